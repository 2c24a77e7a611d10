r"""Spall at a critical normal stress, with the growth of voids around the spall plane.

$$\text{failure} = \frac{\sigma_t}{\sigma_{spall}}, \qquad \sigma_t = s_1 - p, \qquad
  \sigma_t \le \sigma_{spall}\left(1 - \phi/\phi_c\right)$$

sigma_t is the longitudinal tensile stress (without viscous pressure). Where it first reaches the strength the material separates in one
plane. Until the release from this void arrives, the surrounding zones would reach tensions the material cannot support.
Instead voids (volume fraction phi) grow there at a tension equal to the strength, which falls to zero when they coalesce at phi_c. The
voids close again at zero longitudinal stress. A zone that contains voids opens no second plane.

Source: Herrmann WL-TR-64-107, section VI (spall at a critical tensile stress); Wilkins B.4 (a) names such criteria. The growth of
voids, and the linear fall of the strength with their volume fraction, are closures of this package; neither source gives a rule.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax
from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE


class SpallStress(NamedTuple):
    strength: float
    coalescence: float = 0.1


def failure(tension, p, v, damage, par):
    return tension / par.strength


def damage_rate(tension, par):
    return 0.0


def tension_cap(void_fraction, par):
    return par.strength * fmax(1.0 - void_fraction / par.coalescence, 0.0)


def build(strength, coalescence=0.1):
    """Parameters; strength is a positive tension, coalescence a volume fraction between 0 and 1."""
    if not strength > 0.0:
        raise OutOfRange(f"strength = {strength:g} Pa must be positive (tension); omit [fracture] for a material that never spalls")
    if not 0.0 < coalescence < 1.0:
        raise OutOfRange(f"coalescence = {coalescence:g} must lie between 0 and 1 (it is a volume fraction of voids)")
    return SpallStress(strength, coalescence)


FRACTURE.add(
    "spall_stress", SpallStress,
    functions=[failure, damage_rate, tension_cap],
    example=SpallStress(1.0e9),
    build=build,
    units={"strength": "Pa", "coalescence": "1"},
    meaning={"strength": "longitudinal tension at which the material spalls",
             "coalescence": "void fraction at which a zone has lost its strength"},
    defaults={"coalescence": 0.1},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Herrmann, WL-TR-64-107, section VI", "Wilkins, B.4 (a)"),
    flags=("voids",),
)
