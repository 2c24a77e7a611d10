r"""Shocks that are unstable and split into a precursor and a slower second shock.

A shock is stable only if no weaker shock on the same Hugoniot is faster, that is, if its Rayleigh line does not cross the Hugoniot. Where
the shock velocity has a maximum at a lower particle velocity (onset of pore collapse, a phase change), the shock at that maximum runs
ahead, and the second shock starts from the state behind it. Together they reach the same particle velocity at a different pressure from
that of the single jump.

Source: Zel'dovich and Raizer, Physics of Shock Waves, chapter XI, sections 4 and 19; Herrmann, J. Appl. Phys. 40 (1969) 2490 (P-alpha).
"""

import contextlib
from typing import NamedTuple

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import States

SAMPLES = 201
LOOKS = 0.75 ** np.arange(1, 31)       # of the particle velocity: down to 2e-4 of it
NOTICED = 1e-3     # of the shock velocity, by which the precursor must be faster


class Split(NamedTuple):
    """The states behind the precursor and behind the second shock."""

    precursor: States
    behind: States


def split_wave(material, ahead: Initial, single: States) -> Split | None:
    """The two waves that reach the particle velocity of the single shock `single` from `ahead`; None where that shock holds together."""
    up, us = float(single.particle_velocity) - ahead.velocity, float(single.shock_velocity) - ahead.velocity
    if not up > 0.0 or ahead.heat or not _outrun(material, ahead, up, us):
        return None
    jumps, speeds = _hugoniot(material, ahead, SAMPLES, up)
    k = 1 + int(np.argmax(speeds[1:]))
    if k in (1, SAMPLES - 1) or speeds[k] <= us * (1.0 + NOTICED):
        return None

    from scipy.optimize import minimize_scalar  # slow to load, and few curves split

    def slowness(x):
        return ahead.velocity - float(shock(material, ahead, particle_velocity=ahead.velocity + x).shock_velocity)

    best = minimize_scalar(slowness, bounds=(jumps[k - 1], jumps[k + 1]), method="bounded", options={"xatol": 1e-9 * up})
    precursor = shock(material, ahead, particle_velocity=ahead.velocity + float(best.x))
    try:
        behind = shock(material, Initial.of(precursor), particle_velocity=float(single.particle_velocity))
    except HugoniotError:
        return None
    return Split(precursor, behind) if float(behind.shock_velocity) < float(precursor.shock_velocity) else None


def _outrun(material, ahead: Initial, up: float, us: float) -> bool:
    """Whether a weaker shock is faster: asked first of single states, since few curves split."""
    for weaker in up * LOOKS:
        with contextlib.suppress(HugoniotError):
            found = shock(material, ahead, particle_velocity=ahead.velocity + weaker)
            if float(found.shock_velocity) - ahead.velocity > us * (1.0 + NOTICED):
                return True
    return False


def _hugoniot(material, ahead: Initial, points: int, up_to: float) -> tuple[np.ndarray, np.ndarray]:
    """Particle velocities relative to the state ahead and the shock velocities there, closest together at the foot of the Hugoniot, since a
    precursor may end at a small part of the particle velocity behind the second shock."""
    jumps = up_to * np.linspace(0.0, 1.0, points) ** 2
    return jumps, shock(material, ahead, once=True, particle_velocity=ahead.velocity + jumps).shock_velocity - ahead.velocity


def split_range(material, ahead: Initial, up_to: float) -> tuple[float, float] | None:
    """Lowest and highest particle velocity jump of the states up to `up_to` that a faster, weaker shock would outrun; None: no state is."""
    jumps, speeds = (values[1:] for values in _hugoniot(material, ahead, 5 * SAMPLES, up_to))
    outrun = np.maximum.accumulate(speeds) > speeds * (1.0 + NOTICED)
    # a curve that falls from its foot has no precursor of finite strength
    if not outrun.any() or not np.argmax(speeds[:np.argmax(outrun) + 1]) > 0:
        return None
    return float(jumps[outrun].min()), float(jumps[outrun].max())
