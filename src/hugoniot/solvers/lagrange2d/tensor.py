r"""Stress of a zone in two dimensions: the total stress, the elastic trial with its rotation, the return to the yield surface.

Deviators are $s_{xx}, s_{yy}, s_{xy}$ and $s_\theta = -(s_{xx} + s_{yy})$. The Jaumann rate is integrated by Crank-Nicolson: with
$D = s_{xx} - s_{yy}$, $S = 2 s_{xy}$ and a rotation by the angle $\vartheta$ in the step, $a = \tan\vartheta$,

$$D' = \frac{(1-a^2)D - 2aS + dD - a\,dS}{1+a^2},\qquad S' = \frac{(1-a^2)S + 2aD + dS + a\,dD}{1+a^2},$$

which conserves $D^2 + S^2$ in a rigid rotation (Herrmann's illegible equations B.26, B.29; H-E9). In a rigid rotation nodes drift along
their tangents and move along chords. In the middle of the step the spin is $w\,dt = \sin\vartheta$, and $a = w\,dt/\sqrt{1 - (w\,dt)^2}$
rotates the stress by the same angle as the zone.

Source: Herrmann, WL-TR-64-107, B.16 to B.32.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.mathematics import NAN_LAW
from hugoniot.core.ops import fmax, fmin, late_over, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.layout import Rates, Stress, Tensor
from hugoniot.zones.strength import Solid, modulus, needs_rate, yielding

NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


class StrengthOf(NamedTuple):
    """State, deviators and strain rates -> shear, deviators after the step, limit, flow."""

    solid: Solid
    s: Tensor
    d: Rates
    shear: Any
    new: Tensor
    limit: Any
    flow: Any


class LargestOf(NamedTuple):
    """Deviators -> the largest principal one."""

    s: Tensor
    largest: Any


class HeatOf(NamedTuple):
    """Specific volume, mean viscous stress, strain rates -> heat, J/kg."""

    v: Any
    q: Stress
    d: Rates
    heat: Any


def trial_deviators(s, rates, double):
    """Deviators (xx, yy, xy) of the elastic trial, turned with the zone.

    s        those before
    rates    (xx, yy, xy, dilation) of the strain in 1/s, and the sine of the angle of the turn
    double   2 G dt
    """
    xx, yy, xy = s
    d_xx, d_yy, d_xy, dilation, sine = rates
    difference, shear = xx - yy, 2.0 * xy
    d_difference, d_shear = double * (d_xx - d_yy), 2.0 * double * d_xy
    total = 0.5 * (xx + yy + double * (d_xx + d_yy - (2.0 / 3.0) * dilation))
    square = fmin(sine * sine, 1.0)                  # a corner that turns by more in a step is turned by a right angle
    cosine = vsqrt(1.0 - square)                     # a = sine / cosine
    same, a, less = 0.5 - square, sine * cosine, 0.5 * (1.0 - square)
    turned = same * difference - a * shear + less * d_difference - 0.5 * a * d_shear
    return total + turned, total - turned, same * shear + a * difference + less * d_shear + 0.5 * a * d_difference


def equivalent_rate(xx, yy, xy, dilation):
    """Equivalent deviatoric strain rate sqrt(2/3 e':e'), 1/s."""
    third = dilation * (1.0 / 3.0)
    xx, yy = xx - third, yy - third
    zz = -(xx + yy)
    return vsqrt((2.0 / 3.0) * (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy))


@zone_pass(StrengthOf)
def strain_solid(count, given, dt, numbers, law):
    """Elastic trial, flow stress, plastic strain and radial return of a step; `law` is a `zones.strength.Strong`."""
    rows_apart()
    strong = law_of(law, numbers)
    solid, s, d, new = given.solid, given.s, given.d, given.new
    for j in range(count):
        lam = solid.lam[j]
        rate = equivalent_rate(d.xx[j], d.yy[j], d.xy[j], d.dilation[j]) if needs_rate(strong.law) else 0.0
        state = (solid.rho[j], solid.p[j], solid.temperature[j], rate)
        shear = modulus(state, solid.c2[j], lam, strong)
        rates = (d.xx[j], d.yy[j], d.xy[j], d.dilation[j], dt * d.spin[j])
        xx, yy, xy = trial_deviators((s.xx[j], s.yy[j], s.xy[j]), rates, 2.0 * shear * dt)
        square = 3.0 * (xx * xx + yy * yy + xx * yy + xy * xy)
        equivalent = vsqrt(square)
        limit, flow = yielding(equivalent, shear, state, solid.plastic_strain[j], lam, strong)
        scale = fmin(1.0, late_over(limit * equivalent, square + NO_STRESS))
        new.xx[j] = xx * scale
        new.yy[j] = yy * scale
        new.xy[j] = xy * scale
        given.shear[j] = shear
        given.limit[j] = limit
        given.flow[j] = flow


def principal(p, x, y, shear):
    """The principal stress of largest size in the plane, compression positive, of a pressure and tensions besides."""
    half = 0.5 * (x - y)
    size = vsqrt(half * half + shear * shear)
    least, most = p - 0.5 * (x + y) - size, p - 0.5 * (x + y) + size
    return most if most > -least else least


bind(trial_deviators)
bind(equivalent_rate)
bind(principal, **NAN_LAW)


@zone_pass(LargestOf)
def largest_deviator(count, given, dt, numbers, law):
    """The largest principal deviator, at which a material tears."""
    rows_apart()
    s = given.s
    for j in range(count):
        mean, apart, xy = 0.5 * (s.xx[j] + s.yy[j]), 0.5 * (s.xx[j] - s.yy[j]), s.xy[j]
        given.largest[j] = fmax(mean + vsqrt(apart * apart + xy * xy), -2.0 * mean)


@zone_pass(HeatOf)
def viscous_heat(count, given, dt, numbers, law):
    """Work of the mean viscous stress."""
    rows_apart()
    v, q, d, heat = given
    for j in range(count):
        heat[j] = -dt * v[j] * (q.xx[j] * d.xx[j] + q.yy[j] * d.yy[j] + 2.0 * q.xy[j] * d.xy[j] + q.hoop[j] * d.hoop[j])
