"""The balances of a run: energy, momentum, what passed the ends, the errors of these balances, and the largest values of zones.

Extensive quantities are per m^2 (planar), per m and radian (cylindrical) or per steradian (spherical).
"""

import numpy as np

from hugoniot.laws.eos.contract import flagged, reference_state
from hugoniot.problem.forming import forming, settled
from hugoniot.problem.starting import start_at_ends
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange1d.layout import B, H, Z

ENDS = {"work_left": L.WORK_LEFT, "work_right": L.WORK_RIGHT, "impulse_left": L.IMPULSE_LEFT, "impulse_right": L.IMPULSE_RIGHT}


def kinetic_energy(nodes) -> float:
    """Kinetic energy of the nodes, J."""
    return 0.5 * np.sum(nodes[H.mass] * nodes[H.u] ** 2)


def total_energy(solver) -> float:
    """Kinetic and internal energy, J."""
    return float(kinetic_energy(solver.nodes) + np.sum(solver.zones[Z.mass] * solver.zones[Z.e]))


def momentum(solver) -> float:
    """Momentum, kg m/s."""
    return float(np.sum(solver.nodes[H.mass] * solver.nodes[H.u]))


def errors(solver) -> dict[str, float]:
    """Relative mass, momentum and energy errors against the boundary's impulse and work; of momentum NaN for the curved leapfrog."""
    control, zones, nodes = solver.control, solver.zones, solver.nodes
    work = control[L.WORK_LEFT] + control[L.WORK_RIGHT] + control[L.FORCE_WORK] + control[L.SUPPLIED]
    internal = float(np.sum(zones[Z.mass] * np.abs(zones[Z.e])))
    scale = max(abs(solver.start_energy), abs(work), float(kinetic_energy(nodes)) + internal, 1e-300)
    impulse = control[L.IMPULSE_LEFT] + control[L.IMPULSE_RIGHT] + control[L.RADIAL_IMPULSE] + control[L.FORCE_IMPULSE]
    impulse += control[L.LOST_IMPULSE]
    kept = not solver.staggered or solver.problem.dimension == 1     # else accelerations are no forces over the nodes' masses
    size = float(np.sum(nodes[H.mass] * np.abs(nodes[H.u])))
    size = max(size, abs(solver.start_momentum), abs(control[L.IMPULSE_LEFT]), abs(control[L.IMPULSE_RIGHT]), abs(control[L.FORCE_IMPULSE]),
               1e-300)
    return {
        "mass_error": float(abs(zones[Z.mass].sum() / solver.start_mass - 1.0)),
        "momentum_error": abs(momentum(solver) - solver.start_momentum - impulse) / size if kept else float("nan"),
        "energy_error": abs(total_energy(solver) - solver.start_energy - work) / scale,
    }


def exchanges(solver) -> dict[str, float]:
    """Work (J) and impulse (kg m/s) of the two ends so far, of a body force and of heat sources, and the chemical energy released (J)."""
    found = {name: float(solver.control[row]) for name, row in ENDS.items()}
    if solver.problem.body_force is not None:
        found |= {"force_work": float(solver.control[L.FORCE_WORK]), "force_impulse": float(solver.control[L.FORCE_IMPULSE])}
    if solver.problem.heat_sources:
        found["supplied_heat"] = float(solver.control[L.SUPPLIED])
    if solver.burning:
        found["released_heat"] = reactive.released_heat(solver.problem, solver.zones[Z.mass], solver.charge[B.lam], solver.region_ranges)
    return found


def largest_velocity_jump(problem, peak_pressure, peak_density, region_ranges) -> dict[str, float]:
    """Material -> largest particle velocity of a shock in it, from its peak pressure on the Rayleigh line, m/s. Rows (nzone,).

    The overshoot of a shock that is forming does not count (`problem.forming`).

    The shock starts from the initial density, but in solids and liquids that start compressed from the reference density: their laws
    are extrapolated as far as behind such a shock.
    """
    found: dict[str, float] = {}
    form = forming(problem)
    for region, (first, last) in zip(problem.regions, region_ranges):
        law = problem.materials[region.material].eos
        rho0, p0 = min(start_at_ends(problem, region))
        if not flagged(law, "gas") and rho0 > (rest := float(reference_state(law)[0])):
            rho0, p0 = rest, 0.0
        peak = int(first + np.argmax(settled(peak_pressure[first:last], form[first:last])))
        squeeze = 1.0 - rho0 / max(peak_density[peak], rho0)
        jump = float(np.sqrt(max(peak_pressure[peak] - p0, 0.0) * squeeze / rho0))
        found[region.material] = max(found.get(region.material, 0.0), jump)
    return found


def peaks(solver) -> dict[str, np.ndarray]:
    """Peak fields of every zone so far: stress and pressure in compression, tension positive."""
    zones = solver.zones
    return {"peak_stress": zones[Z.peak_stress].copy(), "peak_tension": -zones[Z.peak_tension],
            "peak_pressure": zones[Z.peak_pressure].copy(), "peak_density": zones[Z.peak_density].copy()}
