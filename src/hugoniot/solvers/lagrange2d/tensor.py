r"""Stress of a zone in the plane: what the forces see, the elastic trial with its rotation, the return to the yield surface.

Deviators are $s_{xx}, s_{yy}, s_{xy}$ and $s_\theta = -(s_{xx} + s_{yy})$. The Jaumann rate is solved by Crank-Nicolson: with
$D = s_{xx} - s_{yy}$, $S = 2 s_{xy}$ and a turn of angle $\vartheta$ in the step, $a = \tan\vartheta$,

$$D' = \frac{(1-a^2)D - 2aS + dD - a\,dS}{1+a^2},\qquad S' = \frac{(1-a^2)S + 2aD + dS + a\,dD}{1+a^2},$$

which keeps $D^2 + S^2$ in a rigid turn (Herrmann's lost equations B.26, B.29; H-E9). The spin in the middle of a step of a rigid turn is
$w = 2\tan(\vartheta/2)/dt$, so that $a = w\,dt/(1 - (w\,dt/2)^2)$ turns the stress by the very angle of the zone.

Source: Herrmann, WL-TR-64-107, B.16 to B.32.
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import fmax, fmin, late_over, vsqrt
from hugoniot.core.passes import rows_apart
from hugoniot.solvers.lagrange2d.layout import Rates, Stress, Tensor
from hugoniot.solvers.lagrange2d.row_pass import row_pass

NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


class StartOf(NamedTuple):
    """Pressure, deviators and mean viscous stress of the state -> the stress that pushes."""

    p: Any
    s: Tensor
    q: Stress
    t: Stress


class TrialOf(NamedTuple):
    """Deviators, shear modulus and strain rates -> elastic deviators and their equivalent stress."""

    s: Tensor
    shear: Any
    d: Rates
    new: Tensor
    equivalent: Any


class ReturnOf(NamedTuple):
    """Equivalent and flow stress; deviators are led on -> the largest principal one."""

    equivalent: Any
    limit: Any
    new: Tensor
    largest: Any


class RateOf(NamedTuple):
    """Strain rates -> equivalent rate."""

    d: Rates
    rate: Any


class KeepOf(NamedTuple):
    """Pressure, mean viscous stress and deviators found -> those of the state, the principal stress of largest size."""

    p: Any
    q: Stress
    new: Tensor
    s: Tensor
    sigma: Any


@row_pass(StartOf)
def pushing_stress(count, given, dt, numbers, law):
    """Stress that pushes: pressure, viscous stress and deviators."""
    rows_apart()
    p_, s, q, t = given
    for j in range(count):
        p, xx, yy = p_[j], s.xx[j], s.yy[j]
        t.xx[j] = xx - p - q.xx[j]
        t.yy[j] = yy - p - q.yy[j]
        t.xy[j] = s.xy[j] - q.xy[j]
        t.hoop[j] = -(xx + yy) - p - q.hoop[j]


@row_pass(TrialOf)
def trial(count, given, dt, numbers, law):
    """Deviators of the elastic trial after dt, turned with the zone, and their equivalent stress sqrt(3/2 s:s)."""
    rows_apart()
    s, shear_modulus, d, new, equivalent = given
    for j in range(count):
        half = 0.5 * dt * d.spin[j]
        a = 2.0 * half / (1.0 - half * half)
        double = 2.0 * shear_modulus[j] * dt
        third = d.dilation[j] * (1.0 / 3.0)
        xx, yy, xy = s.xx[j], s.yy[j], s.xy[j]
        difference, shear = xx - yy, 2.0 * xy
        d_difference, d_shear = double * (d.xx[j] - d.yy[j]), 2.0 * double * d.xy[j]
        over = 1.0 / (1.0 + a * a)
        same = 1.0 - a * a
        total = 0.5 * (xx + yy + double * (d.xx[j] + d.yy[j] - 2.0 * third))
        turned = 0.5 * over * (same * difference - 2.0 * a * shear + d_difference - a * d_shear)
        txy = 0.5 * over * (same * shear + 2.0 * a * difference + d_shear + a * d_difference)
        txx, tyy = total + turned, total - turned
        new.xx[j] = txx
        new.yy[j] = tyy
        new.xy[j] = txy
        equivalent[j] = vsqrt(3.0 * (txx * txx + tyy * tyy + txx * tyy + txy * txy))


@row_pass(ReturnOf)
def return_to_yield(count, given, dt, numbers, law):
    """Deviators back on the yield surface of `limit`, radially, and the largest principal one."""
    rows_apart()
    equivalent, limit, new, largest = given
    for j in range(count):
        square = equivalent[j] * equivalent[j]
        scale = fmin(1.0, late_over(limit[j] * equivalent[j], square + NO_STRESS))
        xx, yy, xy = new.xx[j] * scale, new.yy[j] * scale, new.xy[j] * scale
        new.xx[j] = xx
        new.yy[j] = yy
        new.xy[j] = xy
        half = 0.5 * (xx - yy)
        largest[j] = fmax(0.5 * (xx + yy) + vsqrt(half * half + xy * xy), -(xx + yy))


@row_pass(RateOf)
def strain_rates(count, given, dt, numbers, law):
    """Equivalent deviatoric strain rate sqrt(2/3 e':e'), 1/s."""
    rows_apart()
    d, rate = given
    for j in range(count):
        third = d.dilation[j] * (1.0 / 3.0)
        xx, yy, xy = d.xx[j] - third, d.yy[j] - third, d.xy[j]
        zz = -(xx + yy)
        rate[j] = vsqrt((2.0 / 3.0) * (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy))


@row_pass(KeepOf)
def keep(count, given, dt, numbers, law):
    """The deviators become those of the state; the principal stress of largest size, compression positive, goes with it."""
    rows_apart()
    p_, q, new, s, sigma = given
    for j in range(count):
        xx, yy, xy = new.xx[j], new.yy[j], new.xy[j]
        s.xx[j] = xx
        s.yy[j] = yy
        s.xy[j] = xy
        x, y, p = xx - q.xx[j], yy - q.yy[j], p_[j]
        shear = xy - q.xy[j]
        half = 0.5 * (x - y)
        size = vsqrt(half * half + shear * shear)
        low, high = p - 0.5 * (x + y) - size, p - 0.5 * (x + y) + size
        sigma[j] = high if high > -low else low
