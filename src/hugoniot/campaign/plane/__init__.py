"""Standard problems of the two-dimensional solver, each with its exact answer or the field's numbers, and a run of any of them.

Every problem runs with the default settings of `Solver2D`, but for the cells of those on triangles; only the number of zones changes.
"""

from hugoniot.campaign.plane import bodies, explosives, gases, impacts, smooth, triangles
from hugoniot.campaign.plane.parts import PlaneProblem
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

PLANE: dict[str, PlaneProblem] = {problem.name: problem for room in (gases, smooth, bodies, explosives, impacts, triangles)
                                  for problem in room.PROBLEMS}
MARCH = 10_000      # cycles at a time

__all__ = ["PLANE", "PlaneProblem", "run_plane"]


def run_plane(problem: PlaneProblem, zones: int, **options) -> Lagrange2D:
    """The solver of a problem at its stop time; `options` are fields of `Solver2D` that differ from their defaults."""
    solver = problem.start(zones, options)
    while solver.time < problem.stop:
        if problem.before_step:
            problem.before_step(solver)
        solver.march(problem.stop, 1 if problem.before_step else MARCH)
    return solver
