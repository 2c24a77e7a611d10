r"""The spall strength that an experimenter would read from a run: from the body that was hit, on its own surface, with its own constants.

A body is hit where a faster one runs into it; in a run without an impact every body is. Its spall signal is seen at the end that looks
away from the impact: a free surface, or the interface with a window. There

$$\sigma = \tfrac12\left[Z\,(u_1 - u_2) - \sigma_w(u_1) - \sigma_w(u_2)\right], \qquad Z = \rho_0 c_0$$

is the tension at the spall plane: its two characteristics carry the state at the peak u_1 and at the minimum u_2 of the record, and
the window holds the stress of its own Hugoniot, sigma_w(u) = rho_w (c_w + s_w u) u. At a free surface sigma_w = 0 and the formula is
the acoustic one of `diagnostics.velocimetry`.
"""

import re
from dataclasses import dataclass, field

import numpy as np

from hugoniot.diagnostics.velocimetry import (
    PullBack,
    erosion,
    kanel_correction,
    pull_back,
    ringing_period,
    spall_strength,
    spall_thickness,
)
from hugoniot.output.result_columns import history, record_by_record
from hugoniot.output.run import largest_value

LEAST_SIGNAL = 0.4      # part of Z (u1 - u2) that the correction for a window must leave: errors of a velocity grow by its inverse
LARGEST_MISS = 0.1      # of the pull-back: by how much the minimum may lie below the lowest record
LARGEST_LOSS = 1.0      # of the pull-back: Kanel's correction takes the slopes of the record as constant over what was lost
LOST = 0.02             # of the pull-back: gentle pulses lose 1 %, those of impacts 4 % or more (on a mesh, which flattens slopes)
NOISE = 1e-6            # of the largest speed of a run: what a gauge sees of a wave that has not come yet is less
SURFACE, WINDOW = "free surface", "window interface"


@dataclass(frozen=True)
class Record:
    """A velocity record as an interferometer sees it: velocity (m/s, outwards positive) over time (s).

    gauge   name of the gauge, "" for the snapshots' right face; kind SURFACE, WINDOW or ""; region whose end it is, "" if unknown;
    window  the region behind the interface; source how it was recorded, in words
    """

    time: np.ndarray
    velocity: np.ndarray
    gauge: str = ""
    kind: str = SURFACE
    region: str = ""
    window: str = ""
    source: str = ""


@dataclass(frozen=True)
class Reading:
    """numbers (SI; empty if there is no reading) and, if something broke but no strength can be read, the reason.

    note   what limits the strength that is given
    """

    numbers: dict[str, float] = field(default_factory=dict)
    reason: str = ""
    note: str = ""
    record: Record | None = None
    found: PullBack | None = None


def free_surface_gauges(run) -> list[str]:
    """Names of the gauges that ride on a free surface, those of a body that was hit first, then the right-hand one."""
    names = set(run.gauge_names())
    at = {gauge["name"]: str(gauge["at"]) for gauge in run.setup["gauges"]}
    found = [name for name, where in at.items() if where.startswith("free surface") and name in names]
    found += [name for name in sorted(names) if name.startswith("free surface") and name not in found]
    hit, regions = hit_regions(run.setup), run.setup["regions"]

    def rank(name):
        left = "left" in at.get(name, name)
        return (regions[0 if left else -1]["name"] not in hit, left)

    return sorted(found, key=rank)


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


def _ends(setup) -> list[tuple[str, str, str, tuple[str, ...]]]:
    """(region, kind, window, places of a gauge there) of every end at which a region's spall signal can be seen."""
    regions, found, away = setup["regions"], [], _away(setup)
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
            elif np.mean(region["velocity"]) == np.mean(regions[other]["velocity"]):    # else it is where they collide
                pair = f"{name}/{regions[other]['name']}" if side == "right" else f"{regions[other]['name']}/{name}"
                found.append((name, WINDOW, regions[other]["name"], (pair, own)))
    return found


def records(run) -> list[Record]:
    """The records of every gauge at a free surface or a window interface: bodies that were hit first,
    then gauges that the deck names, free surfaces before windows."""
    if not run.gauge_names() or "axes" in run.setup:     # of two dimensions no end is the free surface
        return []
    at = {gauge["name"]: str(gauge["at"]) for gauge in run.setup["gauges"]}
    hit, found = hit_regions(run.setup), []
    for region, kind, window, places in _ends(run.setup):
        name = next((name for place in places for name in run.gauge_names() if at.get(name, name) == place), None)
        if name is not None:
            time, velocity = run.gauge("velocity", name)
            leftward = places[0].endswith("left") if kind == SURFACE else places[1].endswith(":left")
            found.append(Record(time, -velocity if leftward else velocity, name, kind, region, window, f"gauge '{name}'"))
    return sorted(found, key=lambda r: (r.region not in hit, at.get(r.gauge) == r.gauge, r.kind != SURFACE))


def surface_record(run, name: str | None = None) -> Record:
    """What a velocity interferometer would record: of the gauge `name`, else of the body that was hit, else of the snapshots' right face.

    Empty where the right end is not free and no gauge rides on a free surface or a window interface.
    """
    seen = [record for record in records(run) if name in (None, record.gauge)]
    if name is not None and not seen:
        time, velocity = run.gauge("velocity", name)
        return Record(time, velocity, name, "", source=f"gauge '{name}'")
    if seen:
        return seen[0]
    rows = run.arrays("snapshots")
    if "axes" in run.setup or run.setup["boundaries"]["right"]["kind"] != "free" or "velocity_right" not in rows:
        return Record(np.empty(0), np.empty(0), source="nothing")
    return Record(rows["time"], history(rows, "velocity_right", -1), region=run.setup["regions"][-1]["name"],
                  source="the snapshots only; a gauge at 'free surface right' would record it more finely")


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


def constants_of(run, region: str) -> dict[str, float]:
    """rho0 (kg/m3), c_bulk, c_long (m/s) and s of a region's material at rest, as far as they are known."""
    name = next(r["material"] for r in run.setup["regions"] if r["name"] == region)
    material = run.setup["materials"][name]
    known = {c["name"]: c["value"] for law in reversed(material["laws"]) for c in law["constants"] if isinstance(c["value"], (int, float))}
    rest = material.get("at_rest", {})
    rho0, bulk = rest.get("density", known.get("rho0")), rest.get("bulk_sound_speed", known.get("c0"))
    if not rho0 or not bulk:
        return {}
    shear = known.get("shear_modulus") or 0.0
    long = rest.get("longitudinal_sound_speed", bulk if rest else float(np.sqrt(bulk**2 + 4.0 * shear / (3.0 * rho0))))
    return {"rho0": rho0, "c_bulk": bulk, "c_long": long, "s": float(known.get("s", 0.0)) if known.get("c0") else 0.0}


def spall_reading(run, name: str | None = None) -> Reading:
    """What an experimenter would read from the run: pull-back (m/s), spall strength (Pa), thickness of the spalled layer (m).

    name   gauge to read; default the one on the free surface or window interface of a region that was hit and broke
    """
    broken = {} if "axes" in run.setup else spalled_regions(run)
    if not broken:
        return Reading()
    hit = [region for region in broken if region in hit_regions(run.setup)]
    if not hit:
        return Reading(reason=f"voids opened only in the impactor ({_listed(broken)}), not in a target")
    seen = [record for record in records(run) if record.region in hit and name in (None, record.gauge)]
    if not seen and name is None:
        seen = [record for record in (surface_record(run),) if record.region in hit and len(record.time)]
    if not seen:
        places = sorted({places[0] for region, _, _, places in _ends(run.setup) if region in hit})
        hint = f"; add one at {_listed(places)}" if places and name is None else ""
        where = "no gauge is" if name is None else f"gauge '{name}' is not"
        return Reading(reason=f"{where} on a free surface or window interface of {_listed(hit)}, in which the void opened{hint}")
    read = [read_record(run, record, broken[record.region]) for record in seen]
    return next((reading for reading in read if reading.numbers), read[0])


def _listed(names) -> str:
    return ", ".join(f"'{name}'" for name in names)


def read_record(run, record: Record, opened: float = -np.inf) -> Reading:
    """The numbers of one record of a region that broke at the time `opened` (s), or why there are none."""
    if not np.max(record.velocity, initial=0.0) > NOISE * largest_value(run, "velocity"):
        return Reading(reason=f"no wave reached {record.source} before the end of the run", record=record)
    found = pull_back(record.time, record.velocity)
    if found is None:
        reason = f"the velocity at {record.source} shows no pull-back (a drop of at least 4 % of its peak and a rebound above 2 %)"
        return Reading(reason=reason, record=record)
    if found.rebound_time <= opened:
        reason = f"the pull-back at {record.source} came before the first void of '{record.region}' opened, so it is not a spall signal"
        return Reading(reason=reason, record=record)
    if (missed := _missed(record, found)) > LARGEST_MISS:
        reason = (f"the records at {record.source} are too sparse: between two of them the velocity may fall by another {missed:.0%} of "
                  f"the pull-back, and a reliable reading needs less than {LARGEST_MISS:.0%}; reduce gauge_interval")
        return Reading({"peak_velocity": found.peak}, reason, record=record)
    window = constants_of(run, record.window) if record.window else None
    if window == {}:
        return Reading(reason=f"the impedance of the window '{record.window}' is not known", record=record, found=found)
    body = constants_of(run, record.region)
    numbers = reading_of(record.time, record.velocity, found, body, window)
    if window and body:
        signal = body["rho0"] * body["c_bulk"] * found.drop
        left = 2.0 * numbers["spall_strength_acoustic"] / signal
        if left < LEAST_SIGNAL:
            reason = (f"the stress carried by the window '{record.window}' leaves only {max(left, 0.0):.0%} of the pull-back for the "
                      f"spall strength; a reliable reading needs {LEAST_SIGNAL:.0%}")
            numbers = {key: value for key, value in numbers.items() if not key.startswith("spall_strength")}
            return Reading(numbers, reason, record=record, found=found)
    note = _eroded(numbers) or _overtaken(record, found, body, opened, numbers)
    if note:        # Stepanov's formula rests on the same pull-back and is no bound
        numbers.pop("spall_strength_stepanov", None)
    return Reading(numbers, "", note, record, found)


def _eroded(numbers: dict[str, float]) -> str:
    """A note where the elastic front took so much of the pull-back that no correction gives it back."""
    if not numbers.get("pull_back_lost", 0.0) > LARGEST_LOSS * numbers["pull_back"]:
        return ""
    part = numbers["pull_back_lost"] / numbers["pull_back"]
    return ("the acoustic strength is a lower bound: "
            f"the erosion of the pull-back by the elastic front is estimated at up to {part:.0%} of its size, too much for "
            "Kanel's correction")


def _overtaken(record: Record, found: PullBack, body: dict, opened: float, numbers: dict[str, float]) -> str:
    """A note where the front from the spall plane overtook tension on its way to the surface, and no correction was made for that.

    With the way h from the plane to the surface, by the time since the void opened, the elastic front leads by h/c_b - h/c_l; without
    strength the recompression is a shock, which gains h s (drop/2) / c_b^2 on the tension ahead of it.
    """
    if not body or "spall_strength_kanel" in numbers or not np.isfinite(opened):
        return ""
    bulk, long = body["c_bulk"], body["c_long"]
    way = long * (found.minimum_time - opened)
    strong = long > bulk
    lead = way / bulk - way / long if strong else 0.5 * way * body["s"] * found.drop / bulk**2
    part = erosion(record.time, record.velocity, found, lead) / found.drop
    if not part > LOST:
        return ""
    if strong:
        return (f"the acoustic strength is a lower bound: the elastic front eroded up to {part:.0%} of the pull-back, and Kanel's "
                "correction for that needs a run long enough for the surface to ring")
    return ("the acoustic strength is a lower bound: the pulse falls so steeply that the shock from the spall plane eroded "
            f"at least {part:.0%} of the pull-back")


def _missed(record: Record, found: PullBack) -> float:
    """How much lower the velocity may have fallen before the next record, at the slope it had, in parts of the pull-back."""
    k = int(np.searchsorted(record.time, found.minimum_time))
    before, after = record.time[k] - record.time[k - 1], record.time[k + 1] - record.time[k]
    return float((record.velocity[k - 1] - record.velocity[k]) * after / before / found.drop)


def reading_of(time, velocity, found: PullBack, constants: dict, window: dict | None = None) -> dict[str, float]:
    """The numbers of a reading from a record, its pull-back and the constants of `constants_of` (of the body, and of its window)."""
    result = {"peak_velocity": found.peak, "pull_back": found.drop, "minimum_time": found.minimum_time}
    period = ringing_period(time, velocity, found.minimum_time)
    if np.isfinite(period):
        result["ringing_period"] = period
    if not constants:
        return result
    rho0, c_bulk, c_long = constants["rho0"], constants["c_bulk"], constants["c_long"]
    result["spall_strength_acoustic"] = through_window(found.peak, found.minimum, rho0 * c_bulk, window)
    if c_long > c_bulk and not window:
        result["spall_strength_stepanov"] = spall_strength(found.drop, rho0, c_bulk, c_long)
    if np.isfinite(period):
        thickness = result["spall_thickness"] = spall_thickness(period, c_long)
        if c_long > c_bulk:
            lost = kanel_correction(time, velocity, found, thickness, c_bulk, c_long)
            result["pull_back_lost"] = lost
            if lost <= LARGEST_LOSS * found.drop:
                result["spall_strength_kanel"] = through_window(found.peak, found.minimum - lost, rho0 * c_bulk, window)
    return result


def through_window(peak: float, minimum: float, impedance: float, window: dict | None = None) -> float:
    """Spall strength (Pa) from the velocities at peak and minimum (m/s), the body's impedance (kg/m2/s) and the window's constants."""
    held = 0.0
    for velocity in (peak, minimum) if window else ():
        held += window["rho0"] * (window["c_bulk"] + window["s"] * abs(velocity)) * velocity
    return 0.5 * (impedance * (peak - minimum) - held)
