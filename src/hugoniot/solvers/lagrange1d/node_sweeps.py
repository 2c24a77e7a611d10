"""Sweeps over the nodes of one segment: acceleration, motion, and what the boundaries do."""

import math

import numba as nb

from hugoniot.core.compile import GUARD, SWEEP
from hugoniot.mesh.line import area, hoops
from hugoniot.solvers.lagrange1d import layout as L


@nb.njit(**GUARD)
def pulse_value(time, pulse, table):
    """Value of a boundary's pulse; `pulse` = (shape code, amplitude, start, duration), `table` = (times; values)."""
    shape, amplitude, since, duration = int(pulse[0]), pulse[1], time - pulse[2], pulse[3]
    if shape == 1:
        times, values = table[0], table[1]
        if time <= times[0]:
            return values[0]
        for k in range(1, times.shape[0]):
            if time < times[k]:
                return values[k - 1] + (values[k] - values[k - 1]) * (time - times[k - 1]) / (times[k] - times[k - 1])
        return values[-1]
    if since < 0.0:
        return 0.0
    if shape == 0:
        return amplitude
    if shape == 2:
        return amplitude * math.exp(-since / duration)
    if shape == 3:
        return amplitude * math.sin(math.pi * since / duration) if since < duration else 0.0
    if shape == 4:
        return amplitude if since < duration else 0.0
    return amplitude * min(since / duration, 1.0)


@nb.njit(**SWEEP)
def accelerate(zones, nodes, first, last, segment, dt, geometry):
    """Predictor, inner nodes: velocity from the stresses at the start of the step, mean velocity, position at mid-step."""
    a = first + segment
    b = last + segment
    r, u, rh, um = nodes[L.R, a + 1:b], nodes[L.U, a + 1:b], nodes[L.R_HALF, a + 1:b], nodes[L.U_MEAN, a + 1:b]
    im = nodes[L.INVERSE_NODE_MASS, a + 1:b]
    sigma, hoop = zones[L.SIGMA, first:last], zones[L.HOOP, first:last]
    for j in range(r.shape[0]):
        force = area(r[j], geometry) * (sigma[j] - sigma[j + 1])
        if hoops(geometry) > 0.0:
            force -= hoop[j] + hoop[j + 1]
        mean = u[j] + 0.5 * dt * force * im[j]
        um[j] = mean
        rh[j] = r[j] + 0.5 * dt * mean


@nb.njit(**SWEEP)
def move(zones, nodes, first, last, segment, dt, geometry):
    """Corrector, inner nodes: velocity and position at the end of the step from the stresses in its middle."""
    a = first + segment
    b = last + segment
    r, u, rh, um = nodes[L.R, a + 1:b], nodes[L.U, a + 1:b], nodes[L.R_HALF, a + 1:b], nodes[L.U_MEAN, a + 1:b]
    im = nodes[L.INVERSE_NODE_MASS, a + 1:b]
    sigma, hoop = zones[L.SIGMA_HALF, first:last], zones[L.HOOP_HALF, first:last]
    for j in range(r.shape[0]):
        force = area(rh[j], geometry) * (sigma[j] - sigma[j + 1])
        if hoops(geometry) > 0.0:
            force -= hoop[j] + hoop[j + 1]
        new = u[j] + dt * force * im[j]
        mean = 0.5 * (u[j] + new)
        u[j] = new
        um[j] = mean
        r[j] += dt * mean


@nb.njit(**GUARD)
def outside_stress(code, time, reference, pulse, table):
    """Stress a boundary applies, before what a transmitting one adds with the velocity."""
    if code == L.PRESSURE:
        return pulse_value(time, pulse, table)
    return reference if code == L.TRANSMITTING else 0.0


@nb.njit(**GUARD)
def end_node(zones, nodes, control, ends, left, corrector, dt, boundary, geometry):
    """One end of a segment; `ends` = (node, zone, boundary code), `boundary` = (pulse, table) of the deck's boundary.

    A transmitting boundary answers with the impedance rho c of the zone inside, taken at the mean velocity, so it is
    stable at any step. In the corrector the work and the impulse of what stands outside are booked.
    """
    node, zone, code = ends
    pulse, table = boundary
    dimension = geometry.dimension
    u, r, half = nodes[L.U, node], nodes[L.R, node], nodes[L.R_HALF, node]
    place = half if corrector else r
    face = area(place, geometry)
    sigma = zones[L.SIGMA_HALF, zone] if corrector else zones[L.SIGMA, zone]
    hoop = (zones[L.HOOP_HALF, zone] if corrector else zones[L.HOOP, zone]) if dimension > 1.0 else 0.0
    sign = -1.0 if left else 1.0
    inner = sign * face * sigma - hoop
    time = control[L.TIME]
    inverse = nodes[L.INVERSE_NODE_MASS, node]
    if code == L.FIXED or code == L.VELOCITY:
        new = 0.0 if code == L.FIXED else pulse_value(time + dt, pulse, table)
        outer = (new - u) / (dt * inverse) - inner
    else:
        reference = control[L.REFERENCE_LEFT] if left else control[L.REFERENCE_RIGHT]
        push = -sign * face * outside_stress(code, time + 0.5 * dt, reference, pulse, table)
        impedance = face * zones[L.RHO, zone] * zones[L.C, zone] if code == L.TRANSMITTING else 0.0
        weight = 0.5 * dt * inverse * impedance
        new = (u * (1.0 - weight) + dt * inverse * (inner + push)) / (1.0 + weight)
        outer = push - impedance * 0.5 * (u + new)
    mean = 0.5 * (u + new)
    nodes[L.U_MEAN, node] = mean
    if corrector:
        nodes[L.U, node] = new
        nodes[L.R, node] = r + dt * mean
        work, impulse = (L.WORK_LEFT, L.IMPULSE_LEFT) if left else (L.WORK_RIGHT, L.IMPULSE_RIGHT)
        control[work] += dt * outer * mean
        control[impulse] += dt * outer
    else:
        nodes[L.R_HALF, node] = r + 0.5 * dt * mean
