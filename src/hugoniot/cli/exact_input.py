"""What `hugoniot exact` is given: parameters as `gamma=1.4` or `left.density="1 kg/m^3"`, and positions."""

import inspect
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from hugoniot.cli.show import quantity
from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest
from hugoniot.theory.exact import parameter_unit

GEOMETRIES = ("planar", "cylindrical", "spherical")


def parameters_of(function: Callable, settings: list[str], skip: tuple[str, ...] = ()) -> tuple[Callable, dict]:
    """(the solution to be called, every parameter in SI) from `PARAMETER=VALUE` texts; DeckError names what is wrong.

    A parameter that is a tuple of its own (one side of a Riemann problem, a solid) takes dotted names, `left.density=1`.
    """
    known = {k: p for k, p in inspect.signature(function).parameters.items() if k not in skip}
    flat = _flat(known)
    typed: dict[str, str] = {}
    for text in settings:
        key, equals, value = (part.strip() for part in text.partition("="))
        if not equals:
            raise DeckError.single("command line", None, text[:40], "has no value", "write PARAMETER=VALUE, such as gamma=1.4")
        if key in known and _is_record(known[key]):
            typed |= _solid(key, value)
        elif key not in flat:
            raise DeckError.single("command line", None, key[:40], "unknown parameter", nearest(key, flat) if flat else "it has none")
        else:
            typed[key] = value
    geometry = typed.get("geometry", known["geometry"].default if "geometry" in known else "spherical")
    values = dict(flat)
    for key, value in typed.items():
        values[key] = _read(key, value, flat[key], str(geometry))
    if missing := [k for k, v in values.items() if v is inspect.Parameter.empty]:
        raise DeckError.single("command line", None, "exact", f"not given: {', '.join(missing)}", f"write {missing[0]}=VALUE")
    arguments = {k: _record(p, k, values) if _is_record(p) else values[k] for k, p in known.items()}
    return partial(function, **arguments), values


def needed(function: Callable) -> list[str]:
    """Parameters without a usual value, records under dotted names."""
    known = dict(inspect.signature(function).parameters)
    return [k for k, v in _flat(known).items() if v is inspect.Parameter.empty]


def listed(name: str, given: dict) -> str:
    """The unit a parameter is shown in, empty for plain numbers and words."""
    unit = parameter_unit(name.rpartition(".")[2], str(given.get("geometry", "spherical")))
    return "" if unit == "1" else unit


def points_of(text: str, where: str, width: int | None) -> np.ndarray:
    """Positions in metres: (n,) for a list with commas where `width` is 1, else (n, width) with points divided by semicolons."""
    if width == 1:
        return np.array([quantity(part.strip(), "m", where) for part in text.split(",")])
    rows = [[quantity(part.strip(), "m", where) for part in point.split(",")] for point in text.split(";")]
    sizes = (width,) if width else (2, 3)
    if len(rows[0]) not in sizes or any(len(row) != len(rows[0]) for row in rows):
        raise DeckError.single("command line", None, where,
                               f"'{text[:60]}' is not a list of points with {' or '.join(map(str, sizes))} coordinates each",
                               'separate the coordinates of a point by commas and points by semicolons, for example '
                               + ('"0, 4 m; 3 m, 2 m"' if 2 in sizes else '"0, 4 m, 1 m; 3 m, 2 m, 0"'))
    return np.array(rows)


def _is_record(parameter: inspect.Parameter) -> bool:
    return hasattr(parameter.annotation, "_fields")


def _flat(known: dict[str, inspect.Parameter]) -> dict[str, Any]:
    """Default of every parameter, fields of records under dotted names; `inspect.Parameter.empty` where there is none."""
    found: dict[str, Any] = {}
    for key, p in known.items():
        if not _is_record(p):
            found[key] = p.default
            continue
        whole = p.default._asdict() if p.default is not inspect.Parameter.empty else {}
        for name in p.annotation._fields:
            found[f"{key}.{name}"] = whole.get(name, p.annotation._field_defaults.get(name, inspect.Parameter.empty))
    return found


def _record(parameter: inspect.Parameter, key: str, values: dict):
    return parameter.annotation(*(values[f"{key}.{name}"] for name in parameter.annotation._fields))


def _read(key: str, text: str, default: Any, geometry: str) -> Any:
    """One value: a word, a switch, points, or a quantity in the unit of its name."""
    name = key.rpartition(".")[2]
    if isinstance(default, bool):
        if text not in ("true", "false"):
            raise DeckError.single("command line", None, key, f"'{text[:40]}' is neither true nor false", f"write {key}=true")
        return text == "true"
    if name == "geometry" and text not in GEOMETRIES:
        raise DeckError.single("command line", None, key, f"unknown geometry '{text[:40]}'", nearest(text, GEOMETRIES))
    if isinstance(default, str):
        return text
    unit = parameter_unit(name, geometry)
    if isinstance(default, tuple):
        if default and isinstance(default[0], tuple):
            return tuple(tuple(row) for row in points_of(text, key, len(default[0])).tolist())
        return tuple(quantity(part.strip(), unit, key) for part in text.split(","))
    value = quantity(text, unit, key)
    if isinstance(default, int):
        if value != int(value):
            raise DeckError.single("command line", None, key, f"'{text[:40]}' is not a whole number", f"write {key}={default}")
        return int(value)
    return value


def _solid(key: str, name: str) -> dict[str, str]:
    """The constants of a material of the library for a record that names a solid: linear us-up, shear modulus and yield stress."""
    from hugoniot.cli.eos.input import find_material
    from hugoniot.laws.eos.contract import reference_state, sound_speed_squared
    from hugoniot.laws.strength.contract import flow_stress, shear_modulus

    if key != "solid":
        raise DeckError.single("command line", None, key, "is a group of parameters", f"give them one by one: {key}.NAME=VALUE")
    material = find_material(name).material
    par = material.eos
    if not all(hasattr(par, n) for n in ("rho0", "c0", "s", "gamma0")) or material.strength is None:
        raise DeckError.single("command line", None, key, f"'{name[:40]}' gives no linear Us-up law with a strength",
                               f"write its constants: {key}.rho0=..., {key}.c0=...")
    rho, e = reference_state(par)
    stiffness = rho * sound_speed_squared(rho, e, par)
    found = {n: getattr(par, n) for n in ("rho0", "c0", "s", "gamma0")}
    found["shear_modulus"] = shear_modulus(rho, 0.0, 298.15, stiffness, material.strength)
    found["yield_stress"] = flow_stress(rho, 0.0, 298.15, 0.0, 0.0, material.strength)
    return {f"{key}.{n}": repr(float(v)) for n, v in found.items()}
