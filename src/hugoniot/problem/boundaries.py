"""Boundary conditions of a deck: `left = "free"`, `{velocity = "10 m/s"}`, a table, or a named pulse."""

from typing import Annotated, Any

from pydantic import Field

from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.problem.model import Boundary, Pulse
from hugoniot.problem.schema import Quantity, Table, Time, validate
from hugoniot.units import UnitError, parse

PLAIN = ("free", "fixed", "transmitting", "periodic")
DRIVEN = {"velocity": "m/s", "pressure": "Pa"}
SHAPES = ("exponential", "half_sine", "square", "ramp")
LONGEST_TABLE = 100_000
_FORMS = "write \"free\", \"fixed\", \"transmitting\", \"periodic\", {velocity = ...} or {pressure = ...}"


class PulseTable(Table):
    """A pulse of a given shape; the value is zero before its start."""

    shape: str = Field(description="exponential, half_sine, square or ramp")
    amplitude: Any = Field(description="largest value: of exponential the value at its start, of ramp the value that it reaches and keeps")
    duration: Annotated[float, Quantity("s", above=0.0)] = Field(
        description="of exponential the time in which it falls to 1/e, of half_sine and square its length, of ramp its rise time")
    start: Time = Field(0.0, description="time at which the pulse starts")


class HistoryTable(Table):
    """Values as a function of time: linear between the times, constant before the first and after the last."""

    times: list[Any] = Field(description="times, increasing")
    values: list[Any] = Field(description="as many values as times")


def pulse_schema() -> dict:
    """JSON Schema of a history: a number, a named pulse or a table."""
    return {"anyOf": [{"type": "number"}, {"type": "string"}, PulseTable.model_json_schema(), HistoryTable.model_json_schema()]}


def boundary_schema() -> dict:
    """JSON Schema of a boundary."""
    driven = [{"type": "object", "properties": {key: pulse_schema() | {"unit": unit}}, "required": [key], "additionalProperties": False}
              for key, unit in DRIVEN.items()]
    return {"anyOf": [{"enum": list(PLAIN)}, *driven], "default": "free"}


def read_boundary(value: Any, collector: Collector, path: tuple) -> Boundary | None:
    """The boundary a deck describes; None after reporting what is wrong."""
    if isinstance(value, str):
        if value in PLAIN:
            return Boundary(value)
        hint = nearest(value, PLAIN, _FORMS)
        collector.add(path, f"unknown boundary '{printable(value)}'", hint)
        return None
    if not isinstance(value, dict):
        collector.add(path, "expected a string or a table", _FORMS)
        return None
    kind = value.get("kind")
    if isinstance(kind, str) and kind in PLAIN and not set(value) & set(DRIVEN):
        collector.add(path, f"'{kind}' must be given as a string, not in a table",
                      f"write [boundary] with {path[-1]} = \"{kind}\"")
        return None
    for key in value:
        if key not in DRIVEN:
            collector.unknown((*path, key), DRIVEN)
    found = [key for key in DRIVEN if key in value]
    if len(found) != 1:
        hint = "write {velocity = \"100 m/s\"} or {pressure = \"1 GPa\"}"
        collector.add(path, "a driven boundary needs exactly one of velocity and pressure", hint)
        return None
    pulse = read_pulse(value[found[0]], DRIVEN[found[0]], collector, (*path, found[0]))
    return None if pulse is None else Boundary(found[0], pulse)


def read_pulse(value: Any, unit: str, collector: Collector, path: tuple) -> Pulse | None:
    """The history of a driven boundary, from a number, a named pulse or a table; None after reporting what is wrong."""
    if not isinstance(value, dict):
        amplitude = _value(value, unit, collector, path)
        return None if amplitude is None else Pulse("constant", amplitude)
    if "shape" in value or not ("times" in value or "values" in value):
        table = validate(PulseTable, value, collector, path)
        if table is None:
            return None
        if table.shape not in SHAPES:
            collector.add((*path, "shape"), f"unknown pulse shape '{printable(table.shape)}'", nearest(table.shape, SHAPES))
            return None
        amplitude = _value(table.amplitude, unit, collector, (*path, "amplitude"))
        return None if amplitude is None else Pulse(table.shape, amplitude, table.start, table.duration)
    table = validate(HistoryTable, value, collector, path)
    return None if table is None else _history(table, unit, collector, path)


def _history(table: HistoryTable, unit: str, collector: Collector, path: tuple) -> Pulse | None:
    if len(table.times) != len(table.values) or not 2 <= len(table.times) <= LONGEST_TABLE:
        message = f"a table needs as many times as values, 2 to {LONGEST_TABLE} of each"
        collector.add(path, message, f"got times: {len(table.times)}, values: {len(table.values)}")
        return None
    times = [collector.quantity((*path, "times", i), t, "s") for i, t in enumerate(table.times)]
    values = [_value(v, unit, collector, (*path, "values", i)) for i, v in enumerate(table.values)]
    if None in times or None in values:
        return None
    for i, (before, after) in enumerate(zip(times, times[1:])):
        if not after > before:  # type: ignore[operator]
            collector.add((*path, "times", i + 1), f"times must increase, but {after:g} s follows {before:g} s")
            return None
    return Pulse("table", times=tuple(times), values=tuple(values))  # type: ignore[arg-type]


def _value(value: Any, unit: str, collector: Collector, path: tuple) -> float | None:
    limit = 299792458.0 if unit == "m/s" else 1e30
    try:
        number = parse(value, unit)
    except UnitError as error:
        collector.add(path, error.message, error.hint)
        return None
    if abs(number) > limit:
        collector.add(path, f"unreasonably large: {number:g} {unit}", f"the limit is {limit:g} {unit}")
        return None
    return number


def boundary_value(boundary: Boundary) -> Any:
    """What a resolved deck writes for a boundary."""
    return boundary.kind if boundary.pulse is None else {boundary.kind: pulse_value(boundary.pulse)}


def pulse_value(pulse: Pulse) -> Any:
    """What a resolved deck writes for a history."""
    if pulse.shape == "constant":
        return pulse.amplitude
    if pulse.shape == "table":
        return {"times": list(pulse.times), "values": list(pulse.values)}
    return {"shape": pulse.shape, "amplitude": pulse.amplitude, "start": pulse.start, "duration": pulse.duration}
