"""Material tables (`[material.al.eos] law = "mie_gruneisen" ...`), and the material they override, to a `Material`.

The tables of the laws are read by `materials.law_reader`; `materials.read` looks up the `base` that a deck or a file names.
Every problem is collected, none raised.
"""

import math
from dataclasses import fields, replace
from functools import partial
from typing import Any

from hugoniot.laws import mixture as _mixtures  # noqa: F401  (enrols the closures)
from hugoniot.laws.eos.contract import (
    EOS,
    flagged,
    has_temperature,
    pressure,
    reference_state,
    sound_speed_squared,
    temperature_at_rest,
)
from hugoniot.laws.fracture.contract import asked_at_nodes, tension_cap
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.reference_state import CHOICES, FROZEN
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.material import GRAINS_OVER_SERIES, NOT_AT_REST, PORES_REOPEN, Material, Source
from hugoniot.materials.tables import families

_FACTS = ("base", "library", "sources", "valid_up_to", "warnings")
_EXPLOSIVE = ("unreacted", "mixture", "detonation_energy", "reference_state")
_TOLD = ("sources", "warnings")                # texts that results and reports repeat
THERMAL = {"specific_heat", "reference_temperature"}     # constants that move no Hugoniot and no CJ state
AT_REST = 1e-4                                 # of its bulk modulus, up to which an unreacted explosive counts as at rest


def assembled(name: str, tables: Any, base: Material | None, collector: Collector, path: tuple) -> Material | None:
    """The material of the tables at `path`, which override those of `base`; None after telling the collector what is wrong.

    tables   as of `materials.read.build_material`; their key `base`, if there is one, was looked up by the caller
    """
    before = collector.findings
    if not isinstance(tables, dict):
        collector.add(path, "a material must be a table", f"write [{collector.key(path)}.eos] and under it law = \"...\"")
        return None
    known = families()
    collector.texts(path, {key: value for key, value in tables.items() if key in _TOLD})
    for key in tables:
        if key not in known and key not in _FACTS + _EXPLOSIVE:
            collector.unknown((*path, key), (*known, *_FACTS, *_EXPLOSIVE))
    built = {}
    for family, registry in known.items():
        inherited = getattr(base, family) if base else None
        built[family] = read_law(registry, tables[family], collector, (*path, family), inherited) if family in tables else inherited
    if "eos" not in tables and "base" not in tables:
        hint = f"add [{collector.key(path)}.eos] with law = \"...\" (hugoniot list eos), or base = \"...\""
        collector.add(path, "no equation of state", hint)
    valid, sources, warnings = _facts(tables, collector, path, _without_replaced(base, tables))
    unreacted, mixture, heat, reference = _explosive(tables, collector, path, base)
    if collector.findings > before or built["eos"] is None or (base is None and "base" in tables):
        return None     # the caller reported a name that it looked up in vain
    _check_sound(built, collector, path)
    if collector.findings > before:
        return None
    if reference == FROZEN and "reference_state" in tables and built.get("burn") is None:
        collector.add((*path, "reference_state"), "applies only to a material that burns", "omit it, or add a burn law")
        return None
    _check_memory(built["eos"], built.get("burn") is not None, collector, path)
    if collector.findings > before:
        return None
    warnings = tuple(dict.fromkeys((*warnings, *collector.warnings)))
    collector.warnings.clear()
    if unreacted is not None:
        warnings = tuple(dict.fromkeys((*warnings, *doubts(unreacted))))
    if any(law is not None and flagged(law, "grains") and flagged(law, "truncated") for law in (built["eos"], unreacted)):
        warnings = tuple(dict.fromkeys((*warnings, GRAINS_OVER_SERIES)))
    return Material(name, built["eos"], built["strength"], built["fracture"], built.get("burn"), valid, sources, warnings, unreacted,
                    mixture, heat, reference, tables.get("library") or (base.library if base else ""))


def doubts(unreacted: Any) -> list[str]:
    """Warnings about the law of an unreacted explosive: pores that reopen, and a condensed one under pressure in its reference state."""
    law, found = EOS.of(unreacted), [PORES_REOPEN] if flagged(unreacted, "remembers") else []
    rho, e = reference_state(unreacted)
    p = float(pressure(rho, e, unreacted))
    condensed = "gas" not in law.flags or "reacted" in law.flags
    if condensed and abs(p) > AT_REST * rho * sound_speed_squared(rho, e, unreacted):
        found.append(NOT_AT_REST.format(p / 1e6))
    return found


def _check_memory(eos: Any, burns: bool, collector: Collector, path: tuple) -> None:
    """A law keeps its history as the outermost one only, where what would wrap it can stand inside; products of burning have no pores."""
    outer = EOS.of(eos)
    if burns and "remembers" in outer.flags:
        collector.add((*path, "eos"), f"the products of an explosive cannot have the law '{outer.name}'",
                      "give the law of the products here and the porous law under [unreacted]")
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
            collector.add((*path, "detonation_energy"), f"must be greater than 0, got {heat:g} J/kg", "it is the chemical energy released")
    if "reference_state" in tables:
        reference = _choice("reference_state", tables, CHOICES, collector, path)
    return unreacted, mixture, heat, reference


def _choice(key: str, tables: dict, known, collector: Collector, path: tuple) -> Any:
    """The text of a key that names one of `known`, after reporting any other."""
    given = tables[key]
    if not isinstance(given, str) or given not in known:
        shown = printable(given) if isinstance(given, str) else "not a string"
        collector.add((*path, key), f"unknown {key.replace('_', ' ')} '{shown}'", partial(nearest, shown, known))
    return given


def _without_replaced(base: Material | None, tables: dict) -> Material | None:
    """The base without the sources of numbers that the tables replace."""
    if base is None:
        return None
    given = _given_of_eos(tables)

    def stands(source: Source) -> bool:
        family, _, name = source.quantity.partition(".")
        if family == "valid_up_to" and "law" in given or family == "detonation" and given - THERMAL:
            return False      # stated of the curve, or with the constants of the products, that are replaced
        table = tables.get(family)
        return not (table == "none" or (isinstance(table, dict) and ("law" in table or name in table)))

    return replace(base, sources=tuple(s for s in base.sources if stands(s)))


def _given_of_eos(tables: dict) -> set[str]:
    """What the tables say of the equation of state, by the names of its table."""
    eos = tables.get("eos")
    return set(eos) if isinstance(eos, dict) else set()


def _facts(tables: dict, collector: Collector, path: tuple, base: Material | None):
    valid = base.valid_up_to if base and "law" not in _given_of_eos(tables) else None
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
            collector.add((*path, "warnings"), "expected a string or an array of strings")
    return valid, sources, warnings


def _source(row: Any, collector: Collector, path: tuple) -> Source | None:
    if isinstance(row, str):
        return Source("", "", "", row)
    names = [f.name for f in fields(Source)]
    if not isinstance(row, dict):
        collector.add(path, "expected a source, as a string or a table", f"keys: {', '.join(names)}")
        return None
    for key in row:
        if key not in names:
            collector.unknown((*path, key), names)
        elif not isinstance(row[key], str) and key != "value":
            collector.add((*path, key), "expected a string")
    known = {"quantity": "", "value": "", "unit": "", "source": ""} | {k: v for k, v in row.items() if k in names}
    return Source(**known)


def _check_sound(built: dict, collector: Collector, path: tuple) -> None:
    """At rest a material must have positive density, a real sound speed, and strengths that are not negative."""
    par = built["eos"]
    try:
        _check_rest(par, built, collector, path)
    except ArithmeticError:
        collector.add((*path, "eos"), "these parameters give no reference state",
                      "check their units: a value is outside the range of double precision")


def _check_rest(par: Any, built: dict, collector: Collector, path: tuple) -> None:
    rho, e = reference_state(par)
    if not (math.isfinite(rho) and rho > 0.0):
        collector.add((*path, "eos"), f"the reference density must be positive, got {rho:g} kg/m^3")
        return
    p, c2 = pressure(rho, e, par), sound_speed_squared(rho, e, par)
    if not (math.isfinite(p) and math.isfinite(c2) and c2 > 0.0):
        message = (f"no real sound speed in the reference state: at {rho:g} kg/m^3 the squared sound speed is {c2:g} m^2/s^2 and the "
                   f"pressure {p:g} Pa")
        collector.add((*path, "eos"), message, "check the signs and units of the parameters")
        return
    if built["strength"] is not None:
        law = STRENGTH.of(built["strength"])
        if "needs_temperature" in law.flags and not has_temperature(par):
            message = f"the strength law {law.name} needs temperatures, which the equation of state does not give"
            collector.add((*path, "strength"), message, "give the equation of state its specific_heat")
            return
        warm = temperature_at_rest(par)
        for what, value in (("shear modulus", shear_modulus(rho, p, warm, rho * c2, built["strength"])),
                            ("flow stress", flow_stress(rho, p, warm, 0.0, 0.0, built["strength"]))):
            if not (math.isfinite(value) and value >= 0.0):
                collector.add((*path, "strength"), f"the {what} in the reference state must not be negative, got {value:g} Pa")
    if built.get("burn") is not None and asked_at_nodes(built["fracture"]):
        collector.add((*path, "fracture"), "this law is evaluated at nodes, where no burn fraction is defined",
                      'use "pressure_volume" or "spall_stress" for an explosive')
    if built["fracture"] is not None and not tension_cap(0.0, built["fracture"]) > 0.0:
        collector.add((*path, "fracture"), f"the strength in tension must be positive, got {tension_cap(0.0, built['fracture']):g} Pa")
