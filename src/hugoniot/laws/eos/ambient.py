r"""Equation of state of a material whose Hugoniot was measured from a loaded state: after static precompression, or behind a first shock.

Use it where shock data start from an upstream state of density $\rho_0$, pressure $p_a$ and energy $e_a$. The base law has the measured
Hugoniot, with the upstream density as its reference density:

$$p(\rho, e) = p_a + p_{\text{base}}(\rho, e'), \qquad e' = e - e_a - p_a\,(v_a - v), \qquad v = 1/\rho, \; v_a = 1/\rho_0$$

where $e' = 0$ is the reference energy of the base law. The jump condition $e - e_a = \tfrac12(p + p_a)(v_a - v)$ becomes
$e' = \tfrac12(p - p_a)(v_a - v)$, so shocks from the upstream state have the shock and particle velocities of the base law. For
$U_s = c_a + s_au_p$ the Hugoniot is

$$p_H = p_a + \frac{c_a^2\,(v_a - v)}{[v_a - s_a(v_a - v)]^2}.$$

Isentropes, temperature and sound speed are those of the base law at $e'$. Away from this Hugoniot the pressure follows from the Grüneisen
parameter of the base law, which such data do not test.

Source: Starkenberg, ARL-TR-2161, appendix A-11.1, A-11.2 and A-11.5.
"""

from typing import Any, NamedTuple

from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import energy as base_energy
from hugoniot.laws.eos.contract import entropy as base_entropy
from hugoniot.laws.eos.contract import particle_velocity_limit as base_velocity_limit
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class Ambient(NamedTuple):
    base: Any
    pressure: float
    energy: float = 0.0


def own_energy(rho, e, par):
    """e', the base's energy, J/kg."""
    rho0, e0 = base_reference_state(par.base)
    return e0 + e - par.energy - par.pressure * (1.0 / rho0 - 1.0 / rho)


def pressure(rho, e, par):
    return par.pressure + base_pressure(rho, own_energy(rho, e, par), par.base)


def pressure_derivatives(rho, e, par):
    p_rho, p_e = base_derivatives(rho, own_energy(rho, e, par), par.base)
    return p_rho - p_e * par.pressure / (rho * rho), p_e


def energy(rho, p, par):
    rho0, e0 = base_reference_state(par.base)
    return base_energy(rho, p - par.pressure, par.base) - e0 + par.energy + par.pressure * (1.0 / rho0 - 1.0 / rho)


def temperature(rho, e, par):
    return base_temperature(rho, own_energy(rho, e, par), par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(rho, own_energy(rho, e, par), par.base)


def entropy(rho, e, par):
    return base_entropy(rho, own_energy(rho, e, par), par.base)


def reference_state(par):
    return base_reference_state(par.base)[0], par.energy


def density_limits(par):
    return base_density_limits(par.base)


def particle_velocity_limit(par):
    return base_velocity_limit(par.base)


EOS.add(
    "ambient", Ambient,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit],
    example=Ambient(MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0), 5e9, 2e5),
    units={"base": "law", "pressure": "Pa", "energy": "J/kg"},
    meaning={"base": "equation of state with the measured Hugoniot; its reference density is the upstream density",
             "pressure": "pressure of the upstream state", "energy": "energy of the upstream state"},
    defaults={"energy": 0.0},
    box={"rho": (2400.0, 6500.0), "e": (2.5e6, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-11",),
    flags=("loaded",),     # at rest under pressure
)
