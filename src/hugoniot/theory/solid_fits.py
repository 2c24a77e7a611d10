r"""The JWL alternative for solids (`jwl_proportional`) fitted to measured shock and particle velocities.

Shocks of the law from rest have, with $x = 1 - V = u_p/U_s$ and $p = \rho_0U_su_p$,

$$p_H = \frac{p_\Gamma(V) - p_\Gamma(1)}{1 - \tfrac12\Gamma_0x}, \qquad
  p_\Gamma = A\left(1 - \frac{\Gamma_0}{R_1}\right)e^{-R_1V} + B\left(1 - \frac{\Gamma_0}{R_2}\right)e^{-R_2V},$$

which is linear in A and B. For every trial of the exponents A and B follow by linear least squares, and only R1 and R2 are searched, from
several starts. The misfit is relative in pressure. The source finds the form poor for linear Hugoniots. The root-mean-square misfits up to
particle velocities of 2, 5 and 10 km/s are 0.01, 0.15 and 0.7 % for copper, 0.002, 0.05 and 0.3 % for aluminium, and 0.3, 2 and 5 % for
water (s = 2).

Source: Starkenberg A-10.5, with the Hugoniot of S-E12.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.jwl_proportional import JWLProportional

STARTS = ((6.0, 0.6), (11.0, 1.1), (15.0, 3.0), (20.0, 1.5))
WIDEST = (0.05, 60.0)     # of the exponents


class SolidFit(NamedTuple):
    """par: the law; deviation: root mean square of the relative misfit in pressure; worst: largest; highest: up that was fitted, m/s.

    at_bounds: exponents that ended where the search did.
    """

    par: JWLProportional
    deviation: float
    worst: float
    highest: float
    at_bounds: tuple[str, ...] = ()


def fit_solid(rho0: float, gamma0: float, up, us) -> SolidFit:
    """Constants of `jwl_proportional` from (up, us), m/s, above rest. Raises `OutOfRange` for fewer than six usable points."""
    up, us = np.asarray(up, float), np.asarray(us, float)
    usable = (up > 0.0) & (us > up) & np.isfinite(up * us)
    if np.unique(up[usable]).size < 6:
        raise OutOfRange(f"a fit of four constants with a standard deviation needs 6 different particle velocities above 0, got "
                         f"{np.unique(up[usable]).size}")
    x, p = (up / us)[usable], (rho0 * us * up)[usable]
    if not 0.5 * gamma0 * float(x.max()) < 1.0:
        raise OutOfRange(f"gamma0 = {gamma0:g} is too large for these points: the Hugoniot would have its pole at up/us = 2/gamma0 = "
                         f"{2.0 / gamma0:.4g}, and the points reach {float(x.max()):.4g}")

    def columns(r):
        return np.column_stack([(1.0 - gamma0 / k) * (np.exp(-k * (1.0 - x)) - np.exp(-k)) / (1.0 - 0.5 * gamma0 * x) / p for k in r])

    def constants(r):
        return np.linalg.lstsq(columns(r), np.ones_like(p), rcond=None)[0]

    def misfit(logarithms):
        r = np.exp(logarithms)
        return columns(r) @ constants(r) - 1.0

    bounds = np.log(WIDEST[0]) * np.ones(2), np.log(WIDEST[1]) * np.ones(2)
    tried = [least_squares(misfit, np.log(start), bounds=bounds, xtol=1e-12, ftol=1e-12) for start in STARTS]
    best = min(tried, key=lambda found: found.cost)
    r = np.sort(np.exp(best.x))[::-1]
    a, b = constants(r)
    left = columns(r) @ np.array([a, b]) - 1.0
    return SolidFit(JWLProportional(float(a), float(b), float(r[0]), float(r[1]), gamma0, rho0), float(np.sqrt(np.mean(left**2))),
                    float(np.max(np.abs(left))), float(up[usable].max()),
                    tuple(f"R = {k:.3g}" for k in r if not 1.01 * WIDEST[0] < k < WIDEST[1] / 1.01))
