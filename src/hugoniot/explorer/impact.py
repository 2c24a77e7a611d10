"""An impact of a flyer on a stack of layers: the states at the interfaces and their error bands, as the page computes them too."""

from collections.abc import Sequence
from typing import Any

from hugoniot.dossier import fits
from hugoniot.errors import DeckError, OutOfRange
from hugoniot.explorer.splits import about_split, split_of
from hugoniot.explorer.subjects import entry_of, inert, reacted
from hugoniot.explorer.transcribed import parameters
from hugoniot.materials.entry import Entry
from hugoniot.materials.validity import about_law, about_shock, beyond_data
from hugoniot.theory.impedance import Match, first_jump, match
from hugoniot.theory.uncertainty import matched, propagate

MOST_LAYERS = 8
ANSWERS = ("pressure", "particle_velocity", "shock_velocity", "density")


def impact(names: Sequence[str], velocity: float, sigma: float = 0.0, bands: bool = False) -> dict[str, Any]:
    """The states at every interface of the stack, flyer first, SI; `uncertainty` of each where anything is uncertain.

    sigma   standard deviation of the velocity, m/s
    bands   whether the covariance of the library's own fits counts as well
    Raises `OutOfRange` or `NoSolution` with the limit, `DeckError` for an unknown material.
    """
    if not 2 <= len(names) <= MOST_LAYERS:
        raise OutOfRange(f"an impact needs 2 to {MOST_LAYERS} materials, the flyer first; got {len(names)}")
    entries = [entry_of(name) for name in names]
    layers = [inert(entry) for entry in entries]
    met = match(layers, velocity)
    spreads, used = _spreads(entries, layers, velocity, sigma, bands)
    shown = [layer.name if reacted(entry) else name for name, entry, layer in zip(names, entries, layers)]
    rows = [_row(m, shown, [s for s in spreads if s[0] == i]) for i, m in enumerate(met)]
    return {"layers": list(names), "velocity": velocity, "states": rows, "uncertain": used, "warnings": _warnings(entries, velocity, met)}


def _row(m: Match, names: Sequence[str], spreads: list) -> dict:
    row = {"interface": f"{names[m.interface]}/{names[m.interface + 1]}", **m.right.table(), "separated": m.separated,
           "reflected": m.wave_left, "transmitted": m.wave_right, "left": m.left.table()}
    return row | ({"uncertainty": {key: sigma for _, key, sigma in spreads}} if spreads else {})


def _warnings(entries: Sequence[Entry], velocity: float, met: Sequence[Match]) -> list[str]:
    """What must be said about every layer, each once."""
    jumps = [first_jump(i, velocity, met) for i in range(len(entries))]
    return list(dict.fromkeys(text for e, jump in zip(entries, jumps) for text in (*about_split(e, jump), *about_shock(inert(e), jump))))


# -- error bands -----------------------------------------------------------------------------------------------------
def _spreads(entries, layers, velocity: float, sigma: float, bands: bool) -> tuple[list[tuple[int, str, float]], list[str]]:
    """(interface, field, standard deviation) of every answer, and what was taken as uncertain."""
    values, sigmas, together = fits.uncertain((entry.rows, layer) for entry, layer in zip(entries, layers) if bands)
    values["velocity"] = velocity
    sigmas = ({"velocity": sigma} if sigma > 0.0 else {}) | sigmas
    if not sigmas:
        return [], []
    found = propagate(matched(layers, ANSWERS), values, sigmas, correlation=together)
    flat = [(int(key.partition(".")[0]), key.partition(".")[2], spread.sigma) for key, spread in found.items()]
    return flat, list(dict.fromkeys(name.rpartition(".")[0] or name for name in sigmas))


# -- what the page needs to compute the same -------------------------------------------------------------------------
def layer(entry: Entry) -> dict[str, Any]:
    """A material for `H.impact` of the page: the law with its parameters, and what an answer says beside its numbers."""
    try:
        material = inert(entry)
    except DeckError as error:
        return {"none": error.problems[0].message}
    limit, words = beyond_data(material)
    found = {"title": entry.title, "unreacted": reacted(entry), "law": parameters(material.eos),
             "beyond": {"limit": limit, "words": words} if words else None, "split": split_of(entry),
             "of_law": about_law(material), "warnings": about_shock(material),
             "burns": entry.category.startswith("explosive") and entry.unreacted is not None}
    known = fits.of_law(entry.rows, material.eos)
    return found if known is None else found | {"bands": {"names": known[0], "covariance": known[1]}}
