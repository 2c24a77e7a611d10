"""Impacts on porous material: laws, problems and what a run of them left, shared by the tests of tracked fronts."""

from types import MappingProxyType

from hugoniot.laws.eos import p_alpha, p_lambda, snow_plough
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Region, SolverOptions
from hugoniot.simulate import make_solver

FREE = Boundary("free")
COPPER = MieGruneisen(rho0=8930.0, c0=3940.0, s=1.489, gamma0=1.99)
SOLID = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)
ALPHA0, P_E, P_S = 1.275, 0.08e9, 0.7e9
REST = 2700.0 / ALPHA0
LAWS = {"p_alpha": p_alpha.build(SOLID, ALPHA0, P_E, P_S), "snow_plough": snow_plough.build(SOLID, 2100.0, 0.2e9),
        "p_lambda, n = 1": p_lambda.build(SOLID, 2100.0, 25e9, 0.4e9, 1.0), "p_lambda": p_lambda.build(SOLID, 2100.0, 25e9, 0.4e9, 1.2)}


def impact(law, speed, stop=2e-6, mode="algebraic", solver="fronts", zones=(4, 8, 4), mirrored=False, thick=0.002, **options):
    """A copper flyer (2 mm thick) on 6 mm of porous material on 4 mm of copper."""
    names, ends = ("flyer", "foam", "anvil"), (0.002 - thick, 0.002, 0.008, 0.012)
    bodies = [(name, "foam" if name == "foam" else "cu", a, b, speed * (name == "flyer"), n)
              for name, a, b, n in zip(names, ends, ends[1:], zones)]
    gauge = 0.0025
    if mirrored:
        bodies = [(name, matter, -b, -a, -u, n) for name, matter, a, b, u, n in reversed(bodies)]
        gauge = -gauge
    regions = tuple(Region(name, matter, a, b, n, velocity=u) for name, matter, a, b, u, n in bodies)
    given = SolverOptions("fronts", options=MappingProxyType({"mode": mode, **options})) if solver == "fronts" else SolverOptions()
    return Problem("impact", "planar", stop, regions, {"cu": Material("cu", COPPER), "foam": Material("foam", law)}, FREE, FREE,
                   gauges=(Gauge("middle", gauge),), solver=given, output=OutputOptions(gauge_interval=stop / 20, report=False))


def marched(problem, until=None, most=10**9):
    solver = make_solver(problem)
    solver.march(until or problem.stop_time, most)
    return solver


def table(solver):
    """[(kind, row by name)] of the fronts that there were."""
    columns, kinds, rows = solver.front_table()
    return [(kind, dict(zip(columns, row))) for kind, row in zip(kinds, rows.tolist())]
