"""hugoniot material: list, show, search, compare and check the materials library and users' own materials."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, MATERIALS, echo_json, echo_table
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError

app = typer.Typer(no_args_is_help=True, help="Search and show the materials library, in which every number has its source.\n\nA "
        "material is assembled from rows of data tables. A row has an id, such as U007, and can be shown by itself.",
                  epilog="Example: hugoniot material show copper", context_settings={"help_option_names": ["-h", "--help"]})
_COUNTED = {"rows_unverified_against_print": "rows neither from a public file nor checked against the printed source",
            "rows_doubted_or_not_closing": "rows that are doubtful or miss their stated CJ state",
            "curated_materials_with_unverified_constants": "curated materials with constants of such rows"}
SHOWN = {"Pa": (1e9, "GPa"), "J/m^3": (1e9, "GJ/m^3"), "1/Pa": (1e-9, "1/GPa")}


@app.command("list")
def list_materials(
    category: Annotated[str, typer.Argument(help="List only this category, such as metal, polymer, rock, gas or explosive.")] = "",
    everything: Annotated[bool, typer.Option("--all", help="Also list rows that no material of the library uses.")] = False,
    summary: Annotated[bool, typer.Option("--summary", help="Print only totals, such as the number of rows not checked against the "
        "printed source.")] = False,
    counts: Annotated[bool, typer.Option("--counts", help="Print only counts of materials by category and of rows by source and "
        "content.")] = False,
    gamma_law: Annotated[bool, typer.Option("--gamma-law", help="List explosives as ideal gases: density, heat of reaction Q and "
        "gamma, derived from their data.")] = False,
    materials: MATERIALS = None,
    as_json: JSON = False,
) -> None:
    """List the materials of the library.

    Example: hugoniot material list explosive
    """
    from hugoniot.materials import library

    if gamma_law:
        if category.lower() not in ("", "explosive") or materials or summary or counts:
            raise DeckError.single("material list", None, "--gamma-law", "lists the library's explosives only",
                                   "give it alone, or with --all for single rows too")
        _gamma_laws(everything, as_json)
        return

    if summary or counts:
        refuse_idle("on totals of the library", "--all", "--materials", *(["--counts"] if summary else []))
        if category:
            raise DeckError.single("material list", None, category[:40], "has no effect on totals of the library", "omit it")
        (_summary if summary else _counts)(as_json)
        return
    rows = [hit for hit in library.listings() if everything or hit.curated]
    shown = [_listing(hit) for hit in rows] + [_user_listing(e) for e in _users(materials).values()]
    if category:
        kinds = sorted({r["category"] for r in shown})
        shown = [r for r in shown if category.lower() in r["category"].lower()]
        if not shown:
            message = f"no material of category '{category[:40]}'"
            raise DeckError.single("material list", None, "category", message, f"known: {', '.join(kinds)}")
    _echo_listings(shown, as_json)


@app.command()
def search(
    text: Annotated[str, typer.Argument(help="Part of a name or alias, a category, or the id of a row.")],
    as_json: JSON = False,
) -> None:
    """Search materials and rows of the tables.

    Example: hugoniot material search "stainless 304"
    """
    from hugoniot.materials import library
    from hugoniot.materials.collect import printable

    hits = [_listing(hit) for hit in library.search(text)]
    if not hits and not as_json:
        try:
            library.entry(text)
        except DeckError as error:
            nothing = f"nothing found for '{printable(text)}'"
            raise DeckError.single("material search", None, "text", nothing, error.problems[0].hint) from None
    _echo_listings(hits, as_json)


@app.command()
def show(
    name: Annotated[str, typer.Argument(help="Name, alias (Cu, al6061, plexiglas) or id of a row (U007).")],
    materials: MATERIALS = None,
    as_json: JSON = False,
) -> None:
    """Show a material or a row with its sources.

    Prints constants with units, warnings, what is missing, and derived quantities.

    Example: hugoniot material show copper
    """
    from hugoniot.dossier.describe import described, described_row
    from hugoniot.materials import schema

    identity = name.strip().upper()
    try:
        about = described(_entry(name, materials))
    except DeckError:
        if not schema.is_row(identity):
            raise
        about = described_row(identity)
    if as_json:
        echo_json(about)
    else:
        _echo_material(about)


@app.command()
def compare(
    names: Annotated[list[str], typer.Argument(help="Two or more materials, or one, whose sources are then compared.")],
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Picture to write, .png, .pdf or .svg (default: compare.png, or none with "
        "--json).")] = None,
    up_to: Annotated[str, typer.Option("--up-to", help="Particle velocity at which the curves end, such as \"3 km/s\".")] = "",
    materials: MATERIALS = None,
    as_json: JSON = False,
) -> None:
    """Draw Hugoniots of materials or of sources.

    The picture shows p-up and Us-up curves of several materials, or of all sources of one, with measured states.

    Example: hugoniot material compare iron -o iron.png
    """
    from hugoniot.cli.plot import drawable
    from hugoniot.cli.show import quantity
    from hugoniot.dossier.curves import comparison

    picture = out or (None if as_json else Path("compare.png"))
    if picture is not None:
        drawable(picture, "material compare", "--out")
    limit = quantity(up_to, "m/s", "--up-to") if up_to else None
    if limit is not None and not limit > 0.0:
        raise DeckError.single("command line", None, "--up-to", f"{up_to} is not a valid particle velocity",
                               'give a positive one, "3 km/s"')
    chosen = comparison([_entry(name, materials) for name in names], limit)
    if picture is not None:
        from hugoniot.output.atomic import explained
        from hugoniot.plotting.materials import compare_figure

        with explained(picture, "no picture is written"):
            compare_figure(chosen, picture)
    if as_json:
        echo_json(chosen.table())
    else:
        rows = [(c.label, "{1:.0f} m/s at {0:.0f} m/s".format(*c.middle), c.source) for c in chosen.curves]
        echo_table(["curve", "Us at up", "source"], rows)
        for note in chosen.notes:
            typer.echo(note)
        typer.echo(f"wrote {picture}")


@app.command()
def check(
    files: Annotated[list[Path] | None, typer.Argument(help="Files or folders of your own materials.", readable=False)] = None,
    everything: Annotated[bool, typer.Option("--all", help="Check every row, measured state and material of the library.")] = False,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Print all remarks, not only discrepancies found by "
        "computation.")] = False,
    as_json: JSON = False,
) -> None:
    """Check material files, or the whole library.

    Example: hugoniot material check my_materials.toml
    """
    from hugoniot.dossier import checks
    from hugoniot.materials.users import user_materials

    if not files and not everything:
        raise DeckError.single("material check", None, "files", "nothing to check", "give files of materials, or --all")
    found = checks.check_all() if everything else []
    own = user_materials(files or ())
    if files and not own:
        raise DeckError.single("material check", None, "files", f"no material in {', '.join(map(str, files))}",
                               "a material file has [material.NAME.eos], or [eos]")
    for entry in own.values():
        found += checks.check_entry(entry)
    counts = checks.tally(found)
    if as_json:
        echo_json({"counts": counts, "findings": [f._asdict() for f in found if f.verdict != "ok" or not everything]})
    else:
        _echo_findings(found, counts, verbose or not everything)
    if counts["fail"]:
        raise typer.Exit(2)


# -- output ------------------------------------------------------------------------------------------------------
def _users(places: list[Path] | None) -> dict:
    if not places:
        return {}
    from hugoniot.materials.users import user_materials
    return user_materials(places)


def _entry(name: str, places: list[Path] | None):
    if places:
        from hugoniot.materials.users import find, user_materials
        return find(name, user_materials(places))
    from hugoniot.materials import library
    return library.entry(name)


def _listing(hit) -> dict:
    return {"name": hit.name, "category": hit.category, "title": hit.title, "aliases": list(hit.aliases), "rows": list(hit.rows),
            "curated": hit.curated}


def _user_listing(entry) -> dict:
    return {"name": entry.name, "category": "user", "title": entry.title, "aliases": [], "rows": list(entry.rows), "curated": True}


def _echo_listings(rows: list[dict], as_json: bool) -> None:
    if as_json:
        echo_json(rows)
        return
    cells = [(r["name"], r["category"], r["title"] if r["curated"] else "not curated", ", ".join(r["aliases"] or r["rows"])) for r in rows]
    echo_table(["name", "category", "title", "other names, or rows"], cells)
    if not all(r["curated"] for r in rows):
        typer.echo("not curated: no choice was made among the sources; give the id of a row, such as "
                   f"{next(r['rows'][0] for r in rows if not r['curated'])}, as the material")


def _counts(as_json: bool) -> None:
    from hugoniot.materials.counts import by_kind, by_source, known, ranges_by_kind

    kinds, sources = by_kind(), by_source()
    if as_json:
        echo_json({"kinds": kinds, "sources": sources, "known": known(), "ranges": ranges_by_kind()})
        return
    keys = ("curated", "rows_only", "shock", "compression")
    lines = [(name, *(str(count[k]) for k in keys), str(count["curated"] + count["rows_only"])) for name, count in kinds.items()]
    sums = [sum(count[k] for count in kinds.values()) for k in keys]
    echo_table(["kind", "curated", "rows only", "of which shock", "static compression", "all"],
               [*lines, ("all", *map(str, sums), str(sums[0] + sums[1]))])
    echo_table(["source of rows", "rows"], [(name[:70], str(n)) for name, n in list(sources.items())[:25]])
    echo_table(["what is known", "rows"], [(name, str(n)) for name, n in known().items()])
    echo_table(["Us-up rows by kind", "rows", "with a range", "with a deviation of Us", "with measured states"],
               [(name, *(str(count[k]) for k in ("rows", "range", "deviation", "states"))) for name, count in ranges_by_kind().items()])


def _gamma_laws(everything: bool, as_json: bool) -> None:
    from hugoniot.dossier.gamma_law import gamma_laws

    found = gamma_laws(everything)
    if as_json:
        echo_json([{**law._asdict(), "marks": list(law.marks), "derived": True} for law in found])
        return
    echo_table(["explosive", "density, kg/m3", "Q, MJ/kg", "gamma", "", "from D, m/s", "and p_CJ, GPa", "of row"],
               [(law.name, f"{law.density:g}", f"{law.heat * 1e-6:.4g}", f"{law.gamma:.4g}", "derived", f"{law.detonation_velocity:.0f}",
                 f"{law.cj_pressure * 1e-9:.2f}", law.row) for law in found])
    typer.echo("")
    for law in found:
        for mark in law.marks:
            typer.secho(f"WARNING {mark}", fg="yellow")
    typer.echo("derived: gamma = rho0 D^2/p_CJ - 1 and Q = D^2/(2 (gamma^2 - 1)) give a gamma-law gas the CJ state of the products;\n"
               "Q is not the heat of detonation, and away from the CJ state the gas differs from the products")


def _summary(as_json: bool) -> None:
    from hugoniot.dossier.describe import summary

    counts = summary()
    if as_json:
        echo_json(counts)
        return
    rows = [(_COUNTED.get(key, key.replace("_", " ")), str(value)) for key, value in counts.items() if not isinstance(value, dict)]
    echo_table(["of the library", "number"], rows)
    typer.echo("")
    echo_table(["table", "rows", "not checked", "doubtful"],
               [(name, str(t["rows"]), str(t["unverified"]), str(t["doubted"])) for name, t in counts["tables"].items()])


def _echo_material(about: dict) -> None:
    from hugoniot.dossier.wording import DERIVED, GROUPS, differences, digits, grouped, numbered, reference_name, where_read

    typer.echo(f"{about['title']}  [{about['name']}, {about['category']}]")
    if about["aliases"]:
        typer.echo(f"other names: {', '.join(about['aliases'])}")
    if about["laws"]:
        typer.echo("laws: " + "; ".join(f"{GROUPS[family]} {law}" for family, law in about["laws"].items()))
    typer.echo(f"range of the data: {about['reach']}")
    for warning in about["warnings"]:
        typer.secho(f"WARNING {warning}", fg="yellow")
    constants = about["constants"]
    marks, sources = numbered(constants)
    for group, members in grouped(constants).items():
        typer.echo(f"\n{GROUPS[group] if about['laws'] else 'constants'}:")
        rows = [(c["quantity"], *_shown(c["value"], c["unit"]), marks[k], c["mark"], about["meanings"].get(c["quantity"], ""))
                for k, c in ((k, constants[k]) for k in members)]
        filled = [k for k in range(6) if any(row[k] for row in rows)]
        heads = ("constant", "value", "unit", "source", "remark", "meaning")
        echo_table([heads[k] for k in filled], [[row[k] for k in filled] for row in rows])
    if about["derived"]:
        state, cells = about["reference"], []
        for key, q in about["derived"].items():
            scale, unit = SHOWN.get(q["unit"], (1.0, q["unit"]))
            cells.append((DERIVED[key], digits(q["value"] / scale), "" if unit == "1" else unit, q["meaning"]))
        warm = f", temperature {state['temperature']:g} K" if state["temperature"] is not None else ""
        where = f"at the {reference_name(about)}, density {state['density']:.5g} kg/m3{warm}"
        typer.echo(f"\nderived quantities ({'CJ state' if 'cj_velocity' in about['derived'] else where}):")
        echo_table(["quantity", "value", "unit", "how it is computed"], cells)
        if differences(about):
            typer.echo(differences(about))
    choices = [f"{GROUPS[family]}: {reason}" for family, reason in about["reasons"].items()]
    for head, lines in (("fits made by hugoniot to measured states", about["fits"]), ("why these constants", choices),
                        ("limitations", about["missing"]), ("remarks", about["notes"]),
                        ("other rows of the library (hugoniot material show ROW prints one)",
                         [f"{o['row']} ({GROUPS[o['family']]}): {o['summary']}" for o in about["others"]])):
        if lines:
            typer.echo(f"\n{head}:")
            for line in lines:
                typer.echo(f"  {line}")
    if sources:
        typer.echo("\nsources:")
    for k, (source, via) in enumerate(sources, 1):
        typer.echo(f"  [{k}] {source}" + (f"\n      {where_read(via)}" if via else ""))


def _shown(value, unit: str) -> tuple[str, str]:
    """A number and its unit as engineers write them."""
    if isinstance(value, str):
        return value, "" if unit == "text" else unit
    scale, name = SHOWN.get(unit, (1.0, unit))
    return f"{value / scale:.6g}", "" if name == "1" else name


def _echo_findings(found: list, counts: dict, every: bool) -> None:
    quiet = () if every else ("caveat of the row", "warning", "law")
    lines = [f for f in found if f.verdict == "fail"]
    lines += [f for f in found if f.verdict == "mark" and f.check not in quiet and (every or "states no" not in f.text)]
    echo_table(["verdict", "where", "check", "finding"],
               [("remark" if f.verdict == "mark" else f.verdict, f.where, f.check, f.text or f"{f.value:.4g}") for f in lines])
    typer.echo(f"checks passed: {counts['ok']}, remarks: {counts['mark']}, failed: {counts['fail']}")


