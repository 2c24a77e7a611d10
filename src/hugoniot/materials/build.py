"""Material tables (`[material.al.eos] law = "mie_gruneisen" ...`) to a `Material`; `materials.tables` goes the other way.

Nothing here knows any law: names, units and defaults come from the registries, so a new law file is readable at once.
Every problem is collected, none raised.
"""

import importlib
import math
from dataclasses import fields, replace
from typing import Any

import numpy as np

from hugoniot.core.registry import Law, Registry, UnknownName, finite
from hugoniot.errors import DeckError, DeckProblem, HugoniotError
from hugoniot.laws import mixture as _mixtures  # noqa: F401  (enrols the closures)
from hugoniot.laws.eos.contract import EOS, flagged, pressure, reference_state, sound_speed_squared
from hugoniot.laws.fracture.contract import tension_cap
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.reference_state import CHOICES, FROZEN
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.materials import table_law
from hugoniot.materials.collect import Collector, LineOf, nearest, printable
from hugoniot.materials.material import GRAINS_OVER_SERIES, PORES_REOPEN, Material, Source
from hugoniot.materials.tables import accepted, families, law_table

LONGEST_ARRAY = 1_000_000
_FACTS = ("base", "sources", "valid_up_to", "warnings")
_EXPLOSIVE = ("unreacted", "mixture", "detonation_energy", "reference_state")
_TOLD = ("sources", "warnings")                # texts that results and reports repeat
_MAY_LACK = ("strength", "fracture", "burn")   # families a material can do without


def build_material(name: str, tables: dict, problems: list[DeckProblem], file: str, line_of: LineOf) -> Material | None:
    """The material described by the tables of `[material.<name>]`; None after adding to `problems` what is wrong.

    tables    parsed TOML: one table per family (`eos` is needed, `strength`, `fracture`, `burn` may be left out), and optionally
              `base` (a name of the library that the tables override), `sources`, `valid_up_to` (m/s), `warnings`
    file      what messages call the file
    line_of   line of a key path such as ("material", "al", "eos", "rho0"), or None
    """
    collector = Collector(problems, file, line_of)
    return read_material(name, tables, collector, ("material", name))


def read_material(name: str, tables: Any, collector: Collector, path: tuple) -> Material | None:
    """As `build_material`, for a caller that has its `Collector` and the path of the tables."""
    before = len(collector.problems)
    if not isinstance(tables, dict):
        collector.add(path, "a material is a table", f"write [{collector.key(path)}.eos] and under it law = \"...\"")
        return None
    known = families()
    collector.texts(path, {key: value for key, value in tables.items() if key in _TOLD})
    for key in tables:
        if key not in known and key not in _FACTS + _EXPLOSIVE:
            collector.unknown((*path, key), (*known, *_FACTS, *_EXPLOSIVE))
    base = _base(tables, collector, path)
    built = {}
    for family, registry in known.items():
        inherited = getattr(base, family) if base else None
        built[family] = read_law(registry, tables[family], collector, (*path, family), inherited) if family in tables else inherited
    if "eos" not in tables and "base" not in tables:
        hint = f"add [{collector.key(path)}.eos] with law = \"...\" (hugoniot list eos), or base = \"...\""
        collector.add(path, "no equation of state", hint)
    valid, sources, warnings = _facts(tables, collector, path, _without_replaced(base, tables))
    unreacted, mixture, heat, reference = _explosive(tables, collector, path, base)
    if len(collector.problems) > before:
        return None
    _check_sound(built, collector, path)
    if len(collector.problems) > before:
        return None
    if reference == FROZEN and "reference_state" in tables and built.get("burn") is None:
        collector.add((*path, "reference_state"), "what does not burn has no reference state", "leave it out, or add a burn law")
        return None
    _check_memory(built["eos"], built.get("burn") is not None, collector, path)
    if len(collector.problems) > before:
        return None
    if unreacted is not None and flagged(unreacted, "remembers"):
        warnings = tuple(dict.fromkeys((*warnings, PORES_REOPEN)))
    if any(law is not None and flagged(law, "grains") and flagged(law, "truncated") for law in (built["eos"], unreacted)):
        warnings = tuple(dict.fromkeys((*warnings, GRAINS_OVER_SERIES)))
    return Material(name, built["eos"], built["strength"], built["fracture"], built.get("burn"), valid, sources, warnings, unreacted,
                    mixture, heat, reference)


def _check_memory(eos: Any, burns: bool, collector: Collector, path: tuple) -> None:
    """A law keeps its history as the outermost one only, where what would wrap it can stand inside; products of burning have no pores."""
    outer = EOS.of(eos)
    if burns and "remembers" in outer.flags:
        collector.add((*path, "eos"), f"the products of an explosive cannot follow '{outer.name}'",
                      "give the law of its gases here and the porous law under [unreacted]")
    if any(flagged(inner, "remembers") for inner in eos if EOS.knows(inner)):
        collector.add((*path, "eos"), f"'{outer.name}' around a porous law would lose the history of its pores",
                      f"make the porous law the outer one and '{outer.name}' the law of its solid (its base)")


def _explosive(tables: dict, collector: Collector, path: tuple, base: Material | None) -> tuple[Any, str | None, float | None, str | None]:
    """(unreacted equation of state, name of the closure, chemical energy in J/kg, reference state) of an explosive; None if not given."""
    unreacted, mixture, heat, reference = tuple(getattr(base, name) if base else None for name in _EXPLOSIVE)
    if "unreacted" in tables:
        unreacted = read_law(EOS, tables["unreacted"], collector, (*path, "unreacted"), unreacted)
    if "mixture" in tables:
        mixture = _choice("mixture", tables, MIXTURE.names(), collector, path)
    if "detonation_energy" in tables:
        heat = collector.quantity((*path, "detonation_energy"), tables["detonation_energy"], "J/kg")
        if heat is not None and not heat > 0.0:
            collector.add((*path, "detonation_energy"), f"must be greater than 0, got {heat:g} J/kg", "it is the heat of burning")
    if "reference_state" in tables:
        reference = _choice("reference_state", tables, CHOICES, collector, path)
    return unreacted, mixture, heat, reference


def _choice(key: str, tables: dict, known, collector: Collector, path: tuple) -> Any:
    """The text of a key that names one of `known`, after reporting any other."""
    given = tables[key]
    if not isinstance(given, str) or given not in known:
        shown = printable(given) if isinstance(given, str) else "not a text"
        collector.add((*path, key), f"unknown {key.replace('_', ' ')} '{shown}'", nearest(shown, known))
    return given


def read_law(registry: Registry, table: Any, collector: Collector, path: tuple, inherited: Any = None) -> Any:
    """The parameter tuple of the law a table names; None after reporting problems, or for a strength, fracture or burn of "none".

    inherited   parameters that a table without `law`, or with the same law, overrides one by one
    """
    if table == "none" and registry.family in _MAY_LACK:
        return None
    if not isinstance(table, dict):
        hint = f"write [{collector.key(path)}] and under it law = \"...\" (hugoniot list {registry.family})"
        collector.add(path, f"the {registry.family} law is a table", hint)
        return None
    name = table.get("law")
    if name is None and inherited is not None:
        name = registry.of(inherited).name
    if not isinstance(name, str):
        message = "missing" if name is None else "a law is named by a text"
        collector.add((*path, "law"), message, f"known: {', '.join(registry.names())}")
        return None
    try:
        law = registry.get(name)
    except UnknownName:
        collector.add((*path, "law"), f"unknown {registry.family} law '{printable(name)}'", nearest(name, registry.names()))
        return None
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
            collector.add(path, "the parameters are a table")
            return None
        names = list(law.parameters._fields)
        required = [n for n in names if n not in law.parameters._field_defaults]
    before = len(collector.problems)
    values = {} if direct else {k: v for k, v in law.defaults.items() if k in names}
    for key, value in table.items():
        if key in names:
            values[key] = _read_value(registry, law, key, value, collector, (*path, key))
        elif key != "law":
            collector.unknown((*path, key), names)
    for key in required:
        if key not in table:
            unit = law.units.get(key, "1")
            meaning = law.meaning.get(key, "")
            collector.add((*path, key), f"missing: {meaning or 'needed'}" + (f" ({unit})" if unit not in ("1", "text") else ""))
    if len(collector.problems) > before:
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
    if (wanted := _other_kind(getattr(law.example, key, None), value)) is not None:
        given = "a table" if isinstance(value, dict) else "a list" if isinstance(value, list) else printable(str(value), 40)
        collector.add(path, f"expected {wanted}, got {given}", law.meaning.get(key, ""))
        return None
    if isinstance(value, dict):
        return read_law(registry, value, collector, path)
    if unit == "text":
        if not isinstance(value, str):
            collector.add(path, f"expected a text, got {value!r:.40}", law.meaning.get(key, ""))
        return value
    if isinstance(value, list):
        return _read_array(value, unit, collector, path)
    preset = law.defaults.get(key)
    if isinstance(preset, bool):
        if not isinstance(value, bool):
            collector.add(path, "expected true or false")
        return value
    number = collector.quantity(path, value, unit)
    if number is not None:
        _check_bounds(law, key, number, unit, collector, path)
    return number


def _check_bounds(law: Law, key: str, number: float, unit: str, collector: Collector, path: tuple) -> None:
    """Report a number below what its law, or its kind of quantity, allows: a slip of sign that physics would answer much later."""
    shown = f"{number:g}" + (f" {unit}" if unit != "1" else "")
    if key == "specific_heat" and not number > 0.0:
        collector.add(path, f"a specific heat must be positive, got {shown}", "leave it out where it is not known")
    elif key in law.above or (unit == "kg/m^3" and key not in law.least):
        bound = law.above.get(key, 0.0)
        if not number > bound:
            collector.add(path, f"must be greater than {bound:g}, got {shown}", law.meaning.get(key, ""))
    elif key in law.least or unit == "K":
        bound = law.least.get(key, 0.0)
        if not number >= bound:
            collector.add(path, f"must not be less than {bound:g}, got {shown}", law.meaning.get(key, ""))


def _other_kind(example: Any, value: Any) -> str | None:
    """What a parameter is, a law or a number, if it was given as another; None where it may be what it is."""
    if hasattr(example, "_fields"):
        return None if isinstance(value, dict) else "a law, as a table with law = \"...\""
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


def _base(tables: dict, collector: Collector, path: tuple) -> Material | None:
    if "base" not in tables:
        return None
    return from_library(tables["base"], collector, (*path, "base"))


def from_library(name: Any, collector: Collector, path: tuple, others: tuple[str, ...] = ()) -> Material | None:
    """A material of the library by name; `others` are names the hint should offer too."""
    if not isinstance(name, str):
        collector.add(path, "a material is named by a text")
        return None
    library = importlib.import_module("hugoniot.materials.library")  # reads files made of tables, so it imports this module
    try:
        return library.find(name[:200])
    except DeckError as error:
        told = error.problems[0]
        collector.add(path, printable(told.message, 200), nearest(name, others, printable(told.hint, 300)))
        return None


def _without_replaced(base: Material | None, tables: dict) -> Material | None:
    """The base without the sources of numbers that the tables replace."""
    if base is None:
        return None

    def stands(source: Source) -> bool:
        family, _, name = source.quantity.partition(".")
        table = tables.get(family)
        return not (table == "none" or (isinstance(table, dict) and ("law" in table or name in table)))

    return replace(base, sources=tuple(s for s in base.sources if stands(s)))


def _facts(tables: dict, collector: Collector, path: tuple, base: Material | None):
    valid = base.valid_up_to if base else None
    if "valid_up_to" in tables:
        valid = collector.quantity((*path, "valid_up_to"), tables["valid_up_to"], "m/s")
    sources = base.sources if base else ()
    if "sources" in tables:
        rows = tables["sources"] if isinstance(tables["sources"], list) else [tables["sources"]]
        sources = tuple(s for i, row in enumerate(rows) if (s := _source(row, collector, (*path, "sources", i))))
    warnings = base.warnings if base else ()
    if "warnings" in tables:
        warnings = tuple(tables["warnings"]) if isinstance(tables["warnings"], list) else (tables["warnings"],)
        if not all(isinstance(w, str) for w in warnings):
            collector.add((*path, "warnings"), "warnings are texts")
    return valid, sources, warnings


def _source(row: Any, collector: Collector, path: tuple) -> Source | None:
    if isinstance(row, str):
        return Source("", "", "", row)
    names = [f.name for f in fields(Source)]
    if not isinstance(row, dict):
        collector.add(path, "a source is a text or a table", f"keys: {', '.join(names)}")
        return None
    for key in row:
        if key not in names:
            collector.unknown((*path, key), names)
        elif not isinstance(row[key], str) and key != "value":
            collector.add((*path, key), "expected a text")
    known = {"quantity": "", "value": "", "unit": "", "source": ""} | {k: v for k, v in row.items() if k in names}
    return Source(**known)


def _check_sound(built: dict, collector: Collector, path: tuple) -> None:
    """At rest a material must have positive density, a real sound speed, and strengths that are not negative."""
    par = built["eos"]
    try:
        _check_rest(par, built, collector, path)
    except ArithmeticError:
        collector.add((*path, "eos"), "the parameters leave no state at rest", "check their units: one is beyond what numbers hold")


def _check_rest(par: Any, built: dict, collector: Collector, path: tuple) -> None:
    rho, e = reference_state(par)
    if not (math.isfinite(rho) and rho > 0.0):
        collector.add((*path, "eos"), f"the density at rest must be positive, got {rho:g} kg/m^3")
        return
    p, c2 = pressure(rho, e, par), sound_speed_squared(rho, e, par)
    if not (math.isfinite(p) and math.isfinite(c2) and c2 > 0.0):
        message = f"no sound at rest: at {rho:g} kg/m^3 the squared sound speed is {c2:g} m^2/s^2 and the pressure {p:g} Pa"
        collector.add((*path, "eos"), message, "check the signs and units of the parameters")
        return
    if built["strength"] is not None:
        law = STRENGTH.of(built["strength"])
        if "needs_temperature" in law.flags and not has_temperature(par):
            message = f"the strength law {law.name} needs temperatures, which the equation of state does not give"
            collector.add((*path, "strength"), message, "give the equation of state its specific_heat")
            return
        warm = built_temperature(par)
        for what, value in (("shear modulus", shear_modulus(rho, p, warm, rho * c2, built["strength"])),
                            ("flow stress", flow_stress(rho, p, warm, 0.0, 0.0, built["strength"]))):
            if not (math.isfinite(value) and value >= 0.0):
                collector.add((*path, "strength"), f"the {what} at rest must not be negative, got {value:g} Pa")
    if built["fracture"] is not None and not tension_cap(0.0, built["fracture"]) > 0.0:
        collector.add((*path, "fracture"), f"the strength in tension must be positive, got {tension_cap(0.0, built['fracture']):g} Pa")


def has_temperature(par: Any) -> bool:
    """Whether an equation of state gives temperatures (it has the function and the specific heat for it)."""
    return "temperature" in EOS.of(par).functions and math.isfinite(built_temperature(par))


def built_temperature(par: Any) -> float:
    """Temperature of an equation of state at rest, K; 298.15 where it has none."""
    give = EOS.of(par).functions.get("temperature")
    if give is None:
        return 298.15
    rho, e = reference_state(par)
    return float(give(rho, e, par))
