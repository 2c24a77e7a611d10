r"""The scalar integrator along an isentrope, for any law, that release paths, fans and Riemann solutions use.

Along an isentrope the energy, and in a simple wave the particle velocity $u$, follow from

$$\frac{de}{d\ln\rho} = \frac{p}{\rho}, \qquad \frac{du}{d\ln\rho} = \pm c$$

with $+$ for a wave that moves towards $+x$ and $-$ for one towards $-x$. An equation of state that consists of smooth pieces, such as a
table, is integrated piece by piece.

Implementation: Gragg's modified midpoint rule with Richardson extrapolation in h^2 (Bulirsch and Stoer) reaches round-off in few
evaluations; a step that does not converge is halved. Plain scalar code: `theory.kernels` compiles this same source. A status is returned,
never an exception.
"""

import math

from hugoniot.core.ops import vexp
from hugoniot.laws.eos.contract import piece_coordinate, pressure, pressure_and_derivatives, smooth_piece

REACHED, UNSTABLE, TOO_SHORT, OUTSIDE, LEFT = 0, 1, 2, 3, 4
_COLUMNS = 9
_LONGEST = 0.25   # step in ln(rho)
_SHORTEST = 1e-11
_GRAZE = 1e-9       # share of a piece by which a path may bulge out of it unseen: 1e-14 of the energy
_MOST_LEAPS = 4000
_TENSION_RANGE = 3.0  # no material bears tension at a twentieth of its density: the law's curve has levelled off, and is stiff to follow


def rates(y, e, par):
    """(de/dy, du/dy = c) at density exp(y); c is NaN where c^2 <= 0."""
    rho = vexp(y)
    p, p_rho, p_e = pressure_and_derivatives(rho, e, par)
    square = p_rho + p * p_e / (rho * rho)
    return p / rho, (math.sqrt(square) if square > 0.0 else math.nan)


def leap(y, e, u, h, par):
    """(converged, e, u) after one extrapolated step h in ln(rho)."""
    first_e, first_u = rates(y, e, par)
    if not math.isfinite(first_u):
        return False, e, u
    row_e, row_u = [0.0] * _COLUMNS, [0.0] * _COLUMNS
    # what round-off of the pressure (of a stiff law: of c^2) allows
    floor_e = 1e-15 * abs(e) + 1e-15 * first_u * first_u * abs(h)
    floor_u = 1e-15 * abs(u) + 1e-14 * first_u * abs(h)
    last_digit = 2.2e-16 * abs(y)  # of y: where the rates bend hard, short steps see it
    best_e, best_u, miss = e, u, math.inf
    for k in range(_COLUMNS):
        n = 2 * (k + 1)
        d = h / n
        ea, ua = e, u
        eb, ub = e + d * first_e, u + d * first_u
        for i in range(1, n):
            fe, fu = rates(y + i * d, eb, par)
            ea, eb = eb, ea + 2.0 * d * fe
            ua, ub = ub, ua + 2.0 * d * fu
        fe, fu = rates(y + h, eb, par)
        best_e, best_u = 0.5 * (ea + eb + d * fe), 0.5 * (ua + ub + d * fu)
        if not (math.isfinite(best_e) and math.isfinite(best_u)):
            return False, e, u
        # Aitken-Neville towards h = 0; the row keeps what this number of substeps gave at each order
        for j in range(k):
            ratio = n / (2.0 * (k - j))
            ratio = ratio * ratio - 1.0
            old_e, old_u = row_e[j], row_u[j]
            row_e[j], row_u[j] = best_e, best_u
            best_e += (best_e - old_e) / ratio
            best_u += (best_u - old_u) / ratio
        row_e[k], row_u[k] = best_e, best_u
        if k > 0:
            miss = max(abs(best_e - row_e[k - 1]) / (floor_e + 1e-14 * abs(best_e - e) + last_digit * abs(fe - first_e)),
                       abs(best_u - row_u[k - 1]) / (floor_u + 1e-14 * abs(best_u - u) + last_digit * abs(fu - first_u)))
            if miss <= 1.0:
                return True, best_e, best_u
    return miss <= 30.0, best_e, best_u


def advance(y, e, u, target, par):
    """(status, y, e, u) at ln(rho) = target, or where the isentrope turns unstable (c^2 <= 0) or leaves the law on the way there."""
    for _ in range(_MOST_LEAPS):
        if y == target:
            return REACHED, y, e, u
        status, y, e, u = stretch(y, e, u, target, par)
        if status in (UNSTABLE, OUTSIDE):
            return status, y, e, u
    return UNSTABLE, y, e, u


def stretch(y, e, u, target, par):
    """(status, y, e, u) at ln(rho) = target (REACHED) or where the path leaves the smooth piece it begins in (REACHED or LEFT)."""
    way = 1.0 if target > y else -1.0
    piece, low, high = smooth_piece(vexp(y), e, way, par)
    if low >= high:
        return OUTSIDE, y, e, u
    edge = math.log(high) if way > 0.0 else math.log(low)
    start = y
    status, y, e, u = through(y, e, u, target if way * (edge - target) >= 0.0 else edge, piece)
    if status == LEFT and abs(y - start) < _SHORTEST:  # along an edge: a step that small is the same in both pieces
        near = abs(target - y) <= _SHORTEST
        h = target - y if near else way * _SHORTEST
        here_e, here_u = rates(y, e, piece)
        y, e, u = target if near else y + h, e + h * here_e, u + h * here_u
    return status, y, e, u


def through(y, e, u, target, piece):
    """(status, y, e, u) at ln(rho) = target, or where the isentrope leaves the smooth piece of a law or turns unstable before."""
    h = min(max(target - y, -_LONGEST), _LONGEST)
    g, rise = across(y, e, piece)
    for _ in range(_MOST_LEAPS):
        if y == target:
            return REACHED, y, e, u
        remaining = target - y
        if abs(h) >= abs(remaining):
            h = remaining
        done, new_e, new_u = leap(y, e, u, h, piece)
        if done:
            new_y = target if h == remaining else y + h
            new_g, new_rise = across(new_y, new_e, piece)
            if astray(g, rise, new_g, new_rise, h):
                h = 0.5 * h
                continue
            y, e, u, g, rise = new_y, new_e, new_u, new_g, new_rise
            if not 0.0 <= g <= 1.0:
                return to_edge(y, e, u, g, rise, piece)
            h = min(max(1.7 * h, -_LONGEST), _LONGEST)
        elif abs(h) < _SHORTEST:
            # a kink of the law (crush-up): step over it, at an error of the jump of c times this step
            here_e, here_u = rates(y, e, piece)
            if not (math.isfinite(here_u) and math.isfinite(rates(y + h, e + h * here_e, piece)[1])):
                return UNSTABLE, y, e, u
            y, e, u = y + h, e + h * here_e, u + h * here_u
            g, rise = across(y, e, piece)
            h = 1e3 * h
        else:
            h = 0.4 * h
    return UNSTABLE, y, e, u


def across(y, e, piece):
    """(coordinate, its slope by y along the isentrope) in the piece."""
    rho = vexp(y)
    g, g_rho, g_e = piece_coordinate(rho, e, piece)
    return g, g_rho * rho + g_e * pressure(rho, e, piece) / rho


def astray(g, rise, new_g, new_rise, h):
    """Whether the path may have left the piece and come back within a step: it turned, and its end tangents meet outside."""
    if rise * new_rise > 0.0 or rise == new_rise:
        return False
    meet = g + rise * (new_g - g - new_rise * h) / (rise - new_rise)
    return abs(h) > _SHORTEST and not -_GRAZE <= meet <= 1.0 + _GRAZE


def to_edge(y, e, u, g, rise, piece):
    """(LEFT, y, e, u) at the edge, 0 or 1, of the piece that the path has just overshot: Newton on the piece's continuation."""
    edge = 0.0 if g < 0.0 else 1.0
    for _ in range(20):
        h = (edge - g) / rise if rise != 0.0 else 0.0
        done, new_e, new_u = leap(y, e, u, h, piece)
        if not done:
            return UNSTABLE, y, e, u
        y, e, u = y + h, new_e, new_u
        g, rise = across(y, e, piece)
        if abs(h) < 1e-13:
            break
    return LEFT, y, e, u


def to_pressure(y, e, u, target, lowest, highest, par):
    """(status, y, e, u) where the isentrope through (y, e) has the pressure `target`; ln(rho) stays in (lowest, highest).

    Newton along the isentrope itself: dp/dy = rho c^2, in ln(p) for the long expansion of a gas. Every iterate is integrated
    from the last, so an overshoot costs nothing in accuracy.
    """
    torn = y - _TENSION_RANGE
    for _ in range(200):
        rho = vexp(y)
        p = pressure(rho, e, par)
        lowest, highest = (y, highest) if p < target else (lowest, y)
        if target < 0.0 and y <= torn:
            return UNSTABLE, y, e, u
        c = rates(y, e, par)[1]
        if not math.isfinite(c):
            return UNSTABLE, y, e, u
        stiffness = rho * c * c
        step = (target - p) / stiffness
        if target > 0.0 and p > 0.0 and stiffness < 6.0 * p:
            step = math.log(target / p) * p / stiffness
        step = min(max(step, -1.5), 0.3)
        if abs(step) <= 2e-15 * max(1.0, abs(y)) or p == target:
            return REACHED, y, e, u
        goal = y + step
        if goal <= lowest:
            goal = 0.5 * (y + lowest) if lowest > -600.0 else y - 1.0
        if goal >= highest:
            goal = 0.5 * (y + highest)
        if target < 0.0:
            goal = max(goal, torn)
        if abs(goal - y) < 4e-16 * max(1.0, abs(y)):
            return TOO_SHORT, y, e, u
        before = abs(step)
        status, y, e, u = advance(y, e, u, goal, par)
        if status != REACHED and (status == UNSTABLE or (target - pressure(vexp(y), e, par)) * step > 0.0):
            return status, y, e, u
        if before < 1e-12:  # the next correction is below round-off, also where the slope leaps
            return REACHED, y, e, u
    return TOO_SHORT, y, e, u


def to_velocity(y, e, u, target, lowest, highest, par):
    """(status, y, e, u) where the velocity gained has reached `target`: Newton with du/dy = c; see `to_pressure`."""
    torn = y - _TENSION_RANGE
    for _ in range(200):
        stretched = pressure(vexp(y), e, par) < 0.0
        if stretched and y <= torn:
            return UNSTABLE, y, e, u
        c = rates(y, e, par)[1]
        if not math.isfinite(c):
            return UNSTABLE, y, e, u
        lowest, highest = (y, highest) if u < target else (lowest, y)
        step = min(max((target - u) / c, -1.5), 0.3)
        goal = y + step
        if goal <= lowest:
            goal = 0.5 * (y + lowest) if lowest > -600.0 else y - 1.0
        if goal >= highest:
            goal = 0.5 * (y + highest)
        if stretched:
            goal = max(goal, torn)
        if abs(goal - y) < 1e-15 * max(1.0, abs(y)):
            return TOO_SHORT if abs(target - u) > 1e-9 * c else REACHED, y, e, u
        status, y, e, u = advance(y, e, u, goal, par)
        if status != REACHED and (status == UNSTABLE or (target - u) * step > 0.0):
            return status, y, e, u
        if abs(step) < 1e-12:
            return REACHED, y, e, u
    return TOO_SHORT, y, e, u
