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
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.layout import Rates, Stress, Tensor

NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


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


class HeatOf(NamedTuple):
    """Specific volume, mean viscous stress, strain rates -> heat, J/kg."""

    v: Any
    q: Stress
    d: Rates
    heat: Any


@zone_pass(TrialOf)
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


@zone_pass(ReturnOf)
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


@zone_pass(RateOf)
def strain_rates(count, given, dt, numbers, law):
    """Equivalent deviatoric strain rate sqrt(2/3 e':e'), 1/s."""
    rows_apart()
    d, rate = given
    for j in range(count):
        third = d.dilation[j] * (1.0 / 3.0)
        xx, yy, xy = d.xx[j] - third, d.yy[j] - third, d.xy[j]
        zz = -(xx + yy)
        rate[j] = vsqrt((2.0 / 3.0) * (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy))


@zone_pass(HeatOf)
def viscous_heat(count, given, dt, numbers, law):
    """Work of the mean viscous stress."""
    rows_apart()
    v, q, d, heat = given
    for j in range(count):
        heat[j] = -dt * v[j] * (q.xx[j] * d.xx[j] + q.yy[j] * d.yy[j] + 2.0 * q.xy[j] * d.xy[j] + q.hoop[j] * d.hoop[j])
