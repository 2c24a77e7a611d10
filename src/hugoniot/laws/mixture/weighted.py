r"""Pressures weighted by the mass fractions, with both phases at the density and specific internal energy of the mixture.

$$p = (1-\lambda)\,p_r(\rho, e - Q) + \lambda\,p_p(\rho, e) \;(\text{weighted pressures}), \qquad
  p = \lambda\,p_p(\rho, e) \;(\text{burned products})$$

* $\lambda$: burn fraction, the mass fraction of products
* $\rho$, $e$, $p$: density, specific internal energy and pressure of the mixture
* $p_r$, $p_p$: pressures of the equations of state of reactants and products
* $Q$: chemical energy, `detonation_energy`; $e$ includes it, but the equation of state of the reactants does not

The phases are not in equilibrium, and the weighted pressure has no thermodynamic meaning. `weighted_pressures` is the simple rule of many
codes; it is the default with the burn laws `jwl_plus_plus` and `threshold`. `burned_products` leaves out the pressure of the reactants; it
is the default with the burn laws `programmed`, `beta` and `programmed_beta`.

The specific internal energy of an unburned zone includes $Q$ from the start. With `burned_products`, $Q$ is the energy that the equation of
state of the products assigns to the unburned explosive (for JWL $E_0/\rho_0$), unless the material has the key `detonation_energy`. The key
is required if that equation of state contains no chemical energy, as is the case for an ideal gas.
"""

from typing import NamedTuple

from hugoniot.laws.eos.contract import pressure, temperature
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.mixture.contract import MIXTURE, Mixed, PhaseSlopes, Slopes, volume_slopes


class WeightedPressures(NamedTuple):
    reactants: NamedTuple
    products: NamedTuple
    detonation_energy: float


class BurnedProducts(NamedTuple):
    products: NamedTuple


def solve(rho, e, burn_fraction, before, par):
    """No search: both phases have the mixture's density and energy. Phases that carry no mass are not evaluated."""
    p = 0.0
    if burn_fraction < 1.0:
        p = (1.0 - burn_fraction) * pressure(rho, e - par.detonation_energy, par.reactants)
    if burn_fraction > 0.0:
        p = p + burn_fraction * pressure(rho, e, par.products)
    return Mixed(p, rho, e, rho, e, 0.0)


def slopes(rho, e, burn_fraction, mixed, par):
    """Weighted slopes; by burn fraction the difference of the pressures."""
    lam = burn_fraction
    r_v, r_e = volume_slopes(rho, e - par.detonation_energy, par.reactants)
    p_v, p_e = volume_slopes(rho, e, par.products)
    p_l = pressure(rho, e, par.products) - pressure(rho, e - par.detonation_energy, par.reactants)
    return Slopes((1.0 - lam) * r_v + lam * p_v, (1.0 - lam) * r_e + lam * p_e, p_l)


def phase_slopes(burn_fraction, mixed, par):
    """Both phases share the mixture's volume and energy."""
    return PhaseSlopes(1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0)


def weighted_temperature(burn_fraction, mixed, par):
    """Mass-weighted temperature: a label for gauges, with no more meaning than the pressure."""
    t_r = temperature(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants) if burn_fraction < 1.0 else 0.0
    t_p = temperature(mixed.rho_p, mixed.e_p, par.products) if burn_fraction > 0.0 else 0.0
    return (1.0 - burn_fraction) * t_r + burn_fraction * t_p


def products_solve(rho, e, burn_fraction, before, par):
    """p = lambda p_p (A.29): no pressure before the detonation arrives."""
    p = burn_fraction * pressure(rho, e, par.products) if burn_fraction > 0.0 else 0.0
    return Mixed(p, rho, e, rho, e, 0.0)


def products_slopes(rho, e, burn_fraction, mixed, par):
    p_v, p_e = volume_slopes(rho, e, par.products)
    return Slopes(burn_fraction * p_v, burn_fraction * p_e, pressure(rho, e, par.products))


def products_temperature(burn_fraction, mixed, par):
    return temperature(mixed.rho_p, mixed.e_p, par.products)


MIXTURE.add(
    "weighted_pressures", WeightedPressures,
    functions={"solve": solve, "attempt": solve, "equilibrate": solve, "slopes": slopes, "phase_slopes": phase_slopes,
               "temperature": weighted_temperature},
    example=WeightedPressures(IdealGas(5.0, 1000.0, 1600.0), IdealGas(2.8, 1200.0, 1600.0), 5.0e6),
    units={"reactants": "", "products": "", "detonation_energy": "J/kg"},
    meaning={"reactants": "equation of state of the unreacted material", "products": "equation of state of the products",
             "detonation_energy": "chemical energy Q released by burning, not negative"},
    box={"rho": (1200.0, 3000.0), "e": (6e6, 9e6), "burn_fraction": (0.0, 1.0)},
    references=("Herrmann, WL-TR-64-107 (1964), A.29", "KB codes manual (Field Precision, 2000), section 4"),
    flags=("no_equilibrium",),
)

MIXTURE.add(
    "burned_products", BurnedProducts, line="Burned products alone: no pressure before the detonation arrives.",
    functions={"solve": products_solve, "attempt": products_solve, "equilibrate": products_solve, "slopes": products_slopes,
               "phase_slopes": phase_slopes, "temperature": products_temperature},
    example=BurnedProducts(IdealGas(2.8, 1200.0, 1600.0)),
    units={"products": ""}, meaning={"products": "equation of state of the products"},
    box={"rho": (1200.0, 3000.0), "e": (1e6, 9e6), "burn_fraction": (0.0, 1.0)},
    references=("Herrmann, WL-TR-64-107 (1964), A.29",),
    flags=("no_equilibrium", "no_reactants"),
)
