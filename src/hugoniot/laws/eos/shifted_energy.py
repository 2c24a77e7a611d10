r"""Shifted origin of energy: any law with another zero of energy.

$$p(\rho, e) = p_{\text{base}}(\rho, e + \Delta e)$$

Use it to give the laws of one problem, such as an explosive and its products or two phases, the same origin of energy. The reference
energy is that of the base law minus $\Delta e$. Everything else is that of the base law at the energy $e + \Delta e$.

Source: Starkenberg, ARL-TR-2161, appendix A-1 (the energy of an equation of state is defined up to a constant).
"""

from typing import Any, NamedTuple

from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import energy as base_energy
from hugoniot.laws.eos.contract import entropy as base_entropy
from hugoniot.laws.eos.contract import particle_velocity_limit as base_velocity_limit
from hugoniot.laws.eos.contract import piece_coordinate as base_piece_coordinate
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import smooth_piece as base_smooth_piece
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class ShiftedEnergy(NamedTuple):
    base: Any
    shift: float


def pressure(rho, e, par):
    return base_pressure(rho, e + par.shift, par.base)


def pressure_derivatives(rho, e, par):
    return base_derivatives(rho, e + par.shift, par.base)


def energy(rho, p, par):
    return base_energy(rho, p, par.base) - par.shift


def temperature(rho, e, par):
    return base_temperature(rho, e + par.shift, par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(rho, e + par.shift, par.base)


def entropy(rho, e, par):
    return base_entropy(rho, e + par.shift, par.base)


def reference_state(par):
    rho, e = base_reference_state(par.base)
    return rho, e - par.shift


def density_limits(par):
    return base_density_limits(par.base)


def smooth_piece(rho, e, way, par):
    piece, low, high = base_smooth_piece(rho, e + par.shift, way, par.base)
    return ShiftedEnergy(piece, par.shift), low, high


def piece_coordinate(rho, e, piece):
    return base_piece_coordinate(rho, e + piece.shift, piece.base)


def particle_velocity_limit(par):
    return base_velocity_limit(par.base)


EOS.add(
    "shifted_energy", ShiftedEnergy,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit, smooth_piece, piece_coordinate],
    example=ShiftedEnergy(MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0), -4e6),
    units={"base": "law", "shift": "J/kg"},
    meaning={"base": "equation of state whose origin of energy is shifted", "shift": "energy added before the base law is evaluated"},
    box={"rho": (2300.0, 6500.0), "e": (4e6, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-1",),
)
