"""The plan of a sweep: a question, a design, ties between keys, and from them the changes of every case.

Ties are worked out case by case, in their order: `region.target.to = region.flyer.to + 4 mm`. They may use what is varied, what earlier
ties gave, and keys that the deck itself gives.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from hugoniot.campaign.designs import Design
from hugoniot.campaign.questions import Deck, Match
from hugoniot.campaign.variables import refuse
from hugoniot.errors import DeckError
from hugoniot.files import toml_tables
from hugoniot.materials.collect import nearest, printable
from hugoniot.problem.arithmetic import Expression, Number, Trouble, quantity
from hugoniot.problem.schema import keys_of
from hugoniot.problem.solver_kinds import available_solvers, solver_module

MOST_LOOKED_AT = 20      # cases, for one in which the ties have values


@dataclass(frozen=True)
class Tie:
    """A key that follows from others."""

    key: str
    expression: Expression


@dataclass(frozen=True)
class Plan:
    """Everything that decides the table of a sweep."""

    question: Deck | Match
    design: Design
    ties: tuple[Tie, ...] = ()
    option: str = "--vary"          # where the variables were given, for messages
    _base: dict[str, Number] = field(default_factory=dict, compare=False)

    def __len__(self) -> int:
        return len(self.design)

    def changes(self, case: int) -> dict[str, Any]:
        """What the question's keys are in a case. Raises `Trouble` where a tie has no value there."""
        return self.changes_of(self.design.values(case))

    def changes_of(self, values: Sequence[Any]) -> dict[str, Any]:
        """The same for values of the variables."""
        found = {variable.name: value for variable, value in zip(self.design.variables, values) if self.is_key(variable.name)}
        known = self._known(values) if self.ties else {}
        for tie in self.ties:
            known[tie.key] = tie.expression.value(lambda key: self._number(key, known))
            found[tie.key] = known[tie.key].text()
        return found

    def tied(self, values: Sequence[Any]) -> list[Number]:
        """The numbers of the ties; not-a-number from the first that has no value on."""
        known, found = self._known(values), []
        for tie in self.ties:
            try:
                known[tie.key] = tie.expression.value(lambda key: self._number(key, known))
            except Trouble:
                known[tie.key] = Number(math.nan)
            found.append(known[tie.key])
        return found

    def _known(self, values: Sequence[Any]) -> dict[str, Number]:
        return {variable.name: variable.known(value) for variable, value in zip(self.design.variables, values) if not variable.texts}

    def _number(self, key: str, known: Mapping[str, Number]) -> Number:
        if key in known:
            return known[key]
        if key not in self._base:
            raw = self.question.raw if isinstance(self.question, Deck) else {}
            value = given(raw, key)
            if value is None:
                names = [*known, *keys_in(raw)]
                raise Trouble(f"'{printable(key)}' is neither a key of the deck nor varied", nearest(key, names, "write it into the deck"))
            self._base[key] = quantity(value)
        return self._base[key]

    def is_key(self, name: str) -> bool:
        """Whether a name is a key of the question, rather than a name of its own that ties use."""
        if isinstance(self.question, Match):
            return name in ("velocity", *self.question.places_of) or "." in name
        return "." in name or name in top_keys(self.question.raw)

    # -- checks before anything runs -----------------------------------------------------------------------------------
    def check(self) -> None:
        """Raise `DeckError` for keys that do not exist, units that do not fit, ties that cannot be worked out: before any case is run.

        A combination of sound values that makes no sound deck is not looked for here: it is a case that fails, with its reason.
        """
        used = {key for tie in self.ties for key in tie.expression.keys}
        for variable in self.design.variables:
            if not self.is_key(variable.name) and variable.name not in used:
                if isinstance(self.question, Deck):
                    what, known, form = "a key of the deck", top_keys(self.question.raw), "keys are written like region.flyer.velocity"
                else:
                    what, known = "an input of the match", ["velocity", *self.question.places_of]
                    form = f"the inputs are {', '.join(known)} and constants such as material.copper.eos.c0"
                raise refuse(self.option, variable.name, f"not {what}, and no tie uses it", nearest(variable.name, known, form))
        first = self._first_with_values()
        if isinstance(self.question, Deck):
            self._check_deck(self.question, first, self.option)
        else:
            self.question.prepared(first)

    def _first_with_values(self) -> dict[str, Any]:
        """The changes of the first case in which every tie has a value; `DeckError` where none of the first ones has."""
        trouble = None
        for case in range(min(len(self), MOST_LOOKED_AT)):
            try:
                return self.changes(case)
            except Trouble as error:
                trouble = trouble or error
        raise refuse("--tie", "", trouble.message if trouble else "no cases", trouble.hint if trouble else "")

    @staticmethod
    def _check_deck(question: Deck, first: dict[str, Any], option: str) -> None:
        for key in first:
            _check_place(question.raw, key, option)
        question.read({})       # the deck itself has to be sound
        try:
            question.read(first)
            return
        except DeckError as error:
            wrong = {problem.key for problem in error.problems}
        for key, value in first.items():
            try:
                question.read({key: value})
            except DeckError as error:
                own = [problem for problem in error.problems if problem.key in wrong and (
                    problem.key == key or problem.key.startswith(f"{key}.") or key.startswith(f"{problem.key}."))]
                if own:     # others come of a change that is made alone here
                    raise DeckError(own) from None


def ties_of(texts: Sequence[str], varied: Sequence[str]) -> tuple[Tie, ...]:
    """The ties that texts such as "region.target.from = region.flyer.to" describe. Raises `DeckError`."""
    found: list[Tie] = []
    for text in texts:
        key, equals, rest = (part.strip() for part in text.partition("="))
        if not equals or not key or not rest:
            raise refuse("--tie", text, "expected KEY = EXPRESSION", 'write it like "region.target.from = region.flyer.to"')
        if key in varied or any(tie.key == key for tie in found):
            raise refuse("--tie", key, "given twice", "a key may be varied or tied only once")
        try:
            found.append(Tie(key, Expression(rest)))
        except Trouble as error:
            raise refuse("--tie", text, error.message, error.hint) from None
    return tuple(found)


def given(raw: Mapping, key: str) -> Any:
    """What the tables of a deck hold under a dotted key; elements of arrays by their name. None where they hold nothing."""
    here: Any = raw
    for part in key.split("."):
        if isinstance(here, list):
            here = next((element for element in here if isinstance(element, dict) and element.get("name") == part), None)
        else:
            here = here.get(part) if isinstance(here, dict) else None
    return here


def keys_in(raw: Any, before: str = "") -> list[str]:
    """Every dotted key of a deck's tables that holds a value."""
    if isinstance(raw, dict):
        return [key for name, inner in raw.items() for key in keys_in(inner, f"{before}.{name}" if before else str(name))]
    if isinstance(raw, list) and raw and all(isinstance(element, dict) and isinstance(element.get("name"), str) for element in raw):
        return [key for element in raw for key in keys_in(element, f"{before}.{element['name']}")]
    return [before]


def top_keys(raw: Mapping) -> list[str]:
    """The keys that a deck of this solver may have outside its tables."""
    solver = raw.get("solver", {})
    kind = solver.get("kind", "lagrange1d") if isinstance(solver, dict) else "lagrange1d"
    return keys_of(solver_module(kind).Model) if kind in available_solvers() else []


def _check_place(raw: Mapping, key: str, option: str) -> None:
    """Raise `DeckError` where a key leads to an element of the deck that is not there."""
    first, _, rest = key.partition(".")
    tops = top_keys(raw)
    if tops and first not in tops:
        raise refuse(option, key, "no such key in the deck", nearest(first, tops))
    rows = raw.get(first)
    if isinstance(rows, list):
        names = [row["name"] for row in rows if isinstance(row, dict) and isinstance(row.get("name"), str)]
        name = rest.split(".")[0]
        if name not in names:
            raise refuse(option, key, f"the deck has no {first} '{printable(name)}'", nearest(name, names))
    if first == "material":
        used = [row["material"] for part in ("region", "block") if isinstance(raw.get(part), list) for row in raw[part]
                if isinstance(row, dict) and isinstance(row.get("material"), str)]
        known = list(dict.fromkeys([*(raw.get("material") or {}), *used]))
        if not any(rest.startswith(f"{name}.") for name in known):
            raise refuse(option, key, f"the deck has no material '{printable(rest.split('.')[0])}'", nearest(rest.split(".")[0], known))


def sweep_table(text: str, name: str) -> dict[str, Any] | None:
    """The [sweep] table of a deck or sweep file; None where it has none."""
    try:
        table = toml_tables(text).get("sweep")
    except ValueError:
        return None       # the deck's own reader says what is wrong with it
    if table is not None and not isinstance(table, dict):
        raise DeckError.single(name, None, "sweep", "expected a table", "write [sweep] above its keys")
    return table
