r"""Escape of explosive products: a gamma = 3 slab detonated at a piston expands into vacuum when the front reaches its free end.

Characteristics of a gamma = 3 gas are straight. Slab 0 < x < L, piston speed U from x = 0, t* = L/D, $w_\pm = u \pm c$:

| region | w+ | w- |
|---|---|---|
| Taylor fan | x/t | -D/2 |
| uniform, at the piston | 2U + D/2 | -D/2 |
| fan crossed by the escape wave | x/t | (x - L)/(t - t*) |
| uniform crossed by the escape wave | 2U + D/2 | (x - L)/(t - t*) |
| reflected from the piston | 2U - w-(s) | (x - L)/(t - t*) |

where s is the time at which the characteristic through (x, t) left the piston: $x = Us + [2U - w_-(s)](t - s)$ with
$w_-(s) = (Us - L)/(s - t*)$, which gives
$s = [x t^* + t(L - 2Ut^*)]/[x + L - U(t + t^*)]$. The gas front runs on at D.

$c = (w_+ - w_-)/2$, $\rho = 16\rho_0c/(9D)$, $p = \rho c^2/3$.

Source: the problem "escape of HE products" of ExactPack (Dykema and others, UCRL-ID-147096); solution re-derived.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def ehep(detonation_velocity: float = 8500.0, density: float = 1600.0, piston: float = 500.0, length: float = 0.01) -> Solution:
    """Escape of products of a gamma = 3 slab lit at a piston (speed `piston` from x = 0), free at x = length.

    Fields: density, velocity, pressure, energy, sound_speed, burn_fraction; NaN where the piston is; beyond the gas front density 0
    and the front's velocity. `numbers`: escape_time, piston_meets_escape_wave. The defaults are ExactPack's in SI.
    """
    d, up, length_ = detonation_velocity, piston, length
    if min(d, density, length) <= 0.0 or not 0.0 <= up < d / 4.0:
        raise OutOfRange(f"the escaping slab needs positive D, density and length, and 0 <= piston < D/4 = {d / 4.0:g}")
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
