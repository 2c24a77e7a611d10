r"""From other forms of data to Herrmann's series: coefficients of p_H, of rho Gamma and of the whole law.

A Hugoniot is written as a series in the compression $\eta = 1 - \rho_0/\rho$ (C.4), the Grüneisen parameter likewise (C.13):

$$p_H = k_0'\eta\,(1 + k_1'\eta + k_2'\eta^2 + \dots), \qquad
\Gamma = \Gamma_0(1 + \gamma_1\eta + \gamma_2\eta^2 + \gamma_3\eta^3)$$

The functions below give $k_0', k_1', k_2'$ from the usual forms of data. `series` combines them with the Grüneisen parameter into the
coefficients of the law `herrmann_series` (C.16), and `wilkins_cubic` gives the cubic Mie-Grüneisen equation of state of the KO codes.
Labels such as C.4 are equations of Herrmann's report.

Source: Herrmann, WL-TR-64-107 (1964), C.4 to C.16, with C.11 corrected (H-E6); C.17 corrected (H-E5) in `elastic_wave_speed`.
"""

import math
from typing import NamedTuple

from hugoniot.laws.eos.herrmann_series import HerrmannSeries


class HugoniotSeries(NamedTuple):
    """k0 (Pa), k1, k2, k3: the coefficients k0', k1', k2', k3' of the Hugoniot (C.4). The fits below leave k3 at 0."""

    k0: float
    k1: float
    k2: float
    k3: float = 0.0


def from_linear(rho0: float, c0: float, s: float) -> HugoniotSeries:
    """From Us = c0 + s up: k0' = rho0 c0^2, k1' = 2 s, k2' = 3 s^2 (C.7), for compressions up to about 0.1.

    rho0   reference density, kg/m3
    c0     m/s
    s      slope
    """
    return HugoniotSeries(rho0 * c0 * c0, 2.0 * s, 3.0 * s * s)


def from_murnaghan(a: float, exponent: float) -> HugoniotSeries:
    """From p_H = A[(rho/rho0)^n - 1]: k0' = A n, k1' = (n + 1)/2, k2' = (n + 1)(n + 2)/6 (C.9).

    a          A, Pa
    exponent   n
    """
    n = exponent
    return HugoniotSeries(a * n, (n + 1.0) / 2.0, (n + 1.0) * (n + 2.0) / 6.0)


def from_finite_strain(lame_lambda: float, shear_modulus: float) -> HugoniotSeries:
    """From a linear elastic solid in finite strain: k0' = lambda + 2 mu/3, k1' = 5/2, k2' = 235/54 (C.10, and C.11 corrected: H-E6).

    lame_lambda     Lamé constant lambda, Pa
    shear_modulus   mu, Pa
    """
    return HugoniotSeries(lame_lambda + 2.0 / 3.0 * shear_modulus, 5.0 / 2.0, 235.0 / 54.0)


def from_compression_cubic(a: float, b: float, c: float) -> HugoniotSeries:
    """From p_H = A mu + B mu^2 + C mu^3 with mu = rho/rho0 - 1 (Rice, McQueen and Walsh); a, b, c are A, B, C, Pa."""
    return HugoniotSeries(a, (a + b) / a, (a + 2.0 * b + c) / a)


def gruneisen_from_expansion(k0: float, expansion: float, rho0: float, heat_at_pressure: float) -> float:
    """Grüneisen parameter k0' alpha/(rho0 c_p) at the reference state (C.14).

    k0                 k0', Pa
    expansion          volumetric thermal expansion alpha, 1/K
    rho0               reference density, kg/m3
    heat_at_pressure   specific heat c_p at constant pressure, J/(kg K)
    """
    return k0 * expansion / (rho0 * heat_at_pressure)


def series(rho0, hugoniot: HugoniotSeries, gamma0, gammas=(0.0, 0.0, 0.0), specific_heat=math.nan, reference_temperature=298.15):
    """Parameters of the law `herrmann_series` from a Hugoniot and a Grüneisen series (C.15, C.16).

    rho0                    reference density, kg/m3
    hugoniot                a `HugoniotSeries`
    gamma0                  Grüneisen parameter at the reference density
    gammas                  gamma1, gamma2, gamma3 of C.13
    specific_heat           J/(kg K), at constant volume
    reference_temperature   K

    The coefficients are h_n = 1 + gamma1 + ... + gamma_n and k_n = k_n' - (gamma0/2)(sum of h_i k_j' over i + j = n - 1), with h_0 = k_0'
    = 1 in the sum.
    """
    _, k1, k2, k3 = hugoniot
    h1 = 1.0 + gammas[0]
    h2 = h1 + gammas[1]
    h3 = h2 + gammas[2]
    half = 0.5 * gamma0
    return HerrmannSeries(rho0, hugoniot.k0, k1 - half, k2 - half * (h1 + k1), k3 - half * (h2 + h1 * k1 + k2), rho0 * gamma0, h1, h2,
                          h3, specific_heat, reference_temperature)


def wilkins_cubic(rho0, c0, s, gamma0, specific_heat=math.nan, reference_temperature=298.15):
    """Parameters for p = rho0 c0^2 [x + (2s - g/2) x^2 + s(3s - g) x^3] + g rho0 e: Us = c0 + s up with constant rho Gamma, to third order.

    rho0                    reference density, kg/m3; x = 1 - rho0/rho
    c0, s                   constants of the linear Us-up relation, c0 in m/s
    gamma0                  g, Grüneisen parameter at the reference density
    specific_heat           J/(kg K), at constant volume
    reference_temperature   K
    """
    return HerrmannSeries(rho0, rho0 * c0 * c0, 2.0 * s - 0.5 * gamma0, s * (3.0 * s - gamma0), 0.0, rho0 * gamma0, 0.0, 0.0, 0.0,
                          specific_heat, reference_temperature)


def elastic_wave_speed(bulk_modulus: float, shear_modulus: float, rho: float) -> float:
    """Longitudinal elastic wave speed sqrt((K + 4G/3)/rho), m/s, from the bulk modulus K (Pa), the shear modulus G (Pa) and the density
    (kg/m3) (C.17 corrected: H-E5)."""
    return math.sqrt((bulk_modulus + 4.0 / 3.0 * shear_modulus) / rho)
