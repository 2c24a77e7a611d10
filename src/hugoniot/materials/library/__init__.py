"""The material and explosives library: `find(name)` gives a `Material`, `entry(name)` everything known about it.

`index.csv` lists the curated materials with the names people type; `curated/<name>.toml` holds the choices and their reasons;
`data/*.csv` holds every number with its source (see `materials.schema`). No file is read before it is needed.
"""

import csv
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from hugoniot.core.registry import UnknownName
from hugoniot.errors import DeckError, DeckProblem
from hugoniot.materials import cards, schema, static_compression
from hugoniot.materials.entry import Entry, make_entry, read_file
from hugoniot.materials.material import Material
from hugoniot.materials.reach import far_begin
from hugoniot.materials.search import matches, nearest, parts, spelling

HERE = Path(__file__).parent
MAKE_MATERIALS = ("us_up", "jwl", "tillotson", "compression", "gases")  # tables whose single rows are equations of state


class UnknownMaterial(DeckError, UnknownName):
    """A name the library does not know; the message offers the nearest ones."""

    def __str__(self) -> str:
        return DeckError.__str__(self)


@dataclass(frozen=True)
class Listing:
    """One line of the list: a curated material, or all rows of one name that nobody has curated."""

    name: str
    category: str
    title: str
    aliases: tuple[str, ...]
    rows: tuple[str, ...] = ()
    curated: bool = True


@cache
def index() -> dict[str, Listing]:
    """The curated materials by name."""
    with open(HERE / "index.csv", newline="", encoding="utf-8") as file:
        rows = csv.DictReader(file)
        return {r["name"]: Listing(r["name"], r["category"], r["title"], tuple(a.strip() for a in r["aliases"].split(";") if a.strip()))
                for r in rows}


@cache
def spellings() -> dict[str, str]:
    """Every accepted spelling of the curated materials -> name."""
    found: dict[str, str] = {}
    for listing in index().values():
        for text in (listing.name, listing.title, *listing.aliases):
            taken = found.setdefault(spelling(text), listing.name)
            if taken != listing.name:
                raise ValueError(f"the name '{text}' stands for two materials of the library: {taken} and {listing.name}")
    return found


@cache
def _by_parts() -> dict[tuple[str, ...], str | None]:
    """The parts of every accepted name, in any order -> name; None where two materials share them."""
    found: dict[tuple[str, ...], str | None] = {}
    for listing in index().values():
        for text in (listing.name, listing.title, *listing.aliases):
            key = parts(text)
            found[key] = listing.name if found.get(key, listing.name) == listing.name else None
    return found


def curated_name(name: str) -> str | None:
    """The curated material a name stands for: by its spelling, or by its parts in another order where nothing else has that name."""
    known = spellings().get(spelling(name))
    if known is not None or spelling(name) in uncurated() or schema.is_row(name.strip().upper()):
        return known
    return _by_parts().get(parts(name))


@cache
def uncurated() -> dict[str, tuple[str, ...]]:
    """Spelling -> ids of the equation-of-state rows under that name, for names that are not curated.

    Rows of slow compression stand aside where the same name has shock data: they serve for comparison.
    """
    found: dict[str, list[str]] = {}
    for name in MAKE_MATERIALS:
        shocked = frozenset(found) if name == "compression" else frozenset()
        for row in schema.table(name).values():
            key = spelling(row.material)
            if key not in spellings() and key not in shocked:
                found.setdefault(key, []).append(row.id)
    return {k: tuple(v) for k, v in found.items()}


def names() -> list[str]:
    """Names of the curated materials."""
    return list(index())


def find(name: str, brief: bool = False) -> Material:
    """Return a `Material` of the library.

    name    name or alias, such as "copper" or "Cu"; or the id of a row, such as "U007", for a material of this row's constants alone
    brief   whether the search for similar names, which the error message offers, is skipped

    Raises `UnknownMaterial`, a `DeckError`, for an unknown name.

    >>> copper = hugoniot.materials.library.find("copper")
    """
    return entry(name, brief=brief).material


def entry(name: str, also: Mapping[str, str] | None = None, brief: bool = False) -> Entry:
    """As `find`, with title, reasons, what is missing, unreacted explosive and detonation data.

    also   further names the message for an unknown one may offer: spelling -> name
    """
    known = curated_name(name)
    if known is not None:
        return _curated(known)
    if schema.is_row(name.strip().upper()):
        return _of_row(name.strip().upper())
    explosive = spellings().get(spelling(name).removesuffix("reactive"))
    if explosive is not None:
        return _reactive(explosive)
    breaking = curated_name(re.sub(r"[\s_-]+with[\s_-]+spall$", "", name)) if spelling(name).endswith("withspall") else None
    if breaking is not None:
        return _with_spall(breaking)
    rows = uncurated().get(spelling(name), ())
    if len(rows) == 1:
        return _of_row(rows[0])
    raise _unknown(name, rows, also or {}, brief)


def find_all() -> list[Entry]:
    """Every curated material."""
    return [_curated(name) for name in index()]


def search(text: str) -> list[Listing]:
    """Curated materials, their variants with spall, and uncurated rows whose names, aliases, category or row ids hold every word."""
    return [hit for hit in (*listings(), *_variants()) if matches(text, (hit.name, hit.title, hit.category, *hit.aliases, *hit.rows))]


def listings() -> Iterator[Listing]:
    """Everything searchable: curated materials, then names found in the tables only."""
    yield from index().values()
    for rows in uncurated().values():
        first = schema.row(rows[0])
        kind = str(first.get("category", {"jwl": "explosive", "gases": "gas"}.get(first.table, "mineral/rock")))
        yield Listing(first.material, kind, first.material, (), rows, curated=False)


@cache
def _curated(name: str) -> Entry:
    path = HERE / "curated" / f"{name}.toml"
    listing, tables = index()[name], read_file(path)
    made = make_entry(name, tables, path.name, title=listing.title, category=listing.category, aliases=listing.aliases)
    return _warned(made, _branch(name, tables["eos"].get("row")))


def spall_row(name: str) -> str | None:
    """The row of the measured spall strength of a curated material, None where the library has none that belongs to it."""
    return read_file(HERE / "curated" / f"{name}.toml").get("spall")


@cache
def _with_spall(name: str) -> Entry:
    """A curated material with a fracture law: the spall strength measured for it, as a tension at which it separates."""
    plain, row = _curated(name), spall_row(name)
    if plain.material.fracture is not None:
        return plain
    if row is None:
        known = ", ".join(other for other in index() if spall_row(other))
        raise UnknownMaterial([DeckProblem("library", None, "material", f"the library has no measured spall strength for '{name}'",
                                           f"measured ones are available for {known}; or add a fracture law to the deck")])
    tables = read_file(HERE / "curated" / f"{name}.toml")
    reason = "The strength was measured in plate impacts. Spall strengths grow with the rate of unloading and depend on the microstructure."
    tables |= {"fracture": {"law": "spall_stress", "strength": f"{row}.spall_strength", "reason": reason},
               "title": f"{plain.title}, with spall", "missing": [text for text in plain.missing if "with spall" not in text]
               or ["The change of the spall strength with rate and temperature is not included."]}
    made = make_entry(f"{name}_with_spall", tables, f"{name}.toml and row {row}", category=plain.category)
    return _warned(made, _branch(name, tables["eos"].get("row")))


@cache
def _variants() -> tuple[Listing, ...]:
    """The materials that `with spall` makes of curated ones."""
    return tuple(Listing(f"{name} with spall", known.category, f"{known.title}, with spall", (), (row,))
                 for name, known in index().items() if (row := spall_row(name)))


@cache
def _reactive(name: str) -> Entry:
    """An explosive with the ignition-and-growth set of the library: reactant, products and rate of one calibration."""
    plain = _curated(name)
    row = plain.detonation.get("ignition_growth")
    if row is None:
        known = [n for n, listing in index().items() if listing.category == "explosive" and "ignition_growth" in _curated(n).detonation]
        hint = f"sets are available for {', '.join(known)}"
        raise UnknownMaterial([DeckProblem("library", None, "material", f"the library has no rate constants for '{name}'", hint)])
    reason = f"These are the constants of row {row.value}: unreacted explosive, products and rate were calibrated together."
    tables = {**{family: {"row": row.value, "reason": reason} for family in ("eos", "unreacted", "burn")},
              "title": f"{plain.title}, reactive", "missing": list(plain.missing), "aliases": []}
    return replace(make_entry(f"{name}_reactive", tables, f"row {row.value}", category=plain.category), detonation=plain.detonation)


@cache
def _of_row(identity: str) -> Entry:
    row = schema.row(identity)
    if row.table == "ignition_growth":
        return _of_set(row)
    if row.table not in MAKE_MATERIALS:
        raise DeckError.single("library", None, identity, f"a row of the table {row.table} is not a material by itself")
    try:
        cards.card(row)
    except ValueError as error:
        raise DeckError.single("library", None, identity, str(error), f"hugoniot material show {identity} prints the row") from error
    tables: dict = {"eos": {"row": identity}, "title": f"{row.material} (row {identity})"}
    if "up_max" in row:
        tables["valid_up_to"] = f"{identity}.up_max"
    elif row.table == "compression" and (limit := static_compression.reach(row)):
        tables["valid_up_to"] = limit
    made = make_entry(identity, tables, f"row {identity}", category=str(row.get("category", "")))
    warnings = [f"row {identity} is used as published: it is an equation of state without a strength or fracture law"]
    warnings += _branch(row.material, identity)
    if row.table == "compression":
        warnings.append(f"{row.title} is a fit to static compression of one phase; a shock strong enough to transform or melt this phase "
                        "follows a different Hugoniot")
    return replace(_warned(made, warnings), curated=False)


def _branch(name: str, identity: str | None) -> list[str]:
    """What is said of a material whose line holds on the far side of a transition only."""
    row = schema.row(identity) if identity else None
    begin = far_begin(row) if row else 0.0
    if row is None or not begin:
        return []
    what, fitted = f"row {identity} ({name})", row.status == "derived"
    starts = f"the data of {what} begin"
    if "states" in row and not fitted:      # its source states no range
        starts = f"the measured states with which {what} is compared begin"
    elif fitted and "states" not in row:    # to another curve
        starts = f"the fit of {what} begins"
    return [f"{starts} at a particle velocity of {begin:g} m/s; weaker shocks may follow another branch of the Hugoniot"]


def _warned(made: Entry, warnings: Iterable[str]) -> Entry:
    """With more to say than its rows' marks."""
    return replace(made, material=replace(made.material, warnings=(*warnings, *made.material.warnings)))


def _of_set(row: schema.Row) -> Entry:
    """An ignition-and-growth set as it stands: reactant, products and rate."""
    reason = f"These are the constants of row {row.id}: unreacted explosive, products and rate were calibrated together."
    tables: dict = {**{family: {"row": row.id, "reason": reason} for family in ("eos", "unreacted", "burn")},
                    "title": f"{row.material} (set {row.id})"}
    try:
        made = make_entry(row.id, tables, f"row {row.id}", category="explosive")
    except DeckError as error:
        raise DeckError.single("library", None, row.id, f"the set {row.id} ({row.material}) does not make a material: "
                               f"{error.problems[0].message}", f"hugoniot material show {row.id} lists its contents") from error
    return replace(made, curated=False)


def pop_lines(name: str) -> tuple[schema.Row, ...]:
    """Measured Pop plots of an explosive: rows with log10(p/GPa) = a + b log10(x/mm); empty where the library has none."""
    if schema.is_row(name.strip().upper()):
        name = schema.row(name.strip().upper()).material
    texts = (name, name.split(" (")[0], *name.split(" (")[0].split("/"))
    known = {curated_name(part) or curated_name(spelling(part).removesuffix("reactive")) for part in texts} - {None}
    return tuple(row for row in schema.table("pop_plot").values() if row["explosive"] in known)


def windows(name: str) -> tuple[schema.Row, ...]:
    """Optical rows of a window a gauge looks through: index at rest, or apparent against true velocity; empty where there are none.

    A window whose index is linear in density, n = a + b rho, shows the interface at a times its velocity, whatever the loading (Hayes).
    """
    known = curated_name(name) or spelling(name)
    return tuple(row for row in schema.table("windows").values() if (curated_name(row.material) or spelling(row.material)) == known)


def _brief(source: str) -> str:
    return source if len(source) <= 50 else f"{source[:47].rsplit(' ', 1)[0]} ..."


def _unknown(name: str, rows: tuple[str, ...], also: Mapping[str, str], brief: bool) -> UnknownMaterial:
    if rows:
        hint = f"choose one of them by its row: {', '.join(f'{i} ({_brief(schema.row(i).source)})' for i in rows)}"
        message = f"'{name}' is not a curated material, and the library has it from {len(rows)} sources"
    else:
        known = {} if brief else {**also, **spellings(), **{k: schema.row(v[0]).material for k, v in uncurated().items()}}
        near = nearest(name, known) if known else []
        message = f"unknown material '{name[:60]}'"
        hint = f"nearest: {', '.join(near)}" if near else "hugoniot material list shows the library"
    return UnknownMaterial([DeckProblem("library", None, "material", message, hint)])
