"""From a Problem to the solver's arrays: zones, masses, initial states, laws grouped by kind, bodies, boundaries, gauges."""

from dataclasses import dataclass

import numpy as np

from hugoniot.core.compile import float_row
from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import OutOfRange
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.eos.contract import compacted, density_limits, pressure, reference_state, remembered, sound_speed_squared, unloading
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH, shear_modulus
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.mesh.line import GEOMETRY, graded_nodes, volume
from hugoniot.problem.model import Boundary, Problem
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange1d.tables import zone_table

ROUND_OFF = 1e-9     # c^2 below minus this fraction of the largest speed squared is imaginary, not noise
CODES = {"free": L.FREE, "fixed": L.FIXED, "velocity": L.VELOCITY, "pressure": L.PRESSURE, "transmitting": L.TRANSMITTING}


@dataclass
class Laws:
    """Laws of a problem grouped by class: `kinds` and `tables` as the sweeps take them, and each region's place in them."""

    kinds: tuple
    tables: tuple
    kind_of: list[int]
    row_of: list[int]


def viscosity_of(problem: Problem):
    """Parameter tuple of the artificial viscosity."""
    name, values = problem.solver.viscosity
    law = VISCOSITY.get(name)
    return law.build(**{**law.defaults, **dict(values)})


def group_laws(problem: Problem) -> Laws:
    """One kind for each combination of law classes; parameters with tables (arrays) make a kind of their own."""
    viscosity = viscosity_of(problem)
    noise = ROUND_OFF * _speed_scale(problem) ** 2
    kinds, rows, kind_of, row_of, keys = [], [], [], [], []
    for region in problem.regions:
        material = problem.materials[region.material]
        eos = material.eos if material.burn is None else burning.reactive(material)
        # sweeps read floats from a table and all else from the first of a kind: an integer would shift the columns behind it
        laws = tuple(float_parameters(law) for law in (
            eos, material.strength or STRENGTH.get("none").example, material.fracture or FRACTURE.get("none").example, viscosity))
        key = (_shape(laws), region.material if _holds_arrays(laws) else None)
        if key not in keys:
            keys.append(key)
            kinds.append(laws)
            rows.append([])
        kind = keys.index(key)
        extra = () if material.burn is None else reactive.extra_row(problem, region, problem.solver.courant)
        entry = tuple(tuple(float_row(law)) for law in laws) + ((float(reference_state(material.eos)[0]), noise, *extra),)
        if entry not in rows[kind]:
            rows[kind].append(entry)
        kind_of.append(kind)
        row_of.append(rows[kind].index(entry))
    tables = tuple(tuple(np.array([entry[i] or (0.0,) for entry in group]) for i in range(5)) for group in rows)
    return Laws(tuple(kinds), tables, kind_of, row_of)


def _shape(law):
    """Classes of a parameter tuple and of the laws inside it, whatever their numbers: what a sweep is compiled for."""
    return (type(law), *(_shape(v) for v in law)) if isinstance(law, tuple) else type(law)


def _holds_arrays(law) -> bool:
    return any(_holds_arrays(v) if isinstance(v, tuple) else isinstance(v, np.ndarray) for v in law)


def _speed_scale(problem: Problem) -> float:
    """Largest speed of a problem at its start, sound, body or boundary, m/s."""
    speeds = [start_region(problem, region)[3] for region in problem.regions]
    for region in problem.regions:
        speeds += [abs(u) for u in (region.velocity if isinstance(region.velocity, tuple) else (region.velocity,))]
    for boundary in (problem.left, problem.right):
        if boundary.kind == "velocity":
            speeds += [abs(boundary.pulse.amplitude), *(abs(u) for u in boundary.pulse.values)]
    return max(speeds)


def longitudinal_speed(material, rho, e):
    """Elastic sound speed with the shear modulus, m/s; an imaginary one is refused with the state named."""
    eos = unloading(remembered(start_compaction(material.eos, rho, e), material.eos))
    c2 = sound_speed_squared(rho, e, eos)
    if material.strength is not None:
        c2 += 4.0 / 3.0 * shear_modulus(rho, pressure(rho, e, material.eos), 298.15, rho * c2, material.strength) / rho
    if not c2 >= 0.0:
        raise OutOfRange(f"material '{material.name}' has an imaginary sound speed at {rho:g} kg/m3, {e:g} J/kg")
    return float(np.sqrt(c2))


def start_compaction(eos, rho, e) -> float:
    """The history variable of material that was loaded to its initial state; 0 for laws without memory."""
    return float(compacted(0.0, rho, e, pressure(rho, e, eos), eos))


def start_region(problem, region):
    """(node positions, rho, e, longitudinal sound speed) of a region at t = 0."""
    material = problem.materials[region.material]
    if material.burn is not None:
        rho, e, _, c = reactive.start_region(material, region)
        return graded_nodes(region.start, region.end, region.zones, region.ratio), rho, e, c
    rho, e = initial_state(material.eos, region.density, region.pressure, region.temperature, region.energy)
    low, high = density_limits(material.eos)
    if not low < rho < high:
        raise OutOfRange(f"region '{region.name}' starts at {rho:g} kg/m3, outside {low:g} to {high:g} where its law is defined")
    return graded_nodes(region.start, region.end, region.zones, region.ratio), rho, e, longitudinal_speed(material, rho, e)


def touching(left, right):
    """Whether two regions share a face."""
    return right.start - left.end <= 1e-12 * max(abs(left.end), abs(right.start), left.end - left.start)


def interface_bond(problem, left, right):
    """Tensile strength of the interface between two touching regions, Pa."""
    for interface in problem.interfaces:
        if {interface.left, interface.right} == {left.name, right.name}:
            return {"bonded": NO_LIMIT, "separable": 0.0, "bond": interface.strength}[interface.kind]
    return 0.0


def assemble(problem: Problem):
    """(zone table, nodes, gradient, segments, region zone ranges) of a problem at t = 0."""
    geometry = GEOMETRY.get(problem.geometry).example
    reactive.check(problem)
    starts = [start_region(problem, region) for region in problem.regions]
    counts = [region.zones for region in problem.regions]
    total = sum(counts)
    ends = np.cumsum(counts)
    ranges = [(int(end - count), int(end)) for end, count in zip(ends, counts)]
    breaks = [i for i in range(1, len(counts)) if not touching(problem.regions[i - 1], problem.regions[i])]
    bodies = np.split(np.arange(len(counts)), breaks)
    burning_run = any(reactive.burns(problem, region) for region in problem.regions)
    table = zone_table(L.BURNING_ROWS if burning_run else L.ZONE_ROWS, total)
    zones = table[:, :total]
    node_parts, segments = [], []
    for body in bodies:
        r, u, weight, bond = [], [], [], []
        for i in body:
            region, (place, rho, e, c) = problem.regions[i], starts[i]
            a, b = ranges[i]
            mass = rho * np.array([volume(x, y, geometry) for x, y in zip(place[:-1], place[1:])])
            zones[L.MASS, a:b], zones[L.RHO, a:b], zones[L.E, a:b], zones[L.C, a:b] = mass, rho, e, c
            material = problem.materials[region.material]
            p = pressure(rho, e, material.eos) if material.burn is None else reactive.start_region(material, region)[2]
            zones[L.P, a:b] = zones[L.SIGMA, a:b] = p
            zones[L.COMPACTION, a:b] = start_compaction(material.eos, rho, e) if material.burn is None else 0.0
            zones[L.SIGMA_HALF, a:b] = 1.0 / rho if problem.solver.integrator == "wilkins" else 0.0
            zones[L.OLD, a:b] = rho * np.diff(place)
            speed = region.velocity if isinstance(region.velocity, tuple) else (region.velocity, region.velocity)
            fraction = (place - place[0]) / (place[-1] - place[0])
            velocity = speed[0] + (speed[1] - speed[0]) * fraction
            r.append(place), u.append(velocity), weight.append(mass)
            bond.append(np.full(len(place), NO_LIMIT))
        node_parts.append(_weld(problem, zones, body, ranges, r, u, weight, bond))
        segments.append((ranges[body[0]][0], ranges[body[-1]][1], L.FREE, L.FREE))
    segments = np.array(segments, dtype=np.int64)
    segments[0, L.SEG_LEFT], segments[-1, L.SEG_RIGHT] = CODES[problem.left.kind], CODES[problem.right.kind]
    nodes = np.zeros((L.NODE_ROWS, total + len(segments)))
    nodes[[L.R, L.U, L.BOND]] = np.concatenate(node_parts, axis=1)
    if problem.dimension > 1 and nodes[L.R, 0] == 0.0:
        segments[0, L.SEG_LEFT], nodes[L.U, 0] = L.FIXED, 0.0
    zones[L.INVERSE_MASS] = 1.0 / zones[L.MASS]
    if burning_run:
        reactive.prepare(problem, zones, [start[0] for start in starts], ranges)
    gradient = np.zeros(total + 2 * len(segments))
    return table, nodes, gradient, segments, ranges


def _weld(problem, zones, body, ranges, r, u, weight, bond):
    """Nodes of one body: shared faces move with the mean momentum, and the kinetic energy that loses heats the two zones."""
    position, velocity, bonds = r[0].copy(), u[0].copy(), bond[0].copy()
    for i in range(1, len(r)):
        left, right = problem.regions[body[i - 1]], problem.regions[body[i]]
        ml, mr = 0.5 * weight[i - 1][-1], 0.5 * weight[i][0]
        jump = u[i][0] - velocity[-1]
        velocity[-1] += mr / (ml + mr) * jump
        heat = 0.5 * ml * mr / (ml + mr) * jump * jump
        edge = ranges[body[i]][0]
        zones[L.E, edge - 1:edge + 1] += heat / (2.0 * (ml + mr))
        bonds[-1] = interface_bond(problem, left, right)
        position = np.concatenate((position, r[i][1:]))
        velocity = np.concatenate((velocity, u[i][1:]))
        bonds = np.concatenate((bonds, bond[i][1:]))
    return np.stack((position, velocity, bonds))


def boundary_pulse(boundary: Boundary):
    """(pulse numbers, table) of a boundary as the sweeps take them."""
    pulse = boundary.pulse
    if pulse is None:
        return np.zeros(4), np.zeros((2, 1))
    table = np.array([pulse.times, pulse.values]) if pulse.shape == "table" else np.zeros((2, 1))
    return np.array([L.PULSES[pulse.shape], pulse.amplitude, pulse.start, pulse.duration], dtype=float), table


def held_stresses(zones, nodes) -> tuple[float, float]:
    """Stress behind the two ends, Pa, to which a transmitting one adds rho c u outwards: the state at t = 0, moving or not, stays."""
    impedance, u = zones[L.RHO, [0, -1]] * zones[L.C, [0, -1]], nodes[L.U, [0, -1]]
    return float(zones[L.SIGMA, 0] + impedance[0] * u[0]), float(zones[L.SIGMA, -1] - impedance[1] * u[1])
