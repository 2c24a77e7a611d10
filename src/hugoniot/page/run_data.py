"""What the page draws of a run: its record, its columns as arrays of doubles, and a run that is still in progress.

A finished run is read from its result; one in progress from the pieces it has set down, which are whole or not there. Nothing is
written, no lock is taken.
"""

from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble, HugoniotError, OutOfRange
from hugoniot.output.result_columns import history, record_by_record
from hugoniot.output.run import Run
from hugoniot.output.run_numbers import results
from hugoniot.page import live

MOST_EVENTS = 500
MOST_BYTES = 64_000_000     # of one column of all records; of a longer one every second, third, ... record is sent


@lru_cache(maxsize=16)
def _opened(path: Path, stamp: tuple) -> Run:
    return Run(path)


def _run(path: Path) -> Run:
    """The finished run in a folder, opened once for as long as its result is the same."""
    state = (path / "result.h5").stat()
    return _opened(path, (state.st_ino, state.st_size, state.st_mtime_ns))


def finished(path: Path) -> bool:
    """Whether the run has written its summary, the last of its files."""
    return (path / "summary.json").is_file() and (path / "result.h5").is_file()


def line(path: Path) -> dict:
    """Title and status of a run, in a list."""
    try:
        if not finished(path):
            return {"title": path.name, "status": live.status(path)}
        summary = _run(path).summary
        return {"title": summary["title"], "status": summary["status"]}
    except (HugoniotError, OSError) as error:
        return {"title": path.name, "status": str(error)}


def description(path: Path) -> dict[str, Any]:
    """Set-up, times, fields and gauges of a run, and its numbers if it is finished."""
    if not finished(path):
        return live.description(path)
    run = _run(path)
    rows, gauges = run.arrays("snapshots"), run.arrays("gauges")
    plane = "axes" in run.setup
    zones = len(rows["zone"]) if "zone" in rows else 0
    every = _every(rows.shapes)
    names = live.zone_fields({name: len(rows.shapes[name]) for name in rows}, plane)
    found = {
        "title": run.summary["title"], "status": run.summary["status"], "live": False, "plane": plane, "summary": run.summary,
        "geometry": run.setup["geometry"], "zones": zones, "every": every, "times": rows["time"][::every], "regions": _regions(run),
        "fields": live.fields(names), "gauges": run.gauge_names(), "events": _events(run),
        "event_count": len(run.arrays("events").get("time", ())),
        "gauge_fields": live.fields([n for n in gauges if len(gauges.shapes[n]) == 2 and n != "position"]) if len(gauges) else [],
        "gauge_times": len(gauges["time"]) if "time" in gauges else 0, "numbers": _numbers(run),
    }
    if plane:
        mesh = run.arrays("mesh")
        found |= {"axes": run.setup["axes"], "zone_nodes": mesh["zone_nodes"], "block_of": mesh["block_of"]}
    return found


def _every(shapes: dict) -> int:
    largest = max((int(np.prod(shape)) * 8 for shape in shapes.values() if len(shape) == 2), default=0)
    return max(1, -(-largest // MOST_BYTES))


def _regions(run: Run) -> list[dict]:
    """Name, material and last zone of each region, in the order of the zones."""
    names = [str(name) for name in run.arrays("snapshots")["region"]]
    found: list[dict] = []
    kept = {str(r["name"]): str(r.get("material", "")) for r in run.setup["regions"]}
    for k, name in enumerate(names):
        if not found or found[-1]["name"] != name:
            found.append({"name": name, "material": kept.get(name, ""), "first": k})
        found[-1]["last"] = k
    return found


def _events(run: Run) -> list[dict]:
    events = run.arrays("events")
    keys = ("time", "kind", "text")
    return [dict(zip(keys, (float(t), str(k), str(w)))) for t, k, w in zip(*(events.get(key, ()) for key in keys))][:MOST_EVENTS]


def _numbers(run: Run) -> dict:
    """Gauges, spall and warnings; of a solver whose gauges are others only what there is."""
    try:
        return results(run)
    except (HugoniotError, KeyError, ValueError):
        return {}


def column(path: Path, group: str, name: str, which: dict[str, int], step: int = 1) -> np.ndarray:
    """A column of the groups `snapshots` or `gauges`, thinned as the description says; `which` picks one record or one zone.

    step    of a line's records that the description leaves every how many-th is read

    Fields of nodes come as means over the zone, as `hugoniot plot` takes them. `OutOfRange` for what a run does not hold.
    """
    if group not in ("snapshots", "gauges"):
        raise OutOfRange(f"a run has the records snapshots and gauges, not {group!r}")
    if not finished(path):
        plane = group == "snapshots" and name != "time" and which
        return live.plane_column(path, name, which) if plane else live.column(path, group, name)
    run = _run(path)
    rows = run.arrays(group)
    if group == "gauges":
        return _double(rows, name, slice(None))
    every = _every(rows.shapes)
    if "axes" in run.setup:
        return _plane_column(run, rows, name, which, every)
    part = slice(None, None, every * step)
    if "zone" in which:
        return _history(rows, name, which["zone"])[part]
    return _double(rows, name, part) if name in rows else 0.5 * (_double(rows, f"{name}_left", part) + _double(rows, f"{name}_right", part))


def _history(rows, name: str, zone: int) -> np.ndarray:
    """A field of one zone in every record."""
    if f"{name}_left" in rows:
        return 0.5 * (_history(rows, f"{name}_left", zone) + _history(rows, f"{name}_right", zone))
    _numbers_there(rows, name)
    return np.array(history(rows, name, _index(zone, rows.shapes[name][-1])), dtype=float)


def _plane_column(run: Run, rows, name: str, which: dict[str, int], every: int) -> np.ndarray:
    """One record of a field, or of a coordinate of the nodes; or the history of one zone."""
    if name == "time" and "zone" not in which:
        return _double(rows, name, slice(None, None, every))
    if name in ("position_x", "position_y") and "zone" not in which:
        return np.array(record_by_record(rows, name)[_index(which.get("record", 0) * every, len(rows["time"]))], dtype=float)
    from hugoniot.plotting.plane import plane_field

    if "zone" in which:
        zone = _index(which["zone"], len(run.arrays("mesh")["zone_nodes"]))
        records = range(0, len(rows["time"]), every)
        return np.array([plane_field(run, name, k)[zone] for k in records], dtype=float)
    return np.asarray(plane_field(run, name, _index(which.get("record", 0) * every, len(rows["time"]))), dtype=float)


def _double(rows, name: str, part: slice) -> np.ndarray:
    """Some records of a column; a copy, since a view would keep the whole column in memory."""
    _numbers_there(rows, name)
    found = record_by_record(rows, name)
    return np.array(found[part] if isinstance(found, np.ndarray) else [found[k] for k in range(len(found))[part]], dtype=float)


def _numbers_there(rows, name: str) -> None:
    if name not in rows or rows.kinds[name].kind not in "fiu":
        raise OutOfRange(f"the run has no field called '{name[:60]}'")


def _index(k: int, count: int) -> int:
    if not 0 <= k < count:
        raise FileTrouble(f"no entry number {k}: there are only {count}")
    return k
