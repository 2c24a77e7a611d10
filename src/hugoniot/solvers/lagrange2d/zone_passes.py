"""Passes of zones in a step: motion to its middle and its end, energy by the work of forces, corner forces, and the final state.

    strain       motion to the middle: strain rates, density, energy by the stress at the start
    push_fluid, push_solid   corner forces of stress, viscosity and filters in the middle
    settle       motion to the end: strain rates, energy by the work of those forces
    shape        volume and smallest altitude at the end
    stand        the final state: stress, sound speed
    push         corner forces of stress and viscosity alone, of triangles in the middle

Rows named for quadrilaterals are also used for triangles (`triangle_passes`): `cells` chooses by the class of `corners`.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.mathematics import NAN_LAW
from hugoniot.core.ops import fmax
from hugoniot.core.passes import kind_of, named, rows_apart, zone_pass
from hugoniot.solvers.lagrange2d import hourglass
from hugoniot.solvers.lagrange2d.cells import cell, coefficients, longest_side, power, strains, stress_forces, volume
from hugoniot.solvers.lagrange2d.closing import STRETCH
from hugoniot.solvers.lagrange2d.forces import add_forces
from hugoniot.solvers.lagrange2d.layout import FILTER, FOUND_FILTER, NEAR, Corners, Rates, Sides, SidesNow, Stress, Tensor
from hugoniot.solvers.lagrange2d.tensor import principal
from hugoniot.zones.constants import Constants
from hugoniot.zones.soundness import FOUND_RATE, PeakRows, keep_peaks, new_peaks, unsound, wave_speed


class StrainOf(NamedTuple):
    """Rows of nodes in the middle of the step, state at its start -> strain rates, specific volume, density, energy."""

    corners: Sides
    inverse_mass: Any
    e: Any
    p: Any
    s: Tensor
    q: Stress
    d: Rates
    v: Any
    rho: Any
    new_e: Any
    tangled: Any


class PushOf(NamedTuple):
    """Nodes, pressure, deviators, mean viscous stress, shape at t = 0, rho, c -> corner forces, filter's power."""

    corners: Sides
    p: Any
    s: Tensor
    q: Stress
    t0: Any
    t1: Any
    rho: Any
    c: Any
    f: Corners
    power: Any


class RestOf(NamedTuple):
    """Nodes, planar forces of what the corners' viscous stresses have beyond their mean, stretches in which something closes (`closing`)
    -> corner forces with them."""

    corners: Sides
    g: Corners
    closes: Any
    f: Corners


class SettleOf(NamedTuple):
    """Nodes in the middle, corner forces, filter's power and viscous stress of the step -> strain rates, energy, viscous heat;
    found[FOUND_FILTER]."""

    corners: Sides
    f: Corners
    inverse_mass: Any
    filter_power: Any
    d: Rates
    e: Any
    heat: Any
    q: Stress
    found: Any


class ShapeOf(NamedTuple):
    """Nodes at the end, inverse mass -> specific volume, density, inverse of the smallest altitude."""

    corners: SidesNow
    inverse_mass: Any
    v: Any
    rho: Any
    inverse: Any


class StandOf(NamedTuple):
    """Deviators found, stiffness, density and pressure -> deviators of the state, largest principal stress, c and peaks;
    found[FOUND_RATE] and found[FOUND_UNSOUND].

    The viscous stress is not part of the largest stress: it is that of the middle of the step, and with the pressure of the end the sum
    would be up to a tenth above the state behind a strong shock.
    """

    new: Tensor
    c2: Any
    shear: Any
    solid_v: Any
    speed: Any
    inverse: Any
    s: Tensor
    seen: PeakRows


class StressOf(NamedTuple):
    """Nodes, pressure, viscous stress and deviators -> corner forces."""

    corners: SidesNow
    p: Any
    q: Stress
    s: Tensor
    f: Corners


def stress_power(z, j, d):
    """Power of the stress of zone j (pressure, deviators and viscous stress) on strain rates, per volume."""
    xx, yy, p = z.s.xx[j], z.s.yy[j], z.p[j]
    rate = (xx - p - z.q.xx[j]) * d.xx + (yy - p - z.q.yy[j]) * d.yy + 2.0 * (z.s.xy[j] - z.q.xy[j]) * d.xy
    return rate - (xx + yy + p + z.q.hoop[j]) * d.hoop


@zone_pass(StrainOf)
def strain(count, z, dt, numbers, law):
    """Strain rates, density and energy in the middle of the step, by the velocities extrapolated to it and the stress at the start."""
    rows_apart()
    geometry, near, half, bad = kind_of(law), numbers[NEAR], 0.5 * dt, 0.0
    for j in range(count):
        at = cell(z.corners, j)
        d = strains(at, z.corners, j, near, geometry)
        rate = stress_power(z, j, d)
        v = volume(at, geometry) * z.inverse_mass[j]
        z.d.xx[j], z.d.yy[j], z.d.xy[j], z.d.spin[j], z.d.hoop[j], z.d.dilation[j] = d.xx, d.yy, d.xy, d.spin, d.hoop, d.dilation
        z.v[j] = v
        z.rho[j] = 1.0 / v
        z.new_e[j] = z.e[j] + half * v * rate
        # a zone inverted in both directions has a positive volume again, but grows as if it had come from a negative one
        bad += 0.0 if v > 0.0 and half * d.dilation < 1.0 else 1.0
    z.tangled[0] += bad


def with_mean(z, j, b):
    """Corner forces of the stress and the mean viscous stress of zone j."""
    stress_forces(z.f, j, b, z.p[j], z.s.xx[j], z.s.yy[j], z.s.xy[j], z.q.xx[j], z.q.yy[j], z.q.xy[j], z.q.hoop[j])


@zone_pass(PushOf)
def push_fluid(count, z, dt, numbers, law):
    """Corner forces of stress, mean viscosity and subzonal pressure in the middle of the step."""
    rows_apart()
    geometry, near, merit = kind_of(law), numbers[NEAR], numbers[FILTER]
    for j in range(count):
        at = cell(z.corners, j)
        b = coefficients(at, near, geometry)
        with_mean(z, j, b)
        x0, y0, x1, y1, x2, y2, x3, y3 = hourglass.subzonal(at, z.t0[j], z.t1[j], merit * z.rho[j] * z.c[j] * z.c[j])
        add_forces(z.f, j, b, x0, y0, x1, y1, x2, y2, x3, y3)
        z.power[j] = 0.0


@zone_pass(PushOf)
def push_solid(count, z, dt, numbers, law):
    """Corner forces of stress, mean viscosity and viscous filter in the middle of the step."""
    rows_apart()
    geometry, near, coefficient, low, high = kind_of(law), numbers[NEAR], numbers[FILTER], z.corners.low, z.corners.high
    for j in range(count):
        at = cell(z.corners, j)
        b = coefficients(at, near, geometry)
        with_mean(z, j, b)
        x0, y0, x1, y1, x2, y2, x3, y3, taken = hourglass.viscous(at, low, high, j, coefficient * z.rho[j] * z.c[j])
        add_forces(z.f, j, b, x0, y0, x1, y1, x2, y2, x3, y3)
        z.power[j] = taken * 0.25 * (b.w0 + b.w1 + b.w2 + b.w3)


@zone_pass(RestOf)
def add_rest(count, z, dt, numbers, law):
    """Planar forces added with the weights of the geometry in the stretches of zones in which something closes."""
    rows_apart()
    geometry, near, g, first = kind_of(law), numbers[NEAR], z.g, 0
    while first < count:
        end = min(first + STRETCH, count)
        if z.closes[first] > 0.0:
            for j in range(first, end):
                b = coefficients(cell(z.corners, j), near, geometry)
                add_forces(z.f, j, b, g.f0x[j], g.f0y[j], g.f1x[j], g.f1y[j], g.f2x[j], g.f2y[j], g.f3x[j], g.f3y[j])
        first = end


@zone_pass(SettleOf)
def settle(count, z, dt, numbers, law):
    """Strain rates with the mean velocity of the step; energy by the work of the forces, -sum F.u."""
    rows_apart()
    geometry, near, filtered = kind_of(law), numbers[NEAR], 0.0
    for j in range(count):
        at = cell(z.corners, j)
        d = strains(at, z.corners, j, near, geometry)
        work = power(z.f, z.corners, j)
        inverse_mass, xx, yy, xy, hoop = z.inverse_mass[j], z.q.xx[j], z.q.yy[j], z.q.xy[j], z.q.hoop[j]
        heat = -dt * volume(at, geometry) * inverse_mass * (xx * d.xx + yy * d.yy + 2.0 * xy * d.xy + hoop * d.hoop)
        z.d.xx[j], z.d.yy[j], z.d.xy[j], z.d.spin[j], z.d.hoop[j], z.d.dilation[j] = d.xx, d.yy, d.xy, d.spin, d.hoop, d.dilation
        z.e[j] -= dt * inverse_mass * work
        z.heat[j] = heat
        filtered += z.filter_power[j]
    z.found[FOUND_FILTER] += filtered


@zone_pass(ShapeOf)
def shape(count, z, dt, numbers, law):
    """Volume and smallest altitude at the end of the step."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        at = cell(z.corners, j)
        v, longest = volume(at, geometry) * z.inverse_mass[j], longest_side(at)
        inverse = 1.0 / (v * at.area)      # one division does for both
        z.v[j] = v
        z.rho[j] = at.area * inverse
        z.inverse[j] = longest * v * inverse


def rate_of_state(z, j, constants):
    """Write the state of zone j at the end of the step; what it requires of the time step, 1/s."""
    xx, yy, xy = z.new.xx[j], z.new.yy[j], z.new.xy[j]
    z.s.xx[j], z.s.yy[j], z.s.xy[j] = xx, yy, xy
    z.seen.sigma[j] = principal(z.seen.p[j], xx, yy, xy)
    c = wave_speed(z.c2[j] + (4.0 / 3.0) * z.shear[j] * z.solid_v[j], constants.noise)
    z.seen.c[j] = c
    return (fmax(c, constants.front) + 2.0 * z.speed[j]) * z.inverse[j]


@zone_pass(StandOf, finite=False)
def stand(count, z, dt, numbers, law):
    """The state at the end of the step, checked at once."""
    rows_apart()
    constants, seen = named(Constants, numbers), z.seen
    fastest, bad, new = seen.found[FOUND_RATE], 0, 0
    for j in range(count):
        fastest = fmax(fastest, rate_of_state(z, j, constants))
        bad += unsound(seen, j)
        new += new_peaks(seen, j)
    seen.found[FOUND_RATE] = fastest
    keep_peaks(count, seen, bad, new)


@zone_pass(StressOf)
def push(count, z, dt, numbers, law):
    """Corner forces of stress and viscosity."""
    rows_apart()
    geometry, near = kind_of(law), numbers[NEAR]
    for j in range(count):
        with_mean(z, j, coefficients(cell(z.corners, j), near, geometry))


bind(stress_power)
bind(with_mean)
bind(rate_of_state, **NAN_LAW)
