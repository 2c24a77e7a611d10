r"""JWL equation of state (Jones, Wilkins, Lee) for detonation products, with a constant Grüneisen parameter.

$$p = A\left(1 - \frac{\omega}{R_1V}\right)e^{-R_1V} + B\left(1 - \frac{\omega}{R_2V}\right)e^{-R_2V} + \omega\rho e,
  \qquad V = \rho_0/\rho$$

Here $e$ is an energy per mass. The detonation energy $E_0$ is per volume of unreacted explosive, as usually published: the products of a
constant-volume explosion have $e = E_0/\rho_0$. Constants are usually fitted to cylinder tests, which reach expansions of about $V = 7$.
The sound speed follows from

$$c^2 = \omega(\omega+1)\left[e_1\left(\frac{(R_1V)^2}{\omega(\omega+1)} - 1\right)e^{-R_1V}
      + e_2\left(\frac{(R_2V)^2}{\omega(\omega+1)} - 1\right)e^{-R_2V} + e\right],
  \quad e_1 = \frac{A}{R_1\rho_0},\; e_2 = \frac{B}{R_2\rho_0},$$

with the prefactor corrected (S-E10). All isentropes are $e_S = e_1e^{-R_1V} + e_2e^{-R_2V} + e_3V^{-\omega}$, each with its own constant
$e_3$. The temperature is $T = (e - e_C)/c_v$ with the cold isentrope $e_C$, whose constant is `cold_constant`. Leave it at 0 unless a
measured temperature of the products allows it to be fitted.

**Negative B.** Sets fitted to unreacted explosives have $B < 0$; for those use `jwl_unreacted`, which has the same pressure. The cold
pressure $f = Ae^{-R_1V} + Be^{-R_2V}$ then falls to its greatest tension at

$$V_t = \frac{1}{R_1 - R_2}\ln\frac{AR_1}{-BR_2}$$

and would rise again beyond, with an imaginary sound speed. The fit is not valid at such volumes. Beyond $V_t$ the cold pressure therefore
keeps the value $f(V_t)$, and the cold energy grows by $-f(V_t)(V - V_t)/\rho_0$. The law stays smooth to the first derivative, and with
`cold_constant` = 0 the sound speed is $c^2 = \omega(\omega+1)(e - e_C)$, real at any temperature above zero.

Source: Lee and Hornig (1969), as given by Starkenberg, ARL-TR-2161, appendix A-4 and A-9, with corrections S-E10 and S-E11.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, vexp, vlog
from hugoniot.laws.eos.contract import EOS


class JWL(NamedTuple):
    a: float
    b: float
    r1: float
    r2: float
    omega: float
    rho0: float
    e0: float = 0.0
    specific_heat: float = math.nan
    cold_constant: float = 0.0


def greatest_cold_tension(par):
    """Relative volume of the least cold pressure, beyond which that is kept; NO_LIMIT where it falls all the way (B >= 0)."""
    if not (par.a > 0.0 and par.b < 0.0 and par.r1 > par.r2):
        return NO_LIMIT
    return vlog(-par.a * par.r1 / (par.b * par.r2)) / (par.r1 - par.r2)


def fitted(v, par):
    """The relative volume at which the exponential terms are taken: v, up to that of the greatest cold tension."""
    torn = greatest_cold_tension(par)
    return v if v < torn else torn


def pressure(rho, e, par):
    whole = par.rho0 / rho
    v = fitted(whole, par)
    first, second = par.a * vexp(-par.r1 * v), par.b * vexp(-par.r2 * v)
    compression = par.omega / par.rho0 * rho
    return (first * (1.0 - compression / par.r1) + second * (1.0 - compression / par.r2) + par.omega * rho * e
            + compression * (first + second) * (whole - v))


def pressure_derivatives(rho, e, par):
    v = fitted(par.rho0 / rho, par)     # R1 first + R2 second = 0 there, so that the slopes below hold beyond it too
    first, second = par.a * vexp(-par.r1 * v), par.b * vexp(-par.r2 * v)
    w = par.omega / par.rho0
    slope1 = (par.r1 * v - par.omega) * v / par.rho0 - w / par.r1
    slope2 = (par.r2 * v - par.omega) * v / par.rho0 - w / par.r2
    return first * slope1 + second * slope2 + par.omega * e, par.omega * rho


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.omega * rho)


def reference_isentrope(rho, par):
    """The exponential terms alone (Starkenberg A-9.2); energies beside them grow as V^-omega."""
    whole = par.rho0 / rho
    v = fitted(whole, par)
    first, second = par.a * vexp(-par.r1 * v), par.b * vexp(-par.r2 * v)
    return (first / par.r1 + second / par.r2 - (first + second) * (whole - v)) / par.rho0, -par.omega * vlog(whole)


def cold_energy(rho, par):
    """Energy on the isentrope of zero temperature, J/kg."""
    energy_s, growth = reference_isentrope(rho, par)
    return energy_s if par.cold_constant == 0.0 else energy_s + par.cold_constant * vexp(growth)


def temperature(rho, e, par):
    return (e - cold_energy(rho, par)) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero where T V**omega = 1 K."""
    return par.specific_heat * (vlog(temperature(rho, e, par)) - par.omega * vlog(rho / par.rho0))


def reference_state(par):
    """The products at the density and energy of the explosive (constant-volume explosion)."""
    return par.rho0, par.e0 / par.rho0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "jwl", JWL,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9, 613.5),
    units={"a": "Pa", "b": "Pa", "r1": "1", "r2": "1", "omega": "1", "rho0": "kg/m^3", "e0": "J/m^3", "specific_heat": "J/kg/K",
           "cold_constant": "J/kg"},
    meaning={"a": "coefficient of the first exponential", "b": "coefficient of the second exponential",
             "r1": "exponent of the first exponential", "r2": "exponent of the second exponential", "omega": "Grüneisen parameter",
             "rho0": "density of the unreacted explosive", "e0": "detonation energy per volume of unreacted explosive",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "cold_constant": "coefficient e_3 of (rho0/rho)^-omega in the energy at zero temperature"},
    defaults={"e0": 0.0, "specific_heat": math.nan, "cold_constant": 0.0},
    box={"rho": (20.0, 3000.0), "e": (2.5e6, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-9 (corrected: S-E10, S-E11)", "Lee and Hornig 1969, as cited there"),
    flags=("linear_in_energy", "gas", "reacted"),
)
