"""What the set-up and the summary of a run must hold for those who read them, as shapes of tables and lists that a value is compared with.

A shape is a type, or several; a table of shapes by key, where a `?` after the key marks one that may be missing and `...` stands for every
other key; or a list of one shape for all its elements. `None` fits where a shape names it.
"""

from typing import Any

from hugoniot.output.columns import PER_AREA

Number, Whole, Text, Nothing = (int, float), (int,), (str,), type(None)
_LAW: dict[Any, Any] = {
    "family": Text, "law": Text, "summary": Text, "references": [Text],
    "constants": [{"name": Text, "unit": Text, "meaning": Text, "source": Text, "status": Text, "note": Text, "value": (object,)}]}
_LAW["inner"] = [_LAW]
_SOURCE = {"quantity": Text, "value": (object,), "unit": Text, "source": Text, "status": Text, "note": Text}
_MATERIAL = {"name": Text, "laws": [_LAW], "other_sources": [_SOURCE], "warnings": [Text], "reach?": Text,
             "at_rest?": {...: Number}, "bulk?": {"bulk_ratio": Number, "bulk_viscosity": Number}}
_TRANSPORT = {"laws": [_LAW], "bulk_ratio": Number, "bulk_viscosity": Number}
_COMMON = {"title": Text, "geometry": Text, "version": Text, "stop_time": Number, "references": [Text], "materials": {...: _MATERIAL}}
_LINE = {
    **_COMMON, "solver": {"kind": Text, "integrator?": Text, "options?": (dict, Nothing)},
    "regions": [{"name": Text, "material": Text, "start": Number, "end": Number, "zones": Whole, "velocity": (int, float, list),
                 "starts?": {...: Number}}],
    "boundaries": {side: {"kind": Text, "pulse?": (dict, Nothing)} for side in ("left", "right")},
    "gauges": [{"name": Text, "at": (int, float, str)}], "parting?": [Text]}
_POINT = [Number]
_PLANE = {
    **_COMMON, "axes": [Text], "solver": {"kind": Text, "integrator": Text},
    "regions": [{"name": Text, "material": Text, "zones": [Whole]}], "boundaries": {...: {"kind": Text}}, "chains": {...: [[_POINT]]},
    "gauges": [{"name": Text, "kind": Text, "at": (list, Nothing)}], "struck?": [Text], "lighting": [{"at?": (list, Nothing)}],
    "rigid?": [{"name": Text, "points": [_POINT], "closed": (bool,), "centre": _POINT}]}
_COUNTED = ("zone_updates", "voids_opened", "voids_closed", "interfaces_separated")
_SUMMARY = {"title": Text, "status": Text, "solver": Text, "version": Text, "time": Number, "cycles": Whole,
            "wall_seconds": (int, float, Nothing), **{f"{name}?": Number for name in (*_COUNTED, "compile_seconds")},
            "checkpoint_warnings?": [Text], "deck_sha256?": Text,
            **{f"{name}_error?": (int, float, Nothing) for name in ("mass", "momentum", "energy")}}
# entries of some solvers, of which the first stands for all
_TOGETHER = (
    ("zones_eroded", "eroded_mass", "eroded_energy"),
    ("contact_heat", "friction_work", "contact_depth", "bonds_broken"), ("density_thickness", "cells_per_thickness"),
    ("cells_halved", "finest_halving"),
    ("steady_density_thickness", "density_thickness", "steady_velocity_thickness", "steady_density_width_10_90", "mach", "entropy_viscous",
     "entropy_conductive"))


def misfit(value: Any, shape: Any, path: str = "") -> str:
    """Where a value departs from a shape, such as "regions[2].start is missing"; "" where it fits."""
    if isinstance(shape, dict):
        if not isinstance(value, dict):
            return f"{path or 'the record'} is not a table"
        for key, inner in shape.items():
            if key is ...:
                found = next((w for k, v in value.items() if (w := misfit(v, inner, _at(path, k)))), "")
            elif key.endswith("?"):
                found = misfit(value[key[:-1]], inner, _at(path, key[:-1])) if key[:-1] in value else ""
            else:
                found = misfit(value[key], inner, _at(path, key)) if key in value else f"{_at(path, key)} is missing"
            if found:
                return found
        return ""
    if isinstance(shape, list):
        if not isinstance(value, list):
            return f"{path} is not a list"
        return next((w for k, v in enumerate(value) if (w := misfit(v, shape[0], f"{path}[{k}]"))), "")
    kinds = shape if isinstance(shape, tuple) else (shape,)
    if isinstance(value, bool) and not {bool, object} & set(kinds):
        return f"{path} has a value of the wrong type"
    return "" if isinstance(value, kinds) else f"{path} has a value of the wrong type"


def _at(path: str, key: str) -> str:
    return f"{path}.{key}" if path else str(key)


def wrong_setup(document: dict, plane: bool) -> str:
    """What is wrong with the set-up record of a run, of two dimensions where it has a mesh; "" where nothing is."""
    if "axes" in document and not plane:
        return "the record names axes, but the result has no mesh"
    found = misfit(document, _PLANE if plane else _LINE)
    for name, shape in (("viscosity", _LAW), ("transport", _TRANSPORT)):
        if not found and document.get(name) is not None:
            found = misfit(document[name], shape, name)
    if found:
        return found
    if document["geometry"] not in PER_AREA:
        return f"geometry is not one of {', '.join(PER_AREA)}"
    if not document["regions"]:
        return "regions is empty"
    lost = next((region["material"] for region in document["regions"] if region["material"] not in document["materials"]), None)
    return f"materials.{lost} is missing" if lost is not None else ""


def wrong_summary(summary: dict) -> str:
    """What is wrong with the summary of a run: an entry that is missing, or words where a number belongs; "" where nothing is."""
    some = {name: Number for together in _TOGETHER if together[0] in summary for name in together}
    return misfit(summary, _SUMMARY | some)
