"""Puts a mixture's parameter tuple together from two equations of state."""

import math
from typing import Any

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture.contract import MIXTURE

IN_A_RUN = 1e-3


def detonation_energy(reactants, products) -> float:
    """Q = -(heat of detonation), J/kg: energy of the products' law in the unburned state less the reactants' own (Starkenberg section 3).

    Both laws answer with their reference state; a JWL's is E0/rho0 at its rho0.
    """
    return float(eos.reference_state(products)[1] - eos.reference_state(reactants)[1])


def require_temperature(asker: str, role: str, par) -> None:
    """OutOfRange unless the equation of state gives temperature and specific heat at its reference state."""
    law = eos.EOS.of(par)
    heat = 0.0
    if {"temperature", "specific_heat"} <= set(law.functions):
        heat = float(eos.specific_heat(*eos.reference_state(par), par))
    if not (heat > 0.0 and math.isfinite(heat)):
        raise OutOfRange(f"{asker} needs the temperature of the {role}, which law '{law.name}' does not give here: give its "
                         "specific_heat, or choose a law that has one")


def mixture(kind: str, reactants, products, energy: float | None = None, nascent_limit: float = 1e-6):
    """Parameter tuple of a mixture law of that name ("thermal_isolation", ...), with the density limits of both phases filled in.

    reactants   may be None for "burned_products"
    energy      Q in J/kg; None: from the reference states of the two laws
    nascent_limit   of "thermal_isolation": 1e-6 for exact energies, 1e-3 (IN_A_RUN) in a solver
    Raises UnknownName for another kind, OutOfRange for a phase that is missing or lacks what the closure needs.
    """
    law = MIXTURE.get(kind)
    fields = law.parameters._fields
    for role, par in (("reactants", reactants), ("products", products)):
        if role in fields and par is None:
            raise OutOfRange(f"a mixture of kind '{kind}' needs an equation of state of its {role}: give one, or use 'burned_products'")
        if role in fields and "needs_temperature" in law.flags:
            require_temperature(kind, role, par)
    given: dict[str, Any] = {"reactants": reactants, "products": products}
    if "detonation_energy" in fields:
        given["detonation_energy"] = detonation_energy(reactants, products) if energy is None else float(energy)
    if "reactant_density_limit" in fields:
        # kernels are compiled with fast-math, which knows no infinity: a law without limit gets one no state reaches
        given["reactant_density_limit"] = min(float(eos.density_limits(reactants)[1]), 1e30)
        given["product_density_limit"] = min(float(eos.density_limits(products)[1]), 1e30)
    if "nascent_limit" in fields:
        given["nascent_limit"] = float(nascent_limit)
    return law.parameters(**{name: given[name] for name in fields})
