"""A material in words and numbers for people: what `hugoniot material show`, the docs pages and reports print."""

import math

from hugoniot.dossier import fits
from hugoniot.dossier.derived import derived_quantities
from hugoniot.dossier.wording import meanings, row_summary
from hugoniot.laws.eos.contract import has_temperature, pressure, reference_state, temperature_at_rest
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.marks import marks
from hugoniot.materials.reach import data_begin, extrapolated_sound, range_of, reach
from hugoniot.materials.record import mark, material_record


def described(entry: Entry) -> dict:
    """Everything known about a material as plain data (SI numbers, words, lists), for printing or for JSON."""
    derived = derived_quantities(entry.material, entry.unreacted)
    return {
        "name": entry.name, "title": entry.title, "category": entry.category, "aliases": list(entry.aliases), "curated": entry.curated,
        "laws": entry.material.laws(), "valid_up_to": entry.material.valid_up_to, "reach": reach(entry.material),
        "data_begin": data_begin(entry.material) or None, "sound_speed_of_others": extrapolated_sound(entry.material),
        "warnings": list(entry.material.warnings),
        "constants": material_record(entry.material),
        "derived": {k: q._asdict() for k, q in derived.items()},
        "reasons": {k: v for k, v in entry.reasons.items() if v}, "missing": list(entry.missing), "notes": list(entry.notes),
        "others": [{"family": family, "row": i, "material": schema.row(i).material, "summary": row_summary(schema.row(i)),
                    "source": schema.row(i).source, "marks": list(marks(schema.row(i)))}
                   for family, ids in entry.others.items() for i in ids],
        "fits": fit_lines(entry),
        "meanings": meanings(entry.material, entry.rate), "reference": _reference(entry.material.eos),
    }


def _reference(par) -> dict:
    """The state that derived quantities refer to: density (kg/m3), pressure (Pa), temperature (K; None where the law has none)."""
    rho, e = reference_state(par)
    warm = temperature_at_rest(par) if has_temperature(par) else None
    return {"density": float(rho), "pressure": float(pressure(rho, e, par)), "temperature": warm}


def described_row(identity: str) -> dict:
    """A row of any table in the same form, for rows that are no material by themselves or have no law in the package."""
    row = schema.row(identity)
    words = [f"{name}: {value}" for name, value in row.values.items() if isinstance(value, str)]
    constants = [{"material": identity, "quantity": s.quantity, "value": s.value, "unit": s.unit, "source": s.source, "via": s.via,
                  "status": s.status, "mark": mark(s.status, s.note), "note": s.note} for s in row.constants()]
    return {
        "name": identity, "title": f"{row.material or row.get('quantity', '')} (row {identity} of {row.table})",
        "category": str(row.get("category", row.table)), "aliases": [], "curated": False, "laws": {}, "valid_up_to": row.get("up_max"),
        "reach": range_of(row) if row.table == "us_up" else "does not apply", "warnings": list(marks(row)),
        "data_begin": None, "sound_speed_of_others": None, "constants": constants, "derived": {}, "reasons": {}, "missing": [],
        "notes": [*words, *([row.note] if row.note else [])], "others": [], "fits": [],
        "meanings": {}, "reference": None,
    }


def fit_lines(entry: Entry) -> list[str]:
    """Recomputed fits of the measured states among the rows of a material, with standard deviations and range."""
    rows = [i for i in entry.comparison_rows() if i.startswith("U") and schema.row(i).status == "derived"]
    if not rows:
        return []
    lines = []
    for identity in rows:
        if identity not in fits.RECORDED:
            continue
        fit, (selection, _) = fits.recorded(identity), fits.RECORDED[identity]
        terms = [f"({_spread(c, d)}){what}" for c, d, what in zip(fit.coefficients, fit.deviations, ("", " up", " up^2"))]
        lines.append(f"row {identity}: Us = {' + '.join(terms)} (m/s), fitted to {len(fit.points)} states ({selection.words}), "
                     f"particle velocities from {fit.least:.0f} to {fit.highest:.0f} m/s; their shock velocities deviate from it by "
                     f"{fits.scatter(schema.row(identity)).deviation:.3g} m/s, root mean square")
    return lines


def _spread(value: float, deviation: float) -> str:
    """A coefficient ± its standard deviation: to whole m/s, or to two digits of the deviation."""
    if deviation >= 1.0:
        return f"{value:.0f} ± {deviation:.0f}"
    if deviation < 1e-3:
        return f"{value:.2e} ± {deviation:.1e}"
    places = 1 - math.floor(math.log10(deviation))
    return f"{value:.{places}f} ± {deviation:.{places}f}"


def summary() -> dict:
    """Counts for `material list --summary`: what is curated, searchable, unverified against print, doubted."""
    tables = {}
    for row in schema.all_rows():
        count = tables.setdefault(row.table, {"rows": 0, "unverified": 0, "doubted": 0})
        count["rows"] += 1
        count["unverified"] += row.status == "recalled"
        count["doubted"] += any(m for m in marks(row) if schema.UNVERIFIED not in m)
    total = {key: sum(t[key] for t in tables.values()) for key in ("rows", "unverified", "doubted")}
    everything = list(library.listings())
    return {
        "curated_materials": len(library.index()),
        "searchable_materials": len(everything),
        "rows": total["rows"],
        "measured_states": len(schema.points()),
        "rows_unverified_against_print": total["unverified"],
        "rows_doubted_or_not_closing": total["doubted"],
        "curated_materials_with_unverified_constants": sum(
            any(s.status == "recalled" for s in e.material.sources) for e in library.find_all()),
        "tables": tables,
    }
