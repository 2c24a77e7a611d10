"""Pairs of laws, and states of their mixtures about the isentrope of the shocked reactant, that the mixture tests share."""

import numpy as np

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.isentrope import isentrope_energy
from hugoniot.theory import mixture as tool

RHO0 = 1895.0
PRODUCTS = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, RHO0, 6.9e9, 1.0e6 / RHO0)
UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, RHO0, 0.0, 2.487e6 / RHO0)
PAIRS = {
    "two gases": (IdealGas(5.0, 1000.0, RHO0), IdealGas(2.8, 1200.0, RHO0)),
    "jwl, jwl": (UNREACTED, PRODUCTS),
    "mie-grueneisen, jwl": (MieGruneisen(RHO0, 2900.0, 1.68, 1.1, 1100.0), PRODUCTS),
    "stiffened gas, gas": (StiffenedGas(4.4, 2.0e9, RHO0, 1400.0), IdealGas(2.8, 1200.0, RHO0)),
}
Q = 4.5e6
KINDS = ("thermal_isolation", "thermal_equilibrium")


def shocked(par, pressure=2.0e10):
    """(rho, thermal energy) behind a shock of that pressure into material of RHO0 at rest and zero pressure."""
    e = (0.0 - eos.pressure(RHO0, 0.0, par)) / eos.pressure_derivatives(RHO0, 0.0, par)[1]
    v = tool.hugoniot_volume(pressure, RHO0, e, 0.0, par)
    return 1.0 / v, e + 0.5 * pressure * (1.0 / RHO0 - v)


def states(pair, kind, count=12, seed=1):
    """Mixture and states about the isentrope of the shocked reactant, as (par, v, e, lambda, reference).

    The energy's distance from that isentrope is a share of lambda Q: all of it belongs to the products.
    """
    par = tool.mixture(kind, *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    rng = np.random.default_rng(seed)
    rho = rho_k * rng.uniform(0.75, 1.03, count)
    lam = rng.uniform(0.05, 0.98, count)
    along = np.array([isentrope_energy(1.0 / rho_k, e_k, 1.0 / r, par.reactants) for r in rho])
    e = along + Q * (1.0 + lam * rng.uniform(-0.1, 0.3, count))
    return par, 1.0 / rho, e, lam, (rho_k, e_k + Q)


def derivative(function, x, h):
    """Sixth-order central difference."""
    f = [function(x + k * h) - function(x - k * h) for k in (1, 2, 3)]
    return (45.0 * f[0] - 9.0 * f[1] + f[2]) / (60.0 * h)


def solve_all(rho, e, burn_fraction, phases, par):
    """`mixture_kernels.solve_rows`, in Python where that takes less than compiling it: the same source."""
    if type(par.reactants).__name__ == "MieGruneisen" and MIXTURE.of(par).name == "thermal_isolation":       # whose isentrope is integrated
        from hugoniot.laws import mixture_kernels

        mixture_kernels.solve_rows(rho, e, burn_fraction, phases, par)
        return
    with np.errstate(all="ignore"):
        for j, (r, k, fraction, *before) in enumerate(zip(*(row.tolist() for row in (rho, e, burn_fraction, *phases)))):
            phases[:, j] = contract.solve(r, k, fraction, contract.Mixed(*before), par)
