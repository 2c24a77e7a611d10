"""Fields of `[output] fields`: which solver has which, so that none is asked for in vain."""


from hugoniot.core.fields import FIELDS
from hugoniot.laws.eos.contract import gives, has_temperature
from hugoniot.laws.fracture.contract import opens_voids
from hugoniot.materials.collect import nearest, printable

OF_THE_PLANE = ("position_x", "position_y", "velocity_x", "velocity_y", "deviator_xx", "deviator_yy", "deviator_xy", "deviator_zz",
                "principal_angle", "momentum_x", "momentum_y", "contact_pressure", "gap", "sliding_distance", "eroded")
OF_THE_LINE = ("position", "velocity", "deviator_radial", "deviator_hoop", "momentum", "stress", "compaction", "mass")


def trouble_with(name: str, raw: dict) -> tuple[str, str] | None:
    """(message, hint) about a field that a deck cannot ask its solver for; None for one that it can."""
    solver = raw.get("solver")
    plane = isinstance(solver, dict) and solver.get("kind") == "lagrange2d"
    other = OF_THE_LINE if plane else OF_THE_PLANE
    if name not in FIELDS:
        return f"unknown field '{printable(name)}'", nearest(name, [field for field in FIELDS if field not in other])
    if name in other:
        return f"no field '{name}' in {'two dimensions' if plane else 'one dimension'}", "hugoniot list fields shows all"
    return None


def defects(output, regions, materials) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of fields that no material of the regions, or blocks, has."""
    used, found = [materials[region.material] for region in regions], []
    if "entropy" in output.fields and not any(material.burn is None and gives_entropy(material.eos) for material in used):
        found.append((("output", "fields"), "no material of this problem has an entropy",
                      "its equations of state give none, or lack the specific_heat for one; remove 'entropy'"))
    if "void_fraction" in output.fields and not any(opens_voids(material.fracture) for material in used):
        found.append((("output", "fields"), "no material of this problem opens voids",
                      "none has a fracture law such as spall_stress; remove 'void_fraction'"))
    return found


def gives_entropy(eos) -> bool:
    """Whether the law gives an entropy with these parameters, which it does not without a temperature."""
    return gives(eos, "entropy") and has_temperature(eos)
