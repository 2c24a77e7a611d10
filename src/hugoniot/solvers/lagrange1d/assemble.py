"""From a Problem to the solver's arrays: zones, masses, initial states, laws, bodies, boundaries, gauges."""

import numpy as np

from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import (
    compacted,
    density_limits,
    flagged,
    is_condensed,
    pressure,
    remembered,
    sound_speed_squared,
    unloading,
)
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH, shear_modulus
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.mesh.line import GEOMETRY, graded_nodes, volume
from hugoniot.problem.explosives import crushing_density
from hugoniot.problem.model import Boundary, Problem, Pulse
from hugoniot.problem.profiles import values_at, velocities_at
from hugoniot.problem.starting import part_freely
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange1d.bodies import welded
from hugoniot.solvers.lagrange1d.layout import B, H, Z
from hugoniot.solvers.lagrange1d.nodes import End, OpenEnd
from hugoniot.solvers.lagrange1d.ring import RingEnd, joined_seam
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.zones.laws import Laws, laws_of

ROUND_OFF = 1e-9     # c^2 below minus this fraction of the largest speed squared is imaginary, not noise
CODES = {"free": L.FREE, "fixed": L.FIXED, "velocity": L.VELOCITY, "pressure": L.PRESSURE, "transmitting": L.TRANSMITTING,
         "periodic": L.PERIODIC}


def viscosity_in(material, viscosity):
    """The viscosity as a material has it: condensed ones that do not burn have a linear coefficient of their own, in weak jumps only
    without strength.

    Pores have precursors like strength, and solid matter behind the shocks that crush them.
    """
    if "linear_condensed" not in viscosity._fields or flagged(material.eos, "remembers"):
        return viscosity
    if material.burn is not None or not is_condensed(material.eos):
        return viscosity._replace(linear_condensed=viscosity.linear)
    if material.strength is None or "fluid" in STRENGTH.of(material.strength).flags:
        return viscosity._replace(linear=viscosity.linear_condensed)
    return viscosity


def laws_of_regions(problem: Problem, starts) -> tuple[list[Laws], list[int]]:
    """The laws of a problem's materials, and which of them each region follows; `starts`: `start_region` of each."""
    law, values = VISCOSITY.get(problem.solver.viscosity[0]), dict(problem.solver.viscosity[1])
    viscosity = law.build(**{**law.defaults, **values})
    noise = ROUND_OFF * _speed_scale(problem, starts) ** 2
    found: dict[str, Laws] = {}
    for region in problem.regions:
        material = problem.materials[region.material]
        if region.material in found:
            continue
        burns = material.burn is not None
        # what has not begun to burn may have no sound at all
        own = {"noise": noise}
        if burns:
            alike = [other for other in problem.regions if other.material == region.material]
            own = {"noise": noise + 1.0, "crushed": crushing_density(material, alike), **reactive.constants(problem, region)}
        found[region.material] = laws_of(burning.reactive(material) if burns else material.eos,
                                         material.strength or STRENGTH.get("none").example,
                                         material.fracture or FRACTURE.get("none").example, viscosity_in(material, viscosity), **own)
    return list(found.values()), [list(found).index(region.material) for region in problem.regions]


def _speed_scale(problem: Problem, starts) -> float:
    """Largest speed of a problem at its start, sound, body or boundary, m/s."""
    speeds = [float(np.max(start[3])) for start in starts]
    speeds += [float(np.max(np.abs(velocities_at(region, start[0])))) for region, start in zip(problem.regions, starts)]
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
    """(node positions, rho, e, longitudinal sound speed) of a region at t = 0; arrays over the zones where a profile gives the state."""
    material = problem.materials[region.material]
    if region.profile is not None and set(dict(region.profile.fields)) != {"velocity"}:
        place = graded_nodes(region.start, region.end, region.zones, region.ratio)
        states = np.array([start_state(material, region, **state) for state in profile_states(region, place)])
        return place, *states.T
    if material.burn is not None:
        rho, e, _, c = reactive.start_region(material, region)
        return graded_nodes(region.start, region.end, region.zones, region.ratio), rho, e, c
    state = start_state(material, region, region.density, region.pressure, region.temperature, region.energy)
    return graded_nodes(region.start, region.end, region.zones, region.ratio), *state


def profile_states(region, place):
    """Density, pressure, temperature and energy of every zone as a region and its profile give them, at the middles of the zones."""
    middles = 0.5 * (place[:-1] + place[1:])
    given = {name: values_at(region.profile, name, middles) for name, _ in region.profile.fields if name != "velocity"}
    names = ("density", "pressure", "temperature", "energy")
    return [{name: float(given[name][k]) if name in given else getattr(region, name) for name in names} for k in range(len(middles))]


def start_state(material, region, density, pressure, temperature, energy):
    """(rho, e, longitudinal sound speed) of material that starts in a state."""
    rho, e = initial_state(material.eos, density, pressure, temperature, energy)
    low, high = density_limits(material.eos)
    if not low < rho < high:
        raise OutOfRange(f"region '{region.name}' starts at {rho:g} kg/m3, outside the range of its law, {low:g} to {high:g} kg/m3")
    return rho, e, longitudinal_speed(material, rho, e)


def touching(left, right):
    """Whether two regions share a face."""
    return right.start - left.end <= 1e-12 * max(abs(left.end), abs(right.start), left.end - left.start)


def interface_bond(problem, left, right):
    """Tensile strength of the interface between two touching regions, Pa."""
    for interface in problem.interfaces:
        if {interface.left, interface.right} == {left.name, right.name}:
            return {"bonded": NO_LIMIT, "separable": 0.0, "bond": interface.strength}[interface.kind]
    return 0.0


def assemble(problem: Problem, starts):
    """(zone table, charge table, nodes, gradient, segments, region zone ranges) of a problem at t = 0; `starts`: `start_region` of each."""
    geometry = GEOMETRY.get(problem.geometry).example
    reactive.check(problem)
    counts = [region.zones for region in problem.regions]
    total = sum(counts)
    ends = np.cumsum(counts)
    ranges = [(int(end - count), int(end)) for end, count in zip(ends, counts)]
    # one velocity for both of what parts would pull at them until the interface opens
    pairs = list(zip(problem.regions, problem.regions[1:]))
    breaks = [i for i, pair in enumerate(pairs, 1) if not touching(*pair) or part_freely(problem, *pair)]
    bodies = np.split(np.arange(len(counts)), breaks)
    burning_run = any(reactive.burns(problem, region) for region in problem.regions)
    table, charge = zone_table(len(Z), total), zone_table(len(B), total if burning_run else 0)
    zones, nodes = table[:, :total], np.zeros((len(H), total + len(bodies)))
    nodes[H.bond] = NO_LIMIT
    for k, body in enumerate(bodies):
        for i in body:
            region, (place, rho, e, c), (a, b) = problem.regions[i], starts[i], ranges[i]
            zones[Z.mass, a:b] = rho * volume(place[:-1], place[1:], geometry)
            zones[Z.rho, a:b], zones[Z.e, a:b], zones[Z.c, a:b] = rho, e, c
            material = problem.materials[region.material]
            states = np.broadcast_arrays(rho, e) if material.burn is None else ()
            p = [pressure(*state, material.eos) for state in zip(*map(np.atleast_1d, states))] or reactive.start_region(material, region)[2]
            zones[Z.p, a:b] = zones[Z.sigma, a:b] = p
            zones[Z.compaction, a:b] = [start_compaction(material.eos, *state) for state in zip(*map(np.atleast_1d, states))] or 0.0
            zones[Z.v, a:b] = 1.0 / rho
            zones[Z.width, a:b] = rho * np.diff(place)
            u, first = velocities_at(region, place), a + k
            nodes[H.r, first + 1:b + k + 1], nodes[H.u, first + 1:b + k + 1] = place[1:], u[1:]
            if i == body[0]:
                nodes[H.r, first], nodes[H.u, first] = place[0], u[0]
            else:
                nodes[H.u, first] = welded(zones, a - 1, a, nodes[H.u, first], u[0])
                nodes[H.bond, first] = interface_bond(problem, problem.regions[i - 1], region)
    segments = np.array([(ranges[body[0]][0], ranges[body[-1]][1], L.FREE, L.FREE) for body in bodies], dtype=np.int64)
    segments[0, L.SEG_LEFT], segments[-1, L.SEG_RIGHT] = CODES[problem.left.kind], CODES[problem.right.kind]
    if problem.dimension > 1 and nodes[H.r, 0] == 0.0:
        segments[0, L.SEG_LEFT], nodes[H.u, 0] = L.FIXED, 0.0
    if problem.left.kind == "periodic":
        nodes[H.u, [0, -1]] = welded(zones, 0, total - 1, nodes[H.u, 0], nodes[H.u, -1])
    zones[Z.inverse_mass] = 1.0 / zones[Z.mass]
    if burning_run:
        reactive.prepare(problem, zones, charge, [start[0] for start in starts], ranges)
    gradient = np.zeros(total + 2 * len(segments))
    return table, charge, nodes, gradient, segments, ranges


def boundary_end(problem: Problem, boundary: Boundary, field):
    """An end as the sweeps take it; its class says what is compiled."""
    pulse, table = history(boundary.pulse)
    kinds = problem.left.kind, problem.right.kind
    if "periodic" in kinds:
        return RingEnd(pulse, table, field, joined_seam(problem.regions), sum(region.zones for region in problem.regions) - 1)
    return (OpenEnd if "transmitting" in kinds else End)(pulse, table, field)


def history(pulse: Pulse | None):
    """(pulse numbers, table) of a history as the sweeps take it."""
    if pulse is None:
        return np.zeros(4), np.zeros((2, 1))
    table = np.array([pulse.times, pulse.values]) if pulse.shape == "table" else np.zeros((2, 1))
    return np.array([L.PULSES[pulse.shape], pulse.amplitude, pulse.start, pulse.duration], dtype=float), table
