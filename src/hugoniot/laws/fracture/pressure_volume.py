r"""Fracture of a zone whose pressure falls below a limit while its volume exceeds another.

$$P < P_S \;\text{ and }\; V > V_S, \qquad P_S < 0$$

* $P$: pressure of the zone; $P_S$: limit of $P$, a tension and therefore negative, `pressure_limit`
* $V = \rho_0/\rho$: volume relative to that at the reference density $\rho_0$; $V_S$: limit of $V$, `volume_limit`

Where both conditions hold, a void opens at a face of the zone. The condition on the volume keeps material that has
expanded little from breaking under a tension. The law does not limit the tension: it may exceed $|P_S|$ before the volume reaches $V_S$.
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
        raise OutOfRange(f"volume_limit = {volume_limit:g} must be positive; 1 is the volume at the reference density")
    return PressureVolume(pressure_limit, volume_limit)


FRACTURE.add(
    "pressure_volume", PressureVolume,
    functions=[failure, damage_rate, tension_cap],
    example=PressureVolume(-1.0e9, 1.01),
    build=build,
    units={"pressure_limit": "Pa", "volume_limit": "1"},
    meaning={"pressure_limit": "P_S, pressure below which the material may fracture (negative)",
             "volume_limit": "V_S, volume relative to that at the reference density, above which the material may fracture"},
    defaults={"volume_limit": 1.0},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Wilkins, appendix B.4 (a), opening of a void",),
)
