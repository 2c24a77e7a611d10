r"""Shocks in which part of an explosive burns, and the chemical potential of a mixture.

**Reaction inside the shock** (Starkenberg, section 5.8): the burn fraction rises by $\Delta\lambda_H$ across the front,
$\lambda = \lambda_u + \Delta\lambda_H$. The remaining reactant is on its own Hugoniot from the upstream state. All products, old and
new, are in the same state, which follows from the jump conditions of the mixture:

$$e - e_u = \tfrac12(p + p_u)(v_u - v), \qquad v = (1-\lambda)v_r + \lambda v_p, \quad e = (1-\lambda)e_r + \lambda e_p .$$

With nothing reacted this is the frozen Hugoniot, provided that earlier products are on theirs; with everything reacted it is the detonation
Hugoniot. Partly reacted shocks lie between the two. At $\Delta\lambda_H = 1$ the least velocity is that of Chapman and Jouguet.

**Chemical potential** (Starkenberg, section 4.1): with the reactants on their isentrope, or both phases at one temperature,

$$\mu = \left(\frac{\partial e}{\partial\lambda}\right)_{v,s} = e_p - e_r + p\,(v_p - v_r) - T\,(s_p - s_r),$$

where T is the temperature of the products. Each law has its own zero of entropy; a constant difference between the two changes $\mu$ by T
times that difference.
"""

import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.theory.mixture import FrozenHugoniot, MixtureState, frozen_hugoniot, hugoniot_volume, unburned_row

WIDEST = 40.0     # of the upstream volume: how far products are looked for


def reacting_hugoniot(upstream: MixtureState, pressures, reacted: float | Callable[[float], float]) -> FrozenHugoniot:
    """Shocked mixtures at given pressures of which a part has burned in the front.

    reacted   mass fraction that burns in the shock, or a function of the pressure behind it; with 0 this is `frozen_hugoniot`
    Velocities are relative to upstream. Raises NoSolution where no compressive shock gives the state, OutOfRange for more than remains
    unburned.
    """
    p = np.atleast_1d(np.asarray(pressures, float))
    more = np.array([reacted(float(x)) if callable(reacted) else float(reacted) for x in p])
    lam_u = float(upstream.burn_fraction)
    if not ((more >= 0.0) & (lam_u + more <= 1.0 + 1e-12)).all():
        raise OutOfRange(f"the mass fraction that burns in the shock must lie between 0 and {1.0 - lam_u:.6g}, got "
                         + ", ".join(f"{x:.6g}" for x in more[~((more >= 0.0) & (lam_u + more <= 1.0 + 1e-12))][:3]))
    if not more.any() and lam_u > 0.0:
        return frozen_hugoniot(upstream, p)
    par, u = upstream.par, upstream.mixed()
    q, v_u, e_u, p_u = par.detonation_energy, 1.0 / float(upstream.density), float(upstream.energy), u.pressure
    rows = []
    for x, extra in zip(p, more):
        lam = min(lam_u + extra, 1.0)
        v_r = hugoniot_volume(x, u.rho_r, u.e_r - q, p_u, par.reactants) if lam < 1.0 else 1.0 / u.rho_r
        e_r = u.e_r + 0.5 * (x + p_u) * (1.0 / u.rho_r - v_r)
        v_p = _product_volume(x, lam, v_r, e_r, (v_u, e_u, p_u), par.products) if lam > 0.0 else math.nan
        v = (1.0 - lam) * v_r + (lam * v_p if lam > 0.0 else 0.0)
        if not v < v_u:
            raise NoSolution(f"a front to {x:.6g} Pa in which a mass fraction of {extra:.4g} burns would expand the explosive: "
                             "no shock exists")
        e = e_u + 0.5 * (x + p_u) * (v_u - v)
        kept = (v_r, e_r) if lam < 1.0 else (math.nan, math.nan)
        rows.append((v, e, *kept, v_p, (e - (1.0 - lam) * e_r) / lam if lam > 0.0 else math.nan))
    v, e, v_r, e_r, v_p, e_p = np.array(rows).T
    jump, slope = np.sqrt((p - p_u) * (v_u - v)), (p - p_u) / (v_u - v)
    return FrozenHugoniot(p, 1.0 / v, e, 1.0 / v_r, e_r, 1.0 / v_p, e_p, jump, v_u * np.sqrt(slope))


def unburned(density: float, energy: float, par) -> MixtureState:
    """Upstream explosive of which nothing has burned, at rest included, where nascent products have no state; energy with Q, J/kg."""
    return MixtureState(par, *map(np.array, (density, energy, 0.0, *unburned_row(density, energy, par))))


def _product_volume(p: float, lam: float, v_r: float, e_r: float, ahead: tuple[float, float, float], products) -> float:
    """Volume of the products with which the mixture's jump closes, m3/kg: the largest, the branch on which products expand freely."""
    v_u, e_u, p_u = ahead

    def miss(v_p: float) -> float:
        e = e_u + 0.5 * (p + p_u) * (v_u - (1.0 - lam) * v_r - lam * v_p)
        return eos.pressure(1.0 / v_p, (e - (1.0 - lam) * e_r) / lam, products) - p

    tightest = 1.0 / min(float(eos.density_limits(products)[1]), 20.0 / v_u)
    trial, value = WIDEST * v_u, miss(WIDEST * v_u)
    while trial > tightest * (1.0 + 1e-9):
        inner = max(trial / 1.02, tightest)
        found = miss(inner)
        if value < 0.0 <= found:
            return brentq(miss, inner, trial, xtol=1e-15 * v_u, rtol=8.9e-16)
        trial, value = inner, found
    raise NoSolution(f"no state of the products at {p:.6g} Pa satisfies the jump conditions of the mixture")


def chemical_potential(state: MixtureState) -> np.ndarray:
    """mu of every state, J/kg; OutOfRange where a law has no entropy."""
    par, q = state.par, state.par.detonation_energy
    for name, law in (("reactants", par.reactants), ("products", par.products)):
        if not eos.gives(law, "entropy"):
            raise OutOfRange(f"the chemical potential needs the entropy of the {name}, which their law does not give; add a specific_heat")
    found = np.empty(state.density.shape)
    for i in np.ndindex(found.shape):
        m = state.mixed(i)
        heat = state.temperature[i] * (eos.entropy(m.rho_p, m.e_p, par.products) - eos.entropy(m.rho_r, m.e_r - q, par.reactants))
        found[i] = m.e_p - m.e_r + m.pressure * (1.0 / m.rho_p - 1.0 / m.rho_r) - heat
    return found
