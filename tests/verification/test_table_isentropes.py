"""Isentropes of tables, whose slopes leap at every edge of a cell, against an integration in other variables with its own cells.

In a cell p and e are bilinear in (rho, T), so de = p drho/rho^2 is dT/drho = (p/rho^2 - e_rho)/e_T, which DOP853 follows to the edge of
the cell; the package integrates e over ln(rho).
"""

import csv
import re

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract, table
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.shifted_energy import ShiftedEnergy
from hugoniot.laws.eos.tension_cutoff import TensionCutoff
from hugoniot.materials.tables_io import load
from hugoniot.theory.isentrope import isentrope, residual, state

ALUMINIUM = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)
GAS = IdealGas(1.4, 718.0, 1.2)
PRODUCTS = JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9, 1000.0)
# name -> law, densities, temperatures, (density, temperature) of the start, last density
CASES = {
    "aluminium": (ALUMINIUM, np.linspace(2600.0, 4300.0, 25), np.geomspace(200.0, 12000.0, 21), (3900.0, 3100.0), 2810.0),
    # five densities: each cell's straight cold curve makes the path turn in temperature, across many temperatures of the grid and back
    "wide_cells": (ALUMINIUM, np.linspace(2600.0, 4300.0, 5), np.linspace(100.0, 12000.0, 120), (3900.0, 700.0), 2810.0),
    "gas": (GAS, np.geomspace(0.01, 20.0, 30), np.geomspace(20.0, 9000.0, 33), (10.3, 2100.0), 0.02),
    "products": (PRODUCTS, np.geomspace(2.0, 2600.0, 45), np.geomspace(100.0, 20000.0, 40), (2200.0, 4000.0), 5.0),
}


def made(name):
    law, rho, t, *_ = CASES[name]
    return table.from_law(law, rho, t, rho0=contract.reference_state(law)[0])


def in_cell(par, i, j):
    """(p, e, dT/drho) as functions of (rho, T) in one cell, from its corners."""
    rho, t = par.density[i:i + 2], par.temperatures[j:j + 2]

    def corners(values):
        a, b, c, d = values[i, j], values[i + 1, j], values[i, j + 1], values[i + 1, j + 1]
        slope_rho, slope_t = (b - a) / np.diff(rho)[0], (c - a) / np.diff(t)[0]
        twist = (d - b - c + a) / (np.diff(rho)[0] * np.diff(t)[0])
        return (lambda r, x: a + slope_rho * (r - rho[0]) + slope_t * (x - t[0]) + twist * (r - rho[0]) * (x - t[0]),
                lambda r, x: slope_rho + twist * (x - t[0]), lambda r, x: slope_t + twist * (r - rho[0]))

    p, _, _ = corners(par.pressure_table)
    e, e_rho, e_t = corners(par.energy_table)
    return p, e, lambda r, x: (p(r, x[0]) / r**2 - e_rho(r, x[0])) / e_t(r, x[0])


def by_cells(par, start, end):
    """(pressure, energy) at the density `end` on the isentrope through start = (density, temperature), going down in density."""
    rho, t = start
    i, j = np.searchsorted(par.density, rho) - 1, np.searchsorted(par.temperatures, t) - 1
    for _ in range(1000):
        p, e, slope = in_cell(par, i, j)
        ends = [lambda r, x, k=k: x[0] - par.temperatures[k] for k in (j, j + 1)]
        for event, direction in zip(ends, (-1.0, 1.0)):
            event.terminal, event.direction = True, direction
        down = max(par.density[i], end)
        way = solve_ivp(slope, (rho, down), [t], method="DOP853", rtol=3e-14, atol=1e-11, events=ends, max_step=(rho - down) / 3.0)
        rho, t = way.t[-1], way.y[0, -1]
        if way.status == 1:
            j += -1 if way.t_events[0].size else 1
            t = par.temperatures[j + (1 if way.t_events[0].size else 0)]
        elif rho == end:
            return p(rho, t), e(rho, t)
        else:
            i -= 1
    raise AssertionError("the path does not arrive")


@pytest.mark.parametrize("name", CASES)
def test_the_first_law_holds_and_another_integration_finds_the_same_states(name):
    par, (*_, begin, end) = made(name), CASES[name]
    start = state(par, density=begin[0], temperature=begin[1])
    p, e = by_cells(par, begin, end)
    for points in (2, 9):
        path = isentrope(par, start, density=np.geomspace(begin[0], end, points))
        exchanged = start.specific_internal_energy - e
        assert residual(path) < 1e-11
        assert abs(path.specific_internal_energy[-1] - e) < 1e-11 * abs(exchanged)
        assert path.pressure[-1] == pytest.approx(p, rel=1e-9)     # the gas falls by a factor of 6000
    again = isentrope(par, start, pressure=np.linspace(start.pressure, p, 5))
    assert again.density[-1] == pytest.approx(end, rel=1e-11)


def test_a_table_inside_another_law_is_followed_by_its_cells():
    par, (*_, begin, end) = made("aluminium"), CASES["aluminium"]
    start = state(par, density=begin[0], temperature=begin[1])
    rho = np.linspace(begin[0], end, 5)
    found = isentrope(par, start, density=rho)
    for wrapped, shift in ((ShiftedEnergy(par, -4e6), 4e6), (TensionCutoff(par, 1e9), 0.0)):
        path = isentrope(wrapped, state(wrapped, density=begin[0], energy=start.specific_internal_energy + shift), density=rho)
        assert path.specific_internal_energy - shift == pytest.approx(found.specific_internal_energy, rel=1e-12)


@pytest.mark.slow  # compiles
@pytest.mark.parametrize("name", CASES)
def test_the_compiled_way_is_the_same(name):
    par, (*_, begin, end) = made(name), CASES[name]
    start = state(par, density=begin[0], temperature=begin[1])
    rho = np.geomspace(begin[0], end, 300)
    many, few = isentrope(par, start, density=rho), isentrope(par, start, density=rho[::23])
    assert many.specific_internal_energy[::23] == pytest.approx(few.specific_internal_energy, rel=1e-12)
    assert residual(few) < 1e-11


def test_a_table_read_from_a_file_is_followed_as_well(tmp_path):
    par, (*_, begin, end) = made("aluminium"), CASES["aluminium"]
    rho, t = np.meshgrid(par.density, par.temperatures, indexing="ij")
    with (tmp_path / "al.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(("density", "temperature", "pressure", "energy"))
        rows.writerows(zip(*(a.ravel().tolist() for a in (rho, t, par.pressure_table, par.energy_table))))
    read = load(tmp_path / "al.csv", rho0=2785.0)
    path = isentrope(read, state(read, density=begin[0], temperature=begin[1]), density=np.linspace(begin[0], end, 7))
    assert residual(path) < 1e-11
    assert path.specific_internal_energy[-1] == pytest.approx(by_cells(par, begin, end)[1], rel=1e-12)


@pytest.mark.parametrize(("density", "temperature", "given", "edge"), [
    (5.0, 8000.0, {"density": 19.0}, 9000.0), (1.0, 100.0, {"density": 0.0101}, 20.0), (1.0, 100.0, {"pressure": 10.0}, 20.0)])
def test_an_isentrope_that_leaves_the_table_ends_there(density, temperature, given, edge):
    par = made("gas")
    with pytest.raises(OutOfRange, match=r"isentrope of law 'table' ends at .* not defined beyond") as told:
        isentrope(par, state(par, density=density, temperature=temperature), **given)
    rho, e = (float(re.search(rf"([0-9.e+]+) {unit}", str(told.value)).group(1)) for unit in ("kg/m3", "J/kg"))
    assert contract.temperature(rho, e, par) == pytest.approx(edge, rel=1e-4)
