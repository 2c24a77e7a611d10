r"""A Gaussian process through some answers of runs: a smooth guess of a number between the runs, with its error by leaving runs out.

The values at points x of the unit cube's size have the covariance

$$k(x, x') = b^2\,(1 + x \cdot x') + a^2 \left(1 + \sqrt5\,r + \tfrac53 r^2\right) e^{-\sqrt5\,r} + s^2\,\delta_{xx'},
\qquad r^2 = \sum_k \frac{(x_k - x'_k)^2}{l_k^2}$$

a broad straight line, Matern's function of order 5/2, and what jumps from run to run. The lengths l, a and s are those of the largest
marginal likelihood. The error of leaving one run out needs no further fit: with $\alpha = K^{-1} y$ the prediction from all the others
misses y_i by $\alpha_i / (K^{-1})_{ii}$.

Source: C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for Machine Learning (MIT Press, 2006), eqs. (2.25), (2.26), (4.17), (5.8),
(5.9), (5.12).
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy import linalg, optimize

STRAIGHT = 3.0                     # b, in standard deviations of the values
LENGTHS = math.log(0.1), math.log(50.0)
HEIGHTS = math.log(1e-3), math.log(30.0)
JUMPS = math.log(1e-5), math.log(1.0)
_ROOT5 = math.sqrt(5.0)


@dataclass(frozen=True)
class Process:
    """A Gaussian process through values at points.

    points   (n, d), each coordinate from about -1 to 1
    middle, scale   of the values, which are worked with as (value - middle) / scale
    theta    logarithms of the d lengths, of a and of s
    lower    Cholesky factor of the covariance of the values; `alpha` the covariance's inverse times the values
    """

    points: np.ndarray
    middle: float
    scale: float
    theta: np.ndarray
    lower: np.ndarray
    alpha: np.ndarray

    def mean(self, at: np.ndarray) -> np.ndarray:
        """The expected values (m,) at points (m, d)."""
        return self.middle + self.scale * (_smooth(self.theta, at, self.points) @ self.alpha)

    def deviation(self, at: np.ndarray) -> np.ndarray:
        """Standard deviation (m,) of what a run would answer at points (m, d), jumps included."""
        towards = _smooth(self.theta, at, self.points)
        height, jump = np.exp(2.0 * self.theta[-2:])
        own = STRAIGHT**2 * (1.0 + np.sum(at**2, axis=1)) + height + jump
        known = np.sum(linalg.solve_triangular(self.lower, towards.T, lower=True) ** 2, axis=0)
        return self.scale * np.sqrt(np.maximum(own - known, 0.0))

    def left_out(self) -> np.ndarray:
        """(n,) value minus what the other runs predict for it."""
        inverse = linalg.cho_solve((self.lower, True), np.eye(len(self.points)))
        return self.scale * self.alpha / np.diag(inverse)


def process_through(points: np.ndarray, values: np.ndarray) -> Process:
    """The process of largest marginal likelihood through values (n,) at points (n, d)."""
    points, values = np.asarray(points, dtype=float), np.asarray(values, dtype=float)
    middle, scale = float(values.mean()), float(values.std())
    scale = scale if scale > 0.0 else 1.0
    wanted, count = (values - middle) / scale, points.shape[1]
    ends = [LENGTHS] * count + [HEIGHTS, JUMPS]
    starts = [[math.log(length)] * count + [0.0, math.log(jump)] for length, jump in ((1.0, 0.1), (4.0, 1e-3))]
    found = min((optimize.minimize(_surprise, start, (points, wanted), jac=True, bounds=ends, method="L-BFGS-B") for start in starts),
                key=lambda each: each.fun)
    lower = linalg.cholesky(_covariance(found.x, points)[0], lower=True)
    return Process(points, middle, scale, found.x, lower, linalg.cho_solve((lower, True), wanted))


def _smooth(theta: np.ndarray, here: np.ndarray, there: np.ndarray) -> np.ndarray:
    """The covariance without jumps between points (m, d) and (n, d), (m, n)."""
    apart = (here[:, None, :] - there) * np.exp(-theta[:-2])
    r = np.sqrt(5.0 * np.einsum("mnd,mnd->mn", apart, apart))
    return STRAIGHT**2 * (1.0 + here @ there.T) + math.exp(2.0 * theta[-2]) * (1.0 + r + r**2 / 3.0) * np.exp(-r)


def _covariance(theta: np.ndarray, points: np.ndarray):
    """(covariance of the values (n, n), its derivatives to theta (d + 2, n, n))."""
    squares = 5.0 * np.moveaxis(((points[:, None, :] - points) * np.exp(-theta[:-2])) ** 2, 2, 0)
    r = np.sqrt(squares.sum(axis=0))
    fall = math.exp(2.0 * theta[-2]) * np.exp(-r)
    matern, jumps = fall * (1.0 + r + r**2 / 3.0), math.exp(2.0 * theta[-1]) * np.eye(len(points))
    slopes = fall * (1.0 + r) / 3.0 * squares
    return STRAIGHT**2 * (1.0 + points @ points.T) + matern + jumps, np.concatenate([slopes, [2.0 * matern, 2.0 * jumps]])


def _surprise(theta: np.ndarray, points: np.ndarray, wanted: np.ndarray) -> tuple[float, np.ndarray]:
    """Minus the logarithm of the marginal likelihood, and its gradient."""
    whole, slopes = _covariance(np.asarray(theta), points)
    try:
        lower = linalg.cholesky(whole, lower=True)
    except linalg.LinAlgError:
        return 1e25, np.zeros(len(theta))
    inverse = linalg.cho_solve((lower, True), np.eye(len(points)))
    alpha = inverse @ wanted
    value = 0.5 * wanted @ alpha + np.sum(np.log(np.diag(lower))) + 0.5 * len(points) * math.log(2.0 * math.pi)
    gradient = 0.5 * np.einsum("ij,kij->k", inverse - np.outer(alpha, alpha), slopes)
    return float(value), gradient
