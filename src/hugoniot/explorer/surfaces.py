"""The law of a material, and the range of densities and temperatures in which its surface is drawn: the page computes the states itself."""

import math
from typing import Any

from hugoniot.errors import HugoniotError
from hugoniot.explorer.splits import farthest
from hugoniot.explorer.transcribed import parameters
from hugoniot.laws.eos.contract import EOS, reference_state, require_temperature
from hugoniot.laws.eos.table import Table
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.isentrope import AMBIENT, reference
from hugoniot.theory.states import density_range

HOTTEST = 20000.0   # K: where no table goes further
REACH = 1500.0      # m/s: particle velocity of the shock that sets the range where the data state none


def range_of(material) -> dict[str, Any]:
    """`densities` (kg/m3) and `temperatures` (K) as (lowest, highest), what the Hugoniot of the data reaches, and the law as `parameters`.

    `grid`: the (lowest, highest) temperature of a table, None for other laws. Only `refused`, the reason, for a law without temperature.
    """
    par = material.eos
    try:
        require_temperature(par)
        low, high, hottest = _ranges(material)
    except HugoniotError as error:
        return {"refused": str(error)}
    grid = [float(par.temperatures[0]), float(par.temperatures[-1])] if isinstance(par, Table) else None
    return {"law": parameters(par), "densities": [low, high], "temperatures": [grid[0] if grid else 0.0, hottest], "grid": grid}


def _ranges(material) -> tuple[float, float, float]:
    """(lowest, highest density, highest temperature) to draw: what the Hugoniot of the data reaches, in round numbers."""
    par, rho0 = material.eos, float(reference_state(material.eos)[0])
    least, most = density_range(par)
    thin = "gas" in EOS.of(par).flags or "reacted" in EOS.of(par).flags or reference(par).pressure > AMBIENT
    top = None
    if "reacted" not in EOS.of(par).flags:
        ahead = Initial.at_rest(par)
        for up in (material.valid_up_to or REACH, 1000.0, 300.0):
            try:
                top = shock(par, ahead, particle_velocity=farthest(par, ahead, up))
                break
            except HugoniotError:
                continue
    high = 1.05 * float(top.density) if top is not None else 1.5 * rho0
    hot = float(top.temperature) if top is not None and top.temperature is not None else 4000.0
    if isinstance(par, Table):
        return max(float(par.density[0]), 0.5 * rho0), min(float(par.density[-1]) * (1 - 1e-9), 3.0 * rho0), float(par.temperatures[-1])
    low, high = (0.2 * rho0 if thin else 0.9 * rho0), min(high, 0.995 * most if math.isfinite(most) else high)
    return max(_round(low), least * 1.001), min(_round(high), most * 0.999), min(max(_round(1.1 * hot, 2), 1000.0), HOTTEST)


def _round(value: float, digits: int = 4) -> float:
    return float(f"{value:.{digits}g}")
