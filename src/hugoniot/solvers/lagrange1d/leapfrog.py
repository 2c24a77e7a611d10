r"""The `wilkins` integrator: the leapfrog of Wilkins B.2 over a piece of zones, with its own energy equation, as a list of passes.

Corrections and readings: |dU/dr| in q (W-E3); stresses at j+-1/2 (W-E5); pressure and energy solved together, exactly
for laws linear in the energy (B.2 item 8, W-11) and by Newton's method otherwise; dZ included (J-E12); the Courant step with the
elastic sound speed (W-E4), and with the limit for the linear viscosity that W-7 omits (`signal_squared`).

Burning material, with $\bar q = \tfrac12(q^{n+1/2} + q^{n-1/2})$ and dZ the work of the deviators:

$$e^{n+1} = e^n + dZ - \left[\tfrac12(p^n + p^{n+1}) + \bar q\right]\Delta v, \qquad p^{n+1} = p(\rho^{n+1}, e^{n+1}, \lambda^{n+1})$$

First the burn fraction is advanced with the pressure at n, which gives the pressure $p'$ predicted for n+1. It is then advanced once more
from n with the mean pressure of the step, $\tfrac12(p^n + p')$, which gives $p''$. One Newton step in the energy, exact for laws linear in
it, then gives $p^{n+1}$.

Instantaneous burning uses the step of the KB codes, with w the artificial viscosity that moved the nodes at n:

$$e' = e^n + dZ - (p^n + w^n)\,\Delta v, \quad p' = p(\rho^{n+1}, e'), \qquad
  e^{n+1} = e^n + dZ - \left[\tfrac12(p^n + p') + w^n\right]\Delta v, \quad p^{n+1} = p(\rho^{n+1}, e^{n+1})$$

A zone whose $p^{n+1}$ exceeds the threshold burns at the end of the same step: its pressure is already that of the products when its nodes
are moved next. This step is limited by the signal speed c + 4 w/(rho |du|), the limit of diffusion by a quadratic viscosity (Richtmyer &
Morton). The KB codes manual does not give its limit, and the speed of the wave depends on it.

If the explosive has no equation of state before it burns, the schedule spreads the front. Viscosity in the front would compress material
that has no pressure yet, ahead of the schedule, and the pressure in a front at the CJ velocity of its products would grow without bound.
There only the quadratic part of the viscosity acts, and only where the velocity field is not smooth.

As in every leapfrog of this kind, total energy is not conserved to round-off (W-E6).

Source: Wilkins B.2 items 2 and 5 to 9; KB codes equations 1.8 to 1.11 with the viscous term of K-E5, and section 4;
Herrmann A.27 to A.30; Starkenberg sections 3 to 5.
"""

from hugoniot.core.pass_lists import place
from hugoniot.solvers.lagrange1d import leapfrog_passes as P
from hugoniot.solvers.lagrange1d.friction import acts, rub_leaping, rub_leapt
from hugoniot.solvers.lagrange1d.sources import supply
from hugoniot.solvers.lagrange1d.stress import strains
from hugoniot.zones.mixture import slopes_pass
from hugoniot.zones.transport import find_conductivity


def advance(s, geometry):
    """Write how the state at n+1 is found; s: `zones.steps.MaterialSteps` with the rows of `plan`, in which w.v is z.v."""
    z, h, w = s.at.z, s.at.h, s.at.w
    if s.laws.burns:
        s.copy(z.q, w.q)
    if s.laws.is_bare:
        s.do(P.look_around, (h.r, h.u, h.mass, z.mass, w.smooth))
    # the P of the viscosity's a = sqrt(P/rho) is the one at the start of the step
    c, p, smooth = (w.zero, w.zero, w.smooth) if s.laws.is_bare else (z.c, z.p, w.zero)
    s.do(P.whole_motion, (h.r, h.u, z.inverse_mass, c, p, smooth, z.v, z.q, z.viscous_work, w.dv, w.v_half, w.rho, z.rho, w.radial, w.hoop,
                          w.dilation, w.speed, w.printed, w.given), law=s.resisting(geometry))
    solid, solid_v = s.solid(z.rho)
    s.stiffness(solid, solid_v, z.e, z.p)
    if s.laws.burns_at_once:
        s.do(P.heat_before, (w.q, w.dv, w.given, z.viscous_work))
    elif s.laws.burns:
        s.copy(w.given, w.heat)
    if s.laws.is_strong:
        s.do(P.strain_and_work, (s.asked(solid, z.e, z.p, s.at.b.lam), z.s1, z.s2, w.radial, *strains(s, geometry), w.v_half, w.shear,
                                 w.limit, w.flow, w.given), law=s.strong(geometry))
    if s.laws.burns:
        s.copy(z.e, w.target)
        s.add(w.given, w.target)
        close_at_once(s, solid) if s.laws.burns_at_once else close_gradually(s, solid)
    else:
        supply(s, w.given)
        rub_leaping(s, geometry)
        s.settle(solid_v)
    s.tear(solid)
    if s.laws.grows_voids:
        s.do(P.take_relief, (w.relief, w.dv, z.e))
    s.harden(w.v_half)
    stand(s, geometry)
    find_conductivity(s, solid)


def stand(s, geometry):
    """Write sound speed and stress at n+1, and look them over."""
    z, h, w = s.at.z, s.at.h, s.at.w
    if s.laws.burns_at_once:
        s.do(P.end_stress_at_once, (h.r, h.u, z.inverse_mass, z.v, w.dv, w.c2, s.shear, z.s1, z.s2, z.q, z.pull, z.width, w.inverse_width,
                                    place(s.constants), s.seen), law=s.resisting(geometry))
    else:
        later = s.laws.burns or acts(s)
        s.do(P.end_stress if later else P.end_stress_seen, (h.r, z.inverse_mass, z.v, w.c2, s.shear, z.s1, z.s2, z.q, w.speed, w.printed,
                                                            z.pull, z.width, w.inverse_width, s.seen), kind=geometry)
    rub_leapt(s, geometry)
    s.pace(w.inverse_width)
    if s.laws.burns or acts(s):
        s.look_over()


def close_gradually(s, solid):
    """Write burn fraction and mixture at n+1 of what burns by rate or schedule, the burn fraction found twice."""
    z, b, w = s.at.z, s.at.b, s.at.w
    s.add_plastic_heat(w.v_half, w.heat)
    s.burn(s.at.whole, w.rho, z.rho, z.p, w.q, w.lam)
    s.share_old_heat(w.heat)
    s.do(P.after_work, (w.target, z.p, z.p, w.dv, w.e))
    s.mix(solid, w.e, w.lam, b.heat, w.p, b.status)
    s.do(P.mean, (z.p, w.p, b.p_half))
    s.burn(s.at.whole, w.rho, z.rho, b.p_half, z.q, b.lam_half)
    s.share_heat(z.q, b.p_half, w.rho, w.heat)
    s.lead_on(b.lam_half)
    s.do(P.after_work, (w.target, z.p, w.p, w.dv, z.e))
    s.mix(solid, z.e, b.lam, b.heat, b.p_half, w.status)
    s.slopes(solid, z.e, b.lam, b.p_half)
    s.do(P.newton_step, (w.p, b.p_half, w.dv, w.p_e, z.e, z.p, w.e_r, w.e_p))
    s.slopes(solid, z.e, b.lam, z.p, slopes_pass)
    s.keep_phases()


def close_at_once(s, solid):
    """Write the step of the KB codes: mixture at n+1."""
    z, b, w = s.at.z, s.at.b, s.at.w
    s.do(P.after_work, (w.target, z.p, z.p, w.dv, w.e))
    s.mix(solid, w.e, b.lam, w.zero, w.p, b.status)
    s.do(P.after_work, (w.target, z.p, w.p, w.dv, z.e))
    s.mix(solid, z.e, b.lam, w.zero, b.p_half, w.status)
    s.burn(s.at.whole, solid, solid, b.p_half, w.q, w.lam)
    s.share_heat(w.q, b.p_half, solid, w.zero)
    s.lead_on(w.lam)
    s.mix(solid, z.e, b.lam, w.zero, b.p_half, w.status)
    s.slopes(solid, z.e, b.lam, b.p_half)
    s.keep_phases()
    s.copy(b.p_half, z.p)
