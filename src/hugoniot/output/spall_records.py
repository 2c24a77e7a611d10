"""Where the spall signal of a run can be seen: the regions that were hit and that broke, and the velocity records at their ends.

A body is hit where a faster one runs into it; in a run without an impact every body is. Its spall signal is seen at the end that looks
away from the impact: a free surface, or the interface with a window.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library
from hugoniot.output.result_columns import history, record_by_record

SURFACE, INTERFACE = "free surface", "interface"
OUTWARD = 1e-3        # of the largest speed of a record: less is round-off, or what a wave sends ahead of it


@dataclass(frozen=True)
class Record:
    """A velocity record as an interferometer sees it: velocity (m/s, outwards positive) over time (s).

    gauge   name of the gauge, "" for the snapshots' right face; kind SURFACE, INTERFACE or ""; region whose end it is, "" if unknown;
    window  the region behind the interface, transparent or not; source how it was recorded, in words;
    start   the velocity before the first wave, m/s; ahead the region across the gap in front of a free surface, "" if there is none
    outward 1 where outwards is along x, -1 where it is against it: velocity times outward is that of the gauge
    """

    time: np.ndarray
    velocity: np.ndarray
    gauge: str = ""
    kind: str = SURFACE
    region: str = ""
    window: str = ""
    source: str = ""
    start: float = 0.0
    ahead: str = ""
    outward: float = 1.0


def called(setup, region: str) -> str:
    """A region behind an interface in words: a window only where a gauge looks through it, or the library has an index of its material."""
    material = next((r.get("material", "") for r in setup["regions"] if r["name"] == region), "")
    transparent = any(gauge.get("window") == region for gauge in setup.get("gauges", ())) or bool(material and library.windows(material))
    return f"the window '{region}'" if transparent else f"'{region}'"


def hit_regions(setup) -> list[str]:
    """Names of the regions that belong to a body which a faster one runs into; all of them where nothing strikes anything,
    and in two dimensions."""
    regions = setup["regions"]
    if "axes" in setup:
        return [region["name"] for region in regions]
    speeds = [float(np.mean(region["velocity"])) for region in regions]
    impacts = [(a, b) for a, b in zip(range(len(regions)), range(1, len(regions))) if speeds[a] > speeds[b]]
    if not impacts:
        return [region["name"] for region in regions]
    striking = {max(pair, key=lambda k: abs(speeds[k])) for pair in impacts if abs(speeds[pair[0]]) != abs(speeds[pair[1]])}
    # the flyer and what flies with it
    fast = {speeds[k] for k in striking}
    return [region["name"] for region, speed in zip(regions, speeds) if speed not in fast]


def _away(setup) -> list[tuple[str, ...]]:
    """For every region the sides that look away from what strikes or drives it: its spall signal comes out there."""
    names, hit = [region["name"] for region in setup["regions"]], hit_regions(setup)
    striking = [k for k, name in enumerate(names) if name not in hit]
    driven = [side for side in ("left", "right") if setup["boundaries"][side]["kind"] in ("pressure", "velocity")]
    found: list[tuple[str, ...]] = []
    for k, name in enumerate(names):
        before = any(other < k for other in striking) if striking else driven == ["left"]
        behind = any(other > k for other in striking) if striking else driven == ["right"]
        one_sided = name in hit and before != behind
        found.append(("right" if before else "left",) if one_sided else ("right", "left"))
    return found


def explosives(setup) -> set[str]:
    """Names of the regions that burn or begin as detonation products: they drive what they touch, and no spall signal comes out there."""
    laws = {name: material["laws"] for name, material in setup.get("materials", {}).items()}
    burning = {name for name, found in laws.items() if any(_burns(law) for law in found)}
    return {region["name"] for region in setup["regions"] if region.get("material") in burning}


def _burns(law: Mapping) -> bool:
    return law["family"] == "burn" or law["family"] == "eos" and law["law"] in EOS.names() and "reacted" in EOS.get(law["law"]).flags


def ends(setup) -> list[tuple[str, str, str, tuple[str, ...]]]:
    """(region, kind, window, places of a gauge there) of every end at which a region's spall signal can be seen."""
    regions, found, away, driving = setup["regions"], [], _away(setup), explosives(setup)
    for k, region in enumerate(regions):
        name = region["name"]
        for side, other in (("right", k + 1), ("left", k - 1)):
            own = f"{name}:{side}"
            if side not in away[k]:
                continue
            if not 0 <= other < len(regions):
                if setup["boundaries"][side]["kind"] == "free":
                    found.append((name, SURFACE, "", (f"free surface {side}", own)))
                continue
            gap = regions[other]["start"] - region["end"] if side == "right" else region["start"] - regions[other]["end"]
            if gap > 0.0:
                found.append((name, SURFACE, "", (own,)))
            elif driving & {name, regions[other]["name"]}:
                continue
            elif np.mean(region["velocity"]) == np.mean(regions[other]["velocity"]):    # else it is where they collide
                pair = f"{name}/{regions[other]['name']}" if side == "right" else f"{regions[other]['name']}/{name}"
                found.append((name, INTERFACE, regions[other]["name"], (pair, own)))
    return found


def records(run) -> list[Record]:
    """The records of every gauge at a free surface or an interface: bodies that were hit first, inert ones before explosives, then
    gauges that the deck names, free surfaces before windows."""
    if not run.gauge_names() or "axes" in run.setup:     # of two dimensions no end is the free surface
        return []
    at = {gauge["name"]: str(gauge["at"]) for gauge in run.setup["gauges"]}
    hit, driving, found = hit_regions(run.setup), explosives(run.setup), []
    names = [region["name"] for region in run.setup["regions"]]
    for region, kind, window, places in ends(run.setup):
        name = next((name for place in places for name in run.gauge_names() if at.get(name, name) == place), None)
        if name is not None:
            time, velocity = run.gauge("velocity", name)
            leftward = places[0].endswith("left") if kind == SURFACE else places[1].endswith(":left")
            sign = -1.0 if leftward else 1.0
            outward = sign * velocity
            other = names.index(region) + (-1 if leftward else 1)
            ahead = names[other] if kind == SURFACE and 0 <= other < len(names) else ""
            ends_at = np.ravel(run.setup["regions"][names.index(region)]["velocity"])
            start = sign * float(ends_at[0 if leftward else -1])     # the first sample may lie behind a wave that starts here
            found.append(Record(time, outward, name, kind, region, window, f"gauge '{name}'", start, ahead, sign))
    return sorted(found, key=lambda r: (r.region not in hit, r.region in driving, at.get(r.gauge) == r.gauge, r.kind != SURFACE))


def surface_record(run, name: str | None = None) -> Record:
    """What a velocity interferometer would record: of the gauge `name`, else of the body that was hit, else of the snapshots' right face.

    Of several ends that may be seen, the first that moved outwards: a face that another body strikes across a gap does not.
    Empty where the right end is not free and no gauge rides on a free surface or an interface.
    """
    seen = [record for record in records(run) if name in (None, record.gauge)]
    if name is not None and not seen:
        time, velocity = run.gauge("velocity", name)
        return Record(time, velocity, name, "", source=f"gauge '{name}'", start=first(velocity))
    if seen:
        hit, driving = hit_regions(run.setup), explosives(run.setup)
        rank = [(record.region in hit, record.region in driving) for record in seen]
        return next((record for record, own in zip(seen, rank) if own == rank[0] and _moved_out(record)), seen[0])
    rows = run.arrays("snapshots")
    if "axes" in run.setup or run.setup["boundaries"]["right"]["kind"] != "free" or "velocity_right" not in rows:
        return Record(np.empty(0), np.empty(0), source="nothing")
    velocity = history(rows, "velocity_right", -1)
    return Record(rows["time"], velocity, region=run.setup["regions"][-1]["name"], start=first(velocity),
                  source="the snapshots only; a gauge at 'free surface right' would record it more finely")


def _moved_out(record: Record) -> bool:
    """Whether more than round-off of the change of its motion was outwards."""
    change = record.velocity - record.start
    return bool(np.max(change, initial=0.0) > OUTWARD * np.max(np.abs(change), initial=0.0))


def first(velocity) -> float:
    """Velocity with which a record begins, m/s; zero if it is empty."""
    return float(velocity[0]) if len(velocity) else 0.0


def struck(run, record: Record) -> float:
    """When a free surface met the region ahead of it, s; inf if it never did."""
    return _first_event(run, record.region, record.ahead, ("void_closed",))


def separated(run, record: Record) -> float:
    """When an interface first opened between a region and its window, s; inf if it never did."""
    return _first_event(run, record.region, record.window, ("interface_separated", "void_opened"))


def _first_event(run, one: str, other: str, kinds: tuple[str, ...]) -> float:
    """When one of these events first happened between two regions, s; inf if it never did, or there is no other region."""
    rows = run.arrays("events")
    found = [float(time) for kind, text, time in zip(rows["kind"], rows["text"], rows["time"])
             if kind in kinds and other and set(re.findall(r"'(.*?)'", str(text))) == {one, other}]
    return min(found, default=float("inf"))


def spalled_regions(run) -> dict[str, float]:
    """When the first void opened (s), by region, in the order of the events."""
    rows = run.arrays("events")
    names = [region["name"] for region in run.setup["regions"]]
    found: dict[str, float] = {}
    for kind, text, time, numbers in zip(rows["kind"], rows["text"], rows["time"], rows["numbers"]):
        if kind == "void_opened":
            name = region_named(str(text), names) or _region_at(run, float(time), str(numbers))
            found.setdefault(name, float(time))
    return {name: time for name, time in found.items() if name}


def region_named(text: str, names) -> str:
    """The region in which a void opened, from the text of its event; "" where that names two or none."""
    inside = re.search(r" in '(.*)' at ", text)
    return inside[1] if inside and inside[1] in names else ""


def _region_at(run, time: float, numbers: str) -> str:
    """The region at the place of an event, from the snapshot nearest in time; "" if the event has no place."""
    place = re.search(r'"position": ([-+.\deE]+)', numbers)
    rows = run.arrays("snapshots")
    if place is None or "position_left" not in rows or not len(rows["time"]):
        return ""
    k = int(np.argmin(np.abs(rows["time"] - time)))
    centres = 0.5 * (record_by_record(rows, "position_left")[k] + record_by_record(rows, "position_right")[k])
    return str(rows["region"][int(np.argmin(np.abs(centres - float(place[1]))))])
