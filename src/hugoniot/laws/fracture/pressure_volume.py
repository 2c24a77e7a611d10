r"""Fracture when the pressure is low enough and the volume large enough.

$$P < P_S \;\text{ and }\; V > V_S \quad\Longleftrightarrow\quad \min\left(\frac{P}{P_S}, \frac{V}{V_S}\right) > 1, \qquad P_S < 0$$

V is the relative volume rho0/rho. The second condition prevents hot, dense material from fracturing in a passing rarefaction.

Source: Wilkins B.4 (a), opening of a void.
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmin
from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE


class PressureVolume(NamedTuple):
    pressure_limit: float
    volume_limit: float = 1.0


def failure(tension, p, v, damage, par):
    return fmin(p / par.pressure_limit, v / par.volume_limit)


def damage_rate(tension, par):
    return 0.0


def tension_cap(void_fraction, par):
    """The volume gate lets the tension go on beyond the pressure limit."""
    return NO_LIMIT


def build(pressure_limit, volume_limit=1.0):
    """Parameters; the pressure limit is a tension, hence negative, and the volume limit positive."""
    if not pressure_limit < 0.0:
        raise OutOfRange(f"pressure_limit = {pressure_limit:g} Pa must be negative (a tension)")
    if not volume_limit > 0.0:
        raise OutOfRange(f"volume_limit = {volume_limit:g} must be positive; 1 is the volume at rest")
    return PressureVolume(pressure_limit, volume_limit)


FRACTURE.add(
    "pressure_volume", PressureVolume,
    functions=[failure, damage_rate, tension_cap],
    example=PressureVolume(-1.0e9, 1.01),
    build=build,
    units={"pressure_limit": "Pa", "volume_limit": "1"},
    meaning={"pressure_limit": "P_S, pressure below which the material may fracture (negative)",
             "volume_limit": "V_S, relative volume above which the material may fracture"},
    defaults={"volume_limit": 1.0},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Wilkins, B.4 (a)",),
)
