"""Bodies that turn or strike: a stressed square, a disc on a target, plates that meet at an angle."""

from dataclasses import replace

import numpy as np
from scipy.optimize import brentq

from hugoniot.campaign.plane.parts import Bar, N, PlaneProblem, Z, box, centres, solver_of, walls
from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.theory.isentrope import state
from hugoniot.theory.shock_polar import Stream

ALUMINIUM = Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0), PerfectlyPlastic(24.8e9, 0.30e9))

# -- the spinning square ------------------------------------------------------------------------------------------------------
TURN = 0.01                                # s
STRESS = np.array([1.0, -0.4, 0.2])        # xx, yy, xy, Pa: next to nothing beside the tension
ROWS = [Z.sxx, Z.syy, Z.sxy]
SOFT = replace(ALUMINIUM, strength=PerfectlyPlastic(1e-3, 0.30e9))      # so that what shape the square takes leaves the stress alone


def square(steps, asked):
    """A free square zone whose tension holds its four nodes on their circles, under a small stress besides; so many steps a turn.

    A node, a quarter of the mass at half the diagonal, is pulled by half the tension along two edges: tension = density (spin side)^2 / 4;
    in steps of the angle a, in whose middle the sides are longer by 1 / cos(a/2), tension = density (sin(a/2) side / step)^2 there.
    """
    half, step, law = np.pi / steps, TURN / steps, ALUMINIUM.eos
    spin, less = 2.0 * np.tan(half) / step, np.cos(half) ** 2

    def lacking(density):
        energy = pressure(density, 0.0, law) * (1.0 - 1.0 / less) / density      # in the middle, where the square is larger
        return pressure(density * less, energy, law) + density * (np.sin(half) / step) ** 2

    density = brentq(lacking, 0.9 * law.rho0, law.rho0 / less, xtol=1e-12 * law.rho0)
    block = box((1, 1), (-0.5, 0.5), (-0.5, 0.5), material="al", density=density, energy=0.0, velocity=VelocityField(rotation=spin))
    options = {"initial_step": TURN / steps, "largest_step": TURN / steps, "courant": 1e6, **asked}
    solver = solver_of("spinning square", "plane", TURN, block, [SOFT], (), options)
    solver.zones[ROWS] = STRESS[:, None]
    solver.begin()
    return solver


def turned(solver):
    """Change of the size of the stress over one turn, and the angle it is off the square's own, rad."""
    (x1, _, _, x2), (y1, _, _, y2) = solver.nodes[[N.x, N.y]]
    body = np.arctan2(y2 - y1, x2 - x1) - 0.25 * np.pi
    xx, yy, xy = solver.zones[ROWS]
    half, shear, before = 0.5 * (xx - yy), xy, (0.5 * (STRESS[0] - STRESS[1]), STRESS[2])
    size, angle = np.hypot(half, shear), 0.5 * np.arctan2(shear * before[0] - half * before[1], half * before[0] + shear * before[1])
    return {"stress_drift": float(np.max(np.abs(size / np.hypot(*before) - 1.0))), "angle_error": float(np.abs(angle - body).max())}


# -- a disc on a target -------------------------------------------------------------------------------------------------------
RADIUS, THICK, DEEP, SPEED = 10e-3, 3e-3, 6e-3, 700.0
RISEN, PLATEAU = 0.2e-6, 0.5e-6            # s: the shock is there on every mesh; the face that is struck is at rest
FALL = 0.02                                # of the plateau: the release from the edge has come
QUIET = 0.8                                # of the time in which it reaches the axis: its foot has not


def lateral_speed(c, rho):
    """Speed at which the release from the edge enters a plane shock, c its longitudinal sound speed.

    Behind the shock the deviators are at yield, in proportion -2 : 1 : 1. Extending the material sideways loads it further: the return to
    the yield surface takes 2 G n_r^2 = G/3 off the modulus K + 4 G/3, n being the unit tensor along the deviators.
    """
    return np.sqrt(c * c - ALUMINIUM.strength.shear_modulus / (3.0 * rho))


def plates(columns, rows, asked):
    """Flyer and target with so many rows of zones in the flyer's thickness: a disc or, of one column, a strip of plates without edges."""
    geometry, radius = ("axisymmetric", RADIUS) if columns > 1 else ("plane", RADIUS / rows)
    deep = round(rows * DEEP / THICK)
    blocks = [box((columns, rows), (0.0, radius), (-THICK, 0.0), "flyer", "al", velocity=VelocityField(base=(0.0, SPEED))),
              box((columns, deep), (0.0, radius), (0.0, DEEP), "target", "al")]
    sides = () if columns > 1 else walls("flyer.left", "flyer.right", "target.left", "target.right")
    step = 0.2 * THICK / rows / 8000.0     # both take the same steps

    def read(state):
        p, c, rho = (state.zones[name][columns * rows:].reshape(columns, deep) for name in ("pressure", "sound_speed", "density"))
        return {"axis": p[0].copy(), "face": p[:, 0].copy(), "speed": lateral_speed(c[:, 0], rho[:, 0])}

    options = {"initial_step": step, "largest_step": step, **asked}
    return solver_of("disc on target", geometry, 1.4e-6, blocks, [ALUMINIUM], sides, options, sampler=read, interval=5e-9)


def disc(n, asked):
    """n rows of square zones in the thickness of the flyer."""
    return plates(round(n * RADIUS / THICK), n, asked)


def released(solver):
    """How far the pressure on the axis is from that between plates without edges, over the plateau, until the release from the edge comes
    near; and how far the arrival of that release half-way in is from the time at its speed there (`lateral_speed`)."""
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


# -- an oblique impact --------------------------------------------------------------------------------------------------------
LEAN, FLIGHT = np.radians(6.0), 2000.0     # at 10.3 degrees the shock detaches
LONG, THIN, POINT = 32e-3, 4e-3, 20e-3     # m: of a plate; where the point of impact is in the end
FLUID = MieGruneisen(2700.0, 5200.0, 1.5, 2.0)


def leaning(way, name, zones):
    """A plate that leans on y = 0 and flies toward it, from above (way 1) or from below (-1)."""
    along, across = np.array([np.cos(LEAN), way * np.sin(LEAN)]), np.array([-np.sin(LEAN), way * np.cos(LEAN)])
    a = np.array([0.0, way * 1e-6])
    b, c, d = a + LONG * along, a + LONG * along + THIN * across, a + THIN * across
    low, high = ((a, b), (d, c)) if way > 0 else ((d, c), (a, b))

    def line(ends):
        return Curve("line", tuple((float(x), float(y)) for x, y in ends))

    shape = Edges(line((low[0], high[0])), line((low[1], high[1])), line(low), line(high))
    return Block2D(name, "al", shape, zones, velocity=VelocityField(base=(0.0, -FLIGHT * way)))


def plates_that_meet(n, asked):
    """Two plates of n zones across."""
    plates = [leaning(way, name, (8 * n, n)) for way, name in ((1.0, "above"), (-1.0, "below"))]
    return solver_of("oblique impact", "plane", MEETING, plates, [Material("al", FLUID)], (), asked)


def shocked():
    """(pressure, angle to the plane of symmetry) of the shock that runs with the point of impact: Courant and Friedrichs' polar."""
    stream = Stream(FLUID, state(FLUID, pressure=0.0, density=2700.0), FLIGHT / np.sin(LEAN))
    p = brentq(lambda p: stream.deflection(p) - LEAN, 1e9, stream.detachment[0])
    return p, stream.shock_angle(p) - LEAN


def behind(solver):
    """Pressure on the plane of symmetry behind the shock and the angle of the shock in degrees, beside the polar's."""
    pressure, angle = shocked()
    x, y = centres(solver)
    p, y = solver.zones[Z.p], np.abs(y)
    inside = (y < 0.5e-3) & (x > POINT - 8e-3) & (x < POINT - 3e-3)
    shape = (2, *solver.problem.blocks[0].zones)
    front = [place for part in zip(x.reshape(shape), y.reshape(shape), p.reshape(shape)) for place in crossings(*part, 0.5 * pressure)]
    along, across = np.array([place for place in front if 0.6e-3 < place[1] < 1.6e-3]).T
    found = np.arctan(-1.0 / np.polyfit(across, along, 1)[0])
    return {"pressure": float(abs(p[inside].mean() / pressure - 1.0)), "shock_angle": float(np.degrees(abs(found - angle))),
            "contact_depth": solver.results()["contact_depth"]}


def crossings(x, y, p, level):
    """(x, y) where the pressure last falls through a level along every row of zones (second index): the zones of one row have one distance
    to the surface that strikes, so that none of its points depends on which rows a line through the front happens to meet."""
    found = []
    for row in np.flatnonzero((p > level).any(axis=0)):
        k = np.flatnonzero(p[:, row] > level)[-1]
        part = (p[k, row] - level) / (p[k, row] - p[k + 1, row])
        found.append((x[k, row] + part * (x[k + 1, row] - x[k, row]), y[k, row] + part * (y[k + 1, row] - y[k, row])))
    return found


MEETING = POINT * np.tan(LEAN) / FLIGHT
PROBLEMS = (
    PlaneProblem("spinning_square", "a free square under stress turns through one revolution in n steps", square, TURN, turned,
                 (*(Bar(measure, n, goal=goal) for measure, goal in (("stress_drift", 1e-6), ("angle_error", 1e-5)) for n in (100, 400)),),
                 (100, 400)),
    PlaneProblem("disc_impact", "aluminium disc strikes aluminium at 700 m/s, until the release from its edge is near the axis",
                 disc, 1.4e-6, released,
                 (*(Bar(measure, n, goal=goal) for measure, goal in (("axis_pressure", 1e-3), ("release_arrival", 0.02))
                    for n in (16, 24)),), (16, 24)),
    PlaneProblem("oblique_impact", "oblique impact of two plates at 6 degrees to the plane of symmetry, 2 km/s, compared with the "
                 "shock polar", plates_that_meet, MEETING, behind,
                 (Bar("pressure", 20, goal=5e-3), Bar("shock_angle", 20, goal=0.2), Bar("contact_depth", 20, goal=1e-3)), (20,)),
)
