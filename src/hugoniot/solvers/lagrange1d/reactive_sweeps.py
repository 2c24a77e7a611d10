"""Sweeps over a run of burning zones for the compatible integrator: the mixture stands where inert zones have an equation of state.

The same steps as `zone_sweeps`, without strength: burn fraction and mixture are found in the predictor with the pressure of the step
before, in the corrector with the one of the middle of the step, both from the state at the start of the step. Each phase first takes
its share of the step's viscous heat, reactants of a frozen reference state only while a shock is passing. A search that fails leaves
its status and a sound speed of -1, which the watch refuses.

Most zones of a charge have not begun to burn or have ended, and are plain material. First the burn fractions of a step are found, then
every stretch of zones that have all burned nothing, all burned whole, or all burned a part goes through the same loop: with a burn fraction
of 0 or 1 that is known when it is compiled, nothing of a mixture is left in it, and it is packed like that of inert zones.

Source: 003 (Starkenberg ARL-TR-2161) sections 3 to 5; 002 (Herrmann WL-TR-64-107) A.27 to A.30; `docs/theory/mixtures.md`.
"""

import sys

import numba as nb

from hugoniot.core import compile as binding
from hugoniot.core.compile import SWEEP, parameters, rows_apart
from hugoniot.core.ops import fmax, fmin
from hugoniot.laws.burn import contract as burn_contract
from hugoniot.laws.burn import depletion
from hugoniot.laws.burn.contract import BURN, advance, rate, scheduled, short_advance
from hugoniot.laws.mixture import contract as mixture_contract
from hugoniot.laws.mixture import reference_state
from hugoniot.laws.mixture.binding import bind_mixtures
from hugoniot.laws.mixture.contract import (
    CONVERGED,
    MIXTURE,
    Mixed,
    at_rest,
    attempt,
    heated,
    mixture_temperature,
    slopes,
    solve,
    sound_speed_squared,
)
from hugoniot.laws.mixture.reference_state import PASSING, found_state, is_passing, reactants_share
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.mesh.line import area, volume
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.constitutive import resisted, wave_speed
from hugoniot.solvers.lagrange1d.reactive import STEP_SHARE

SMALL = 1e-30
NEARLY = 0.99        # burn fraction up to which the time step follows the rate
IGNITED = 0.05       # burn fraction from which the resolution of the rate is watched
UNBURNED, PARTLY, BURNED = 0.0, -1.0, 1.0
SUBCYCLED = -1.0     # in place of a burn fraction that takes sub-steps


def burn_temperature(lam, mixed, mixture, rate):
    """Temperature for a burn law that asks for one; 0 for the others, at no cost."""
    return mixture_temperature(lam, mixed, mixture) if "temperature_driven" in BURN.of(rate).flags else 0.0


def no_temperature(lam, mixed, mixture, rate):
    return 0.0


def its_temperature(lam, mixed, mixture, rate):
    return mixture_temperature(lam, mixed, mixture)


def driving_pressure(p, q, rate):
    """The pressure a burn law is meant to see: with the artificial viscosity where its authors count it."""
    return p + q if "includes_viscosity" in BURN.of(rate).flags else p


def with_viscosity(p, q, rate):
    return p + q


def without_viscosity(p, q, rate):
    return p


def at_once(rate):
    """Whether a zone burns at once: decided by the pressure at the start of a step, so that both its halves agree (KB codes)."""
    return "instantaneous" in BURN.of(rate).flags


def subcycles(rate):
    """Whether `advance` of the burn law is a loop, which no packed loop over zones can hold."""
    return "subcycled" in BURN.of(rate).flags


def isolates(mixture):
    """Whether the reactants keep an isentrope, and so have a reference state."""
    return "follows_isentrope" in MIXTURE.of(mixture).flags


def warmed(before, heat, shocked, freezes, mixture):
    """`before` after the viscous heat of a step (J/kg of mixture), less what isolated reactants do not take of it."""
    share = warmed_apart if isolates(mixture) else warmed_alike
    return share(before, heat, shocked, freezes, mixture)


def warmed_apart(before, heat, shocked, freezes, mixture):
    return heated(before, reactants_share(heat, shocked, freezes))


def warmed_alike(before, heat, shocked, freezes, mixture):
    return heated(before, heat)


def fraction(lam, time, width, rho, p, q, phases, dt, par):
    """Burn fraction after a step of dt at constant state."""
    heat = burn_temperature(lam, phases, par.mixture, par.rate)
    lam = scheduled(lam, time, 0.0, width, rho, par.rate)
    return advance(lam, dt, rho, driving_pressure(p, q, par.rate), heat, par.rate) if lam < 1.0 else lam


def short_fraction(lam, rho, p, q, phases, dt, par):
    """The same of a zone that burns by a rate, where `short_advance` does; else SUBCYCLED."""
    heat = burn_temperature(lam, phases, par.mixture, par.rate)
    end, done = short_advance(lam, dt, rho, driving_pressure(p, q, par.rate), heat, par.rate)
    return end if done else SUBCYCLED


def swept(r1, r2, u1, u2, geometry):
    """Rate of a zone's volume."""
    return area(r2, geometry) * u2 - area(r1, geometry) * u1


def whole(lam):
    """UNBURNED, BURNED, or PARTLY for what is between: the burn fraction where a loop may know it."""
    return lam if lam in (UNBURNED, BURNED) else PARTLY


def yes(rate):
    return True


def no(rate):
    return False


def _bind():
    def asks(flag, then, otherwise):
        return lambda *classes: then if flag in BURN.of_class(classes[-1]).flags else otherwise

    bind_mixtures()
    binding.bind_family(BURN, burn_contract.GENERICS)
    for module in (depletion, burn_contract, mixture_contract, reference_state):
        binding.bind_module(module)
    binding.bind_choice(burn_temperature, asks("temperature_driven", its_temperature, no_temperature))
    binding.bind_choice(driving_pressure, asks("includes_viscosity", with_viscosity, without_viscosity))
    binding.bind_choice(at_once, asks("instantaneous", yes, no))
    binding.bind_choice(subcycles, asks("subcycled", yes, no))

    def isolating(then, otherwise):
        return lambda *classes: then if "follows_isentrope" in MIXTURE.of_class(classes[-1]).flags else otherwise

    binding.bind_choice(warmed, isolating(warmed_apart, warmed_alike))
    binding.bind_choice(isolates, isolating(yes, no))
    binding.bind_module(sys.modules[__name__])


_bind()


@nb.njit(**SWEEP)
def end_of_stretch(lam, start):
    """Where the zones from `start` on that have all burned nothing, all burned whole, or all burned a part, end."""
    known = whole(lam[start])
    for j in range(start + 1, lam.shape[0]):
        if whole(lam[j]) != known:
            return j
    return lam.shape[0]


@nb.njit(**SWEEP)
def burn(zones, nodes, places, stress, first, last, segment, dt, law, rows, geometry):
    """Burn fractions dt after the start of the step into the row OLD, by the density of the rows `places` and the pressure of `stress`.

    Zones that burn by a law of sub-steps are tried for many at a time; those that are still whole are mostly answered at once.
    """
    par = parameters(law[0], rows[0])
    mass, p, q, sigma = zones[L.MASS, first:last], zones[L.P, first:last], zones[L.Q, first:last], zones[stress, first:last]
    burned, since, width = zones[L.BURN_FRACTION, first:last], zones[L.LIT_SINCE, first:last], zones[L.ZONE_SIZE, first:last]
    rho_r, e_r, rho_p, e_p = zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last], zones[L.E_P, first:last]
    new, r, start = zones[L.OLD, first:last], nodes[places, first + segment:last + segment + 1], 0
    while start < last - first:
        known, stop = whole(burned[start]), end_of_stretch(burned, start) if subcycles(par.rate) else last - first
        if subcycles(par.rate) and known == PARTLY:
            here = slice(start, stop)
            burn_shortly(r[start:stop + 1], mass[here], p[here], q[here], sigma[here], burned[here], rho_r[here], e_r[here], rho_p[here],
                         e_p[here], new[here], dt, law, rows, geometry)
        elif subcycles(par.rate):
            for j in range(start, stop):
                new[j] = BURNED if known == BURNED else SUBCYCLED
        if not subcycles(par.rate) or known != BURNED:
            for j in range(start, stop):
                if not subcycles(par.rate) or new[j] < 0.0:
                    now = p[j] if at_once(par.rate) else sigma[j] - q[j]
                    new[j] = fraction(burned[j], since[j] + dt, width[j], mass[j] / volume(r[j], r[j + 1], geometry), now, q[j],
                                      Mixed(p[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), dt, par)
        start = stop


@nb.njit(**SWEEP)
def burn_shortly(r, mass, p, q, sigma, burned, rho_r, e_r, rho_p, e_p, new, dt, law, rows, geometry):
    """`short_fraction` over rows of the tables."""
    rows_apart()
    par = parameters(law[0], rows[0])
    for j in range(mass.shape[0]):
        new[j] = short_fraction(burned[j], mass[j] / volume(r[j], r[j + 1], geometry), sigma[j] - q[j], q[j],
                                Mixed(p[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), dt, par)


@nb.njit(**SWEEP)
def predict_burning(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """Stress in the middle of the step, from the state at its start and the predicted mean velocity."""
    burn(zones, nodes, L.R, L.SIGMA, first, last, segment, 0.5 * dt, law, rows, geometry)
    lam_half = zones[L.OLD, first:last]
    start = first
    while start < last:
        known, stop = whole(lam_half[start - first]), first + end_of_stretch(lam_half, start - first)
        if known == UNBURNED:
            predict_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, UNBURNED)
        elif known == BURNED:
            predict_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, BURNED)
        else:
            predict_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, PARTLY)
        start = stop


@nb.njit(**SWEEP)
def predict_alike(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, known):
    """`predict_burning` of zones that are alike, their burn fractions found."""
    a, b = first + segment, last + segment
    predict_zones(
        nodes[L.R_HALF, a:b + 1], nodes[L.U_MEAN, a:b + 1], gradient[first + 2 * segment:last + 2 * segment + 2], zones[L.MASS, first:last],
        zones[L.INVERSE_MASS, first:last], zones[L.E, first:last], zones[L.C, first:last], zones[L.P, first:last],
        zones[L.SIGMA, first:last], zones[L.SIGMA_HALF, first:last], zones[L.Q, first:last], zones[L.VISCOUS_SPEED, first:last],
        zones[L.MIX_STATUS, first:last], zones[L.OLD, first:last], zones[L.RHO_R, first:last], zones[L.E_R, first:last],
        zones[L.RHO_P, first:last], zones[L.E_P, first:last], zones[L.REFERENCE, first:last], dt, law, rows, geometry, known)


@nb.njit(**SWEEP)
def predict_zones(rh, u, g, mass, im, e, c, p_, sigma, sigma_half, q_, speed_out, status, lam_half, rho_r, e_r, rho_p, e_p, reference,
                  dt, law, rows, geometry, known):
    """`predict_alike` over rows of the tables."""
    rows_apart()
    par = parameters(law[0], rows[0])
    viscosity = parameters(law[3], rows[3])
    half, freezes = 0.5 * dt, rows[4][4]
    if known == PARTLY:
        for j in range(mass.shape[0]):
            change = half * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
            rho, energy = mass[j] / volume(rh[j], rh[j + 1], geometry), e[j] - sigma[j] * change
            before = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
            before = warmed(before, -q_[j] * change, reference[j] == PASSING, freezes, par.mixture)
            mixed = attempt(rho, energy, lam_half[j], before, par.mixture)
            sigma_half[j], status[j] = mixed.pressure, mixed.status
        for j in range(mass.shape[0]):
            if status[j] != CONVERGED:
                change = half * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
                rho, energy = mass[j] / volume(rh[j], rh[j + 1], geometry), e[j] - sigma[j] * change
                before = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
                before = warmed(before, -q_[j] * change, reference[j] == PASSING, freezes, par.mixture)
                mixed = solve(rho, energy, lam_half[j], before, par.mixture)
                sigma_half[j], status[j] = mixed.pressure, mixed.status
    for j in range(mass.shape[0]):
        rho = mass[j] / volume(rh[j], rh[j + 1], geometry)
        if known == PARTLY:
            p = sigma_half[j]
        else:
            energy = e[j] - sigma[j] * half * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
            mixed = solve(rho, energy, known, Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), par.mixture)
            p, status[j] = mixed.pressure, mixed.status
        du = u[j + 1] - u[j]
        steep = -g[j + 1]
        left, right = -g[j], -g[j + 2]
        smooth = fmax(0.0, fmin(fmin(0.5 * (left + right), steep), 2.0 * fmin(left, right)))
        psi = fmin(smooth / (fmax(steep, 0.0) + SMALL), 1.0)
        squeeze = resisted(du, du, viscosity)
        speed = viscous_speed(1.0 / rho, c[j], p, squeeze, psi, viscosity)
        q = -rho * squeeze * speed
        q_[j] = q
        speed_out[j] = speed if squeeze != 0.0 else 0.0
        sigma_half[j] = p + q


@nb.njit(**SWEEP)
def correct_burning(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """State at the end of the step; `found` takes the largest signal rate (1/s, that of burning included) and the geometric impulse."""
    burn(zones, nodes, L.R_HALF, L.SIGMA_HALF, first, last, segment, dt, law, rows, geometry)
    burned, since, new = zones[L.BURN_FRACTION, first:last], zones[L.LIT_SINCE, first:last], zones[L.OLD, first:last]
    for j in range(last - first):
        burned[j], since[j] = new[j], since[j] + dt
    fastest, impulse, start = 0.0, 0.0, first
    while start < last:
        known, stop = whole(burned[start - first]), first + end_of_stretch(burned, start - first)
        if known == UNBURNED:
            pace, push = correct_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, UNBURNED)
        elif known == BURNED:
            pace, push = correct_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, BURNED)
        else:
            pace, push = correct_alike(zones, nodes, gradient, start, stop, segment, dt, law, rows, geometry, PARTLY)
        fastest, impulse, start = fmax(fastest, pace), impulse + push, stop
    found[0], found[1], found[2], found[3] = fastest, 0.0, impulse, 0.0


@nb.njit(**SWEEP)
def correct_alike(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, known) -> tuple[float, float]:
    """(largest signal rate, geometric impulse) after `correct_burning` of zones that are alike, their burn fractions found."""
    a, b = first + segment, last + segment
    return correct_zones(
        nodes[L.R, a:b + 1], nodes[L.R_HALF, a:b + 1], nodes[L.U_MEAN, a:b + 1], nodes[L.U, a:b + 1],
        gradient[first + 2 * segment + 1:last + 2 * segment + 1], zones[L.MASS, first:last], zones[L.INVERSE_MASS, first:last],
        zones[L.RHO, first:last], zones[L.E, first:last], zones[L.P, first:last], zones[L.C, first:last], zones[L.SIGMA, first:last],
        zones[L.SIGMA_HALF, first:last], zones[L.Q, first:last], zones[L.VISCOUS_SPEED, first:last], zones[L.VISCOUS_WORK, first:last],
        zones[L.BURN_FRACTION, first:last], zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last],
        zones[L.E_P, first:last], zones[L.MIX_STATUS, first:last], zones[L.RESOLUTION, first:last], zones[L.REFERENCE, first:last],
        zones[L.OLD, first:last], dt, law, rows, geometry, known)


@nb.njit(**SWEEP)
def correct_zones(r, rh, u, ue, g, mass, im, rho_, e_, p_, c_, sigma, sigma_half, q, speed, viscous, burned, rho_r, e_r, rho_p, e_p, status,
                  resolved, reference, tried, dt, law, rows, geometry, known) -> tuple[float, float]:
    """`correct_alike` over rows of the tables."""
    rows_apart()
    par = parameters(law[0], rows[0])
    noise, per_rate, front, freezes = rows[4][1], rows[4][2], rows[4][3], rows[4][4]
    fastest, radial_impulse = 0.0, 0.0
    if known == PARTLY:
        for j in range(mass.shape[0]):
            change = dt * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
            shocked = is_passing(q[j], sigma_half[j] - q[j], mass[j] / volume(rh[j], rh[j + 1], geometry) * c_[j] * c_[j])
            rho, energy = 1.0 / (volume(r[j], r[j + 1], geometry) * im[j]), e_[j] - sigma_half[j] * change
            before = warmed(Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), -q[j] * change, shocked, freezes, par.mixture)
            mixed = attempt(rho, energy, burned[j], before, par.mixture)
            p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.pressure, mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
            tried[j] = mixed.status
        for j in range(mass.shape[0]):
            if tried[j] != CONVERGED:      # what was tried is warm already
                change = dt * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
                rho, energy = 1.0 / (volume(r[j], r[j + 1], geometry) * im[j]), e_[j] - sigma_half[j] * change
                mixed = solve(rho, energy, burned[j], Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0), par.mixture)
                p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.pressure, mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
                tried[j] = mixed.status
    for j in range(mass.shape[0]):
        change = dt * im[j] * swept(rh[j], rh[j + 1], u[j], u[j + 1], geometry)
        energy = e_[j] - sigma_half[j] * change
        radial_impulse += sigma_half[j] * (area(rh[j + 1], geometry) - area(rh[j], geometry))
        v = volume(r[j], r[j + 1], geometry) * im[j]
        rho = 1.0 / v
        lam = burned[j] if known == PARTLY else known
        shocked = is_passing(q[j], sigma_half[j] - q[j], mass[j] / volume(rh[j], rh[j + 1], geometry) * c_[j] * c_[j])
        if isolates(par.mixture):
            reference[j] = found_state(reference[j], shocked, lam)
        if known == PARTLY:
            mixed = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], tried[j])
        else:
            before = at_rest(rho_r[j], e_r[j]) if known == UNBURNED else Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
            mixed = solve(rho, energy, lam, warmed(before, -q[j] * change, shocked, freezes, par.mixture), par.mixture)
        p = mixed.pressure
        c2 = sound_speed_squared(rho, p, slopes(rho, energy, lam, mixed, par.mixture))
        fault = status[j] + mixed.status
        c = wave_speed(c2, noise + 1.0) if fault == 0.0 else -1.0   # what has not begun to burn may have no sound at all
        inverse = 1.0 / (r[j + 1] - r[j])
        g[j] = (ue[j + 1] - ue[j]) * inverse
        fastest = fmax(fastest, (fmax(c, front) + 2.0 * speed[j]) * inverse)
        if 0.0 < lam < NEARLY:   # what has not begun has no rate
            # a term that ends at a small burn fraction (ignition) is looked past: it cannot burn more than the share of a step
            drive, heat = driving_pressure(p, q[j], par.rate), burn_temperature(lam, mixed, par.mixture, par.rate)
            pace = rate(fmax(lam, STEP_SHARE), rho, drive, heat, par.rate)
            fastest = fmax(fastest, per_rate * pace)
            if lam > IGNITED and pace > 0.0:
                resolved[j] = fmin(resolved[j], c * inverse / pace)
        status[j] = fault
        rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
        rho_[j] = rho
        e_[j] = energy
        p_[j] = p
        c_[j] = c
        viscous[j] -= q[j] * change
        sigma[j] = p + q[j]
    return fastest, radial_impulse
