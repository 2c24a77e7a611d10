r"""No strength: the material is a fluid.

$$G = 0, \qquad Y = 0$$

The shear modulus $G$ and the flow stress $Y$ vanish, so the stress is the pressure alone. This law is the default for a material
without a table `[material.NAME.strength]`.
"""

from typing import NamedTuple

from hugoniot.laws.strength.contract import STRENGTH


class NoStrength(NamedTuple):
    pass


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    return 0.0


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    return 0.0


STRENGTH.add(
    "none", NoStrength,
    functions=[shear_modulus, flow_stress],
    example=NoStrength(),
    units={}, meaning={},
    box={"rho": (1.0, 2e4), "p": (-1e10, 1e12), "temperature": (0.0, 1e4), "bulk_modulus": (0.0, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Wilkins, appendix B.1, item 9, with zero yield stress",),
    flags=("fluid",),
)
