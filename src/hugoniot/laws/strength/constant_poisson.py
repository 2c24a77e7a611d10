r"""Elastic-perfectly plastic solid with a constant Poisson ratio: the shear modulus is proportional to the bulk modulus.

$$G = \frac{3\,(1 - 2\nu)}{2\,(1 + \nu)}\,K, \qquad Y = Y_0$$

* $G$: shear modulus; $Y$: flow stress in uniaxial stress
* $K$: isentropic bulk modulus of the equation of state, at the current density and energy
* $\nu$: Poisson ratio, `poisson_ratio`
* $Y_0$: yield stress, `yield_stress`

Use it where only the Poisson ratio is known: the material stiffens in shear as it does in bulk. The ratio of the longitudinal
sound speed $c_L$ to the bulk sound speed $c_b$ is then constant, $c_L^2/c_b^2 = 3(1-\nu)/(1+\nu)$, which is 1.5 for $\nu = 1/3$.
"""

from typing import NamedTuple

from hugoniot.errors import OutOfRange
from hugoniot.laws.strength.contract import STRENGTH


class ConstantPoisson(NamedTuple):
    poisson_ratio: float
    yield_stress: float


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    return 1.5 * (1.0 - 2.0 * par.poisson_ratio) / (1.0 + par.poisson_ratio) * bulk_modulus


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    return par.yield_stress


def build(poisson_ratio, yield_stress):
    """Parameters; a Poisson ratio outside (-1, 1/2] is no isotropic solid."""
    if not -1.0 < poisson_ratio <= 0.5:
        raise OutOfRange(f"poisson_ratio = {poisson_ratio:g} must lie between -1 and 0.5; metals lie between 0.25 and 0.45")
    return ConstantPoisson(poisson_ratio, yield_stress)


STRENGTH.add(
    "constant_poisson", ConstantPoisson,
    functions=[shear_modulus, flow_stress],
    example=ConstantPoisson(0.33, 0.3e9),
    build=build,
    units={"poisson_ratio": "1", "yield_stress": "Pa"},
    meaning={"poisson_ratio": "Poisson ratio", "yield_stress": "flow stress in uniaxial stress"},
    box={"rho": (2000.0, 5000.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Herrmann, WL-TR-64-107 (1964), appendix C.1, with C.17 corrected (H-E5)",),
    flags=("needs_bulk_modulus",),
)
