r"""One state behind a shock, for any law: the scalar search that every curve of the package uses.

With the specific volume $v = 1/\rho$ and $x = v_0 - v$, the conservation of mass, momentum and energy across a shock that releases the
heat $q$ reads

$$p - p_0 = m^2 x, \qquad m = \rho_0 (U_s - u_0), \qquad (u - u_0)^2 = (p - p_0)\,x, \qquad
  e - e_0 = q + \tfrac12 (p + p_0)\,x$$

* index 0: the state ahead; $u$: particle velocity; $U_s$: shock velocity; $m$: mass flux through the shock

If the pressure, the particle velocity or the shock velocity is given, $p$ and $e$ are functions of $x$ alone, and the equation of state
determines $x$. If the density is given, $x$ is known and $p$ is found. Porous materials, in which the density may fall along the
Hugoniot, are included.

Implementation: in x the root is single where the law is stable. Newton's method works inside a bracket, which is halved where a step
would leave it. The functions are plain scalar code, so that `theory.kernels` compiles this same source for arrays. They return a status
and never raise; `theory.hugoniot` turns a status into an error that states the limit.

Source: KB codes manual, equations 2.7 to 2.13 with the energy sign corrected (K-E1), and 4.3 for the heat; Starkenberg, ARL-TR-2161, A-5.
"""

import math

from hugoniot.laws.eos.contract import pressure, pressure_and_derivatives, pressure_derivatives

BY_PRESSURE, BY_PARTICLE_VELOCITY, BY_SHOCK_VELOCITY, BY_DENSITY = 0, 1, 2, 3
FOUND, NOT_COMPRESSIVE, BEYOND_LIMIT, NOT_CONVERGED = 0, 1, 2, 3
_TRIES = 200
_EPSILON = 4.5e-16
_CLOSE = 1e-10  # a Newton step of this relative size leaves an error of its square: at round-off, halving brackets would only lose the root


def line(mode, target, x, p0, e0):
    """(p, e, dp/dx, de/dx) that the conservation laws demand at x = v0 - v; `e0` includes the heat of reaction.

    target   pressure (Pa), particle velocity jump (m/s) or mass flux rho0 Us (kg/m2/s), as `mode` says
    """
    if mode == BY_PRESSURE:
        mean = 0.5 * (target + p0)
        return target, e0 + mean * x, 0.0, mean
    if mode == BY_PARTICLE_VELOCITY:
        square = target * target
        return p0 + square / x, e0 + 0.5 * square + p0 * x, -square / (x * x), p0
    slope = target * target
    return p0 + slope * x, e0 + (p0 + 0.5 * slope * x) * x, slope, p0 + slope * x


def misfit(mode, target, x, v0, p0, e0, par):
    """(g, dg/dx): by how much the law's pressure exceeds the line's at x, Pa, and its slope."""
    p, e, p_x, e_x = line(mode, target, x, p0, e0)
    rho = 1.0 / (v0 - x)
    found, p_rho, p_e = pressure_and_derivatives(rho, e, par)
    return found - p, rho * rho * p_rho + p_e * e_x - p_x


def beyond_stability(mode, target, x, v0, p0, e0, par):
    """Whether x lies beyond Segletes' limit (Starkenberg A-5), 1 - (dp/de) x/2 = 0, at which the Hugoniot stands upright and ends.

    Past it the misfit has changed its sign once more without meeting a root.
    """
    _, e, _, _ = line(mode, target, x, p0, e0)
    return 0.5 * pressure_derivatives(1.0 / (v0 - x), e, par)[1] * x >= 1.0


def bracket(mode, target, guess, least, most, v0, p0, e0, par):
    """(status, low, high) with g(low) < 0 <= g(high), searched outwards from `guess` inside (least, most)."""
    x = guess if guess > least else least + 1e-3 * (most - least)
    x = x if x < most else 0.5 * (least + most)
    g, _ = misfit(mode, target, x, v0, p0, e0, par)
    low, high = least, most
    for _ in range(_TRIES):
        if g < 0.0:
            low = x
            if most - x <= 1e-13 * most:
                return BEYOND_LIMIT, low, high
            x = min(1.5 * x - 0.5 * least, 0.5 * (x + most))
            g, slope = misfit(mode, target, x, v0, p0, e0, par)
            # the roots of porous materials lie beyond that limit too: only where the misfit falls was a root leapt over
            if (g < 0.0 and slope < 0.0 and beyond_stability(mode, target, x, v0, p0, e0, par)
                    and not beyond_stability(mode, target, low, v0, p0, e0, par)):
                most, x, g = x, low, -1.0  # the root was leapt over: nearer
                continue
            if not g < 0.0:
                return (FOUND if math.isfinite(g) else BEYOND_LIMIT), low, x
        elif g >= 0.0:
            high = x
            if x - least <= 1e-13 * v0:
                return dip(mode, target, least, most, v0, p0, e0, par)
            x = least + 0.4 * (x - least)
            g, _ = misfit(mode, target, x, v0, p0, e0, par)
            if g < 0.0:
                return FOUND, x, high
        else:
            return BEYOND_LIMIT, low, high
    return NOT_CONVERGED, low, high


def dip(mode, target, least, most, v0, p0, e0, par):
    """(status, low, high) by a scan for g < 0: where g is positive at small x also (reaction, elastic limit of a porous solid)."""
    low = -1.0
    for k in range(1, 200):
        x = least + (most - least) * (k / 200.0) ** 3
        g, _ = misfit(mode, target, x, v0, p0, e0, par)
        if g < 0.0:
            low = x
        elif low >= 0.0 and g >= 0.0:
            return FOUND, low, x
    return NOT_COMPRESSIVE, least, most


def polish(mode, target, low, high, v0, p0, e0, par):
    """(status, x): the root inside a bracket, by Newton's method that halves the bracket where it would leave it."""
    x = 0.5 * (low + high)
    previous = high - low
    for _ in range(_TRIES):
        g, slope = misfit(mode, target, x, v0, p0, e0, par)
        if g == 0.0:
            return FOUND, x
        if g < 0.0:
            low = x
        else:
            high = x
        step = -g / slope if slope > 0.0 else high - low
        if slope > 0.0 and abs(step) <= _CLOSE * abs(x):
            return FOUND, x + step
        if not (low < x + step < high) or abs(step) > 0.6 * previous:
            step = 0.5 * (low + high) - x
        previous = abs(step)
        x += step
        if previous <= _EPSILON * abs(x) or high - low <= _EPSILON * high:
            return (FOUND if _is_root(mode, target, x, v0, p0, e0, par) else NOT_CONVERGED), x
    # round-off of a stiff law can keep the last step above the threshold: accept what no further step can better
    return (FOUND if previous <= 1e-12 * abs(x) else NOT_CONVERGED), x


def _is_root(mode, target, x, v0, p0, e0, par):
    """Whether the misfit vanishes on both sides of x: a bracket also closes in on a jump of the law, where nothing is solved."""
    for side in (-1e-12, 1e-12):
        g, slope = misfit(mode, target, x + side * x, v0, p0, e0, par)
        if abs(g) > abs(slope) * (1e-6 * x + 1e-12 * v0):
            return False
    return True


def pressure_at(x, rho, p0, e0, guess, par):
    """(status, p) on the Hugoniot at a given density: Newton in p, exact in one step for a law linear in energy.

    A slope above zero lies beyond the compression limit, except for strongly distended material that heat keeps below the density
    of the solid, where the law without that heat would be in tension.
    """
    p = guess
    for _ in range(60):
        e = e0 + 0.5 * (p + p0) * x
        h = pressure(rho, e, par) - p
        slope = 0.5 * pressure_derivatives(rho, e, par)[1] * x - 1.0
        if not (math.isfinite(h) and (slope < 0.0 or (slope > 0.0 and anomalous(x, rho, p0, e0, par)))):
            return _pressure_by_bracket(x, rho, p0, e0, par)
        step = -h / slope
        p += step
        if abs(step) <= _EPSILON * abs(p):
            return FOUND, p
    return (FOUND, p) if abs(step) <= 1e-12 * abs(p) else _pressure_by_bracket(x, rho, p0, e0, par)


def anomalous(x, rho, p0, e0, par):
    """Whether heat alone holds distended material at `rho`: the law without that heat is in tension, here and at the initial density."""
    cold = pressure(rho, e0, par)
    return cold < p0 and pressure(1.0 / (x + 1.0 / rho), e0, par) < p0 - 1e-6 * abs(cold)


def _pressure_by_bracket(x, rho, p0, e0, par):
    """(status, p) by doubling and halving, for laws whose slope misleads Newton's method (tables, phase changes)."""
    high = max(abs(p0), 1.0)
    for _ in range(_TRIES):
        if pressure(rho, e0 + 0.5 * (high + p0) * x, par) - high < 0.0:
            break
        high *= 2.0
        if high > 1e20:
            return BEYOND_LIMIT, high
    low = p0
    if not pressure(rho, e0 + p0 * x, par) - p0 >= 0.0:
        return NOT_COMPRESSIVE, p0
    for _ in range(_TRIES):
        p = 0.5 * (low + high)
        if pressure(rho, e0 + 0.5 * (p + p0) * x, par) - p < 0.0:
            high = p
        else:
            low = p
        if high - low <= _EPSILON * high:
            break
    return FOUND, 0.5 * (low + high)


def shocked(mode, target, guess, least, most, v0, p0, e0, par):
    """(status, x, p, e) behind a shock from (v0, p0, e0).

    target        as in `line`; for BY_DENSITY the density
    guess         first x to try; (least, most) the interval of x in which the law is defined
    """
    if mode == BY_DENSITY:
        x = v0 - 1.0 / target
        if x < least or x >= most:
            return (NOT_COMPRESSIVE if x < least else BEYOND_LIMIT), x, p0, e0
        status, p = pressure_at(x, target, p0, e0, pressure(target, e0 + p0 * x, par), par)
        if status == FOUND and p < p0:
            status = BEYOND_LIMIT
        return status, x, p, e0 + 0.5 * (p + p0) * x
    status, low, high = bracket(mode, target, guess, least, most, v0, p0, e0, par)
    if status == NOT_COMPRESSIVE and mode != BY_SHOCK_VELOCITY and least == 0.0 and 0.0 < guess < 1e-10 * v0:
        # weaker than the round-off of the law's pressure: an acoustic wave, which is where the guess starts from
        p, e, _, _ = line(mode, target, guess, p0, e0)
        return FOUND, guess, p, e
    if status != FOUND:
        return status, low, p0, e0
    status, x = polish(mode, target, low, high, v0, p0, e0, par)
    p, e, _, _ = line(mode, target, x, p0, e0)
    return status, x, p, e


def first_guess(mode, target, v0, p0, c0):
    """x to begin with: a linear shock-particle velocity line of slope 1.4 through the sound speed c0."""
    if mode == BY_PRESSURE:
        rise = max(target - p0, 0.0)
        return v0 * rise / (c0 * c0 / v0 + 2.0 * rise)
    if mode == BY_PARTICLE_VELOCITY:
        return v0 * target / (c0 + 1.4 * target)
    speed = target * v0
    return v0 * max(speed - c0, 1e-6 * speed) / (1.4 * speed)
