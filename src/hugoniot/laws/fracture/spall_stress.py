r"""Spall at a critical tension, with the growth of voids around the spall plane.

$$\frac{\sigma_t}{\sigma_s} \ge 1, \qquad \sigma_t = s_1 - p; \qquad
  \sigma_t \le \sigma_s\left(1 - \phi/\phi_c\right) \text{ where voids grow}$$

* $\sigma_t$: longitudinal tensile stress, without artificial viscosity; $s_1$: longitudinal stress deviator, positive in tension;
  $p$: pressure
* $\sigma_s$: spall strength, `strength`
* $\phi$: volume fraction of voids; $\phi_c$: the fraction at which they coalesce, `coalescence`

Where $\sigma_t$ first reaches $\sigma_s$ the material separates in one plane. Before the release from this plane arrives, the
adjoining zones would reach tensions that the material cannot support. Voids grow in them instead, at a tension that falls linearly from
$\sigma_s$ to zero at $\phi_c$. On compression the voids close at zero longitudinal stress. A zone that contains voids opens no second
plane.

The strength does not depend on the rate of loading. The rule for the growth of voids is this package's own: the sources give only the
criterion.
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
    meaning={"strength": "spall strength, a longitudinal tension",
             "coalescence": "void fraction at which the strength vanishes"},
    defaults={"coalescence": 0.1},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    references=("Herrmann, WL-TR-64-107 (1964), section VI", "Wilkins, appendix B.4 (a)"),
    flags=("voids",),
)
