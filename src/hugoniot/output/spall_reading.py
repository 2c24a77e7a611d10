r"""The spall strength that an experimenter would read from a run: from the body that was hit, on its own surface, with its own constants.

A body is hit where a faster one runs into it; in a run without an impact every body is. Its spall signal is seen at the end that looks
away from the impact: a free surface, or the interface with a window. There

$$\sigma = \tfrac12\left[Z\,(u_1 - u_2) - \sigma_w(u_1) - \sigma_w(u_2)\right], \qquad Z = \rho_0 c_0$$

is the tension at the spall plane: its two characteristics carry the state at the peak u_1 and at the minimum u_2 of the record, and
the window holds the stress of its own Hugoniot, sigma_w(u) = rho_w (c_w + s_w u) u. At a free surface sigma_w = 0 and the formula is
the acoustic one of `diagnostics.velocimetry`.
"""

from dataclasses import dataclass, field, replace

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
from hugoniot.output.run import largest_value
from hugoniot.output.spall_records import Record, called, ends, hit_regions, records, separated, spalled_regions, struck, surface_record
from hugoniot.units import format_si

LEAST_SIGNAL = 0.4      # part of Z (u1 - u2) that the correction for a window must leave: errors of a velocity grow by its inverse
LARGEST_MISS = 0.1      # of the pull-back: by how much the minimum may lie below the lowest record
LARGEST_LOSS = 1.0      # of the pull-back: Kanel's correction takes the slopes of the record as constant over what was lost
LOST = 0.02             # of the pull-back: gentle pulses lose 1 %, those of impacts 4 % or more (on a mesh, which flattens slopes)
LEAST_PRESSURE = 1e-4   # of rho c^2: an initial pressure below it moves a surface by less than 1e-4 c
LEAST_MINIMUM = 0.25    # of the pull-back: how deep the minima of the ringing are
NOISE = 1e-6            # of the largest speed of a run: what a gauge sees of a wave that has not come yet is less


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


def constants_of(run, region: str) -> dict[str, float]:
    """rho0 (kg/m3), c_bulk, c_long (m/s) and s of a region's material in the state in which it starts, as far as they are known."""
    record = next(r for r in run.setup["regions"] if r["name"] == region)
    material = run.setup["materials"][record["material"]]
    known = {c["name"]: c["value"] for law in reversed(material["laws"]) for c in law["constants"] if isinstance(c["value"], (int, float))}
    rest = record.get("starts") or material.get("at_rest", {})
    rho0, bulk = rest.get("density", known.get("rho0")), rest.get("bulk_sound_speed", known.get("c0"))
    if not rho0 or not bulk:
        return {}
    shear = known.get("shear_modulus") or 0.0
    long = rest.get("longitudinal_sound_speed", bulk if rest else float(np.sqrt(bulk**2 + 4.0 * shear / (3.0 * rho0))))
    slope = rest.get("hugoniot_slope", known.get("s", np.nan) if known.get("c0") else np.nan)
    return {"rho0": rho0, "c_bulk": bulk, "c_long": long, "s": float(slope)}


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
        places = sorted({places[0] for region, _, _, places in ends(run.setup) if region in hit})
        hint = f"; add one at {_listed(places)}" if places and name is None else ""
        where = "no gauge is" if name is None else f"gauge '{name}' is not"
        return Reading(reason=f"{where} on a free surface or interface of {_listed(hit)}, in which the void opened{hint}")
    read = [read_record(run, record, broken[record.region]) for record in seen]
    return next((reading for reading in read if reading.numbers), read[0])


def _listed(names) -> str:
    return ", ".join(f"'{name}'" for name in names)


def read_record(run, record: Record, opened: float = -np.inf) -> Reading:
    """The numbers of one record of a region that broke at the time `opened` (s), or why there are none."""
    if not np.max(np.abs(record.velocity - record.start), initial=0.0) > NOISE * largest_value(run, "velocity"):
        return Reading(reason=f"no wave reached {record.source} before the end of the run", record=record)
    free = record.time < (met := struck(run, record))     # what comes after is the impact on another body
    before = replace(record, time=record.time[free], velocity=record.velocity[free])
    found = pull_back(before.time, before.velocity, start=record.start)
    if found is None:
        until = f" before it met '{record.ahead}' at {format_si(met, 's', 4)}" if np.isfinite(met) else ""
        reason = (f"the velocity at {record.source} shows no pull-back{until} (a drop of at least 4 % of its largest change and a rebound "
                  "above 2 %)")
        return Reading(reason=reason, record=record)
    if found.rebound_time <= opened:
        reason = f"the pull-back at {record.source} came before the first void in '{record.region}' opened, so it is not a spall signal"
        return Reading(reason=reason, record=record)
    if (missed := _missed(before, found)) > LARGEST_MISS:
        reason = (f"the records at {record.source} are too sparse: between two samples the velocity may fall by another {missed:.0%} of "
                  f"the pull-back, and a reliable reading needs less than {LARGEST_MISS:.0%}; reduce gauge_interval")
        return Reading({"peak_velocity": found.peak}, reason, record=record)
    if reason := _unfit_start(run, record.region) or (_unfit_start(run, record.window) if record.window else ""):
        return Reading(reason=reason, record=record, found=found)
    window = constants_of(run, record.window) if record.window else None
    if window is not None and not np.isfinite(window.get("s", np.nan)):
        return Reading(reason=f"the impedance of {called(run.setup, record.window)} is not known", record=record, found=found)
    body = constants_of(run, record.region)
    held = window is not None and separated(run, record) > found.minimum_time
    numbers = reading_of(before.time, before.velocity, found, body, window, record.start, held)
    if window and body:
        signal = body["rho0"] * body["c_bulk"] * found.drop
        left = 2.0 * numbers["spall_strength_acoustic"] / signal
        if left < LEAST_SIGNAL:
            reason = (f"the stress carried by {called(run.setup, record.window)} leaves only {max(left, 0.0):.0%} of the pull-back for the "
                      f"spall strength; a reliable reading needs {LEAST_SIGNAL:.0%}")
            numbers = {key: value for key, value in numbers.items() if not key.startswith("spall_strength")}
            return Reading(numbers, reason, record=record, found=found)
    note = _eroded(numbers) or _overtaken(before, found, body, opened, numbers)
    if note:        # Stepanov's formula rests on the same pull-back and is no bound
        numbers.pop("spall_strength_stepanov", None)
    return Reading(numbers, "", note, record, found)


def _unfit_start(run, region: str) -> str:
    """Why the formulas, which start from a uniform state free of stress, do not hold for a region; "" where they do."""
    start = next((r for r in run.setup["regions"] if r["name"] == region), {})
    profile = start.get("profile") or {}
    if any(name != "velocity" for name, _ in profile.get("fields", ())):
        return f"'{region}' starts in a state that varies along it, and the formulas for the spall strength need a uniform one"
    state = start.get("starts", {})
    stiffness = state["density"] * state["bulk_sound_speed"] ** 2 if state else 0.0
    if state and abs(state["pressure"]) > LEAST_PRESSURE * stiffness:
        return (f"'{region}' starts under a pressure of {format_si(state['pressure'], 'Pa', 4)}, and the formulas for the spall strength "
                "need a body that is free of stress")
    return ""


def _eroded(numbers: dict[str, float]) -> str:
    """A note where the elastic front took so much of the pull-back that no correction gives it back."""
    if not numbers.get("pull_back_lost", 0.0) > LARGEST_LOSS * numbers["pull_back"]:
        return ""
    part = numbers["pull_back_lost"] / numbers["pull_back"]
    return ("the acoustic strength is a lower bound: "
            f"the elastic front may have eroded the pull-back by up to {part:.0%} of the value recorded, too much for Kanel's correction")


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
        return (f"the acoustic strength is a lower bound: the elastic front eroded up to {part:.0%} of the pull-back; Kanel's "
                "correction needs a run that lasts until the surface velocity has rung (a later stop_time)")
    return ("the acoustic strength is a lower bound: the pulse falls so steeply that the shock from the spall plane eroded "
            f"at least {part:.0%} of the pull-back")


def _missed(record: Record, found: PullBack) -> float:
    """How much lower the velocity may have fallen before the next record, at the slope it had, in parts of the pull-back."""
    k = int(np.searchsorted(record.time, found.minimum_time))
    before, after = record.time[k] - record.time[k - 1], record.time[k + 1] - record.time[k]
    return float((record.velocity[k - 1] - record.velocity[k]) * after / before / found.drop)


def reading_of(time, velocity, found: PullBack, constants: dict, window: dict | None = None, start: float = 0.0,
               held: bool = True) -> dict[str, float]:
    """The numbers of a reading from a record, its pull-back and the constants of `constants_of` (of the body, and of its window).

    start is the velocity of the surface before the first wave, m/s; held whether the window still touches the body at the minimum.
    """
    result = {"peak_velocity": found.peak, "pull_back": found.drop, "minimum_time": found.minimum_time}
    # a ripple on the tops of the ringing is no minimum
    least = max(0.01, LEAST_MINIMUM * found.drop / float(np.max(np.abs(velocity - start))))
    period = ringing_period(time, velocity, found.minimum_time, least, start)
    if np.isfinite(period):
        result["ringing_period"] = period
    if not constants:
        return result
    rho0, c_bulk, c_long = constants["rho0"], constants["c_bulk"], constants["c_long"]
    result["spall_strength_acoustic"] = through_window(found.peak - start, found.minimum - start, rho0 * c_bulk, window, held)
    if c_long > c_bulk and not window:
        result["spall_strength_stepanov"] = spall_strength(found.drop, rho0, c_bulk, c_long)
    if np.isfinite(period):
        thickness = result["spall_thickness"] = spall_thickness(period, c_long)
        if c_long > c_bulk:
            lost = kanel_correction(time, velocity, found, thickness, c_bulk, c_long)
            result["pull_back_lost"] = lost
            if lost <= LARGEST_LOSS * found.drop:
                result["spall_strength_kanel"] = through_window(found.peak - start, found.minimum - start - lost, rho0 * c_bulk, window,
                                                                held)
    return result


def through_window(peak: float, minimum: float, impedance: float, window: dict | None = None, held: bool = True) -> float:
    """Spall strength (Pa) from the velocities at peak and minimum (m/s, relative to that before the first wave), the body's impedance
    (kg/m2/s) and the window's constants. A window that has separated before the minimum (held = False) carries no stress there."""
    carried = 0.0
    for velocity in ((peak, minimum) if held else (peak,)) if window else ():
        carried += window["rho0"] * (window["c_bulk"] + window["s"] * abs(velocity)) * velocity
    return 0.5 * (impedance * (peak - minimum) - carried)
