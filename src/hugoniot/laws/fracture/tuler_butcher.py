r"""Tuler-Butcher cumulative damage: a high tension breaks the material immediately, a lower one after a delay.

$$\frac{dD}{dt} = \frac{1}{\tau}\left(\frac{\sigma_t - \sigma_0}{\sigma_r}\right)^{\lambda} \text{ for } \sigma_t > \sigma_0,
  \qquad \text{failure at } D = 1$$

* $D$: damage, from 0 to 1; $\sigma_t$: longitudinal tensile stress
* $\sigma_0$: tension below which there is no damage, `threshold`
* $\lambda$: `exponent`
* $\sigma_r$, $\tau$: `reference_stress`, `critical_time`; a tension of $\sigma_0 + \sigma_r$ breaks the material in the time $\tau$

The original form is $\int(\sigma_t - \sigma_0)^\lambda\,dt = K$, so that $K = \sigma_r^\lambda\tau$. The law does not limit the tension,
which may rise further until the damage is complete.
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE


class TulerButcher(NamedTuple):
    threshold: float
    exponent: float
    reference_stress: float
    critical_time: float


def failure(tension, p, v, damage, par):
    return damage


def damage_rate(tension, par):
    excess = (tension - par.threshold) / par.reference_stress
    return vpow(excess, par.exponent) / par.critical_time if excess > 0.0 else 0.0


def tension_cap(void_fraction, par):
    """The criterion bounds an integral, not the tension itself."""
    return NO_LIMIT


def build(**values):
    """Parameters; reference stress, critical time and exponent are positive."""
    par = TulerButcher(**values)
    for name in ("exponent", "reference_stress", "critical_time"):
        if not getattr(par, name) > 0.0:
            unit = FRACTURE.of(par).units[name].replace("1", "")
            raise OutOfRange(f"{name} must be positive, got {getattr(par, name):g} {unit}".rstrip())
    return par


FRACTURE.add(
    "tuler_butcher", TulerButcher,
    functions=[failure, damage_rate, tension_cap],
    example=TulerButcher(0.5e9, 2.0, 1.0e9, 0.2e-6),
    build=build,
    units={"threshold": "Pa", "exponent": "1", "reference_stress": "Pa", "critical_time": "s"},
    meaning={"threshold": "tension below which there is no damage", "exponent": "lambda, power of the tension above the threshold",
             "reference_stress": "excess of the tension over the threshold that breaks the material in the critical time",
             "critical_time": "time to failure under the threshold plus the reference stress"},
    box={"tension": (-1e11, 1e10), "p": (-1e10, 1e11), "v": (0.3, 1.5), "damage": (0.0, 1.0)},
    least={"threshold": 0.0},
    references=("Tuler & Butcher, Int. J. Fracture Mech. 4 (1968) 431, equation 1",),
    flags=("cumulative",),
)
