"""How far the data behind a material reach, in words: what `check`, `material show` and a run's report say of it.

A row without a range is not valid everywhere: where it ends is not known, and these words say so.
"""

import re
from functools import cache

from hugoniot.laws.eos.contract import flagged
from hugoniot.materials import schema
from hugoniot.materials.build import THERMAL
from hugoniot.materials.material import Material
from hugoniot.materials.record import material_record
from hugoniot.materials.schema import Row
from hugoniot.materials.search import substance
from hugoniot.materials.validity import range_of as range_of_validity
from hugoniot.materials.validity import rounded
from hugoniot.units import format_si

SAME_DENSITY = 0.02   # relative difference above which a row is of another material
ALIKE = 0.1           # relative difference of sound speeds from which rows disagree
FAR_BRANCH = 1000.0  # m/s: a row whose data begin above this particle velocity describes the far side of a transition, or melt
_ROW = re.compile(r"\brow (U\d{3})\b")


def reach(material: Material) -> str:
    """The range of a material's equation of state in words: its end and where that comes from, or that none is known."""
    if flagged(material.eos, "gas"):
        return "a range of particle velocity does not apply to gases and detonation products"
    if material.valid_up_to is None:
        end = range_of_validity(material)
        return f"not stated; a run warns only above a particle velocity of {rounded(end.up)}, {end.why}"
    found = f"particle velocity up to {format_si(material.valid_up_to, 'm/s')}"
    source = _range_source(material)
    if source is None:
        return found
    basis = about(row) if (row := _range_row(source)) else ""
    if basis and (own := _replaced(material)):
        basis += f"; this material replaces {', '.join(own)}, so the statement is about another curve"
    if begin := data_begin(material):
        found = f"particle velocity {format_si(begin, 'm/s')} to {format_si(material.valid_up_to, 'm/s')}"
    if not basis and source.status == "derived":
        basis = f"derived, {source.note}" if source.note else "derived"
    return f"{found} ({basis})" if basis else found


def _replaced(material: Material) -> list[str]:
    """Names of the constants of the Hugoniot that are not those of the source of the range."""
    own = [row["quantity"] for row in material_record(material) if row["status"] == "user"]
    return [name.removeprefix("eos.") for name in own if name.startswith("eos.") and name.removeprefix("eos.") not in THERMAL]


def data_begin(material: Material) -> float:
    """Particle velocity (m/s) at which the data behind a material's Hugoniot begin, where they lie beyond a transition or melt; else 0."""
    source = _range_source(material)
    row = _range_row(source) if source else None
    return far_begin(row) if row else 0.0


def far_begin(row: Row) -> float:
    """Particle velocity (m/s) at which the data of a row begin, if on the far side of a transition or melt; else 0.

    They do if they begin above `FAR_BRANCH`, or with a shock slower than the sound speed at zero pressure that another row of the same
    substance has: the elastic or acoustic front outruns such a shock, so that it starts from a compressed state.
    """
    begin = row.get("up_min", 0.0)
    if not begin or begin >= FAR_BRANCH or "c0" not in row or "rho0" not in row:
        return begin if begin >= FAR_BRANCH else 0.0
    slowest = row["c0"] + row.get("s", 0.0) * begin        # the higher terms of a fit are small where its data begin
    return begin if any(slowest < other["c0"] for other in _others(row)) else 0.0


def extrapolated_sound(material: Material) -> tuple[float, float, float] | None:
    """(particle velocity at which the data begin, lowest and highest sound speed of other rows of the substance, m/s) where one of them
    differs from that of the material's row by more than `ALIKE`, so that its intercept is no measured sound speed; None elsewhere."""
    source = _range_source(material)
    row = _range_row(source) if source else None
    if row is None or far_begin(row) or not row.get("up_min") or "c0" not in row or "rho0" not in row:
        return None
    others = [other["c0"] for other in _others(row) if not far_begin(other)]
    return (row["up_min"], min(others), max(others)) if any(abs(c / row["c0"] - 1.0) > ALIKE for c in others) else None


def _others(row: Row) -> list[Row]:
    """The other Us-up rows of a substance at the same density, whose data begin below `FAR_BRANCH`."""
    others = _by_substance().get(substance(row.material), ())
    return [other for other in others if other.id != row.id and abs(other["rho0"] / row["rho0"] - 1.0) < SAME_DENSITY
            and other.get("up_min", FAR_BRANCH) < FAR_BRANCH]


@cache
def _by_substance() -> dict[str, list[Row]]:
    found: dict[str, list[Row]] = {}
    for row in schema.table("us_up").values():
        if "c0" in row and "rho0" in row:
            found.setdefault(substance(row.material), []).append(row)
    return found


def _range_source(material: Material):
    return next((s for s in material.sources if s.quantity == "valid_up_to" and s.value == material.valid_up_to), None)


def _range_row(source) -> Row | None:
    named = _ROW.search(source.note)
    return schema.row(named.group(1)) if named else None


def about(row: Row) -> str:
    """Where the range of a Us-up row comes from: measured states and how they scatter about its curve, or its source's statement."""
    if "states" in row:
        begin, end, deviation = (format_si(row[name], "m/s", d) for name, d in (("up_min", 6), ("up_max", 6), ("us_deviation", 3)))
        return (f"range of the {row['states']:g} measured states with which the library compares row {row.id}: particle velocities from "
                f"{begin} to {end}; their shock velocities deviate from the curve of the row by {deviation}, root mean square")
    found = f"the range of the fit of row {row.id}" if row.status == "derived" else f"as stated by the source of row {row.id}"
    if "up_max" not in row or row.range_from():
        found = f"row {row.id}" + (f": {row.range_from()}" if row.range_from() else "")
    if "us_deviation" in row:
        found += f", with a deviation of the shock velocities of {format_si(row['us_deviation'], 'm/s', 3)}"
    return found


def range_of(row: Row) -> str:
    """The range of a Us-up row by itself, in words."""
    ends = [format_si(row[name], "m/s") if name in row else "" for name in ("up_min", "up_max")]
    if not ends[1]:
        return "not known" + (f" (data from {ends[0]})" if row.get("up_min") else "")
    return (f"{ends[0]} to {ends[1]}" if row.get("up_min") else f"up to {ends[1]}") + f" ({about(row)})"
