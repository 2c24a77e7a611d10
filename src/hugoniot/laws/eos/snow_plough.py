r"""Snow-plough compaction of porous material: pores close at a crush pressure, beyond which the law of the solid holds.

Use it where only the initial density and a crush pressure are known.

$$p = \max\left[p_{\text{solid}}(\rho, e),\;
  \min\left(p_c\,\frac{\rho - \rho_{00}}{\rho_s - \rho_{00}},\; c_s^2(\rho - \rho_r)\right)\right]$$

$\rho_{00}$ is the initial density of the porous material, $\rho_s$ and $c_s$ the reference density and sound speed of its solid (the base
law), and $p_c$ the crush pressure, which the ramp reaches at $\rho_s$. The pure snow-plough is the limit $p_c = 0$, in which sound does not
travel. On the ramp, the first expression in the minimum, the pressure does not depend on energy. Shocks that close the pores end on the
Hugoniot of the law of the solid for the initial density $\rho_{00}$.

Crushing is irreversible. From the ramp the material unloads with the sound speed $c_s$ to the density $\rho_r$, at which the pressure is
zero ($\rho_{00}$ before any crushing), supports tension below it, and reloads along the same line. Once the pressure of the solid has
exceeded the ramp, the pores are closed and the law of the solid holds from then on. A run stores the compaction
$(\rho_r - \rho_{00})/(\rho_s - \rho_{00})$ of every zone, 1 when closed.

The temperature is that of the solid with the same energy, at the density $\rho$ or $\rho_s$, whichever is larger. The law has no entropy,
because crushing is irreversible and the pressure of the ramp does not depend on energy.

Source: Zel'dovich and Raizer, Physics of Shock Waves, XI.3; Thouvenin (1966), as reviewed by Herrmann, J. Appl. Phys. 40, 2490 (1969).
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import sound_speed_squared as base_sound_speed_squared
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class SnowPlough(NamedTuple):
    """rho_solid and stiffness (c^2), of the solid's reference state, and rho_rest, the density at zero pressure, are filled by `build`."""

    base: Any
    rho_porous: float
    crush_pressure: float
    rho_solid: float
    stiffness: float
    rho_rest: float


def _ramp(rho, par):
    """(pressure, slope) while the pores close or have closed in part, Pa and m2/s2."""
    slope = par.crush_pressure / (par.rho_solid - par.rho_porous)
    ramp, elastic = slope * (rho - par.rho_porous), par.stiffness * (rho - par.rho_rest)
    return (elastic, par.stiffness) if elastic < ramp or rho <= par.rho_porous else (ramp, slope)


def _closed(par):
    return par.rho_rest >= par.rho_solid


def pressure(rho, e, par):
    p = base_pressure(rho, e, par.base)
    crush = _ramp(rho, par)[0]
    return p if _closed(par) or p > crush else crush


def pressure_derivatives(rho, e, par):
    p = base_pressure(rho, e, par.base)
    p_rho, p_e = base_derivatives(rho, e, par.base)
    crush, slope = _ramp(rho, par)
    return (p_rho, p_e) if _closed(par) or p > crush else (slope, 0.0)


def _solid(rho, par):
    """Density at which the solid inside the pores is evaluated: its reference density until the pores are closed."""
    return rho if _closed(par) or rho > par.rho_solid else par.rho_solid


def temperature(rho, e, par):
    return base_temperature(_solid(rho, par), e, par.base)


def specific_heat(rho, e, par):
    return base_specific_heat(_solid(rho, par), e, par.base)


def remembered(compaction, par):
    rest = par.rho_solid if compaction >= 1.0 else par.rho_porous + compaction * (par.rho_solid - par.rho_porous)
    return SnowPlough(par.base, par.rho_porous, par.crush_pressure, par.rho_solid, par.stiffness, rest)


def unloading(par):
    return SnowPlough(par.base, par.rho_porous, NO_LIMIT, par.rho_solid, par.stiffness, par.rho_rest)


def compacted(compaction, rho, e, p, par):
    ramp = par.crush_pressure * (rho - par.rho_porous) / (par.rho_solid - par.rho_porous)
    if ramp > 0.0 and base_pressure(rho, e, par.base) > ramp:
        return 1.0
    return fmax(compaction, (rho - ramp / par.stiffness - par.rho_porous) / (par.rho_solid - par.rho_porous))


def elastic_limit(par):
    """Where the elastic line through the density at zero pressure meets the ramp."""
    if _closed(par) or par.crush_pressure >= NO_LIMIT:
        return NO_LIMIT
    slope = par.crush_pressure / (par.rho_solid - par.rho_porous)
    return slope * par.stiffness * (par.rho_rest - par.rho_porous) / (par.stiffness - slope)


def reference_state(par):
    return par.rho_rest, base_reference_state(par.base)[1]


def density_limits(par):
    return base_density_limits(par.base)


def build(base, rho_porous, crush_pressure):
    """Parameters from a deck."""
    solid = base_reference_state(base)[0]
    if not 0.0 < rho_porous < solid:
        raise OutOfRange(f"snow_plough: rho_porous must lie between 0 and the solid's {solid:.6g} kg/m3, got {rho_porous:g} kg/m3")
    if not crush_pressure > 0.0:
        raise OutOfRange("snow_plough: crush_pressure must be positive (a small value lets pores close almost freely), got "
                         f"{crush_pressure:g} Pa")
    stiffness = float(base_sound_speed_squared(*base_reference_state(base), base))
    if not crush_pressure < 0.5 * stiffness * (solid - rho_porous):
        raise OutOfRange(f"snow_plough: crush_pressure {crush_pressure:.4g} Pa makes the pores stiffer than the solid; stay well below "
                         f"{0.5 * stiffness * (solid - rho_porous):.4g} Pa")
    return SnowPlough(base, rho_porous, crush_pressure, solid, stiffness, rho_porous)


EOS.add(
    "snow_plough", SnowPlough,
    functions=[pressure, pressure_derivatives, temperature, specific_heat, reference_state, density_limits, remembered, unloading,
               compacted, elastic_limit],
    example=build(MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0), 1700.0, 0.2e9),
    build=build,
    units={"base": "law", "rho_porous": "kg/m^3", "crush_pressure": "Pa", "rho_solid": "kg/m^3",
           "stiffness": "m^2/s^2", "rho_rest": "kg/m^3"},
    meaning={"base": "equation of state of the solid", "rho_porous": "initial density of the porous material",
             "crush_pressure": "pressure at which the pores have closed", "rho_solid": "reference density of the solid (filled by build)",
             "stiffness": "square of the sound speed of the solid in its reference state (filled by build)",
             "rho_rest": "density at zero pressure after the history (filled by build)"},
    box={"rho": (1650.0, 6000.0), "e": (0.0, 1e7)},
    flags=("remembers",),
    least={"crush_pressure": 0.0},
    references=("Zel'dovich and Raizer, Physics of Shock Waves, XI.3", "Herrmann, J. Appl. Phys. 40, 2490 (1969)"),
)
