r"""Mie-Grüneisen equation of state with a linear Us-up relation, written in terms of its exact cold curve (at 0 K).

Its pressures are those of `mie_gruneisen`. The temperature is zero on the cold curve, so temperature and entropy depend on the energy
$E_{00}$ at the reference density and 0 K instead of on a reference temperature. Use the law to compare with results that were computed
with a cold curve. In other cases use `mie_gruneisen`, which needs no cold energy.

$$p = P_c + \rho_0\Gamma_0(e - E_c), \qquad P_c = \rho_0\frac{dE_c}{d\eta}, \qquad \eta = 1 - \rho_0/\rho$$

In compression the cold energy $E_c$ and cold pressure $P_c$ follow from

$$\frac{dE_c}{d\eta} - \Gamma_0E_c = f(\eta) = \frac{c_0^2\,\eta\,(1 - \Gamma_0\eta/2)}{(1 - s\eta)^2}, \qquad E_c(0) = E_{00}.$$

The solution is $E_c = E_{00}\exp(\Gamma_0\eta) + e_S$. The equation of $e_S$, the energy on the isentrope through the reference state, is
given under `mie_gruneisen`, in compression and in tension; in compression it contains an exponential integral, which the source calls
an error function (J-E8). With this solution the pressure is $p = \rho_0(f + \Gamma_0e)$: the law reproduces the Us-up relation exactly,
whatever the values of $\Gamma_0$ and $E_{00}$. The temperature is $T = (e - E_c)/c_v$ with a constant specific heat $c_v$. With
$E_{00} = -c_vT_0$ it is $T_0$ in the reference state, and it is everywhere that of `mie_gruneisen` with this $T_0$.

Parameters with $\Gamma_0 > 8s$ are refused, because the closed form of $e_S$ would lose its precision; use `mie_gruneisen`.

Source: Jordan (2011), eq. 5.1.1 to 5.1.10; 5.1.10 is missing from the available copy and was rederived (J-E17). Starkenberg, ARL-TR-2161,
appendix A-2.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import mie_gruneisen
from hugoniot.laws.eos.contract import EOS


class MieGruneisenCold(NamedTuple):
    rho0: float
    c0: float
    s: float
    gamma0: float
    cold_energy: float = 0.0
    specific_heat: float = math.nan


def cold_energy(rho, par):
    """E_c, J/kg."""
    e_s, growth = mie_gruneisen.reference_isentrope(rho, par)
    return par.cold_energy * growth + e_s


def cold_pressure(rho, par):
    """P_c = rho0 dE_c/deta, Pa."""
    return mie_gruneisen.pressure(rho, cold_energy(rho, par), par)


def temperature(rho, e, par):
    return (e - cold_energy(rho, par)) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero where T = 1 K at rho0."""
    return par.specific_heat * (vlog(temperature(rho, e, par)) - par.gamma0 * (1.0 - par.rho0 / rho))


def cold_coefficients(c0, s, gamma0, e00, order):
    """Coefficients e_0 ... e_order of the power series of E_c in eta: (n + 1) e_{n+1} = gamma0 e_n + S_n."""
    e = [e00, gamma0 * e00]
    for n in range(1, order):
        source = c0 * c0 * (n * s ** (n - 1) - (0.5 * gamma0 * (n - 1) * s ** (n - 2) if n > 1 else 0.0))
        e.append((gamma0 * e[n] + source) / (n + 1))
    return e[:order + 1]


def build(rho0, c0, s, gamma0, cold_energy=0.0, specific_heat=math.nan):
    """Parameters from a deck."""
    if gamma0 > 8.0 * s:
        raise OutOfRange(f"mie_gruneisen_cold: the closed form of the cold curve loses its precision by cancellation for gamma0 > 8 s "
                         f"(gamma0 = {gamma0}, s = {s}); use mie_gruneisen, which has the same pressures")
    return MieGruneisenCold(rho0, c0, s, gamma0, cold_energy, specific_heat)


EOS.add(
    "mie_gruneisen_cold", MieGruneisenCold,
    functions=[mie_gruneisen.pressure, mie_gruneisen.pressure_derivatives, mie_gruneisen.energy, temperature, specific_heat, entropy,
               mie_gruneisen.reference_state, mie_gruneisen.density_limits, mie_gruneisen.particle_velocity_limit],
    example=MieGruneisenCold(8930.0, 3940.0, 1.49, 1.99, -385.0 * 298.15, 385.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "gamma0": "1", "cold_energy": "J/kg", "specific_heat": "J/kg/K"},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "slope of the Hugoniot, dUs/dup",
             "gamma0": "Grüneisen parameter at the reference density", "cold_energy": "energy at the reference density and 0 K",
             "specific_heat": "specific heat at constant volume, needed for temperatures"},
    defaults={"cold_energy": 0.0, "specific_heat": math.nan},
    box={"rho": (7000.0, 20000.0), "e": (0.0, 1e7)},
    references=("Jordan 2011, eq. 5.1.1 to 5.1.10 (J-E8, J-E17)", "Starkenberg, ARL-TR-2161, appendix A-2"),
    flags=("linear_in_energy",),
)
