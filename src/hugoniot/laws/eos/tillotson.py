r"""Tillotson equation of state, for metals and rocks in hypervelocity impact, from the solid to the vapour.

With $X = \rho/\rho_0$, $\mu = X - 1$ and $\omega = e/(E_0X^2) + 1$, compressed or cold material has

$$p_1 = \left(a + \frac{b}{\omega}\right)\rho e + A\mu + B\mu^2 \qquad (X \ge 1 \text{ or } e \le E_{iv}),$$

expanded material hot enough to be vapour

$$p_3 = a\rho e + \left[\frac{b\rho e}{\omega} + A\mu\,e^{-\beta(1/X - 1)}\right]e^{-\alpha(1/X - 1)^2} \qquad (X < 1,\ e \ge E_{cv}),$$

and between the energies of incipient and complete vaporisation $E_{iv}$ and $E_{cv}$, for $X < 1$,
$p = [(e - E_{iv})p_3 + (E_{cv} - e)p_1]/(E_{cv} - E_{iv})$. The pressure is continuous at every boundary, but its slopes are not. The law
is not linear in the energy, and it does not describe melting or the coexistence of liquid and vapour. The theory gives only the pressure.

Source: Tillotson, General Atomic GA-3216 (1962); interpolation as in Melosh, Impact Cratering (1989), App. II.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp
from hugoniot.laws.eos.contract import EOS


class Tillotson(NamedTuple):
    rho0: float
    a: float
    b: float
    bulk_a: float
    bulk_b: float
    alpha: float
    beta: float
    e0: float
    e_incipient: float
    e_complete: float


def _condensed(rho, e, par):
    """(p, dp/drho, dp/de) of the compressed or cold branch."""
    x = rho / par.rho0
    mu = x - 1.0
    q = par.b / (e / (par.e0 * x * x) + 1.0)
    # b/omega: d(b/omega)/de = -(b/omega)(1 - 1/omega)/e and by rho +2 (b/omega)(1 - 1/omega)/rho
    soft = q * (1.0 - q / par.b)
    return ((par.a + q) * rho * e + mu * (par.bulk_a + par.bulk_b * mu),
            (par.a + q + 2.0 * soft) * e + (par.bulk_a + 2.0 * par.bulk_b * mu) / par.rho0,
            (par.a + q - soft) * rho)


def _vapour(rho, e, par):
    """(p, dp/drho, dp/de) of the hot expanded branch."""
    x = rho / par.rho0
    stretch = 1.0 / x - 1.0
    q = par.b / (e / (par.e0 * x * x) + 1.0)
    soft = q * (1.0 - q / par.b)
    cold = par.bulk_a * (x - 1.0) * vexp(-par.beta * stretch)
    decay = vexp(-par.alpha * stretch * stretch)
    # d(stretch)/drho = -1/(x rho)
    gain = 2.0 * par.alpha * stretch / (x * rho)
    cold_slope = cold * par.beta / (x * rho) + par.bulk_a / par.rho0 * vexp(-par.beta * stretch)
    return (par.a * rho * e + (q * rho * e + cold) * decay,
            par.a * e + ((q + 2.0 * soft) * e + cold_slope + gain * (q * rho * e + cold)) * decay,
            (par.a + (q - soft) * decay) * rho)


def _share(e, par):
    """Weight of the vapour branch in expansion."""
    w = (e - par.e_incipient) / (par.e_complete - par.e_incipient)
    return 0.0 if w < 0.0 else (1.0 if w > 1.0 else w)


def pressure(rho, e, par):
    p1 = _condensed(rho, e, par)[0]
    if rho >= par.rho0 or e <= par.e_incipient:
        return p1
    w = _share(e, par)
    return p1 + w * (_vapour(rho, e, par)[0] - p1)


def pressure_derivatives(rho, e, par):
    p1, r1, e1 = _condensed(rho, e, par)
    if rho >= par.rho0 or e <= par.e_incipient:
        return r1, e1
    p3, r3, e3 = _vapour(rho, e, par)
    w = _share(e, par)
    jump = (p3 - p1) / (par.e_complete - par.e_incipient) if e < par.e_complete else 0.0
    return r1 + w * (r3 - r1), e1 + w * (e3 - e1) + jump


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "tillotson", Tillotson,
    functions=[pressure, pressure_derivatives, reference_state, density_limits],
    example=Tillotson(2700.0, 0.5, 1.63, 75.2e9, 65e9, 5.0, 5.0, 5e6, 3e6, 13.9e6),
    units={"rho0": "kg/m^3", "a": "1", "b": "1", "bulk_a": "Pa", "bulk_b": "Pa", "alpha": "1", "beta": "1", "e0": "J/kg",
           "e_incipient": "J/kg", "e_complete": "J/kg"},
    meaning={"rho0": "reference density", "a": "Grüneisen parameter of the hot gas",
             "b": "Grüneisen parameter in the reference state minus `a`", "bulk_a": "A, bulk modulus in the reference state",
             "bulk_b": "B, coefficient of (rho/rho0 - 1)^2 in the pressure",
             "alpha": "coefficient in exp(-alpha (rho0/rho - 1)^2), a factor of all terms except `a` rho e in the pressure of expanded "
                      "vapour",
             "beta": "coefficient in exp(-beta (rho0/rho - 1)), a further factor of the term with A in the pressure of expanded vapour",
             "e0": "specific energy at which, at the reference density, the coefficient of rho e in the pressure has fallen "
                   "from `a` + `b` to `a` + `b`/2",
             "e_incipient": "specific energy of incipient vaporisation", "e_complete": "specific energy of complete vaporisation"},
    box={"rho": (2400.0, 7000.0), "e": (0.0, 5e7)},
    above={"e0": 0.0, "e_incipient": 0.0, "e_complete": 0.0},
    least={"alpha": 0.0, "beta": 0.0},
    references=("Tillotson, General Atomic GA-3216 (1962)", "Melosh, Impact Cratering (1989), App. II"),
)
