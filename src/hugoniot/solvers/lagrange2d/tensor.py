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
from hugoniot.solvers.lagrange2d.layout import Rates, Stress, Tensor, Work, Zones
from hugoniot.solvers.lagrange2d.row_pass import row_pass

NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


class StartOf(NamedTuple):
    """State -> the stress that pushes."""

    z: Zones
    t: Stress


class MiddleOf(NamedTuple):
    """Scratch of the middle of a step and mean viscous stress -> the stress that pushes."""

    w: Work
    q: Tensor
    t: Stress


class TrialOf(NamedTuple):
    """State and strain rates -> elastic deviators in the scratch rows."""

    z: Zones
    w: Work
    d: Rates


class WorkOf(NamedTuple):
    """Scratch rows alone."""

    w: Work


class RateOf(NamedTuple):
    """Strain rates -> equivalent rate."""

    d: Rates
    rate: Any


class KeepOf(NamedTuple):
    """Scratch rows -> state."""

    z: Zones
    w: Work



@row_pass(StartOf)
def stress_at_start(count, given, dt, numbers, law):
    """Stress that pushes at the start of a step: that of the state, and the viscous stress of the step before."""
    rows_apart()
    z, t = given
    for j in range(count):
        p, xx, yy = z.p[j], z.sxx[j], z.syy[j]
        t.xx[j] = xx - p - z.qxx[j]
        t.yy[j] = yy - p - z.qyy[j]
        t.xy[j] = z.sxy[j] - z.qxy[j]
        t.hoop[j] = -(xx + yy) - p


@row_pass(MiddleOf)
def stress_in_middle(count, given, dt, numbers, law):
    """Stress that pushes in the middle of the step; q: mean viscous stress of the zone."""
    rows_apart()
    w, q, t = given
    for j in range(count):
        p, xx, yy = w.p[j], w.txx[j], w.tyy[j]
        t.xx[j] = xx - p - q.xx[j]
        t.yy[j] = yy - p - q.yy[j]
        t.xy[j] = w.txy[j] - q.xy[j]
        t.hoop[j] = -(xx + yy) - p


@row_pass(TrialOf)
def trial(count, given, dt, numbers, law):
    """Deviators of the elastic trial after dt, turned with the zone, and their equivalent stress sqrt(3/2 s:s)."""
    rows_apart()
    z, w, d = given
    for j in range(count):
        half = 0.5 * dt * d.spin[j]
        a = 2.0 * half / (1.0 - half * half)
        double = 2.0 * w.shear[j] * dt
        third = d.dilation[j] * (1.0 / 3.0)
        xx, yy, xy = z.sxx[j], z.syy[j], z.sxy[j]
        difference, shear = xx - yy, 2.0 * xy
        d_difference, d_shear = double * (d.xx[j] - d.yy[j]), 2.0 * double * d.xy[j]
        over = 1.0 / (1.0 + a * a)
        same = 1.0 - a * a
        total = 0.5 * (xx + yy + double * (d.xx[j] + d.yy[j] - 2.0 * third))
        turned = 0.5 * over * (same * difference - 2.0 * a * shear + d_difference - a * d_shear)
        txy = 0.5 * over * (same * shear + 2.0 * a * difference + d_shear + a * d_difference)
        txx, tyy = total + turned, total - turned
        w.txx[j] = txx
        w.tyy[j] = tyy
        w.txy[j] = txy
        w.equivalent[j] = vsqrt(3.0 * (txx * txx + tyy * tyy + txx * tyy + txy * txy))


@row_pass(WorkOf)
def return_to_yield(count, given, dt, numbers, law):
    """Deviators back on the yield surface of `limit`, radially, and the largest principal one."""
    rows_apart()
    w = given.w
    for j in range(count):
        square = w.equivalent[j] * w.equivalent[j]
        scale = fmin(1.0, late_over(w.limit[j] * w.equivalent[j], square + NO_STRESS))
        xx, yy, xy = w.txx[j] * scale, w.tyy[j] * scale, w.txy[j] * scale
        w.txx[j] = xx
        w.tyy[j] = yy
        w.txy[j] = xy
        half = 0.5 * (xx - yy)
        w.t1[j] = fmax(0.5 * (xx + yy) + vsqrt(half * half + xy * xy), -(xx + yy))


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


@row_pass(WorkOf)
def no_deviators(count, given, dt, numbers, law):
    """A fluid."""
    rows_apart()
    w = given.w
    for j in range(count):
        w.txx[j] = 0.0
        w.tyy[j] = 0.0
        w.txy[j] = 0.0
        w.t1[j] = 0.0
        w.shear[j] = 0.0


@row_pass(KeepOf)
def keep(count, given, dt, numbers, law):
    """The deviators become those of the state; the principal stress of largest size goes with it."""
    rows_apart()
    z, w = given
    for j in range(count):
        xx, yy, xy = w.txx[j], w.tyy[j], w.txy[j]
        z.sxx[j] = xx
        z.syy[j] = yy
        z.sxy[j] = xy
        x, y, p = xx - z.qxx[j], yy - z.qyy[j], z.p[j]
        shear = xy - z.qxy[j]
        half = 0.5 * (x - y)
        size = vsqrt(half * half + shear * shear)
        low, high = p - 0.5 * (x + y) - size, p - 0.5 * (x + y) + size
        z.sigma[j] = high if high > -low else low
