r"""Escape of detonation products: a slab of gamma = 3 explosive, lit at a piston, expands into vacuum when the front reaches its free end.

It tests a solver in expansion from a detonation to vacuum and in the reflection of the release from a moving piston.

The slab lies in $0 < x < L$, the piston moves at the speed $U$ from $x = 0$, and the front reaches the free end at $t^* = L/D$. In a
gamma = 3 gas the characteristics are straight and $w_\pm = u \pm c$ are constant along them:

| region | $w_+$ | $w_-$ |
|---|---|---|
| Taylor fan | $x/t$ | $-D/2$ |
| uniform, at the piston | $2U + D/2$ | $-D/2$ |
| fan crossed by the escape wave | $x/t$ | $(x - L)/(t - t^*)$ |
| uniform crossed by the escape wave | $2U + D/2$ | $(x - L)/(t - t^*)$ |
| reflected from the piston | $2U - w_-(s)$ | $(x - L)/(t - t^*)$ |

Here $s = [x t^* + t(L - 2Ut^*)]/[x + L - U(t + t^*)]$ is the time at which the characteristic through $(x, t)$ left the piston, and
$w_-(s) = (Us - L)/(s - t^*)$. The front of the gas continues at the speed $D$. The state is

$$u = \tfrac12(w_+ + w_-), \qquad c = \tfrac12(w_+ - w_-), \qquad \rho = \frac{16\rho_0c}{9D}, \qquad p = \tfrac13\rho c^2$$

* $D$: `detonation_velocity`; $\rho_0$: initial density of the explosive, `density`; $U$: `piston`; $L$: `length`

Source: the problem "escape of HE products" of ExactPack (Dykema and others, UCRL-ID-147096); solution derived for this project.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def ehep(detonation_velocity: float = 8500.0, density: float = 1600.0, piston: float = 500.0, length: float = 0.01) -> Solution:
    """Escape of the products of a gamma = 3 slab, lit at a moving piston, into vacuum.

    detonation_velocity   detonation velocity D
    density               initial density of the explosive
    piston                speed of the piston from x = 0 at time 0, from 0 to D/4
    length                length of the slab

    Fields: density, velocity, pressure, energy, sound_speed, burn_fraction; not a number (NaN) behind the face of the piston; beyond the
    front of the gas the density is 0 and the velocity that of the front. Numbers: escape_time (of the front at the free end),
    piston_meets_escape_wave (s).
    The defaults are those of ExactPack.
    """
    d, up, length_ = detonation_velocity, piston, length
    if min(d, density, length) <= 0.0 or not 0.0 <= up < d / 4.0:
        raise OutOfRange(f"the escaping slab needs positive D, density and length, and 0 <= piston < D/4 = {d / 4.0:g} m/s, got D = "
                         f"{d:g} m/s, density = {density:g} kg/m3, length = {length:g} m, piston = {up:g} m/s")
    start = length_ / d
    meeting = (length_ + 0.5 * d * start) / (up + 0.5 * d)

    def incoming(x, time):
        """w+ at points of the gas."""
        fan = 2.0 * up + 0.5 * d
        plus = np.clip(x / time, fan, None)
        if time <= meeting:
            return plus
        s = (x * start + time * (length_ - 2.0 * up * start)) / (x + length_ - up * (time + start))
        reflected = s > meeting
        s = np.where(reflected, np.minimum(s, time), time)
        return np.where(reflected, 2.0 * up - (up * s - length_) / (s - start), plus)

    def profile(x, time):
        outgoing = np.full_like(x, -0.5 * d)
        if time > start:
            outgoing = np.maximum((x - length_) / (time - start), -0.5 * d)
        incoming_now = incoming(x, time)
        front = d * time
        gas = x <= front
        burnt = gas if time > start else x <= d * time
        c = np.where(burnt, np.maximum(0.5 * (incoming_now - outgoing), 0.0), 0.0)
        u = np.where(burnt, 0.5 * (incoming_now + outgoing), d if time > start else 0.0)
        rho = np.where(burnt, 16.0 / 9.0 * density * c / d, 0.0 if time > start else np.where(x <= length_, density, 0.0))
        fields = {"density": rho, "velocity": u, "pressure": rho * c * c / 3.0, "energy": c * c / 6.0, "sound_speed": c,
                  "burn_fraction": np.where(burnt, 1.0, 0.0)}
        return {name: np.where(x < up * time, np.nan, value) for name, value in fields.items()}

    def fronts(time):
        return (d * time, length_) if time < start else ()

    numbers = {"escape_time": start, "piston_meets_escape_wave": meeting}
    return Solution("escape of explosive products", "planar", profile, fronts, numbers, (1e-300, float("inf")))
