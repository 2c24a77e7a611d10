"""Shocks in gases: Noh's implosion, Sedov's blast wave, Saltzman's piston, the triple point."""

from functools import partial

import numpy as np

from hugoniot.campaign.plane.parts import (
    HOLE,
    Bar,
    N,
    PlaneProblem,
    Z,
    asymmetry,
    at_corners,
    box,
    centres,
    gas,
    l1,
    quarter_ring,
    sectors,
    solver_of,
    still,
    walls,
)
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.model import Boundary2D, VelocityField

INWARD = VelocityField(radial=-1.0)
COLD = dict(density=1.0, pressure=1e-10, velocity=INWARD)


# -- Noh ------------------------------------------------------------------------------------------------------------------
def noh_square(geometry, scheme, n, asked):
    sides = walls("b.left", "b.bottom") if geometry == "plane" else walls("b.bottom")
    return solver_of("Noh", geometry, 0.6, box((n, n), (0.0, 1.0), (0.0, 1.0), **COLD), [gas(5.0 / 3.0)], sides, asked, scheme=scheme)


def noh_polar(geometry, angles, n, asked):
    sides = walls("b.bottom", "b.top") if geometry == "plane" else walls("b.bottom")
    block = quarter_ring((n, angles(n)), (HOLE, 1.0), **COLD)
    return solver_of("Noh", geometry, 0.6, block, [gas(5.0 / 3.0)], (still("b.left"), *sides), asked, scheme="area_weighted")


def noh_error(plateau, power, solver):
    """L1 of the density inside r = 0.39 over the plateau, largest distance of the shock of a ten-degree sector from 0.2, densest zone."""
    x, y = centres(solver)
    r, rho = np.hypot(x, y), solver.zones[Z.rho]
    found = {"density_l1": l1(solver, np.where(r < 0.2, plateau, (1.0 + 0.6 / r) ** power), r < 0.39) / plateau}
    ahead, sector, off = 4.0**power, sectors(solver), 0.0
    for k in range(9):
        weight = np.clip((rho - ahead) * (plateau - rho), 0.0, None) ** 4 * ((sector == k) & (abs(r - 0.2) < 0.05))
        off = max(off, abs(float(np.sum(r * weight) / weight.sum()) - 0.2))
    return found | {"shock_position": off, "densest_zone": float(rho.max())}


def noh_round(plateau, power, solver):
    return {"density_l1": noh_error(plateau, power, solver)["density_l1"], "asymmetry": asymmetry(solver)}


# -- Sedov ----------------------------------------------------------------------------------------------------------------
def sedov(geometry, energy, n, asked):
    """`energy` in the corner cell of a quadrant of 1.2 x 1.2, per metre of depth or per radian."""
    block = box((n, n), (0.0, 1.2), (0.0, 1.2), density=1.0, energy=1e-9)
    sides = walls("b.left", "b.bottom") if geometry == "plane" else walls("b.bottom")
    solver = solver_of("Sedov", geometry, 1.0, block, [gas(1.4)], sides, asked, initial_step=1e-7)
    z, corner = solver.zones, [k * n for k in range(solver.problem.mesh.blocks[0].per_cell)]
    z[Z.e, corner] = energy / z[Z.mass, corner].sum()
    z[Z.p, corner] = 0.4 * z[Z.rho, corner] * z[Z.e, corner]
    z[Z.c, corner] = np.sqrt(1.4 * z[Z.p, corner] / z[Z.rho, corner])
    solver.begin()
    return solver


def sedov_front(solver):
    """Peak density (6) by sectors, where it stands (1), and by how much sectors differ."""
    x, y = centres(solver)
    r, rho, sector = np.hypot(x, y), solver.zones[Z.rho], sectors(solver)
    best = [np.flatnonzero(sector == k)[np.argmax(rho[sector == k])] for k in range(9)]
    peaks, place = rho[best], r[best]
    return {"peak_density": float(peaks.mean()), "peak_scatter": float(peaks.std() / peaks.mean()),
            "shock_position": float(abs(place.mean() - 1.0)), "densest_zone": float(rho.max())}


# -- Saltzman -------------------------------------------------------------------------------------------------------------
def saltzman(n, asked):
    """A piston into n / 10 rows of skewed zones."""
    rows = n // 10
    driven = Boundary2D(("b.left",), "velocity", Pulse("constant", 1.0), direction=(1.0, 0.0))
    sides = (driven, *walls("b.right", "b.bottom", "b.top"))
    block = box((n, rows), (0.0, 1.0), (0.0, 0.1), density=1.0, energy=1e-4)
    straight = solver_of("Saltzman", "plane", 0.94, block, [gas(5.0 / 3.0)], sides, asked)
    part = straight.problem.mesh.blocks[0]
    i, j = np.meshgrid(np.arange(n + 1), np.arange(rows + 1), indexing="ij")
    part.x[...] = i / n + (rows - j) * (0.1 / rows) * np.sin(np.pi * i / n)
    straight.problem.mesh.nodes[0, part.nodes.ravel()] = part.x.ravel()
    return type(straight)(straight.problem)


def saltzman_front(solver):
    """At t = 0.6: L1 of the density, mean place and straightness of the shock, largest velocity across."""
    rows = solver.problem.mesh.blocks[0].nj
    x, _ = centres(solver)
    profile, place = solver.zones[Z.rho].reshape(-1, rows), x.reshape(-1, rows)
    last = [int(np.max(np.nonzero(profile[:, j] > 2.5)[0])) for j in range(rows)]
    front = [float(np.interp(2.5, profile[[k + 1, k], j], place[[k + 1, k], j])) for j, k in enumerate(last)]
    return {"density_l1": l1(solver, np.where(x < 0.8, 4.0, 1.0)), "shock_position": float(abs(np.mean(front) - 0.8)),
            "front_rms": float(np.std(front)), "velocity_across": float(np.abs(at_corners(solver, N.v)).max())}


def reached(solver):
    """How far a run came."""
    return {"time_reached": solver.time}


# -- the triple point ---------------------------------------------------------------------------------------------------------
def triple_point(n, asked):
    """Shocked gas beside two layers of different gases at rest, with n zones to the unit length."""
    half, driver, rest = 3 * n // 2, dict(density=1.0, pressure=1.0), dict(pressure=0.1)
    blocks = [box((n, half), (0.0, 1.0), (0.0, 1.5), "a", "light", **driver),
              box((n, half), (0.0, 1.0), (1.5, 3.0), "b", "light", **driver),
              box((6 * n, half), (1.0, 7.0), (0.0, 1.5), "c", "heavy", density=1.0, **rest),
              box((6 * n, half), (1.0, 7.0), (1.5, 3.0), "d", "light", density=0.125, **rest)]
    sides = walls("a.left", "b.left", "a.bottom", "c.bottom", "b.top", "d.top", "c.right", "d.right")
    gases = [gas(1.5, "light"), gas(1.4, "heavy")]
    return solver_of("triple point", "plane", 3.0, blocks, gases, sides, asked)


def layers(solver):
    """Length of the line between the two layers, which rolls up."""
    block = solver.problem.mesh.blocks[2]
    x, y = (solver.nodes[row, solver.numbering.representative][block.nodes[:, -1]] for row in (N.x, N.y))
    return float(np.hypot(np.diff(x), np.diff(y)).sum())


def rolled(solver):
    """The same beside that of a mesh twice as fine, and how far the run came."""
    finer = triple_point(2 * solver.problem.blocks[0].zones[0], {})
    while finer.time < solver.time:
        finer.march(solver.time, 10_000)
    return {"interface_length": abs(layers(solver) / layers(finer) - 1.0), "time_reached": solver.time}


PROBLEMS = (
    PlaneProblem("noh_square", "Noh's cylindrical implosion on square zones", partial(noh_square, "plane", "true_volume"), 0.6,
                 partial(noh_error, 16.0, 1),
                 (Bar("density_l1", 50, goal=0.036, peer=0.0533), Bar("density_l1", 100, goal=0.020),
                  Bar("shock_position", 50, goal=0.004, peer=0.0763), Bar("shock_position", 100, goal=0.004),
                  Bar("densest_zone", 50, goal=17.0, peer=28.9), Bar("densest_zone", 100, goal=17.0)), (50, 100)),
    PlaneProblem("noh_ring", "Noh's cylindrical implosion on a polar mesh, 75 x 30 and 150 x 60 zones",
                 partial(noh_polar, "plane", lambda n: n * 2 // 5), 0.6, partial(noh_round, 16.0, 1),
                 (Bar("density_l1", 75, goal=0.015, peer=0.0177), Bar("density_l1", 150, goal=0.0075, peer=0.0087),
                  Bar("asymmetry", 75, goal=1e-10), Bar("asymmetry", 150, goal=1e-10)), (75, 150)),
    PlaneProblem("noh_sphere", "Noh's spherical implosion on square zones, scheme true_volume",
                 partial(noh_square, "axisymmetric", "true_volume"), 0.6, partial(noh_error, 64.0, 2),
                 (Bar("density_l1", 50, goal=0.050, peer=0.0581), Bar("density_l1", 100, goal=0.025, peer=0.0294)), (50, 100)),
    PlaneProblem("noh_sphere_polar", "Noh's spherical implosion on a polar mesh, 100 x 30 zones, scheme area_weighted",
                 partial(noh_polar, "axisymmetric", lambda n: n * 3 // 10), 0.6, partial(noh_round, 64.0, 2),
                 (Bar("density_l1", 100, goal=0.035, peer=0.0383), Bar("asymmetry", 100, goal=1e-10, peer=2e-7)), (100,)),
    PlaneProblem("sedov_square", "Sedov's cylindrical blast wave on square zones", partial(sedov, "plane", 0.984074 / 4.0), 1.0,
                 sedov_front,
                 (Bar("peak_density", 45, goal=5.5, sense="above"), Bar("peak_density", 90, goal=5.5, sense="above"),
                  Bar("densest_zone", 45, goal=6.1), Bar("densest_zone", 90, goal=6.1),
                  Bar("peak_scatter", 45, goal=0.02, peer=0.05), Bar("peak_scatter", 90, goal=0.02, peer=0.05),
                  Bar("shock_position", 45, goal=0.01), Bar("shock_position", 90, goal=0.005)), (45, 90)),
    PlaneProblem("sedov_sphere", "Sedov's spherical blast wave on square zones",
                 partial(sedov, "axisymmetric", 0.851072 / (4.0 * np.pi)), 1.0, sedov_front,
                 (Bar("shock_position", 45, goal=0.005, peer=0.021), Bar("shock_position", 90, goal=0.005)), (45, 90)),
    PlaneProblem("saltzman_skewed", "Saltzman's piston drives a shock into skewed zones, at t = 0.6", saltzman, 0.6, saltzman_front,
                 (Bar("density_l1", 100, goal=0.09, peer=0.300), Bar("front_rms", 100, goal=1e-3, peer=1e-3),
                  Bar("velocity_across", 100, goal=0.05, peer=0.116)), (100,)),
    PlaneProblem("saltzman_reflected", "The same piston until after the second reflection of the shock, t = 0.94", saltzman, 0.94, reached,
                 (Bar("time_reached", 100, goal=0.94, peer=0.907, sense="above"),), (100,)),
    PlaneProblem("triple_point", "triple-point problem to t = 3, compared with a mesh twice as fine", triple_point, 3.0, rolled,
                 (*(Bar("interface_length", n, goal=0.05) for n in (4, 8)),
                  *(Bar("time_reached", n, goal=3.0, sense="above") for n in (4, 8))), (4, 8)),
)
