"""Detonations read from snapshots: where the front is, how fast it runs, where a shock turned into one, and the Pop plot of many runs.

Arrays are those of `run.arrays("snapshots")` or of a list of states: times (n,), zone fields (n, nzone), face positions (n, nzone).
"""

import math
from typing import NamedTuple

import numpy as np

from hugoniot.errors import OutOfRange


def front_path(field, left, right, level: float = 0.5, toward: str = "right") -> np.ndarray:
    """Position (n,) at which a field falls through `level` ahead of a front; not-a-number where it does not in the row.

    field         burn_fraction (n, nzone), or pressure for the shock ahead of a growing reaction
    left, right   face positions (n, nzone), m
    level         of the field: 0.5 of a burn fraction; for a pressure a value (Pa) well below the shock's
    toward        which way the front runs: "right" or "left"

    Linear between zone centres.
    """
    if toward not in ("right", "left"):
        raise OutOfRange(f"a front runs toward \"right\" or \"left\", not {toward!r}")
    step = 1 if toward == "right" else -1
    values, centre = np.asarray(field, float)[:, ::step], 0.5 * (np.asarray(left, float) + np.asarray(right, float))[:, ::step]
    path = np.full(len(values), np.nan)
    for i, row in enumerate(values):
        above = np.flatnonzero(row >= level)
        if above.size == 0 or above[-1] + 1 >= row.size:
            continue
        k = above[-1]
        share = (row[k] - level) / (row[k] - row[k + 1])
        path[i] = centre[i, k] + share * (centre[i, k + 1] - centre[i, k])
    return path


def front_speed(times, path, start: float = -np.inf, end: float = np.inf) -> float:
    """Speed (m/s) of a front from a straight line through its path between two positions; OutOfRange below three points."""
    times, path = np.asarray(times, float), np.asarray(path, float)
    use = np.isfinite(path) & (path >= start) & (path <= end)
    if use.sum() < 3:
        raise OutOfRange(f"only {int(use.sum())} points of the front lie between {start:.6g} and {end:.6g} m: use more snapshots")
    return float(abs(np.polyfit(times[use], path[use], 1)[0]))


def run_to_detonation(times, path, detonation_velocity: float, shock_velocity: float | None = None) -> tuple[float, float]:
    """(run distance m, time s) at which a shock turned into a detonation, from the start of its path.

    It is where the front's speed passes half-way from that of the entering shock (`shock_velocity`, or the mean of the first three
    intervals) to the detonation velocity for the last time. Set what the path does after the front has left the charge to not-a-number.
    Raises OutOfRange when that does not happen within the path.
    """
    times, path = np.asarray(times, float), np.asarray(path, float)
    known = np.isfinite(path)
    times, path = times[known], path[known]
    if times.size < 8:
        raise OutOfRange(f"{times.size} points of the front are too few for a run distance: use more snapshots")
    speed = np.abs(np.diff(path) / np.diff(times))
    where, when = 0.5 * (path[1:] + path[:-1]), 0.5 * (times[1:] + times[:-1])
    halfway = 0.5 * ((np.mean(speed[:3]) if shock_velocity is None else shock_velocity) + detonation_velocity)
    slow = np.flatnonzero(speed < halfway)
    if slow.size == 0 or slow[-1] + 1 >= speed.size:
        where = "is faster all the way" if slow.size == 0 else "is still slower at the end of its path"
        raise OutOfRange(f"no run distance in this run: a front detonates where its speed rises through {halfway:.5g} m/s, half-way from "
                         f"the entering shock to the detonation, but this one {where}")
    k = slow[-1]
    share = (halfway - speed[k]) / (speed[k + 1] - speed[k])
    return float(abs(where[k] + share * (where[k + 1] - where[k]) - path[0])), float(when[k] + share * (when[k + 1] - when[k]) - times[0])


class PopLine(NamedTuple):
    """log10(p/GPa) = a + b log10(x/mm) and standard deviations: of the points in log10 p, of a, of b (nan where not known)."""

    a: float
    b: float
    deviation: float = math.nan
    a_deviation: float = math.nan
    b_deviation: float = math.nan

    def distance(self, pressure):
        """Run distance (m) at an input pressure (Pa)."""
        return 1e-3 * 10.0 ** ((np.log10(np.asarray(pressure) * 1e-9) - self.a) / self.b)


def pop_line(pressures, distances) -> PopLine:
    """The line through input pressures (Pa) and run distances (m), by least squares in log10 p, with standard deviations."""
    p, x = np.asarray(pressures, float), np.asarray(distances, float)
    if p.size < 2 or p.shape != x.shape or not (np.all(p > 0.0) and np.all(x > 0.0)):
        raise OutOfRange("a Pop plot needs at least two pairs of a pressure and a run distance, all positive")
    u, v = np.log10(x * 1e3), np.log10(p * 1e-9)
    b, a = (float(c) for c in np.polyfit(u, v, 1))
    if p.size == 2:
        return PopLine(a, b)
    deviation = float(np.sqrt(np.sum((v - a - b * u) ** 2) / (p.size - 2)))
    spread = float(np.sum((u - u.mean()) ** 2))
    return PopLine(a, b, deviation, deviation * float(np.sqrt(1.0 / p.size + u.mean() ** 2 / spread)), deviation / float(np.sqrt(spread)))


def von_neumann_pressure(state, toward: str = "right", zones: int = 8) -> float:
    """Pressure (Pa) of the reaction zone at its front: the straight line through the first `zones` behind the shock, led on to the front.

    A captured shock takes two to four zones, in which burning has begun, so that no zone ever holds the von Neumann state: the highest
    one is low by the slope of the zone times that width. The line starts at the first zone whose viscosity has fallen below a thousandth
    of its pressure; the front is where the pressure falls through half of its highest value. `zones` are a small part of the reaction zone.
    OutOfRange where fewer zones lie behind the shock.
    """
    step = 1 if toward == "right" else -1
    p, q = (np.asarray(state.zones[name])[::step] for name in ("pressure", "viscous_pressure"))
    x = 0.5 * (np.asarray(state.position_left) + np.asarray(state.position_right))[::step]
    above = np.flatnonzero(p >= 0.5 * p.max())
    smooth = np.flatnonzero(q[:above[-1] + 1] <= 1e-3 * p[:above[-1] + 1])
    if above[-1] + 1 == p.size or smooth.size == 0 or smooth[-1] + 1 < zones:
        raise OutOfRange(f"no front in this state has {zones} zones behind its shock, so the spike of a reaction zone cannot be read")
    k, last = above[-1], smooth[-1] + 1
    front = x[k] + (p[k] - 0.5 * p.max()) / (p[k] - p[k + 1]) * (x[k + 1] - x[k])
    return float(np.polyfit(x[last - zones:last] - front, p[last - zones:last], 1)[1])


def body_motion(state, region_of, region: int) -> dict[str, float]:
    """Mass (kg), momentum (kg m/s), kinetic energy (J) and mean velocity (m/s) of one region, per unit area or angle.

    For plates and walls driven by explosives; velocity = momentum / mass is what Gurney's formulas give.
    """
    here = np.asarray(region_of) == region
    mass = state.zones["mass"][here]
    u = 0.5 * (state.velocity_left[here] + state.velocity_right[here])
    total, momentum = float(mass.sum()), float(np.sum(mass * u))
    kinetic = 0.25 * float(np.sum(mass * (state.velocity_left[here] ** 2 + state.velocity_right[here] ** 2)))
    return {"mass": total, "momentum": momentum, "kinetic_energy": kinetic, "velocity": momentum / total}


def body_history(budget, snapshots, region: str) -> dict[str, np.ndarray]:
    """Motion of one region over a run: time (s), mass, momentum, kinetic_energy, velocity and energy_velocity (m/s), all (n,).

    budget, snapshots   `run.arrays("budget")` and `run.arrays("snapshots")`; mass, momentum (kg m/s) and energy (J) are per unit area or
                        angle. velocity = momentum / mass, what Gurney's formulas mean by that of a plate; energy_velocity =
                        sqrt(2 kinetic_energy / mass), what they mean by that of a wall (a little more while the wall rings)
    OutOfRange for a region that the run does not have.
    """
    names = [str(name) for name in budget["region"]]
    if region not in names:
        raise OutOfRange(f"no region '{region}'; this run has: {', '.join(names)}")
    k, time = names.index(region), np.asarray(budget["time"], float)
    mass = float(np.sum(snapshots["mass"][np.asarray(snapshots["region"]) == region]))
    momentum, kinetic = budget["momentum"][:, k], budget["kinetic_energy"][:, k]
    return {"time": time, "mass": np.full_like(time, mass), "momentum": momentum, "kinetic_energy": kinetic, "velocity": momentum / mass,
            "energy_velocity": np.sqrt(2.0 * kinetic / mass)}
