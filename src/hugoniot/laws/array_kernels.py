"""Compiled sweeps over arrays of states, one per quantity, for any registered law. Importing this imports numba."""

import numba as nb

import hugoniot.laws.eos  # noqa: F401  (enrols every law)
from hugoniot.core.binder import bind_family, bind_module
from hugoniot.core.target import GUARD, SWEEP
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import (
    EOS,
    GENERICS,
    energy,
    entropy,
    pressure,
    pressure_derivatives,
    remembered,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.strength import contract as strength_contract
from hugoniot.laws.strength.contract import STRENGTH, shear_modulus

bind_family(STRENGTH, strength_contract.GENERICS)
bind_family(EOS, GENERICS)
bind_module(contract)

# A loop that may end at any state is made for one state at a time: made for several lanes, those states
# that fill no lane get other bits.
NEVER = -1e300


@nb.njit(**SWEEP)
def pressure_sweep(rho, e, par, out):
    for j in range(out.shape[0]):
        out[j] = pressure(rho[j], e[j], par)


@nb.njit(**SWEEP)
def derivatives_sweep(rho, e, par, p_rho, p_e):
    for j in range(p_rho.shape[0]):
        a, b = pressure_derivatives(rho[j], e[j], par)
        p_rho[j] = a
        p_e[j] = b


@nb.njit(**SWEEP)
def sound_speed_squared_sweep(rho, e, par, out):
    for j in range(out.shape[0]):
        out[j] = sound_speed_squared(rho[j], e[j], par)


@nb.njit(**SWEEP)
def temperature_sweep(rho, e, par, out):
    for j in range(out.shape[0]):
        out[j] = temperature(rho[j], e[j], par)


@nb.njit(**GUARD)
def recorded_temperature_rows(rho, e, par, out):
    for j in range(out.shape[0]):
        out[j] = temperature(rho[j], e[j], par)
        if out[j] == NEVER:
            break


@nb.njit(**GUARD)
def remembered_temperature_rows(rho, e, compaction, par, out):
    for j in range(out.shape[0]):
        out[j] = temperature(rho[j], e[j], remembered(compaction[j], par))
        if out[j] == NEVER:
            break


@nb.njit(**SWEEP)
def energy_sweep(rho, p, par, out):
    for j in range(out.shape[0]):
        out[j] = energy(rho[j], p[j], par)


@nb.njit(**SWEEP)
def entropy_sweep(rho, e, par, out):
    for j in range(out.shape[0]):
        out[j] = entropy(rho[j], e[j], par)


@nb.njit(**GUARD)
def shear_modulus_sweep(rho, p, temperature, bulk_modulus, par, out):
    for j in range(out.shape[0]):
        out[j] = shear_modulus(rho[j], p[j], temperature[j], bulk_modulus[j], par)
