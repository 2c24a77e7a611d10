"""What a burning material is made of: which closure joins reactants and products, the heat it holds, the state it rests in.

`Material.eos` are the products, `Material.unreacted` the explosive before it burns, `Material.mixture` the name of a closure of
`laws.mixture`. A burning zone's energy counts the chemical energy from the start, so that nothing is added while it burns (Starkenberg
section 3); see `docs/theory/mixtures.md`.
"""

from typing import Any

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, Reactive
from hugoniot.laws.eos.contract import EOS, has_temperature, reference_state
from hugoniot.laws.mixture import build
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.reference_state import CHOICES, FROZEN
from hugoniot.materials.initial_state import initial_state
from hugoniot.materials.material import Material


def closure(material: Material) -> str:
    """Name of the closure: the material's own, or the one its burn law is used with by its authors.

    Schedules burn into products alone (Herrmann A.29); what burns at once, and JWL++, weights pressures; rates take thermal isolation.
    """
    if material.mixture is not None:
        return material.mixture
    law = BURN.of(material.burn)
    if "programmed" in law.flags or ("compression_driven" in law.flags and "pressure_driven" not in law.flags):
        return "burned_products"
    return "weighted_pressures" if "instantaneous" in law.flags or law.name == "jwl_plus_plus" else "thermal_isolation"


def has_reactants(material: Material) -> bool:
    """Whether the unburned material has an equation of state of its own in a run."""
    return "no_reactants" not in MIXTURE.get(closure(material)).flags


def keeps_isentrope(material: Material) -> bool:
    """Whether the reactants stay on the isentrope through a reference state behind the shock, while a rate burns them."""
    flags = BURN.of(material.burn).flags
    return "follows_isentrope" in MIXTURE.get(closure(material)).flags and "instantaneous" not in flags and "programmed" not in flags


def outruns_itself(material: Material) -> bool:
    """Whether weak compressions burn their way ahead of the detonation: burning by compression with phases of equal pressure.

    The first products of an explosive without pressure fill almost any volume, so that a burn fraction F that follows the density raises
    the pressure as the square root of F, and the speed of small waves, c^2 = dp/drho + (dp/dF) dF/drho, has no bound as F vanishes
    (PBX-9404 in thermal isolation: 25 km/s at F = 1e-4).
    """
    flags = BURN.of(material.burn).flags
    return ("compression_driven" in flags and "pressure_driven" not in flags
            and "no_equilibrium" not in MIXTURE.get(closure(material)).flags)


def resting(material: Material) -> Any:
    """The equation of state in which a region of the material starts."""
    return material.unreacted if material.burn is not None and has_reactants(material) else material.eos


def reactive(material: Material) -> Reactive:
    """The pair of rate and mixture a solver burns the material with; OutOfRange where something it needs is missing."""
    law, kind = BURN.of(material.burn), closure(material)
    here = f"material '{material.name}'"
    if material.reference_state not in (None, *CHOICES):
        raise OutOfRange(f"{here}: unknown reference_state '{material.reference_state}'; use one of {', '.join(CHOICES)}")
    if material.reference_state == FROZEN and not keeps_isentrope(material):
        why = (f"'{kind}' does not keep the reactants on an isentrope" if "follows_isentrope" not in MIXTURE.get(kind).flags
               else f"the burn law '{law.name}' leaves no reactants behind a shock")
        raise OutOfRange(f"{here} has no reference state to freeze: {why}; leave out reference_state, or use mixture = "
                         "\"thermal_isolation\" with a rate law")
    if not has_reactants(material):
        if "pressure_driven" in law.flags or "temperature_driven" in law.flags:
            raise OutOfRange(f"{here}: the burn law '{law.name}' depends on the state of the unburned explosive, which '{kind}' does not "
                             "have; choose another mixture")
        if material.detonation_energy is None and "reacted" not in EOS.of(material.eos).flags:
            raise OutOfRange(f"{here}: its products ('{EOS.of(material.eos).name}') contain no chemical energy; give detonation_energy")
        return Reactive(material.burn, build.mixture(kind, None, material.eos))
    if material.unreacted is None:
        raise OutOfRange(f"{here}: the burn law '{law.name}' with '{kind}' needs the unreacted explosive; give it an [unreacted] "
                         "table with an equation of state")
    mixture = build.mixture(kind, material.unreacted, material.eos, material.detonation_energy, build.IN_A_RUN)
    if not mixture.detonation_energy > 0.0:
        raise OutOfRange(f"{here}: burning would release {mixture.detonation_energy:.6g} J/kg, which is not positive; give "
                         "detonation_energy, or products with their E0")
    if "temperature_driven" in law.flags:
        for role, par in (("unreacted explosive", material.unreacted), ("products", material.eos)):
            if not has_temperature(par):
                raise OutOfRange(f"{here}: the burn law '{law.name}' needs the temperature of the {role}; give it a specific_heat")
    return Reactive(material.burn, mixture)


def heat_of(material: Material) -> float:
    """Chemical energy of the unburned material, J/kg: what burning all of it releases."""
    if has_reactants(material):
        return float(reactive(material).mixture.detonation_energy)
    given = material.detonation_energy
    return float(reference_state(material.eos)[1] if given is None else given)


def start_state(material: Material, density=None, pressure=None, temperature=None, energy=None) -> tuple[float, float]:
    """(rho, e) of an unburned region, e with the chemical energy; the arguments are a region's. OutOfRange where they do not fit.

    An `energy` is thermal: it adds to the chemical one. Without reactants there is no pressure or temperature to start from.
    """
    heat = heat_of(material)
    if has_reactants(material):
        rho, e = initial_state(material.unreacted, density, pressure, temperature, energy)
        return rho, e + heat
    if pressure is not None or temperature is not None:
        raise OutOfRange(f"material '{material.name}' has no pressure or temperature before it burns (closure 'burned_products'); give its "
                         "density, or an unreacted equation of state and another mixture")
    return density or float(reference_state(material.eos)[0]), heat + (energy or 0.0)
