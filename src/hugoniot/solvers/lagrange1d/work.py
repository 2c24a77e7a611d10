"""What a march works on, and the lists of passes over a run of zones, each compiled once and entered by its address.

Nothing here knows a law or a geometry: which passes a material takes stands in its recipe, which passes a geometry takes in `Steps`.
"""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.passes import Entry, record, row, rows
from hugoniot.core.target import INLINE
from hugoniot.solvers.lagrange1d import compatible, leapfrog, nodes, stress
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.compatible import correct, predict
from hugoniot.solvers.lagrange1d.layout import ChargeRows, NodeRows, WorkRows, ZoneRows
from hugoniot.solvers.lagrange1d.leapfrog import advance
from hugoniot.zones.constants import Constants
from hugoniot.zones.recipe import Recipe
from hugoniot.zones.soundness import FOUND_FLOATS

CONSTANTS = len(Constants._fields)


class Piece(NamedTuple):
    """Rows of one piece: zones, charge, its nodes (one more than zones), velocity gradients (from the left neighbour's), scratch."""

    z: Any
    b: Any
    h: Any
    g: Any
    w: Any


class Steps(NamedTuple):
    """Addresses of the passes of a geometry and an integrator (0: not used)."""

    trial: int = 0
    back: int = 0
    rate: int = 0
    accelerate: int = 0
    half_motion: int = 0
    half_stress: int = 0
    half_heat: int = 0
    move: int = 0
    end_motion: int = 0
    end_stress: int = 0
    heat_flux: int = 0
    leap: int = 0
    whole_motion: int = 0
    energy_target: int = 0
    energy_before: int = 0
    end_stress_at_once: int = 0
    look_around: int = 0
    damp: int = 0
    take_relief: int = 0
    mean: int = 0
    after_work: int = 0
    newton_step: int = 0
    curved: int = 0              # 1 where there is hoop strain
    predict: int = 0             # the lists of passes over a run of zones
    correct: int = 0
    advance: int = 0


def steps_of(staggered: bool, geometry, recipes) -> Steps:
    """The passes a problem needs, given its recipes; compiles what is not on disk yet."""
    def any_has(name):
        return any(getattr(recipe, name) for recipe in recipes)

    of_geometry, of_none = {}, {}
    if any_has("shear"):
        of_geometry |= {"trial": stress.trial_pass, "back": stress.return_pass}
    if any_has("needs_rate"):
        of_none["rate"] = stress.rate_pass
    if staggered:
        of_geometry |= {"leap": nodes.leap, "whole_motion": leapfrog.whole_motion}
        if not all(recipe.instant for recipe in recipes):
            of_geometry |= {"energy_target": leapfrog.energy_target, "end_stress": leapfrog.end_stress}
        if any_has("instant"):
            of_geometry |= {"energy_before": leapfrog.energy_before, "end_stress_at_once": leapfrog.end_stress_at_once}
        if any_has("relief"):
            of_none["take_relief"] = leapfrog.take_relief
        if any_has("bare"):
            of_none |= {"look_around": leapfrog.look_around, "damp": leapfrog.damp}
        if any_has("solve"):
            of_none |= {"mean": leapfrog.mean, "after_work": leapfrog.after_work, "newton_step": leapfrog.newton_step}
    else:
        of_geometry |= {"accelerate": nodes.accelerate, "move": nodes.move, "half_motion": compatible.half_motion,
                        "half_stress": compatible.half_stress, "end_motion": compatible.end_motion, "end_stress": compatible.end_stress,
                        "heat_flux": compatible.heat_flux}
        if any_has("solve"):
            of_none["half_heat"] = compatible.half_heat
    return Steps(curved=int(geometry.dimension > 1.0), **{name: each.address(geometry) for name, each in of_geometry.items()},
                 **{name: each.address() for name, each in of_none.items()})


class Arrays(NamedTuple):
    """What a march works on: the tables of `layout`, and where the pieces of work are.

    recipes, constants   (n, fields) of `zones.recipe`
    work                 (threads * fields of WorkRows, zones of a piece)
    runs                 pieces of zones of one material: columns RUN_... of `layout`
    spans                pieces of inner nodes: (first zone, last zone, segment)
    ranges               zones between which artificial heat flows: (first, last, segment, whether they burn)
    found                a row for each run, and the totals of a step behind them
    steps                (1, fields of Steps)
    flux                 numbers of the heat flux
    dts                  (dt, mean of the last two)
    """

    zones: Any
    charge: Any
    nodes: Any
    gradient: Any
    work: Any
    steps: Any
    recipes: Any
    constants: Any
    flux: Any
    runs: Any
    spans: Any
    ranges: Any
    found: Any
    dts: Any
    control: Any
    counters: Any
    segments: Any
    interfaces: Any


# -- pieces of zones -----------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def piece_at(a, first, segment, member):
    """The rows of the piece that begins at zone `first`, with the scratch of one member of the team."""
    return Piece(rows(ZoneRows, a.zones, first), rows(ChargeRows, a.charge, first), rows(NodeRows, a.nodes, first + segment),
                 row(a.gradient, first + 2 * segment), rows(WorkRows, a.work, member * L.PIECE))


@nb.njit(**INLINE)
def fresh(a, i):
    """The row that takes what passes find in run i, cleared."""
    found = row(a.found, i * FOUND_FLOATS)
    for k in range(FOUND_FLOATS):
        found[k] = 0.0
    return found


def predict_run(a, i, member):
    """Stress of run i in the middle of the step."""
    segment, first, end = a.runs[i, L.RUN_SEGMENT], a.runs[i, L.RUN_FIRST], a.runs[i, L.RUN_LAST]
    steps, recipe = record(Steps, a.steps, 0), record(Recipe, a.recipes, a.runs[i, L.RUN_MATERIAL])
    constants = row(a.constants, a.runs[i, L.RUN_MATERIAL] * CONSTANTS)
    while first < end:
        count = min(end - first, L.PIECE)
        predict(count, piece_at(a, first, segment, member), steps, recipe, constants, a.dts[0])
        first += count


def correct_run(a, i, member):
    """State of run i at the end of the step."""
    segment, first, end = a.runs[i, L.RUN_SEGMENT], a.runs[i, L.RUN_FIRST], a.runs[i, L.RUN_LAST]
    steps, recipe = record(Steps, a.steps, 0), record(Recipe, a.recipes, a.runs[i, L.RUN_MATERIAL])
    constants, found = row(a.constants, a.runs[i, L.RUN_MATERIAL] * CONSTANTS), fresh(a, i)
    while first < end:
        count = min(end - first, L.PIECE)
        correct(count, piece_at(a, first, segment, member), steps, recipe, constants, found, a.dts[0])
        first += count


def advance_run(a, i, member):
    """State of run i at n+1 of the leapfrog."""
    segment, first, end = a.runs[i, L.RUN_SEGMENT], a.runs[i, L.RUN_FIRST], a.runs[i, L.RUN_LAST]
    steps, recipe = record(Steps, a.steps, 0), record(Recipe, a.recipes, a.runs[i, L.RUN_MATERIAL])
    constants, found = row(a.constants, a.runs[i, L.RUN_MATERIAL] * CONSTANTS), fresh(a, i)
    while first < end:
        count = min(end - first, L.PIECE)
        advance(count, piece_at(a, first, segment, member), steps, recipe, constants, found, a.dts[0])
        first += count


PREDICT_RUN, CORRECT_RUN, ADVANCE_RUN = Entry(predict_run), Entry(correct_run), Entry(advance_run)


def enter(arrays: Arrays, steps: Steps, staggered: bool) -> Steps:
    """The same with the addresses of the lists of passes that a march of these arrays enters."""
    if staggered:
        return steps._replace(advance=ADVANCE_RUN.address(arrays, 0, 0))
    return steps._replace(predict=PREDICT_RUN.address(arrays, 0, 0), correct=CORRECT_RUN.address(arrays, 0, 0))
