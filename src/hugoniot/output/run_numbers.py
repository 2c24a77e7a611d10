"""The numbers of a finished run that terminal, report and JSON show: each is found here, once."""

import numpy as np

from hugoniot.diagnostics.arrival import first_crossing
from hugoniot.diagnostics.interface_gauges import sides
from hugoniot.diagnostics.velocimetry import flat_top
from hugoniot.output.run import Run
from hugoniot.output.spall_reading import spall_reading

NOISE = 1e-6   # of the largest speed of a run: what a gauge sees of a wave that has not come yet is less
GAUGE_UNITS = {"arrival": "s", "peak_stress": "Pa", "plateau_stress": "Pa", "lowest_stress": "Pa", "peak_velocity": "m/s",
               "plateau_velocity": "m/s", "last_velocity": "m/s"}
SPALL = (("peak_velocity", "velocity before the pull-back", "m/s"), ("pull_back", "pull-back", "m/s"),
         ("spall_strength_acoustic", "spall strength, acoustic", "Pa"),
         ("spall_strength_kanel", "spall strength with Kanel's correction", "Pa"),
         ("spall_thickness", "spalled layer", "m"))


def gauge_rows(run: Run) -> list[dict]:
    """Per gauge, SI: first arrival (half of the peak velocity change; NaN where nothing came), stress and velocity: peak, plateau, end.

    A peak may be the short overshoot of a numerical shock; the plateau is the level of a flat top without it, NaN where there is none.
    """
    rows = []
    table = run.arrays("gauges") if run.gauge_names() else {}
    noise = NOISE * _largest_velocity(run)
    names = run.gauge_names()
    side_of = sides(run.setup["gauges"])
    for k, name in enumerate(names):
        time, velocity = table["time"], _velocity(table, k)
        if name in side_of and np.array_equal(velocity, table["velocity"][:, names.index(side_of[name])]):
            continue     # the interface gauge has it
        row: dict = {"gauge": name}
        change = velocity - velocity[0]
        peak = change[np.argmax(np.abs(change))]
        row["arrival"] = first_crossing(time, velocity, velocity[0] + 0.5 * peak) if abs(peak) > noise else float("nan")
        if "stress" in table:
            stress = table["stress"][:, k]
            row |= {"peak_stress": float(stress.max()), "plateau_stress": flat_top(time, stress), "lowest_stress": float(stress.min())}
        highest = float(velocity[np.argmax(np.abs(velocity))])
        way = float(np.copysign(1.0, highest))
        row |= {"peak_velocity": highest, "plateau_velocity": way * flat_top(time, way * velocity), "last_velocity": float(velocity[-1])}
        rows.append(row)
    return rows


def _velocity(table: dict, k: int) -> np.ndarray:
    """What gauge k has for a velocity: in two dimensions that along its line of sight, or the speed."""
    if "velocity" in table:
        return table["velocity"][:, k]
    along = table.get("line_velocity")
    if along is not None and np.isfinite(along[:, k]).all():
        return along[:, k]
    return np.hypot(table["velocity_x"][:, k], table["velocity_y"][:, k])


def _largest_velocity(run: Run) -> float:
    """The largest speed in the gauges and snapshots of a run, m/s."""
    tables = [run.arrays(group) for group in ("gauges", "snapshots")]
    known = [table[name] for table in tables for name in table if name.startswith("velocity")]
    return max((max(float(np.max(values)), -float(np.min(values))) for values in known if values.size), default=0.0)


def spall_numbers(run: Run) -> dict:
    """The spall reading: gauge, kind of surface, region, window, numbers (SI), and the reason where no strength is given."""
    reading = spall_reading(run)
    why = {"reason": reading.reason} if reading.reason else {}
    record = reading.record if reading.numbers else None
    where = {"gauge": record.gauge, "surface": record.kind, "region": record.region, "window": record.window} if record else {}
    return {**where, **reading.numbers, **why}


def warnings_of(run: Run) -> list[str]:
    """Texts of the warnings among a run's events."""
    events = run.arrays("events")
    return [str(text) for kind, text in zip(events.get("kind", ()), events.get("text", ())) if kind == "warning"]


def results(run: Run) -> dict:
    """Everything of the above for programs: gauges, spall, warnings."""
    return {"gauges": gauge_rows(run), "spall": spall_numbers(run), "warnings": warnings_of(run)}
