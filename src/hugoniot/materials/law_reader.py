"""Tables of laws (`[material.al.eos] law = "mie_gruneisen" ...`) to their parameter tuples; `materials.tables` goes the other way.

Nothing here knows any law: names, units and defaults come from the registries, so a new law file is readable at once.
Every problem is collected, none raised.
"""

import math
from functools import partial
from typing import Any

import numpy as np

from hugoniot.core.registry import Law, Registry, finite
from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import table_law
from hugoniot.materials.collect import Collector, explained, nearest, printable, shown_value
from hugoniot.materials.tables import accepted, law_table

LONGEST_ARRAY = 1_000_000
_MAY_LACK = ("strength", "fracture", "burn")   # families a material can do without


def read_law(registry: Registry, table: Any, collector: Collector, path: tuple, inherited: Any = None) -> Any:
    """The parameter tuple of the law a table names; None after reporting problems, or for a strength, fracture or burn of "none".

    inherited   parameters that a table without `law`, or with the same law, overrides one by one
    """
    if table == "none" and registry.family in _MAY_LACK:
        return None
    if not isinstance(table, dict):
        hint = f"write [{collector.key(path)}] and under it law = \"...\" (hugoniot list {registry.family})"
        collector.add(path, f"the {registry.family} law must be a table", hint)
        return None
    name = table.get("law")
    if name is None and inherited is not None:
        name = registry.of(inherited).name
    if not isinstance(name, str):
        message = "missing" if name is None else "expected the name of a law in quotes"
        collector.add((*path, "law"), message, f"known: {', '.join(registry.names())}")
        return None
    if name not in registry.names():
        collector.add((*path, "law"), f"unknown {registry.family} law '{printable(name)}'", partial(nearest, name, registry.names()))
        return None
    law = registry.get(name)
    if registry is EOS and name == table_law.LAW and "file" in table:
        return table_law.read_table_law(table, collector, path)
    start = dict(law_table(registry, inherited)) if inherited is not None and registry.of(inherited) is law else {}
    return _read_parameters(registry, law, start | table, collector, path)


def _read_parameters(registry: Registry, law: Law, table: dict, collector: Collector, path: tuple) -> Any:
    names, required = accepted(law)
    direct = "parameters" in table and "parameters" not in names
    if direct:  # the law's own fields, as a saved problem writes them when `build` derives them from other numbers
        table, path = table["parameters"], (*path, "parameters")
        if not isinstance(table, dict):
            collector.add(path, "expected a table of parameters")
            return None
        names = list(law.parameters._fields)
        required = [n for n in names if n not in law.parameters._field_defaults]
    before = collector.findings
    values = {} if direct else {k: v for k, v in law.defaults.items() if k in names}
    for key, value in table.items():
        if key in names:
            values[key] = _read_value(registry, law, key, value, collector, (*path, key))
        elif key != "law":
            collector.unknown((*path, key), names)
    for key in required:
        if key not in table:
            unit = law.units.get(key, "1")
            shown = "" if unit in ("1", "text", "law") else f"; unit: {unit}"
            meaning = law.meaning.get(key)
            collector.add((*path, key), "missing" + (f" ({meaning}{shown})" if meaning else ""),
                          'write a table with law = "..."' if unit == "law" else "")
    lost = any(value is None and EOS.knows(getattr(law.example, key, None)) for key, value in values.items())
    if lost or collector.findings > before:
        return None
    try:
        par = law.parameters(**_as_arrays(law, values)) if direct else law.build(**values)
    except (HugoniotError, ValueError, ArithmeticError, TypeError) as error:
        collector.add(path, printable(str(error), 300))
        return None
    optional = {k for k, v in law.defaults.items() if isinstance(v, float) and math.isnan(v)}
    if not optional and not finite(par):
        collector.add(path, "the parameters are not all finite numbers")
        return None
    return par


def _as_arrays(law: Law, values: dict) -> dict:
    """Values of fields that are arrays in the law's example, as arrays."""
    return {k: np.array(v, dtype=float) if isinstance(getattr(law.example, k), np.ndarray) else v for k, v in values.items()}


def _read_value(registry: Registry, law: Law, key: str, value: Any, collector: Collector, path: tuple) -> Any:
    unit = law.units.get(key, "1")
    if isinstance(value, str) and EOS.knows(getattr(law.example, key, None)) and collector.reported(path):
        return None     # the name of a material, which was looked up in vain
    if (wanted := _other_kind(getattr(law.example, key, None), value)) is not None:
        collector.add(path, f"expected {wanted}, got {shown_value(value)}{explained(key, law.meaning.get(key, ''))}")
        return None
    if isinstance(value, dict):
        return read_law(registry, value, collector, path)
    if unit == "text":
        if not isinstance(value, str):
            collector.add(path, f"expected a string, got {shown_value(value)}{explained(key, law.meaning.get(key, ''))}")
        return value
    if isinstance(value, list):
        return _read_array(value, unit, collector, path)
    preset = law.defaults.get(key)
    if isinstance(preset, bool):
        if not isinstance(value, bool):
            collector.add(path, f"expected true or false, got {shown_value(value)}")
        return value
    number = collector.quantity(path, value, unit)
    if number is not None:
        _check_bounds(law, key, number, unit, collector, path)
    return number


def _check_bounds(law: Law, key: str, number: float, unit: str, collector: Collector, path: tuple) -> None:
    """Report a number below what its law, or its kind of quantity, allows: a slip of sign that physics would answer much later."""
    shown = f"{number:g}" + (f" {unit}" if unit != "1" else "")
    if key == "specific_heat" and not number > 0.0:
        collector.add(path, f"a specific heat must be positive, got {shown}", "omit it where it is not known")
    elif key in law.above or (unit == "kg/m^3" and key not in law.least):
        bound = law.above.get(key, 0.0)
        if not number > bound:
            collector.add(path, f"must be greater than {bound:g}, got {shown}{explained(key, law.meaning.get(key, ''))}")
    elif key in law.least or unit == "K":
        bound = law.least.get(key, 0.0)
        if not number >= bound:
            collector.add(path, f"must not be less than {bound:g}, got {shown}{explained(key, law.meaning.get(key, ''))}")


def _other_kind(example: Any, value: Any) -> str | None:
    """What a parameter is, a law or a number, if it was given as another; None where it may be what it is."""
    if hasattr(example, "_fields"):
        return None if isinstance(value, dict) else "a law, as a table with law = \"...\" or the name of a material of the library"
    return "a number" if isinstance(example, float) and isinstance(value, (dict, list)) else None


def _read_array(value: list, unit: str, collector: Collector, path: tuple, deepest: int = 2) -> tuple:
    """Rows of quantities; problems of the first few elements are told, not of a million."""
    if len(value) > LONGEST_ARRAY:
        collector.add(path, f"{len(value)} values are too many", f"the limit is {LONGEST_ARRAY}")
        return ()
    found = []
    for i, element in enumerate(value):
        if isinstance(element, list) and deepest > 1:
            found.append(_read_array(element, unit, collector, (*path, i), deepest - 1))
        else:
            found.append(collector.quantity((*path, i), element, unit))
        if found[-1] is None:
            break
    return tuple(found)
