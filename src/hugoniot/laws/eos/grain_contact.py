r"""Grain contact: a law fitted to a powder, stiffened above the density of its grains, where the fit is too soft.

A Hugoniot fitted to a powder is not valid at densities where nothing was measured: with a slope $s < 1$ its pressure stays finite even at
zero volume (J-E16), although the grains fill the space at a finite density. This law adds the resistance of the grains above their density
$\rho_s$, along a Murnaghan curve with their bulk modulus $K$ and its pressure derivative $n$:

$$p(\rho, e) = p_{\text{base}}(\rho,\, e - e_s) + p_s(\rho), \qquad
  p_s = \frac{K}{n}\left(X^n - 1\right), \quad
  e_s = \frac{K}{n\rho_s}\left[\frac{X^{n-1} - 1}{n - 1} + \frac1X - 1\right], \quad X = \rho/\rho_s > 1$$

and $p_s = e_s = 0$ at lower densities, where the law is identical to the base law. For a solid with $U_s = c_0 + su_p$ use
$K = \rho_sc_0^2$ and $n = 4s - 1$. Temperature and entropy are those of the base law at the energy $e - e_s$, and
$c^2 = c_{\text{base}}^2 + (K/\rho_s)X^{n-1}$ for $X > 1$. At $\rho_s$ pressure and energy are continuous and the sound speed jumps up. If
the compression limit of the base law lies below $\rho_s$, the grains never touch and this law has no effect.

The thermal pressure is that of the base law. Its Grüneisen parameter is that of the powder, far below that of the solid at the same
density, so hot grains occupy less space than they should. Where that matters, use a compaction law (`snow_plough`, `p_alpha`,
`p_lambda`), whose pores also stay closed on release. With `grain_contact` a released powder expands again.

Source: Zel'dovich and Raizer, Physics of Shock Waves, XI.1 and XI.2 (a cold pressure and energy that depend on the volume alone);
Murnaghan, Proc. Natl. Acad. Sci. 30, 244 (1944). Powder of the example: Jordan (2011), table 7.2.1, with J-E10.
"""

import math
from typing import Any, NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax, fmin, vpow
from hugoniot.errors import OutOfRange
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
from hugoniot.laws.eos.mie_gruneisen_cold import MieGruneisenCold


class GrainContact(NamedTuple):
    """contact_density, from which the grains resist, is the grains' density, filled by `build`; a smooth piece of the law moves it away."""

    base: Any
    grain_density: float
    grain_modulus: float
    grain_modulus_slope: float
    contact_density: float


def _contact(rho, par):
    """(p_s, Pa; e_s, J/kg; dp_s/drho, m2/s2) of the grains."""
    x, n, stiffness = rho / par.grain_density, par.grain_modulus_slope, par.grain_modulus / par.grain_density
    power = vpow(x, n - 1.0)
    p, slope = par.grain_modulus / n * (power * x - 1.0), stiffness * power
    e = stiffness / n * ((power - 1.0) / (n - 1.0) + 1.0 / x - 1.0)
    return (p, e, slope) if rho > par.contact_density else (0.0, 0.0, 0.0)


def pressure(rho, e, par):
    p_s, e_s, _ = _contact(rho, par)
    return base_pressure(rho, e - e_s, par.base) + p_s


def pressure_derivatives(rho, e, par):
    p_s, e_s, slope = _contact(rho, par)
    p_rho, p_e = base_derivatives(rho, e - e_s, par.base)
    return p_rho - p_e * p_s / (rho * rho) + slope, p_e


def energy(rho, p, par):
    p_s, e_s, _ = _contact(rho, par)
    return base_energy(rho, p - p_s, par.base) + e_s


def temperature(rho, e, par):
    return base_temperature(rho, e - _contact(rho, par)[1], par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(rho, e - _contact(rho, par)[1], par.base)


def entropy(rho, e, par):
    return base_entropy(rho, e - _contact(rho, par)[1], par.base)


def reference_state(par):
    return base_reference_state(par.base)


def density_limits(par):
    return base_density_limits(par.base)


def particle_velocity_limit(par):
    """The base law's, unless that one is reached at no volume left (J-E16), which grains do not allow."""
    return base_velocity_limit(par.base) if math.isfinite(base_density_limits(par.base)[1]) else math.inf


def smooth_piece(rho, e, way, par):
    """The base law's piece on the side of the contact that is entered (at the contact itself, a few last digits of the density wide)."""
    touching = rho * (1.0 + 1e-14 * way) > par.contact_density
    piece, low, high = base_smooth_piece(rho, e - _contact(rho, par)[1], way, par.base)
    low, high = (fmax(low, par.contact_density), high) if touching else (low, fmin(high, par.contact_density))
    return _joined(piece, par, 0.0 if touching else NO_LIMIT), low, high


def _joined(base, par, contact_density):
    return GrainContact(base, par.grain_density, par.grain_modulus, par.grain_modulus_slope, contact_density)


def piece_coordinate(rho, e, piece):
    p_s, e_s, _ = _contact(rho, piece)
    g, g_rho, g_e = base_piece_coordinate(rho, e - e_s, piece.base)
    return g, g_rho - g_e * p_s / (rho * rho), g_e


def build(base, grain_density, grain_modulus, grain_modulus_slope):
    """Parameters from a deck; OutOfRange unless the grains are denser than the powder, and stiffen."""
    powder = base_reference_state(base)[0]
    if not powder < grain_density < NO_LIMIT:
        raise OutOfRange(f"grain_contact: grain_density must be finite and exceed the density of the powder, {powder:.6g} kg/m3, "
                         f"got {grain_density:g} kg/m3")
    if not 0.0 < grain_modulus < NO_LIMIT:
        raise OutOfRange("grain_contact: grain_modulus, the bulk modulus of the grains, must be positive and finite, got "
                         f"{grain_modulus:g} Pa")
    if not 1.0 < grain_modulus_slope < NO_LIMIT:
        raise OutOfRange("grain_contact: grain_modulus_slope, the pressure derivative of the grains' bulk modulus, must be finite and "
                         f"exceed 1, got {grain_modulus_slope:g} (4 s - 1 of a linear Hugoniot)")
    return GrainContact(base, grain_density, grain_modulus, grain_modulus_slope, grain_density)


EOS.add(
    "grain_contact", GrainContact,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit, smooth_piece, piece_coordinate],
    example=build(MieGruneisenCold(100.0, 121.0, 0.9736, 0.3, -86.2 * 298.15, 86.2), 2200.0, 23.4e9, 4.34),
    build=build,
    units={"base": "law", "grain_density": "kg/m^3", "grain_modulus": "Pa", "grain_modulus_slope": "1", "contact_density": "kg/m^3"},
    meaning={"base": "equation of state fitted to the powder", "grain_density": "reference density of the grains",
             "grain_modulus": "bulk modulus of the grains",
             "grain_modulus_slope": "pressure derivative of the bulk modulus of the grains; 4 s - 1 for a linear Hugoniot of the solid",
             "contact_density": "density from which the grains resist (filled by build)"},
    box={"rho": (95.0, 3500.0), "e": (0.0, 5e6)},
    above={"grain_modulus": 0.0},
    references=("Zel'dovich and Raizer, Physics of Shock Waves, XI.1, XI.2", "Murnaghan, Proc. Natl. Acad. Sci. 30, 244 (1944)",
                "Jordan 2011, table 7.2.1 (J-E10; the powder)"),
    flags=("grains",),
)
