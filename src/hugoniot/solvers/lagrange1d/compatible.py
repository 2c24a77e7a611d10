"""The compatible integrator: the stress in the middle of a step and the state at its end, each a list of passes over a piece of zones.

Forces are the transpose of the strain rates: with the volume rate A2 u2 - A1 u1 and the hoop rate (u1+u2)/(r1+r2), the power
put into a zone is -sigma (A2 u2 - A1 u1) + H (u1 + u2), sigma = p + q - s1, H = (d-1) V (s2 + q - s1)/(r1 + r2), and the force
on a node is minus its derivative with respect to that node's velocity. Work and force use the same numbers, so the energy a zone gains is
the kinetic energy its nodes lose, to round-off, in every geometry.

The artificial viscosity is uniaxial: q resists only the radial compression, with the power -q V (radial rate), and not the hoop
convergence of flow towards the axis, which is not a shock (Schulz, Methods Comput. Phys. 3 (1964) 1; Noh, J. Comput.
Phys. 72 (1987) 78). Hence the q in H: it subtracts the hoop part of q in sigma, which multiplies the whole volume rate.
"""

from hugoniot.core.binder import bind
from hugoniot.core.mathematics import NAN_LAW
from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import kind_of, law_of, named, rows_apart, zone_pass
from hugoniot.mesh.line import area, hoops, mean_area, volume
from hugoniot.solvers.lagrange1d.friction import acts, rub_end, rub_half
from hugoniot.solvers.lagrange1d.sources import supply
from hugoniot.solvers.lagrange1d.stress import deviators, hoop_force
from hugoniot.zones.constants import Constants
from hugoniot.zones.soundness import FOUND_IMPULSE, FOUND_RATE, PeakRows, keep_peaks, new_peaks, unsound, wave_speed
from hugoniot.zones.transport import find_conductivity
from hugoniot.zones.viscosity import OWN, at_middle, resisted, resisting_speed, signal_speed, smoothness

SMALL = 1e-30


def shrinking(r1, r2, u1, u2, geometry):
    """Speed with which a zone closes along the motion, or shrinks, if that is more, m/s."""
    closing = u1 - u2
    if hoops(geometry) > 0.0:
        return fmax(closing, (area(r1, geometry) * u1 - area(r2, geometry) * u2) / mean_area(r1, r2, geometry))
    return closing


# -- passes of the geometry ----------------------------------------------------------------------------------------
@zone_pass("r u gradient inverse_mass e sigma hoop_force end_e v rho radial hoop dilation smooth")
def half_motion(count, z, dt, numbers, law):
    """Energy, density and strains in the middle of the step, from the stress at its start and the velocities extrapolated to the middle."""
    rows_apart()
    geometry, half = kind_of(law), 0.5 * dt
    for j in range(count):
        r1, r2, u1, u2, im = z.r[j], z.r[j + 1], z.u[j], z.u[j + 1], z.inverse_mass[j]
        rate = area(r2, geometry) * u2 - area(r1, geometry) * u1
        v = volume(r1, r2, geometry) * im
        rho = 1.0 / v
        power = -z.sigma[j] * rate
        radial = half * rate * (im * rho)
        if hoops(geometry) > 0.0:
            power += z.hoop_force[j] * (u1 + u2)
            hoop = half * (u1 + u2) / (r1 + r2 + SMALL)
            z.hoop[j] = hoop
            z.dilation[j] = radial
            radial -= hoops(geometry) * hoop
        z.end_e[j] = z.e[j] + half * im * power
        z.v[j] = v
        z.rho[j] = rho
        z.radial[j] = radial
        z.smooth[j] = smoothness(z.gradient[j], z.gradient[j + 1], z.gradient[j + 2])


@zone_pass("r u inverse_mass solid v radial c p smooth t1 t2 speed q sigma hoop_force")
def half_stress(count, z, dt, numbers, law):
    """Viscous pressure, and what pushes the nodes in the middle of the step; `law` is a `zones.viscosity.Resisting`."""
    rows_apart()
    resisting = law_of(law, numbers)
    geometry = resisting.geometry
    for j in range(count):
        du = z.u[j + 1] - z.u[j]
        squeeze = resisted(du, z.radial[j] if hoops(geometry) > 0.0 else du, resisting.law)
        speed = resisting_speed(z.v[j], z.c[j], z.p[j], squeeze, z.smooth[j], resisting.law)
        mobility = OWN * dt * mean_area(z.r[j], z.r[j + 1], geometry) * z.inverse_mass[j]
        squeeze = at_middle(squeeze, z.q[j], mobility, z.solid[j] * speed)
        q = -z.solid[j] * squeeze * speed
        z.speed[j] = speed
        z.q[j] = q
        z.sigma[j] = z.p[j] + q - z.t1[j]
        if hoops(geometry) > 0.0:
            z.hoop_force[j] = hoop_force(z.r[j], z.r[j + 1], z.t1[j], z.t2[j], q, geometry)


@zone_pass("r_half u_mean r u gradient inverse_mass sigma hoop_force q e v rho radial hoop dilation heat viscous_work found")
def end_motion(count, z, dt, numbers, law):
    """Energy, density and strains at the end of the step, velocity gradients and viscous heat; the impulse of neighbouring sectors."""
    rows_apart()
    geometry, impulse = kind_of(law), 0.0
    for j in range(count):
        u1, u2, r1, r2, im = z.u_mean[j], z.u_mean[j + 1], z.r_half[j], z.r_half[j + 1], z.inverse_mass[j]
        rate = area(r2, geometry) * u2 - area(r1, geometry) * u1
        size = volume(r1, r2, geometry)
        power = -z.sigma[j] * rate
        radial, closing = dt * rate / size, rate
        if hoops(geometry) > 0.0:
            power += z.hoop_force[j] * (u1 + u2)
            impulse += z.sigma[j] * (area(r2, geometry) - area(r1, geometry)) - 2.0 * z.hoop_force[j]
            turn = (u1 + u2) / (r1 + r2 + SMALL)
            closing = rate - hoops(geometry) * size * turn
            z.hoop[j] = dt * turn
            z.dilation[j] = radial
            radial -= hoops(geometry) * dt * turn
        z.radial[j] = radial
        z.e[j] += dt * im * power
        v = volume(z.r[j], z.r[j + 1], geometry) * im
        rho = 1.0 / v
        z.v[j] = v
        z.rho[j] = rho
        z.gradient[j + 1] = (z.u[j + 1] - z.u[j]) * (mean_area(z.r[j], z.r[j + 1], geometry) * im * rho)
        heat = -dt * z.q[j] * closing * im
        z.heat[j] = heat
        z.viscous_work[j] += heat
    z.found[FOUND_IMPULSE] += impulse


def stand(z, j, geometry, constants):
    """Sound speed and stress of a zone at the end of the step; its signal rate, 1/s."""
    t1, t2, q = z.t1[j], z.t2[j], z.q[j]
    c = wave_speed(z.c2[j] + (4.0 / 3.0) * z.shear[j] * z.solid_v[j], constants.noise)
    inverse_width = mean_area(z.r[j], z.r[j + 1], geometry) * z.inverse_mass[j] * z.seen.rho[j]
    z.inverse_width[j] = inverse_width
    z.seen.c[j] = c
    z.s1[j] = t1
    z.s2[j] = t2
    z.seen.sigma[j] = z.seen.p[j] + q - t1
    if hoops(geometry) > 0.0:
        z.hoop_force[j] = hoop_force(z.r[j], z.r[j + 1], t1, t2, q, geometry)
    return signal_speed(fmax(c, constants.front), z.speed[j], q, z.seen.rho[j]) * inverse_width


bind(stand, **NAN_LAW)


@zone_pass("r solid_v shear c2 q t1 t2 speed inverse_mass s1 s2 hoop_force inverse_width seen", seen=PeakRows)
def end_stress(count, z, dt, numbers, law):
    """Sound speed and stress at the end of the step, to which something will be added; the largest signal rate, 1/s.

    `seen` has density, pressure, sound speed and stress as well.
    """
    rows_apart()
    geometry, constants, fastest = kind_of(law), named(Constants, numbers), z.seen.found[FOUND_RATE]
    for j in range(count):
        fastest = fmax(fastest, stand(z, j, geometry, constants))
    z.seen.found[FOUND_RATE] = fastest


@zone_pass(end_stress.rows, finite=False)
def end_stress_seen(count, z, dt, numbers, law):
    """The same where nothing will, checked at once (`zones.soundness.look_over`)."""
    rows_apart()
    geometry, constants, fastest = kind_of(law), named(Constants, numbers), z.seen.found[FOUND_RATE]
    bad = new = 0
    for j in range(count):
        fastest = fmax(fastest, stand(z, j, geometry, constants))
        bad += unsound(z.seen, j)
        new += new_peaks(z.seen, j)
    z.seen.found[FOUND_RATE] = fastest
    keep_peaks(count, z.seen, bad, new)


@zone_pass("q v radial heat")
def half_heat(count, z, dt, numbers, law):
    """Viscous heat of half a step, J/kg."""
    rows_apart()
    for j in range(count):
        z.heat[j] = -z.q[j] * z.v[j] * z.radial[j]


@zone_pass("r u lam q rho inverse_mass e flux")
def heat_flux(count, z, dt, numbers, law):
    """Artificial heat flux inside a run of zones, where a shock is: h rho w (e_left - e_right) through each face.

    w is the speed with which a zone closes along the motion, |du|, or that with which it shrinks, minus its volume rate over its
    mean area, if that is more: where a flow converges, a shock that takes its time makes heat of the hoop convergence as well.
    Spreads the excess heat a shock leaves where it starts or is reflected (wall heating). Conservative: what leaves one zone
    enters the next. Noh, J. Comput. Phys. 72 (1987) 78, section on artificial heat conduction; nothing flows where q = 0, nor to
    or from what has begun to burn (numbers[1] = 1: `lam` is a row), whose phases would have to share it. numbers[0] is h.
    """
    rows_apart()
    geometry, coefficient, burns = kind_of(law), numbers[0], numbers[1] > 0.0
    for j in range(count):
        speed = shrinking(z.r[j], z.r[j + 1], z.u[j], z.u[j + 1], geometry)
        z.flux[j] = speed if z.q[j] > 0.0 else 0.0
    for j in range(count - 1):
        face = area(z.r[j + 1], geometry) * fmin(z.rho[j], z.rho[j + 1])
        z.flux[j] = dt * coefficient * face * fmax(z.flux[j], z.flux[j + 1]) * (z.e[j] - z.e[j + 1])
    if burns:
        for j in range(count - 1):
            z.flux[j] = z.flux[j] if z.lam[j] == 0.0 and z.lam[j + 1] == 0.0 else 0.0
    if count > 1:
        # one difference for each zone: subtracted and added one after the other, the mirror image would be rounded otherwise
        z.e[0] -= z.flux[0] * z.inverse_mass[0]
        for j in range(1, count - 1):
            z.e[j] += (z.flux[j - 1] - z.flux[j]) * z.inverse_mass[j]
        z.e[count - 1] += z.flux[count - 2] * z.inverse_mass[count - 1]


# -- the step ----------------------------------------------------------------------------------------------------------
def predict(s, geometry):
    """Write how the stress in the middle of the step is found; s: `zones.steps.MaterialSteps` with the rows of `plan`."""
    z, b, h, w = s.at.z, s.at.b, s.at.h, s.at.w
    s.do(half_motion, (h.r_half, h.u_mean, s.at.g, z.inverse_mass, z.e, z.sigma, z.hoop, w.e, w.v, s.rho_half, w.radial, w.hoop, w.dilation,
                       w.smooth), kind=geometry)
    supply(s, w.e, half=True)
    solid, solid_v = s.solid(s.rho_half)
    if s.laws.burns:
        s.burn(s.at.half, z.rho, z.rho, z.p, z.q, b.lam_half)
        s.do(half_heat, (z.q, w.v, w.radial, w.heat))
        s.close_half(solid)
    else:
        s.pressure(solid, solid_v, w.e, s.p_half)
    t1, t2 = deviators(s, geometry, solid, w.e, s.p_half, b.lam_half, s.at.half)
    s.relieve(solid)
    c = w.zero if s.laws.keeps_time else z.c      # no linear viscosity: it would compress what has no pressure yet, ahead of its schedule
    s.do(half_stress, (h.r_half, h.u_mean, z.inverse_mass, solid, w.v, w.radial, c, s.p_half, w.smooth, t1, t2, z.viscous_speed, z.q,
                       z.sigma_half, z.hoop_half), law=s.resisting(geometry))
    rub_half(s, geometry, solid)
    if s.laws.burns:
        s.keep_half()


def correct(s, geometry):
    """Write how the state at the end of the step is found."""
    z, b, h, w, found = s.at.z, s.at.b, s.at.h, s.at.w, s.at.found
    s.do(end_motion, (h.r_half, h.u_mean, h.r, h.u, s.at.g, z.inverse_mass, z.sigma_half, z.hoop_half, z.q, z.e, w.v, z.rho, w.radial,
                      w.hoop, w.dilation, w.heat, z.viscous_work, found), kind=geometry)
    supply(s, z.e)
    solid, solid_v = s.solid(z.rho)
    if s.laws.burns:
        s.close_end(solid)
    else:
        s.state(solid_v, z.e, z.p)
    t1, t2 = deviators(s, geometry, solid, z.e, z.p, b.lam, s.at.whole)
    s.tear(solid)
    s.harden(w.v)
    rows = (h.r, solid_v, s.shear, w.c2, z.q, t1, t2, z.viscous_speed, z.inverse_mass, z.s1, z.s2, z.hoop, w.inverse_width, s.seen)
    if s.laws.burns or acts(s):
        s.do(end_stress, rows, kind=geometry)
        rub_end(s, geometry, solid)
        s.pace(w.inverse_width)
        s.look_over()
    else:
        s.do(end_stress_seen, rows, kind=geometry)
    find_conductivity(s, solid)
