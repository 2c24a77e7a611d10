"""One material of the library or of a user's file: choices, reasons, what is missing, and the `Material` built from them.

A file `<name>.toml` holds, beside the tables of a deck (`[eos]`, `[strength]`, `[fracture]`, `[burn]`),

    title, missing, notes             words for the reader; `missing` lists what no source in the library gives
    valid_up_to                       highest particle velocity the data reach
    [eos] row = "U007"                the constants of one row of the library; further keys of the table replace single ones
    [eos] reason = "..."              why this choice (also under strength, fracture, burn, unreacted)
    [eos] others = ["U058", ...]      rows of other sources, for comparison
    [unreacted] row = "J049"          the unreacted explosive, as another equation of state
    [detonation]                      velocity, pressure, gurney_velocity, ignition_growth = "G001" (the row of a rate law)

and a value anywhere may be a number in SI, a text with a unit, a cell of the library ("S088.spall_strength"), or a table
{ value = "3.94 km/s", source = "...", via = "...", status = "...", note = "..." }.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from hugoniot.core.registry import Registry
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import read_text, toml_tables, toml_trouble
from hugoniot.materials import cards, schema, table_law
from hugoniot.materials.build import assembled, doubts
from hugoniot.materials.collect import Collector
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.marks import marks
from hugoniot.materials.material import Material, Source
from hugoniot.materials.tables import families

WORDS = ("title", "category", "aliases", "missing", "notes", "unreacted", "detonation", "spall")
DETONATION = {"velocity": "m/s", "pressure": "Pa", "gurney_velocity": "m/s", "ignition_growth": "text"}
_PROVENANCE = ("source", "via", "status", "note")


@dataclass(frozen=True)
class Entry:
    """A material with everything a reader wants to know about it.

    reasons      family -> why this law and these constants
    others       family -> ids of rows of other sources
    unreacted    parameters of the equation of state of the unreacted explosive
    rate         parameters of a rate law for reactive flow (ignition and growth), with `unreacted` and the products in material.eos
    detonation   name -> Source: measured velocity (m/s), CJ pressure (Pa), Gurney velocity (m/s), id of an ignition-and-growth row
    rows         ids of the rows the constants come from, in order of first use
    curated      False for a material made of a single row, without a person's choice
    """

    name: str
    title: str
    category: str
    material: Material
    aliases: tuple[str, ...] = ()
    reasons: Mapping[str, str] = field(default_factory=dict)
    others: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    missing: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    unreacted: Any = None
    rate: Any = None
    detonation: Mapping[str, Source] = field(default_factory=dict)
    rows: tuple[str, ...] = ()
    file: str = ""
    curated: bool = True

    def comparison_rows(self) -> tuple[str, ...]:
        """Rows used and rows of other sources."""
        return tuple(dict.fromkeys((*self.rows, *(i for ids in self.others.values() for i in ids))))


def read_file(path: Path) -> dict:
    """The parsed TOML of a material file; FileTrouble or DeckError where it cannot be read."""
    try:
        text = read_text(path)
    except OSError as error:
        raise FileTrouble(f"cannot read the material file {path}: {error.strerror or error}") from error
    except UnicodeDecodeError:
        raise DeckError.single(path, None, "material", "not a UTF-8 text file", "a material file is a TOML file") from None
    try:
        return toml_tables(text)
    except tomllib.TOMLDecodeError as error:
        line, message, hint = toml_trouble(error, text)
        raise DeckError.single(path, line, "material", message, hint) from error
    except ValueError as error:
        raise DeckError.single(path, None, "material", f"not a material file: {error}") from None


def make_entry(name: str, tables: dict, file: str, line_of=None, base: Material | None = None, **words) -> Entry:
    """The entry of the library described by the tables of one material, which override `base`; DeckError with every problem found."""
    collector = Collector([], file, line_of or (lambda path: None))
    entry = read_entry(name, tables, collector, base, **words)
    if entry is None:
        raise collector.error()
    return replace(entry, material=replace(entry.material, library=name))


def read_entry(name: str, tables: dict, collector: Collector, base: Material | None = None, **words) -> Entry | None:
    """As `make_entry`, for a caller that has its collector, which gets the problems; None where there are any."""
    return _Reader(name, collector, base).read(tables, words)


class _Reader:
    """Resolves rows, cells and sourced values to plain tables, remembers the sources, and hands the tables to the deck's reader."""

    def __init__(self, name: str, collector: Collector, base: Material | None):
        self.name, self.file, self.collector, self.before = name, collector.file, collector, collector.findings
        self.sources: list[Source] = []
        self.reasons: dict[str, str] = {}
        self.others: dict[str, tuple[str, ...]] = {}
        self.marks: list[str] = []
        self.rows: list[str] = []
        self.base = base
        self.listed: set[str] = set()

    def read(self, tables: dict, words: dict) -> Entry | None:
        plain = {k: v for k, v in tables.items() if k not in WORDS}
        listed = tables.get("sources", ())
        self.listed = {s["quantity"] for s in listed if isinstance(s, dict) and "quantity" in s} if isinstance(listed, list) else set()
        known = families()
        for family in known:
            if isinstance(plain.get(family), dict):
                plain[family] = self.law(family, dict(plain[family]))
        valid = plain.get("valid_up_to")
        if isinstance(valid, (str, dict)):
            plain["valid_up_to"] = self.value("valid_up_to", valid, "m/s")
        self.check_words(tables)
        unreacted = self.unreacted(known["eos"], tables.get("unreacted"))
        detonation = self.detonation(tables.get("detonation", {}))
        rate = None
        if "ignition_growth" in detonation:
            rate = read_law(known["burn"], self.law("rate", {"row": detonation["ignition_growth"].value}), self.collector,
                            ("material", self.name, "detonation"))
        material = assembled(self.name, plain, self.base, self.collector, ("material", self.name))
        if material is None or self.collector.findings > self.before:
            return None
        warnings = tuple(dict.fromkeys((*material.warnings, *self.marks, *(doubts(unreacted) if unreacted is not None else ()))))
        replaced = {source.quantity for source in self.sources}
        inherited = (source for source in material.sources if source.quantity not in replaced)
        material = replace(material, sources=(*inherited, *self.sources), warnings=warnings, unreacted=unreacted or material.unreacted)
        said = {k: tables.get(k, words.get(k, d)) for k, d in (("title", self.name), ("category", "user"), ("aliases", ()))}
        return Entry(self.name, said["title"], said["category"], material, _lines(said["aliases"]), self.reasons, self.others,
                     _lines(tables.get("missing", ())), _lines(tables.get("notes", ())), material.unreacted, rate, detonation,
                     tuple(dict.fromkeys(self.rows)), self.file)

    def check_words(self, tables: dict) -> None:
        """The keys for readers hold texts, or lists of texts."""
        path = ("material", self.name)
        for key in ("title", "category"):
            if not isinstance(tables.get(key, ""), str):
                self.collector.add((*path, key), "expected a string")
        for key in ("aliases", "missing", "notes"):
            if not _texts(tables.get(key, ())):
                self.collector.add((*path, key), "expected a string or a list of strings")
        for key in ("unreacted", "detonation"):
            if not isinstance(tables.get(key, {}), dict):
                self.collector.add((*path, key), "expected a table", f"write [{key}]")

    def law(self, family: str, table: dict) -> dict:
        """The table of one law with every value plain: SI numbers, or texts with units that the deck's reader takes."""
        path = ("material", self.name, family)
        if family != "rate":
            self.reasons[family] = str(table.pop("reason", ""))
            others = table.pop("others", ())
            if not _texts(others):
                self.collector.add((*path, "others"), "expected a list of rows, such as [\"U002\"]")
                others = ()
            self.others[family] = _lines(others)
        for identity in self.others.get(family, ()):
            if not schema.is_row(identity):
                self.collector.add((*path, "others"), f"the library has no row '{identity}'")
        kind = {"unreacted": "eos", "rate": "burn"}.get(family, family)
        card = self.card(path, table.pop("row"), "burn" if family == "rate" else family) if "row" in table else {}
        return self.plain(family, kind, {**card, **table})

    def plain(self, place: str, family: str, merged: dict) -> dict:
        """Every value of a law table resolved; `place` names the table in the list of sources."""
        units = self.units(family, merged.get("law"))
        heat = merged.get("specific_heat")
        tabulated = heat if isinstance(heat, str) and heat.endswith(".heat_capacity") and schema.is_row(heat.split(".")[0]) else None
        if tabulated:
            del merged["specific_heat"]
        found = {k: v if k == "law" else self.inner(f"{place}.{k}", v) if isinstance(v, dict) and "row" in v
                 else self.value(f"{place}.{k}", v, units.get(k, "1")) for k, v in merged.items()}
        if tabulated and "heat_capacity" not in schema.row(tabulated.split(".")[0]):
            self.collector.add(("material", self.name, *place.split("."), "specific_heat"), f"the library has no value '{tabulated}'",
                               f"hugoniot material show {tabulated.split('.')[0]} lists the values of the row")
        elif tabulated:
            row = schema.row(tabulated.split(".")[0])
            self.use(row, "heat_capacity")
            scales = [s.value for n in ("gamma0", "c0") for s in self.sources if s.quantity == f"{place}.{n}"]
            heat = cards.specific_heat(row, *scales) if len(scales) == 2 and None not in scales else row.constant("heat_capacity")
            found["specific_heat"] = self.value(f"{place}.specific_heat", heat, "J/kg/K")
        return found

    def inner(self, place: str, table: dict) -> dict:
        """The law inside another one, as the solid of a porous law, of a row and what replaces its values."""
        return self.plain(place, "eos", {**self.card(("material", self.name, *place.split(".")), table["row"], "eos"),
                                         **{k: v for k, v in table.items() if k != "row"}})

    def card(self, path: tuple, identity: Any, family: str) -> dict:
        if not (isinstance(identity, str) and schema.is_row(identity)):
            self.collector.add((*path, "row"), f"the library has no row '{identity}'", "hugoniot material search finds rows")
            return {}
        row = schema.row(identity)
        try:
            found = cards.card(row, family)
        except ValueError as error:
            self.collector.add((*path, "row"), str(error))
            return {}
        self.use(row)
        return found

    def use(self, row: schema.Row, constant: str = "") -> None:
        """Remember that a row is used, or one constant of it alone, and what must be seen wherever it is."""
        self.rows.append(row.id)
        self.marks += marks(row, constant)

    def value(self, quantity: str, value: Any, unit: str) -> Any:
        """Resolve one value, remembering its source under the name `quantity`."""
        if isinstance(value, Source):
            self.sources.append(replace(value, quantity=quantity))
            return value.value
        path = ("material", self.name, *quantity.split("."))
        if isinstance(value, str):
            try:
                found = schema.cell(value)
            except KeyError:
                self.collector.add(path, f"the library has no value '{value}'",
                                   f"hugoniot material show {value.split('.')[0]} lists the values of the row")
                return value
            if found is not None and found.unit != unit:
                self.collector.add(path, f"the library's value '{value}' is in {found.unit}, not in {unit}")
                return value
            if found is not None:
                row, _, constant = value.partition(".")
                self.use(schema.row(row), constant)
                return self.value(quantity, found, unit)
        if isinstance(value, dict) and "value" in value:
            return self.sourced(quantity, value, unit, path)
        if isinstance(value, (str, int, float)) and not isinstance(value, bool):
            number = self.collector.quantity(path, value, unit) if unit != "text" else value
            if number is not None and unit != "text" and quantity not in self.listed:
                self.sources.append(Source(quantity, number, unit, "not stated", self.file, "user"))
        return value

    def sourced(self, quantity: str, table: dict, unit: str, path: tuple) -> Any:
        for key in table:
            if key not in ("value", *_PROVENANCE):
                self.collector.unknown((*path, key), ("value", *_PROVENANCE))
        number = table["value"] if unit == "text" else self.collector.quantity((*path, "value"), table["value"], unit)
        said = {k: str(table.get(k, d)) for k, d in zip(_PROVENANCE, ("not stated", self.file, "user", ""), strict=True)}
        if said["status"] not in (*schema.STATUSES, "user"):
            self.collector.add((*path, "status"), f"unknown status '{said['status']}'", f"known: {', '.join((*schema.STATUSES, 'user'))}")
        if said["status"] == "recalled":
            self.marks.append(f"{quantity} is {schema.UNVERIFIED} ({said['source']})")
        self.sources.append(Source(quantity, number, unit, said["source"], said["via"], said["status"], said["note"]))
        return number

    def units(self, family: str, law: Any) -> Mapping[str, str]:
        registry = families()[family]
        if law is None and self.base is not None and getattr(self.base, family) is not None:
            return registry.of(getattr(self.base, family)).units
        units = registry.get(law).units if isinstance(law, str) and law in registry.names() else {}
        return {**table_law.UNITS, **units} if law == table_law.LAW else units

    def unreacted(self, registry: Registry, table: Any) -> Any:
        if not isinstance(table, dict):
            return None
        plain = self.law("unreacted", dict(table))
        return read_law(registry, plain, self.collector, ("material", self.name, "unreacted"))

    def detonation(self, table: Mapping) -> dict[str, Source]:
        found: dict[str, Source] = {}
        for key, value in table.items() if isinstance(table, dict) else ():
            if key not in DETONATION:
                self.collector.unknown(("material", self.name, "detonation", key), tuple(DETONATION))
                continue
            before = len(self.sources)
            if key != "ignition_growth":
                if isinstance(value, bool) or not isinstance(value, (int, float, str, dict)):
                    self.collector.quantity(("material", self.name, "detonation", key), value, DETONATION[key])
                    continue
                self.value(f"detonation.{key}", value, DETONATION[key])
            else:
                if not schema.is_row(value) or value[0] != "G":
                    self.collector.add(("material", self.name, "detonation", key), f"the library has no ignition-and-growth row '{value}'")
                    continue
                row = schema.row(value)
                self.use(row)
                found[key] = Source(f"detonation.{key}", value, "text", row.source, row.via, row.status, row.note)
            if len(self.sources) > before:
                found[key] = self.sources[-1]
        return found


def _texts(value: Any) -> bool:
    """Whether a value is a text or a list of texts."""
    return isinstance(value, str) or isinstance(value, (list, tuple)) and all(isinstance(v, str) for v in value)


def _lines(value: Any) -> tuple[str, ...]:
    """A text or a list of texts as texts; anything else was reported."""
    return (value,) if isinstance(value, str) else tuple(value) if _texts(value) else ()
