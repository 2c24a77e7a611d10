r"""Along an isentrope, for any law: the scalar integrator that release paths, fans and Riemann solutions use.

With $y = \ln\rho$,

$$\frac{de}{dy} = \frac{p}{\rho}, \qquad \frac{du}{dy} = c$$

(the first law at constant entropy, and the Riemann invariant of a simple wave: u is the velocity gained while the density
falls, taken positive with y). Both sides are smooth for every law, so Gragg's modified midpoint rule with Richardson
extrapolation in $h^2$ (Bulirsch and Stoer) reaches round-off in few evaluations; a step that does not converge is halved.

Plain scalar code: `theory.kernels` compiles this same source. A status is returned, never an exception.
"""

import math

from hugoniot.core.ops import vexp
from hugoniot.laws.eos.contract import pressure, pressure_and_derivatives

REACHED, UNSTABLE, TOO_SHORT = 0, 1, 2
_COLUMNS = 9
_LONGEST = 0.25   # step in ln(rho)
_SHORTEST = 1e-11
_MOST_LEAPS = 4000
_TENSION_RANGE = 3.0  # no material bears tension at a twentieth of its density: the law's curve has levelled off


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
    """(status, y, e, u) at ln(rho) = target, or where the isentrope turns unstable (c^2 <= 0) on the way there."""
    h = min(max(target - y, -_LONGEST), _LONGEST)
    for _ in range(_MOST_LEAPS):
        if y == target:
            return REACHED, y, e, u
        remaining = target - y
        if abs(h) >= abs(remaining):
            h = remaining
        done, new_e, new_u = leap(y, e, u, h, par)
        if done:
            y = target if h == remaining else y + h
            e, u = new_e, new_u
            h = min(max(1.7 * h, -_LONGEST), _LONGEST)
        elif abs(h) < _SHORTEST:
            # a kink of the law (crush-up, table cell): step over it, at an error of the jump of c times this step
            here_e, here_u = rates(y, e, par)
            if not (math.isfinite(here_u) and math.isfinite(rates(y + h, e + h * here_e, par)[1])):
                return UNSTABLE, y, e, u
            y, e, u = y + h, e + h * here_e, u + h * here_u
            h = 1e3 * h
        else:
            h = 0.4 * h
    return UNSTABLE, y, e, u


def to_pressure(y, e, u, target, lowest, highest, par):
    """(status, y, e, u) where the isentrope through (y, e) has the pressure `target`; ln(rho) stays in (lowest, highest).

    Newton along the isentrope itself: dp/dy = rho c^2, in ln(p) for the long expansion of a gas. Every iterate is integrated
    from the last, so an overshoot costs nothing in accuracy.
    """
    start = y
    for _ in range(200):
        rho = vexp(y)
        p = pressure(rho, e, par)
        if target < 0.0 and y < start - _TENSION_RANGE:
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
        if abs(goal - y) < 4e-16 * max(1.0, abs(y)):
            return TOO_SHORT, y, e, u
        before = abs(step)
        status, y, e, u = advance(y, e, u, goal, par)
        if status != REACHED:
            return status, y, e, u
        if before < 1e-9:  # quadratic: the next correction is below round-off
            return REACHED, y, e, u
    return TOO_SHORT, y, e, u


def to_velocity(y, e, u, target, lowest, highest, par):
    """(status, y, e, u) where the velocity gained has reached `target`: Newton with du/dy = c; see `to_pressure`."""
    for _ in range(200):
        c = rates(y, e, par)[1]
        if not math.isfinite(c):
            return UNSTABLE, y, e, u
        step = min(max((target - u) / c, -1.5), 0.3)
        goal = y + step
        if goal <= lowest:
            goal = 0.5 * (y + lowest) if lowest > -600.0 else y - 1.0
        if goal >= highest:
            goal = 0.5 * (y + highest)
        if abs(goal - y) < 1e-15 * max(1.0, abs(y)):
            return TOO_SHORT if abs(target - u) > 1e-9 * c else REACHED, y, e, u
        status, y, e, u = advance(y, e, u, goal, par)
        if status != REACHED:
            return status, y, e, u
        if abs(step) < 1e-9:
            return REACHED, y, e, u
    return TOO_SHORT, y, e, u
