r"""How well the library knows a material's constants: what its sources say of themselves, and where they differ.

A *direction* is a set of changes of constants that belong together, for one standard deviation. All directions of a material are
independent of each other, each normal; a constant that moves along several has the sum of their squares for its variance. There are
two kinds:

* Of a fit through measured states, those of the covariance of its coefficients: recomputed where the library holds the states, else
  from the standard deviations that the row gives.
* Of any other set of constants, a direction for each source, the row used and the rows of other sources for the same law: with n + 1
  sources of a constant and their mean $\bar x$, the change $(x_k - \bar x)/\sqrt n$ along the direction of source k. Together they have
  the covariance of the sources, so that constants that were fitted together, such as c0 and s, stay together.

A row that repeats the numbers of another one is no further source; one that is marked with DOUBT, or whose density shows that it is of
another material, is left out. A constant with a single source, or one that the deck gives itself, has no uncertainty here and is listed
as such: the library does not know it.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from hugoniot.dossier import fits
from hugoniot.materials import cards, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.material import Material
from hugoniot.materials.reach import SAME_DENSITY
from hugoniot.materials.record import mark
from hugoniot.materials.tables import families, law_table

FAMILIES = ("eos", "strength", "fracture")
AT_LEAST = ("these standard deviations, and the spreads that follow from them, are lower bounds: where sources agree, one may have copied "
            "or rounded the numbers of the other")
_HUGONIOT = ("eos.c0", "eos.s", "eos.s1", "eos.s2", "eos.s3")
_COEFFICIENTS = {"linear": ("eos.c0", "eos.s"), "quadratic": ("eos.c0", "eos.s1", "eos.s2")}


@dataclass(frozen=True)
class Direction:
    """source: the row whose numbers it follows; shifts: "eos.c0" -> change for one standard deviation, SI."""

    source: str
    shifts: Mapping[str, float]


@dataclass(frozen=True)
class Uncertainty:
    """Of one material: directions, standard deviation of every constant that has one, why others have none, rows that were left out."""

    directions: tuple[Direction, ...] = ()
    deviations: Mapping[str, float] = field(default_factory=dict)
    unknown: Mapping[str, str] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()


def uncertainty_of(entry: Entry, material: Material | None = None) -> Uncertainty:
    """The uncertainty of a material of the library; `material` is what a deck has made of it, whose own numbers are left alone."""
    used, found, left_out = material or entry.material, [], []
    unknown: dict[str, str] = {}
    marks = {source.quantity: mark(source.status, source.note) for source in entry.material.sources}
    for family in FAMILIES:
        constants, own = _constants(entry.material, family), _constants(used, family)
        if not own:
            continue
        row = next((r for r in entry.rows if family in _families_of(r)), "")
        directions, skipped = _directions(row, entry.others.get(family, ()), family, constants)
        left_out += skipped
        same = {name for name, value in own.items() if name in constants and abs(value - constants[name]) <= 1e-9 * abs(value)}
        found += [Direction(d.source, kept) for d in directions if (kept := {k: v for k, v in d.shifts.items() if k in same})]
        moved = {name for d in found for name in d.shifts}
        for name in own:
            if name not in moved:
                word = marks.get(name, "")
                reason = "one source" + (f" ({word})" if word else "") if name in same else "given by the deck"
                unknown[name] = reason
    names = dict.fromkeys(name for direction in found for name in direction.shifts)
    deviations = {name: math.sqrt(sum(direction.shifts.get(name, 0.0) ** 2 for direction in found)) for name in names}
    return Uncertainty(tuple(found), deviations, unknown, tuple(left_out))


def _constants(material: Material, family: str) -> dict[str, float]:
    """The numbers of a law, "eos.c0" -> SI."""
    par = getattr(material, family)
    table = law_table(families()[family], par) if par is not None else {}
    numbers = {name: value for name, value in table.items() if isinstance(value, (int, float)) and not isinstance(value, bool)}
    return {f"{family}.{name}": float(value) for name, value in numbers.items()}


def _families_of(identity: str) -> tuple[str, ...]:
    return {"us_up": ("eos",), "compression": ("eos",), "tillotson": ("eos",), "jwl": ("eos",), "gases": ("eos",),
            "strength": ("strength",)}.get(schema.row(identity).table, ())


def _directions(row: str, others: Sequence[str], family: str, constants: Mapping[str, float]) -> tuple[list[Direction], list[str]]:
    """The directions of the constants of one law, and the rows that were left out."""
    if row and (stated := _of_fit(row)):
        return stated, []
    law = cards.card(schema.row(row)).get("law") if row else None
    sources, left_out = {row or "the library": dict(constants)}, []
    for identity in others:
        values, why = _values(identity, family, law)
        if not why and (rho := values.get(f"{family}.rho0")) and f"{family}.rho0" in constants:
            apart = rho / constants[f"{family}.rho0"] - 1.0
            why = f"its density differs by {100.0 * apart:+.0f} %: another material" if abs(apart) > SAME_DENSITY else ""
        if why:
            left_out.append(f"{identity}: {why}")
        else:
            sources[identity] = {name: value for name, value in values.items() if name in constants}
    return _between(_distinct(sources), constants), left_out


def _values(identity: str, family: str, law) -> tuple[dict[str, float], str]:
    """(constants of a row, "eos.c0" -> SI; why it cannot be compared)."""
    row = schema.row(identity)
    try:
        card = cards.card(row, family)
    except ValueError:
        card = {}
    doubt = row.doubt if "DOUBT:" in row.note else ""
    if doubt or not card or card.get("law") != law:
        return {}, doubt or "not a set of constants for the same law"
    return {f"{family}.{name}": float(source.value) for name, source in card.items() if not isinstance(source, str)
            and isinstance(source.value, (int, float)) and not source.source.startswith("estimated")}, ""


def _of_fit(identity: str) -> list[Direction]:
    """Of a fit through measured states."""
    row = schema.row(identity)
    names = _COEFFICIENTS.get(str(row.get("form")), ())
    if identity in fits.RECORDED:
        covariance = fits.recorded(identity).covariance
    elif "c0_deviation" in row and "s_deviation" in row and len(names) == 2:
        covariance = np.diag([row["c0_deviation"] ** 2, row["s_deviation"] ** 2])
    else:
        return []
    return [Direction(f"{identity} {name.partition('.')[2]}", {n: float(v) for n, v in zip(names, column) if v != 0.0})
            for name, column in zip(names, np.linalg.cholesky(covariance).T)]


def _distinct(sources: dict[str, dict[str, float]]) -> dict[str, dict[str, float]]:
    """The sources without those, and without those Hugoniots, that repeat the numbers of an earlier one."""
    kept: dict[str, dict[str, float]] = {}
    for identity, values in sources.items():
        hugoniot = [name for name in _HUGONIOT if name in values]
        if any(_repeat(values, earlier, list(values)) for earlier in kept.values()):
            continue
        copied = bool(hugoniot) and any(_repeat(values, earlier, hugoniot) for earlier in kept.values())
        kept[identity] = {name: value for name, value in values.items() if not (copied and name in (*_HUGONIOT, "eos.rho0"))}
    return kept


def _repeat(values: Mapping[str, float], earlier: Mapping[str, float], names: Sequence[str]) -> bool:
    shared = [name for name in names if name in earlier]
    return bool(shared) and all(abs(values[name] - earlier[name]) <= 1e-6 * abs(values[name]) for name in shared)


def _between(sources: dict[str, dict[str, float]], constants: Mapping[str, float]) -> list[Direction]:
    """Of the differences between sources."""
    shifts: dict[str, dict[str, float]] = {identity: {} for identity in sources}
    for name in constants:
        given = {identity: values[name] for identity, values in sources.items() if name in values}
        if len(given) < 2:
            continue
        mean = sum(given.values()) / len(given)
        for identity, value in given.items():
            if abs(value - mean) > 1e-9 * abs(mean):
                shifts[identity][name] = (value - mean) / math.sqrt(len(given) - 1)
    return [Direction(identity, found) for identity, found in shifts.items() if found]
