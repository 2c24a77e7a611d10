r"""Coefficients of Herrmann's series from other forms of shock data.

Herrmann writes a Hugoniot as $p_H = k_0'\eta\,(1 + k_1'\eta + k_2'\eta^2 + \dots)$ with the compression $\eta = 1 - \rho_0/\rho$ (C.4).
The functions below give $(k_0', k_1', k_2')$ from the usual fits. `series` combines them with the Grüneisen parameter
$\Gamma = \Gamma_0(1 + \gamma_1\eta + \gamma_2\eta^2 + \gamma_3\eta^3)$ (C.13) into parameters of the law `herrmann_series` (C.16).
`wilkins_cubic` gives the cubic Mie-Grüneisen form of Wilkins' KO codes.

Source: Herrmann, WL-TR-64-107, C.4 to C.16, with C.11 corrected (H-E6); `elastic_wave_speed` is C.17, corrected (H-E5).
"""

import math
from typing import NamedTuple

from hugoniot.laws.eos.herrmann_series import HerrmannSeries


class HugoniotSeries(NamedTuple):
    """k0' (Pa), k1', k2' of C.4, and k3', which the fits below leave at 0 (C.7: not to be retained)."""

    k0: float
    k1: float
    k2: float
    k3: float = 0.0


def from_linear(rho0: float, c0: float, s: float) -> HugoniotSeries:
    """Us = c0 + s up: k0' = rho0 c0^2, k1' = 2 s, k2' = 3 s^2 (C.7); good to compressions of about 0.1."""
    return HugoniotSeries(rho0 * c0 * c0, 2.0 * s, 3.0 * s * s)


def from_murnaghan(a: float, exponent: float) -> HugoniotSeries:
    """p_H = A[(rho/rho0)^n - 1]: k0' = A n, k1' = (n + 1)/2, k2' = (n + 1)(n + 2)/6 (C.9)."""
    n = exponent
    return HugoniotSeries(a * n, (n + 1.0) / 2.0, (n + 1.0) * (n + 2.0) / 6.0)


def from_finite_strain(lame_lambda: float, shear_modulus: float) -> HugoniotSeries:
    """Linear elastic solid in finite strain: k0' = lambda + 2 mu/3 (H-E6: not lambda + mu/3), k1' = 5/2, k2' = 235/54 (C.10, C.11)."""
    return HugoniotSeries(lame_lambda + 2.0 / 3.0 * shear_modulus, 5.0 / 2.0, 235.0 / 54.0)


def from_compression_cubic(a: float, b: float, c: float) -> HugoniotSeries:
    """Rice, McQueen and Walsh's p_H = A mu + B mu^2 + C mu^3, mu = rho/rho0 - 1 = eta + eta^2 + eta^3 + ..."""
    return HugoniotSeries(a, (a + b) / a, (a + 2.0 * b + c) / a)


def gruneisen_from_expansion(k0: float, expansion: float, rho0: float, heat_at_pressure: float) -> float:
    """gamma0 = k0' alpha / (rho0 c_p) with the volumetric expansion alpha (1/K) and c_p (J/kg/K) (C.14)."""
    return k0 * expansion / (rho0 * heat_at_pressure)


def series(rho0, hugoniot: HugoniotSeries, gamma0, gammas=(0.0, 0.0, 0.0), specific_heat=math.nan, reference_temperature=298.15):
    """The law herrmann_series of a Hugoniot and a Grüneisen series (C.15, C.16).

    rho0 kg/m3; gamma0 and `gammas` = (gamma1, gamma2, gamma3) of C.13. h_n = 1 + gamma1 + ... + gamma_n is the series of
    Gamma/(1 - eta), k_n = k_n' - (gamma0/2)(sum of h_i k_j', i + j = n - 1).
    """
    _, k1, k2, k3 = hugoniot
    h1 = 1.0 + gammas[0]
    h2 = h1 + gammas[1]
    h3 = h2 + gammas[2]
    half = 0.5 * gamma0
    return HerrmannSeries(rho0, hugoniot.k0, k1 - half, k2 - half * (h1 + k1), k3 - half * (h2 + h1 * k1 + k2), rho0 * gamma0, h1, h2,
                          h3, specific_heat, reference_temperature)


def wilkins_cubic(rho0, c0, s, gamma0, specific_heat=math.nan, reference_temperature=298.15):
    """p = rho0 c0^2 [x + (2s - g/2) x^2 + s(3s - g) x^3] + g rho0 e, the cubic of Us = c0 + s up with rho Gamma constant (B31)."""
    return HerrmannSeries(rho0, rho0 * c0 * c0, 2.0 * s - 0.5 * gamma0, s * (3.0 * s - gamma0), 0.0, rho0 * gamma0, 0.0, 0.0, 0.0,
                          specific_heat, reference_temperature)


def elastic_wave_speed(bulk_modulus: float, shear_modulus: float, rho: float) -> float:
    """c_e = sqrt((K + 4G/3)/rho), m/s (C.17 corrected: H-E5)."""
    return math.sqrt((bulk_modulus + 4.0 / 3.0 * shear_modulus) / rho)
