"""How far the Hugoniots of the page go, and what it says where no single shock leads to a state: the wave splits in two."""

from typing import Any

from hugoniot.errors import HugoniotError
from hugoniot.explorer.subjects import inert, own
from hugoniot.laws.eos.contract import flagged
from hugoniot.materials.entry import Entry
from hugoniot.materials.validity import rounded
from hugoniot.theory.hugoniot import Initial, limit, shock
from hugoniot.theory.split import split_range

REACH = 8000.0      # m/s: as far as splits are looked for


def farthest(material, ahead: Initial, wanted: float) -> float:
    """A particle velocity, m/s, to which a shock leads: the wanted one, or just before the end of the Hugoniot. The state of highest
    density is no end for strongly porous material, whose density falls again behind stronger shocks."""
    try:
        shock(material, ahead, particle_velocity=ahead.velocity + wanted)
    except HugoniotError:
        return min(wanted, 0.95 * float(limit(material, ahead).particle_velocity))
    return wanted


def split_of(entry: Entry) -> dict[str, Any] | None:
    """`low` and `high`: the jumps of the particle velocity (m/s) between which a shock from rest splits; `words` for one of them, with {up}
    in its place, and `range` for all. None for a material whose shocks hold together; of the library only pores make them split."""
    material = inert(entry)
    if entry.name not in own and not flagged(material.eos, "remembers"):
        return None
    ahead = Initial.at_rest(material)
    try:
        found = split_range(material, ahead, farthest(material, ahead, REACH))
    except HugoniotError:
        return None
    if found is None:
        return None
    runs = "a faster precursor runs ahead; hugoniot eos hugoniot --at gives the states behind both waves"
    return {"low": found[0], "high": found[1], "words": f"no single shock leads to up = {{up}} m/s in {entry.name}: {runs}",
            "range": f"{entry.title}: from {rounded(found[0])} to {rounded(found[1])} no single shock exists: {runs}"}


def about_split(entry: Entry, jump: float) -> list[str]:
    """The remark on a shock from rest that changes the particle velocity by `jump`, m/s; none where it holds together."""
    split = split_of(entry)
    return [split["words"].replace("{up}", f"{jump:.6g}")] if split and split["low"] <= jump <= split["high"] else []
