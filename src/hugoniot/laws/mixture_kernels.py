"""Compiled sweeps over arrays of mixture states: solve, slopes, temperature. Importing this module imports numba."""

import numba as nb

from hugoniot.core.target import CURVE
from hugoniot.laws.mixture.binding import bind_mixtures
from hugoniot.laws.mixture.contract import Mixed, equilibrate, mixture_temperature, slopes, solve

bind_mixtures()


@nb.njit(**CURVE)
def equilibrate_rows(rho, e, burn_fraction, rho_reference, e_reference, par, out):
    """Solve every state; `out` (9, n) receives p, rho_r, e_r, rho_p, e_p, status, p_v, p_e, p_lambda."""
    for j in range(rho.shape[0]):
        before = Mixed(0.0, rho_reference[j], e_reference[j], 0.0, 0.0, 0.0)
        mixed = equilibrate(rho[j], e[j], burn_fraction[j], before, par)
        slope = slopes(rho[j], e[j], burn_fraction[j], mixed, par)
        out[0, j] = mixed.pressure
        out[1, j] = mixed.rho_r
        out[2, j] = mixed.e_r
        out[3, j] = mixed.rho_p
        out[4, j] = mixed.e_p
        out[5, j] = mixed.status
        out[6, j] = slope.by_volume
        out[7, j] = slope.by_energy
        out[8, j] = slope.by_burn_fraction


@nb.njit(**CURVE)
def solve_rows(rho, e, burn_fraction, phases, par):
    """One step of a run: `phases` (6, n), p, rho_r, e_r, rho_p, e_p, status of the step before, is overwritten by the new state."""
    for j in range(rho.shape[0]):
        before = Mixed(phases[0, j], phases[1, j], phases[2, j], phases[3, j], phases[4, j], phases[5, j])
        mixed = solve(rho[j], e[j], burn_fraction[j], before, par)
        phases[0, j] = mixed.pressure
        phases[1, j] = mixed.rho_r
        phases[2, j] = mixed.e_r
        phases[3, j] = mixed.rho_p
        phases[4, j] = mixed.e_p
        phases[5, j] = mixed.status


@nb.njit(**CURVE)
def temperature_rows(phases, par, out):
    """Temperature, K, of states given as `phases` (n, 5): burn fraction, rho_r, e_r, rho_p, e_p."""
    for j in range(out.shape[0]):
        mixed = Mixed(0.0, phases[j, 1], phases[j, 2], phases[j, 3], phases[j, 4], 0.0)
        out[j] = mixture_temperature(phases[j, 0], mixed, par)
