"""Flows without shocks: Coggeshall's and Kidder's compressions, Gresho's vortex and Taylor-Green vortices.

What they lose is the scheme's own dissipation.
"""

import numpy as np

from hugoniot.campaign.plane.parts import Bar, N, PlaneProblem, Z, box, centres, gas, quarter_ring, solver_of, walls
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.model import Boundary2D, VelocityField, Viscosity2D
from hugoniot.theory.exact.coggeshall import coggeshall
from hugoniot.theory.exact.kidder import kidder

ANGLES = 24
COLLAPSE, PART = kidder().numbers["tau"], 0.9


def set_pressure(solver, pressure, gamma):
    """Give every zone of a gas a pressure at its density."""
    z = solver.zones
    z[Z.p], z[Z.e] = pressure, pressure / ((gamma - 1.0) * z[Z.rho])
    z[Z.c] = np.sqrt(gamma * z[Z.p] / z[Z.rho])
    z[Z.sigma] = z[Z.p]


# -- Coggeshall -------------------------------------------------------------------------------------------------------------
def compressed(n, asked):
    """The unit square in r and z; its outer edges move as the exact flow does."""
    times = np.linspace(0.0, 0.8, 4001)

    def driven(name, way, speed, rate):
        pulse = Pulse("table", times=tuple(times), values=tuple(speed * (1.0 - times) ** rate))
        return Boundary2D((name,), "velocity", pulse, direction=way)

    flow = coggeshall()
    b = flow.numbers["axial_rate"]
    block = box((n, n), (0.0, 1.0), (0.0, 1.0), density=1.0, energy=1e-6, velocity=VelocityField(gradient=((-1.0, 0.0), (0.0, -b))))
    sides = (driven("b.right", (1.0, 0.0), -1.0, 0.0), driven("b.top", (0.0, 1.0), -b, b - 1.0), *walls("b.bottom"))
    solver = solver_of("Coggeshall", "axisymmetric", 0.8, block, [gas(5.0 / 3.0)], sides, asked)
    x, y = centres(solver)
    set_pressure(solver, flow(np.stack([x, y], axis=-1), 0.0)["pressure"], 5.0 / 3.0)
    solver.begin()
    return solver


def uniform(solver):
    """Largest deviation of the density of a zone from the exact one."""
    return {"density": float(np.abs(solver.zones[Z.rho] * 0.2**2.25 - 1.0).max())}


# -- Kidder -------------------------------------------------------------------------------------------------------------------
def ring(n, asked):
    """A ring of gas of gamma 2 under the pressures of the exact solution: a block for each of n rows, each with its density."""
    exact, faces = kidder(), np.linspace(0.9, 1.0, n + 1)
    start = exact.profile(0.5 * (faces[1:] + faces[:-1]), 0.0)
    blocks = [quarter_ring((1, ANGLES), faces[k:k + 2], f"r{k}", density=float(start["density"][k]), pressure=float(start["pressure"][k]))
              for k in range(n)]
    times = np.linspace(0.0, PART * COLLAPSE, 4001)
    growth = (1.0 - (times / COLLAPSE) ** 2) ** -2.0
    loads = [Boundary2D((chain,), "pressure", Pulse("table", times=tuple(times), values=tuple(edge * growth)))
             for chain, edge in (("r0.left", 0.1), (f"r{n - 1}.right", 10.0))]
    sides = walls(*(f"{block.name}.{side}" for block in blocks for side in ("bottom", "top")))
    return solver_of("Kidder", "plane", PART * COLLAPSE, blocks, [gas(2.0)], (*loads, *sides), asked)


def squeezed(solver):
    """Radii of both surfaces beside the exact ones, roundness, and how much of the energy the viscosity has made."""
    radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(-1, 2, ANGLES + 1)
    scale, z = np.sqrt(1.0 - PART**2), solver.zones
    return {"inner_radius": float(abs(radius[0, 0].mean() / (0.9 * scale) - 1.0)),
            "outer_radius": float(abs(radius[-1, 1].mean() / scale - 1.0)), "asymmetry": float(np.ptp(radius, axis=2).max()),
            "viscous_work": float(abs(np.sum(z[Z.mass] * z[Z.viscous_work])) / np.sum(z[Z.mass] * z[Z.e]))}


# -- Gresho -------------------------------------------------------------------------------------------------------------------
def vortex(n, asked):
    """Gresho's vortex in the unit square, gamma 5/3: rotation that the pressure holds."""
    block = box((n, n), (-0.5, 0.5), (-0.5, 0.5), density=1.0, pressure=5.0)
    sides = walls("b.left", "b.right", "b.bottom", "b.top")
    solver = solver_of("Gresho", "plane", 0.1, block, [gas(5.0 / 3.0)], sides, asked)
    x, y = solver.nodes[N.x], solver.nodes[N.y]
    r = np.hypot(x, y)
    spin = np.where(r < 0.2, 5.0, np.where(r < 0.4, 2.0 / np.where(r > 0.0, r, 1.0) - 5.0, 0.0))
    solver.nodes[N.u], solver.nodes[N.v] = -spin * y, spin * x
    r = np.hypot(*centres(solver))
    outside = np.where(r < 0.4, 9.0 - 4.0 * np.log(0.2) + 12.5 * r**2 - 20.0 * r + 4.0 * np.log(r), 3.0 + 4.0 * np.log(2.0))
    set_pressure(solver, np.where(r < 0.2, 5.0 + 12.5 * r**2, outside), 5.0 / 3.0)
    solver.begin()
    return solver


def loss(solver):
    """What the fastest node has lost of its speed of 1, and L2 of the speed."""
    x, y = solver.nodes[N.x], solver.nodes[N.y]
    r, speed = np.hypot(x, y), np.hypot(solver.nodes[N.u], solver.nodes[N.v])
    exact = np.where(r < 0.2, 5.0 * r, np.where(r < 0.4, 2.0 - 5.0 * r, 0.0))
    return {"peak_speed": float(1.0 - speed.max()), "speed_l2": float(np.sqrt(np.mean((speed - exact) ** 2)))}


# -- Taylor and Green --------------------------------------------------------------------------------------------------------
def heat(solver):
    """Set free the heat that keeps the vortices steady, between two steps that of half of each, which are nearly equal."""
    z, (x, y) = solver.zones, np.pi * np.array(centres(solver))
    time = solver.step if solver.cycle else 0.5 * solver.problem.solver.initial_step
    set_free = time * 0.375 * np.pi * (np.cos(3.0 * x) * np.cos(y) - np.cos(x) * np.cos(3.0 * y))
    solver.start_energy += float(np.sum(z[Z.mass] * set_free))
    set_pressure(solver, z[Z.p] + 2.0 / 3.0 * z[Z.rho] * set_free, 5.0 / 3.0)
    solver.rewind.forget()


def vortices(n, asked):
    """Taylor-Green vortices in the unit square, without viscosity."""
    options = {"viscosity": Viscosity2D(linear=0.0, quadratic=0.0), "initial_step": 0.05 / n, "largest_step": 0.05 / n, **asked}
    sides = walls("b.left", "b.right", "b.bottom", "b.top")
    block = box((n, n), (0.0, 1.0), (0.0, 1.0), density=1.0, pressure=1.0)
    solver = solver_of("Taylor and Green", "plane", 0.5, block, [gas(5.0 / 3.0)], sides, options)
    solver.nodes[N.u], solver.nodes[N.v] = green(solver.nodes[N.x], solver.nodes[N.y])
    x, y = np.pi * np.array(centres(solver))
    set_pressure(solver, 1.0 + 0.25 * (np.cos(2.0 * x) + np.cos(2.0 * y)), 5.0 / 3.0)
    solver.begin()
    return solver


def green(x, y):
    """The steady velocity (u, v)."""
    return np.sin(np.pi * x) * np.cos(np.pi * y), -np.cos(np.pi * x) * np.sin(np.pi * y)


def turned(solver):
    """L2 of the velocity of the nodes, by mass."""
    n = solver.nodes
    u, v = green(n[N.x], n[N.y])
    return {"velocity_l2": float(np.sqrt(np.sum(n[N.own] * ((n[N.u] - u) ** 2 + (n[N.v] - v) ** 2)) / n[N.own].sum()))}


PROBLEMS = (
    PlaneProblem("coggeshall_rz", "Coggeshall's smooth compression of a cylinder of gas, t = 0.8", compressed, 0.8, uniform,
                 (Bar("density", 20, goal=0.005), Bar("density", 40, goal=0.005)), (20, 40)),
    PlaneProblem("kidder_ring", "Kidder's isentropic compression of a ring, to 0.9 of its collapse time", ring, PART * COLLAPSE, squeezed,
                 (Bar("inner_radius", 100, goal=1e-4), Bar("outer_radius", 100, goal=1e-4), Bar("asymmetry", 100, goal=1e-12),
                  Bar("viscous_work", 100, goal=1e-3)), (25, 50, 100)),
    PlaneProblem("gresho", "Gresho's steady vortex after half a radian of rotation", vortex, 0.1, loss,
                 (Bar("peak_speed", 40, goal=0.05),), (20, 40, 80)),
    PlaneProblem("taylor_green", "Taylor-Green vortices, kept steady by a heat source, t = 0.5, no viscosity", vortices, 0.5, turned,
                 (), (16, 32, 64), heat),
)
