"""Unit and long name of every column a run folder can hold: the fields of core.fields and what is derived from them."""

from hugoniot.core.fields import FIELDS

_FACES = {
    "position_left": ("m", "position of the zone's left face"),
    "position_right": ("m", "position of the zone's right face"),
    "velocity_left": ("m/s", "velocity of the zone's left face"),
    "velocity_right": ("m/s", "velocity of the zone's right face"),
    "tension": ("Pa", "longitudinal tension"),
    "time": ("s", "time"),
    "centre": ("m", "centre of the zone at t = 0 (Lagrangian coordinate)"),
    "centre_x": ("m", "x (or r) of the zone's centre at t = 0"),
    "centre_y": ("m", "y (or z) of the zone's centre at t = 0"),
    "forming": ("", "whether a captured shock may still be forming in the zone"),
    "line_position": ("m", "position of the surface along the line of sight"),
    "line_velocity": ("m/s", "velocity along the line of sight"),
    "normal_velocity": ("m/s", "velocity along the outward normal"),
    "apparent_velocity": ("m/s", "apparent velocity through the window"),
    "mass": ("kg", FIELDS["mass"].long_name),
    "particle_velocity": ("m/s", "particle velocity"),
    "speed": ("m/s", "speed of the material"),
    "strain_rate": ("1/s", "strain rate"),
    "time_step": ("s", "time step"),
    "step": ("s", "time step"),
}
_PER_MASS = {
    "plastic_work": ("J/kg", "plastic work done per unit mass"),
    "viscous_work": ("J/kg", "work of the artificial viscosity per unit mass"),
}
PER_AREA = {"planar": "/m^2", "cylindrical": "/m/rad", "spherical": "/sr", "plane": "/m", "axisymmetric": "/rad"}


def describe(name: str, geometry: str = "", given: dict | None = None) -> tuple[str, str]:
    """(SI unit, long name) of a column of zones or gauges, or, with a geometry, of a budget.

    `given` maps names to units or to (unit, long name) and wins; budgets are per unit area (planar), per metre and radian
    (cylindrical) or per steradian (spherical), as the solver counts mass.
    """
    words = name.replace("_", " ")
    if given and name in given:
        entry = given[name]
        return (entry, words) if isinstance(entry, str) else (entry[0], entry[1])
    if not geometry and name in _PER_MASS:
        return _PER_MASS[name]
    if name in _FACES:
        return _FACES[name]
    if name in FIELDS and not (geometry and FIELDS[name].unit in ("J/kg", "kg m/s")):     # of zones; budgets hold whole regions
        return FIELDS[name].unit, FIELDS[name].long_name
    if name.startswith("time_of_"):
        return "s", words
    for prefix in ("peak_", "least_", "largest_", "smallest_", "max_", "min_", "maximum_", "minimum_"):
        if name.startswith(prefix):
            unit, inner = describe(name.removeprefix(prefix), geometry, given)
            return unit, f"{prefix[:-1]} {inner}"
    return _budget_unit(name, PER_AREA.get(geometry, "")), words


def _budget_unit(name: str, per: str) -> str:
    if name.endswith(("error", "fraction", "count")) or name in ("cycle", "segments"):
        return "1"
    for words, unit in ((("momentum", "impulse"), "kg m/s"), (("energy", "work", "heat", "dissipat"), "J"), (("mass",), "kg"),
                        (("pressure", "stress"), "Pa"), (("velocity",), "m/s"), (("time",), "s"), (("moved",), "m")):
        if any(word in name for word in words):
            return unit + (per if unit in ("kg m/s", "J", "kg") else "")
    return ""
