"""Hugoniot curves of any law from any state: principal, second shock, distended material, with heat of reaction.

Implementation: the search for one state, with its equations, is in `theory.jump`. Here it is applied to numbers or arrays, directly for a
few states and compiled (`theory.kernels`) for many. A search that fails raises an error that states the limit.
"""

import math

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory import jump
from hugoniot.theory.states import States, law_of
from hugoniot.theory.upstream import Initial, crushed, distended, fastest, interval, sound_speed_ahead

COMPILE_ABOVE = 200  # states: below, plain Python answers before a compiler would be loaded
COMPILE_ONCE_ABOVE = 10_000     # states of a question that is asked once: below, plain Python answers before a compiler has compiled
_MODES = {"pressure": jump.BY_PRESSURE, "particle_velocity": jump.BY_PARTICLE_VELOCITY,
          "shock_velocity": jump.BY_SHOCK_VELOCITY, "density": jump.BY_DENSITY}


def shock(material, initial: Initial | None = None, *, direction: int = 1, once: bool = False, **given) -> States:
    """States behind a shock that runs into a given state.

    material    a `Material`, or the parameters of an equation of state
    initial     the state ahead: an `Initial`, such as `Initial.of(states)` (default: the reference state, at rest)
    given       exactly one of pressure (Pa), particle_velocity (m/s), shock_velocity (m/s), density (kg/m3): a number or an array;
                velocities are those in the laboratory
    direction   +1: the shock runs towards +x; -1: towards -x
    once        True skips the compilation, which takes seconds; useful if only one curve of up to ten thousand states is needed

    Returns `States` of the shape of the number or array given. Raises `OutOfRange` with the limit if a state is outside the range of the
    law, and `NoSolution` if none is found.

    >>> shock(copper, particle_velocity=500.0).pressure     # Pa

    """
    par = law_of(material)
    ahead = initial or Initial.at_rest(par)
    name, value = _one(given)
    mode, targets = _targets(name, value, ahead, direction)
    x, p, e = _solve(mode, targets, ahead, par, name, COMPILE_ONCE_ABOVE if once else COMPILE_ABOVE)
    shape = np.shape(value)
    rise = np.maximum(p - ahead.pressure, 0.0)
    up = np.sqrt(rise * np.maximum(x, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        us = np.where(x > 0.0, np.sqrt(rise / x), 0.0) / ahead.density
    if mode == jump.BY_PARTICLE_VELOCITY:
        up = targets
    _check_fit(par, ahead, up)
    still = (p == ahead.pressure) | (x <= 0.0)
    if still.any() and not distended(par, ahead):
        us = np.where(still, sound_speed_ahead(par, ahead), us)
    fields = (1.0 / (1.0 / ahead.density - x), p, e, ahead.velocity + direction * up, ahead.velocity + direction * us)
    return States(par, *(f.reshape(shape) if shape else float(f[0]) for f in fields))


def curve(material, initial: Initial | None = None, *, points: int = 101, up_to: float | None = None, direction: int = 1,
          once: bool = False) -> States:
    """The Hugoniot from an initial state, evenly spaced in particle velocity from the initial state on.

    points   number of states
    up_to    highest particle velocity, m/s; default: the highest for which the material's data are valid, if known, otherwise the smaller
             of the sound speed of the initial state and 90 % of the particle velocity at which the Hugoniot ends

    The other arguments are those of `shock`. Raises OutOfRange for fewer than two points and for an `up_to` that is not positive or is
    beyond the range of the equation of state.
    """
    par = law_of(material)
    ahead = initial or Initial.at_rest(par)
    end = (getattr(material, "valid_up_to", None) or _reach(par, ahead)) if up_to is None else up_to
    if not end > 0.0:
        raise OutOfRange(f"the last particle velocity of a Hugoniot must be positive, got {end:.6g} m/s")
    if points < 2:
        raise OutOfRange(f"a Hugoniot needs points = 2 or more, got {points}")
    jumps = np.linspace(1e-3 * end if ahead.heat else 0.0, end, points)
    return shock(par, ahead, direction=direction, once=once, particle_velocity=ahead.velocity + direction * jumps)


def rayleigh_line(initial: Initial, shock_velocity: float, points: int = 2, particle_velocity: float | None = None):
    """Particle velocity (m/s) and pressure (Pa) along the Rayleigh line p = p0 + rho0 (Us - u0)(u - u0), from the state ahead.

    initial             state ahead of the shock
    shock_velocity      Us, m/s
    points              number of points
    particle_velocity   particle velocity at the end of the line, m/s; default: Us
    """
    end = shock_velocity if particle_velocity is None else particle_velocity
    u = np.linspace(initial.velocity, end, points)
    return u, initial.pressure + initial.density * (shock_velocity - initial.velocity) * (u - initial.velocity)


def limit(material, initial: Initial | None = None) -> States:
    """The end of the Hugoniot: the state of highest density that a single shock can reach.

    At a density limit of the equation of state (such as the pole of a linear Us-up relation), and where 1 - (dp/de)(v0 - v)/2 vanishes
    (Segletes' limit, Starkenberg A-5), pressure and particle velocity tend to infinity. They are finite at the edge of a table and for a
    Us-up relation of slope below 1 (J-E16).
    """
    par = law_of(material)
    ahead = initial or Initial.at_rest(par)
    v0, least, most = interval(par, ahead)

    def reached(x):
        status, p = jump.pressure_at(x, 1.0 / (v0 - x), ahead.pressure, ahead.energy + ahead.heat, ahead.pressure, par)
        return (status == jump.FOUND and p >= ahead.pressure and math.isfinite(p)), p

    with np.errstate(all="ignore"):
        low = least + 1e-3 * (most - least)
        high = most
        if reached(low)[0]:
            if reached(near := least + (1.0 - 1e-9) * (most - least))[0]:
                low = near
            for _ in range(60):
                x = 0.5 * (low + high)
                low, high = (x, high) if reached(x)[0] else (low, x)
        _, p = reached(low)
        _, before = reached(low - 1e-4 * (low - least))
    finite = math.isfinite(p) and p < 1.05 * before + 1e-3 and not _upright(low, v0, ahead, before, par)
    if not finite and math.isfinite(end := fastest(par, ahead)):
        finite, p = True, ahead.pressure + end * end / low
    up = math.sqrt(max(p - ahead.pressure, 0.0) * low) if finite else math.inf
    speed = math.sqrt(max(p - ahead.pressure, 0.0) / low) / ahead.density if finite else math.inf
    gap = v0 - low
    density = math.inf if gap < 1e-7 * v0 else 1.0 / gap
    energy = ahead.energy + ahead.heat + 0.5 * (p + ahead.pressure) * low if finite else math.inf
    return States(par, density, p if finite else math.inf, energy, up, speed)


def residual(material, initial: Initial, states: States):
    """The largest relative residual of the three jump conditions and of the equation of state, for each state.

    Each conservation law is divided by its largest term, and the pressure residual by the bulk modulus where it is larger than the
    pressure.
    """
    par = law_of(material)
    stiffness = abs(contract.bulk_modulus(*contract.reference_state(par), par))
    rho, p, e = (np.asarray(v, float) for v in (states.density, states.pressure, states.specific_internal_energy))
    u, us = np.asarray(states.particle_velocity, float) - initial.velocity, np.asarray(states.shock_velocity, float) - initial.velocity
    flux = initial.density * us
    mass = (rho * (us - u) - flux) / np.maximum(np.abs(flux), 1e-300)
    momentum = (p - initial.pressure - flux * u) / np.maximum(np.maximum(np.abs(p), initial.density * us**2), 1e-300)
    work = 0.5 * (p + initial.pressure) * (1.0 / initial.density - 1.0 / rho)
    gain = e - initial.energy - initial.heat
    energy = (gain - work) / np.maximum(np.maximum(np.abs(gain), us**2), 1e-300)
    given = np.array([contract.pressure(r, k, par) for r, k in zip(rho.ravel().tolist(), e.ravel().tolist())]).reshape(rho.shape)
    law = (given - p) / np.maximum(np.abs(p), stiffness)
    worst = np.max(np.abs([mass, momentum, energy, law]), axis=0)
    return worst if worst.ndim else float(worst)


def entropy_rise(material, initial: Initial, density: float) -> float:
    r"""Entropy gained in a shock to a given density (kg/m3), J/(kg K), for any equation of state with a temperature.

    It is the integral of $ds$ along the Hugoniot, where with $x = v_0 - v$

    $$T\,ds = \tfrac12\left[x\,dp - (p - p_0)\,dx\right]$$

    Raises OutOfRange for a shock that releases heat or runs into empty pores, because its Hugoniot does not begin at the state ahead.
    """
    par = law_of(material)
    if "temperature" not in EOS.of(par).functions:
        raise OutOfRange(f"law '{EOS.of(par).name}' has no temperature, so no entropy follows: give it a specific heat")
    if initial.heat != 0.0 or distended(par, initial):
        raise OutOfRange("the entropy is integrated along the Hugoniot from the state ahead, but with a heat of reaction or empty pores "
                         "the Hugoniot does not begin there")
    nodes, weights = np.polynomial.legendre.leggauss(40)
    end = 1.0 / initial.density - 1.0 / density
    x = 0.5 * end * (nodes + 1.0)
    states = shock(par, initial, density=1.0 / (1.0 / initial.density - x))
    total = 0.0
    for xi, w, rho, p, e in zip(x, weights, states.density, states.pressure, states.specific_internal_energy):
        p_rho, p_e = contract.pressure_derivatives(rho, e, par)
        slope = (rho * rho * p_rho + 0.5 * p_e * (p + initial.pressure)) / (1.0 - 0.5 * p_e * xi)
        total += w * 0.5 * (slope * xi - (p - initial.pressure)) / contract.temperature(rho, e, par)
    return 0.5 * end * float(total)


# -- inside ------------------------------------------------------------------------------------------------------
def _one(given: dict):
    if len(given) != 1 or next(iter(given)) not in _MODES:
        raise OutOfRange(f"give exactly one of {', '.join(_MODES)} for a state on a Hugoniot, got {', '.join(given) or 'none'}")
    return next(iter(given.items()))


def _check_fit(par, ahead: Initial, up) -> None:
    end = fastest(par, ahead)
    if np.max(up) > end * (1.0 + 1e-9):
        raise OutOfRange(f"particle velocity {np.max(up):.6g} m/s is beyond the fit of law '{EOS.of(par).name}': the Hugoniot ends at "
                         f"particle velocity {end:.6g} m/s, where the fitted shock velocity stops rising or the particle velocity "
                         "reaches it")


def _targets(name, value, ahead: Initial, direction: int):
    values = np.atleast_1d(np.asarray(value, float)).ravel()
    mode = _MODES[name]
    if not np.isfinite(values).all():
        raise OutOfRange(f"{name} must be finite")
    if name == "density" and not (values > 0.0).all():
        raise OutOfRange("a density must be positive")
    if mode in (jump.BY_PARTICLE_VELOCITY, jump.BY_SHOCK_VELOCITY):
        values = direction * (values - ahead.velocity)
        if (values < 0.0).any():
            raise OutOfRange(f"a {name.replace('_', ' ')} of {values.min():.6g} m/s relative to the material ahead, in the "
                             "direction in which the shock travels, would expand it: a Hugoniot is valid in compression only; use an "
                             "isentrope for release")
        if mode == jump.BY_SHOCK_VELOCITY and (values == 0.0).any():
            raise OutOfRange("the shock velocity cannot be zero: a shock is faster than sound in the material ahead")
    if mode == jump.BY_PRESSURE and (values < ahead.pressure).any():
        raise OutOfRange(f"a pressure of {values.min():.6g} Pa is below the {ahead.pressure:.6g} Pa ahead of the shock: "
                         "a Hugoniot is valid in compression only; use an isentrope for release")
    return mode, values * ahead.density if mode == jump.BY_SHOCK_VELOCITY else values


def _solve(mode, targets, ahead: Initial, par, name, compile_above):
    v0, least, most = interval(par, ahead)
    floor = crushed(par, ahead, v0)
    c0 = sound_speed_ahead(par, ahead)
    e0 = ahead.energy + ahead.heat
    x, p, e = np.zeros_like(targets), np.full_like(targets, ahead.pressure), np.full_like(targets, e0)
    still = _still(mode, targets, ahead) & (ahead.heat == 0.0 and floor == 0.0)
    if targets.size > compile_above:
        from hugoniot.theory import kernels

        status = np.zeros(targets.size, np.int64)
        kernels.shock_curve(mode, targets, still, v0, ahead.pressure, e0, c0, floor, least, most, par, x, p, e, status)
    else:
        status = np.zeros(targets.size, int)
        with np.errstate(all="ignore"):
            for i, target in enumerate(targets.tolist()):
                if not still[i]:
                    first = max(jump.first_guess(mode, target, v0, ahead.pressure, c0), floor)
                    try:
                        status[i], x[i], p[i], e[i] = jump.shocked(mode, target, first, least, most, v0, ahead.pressure, e0, par)
                    except ArithmeticError:  # a pole of the law: compiled code meets an infinity there
                        status[i] = jump.BEYOND_LIMIT
    bad = np.flatnonzero(status != jump.FOUND)
    if bad.size:
        _refuse(int(status[bad[0]]), mode, name, float(targets[bad[0]]), ahead, par)
    return x, p, e


def _upright(x, v0, ahead: Initial, p, par) -> bool:
    """Whether x, next to which the pressure is p, is Segletes' limit, 1 - (dp/de) x/2 = 0."""
    e = ahead.energy + ahead.heat + 0.5 * (p + ahead.pressure) * x
    return abs(1.0 - 0.5 * contract.pressure_derivatives(1.0 / (v0 - x), e, par)[1] * x) < 1e-6


def _reach(par, ahead: Initial) -> float:
    """The upstream sound speed, m/s, or 90 % of the particle velocity at which the Hugoniot ends if that is less."""
    speed = sound_speed_ahead(par, ahead)
    v0, least, most = interval(par, ahead)
    target = speed / 0.9
    guess = max(jump.first_guess(jump.BY_PARTICLE_VELOCITY, target, v0, ahead.pressure, speed), crushed(par, ahead, v0))
    with np.errstate(all="ignore"):
        try:
            status, *_ = jump.shocked(jump.BY_PARTICLE_VELOCITY, target, guess, least, most, v0, ahead.pressure,
                                      ahead.energy + ahead.heat, par)
        except ArithmeticError:  # a pole of the law
            status = jump.BEYOND_LIMIT
    return speed if status == jump.FOUND else min(speed, 0.9 * limit(par, ahead).particle_velocity)


def _still(mode, targets, ahead: Initial):
    """Where the asked state is the upstream state itself: a shock of no strength."""
    rest = {jump.BY_PRESSURE: ahead.pressure, jump.BY_PARTICLE_VELOCITY: 0.0, jump.BY_DENSITY: ahead.density}.get(mode, math.nan)
    return targets == rest


def _refuse(status, mode, name, target, ahead: Initial, par):
    """Turn a status of the search into an error that states the limit."""
    law = EOS.of(par).name
    shown = target / ahead.density if mode == jump.BY_SHOCK_VELOCITY else target
    asked = f"{name.replace('_', ' ')} {shown:.6g} {({'density': 'kg/m3', 'pressure': 'Pa'}).get(name, 'm/s')}"
    if status == jump.NOT_COMPRESSIVE and mode == jump.BY_SHOCK_VELOCITY:
        raise OutOfRange(f"{asked} is not above the sound speed {sound_speed_ahead(par, ahead):.6g} m/s ahead of the shock (law '{law}'); "
                         "where heat is released it must be at least the Chapman-Jouguet velocity")
    if mode == jump.BY_DENSITY and target > ahead.density and not distended(par, ahead):
        status = jump.BEYOND_LIMIT
    if status == jump.NOT_COMPRESSIVE:
        raise OutOfRange(f"{asked} does not compress the state ahead ({ahead.density:.6g} kg/m3, {ahead.pressure:.6g} Pa; law '{law}')")
    if status == jump.BEYOND_LIMIT:
        end = limit(par, ahead)
        reach = [f"density {end.density:.6g} kg/m3"] if math.isfinite(end.density) else []
        if math.isfinite(end.particle_velocity):
            reach += [f"pressure {end.pressure:.6g} Pa", f"particle velocity {end.particle_velocity:.6g} m/s",
                      f"shock velocity {end.shock_velocity:.6g} m/s"]
        if not math.isfinite(end.density):
            reach.append("where the specific volume would be zero")
        raise OutOfRange(f"{asked} is beyond the compression limit of law '{law}' (density ahead {ahead.density:.6g} kg/m3): "
                         f"the Hugoniot ends at {', '.join(reach)}; try a weaker shock")
    raise NoSolution(f"{asked} was not found on the Hugoniot of law '{law}' (density ahead {ahead.density:.6g} kg/m3): the search did not "
                     "converge, probably because the pressure of the law jumps there; try a slightly different value")
