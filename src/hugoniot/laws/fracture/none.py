"""No fracture: the material supports any tension.

$$r = 0$$

A material breaks when its failure ratio $r$ reaches 1; here it stays at zero. This law is the
default for a material without a table `[material.NAME.fracture]`.
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT
from hugoniot.laws.fracture.contract import FRACTURE


class NoFracture(NamedTuple):
    pass


def failure(tension, p, v, damage, par):
    return 0.0


def damage_rate(tension, par):
    return 0.0


def tension_cap(void_fraction, par):
    return NO_LIMIT


FRACTURE.add(
    "none", NoFracture,
    functions=[failure, damage_rate, tension_cap],
    example=NoFracture(),
    units={}, meaning={},
    box={"tension": (-1e11, 1e11), "p": (-1e11, 1e11), "v": (0.1, 10.0), "damage": (0.0, 1.0)},
    references=("Wilkins, appendix B.4 (a), with an unreachable limit",),
    flags=("never",),
)
