"""Before the first step: driven and held ends, the numbers that control the time step, and the first step itself."""

import numpy as np

from hugoniot.core.ops import NO_LIMIT
from hugoniot.laws.arrays import temperature_array
from hugoniot.laws.transport.contract import TRANSPORT, longitudinal_viscosity, viscosity
from hugoniot.problem.terms import transport_of
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive, transmitting
from hugoniot.solvers.lagrange1d.friction import EXTRAPOLATED
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.pulses import pulse_value

LARGEST_COLLAPSE = 1e-12     # smallest useful step as a fraction of the stop time


def prepare(solver) -> None:
    """Fill the control numbers of a solver at t = 0, give its driven ends their velocity and plan its first step."""
    problem, control, nodes = solver.problem, solver.control, solver.nodes
    options = problem.solver
    control[L.HEAT_FLUX] = options.options["heat_flux"]
    control[L.COURANT] = options.courant
    control[L.GROWTH] = options.growth
    control[L.DT_LARGEST] = options.largest_step or NO_LIMIT
    control[L.DT_SMALLEST] = LARGEST_COLLAPSE * problem.stop_time
    control[L.GAUGE_INTERVAL] = problem.output.gauge_interval
    for end, zone in ((L.END_LEFT, 0), (L.END_RIGHT, -1)):
        control[end + L.OUTSIDE] = control[end + L.AMBIENT] = solver.zones[Z.sigma, zone]
    transmitting.remember(control, solver.zones)
    transmitting.await_echoes(control, solver.zones, problem)
    for side, end, node in zip((problem.left, problem.right), solver.boundaries, (0, -1)):
        if side.kind == "velocity":
            nodes[H.u, node] = pulse_value.py_func(0.0, end.pulse, end.table)
        if side.kind == "fixed":
            nodes[H.u, node] = 0.0
    plan_first_step(solver)


def plan_first_step(solver) -> None:
    """The first step, and the velocity gradients that the viscosity's limiter looks back at, from the zones as they are."""
    options, control = solver.problem.solver, solver.control
    control[L.RATE] = signal_rate(solver, np.arange(solver.zones.shape[1]))
    first = options.initial_step or 0.1 * control[L.COURANT] / control[L.RATE]
    control[L.DT_NATURAL] = first / control[L.GROWTH]
    control[L.DT] = control[L.DT_OLD] = 0.0     # the leapfrog leaps from velocities at t = 0 to those half a step later
    solver.nodes[H.u_mean] = solver.nodes[H.u]     # no acceleration is known yet
    renew_gradients(solver)


def renew_gradients(solver) -> None:
    """Velocity gradients from the nodes as they are."""
    left, right = solver.faces(H.r)
    ul, ur = solver.faces(H.u)
    places = np.concatenate([np.arange(a, b) + 2 * k + 1 for k, (a, b, _, _) in enumerate(solver.segments)])
    solver.gradient[places] = (ur - ul) / (right - left)


def signal_rate(solver, zones) -> float:
    """Largest (c + 2 w + 4 nu/width) / width of some zones, 1/s: for the first step and impacts.

    w is the viscous speed of a jump as a shock sees it, nu the physical kinematic viscosity.
    """
    problem = solver.problem
    left, right = solver.faces(H.r)
    ul, ur = solver.faces(H.u)
    jump = np.maximum(ul - ur, 0.0)[zones]
    fronts = np.array([reactive.front_speed(problem, region) for region in problem.regions])
    speed = np.maximum(solver.zones[Z.c, zones], fronts[solver.region_of[zones]]) + (16.0 if solver.staggered else 4.0) * jump
    width = (right - left)[zones]
    rate = float(np.max((speed + EXTRAPOLATED * kinematic_viscosities(solver, zones) / width) / width))
    return rate if rate > 0.0 else 1e3 / problem.stop_time


def kinematic_viscosities(solver, zones) -> np.ndarray:
    """(4/3 mu + zeta)/rho of some zones as they are, m^2/s; 0 where a material has no physical viscosity."""
    problem, found = solver.problem, np.zeros(len(zones))
    for k in np.unique(solver.region_of[zones]):
        name = problem.regions[k].material
        own = transport_of(problem.transport[name]) if name in problem.transport else None
        if own is None or own.shear is None:
            continue
        here = solver.region_of[zones] == k
        rho, e = (solver.zones[row, zones[here]] for row in (Z.rho, Z.e))
        warm = "needs_temperature" in TRANSPORT.of(own.shear).flags
        heat = temperature_array(rho, e, problem.materials[name].eos) if warm else np.zeros_like(rho)
        mu = np.array([viscosity(*state, own.shear) for state in zip(rho, heat)])
        found[here] = longitudinal_viscosity(mu, own) / rho
    return found
