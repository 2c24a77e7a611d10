"""Motion of the nodes of one segment by both integrators, and what the boundaries do."""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.binder import only_if
from hugoniot.core.passes import kind_of, rows_apart, zone_pass
from hugoniot.core.target import BY_ADDRESS
from hugoniot.mesh.line import area, hoops
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.field import field_at
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.pulses import pulse_mean, pulse_value
from hugoniot.solvers.lagrange1d.ring import ring_pull
from hugoniot.solvers.lagrange1d.transmitting import follow, settle

SUDDEN = 0.01     # |du| / c of a driven end in one step: a jump, not a ramp


# -- inner nodes: `count` of them from the second of the node rows on; zone rows begin with the zone on the left of the first ---------
@zone_pass("r u u_mean r_half")
def drift(count, z, dt, numbers, law):
    """Nodes, ends included, in the middle of the step: positions by the velocities at its start, and those velocities extrapolated by the
    acceleration of the previous step. dt is half the step; `numbers` its ratio to the one before."""
    rows_apart()
    ahead = numbers[0]
    for j in range(count):
        u = z.u[j]
        z.r_half[j] = z.r[j] + dt * u
        z.u_mean[j] = u + ahead * (u - z.u_mean[j])


@zone_pass("sigma hoop r_half inverse_mass u u_mean r")
def move(count, z, dt, numbers, law):
    """Velocity and position at the end of the step from the stresses in its middle."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        force = area(z.r_half[j + 1], geometry) * (z.sigma[j] - z.sigma[j + 1])
        if hoops(geometry) > 0.0:
            force -= z.hoop[j] + z.hoop[j + 1]
        before = z.u[j + 1]
        new = before + dt * force * z.inverse_mass[j + 1]
        mean = 0.5 * (before + new)
        z.u[j + 1] = new
        z.u_mean[j + 1] = mean
        z.r[j + 1] += dt * mean


@zone_pass("sigma pull width inverse_mass u r")
def leap(count, z, dt, numbers, law):
    """Leapfrog: velocity to n+1/2 and position to n+1 (B.2 item 2); `numbers` is the mean time step."""
    rows_apart()
    geometry, dt_mean = kind_of(law), numbers[0]
    for j in range(count):
        if hoops(geometry) == 0.0:
            new = z.u[j + 1] + dt_mean * (z.sigma[j] - z.sigma[j + 1]) * z.inverse_mass[j + 1]
        else:
            phi = 0.5 * (z.width[j] + z.width[j + 1])
            beta = 0.5 * (z.pull[j] + z.pull[j + 1])
            new = z.u[j + 1] + dt_mean * ((z.sigma[j] - z.sigma[j + 1]) / phi + beta * hoops(geometry))
        z.u[j + 1] = new
        z.r[j + 1] += dt * new


class End(NamedTuple):
    """An end of the run: pulse and table of the deck's boundary, field of a body force.

    For an `End` nothing of a transmitting one is compiled.
    """

    pulse: Any
    table: Any
    field: Any


class OpenEnd(End):
    """The same, of a run that has a transmitting end."""


# -- boundaries --------------------------------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def outside_stress(code, begin, close, end, control, pulse, table):
    """Stress that a boundary applies between two times, Pa, before what a transmitting one adds as its velocity changes."""
    if code == L.PRESSURE:
        return pulse_mean(begin, close, pulse, table)
    return control[end + L.OUTSIDE] + control[end + L.LEAD] if code == L.TRANSMITTING else 0.0


@nb.njit(**BY_ADDRESS)
def opposed(u, acceleration, dt, per_stress, impedance):
    """Velocity after dt of an end whose change of velocity is opposed with an impedance (0: not at all), taken at the mean velocity.

    per_stress is the acceleration under a unit of stress, m2/kg. At the mean velocity it is stable at any step.
    """
    return u + dt * acceleration / (1.0 + 0.5 * dt * per_stress * impedance)


@nb.njit(**BY_ADDRESS)
def end_pull(zones, nodes, ends, geometry):
    """(acceleration of a segment's end per stress, m2/kg; that of the hoop stress inside, m/s2) in the leapfrog (B.3)."""
    node, zone, _ = ends
    if hoops(geometry) == 0.0:
        return nodes[H.inverse_mass, node], 0.0
    return 1.0 / (0.5 * zones[Z.width, zone]), zones[Z.pull, zone] * hoops(geometry)


@nb.njit(**BY_ADDRESS)
def book(control, left, work, impulse):
    """Add what stands outside an end has done to it."""
    control[L.WORK_LEFT if left else L.WORK_RIGHT] += work
    add_impulse(control, L.IMPULSE_LEFT if left else L.IMPULSE_RIGHT, impulse)


@nb.njit(**BY_ADDRESS)
def add_impulse(control, account, impulse):
    """Add to an account of impulse, and keep what its last digits lose (Neumaier's sum, Z. angew. Math. Mech. 54 (1974) 39).

    A body at rest under pressure adds the same digits in each of a hundred thousand steps, and a plain sum rounds them the same way.
    """
    before, after = control[account], control[account] + impulse
    large, small = (before, impulse) if abs(before) >= abs(impulse) else (impulse, before)
    control[L.LOST_IMPULSE] += (large - after) + small
    control[account] = after


@only_if(lambda boundary: boundary is OpenEnd)
def answer(zones, control, zone, end, dt, boundary):
    """`transmitting.follow`, in a run that has such an end."""
    inward = 1 if end == L.END_LEFT else -1
    follow(control[end:end + L.END_FLOATS], zones, (Z.sigma, Z.rho, Z.q), zone, inward, zones[Z.rho, zone] * zones[Z.c, zone],
           zones[Z.mass, zone], dt)


@only_if(lambda boundary: boundary is OpenEnd)
def hold(zones, nodes, control, ends, end, faster, dt, geometry, boundary):
    """`transmitting.settle`, in a run that has such an end."""
    settle(zones, nodes, control, ends, end, faster, dt, geometry)


@nb.njit(**BY_ADDRESS)
def follow_end(zones, nodes, control, ends, left, dt, boundary):
    """Let a transmitting end of a segment see the zones at the start of the step, and the zones the velocity that an end is given in it:
    extrapolated with its acceleration, an end whose velocity jumps would go on past it."""
    node, zone, code = ends
    if code == L.VELOCITY:
        nodes[H.u_mean, node] = pulse_mean(control[L.TIME], control[L.TIME] + dt, boundary.pulse, boundary.table)
    elif code == L.TRANSMITTING:
        answer(zones, control, zone, L.END_LEFT if left else L.END_RIGHT, dt, boundary)


@nb.njit(**BY_ADDRESS)
def end_node(zones, nodes, control, ends, left, dt, boundary, geometry):
    """One end of a segment at the end of the step; `ends` = (node, zone, boundary code), `boundary` an `End` or `OpenEnd`.

    The work and the impulse of what stands outside are recorded.
    """
    node, zone, code = ends
    pulse, table, field = boundary.pulse, boundary.table, boundary.field
    u, r, r_half, time = nodes[H.u, node], nodes[H.r, node], nodes[H.r_half, node], control[L.TIME]
    face, hoop = area(r_half, geometry), zones[Z.hoop_half, zone] if hoops(geometry) > 0.0 else 0.0
    sign, inverse = -1.0 if left else 1.0, nodes[H.inverse_mass, node]
    inner = sign * face * zones[Z.sigma_half, zone] - hoop + nodes[H.mass, node] * field_at(r_half, field)
    if code == L.FIXED or code == L.VELOCITY or code == L.PERIODIC:
        new = 0.0 if code == L.FIXED else pulse_value(time + dt, pulse, table)
        if code == L.PERIODIC:
            new = u + dt * ring_pull(zones, nodes, control, True, boundary)
        outer = (new - u) / (dt * inverse) - inner
        mean = pulse_mean(time, time + dt, pulse, table) if code == L.VELOCITY else 0.5 * (u + new)
    else:
        end = L.END_LEFT if left else L.END_RIGHT
        impedance = control[end + L.IMPEDANCE] if code == L.TRANSMITTING else 0.0
        push = -sign * face * outside_stress(code, time, time + dt, end, control, pulse, table)
        new = opposed(u, inverse * (inner + push), dt, inverse * face, impedance)
        outer, mean = push - impedance * face * 0.5 * (new - u), 0.5 * (u + new)
        if code == L.TRANSMITTING:
            hold(zones, nodes, control, ends, end, new - u, dt, geometry, boundary)
    nodes[H.u_mean, node] = mean
    nodes[H.u, node] = new
    nodes[H.r, node] = r + dt * mean
    # a history that bends within the step moves the end by its mean, but accelerates it from end to end
    book(control, left, dt * outer * mean + (new - u) * (0.5 * (u + new) - mean) / inverse, dt * outer)
    jump = abs(new - u)
    if (code == L.VELOCITY or code == L.PRESSURE) and jump > SUDDEN * zones[Z.c, zone]:
        # the shock is not seen by its viscous pressure yet: the next step is chosen as for an impact (`start.signal_rate`)
        width = abs(nodes[H.r, node + (1 if left else -1)] - nodes[H.r, node])
        short = control[L.COURANT] * width / (zones[Z.c, zone] + 4.0 * jump)
        control[L.DT_NATURAL] = min(control[L.DT_NATURAL], short / control[L.GROWTH])


@nb.njit(**BY_ADDRESS)
def leap_end(zones, nodes, control, ends, left, dts, boundary, geometry):
    """One end of a segment in the leapfrog: acceleration under the outside stress, or the prescribed velocity; `dts` = (dt, mean dt)."""
    node, zone, code = ends
    pulse, table, field = boundary.pulse, boundary.table, boundary.field
    dt, dt_mean = dts[0], dts[1]
    sign = -1.0 if left else 1.0
    u, time = nodes[H.u, node], control[L.TIME]
    per_stress, pull = end_pull(zones, nodes, ends, geometry)
    pull += field_at(nodes[H.r, node], field)
    face, mass = area(nodes[H.r, node], geometry), nodes[H.mass, node]
    if code == L.FIXED or code == L.VELOCITY or code == L.PERIODIC:
        new = 0.0 if code == L.FIXED else pulse_mean(time, time + dt, pulse, table)
        if code == L.PERIODIC:
            new = u + dt_mean * ring_pull(zones, nodes, control, False, boundary)
        outer = mass * ((new - u) / dt_mean - sign * zones[Z.sigma, zone] * per_stress - pull)
    else:
        end, impedance = L.END_LEFT if left else L.END_RIGHT, 0.0
        if code == L.TRANSMITTING:
            answer(zones, control, zone, end, dt_mean, boundary)
            impedance = control[end + L.IMPEDANCE]
        close = time + 0.5 * dt
        outside = outside_stress(code, close - dt_mean, close, end, control, pulse, table)
        new = opposed(u, sign * (zones[Z.sigma, zone] - outside) * per_stress + pull, dt_mean, per_stress, impedance)
        outer = -sign * face * (outside + sign * impedance * 0.5 * (new - u))
        if code == L.TRANSMITTING:
            hold(zones, nodes, control, ends, end, new - u, dt_mean, geometry, boundary)
    nodes[H.u, node] = new
    nodes[H.r, node] += dt * new
    book(control, left, dt * outer * new, dt_mean * outer)
