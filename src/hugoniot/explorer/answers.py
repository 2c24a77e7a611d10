"""What the page may ask without changing anything: one function per question, the same for the server and for an export."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from hugoniot.errors import OutOfRange
from hugoniot.explorer import catalogue, curves, decks, fits, impact, subjects, tables
from hugoniot.explorer.places import Places
from hugoniot.explorer.subjects import entry_of
from hugoniot.page import run_data
from hugoniot.version import __version__

Query = Mapping[str, str]


def start(places: Places, query: Query) -> Any:
    """What is open."""
    named = {key: [{"name": p.name, "typed": p.typed} for p in getattr(places, key)] for key in ("runs", "sweeps", "fits", "decks")}
    runs = [entry | run_data.line(place.path) for entry, place in zip(named["runs"], places.runs)]
    return {"version": __version__, **named, "runs": runs,
            "materials": places.materials, "files": {name: Path(entry.file).as_posix() for name, entry in subjects.own.items()},
            "may_run": places.work is not None}


def materials(places: Places, query: Query) -> Any:
    """The whole library, a line each."""
    return catalogue.listing()


def material(places: Places, query: Query) -> Any:
    """The curves of one material."""
    return curves.curves_of(text(query, "name"))


def about(places: Places, query: Query) -> Any:
    """Everything known about one material."""
    return catalogue.about(text(query, "name"))


def state(places: Places, query: Query) -> Any:
    """One state of a principal Hugoniot."""
    return curves.state_of(text(query, "name"), text(query, "by"), number(query, "value"))


def layers(places: Places, query: Query) -> Any:
    """Every material that a shock from rest may meet, with its law: the page computes impacts itself."""
    return {line["name"]: impact.layer(entry_of(line["name"])) for line in catalogue.listing()["materials"] if line["alone"]}


def run(places: Places, query: Query) -> Any:
    """What a run holds."""
    return run_data.description(places.run(integer(query, "run")).path)


def array(places: Places, query: Query) -> Any:
    """One column of a run, as an array of doubles."""
    which = {key: integer(query, key) for key in ("record", "zone") if key in query}
    return run_data.column(places.run(integer(query, "run")).path, text(query, "group"), text(query, "name"), which)


def sweep(places: Places, query: Query) -> Any:
    """A table of cases."""
    return tables.table(places.sweep(integer(query, "sweep")).path)


def fit(places: Places, query: Query) -> Any:
    """The fit of a deck: parameters, correlations, data, model and residuals."""
    return fits.fit(places.fit(integer(query, "fit")).path)


def deck(places: Places, query: Query) -> Any:
    """The text of a deck named at the start, and what there is to say about it."""
    place = places.deck(integer(query, "deck"))
    words = decks.text_of(place.path)
    return {"name": place.name, "text": words, "checked": decks.check(words, place.path.parent)}


def words(places: Places, query: Query) -> Any:
    """What a deck of a solver may hold, for completion."""
    return decks.words(query.get("kind", "lagrange1d"))


QUESTIONS: dict[str, Callable[[Places, Query], Any]] = {
    f.__name__: f for f in (start, materials, material, about, state, layers, run, array, sweep, fit, deck, words)}


def text(query: Query, key: str) -> str:
    """A text of the query; `OutOfRange` where it is missing."""
    if key not in query:
        raise OutOfRange(f"the parameter {key} is missing")
    return query[key]


def number(query: Query, key: str, otherwise: float | None = None) -> float:
    """A finite number of the query; `OutOfRange` where it is none."""
    try:
        value = float(query[key]) if key in query or otherwise is None else otherwise
    except (KeyError, ValueError):
        raise OutOfRange(f"{key}: expected a number, got {str(query.get(key))[:40]!r}") from None
    if not abs(value) < 1e300:
        raise OutOfRange(f"{key}: must be a finite number")
    return value


def numbers(query: Query, key: str) -> tuple[float, ...]:
    """Numbers with commas between them; none where the query has none. `OutOfRange` where one is no number."""
    return tuple(number({key: part}, key) for part in query.get(key, "").split(",") if part.strip())


def integer(query: Query, key: str) -> int:
    """A whole number of the query, not negative; `OutOfRange` where it is none."""
    value = query.get(key, "")
    if not (value.isascii() and value.isdigit() and len(value) < 10):
        raise OutOfRange(f"{key}: must be a whole number")
    return int(value)
