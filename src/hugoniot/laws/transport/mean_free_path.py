r"""Mean free path of a gas, m, in the definitions the literature uses, by name.

$$\lambda_{\rm bsl} = \frac{3\mu}{\rho\bar c},\qquad
  \lambda_{\rm chapman\_enskog} = \frac{16}{5}\frac{\mu}{\rho\sqrt{2\pi RT}},\qquad
  \lambda_{\rm viscous} = \frac{2\mu}{\rho\bar c} = \frac{\mu}{p}\sqrt{\frac{\pi RT}{2}},$$
$$\lambda_{\rm vhs} = \frac{2(5-2\omega)(7-2\omega)}{15}\frac{\mu}{\rho\sqrt{2\pi RT}},\qquad \bar c = \sqrt{8RT/\pi},\quad RT = p/\rho.$$

Jordan's table 6.2.1.1 mixes the first two: its "power law" block is in chapman_enskog, its other two in bsl (J-E4); the ratio of the
two is 1.4726. Sources: bsl, Bird, Stewart and Lightfoot (1960) eq. 1.4-9;
chapman_enskog, hard spheres in first approximation, as Alsmeyer
(J. Fluid Mech. 74 (1976) 497) uses it; viscous, Maxwell's; vhs, Bird, Molecular Gas Dynamics (1994), eq. 4.65.
"""

import difflib
import math

from hugoniot.errors import OutOfRange
from hugoniot.laws.transport.contract import viscosity

MEAN_FREE_PATHS = {
    "bsl": "3 mu / (rho cbar), Bird, Stewart and Lightfoot; elementary kinetic theory",
    "chapman_enskog": "(16/5) mu / (rho sqrt(2 pi R T)), hard spheres in the first Chapman-Enskog approximation (Alsmeyer's unit)",
    "viscous": "2 mu / (rho cbar) = (mu/p) sqrt(pi R T / 2), Maxwell",
    "vhs": "Bird's variable hard spheres with viscosity exponent omega",
}


def viscosity_exponent(rho: float, T: float, par) -> float:
    """omega = d ln mu / d ln T of a viscosity law at a state (kg/m3, K); the law's own where it is a power of temperature."""
    if hasattr(par, "exponent"):
        return float(par.exponent)
    if not T > 0.0:
        return 0.0
    step = 1e-4
    low, high = viscosity(rho, T * (1.0 - step), par), viscosity(rho, T * (1.0 + step), par)
    return (math.log(high) - math.log(low)) / (math.log1p(step) - math.log1p(-step))


def mean_free_path(definition: str, mu: float, rho: float, p: float, exponent: float) -> float:
    """Mean free path, m, of a gas of viscosity mu (Pa s), density rho (kg/m3) and pressure p (Pa).

    exponent   omega of mu ~ T^omega (`viscosity_exponent`), used by "vhs" only
    Raises `OutOfRange` for an unknown definition or a pressure that no gas has.
    """
    if definition not in MEAN_FREE_PATHS:
        near = difflib.get_close_matches(definition, MEAN_FREE_PATHS, n=1)
        hint = f"did you mean '{near[0]}'?" if near else f"known: {', '.join(MEAN_FREE_PATHS)}"
        raise OutOfRange(f"unknown mean free path '{definition}'; {hint}")
    if not p > 0.0:
        raise OutOfRange(f"a mean free path needs a gas: the pressure ahead is {p:g} Pa; give the mean free path itself, in m, instead "
                         "of a name")
    thermal = math.sqrt(p / rho)
    if definition == "bsl":
        return 3.0 * mu / (rho * thermal * math.sqrt(8.0 / math.pi))
    if definition == "viscous":
        return 2.0 * mu / (rho * thermal * math.sqrt(8.0 / math.pi))
    factor = 3.2 if definition == "chapman_enskog" else 2.0 * (5.0 - 2.0 * exponent) * (7.0 - 2.0 * exponent) / 15.0
    return factor * mu / (rho * thermal * math.sqrt(2.0 * math.pi))
