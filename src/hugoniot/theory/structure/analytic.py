r"""Closed-form solutions of the shock structure of an ideal gas with constant viscosity and Prandtl number 3/4 (Becker).

With $\phi = u/u_1$, total enthalpy is constant through the shock and momentum integrates to

$$\frac{(1-\phi)}{(\phi-\alpha)^{\alpha}} = \exp\!\left[\beta(1-\alpha)\,\mathrm{Ma}\,(\zeta-\zeta_0)\right], \qquad
  \frac{d\phi}{d\zeta} = -\beta\,\mathrm{Ma}\,\frac{(1-\phi)(\phi-\alpha)}{\phi},$$
$$\alpha = \frac{\gamma-1}{\gamma+1}+\frac{2}{(\gamma+1)\mathrm{Ma}^2}, \qquad \beta = \frac98(\gamma+1)\sqrt{\frac{\pi}{8\gamma}},
  \qquad \zeta = x/\lambda_{\rm bsl}.$$

Source: Jordan eq. 6.3.1, lost in the scan and restored (J-E17), after Bird, Stewart and Lightfoot, Transport Phenomena; Becker,
Z. Phys. 8 (1922) 321.
Jordan's table 6.2.1.2 lists the velocity thickness of this solution under the heading of density thicknesses (J-E3).
"""

import math
from dataclasses import dataclass

import numpy as np

from hugoniot.errors import OutOfRange


@dataclass(frozen=True)
class BeckerShock:
    """The closed-form solution for one Mach number and ratio of specific heats; lengths in the mean free path lambda_bsl ahead."""

    mach: float
    gamma: float = 5.0 / 3.0

    def __post_init__(self):
        if not self.mach > 1.0:
            raise OutOfRange(f"Mach {self.mach:g} is not a shock; give mach above 1")
        if not self.gamma > 1.0:
            raise OutOfRange(f"an ideal gas needs gamma above 1, got {self.gamma:g}")

    @property
    def alpha(self) -> float:
        """u2/u1 = rho1/rho2."""
        g = self.gamma
        return (g - 1.0) / (g + 1.0) + 2.0 / ((g + 1.0) * self.mach**2)

    @property
    def beta(self) -> float:
        return 9.0 / 8.0 * (self.gamma + 1.0) * math.sqrt(math.pi / (8.0 * self.gamma))

    def velocity(self, zeta, zeta0: float = 0.0):
        """u/u1 at zeta = x/lambda_bsl: Newton on s = log((1 - phi)/(phi - alpha)), in which the equation is nearly linear."""
        a = self.alpha
        target = self.beta * (1.0 - a) * self.mach * (np.asarray(zeta, float) - zeta0) - (1.0 - a) * math.log(1.0 - a)
        s = np.where(target > 0.0, target / a, target)
        for _ in range(60):
            soft = np.logaddexp(0.0, s)
            change = (s - (1.0 - a) * soft - target) / (1.0 - (1.0 - a) * np.exp(s - soft))
            s = s - change
            if np.all(np.abs(change) <= 1e-15 * (1.0 + np.abs(s))):
                break
        return a + (1.0 - a) * np.exp(-np.logaddexp(0.0, s))

    def slope(self, phi):
        """d(u/u1)/d zeta."""
        return -self.beta * self.mach * (1.0 - phi) * (phi - self.alpha) / phi

    @property
    def velocity_thickness(self) -> float:
        """(u1 - u2)/max|du/dx| in lambda_bsl: (1 + sqrt(alpha)) / ((1 - sqrt(alpha)) beta Ma)."""
        root = math.sqrt(self.alpha)
        return (1.0 + root) / ((1.0 - root) * self.beta * self.mach)

    @property
    def density_thickness(self) -> float:
        """(rho2 - rho1)/max|drho/dx| in lambda_bsl; the steepest point solves phi^2 - 2(1+alpha)phi + 3 alpha = 0."""
        a = self.alpha
        phi = (1.0 + a) - math.sqrt((1.0 + a) ** 2 - 3.0 * a)
        return (1.0 / a - 1.0) / (-self.slope(phi) / phi**2)

    def entropy_jump(self, gas_constant: float) -> float:
        """Entropy gained, J/(kg K): R/(gamma-1) log(p2/p1) - gamma R/(gamma-1) log(rho2/rho1) (Jordan eq. 6.2.4, in J: J-E1)."""
        g = self.gamma
        pressures = 1.0 + 2.0 * g / (g + 1.0) * (self.mach**2 - 1.0)
        return gas_constant / (g - 1.0) * (math.log(pressures) + g * math.log(self.alpha))
