"""Fields of `[output] fields`: which solver has which, so that none is asked for in vain."""


from hugoniot.core.fields import FIELDS
from hugoniot.laws.eos.contract import gives
from hugoniot.materials.collect import nearest, printable
from hugoniot.problem.model import Problem

OF_THE_PLANE = ("position_x", "position_y", "velocity_x", "velocity_y", "deviator_xx", "deviator_yy", "deviator_xy", "deviator_zz",
                "principal_angle", "contact_pressure", "gap", "sliding_distance", "eroded")
OF_THE_LINE = ("position", "velocity", "deviator_radial", "deviator_hoop", "entropy", "kinetic_energy", "momentum",
               "elastic_deviator_energy", "elastic_volume_energy", "mass")


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


def defects(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of fields that no material of the problem has."""
    if "entropy" not in problem.output.fields:
        return []
    used = [problem.materials[region.material] for region in problem.regions]
    if any(material.burn is None and gives(material.eos, "entropy") for material in used):
        return []
    return [(("output", "fields"), "no material of this problem has an entropy", "its equations of state give none; leave the field out")]
