r"""Pop plot of an explosive: pistons of many input pressures, and where and when each shock turned into a detonation.

Each run is a planar charge pushed by a piston of constant velocity, the particle velocity of the unreacted Hugoniot at the input
pressure. The front is the place where the pressure falls through half the input pressure; it is read each time a detonation would
have crossed `STRIDE` zones, from the face of the charge at time 0 on. `diagnostics.detonation.run_to_detonation` finds the run distance
x* and time t* in that x-t curve. The charge grows until the detonation fits into it. Runs share nothing, so the answer does not depend
on how many are done at a time.

Source of the plot: J. B. Ramsay and A. Popolato, 4th Symposium (International) on Detonation, 1965.
"""

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace

import numpy as np

from hugoniot.diagnostics.detonation import PopLine, front_path, pop_line, run_to_detonation
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import reference_state
from hugoniot.materials import burning
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock

STRIDE = 8             # zones a detonation crosses between two readings of the front
FIRST_LENGTH = 250     # zones of the first charge
GROWTH = 2.5           # of the charge until the detonation fits into it
SETTLED = 25           # readings above the half-way speed after which a detonation is believed
NEAREST = 3 * STRIDE   # zones a run distance must span


@dataclass(frozen=True)
class Initiation:
    """One run. Distances are measured from the face the piston pushes, times from the arrival of the shock there.

    pressure, piston_velocity, shock_velocity   of the unreacted Hugoniot: Pa, m/s, m/s
    distance, time   to detonation: m, s; not-a-number where there is none
    path             (times, positions) of the front
    note             why there is no run distance, or what the run warned of; empty for a sound one
    at_once          whether the charge detonates at once, within a few zones or overdriven, so that it has no run distance
    """

    pressure: float
    piston_velocity: float
    shock_velocity: float
    distance: float
    time: float
    zones: int
    path: tuple[np.ndarray, np.ndarray]
    note: str = ""
    at_once: bool = False


@dataclass(frozen=True)
class PopPlot:
    """Runs in the order of their pressures, and the line through those that turned into a detonation (None below two of them)."""

    material: str
    detonation_velocity: float
    zone_size: float
    points: tuple[Initiation, ...]
    line: PopLine | None = field(default=None)


def pop_plot(material: Material, pressures: Sequence[float], zone_size: float = 2e-5, longest: float = 0.1, jobs: int = 1) -> PopPlot:
    """Run distances of a burning material at input pressures (Pa).

    zone_size   m; the distance converges with it
    longest     m; a shock that has not turned within it gives no run distance
    jobs        runs at a time
    Raises OutOfRange for a material that does not burn by a rate, or pressures that are not positive.
    """
    charge = charge_of(material)
    if not all(0.0 < p < math.inf for p in pressures) or not (0.0 < zone_size < longest):
        raise OutOfRange("a Pop plot needs positive input pressures, and zones that are smaller than the longest charge")
    ordered = sorted(set(float(p) for p in pressures))
    # the first run compiles the sweeps; the others find them
    points = [initiation(charge, ordered[-1], zone_size, longest)] if ordered else []
    with ThreadPoolExecutor(max_workers=max(1, jobs)) as pool:
        points = [*pool.map(lambda p: initiation(charge, p, zone_size, longest), ordered[:-1]), *points]
    turned = [point for point in points if math.isfinite(point.distance)]
    return PopPlot(material.name, charge.speed, zone_size, tuple(points), line_through(turned))


def line_through(turned: Sequence[Initiation]) -> PopLine | None:
    """The line through runs that turned into a detonation, with their scatter about it; None below two of them.

    Runs have no random errors: their scatter is the curvature of the plot and the error of the mesh, which are common to all of them, and
    a run is repeated bit for bit. So the standard deviations of a and b that independent measurements would have are not given.
    """
    if len(turned) < 2:
        return None
    line = pop_line([p.pressure for p in turned], [p.distance for p in turned])
    return PopLine(line.a, line.b, line.deviation)


def detonation_velocity(material: Material) -> float:
    """Chapman-Jouguet velocity (m/s) of the products with the energy and the density of the unburned explosive."""
    rho0 = float(reference_state(burning.resting(material))[0])
    return cj(material.eos, Initial(rho0, 0.0, burning.heat_of(material) + _at_rest(material))).detonation_velocity


def _at_rest(material: Material) -> float:
    """Energy of the unburned explosive at rest without its chemical energy, J/kg."""
    return float(reference_state(material.unreacted)[1]) if material.unreacted is not None else 0.0


@dataclass(frozen=True)
class Charge:
    """An explosive made ready for runs: `material` under the name "explosive", CJ `speed` (m/s), state `ahead` of its shocks."""

    material: Material
    speed: float
    ahead: Initial


def charge_of(material: Material) -> Charge:
    """The charge of a material that burns by a rate; OutOfRange for any other."""
    law = BURN.of(material.burn) if material.burn is not None else None
    if law is None or not {"pressure_driven", "temperature_driven"} & set(law.flags) or "instantaneous" in law.flags:
        raise OutOfRange(f"material '{material.name}' has no rate-based burn law, which a Pop plot needs: use a material such as "
                         "\"LX-17 reactive\" from the library, or one with an [unreacted] and a [burn] table")
    burning.reactive(material)     # says what is missing
    return Charge(replace(material, name="explosive"), detonation_velocity(material), Initial.at_rest(material.unreacted))


def initiation(charge: Charge, pressure: float, zone_size: float, longest: float, zones: int = FIRST_LENGTH) -> Initiation:
    """The run of one pressure, in a charge that grows from `zones` until the front has turned."""
    inert = shock(charge.material.unreacted, charge.ahead, pressure=pressure)
    piston, entering = float(inert.particle_velocity), float(inert.shock_velocity)
    most, at_once = int(longest / zone_size), False
    if entering >= charge.speed:
        told = f"the input shock runs at {entering:.0f} m/s, faster than the detonation, which is therefore overdriven"
        return Initiation(pressure, piston, entering, math.nan, math.nan, 0, (np.zeros(0), np.zeros(0)), told, True)
    while True:
        zones = min(zones, most)
        times, path, told = _front(charge, pressure, piston, entering, zones, zone_size)
        try:
            distance, time = run_to_detonation(times, path, charge.speed, entering)
            at_once = bool(distance < NEAREST * zone_size)
            if at_once:
                told = [f"detonation within only {distance / zone_size:.0f} zones: make the zones {NEAREST * zone_size / distance:.1f} "
                        "times smaller"]
                distance = time = math.nan
            break
        except OutOfRange:
            distance = time = math.nan
            at_once = times.size >= 8 and bool(np.all(np.diff(path) > 0.5 * (entering + charge.speed) * np.diff(times)))
            if at_once:
                told = [f"detonation within fewer than {STRIDE} zones: make the zones smaller"]
                break
            if zones >= most:
                told = [f"no detonation within {longest * 1e3:.4g} mm"]
                break
        zones = int(zones * GROWTH)
    return Initiation(pressure, piston, entering, distance, time, zones, (times, path), "; ".join(told), at_once)


def _front(charge: Charge, pressure: float, piston: float, entering: float, zones: int, zone_size: float):
    """(times, positions, warnings) of the front until it has settled to a detonation or nears the end of the charge."""
    length = zones * zone_size
    problem = Problem("pop plot", "planar", 1.2 * length / entering, (Region("charge", "explosive", 0.0, length, zones),),
                      {"explosive": charge.material}, Boundary("velocity", Pulse("constant", amplitude=piston)), Boundary("free"),
                      output=OutputOptions(report=False))
    solver = make_solver(problem)
    interval = STRIDE * zone_size / charge.speed
    halfway = 0.5 * (entering + charge.speed)
    times, path, settled = [0.0], [0.0], 0
    while path[-1] < length - 2 * STRIDE * zone_size and times[-1] < problem.stop_time - interval and settled < SETTLED:
        until = len(times) * interval
        while solver.time < until:
            solver.march(until, 1_000_000)
        state = solver.state()
        place = front_path(state.zones["pressure"][None, :], state.position_left[None, :], state.position_right[None, :], 0.5 * pressure)
        times.append(solver.time)
        path.append(float(place[0]) if math.isfinite(place[0]) else path[-1])
        settled = settled + 1 if path[-1] - path[-2] > halfway * (times[-1] - times[-2]) else 0
    return np.array(times), np.array(path), solver.warnings()
