r"""Standing wave in a gamma = 3 gas between two walls: a smooth flow in which each Riemann invariant satisfies Burgers' equation.

It tests the order of accuracy of a solver in smooth flow, before any shock forms.

For $\gamma = 3$ the sound speed is proportional to the density, and $w_\pm = u \pm c$ satisfy

$$\partial_t w + w\,\partial_x w = 0 \quad\Longrightarrow\quad w_\pm(x,t) = w_\pm^0(x - w_\pm t)$$

until characteristics first cross, at the time $-1/\min (w_\pm^0)'$. Here $w_\pm^0$ are the initial values. The gas starts from rest with
uniform entropy and the density $\bar\rho\,[1 + A\cos(k\pi x/L)]$ between walls at 0 and $L$. Beyond the
walls the gas is continued by its mirror images, so that the velocity at the walls is zero.

* $\bar\rho$: `density`; $A$: `amplitude`; $k$: `half_waves`; $L$: `length`

Source: Courant & Friedrichs, Supersonic Flow and Shock Waves (1948), section 40, treats gamma = 3; the solution between walls was
derived for this project.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def _carried(x, time, sign, level, amplitude, wave_number):
    """Solve w = sign c0(x - w t) by Newton's iteration with the steepest characteristics still apart."""
    w = sign * level * (1.0 + amplitude * np.cos(wave_number * x))
    for _ in range(60):
        phase = wave_number * (x - w * time)
        residual = w - sign * level * (1.0 + amplitude * np.cos(phase))
        slope = 1.0 - sign * level * amplitude * np.sin(phase) * wave_number * time
        step = residual / slope
        w = w - step
        if np.max(np.abs(step), initial=0.0) < 1e-15 * level:
            break
    return w


def double_burgers(density: float = 1.0, pressure: float = 1.0 / 3.0, amplitude: float = 0.1, length: float = 1.0,
                   half_waves: int = 2) -> Solution:
    """Smooth standing wave in a gamma = 3 gas between walls at 0 and length, from rest with uniform entropy.

    density      mean density
    pressure     pressure at the mean density
    amplitude    relative amplitude A of the density at time 0, between -1 and 1, not 0
    length       distance between the walls
    half_waves   number k of half waves between the walls

    Fields: density, velocity, pressure, energy, sound_speed. Numbers: breaking_time, mean_sound_speed (at the mean density).
    Valid up to 0.98 of breaking_time.
    """
    if not (0.0 < abs(amplitude) < 1.0 and density > 0.0 and pressure > 0.0 and length > 0.0 and half_waves >= 1):
        raise OutOfRange("the standing wave needs 0 < |amplitude| < 1 and positive density, pressure, length and half_waves")
    level = float(np.sqrt(3.0 * pressure / density))
    k = half_waves * np.pi / length
    breaking = 1.0 / (level * abs(amplitude) * k)

    def profile(x, time):
        right, left = (_carried(x, time, sign, level, amplitude, k) for sign in (1.0, -1.0))
        c = 0.5 * (right - left)
        rho = density * c / level
        p = pressure * (rho / density) ** 3
        return {"density": rho, "velocity": 0.5 * (right + left), "pressure": p, "energy": p / (2.0 * rho), "sound_speed": c}

    numbers = {"breaking_time": breaking, "mean_sound_speed": level}
    return Solution("gamma = 3 standing wave", "planar", profile, numbers=numbers, times=(0.0, 0.98 * breaking))
