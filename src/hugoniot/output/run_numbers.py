"""The numbers of a finished run that terminal, report and JSON show: each is found here, once."""

import itertools
import re
from collections.abc import Mapping

import numpy as np

from hugoniot.diagnostics.arrival import arrivals
from hugoniot.diagnostics.interface_gauges import sides
from hugoniot.diagnostics.velocimetry import durations, flat_stretch, level_over
from hugoniot.output.columns import PER_AREA
from hugoniot.output.focus import at_focus
from hugoniot.output.run import Run, largest_value
from hugoniot.output.spall_reading import NOISE, spall_reading
from hugoniot.output.spall_records import SURFACE, surface_record
from hugoniot.problem.forming import settled
from hugoniot.units import format_si

ROUND_OFF = 1e-12     # of the largest value of a run: what is smaller is the round-off of a state at rest
GAUGE_UNITS = {"arrival": "s", "second_arrival": "s", "peak_stress": "Pa", "plateau_stress": "Pa", "lowest_stress": "Pa",
               "peak_pressure": "Pa", "plateau_pressure": "Pa", "lowest_pressure": "Pa",
               "peak_velocity": "m/s", "plateau_velocity": "m/s", "last_velocity": "m/s"}
IN_PLANE = ("velocity: the speed of a material point; along the outward normal on a side (on a joint, from its first block to its second); "
            "along a line of sight")
SPALL = (("peak_velocity", "velocity before the pull-back", "m/s"), ("pull_back", "pull-back", "m/s"),
         ("spall_strength_acoustic", "spall strength, acoustic", "Pa"),
         ("spall_strength_kanel", "spall strength with Kanel's correction", "Pa"),
         ("spall_thickness", "spalled layer", "m"))


def is_lower_bound(key: str, spall: Mapping) -> bool:
    """Whether a number of `spall_numbers` is a lower bound: the acoustic strength, where the note says what eroded the pull-back."""
    return key == "spall_strength_acoustic" and "note" in spall


def gauge_rows(run: Run) -> list[dict]:
    """Per gauge, SI: arrival of the first wave in the velocity (`diagnostics.arrival`; NaN where nothing came), then peak, plateau and
    end of stress and velocity.

    In two dimensions material points have the pressure in place of the stress, and `IN_PLANE` says which velocity a gauge has; the arrival
    at a point is that of a change of its velocity as a vector. A gauge whose zone or surface is lost counts up to then and has no end.

    `second_arrival`, that of the plastic wave behind a precursor, stands in all rows if a gauge of the run has one, else in none; both
    waves compress, by the stress or, on a free side, by the velocity out of the body. A peak may be the short overshoot of a numerical
    shock; the plateaus are the levels of one flat top without it, behind the first wave: that of the stress, and the velocity over the
    same time. Where the top of the stress is not flat, it is that of the change of velocity, if the stress is constant over it; the same
    at a free surface, which has no stress. NaN where neither top is flat, or the velocity changes over that of the stress; and for the
    stress of a surface that moves without any.
    """
    rows = []
    table = run.arrays("gauges") if run.gauge_names() else {}
    plane = "axes" in run.setup
    word = "pressure" if plane else "stress"
    noise = NOISE * largest_value(run, "velocity")
    moving, stressed = _scales(run, word)
    names = run.gauge_names()
    side_of = sides(run.setup["gauges"])
    placed = {gauge["name"]: gauge for gauge in run.setup["gauges"]}
    for k, name in enumerate(names):
        if name in side_of and _same(table["velocity"], k, names.index(side_of[name]), moving):
            continue     # the interface gauge has it
        gauge = placed.get(name, {})
        velocity, change = _velocity(table, k, gauge.get("kind", ""))
        end = max(recorded(velocity), 1)
        time = table["time"][:end]
        velocity, change = (without_round_off(values[:end], moving) for values in (velocity, change))
        row: dict = {"gauge": name}
        moved = bool(np.max(np.abs(change - change[0])) > noise)
        stress = without_round_off(table[word][:end, k], stressed) if word in table else None
        out = outward(run.setup, gauge)
        place = table["position"][:end, k] if "position" in table else None
        loads = [] if stress is None else [change * out] if plane and out else [stress, change * out]
        row["arrival"], row["second_arrival"] = arrivals(time, change, *loads, position=place) if moved else (float("nan"), float("nan"))
        inside, struck = gauge.get("kind", "point") == "point", at_impact(run.setup, gauge)
        if struck:
            row |= {"arrival": 0.0, "second_arrival": float("nan")}
        # what is recorded on a side is the stress of the zones beside it, which says when a face is pressed, but not how much
        levels = _levels(time, velocity, change, stress if inside or struck else None, row["arrival"], moved)
        if word in table:
            row |= {f"{part}_{word}": levels.get(part, float("nan")) if inside else float("nan") for part in ("peak", "plateau", "lowest")}
        row |= {f"{part}_velocity": levels[f"{part}_velocity"] for part in ("peak", "plateau", "last")}
        if end < len(table["time"]):
            row["last_velocity"] = float("nan")
        rows.append(row)
    if all(np.isnan(row["second_arrival"]) for row in rows):
        for row in rows:
            del row["second_arrival"]
    return rows


def _scales(run: Run, word: str) -> tuple[float, float]:
    """The largest velocity, m/s, and stress or pressure (`word`), Pa, of a run, beside which smaller values are round-off.

    Of a body at rest under pressure all velocities are round-off: that of its stress, which is rho c times a velocity; of a free body that
    moves as a whole all stresses are.
    """
    fast = largest_value(run, "sound_speed")
    moving = max(largest_value(run, "velocity"), 0.1 * fast)
    return moving, max(largest_value(run, word), largest_value(run, "density") * fast * moving)


def at_impact(setup, gauge: Mapping) -> bool:
    """Whether a gauge sits where two bodies that touch differ in velocity at t = 0, unless they part freely: waves start there then.

    Its record begins at that velocity or between the two, and later waves were taken for the first one.
    """
    if "axes" in setup:
        return gauge.get("name") in setup.get("struck", ())      # missing from runs of earlier versions
    regions, at = setup["regions"], gauge.get("at")
    pairs = [(a, b) for a, b in zip(regions, regions[1:])
             if a["end"] == b["start"] and np.ravel(a["velocity"])[-1] != np.ravel(b["velocity"])[0]
             and f"{a['name']}/{b['name']}" not in setup.get("parting", ())]
    places = [(f"{a['name']}/{b['name']}", f"{a['name']}:right", f"{b['name']}:left") for a, b in pairs]
    return at in [a["end"] for a, _ in pairs] or re.sub(r"\s*([/:])\s*", r"\1", str(at)) in itertools.chain(*places)


def outward(setup, gauge: Mapping) -> float:
    """1 if the record of a gauge on a free side is positive out of the body, -1 if into it; 0 of a joint, or of a point in two dimensions.

    A point in one dimension counts as one on the end of a region that is nearest to it.
    """
    if "axes" in setup:      # a line of sight sees the farthest point along it
        return 0.0 if gauge.get("kind", "point") == "point" or "/" in str(gauge.get("on")) else 1.0
    at = gauge.get("at", "")
    if isinstance(at, str):
        return -1.0 if at.endswith("left") else 1.0 if at.endswith("right") else 0.0
    near = [(abs(at - region[end]), way) for region in setup["regions"] for end, way in (("start", -1.0), ("end", 1.0))]
    return min(near)[1]


def _levels(time, velocity, change, stress, arrival: float, moved: bool) -> dict[str, float]:
    """Peak, plateau and lowest of a gauge's stress (None: not recorded), and peak, plateau and end of its velocity; `change` is the
    record in which waves arrive, `moved` whether it changed."""
    first = int(np.searchsorted(time, arrival)) if np.isfinite(arrival) else 0
    weight, free = durations(time[first:]), stress is None or (moved and not stress.any())
    nothing, found, change = float("nan"), {}, np.abs(change - change[0])[first:]
    top, level = flat_stretch(weight, change if free else stress[first:])
    if not (free or np.isfinite(level)):     # at a start-up the stress may exceed its level many times, the velocity by half
        top, _ = flat_stretch(weight, change)
        level = level_over(weight, stress[first:], top)
        top, level = (top, level) if level > 0.0 else (slice(0, 0), nothing)
    if not free:
        found = {"peak": float(stress.max()), "plateau": level, "lowest": float(stress.min())}
    largest = float(np.max(np.abs(velocity)))
    return found | {"peak_velocity": float(velocity[np.argmax(np.abs(velocity))]),
                    "plateau_velocity": level_over(weight, velocity[first:], top, largest), "last_velocity": float(velocity[-1])}


def _same(table: np.ndarray, k: int, other: int, largest: float) -> bool:
    """Whether the records of two gauges differ by round-off only."""
    return bool(np.all(np.abs(table[:, k] - table[:, other]) <= ROUND_OFF * largest))


def without_round_off(values: np.ndarray, largest: float) -> np.ndarray:
    """Values with zeros for those that are round-off beside the largest of their run."""
    return np.where(np.abs(values) > ROUND_OFF * largest, values, 0.0)


def _velocity(table: dict, k: int, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """What gauge k has for a velocity, and the record in which its waves arrive; kind: of a gauge in two dimensions."""
    name = {"": "velocity", "edge": "normal_velocity", "slit": "line_velocity"}.get(kind, "")
    if name in table:      # normal_velocity is missing from runs of earlier versions
        return table[name][:, k], table[name][:, k]
    found, other = (table[name][:, k] for name in ("velocity_x", "velocity_y"))
    return np.hypot(found, other), np.hypot(found - found[0], other - other[0])


def recorded(values: np.ndarray) -> int:
    """How many values a record has before the first that is missing (NaN)."""
    missing = np.isnan(values)
    return int(missing.argmax()) if missing.any() else len(values)


def spall_numbers(run: Run) -> dict:
    """The spall reading: gauge, kind of surface, region, window, numbers (SI), the reason where no strength is given,
    a note on what limits it."""
    reading = spall_reading(run)
    why = {key: words for key, words in (("reason", reading.reason), ("note", reading.note)) if words}
    record = reading.record if reading.numbers else None
    where = {"gauge": record.gauge, "surface": record.kind, "region": record.region, "window": record.window} if record else {}
    return {**where, **reading.numbers, **why}


def highest(run: Run) -> dict:
    """Highest stress (else pressure) and tension of any zone at any time, Pa, and the velocity of the surface that is seen, m/s.

    Beside each field stands where it was found: `stress_region` the body and `stress_at` the centre of the zone at t = 0, m, one number
    for each coordinate. Zones in which a captured shock is still forming (`problem.forming`), and overshoots, do not count;
    `peaks` has them. Where they have more than that can explain, as in a wave that ends or decays before it leaves them, theirs is
    the highest, and `stress_forming` is true. `stress_focus` is true where it stands beside the axis or centre and falls off from there:
    a converging wave grows without bound, and its value is the larger the finer the mesh.
    `surface` is the gauge of that velocity, or "free surface". The velocity is along x, as in `gauge_rows`, when it is farthest from
    `surface_start`, that at the start: of a body that moves as a whole the largest one may be that of the body before any wave.
    A field that the run does not have is left out, and so are a tension and a velocity that never came, or that are the round-off of a
    surface at rest; the velocity is that of the spall reading where there is one.
    """
    peaks, found = run.arrays("peaks"), {}
    centres = [peaks[name] for name in ("centre", "centre_x", "centre_y") if name in peaks]
    for word, names in (("stress", ("stress", "peak_stress")), ("pressure", ("pressure", "peak_pressure")),
                        ("tension", ("tension", "peak_tension", "least_stress"))):
        values = next((np.abs(peaks[n]) if word == "tension" else peaks[n] for n in names if n in peaks and len(peaks[n])), None)
        if values is None or (word == "pressure" and "stress" in found):
            continue
        values = without_round_off(values, _scales(run, word)[1])
        least = NOISE * found.get("stress", found.get("pressure", 0.0))
        if word == "tension" and not np.max(values) > least:
            continue
        form = peaks["forming"] > 0 if word != "tension" and "forming" in peaks else np.zeros(len(values), dtype=bool)
        counted = settled(values, form)
        if counted is values and form.any():
            found[f"{word}_forming"] = True
        k = int(np.argmax(counted))
        if at_focus(run.setup, values, k):
            found[f"{word}_focus"] = True
        found |= {word: float(values[k]), f"{word}_region": str(peaks["region"][k]), f"{word}_at": [float(x[k]) for x in centres]}
    seen = surface_record(run)
    change, noise = np.abs(seen.velocity - seen.start), NOISE * largest_value(run, "velocity")
    if len(seen.time) and "peak_velocity" not in spall_numbers(run) and np.max(change) > noise:
        found |= {"surface": "free surface" if seen.kind == SURFACE else seen.gauge,
                  "surface_velocity": float(seen.outward * seen.velocity[np.argmax(change)]),
                  "surface_start": float(seen.outward * seen.start) if abs(seen.start) > noise else 0.0}
    return found


def highest_rows(run: Run) -> list[tuple[str, str, str]]:
    """(what, its value, where) of `highest` in words."""
    top = highest(run)
    rows = [(word, format_si(top[word], "Pa", 5), (_place(top[f"{word}_region"], top[f"{word}_at"]) if top[word] else "")
             + ("; a wave converges there, and the value depends on the mesh" if f"{word}_focus" in top else
                "; a shock that forms there overshoots" if f"{word}_forming" in top else ""))
            for word in ("stress", "pressure", "tension") if word in top]
    if "surface_velocity" in top:
        start = f"at the start {format_si(top['surface_start'], 'm/s', 5)}" if top["surface_start"] else ""
        rows.append((f"velocity, {top['surface']}", format_si(top["surface_velocity"], "m/s", 5), start))
    return rows


def _place(region: str, centre: list[float]) -> str:
    """Where a zone was at t = 0."""
    coordinates = ", ".join(format_si(x, "m", 4) for x in centre)
    return f"{region}, initially at {coordinates if len(centre) == 1 else f'({coordinates})'}" if centre else region


def eroded_rows(run: Run) -> list[tuple[str, str]]:
    """(what, its value) of the zones that have left the mesh, in words; none in a run without erosion."""
    s, per = run.summary, PER_AREA.get(run.setup["geometry"], "")
    if "zones_eroded" not in s:
        return []
    whose = "energy" if "eroded_momentum_y" in s else "internal energy"      # what is dropped takes its kinetic energy along
    return [("zones", str(s["zones_eroded"])), ("mass", format_si(s["eroded_mass"], "kg" + per)),
            (whose, format_si(s["eroded_energy"], "J" + per))]


def warnings_of(run: Run) -> list[str]:
    """Texts of the warnings among a run's events."""
    events = run.arrays("events")
    return [str(text) for kind, text in zip(events.get("kind", ()), events.get("text", ())) if kind == "warning"]


def record(run: Run) -> dict:
    """A whole run for programs, as `run`, `resume` and `info` print it: folder, summary, `results` and events."""
    events = run.arrays("events")
    happened = {key: np.asarray(events[key]).tolist() for key in ("time", "cycle", "kind", "text") if key in events}
    rows = [dict(zip(happened, row)) for row in zip(*happened.values())]
    return {"folder": str(run.folder), "summary": run.summary, **results(run), "events": rows}


def results(run: Run) -> dict:
    """Everything of the above for programs: zones, gauges, highest values, spall, warnings; of a resolved shock its transport laws."""
    transport = {"transport": run.setup["transport"]} if run.setup.get("transport") else {}
    return {"zones": len(run.arrays("peaks").get("zone", ())), "gauges": gauge_rows(run), "highest": highest(run),
            "spall": spall_numbers(run), **transport, "warnings": warnings_of(run)}
