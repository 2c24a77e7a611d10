r"""Burn times of programmed-burn explosives: the shortest path of a front that runs at a given speed (Kenamond's problems).

1. One explosive, one or more detonators: $t(x) = \min_k\left[t_k + |x - x_k|/D\right]$.
2. A fast explosive in a ball of radius R (speed D_1) inside a slow one (D_2), lit at the centre and at detonators outside: from the
   centre $t = r/D_1$ or $R/D_1 + (r-R)/D_2$; a detonator outside lights the slow explosive along straight lines (its line of
   sight; the data must be such that the ball burns from its centre first, which is checked).
3. An inert ball of radius R in an explosive: beyond the shadow line the path is a tangent, an arc, a tangent,

$$t = \frac1D\left[\sqrt{r_d^2 - R^2} + \sqrt{r^2 - R^2} + R\left(\theta - \arccos\frac{R}{r_d} - \arccos\frac{R}{r}\right)\right]$$

where theta is the angle between detonator and point seen from the centre. If the straight line to the detonator is clear, t is the distance
over D.

Source: Kenamond, HE burn-table verification problems (LA-UR-11-03096); ExactPack's kenamond1 to 3; paths re-derived.
"""

import numpy as np

from hugoniot.errors import OutOfRange


def _distance(points, place):
    return np.linalg.norm(points - np.asarray(place, float), axis=-1)


def single(points, detonation_velocity: float = 2.0, detonators=((0.0, 0.0, 0.0),), times=(0.0,)) -> np.ndarray:
    """Burn time at an array of points (last axis: 2 or 3 coordinates) of one explosive with any number of detonators."""
    points = np.asarray(points, float)
    arrivals = [t + _distance(points, np.asarray(x)[: points.shape[-1]]) / detonation_velocity for x, t in zip(detonators, times)]
    return np.min(arrivals, axis=0)


def nested(points, radius: float = 3.0, inner_velocity: float = 2.0, outer_velocity: float = 1.0, detonators=((0.0, 5.0), (0.0, -5.0)),
           times=(2.0, 2.0)) -> np.ndarray:
    """Burn time with a fast ball of `radius` about the origin, lit at its centre at time 0, and detonators outside it.

    Raises OutOfRange where an outside detonator would light the ball before its own front arrives: then paths refract at the ball and
    this solution does not hold.
    """
    points = np.asarray(points, float)
    if inner_velocity < outer_velocity:
        raise OutOfRange("the inner explosive must be the faster one")
    r = np.linalg.norm(points, axis=-1)
    best = np.where(r <= radius, r / inner_velocity, radius / inner_velocity + (r - radius) / outer_velocity)
    for place, time in zip(detonators, times):
        gap = float(np.linalg.norm(place)) - radius
        if gap <= 0.0 or time + gap / outer_velocity < radius / inner_velocity:
            raise OutOfRange(f"the detonator at {tuple(place)} lights the inner explosive before its own front; choose a later time")
        best = np.where(r > radius, np.minimum(best, time + _shadowed(points, np.asarray(place, float), radius) / outer_velocity), best)
    return best


def obstacle(points, detonation_velocity: float = 2.0, radius: float = 3.0, detonator=(0.0, 5.0)) -> np.ndarray:
    """Burn time around an inert ball of `radius` about the origin; NaN inside it."""
    points = np.asarray(points, float)
    place = np.asarray(detonator, float)
    if np.linalg.norm(place) < radius:
        raise OutOfRange("the detonator lies inside the inert ball")
    time = _shadowed(points, place, radius) / detonation_velocity
    return np.where(np.linalg.norm(points, axis=-1) < radius * (1.0 - 1e-12), np.nan, time)


def _shadowed(points, place, radius):
    """Length of the shortest path from `place` to points outside the ball of `radius` about the origin."""
    r, away = np.linalg.norm(points, axis=-1), np.linalg.norm(place)
    outside = np.maximum(r, radius)
    with np.errstate(divide="ignore", invalid="ignore"):
        angle = np.arccos(np.clip(points @ place / (r * away), -1.0, 1.0))
    angle = np.where(r > 0.0, angle, 0.0)
    arc = angle - np.arccos(radius / away) - np.arccos(radius / outside)
    around = np.sqrt(away**2 - radius**2) + np.sqrt(outside**2 - radius**2) + radius * arc
    return np.where(arc <= 0.0, _distance(points, place), around)


def kenamond() -> dict[str, object]:
    """Burn-time functions by problem: 1 one explosive, 2 nested explosives, 3 inert obstacle."""
    return {"1": single, "2": nested, "3": obstacle}
