r"""The sweeps over a run of burning zones for the leapfrog: Wilkins' step with a mixture.

What burns at once takes the step of the KB codes (`instant_leapfrog`). All else has Wilkins' energy equation, the mixture standing where
inert zones have an equation of state: with $\bar q = \tfrac12(q^{n+1/2} + q^{n-1/2})$,

$$e^{n+1} = e^n - \left[\tfrac12(p^n + p^{n+1}) + \bar q\right]\Delta v, \qquad p^{n+1} = p(\rho^{n+1}, e^{n+1}, \lambda^{n+1})$$

First the burn fraction is led on by the pressure at n, and gives the pressure $p'$ expected at n+1; then once more from n by the mean
pressure of the step, $\tfrac12(p^n + p')$, and gives $p''$, from which one Newton step in the energy, exact for laws linear in it, leads
to $p^{n+1}$. Before, each phase takes its share of the viscous heat $-\bar q\,\Delta v$, as in `reactive_sweeps`, which also says why
zones are dealt with in stretches that have all burned nothing, all burned whole, or all burned a part.

Where nothing stands for the explosive before it burns, a schedule spreads the front by itself, and viscosity in it would compress what
has no pressure yet, ahead of the schedule; a front that runs at the speed its products would drive then grows without end. There only the
quadratic part of the viscosity acts, and only as far as the velocity field is not smooth.

A burning zone's energy holds Q from the start (`materials.burning`), so nothing is added to it. The energy is not that of the
motion to round-off, as in every leapfrog of its kind (W-E6).

Source: 000 (Wilkins) B.2 items 7 and 8; 002 (Herrmann) A.27 to A.30; 003 (Starkenberg) sections 3 to 5.
"""

import numba as nb
from numba.extending import overload

from hugoniot.core.compile import INLINE, SWEEP, bind, bind_choice, parameters, rows_apart
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.laws.burn.contract import BURN, advance, rate, scheduled
from hugoniot.laws.mixture.contract import (
    CONVERGED,
    MIXTURE,
    Mixed,
    at_rest,
    attempt,
    heated,
    slopes,
    solve,
    sound_speed_squared,
)
from hugoniot.laws.mixture.reference_state import PASSING, found_state, is_passing, reactants_share
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.mesh.line import hoops, mean_area, volume
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.constitutive import no, resisted, wave_speed, yes
from hugoniot.solvers.lagrange1d.instant_leapfrog import burn_at_once
from hugoniot.solvers.lagrange1d.reactive import STEP_SHARE
from hugoniot.solvers.lagrange1d.reactive_sweeps import (
    BURNED,
    IGNITED,
    NEARLY,
    PARTLY,
    UNBURNED,
    burn_temperature,
    driving_pressure,
    end_of_stretch,
    isolates,
    whole,
)
from hugoniot.solvers.lagrange1d.wilkins_sweeps import SMALL, signal_squared


def bare(mixture):
    """Whether nothing stands for the explosive before it burns."""
    return "no_reactants" in MIXTURE.of(mixture).flags


def smoothness(left, own, right):
    """1 where the velocity gradient (1/s) is that of its neighbours, 0 at a shock or an extremum (Caramana, Shashkov and Whalen 1998)."""
    steep, before, behind = -own, -left, -right
    smooth = fmax(0.0, fmin(fmin(0.5 * (before + behind), steep), 2.0 * fmin(before, behind)))
    return fmin(smooth / (fmax(steep, 0.0) + SMALL), 1.0)


bind_choice(bare, lambda cls: yes if "no_reactants" in MIXTURE.of_class(cls).flags else no)
bind(smoothness)


def advance_burning(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """State of a run of burning zones at n+1; `found` takes the largest signal rate (1/s, that of burning included), 0, 0, 0."""
    raise NotImplementedError("compiled only")


@overload(advance_burning, jit_options=INLINE)
def _(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    def gradually(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
        burn_gradually(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found)

    def at_once(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
        burn_at_once(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found)

    burn_law = law[0].types[0].instance_class
    return at_once if "instantaneous" in BURN.of_class(burn_law).flags else gradually


# -- by rate or by schedule ------------------------------------------------------------------------------------------
@nb.njit(**SWEEP)
def burn_gradually(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """State of a run of zones at n+1, its burn fractions found twice.

    Rows that this integrator leaves free hold, within a step, the burn fraction expected (OLD), the pressure expected (SIGMA), the
    new viscous pressure (VISCOUS_SPEED), and the smoothness or, of closures with reactants, the status of what was tried (HOOP_HALF).
    """
    if bare(parameters(law[0], rows[0]).mixture):
        look_around(zones, nodes, first, last, segment)
    burn(zones, nodes, first, last, segment, dt, law, rows, geometry, True)
    expected, start = zones[L.OLD, first:last], first
    while start < last:
        known, stop = whole(expected[start - first]), first + end_of_stretch(expected, start - first)
        if known == UNBURNED:
            expect_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, UNBURNED)
        elif known == BURNED:
            expect_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, BURNED)
        else:
            expect_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, PARTLY)
        start = stop
    burn(zones, nodes, first, last, segment, dt, law, rows, geometry, False)
    burned, fastest, start = zones[L.BURN_FRACTION, first:last], 0.0, first
    while start < last:
        known, stop = whole(burned[start - first]), first + end_of_stretch(burned, start - first)
        if known == UNBURNED:
            pace = settle_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, UNBURNED)
        elif known == BURNED:
            pace = settle_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, BURNED)
        else:
            pace = settle_alike(zones, nodes, start, stop, segment, dt, law, rows, geometry, PARTLY)
        fastest, start = fmax(fastest, pace), stop
    found[0], found[1], found[2], found[3] = fastest, 0.0, 0.0, 0.0


@nb.njit(**SWEEP)
def look_around(zones, nodes, first, last, segment):
    """Smoothness of the velocity field in every zone; beyond an end of its body the field goes on as inside."""
    r, u, node_mass = nodes[L.R], nodes[L.U], nodes[L.NODE_MASS]
    mass, smooth = zones[L.MASS], zones[L.HOOP_HALF]
    for j in range(first, last):
        k = j + segment
        own = (u[k + 1] - u[k]) / (r[k + 1] - r[k])
        # the node at an end of a body has the half of one zone
        left = own if node_mass[k] == 0.5 * mass[j] else (u[k] - u[k - 1]) / (r[k] - r[k - 1])
        right = own if node_mass[k + 1] == 0.5 * mass[j] else (u[k + 2] - u[k + 1]) / (r[k + 2] - r[k + 1])
        smooth[j] = smoothness(left, own, right)


@nb.njit(**SWEEP)
def burn(zones, nodes, first, last, segment, dt, law, rows, geometry, expecting):
    """Burn fractions at n+1: `expecting`, from the pressure at n into the row OLD; then from the mean pressure, for good."""
    par = parameters(law[0], rows[0])
    r, im, old = nodes[L.R, first + segment:last + segment + 1], zones[L.INVERSE_MASS, first:last], zones[L.SIGMA_HALF, first:last]
    p, q, expected, q_new = zones[L.P, first:last], zones[L.Q, first:last], zones[L.SIGMA, first:last], zones[L.VISCOUS_SPEED, first:last]
    burned, since, width = zones[L.BURN_FRACTION, first:last], zones[L.LIT_SINCE, first:last], zones[L.ZONE_SIZE, first:last]
    rho_r, e_r, rho_p, e_p = zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last], zones[L.E_P, first:last]
    fraction = zones[L.OLD, first:last]
    for j in range(last - first):
        v = volume(r[j], r[j + 1], geometry) * im[j]
        lam = scheduled(burned[j], since[j] + dt, 0.0, width[j], 1.0 / v, par.rate)
        if lam < 1.0:
            heat = burn_temperature(burned[j], Mixed(p[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), par.mixture, par.rate)
            if expecting:
                drive = driving_pressure(p[j], q[j], par.rate)
            else:
                drive = driving_pressure(0.5 * (p[j] + expected[j]), q_new[j], par.rate)
            lam = advance(lam, dt, 2.0 / (v + old[j]), drive, heat, par.rate)
        if expecting:
            fraction[j] = lam
        else:
            burned[j] = lam
            since[j] += dt


@nb.njit(**SWEEP)
def expect_alike(zones, nodes, first, last, segment, dt, law, rows, geometry, known):
    """Pressure expected at n+1 and viscous pressure of zones that are alike, the burn fractions expected of them found."""
    a, b = first + segment, last + segment
    expect_zones(
        nodes[L.R, a:b + 1], nodes[L.U, a:b + 1], zones[L.INVERSE_MASS, first:last], zones[L.E, first:last], zones[L.C, first:last],
        zones[L.P, first:last], zones[L.Q, first:last], zones[L.SIGMA_HALF, first:last], zones[L.OLD, first:last],
        zones[L.SIGMA, first:last], zones[L.VISCOUS_SPEED, first:last], zones[L.HOOP_HALF, first:last], zones[L.MIX_STATUS, first:last],
        zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last], zones[L.E_P, first:last],
        zones[L.REFERENCE, first:last], law, rows, geometry, known)


@nb.njit(**SWEEP)
def expect_zones(r, u, im, e, c, p_, q_, old, fraction, expected, q_new, smooth, status, rho_r, e_r, rho_p, e_p, reference,
                 law, rows, geometry, known):
    """`expect_alike` over rows of the tables."""
    rows_apart()
    par = parameters(law[0], rows[0])
    viscosity = parameters(law[3], rows[3])
    freezes, tries = rows[4][4], known == PARTLY and not bare(par.mixture)
    for j in range(im.shape[0]):
        v = volume(r[j], r[j + 1], geometry) * im[j]
        v_half = 0.5 * (v + old[j])
        squeeze = resisted(u[j + 1] - u[j], v - old[j], viscosity)
        if bare(par.mixture):
            speed = (1.0 - smooth[j]) * viscous_speed(v_half, 0.0, 0.0, squeeze, 0.0, viscosity)
        else:
            speed = viscous_speed(v_half, c[j], p_[j], squeeze, 0.0, viscosity)
        q_new[j] = -squeeze * speed / v_half
    if tries:
        for j in range(im.shape[0]):
            v = volume(r[j], r[j + 1], geometry) * im[j]
            dv, q = v - old[j], 0.5 * (q_[j] + q_new[j])
            warmth = -q * dv
            if isolates(par.mixture):
                warmth = reactants_share(warmth, reference[j] == PASSING, freezes)
            before = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
            mixed = attempt(1.0 / v, e[j] - (p_[j] + q) * dv, fraction[j], heated(before, warmth), par.mixture)
            expected[j], status[j] = mixed.pressure, mixed.status
    for j in range(im.shape[0]):
        v = volume(r[j], r[j + 1], geometry) * im[j]
        dv, q = v - old[j], 0.5 * (q_[j] + q_new[j])
        warmth = -q * dv
        if isolates(par.mixture):
            warmth = reactants_share(warmth, reference[j] == PASSING, freezes)
        lam = fraction[j] if known == PARTLY else known
        before = Mixed(expected[j] if tries else p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
        done = tries and status[j] == CONVERGED
        mixed = before if done else solve(1.0 / v, e[j] - (p_[j] + q) * dv, lam, heated(before, warmth), par.mixture)
        expected[j] = mixed.pressure
        status[j] = mixed.status


@nb.njit(**SWEEP)
def settle_alike(zones, nodes, first, last, segment, dt, law, rows, geometry, known):
    """Largest signal rate after the state at n+1 of zones that are alike, their burn fractions found."""
    a, b = first + segment, last + segment
    return settle_zones(
        nodes[L.R, a:b + 1], nodes[L.U, a:b + 1], zones[L.INVERSE_MASS, first:last], zones[L.RHO, first:last], zones[L.E, first:last],
        zones[L.P, first:last], zones[L.C, first:last], zones[L.Q, first:last], zones[L.SIGMA, first:last], zones[L.SIGMA_HALF, first:last],
        zones[L.OLD, first:last], zones[L.VISCOUS_SPEED, first:last], zones[L.VISCOUS_WORK, first:last], zones[L.BURN_FRACTION, first:last],
        zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last], zones[L.E_P, first:last],
        zones[L.MIX_STATUS, first:last], zones[L.HOOP_HALF, first:last], zones[L.RESOLUTION, first:last], zones[L.REFERENCE, first:last],
        law, rows, geometry, known)


@nb.njit(**SWEEP)
def settle_zones(r, u, im, rho_, e_, p_, c_, q_, sigma, old, width, q_new, viscous, burned, rho_r, e_r, rho_p, e_p, status, smooth,
                 resolved, reference, law, rows, geometry, known):
    """`settle_alike` over rows of the tables."""
    rows_apart()
    par = parameters(law[0], rows[0])
    viscosity = parameters(law[3], rows[3])
    noise, per_rate, front, freezes = rows[4][1], rows[4][2], rows[4][3], rows[4][4]
    fastest, quickest, tries = 0.0, 0.0, known == PARTLY and not bare(par.mixture)
    if tries:
        for j in range(im.shape[0]):
            v = volume(r[j], r[j + 1], geometry) * im[j]
            dv, q, half = v - old[j], 0.5 * (q_[j] + q_new[j]), 0.5 * (p_[j] + sigma[j])
            warmth, energy = -q * dv, e_[j] - (half + q) * dv
            if isolates(par.mixture):
                shocked = is_passing(q_new[j], half, 2.0 / (v + old[j]) * c_[j] * c_[j])
                warmth = reactants_share(warmth, shocked, freezes)
                reference[j] = found_state(reference[j], shocked, burned[j])
            before = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
            mixed = attempt(1.0 / v, energy, burned[j], heated(before, warmth), par.mixture)
            p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.pressure, mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
            e_[j], smooth[j] = energy, mixed.status
    for j in range(im.shape[0]):
        v = volume(r[j], r[j + 1], geometry) * im[j]
        rho, dv, q = 1.0 / v, v - old[j], 0.5 * (q_[j] + q_new[j])
        lam = burned[j] if known == PARTLY else known
        before = at_rest(rho_r[j], e_r[j]) if known == UNBURNED else Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
        if tries:      # what was tried is warm already, and its energy stands in its place
            energy = e_[j]
            mixed = before if smooth[j] == CONVERGED else solve(rho, energy, lam, before, par.mixture)
        else:
            half = 0.5 * (p_[j] + sigma[j])
            warmth, energy = -q * dv, e_[j] - (half + q) * dv
            if isolates(par.mixture):
                shocked = is_passing(q_new[j], half, 2.0 / (v + old[j]) * c_[j] * c_[j])
                warmth = reactants_share(warmth, shocked, freezes)
                reference[j] = found_state(reference[j], shocked, lam)
            mixed = solve(rho, energy, lam, heated(before, warmth), par.mixture)
        slope = slopes(rho, energy, lam, mixed, par.mixture)
        rest = 0.5 * (sigma[j] - mixed.pressure) * dv / (1.0 + 0.5 * slope.by_energy * dv)
        energy += rest
        p, mixed = mixed.pressure + slope.by_energy * rest, heated(mixed, rest)
        fault = status[j] + mixed.status
        c2 = sound_speed_squared(rho, p, slope)
        c = wave_speed(c2, noise + 1.0) if fault == 0.0 else -1.0   # what has not begun to burn may have no sound at all
        squeeze = resisted(u[j + 1] - u[j], dv, viscosity)
        quadratic, jump = viscous_speed(v, 0.0, 0.0, squeeze, 0.0, viscosity), fmax(squeeze, -squeeze)
        if bare(par.mixture):
            quadratic, jump = (1.0 - smooth[j]) * quadratic, (1.0 - smooth[j]) * jump
        wave, inverse = fmax(c, front), mean_area(r[j], r[j + 1], geometry) * im[j] * rho
        speed = quadratic if bare(par.mixture) else viscous_speed(v, c, p, squeeze, 0.0, viscosity)
        signal = signal_squared(wave * wave, 8.0 * (quadratic + jump), speed)
        fastest = fmax(fastest, signal * (inverse * inverse))
        if 0.0 < lam < NEARLY:   # as in `reactive_sweeps`
            drive, heat = driving_pressure(p, q_new[j], par.rate), burn_temperature(lam, mixed, par.mixture, par.rate)
            pace = rate(fmax(lam, STEP_SHARE), rho, drive, heat, par.rate)
            quickest = fmax(quickest, per_rate * pace)
            if lam > IGNITED and pace > 0.0:
                resolved[j] = fmin(resolved[j], c * inverse / pace)
        status[j] = fault
        rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
        rho_[j], e_[j], p_[j], c_[j] = rho, energy, p, c
        viscous[j] -= q * dv
        sigma[j] = p + q_new[j]
        q_[j], old[j] = q_new[j], v
        if hoops(geometry) > 0.0:
            width[j] = rho * (r[j + 1] - r[j])
    return fmax(vsqrt(fastest), quickest)
