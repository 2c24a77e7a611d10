"""Every constant a run used, with its source and mark, as plain rows for reports and tables."""

import re

from hugoniot.core.registry import Registry
from hugoniot.materials.material import Material, Source
from hugoniot.materials.schema import UNVERIFIED
from hugoniot.materials.tables import families, law_table

MARKS = {"recalled": UNVERIFIED, "user": "user's own value", "corrected": "error in the file corrected", "derived": "computed by hugoniot",
         "default": "default value"}
# how a derived constant was found: what its note says first, after its row
_FOUND = re.compile(r"row [A-Z]\d{3}: ((?:assumed|calibrated by|computed from|converted from|estimated|fitted by|highest of|mean of|set by|"
                    r"taken from)[^;:,]*|assumed|estimated)")
# what was corrected: the columns of the row, and what the file has
_CORRECTED = re.compile(r"\bcorrected: [\w ]+ \((corrected: [^)]*)\)")


def mark(status: str, note: str = "") -> str:
    """The word a surface shows beside a constant: empty for a verified one without doubt."""
    doubt = "doubtful" if "DOUBT" in note else "sources disagree" if "DISAGREES" in note else ""
    said = _FOUND.match(note) if status in ("derived", "recalled") else _CORRECTED.search(note) if status == "corrected" else None
    found = said.group(1) if said else MARKS.get(status, "")
    return ", ".join(m for m in (found, doubt) if m)


def material_record(material: Material) -> list[dict]:
    """One dictionary per constant: material, quantity, value (SI), unit, source, via, status, mark, note.

    Complete and true to the run: a number that differs from what its stated source gives (a deck replaced it) is the user's own, and
    numbers nobody stated are either a default of their law or "not stated".
    """
    stated = {s.quantity: s for s in material.sources}
    rows = []
    for family, registry in families().items():
        par = getattr(material, family)
        if par is None:
            continue
        for name, value in _numbers(law_table(registry, par)):
            source = stated.pop(f"{family}.{name}", None)
            *inside, leaf = name.split(".")
            rows.append(_row(material.name, _source_of(f"{family}.{name}", leaf, value, source, law_inside(registry, par, inside))))
    return rows + [_row(material.name, source) for source in stated.values()]


def law_inside(registry: Registry, par, path: list[str]):
    """The law a parameter belongs to: that of `par`, or one inside it."""
    for part in path:
        inner = getattr(par, part, None)
        par = inner if registry.knows(inner) else par
    return registry.of(par)


def _source_of(quantity: str, name: str, value: float, source: Source | None, law) -> Source:
    unit = law.units.get(name, "1")
    if source is None or source.source == "not stated":
        if value in (law.defaults.get(name), getattr(law.parameters, "_field_defaults", {}).get(name)):
            return Source(quantity, value, unit, f"default value of the law {law.name}", status="default")
        return source or Source(quantity, value, unit, "not stated")
    if isinstance(source.value, (int, float)) and abs(value - source.value) > 1e-9 * abs(source.value):
        return Source(quantity, value, unit, "not stated", note=f"replaces {source.value:g} of {source.source}")
    return source


def _row(name: str, s: Source) -> dict:
    return {"material": name, "quantity": s.quantity, "value": s.value, "unit": s.unit, "source": s.source, "via": s.via,
            "status": s.status, "mark": mark(s.status, s.note), "note": s.note}


def _numbers(table: dict, prefix: str = ""):
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _numbers(value, prefix if key == "parameters" else f"{prefix}{key}.")
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            yield f"{prefix}{key}", float(value)
