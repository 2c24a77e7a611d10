"""Balances, exchanges and peak values of a run in two dimensions, read from the solver's arrays without changing them."""

import numpy as np

from hugoniot.solvers.lagrange1d import accounts as line
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import quads as G
from hugoniot.solvers.lagrange2d.assemble import N, Z

B = L.Charge(*range(len(L.Charge._fields)))

ZONE_FIELDS = {"density": Z.rho, "energy": Z.e, "pressure": Z.p, "viscous_pressure": Z.q, "sound_speed": Z.c, "deviator_xx": Z.sxx,
               "deviator_yy": Z.syy, "deviator_xy": Z.sxy, "plastic_strain": Z.plastic_strain, "damage": Z.damage,
               "plastic_work": Z.plastic_work, "viscous_work": Z.viscous_work}


def zone_fields(zones) -> dict[str, np.ndarray]:
    """The fields of zones, by the words of `core.fields`: views of the table, as far as they stand in it."""
    found = {name: zones[row] for name, row in ZONE_FIELDS.items()}
    return found | {"deviator_zz": -(found["deviator_xx"] + found["deviator_yy"]), "mass": zones[Z.mass]}


def fields_of_laws(solver) -> dict[str, np.ndarray]:
    """Void fraction where zones open; burn fraction where something burns and, in thermal isolation, the code of the reference state."""
    voids = {"void_fraction": solver.zones[Z.voids] * solver.zones[Z.rho]} if solver.opens_voids else {}
    lit = {"burn_fraction": solver.charge[B.lam].copy()} if solver.burning else {}
    isolated = solver.burning and any(reactive.isolated(solver.problem))
    return voids | lit | ({"reference_state": solver.charge[B.reference].copy()} if isolated else {})


def largest_speed(problem, zones, nodes) -> float:
    """Of sound, of nodes and of what is driven at t = 0, m/s."""
    pulses = [b.pulse for b in problem.boundaries if b.kind == "velocity" and b.pulse]
    return max(float(zones[Z.c].max()), float(np.hypot(nodes[N.u], nodes[N.v]).max()),
               *(abs(v) for pulse in pulses for v in (pulse.amplitude, *pulse.values)))


def ranges(problem) -> list[tuple[int, int]]:
    """First zone of every block, and the one after its last."""
    return [(part.first_zone, part.first_zone + part.zones) for part in problem.mesh.blocks]


def kinetic_energy(nodes) -> float:
    """J per metre or per radian."""
    return 0.5 * float(np.sum(nodes[N.own] * (nodes[N.u] ** 2 + nodes[N.v] ** 2)))


def total_energy(zones, nodes) -> float:
    """Kinetic and internal energy, J per metre or per radian."""
    return kinetic_energy(nodes) + float(np.sum(zones[Z.mass] * zones[Z.e]))


def momentum(nodes) -> np.ndarray:
    """(x, y), kg m/s per metre or per radian."""
    return np.array([np.sum(nodes[N.own] * nodes[row]) for row in (N.u, N.v)])


def errors(solver) -> dict[str, float]:
    """Relative mass, momentum and energy errors against the impulse and work of the boundaries.

    In axisymmetric flow the hoop stress works on the radial momentum, which then has no balance (NaN); the area-weighted scheme
    does not keep the axial one either, and its error is the drift.
    """
    zones, nodes, chains = solver.zones, solver.nodes, solver.chains
    work = float(chains[:, L.CHAIN_WORK].sum() + solver.control[L.GRAVITY_WORK])
    internal = float(np.sum(zones[Z.mass] * np.abs(zones[Z.e])))
    scale = max(abs(solver.start_energy), abs(work), kinetic_energy(nodes) + internal, 1e-300)
    gone = solver.erosion.dropped
    weight = float(nodes[N.own].sum()) * solver.time + gone[4]
    impulse = chains[:, [L.CHAIN_IMPULSE_X, L.CHAIN_IMPULSE_Y]].sum(axis=0) + weight * np.array(solver.problem.body_force)
    size = float(np.sum(nodes[N.own] * np.hypot(nodes[N.u], nodes[N.v])))
    # of what is in balance all velocities are round-off: that of its stress, which rho c makes a velocity of
    sound, stress = zones[Z.rho] * zones[Z.c], np.max(np.abs(zones[[Z.p, Z.sxx, Z.syy, Z.sxy]]), axis=0)
    size = max(size, float(np.sum(zones[Z.mass] * np.divide(stress, sound, out=np.zeros_like(sound), where=sound > 0.0))),
               *np.abs(solver.start_momentum), np.abs(chains[:, 1:]).max(initial=0.0), 1e-300)
    drift = np.abs(momentum(nodes) + gone[1:3] - solver.start_momentum - impulse) / size
    if solver.kind != G.PLANAR:
        drift[0] = np.nan
    return {"mass_error": float(abs((zones[Z.mass].sum() + gone[0]) / solver.start_mass - 1.0)), "momentum_error": float(np.nanmax(drift)),
            "momentum_x_error": float(drift[0]), "momentum_y_error": float(drift[1]),
            "energy_error": abs(total_energy(zones, nodes) + gone[3] - solver.start_energy - work) / scale}


def signal_rate(solver) -> float:
    """Largest (c + 4 du) / altitude, du the fastest closing of two corners: guards the first step."""
    x, y, u, v = (solver._corners(row) for row in (N.x, N.y, N.u, N.v))
    jump = np.zeros(solver.zones.shape[1])
    for a in range(len(x)):
        for b in range(a + 1, len(x)):
            dx, dy = x[b] - x[a], y[b] - y[a]
            length = np.hypot(dx, dy)
            closing = -((u[b] - u[a]) * dx + (v[b] - v[a]) * dy) / np.where(length > 0.0, length, 1.0)
            jump = np.maximum(jump, np.where(length > 0.0, closing, 0.0))
    rate = float(np.max((np.maximum(solver.zones[Z.c], solver.fronts) + 4.0 * jump) * solver._inverse_altitudes()))
    return rate if rate > 0.0 else 1e3 / solver.problem.stop_time


def exchanges(solver) -> dict[str, float]:
    """Work (J) and impulse (kg m/s) of every chain of edges so far, the work of a body force (J), and the heat that burning released (J);
    mass (kg), momentum and energy of eroded zones whose mass is dropped.

    What a wall that lets go, which is a rigid body of the name of its chain, does to the material is counted for the chain.
    """
    found: dict[str, float] = {}
    for name, values in zip(solver.boundaries.chains, solver.chains):
        plain = name.removeprefix("rigid ")
        name = plain if plain in solver.problem.mesh.chains else name
        for word, value in zip(("work", "impulse_x", "impulse_y"), values):
            found[f"{word} {name}"] = found.get(f"{word} {name}", 0.0) + float(value)
    found |= solver.contact.exchanges() | solver.erosion.exchanges()
    if any(solver.problem.body_force):
        found["force_work"] = float(solver.control[L.GRAVITY_WORK])
    if solver.burning:
        found["released_heat"] = reactive.released_heat(solver.problem, solver.zones[Z.mass], solver.charge[B.lam], ranges(solver.problem))
    return found


def peaks(zones) -> dict[str, np.ndarray]:
    """Peak fields of every zone so far: stress and pressure in compression, tension positive."""
    return {"peak_stress": zones[Z.peak_stress].copy(), "peak_tension": -zones[Z.peak_tension],
            "peak_pressure": zones[Z.peak_pressure].copy(), "peak_density": zones[Z.peak_density].copy()}


def largest_velocity_jump(problem, zones) -> dict[str, float]:
    """Material -> largest particle velocity of a shock in it, from its peak pressure on the Rayleigh line, m/s."""
    return line.largest_velocity_jump(problem, zones[Z.peak_pressure], zones[Z.peak_density], ranges(problem))


def doubts(solver) -> list[str]:
    """Sentences about rates of burning that the mesh did not resolve, and about explosives in tension beyond what they can support."""
    if not solver.burning:
        return []
    return reactive.doubts(solver.problem, solver.charge[B.resolution], -solver.zones[Z.peak_tension], ranges(solver.problem))


def references(solver) -> list[tuple[str, str]]:
    """How the reference state of reactants in thermal isolation was found, by block."""
    found = reactive.references(solver.problem, solver.charge[B.reference], ranges(solver.problem)) if solver.burning else []
    return [("reference_state", text) for text in found]
