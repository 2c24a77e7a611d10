"""Constants that no solid or liquid has: mostly numbers whose unit was forgotten or mistaken."""

from hugoniot.laws.eos.contract import EOS, density_limits, flagged, is_condensed, reference_state, sound_speed_squared
from hugoniot.materials.material import Material

COMPRESSED = 1.1      # times the density at rest, up to which a solid or liquid has to have a sound speed
# key -> (least, largest, SI unit, the unit in which people give it). Below are gases, aerogels and numbers whose unit was forgotten;
# osmium has 22 600 kg/m3, diamond 12 km/s
LIMITS = {"rho0": (50.0, 25e3, "kg/m^3", "g/cm^3"), "c0": (100.0, 25e3, "m/s", "km/s"), "shear_modulus": (1e4, 1e12, "Pa", "GPa"),
          "yield_stress": (1e3, 1e11, "Pa", "GPa"), "specific_heat": (50.0, 15e3, "J/kg/K", "J/g/K"), "s": (0.1, 10.0, "", ""),
          "gamma0": (0.01, 10.0, "", "")}


def unlikely(name: str, material: Material) -> list[str]:
    """What to say of constants outside those of all known solids and liquids, and of laws that soften at once."""
    laws, found = [material.eos], _softening(name, material.eos)
    if material.strength is not None:
        laws.append(material.strength)
    while laws:
        par = laws.pop()
        if EOS.knows(par) and _is_gas(par):
            continue
        laws += [value for value in par if EOS.knows(value)]
        for key, value in par._asdict().items():
            least, largest, unit, better = LIMITS.get(key, (0.0, 0.0, "", ""))
            if not isinstance(value, float) or not value > 0.0 or key not in LIMITS or least <= value <= largest:
                continue
            doubt = f"A bare number is SI; write \"{value:g} {better}\" if that is what you mean" if value < least and better else \
                f"No known material comes near this: is {'the unit' if unit else 'the value'} right?"
            found.append(f"material '{name}': {key} = {' '.join((f'{value:g}', unit)).strip()} for a solid or liquid? {doubt}")
    return found


def _is_gas(par) -> bool:
    """Whether a law is that of a gas; a table may hold one."""
    law = EOS.of(par)
    return "gas" in law.flags or law.name == "table" and not is_condensed(par)


def _softening(name: str, par) -> list[str]:
    """A law without a sound speed at small compression, where its pressure falls: a wrong sign, or a slip of a power."""
    if "gas" in EOS.of(par).flags or flagged(par, "remembers"):
        return []
    rho, e = reference_state(par)
    for k in range(1, 21):
        density = rho * (1.0 + (COMPRESSED - 1.0) * k / 20.0)
        if density < density_limits(par)[1] and sound_speed_squared(density, e, par) < 0.0:
            return [f"material '{name}': the law has no real sound speed above {density:.6g} kg/m3, {100.0 * (density / rho - 1.0):.2g} % "
                    "above its reference density: its pressure falls with compression there; check signs and powers of the coefficients"]
    return []
