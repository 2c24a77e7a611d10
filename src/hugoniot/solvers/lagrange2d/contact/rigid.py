"""Rigid bodies in a step: their motion and the positions of their vertices.

A rotating body moves as a whole: its centre with the mean velocity of the step, its vertices around the centre with
the mean rate of rotation, along chords. An impulse acts in the middle of the step, at the point of contact there, so that the angular
momentum lost by the material is gained by the body.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange1d.pulses import pulse_mean, pulse_value
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.contact import layout as C

X, U, UM = (L.Nodes._fields.index(name) for name in ("x", "u", "um"))      # rows of the node table


@nb.njit(**INLINE)
def place(c, p, t):
    """Where a point is at the start of a step (t = 0), at its end (1), or in its middle (0.5), where forces act."""
    at = c.places[p]
    if t == 0.5:
        return at[C.AT_X] + at[C.HALF_X], at[C.AT_Y] + at[C.HALF_Y]
    return at[C.AT_X] + t * at[C.BY_X], at[C.AT_Y] + t * at[C.BY_Y]


@nb.njit(**BY_ADDRESS)
def lead_on(c, dt):
    """How far the points concerned and the rigid bodies move in a step with the velocities of their movers."""
    for i in range(c.sizes[C.POINTS]):
        at, q, m = c.places[c.near_points[i, 0]], c.mover_numbers[c.near_points[i, 1]], c.near_points[i, 1]
        at[C.BY_X], at[C.BY_Y] = dt * q[C.U], dt * q[C.V]
        if q[C.W] != 0.0:
            x, y = chord(c.rigid[c.movers[m, C.MOVER_RIGID]], at[C.AT_X], at[C.AT_Y], dt * q[C.W])
            at[C.BY_X], at[C.BY_Y] = at[C.BY_X] + x, at[C.BY_Y] + y
    for r in range(c.rigid.shape[0]):
        at, q = c.places[c.points.shape[0] + r], c.mover_numbers[c.movers.shape[0] - c.rigid.shape[0] + r]
        at[C.AT_X], at[C.AT_Y] = c.rigid[r, C.CENTRE_X], c.rigid[r, C.CENTRE_Y]
        at[C.BY_X], at[C.BY_Y] = dt * q[C.U], dt * q[C.V]


@nb.njit(**BY_ADDRESS)
def drift(c, dt):
    """How far the points concerned and the rigid bodies move to the middle of the step: by the velocities at its start, as all nodes do."""
    half = 0.5 * dt
    for i in range(c.sizes[C.POINTS]):
        p, m = c.near_points[i, 0], c.near_points[i, 1]
        at, k = c.places[p], c.points[p, C.POINT_NODE]
        if c.movers[m, C.MOVER_RIGID] < 0:
            at[C.HALF_X], at[C.HALF_Y] = half * c.nodes[U, k], half * c.nodes[U + 1, k]
        else:
            body = c.rigid[c.movers[m, C.MOVER_RIGID]]
            x, y = chord(body, at[C.AT_X], at[C.AT_Y], half * body[C.SPIN])
            at[C.HALF_X], at[C.HALF_Y] = half * body[C.SPEED_X] + x, half * body[C.SPEED_X + 1] + y
    for r in range(c.rigid.shape[0]):
        at, body = c.places[c.points.shape[0] + r], c.rigid[r]
        at[C.HALF_X], at[C.HALF_Y] = half * body[C.SPEED_X], half * body[C.SPEED_X + 1]


@nb.njit(**INLINE)
def chord(body, x, y, angle):
    """Way of a vertex at (x, y) when its body turns by an angle about its centre."""
    x, y, sine, cosine = x - body[C.CENTRE_X], y - body[C.CENTRE_Y], math.sin(angle), math.cos(angle)
    return (cosine - 1.0) * x - sine * y, sine * x + (cosine - 1.0) * y


@nb.njit(**INLINE)
def arm(c, s, a, ends, share, t):
    """(side, x, y): 1 where the mover s of a point turns, -1 where the mover a of an edge does, 0 where neither; the way from its centre
    to the place `share` between the points at the ends of the edge at the time t of `place`."""
    n = c.mover_numbers
    side = 1.0 if n[s, C.II] > 0.0 else -1.0 if n[a, C.II] > 0.0 else 0.0
    if side == 0.0:
        return 0.0, 0.0, 0.0
    (ax, ay), (bx, by) = place(c, ends[0], t), place(c, ends[1], t)
    x, y = place(c, c.points.shape[0] + c.movers[s if side > 0.0 else a, C.MOVER_RIGID], t)
    return side, (1.0 - share) * ax + share * bx - x, (1.0 - share) * ay + share * by - y


@nb.njit(**BY_ADDRESS)
def velocity_from(c, m, mean):
    """Give a mover the velocity of its rigid body, the mean one of the step or that at its start."""
    body, q = c.rigid[c.movers[m, C.MOVER_RIGID]], c.mover_numbers[m]
    first = C.MEAN_X if mean else C.SPEED_X
    q[C.U], q[C.V], q[C.W] = body[first], body[first + 1], body[first + 2]


@nb.njit(**BY_ADDRESS)
def velocity_to(c, nodes, m, mean, dt):
    """Give a rigid body and its vertices the velocity of its mover; dt: the step, for the mean one."""
    body, q = c.rigid[c.movers[m, C.MOVER_RIGID]], c.mover_numbers[m]
    first = C.MEAN_X if mean else C.SPEED_X
    body[first], body[first + 1], body[first + 2] = q[C.U], q[C.V], q[C.W]
    for i in range(c.copies_start[m], c.copies_start[m + 1]):
        k = c.copies[i]
        u, v = q[C.U], q[C.V]
        if q[C.W] != 0.0:
            if mean:
                x, y = chord(body, nodes[X, k], nodes[X + 1, k], dt * q[C.W])
                u, v = u + x / dt, v + y / dt
            else:
                u, v = turned(body, nodes, k, u, v, q[C.W])
        row = UM if mean else U
        nodes[row, k], nodes[row + 1, k] = u, v


@nb.njit(**INLINE)
def turned(body, nodes, k, u, v, spin):
    """Velocity of a vertex where its body stands."""
    return u - spin * (nodes[X + 1, k] - body[C.CENTRE_Y]), v + spin * (nodes[X, k] - body[C.CENTRE_X])


@nb.njit(**BY_ADDRESS)
def drive(c, time, dt):
    """Mean velocity of rigid bodies without contact."""
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        pulse, q = c.movers[m, C.MOVER_PULSE], c.mover_numbers[m]
        velocity_from(c, m, False)
        if pulse >= 0:
            speed = pulse_mean(time, time + dt, c.speeds[pulse], c.speed_tables[pulse])
            q[C.U], q[C.V] = speed * q[C.H1X], speed * q[C.H1Y]
        elif q[C.IM] > 0.0:
            gx, gy = 0.5 * dt * c.gx, 0.5 * dt * c.gy
            q[C.U], q[C.V] = q[C.U] + q[C.PXX] * gx + q[C.PXY] * gy, q[C.V] + q[C.PXY] * gx + q[C.PYY] * gy
        velocity_to(c, c.nodes, m, True, dt)


@nb.njit(**BY_ADDRESS)
def move_rigid(c, nodes, time, dt):
    """Rigid bodies to the end of the step that starts at `time`; a negative dt takes them back."""
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        body, pulse = c.rigid[c.movers[m, C.MOVER_RIGID]], c.movers[m, C.MOVER_PULSE]
        for d in range(3):
            body[C.CENTRE_X + d] += dt * body[C.MEAN_X + d]
            body[C.SPEED_X + d] = 2.0 * body[C.MEAN_X + d] - body[C.SPEED_X + d]
        if pulse >= 0:
            speed, q = pulse_value(time + max(dt, 0.0), c.speeds[pulse], c.speed_tables[pulse]), c.mover_numbers[m]
            body[C.SPEED_X], body[C.SPEED_Y] = speed * q[C.H1X], speed * q[C.H1Y]
        for i in range(c.copies_start[m], c.copies_start[m + 1]):
            k = c.copies[i]
            nodes[X, k] += dt * nodes[UM, k]
            nodes[X + 1, k] += dt * nodes[UM + 1, k]
            nodes[U, k], nodes[U + 1, k] = turned(body, nodes, k, body[C.SPEED_X], body[C.SPEED_Y], body[C.SPIN])
