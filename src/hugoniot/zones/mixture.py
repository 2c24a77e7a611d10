"""Closure of burning material: a mixture of reactants and products in place of the equation of state of inert material.

    solve        pressure and both phases at a given energy and burn fraction
    slopes       c^2 and dp/de of a solved mixture
    temperature  T of a solved mixture
    bare, isolates   kind of a closure: without reactants, with reactants on an isentrope

Most zones of a charge have not begun to burn or have burned out, and are plain material. Runs of zones that are all unburned,
all burned out, or all burning go through the same loop. For a burn fraction of 0 or 1 that is known when it is compiled,
the loop contains nothing of a mixture and is vectorised like that of inert zones.

A search starts from the state of the previous step, heated by the share of the step's heat that its phases receive (`heat`). A search
that fails leaves its status. Passes are compiled for a mixture, independent of its burn law.

Source: Starkenberg ARL-TR-2161 sections 3 to 5; `docs/theory/mixtures.md`.
"""

import numba as nb

from hugoniot.core.passes import flag_of, law_of, rows_apart, zone_pass
from hugoniot.core.target import SWEEP
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

UNBURNED, PARTLY, BURNED = 0.0, -1.0, 1.0
isolates = flag_of(MIXTURE, "follows_isentrope")     # whether the reactants keep an isentrope, and so have a reference state
bare = flag_of(MIXTURE, "no_reactants")              # whether nothing stands for the explosive before it burns


def whole(lam):
    """UNBURNED, BURNED, or PARTLY for what is between: the burn fraction where a loop may know it."""
    return lam if lam in (UNBURNED, BURNED) else PARTLY


def before(z, j):
    """The phases of the previous step, warmed."""
    return heated(phases(z, j), z.heat[j])


def phases(z, j):
    """The phases in rows."""
    return Mixed(z.p[j], z.rho_r[j], z.e_r[j], z.rho_p[j], z.e_p[j], 0.0)


@nb.njit(**SWEEP)
def end_of_stretch(lam, start, count):
    """Where the zones from `start` on that have all burned nothing, all burned whole, or all burned a part, end."""
    known, others = whole(lam[start]), 0
    for j in range(start + 1, count):     # mostly none, which a packed loop finds soonest
        others += whole(lam[j]) != known
    if others == 0:
        return count
    stop = start + 1
    while whole(lam[stop]) == known:
        stop += 1
    return stop


@nb.njit(**SWEEP)
def keep(z, j, mixed):
    z.new_p[j] = mixed.pressure
    z.new_rho_r[j] = mixed.rho_r
    z.new_e_r[j] = mixed.e_r
    z.new_rho_p[j] = mixed.rho_p
    z.new_e_p[j] = mixed.e_p
    z.status[j] = mixed.status


@nb.njit(**SWEEP)
def keep_slopes(z, j, mixed, lam, mixture):
    slope = slopes(z.rho[j], z.e[j], lam, mixed, mixture)
    z.c2[j] = sound_speed_squared(z.rho[j], mixed.pressure, slope)
    z.p_e[j] = slope.by_energy


@nb.njit(**SWEEP)
def solve_pure(z, start, stop, known, mixture):
    """Zones that have burned nothing, or whole."""
    for j in range(start, stop):
        start_from = heated(at_rest(z.rho_r[j], z.e_r[j]), z.heat[j]) if known == UNBURNED else before(z, j)
        mixed = solve(z.rho[j], z.e[j], known, start_from, mixture)
        keep(z, j, mixed)
        keep_slopes(z, j, mixed, known, mixture)


@zone_pass("rho e lam heat p rho_r e_r rho_p e_p new_p new_rho_r new_e_r new_rho_p new_e_p status c2 p_e")
def solve_pass(count, z, dt, numbers, law):
    """rho, e, lam (burn fraction), heat (J/kg), the phases before (p, rho_r, e_r, rho_p, e_p) -> the phases now (new_...) and status.

    Of what has burned nothing or whole also c2 and p_e (`slopes_pass`): they share the exponentials of its pressure.
    """
    rows_apart()
    mixture, start = law_of(law, numbers), 0
    while start < count:
        known, stop = whole(z.lam[start]), end_of_stretch(z.lam, start, count)
        if known == UNBURNED:
            solve_pure(z, start, stop, UNBURNED, mixture)
        elif known == BURNED:
            solve_pure(z, start, stop, BURNED, mixture)
        else:
            for j in range(start, stop):
                keep(z, j, attempt(z.rho[j], z.e[j], z.lam[j], before(z, j), mixture))
            for j in range(start, stop):
                if z.status[j] != CONVERGED:
                    keep(z, j, solve(z.rho[j], z.e[j], z.lam[j], before(z, j), mixture))
        start = stop


@nb.njit(**SWEEP)
def slopes_of_pure(z, start, stop, known, mixture):
    for j in range(start, stop):
        keep_slopes(z, j, phases(z, j), known, mixture)


@nb.njit(**SWEEP)
def slopes_of_mixed(z, start, stop, mixture):
    for j in range(start, stop):
        keep_slopes(z, j, phases(z, j), z.lam[j], mixture)


@zone_pass("rho e lam p rho_r e_r rho_p e_p c2 p_e")
def slopes_pass(count, z, dt, numbers, law):
    """rho, e, lam and solved phases -> c2 (m2/s2), p_e (dp/de at constant density, kg/m3)."""
    rows_apart()
    mixture, start = law_of(law, numbers), 0
    while start < count:
        known, stop = whole(z.lam[start]), end_of_stretch(z.lam, start, count)
        if known == UNBURNED:
            slopes_of_pure(z, start, stop, UNBURNED, mixture)
        elif known == BURNED:
            slopes_of_pure(z, start, stop, BURNED, mixture)
        else:
            slopes_of_mixed(z, start, stop, mixture)
        start = stop


@zone_pass(slopes_pass.rows)
def mixed_slopes_pass(count, z, dt, numbers, law):
    """The slopes of what has burned a part; `solve_pass` has found those of the rest."""
    rows_apart()
    mixture, start = law_of(law, numbers), 0
    while start < count:
        known, stop = whole(z.lam[start]), end_of_stretch(z.lam, start, count)
        if known == PARTLY:
            slopes_of_mixed(z, start, stop, mixture)
        start = stop


@zone_pass("lam p rho_r e_r rho_p e_p temperature")
def mixture_temperature_pass(count, z, dt, numbers, law):
    """lam and phases -> temperature (K)."""
    rows_apart()
    mixture = law_of(law, numbers)
    for j in range(count):
        z.temperature[j] = mixture_temperature(z.lam[j], phases(z, j), mixture)
