r"""Tension cut-off: any law, limited to a given tension.

$$p(\rho, e) = \max\left[p_{\text{base}}(\rho, e),\; -p_{\text{cut}}\right]$$

Use it for liquids and fragmented material that cavitate or separate under tension, where a fracture law would be too detailed. Where the
cut-off acts, both derivatives of the pressure and the sound speed are zero: the stretched material is a spray of constant pressure. It
recovers on recompression to the density at which the cut-off began. In runs with `lagrange1d` and `lagrange2d` material may reach the
cut-off; a run with `fronts` stops there with an error. Initial states and those of the command-line tools must not be at the cut-off.

The temperature is that of the base law. There is no entropy, because that of the base law no longer satisfies $T\,ds = de + p\,dv$ where
the cut-off acts.

Source: Wilkins, B.2 (pressure limit of materials that spall).
"""

from typing import Any, NamedTuple

from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import particle_velocity_limit as base_velocity_limit
from hugoniot.laws.eos.contract import piece_coordinate as base_piece_coordinate
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import smooth_piece as base_smooth_piece
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class TensionCutoff(NamedTuple):
    base: Any
    tension: float


def pressure(rho, e, par):
    p = base_pressure(rho, e, par.base)
    return p if p > -par.tension else -par.tension + 0.0 * p


def pressure_derivatives(rho, e, par):
    p = base_pressure(rho, e, par.base)
    p_rho, p_e = base_derivatives(rho, e, par.base)
    return (p_rho, p_e) if p > -par.tension else (0.0, 0.0)


def temperature(rho, e, par):
    return base_temperature(rho, e, par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(rho, e, par.base)


def reference_state(par):
    return base_reference_state(par.base)


def density_limits(par):
    return base_density_limits(par.base)


def smooth_piece(rho, e, way, par):
    piece, low, high = base_smooth_piece(rho, e, way, par.base)
    return TensionCutoff(piece, par.tension), low, high


def piece_coordinate(rho, e, piece):
    return base_piece_coordinate(rho, e, piece.base)


def particle_velocity_limit(par):
    return base_velocity_limit(par.base)


EOS.add(
    "tension_cutoff", TensionCutoff,
    functions=[pressure, pressure_derivatives, temperature, specific_heat, reference_state, density_limits,
               particle_velocity_limit, smooth_piece, piece_coordinate],
    example=TensionCutoff(MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0), 1e9),
    units={"base": "law", "tension": "Pa"},
    meaning={"base": "equation of state whose tension is limited", "tension": "largest tension, positive"},
    box={"rho": (2760.0, 6500.0), "e": (0.0, 2e7)},
    references=("Wilkins, B.2",),
)
