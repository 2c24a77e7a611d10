"""Artificial viscosity of a zone: its signal speed, the jump it resists, the smoothness that switches it off."""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.viscosity.contract import viscous_speed

SMALL = 1e-30


class SpeedRows(NamedTuple):
    """v (m3/kg), c (m/s), p (Pa), squeeze (the jump that is resisted, m/s), smooth (0 to 1) -> speed (m/s): q = rho |squeeze| speed."""

    v: Any
    c: Any
    p: Any
    squeeze: Any
    smooth: Any
    speed: Any


class SpeedsRows(NamedTuple):
    """v, c, p, squeeze -> speed, as of a zone that is not smooth; end_v -> weak, the speed of the quadratic part alone."""

    v: Any
    c: Any
    p: Any
    squeeze: Any
    end_v: Any
    speed: Any
    weak: Any


def resisted(du, growth, two_sided):
    """The velocity jump an artificial viscosity resists: 0 unless the zone narrows and shrinks (`growth` < 0), but for two-sided laws."""
    return du if two_sided else fmin(du if growth < 0.0 else 0.0, 0.0)


def smoothness(left, own, right):
    """1 where the velocity gradient (1/s) is that of its neighbours, 0 at a shock or an extremum.

    Ratios of the neighbours' gradients to this one (Caramana, Shashkov and Whalen 1998, J. Comput. Phys. 144, 70).
    """
    steep, before, behind = -own, -left, -right
    smooth = fmax(0.0, fmin(fmin(0.5 * (before + behind), steep), 2.0 * fmin(before, behind)))
    return fmin(smooth / (fmax(steep, 0.0) + SMALL), 1.0)


@zone_pass(SpeedRows)
def speed_pass(count, z, dt, numbers, law):
    rows_apart()
    viscosity = law_of(law, numbers)
    for j in range(count):
        speed = viscous_speed(z.v[j], z.c[j], z.p[j], z.squeeze[j], z.smooth[j], viscosity)
        z.speed[j] = speed if z.squeeze[j] != 0.0 else 0.0


@zone_pass(SpeedsRows)
def speeds_pass(count, z, dt, numbers, law):
    rows_apart()
    viscosity = law_of(law, numbers)
    for j in range(count):
        squeeze = z.squeeze[j]
        speed = viscous_speed(z.v[j], z.c[j], z.p[j], squeeze, 0.0, viscosity)
        weak = viscous_speed(z.end_v[j], 0.0, 0.0, squeeze, 0.0, viscosity)
        z.speed[j] = speed if squeeze != 0.0 else 0.0
        z.weak[j] = weak if squeeze != 0.0 else 0.0


bind(resisted)
bind(smoothness)
