r"""Spall at a tension proportional to the square root of its gradient: a short pulse needs a higher tension than a long one.

$$\sigma_t \ge \max\left(\sigma_{least},\; A\sqrt{|d\sigma_t/dx|}\right), \qquad A = \sigma_r/\sqrt{G_r}$$

A is given as the strength sigma_r at a reference gradient G_r, so that every parameter has a simple unit. sigma_least is the
strength where the tension is uniform; without it any uniform tension would break the material. Noise behind a wave has
hardly any gradient, so sigma_least should not be far below the tension at which the material is expected to break. The criterion is
evaluated at nodes inside a region, with the mean tension of the zones beside the node and the larger of the slopes over four zones
on either side of it. At the front of a wave, whose slope is set by the mesh, and at the peak beside it, the material therefore breaks only
where it would also break in the flow behind.

A triangular pulse of peak P and length L that reaches a free surface leaves a tension that grows from the surface as 2 P x / L. It spalls
at the depth $A\sqrt{L/(2P)}$, at the tension $A\sqrt{2P/L}$, and again at the same distance as long as the pulse lasts.

The law has no default constants: the open literature gives its form, and its equivalence to an impulse criterion (Tuler & Butcher 1968),
but no values for metals.

Source: Breed, Mader & Venable, J. Appl. Phys. 38 (1967) 3271; mentioned without an equation in Wilkins B.4 (a).
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax, vsqrt
from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE


class StressGradient(NamedTuple):
    strength: float
    gradient: float
    least: float


def failure(tension, p, v, damage, par):
    """In a uniform tension."""
    return tension / par.least


def damage_rate(tension, par):
    return 0.0


def tension_cap(void_fraction, par):
    """The strength depends on what lies around."""
    return NO_LIMIT


def at_node(tension, p, v, slope, par):
    return tension / fmax(par.least, par.strength * vsqrt(slope / par.gradient))


def build(**values):
    """Parameters, all positive."""
    par = StressGradient(**values)
    for name, value in zip(par._fields, par):
        if not value > 0.0:
            raise OutOfRange(f"{name} = {value:g} must be positive")
    return par


FRACTURE.add(
    "stress_gradient", StressGradient,
    functions=[failure, damage_rate, tension_cap, at_node],
    example=StressGradient(1.0e9, 1.0e12, 0.2e9),
    build=build,
    units={"strength": "Pa", "gradient": "Pa/m", "least": "Pa"},
    meaning={"strength": "tension that breaks the material at the reference gradient", "gradient": "reference gradient of the tension",
             "least": "tension that breaks the material however small the gradient"},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Breed, Mader & Venable, J. Appl. Phys. 38 (1967) 3271", "Tuler & Butcher, Int. J. Fracture Mech. 4 (1968) 431"),
    flags=("nodes",),
)
