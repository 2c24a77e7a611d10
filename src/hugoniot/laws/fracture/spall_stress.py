r"""Spall at a critical normal stress.

$$\text{failure} = \frac{\sigma_t}{\sigma_{spall}}, \qquad \sigma_t = s_1 - p$$

sigma_t is the longitudinal tensile stress (viscous pressure excluded). The material parts the moment it reaches the strength.

Source: Herrmann WL-TR-64-107, section VI (spall at a critical tensile stress); Wilkins B.4 (a) names such criteria.
"""

from typing import NamedTuple

from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE


class SpallStress(NamedTuple):
    strength: float


def failure(tension, p, v, damage, par):
    return tension / par.strength


def damage_rate(tension, par):
    return 0.0


def tension_cap(par):
    return par.strength


def build(strength):
    """Parameters; strength is a positive tension."""
    if not strength > 0.0:
        raise OutOfRange(f"strength = {strength:g} Pa must be positive (tension); leave [fracture] out for a material that never spalls")
    return SpallStress(strength)


FRACTURE.add(
    "spall_stress", SpallStress,
    functions=[failure, damage_rate, tension_cap],
    example=SpallStress(1.0e9),
    build=build,
    units={"strength": "Pa"},
    meaning={"strength": "longitudinal tension at which the material parts"},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Herrmann, WL-TR-64-107, section VI", "Wilkins, B.4 (a)"),
)
