r"""Tabulated equation of state: pressure and energy as functions of density and temperature, for instance from a SESAME file.

A deck gives the table itself, as in the example, or names a file (`file = "copper.h5"`, in CSV, HDF5 or SESAME format). In each cell of
density and temperature both tables are bilinear. At given density and energy the cell is found by bisection, and the temperature in it in
closed form. With subscripts for derivatives of the table in $\rho$ and $T$,

$$\frac{\partial p}{\partial e}\Big|_\rho = \frac{p_T}{e_T}, \quad
  \frac{\partial p}{\partial\rho}\Big|_e = p_\rho - e_\rho\frac{p_T}{e_T}.$$

A table is refused if a value is missing, if a grid does not increase, if the energy does not rise with temperature everywhere (which would
give $c_v \le 0$), or if $c^2 \le 0$ at a corner of a cell with $p \ge 0$. With `least_sound_speed` $c_m$ such corners are accepted:
wherever $c^2 < c_m^2$ the slope $\partial p/\partial\rho$ is raised until $c = c_m$. Pressures and energies remain those of the table.

Outside the grid a run extrapolates the nearest cell. The law has no entropy: bilinear tables satisfy the identity $e_v = Tp_T - p$, with
$v = 1/\rho$, only to the resolution of the table. In a wide cell the temperature may even fall in a weak compression, as it does from the
reference state of the example; heat conduction then makes a shock thinner instead of thicker. In Python `hugoniot.laws.eos.table.from_law`
tabulates any law that has a temperature.

Source: KB codes, section 3 (tables in density and temperature); Lyon and Johnson, LA-UR-92-3407 (1992) (SESAME table 301).
"""

import math
from typing import Any, NamedTuple

import numpy as np

from hugoniot.core.ops import fmax
from hugoniot.core.tables import bilinear, bracket, bracket_blend
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen


class UnsoundTable(OutOfRange):
    """A table that `build` refuses; `place` = (row of the density, column of the temperature) where it is one point."""

    def __init__(self, message: str, place: tuple[int, int] | None = None):
        super().__init__(message)
        self.place = place


class Table(NamedTuple):
    """density (n,), temperatures (m,), pressure_table and energy_table (n, m); reference state (filled by `build`); lower bound of c."""

    density: Any
    temperatures: Any
    pressure_table: Any
    energy_table: Any
    rho0: float
    e0: float
    least_sound_speed: float = 0.0


def _locate(rho, e, par):
    """(i, j, f, g): the cell of (rho, e) and the fractions in it."""
    i = bracket(par.density, rho)
    f = (rho - par.density[i]) / (par.density[i + 1] - par.density[i])
    j = bracket_blend(par.energy_table, i, f, e)
    low = par.energy_table[i, j] + f * (par.energy_table[i + 1, j] - par.energy_table[i, j])
    high = par.energy_table[i, j + 1] + f * (par.energy_table[i + 1, j + 1] - par.energy_table[i, j + 1])
    return i, j, f, (e - low) / (high - low)


def pressure(rho, e, par):
    i, j, f, g = _locate(rho, e, par)
    return bilinear(par.pressure_table, i, j, f, g)[0]


def pressure_derivatives(rho, e, par):
    i, j, f, g = _locate(rho, e, par)
    p, p_f, p_g = bilinear(par.pressure_table, i, j, f, g)
    _, e_f, e_g = bilinear(par.energy_table, i, j, f, g)
    p_e = p_g / e_g
    p_rho = (p_f - e_f * p_e) / (par.density[i + 1] - par.density[i])
    if par.least_sound_speed > 0.0:
        p_rho = fmax(p_rho, par.least_sound_speed * par.least_sound_speed - p * p_e / (rho * rho))
    return p_rho, p_e


def temperature(rho, e, par):
    _, j, _, g = _locate(rho, e, par)
    return par.temperatures[j] + g * (par.temperatures[j + 1] - par.temperatures[j])


def specific_heat(rho, e, par):
    i, j, f, g = _locate(rho, e, par)
    return bilinear(par.energy_table, i, j, f, g)[2] / (par.temperatures[j + 1] - par.temperatures[j])


def smooth_piece(rho, e, way, par):
    """The cell entered, as a table of its own; at an edge the one that 1e-12 of the density further on along the isentrope lies in."""
    on = 1e-12 * way
    i, j, f, g = _locate(rho * (1.0 + on), e + on * pressure(rho, e, par) / rho, par)
    cell = Table(par.density[i:i + 2], par.temperatures[j:j + 2], par.pressure_table[i:i + 2, j:j + 2], par.energy_table[i:i + 2, j:j + 2],
                 par.rho0, par.e0, par.least_sound_speed)
    inside = 0.0 <= f <= 1.0 and 0.0 <= g <= 1.0
    return cell, par.density[i], par.density[i + 1] if inside else par.density[i]


def piece_coordinate(rho, e, piece):
    """The fraction of the cell's temperatures, and its slopes."""
    i, j, f, g = _locate(rho, e, piece)
    _, e_f, e_g = bilinear(piece.energy_table, i, j, f, g)
    return g, -e_f / (e_g * (piece.density[i + 1] - piece.density[i])), 1.0 / e_g


def reference_state(par):
    return par.rho0, par.e0


def density_limits(par):
    return float(par.density[0]), float(par.density[-1])


def energy_limits(rho, par):
    """(lowest, highest) energy tabulated at a density."""
    i = bracket(par.density, rho)
    f = (rho - par.density[i]) / (par.density[i + 1] - par.density[i])
    row = par.energy_table[i] + f * (par.energy_table[i + 1] - par.energy_table[i])
    return float(row[0]), float(row[-1])


def state_at(rho, temperature, par):
    """(p, e) at a density and temperature of the table."""
    i, j = bracket(par.density, rho), bracket(par.temperatures, temperature)
    f = (rho - par.density[i]) / (par.density[i + 1] - par.density[i])
    g = (temperature - par.temperatures[j]) / (par.temperatures[j + 1] - par.temperatures[j])
    return bilinear(par.pressure_table, i, j, f, g)[0], bilinear(par.energy_table, i, j, f, g)[0]


def build(density, temperatures, pressure_table, energy_table, rho0=math.nan, reference_temperature=298.15,
          least_sound_speed=0.0):
    """A checked table.

    density (n,) kg/m3 and temperatures (m,) K increasing; pressure_table (n, m) Pa and energy_table (n, m) J/kg, or flat lists of
    n m numbers, temperature running fastest. The reference state is (rho0, reference_temperature); without rho0, the highest density at
    which the isotherm crosses zero pressure. least_sound_speed, m/s: see above; 0 refuses unstable corners. Raises OutOfRange with the
    place and the way out.
    """
    rho = _grid("density", density)
    t = _grid("temperature", temperatures)
    p, e = _filled("pressure", pressure_table, rho, t), _filled("energy", energy_table, rho, t)
    _check_energy(e, rho, t)
    if not 0.0 <= least_sound_speed < math.inf:
        raise OutOfRange(f"table: least_sound_speed must be finite and not negative, got {least_sound_speed:g} m/s")
    table = Table(rho, t, p, e, math.nan, math.nan, float(least_sound_speed))
    if bad := [] if least_sound_speed else unstable_corners(table):
        i, j = bad[0]
        raise UnsoundTable(f"table: the squared sound speed is not positive at density {rho[i]:.6g} kg/m3, temperature {t[j]:.6g} K "
                           f"(such grid points: {len(bad)}); smooth the table, end the grid before that point, or give least_sound_speed",
                           (i, j))
    if not math.isfinite(rho0):
        rho0 = _rest_density(table, reference_temperature)
    if not rho[0] <= rho0 <= rho[-1]:
        raise OutOfRange(f"table: rho0 = {rho0:.6g} kg/m3 is outside the densities of the grid, {rho[0]:.6g} to {rho[-1]:.6g} kg/m3")
    return table._replace(rho0=float(rho0), e0=float(state_at(rho0, reference_temperature, table)[1]))


def _grid(name, values):
    grid = np.ascontiguousarray(values, dtype=np.float64)
    if grid.ndim != 1 or grid.size < 2:
        raise OutOfRange(f"table: the {name} grid needs at least two values")
    bad = np.flatnonzero(~np.isfinite(grid))
    if bad.size:
        raise OutOfRange(f"table: value {bad[0] + 1} of the {name} grid is not a number")
    bad = np.flatnonzero(np.diff(grid) <= 0.0)
    if bad.size:
        unit = {"density": "kg/m3", "temperature": "K"}[name]
        raise OutOfRange(f"table: the {name} grid must increase, but value {bad[0] + 2} ({grid[bad[0] + 1]:.6g} {unit}) does not exceed "
                         f"value {bad[0] + 1} ({grid[bad[0]]:.6g} {unit})")
    return grid


def _filled(name, values, rho, t):
    table = np.ascontiguousarray(values, dtype=np.float64)
    if table.size != rho.size * t.size:
        raise OutOfRange(f"table: {name} has {table.size} values, but {rho.size} densities x {t.size} temperatures "
                         f"need {rho.size * t.size}")
    table = table.reshape(rho.size, t.size)
    holes = np.argwhere(~np.isfinite(table))
    if holes.size:
        i, j = holes[0]
        raise UnsoundTable(f"table: no {name} is given at density {rho[i]:.6g} kg/m3, temperature {t[j]:.6g} K "
                           f"({len(holes)} missing in all); add it, or end the grid before that point", (i, j))
    return table


def _check_energy(e, rho, t):
    bad = np.argwhere(np.diff(e, axis=1) <= 0.0)
    if bad.size:
        i, j = bad[0]
        raise UnsoundTable(f"table: the energy must rise with temperature, but at density {rho[i]:.6g} kg/m3 it does not between "
                           f"{t[j]:.6g} and {t[j + 1]:.6g} K (such places: {len(bad)}); "
                           "correct the table, end the grid before that point, or read it with repair = true", (i, j + 1))


def unstable_corners(table):
    """[(row of the density, column of the temperature)] of corners of cells where p >= 0 and c^2 <= 0 by that cell's own slopes."""
    rho, p, e = table.density, table.pressure_table, table.energy_table
    d_rho, found = np.diff(rho)[:, None], []
    for f in (0, 1):
        for g in (0, 1):
            p_rho, e_rho = np.diff(p, axis=0)[:, g:p.shape[1] - 1 + g] / d_rho, np.diff(e, axis=0)[:, g:p.shape[1] - 1 + g] / d_rho
            p_e = np.diff(p, axis=1)[f:len(rho) - 1 + f] / np.diff(e, axis=1)[f:len(rho) - 1 + f]
            corner = p[f:len(rho) - 1 + f, g:p.shape[1] - 1 + g]
            at = rho[f:len(rho) - 1 + f, None]
            c2 = p_rho - e_rho * p_e + corner * p_e / (at * at)
            found += [(i, j) for i, j in np.argwhere((c2 <= 0.0) & (corner >= 0.0)) + (f, g)]
    return found


def _rest_density(table, temperature):
    p = np.array([state_at(r, temperature, table)[0] for r in table.density])
    up = np.flatnonzero((p[:-1] < 0.0) & (p[1:] >= 0.0))
    if not up.size:
        raise OutOfRange(f"table: no density has zero pressure at {temperature:.6g} K; give rho0, the reference density")
    i = up[-1]
    return table.density[i] - p[i] * (table.density[i + 1] - table.density[i]) / (p[i + 1] - p[i])


def from_law(par, density, temperatures, rho0=math.nan, reference_temperature=298.15):
    """The table of any law that has a temperature, on the grids `density` (kg/m3) and `temperatures` (K)."""
    contract.require_temperature(par)
    rho, t = _grid("density", density), _grid("temperature", temperatures)
    e = np.array([[_energy_at(r, x, par) for x in t] for r in rho])
    p = np.array([[contract.pressure(r, u, par) for u in row] for r, row in zip(rho, e)])
    if not math.isfinite(rho0):
        rho0 = contract.reference_state(par)[0]
    return build(rho, t, p, e, rho0, reference_temperature)


def _energy_at(rho, temperature, par):
    """Energy at which the law has the temperature, by Newton's method (one step for a constant specific heat).

    A trial colder than 0 K, where laws have no specific heat, halves the step that led there (or lifts the start).
    """
    good, e, step, found = math.nan, contract.reference_state(par)[1], 1e5, math.nan
    with np.errstate(invalid="ignore"):
        for _ in range(200):
            found = contract.temperature(rho, e, par)
            if found > 0.0:
                good, step = e, (temperature - found) * contract.specific_heat(rho, e, par)
                if abs(temperature - found) <= 1e-12 * temperature:
                    return e + step
            elif math.isfinite(good):
                step *= 0.5
            else:
                step *= 2.0
            e = (good if math.isfinite(good) else e) + step
    raise OutOfRange(f"{EOS.of(par).name}: no energy gives {temperature:.6g} K at density {rho:.6g} kg/m3")


def _example():
    solid = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)
    return from_law(solid, (2500.0, 2785.0, 3200.0, 3700.0, 4300.0), (100.0, 300.0, 5000.0, 40000.0))


EOS.add(
    "table", Table,
    functions=[pressure, pressure_derivatives, temperature, specific_heat, reference_state, density_limits, energy_limits,
               smooth_piece, piece_coordinate],
    example=_example(),
    build=build,
    units={"density": "kg/m^3", "temperatures": "K", "pressure_table": "Pa", "energy_table": "J/kg", "rho0": "kg/m^3", "e0": "J/kg",
           "reference_temperature": "K", "least_sound_speed": "m/s"},
    meaning={"density": "densities of the grid", "temperatures": "temperatures of the grid",
             "pressure_table": "pressures, at all temperatures for the first density, then for the next",
             "energy_table": "specific internal energies in the same order",
             "rho0": "reference density; by default the highest with zero pressure at the reference temperature",
             "e0": "energy of the reference state (filled by build)", "reference_temperature": "temperature of the reference state",
             "least_sound_speed": "lower bound of the sound speed where the table has less or none; with 0 such a table is refused"},
    defaults={"rho0": math.nan, "reference_temperature": 298.15, "least_sound_speed": 0.0},
    least={"least_sound_speed": 0.0},
    box={"rho": (2600.0, 4200.0), "e": (5e6, 2e7)},
    references=("KB codes, section 3", "Lyon and Johnson, LA-UR-92-3407 (1992)"),
)
