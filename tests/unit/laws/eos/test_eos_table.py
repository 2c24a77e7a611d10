"""Tables p(rho, T), e(rho, T): interpolation, inverse, soundness, and the text files they come from."""

import math

import numpy as np
import pytest

from hugoniot.core.tables import bilinear, bracket, bracket_blend
from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.laws.eos import contract, table
from hugoniot.laws.eos.contract import (
    EOS,
    check_state,
    energy,
    pressure,
    pressure_derivatives,
    reference_state,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.eos.davis_reactants import DavisReactants
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.tillotson import Tillotson
from hugoniot.materials import tables_io

SOLID = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)


@pytest.fixture(scope="module")
def solid_table():
    return table.from_law(SOLID, np.linspace(2600.0, 4600.0, 41), np.geomspace(150.0, 20000.0, 30), rho0=2785.0)


@pytest.mark.parametrize("n", [*range(2, 35), 64, 201])
def test_bracket_finds_the_cell(n):
    grid = np.sort(np.random.default_rng(n).uniform(0.0, 1.0, n))
    for x in np.concatenate([grid, np.random.default_rng(1).uniform(-0.1, 1.1, 50)]):
        expected = int(np.clip(np.searchsorted(grid, x, side="right") - 1, 0, n - 2))
        assert bracket(grid, x) == expected
        two = np.stack([grid, grid + 0.0])
        assert bracket_blend(two, 0, 0.3, x) == expected


def test_bilinear_is_exact_on_bilinear_functions():
    def f(x, y):
        return 2.0 + 3.0 * x - y + 0.5 * x * y

    cell = np.array([[f(x, y) for y in (0.0, 1.0)] for x in (0.0, 1.0)])
    value, by_f, by_g = bilinear(cell, 0, 0, 0.3, 0.8)
    assert (value, by_f, by_g) == pytest.approx((f(0.3, 0.8), 3.4, -0.85), rel=1e-14)


def test_second_order_towards_the_law():
    errors = []
    for n in (21, 41, 81):
        made = table.from_law(SOLID, np.linspace(2600.0, 4600.0, n), np.linspace(200.0, 8000.0, n))
        rng = np.random.default_rng(0)
        squares = []
        for rho in rng.uniform(2900.0, 4300.0, 400):
            e = energy_at(rho, rng.uniform(400.0, 7000.0))
            squares.append((pressure(rho, e, made) / pressure(rho, e, SOLID) - 1.0) ** 2)
            squares.append((temperature(rho, e, made) / temperature(rho, e, SOLID) - 1.0) ** 2)
        errors.append(math.sqrt(np.mean(squares)))
    assert 1.85 < math.log2(errors[0] / errors[1]) < 2.4
    assert 1.85 < math.log2(errors[1] / errors[2]) < 2.4


def energy_at(rho, t, par=SOLID):
    return table._energy_at(rho, t, par)


def test_inverse_interpolation_is_exact(solid_table):
    for rho in (2610.0, 2785.0, 3333.0, 4600.0):
        for t in (150.0, 298.15, 4321.0, 19999.0):
            p, e = table.state_at(rho, t, solid_table)
            assert temperature(rho, e, solid_table) == pytest.approx(t, rel=1e-12)
            assert pressure(rho, e, solid_table) == pytest.approx(p, rel=1e-11)


def test_derivatives_inside_cells(solid_table):
    rho, e, h = 3333.3, 5e6, 1e-6
    p_rho, p_e = pressure_derivatives(rho, e, solid_table)
    assert (pressure(rho + h, e, solid_table) - pressure(rho - h, e, solid_table)) / (2 * h) == pytest.approx(p_rho, rel=1e-6)
    assert (pressure(rho, e + 1, solid_table) - pressure(rho, e - 1, solid_table)) / 2 == pytest.approx(p_e, rel=1e-7)
    assert sound_speed_squared(rho, e, solid_table) == pytest.approx(sound_speed_squared(rho, e, SOLID), rel=0.03)


def test_rest_state(solid_table):
    rho, e = reference_state(solid_table)
    assert rho == 2785.0
    assert temperature(rho, e, solid_table) == pytest.approx(298.15, rel=1e-12)
    found = table.build(*solid_table[:4])
    assert found.rho0 == pytest.approx(2785.0, rel=3e-4)
    assert pressure(found.rho0, found.e0, found) == pytest.approx(0.0, abs=1e-3)


def test_law_with_a_specific_heat_that_varies():
    explosive = DavisReactants(1890.0, 1800.0, 4.6, 0.34, 0.56, 0.0, 0.4265, 0.0, 1074.0, 297.0)
    made = table.from_law(explosive, np.linspace(1800.0, 2600.0, 60), np.linspace(250.0, 2500.0, 120))
    for t in (297.0, 1700.0):
        e = table._energy_at(2200.0, t, explosive)
        assert temperature(2200.0, e, explosive) == pytest.approx(t, rel=1e-9)
        assert temperature(2200.0, e, made) == pytest.approx(t, rel=1e-3)


def test_gas_table_needs_a_rest_density():
    gas = IdealGas(1.4, 717.5)
    made = table.from_law(gas, np.geomspace(0.1, 10.0, 60), np.linspace(200.0, 3000.0, 20))
    assert made.rho0 == 1.2
    with pytest.raises(OutOfRange, match="give rho0"):
        table.build(*made[:4])
    assert pressure(1.3, energy(1.3, 2e5, gas), made) == pytest.approx(2e5, rel=1e-12)


def test_outside_is_refused_with_the_limits(solid_table):
    with pytest.raises(OutOfRange, match="4600"):
        check_state(4700.0, 5e6, solid_table)
    with pytest.raises(OutOfRange, match="the range of the law at 3000"):
        check_state(3000.0, 1e9, solid_table)
    check_state(3000.0, 1e6, solid_table)


def broken(made, **change):
    values = dict(density=made.density.copy(), temperatures=made.temperatures.copy(), pressure_table=made.pressure_table.copy(),
                  energy_table=made.energy_table.copy(), rho0=2785.0)
    for name, (place, value) in change.items():
        values[name][place] = value
    return values


@pytest.mark.parametrize("change, message", [
    ({"pressure_table": ((3, 4), math.nan)}, r"no pressure is given at density 2750 kg/m3"), ({"energy_table": ((5, 9), 0.0)}, "must rise with temperature"),
    ({"density": (6, 2600.0)}, "value 7 .2600 kg/m3. does not exceed value 6"), ({"temperatures": (0, math.inf)}, "value 1 of the temperature grid is not a number"),
    ({"pressure_table": ((20, 10), 1e12)}, r"squared sound speed is not positive at density")])
def test_unsound_tables_are_refused_with_the_place(solid_table, change, message):
    with pytest.raises(OutOfRange, match=message):
        table.build(**broken(solid_table, **change))


def test_wrong_size_and_law_without_temperature(solid_table):
    with pytest.raises(OutOfRange, match="41 densities x 30 temperatures"):
        table.build(solid_table.density, solid_table.temperatures, solid_table.pressure_table[:-1], solid_table.energy_table, 2785.0)
    with pytest.raises(OutOfRange, match="no temperature"):
        table.from_law(Tillotson(2700.0, 0.5, 1.63, 75.2e9, 65e9, 5.0, 5.0, 5e6, 3e6, 13.9e6), (2700.0, 3000.0), (300.0, 400.0))


def csv_text(made):
    rows = ["# aluminium", "temperature,density,energy,pressure"]
    for i, rho in enumerate(made.density):
        rows += [f"{t!r},{rho!r},{e!r},{p!r}" for t, e, p in zip(made.temperatures.tolist(), made.energy_table[i].tolist(), made.pressure_table[i].tolist())]
    return "\n".join(rows).replace("np.float64(", "").replace(")", "")


def test_csv_round_trip(solid_table, tmp_path):
    path = tmp_path / "al.csv"
    path.write_text(csv_text(solid_table))
    again = tables_io.load(path, rho0=2785.0)
    for a, b in zip(again, solid_table):
        np.testing.assert_array_equal(a, b)


@pytest.mark.parametrize("spoil, message", [
    (lambda t: t.replace("energy,pressure", "energy,presure"), r"al.csv:2: header: needs exactly one column 'pressure'"),
    (lambda t: t.replace("\n150", "\nx150", 1), r"al.csv:3: temperature: 'x150.0' is not a number"), (lambda t: t + "\n" + t.splitlines()[2], "given twice"),
    (lambda t: "\n".join(t.splitlines()[:-1]), "no row gives density 4600 kg/m3 at temperature 20000 K"), (lambda t: "", "no rows")])
def test_bad_csv_names_the_line(solid_table, spoil, message):
    text = csv_text(solid_table)
    assert "\n150.0," in text
    with pytest.raises(DeckError, match=message):
        tables_io.read_csv(spoil(text), "al.csv")


def sesame_text(made, style, number="{:15.8E}"):
    words = [len(made.density), len(made.temperatures), *(made.density / 1e3), *made.temperatures,
             *(made.pressure_table.T.ravel() / 1e9), *(made.energy_table.T.ravel() / 1e6)]
    lines = []
    for k in range(0, len(words), 5):
        lines.append("".join(number.format(float(w)) for w in words[k:k + 5]) + ("11111" if style == "exchange" else ""))
    if style == "exchange":
        return "\n".join([" 0  3720   101   240   r   82803   22704   1", "material. aluminum 3.1416 made up", " 1  3720   201     5   r   82803   22704   1",
                          " 1.30000000E+01 2.69800000E+01 2.78500000E+00 0.00000000E+00 0.00000000E+0011111",
                          f" 1  3720   301 {len(words)}   r   82803   22704   1", *lines, " 2"])
    return "\n".join([" INDEX      MATID ...   NWDS = 9", " 1.0 2.0", " RECORD     TYPE =  201     NWDS =        5", " 1.3E+01 2.7E+01",
                      f" RECORD     TYPE =  301     NWDS = {len(words)}", *lines])


@pytest.mark.parametrize("style", ["exchange", "sandia"])
@pytest.mark.parametrize("number", ["{:16.8E}", "{:15.8E}"])
def test_sesame_301_is_read_in_both_styles(solid_table, style, number):
    """At width 15 a negative number touches the one before it."""
    again = tables_io.read_301(sesame_text(solid_table, style, number), rho0=2785.0)
    np.testing.assert_allclose(again.density, solid_table.density, rtol=1e-8)
    np.testing.assert_allclose(again.pressure_table, solid_table.pressure_table, rtol=1e-7, atol=10.0)
    np.testing.assert_allclose(again.energy_table, solid_table.energy_table, rtol=1e-7, atol=0.1)
    assert pressure(3333.0, 5e6, again) == pytest.approx(pressure(3333.0, 5e6, solid_table), rel=1e-6)


def test_sesame_cut_and_fortran_exponents(solid_table):
    text = sesame_text(solid_table, "exchange").replace("E+", "D+")
    cut = tables_io.read_301(text, rho0=3000.0, density_range=(2900.0, 4000.0), temperature_range=(200.0, 1e4), material=3720)
    assert cut.density[0] >= 2900.0
    assert cut.density[-1] <= 4000.0
    assert cut.temperatures[-1] <= 1e4


@pytest.mark.parametrize("spoil, message", [(lambda t: t.replace("   301 ", "   305 "), "no 301 table"), (lambda t: "\n".join(t.splitlines()[:80]), "truncated"),
                                            (lambda t: t.replace(" 4.10000000E+01", " 4.15000000E+01", 1), "numbers of densities")])
def test_bad_sesame_is_one_message(solid_table, spoil, message):
    with pytest.raises(DeckError, match=message):
        tables_io.read_301(spoil(sesame_text(solid_table, "exchange")), "al.ses")


def test_files_that_are_not_tables(tmp_path):
    binary = tmp_path / "x.dat"
    binary.write_bytes(b"\x89HDF\xff\xfe")
    with pytest.raises(DeckError, match="not a text file"):
        tables_io.load(binary)
    with pytest.raises(FileTrouble, match="No such file"):
        tables_io.load(tmp_path / "missing.csv")
    with pytest.raises(DeckError, match="no 301 table of material 99"):
        tables_io.read_301("nothing here", material=99)


@pytest.mark.parametrize("law", [law for law in EOS if contract.has_temperature(law.example)], ids=lambda law: law.name)
def test_a_table_of_any_law_inverts_exactly(law):
    """T(rho, e) of p(rho, T), e(rho, T), over the law's own box; c^2 > 0 is checked by `build`."""
    low, high = law.box["rho"]
    low = 2300.0 if law.name == "p_lambda" else low  # hot and half crushed, its interpolated c^2 is negative, which is refused
    rho = np.linspace(low, high, 15) if high < 20.0 * low else np.geomspace(low, high, 15)
    made = table.from_law(law.example, rho, np.geomspace(200.0, 2e4, 15), rho0=rho[3])
    rng = np.random.default_rng(4)
    for r, t in zip(rng.uniform(rho[0], rho[-1], 60), rng.uniform(250.0, 1.9e4, 60)):
        p, e = table.state_at(r, t, made)
        assert contract.temperature(r, e, made) == pytest.approx(t, rel=1e-12)
        assert contract.pressure(r, e, made) == pytest.approx(p, rel=1e-12, abs=1e-3)
    for r in rho[[0, 7]]:
        t = 200.0 * 100.0 ** (5.0 / 14.0)
        p, e = table.state_at(r, t, made)
        assert contract.temperature(r, e, law.example) == pytest.approx(t, rel=1e-9)
        assert contract.pressure(r, e, law.example) == pytest.approx(p, rel=1e-9, abs=1.0)
