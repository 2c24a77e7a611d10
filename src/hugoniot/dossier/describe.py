"""A material in words and numbers for people: what `hugoniot material show`, the docs pages and reports print."""

from hugoniot.dossier import fits
from hugoniot.dossier.derived import derived_quantities
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.marks import marks
from hugoniot.materials.reach import range_of, reach
from hugoniot.materials.record import mark, material_record
from hugoniot.materials.schema import Row


def described(entry: Entry) -> dict:
    """Everything known about a material as plain data (SI numbers, words, lists), for printing or for JSON."""
    derived = derived_quantities(entry.material, entry.unreacted)
    return {
        "name": entry.name, "title": entry.title, "category": entry.category, "aliases": list(entry.aliases), "curated": entry.curated,
        "laws": entry.material.laws(), "valid_up_to": entry.material.valid_up_to, "reach": reach(entry.material),
        "warnings": list(entry.material.warnings),
        "constants": material_record(entry.material),
        "derived": {k: q._asdict() for k, q in derived.items()},
        "reasons": {k: v for k, v in entry.reasons.items() if v}, "missing": list(entry.missing), "notes": list(entry.notes),
        "others": [{"family": family, "row": i, "summary": row_summary(schema.row(i)), "source": schema.row(i).source,
                    "marks": list(marks(schema.row(i)))} for family, ids in entry.others.items() for i in ids],
        "fits": fit_lines(entry),
    }


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
        "constants": constants, "derived": {}, "reasons": {}, "missing": [],
        "notes": [*words, *([row.note] if row.note else [])], "others": [], "fits": [],
    }


def row_summary(row: Row) -> str:
    """The constants of a row in a few characters, with the range of a Hugoniot and its mark."""
    if row.table == "us_up":
        text = hugoniot_text(row) + (f", to up = {row['up_max']:g} m/s" if "up_max" in row else ", range not known")
    elif row.table == "compression":
        text = f"{row['rho0']:g} kg/m3, K = {row['bulk_modulus'] / 1e9:.4g} GPa, K' = {row['bulk_modulus_slope']:g}"
    elif row.table == "jwl":
        stated = f", D {row['detonation_velocity']:g} m/s" if "detonation_velocity" in row else ""
        text = f"{row['role']} {row['rho0']:g} kg/m3{stated}"
    elif row.table == "strength":
        y = row.get("yield_stress") or row.get("johnson_cook_yield")
        text = row["model"] + (f" Y {y / 1e9:.3g} GPa" if y else "")
    else:
        text = row.table.replace("_", " ")
    return text + (" (unverified)" if row.status == "recalled" else " (doubtful)" if row.marks else "")


def hugoniot_text(row: Row) -> str:
    """Us(up) of a row as a formula, m/s."""
    text = f"Us = {row['c0']:g} m/s + {row['s']:g} up"
    if row["form"] == "quadratic":
        text += f" {row['quadratic']:+.3g} up^2"
    elif row["form"] == "ulh":
        text += f" {row['exponential_amplitude']:+g} up exp(-{row['exponential_rate']:g} up)"
    elif row["form"] == "steinberg_cubic":
        text += f" {row['s2']:+g} (up/Us) up {row['s3']:+g} (up/Us)^2 up"
    return text


def where_read(via: str) -> str:
    """Where a number was read, as a phrase: a public file, or how the package made it."""
    return f"read in {via}" if "@" in via or via.startswith("public copy") else via


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
        terms = [f"{fit.coefficients[0]:.0f}({fit.deviations[0]:.0f})", f"{fit.coefficients[1]:.4f}({fit.deviations[1]:.4f}) up"]
        square = "".join(f" {c:+.3g}({d:.2g}) up^2" for c, d in zip(fit.coefficients[2:], fit.deviations[2:]))
        lines.append(f"{identity}: Us = {' + '.join(terms)}{square} m/s, {len(fit.points)} states, "
                     f"up {fit.least:.0f} to {fit.highest:.0f} m/s, standard deviation {fit.deviation:.0f} m/s ({selection.words})")
    return lines


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
