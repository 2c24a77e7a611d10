"""Small passes of a step over zones: density, energy, viscous heat, altitudes, sound speed, filters' stiffness."""

from typing import Any, NamedTuple

from hugoniot.core.ops import fmax, vsqrt
from hugoniot.core.passes import named, rows_apart
from hugoniot.solvers.lagrange2d.layout import Points, Rates, Stress
from hugoniot.solvers.lagrange2d.row_pass import row_pass
from hugoniot.zones.constants import Constants
from hugoniot.zones.soundness import FOUND_RATE, wave_speed


class HalfOf(NamedTuple):
    """Volume, inverse mass, energy, strain rates and stress at the start -> v, rho, e in the middle of the step; volumes not positive."""

    volume: Any
    inverse_mass: Any
    e: Any
    d: Rates
    t: Stress
    v: Any
    rho: Any
    new_e: Any
    tangled: Any


class HeatOf(NamedTuple):
    """Specific volume, mean viscous stress, strain rates -> heat, J/kg."""

    v: Any
    q: Stress
    d: Rates
    heat: Any


class EnergyOf(NamedTuple):
    """Inverse mass, power, viscous heat -> energy and viscous work, led on."""

    inverse_mass: Any
    power: Any
    heat: Any
    e: Any
    viscous_work: Any


class DensityOf(NamedTuple):
    """Volume, inverse mass -> specific volume and density."""

    volume: Any
    inverse_mass: Any
    v: Any
    rho: Any


class AltitudeOf(NamedTuple):
    """Two rows of nodes, area -> longest edge over area, 1/m: the inverse of the smallest altitude."""

    low: Points
    high: Points
    area: Any
    inverse: Any


class SpeedOf(NamedTuple):
    """c2 of the bulk, shear, specific volume of the solid, viscous speed, inverse altitude -> c; found[FOUND_RATE]."""

    c2: Any
    shear: Any
    solid_v: Any
    speed: Any
    inverse: Any
    c: Any
    found: Any


class StiffnessOf(NamedTuple):
    """rho, c -> rho c^2, rho c."""

    rho: Any
    c: Any
    stiffness: Any
    impedance: Any


class KeptViscosity(NamedTuple):
    """Mean viscous stress and power of the filter -> those of the state, the trace, work of the filter (led on)."""

    mean: Stress
    power: Any
    q: Stress
    trace: Any
    work: Any


@row_pass(HalfOf)
def half_motion(count, given, dt, numbers, law):
    """Density and energy in the middle of the step, by the stress at its start."""
    rows_apart()
    volume, inverse_mass, e, d, t, v_, rho, new_e, tangled = given
    half, bad = 0.5 * dt, 0.0
    for j in range(count):
        power = t.xx[j] * d.xx[j] + t.yy[j] * d.yy[j] + 2.0 * t.xy[j] * d.xy[j] + t.hoop[j] * d.hoop[j]
        v = volume[j] * inverse_mass[j]
        v_[j] = v
        rho[j] = 1.0 / v
        new_e[j] = e[j] + half * v * power
        bad += 0.0 if v > 0.0 else 1.0
    tangled[0] += bad


@row_pass(HeatOf)
def viscous_heat(count, given, dt, numbers, law):
    """Work of the mean viscous stress."""
    rows_apart()
    v, q, d, heat = given
    for j in range(count):
        heat[j] = -dt * v[j] * (q.xx[j] * d.xx[j] + q.yy[j] * d.yy[j] + 2.0 * q.xy[j] * d.xy[j] + q.hoop[j] * d.hoop[j])


@row_pass(EnergyOf)
def end_energy(count, given, dt, numbers, law):
    """Energy at the end of the step, by the work of the corner forces."""
    rows_apart()
    inverse_mass, power, heat, e, viscous_work = given
    for j in range(count):
        e[j] += dt * inverse_mass[j] * power[j]
        viscous_work[j] += heat[j]


@row_pass(DensityOf)
def density(count, given, dt, numbers, law):
    """Specific volume and density."""
    rows_apart()
    volume, inverse_mass, v_, rho = given
    for j in range(count):
        v = volume[j] * inverse_mass[j]
        v_[j] = v
        rho[j] = 1.0 / v


@row_pass(AltitudeOf)
def altitudes(count, given, dt, numbers, law):
    """Inverse of the smallest altitude of each zone."""
    rows_apart()
    low, high, area, inverse = given
    for j in range(count):
        ax, ay, bx, by = high.x[j] - low.x[j], high.y[j] - low.y[j], high.x[j + 1] - high.x[j], high.y[j + 1] - high.y[j]
        cx, cy = low.x[j + 1] - high.x[j + 1], low.y[j + 1] - high.y[j + 1]
        dx, dy = low.x[j] - low.x[j + 1], low.y[j] - low.y[j + 1]
        longest = fmax(fmax(ax * ax + ay * ay, bx * bx + by * by), fmax(cx * cx + cy * cy, dx * dx + dy * dy))
        inverse[j] = vsqrt(longest) / area[j]


@row_pass(SpeedOf)
def end_speed(count, given, dt, numbers, law):
    """Sound speed at the end of the step; the largest signal rate, 1/s. `numbers` are the material's constants."""
    rows_apart()
    c2, shear, solid_v, speed, inverse, c_, found = given
    constants = named(Constants, numbers)
    fastest = found[FOUND_RATE]
    for j in range(count):
        c = wave_speed(c2[j] + (4.0 / 3.0) * shear[j] * solid_v[j], constants.noise)
        fastest = fmax(fastest, (fmax(c, constants.front) + 2.0 * speed[j]) * inverse[j])
        c_[j] = c
    found[FOUND_RATE] = fastest


@row_pass(StiffnessOf)
def stiffnesses(count, given, dt, numbers, law):
    """What the filters push with."""
    rows_apart()
    rho, c, stiffness, impedance = given
    for j in range(count):
        impedance[j] = rho[j] * c[j]
        stiffness[j] = rho[j] * c[j] * c[j]


@row_pass(KeptViscosity)
def keep_viscosity(count, given, dt, numbers, law):
    """The mean viscous stress of a step that stands goes with the state."""
    rows_apart()
    mean, power, q, trace, work = given
    for j in range(count):
        q.xx[j] = mean.xx[j]
        q.yy[j] = mean.yy[j]
        q.xy[j] = mean.xy[j]
        q.hoop[j] = mean.hoop[j]
        trace[j] = mean.xx[j] + mean.yy[j] + mean.hoop[j]
        work[j] += dt * power[j]
