"""Nodes on boundaries, shared by blocks or on the axis, which something besides their own zones acts on.

Loads on edges are added to the forces of their nodes. The forces on nodes shared by several blocks are summed in a fixed order and given
to each. Constraints (walls, axis, driven edges) remove the constrained component of the velocity; their impulse and work are recorded for
the chain of edges. `middle` gives the position of a node's mid-step values in the rows (`rings`).
"""

import numba as nb

from hugoniot.core.passes import rows
from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange1d.layout import LEAD, OUTSIDE
from hugoniot.solvers.lagrange1d.pulses import pulse_mean
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.quads import AREA_WEIGHTED, PLANAR


# -- loads on edges ---------------------------------------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def edge_force(x1, y1, x2, y2, kind, near):
    """Force (x1, y1, x2, y2) of a unit pressure to the left of an edge from 1 to 2 on its ends.

    Around a body these are the derivatives of its volume. An edge by itself gets what acts on it, the integral of N_k x along it: the
    derivative of one term of the volume would give a chain that is not closed no axial force.
    """
    dx, dy = x2 - x1, y2 - y1
    if kind == PLANAR:
        return 0.5 * dy, -0.5 * dx, 0.5 * dy, -0.5 * dx
    if kind == AREA_WEIGHTED:
        r1, r2 = max(x1, near), max(x2, near)
        return 0.5 * dy * r1, -0.5 * dx * r1, 0.5 * dy * r2, -0.5 * dx * r2
    first, second = (2.0 * x1 + x2) / 6.0, (x1 + 2.0 * x2) / 6.0
    return dy * first, -dx * first, dy * second, -dx * second


@nb.njit(**BY_ADDRESS)
def load(nodes, middle, loads, given, pulses, ends, step, geometry):
    """Add the pressure on loaded edges to the forces of their nodes, and keep it in `given` (edge, 4) for the booking of its work.

    It is the mean over a `step`, the times of its beginning and end.
    A transmitting edge, of pulse -1 - its number, has the stress outside and the lead of `ends`; what the motion adds is `transmit`.
    """
    n = rows(L.Nodes, nodes, 0)
    numbers, tables = pulses
    kind, near = geometry
    for i in range(loads.shape[0]):
        a, b, sign = loads[i, L.LOAD_A], loads[i, L.LOAD_B], loads[i, L.LOAD_OUTWARD]
        force = edge_force(n.xh[middle[a]], n.yh[middle[a]], n.xh[middle[b]], n.yh[middle[b]], kind, near)
        pulse = loads[i, L.LOAD_PULSE]
        if pulse < 0:
            pressure = ends[-1 - pulse, OUTSIDE] + ends[-1 - pulse, LEAD]
        else:
            pressure = pulse_mean(step[0], step[1], numbers[pulse], tables[pulse])
        push = -sign * pressure
        for k in range(4):
            given[i, k] = push * force[k]
        n.fx[middle[a]] += given[i, 0]
        n.fy[middle[a]] += given[i, 1]
        n.fx[middle[b]] += given[i, 2]
        n.fy[middle[b]] += given[i, 3]


@nb.njit(**BY_ADDRESS)
def book_loads(nodes, middle, loads, given, chains, dt):
    """Impulse and work of the loaded edges in this step."""
    n = rows(L.Nodes, nodes, 0)
    for i in range(loads.shape[0]):
        a, b, chain = middle[loads[i, L.LOAD_A]], middle[loads[i, L.LOAD_B]], loads[i, L.LOAD_CHAIN]
        work = given[i, 0] * n.um[a] + given[i, 1] * n.vm[a] + given[i, 2] * n.um[b] + given[i, 3] * n.vm[b]
        chains[chain, L.CHAIN_WORK] += dt * work
        chains[chain, L.CHAIN_IMPULSE_X] += dt * (given[i, 0] + given[i, 2])
        chains[chain, L.CHAIN_IMPULSE_Y] += dt * (given[i, 1] + given[i, 3])


# -- nodes that blocks share --------------------------------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def exchange(nodes, starts, members):
    """Sum the forces over every group of nodes that are one, in fixed order, and give the sum to each."""
    n = rows(L.Nodes, nodes, 0)
    for k in range(starts.shape[0] - 1):
        x, y = 0.0, 0.0
        for m in range(starts[k], starts[k + 1]):
            x += n.fx[members[m]]
            y += n.fy[members[m]]
        for m in range(starts[k], starts[k + 1]):
            n.fx[members[m]] = x
            n.fy[members[m]] = y


@nb.njit(**BY_ADDRESS)
def axis_masses(nodes, middle, axis, ratio, near):
    """Area weighted: a node on the axis has the areal mass of its neighbour off the axis times the ratio of both at t = 0.

    The neighbour's radius is that in the middle of the step, as for the forces there.
    """
    n = rows(L.Nodes, nodes, 0)
    for i in range(axis.shape[0]):
        node, beside = axis[i, 0], axis[i, 1]
        n.im[node] = n.im[beside] * n.xh[middle[beside]] / (near * ratio[i])


# -- special nodes: motion again, and what holds them ---------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def free_motion(nodes, middle, special, dt, body_force):
    """Mean velocity of the special nodes from their whole forces."""
    n, (gx, gy) = rows(L.Nodes, nodes, 0), body_force
    for i in range(special.shape[0]):
        k, m = special[i], middle[special[i]]
        n.um[m] = n.u[k] + 0.5 * dt * (n.fx[m] * n.im[k] + gx)
        n.vm[m] = n.v[k] + 0.5 * dt * (n.fy[m] * n.im[k] + gy)


@nb.njit(**BY_ADDRESS)
def transmit(nodes, gates, normals, chains, dt):
    """What a transmitting boundary answers: its impedance times the change of velocity along its normal, stable at any step.

    gates: (node, chain, booked); normals: (x, y) whose length is the impedance, rho c times the area, kg/s.
    """
    n = rows(L.Nodes, nodes, 0)
    for i in range(gates.shape[0]):
        k = gates[i, 0]
        impedance = (normals[i, 0] ** 2 + normals[i, 1] ** 2) ** 0.5
        if impedance == 0.0:
            continue
        nx, ny = normals[i, 0] / impedance, normals[i, 1] / impedance
        weight = 0.5 * dt * n.im[k] * impedance
        speed = (n.um[k] - n.u[k]) * nx + (n.vm[k] - n.v[k]) * ny
        taken = speed * weight / (1.0 + weight)
        n.um[k] -= taken * nx
        n.vm[k] -= taken * ny
        if gates[i, 2] == 1:
            force, chain = -impedance * (speed - taken), gates[i, 1]
            chains[chain, L.CHAIN_WORK] += dt * force * (n.um[k] * nx + n.vm[k] * ny)
            chains[chain, L.CHAIN_IMPULSE_X] += dt * force * nx
            chains[chain, L.CHAIN_IMPULSE_Y] += dt * force * ny


@nb.njit(**INLINE)
def along_both(first, second, ax, ay, bx, by):
    """(f, s) of the change f (ax, ay) + s (bx, by) whose parts along the two directions are `first` and `second`; they are independent."""
    overlap = ax * bx + ay * by
    over = 1.0 / (1.0 - overlap * overlap)
    return (first - overlap * second) * over, (second - overlap * first) * over


@nb.njit(**INLINE)
def lacking(u, v, given, ax, ay, bx, by, second):
    """(f, s) of the change f (ax, ay) + s (bx, by) by which the velocity (u, v) gets the values `given` along one or two directions."""
    f = given[0] - (u * ax + v * ay)
    return along_both(f, given[1] - (u * bx + v * by), ax, ay, bx, by) if second else (f, 0.0)


@nb.njit(**BY_ADDRESS)
def given_velocity(row, pulses, tables, begin, end):
    """Mean between two times of the velocities that a row of the held nodes has along its two directions, m/s."""
    one, two = row[L.HOLD_PULSE_1], row[L.HOLD_PULSE_2]
    return (pulse_mean(begin, end, pulses[one], tables[one]) if one >= 0 else 0.0,
            pulse_mean(begin, end, pulses[two], tables[two]) if two >= 0 else 0.0)


@nb.njit(**BY_ADDRESS)
def hold(nodes, middle, held, normals, pulses, tables, chains, step, book):
    """Take from the mean velocity what walls, the axis and driven edges do not allow; book their impulse and work.

    held: integers of `layout` HOLD_*; normals: (n1x, n1y, n2x, n2y) of unit directions along which the velocity is that of the pulse
    (none: 0), its mean over the `step`, the times of its beginning and end; what it is at the end is for `settle`.
    """
    n = rows(L.Nodes, nodes, 0)
    for i in range(held.shape[0]):
        k, m, both = held[i, L.HOLD_NODE], middle[held[i, L.HOLD_NODE]], held[i, L.HOLD_CHAIN_2] >= 0
        ax, ay, bx, by = normals[i, 0], normals[i, 1], normals[i, 2], normals[i, 3]
        mean = given_velocity(held[i], pulses, tables, step[0], step[1])
        last = given_velocity(held[i], pulses, tables, step[1], step[1])
        first, second = lacking(2.0 * n.um[m] - n.u[k], 2.0 * n.vm[m] - n.v[k], last, ax, ay, bx, by, both)
        f, s = lacking(n.um[m], n.vm[m], mean, ax, ay, bx, by, both)
        n.um[m] += f * ax + s * bx
        n.vm[m] += f * ay + s * by
        if book and held[i, L.HOLD_BOOKED] == 1:
            # a history that bends within the step moves the node by its mean, but accelerates it from end to end
            mass, u, v = 1.0 / n.im[k], 2.0 * n.um[m] - n.u[k], 2.0 * n.vm[m] - n.v[k]
            bent, bent_2 = lacking(u, v, last, ax, ay, bx, by, both)
            u, v = u + bent * ax + bent_2 * bx - n.u[k], v + bent * ay + bent_2 * by - n.v[k]
            book_hold(chains, held[i, L.HOLD_CHAIN_1], mass * first, ax, ay, n.um[m], n.vm[m])
            chains[held[i, L.HOLD_CHAIN_1], L.CHAIN_WORK] += 0.5 * mass * bent * (u * ax + v * ay)
            if both:
                book_hold(chains, held[i, L.HOLD_CHAIN_2], mass * second, bx, by, n.um[m], n.vm[m])
                chains[held[i, L.HOLD_CHAIN_2], L.CHAIN_WORK] += 0.5 * mass * bent_2 * (u * bx + v * by)


@nb.njit(**BY_ADDRESS)
def settle(nodes, held, normals, pulses, tables, time):
    """Give held nodes the velocity of their pulses at a time, where a step has led them on by twice the mean."""
    n = rows(L.Nodes, nodes, 0)
    for i in range(held.shape[0]):
        k, given = held[i, L.HOLD_NODE], given_velocity(held[i], pulses, tables, time, time)
        ax, ay, bx, by = normals[i, 0], normals[i, 1], normals[i, 2], normals[i, 3]
        f, s = lacking(n.u[k], n.v[k], given, ax, ay, bx, by, held[i, L.HOLD_CHAIN_2] >= 0)
        n.u[k] += f * ax + s * bx
        n.v[k] += f * ay + s * by


@nb.njit(**INLINE)
def book_hold(chains, chain, impulse, nx, ny, u, v):
    """Impulse of a hold along (nx, ny), and its work at the mean velocity."""
    chains[chain, L.CHAIN_WORK] += impulse * (nx * u + ny * v)
    chains[chain, L.CHAIN_IMPULSE_X] += impulse * nx
    chains[chain, L.CHAIN_IMPULSE_Y] += impulse * ny
