"""Explosives: Kenamond's burn times, and the cylinder test of Composition B against the streak camera's record."""

from functools import partial

import numpy as np

from hugoniot.campaign.plane.parts import Bar, PlaneProblem
from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.problem.catalogue import TEMPLATES
from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.solvers.lagrange2d.accounts import B
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.theory.exact.kenamond import nested, obstacle, single

FAST, SLOW = 2000.0, 1000.0        # detonation velocities, m/s
BALL, OUTER = 3.0, 10.0            # radii of what stands in the middle and of the explosive, m
MIDDLE = 1e-6                      # of the hole that stands for the centre of a ball
HALF = [-90, 90]                   # degrees: all angles at r > 0
# (place, time) of five detonators in one explosive; of four about a ball that burns from its centre
SEVERAL = (((0.0, 0.0), 0.0), ((6.0, 2.0), 0.5e-3), ((4.0, 7.0), 1e-3), ((9.0, 9.0), 0.2e-3), ((0.5, 8.0), 2.5e-3))
ABOUT = (((0.0, 5.0), 2e-3), ((0.0, -5.0), 2e-3), ((4.0, 4.0), 2.5e-3), ((4.0, -4.0), 3e-3))
MEASURED = {6e-3: 1386.0, 19e-3: 1631.0}     # m/s after so many m of travel: E = 0.960 and 1.330 kJ per gram of copper
RING = 1.4e-3                      # m: travel while a wave runs through the wall and back, over which its speed is a mean


# -- Kenamond -----------------------------------------------------------------------------------------------------------------
def lit(geometry, blocks, detonators, asked):
    """A solver for blocks (name, detonation velocity, lines of the deck) lit at (place, time)."""
    text = f'geometry = "{geometry}"\nstop_time = "1 s"\n'
    for name, speed, lines in blocks:
        text += f'[[block]]\nname = "{name}"\nmaterial = "{name}"\n{lines}\n'
        text += f'[material.{name}]\nbase = "comp_b"\nburn = {{law = "programmed", detonation_velocity = {speed}}}\n'
    text += "".join(f"[[lighting]]\nat = {list(place)}\ntime = {time}\n" for place, time in detonators)
    return Lagrange2D(read_deck_text(text + '[solver]\nkind = "lagrange2d"\n', overrides=given(asked)).problem)


def given(asked) -> dict:
    """Options of a solver as keys of a deck."""
    return {f"solver.{name}": value for name, value in asked.items()}


def part(radii, zones):
    """A half ring."""
    return f'shape = "sector"\nradius = {list(radii)}\nangle = ["{HALF[0]} deg", "{HALF[1]} deg"]\nzones = {list(zones)}'


def one_explosive(n, asked):
    """A square of 10 m with several detonators, divided in two blocks."""
    halves = [("left", FAST, f"x = [0, 5]\ny = [0, 10]\nzones = [{n // 2}, {n}]"),
              ("right", FAST, f"x = [5, 10]\ny = [0, 10]\nzones = [{n // 2}, {n}]")]
    return lit("plane", halves, SEVERAL, asked)


def two_explosives(n, asked):
    """A fast explosive in a slow one; the plane x = 0 is one of symmetry."""
    blocks = [("fast", FAST, part((MIDDLE, BALL), (n, n))), ("slow", SLOW, part((BALL, OUTER), (n, n)))]
    return lit("plane", blocks, (((MIDDLE, 0.0), 0.0), *ABOUT), asked)


def around(n, asked):
    """A ball of no explosive in an explosive that is lit on the axis."""
    return lit("axisymmetric", [("ring", FAST, part((BALL, OUTER), (n, n)))], (((0.0, 5.0), 0.0),), asked)


def late(exact, solver):
    """Largest error of the time at which the front reaches a zone, over the time the front takes to the farthest one."""
    mesh = solver.problem.mesh
    wanted = exact(mesh.nodes.T * (1.0 + 1e-13))[mesh.zone_nodes].min(axis=1)
    return {"lighting_time": float(np.max(np.abs(-solver.charge[B.since] - wanted)) / wanted.max())}


def with_detonators(function, detonators, **more):
    places, times = zip(*detonators)
    return partial(function, detonators=places, times=times, **more)


# -- the cylinder test --------------------------------------------------------------------------------------------------------
def cylinder(n, asked):
    """The deck of `hugoniot init cylinder-test` with n zones across the charge, and others of the same shape."""
    along, across = round(17.5 * n), max(round(3 * n / 8), 1)
    zones = {"block.charge.zones": [n, along], "block.wall.zones": [across, along]}
    problem = read_deck(TEMPLATES / "cylinder-test.toml", {**zones, **given(asked)}).problem
    return Lagrange2D(problem, Sampler(problem))


def streak(solver):
    """How far the speeds of the streak record are from the measured ones."""
    times, rows = solver.take_gauges()
    travel = rows["line_position"][:, 0] - rows["line_position"][0, 0]
    found = {}
    for place, speed in MEASURED.items():
        begin, end = np.interp([place - 0.5 * RING, place + 0.5 * RING], travel, times)
        found[f"speed_{place * 1e3:.0f}mm"] = float(abs(RING / (end - begin) / speed - 1.0))
    return found


PROBLEMS = (
    PlaneProblem("kenamond_1", "burn times from five detonators in one explosive", one_explosive, 0.0,
                 partial(late, with_detonators(single, SEVERAL, detonation_velocity=FAST)),
                 (Bar("lighting_time", 20, goal=1e-12), Bar("lighting_time", 100, goal=1e-12)), (20, 100)),
    PlaneProblem("kenamond_2", "burn times of a fast explosive inside a slow one, five detonators", two_explosives, 0.0,
                 partial(late, with_detonators(nested, ABOUT, radius=BALL, inner_velocity=FAST, outer_velocity=SLOW)),
                 (Bar("lighting_time", 20, goal=0.01), Bar("lighting_time", 100, goal=0.01)), (20, 100)),
    PlaneProblem("kenamond_3", "burn times around an inert ball", around, 0.0,
                 partial(late, partial(obstacle, detonation_velocity=FAST, radius=BALL, detonator=(0.0, 5.0))),
                 (Bar("lighting_time", 20, goal=0.01), Bar("lighting_time", 100, goal=0.01)), (20, 100)),
    PlaneProblem("cylinder_comp_b", "cylinder test of Composition B, 25.4 mm, evaluated from the streak record",
                 cylinder, 28.5e-6, streak,
                 (*(Bar(f"speed_{mm}mm", n, goal=0.02) for mm in (6, 19) for n in (8, 12)),), (8, 12)),
)
