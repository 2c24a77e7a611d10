r"""JWL++: burning at a rate proportional to a power of the pressure, with first-order depletion.

$$\dot\lambda = G\,p^b\,(1-\lambda)$$

* $\lambda$: burned mass fraction, 0 to 1; $\dot\lambda$: its rate of change
* $p$: pressure of the mixture with the artificial viscosity added
* $G$, $b$: `g`, `b`; a published $G$ in $\mathrm{\mu s^{-1}\,Mbar^{-b}}$ is multiplied by $10^{6-11b}$

The pressure of a burning zone follows from the mixture law of the material. With the default, `weighted_pressures`, it is the mean of the
pressures of unreacted explosive and products, weighted by their mass fractions.
"""

from typing import NamedTuple

from hugoniot.laws.burn.contract import BURN, no_schedule
from hugoniot.laws.burn.depletion import deplete, power, without_negatives


class JWLPlusPlus(NamedTuple):
    g: float
    b: float


def rate(burn_fraction, rho, p, temperature, par):
    return par.g * power(p, par.b) * (1.0 - burn_fraction)


def advance(burn_fraction, dt, rho, p, temperature, par):
    return deplete(burn_fraction, dt * par.g * power(p, par.b), 1.0)


def build(*values, **named) -> JWLPlusPlus:
    """Parameters; OutOfRange for a negative one."""
    return without_negatives(JWLPlusPlus(*values, **named))


BURN.add(
    "jwl_plus_plus", JWLPlusPlus,
    functions={"rate": rate, "advance": advance, "scheduled": no_schedule},
    example=JWLPlusPlus(3.5083e-7, 1.3),
    units={"g": "1/(Pa^b s)", "b": "1"}, meaning={"g": "G, rate constant", "b": "power of the pressure"},
    box={"p": (0.0, 60.0e9)},
    references=("Souers et al., Propellants, Explosives, Pyrotechnics 25 (2000) 54",),
    flags=("pressure_driven", "includes_viscosity"),
    build=build,
)
