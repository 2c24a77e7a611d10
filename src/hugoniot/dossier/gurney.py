"""Gurney velocities of the library's explosives."""

from collections.abc import Sequence

from hugoniot.errors import DeckError
from hugoniot.materials import library, schema
from hugoniot.materials.search import spelling


def gurney_velocities(names: Sequence[str] = ()) -> list[tuple[str, float, str]]:
    """(explosive, sqrt(2E) in m/s, source) of named explosives, or of every one the library has a value for. Raises `DeckError`."""
    rows = list(schema.table("gurney").values())
    if not names:
        return [(row.material, float(row["gurney_velocity"]), row.source) for row in rows]
    found = []
    for name in names:
        stated = library.entry(name).detonation.get("gurney_velocity")
        row = next((row for row in rows if spelling(row.material) == spelling(name)), None)
        if stated is not None:
            found.append((name, float(stated.value), stated.source))
        elif row is not None:
            found.append((name, float(row["gurney_velocity"]), row.source))
        else:
            raise DeckError.single("library", None, name, "no Gurney velocity is known", "known: " + ", ".join(row.material for row in rows)
                                   + '; or give --velocity "2.7 km/s"')
    return found
