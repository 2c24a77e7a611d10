"""Laws and materials as tables of SI numbers, the form decks and material files have; `materials.law_reader` reads it back."""

import functools
import inspect
import math
from dataclasses import asdict
from typing import Any

import numpy as np

from hugoniot.core.registry import Law, Registry
from hugoniot.errors import HugoniotError
from hugoniot.laws import burn, eos, fracture, strength  # noqa: F401  (importing a room enrols its laws)
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials.material import Material


def families() -> dict[str, Registry]:
    """The families a material is made of, in the order they are written."""
    return {"eos": EOS, "strength": STRENGTH, "fracture": FRACTURE, "burn": BURN}


def accepted(law: Law) -> tuple[list[str], list[str]]:
    """(names a table may give, names it must give) of a law, from the signature that builds its parameters."""
    signature = _signature(law.build)
    named = [p for p in signature if p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)]
    names, required = [p.name for p in named], [p.name for p in named if p.default is p.empty]
    if any(p.kind is p.VAR_KEYWORD for p in signature):
        preset = getattr(law.parameters, "_field_defaults", {})
        names = list(dict.fromkeys([*names, *getattr(law.parameters, "_fields", ())]))
        required = [n for n in names if n in required or (n not in preset and n in law.parameters._fields)]
    return names, [n for n in required if n not in law.defaults]


@functools.cache
def _signature(build) -> tuple[inspect.Parameter, ...]:
    return tuple(inspect.signature(build).parameters.values())


def law_table(registry: Registry, par: Any) -> dict:
    """The table (`law` first, SI numbers) that reads back to exactly `par`; not-a-number optional values are left out."""
    law = registry.of(par)
    values = {name: value for name, value in par._asdict().items() if not (isinstance(value, float) and math.isnan(value))}
    names, required = accepted(law)
    written = {k: _plain(registry, v) for k, v in values.items()}
    if set(values) <= set(names) and set(required) <= set(values):
        try:
            again = law.build(**({k: v for k, v in law.defaults.items() if k in names} | values))
        except (HugoniotError, ValueError, ArithmeticError, TypeError):
            again = None
        if again is not None and same_parameters(again, par):
            return {"law": law.name, **written}
    return {"law": law.name, "parameters": written}


def same_parameters(a: Any, b: Any) -> bool:
    """Whether two parameter tuples are of one law and equal bit for bit; not-a-number equals itself, arrays compare by element."""
    return type(a) is type(b) and all(
        same_parameters(x, y) if isinstance(x, tuple) else _same_value(x, y) for x, y in zip(a, b))


def _same_value(x: Any, y: Any) -> bool:
    if type(x) is float and type(y) is float:
        return x == y or (x != x and y != y)
    return np.array_equal(x, y, equal_nan=not isinstance(x, str))


def _plain(registry: Registry, value: Any) -> Any:
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        return law_table(registry, value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, tuple):
        return [float(v) for v in value]
    return value if isinstance(value, (str, bool)) else float(value)


def material_tables(material: Material) -> dict:
    """The tables of `[material.<name>]` that read back to exactly this material."""
    tables: dict[str, Any] = {"library": material.library} if material.library else {}
    if material.valid_up_to is not None:
        tables["valid_up_to"] = float(material.valid_up_to)
    if material.warnings:
        tables["warnings"] = list(material.warnings)
    if material.sources:
        known = {"quantity": "", "value": "", "unit": "", "source": "", "via": "", "status": "user", "note": ""}
        tables["sources"] = [{k: v for k, v in asdict(source).items() if v != known.get(k)} for source in material.sources]
    for family, registry in families().items():
        par = getattr(material, family)
        if par is not None:
            tables[family] = law_table(registry, par)
    if material.unreacted is not None:
        tables["unreacted"] = law_table(EOS, material.unreacted)
    given = {name: getattr(material, name) for name in ("mixture", "detonation_energy", "reference_state")}
    return {key: value for key, value in given.items() if value is not None} | tables
