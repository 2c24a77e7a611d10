"""An initial state that varies along a region, [region.profile]: expressions in the position x, arrays, or a file of columns.

    [region.profile]
    velocity = "10 m/s * sin(2 * pi * x / 5 mm)"
    pressure = "1 GPa + 0.1 GPa * cos(2 * pi * x / 5 mm)"

or `positions` with an array for each field, or `file = "start.csv"` beside the deck, whose first line reads like
`position [mm], velocity [m/s], density [g/cm^3]`; between its lines values are linear. Velocities are taken at the nodes, the state (any
two of density, pressure, temperature and energy) in the middle of every zone.
"""

import math
from typing import Annotated, Any

import numpy as np
from pydantic import Field, WithJsonSchema

from hugoniot.errors import DeckError
from hugoniot.files import csv_rows, read_regular
from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.problem.arithmetic import EXAMPLE, FUNCTIONS, Expression, Number, Trouble
from hugoniot.problem.model import Profile, Region
from hugoniot.problem.schema import Table
from hugoniot.units import UnitError, parse, parse_all, powers_of

UNITS = {"velocity": "m/s", "density": "kg/m^3", "pressure": "Pa", "temperature": "K", "energy": "J/kg"}
LONGEST = 150_000        # values of a field of a table, lines of a file
LARGEST = 50_000_000     # bytes of a file
MOST = 700_000           # values of all profiles of a deck: that of a run holds them all, and must be one that can be read again
MUCH_LONGER = 2.0        # than its region: a profile whose unit is doubted
LIGHT = 299_792_458.0    # m/s
_EXAMPLE = 'write it like "10 m/s * sin(2 * pi * x / 5 mm)", with + - * / ** and ' + ", ".join(FUNCTIONS)
_ENTRY = WithJsonSchema({"anyOf": [{"type": "number"}, {"type": "string"}, {"type": "array", "items": {"type": ["number", "string"]}}]})


class ProfileTable(Table):
    """An initial state that varies along a region, in one of three forms: expressions, arrays, or a file.

    A quantity given here must not be given in the region too. A profile of anything but velocity is not possible in an explosive that
    burns.
    """

    file: str | None = Field(
        None, max_length=1000, description="CSV file in the deck's folder, up to 150 000 lines, with a first line such as \"position "
        "[mm], velocity [m/s]\"; excludes all other keys")
    positions: list[Any] | None = Field(None, max_length=LONGEST, description="positions of the values in the arrays, increasing; they "
        "must cover the region")
    velocity: Annotated[Any, _ENTRY] = Field(None, description="without positions an expression in the position x, such as \"10 m/s * "
        "sin(2 * pi * x / 5 mm)\"; with positions an array, linear in between")
    density: Annotated[Any, _ENTRY] = Field(None, description="density, in the same forms")
    pressure: Annotated[Any, _ENTRY] = Field(None, description="pressure, in the same forms")
    temperature: Annotated[Any, _ENTRY] = Field(None, description="temperature, in the same forms")
    energy: Annotated[Any, _ENTRY] = Field(None, description="specific internal energy, in the same forms")


def values_at(profile: Profile, field: str, places: np.ndarray) -> np.ndarray:
    """SI values of one field at positions (m). Raises `Trouble` for an expression without a value there."""
    given = dict(profile.fields)[field]
    if not isinstance(given, str):
        return np.interp(places, profile.positions, given)
    expression, wanted = Expression(given), powers_of(f"1 {UNITS[field]}")[1]
    found = np.empty(len(places))
    for k, x in enumerate(places):
        number = expression.value(lambda name, x=float(x): _named(name, x))
        if number.powers is not None and tuple(number.powers) != tuple(wanted):
            raise Trouble(f"the profile of {field} has the unit {number.unit()}", f"expected {UNITS[field]}")
        found[k] = number.value
    return found


def velocities_at(region: Region, places: np.ndarray) -> np.ndarray:
    """Velocities of a region at t = 0 at positions (m), m/s: constant, linear between its ends, or from its profile."""
    if region.profile is not None and "velocity" in dict(region.profile.fields):
        return values_at(region.profile, "velocity", places)
    start, end = region.velocity if isinstance(region.velocity, tuple) else (region.velocity, region.velocity)
    return start + (end - start) * ((places - region.start) / (region.end - region.start))


def end_velocities(region: Region) -> tuple[float, float]:
    """The same at the left and right end of a region."""
    left, right = velocities_at(region, np.array((region.start, region.end))).tolist()
    return left, right


def _named(name: str, x: float) -> Number:
    if name == "x":
        return Number(x, (1, 0, 0, 0, 0))
    if name == "pi":
        return Number(math.pi)
    raise Trouble(f"unknown name '{printable(name, 40)}'", "a profile may contain x (the position) and pi")


def read_profile(table: ProfileTable | None, nodes: np.ndarray, collector: Collector, path: tuple) -> Profile | None:
    """The profile of a region with nodes (m), after reporting what is wrong with it; None where nothing is left of it."""
    if table is None:
        return None
    given = {name: value for name in UNITS if (value := getattr(table, name)) is not None}
    before = collector.findings
    if table.file is not None:
        if given or table.positions is not None:
            collector.add((*path, "file"), "cannot be combined with other keys", "give the file, or positions and arrays, or expressions")
        profile = _of_file(table.file, collector, (*path, "file")) if collector.findings == before else None
    elif not given:
        collector.add(path, "is empty", "give velocity, density, pressure, temperature or energy")
        return None
    elif table.positions is not None:
        places = _numbers(table.positions, "m", collector, (*path, "positions"))
        fields = tuple((name, tuple(_numbers(value, UNITS[name], collector, (*path, name)))) for name, value in given.items())
        profile = Profile(tuple(places), fields)
    else:
        profile = Profile((), tuple((name, _expression(value, collector, (*path, name))) for name, value in given.items()))
    if profile is None or collector.findings > before:
        return None
    if table.file is not None or table.positions is not None:
        _check_table(profile, float(nodes[0]), float(nodes[-1]), collector, path)
    if collector.findings == before and (wrong := _first_trouble(profile, nodes)) is not None:
        collector.add((*path, wrong[0] if table.file is None else "file"), wrong[1].message, wrong[1].hint)
    return profile if collector.findings == before else None


def _expression(value: Any, collector: Collector, path: tuple) -> str:
    text = str(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else value
    try:
        if not isinstance(text, str):
            raise Trouble("expected an expression in x", 'for example "10 m/s * sin(2 * pi * x / 5 mm)"; arrays need positions')
        Expression(text)
    except Trouble as error:
        collector.add(path, error.message, _EXAMPLE if error.hint == EXAMPLE else error.hint)
        return ""
    return text


def _first_trouble(profile: Profile, nodes: np.ndarray) -> tuple[str, Trouble] | None:
    """The first field that has no value, or no possible one, at a place where a run asks for it."""
    for name, _ in profile.fields:
        try:
            values = values_at(profile, name, nodes if name == "velocity" else 0.5 * (nodes[:-1] + nodes[1:]))
        except Trouble as error:
            return name, Trouble(error.message, _EXAMPLE if error.hint == EXAMPLE else error.hint)
        if name == "velocity" and (fastest := float(np.max(np.abs(values)))) > LIGHT:
            return name, Trouble(f"unreasonably large: {fastest:g} m/s is faster than light")
    return None


def _numbers(values: Any, unit: str, collector: Collector, path: tuple) -> list[float]:
    if not isinstance(values, list):
        collector.add(path, "expected an array", "give positions together with arrays of values at them")
        return []
    try:
        return [parse(value, unit) for value in values]
    except UnitError as error:
        collector.add(path, error.message, error.hint)
        return []


def _check_table(profile: Profile, start: float, end: float, collector: Collector, path: tuple) -> None:
    places = profile.positions
    for name, values in profile.fields:
        if len(values) != len(places):
            collector.add((*path, name), f"values: {len(values)}, positions: {len(places)}", "each position needs one")
    if len(places) < 2 or any(not b > a for a, b in zip(places, places[1:])):
        collector.add((*path, "positions"), "at least two positions are needed, and they must increase")
    elif places[-1] - places[0] > MUCH_LONGER * (end - start) and places[0] <= start and places[-1] >= end:
        collector.warnings.append(f"{collector.key(path)}: the profile reaches from {places[0]:g} to {places[-1]:g} m, "
                                  f"{(places[-1] - places[0]) / (end - start):.3g} times the length of the region; "
                                  f"only its part from {start:g} to {end:g} m is used: are its positions in the right unit?")
    elif places[0] > start + 1e-9 * (end - start) or places[-1] < end - 1e-9 * (end - start):
        collector.add((*path, "positions"), f"reach from {places[0]:g} to {places[-1]:g} m, but the region reaches from {start:g} to "
                                            f"{end:g} m",
                      "a profile must cover its region")


def _of_file(name: str, collector: Collector, path: tuple) -> Profile | None:
    """The columns of a file beside the deck."""
    try:
        text = read_regular(collector.folder / name, LARGEST).decode("utf-8-sig", errors="replace")
        rows = [row for _, row in csv_rows(text, name, most=LONGEST) if any(map(str.strip, row))]
    except DeckError as error:
        collector.add(path, f"'{printable(name)}', line {error.problems[0].line}: {error.problems[0].message}", error.problems[0].hint)
        return None
    except OSError as error:
        collector.add(path, f"cannot read '{printable(name)}': {printable(error.strerror or error, 120)}")
        return None
    if len(rows) < 3:
        collector.add(path, "needs a line of column headers and two lines of values or more", "for example position [mm], velocity [m/s]")
        return None
    columns: dict[str, tuple[float, ...]] = {}
    for k, head in enumerate(rows[0]):
        field, _, unit = (part.strip() for part in head.strip().rstrip("])").replace("(", "[").partition("["))
        if field not in ("position", *UNITS):
            collector.add(path, f"unknown column '{printable(field)}'", nearest(field, ("position", *UNITS)))
            return None
        if field in columns:
            collector.add(path, f"column '{field}' appears twice")
            return None
        try:
            columns[field] = tuple(parse_all((float(row[k]) for row in rows[1:]), unit, UNITS.get(field, "m")))
        except UnitError as error:
            collector.add(path, f"column '{field}': {error.message}", error.hint)
            return None
        except (ValueError, IndexError):
            collector.add(path, f"column '{field}' contains a value that is not a number")
            return None
    places = columns.pop("position", None)
    if places is None or not columns:
        collector.add(path, "needs a column 'position' and at least one other", "for example position [mm], velocity [m/s]")
        return None
    return Profile(places, tuple((name, columns[name]) for name in UNITS if name in columns))      # the order of arrays in a deck


def size_of(profile: Profile | None) -> int:
    """Numbers that a deck has to hold for it."""
    return 0 if profile is None else len(profile.positions) * (1 + len(profile.fields))


def profile_value(profile: Profile) -> dict[str, Any]:
    """What a resolved deck writes."""
    places = {"positions": list(profile.positions)} if profile.positions else {}
    return places | {name: value if isinstance(value, str) else list(value) for name, value in profile.fields}
