"""What a deck may say but seldom means: forgotten units, jumps of the zone mass, speeds beyond the data or beyond the laws of motion."""

import contextlib
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import EOS, gives, has_temperature, is_condensed, reference_state, sound_speed_squared, temperature
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.materials.plausible import unlikely
from hugoniot.materials.validity import beyond, impact, range_of
from hugoniot.mesh.line import graded_nodes
from hugoniot.problem.model import Problem
from hugoniot.problem.profiles import LIGHT, end_velocities
from hugoniot.problem.starting import start_at_ends
from hugoniot.units import format_si

if TYPE_CHECKING:
    from hugoniot.problem.plane.model import Problem2D

RELATIVISTIC = 0.01      # of the speed of light
SLOW = 1000.0            # m/s: no estimated range ends below it
# Courant numbers up to which the peak of a shock at 5 GPa is right to 0.11 %: it is 0.5 % too high at 0.8, 0.8 % at 0.9 (compatible) and
# 6 % at 1.0 (wilkins); in two dimensions shocks of 18 GPa are 0.1 % too high at 0.4 and 0.3 % at 0.5
LONGEST_STEP = {"compatible": 0.7, "wilkins": 0.8}
LONGEST_STEP_IN_PLANE = 0.4
UNDERSHOOT = 0.40        # of a sudden drop of the pressure: that of the last zone in a chain of zones with a linear law
ALIKE = 1e-6             # of a speed: what two blocks that share nodes may differ by
SHORT = ("exponential", "half_sine", "square")      # pulses that end
EXPANDED = 0.99          # of the reference density: metals expand as much in about 200 K
NOISE = 1e-4             # of rho c^2: a tension that no interface opens under


def advice(problem: Problem) -> list[str]:
    """Warnings of a problem that can be run."""
    found = unlikely_constants(problem)
    starts = [start_at_ends(problem, region) for region in problem.regions]
    for k, (a, b) in enumerate(zip(problem.regions, problem.regions[1:])):
        if a.end != b.start:
            continue
        masses = []
        for region, (rho, _), last in ((a, starts[k][1], True), (b, starts[k + 1][0], False)):
            q, n = region.ratio, region.zones
            first = (region.end - region.start) * ((1.0 - q) / (1.0 - q**n) if q != 1.0 else 1.0 / n)
            masses.append(rho * first * (q ** (n - 1) if last else 1.0))
        jump = max(masses) / min(masses)
        if jump > 10.0:
            found.append(f"the zone mass jumps by a factor of {jump:.3g} between '{a.name}' and '{b.name}': expect errors there "
                         "when waves cross; choose zone_size or ratio so that neighbouring zones have similar masses")
    if problem.solver.kind == "lagrange1d":
        found += _undershoots(problem, starts)
        found += _long_steps(problem.solver.courant, LONGEST_STEP[problem.solver.integrator]) + _short_pulses(problem)
    return found + _coarse_output(problem) + advice_on_speeds(problem)


def _undershoots(problem: Problem, starts: list) -> list[str]:
    """Condensed regions that start beside so much lower a pressure that their release undershoots into tension."""
    found, regions, last = [], problem.regions, len(problem.regions) - 1
    for k, region in enumerate(regions):
        eos = problem.materials[region.material].eos
        if eos is None or not is_condensed(eos):
            continue
        rho, e = reference_state(eos)
        drops = []
        for side, other, end in ((0, k - 1, problem.left), (1, k + 1, problem.right)):
            high = starts[k][side][1]
            if 0 <= other <= last:
                touches = regions[min(k, other)].end == regions[max(k, other)].start
                drops.append((high, starts[other][1 - side][1] if touches else 0.0))
            elif end.kind == "free":
                drops.append((high, 0.0))
        high, low = max(drops, key=lambda drop: UNDERSHOOT * (drop[0] - drop[1]) - drop[1], default=(0.0, 0.0))
        tension = UNDERSHOOT * (high - low) - low
        if tension > NOISE * rho * sound_speed_squared(rho, e, eos):
            found.append(f"'{region.name}' starts at {format_si(high, 'Pa')} beside {format_si(low, 'Pa')}: its sudden release undershoots "
                         f"by up to about {UNDERSHOOT:.0%} of the difference; tension up to {format_si(tension, 'Pa', 3)} may be numerical")
    return found


def _short_pulses(problem: Problem) -> list[str]:
    """Ends driven for a shorter time than sound takes to cross the zone beside them."""
    found = []
    for side, boundary, region, k in (("left", problem.left, problem.regions[0], 0), ("right", problem.right, problem.regions[-1], -1)):
        width = float(np.diff(graded_nodes(region.start, region.end, region.zones, region.ratio))[k])
        found += _short_pulse(f"the {side} boundary", boundary.pulse, problem.materials[region.material].eos, width)
    return found


def _short_pulse(name: str, pulse, eos, width: float) -> list[str]:
    """The same of one end or side, beside whose first zone, `width` m thick, is the law `eos`."""
    if eos is None or pulse is None or pulse.shape not in SHORT:
        return []
    sound = float(np.sqrt(max(sound_speed_squared(*reference_state(eos), eos), 0.0)))
    if not 0.0 < pulse.duration * sound < width:
        return []
    return [f"{name} is driven for {format_si(pulse.duration, 's', 3)}, but sound takes "
            f"{format_si(width / sound, 's', 3)} to cross the zone beside it, over which its stress is spread and too low; "
            f"use zones of {format_si(0.1 * pulse.duration * sound, 'm', 2)} there, ten in the length of the pulse"]


def _coarse_output(problem: "Problem | Problem2D") -> list[str]:
    """Intervals of snapshots and gauges longer than the run, as a number of them is that is read as seconds."""
    given = {"snapshots": problem.output.snapshots, "gauge_interval": problem.output.gauge_interval}
    return [f"{key} = {value:g} s is the time between two of them, and longer than the run of {format_si(problem.stop_time, 's', 3)}: "
            "only its start and end are kept" for key, value in given.items() if isinstance(value, float) and value > problem.stop_time]


def advice_on_speeds(problem: Problem) -> list[str]:
    """Warnings of velocities beyond the data of the materials, stated or estimated, and beyond Newton's laws."""
    found, met = [], _driven(problem)
    for a, b in zip(problem.regions, problem.regions[1:]):
        closing = end_velocities(a)[1] - end_velocities(b)[0]
        names = a.material, b.material
        if closing <= min(problem.materials[name].valid_up_to or SLOW for name in names):      # a shock's particle velocity is part of it
            continue
        ends = {name: range_of(problem.materials[name]) for name in names}
        for name, up in zip(names, impact(problem.materials[a.material], problem.materials[b.material], closing)):
            end = ends[name]
            if end.stated and up > end.up:
                found.append(f"'{a.name}' hits '{b.name}' at {closing:g} m/s, which drives '{name}' to a particle velocity of about "
                             f"{up:.3g} m/s, but the data of '{name}' end at a particle velocity of {end.up:g} m/s")
            met[name] = max(met.get(name, 0.0), up)
    return list(dict.fromkeys(found)) + _beyond_estimate(problem, met) + _relativistic(_speeds(problem))


def advice_on_blocks(problem: "Problem2D") -> list[str]:
    """The same of two dimensions: forgotten units, and the speeds of blocks, whose mean velocities say how fast they may meet."""
    found = unlikely_constants(problem)
    nodes = [velocity.reshape(2, -1) for velocity in problem.velocities()]
    means = np.array([velocity.mean(axis=1) for velocity in nodes])
    fastest: dict[tuple[str, str], tuple[float, str, str]] = {}
    for (a, one), (b, other) in combinations(zip(problem.blocks, means), 2):
        speed, pair = float(np.hypot(*(one - other))), (a.material, b.material)
        if speed > fastest.get(pair, (0.0,))[0]:
            fastest[pair] = speed, a.name, b.name
    beyond_data: dict[str, str] = {}
    met: dict[str, float] = {}
    for pair, (speed, first, second) in fastest.items():
        for name, up in zip(pair, impact(*(problem.materials[name] for name in pair), speed)):
            if up > met.get(name, 0.0):
                met[name], end = up, range_of(problem.materials[name])
                if end.stated and up > end.up:
                    beyond_data[name] = (f"'{first}' moves at {speed:g} m/s relative to '{second}'; their impact would drive '{name}' to a "
                                         f"particle velocity of about {up:.3g} m/s, but the data of '{name}' end at a particle velocity of "
                                         f"{end.up:g} m/s")
    found += beyond_data.values()
    speeds = {f"block '{block.name}'": float(np.hypot(*velocity).max()) for block, velocity in zip(problem.blocks, nodes)}
    found += _joined_at_impact(problem) + _coarse_output(problem)
    for name, boundary in problem.chain_boundaries().items():
        chain, pulse = problem.mesh.chains[name], boundary.pulse
        material = problem.blocks[chain.block].material
        if boundary.kind in ("velocity", "wall"):
            met[material] = max(met.get(material, 0.0), _driven_by_side(problem, chain, boundary))
        if boundary.kind == "velocity":
            speeds[f"the boundary '{name}'"] = max(abs(pulse.amplitude), *map(abs, pulse.values), 0.0)
        found += _short_pulse(f"the boundary '{name}'", pulse, problem.materials[material].eos, _thinnest(problem.mesh, chain))
    return found + _long_steps(problem.solver.courant, LONGEST_STEP_IN_PLANE) + _beyond_estimate(problem, met) + _relativistic(speeds)


def _driven_by_side(problem: "Problem2D", chain, boundary) -> float:
    """Largest particle velocity to which a wall or a driven side drives the material beside it along its inward normal, m/s."""
    from hugoniot.problem.plane.model import velocity_at

    inward = -problem.mesh.outward_normals(chain)
    speed = (velocity_at(problem.blocks[chain.block].velocity, *problem.mesh.nodes[:, chain.edges].mean(axis=2)) * inward).sum(axis=0)
    along = 1.0 if boundary.direction is None else np.array(boundary.direction) @ inward
    values = (0.0,) if boundary.pulse is None else (boundary.pulse.amplitude, *boundary.pulse.values)
    return float(max(np.max(value * along - speed) for value in values))


def _thinnest(mesh, chain) -> float:
    """Area over the length of the edge, m, of the thinnest zone on a chain; of triangles that of the cell they halve."""
    (x1, y1), (x2, y2) = np.moveaxis(mesh.nodes[:, chain.edges], 2, 0)
    x, y = mesh.nodes[:, mesh.zone_nodes[chain.zones]]
    area = 0.5 * np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1))
    return float(np.min(area / np.hypot(x2 - x1, y2 - y1))) * (2.0 if mesh.zone_nodes.shape[1] == 3 else 1.0)


def _joined_at_impact(problem: "Problem2D") -> list[str]:
    """Solid or liquid blocks that are joined although they move towards or away from each other, as bodies do that collide."""
    from hugoniot.problem.plane.model import velocity_at

    found = []
    for joint in problem.mesh.joints.values():
        a, b = (problem.blocks[k] for k in joint.blocks)
        laws = [problem.materials[block.material].eos for block in (a, b)]
        if a is b or None in laws or not all(map(is_condensed, laws)):
            continue
        x, y = problem.mesh.nodes[:, joint.edges].mean(axis=2)
        one, other = (velocity_at(block.velocity, x, y) for block in (a, b))
        speed = float(np.hypot(*(one - other)).max())
        if speed > ALIKE * float(max(np.hypot(*one).max(), np.hypot(*other).max())):
            found.append(f"'{a.name}' and '{b.name}' move at {speed:.4g} m/s relative to each other but are joined, so they "
                         f'cannot separate afterwards; if they should, add [[contact]] with between = ["{a.name}", "{b.name}"]')
    return found


def _long_steps(courant: float | None, most: float) -> list[str]:
    """Steps with which the viscosity of a shock overshoots."""
    if (courant or 0.0) <= most:
        return []
    return [f"courant = {courant:g}: with steps this long shocks overshoot and ring; use {most:g} or less"]


def unlikely_constants(problem: "Problem | Problem2D") -> list[str]:
    """Warnings of the constants of the materials and of the densities at which bodies start."""
    return [text for name, material in problem.materials.items() for text in unlikely(name, material)] + _heated_by_density(problem)


def _heated_by_density(problem: "Problem | Problem2D") -> list[str]:
    """Solids and liquids whose only initial value is a density below the reference one: at zero pressure they are hot, not porous."""
    found = []
    for body in getattr(problem, "regions", None) or getattr(problem, "blocks", ()):
        material, others = problem.materials[body.material], (body.pressure, body.temperature, body.energy)
        law = burning.resting(material)
        alone = body.density is not None and all(value is None for value in others) and not getattr(body, "profile", None)
        if not alone or law is None or not gives(law, "reference_state") or not is_condensed(law) or "reacted" in EOS.of(law).flags:
            continue
        rho0 = float(reference_state(law)[0])
        if not body.density < EXPANDED * rho0:
            continue
        with contextlib.suppress(HugoniotError, ArithmeticError, ValueError):
            rho, e = initial_state(law, body.density)
            hot = f"heated to {float(temperature(rho, e, law)):.4g} K" if has_temperature(law) else "heated"
            found.append(f"'{body.name}' starts at {rho:.6g} kg/m3, below the reference density of {rho0:.6g} kg/m3, and at zero pressure: "
                         f"it is {hot} and has no pores; for porous material use a law such as p_alpha, for another solid density give "
                         "rho0")
    return found


def _speeds(problem: Problem) -> dict[str, float]:
    """Largest speed of every region and driven end, m/s, by what a warning calls it."""
    speeds = {f"region '{region.name}'": max(map(abs, end_velocities(region))) for region in problem.regions}
    for side, boundary in (("left", problem.left), ("right", problem.right)):
        if boundary.kind == "velocity":
            speeds[f"the {side} boundary"] = max(abs(boundary.pulse.amplitude), *map(abs, boundary.pulse.values), 0.0)
    return speeds


def _relativistic(speeds: dict[str, float]) -> list[str]:
    """Speeds at which the equations of motion, which are Newton's, are off by more than a part in ten thousand."""
    return [f"{name} moves at {speed:.3g} m/s, {speed / LIGHT:.2g} of the speed of light: the equations of motion are not relativistic; "
            "is the unit right?" for name, speed in speeds.items() if speed > RELATIVISTIC * LIGHT]


def _driven(problem: Problem) -> dict[str, float]:
    """Particle velocity to which walls and driven ends drive the materials beside them, m/s."""
    met: dict[str, float] = {}
    for boundary, region, side in ((problem.left, problem.regions[0], 0), (problem.right, problem.regions[-1], 1)):
        inward, speed = 1.0 - 2.0 * side, end_velocities(region)[side]
        given = {"fixed": (0.0,), "velocity": (boundary.pulse.amplitude, *boundary.pulse.values) if boundary.pulse else ()}
        up = max((inward * (value - speed) for value in given.get(boundary.kind, ())), default=0.0)
        met[region.material] = max(met.get(region.material, 0.0), up)
    return met


def _beyond_estimate(problem: "Problem | Problem2D", met: dict[str, float]) -> list[str]:
    """Materials without a stated range that are driven beyond the estimated one."""
    found = []
    for name, up in met.items():
        if up <= SLOW:
            continue
        end = range_of(problem.materials[name])
        if not end.stated and up > end.up:
            found.append(f"material '{name}' is driven to a particle velocity of about {up:.3g} m/s "
                         f"(a specific energy of {0.5e-6 * up**2:.3g} MJ/kg): "
                         f"{beyond(end)}, and no range of its data is stated (valid_up_to)")
    return found
