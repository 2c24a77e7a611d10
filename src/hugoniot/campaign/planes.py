"""What a search knows of residuals near a point: a plane fitted to a sample of runs, its least squares, and the covariance it gives.

The losses are those of `scipy.optimize.least_squares`, as functions of the squared residual, with the weights of iterated least squares.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import optimize

RANGES_KNOWN = 3.0    # standard deviation, in ranges, of a parameter of which the data say nothing
TRUST = 8.0           # rise of the sum of squares for each parameter at which a point of a sample counts half

RHO: dict[str, Callable] = {
    "linear": lambda z: z, "soft_l1": lambda z: 2.0 * (np.sqrt(1.0 + z) - 1.0),
    "huber": lambda z: np.where(z <= 1.0, z, 2.0 * np.sqrt(z) - 1.0), "cauchy": np.log1p,
}
WEIGHT: dict[str, Callable] = {
    "linear": np.ones_like, "soft_l1": lambda z: 1.0 / np.sqrt(1.0 + z), "cauchy": lambda z: 1.0 / (1.0 + z),
    "huber": lambda z: np.where(z <= 1.0, 1.0, 1.0 / np.sqrt(np.maximum(z, 1.0))),
}
LOSSES = tuple(RHO)
# mean of the weighted square z/sqrt(1 + z), min(z, sqrt z) or z/(1 + z) of a residual that is normal with the deviation given
EXPECTED = {"linear": 1.0, "soft_l1": 0.564891, "huber": 0.682689, "cauchy": 0.344320}


@dataclass(frozen=True)
class Minimum:
    """Where a search ended.

    x        coordinates of all parameters; cost the sum of squares there
    slopes   (nresidual, nparameter) of the residuals, `weight` (nresidual,) of the loss
    rough    (npoint, nresidual) how residuals near by stray from a plane, weighted so that their squares add up to the mean square
    least    the smallest sum of squares of any run near by: below `cost` where the runs answer in jumps
    """

    x: np.ndarray
    cost: float
    slopes: np.ndarray
    weight: np.ndarray
    rough: np.ndarray
    settled: bool
    least: float = math.nan


def covariance(found: "Minimum | Plane", inflated: float = 1.0) -> np.ndarray:
    """Of the coordinates: from the noise of the data (its variance times `inflated`), and from the small jumps of the runs."""
    count = found.slopes.shape[1]
    # what the data say nothing about is known to a few ranges
    normal = np.linalg.inv(found.slopes.T @ (found.weight[:, None] * found.slopes) + np.eye(count) / RANGES_KNOWN**2)
    strayed = found.rough @ (found.weight[:, None] * found.slopes) @ normal
    return inflated * normal + strayed.T @ strayed


@dataclass(frozen=True)
class Plane:
    """Residuals near a point as a plane: offset (nresidual,), slopes (nresidual, nparameter); weight and rough as of `Minimum`."""

    offset: np.ndarray
    slopes: np.ndarray
    weight: np.ndarray
    rough: np.ndarray

    @classmethod
    def nothing(cls, count: int) -> "Plane":
        return cls(np.zeros(0), np.zeros((0, count)), np.zeros(0), np.zeros((0, 0)))

    def spread(self) -> np.ndarray:
        """Standard deviations of the coordinates with the scatter of the residuals here, and with their jumps."""
        scatter = float(np.sum(self.weight * self.offset**2)) / max(self.offset.size - self.slopes.shape[1], 1)
        return np.sqrt(np.maximum(np.diag(covariance(self, max(scatter, 1.0))), 0.0))

    def step(self, x: np.ndarray, ends: tuple[np.ndarray, np.ndarray], most: np.ndarray, fixed: Sequence[int]) -> np.ndarray:
        """Where the plane has its least squares, within `most` of x and within the ends."""
        moving = [k for k in range(len(x)) if k not in fixed]
        step = np.zeros(len(x))
        if not moving:
            return step
        root = np.sqrt(self.weight)
        least, largest = np.maximum(ends[0] - x, -most)[moving], np.minimum(ends[1] - x, most)[moving]
        found = optimize.lsq_linear(root[:, None] * self.slopes[:, moving], -root * self.offset,
                                    (np.minimum(least, -1e-12), np.maximum(largest, 1e-12)))
        step[moving] = found.x
        return np.clip(x + step, *ends) - x


def through(here: np.ndarray, away: np.ndarray, found: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(offset (nresidual,), slopes (nresidual, nmoved), rough (npoint + 1, nresidual)) of the plane through a sample.

    here    (nresidual,) at the point itself
    away    (npoint, nmoved) how far the points of the sample are from it; found (npoint, nresidual) their residuals
    """
    away, found = np.vstack([np.zeros(away.shape[1]), away]), np.vstack([here, found])
    squares = np.sum(found**2, axis=1)
    scatter = max(1.0, float(squares.min()) / max(here.size, 1))
    trust = 1.0 / (1.0 + (squares - squares.min()) / (TRUST * scatter * (away.shape[1] + 1)))    # what lies beyond a jump counts little
    root = np.sqrt(trust)[:, None]
    solved = np.linalg.lstsq(root * np.column_stack([np.ones(len(away)), away]), root * found, rcond=None)[0]
    return solved[0], solved[1:].T, root / np.sqrt(np.sum(trust)) * (found - solved[0] - away @ solved[1:])
