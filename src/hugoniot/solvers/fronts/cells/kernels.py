"""The one compiled sweep of the cells: pressure and its slopes for a row of states, for any equation of state."""

import numba as nb

import hugoniot.laws.eos  # noqa: F401  (enrols every law)
from hugoniot.core.binder import bind_family, bind_module
from hugoniot.core.target import GUARD
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS, GENERICS, pressure_and_derivatives

bind_family(EOS, GENERICS)
bind_module(contract)


@nb.njit(**GUARD)
def states(rho, e, par, p, p_rho, p_e):
    for j in range(rho.shape[0]):
        a, b, c = pressure_and_derivatives(rho[j], e[j], par)
        p[j] = a
        p_rho[j] = b
        p_e[j] = c
