"""Validity checks of a state, and the peak values of a zone, evaluated after every step."""

from collections import namedtuple

import numpy as np

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, vsqrt
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.core.target import INLINE

LIMIT = 1e12          # density (kg/m3) or sound speed (m/s) beyond which a state is no physics
LIMIT_BITS = np.float64(LIMIT).view(np.uint64)
(FOUND_RATE, FOUND_FAILURE, FOUND_IMPULSE, FOUND_CAPPED, FOUND_UNSOUND) = range(5)   # what passes find in a stretch of zones
FOUND_FLOATS = 5
STRESS_SCALE = 1e-18   # so that the same limit serves stresses: 1e30 Pa


class PeakRows(namedtuple("PeakRows", "rho c sigma p peak_stress peak_tension peak_pressure peak_density found")):
    """rho, c, sigma, p -> the largest and smallest sigma, the largest p and rho so far; found[FOUND_UNSOUND]."""


def wave_speed(c2, noise):
    """sqrt(c2); -1, which `look_over` refuses, for an imaginary speed; 0 for what is zero but for round-off (a cold gas)."""
    return vsqrt(fmax(c2, 0.0)) if c2 > -noise else -1.0


def unsound(z, j):
    """1 for a density that is not positive, a sound speed or a stress that is not a finite number, or one beyond all physics; else 0.

    A negative number, an infinity and what is no number have larger bits than any finite positive one: one comparison does for the three,
    where a compiled comparison of numbers costs as much as a store.
    """
    bits = np.float64(z.rho[j]).view(np.uint64)
    of_speed, of_stress = np.float64(z.c[j]).view(np.uint64), np.float64(abs(z.sigma[j]) * STRESS_SCALE).view(np.uint64)
    bits = of_speed if of_speed > bits else bits
    bits = of_stress if of_stress > bits else bits
    return 0 if bits < LIMIT_BITS else 1


def new_peaks(z, j):
    """How many peaks of a zone are new."""
    rho, sigma, p = z.rho[j], z.sigma[j], z.p[j]
    of_stress = (1 if sigma > z.peak_stress[j] else 0) + (1 if sigma < z.peak_tension[j] else 0)
    return of_stress + (1 if p > z.peak_pressure[j] else 0) + (1 if rho > z.peak_density[j] else 0)


def keep_peaks(count, z, bad, new):
    """Count `bad` zones, and record the `new` peaks of a piece.

    Peaks are written only where a piece has a new one: most have none, and rows that are only read need not go back to memory.
    """
    rows_apart()
    z.found[FOUND_UNSOUND] += bad
    if new > 0:
        for j in range(count):
            rho, sigma, p = z.rho[j], z.sigma[j], z.p[j]
            z.peak_stress[j] = sigma if sigma > z.peak_stress[j] else z.peak_stress[j]
            z.peak_tension[j] = sigma if sigma < z.peak_tension[j] else z.peak_tension[j]
            z.peak_pressure[j] = p if p > z.peak_pressure[j] else z.peak_pressure[j]
            z.peak_density[j] = rho if rho > z.peak_density[j] else z.peak_density[j]


@zone_pass(PeakRows, exact=True)
def look_over(count, z, dt, numbers, law):
    """Counts zones with a density that is not positive or a sound speed that is not a finite number; records the peaks on the way."""
    rows_apart()
    bad = new = 0
    for j in range(count):
        bad += unsound(z, j)
        new += new_peaks(z, j)
    keep_peaks(count, z, bad, new)


def first_unsound(rho, c, sigma) -> int:
    """First of the zones `look_over` counts, or -1; arrays of density, sound speed and stress."""
    sound = (rho >= 0.0) & (rho < LIMIT) & (c >= 0.0) & (c < LIMIT) & (np.abs(sigma) * STRESS_SCALE < LIMIT)
    return int(np.argmin(sound)) if not sound.all() else -1


for _function in (unsound, new_peaks, keep_peaks):
    bind(_function, **INLINE)
