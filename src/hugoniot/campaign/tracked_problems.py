"""Problems with tracked fronts: shocks, contacts and fans that are exact, and cells behind a front of no width.

Those of the mode `algebraic` have no mesh: zones only say where fields are read. The numbers of the meetings of shocks in a gas come
from an exact Riemann solver that shares nothing with this package. Measures are relative differences, positions over the length of the
line.
"""

import dataclasses
import math
from collections.abc import Callable
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.problem.standard import gases
from hugoniot.problem.standard.parts import Bar, bonded
from hugoniot.simulate import make_solver
from hugoniot.solvers.fronts.cells import tables
from hugoniot.theory import riemann
from hugoniot.theory.exact.elastic_plastic_piston import Solid, elastic_plastic_piston
from hugoniot.theory.isentrope import state as reference_state
from hugoniot.theory.stability import Wave

FIXED, OPEN = Boundary("fixed"), Boundary("transmitting")
EXACT = {"fronts": 1e-10, "states": 1e-12}      # goals of what has a closed answer
READ = 10                                       # zones, where they only say where fields are read


class TrackedProblem(NamedTuple):
    """A problem with a known answer.

    build      zones -> problem
    measure    solver at the stop time -> {measure: value}
    bars       numbers to beat; zones: the grids
    mode       of the solver: "algebraic" or "cells"
    """

    name: str
    description: str
    build: Callable[[int], Problem]
    measure: Callable[[Any], dict[str, float]]
    bars: tuple[Bar, ...]
    zones: tuple[int, ...] = (READ,)
    mode: str = "algebraic"


def run_tracked(problem: TrackedProblem, zones: int):
    """The solver of a problem at its stop time."""
    asked = problem.build(zones)
    solver = make_solver(dataclasses.replace(asked, solver=SolverOptions("fronts", options=MappingProxyType({"mode": problem.mode}))))
    solver.march(asked.stop_time, 10**9)
    while solver.time < asked.stop_time:
        solver.march(asked.stop_time, 10**9)
    return solver


def _goals(**goals: float) -> tuple[Bar, ...]:
    return tuple(Bar(name, READ, goal=goal) for name, goal in goals.items())


def off(found, expected) -> float:
    """Largest relative difference between two rows of numbers; infinite where they differ in number."""
    found, expected = np.asarray(found, dtype=float), np.asarray(expected, dtype=float)
    return float(np.abs(found / expected - 1.0).max()) if found.shape == expected.shape else math.inf


# -- tubes ---------------------------------------------------------------------------------------------------------------
def _tube(name: str, words: str, build, middle: float, stop: float = math.inf) -> TrackedProblem:
    """All waves of a tube, against the Riemann solver of `theory`."""
    def cut(zones):
        problem = build(zones)
        return dataclasses.replace(problem, stop_time=min(stop, problem.stop_time))

    def measure(solver):
        laws = [solver.problem.materials[r.material].eos for r in solver.problem.regions]
        outer = [piece.state for piece in (solver.line.pieces[1], solver.line.pieces[-2])]
        sides = [reference_state(law, velocity=s.u, density=s.rho, energy=s.e) for law, s in zip(laws, outer)]
        exact = riemann.riemann(laws[0], sides[0], laws[1], sides[1])
        wanted = np.array([middle + speed * solver.time for _, speed in exact.jumps])
        found = np.array([f.at(solver.time) for f in solver.line.fronts if f.kind != "end"])[-len(wanted):]
        stars = [p.state for p in solver.line.pieces if p.kind == "state"][1:-1][-2:]
        states = [off((s.rho, s.sigma), (side.behind.density, exact.pressure)) for s, side in zip(stars, (exact.left, exact.right))]
        return {"fronts": float(np.abs(found - wanted).max()) / solver.length, "states": max(states)}
    return TrackedProblem(name, words, cut, measure, _goals(**EXACT))


# -- meetings of shocks in a gas -------------------------------------------------------------------------------------------
def behind(mach: float, ahead=(1.0, 0.0, 1.0), gamma: float = 1.4) -> tuple[float, float, float]:
    """(density, velocity, pressure) behind a shock that runs to the right into `ahead`."""
    rho, u, p = ahead
    m2, c = mach * mach, math.sqrt(gamma * p / rho)
    return (rho * (gamma + 1.0) * m2 / ((gamma - 1.0) * m2 + 2.0), u + 2.0 * c / (gamma + 1.0) * (mach - 1.0 / mach),
            p * (2.0 * gamma * m2 - gamma + 1.0) / (gamma + 1.0))


REST, M2, M3 = (1.0, 0.0, 1.0), behind(2.0), behind(3.0)


def _meeting(name: str, words: str, states, edges, stop: float, expected, right=FIXED) -> TrackedProblem:
    """states: (gamma, state) of touching regions; expected: (pressure, velocity) between, densities there, speeds of what leaves."""
    (pressure, velocity), densities, speeds = expected

    def build(zones):
        laws = {f"gamma {gamma:.6g}": Material(f"gamma {gamma:.6g}", IdealGas(gamma)) for gamma, _ in states}
        regions = tuple(Region(f"r{k}", f"gamma {gamma:.6g}", edges[k], edges[k + 1], zones, velocity=u, density=rho, pressure=p)
                        for k, (gamma, (rho, u, p)) in enumerate(states))
        return Problem(name, "planar", stop, regions, laws, OPEN, right, bonded(regions))

    def measure(solver):
        between = [p.state for p in solver.line.pieces if p.kind == "state" and abs(p.state.sigma / pressure - 1.0) < 1e-6]
        rows = [off(s.sigma, pressure) for s in between] + [off(s.u, velocity) for s in between if velocity]
        found = {round(math.log(s.rho), 9): s.rho for s in between}
        leaving = [f.speed for f in solver.line.fronts if f.kind == "shock" or f.kind.startswith("fan")]
        return {"states": max([*rows, off(sorted(found.values()), sorted(densities))], default=math.inf), "speeds": off(leaving, speeds)}
    return TrackedProblem(name, words, build, measure, _goals(states=1e-9, speeds=1e-8))


MEETINGS = (
    _meeting("shock_on_light_gas", "A Mach 3 shock meets a gas a seventh as dense, of gamma 5/3",
             ((1.4, M3), (1.4, REST), (5.0 / 3.0, (0.138, 0.0, 1.0))), (-10.0, -1.0, 0.0, 10.0), 0.35,
             ((4.4683129553, 3.7223396208), (2.1193200225, 0.3075593409), (0.6927177439, 2.0042827378, 6.7518563955))),
    _meeting("shock_on_heavy_gas", "A Mach 3 shock meets a gas five times as dense",
             ((1.4, M3), (1.4, REST), (1.4, (5.0, 0.0, 1.0))), (-10.0, -1.0, 0.0, 10.0), 0.6,
             ((19.5110336429, 1.7036009514), (6.0286096888, 23.1402230717), (0.0591738923, 2.1731654503))),
    _meeting("shock_on_wall", "A Mach 3 shock meets a wall", ((1.4, M3), (1.4, REST)), (-10.0, -1.0, 0.0), 0.5,
             ((51.6666666667, 0.0), (10.8701298701,), (-1.4461528359,))),
    _meeting("shock_overtakes_shock", "A Mach 2 shock overtakes another",
             ((1.4, behind(2.0, M2)), (1.4, M2), (1.4, REST)), (-20.0, -1.0, 0.0, 20.0), 0.5,
             ((17.6166157505, 3.5970459969), (6.4375610458, 4.5179925706), (1.4036462876, 1.6397136266, 4.6195171718))),
    _meeting("shocks_head_on", "Shocks of Mach 2 and Mach 3 head on",
             ((1.4, M2), (1.4, REST), (1.4, (M3[0], -M3[1], M3[2]))), (-20.0, -1.0, 1.0, 20.0), 0.5,
             ((29.2706278212, -1.0482529501), (8.5360704818, 7.8586410341), (-2.1964776422, 0.4758236353)), OPEN),
)


# -- pistons, layers, strength ---------------------------------------------------------------------------------------------
def _to_and_fro(zones: int) -> Problem:
    region = Region("gas", "gas", 0.0, 1.0, zones, density=1.0, energy=0.0)
    return Problem("to and fro", "planar", 0.93, (region,), {"gas": Material("gas", IdealGas(5.0 / 3.0))},
                   Boundary("velocity", Pulse("constant", 1.0)), FIXED)


def _reflections(solver) -> dict[str, float]:
    _, kinds, rows = solver.front_table()
    ends = [row[2:4] for kind, row in zip(kinds, rows) if kind == "shock"][:2]
    last = max((p.state for p in solver.line.pieces if p.kind == "state"), key=lambda s: s.sigma)
    return {"fronts": off([*ends[0], *ends[1], solver.line.next_meeting()[0]], (0.75, 1.0, 0.9, 0.9, 0.95)),
            "states": off((last.rho, last.sigma), (20.0, 28.0))}


ALUMINIUM = MieGruneisen(rho0=2785.0, c0=5328.0, s=1.338, gamma0=2.0)
HELD = 2e-7      # s


def _pushed(zones: int) -> Problem:
    piston = Boundary("velocity", Pulse("square", 950.0, 0.0, HELD))
    return Problem("overtaken", "planar", 6e-6, (Region("target", "al", 0.0, 0.05, zones),), {"al": Material("al", ALUMINIUM)}, piston)


def _overtaken(solver) -> dict[str, float]:
    """The release head meets the shock at t = c T / (u + c - Us): where the first line of the shock ends."""
    _, kinds, rows = solver.front_table()
    begin, _, time, place, us = next(row[:5] for kind, row in zip(kinds, rows) if kind == "shock")
    head = next(row[4] for kind, row in zip(kinds, rows) if kind.startswith("fan head"))
    c = head - 950.0
    exact = c * HELD / (head - us)
    return {"speeds": off(us, 5328.0 + 1.338 * 950.0), "fronts": off((time - begin, place), (exact, us * exact))}


def _struck(zones: int) -> Problem:
    metal = Material("al", ALUMINIUM, PerfectlyPlastic(27.6e9, 0.3e9))
    regions = (Region("flyer", "al", 0.0, 0.01, zones, velocity=800.0), Region("target", "al", 0.01, 0.03, zones))
    return Problem("elastic flyer", "planar", 1.0e-6, regions, {"al": metal}, Boundary("free"), Boundary("free"))


def _two_waves(solver) -> dict[str, float]:
    exact = elastic_plastic_piston(Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 0.3e9), 400.0).numbers
    speeds = [f.speed for f in solver.line.fronts if f.direction > 0]
    plateau = next(p.state for p in solver.line.pieces if p.region == 1 and p.kind == "state")
    return {"speeds": off(speeds, (exact["plastic_wave_speed"], exact["elastic_wave_speed"])),
            "states": off((plateau.sigma, plateau.u), (exact["plastic_stress"], 400.0))}


COPPER, PMMA = MieGruneisen(8930.0, 3940.0, 1.489, 1.99), MieGruneisen(1186.0, 2598.0, 1.516, 0.97)
TUNGSTEN = MieGruneisen(19224.0, 4029.0, 1.237, 1.54)
STEPS = 6      # states of the ring-up, before a fan is met


def _layered(zones: int) -> Problem:
    metals = {"cu": Material("cu", COPPER), "pmma": Material("pmma", PMMA), "w": Material("w", TUNGSTEN)}
    regions = (Region("flyer", "cu", -0.05, 0.0, zones, velocity=555.0), Region("layer", "pmma", 0.0, 0.002, zones),
               Region("anvil", "w", 0.002, 0.1, zones))
    return Problem("ring-up", "planar", 3.2e-6, regions, metals, Boundary("free"), Boundary("free"))


def _ring_up(solver) -> dict[str, float]:
    """Every state of the layer, as impedances match one after the other, stands behind a front of the record."""
    left, layer, right = reference_state(COPPER, velocity=555.0), reference_state(PMMA), reference_state(TUNGSTEN)
    columns, kinds, rows = solver.front_table()
    at = [columns.index(f"{name}_{side}") for side in ("left", "right") for name in ("stress", "velocity")]
    seen = np.array([row[at] for kind, row in zip(kinds, rows) if kind == "shock"]).reshape(-1, 2)
    worst = 0.0
    for k in range(STEPS):
        found = riemann.riemann(COPPER, left, PMMA, layer) if k % 2 == 0 else riemann.riemann(PMMA, layer, TUNGSTEN, right)
        worst = max(worst, float(np.abs(seen / (found.pressure, found.velocity) - 1.0).max(axis=1).min()))
        if k % 2 == 0:
            left, layer = found.left.behind, found.right.behind
        else:
            layer, right = found.left.behind, found.right.behind
    return {"states": worst}


# -- cells -----------------------------------------------------------------------------------------------------------------
def _contacts(solver) -> dict[str, float]:
    found = [float(x) for f, x in zip(solver.mesh.fronts, solver.mesh.x[solver.mesh.faces()]) if f.kind == "interface"]
    return {"contacts": float(np.abs(np.array(found) - (0.59389, 0.79811)).max()) if len(found) == 2 else math.inf}


WAVE = Wave(1.2, 50.0, 20.0, 1.6)      # of a low activation energy: no mode grows
DEEP = 3.0                             # half-reaction lengths behind the front


def _steady_zone() -> tuple[np.ndarray, ...]:
    """(time since the shock, distance behind it, velocity in the laboratory, pressure) of the steady zone."""
    s = np.concatenate([[0.0], np.geomspace(1e-3, 24.0, 4000)])
    rho, u, p = np.array([WAVE.state(-math.expm1(-a)) for a in s]).T
    per_s = 1.0 / (WAVE.rate_constant * np.exp(-WAVE.activation * rho / p))
    time, distance = (np.concatenate([[0.0], np.cumsum(0.5 * (f[1:] + f[:-1]) * np.diff(s))]) for f in (per_s, -u * per_s))
    return time, distance, WAVE.velocity + u, p


def _overdriven(zones: int) -> Problem:
    """A piston that moves as the material behind the steady front; `zones` in a half-reaction length."""
    time, _, u, _ = _steady_zone()
    fuel = IdealGas(1.2, 5.0, 1.0)
    material = Material("gas", fuel, burn=Arrhenius(WAVE.rate_constant, WAVE.activation), unreacted=fuel, mixture="weighted_pressures",
                        detonation_energy=WAVE.heat)
    length, early = WAVE.velocity + 2.0, time < 2.0
    pulse = Pulse("table", times=tuple(time[early][::4].tolist()), values=tuple(u[early][::4].tolist()))
    region = Region("gas", "gas", 0.0, length, round(zones * length), density=1.0, pressure=1.0)
    return Problem("overdriven", "planar", 1.0, (region,), {"gas": material}, Boundary("velocity", pulse), FIXED)


def _zone_errors(solver) -> dict[str, float]:
    _, distance, _, p = _steady_zone()
    mesh = solver.mesh
    front = float(mesh.x[mesh.faces()[1]])
    behind_it = front - mesh.middle
    inside = (behind_it > 0.0) & (behind_it < DEEP)
    gap = solver.flow.look(mesh)[tables.P, :len(inside)][inside] - np.interp(behind_it[inside], distance, p)
    return {"front_position": abs(front / WAVE.velocity - 1.0), "pressure_l1": float(np.abs(gap).mean() / p[0])}


TRACKED: dict[str, TrackedProblem] = {problem.name: problem for problem in (
    _tube("tracked_sod", "Sod's tube: every wave exact", gases.build_sod, 0.5),
    _tube("tracked_leblanc", "LeBlanc's tube: every wave exact", gases.build_leblanc, 3.0),
    _tube("tracked_two_rarefactions", "Receding streams (123): every wave exact", gases.build_two_rarefactions, 0.5),
    _tube("tracked_collision", "Colliding streams: every wave exact", gases.build_collision, 0.5),
    _tube("tracked_water_gas", "Liquid against a gas, before a wave reaches a wall: every wave exact", gases.build_water_gas, 0.7, 1.1e-4),
    *MEETINGS,
    TrackedProblem("shock_to_and_fro", "A piston's shock reflected between piston and wall at t = 0.75, 0.90, 0.95", _to_and_fro,
                   _reflections, _goals(fronts=1e-12, states=1e-12)),
    TrackedProblem("release_overtakes_shock", "A piston that stops: its release overtakes the shock", _pushed, _overtaken,
                   _goals(speeds=1e-12, fronts=1e-9)),
    TrackedProblem("elastic_flyer", "Impact at 800 m/s of aluminium with strength: precursor and plastic shock", _struck, _two_waves,
                   _goals(speeds=1e-9, states=1e-9)),
    TrackedProblem("ring_up", "A copper flyer rings PMMA up against tungsten: six states by impedance matching", _layered, _ring_up,
                   _goals(states=1e-9)),
    TrackedProblem("blast_contacts", "Interacting blast waves: contacts at 0.59389 and 0.79811", gases.build_woodward_colella,
                   _contacts, tuple(Bar("contacts", n, goal=1e-3) for n in (100, 400)), (100, 400), "cells"),
    TrackedProblem("reaction_zone", "Steady zone of a detonation driven by a piston, overdrive (D/D_CJ)^2 = 1.6, activation energy 20; "
                   "zones per half-reaction length",
                   _overdriven, _zone_errors, (Bar("front_position", 20, goal=1e-5), Bar("pressure_l1", 20, goal=1e-4)), (5, 10, 20),
                   "cells"),
)}
