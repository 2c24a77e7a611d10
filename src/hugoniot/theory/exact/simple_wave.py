r"""Simple waves of an ideal gas: a piston withdrawn at constant speed, and a smooth compression that steepens towards a shock.

They test a solver in smooth flow, where the exact solution is isentropic.

A wave runs along +x into gas at rest with the density $\rho_0$, pressure $p_0$ and sound speed $c_0$. In it

$$c = c_0 + \tfrac12(\gamma-1)\,u, \qquad \rho = \rho_0 (c/c_0)^{2/(\gamma-1)}, \qquad p = p_0 (c/c_0)^{2\gamma/(\gamma-1)}$$

and $u$ is constant along straight characteristics, which leave the path $X(s)$ of the piston, with the velocity $U(s)$, at the time $s$:

$$x = X(s) + \left[c_0 + \tfrac12(\gamma+1)\,U(s)\right](t - s)$$

They first cross at the smallest $t = s + [c_0 + \tfrac12(\gamma-1)U] / [\tfrac12(\gamma+1)U']$ over all $s$ with $U' > 0$. A piston
withdrawn faster than $2c_0/(\gamma-1)$ leaves a vacuum behind.

Source: Courant & Friedrichs, Supersonic Flow and Shock Waves (1948), sections 40 to 48.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def _gas(u, gamma, density, pressure):
    """Fields of the simple wave at particle velocity u; below the escape speed the gas is gone."""
    c0 = np.sqrt(gamma * pressure / density)
    ratio = np.maximum(1.0 + 0.5 * (gamma - 1.0) * u / c0, 0.0)
    rho = density * ratio ** (2.0 / (gamma - 1.0))
    return {"density": rho, "velocity": u, "pressure": pressure * ratio ** (2.0 * gamma / (gamma - 1.0)),
            "energy": (c0 * ratio) ** 2 / (gamma * (gamma - 1.0)), "sound_speed": c0 * ratio}


def _check(gamma, density, pressure, speed):
    if gamma <= 1.0 or density <= 0.0 or pressure <= 0.0 or speed <= 0.0:
        raise OutOfRange("a simple wave needs gamma > 1 and positive density, pressure and speed, "
                         f"got gamma = {gamma:g}, density = {density:g} kg/m3, pressure = {pressure:g} Pa, speed = {speed:g} m/s")


def centred_rarefaction(gamma: float = 1.4, density: float = 1.0, pressure: float = 1.0, speed: float = 1.0) -> Solution:
    """Centred rarefaction: gas at rest in x > 0, from which a piston is withdrawn at constant speed, starting at x = 0.

    gamma      ratio of specific heats, above 1
    density    density of the gas at rest
    pressure   pressure of the gas at rest
    speed      speed of the piston, towards -x

    Fields: density, velocity, pressure, energy, sound_speed; not a number (NaN) behind the piston; in a vacuum the density is 0
    and the velocity that of the gas front. Numbers: head and tail (velocities of the edges of the fan), escape_speed (of the gas into
    vacuum).
    """
    _check(gamma, density, pressure, speed)
    c0 = float(np.sqrt(gamma * pressure / density))
    escape = 2.0 * c0 / (gamma - 1.0)
    slowest = -min(speed, escape)
    tail = c0 + 0.5 * (gamma + 1.0) * slowest

    def profile(x, time):
        with np.errstate(divide="ignore", invalid="ignore"):
            y = np.clip(x / time if time > 0.0 else np.where(x > 0.0, np.inf, -np.inf), -1e30, 1e30)
        u = np.clip(2.0 / (gamma + 1.0) * (y - c0), slowest, 0.0)
        fields = _gas(u, gamma, density, pressure)
        if speed > escape:
            for name in ("density", "pressure", "energy", "sound_speed"):
                fields[name] = np.where(y < slowest, 0.0, fields[name])
        return {name: np.where(x < -speed * time, np.nan, value) for name, value in fields.items()}

    return Solution("centred rarefaction", "planar", profile, numbers={"head": c0, "tail": tail, "escape_speed": escape})


def piston_pulse(gamma: float = 1.4, density: float = 1.0, pressure: float = 1.0, speed: float = 0.1, duration: float = 1.0) -> Solution:
    """Smooth compression: gas at rest in x > 0, driven by a piston whose velocity is speed times sin^2(pi t/duration) and then 0.

    gamma      ratio of specific heats, above 1
    density    density of the gas at rest
    pressure   pressure of the gas at rest
    speed      highest speed of the piston, into the gas
    duration   duration of the motion of the piston

    Fields: density, velocity, pressure, energy, sound_speed; not a number (NaN) behind the piston.
    Numbers: breaking_time, until which the solution is valid, and final_position of the piston.
    """
    _check(gamma, density, pressure, speed)
    c0 = float(np.sqrt(gamma * pressure / density))

    def velocity(s):
        return np.where((s > 0.0) & (s < duration), speed * np.sin(np.pi * s / duration) ** 2, 0.0)

    def position(s):
        within = np.clip(s, 0.0, duration)
        return 0.5 * speed * (within - duration / (2.0 * np.pi) * np.sin(2.0 * np.pi * within / duration))

    s = np.linspace(0.0, 0.5 * duration, 200001)[1:-1]
    slope = speed * np.pi / duration * np.sin(2.0 * np.pi * s / duration)
    breaking = float(np.min(s + (c0 + 0.5 * (gamma - 1.0) * velocity(s)) / (0.5 * (gamma + 1.0) * slope)))

    def profile(x, time):
        low, high = np.full_like(x, -1e3 * (duration + time) - np.max(np.abs(x), initial=0.0) / c0), np.full_like(x, time)
        for _ in range(110):
            middle = 0.5 * (low + high)
            beyond = position(middle) + (c0 + 0.5 * (gamma + 1.0) * velocity(middle)) * (time - middle) > x
            low, high = np.where(beyond, middle, low), np.where(beyond, high, middle)
        fields = _gas(velocity(0.5 * (low + high)), gamma, density, pressure)
        return {name: np.where(x < position(time), np.nan, value) for name, value in fields.items()}

    numbers = {"breaking_time": breaking, "final_position": float(position(duration))}
    return Solution("piston pulse", "planar", profile, numbers=numbers, times=(0.0, breaking))
