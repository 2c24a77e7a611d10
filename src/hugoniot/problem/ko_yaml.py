"""Decks of pyKO (YAML) as decks of this package: layers of MGR, IDG, TIL and SES with HYDRO, VM and SG strength, gaps, fracture, gravity.

Format: pyKO v0.6 to v0.8, S. T. Stewart and others, github.com/ImpactsWiki/pyko, whose decks state the unit of every kind of quantity.
Tables (SES) are named by the deck, not copied: their standard file (301), in the units of the ANEOS tables that pyKO comes with.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from hugoniot.errors import DeckError
from hugoniot.materials.collect import printable
from hugoniot.problem.ko_decks import GEOMETRIES, KoDeck, Layer, check_reference, fracture_table
from hugoniot.units import UnitError, parse

LARGEST = 200_000        # characters
MOST_VALUES = 5_000      # of the text itself, and once its aliases are expanded; a deck has some hundred
LONGEST = 1_000          # characters of a value
DEEPEST = 20             # tables and arrays within each other
_KINDS = {"time": "s", "length": "m", "velocity": "m/s", "density": "kg/m^3", "pressure": "Pa", "temperature": "K", "sp_energy": "J/kg",
          "sp_heat_cap": "J/kg/K", "gravity": "m/s^2"}
_LONG = re.compile(r"\b(giga|mega|kilo|centi|milli|micro|nano|)(pascal|bar|meter|metre|second|gram|joule|kelvin)s?\b")
_PREFIX = {"giga": "G", "mega": "M", "kilo": "k", "centi": "c", "milli": "m", "micro": "u", "nano": "n", "": ""}
_SYMBOL = {"pascal": "Pa", "bar": "bar", "meter": "m", "metre": "m", "second": "s", "gram": "g", "joule": "J", "kelvin": "K"}
_UNREAD = ("name", "outputfilename", "units", "tableunits")     # keys without weight for the physics
_TABLE_UNITS = {"density": "g/cm^3", "temperature": "K", "pressure": "GPa", "sp_energy": "MJ/kg"}
_CODE_PRESSURE = 1e11    # Pa: Mbar, in which the pressure coefficient of SG is given whatever the units of the deck


def read_yaml(text: str, file: str, folders: Sequence[Path] = (Path(),)) -> KoDeck:
    """The deck in a text of YAML; folders: where the paths of its tables may begin, in this order. Raises `DeckError`."""
    if len(text) > LARGEST:
        raise DeckError.single(file, None, "deck", f"a YAML deck cannot have more than {LARGEST:,} characters".replace(",", " "))
    try:
        _check_size(text, file)
        raw = yaml.safe_load(text)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        words = printable(str(getattr(error, "problem", None) or "not readable"), 100)
        if words.startswith("could not determine a constructor"):
            words = "a value has a tag (!...) that a deck cannot contain"
        raise DeckError.single(file, mark.line + 1 if mark else None, "deck", f"not YAML: {words}") from None
    except (RecursionError, ValueError):
        raise DeckError.single(file, None, "deck", "not a deck in YAML") from None
    if _values(raw) > MOST_VALUES:
        raise DeckError.single(file, None, "deck", f"more than {MOST_VALUES} values once its aliases are expanded: too many for a deck")
    return _Reader(raw, file, folders).deck()


def _check_size(text: str, file: str) -> None:
    """Refuse a text that would keep the reader busy: a number such as 1:59:59 takes it a time that grows with the square of its length."""
    count = depth = 0
    for event in yaml.parse(text, Loader=yaml.SafeLoader):
        count += isinstance(event, yaml.NodeEvent)
        depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
        wrong = (f"more than {MOST_VALUES} values are too many" if count > MOST_VALUES else
                 "tables and arrays nested too deeply" if depth > DEEPEST else
                 f"a value has more than {LONGEST} characters" if len(getattr(event, "value", "")) > LONGEST else "")
        if wrong:
            raise DeckError.single(file, event.start_mark.line + 1, "deck", f"not a deck: {wrong}")


def _values(raw: Any) -> int:
    """How many values a text holds once its aliases are expanded, which a few lines can make millions; counted up to `MOST_VALUES`."""
    waiting, count = [raw], 0
    while waiting and count <= MOST_VALUES:
        value = waiting.pop()
        count += 1
        waiting += value.values() if isinstance(value, dict) else value if isinstance(value, (list, tuple, set)) else ()
    return count


class _Given(dict):
    """A table of theirs that remembers which of its keys were asked for."""

    def __init__(self, table: dict):
        super().__init__(table)
        self.asked: set = set()

    def get(self, key, default=None):
        self.asked.add(key)
        return super().get(key, default)


class _Reader:
    def __init__(self, raw: Any, file: str, folders: Sequence[Path]):
        self.file, self.folders, self.tables = file, folders, {}
        self.raw = self.table(raw, "deck")
        self.units = {name: _LONG.sub(lambda m: _PREFIX[m[1]] + _SYMBOL[m[2]], str(unit))
                      for name, unit in self.table(raw.get("units"), "units").items()}

    def deck(self) -> KoDeck:
        keys = [key for key in self.raw if re.fullmatch(r"mat\w*", str(key))]
        if not keys:
            raise self.wrong("mat1", "no layer is given")
        ends = self.table(self.raw.get("boundaries"), "boundaries")
        left: list[str] = []
        layers = tuple(self.layer(key, left) for key in keys)
        geometry = self.raw.get("geometry", "PLA")
        if geometry not in ("PLA", "CYL", "SPH"):
            raise self.wrong("geometry", f"'{printable(str(geometry), 30)}' is not PLA, CYL or SPH")
        if self.raw.get("pvoid"):
            left.append("pvoid is left out: a void has no pressure")
        deck = KoDeck(str(self.raw.get("name", "")), GEOMETRIES[geometry], self.number(self.raw, "tstop", "time"), layers,
                      (self.end(ends, "ibc", "ip0"), self.end(ends, "obc", "op0")), self.number(self.raw, "dtoutput", "time", 0.0) or None,
                      self.number(self.raw, "dtstart", "time", 0.0) or None, self.number(self.raw, "gravity", "gravity", 0.0), left)
        if unused := self.unused(keys):
            left.append(f"not used: {', '.join(unused[:20])}" + (" and more" if len(unused) > 20 else ""))
        return deck

    def unused(self, layers: list[str]) -> list[str]:
        """Keys of their deck that mean nothing here; a key misspelt is one of them."""
        found = []
        for name, table in self.tables.items():
            if name == "units":
                continue      # of kinds that this deck may not have
            known = {*table.asked, *(_UNREAD if name == "deck" else ()), *(layers if name == "deck" else ())}
            found += [printable(str(key) if name == "deck" else f"{name}.{key}", 60) for key in table if key not in known]
        return found

    def layer(self, key: str, left: list[str]) -> Layer:
        here = self.table(self.raw[key], key)
        mesh, start = self.table(here.get("mesh"), f"{key}.mesh"), self.table(here.get("init"), f"{key}.init")
        eos = self.table(here.get("eos"), f"{key}.eos")
        density = self.number(start, "rho0", "density", where=key)
        if not density > 0.0:
            raise self.wrong(f"{key}.init.rho0", f"{density:g} kg/m^3 is not a density")
        tables: dict[str, Any] = {"eos": self.eos(eos, start, density, key)}
        if (strength := self.strength(self.table(here.get("str"), f"{key}.str"), eos, density, key)) is not None:
            tables["strength"] = strength
        breaks = here.get("frac")
        if breaks is not None and tables["eos"]["law"] != "ideal_gas":
            table = self.table(breaks, f"{key}.frac")
            least, limit = self.number(table, "nrhomin", None, 0.8, where=key), self.number(table, "pfrac", "pressure", where=key)
            for name, value in (("nrhomin", least), ("pfrac", limit)):
                if value < 0.0 or name == "nrhomin" and value == 0.0:
                    raise self.wrong(f"{key}.frac.{name}", f"{value:g} is not a valid limit",
                                     "pfrac is a tension, nrhomin a density over rho0, and both are positive")
            if (fracture := fracture_table(limit, least)) is not None:
                tables["fracture"] = fracture
        if here.get("gravity") is not None:
            left.append(f"{key}: the initial equilibrium with gravity is left out; [region.profile] can give the pressure over position")
        return Layer(str(eos.get("name", key)), self.number(mesh, "xstart", "length", where=key),
                     self.number(mesh, "length", "length", where=key), self.cells(mesh, key),
                     self.number(start, "up0", "velocity", 0.0, where=key), density, self.number(start, "e0", "sp_energy", 0.0, where=key),
                     self.number(start, "p0", "pressure", 0.0, where=key), tables)

    def eos(self, eos: dict, start: dict, density: float, key: str) -> dict[str, Any]:
        kind = eos.get("type")
        heat = self.number(eos, "cv", "sp_heat_cap", 0.0, where=key)
        if kind == "IDG":
            gas = {"law": "ideal_gas", "gamma": self.number(eos, "gamma", None, where=key), "rho0": density}
            return gas | ({"specific_heat": heat} if heat > 0.0 else {})
        if kind == "MGR":
            if self.number(eos, "s2", None, 0.0, where=key):
                raise self.wrong(f"{key}.eos.s2", "a quadratic term is not part of pyKO's MGR", "set it to 0")
            reference = self.number(eos, "rhoref", "density", where=key)
            check_reference(density, reference, self.file, f"{key}.eos.rhoref")
            table = {"law": "wilkins_cubic", "rho0": reference,
                     "c0": self.number(eos, "c0", "velocity", where=key), "s": self.number(eos, "s1", None, where=key),
                     "gamma0": self.number(eos, "gamma0", None, where=key)}
            warm = {"specific_heat": heat, "reference_temperature": self.number(start, "t0", "temperature", 298.15, where=key)}
            return table | (warm if heat > 0.0 else {})
        if kind == "TIL":
            return {"law": "tillotson", "rho0": self.number(eos, "rhoref", "density", where=key)} | {
                name: self.number(eos, theirs, unit, where=key) for name, theirs, unit in (
                    ("a", "a", None), ("b", "b", None), ("bulk_a", "AA", "pressure"), ("bulk_b", "BB", "pressure"),
                    ("alpha", "alpha", None), ("beta", "beta", None), ("e0", "E0", "sp_energy"), ("e_incipient", "EIV", "sp_energy"),
                    ("e_complete", "ECV", "sp_energy"))}
        if kind == "SES":
            eos.get("fileext")     # entropies, sound speeds, phases: they follow from the standard table, or are not used
            warm = self.number(start, "t0", "temperature", 298.15, where=key)
            # pyKO runs on any table: it takes the first temperature of an energy, and its sound speeds from another file
            return {"law": "table", "file": self.table_file(eos, key), "rho0": density, "reference_temperature": warm, "repair": True,
                    "least_sound_speed": 1.0}
        raise self.wrong(f"{key}.eos.type", f"'{printable(str(kind), 30)}' is not supported", "known: IDG, MGR, TIL, SES")

    def table_file(self, eos: dict, key: str) -> str:
        """Where the standard table of a layer lies."""
        units = self.raw.get("tableunits", {})
        if not isinstance(units, dict) or any(units.get(kind, unit) != unit for kind, unit in _TABLE_UNITS.items()):
            raise self.wrong("tableunits", "tables are read in g/cm^3, K, GPa, MJ/kg only", "convert the table")
        name = f"{eos.get('path', '')}{eos.get('filestd', '')}"
        try:
            found = next((folder / name for folder in self.folders if name and (folder / name).is_file()), None)
        except (OSError, ValueError):
            found = None
        if found is None:
            raise self.wrong(f"{key}.eos.filestd", f"no table at '{printable(name, 100)}'",
                             "give a path relative to the folder of the deck, the one above it, or the current one")
        return str(found.resolve())

    def cells(self, mesh: dict, key: str) -> int:
        number = self.number(mesh, "cells", None, where=key)
        if not (number.is_integer() and number >= 1.0):
            raise self.wrong(f"{key}.mesh.cells", f"{number:g} is not a number of cells", "give a whole number above 0")
        return int(number)

    def strength(self, table: dict, eos: dict, density: float, key: str) -> dict[str, Any] | None:
        kind = table.get("type")
        if kind == "HYDRO":
            return None
        if kind == "VM":
            shear, flow = (self.number(table, name, "pressure", where=key) for name in ("gmod", "ys"))
            return {"law": "perfectly_plastic", "shear_modulus": shear, "yield_stress": flow} if shear > 0.0 else None
        if kind == "SG":
            gamma = sum(self.number(eos, name, None, where=key) for name in (("gamma0",) if eos.get("type") == "MGR" else ("a", "b")))
            return {"law": "steinberg_guinan", "rho0": density, "shear_modulus": self.number(table, "mu0", "pressure", where=key),
                    "yield_stress": self.number(table, "Y0", "pressure", where=key),
                    "hardening_coefficient": self.number(table, "beta", None, where=key),
                    "hardening_exponent": self.number(table, "n", None, where=key),
                    "largest_yield_stress": self.number(table, "Ymax", "pressure", where=key),
                    "pressure_coefficient": self.number(table, "b", None, where=key) / _CODE_PRESSURE,
                    "temperature_coefficient": self.number(table, "h", None, where=key),
                    "melt_temperature": self.number(table, "Tm0", "temperature", where=key), "melt_gruneisen": gamma, "melt_a": gamma}
        raise self.wrong(f"{key}.str.type", f"'{printable(str(kind), 30)}' is not supported", "known: HYDRO, VM, SG")

    def end(self, ends: dict, kind: str, pressure: str) -> Any:
        if ends.get(kind) == "FIXED":
            return "fixed"
        if ends.get(kind) == "FREE":
            outside = self.number(ends, pressure, "pressure", 0.0, where="boundaries")
            return {"pressure": outside} if outside else "free"
        raise self.wrong(f"boundaries.{kind}", f"'{printable(str(ends.get(kind)), 30)}' is not FREE or FIXED")

    def number(self, table: dict, name: str, kind: str | None, default: float | None = None, where: str = "") -> float:
        """A number of their deck in SI: a text such as 1E20 counts, as YAML reads it as one."""
        path = f"{where}.{name}" if where else name
        value = table.get(name, default)
        if value is None:
            raise self.wrong(path, "is not given")
        try:
            number = float(value) if not isinstance(value, bool) else float("nan")
            if kind and kind not in self.units and number != 0.0:
                raise self.wrong(f"units.{kind}", f"missing, but {path} needs it", f'for example {kind}: "{_KINDS[kind]}"')
            return parse(f"{number!r} {self.units.get(kind, _KINDS[kind])}", _KINDS[kind]) if kind else parse(number, "1")
        except UnitError as error:
            raise self.wrong(path, error.message, error.hint) from None
        except (TypeError, ValueError, OverflowError):
            raise self.wrong(path, f"'{printable(str(value), 30)}' is not a number") from None

    def table(self, value: Any, name: str) -> dict:
        if not isinstance(value, dict):
            raise DeckError.single(self.file, None, name, "is not given" if value is None else "must be a table")
        return self.tables.setdefault(name, _Given(value))

    def wrong(self, key: str, message: str, hint: str = "") -> DeckError:
        return DeckError.single(self.file, None, key, message, hint)
