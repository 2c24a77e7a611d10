"""Gurney velocities sqrt(2E) of the library's explosives: as tabulated, or derived from the products' own equation of state.

Derived: E is what the gas has given up when it has expanded from the Chapman-Jouguet state along its isentrope to V = EXPANSION times
the volume of the explosive, $E = e_0 - e_S(V)$. For the nine explosives that have both this is 0.2 to 7.5 % above the table (median
3.2 %). Down to V = 7 it is 2 to 9 % more.
"""

from collections.abc import Sequence
from typing import NamedTuple

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.search import spelling
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.isentrope import isentrope

EXPANSION = 4.0
DERIVED = (f"derived: chemical energy less the internal energy of the products on their CJ isentrope at V = {EXPANSION:g}; 0 to 8 % above "
           "the tabulated value, where there is one")


class GurneyVelocity(NamedTuple):
    """sqrt(2E) of an explosive in m/s, where it is from, whether it was derived from its products, and what is doubtful about it."""

    explosive: str
    velocity: float
    source: str
    derived: bool
    marks: tuple[str, ...] = ()


def gurney_velocities(names: Sequence[str] = ()) -> list[GurneyVelocity]:
    """Of named explosives; without names, every row of the table, then every other explosive of the library. Raises `DeckError`."""
    rows = list(schema.table("gurney").values())
    if not names:
        others = [entry for entry in _explosives() if _stated(entry) is None]
        return [_tabulated(row.material, row) for row in rows] + [
            _derived(entry.title, entry) for entry in others]
    found = []
    for name in names:
        row = next((row for row in rows if spelling(row.material) == spelling(name)), None)
        if row is not None:
            found.append(_tabulated(name, row))
            continue
        entry = library.entry(name)
        stated = _stated(entry)
        if stated is not None:
            found.append(GurneyVelocity(name, float(stated.value), stated.source, False))
        elif "reacted" in EOS.of(entry.material.eos).flags:
            found.append(_derived(name, entry))
        else:
            raise DeckError.single("library", None, name, "has neither a Gurney velocity nor detonation products in the library",
                                   "give its Gurney velocity, such as --velocity \"2.7 km/s\"; tabulated Gurney velocities: "
                                   + ", ".join(row.material for row in rows))
    return found


def derived_velocity(entry: Entry) -> float:
    """sqrt(2E) in m/s of an explosive from the isentrope of its products."""
    products = entry.material.eos
    rho0, e0 = reference_state(products)
    end = isentrope(products, cj(products).state, density=rho0 / EXPANSION)
    return float((2.0 * (e0 - end.specific_internal_energy)) ** 0.5)


def _derived(name: str, entry: Entry) -> GurneyVelocity:
    return GurneyVelocity(name, derived_velocity(entry), DERIVED, True, schema.row(entry.rows[0]).marks)


def _tabulated(name: str, row: schema.Row) -> GurneyVelocity:
    return GurneyVelocity(name, float(row["gurney_velocity"]), row.source, False, row.marks)


def _stated(entry: Entry):
    return entry.detonation.get("gurney_velocity")


def _explosives() -> list[Entry]:
    """The curated explosives with products."""
    return [library.entry(name) for name, hit in library.index().items() if hit.category == "explosive" and hit.curated]
