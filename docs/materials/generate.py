"""Writes a page for every curated material of the library, from its data: python docs/materials/generate.py

The pages go to docs/generated/materials (not kept in the repository): the laws and their range, a picture of the Hugoniots with the
measured states, the constants with their sources, derived quantities, the reasons for the choice, what is missing, and other rows.
"""

import re
import sys
from pathlib import Path

import matplotlib

from hugoniot.dossier.curves import comparison, measured
from hugoniot.dossier.describe import described, summary
from hugoniot.dossier.wording import DERIVED, GROUPS, differences, digits, grouped, numbered, reference_name, where_read
from hugoniot.errors import HugoniotError
from hugoniot.materials import cards, library, schema
from hugoniot.materials.schema import UNVERIFIED
from hugoniot.materials.tables import families
from hugoniot.plotting.materials import compare_figure
from hugoniot.problem.explosives import TOLERATED

matplotlib.use("Agg")
HERE = Path(__file__).parent
TARGET = HERE.parent / "generated" / "materials"
INVERSE = re.compile(r"1/\(?([A-Za-z]+)(?:\^([yz]))?(?: ([A-Za-z]+)\))?")     # a unit such as 1/s or 1/(Pa^y s)
SCALES = {"Pa": (1e9, "GPa"), "J/m^3": (1e9, "GJ/m³"), "1/Pa": (1e-9, "1/GPa"), "kg/m^3": (1.0, "kg/m³"), "1": (1.0, ""),
          "J/kg/K": (1.0, "J/(kg K)")}
RAISED = str.maketrans("0123456789yz", "⁰¹²³⁴⁵⁶⁷⁸⁹ʸᶻ")
RATE = ("These belong to the variant `material = \"{name} reactive\"`, which replaces the programmed burn by ignition and growth "
        "and has the equations of state of its own set (`hugoniot material show \"{name} reactive\"` prints them). In the "
        "units, {powers}.")
ROWS = "These rows of the library are for the same material or a similar one (column *material*){used}. {use}"
FILE = ("\"The file\" beside a row is the public file from which the row was taken: `hugoniot material show {example}` names that of "
        "{example}.")
RULE = (" The library takes the stated velocity where it is at most {:.2g} % below and at most {:.2g} % above the CJ velocity of the "
        "products, and the CJ velocity otherwise ([reason](../../theory/detonation.md#programmed-burn)).")
LACKS = "Where an entry says that the library has no data, it means none for this material."
RECALLED = "Data marked \"not checked\" were quoted from memory, without consulting the publication named."
UNNAMED = re.compile(r"\b[Tt]he file\b(?! [\w-]+\.\w)")     # "the file" without its name


def number(value, unit: str, count: int = 0) -> str:
    """A value with its unit as a table cell; to some digits if `count` says so."""
    if isinstance(value, str):
        return f"`{value}`"
    scale, name = SCALES.get(unit, (1.0, unit))
    if unit == "J/kg" and abs(value) >= 1e6:
        scale, name = 1e6, "MJ/kg"
    if unit == "Pa" and abs(value) < 1e6:
        scale, name = 1e3, "kPa"
    if match := INVERSE.fullmatch(name):
        name = f"{match[1]}⁻{(match[2] or '1').translate(RAISED)}" + (f" {match[3]}⁻¹" if match[3] else "")
    text = digits(value / scale, count) if count == 4 else f"{value / scale:.{count or 6}g}"
    return f"{powers(text)} {name}".rstrip()


def powers(text: str) -> str:
    """Numbers such as 1.2e-05 as 1.2 × 10⁻⁵."""
    return re.sub(r"(?<=\d)e([+-])0?(\d+)\b", lambda m: f" × 10{'⁻' if m[1] == '-' else ''}{m[2].translate(RAISED)}", text)


def cell(text: str) -> str:
    """Text that cannot break a table or start markup, with the signs that plain text lacks."""
    text = powers(text).replace("kg/m3", "kg/m³").replace("J/m3", "J/m³").replace("g/cm3", "g/cm³").replace("^2", "²")
    pieces = re.split(r"(`[^`]*`)", text.replace("|", "\\|").replace("\n", " "))
    return "".join(p if p.startswith("`") else p.replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_").replace("^", "\\^")
                   for p in pieces)


def sentence(text: str) -> str:
    """With a capital letter and a full stop."""
    text = cell(text)
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")


def table(heads: list[str], rows: list[tuple]) -> list[str]:
    """A Markdown table."""
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def page(about: dict, picture: tuple[str, bool] | None) -> str:
    """The page of one material; `picture`: the file, and whether a curve in it is dashed."""
    lines = [f"# {about['title']}", "", *_first(about)]
    for warning in about["warnings"]:
        lines += [f":::{{warning}}\n{sentence(warning)}{supplies(warning, about['constants'])}\n:::", ""]
    if picture:
        lines += [f"![Hugoniots of {cell(about['title'])}]({picture[0]})", "", caption(about, picture[1]), ""]
    lines += _constants(about) + _derived(about)
    if about["fits"]:
        lines += ["## Fits to measured states", "", "Least-squares fits made by hugoniot to the measured states in the library; ± gives "
                  "one standard deviation.", "", *(f"* {sentence(line)}" for line in about["fits"]), ""]
    lines += ["## Why these constants", "", *(f"* **{GROUPS[family].capitalize()}.** {sentence(reason)}"
                                              for family, reason in about["reasons"].items()), ""]
    lines += ["## Limitations", "", *([LACKS, ""] if any("The library has no" in text for text in about["missing"]) else []),
              *(f"* {sentence(text)}" for text in about["missing"]), ""]
    if about["notes"]:
        lines += ["## Remarks", "", *(f"* {sentence(text)}" for text in about["notes"]), ""]
    return "\n".join(lines + _others(about))


def rows_used(constants: list[dict]) -> list[str]:
    """The rows that constants come from, in order of use."""
    found = (re.search(r"\brow ([A-Z]\d{3})\b", c["note"]) for c in constants if c["quantity"] != "valid_up_to")
    return list(dict.fromkeys(match.group(1) for match in found if match))


def supplies(warning: str, constants: list[dict]) -> str:
    """Which constants come from the row that a warning names, where they are few."""
    named = re.match(r"row ([A-Z]\d{3}) ", warning)
    names = [f"`{c['quantity']}`" for c in constants if named and rows_used([c]) == [named[1]]]
    return f" Only {' and '.join(names)} {'is' if len(names) == 1 else 'are'} taken from this row." if 0 < len(names) < 3 else ""


def short(mark: str, identity: str) -> str:
    """A mark of a row in the line of that row, which has its name and source."""
    row = schema.row(identity)
    return mark.removeprefix(f"{row.title} ").removeprefix("is ").removesuffix(f" ({row.source})")


def caption(about: dict, dashed: bool) -> str:
    """What the picture shows."""
    what = "this material" if "cj_velocity" not in about["derived"] else "the unreacted explosive"
    several = any(o["row"][0] in "UT" for o in about["others"])
    text = f"Hugoniots of {what} and of other rows of the library (see below)" if several else f"Hugoniot of {what}"
    if solid := rows_used([c for c in about["constants"] if c["quantity"].startswith("eos.base.")]):
        text = f"Hugoniots of {what} and of its solid (row {solid[0]})"
    if measured(about["name"]):
        text += ", with the measured states of the library"
    return text + ("; a curve is thin and dashed outside the range of its data, where that is known." if dashed else ".")


def _first(about: dict) -> list[str]:
    """What the material is, which laws describe it, and in which range."""
    names = [f"`{a}`" for a in about["aliases"]]
    also = f" The name{'s' if names[1:] else ''} {listing(names)} give{'' if names[1:] else 's'} the same material." if names else ""
    lines = [f"This page gives the laws and constants of the library's material *{cell(about['title'])}* (category: {about['category']}). "
             f"In a deck, write `material = \"{about['name']}\"`.{also}", ""]
    rows = rows_used(about["constants"])
    if rows:
        lines += [f"The constants come from row{'s' if rows[1:] else ''} {listing(rows)} of the library. A *row* is one set of "
                  "constants from the literature or fitted by hugoniot; "
                  f"`hugoniot material show {rows[0]}` prints row {rows[0]} with its source.", ""]
    lines += ["The material is described by these laws:", ""]
    for family, law in about["laws"].items():
        folder = "eos" if family == "unreacted" else family
        what = "equation of state of the detonation products" if family == "eos" and "burn" in about["laws"] else GROUPS[family]
        text = families()[folder].get(law).summary
        lines.append(f"* {what[:1].upper() + what[1:]}: [`{law}`](../laws/{folder}/{law}.md). {sentence(text)}")
    if "does not apply" in about["reach"]:
        return [*lines, ""]
    reach = about["reach"].replace("not stated; a run", "the source of the equation of state states no range. A run")
    named = re.search(r"source of row (U\d{3})", reach)
    if named and named[1] not in rows:
        reach = reach.replace(named[0], f"{named[0]}, which this material does not use; see Remarks")
    return [*lines, "", f"**Valid range.** {sentence(reach)}", ""]


def _detonation(constants, members) -> str:
    """Which of the stated values of a detonation the laws use."""
    values = {c["quantity"]: c["value"] for c in constants}
    stated = [constants[k]["quantity"] for k in members]
    if stated == ["detonation.gurney_velocity"]:
        return "The laws do not use the Gurney velocity."
    rule = RULE.format(-100.0 * TOLERATED[0], 100.0 * TOLERATED[1]) if "detonation.velocity" in values else ""
    if values.get("burn.detonation_velocity") != values.get("detonation.velocity"):
        return f"The laws use none of these values. Programmed burn uses the value in the table of the burn law.{rule}"
    return ("Of these values the laws use only the detonation velocity, in the programmed burn; the others are for comparison."
            if len(stated) > 1 else "Programmed burn uses this value.") + rule


def _constants(about: dict) -> list[str]:
    """Tables of the constants, one per law, and the numbered list of their sources."""
    constants = about["constants"]
    marks, sources = numbered(constants)
    lines = ["## Constants", "", "The names are those used in decks and material files; numbers in brackets refer to the sources below the "
             "tables. A default value is the one that the law takes where no source gives another.", ""]
    for group, members in grouped(constants).items():
        lines += [f"### {GROUPS[group].capitalize()}", ""]
        if group == "rate":
            lines += [RATE.format(name=about["name"], powers=_exponents(constants, members)), ""]
        if group == "unreacted" and (said := _starts(constants)):
            lines += [said, ""]
        if group == "detonation":
            lines += [_detonation(constants, members), ""]
        rows = []
        for c, mark in ((constants[k], marks[k]) for k in members if not _idle(constants[k], constants)):
            few = 5 if c["status"] == "derived" or c["unit"] == "J/kg/K" else 0     # a specific heat per volume was divided by the density
            name, value = c["quantity"].removeprefix(f"{group}."), number(c["value"], c["unit"], few)
            if group == "rate" and name == "g2" and c["value"] == 0.0:
                value = "0"
            rows.append((f"`{name}`", cell(about["meanings"].get(c["quantity"], "")), value, mark, c["mark"]))
        lines += table(["name", "meaning", "value", "source", "remark"], rows)
    if sources:
        lines += ["### Sources", "", "Where a public file is named, the numbers were taken from that file, not from the publication that "
                  "it cites ([provenance](../../materials/provenance.md)).", ""]
        if any(UNNAMED.search(source) for source, _ in sources):
            lines[-2] += " \"The file\" in a source is the file from which its numbers were taken."
        if _quoted(constants):
            lines[-2] += f" {RECALLED}"
        lines += [f"{k}. {sentence(source)}" + (f" {sentence(where_read(via))}" if via else "")
                  for k, (source, via) in enumerate(sources, 1)] + [""]
    return lines


def _quoted(constants: list[dict]) -> bool:
    """Whether a constant was quoted from memory, itself or in the row that it was taken from."""
    return any(c["via"].startswith("recalled") or UNVERIFIED in c["mark"] for c in constants)


def _idle(constant: dict, constants: list[dict]) -> bool:
    """Whether a constant is the default temperature of an equation of state that computes no temperatures."""
    place, _, name = constant["quantity"].rpartition(".")
    return name == "reference_temperature" and constant["status"] == "default" and \
        not any(c["quantity"] == f"{place}.specific_heat" for c in constants)


def _exponents(constants: list[dict], members: list[int]) -> str:
    """What the exponents in the units of a rate are."""
    stated = {constants[k]["quantity"].removeprefix("rate."): constants[k]["value"] for k in members}
    return "y and z are the constants with these names" if "z" in stated and stated["g2"] else \
        "y is the constant with this name; with G2 = 0 there is no completion term"


def _starts(constants: list[dict]) -> str:
    """What uses the unreacted explosive, and at which density a region starts where the two equations of state have different ones."""
    rho0 = {c["quantity"]: c["value"] for c in constants if c["quantity"] in ("eos.rho0", "unreacted.rho0")}
    products, unreacted = rho0.get("eos.rho0"), rho0.get("unreacted.rho0")
    if unreacted is None:
        return ""
    used = "Programmed burn does not use this equation of state; `hugoniot eos` uses it for shocks in the unreacted explosive."
    if products == unreacted:
        return used
    return (f"{used} Such shocks start at {unreacted:g} kg/m³; a region with programmed burn starts at {products:g} kg/m³, the initial "
            "density for which the constants of the detonation products hold.")


def _derived(about: dict) -> list[str]:
    if not about["derived"]:
        return []
    state = about["reference"]
    at = [f"density {state['density']:.5g} kg/m³"]
    at += [f"temperature {state['temperature']:g} K"] if state["temperature"] is not None else []
    at.append("zero pressure" if abs(state["pressure"]) < 1e3 else f"pressure {state['pressure'] / 1e3:.4g} kPa")
    said = f"Computed from the constants above at the {reference_name(about)} ({', '.join(at)})."
    if "cj_velocity" in about["derived"]:
        said = "The Chapman-Jouguet (CJ) state computed from the constants of the detonation products"
        said += ", and the sound speed of the unreacted explosive." if "unreacted_sound_speed" in about["derived"] else "."
    rows = [(DERIVED[k][:1].upper() + DERIVED[k][1:], number(q["value"], q["unit"], 5 if k == "cj_velocity" else 4), cell(q["meaning"]))
            for k, q in about["derived"].items()]
    return ["## Derived quantities", "", " ".join(t for t in (said, differences(about)) if t), "",
            *table(["quantity", "value", "how it is computed"], rows)]


def _others(about: dict) -> list[str]:
    if not about["others"]:
        return []
    rows = [(o["row"], GROUPS[o["family"]], cell(o["material"]), cell(o["summary"]),
             " ".join([sentence(o["source"]), *(f"**{sentence(short(mark, o['row']))}**" for mark in o["marks"])]))
            for o in about["others"]]
    states = [o["row"] for o in about["others"] if o["family"] == "eos" and usable(o["row"])]
    curved = [o["row"] for o in about["others"] if schema.row(o["row"]).get("form") == "ulh"]
    except_for = f" (not {listing(curved)}: hugoniot has no law for {'their' if curved[1:] else 'its'} exponential form)" if curved else ""
    use = "in a material file a row can supply the constants of a single law ([your own materials](../../materials/users.md))."
    alone = (f"An equation-of-state row can be used in a deck as a material in its own right{except_for}, as in "
             f"`material = \"{states[0]}\"`; {use}") if states else use[:1].upper() + use[1:]
    taken = {o["row"]: [f"`{c['quantity']}`" for c in about["constants"] if c["quantity"] != "valid_up_to" and rows_used([c]) == [o["row"]]]
             for o in about["others"]}
    used = listing([f"{listing(names)} of row {row}" for row, names in taken.items() if names])
    used = f"; this material uses only {used}" if used else "; this material does not use them"
    unnamed = next((row for row, *_, said in rows if UNNAMED.search(said)), None)
    said = ROWS.format(used=used, use=alone) + (" " + FILE.format(example=unnamed) if unnamed else "")
    if any(schema.row(o["row"]).status == "recalled" for o in about["others"]) and not _quoted(about["constants"]):
        said += f" {RECALLED}"
    return ["## Other data", "", said, "",
            *table(["row", "for", "material", "constants", "source and remarks"], rows)]


def listing(names: list[str]) -> str:
    """Names as "a, b and c"."""
    return " and ".join(part for part in (", ".join(names[:-1]), *names[-1:]) if part)


def usable(identity: str) -> bool:
    """Whether a deck can name the row as its material."""
    try:
        return bool(cards.card(schema.row(identity)))
    except ValueError:
        return False


def draw(entry, target: Path) -> tuple[str, bool] | None:
    """The picture of a material's Hugoniots, and whether a curve is dashed; None where it has none from rest (products only)."""
    try:
        chosen = comparison([entry])
    except HugoniotError:
        return None
    if not chosen.curves:
        return None
    compare_figure(chosen, target / f"{entry.name}.png")
    return f"{entry.name}.png", any(not curve.reliable.all() for curve in chosen.curves)


def index(entries: list, laws: dict[str, dict]) -> str:
    """The table of all pages with the counts of the library; laws {material: {family: law}}."""
    counts = summary()
    lines = ["# Curated materials", "",
             f"This table lists the {counts['curated_materials']} curated materials: for each, laws and constants were chosen from the "
             f"available sources, and its page gives the reasons. The library holds {counts['rows']} sets of constants "
             f"(*rows*) from the literature or fitted by hugoniot, and {counts['measured_states']} measured shock states. "
             f"`hugoniot material search` also finds {counts['searchable_materials'] - counts['curated_materials']} other materials, for "
             f"which the library has rows that are not curated. {counts['rows_unverified_against_print']} rows were quoted from "
             "memory, without consulting the publication; a warning says \"not checked against the printed source\" if one is used "
             "([provenance](../../materials/provenance.md)).", ""]
    heads = ("material", "kind", "density, kg/m³", "c0, m/s", "s", "equation of state", "strength law", "spall strength")
    lines += ["c0 and s are the intercept of the Hugoniot Us(up) and its slope at up = 0. Click on a heading to sort; type to filter.", "",
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
            cell(laws.get("eos", "")), cell(laws.get("strength", "")), f"{spall / 1e9:.3g} GPa" if spall else "")


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
