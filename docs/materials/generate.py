"""Writes a page for every curated material of the library, from its data: python docs/materials/generate.py

The pages go to docs/generated/materials (not kept in the repository): a table of constants with marks and sources, derived quantities,
choices and their reasons, what is missing, other sources, and a picture of the Hugoniots with the measured states.
"""

import sys
from pathlib import Path

import matplotlib

from hugoniot.dossier.curves import comparison
from hugoniot.dossier.describe import described, summary, where_read
from hugoniot.errors import HugoniotError
from hugoniot.materials import library
from hugoniot.plotting.materials import compare_figure

matplotlib.use("Agg")
HERE = Path(__file__).parent
TARGET = HERE.parent / "generated" / "materials"
SCALES = {"Pa": (1e9, "GPa"), "J/m^3": (1e9, "GJ/m³"), "1/Pa": (1e-9, "1/GPa"), "kg/m^3": (1.0, "kg/m³"), "1": (1.0, "")}


def number(value, unit: str) -> str:
    """A value with its unit as a table cell."""
    if isinstance(value, str):
        return value
    scale, name = SCALES.get(unit, (1.0, unit))
    return f"{value / scale:.6g} {name}".rstrip()


def cell(text: str) -> str:
    """Text that cannot break a table or start markup."""
    return text.replace("|", "\\|").replace("\n", " ").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_").replace("^", "\\^")


def table(heads: list[str], rows: list[tuple]) -> list[str]:
    """A Markdown table."""
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def page(about: dict, picture: str | None) -> str:
    """The page of one material."""
    lines = [f"# {about['title']}", "", f"`{about['name']}`, {about['category']}" +
             (f". Also: {', '.join(cell(a) for a in about['aliases'])}" if about["aliases"] else ""), ""]
    for warning in about["warnings"]:
        lines += [f":::{{warning}}\n{cell(warning)}\n:::", ""]
    laws = ", ".join(f"{family}: `{law}`" for family, law in about["laws"].items())
    lines += [f"Laws: {laws}. Range of the data: {cell(about['reach'])}.", ""]
    if picture:
        lines += [f"![Hugoniots of {cell(about['title'])}]({picture})", ""]
    sources: dict[tuple[str, str], int] = {}
    rows = []
    for c in about["constants"]:
        reference = ""
        if c["status"] != "default":
            reference = f"[{sources.setdefault((c['source'], c['via']), len(sources) + 1)}]"
        rows.append((f"`{c['quantity']}`", number(c["value"], c["unit"]), reference, c["mark"]))
    lines += ["## Constants", "", *table(["constant", "value", "source", "mark"], rows)]
    lines += [f"{k}. {cell(source)}" + (f"<br>{cell(where_read(via))}" if via else "") for (source, via), k in sources.items()] + [""]
    if about["derived"]:
        rows = [(f"`{k}`", number(q["value"], q["unit"]), cell(q["meaning"])) for k, q in about["derived"].items()]
        lines += ["## Derived", "", *table(["quantity", "value", "how"], rows)]
    if about["fits"]:
        lines += ["## Measured states, fitted by the package", "", *(f"* {cell(line)}" for line in about["fits"]), ""]
    lines += ["## Choices", "", *(f"* **{family}**: {cell(reason)}" for family, reason in about["reasons"].items()), ""]
    lines += ["## What is missing", "", *(f"* {cell(text)}" for text in about["missing"]), ""]
    if about["notes"]:
        lines += ["## Notes", "", *(f"* {cell(text)}" for text in about["notes"]), ""]
    if about["others"]:
        rows = [(o["row"], o["family"], cell(o["summary"]), cell(o["source"]) + "".join(f"<br>**{cell(m)}**" for m in o["marks"]))
                for o in about["others"]]
        lines += ["## Other sources", "", *table(["row", "for", "constants", "source"], rows)]
    return "\n".join(lines)


def draw(entry, target: Path) -> str | None:
    """The picture of a material's Hugoniots; None where it has none from rest (products only)."""
    try:
        chosen = comparison([entry])
    except HugoniotError:
        return None
    if not chosen.curves:
        return None
    compare_figure(chosen, target / f"{entry.name}.png")
    return f"{entry.name}.png"


def index(entries: list, laws: dict[str, dict]) -> str:
    """The table of all pages with the counts of the library; laws {material: {family: law}}."""
    counts = summary()
    lines = ["# The materials", "", f"{counts['curated_materials']} curated materials, {counts['searchable_materials']} searchable, "
             f"{counts['rows']} rows, {counts['measured_states']} measured states. "
             f"{counts['rows_unverified_against_print']} rows are unverified against print and say so wherever they appear.", ""]
    heads = ("material", "kind", "density, kg/m³", "c0, m/s", "s", "strength", "spall strength", "state law")
    lines += ["Click on a heading to sort; type to filter.", "",
              "```{raw} html", '<input class="filter" type="search" placeholder="filter, such as metal or steinberg" '
              'aria-label="Filter the materials">', "```", "",
              *table(list(heads), [row(e, laws[e.name]) for e in entries]),
              "```{toctree}", ":hidden:", "", *(e.name for e in entries), "```", ""]
    return "\n".join(lines)


def row(entry, laws: dict) -> tuple:
    """A material's line in the table of all."""
    def constant(law, *names):
        return next((f"{getattr(law, name):.5g}" for name in names if isinstance(getattr(law, name, None), float)), "")

    eos, spall = entry.material.eos, getattr(entry.material.fracture, "strength", None)
    return (f"[{cell(entry.name)}]({entry.name}.md)", entry.category, constant(eos, "rho0"), constant(eos, "c0"), constant(eos, "s", "s1"),
            cell(laws.get("strength", "")), f"{spall / 1e9:.3g} GPa" if spall else "", cell(laws.get("eos", "")))


def main(names: list[str]) -> None:
    """Write the pages of the named materials, or of all."""
    TARGET.mkdir(parents=True, exist_ok=True)
    entries = library.find_all()
    about = {entry.name: described(entry) for entry in entries}
    for entry in entries:
        if not names or entry.name in names:
            (TARGET / f"{entry.name}.md").write_text(page(about[entry.name], draw(entry, TARGET)), encoding="utf-8")
    (TARGET / "index.md").write_text(index(entries, {name: found["laws"] for name, found in about.items()}), encoding="utf-8")
    sys.stdout.write(f"wrote {TARGET}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
