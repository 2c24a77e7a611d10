"""Surfaces of a law: pressure and energy over density and temperature, its isotherms, and at 0 K its cold curve."""

import math
from typing import Any

import numpy as np

from hugoniot.errors import HugoniotError, OutOfRange
from hugoniot.explorer.subjects import entry_of, inert_or_none
from hugoniot.laws.eos.contract import EOS, reference_state, require_temperature
from hugoniot.laws.eos.table import Table
from hugoniot.theory.hugoniot import Initial, limit, shock
from hugoniot.theory.isentrope import AMBIENT, at_temperature, reference
from hugoniot.theory.states import density_range

POINTS, MOST_POINTS = 61, 201
ISOTHERMS = (0.0, 300.0, 1000.0, 2000.0, 4000.0, 8000.0)      # K
HOTTEST = 20000.0   # K: where no table goes further
REACH = 1500.0      # m/s: particle velocity of the shock that sets the range where the data state none


def surface(name: str, densities: tuple[float, ...] = (), temperatures: tuple[float, ...] = (), points: int = POINTS,
            isotherms: bool = False) -> dict[str, Any]:
    """Pressure (Pa) and energy (J/kg), lists (n, m), at n densities (kg/m3) and m temperatures (K); None where the law has no state.

    densities      (lowest, highest); by default from some tension to the densest state of the Hugoniot that is drawn
    temperatures   (lowest, highest), or with `isotherms` any number of values
    Raises `OutOfRange` for a law without temperature and for ranges it does not have.
    """
    entry = entry_of(name)
    material = inert_or_none(entry) or entry.material
    require_temperature(material.eos)
    if not 2 <= points <= MOST_POINTS:
        raise OutOfRange(f"a surface has 2 to {MOST_POINTS} points in each direction")
    low, high, hottest = _ranges(material)
    low, high = _pair(densities, "densities") if densities else (low, high)
    least, most = density_range(material.eos)
    if not least <= low < high < most:
        raise OutOfRange(f"{name}: the law holds for densities from {max(least, 1e-6):.6g} to {most:.6g} kg/m3")
    rho = np.linspace(low, high, points)
    t = _temperatures(material, temperatures, hottest, points, isotherms)
    p, e = _grid(material, rho, t)
    return {"name": name, "density": rho, "temperature": t, "pressure": p, "specific_internal_energy": e}


def _pair(values: tuple[float, ...], words: str) -> tuple[float, float]:
    if len(values) != 2 or not 0.0 <= values[0] < values[1]:
        raise OutOfRange(f"{words}: give two increasing numbers")
    return values[0], values[1]


def _temperatures(material, given: tuple[float, ...], hottest: float, points: int, isotherms: bool) -> np.ndarray:
    if isotherms:
        values = np.array(sorted(set(given or ISOTHERMS)))
        if not 1 <= len(values) <= 24 or values[0] < 0.0:
            raise OutOfRange("give up to 24 temperatures for the isotherms, none below 0 K")
        if isinstance(material.eos, Table):
            grid = material.eos.temperatures
            values = values[(values >= grid[0]) & (values <= grid[-1])]
        return values if given else values[values <= max(hottest, 1000.0)]
    coldest = float(material.eos.temperatures[0]) if isinstance(material.eos, Table) else 0.0
    return np.linspace(*(_pair(given, "temperatures") if given else (coldest, hottest)), points)


def _ranges(material) -> tuple[float, float, float]:
    """(lowest, highest density, highest temperature) to draw: what the Hugoniot of the data reaches, in round numbers."""
    par, rho0 = material.eos, float(reference_state(material.eos)[0])
    least, most = density_range(par)
    thin = "gas" in EOS.of(par).flags or "reacted" in EOS.of(par).flags or reference(par).pressure > AMBIENT
    top = None
    if "reacted" not in EOS.of(par).flags:
        end = limit(par, Initial.at_rest(par)).particle_velocity
        for up in (material.valid_up_to or REACH, 1000.0, 300.0):
            try:
                top = shock(par, particle_velocity=min(up, 0.9 * end))
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


def _grid(material, rho: np.ndarray, t: np.ndarray) -> tuple[list, list]:
    """As `theory.isentrope.grid`, which `hugoniot eos table` prints, with None where the law has no such state."""
    p, e = [], []
    for density in rho.tolist():
        rows: tuple[list, list] = ([], [])
        for temperature in t.tolist():
            values: tuple[float | None, float | None]
            try:
                values = at_temperature(material, density, temperature)
            except HugoniotError:
                values = None, None
            for row, value in zip(rows, values):
                row.append(value)
        p.append(rows[0])
        e.append(rows[1])
    return p, e
