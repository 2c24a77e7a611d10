"""What a case of a sweep answers: a deck with some keys changed and run in memory, or an impedance match.

A question is made once per process from plain data (`record`), and answers any number of changes. An answer is a dictionary that JSON
holds: `key` (of what was asked, with every default written out, and of the program that answered), and `numbers` or a `reason`; beside
numbers the `warnings`, if there are any.
"""

import contextlib
import hashlib
import json
import math
import pathlib
import shutil
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from hugoniot.errors import DeckError, HugoniotError
from hugoniot.output.origin import program
from hugoniot.simulate import make_solver, run

FORMAT = 3           # of the numbers: a change of what they mean asks every case again
POINTS = 400         # of a record that is kept of each case
_DIGITS = 32
MATCHED = {"pressure": "Pa", "particle_velocity": "m/s", "shock_velocity": "m/s", "density": "kg/m^3", "specific_internal_energy": "J/kg"}


def question_of(record: Mapping[str, Any]):
    """The question of a record: `Deck.record` or `Match.record`."""
    return _KINDS[record["kind"]](**{key: value for key, value in record.items() if key != "kind"})


def address(resolved: str) -> str:
    """The key of what is asked with every default written out, together with the program that answers."""
    return hashlib.sha256(json.dumps([FORMAT, program(), resolved], sort_keys=True).encode()).hexdigest()[:_DIGITS]


def _reason(error: Exception) -> str:
    """Why a case has no numbers, on one line."""
    if isinstance(error, DeckError):
        first = error.problems[0]
        return " ".join(f"deck: {first.key}: {first.message}".split())
    if isinstance(error, HugoniotError):
        return " ".join(str(error).split())
    return " ".join(f"unexpected {type(error).__name__}: {error}".split())[:300]


def _copied(raw: Any) -> Any:
    """Tables of a deck of their own; the values in them never change."""
    if isinstance(raw, dict):
        return {key: _copied(inner) for key, inner in raw.items()}
    return [_copied(inner) for inner in raw] if isinstance(raw, list) else raw


class Asked:
    """What both kinds of questions do."""

    def answer(self, changes: Mapping[str, Any], known: Sequence[str] | set = ()) -> dict:
        """The answer for some changes; only its key where that is `known` already."""
        found: dict[str, Any] = {}
        try:
            resolved, ask = self.prepared(changes)
            found["key"] = address(resolved)
            if found["key"] in known and self.stands(found["key"]):
                return found
            found |= ask(found["key"])
        except (KeyboardInterrupt, SystemExit):
            raise
        except Exception as error:    # one case that fails is a row of the table, whatever the reason
            found["reason"] = _reason(error)
        return found

    def prepared(self, changes: Mapping[str, Any]):
        """(what is asked, written out; function from the key to the rest of the answer)."""
        raise NotImplementedError

    def stands(self, key: str) -> bool:
        """Whether all that the answer of a key left on the disk is there."""
        return True

    def warm(self) -> None:
        """Load what every case needs, compiled code too, before the first one's time begins."""

    def record(self) -> dict:
        """Plain data that `question_of` makes this question from."""
        raise NotImplementedError


class Deck(Asked):
    """A deck: its text, the name messages call it, where users' materials are looked for, and what is kept of each case.

    records   "GAUGE.field" of which each case keeps `points` values from `since` to `until` (s)
    runs      folder for full run folders, or None
    pops      (input pressures in Pa, distances in m that they are wanted to have) of each Pop plot asked for besides
    run       whether the deck itself is run: its numbers and records
    """

    def __init__(self, text: str, name: str, beside: str | None = None, places: Sequence[str] = (), records: Sequence[str] = (),
                 until: float = 0.0, runs: str | None = None, points: int = POINTS, pops: Sequence = (), run: bool = True,
                 since: float = 0.0):
        from hugoniot.problem.deck import parse_deck

        self.text, self.name, self.beside, self.places = text, name, beside, tuple(places)
        self.records, self.until, self.runs, self.points = tuple(records), until, runs, points
        self.pops, self.run, self.since = [list(map(list, pop)) for pop in pops], run, since
        self.raw = parse_deck(text, name)
        self.raw.pop("sweep", None)
        self.beside_path = None if beside is None else pathlib.Path(beside)

    def record(self) -> dict:
        pops = {"pops": self.pops, "run": self.run}
        return {"kind": "deck", "text": self.text, "name": self.name, "beside": self.beside, "places": list(self.places), **pops,
                "records": list(self.records), "since": self.since, "until": self.until, "runs": self.runs, "points": self.points}

    def read(self, changes: Mapping[str, Any]):
        """The deck with the changes; `DeckError` with every problem."""
        from hugoniot.problem.deck import read_tables

        return read_tables(_copied(self.raw), self.text, self.name, dict(changes), self.places, self.beside_path)

    def warm(self):
        from hugoniot.campaign import memory_run, numbers  # noqa: F401  (loads them)

        with contextlib.suppress(HugoniotError):      # what is wrong with the deck itself is the reason its cases give
            solver = make_solver(self.read({}).problem)
            solver.march(solver.problem.stop_time, 1)

    def prepared(self, changes):
        deck = self.read(changes)
        span = f"{self.since!r} {self.until!r}" if self.since else f"{self.until!r}"
        kept = "".join(f"# {self.points} {span} {name}\n" for name in self.records)
        kept += "".join(f"# pop plot {pop!r}\n" for pop in self.pops) + ("" if self.run else "# not run\n")
        return deck.resolved + kept, lambda key: self._ran(deck, key)

    def stands(self, key):
        return self.runs is None or (pathlib.Path(self.runs) / key / "summary.json").is_file()

    def _ran(self, deck, key: str) -> dict:
        from hugoniot.campaign.memory_run import MemoryRun
        from hugoniot.campaign.numbers import numbers_of
        from hugoniot.output.run_numbers import warnings_of

        popped = {f"pop plot {k}.distance": self._popped(deck.problem, pop) for k, pop in enumerate(self.pops, 1)}
        if not self.run:
            return {"numbers": {}, "records": popped}
        if self.runs is None:
            found: Any = MemoryRun(deck.problem, deck.warnings)
            warned = [*deck.warnings, *found.warnings]
        else:
            folder = pathlib.Path(self.runs) / key
            if folder.is_dir() and not (folder / "summary.json").is_file():
                shutil.rmtree(folder)     # what a killed worker began; its name is ours alone
            found = run(deck, folder, report=False, overwrite=True)
            warned = warnings_of(found)
        records = {**(self._kept(found) if self.records else {}), **popped}
        return {"numbers": numbers_of(found), **({"records": records} if records else {}), **_warned(warned)}

    @staticmethod
    def _popped(problem, pop) -> list[float]:
        from hugoniot.campaign.pop_target import distances, explosive_of

        return distances(explosive_of(problem), *pop)

    def times(self) -> np.ndarray:
        """At which the records of a case are kept, s."""
        return np.linspace(self.since, self.until, self.points)

    def _kept(self, found) -> dict[str, list[float]]:
        times, kept = self.times(), {}
        for name in self.records:
            gauge, _, field = name.rpartition(".")
            time, values = found.gauge(field, gauge)
            kept[name] = np.interp(times, time, values, right=math.nan).tolist()
        return kept


class Match(Asked):
    """An impedance match of a flyer and the layers it strikes.

    layers   names of materials, the flyer first
    Its keys are `velocity`, `flyer`, `target` (or `target1`, `target2`, ...) and `material.NAME.FAMILY.PARAMETER`.
    """

    def __init__(self, layers: Sequence[str], places: Sequence[str] = (), runs: None = None):
        self.layers, self.places = tuple(layers), tuple(places)
        targets = ["target"] if len(layers) == 2 else [f"target{k}" for k in range(1, len(layers))]
        self.places_of = dict(zip(("flyer", *targets), self.layers))

    def record(self) -> dict:
        return {"kind": "match", "layers": list(self.layers), "places": list(self.places)}

    def prepared(self, changes):
        layers, velocity = self._read(changes)
        from hugoniot.laws.eos.contract import EOS
        from hugoniot.materials.tables import law_table

        asked = {"match": [law_table(EOS, layer.eos) for layer in layers], "velocity": velocity}
        return json.dumps(asked, sort_keys=True, default=repr), lambda key: _matched(layers, velocity)

    def _read(self, changes: Mapping[str, Any]) -> tuple[list, float]:
        from hugoniot.units import UnitError, parse

        names = {place: str(changes.get(place, name)) for place, name in self.places_of.items()}
        tables: dict[str, dict] = {}
        for key, value in changes.items():
            if key in names or key == "velocity":
                continue
            owner = next((name for name in names.values() if key.startswith(f"material.{name}.")), None)
            parts = key[len(f"material.{owner}."):].split(".") if owner else []
            if owner is None or len(parts) != 2:
                hint = f"known: velocity, {', '.join(names)}, and keys such as material.{next(iter(names.values()))}.eos.c0"
                raise DeckError.single("match", None, key, "an impedance match has no such input", hint)
            tables.setdefault(owner, {"base": owner}).setdefault(parts[0], {})[parts[1]] = value
        if "velocity" not in changes:
            raise DeckError.single("match", None, "velocity", "the velocity of the flyer is missing", 'write --vary "velocity = 500 m/s"')
        try:
            velocity = parse(changes["velocity"], "m/s")
        except UnitError as error:
            raise DeckError.single("match", None, "velocity", error.message, error.hint) from None
        return [self._material(name, tables.get(name)) for name in names.values()], velocity

    def _material(self, name: str, table: dict | None):
        from hugoniot.materials.collect import Collector
        from hugoniot.materials.library import find
        from hugoniot.materials.read import read_material
        from hugoniot.materials.users import find as find_own
        from hugoniot.materials.users import user_materials

        if table is None:
            return find_own(name, user_materials(self.places)).material if self.places else find(name)
        collector = Collector([], "match", lambda path: None)
        material = read_material(name, table, collector, ("material", name))
        if collector.problems or material is None:
            raise collector.error()
        return material


def _warned(texts: Sequence[str]) -> dict[str, list[str]]:
    """The warnings of an answer, each once."""
    return {"warnings": list(dict.fromkeys(texts))} if texts else {}


def _matched(layers: Sequence, velocity: float) -> dict:
    from hugoniot.materials.validity import about_shock
    from hugoniot.theory.impedance import first_jump, match

    met = match(layers, velocity)
    rows = [m.right.table() for m in met]
    several = len(rows) > 1
    numbers = {(f"interface {k}.{name}" if several else name): float(row[name]) for k, row in enumerate(rows, 1)
               for name in MATCHED if row.get(name) is not None}
    return {"numbers": numbers, **_warned([text for k, layer in enumerate(layers)
                                           for text in about_shock(layer, first_jump(k, velocity, met))])}


_KINDS = {"deck": Deck, "match": Match}
