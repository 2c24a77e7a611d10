r"""How much a second shock deviates from the principal Hugoniot: appendix A of Wilkins, equations A.1 to A.4.

The equation of state is, with constants $a$, $b$ (pressures) and $c$ (a number),

$$P = a\mu + b\mu^2 + c(1+\mu)E, \qquad \mu = \rho/\rho_0 - 1$$

where $E$ is the energy per volume at the reference density $\rho_0$. Labels such as A.1 are equations of Wilkins. The principal Hugoniot
(A.1) and its cubic series (A.2) are

$$P = \frac{a\mu + b\mu^2}{1 - \tfrac c2\mu} = a\mu + (b + \tfrac{ac}2)\mu^2 + \tfrac c2(b + \tfrac{ac}2)\mu^3 + \dots$$

A second shock starts from a point of the principal Hugoniot, with the compression $\mu_1$, the pressure $P_1$ and the relative volume
$V_1 = 1/(1 + \mu_1)$. Its exact Hugoniot (A.3) is, with $\delta = 1 - V_1$ and $V = 1/(1+\mu)$,

$$P = \frac{a\mu + b\mu^2 + \tfrac c2P_1\mu}{1 - \tfrac c2\left(\mu - \delta/V\right)}$$

and the corrected series (A.4) is

$$P = \Big[a\mu + (b + \tfrac{ac}2)\mu^2 + \tfrac c2(b + \tfrac{ac}2)\mu^3\Big]
  - \frac c2\mu\Big[a\frac\delta V + (b + ac)\mu\frac\delta V - \frac c2 a\frac{\delta^2}{V^2}\Big]
  + \frac c2\mu P_1\Big[1 + \frac c2\Big(\mu - \frac\delta V\Big)\Big]$$

In our copy the printed form of (A.4) is damaged. As far as it is legible it exceeds (A.3) by 17 to 21 % at $\mu$ = 0.15 to 0.25, for
$\mu_1 = 0.10$ and Wilkins' constants (W-E1). The difference between the two Hugoniots is of third order in the compression, not of higher
order as the source says.

In the functions, `mu` and `mu1` are the compressions $\mu$ and $\mu_1$, and `law` is a `Quadratic`, the constants of the equation of state.
Pressures are in the unit of $a$ and $b$.

Source: Wilkins, appendix A.
"""

from typing import NamedTuple

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import law_of


class Quadratic(NamedTuple):
    """Constants of the equation of state: a and b, pressures in the same unit, and c, a number."""

    a: float
    b: float
    c: float


def of_material(material) -> tuple[Quadratic, float]:
    """A `Quadratic` that represents a material near its reference state, with a and b in Pa, and the reference density, kg/m3.

    a is the bulk modulus and c the Grüneisen parameter there; b follows from the curvature of the principal Hugoniot at weak shocks. For
    a linear Us-up relation of slope s and constant Grüneisen parameter it is a (2s - 1 - c/2).
    """
    ahead = Initial.at_rest(material)
    par = law_of(material)
    a = float(contract.bulk_modulus(ahead.density, ahead.energy, par))
    c = float(contract.gruneisen(ahead.density, ahead.energy, par))
    steps = np.array([1e-3, 2e-3, 4e-3])
    rise = np.array([shock(material, ahead, density=ahead.density * (1.0 + m)).pressure for m in steps.tolist()]) - ahead.pressure
    near = (rise / steps - a) / steps
    # P/mu = a + k mu + ...: two steps of Richardson's extrapolation of k to mu = 0
    once = 2.0 * near[:2] - near[1:]
    return Quadratic(a, float((4.0 * once[0] - once[1]) / 3.0 - 0.5 * a * c), c), ahead.density


def principal(mu, law: Quadratic):
    """(A.1): pressure on the principal Hugoniot. Raises OutOfRange for mu of 2/c and above: the pressure is infinite at 2/c."""
    mu = _checked(mu, 2.0 / law.c, "principal Hugoniot")
    return (law.a * mu + law.b * mu**2) / (1.0 - 0.5 * law.c * mu)


def principal_series(mu, law: Quadratic):
    """(A.2): pressure on the principal Hugoniot by the cubic series, which Wilkins gives for mu < 0.25."""
    mu = np.asarray(mu, float)
    k = law.b + 0.5 * law.a * law.c
    return (law.a * mu + k * mu**2 + 0.5 * law.c * k * mu**3)[()]


def second(mu, mu1: float, law: Quadratic):
    """(A.3): pressure on the Hugoniot of the second shock, for mu >= mu1."""
    mu = np.asarray(mu, float)
    if (mu < mu1).any():
        raise OutOfRange(f"a second shock from mu1 = {mu1} compresses further: give mu >= {mu1}")
    expansion = mu - _shift(mu, mu1)
    if (0.5 * law.c * expansion >= 1.0).any():
        raise OutOfRange(f"mu = {np.max(mu):.6g} is beyond the compression limit of the second shock, c (mu - delta/V) = 2")
    p1 = principal(mu1, law)
    return ((law.a * mu + law.b * mu**2 + 0.5 * law.c * p1 * mu) / (1.0 - 0.5 * law.c * expansion))[()]


def second_series(mu, mu1: float, law: Quadratic):
    """(A.4) corrected (W-E1): pressure on the Hugoniot of the second shock by the series, with P1 from (A.2) as in Wilkins."""
    mu = np.asarray(mu, float)
    a, b, c = law
    shift, p1 = _shift(mu, mu1), principal_series(mu1, law)
    bracket = a * shift + (b + a * c) * mu * shift - 0.5 * c * a * shift**2
    return (principal_series(mu, law) - 0.5 * c * mu * bracket + 0.5 * c * mu * p1 * (1.0 + 0.5 * c * (mu - shift)))[()]


def second_series_as_printed(mu, mu1: float, law: Quadratic):
    """(A.4) as printed, to show that this form is wrong; a, b and c as Wilkins gives them, in Mbar, because the form mixes units."""
    mu = np.asarray(mu, float)
    a, b, c = law
    shift = _shift(mu, mu1)
    bracket = a * shift + (b + 0.5 * a * c) * mu * shift - 0.5 * c * a * shift**2
    return (principal_series(mu, law) / (1.0 - 0.5 * c * bracket) + 0.5 * c * mu * principal_series(mu1, law))[()]


def leading_difference(mu, mu1: float, law: Quadratic):
    """Leading, third-order term of the second minus the principal Hugoniot: -(c/2)(a + b + ac/2) mu mu1 (mu - mu1)."""
    mu = np.asarray(mu, float)
    a, b, c = law
    return (-0.5 * c * (a + b + 0.5 * a * c) * mu * mu1 * (mu - mu1))[()]


def comparison(mu, mu1: float, law: Quadratic) -> dict:
    """Pressures of a second shock from mu1 and of the principal Hugoniot at the compressions mu, both exact and as series."""
    first, again = principal(mu, law), second(mu, mu1, law)
    return {"principal_pressure": first, "principal_series": principal_series(mu, law), "second_pressure": again,
            "second_series": second_series(mu, mu1, law), "difference": again - first,
            "leading_difference": leading_difference(mu, mu1, law)}


def _shift(mu, mu1):
    """delta/V = (1 - V1)(1 + mu)."""
    return (mu1 / (1.0 + mu1)) * (1.0 + mu)


def _checked(mu, limit, what):
    mu = np.asarray(mu, float)
    if (mu >= limit).any():
        raise OutOfRange(f"mu = {np.max(mu):.6g} is beyond the compression limit of the {what}, mu = {limit:.6g}")
    return mu[()]
