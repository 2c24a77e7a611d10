"""The library's own uncertainties as parameters of a sweep: `hugoniot sweep DECK --uncertain library`.

Every direction of `dossier.uncertainty` is a name with a normal distribution, and every constant that has directions is tied to them:
`material.copper.eos.c0 = 3940 + 20.1 * copper_U007 - 5.2 * copper_U202`. So constants of one source move together, and designs, tables,
bands and indices are those of any sweep.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from hugoniot.campaign.plan import Tie
from hugoniot.campaign.questions import Deck
from hugoniot.campaign.variables import Variable, refuse
from hugoniot.dossier.uncertainty import Uncertainty, uncertainty_of
from hugoniot.materials import library
from hugoniot.materials.library import UnknownMaterial
from hugoniot.materials.tables import families, law_table
from hugoniot.problem.arithmetic import Expression

KINDS = ("library",)
SAMPLES = 64


@dataclass(frozen=True)
class Known:
    """What the library knows of one material of a deck: its name there, that of the library, its uncertainty, the constants used."""

    name: str
    entry: str
    found: Uncertainty
    constants: dict[str, float]
    units: dict[str, str]


def known_of(question: Deck) -> list[Known]:
    """The materials of a deck that come from the library."""
    problem, tables = question.read({}).problem, question.raw.get("material") or {}
    found = []
    for name, material in problem.materials.items():
        table = tables.get(name)
        base = table.get("base", table.get("library")) if isinstance(table, dict) else name
        try:
            entry = library.entry(base) if isinstance(base, str) else None
        except UnknownMaterial:
            entry = None        # a file of the user's
        if entry is None:
            continue
        constants, units = {}, {}
        for family, registry in families().items():
            par = getattr(material, family)
            for key, value in (law_table(registry, par) if par is not None else {}).items():
                constants[f"{family}.{key}"], units[f"{family}.{key}"] = value, registry.of(par).units.get(key, "1")
        found.append(Known(name, entry.name, uncertainty_of(entry, material), constants, units))
    return found


def uncertain(question: Deck, kind: str) -> tuple[list[Variable], list[Tie], list[Known]]:
    """(names that vary, ties of the constants to them, what is known of each material). Raises `DeckError`."""
    if kind not in KINDS:
        raise refuse("--uncertain", kind, "unknown kind of uncertainty", f"known: {', '.join(KINDS)}")
    if not isinstance(question, Deck):
        raise refuse("--uncertain", kind, "an impedance match has no deck", 'vary its constants: --vary "material.copper.eos.c0 = ..."')
    known = known_of(question)
    varied: dict[str, Variable] = {}
    ties = []
    for each in known:
        # by the name in the library: what a deck calls by two names is one material, whose constants are wrong together
        names = {d.source: _identifier(each.entry, d.source) for d in each.found.directions}
        varied |= {name: Variable(name, "normal", "", 0.0, 1.0) for name in names.values()}
        for constant in each.found.deviations:
            terms = [f" + {d.shifts[constant]:.9g} * {names[d.source]}" for d in each.found.directions if constant in d.shifts]
            ties.append(Tie(f"material.{each.name}.{constant}", Expression(f"{each.constants[constant]!r}{''.join(terms)}")))
    if not ties:
        raise refuse("--uncertain", kind, "the library gives no uncertainty for any constant of this deck",
                     'name a material of the library, or give an uncertainty: --vary "material.al.eos.c0 = 5.35 +- 0.05 km/s"')
    return list(varied.values()), ties, known


def _identifier(material: str, source: str) -> str:
    return re.sub(r"\W+", "_", f"{material}_{source}")


def records_of(question: Deck) -> list[str]:
    """The velocity at every gauge of a deck, or what its solver records instead."""
    from hugoniot.problem.plane.model import Problem2D

    problem = question.read({}).problem
    return [] if isinstance(problem, Problem2D) else [f"{gauge.name}.velocity" for gauge in problem.gauges]


def rows_of(known: list[Known]) -> Iterator[list[str]]:
    """What is known, one line for each constant: material, constant, value, unit, standard deviation, its sources or why it has none."""
    for each in known:
        for name, deviation in each.found.deviations.items():
            sources = [d.source for d in each.found.directions if name in d.shifts]
            yield [each.name, name, repr(float(each.constants[name])), each.units[name], f"{deviation:.4g}", ", ".join(sources)]
        for name, reason in each.found.unknown.items():
            yield [each.name, name, repr(float(each.constants[name])), each.units[name], "", reason]
        for words in each.found.left_out:
            yield [each.name, "", "", "", "", f"left out: {words}"]
