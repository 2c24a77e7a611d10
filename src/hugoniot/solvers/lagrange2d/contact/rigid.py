"""Rigid bodies in a step: what moves them, and where their vertices are taken.

A body that turns goes from one place to the next as a whole: its centre by the mean velocity of the step, its vertices around the centre by
the mean rate of turning, along chords. An impulse acts in the middle of the step, at the place of contact there, so that the angular
momentum that the material loses is what the body gains.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange1d.nodes import pulse_value
from hugoniot.solvers.lagrange2d.contact import layout as C

X, U, XH, UM = 0, 2, 4, 6      # rows of the node table


@nb.njit(**INLINE)
def place(c, nodes, m, k, dt):
    """Where a column k of the nodes is after dt, with the velocity of its mover m."""
    n = c.mover_numbers
    x, y = nodes[X, k] + dt * n[m, C.U], nodes[X + 1, k] + dt * n[m, C.V]
    if n[m, C.W] != 0.0:
        dx, dy = chord(c.rigid[c.movers[m, C.MOVER_RIGID]], nodes, k, dt * n[m, C.W])
        x, y = x + dx, y + dy
    return x, y


@nb.njit(**INLINE)
def chord(body, nodes, k, angle):
    """Way of a vertex when its body turns by an angle about its centre."""
    x, y, sine, cosine = nodes[X, k] - body[C.CENTRE_X], nodes[X + 1, k] - body[C.CENTRE_Y], math.sin(angle), math.cos(angle)
    return (cosine - 1.0) * x - sine * y, sine * x + (cosine - 1.0) * y


@nb.njit(**BY_ADDRESS)
def arm(c, nodes, s, a, b, ends, t, dt):
    """(side, x, y): 1 where the mover of a point turns, -1 where that of an edge does, 0 where neither; the way from its centre to the
    place t of the edge after dt. ends: node columns of the edge."""
    n = c.mover_numbers
    side = 1.0 if n[s, C.II] > 0.0 else -1.0 if n[a, C.II] > 0.0 else 0.0
    if side == 0.0:
        return 0.0, 0.0, 0.0
    m = s if side > 0.0 else a
    body, (ax, ay), (bx, by) = c.rigid[c.movers[m, C.MOVER_RIGID]], place(c, nodes, a, ends[0], dt), place(c, nodes, b, ends[1], dt)
    x, y = body[C.CENTRE_X] + dt * n[m, C.U], body[C.CENTRE_Y] + dt * n[m, C.V]
    return side, (1.0 - t) * ax + t * bx - x, (1.0 - t) * ay + t * by - y


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
                x, y = chord(body, nodes, k, dt * q[C.W])
                u, v = u + x / dt, v + y / dt
            else:
                u, v = turned(body, nodes, k, u, v, q[C.W])
        row = UM if mean else U
        nodes[row, k], nodes[row + 1, k] = u, v
        if mean:
            nodes[XH, k], nodes[XH + 1, k] = nodes[X, k] + 0.5 * dt * u, nodes[X + 1, k] + 0.5 * dt * v


@nb.njit(**INLINE)
def turned(body, nodes, k, u, v, spin):
    """Velocity of a vertex where its body stands."""
    return u - spin * (nodes[X + 1, k] - body[C.CENTRE_Y]), v + spin * (nodes[X, k] - body[C.CENTRE_X])


@nb.njit(**BY_ADDRESS)
def drive(c, run, options, time, dt):
    """Mean velocity of rigid bodies without contact."""
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        pulse, q = c.movers[m, C.MOVER_PULSE], c.mover_numbers[m]
        velocity_from(c, m, False)
        if pulse >= 0:
            speed = pulse_value(time + dt, c.speeds[pulse], c.speed_tables[pulse])
            q[C.U], q[C.V] = 0.5 * (q[C.U] + speed * q[C.H1X]), 0.5 * (q[C.V] + speed * q[C.H1Y])
        elif q[C.IM] > 0.0:
            gx, gy = 0.5 * dt * options.gx, 0.5 * dt * options.gy
            q[C.U], q[C.V] = q[C.U] + q[C.PXX] * gx + q[C.PXY] * gy, q[C.V] + q[C.PXY] * gx + q[C.PYY] * gy
        velocity_to(c, run.nodes, m, True, dt)


@nb.njit(**BY_ADDRESS)
def move_rigid(c, nodes, dt):
    """Rigid bodies to the end of the step; a negative dt takes them back."""
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        body = c.rigid[c.movers[m, C.MOVER_RIGID]]
        for d in range(3):
            body[C.CENTRE_X + d] += dt * body[C.MEAN_X + d]
            body[C.SPEED_X + d] = 2.0 * body[C.MEAN_X + d] - body[C.SPEED_X + d]
        for i in range(c.copies_start[m], c.copies_start[m + 1]):
            k = c.copies[i]
            nodes[X, k] += dt * nodes[UM, k]
            nodes[X + 1, k] += dt * nodes[UM + 1, k]
            nodes[U, k], nodes[U + 1, k] = turned(body, nodes, k, body[C.SPEED_X], body[C.SPEED_Y], body[C.SPIN])
