"""The states at inner faces that are no fronts, compiled: the HLLC problem of the states on both sides, read off at the speed of the face.

Source: Toro, Riemann Solvers, section 10.4.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.fronts.cells.solids import is_solid
from hugoniot.solvers.fronts.cells.tables import F_E, F_P, F_RHO, F_U, INTO_LEFT, INTO_RIGHT, LAM, LEFT, RIGHT, SPEED, VOLUME, C, E, P, U


@nb.njit(**BY_ADDRESS)
def hllc(grid, rules, work, n):
    """The HLLC state at inner faces, which move at the speeds of the table."""
    w = work.w
    for f in range(1, n):
        i = f - 1
        rl, ul, el, pl, cl = w[RIGHT, i], w[RIGHT + U, i], w[RIGHT + E, i], w[RIGHT + P, i], w[RIGHT + C, i]
        rr, ur, er, pr, cr = w[LEFT, f], w[LEFT + U, f], w[LEFT + E, f], w[LEFT + P, f], w[LEFT + C, f]
        at = w[SPEED, f]
        low, high = min(ul - cl, ur - cr), max(ul + cl, ur + cr)
        ml, mr = rl * (low - ul), rr * (high - ur)           # mass fluxes into the waves, negative and positive
        gap = mr - ml
        star, p = 0.5 * (ul + ur), 0.5 * (pl + pr)
        if gap > 0.0:
            star = (pl - pr + mr * ur - ml * ul) / gap
            p = 0.5 * (pl + ml * (star - ul) + pr + mr * (star - ur))
        left = at <= star
        rho, u, e, p0, m, edge = (rl, ul, el, pl, ml, low) if left else (rr, ur, er, pr, mr, high)
        whole = e + 0.5 * u * u
        if (at <= low if left else at >= high) or m == 0.0:
            w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = rho, u, whole, p0
        else:
            w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = m / (edge - star), star, whole + (p * star - p0 * u) / m, p
        for k in range(3):
            value = w[RIGHT + LAM + k, i] if left else w[LEFT + LAM + k, f]
            w[INTO_LEFT + k, f] = w[INTO_RIGHT + k, f] = value
        if is_solid(rules, grid.region[i]) and grid.region[i] == grid.region[f]:
            w[INTO_LEFT + 1, f] = w[INTO_RIGHT + 1, f] = w[RIGHT + VOLUME, i] / rl if left else w[LEFT + VOLUME, f] / rr
