r"""Burn times of programmed burns: when a detonation front of constant speed reaches each point (Kenamond's problems).

They test the lighting times of a code: several detonators, two explosives of different speed, and a front that bends around an obstacle.
The front reaches a point along the path of least time. Let $\mathbf x$ be a point, $r$ its distance from the origin, and $\mathbf x_k$ and
$t_k$ the position and the lighting time of detonator $k$.

**Problem 1**: one explosive of detonation velocity $D$, any number of detonators.

$$t = \min_k\left[t_k + \frac{|\mathbf x - \mathbf x_k|}{D}\right]$$

**Problem 2**: a ball of radius $R$ about the origin, of an explosive with velocity $D_1$, in an explosive with the lower velocity $D_2$.
It is lit at its centre at $t = 0$; further detonators lie outside. The front from the centre arrives at

$$t = \frac{r}{D_1} \;(r \le R), \qquad t = \frac{R}{D_1} + \frac{r-R}{D_2} \;(r > R)$$

and a detonator outside lights the outer explosive along the shortest path that does not enter the ball. The earliest front counts. The
ball must burn from its centre. A detonator outside that would light it first is not supported, because its front would be refracted at
the ball.

**Problem 3**: an inert ball of radius $R$ about the origin in an explosive of detonation velocity $D$, with one detonator at the distance
$r_d$ from the origin. In the shadow of the ball the path consists of a tangent, an arc and a tangent,

$$t = \frac1D\left[\sqrt{r_d^2 - R^2} + \sqrt{r^2 - R^2} + R\left(\theta - \arccos\frac{R}{r_d} - \arccos\frac{R}{r}\right)\right]$$

where $\theta$ is the angle between the detonator and the point, seen from the origin. Where the straight line to the detonator is clear,
$t$ is its length divided by $D$.

Source: Kenamond, HE burn-table verification problems (LA-UR-11-03096); ExactPack's kenamond1 to 3; paths derived for this project.
"""

import numpy as np

from hugoniot.errors import OutOfRange


def _distance(points, place):
    return np.linalg.norm(points - np.asarray(place, float), axis=-1)


def single(points, detonation_velocity: float = 2.0, detonators=((0.0, 0.0, 0.0),), times=(0.0,)) -> np.ndarray:
    """One explosive with any number of detonators: burn times in s.

    points                positions, 2 or 3 coordinates each, in the last axis of an array
    detonation_velocity   detonation velocity D
    detonators            positions of the detonators, 2 or 3 coordinates each
    times                 lighting time of each detonator
    """
    points = np.asarray(points, float)
    arrivals = [t + _distance(points, np.asarray(x)[: points.shape[-1]]) / detonation_velocity for x, t in zip(detonators, times)]
    return np.min(arrivals, axis=0)


def nested(points, radius: float = 3.0, inner_velocity: float = 2.0, outer_velocity: float = 1.0, detonators=((0.0, 5.0), (0.0, -5.0)),
           times=(2.0, 2.0)) -> np.ndarray:
    """A ball of fast explosive in a slower one, lit at its centre at time 0 and by detonators outside: burn times in s.

    points           positions, 2 or 3 coordinates each, in the last axis of an array
    radius           radius R of the ball
    inner_velocity   detonation velocity D_1 of the ball
    outer_velocity   detonation velocity D_2 outside, not above D_1
    detonators       positions of the detonators outside the ball
    times            lighting time of each of them

    Not supported (OutOfRange): a detonator outside that would light the ball before the front from its centre arrives.
    """
    points = np.asarray(points, float)
    if inner_velocity < outer_velocity:
        raise OutOfRange("the inner explosive must have the higher detonation velocity")
    r = np.linalg.norm(points, axis=-1)
    best = np.where(r <= radius, r / inner_velocity, radius / inner_velocity + (r - radius) / outer_velocity)
    for place, time in zip(detonators, times):
        gap = float(np.linalg.norm(place)) - radius
        if gap <= 0.0 or time + gap / outer_velocity < radius / inner_velocity:
            raise OutOfRange(f"the front of the detonator at {tuple(place)} m reaches the inner explosive before the front from its "
                             "centre does; choose a later time")
        best = np.where(r > radius, np.minimum(best, time + _shadowed(points, np.asarray(place, float), radius) / outer_velocity), best)
    return best


def obstacle(points, detonation_velocity: float = 2.0, radius: float = 3.0, detonator=(0.0, 5.0)) -> np.ndarray:
    """An explosive with an inert ball and one detonator: burn times in s, not a number (NaN) inside the ball.

    points                positions, 2 or 3 coordinates each, in the last axis of an array
    detonation_velocity   detonation velocity D
    radius                radius R of the ball
    detonator             position of the detonator
    """
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
    """Burn times around several detonators (problem=1), in nested explosives (problem=2) and behind an inert obstacle (problem=3).

    The points are given with --at, or the burn times are drawn with --plot:

        hugoniot exact kenamond problem=2 --at "0, 4 m; 3 m, 2 m"

    In Python `SOLUTIONS["kenamond"]()` of `hugoniot.theory.exact` returns the functions of the three problems under the keys "1", "2" and
    "3". Each takes an array of points and the parameters of its problem.
    """
    return {"1": single, "2": nested, "3": obstacle}
