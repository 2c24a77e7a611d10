r"""Steinberg-Guinan: shear modulus and flow stress of metals at high strain rates as functions of pressure and temperature, with melting.

$$G = G_0\,\varphi, \qquad Y = \min\left\{Y_0\,[1 + \beta(\varepsilon_p + \varepsilon_i)]^n,\; Y_{\max}\right\}\varphi, \qquad
  \varphi = 1 + A\,p\,\eta^{-1/3} - B\,(T - 300\,\mathrm{K})$$
$$T_m = T_{m0}\,\exp\left[2a\left(1 - 1/\eta\right)\right]\eta^{2(\gamma_0 - a - 1/3)}, \qquad \eta = \rho/\rho_0$$

* $G$, $Y$: shear modulus and flow stress in uniaxial stress; $G_0$, $Y_0$: their initial values at zero pressure and 300 K,
  `shear_modulus`, `yield_stress`; $Y_{\max}$: `largest_yield_stress`
* $\beta$, $n$: `hardening_coefficient`, `hardening_exponent`; $\varepsilon_p$: accumulated equivalent plastic strain;
  $\varepsilon_i$: `initial_strain`
* $A$, $B$: `pressure_coefficient`, `temperature_coefficient`; $p$, $T$: pressure and temperature
* $\rho_0$: reference density, `rho0`; $\rho$: density
* $T_m$: melting temperature; $T_{m0}$, $\gamma_0$, $a$: `melt_temperature`, `melt_gruneisen`, `melt_a`; the Grüneisen parameter of
  this melting law is $\gamma_0 - a(1 - 1/\eta)$

Above the melting temperature $Y = 0$, and $G$ is $G_0$ times `melt_shear_fraction`. Large tensions or temperatures would make $\varphi$
negative; it is therefore not less than `melt_shear_fraction` in $G$ and not less than 0 in $Y$. The flow stress does not depend on the
strain rate. The law gives $Y$ the same relative pressure derivative as $G$, as the published table of parameters does. The equation
of state must give a temperature. The constants of the example are for 6061-T6 aluminium (Steinberg, UCRL-MA-106439,
1996; not checked against the printed source).
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, fmin, vexp, vpow
from hugoniot.laws.strength.contract import STRENGTH


class SteinbergGuinan(NamedTuple):
    rho0: float
    shear_modulus: float
    yield_stress: float
    hardening_coefficient: float
    hardening_exponent: float
    largest_yield_stress: float
    pressure_coefficient: float
    temperature_coefficient: float
    melt_temperature: float
    melt_gruneisen: float
    melt_a: float
    initial_strain: float = 0.0
    melt_shear_fraction: float = 0.0


def melt_temperature(rho, par):
    """Melting temperature at density rho, K."""
    eta = rho / par.rho0
    return (par.melt_temperature * vexp(2.0 * par.melt_a * (1.0 - 1.0 / eta))
            * vpow(eta, 2.0 * (par.melt_gruneisen - par.melt_a - 1.0 / 3.0)))


def softening(rho, p, temperature, par):
    """The factor phi of pressure and temperature."""
    return 1.0 + par.pressure_coefficient * p * vpow(rho / par.rho0, -1.0 / 3.0) - par.temperature_coefficient * (temperature - 300.0)


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    solid = fmax(softening(rho, p, temperature, par), par.melt_shear_fraction)
    return par.shear_modulus * (solid if temperature < melt_temperature(rho, par) else par.melt_shear_fraction)


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    hardening = vpow(1.0 + par.hardening_coefficient * (plastic_strain + par.initial_strain), par.hardening_exponent)
    hardened = fmin(par.yield_stress * hardening, par.largest_yield_stress)
    solid = hardened * fmax(softening(rho, p, temperature, par), 0.0)
    return solid if temperature < melt_temperature(rho, par) else 0.0


STRENGTH.add(
    "steinberg_guinan", SteinbergGuinan,
    functions=[shear_modulus, flow_stress],
    example=SteinbergGuinan(2703.0, 27.6e9, 0.29e9, 125.0, 0.10, 0.68e9, 6.52e-11, 6.16e-4, 1220.0, 1.97, 1.5),
    units={"rho0": "kg/m^3", "shear_modulus": "Pa", "yield_stress": "Pa", "hardening_coefficient": "1", "hardening_exponent": "1",
           "largest_yield_stress": "Pa", "pressure_coefficient": "1/Pa", "temperature_coefficient": "1/K", "melt_temperature": "K",
           "melt_gruneisen": "1", "melt_a": "1", "initial_strain": "1", "melt_shear_fraction": "1"},
    meaning={"rho0": "reference density", "shear_modulus": "shear modulus at zero pressure and 300 K",
             "yield_stress": "flow stress in uniaxial stress at first yield, zero pressure and 300 K",
             "hardening_coefficient": "beta, coefficient of strain hardening", "hardening_exponent": "n, exponent of strain hardening",
             "largest_yield_stress": "upper limit of the hardened flow stress at zero pressure and 300 K",
             "pressure_coefficient": "A, pressure derivative of the shear modulus, divided by the shear modulus",
             "temperature_coefficient": "B, relative decrease of the shear modulus per kelvin",
             "melt_temperature": "melting temperature at the reference density",
             "melt_gruneisen": "Grüneisen parameter of the melting law at the reference density",
             "melt_a": "a, slope of the Grüneisen parameter of the melting law: Gamma = melt_gruneisen - a (1 - rho0/rho)",
             "initial_strain": "equivalent plastic strain before loading",
             "melt_shear_fraction": "fraction of the shear modulus that remains in the melt"},
    defaults={"initial_strain": 0.0, "melt_shear_fraction": 0.0},
    box={"rho": (2600.0, 4500.0), "p": (-2e9, 1e11), "temperature": (200.0, 5000.0), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    above={"melt_temperature": 0.0},
    least=dict.fromkeys(("hardening_coefficient", "hardening_exponent", "pressure_coefficient", "temperature_coefficient",
                         "initial_strain", "melt_shear_fraction"), 0.0),
    references=("Steinberg, Cochran & Guinan, J. Appl. Phys. 51 (1980) 1498",),
    flags=("hardens", "needs_temperature",),
)
