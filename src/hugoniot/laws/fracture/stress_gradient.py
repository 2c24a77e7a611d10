r"""Spall at a tension proportional to the square root of its gradient, but not below a minimum value: short pulses need a higher tension.

$$\sigma_t \ge \max\left(\sigma_m,\; A\sqrt{|d\sigma_t/dx|}\right), \qquad A = \sigma_r/\sqrt{G_r}$$

* $\sigma_t$: longitudinal tensile stress
* $\sigma_r$: strength at the reference gradient $G_r$, `strength` and `gradient`
* $\sigma_m$: strength in a uniform tension, `least`; without it, any uniform tension would break the material

Oscillations behind a wave have small gradients, so $\sigma_m$ should not be far below the tension at which the material is expected to
break. The criterion is evaluated at nodes inside a material: $\sigma_t$ is the mean of the two adjoining zones, and the gradient is the
larger of the slopes over four zones on either side.

A triangular pulse of peak $P$ and length $L$ that reaches a free surface produces a tension $2Px/L$ at the depth $x$. The material
spalls at the depth $A\sqrt{L/(2P)}$ and the tension $A\sqrt{2P/L}$, and again at equal distances while the pulse lasts.

The law is for one-dimensional runs of inert materials. It has no default constants, because no published values were available for
checking; those of the example only show the syntax. Tuler & Butcher relate the law to an impulse criterion.
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
            raise OutOfRange(f"{name} must be positive, got {value:g} {FRACTURE.of(par).units[name]}")
    return par


FRACTURE.add(
    "stress_gradient", StressGradient,
    functions=[failure, damage_rate, tension_cap, at_node],
    example=StressGradient(1.0e9, 1.0e12, 0.2e9),
    build=build,
    units={"strength": "Pa", "gradient": "Pa/m", "least": "Pa"},
    meaning={"strength": "tension at which the material breaks at the reference gradient", "gradient": "reference gradient of the tension",
             "least": "lower limit of the tension at which the material breaks; a uniform tension breaks it there"},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Breed, Mader & Venable, J. Appl. Phys. 38 (1967) 3271",
                "Tuler & Butcher, Int. J. Fracture Mech. 4 (1968) 431, for the impulse criterion"),
    flags=("nodes",),
)
