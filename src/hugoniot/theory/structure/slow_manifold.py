r"""The trajectory inside a shock as a curve h(w), by Chebyshev collocation: the method for weak shocks and strong conductors.

Where one of the two growth rates at the upstream end is many times the other, the equations are stiff along x, but the trajectory itself is
a smooth curve between the two ends (the slow manifold). With y from 0 (upstream) to 1 and $g(y) = y(1-y)\,q(y)$ it satisfies

$$g_\xi(y, g) - g'(y)\,y_\xi(y, g) = 0,$$

which is solved by Newton's method for a polynomial q at Chebyshev points; the error falls exponentially with their number. One smooth
equation, $y_\xi(y, g(y))$, remains for the position. At the upstream end the curve has a singular part $y^r$, with r the ratio of the
rates, which is negligible for large r.
"""

import numpy as np
from numpy.polynomial import chebyshev

from hugoniot.errors import NoSolution

_SIZES = (12, 24, 48, 96)
_STEP = 1e-6
_SLOW = 0.02   # ratio of the last coefficients after twice as many points: a smooth curve falls far below, a kink gives a fifth


def slow_manifold(rates, tolerance: float):
    """g as a function of y in [0, 1], from `rates(xi, (y, g, 0, 0)) -> (y_xi, g_xi, ...)`; relative tolerance of its coefficients."""
    q, tail = None, np.inf
    for n in _SIZES:
        s = np.cos(np.pi * (np.arange(n) + 0.5) / n)
        guess = _quasi_steady(rates, 0.5 * (s + 1.0)) if q is None else chebyshev.chebval(s, q)
        values, converged = _newton(rates, s, guess, max(tolerance, 1e-8))
        if not converged:
            continue
        q = chebyshev.chebfit(s, values, n - 1)
        before, tail = tail, np.abs(q[-3:]).max() / np.abs(q).max()
        if tail <= tolerance:
            return lambda y, q=q: y * (1.0 - y) * float(chebyshev.chebval(2.0 * y - 1.0, q))
        if tail > _SLOW * before:
            break
    raise NoSolution("no smooth profile was found for this shock, whose equations are stiff; check that viscosity and conductivity vary "
                     "smoothly between the states ahead of and behind it")


def _quasi_steady(rates, y):
    """q where conduction has come to balance: g that makes g_xi vanish, to first order about g = 0."""
    found = []
    for a in y.tolist():
        up, zero = rates(0.0, (a, _STEP, 0.0, 0.0))[1], rates(0.0, (a, 0.0, 0.0, 0.0))[1]
        found.append(-zero * _STEP / (up - zero) / (a * (1.0 - a)))
    return np.array(found)


def _newton(rates, s, q, near: float):
    """Values of q at the points s after Newton's method; whether it converged: to round-off, or to `near` and no further."""
    y = 0.5 * (s + 1.0)
    bubble, slope = y * (1.0 - y), 1.0 - 2.0 * y
    n = len(s)
    vander = chebyshev.chebvander(s, n - 1)
    derivative = np.linalg.solve(vander.T, np.array([chebyshev.chebval(s, chebyshev.chebder(row)) for row in np.eye(n)])).T * 2.0
    operator = np.diag(slope) + bubble[:, None] * derivative  # dg/dy from q
    last = np.inf
    for _ in range(30):
        g = bubble * q
        table = np.array([[rates(0.0, (a, b + d, 0.0, 0.0))[:2] for d in (0.0, _STEP, -_STEP)] for a, b in zip(y.tolist(), g.tolist())])
        here, partial = table[:, 0], (table[:, 1] - table[:, 2]) / (2.0 * _STEP)
        gradient = operator @ q
        residual = here[:, 1] - gradient * here[:, 0]
        matrix = np.diag((partial[:, 1] - gradient * partial[:, 0]) * bubble) - here[:, :1] * operator
        change = np.linalg.solve(matrix, -residual)
        size = np.abs(change).max() / np.abs(q).max()
        if size > 1.0:
            change /= 2.0 * size
        q = q + change
        if not np.isfinite(size):
            return q, False
        if size < 1e-13 or (last < near and size >= 0.5 * last):
            return q, True
        last = size
    return q, last < near
