"""Bodies that turn or strike: the spinning stressed square, a disc on a target, an oblique impact."""

import numpy as np

from hugoniot.campaign.plane.parts import Bar, N, PlaneProblem, Z, box, solver_of, walls
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.plane.model import VelocityField

ALUMINIUM = Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0), PerfectlyPlastic(24.8e9, 0.30e9))

# -- the spinning square ------------------------------------------------------------------------------------------------------
TURN = 0.01                                # s
STRESS = 0.3 * 24.8e9 * 1e-3 * np.array([1.0, -0.4, 0.2])      # xx, yy, xy: elastic, Pa
ROWS = [Z.sxx, Z.syy, Z.sxy]


def square(steps, asked):
    """A unit square of 4 x 4 zones under a uniform stress that is carried through one turn in so many steps."""
    block = box((4, 4), (-0.5, 0.5), (-0.5, 0.5), material="al")
    options = {"initial_step": TURN / steps, "largest_step": TURN / steps, "courant": 1e6, **asked}
    solver = solver_of("spinning square", "plane", TURN, block, [ALUMINIUM], (), options)
    solver.zones[ROWS] = STRESS[:, None]
    solver.nodes[N.im] = 0.0               # no force turns the nodes from their way
    carry(solver)
    solver.begin()
    return solver


def carry(solver):
    """Velocities with which every node ends the step where the rotation takes it: along the chord."""
    steps = round(TURN / solver.problem.solver.largest_step)
    x, y = solver.nodes[N.x], solver.nodes[N.y]
    angle, dt = 2.0 * np.pi / steps, TURN / steps
    solver.nodes[N.u] = ((np.cos(angle) - 1.0) * x - np.sin(angle) * y) / dt
    solver.nodes[N.v] = (np.sin(angle) * x + (np.cos(angle) - 1.0) * y) / dt


def turned(solver):
    """Change of the size of the stress over one turn, and the angle it is off, rad."""
    xx, yy, xy = solver.zones[ROWS]
    half, shear, before = 0.5 * (xx - yy), xy, (0.5 * (STRESS[0] - STRESS[1]), STRESS[2])
    size, angle = np.hypot(half, shear), 0.5 * np.arctan2(shear * before[0] - half * before[1], half * before[0] + shear * before[1])
    return {"stress_drift": float(np.max(np.abs(size / np.hypot(*before) - 1.0))), "angle_error": float(np.abs(angle).max())}


# -- a disc on a target -------------------------------------------------------------------------------------------------------
RADIUS, THICK, DEEP, SPEED = 10e-3, 3e-3, 6e-3, 700.0
RISEN, PLATEAU = 0.2e-6, 0.5e-6            # s: the shock is there on every mesh; the face that is struck is at rest
FALL = 0.02                                # of the plateau: the release from the edge has come
QUIET = 0.8                                # of the time in which it reaches the axis: its foot has not


def plates(columns, rows, asked):
    """Flyer and target with so many rows of zones in the flyer's thickness: a disc or, of one column, a strip of plates without edges."""
    geometry, radius = ("axisymmetric", RADIUS) if columns > 1 else ("plane", RADIUS / rows)
    deep = round(rows * DEEP / THICK)
    blocks = [box((columns, rows), (0.0, radius), (-THICK, 0.0), "flyer", "al", velocity=VelocityField(base=(0.0, SPEED))),
              box((columns, deep), (0.0, radius), (0.0, DEEP), "target", "al")]
    sides = () if columns > 1 else walls("flyer.left", "flyer.right", "target.left", "target.right")
    step = 0.2 * THICK / rows / 8000.0     # both take the same steps

    def read(state):
        p, c = (state.zones[name][columns * rows:].reshape(columns, deep) for name in ("pressure", "sound_speed"))
        return {"axis": p[0].copy(), "face": p[:, 0].copy(), "speed": c[:, 0].copy()}

    options = {"initial_step": step, "largest_step": step, **asked}
    return solver_of("disc on target", geometry, 1.4e-6, blocks, [ALUMINIUM], sides, options, sampler=read, interval=5e-9)


def disc(n, asked):
    """n rows of square zones in the thickness of the flyer."""
    return plates(round(n * RADIUS / THICK), n, asked)


def released(solver):
    """How far the pressure on the axis is from that between plates without edges, over the plateau, until the release from the edge comes
    near; and how far the arrival of that release half-way in is from that of longitudinal sound behind the shock."""
    columns, rows = solver.problem.blocks[0].zones
    strip = plates(1, rows, {})
    while strip.time < solver.time:
        strip.march(solver.time, 10_000)
    times, found = solver.take_gauges()
    _, wanted = strip.take_gauges()
    at = int(np.searchsorted(times, PLATEAU))
    plateau, speed = wanted["face"][at, 0], wanted["speed"][at, 0]
    watched = (times > RISEN) & (times < QUIET * RADIUS / speed)
    place = columns // 2
    way = RADIUS * (1.0 - (place + 0.5) / columns)
    fallen = found["face"][:, place] < (1.0 - FALL) * wanted["face"][:, 0]
    arrival = times[np.flatnonzero(fallen & (times > RISEN))[0]]
    return {"axis_pressure": float(np.abs(found["axis"] - wanted["axis"])[watched].max() / plateau),
            "release_arrival": float(abs(arrival * speed / way - 1.0))}


PROBLEMS = (
    PlaneProblem("spinning_square", "a stressed square carried through one turn in so many steps", square, TURN, turned,
                 (*(Bar(measure, n, goal=goal) for measure, goal in (("stress_drift", 1e-6), ("angle_error", 1e-5)) for n in (100, 400)),),
                 (100, 400), carry),
    PlaneProblem("disc_impact", "aluminium disc on aluminium, 700 m/s, until the release from its edge is near the axis", disc, 1.4e-6,
                 released, (*(Bar(measure, n, goal=goal) for measure, goal in (("axis_pressure", 1e-3), ("release_arrival", 0.02))
                              for n in (16, 24)),), (16, 24)),
)
