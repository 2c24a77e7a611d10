"""Constants that no solid or liquid has: mostly numbers whose unit was forgotten or mistaken."""

from hugoniot.laws.eos.contract import EOS
from hugoniot.materials.material import Material

# key -> (least, largest, SI unit, the unit in which people give it). Below are gases, aerogels and numbers whose unit was forgotten;
# osmium has 22 600 kg/m3, diamond 12 km/s
LIMITS = {"rho0": (50.0, 25e3, "kg/m^3", "g/cm^3"), "c0": (100.0, 25e3, "m/s", "km/s")}


def unlikely(name: str, material: Material) -> list[str]:
    """What to say of densities and sound speeds at rest outside the range of all known solids and liquids."""
    laws, found = [material.eos], []
    while laws:
        par = laws.pop()
        if "gas" in EOS.of(par).flags:
            continue
        laws += [value for value in par if EOS.knows(value)]
        for key, value in par._asdict().items():
            least, largest, unit, better = LIMITS.get(key, (0.0, 0.0, "", ""))
            if not isinstance(value, float) or not value > 0.0 or key not in LIMITS or least <= value <= largest:
                continue
            found.append(f"material '{name}': {key} = {value:g} {unit} for a solid or liquid? "
                         + (f"A bare number is SI; write \"{value:g} {better}\" if that is what you mean" if value < least else
                            "No known material comes near this: is the unit right?"))
    return found
