"""SESAME-format files with all their tables: what is read, whether the parts add up, which part a deck takes."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import pressure, sound_speed_squared
from hugoniot.laws.eos.table import state_at
from hugoniot.materials import sesame
from hugoniot.materials.tables_io import Window, load, read
from hugoniot.problem.deck import read_deck

RHO, T = np.linspace(2000.0, 6000.0, 21), np.linspace(0.0, 3000.0, 11)


def parts():
    """{table: (p, e)} of a solid by parts: a cold curve, ions of constant Gamma and c_v, electrons with energies as T^2."""
    rho, t = RHO[:, None], T[None, :]
    ions, electrons = 900.0 * t + 0.0 * rho, 2e-2 * t * t + 0.0 * rho
    cold = (75e9 * (rho / 2700.0 - 1.0), 2e6 * (1.0 - 2700.0 / rho) ** 2)
    found = {306: tuple(np.array(c[:, :1]) for c in cold), 305: (2.0 * rho * ions, ions), 304: (2.0 / 3.0 * rho * electrons, electrons)}
    found[303] = tuple(a + b for a, b in zip(found[305], found[306]))
    found[301] = tuple(a + b for a, b in zip(found[303], found[304]))
    return found


def text_of(tables, material=4100, more=()):
    def block(number, words):
        rows = ["".join(f"{float(w):22.14E}" for w in words[k:k + 5]) for k in range(0, len(words), 5)]
        return [f" 1  {material}   {number}  {len(words)}  r 82993   82704   1", *rows]

    lines = [f" 0  {material}   101   40   r   82803   22704   1", "material. made up 3.14", *block(201, [13.0, 26.98, 2.7, 0.0, 0.0])]
    for number, (p, e) in tables.items():
        lines += block(number, [RHO.size, p.shape[1], *(RHO / 1e3), *T[:p.shape[1]], *(p.T.ravel() / 1e9), *(e.T.ravel() / 1e6)])
    for number, words in more:
        lines += block(number, words)
    return "\n".join([*lines, " 2"])


@pytest.mark.parametrize("number", [301, 303, 304, 305])
def test_each_part_is_the_law_its_table_holds(tmp_path, number):
    p, e = parts()[number]
    (tmp_path / "al.ses").write_text(text_of(parts()))
    law = load(tmp_path / "al.ses", rho0=2700.0, table=number, least_sound_speed=1.0 if number in (304, 305) else 0.0)
    assert state_at(3000.0, 600.0, law) == pytest.approx((p[5, 2], e[5, 2]), rel=1e-12)


def test_a_file_without_the_total_gives_the_sum_of_its_parts(tmp_path):
    made, whole = parts(), load_text(tmp_path, text_of(parts()))
    for missing in ((301,), (301, 303)):
        law = load_text(tmp_path, text_of({k: v for k, v in made.items() if k not in missing}))
        np.testing.assert_allclose(law.pressure_table, whole.pressure_table, rtol=1e-12, atol=1.0)
        np.testing.assert_allclose(law.energy_table, whole.energy_table, rtol=1e-12, atol=1e-6)


def load_text(folder, text, **wanted):
    (folder / "al.ses").write_text(text)
    return load(folder / "al.ses", rho0=2700.0, **wanted)


@pytest.mark.parametrize("change, wanted, message", [
    (lambda t: t, {"table": 306}, "a cold curve has one temperature"), (lambda t: t, {"material": 7}, "no 301 table of material 7 in this file; choose a material of this file: 4100"),
    (lambda t: t.replace("   304  ", "   301  ").replace("   303  ", "   305  "), {"table": 303}, "no 303 table in this file; it has 301, 305, 306; choose table 301 or 305, or give a file that has 303"),
    (lambda t: "* INPUT\nANEOS1    -1  'Al solid'\n", {}, "the input of the ANEOS program, not a table")])
def test_what_a_file_does_not_give_is_refused_with_what_it_has(tmp_path, change, wanted, message):
    with pytest.raises(DeckError, match=message):
        load_text(tmp_path, change(text_of(parts())), **wanted)


def test_a_table_of_entropies_and_sound_speeds_is_not_taken_for_pressures(tmp_path):
    p, e = parts()[301]
    with pytest.raises(DeckError, match="four values or more at each point.*NEW-SESAME-STD"):
        load_text(tmp_path, text_of({301: (np.hstack([p, p]), np.hstack([e, e]))}).replace(f"{22:22.14E}", f"{11:22.14E}", 1))


def test_parts_are_checked_against_the_total():
    found = sesame.records(text_of(parts()))
    assert all(max(miss[:2]) < 1e-12 for miss in sesame.sum_differences(found).values()) and len(sesame.sum_differences(found)) == 2
    made = parts()
    made[301][0][7, 3] *= 1.1
    miss = sesame.sum_differences(sesame.records(text_of(made)))[303, 304]
    assert miss[0] == pytest.approx(0.1, rel=1e-6) and miss[2:] == (RHO[7], T[3])


def test_the_command_shows_parts_coexistence_and_a_sum_that_misses(tmp_path):
    made = parts()
    made[301][1][3, 2] += 1e5
    vapour = [2, 1e-9, 0.5, 1000.0, 7000.0, 1e-6, 0.6, 2.6, 0.6, 12.0, 14.0, 1.0, 14.0]
    melting = [2, 1, 2.5, 3.0, 0.0, 933.0, 1200.0, 0.0, 10.0, 0.9, 1.2]
    path = tmp_path / "al.ses"
    path.write_text(text_of(made, more=((401, vapour), (411, melting))))
    run = CliRunner().invoke(build_app("eos"), ["eos", "sesame", str(path), "--temperature", "900 K", "--csv", str(tmp_path / "x.csv")])
    assert run.exit_code == 0, run.output
    for text in ("401 vaporization to 7000 K, 0.5 GPa, 600 and 600 kg/m3", "411 solid on the melting line: 933 K at 0 GPa to 1200 K at 10 GPa",
                 "306 cold curve: zero pressure at 2700 kg/m3", "tables 303 + 304 differs from table 301"):
        assert text in run.output
    rows = np.genfromtxt(tmp_path / "x.csv", delimiter=",", names=True, deletechars="")
    assert (rows["temperature_(K)"][5], rows["density_(kg/m^3)"][5]) == (900.0, RHO[5]) and rows["pressure_301_(Pa)"][5] == pytest.approx(parts()[301][0][5, 3], rel=1e-12)
    run = CliRunner().invoke(build_app("eos"), ["eos", "sesame", str(path), "--json"])
    found = json.loads(run.stdout)
    assert found["sums"]["303 + 304"]["energy"] > 1e-3 and found["coexistence"]["412" if "412" in found["coexistence"] else "411"]["number"] == 411


# -- tables whose energy falls --------------------------------------------------------------------------------------
def fallen():
    """A table of a solid with two entries out of order, and where they are."""
    p, e = (a.copy() for a in parts()[301])
    e[8, 2], e[12, 3] = e[8, 2] + 9e5, e[12, 3] - 9e5
    return p, e


def test_repair_draws_lines_between_the_neighbours_and_says_where(tmp_path):
    p, e = fallen()
    with pytest.raises(DeckError, match="does not between.*such places: 2.*repair = true"):
        load_text(tmp_path, text_of({301: (p, e)}))
    law, (note,) = read(tmp_path / "al.ses", Window(2700.0, repair=True))
    changed = np.argwhere(law.energy_table != e[:, :])
    assert {tuple(c) for c in changed if abs(law.energy_table[tuple(c)] - e[tuple(c)]) > 1.0} == {(8, 2), (12, 3)}
    for i, j in ((8, 2), (12, 3)):
        share = (T[j] - T[j - 1]) / (T[j + 1] - T[j - 1])
        for table, before in ((law.energy_table, e), (law.pressure_table, p)):
            assert table[i, j] == pytest.approx(before[i, j - 1] + share * (before[i, j + 1] - before[i, j - 1]), rel=1e-9)
    assert "(such places: 2); entries interpolated between their neighbours: 2 of 231, at densities from 3600 to 4400 kg/m3 and temperatures from 600 to 900 K" in note


def test_a_sound_table_is_not_touched_by_repair(tmp_path):
    whole = load_text(tmp_path, text_of(parts()))
    law, notes = read(tmp_path / "al.ses", Window(2700.0, repair=True, least_sound_speed=1.0))
    assert notes == () and np.array_equal(law.energy_table, whole.energy_table) and np.array_equal(law.pressure_table, whole.pressure_table)


def test_an_unstable_place_keeps_its_pressures_and_gets_the_least_sound_speed(tmp_path):
    p, e = (a.copy() for a in parts()[301])
    p[10] = p[9]      # a plateau: c^2 <= 0 while the energy rises
    e[10] = e[9] + 1e6
    with pytest.raises(DeckError, match="or give least_sound_speed"):
        load_text(tmp_path, text_of({301: (p, e)}))
    law, (note,) = read(tmp_path / "al.ses", Window(2700.0, least_sound_speed=25.0))
    rho, heat = 0.5 * (RHO[9] + RHO[10]), 0.5 * (law.energy_table[9, 2] + law.energy_table[10, 2])
    assert "25 m/s is used there" in note
    assert sound_speed_squared(rho, heat, law) == pytest.approx(625.0)
    assert pressure(rho, heat, law) == pytest.approx(pressure(rho, heat, law._replace(least_sound_speed=0.0)), rel=1e-14)
    assert sound_speed_squared(rho, heat, law._replace(least_sound_speed=0.0)) < 0.0


def test_a_deck_takes_a_part_and_keeps_the_warnings_of_a_repair(tmp_path):
    (tmp_path / "al.ses").write_text(text_of({301: fallen(), **{k: v for k, v in parts().items() if k != 301}}))
    deck = ('stop_time = "1 us"\n[[region]]\nname = "plate"\nmaterial = "al"\nfrom = "0 mm"\nto = "1 mm"\nzones = 10\n[material.al.eos]\n'
            'law = "table"\nfile = "al.ses"\nrho0 = "2700 kg/m^3"\n')
    (tmp_path / "deck.toml").write_text(deck + "repair = true\n")
    assert [("interpolated between their neighbours" in w) for w in read_deck(tmp_path / "deck.toml").warnings].count(True) == 1
    (tmp_path / "deck.toml").write_text(deck + "table = 303\n")
    found = read_deck(tmp_path / "deck.toml")
    assert not any("interpolated" in w for w in found.warnings)
    assert found.problem.materials["al"].eos.energy_table[5, 2] == pytest.approx(parts()[303][1][5, 2], rel=1e-12)
    for keys, message in (("table = 401\n", "401 is not a table of pressures"), ('repair = "yes"\n', "expected true or false"),
                          ('least_sound_speed = "-1 m/s"\n', "must not be less than 0")):
        (tmp_path / "deck.toml").write_text(deck + keys)
        with pytest.raises(DeckError, match=message):
            read_deck(tmp_path / "deck.toml")
