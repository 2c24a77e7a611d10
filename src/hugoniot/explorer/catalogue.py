"""The list of the whole library: one line per curated material and per row that is a material by itself."""

from functools import cache
from pathlib import Path
from typing import Any

from hugoniot.dossier.derived import derived_quantities
from hugoniot.dossier.describe import described, described_row
from hugoniot.errors import DeckError, HugoniotError
from hugoniot.explorer.subjects import entry_of, own
from hugoniot.laws.eos.contract import reference_state
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.marks import marks

COLUMNS = ("bulk_sound_speed", "gruneisen", "hugoniot_elastic_limit", "cj_velocity", "cj_pressure")


def listing() -> dict[str, Any]:
    """`materials`: one dictionary each, SI, those of the user's files first; `rows`: every row that makes no material by itself."""
    mine = [{"name": entry.name, "title": entry.title, "category": f"of {Path(entry.file).name}", "curated": False, "also": [],
             **_known(entry)} for entry in own.values()]
    return _library() | {"materials": mine + _library()["materials"]}


@cache
def _library() -> dict[str, Any]:
    found, alone = [], set()
    for line in library.listings():
        for name in (line.name,) if line.curated else line.rows:
            alone.add(name)
            found.append(_material(line, name))
    rows = [_row(row) for row in schema.all_rows() if row.id not in alone]
    return {"materials": found, "rows": rows, "points": len(schema.points())}


def _material(line, name: str) -> dict:
    shown = {"name": name, "title": line.title, "category": line.category, "curated": line.curated, "also": list(line.aliases)}
    try:
        entry = entry_of(name)
    except DeckError as error:      # a row that serves for comparison only
        row = schema.row(name)
        return shown | {"source": row.source, "density": row.get("rho0"), "mark": str(error.problems[0].message), "alone": False}
    return shown | _known(entry)


def _known(entry: Entry) -> dict:
    return _numbers(entry) | {"source": _source(entry), "mark": _mark(entry), "laws": entry.material.laws(), "alone": True}


def _numbers(entry: Entry) -> dict:
    numbers: dict[str, Any] = {"density": float(reference_state(entry.material.eos)[0]), "valid_up_to": entry.material.valid_up_to}
    try:
        derived = derived_quantities(entry.material, entry.unreacted)
    except HugoniotError:
        return numbers
    return numbers | {key: derived[key].value for key in COLUMNS if key in derived}


def _source(entry: Entry) -> str:
    return schema.row(entry.rows[0]).source if entry.rows else Path(entry.file).name


def _mark(entry: Entry) -> str:
    """The first doubt about the rows a material is made of; empty without one."""
    return next((text for identity in entry.rows for text in marks(schema.row(identity))), "")


def _row(row) -> dict:
    title = row.material or str(row.get("quantity", ""))
    return {"name": row.id, "title": title, "category": row.table.replace("_", " "), "curated": False, "also": [],
            "alone": False, "density": row.get("rho0"), "source": row.source, "mark": "; ".join(marks(row))}


def about(name: str) -> dict[str, Any]:
    """Everything known about a material, or about a row that is none; `DeckError` for an unknown name."""
    try:
        return described(entry_of(name))
    except DeckError:
        if schema.is_row(name):
            return described_row(name)
        raise
