"""Standard problems on triangles: every cell of the mesh divided by a diagonal, all of them one way unless another pattern is asked for."""

from functools import partial

from hugoniot.campaign.plane.bodies import LENGTH, RADIUS, bar, copper
from hugoniot.campaign.plane.gases import noh_error, noh_square, sedov, sedov_front
from hugoniot.campaign.plane.parts import Bar, N, PlaneProblem, Z

TRIANGLES = {"cells": "triangles"}
MARCH = 10_000      # cycles at a time


def divided(start, n, asked):
    """A problem of quadrilaterals on triangles."""
    return start(n, {**TRIANGLES, **asked})


def beside_quads(start, stop, solver):
    """Length, radius of the foot and largest plastic strain of a Taylor bar, each over that of the bar of quadrilaterals, less 1."""
    quads = start(solver.problem.mesh.blocks[0].ni, {})
    while quads.time < stop:
        quads.march(stop, MARCH)

    def sizes(s):
        return {"length": s.nodes[N.y].max(), "foot": s.nodes[N.x].max(), "plastic_strain": s.zones[Z.plastic_strain].max()}

    ours, theirs = sizes(solver), sizes(quads)
    return {f"{name}_beside_quads": float(abs(ours[name] / theirs[name] - 1.0)) for name in ours}


_NOH, _SEDOV = partial(noh_square, "plane", "true_volume"), partial(sedov, "plane", 0.984074 / 4.0)
_BAR = partial(bar, copper(), 227.0, LENGTH / RADIUS)

PROBLEMS = (
    PlaneProblem("noh_triangles", "Noh's cylindrical implosion on triangles, n x n cells", partial(divided, _NOH), 0.6,
                 partial(noh_error, 16.0, 1),
                 (Bar("density_l1", 50, peer=0.0533), Bar("shock_position", 50, peer=0.0763), Bar("densest_zone", 50, peer=28.9)),
                 (50, 100)),
    PlaneProblem("sedov_triangles", "Sedov's cylindrical blast wave on triangles, n x n cells", partial(divided, _SEDOV), 1.0, sedov_front,
                 (), (45, 90)),
    PlaneProblem("taylor_triangles", "Taylor bar of copper on triangles, compared with the same bar on quadrilaterals",
                 partial(divided, _BAR), 80e-6,
                 partial(beside_quads, _BAR, 80e-6), tuple(Bar("length_beside_quads", n, goal=0.02) for n in (5, 10, 20)), (5, 10)),
)
