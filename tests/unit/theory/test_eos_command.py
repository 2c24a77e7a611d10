"""`hugoniot eos`: the words of its JSON, its files and pictures, and what it says to bad input."""

import csv
import json

import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app

WORDS = {"pressure", "density", "particle_velocity", "shock_velocity", "specific_internal_energy", "temperature", "sound_speed"}


def eos(*arguments):
    return CliRunner().invoke(build_app("eos"), ["eos", *arguments])


def answer(*arguments):
    result = eos(*arguments, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def test_hugoniot_state():
    found = answer("hugoniot", "copper", "--at", "pressure = 10 GPa")
    assert set(found) >= WORDS and found["pressure"] == 1e10
    assert found["shock_velocity"] == pytest.approx(3940.0 + 1.489 * found["particle_velocity"], rel=1e-10)
    many = answer("hugoniot", "copper", "aluminum", "--points", "5", "--up-to", "1 km/s")
    assert [len(m["pressure"]) for m in many["materials"]] == [5, 5]
    second = answer("hugoniot", "copper", "--after", "pressure = 10 GPa", "--at", "pressure = 20 GPa")
    direct = answer("hugoniot", "copper", "--at", "pressure = 20 GPa")
    assert second["temperature"] < direct["temperature"]


def test_match_gives_one_state_per_interface_in_time_order():
    found = answer("match", "copper", "pmma", "copper", "--velocity", "555 m/s", "--error", "velocity = 5 m/s")
    assert [s["interface"] for s in found["states"]] == ["copper/pmma", "pmma/copper"]
    assert all(set(s) >= WORDS for s in found["states"])
    assert found["states"][1]["pressure"] > found["states"][0]["pressure"]
    assert found["states"][0]["uncertainty"]["pressure"]["sigma"] > 0.0
    assert "GPa" in eos("match", "copper", "aluminum", "--velocity", "1 km/s").stdout


def test_error_bars_of_a_ring_up_are_those_of_its_own_states():
    """Each against the change of that state with the velocity of the flyer."""
    stack = ("match", "copper", "pmma", "copper", "--ring-up", "3", "--velocity")
    found = answer(*stack, "1000 m/s", "--error", "velocity = 10 m/s")["states"]
    slow, fast = (answer(*stack, speed)["states"] for speed in ("995 m/s", "1005 m/s"))
    assert len(found) == 5
    for state, low, high in zip(found, slow, fast):
        assert state["uncertainty"]["pressure"]["sigma"] == pytest.approx(high["pressure"] - low["pressure"], rel=1e-6)


def test_a_line_through_points_of_a_parabola_is_reported(tmp_path):
    """With noise of 10 m/s: s2 = 5e-5 s/m bends the curve by 80 m/s from the line at the ends, s2 = 0 not at all."""
    noise = 10.0 * np.random.default_rng(2).standard_normal(20)
    for s2 in (5e-5, 0.0):
        lines = [f"{u},{3940.0 + 1.5 * u + s2 * u * u + n}" for u, n in zip(np.linspace(200.0, 4000.0, 20), noise)]
        (tmp_path / "shots.csv").write_text("up (m/s),us (m/s)\n" + "\n".join(lines) + "\n", encoding="utf-8")
        assert any("not on a straight line" in word for word in answer("fit", str(tmp_path / "shots.csv"))["warnings"]) == (s2 > 0.0)


def test_an_isentrope_beyond_the_densities_of_the_data_is_reported():
    """The densities of the shock states of copper end at up = 2946 m/s."""
    end = answer("hugoniot", "copper", "--at", "particle_velocity = 2946 m/s")["density"]
    for to, beyond in (("100 GPa", False), ("600 GPa", True)):
        found = answer("isentrope", "copper", "--to", to)
        assert (max(found["density"]) > end) == beyond == any("extrapolated" in word for word in found["warnings"])


def test_a_riemann_problem_states_where_it_starts():
    """A pressure alone leaves the density at the reference: air at 1 MPa and 1.18 kg/m3 has T = 298.15 K (1 MPa)/(1 atm)."""
    found = answer("riemann", "air", "air", "--left", "pressure = 1 MPa")
    assert found["left_initial"]["temperature"] == pytest.approx(298.15 * 1e6 / 101325.0, rel=1e-9)
    assert "2942.5 K" in eos("riemann", "air", "air", "--left", "pressure = 1 MPa").stdout


def test_a_match_beyond_a_law_names_the_material_and_a_row_that_reaches_further():
    told = eos("match", "basalt", "basalt", "--velocity", "20 km/s")
    assert told.exit_code == 3
    assert "material 'basalt'" in told.output and "T029" in told.output
    # the row that is offered does answer, with half of the impact velocity, as a symmetric impact must
    found = answer("match", "T029", "T029", "--velocity", "20 km/s")
    assert found["states"][0]["particle_velocity"] == pytest.approx(10e3, rel=1e-9)


@pytest.mark.parametrize("degree", [1, 2])
def test_a_fit_is_a_table_for_a_deck(tmp_path, degree):
    """Points on a known curve come back as the law of a material, with Gamma 2 s - 1."""
    from hugoniot.problem.deck import read_deck_text

    s2 = 2e-5 if degree == 2 else 0.0
    lines = [f"{u / 1000},{(3940.0 + 1.5 * u + s2 * u * u) / 1000}" for u in range(200, 2100, 200)]
    (tmp_path / "shots.csv").write_text("up [km/s],us (km/s)\n" + "\n".join(lines) + "\n", encoding="utf-8")
    told = eos("fit", str(tmp_path / "shots.csv"), "--toml", "--density", "8.93 g/cm^3", *(["--quadratic"] if degree == 2 else []))
    assert told.exit_code == 0, told.output
    deck = 'stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "shots"\nfrom = 0\nto = 1\nzones = 2\n' + told.stdout
    law = read_deck_text(deck).problem.materials["shots"].eos
    wanted = (8930.0, 3940.0, 1.5, s2, 2.0) if degree == 2 else (8930.0, 3940.0, 1.5, 2.0)
    assert law[:len(wanted)] == pytest.approx(wanted, rel=1e-5)
    bare = eos("fit", str(tmp_path / "shots.csv"), "--toml")
    assert bare.exit_code == 2 and "add --density" in bare.output


def test_table_is_read_back_by_the_law_of_tables(tmp_path):
    from hugoniot.laws.eos import contract
    from hugoniot.materials.library import find
    from hugoniot.materials.tables_io import load

    out = tmp_path / "copper.csv"
    assert eos("table", "copper", "--points", "60", "--densities", "8.8 g/cm^3, 12 g/cm^3", "--csv", str(out)).exit_code == 0
    table, law = load(out, rho0=8930.0), find("copper").eos
    rho, e = 10100.0, 3.0e5
    assert contract.pressure(rho, e, table) == pytest.approx(contract.pressure(rho, e, law), rel=2e-3)


def test_waves_in_time():
    found = answer("match", "copper", "copper", "--velocity", "500 m/s", "--thickness", "1 mm", "--thickness", "3 mm", "--until", "0.3 us")
    first, rear = found["states"][:2]
    assert first["time"] == 0.0 and first["particle_velocity"] == pytest.approx(250.0)
    assert rear["interface"] == "free surface/copper" and rear["time"] == pytest.approx(1e-3 / (3940.0 + 1.489 * 250.0), rel=1e-9)


def test_cj_words():
    found = answer("cj", "comp_b")
    assert set(found) >= WORDS | {"detonation_velocity", "adiabatic_exponent"}
    assert (found["detonation_velocity"], found["pressure"]) == pytest.approx((7980.0, 29.5e9), rel=1e-3)


def test_gas_of_the_source_from_a_file(tmp_path):
    path = tmp_path / "gas.toml"
    path.write_text('[eos]\nlaw = "ideal_gas"\ngamma = 3.0\n', encoding="utf-8")
    found = answer("cj", str(path), "--density", "1.77 g/cm^3", "--heat", "6.27 MJ/kg")
    assert (found["detonation_velocity"], found["pressure"]) == pytest.approx((10015.987, 44.3916e9), rel=1e-6)


@pytest.mark.parametrize("burn", ["", '[burn]\nlaw = "programmed"\ndetonation_velocity = 8485.0\n'])
def test_a_stated_chemical_energy_counts_as_in_a_run(tmp_path, burn):
    """A gamma-law gas has D^2 = 2 (gamma^2 - 1) Q and p = rho0 D^2/(gamma + 1); a JWL set with the energy Q is that with e0 = rho0 Q."""
    path = tmp_path / "gas.toml"
    path.write_text('detonation_energy = 4.5e6\n[eos]\nlaw = "ideal_gas"\ngamma = 3.0\nrho0 = 1800.0\n' + burn, encoding="utf-8")
    found = answer("cj", str(path))
    assert found["detonation_velocity"] ** 2 == pytest.approx(2.0 * 8.0 * 4.5e6, rel=1e-9)
    assert found["pressure"] == pytest.approx(1800.0 * 2.0 * 8.0 * 4.5e6 / 4.0, rel=1e-9)
    assert answer("isentrope", str(path))["pressure"][0] == found["pressure"]
    assert answer("show", str(path))["pressure"] == pytest.approx(2.0 * 1800.0 * 4.5e6)
    refused = eos("cj", str(path), "--heat", "5 MJ/kg")
    assert refused.exit_code == 2 and "already has a chemical energy" in refused.output

    comp_b = "[eos]\nlaw = \"jwl\"\na = 524.2e9\nb = 7.678e9\nr1 = 4.2\nr2 = 1.1\nomega = 0.34\nrho0 = 1717.0\ne0 = "
    (tmp_path / "stated.toml").write_text(f"detonation_energy = 4e6\n{comp_b}8.5e9\n{burn}", encoding="utf-8")
    (tmp_path / "same.toml").write_text(f"{comp_b}{1717.0 * 4e6}\n", encoding="utf-8")
    for tool in ("cj", "isentrope"):
        stated, same = (answer(tool, str(tmp_path / name)) for name in ("stated.toml", "same.toml"))
        assert stated["pressure"] == pytest.approx(same["pressure"], rel=1e-9)


def test_other_commands_answer(tmp_path):
    shown = answer("show", "copper", "--at", "particle_velocity = 500 m/s")
    assert shown["law"] and shown["particle_velocity"] == 500.0 and shown["gruneisen"] > 0
    path = answer("isentrope", "copper", "--at", "pressure = 50 GPa", "--points", "6")
    assert path["pressure"][0] == 5e10 and path["pressure"][-1] == 0.0 and path["shock_velocity"] is None
    waves = answer("riemann", "copper", "water", "--left", "velocity = 500 m/s")
    assert waves["left"]["wave"] == waves["right"]["wave"] == "shock" and waves["pressure"] > 0
    fitted = answer("fit", "copper")
    assert fitted["points"] == 141 and fitted["s"] == pytest.approx(1.517, abs=1e-3)
    grid = answer("table", "copper", "--points", "3")
    assert len(grid["pressure"]) == 3 == len(grid["pressure"][0])
    out = tmp_path / "curve.csv"
    assert eos("hugoniot", "copper", "--points", "4", "--csv", str(out)).exit_code == 0
    rows = list(csv.reader(out.open()))
    assert rows[0][0] == "pressure (Pa)" and len(rows) == 5


@pytest.mark.parametrize("arguments", [
    ("hugoniot", "copper", "aluminum", "--at", "pressure = 20 GPa"), ("hugoniot", "copper", "--axes", "us-up"), ("isentrope", "copper", "--at", "pressure = 30 GPa"),
    ("match", "copper", "pmma", "--velocity", "500 m/s"), ("cj", "tnt"), ("fit", "copper"),
    ("match", "copper", "pmma", "--velocity", "500 m/s", "--thickness", "1 mm", "--thickness", "3 mm", "--until", "0.6 us"),
    ("show", "copper", "--at", "pressure = 60 GPa"), ("show", "tnt"), ("riemann", "copper", "water", "--left", "velocity = 500 m/s"),
    ("riemann", "air", "air", "--left", "velocity = -3 km/s"), ("table", "copper", "--points", "5"), ("second-shock", "copper"),
    ("hugoniot", "comp_b", "tnt", "--reaction", "--axes", "p-v")])
def test_pictures(tmp_path, arguments):
    out = tmp_path / "picture.png"
    result = eos(*arguments, "--plot", str(out))
    assert result.exit_code == 0, result.output
    assert out.stat().st_size > 10_000 and out.read_bytes()[1:4] == b"PNG"


def test_a_gas_is_released_to_its_pressure_at_rest_and_told_in_kpa():
    found = answer("isentrope", "air", "--at", "pressure = 1 MPa", "--points", "5")
    assert found["pressure"][0] == pytest.approx(1e6) and found["pressure"][-1] == pytest.approx(101325.0, rel=1e-4)
    told = eos("hugoniot", "air", "--points", "3").stdout
    assert "pressure, kPa" in told and "101.32" in told


def test_a_written_table_holds_the_material_at_rest(tmp_path):
    assert eos("table", "copper", "--csv", str(tmp_path / "copper.csv")).exit_code == 0
    (tmp_path / "read.toml").write_text('[eos]\nlaw = "table"\nfile = "copper.csv"\n')
    rest = answer("show", str(tmp_path / "read.toml"))
    assert min(rest["parameters"]["temperatures"]) < rest["temperature"] == pytest.approx(298.15)
    stretched = answer("isentrope", str(tmp_path / "read.toml"), "--to", "-5 GPa", "--points", "3")
    assert stretched["pressure"][-1] == pytest.approx(-5e9) and stretched["temperature"][-1] < 298.15


POROUS = """[eos]
law = "p_alpha"
alpha0 = 1.3
elastic_pressure = "0.1 GPa"
compaction_pressure = "1 GPa"
[eos.base]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5350 m/s"
s = 1.34
gamma0 = 2.0
"""


def test_crushed_pores_stay_crushed_in_a_release_and_the_law_of_the_solid_is_shown(tmp_path):
    (tmp_path / "foam.toml").write_text(POROUS)
    path = str(tmp_path / "foam.toml")
    found = answer("isentrope", path, "--at", "pressure = 0.5 GPa", "--points", "3")
    crushed = 1.0 + 0.3 * (0.5 / 0.9) ** 2     # alpha at 0.5 GPa
    assert found["pressure"][-1] == pytest.approx(0.0, abs=1.0) and found["density"][-1] == pytest.approx(2700.0 / crushed, rel=2e-3)
    shown = answer("show", path)
    assert shown["parameters"]["base"]["law"] == "mie_gruneisen" and shown["parameters"]["base"]["c0"] == 5350.0
    assert "equation of state of the solid" in eos("show", path).stdout


def test_an_answer_says_which_state_it_starts_from_and_of_what(tmp_path):
    assert "of the unreacted explosive at pressure" in eos("show", "comp_b", "--at", "pressure = 5 GPa").stdout
    assert "porous: 5000.00 kg/m3" in eos("hugoniot", "copper", "--density", "5 g/cm^3", "--at", "pressure = 20 GPa").stdout
    assert "from 10 GPa and 9498.50 kg/m3" in eos("hugoniot", "copper", "--after", "pressure = 10 GPa", "--at", "pressure = 20 GPa").stdout


def test_few_rows_make_no_polygon_of_the_picture():
    from hugoniot.cli.eos import hugoniot as tool

    for asked in (tool.Question(None, 3, "1 km/s", None, None, False, None, []), tool.Question(None, 3, None, None, None, True, None, [])):
        found = tool.solve("comp_b", asked)
        drawn = tool._drawn(found, False)
        assert len(found.states) == 3 and len(drawn) >= tool.SMOOTH
        assert drawn.pressure[-1] == pytest.approx(found.states.pressure[-1], rel=1e-9)


@pytest.mark.parametrize(("arguments", "code", "words"), [
    (("hugoniot", "copper", "--density", "9.5 g/cm^3"), 3, "exceeds the reference density of 8930 kg/m3"),
    (("isentrope", "copper", "--to", "-50 GPa"), 3, "pressure -5e+10 Pa is not reached"),
    (("match", "coper", "aluminum", "--velocity", "1 km/s"), 2, "copper"), (("hugoniot", "copper", "--at", "presure = 10 GPa"), 2, "did you mean 'pressure'"),
    (("hugoniot", "copper", "--at", "pressure = 10 km"), 2, "--at pressure"), (("hugoniot", "copper", "--at", "density = 40 g/cm^3"), 3, "ends at density"),
    (("match", "copper", "--velocity", "1 km/s"), 2, "at least one target"), (("match", "copper", "pmma", "--velocity", "-1 km/s"), 3, "does not strike"),
    (("cj", "copper"), 3, "no Chapman-Jouguet point"), (("hugoniot", "missing.toml"), 4, "cannot read missing.toml"), (("hugoniot", "copper", "--up-to", "0 m/s"), 3, "particle velocity of a Hugoniot must be positive"),
    (("match", "copper", "pmma", "--velocity", "1 km/s", "--error", "pmma.c9 = 1"), 2, "not an input of this match"),
    (("match", "copper", "pmma", "copper", "aluminum", "--velocity", "1 km/s", "--ring-up", "2"), 2, "aluminum would have no effect"),
    (("match", "copper", "pmma", "--velocity", "1 km/s", "--samples", "100"), 2, "no input is uncertain"),
    (("match", "copper", "pmma", "--velocity", "1 km/s", "--until", "1 us"), 2, "add --thickness"),
    (("match", "copper", "pmma", "--velocity", "1 km/s", "--thickness", "1 mm", "--thickness", "1 mm", "--error", "velocity = 5 m/s"), 2,
     "not supported with --thickness"),
    (("match", "copper", "basalt", "--velocity", "14 km/s"), 3, "rows T007, T029 and T038 of the library reach further"),
    (("match", "copper", "pmma", "--velocity", "1 km/s", "--thickness", "1 mm"), 2, "1 thickness for 2 layers"),
    (("cj", "comp_b", "--density", "-1 g/cm^3"), 3, "give a positive density"), (("table", "copper", "--densities", "8 g/cm^3, 90 g/cm^3"), 3, "is defined for densities"),
    (("hugoniot", "comp_b", "--reaction", "--after", "pressure = 1 GPa"), 2, "omit it"), (("second-shock", "--first", "-0.1"), 2, "must be positive"),
    (("second-shock", "--mu", "1.5"), 3, "compression limit"), (("fit-gamma", "water_like", "--at", "pressure = 1 GPa"), 2, "unknown material"),
    (("fit-gamma", "tnt", "--at", "pressure = 1 GPa"), 2, "unreacted"), (("match", "copper", "pmma", "--velocity", "1 kms"), 2, "did you mean"),
    (("fit", "copper", "--density", "8 g/cm^3"), 2, "has no effect without --toml"), (("fit", "copper", "--toml", "--json"), 2, "has no effect with --toml"),
    (("hugoniot", "copper", "--data", "shots.csv"), 2, "add --plot"),
    (("fit", "missing.csv"), 4, "cannot read missing.csv"), (("fit", "copper", "--from", "2.9 km/s", "--to", "2.92 km/s"), 2, "copper: points: a fit of degree 1"), (("hugoniot", "copper", "--plot", "x.doc"), 2, "not a picture file")])
def test_bad_input_is_answered_with_the_way_out(arguments, code, words):
    result = eos(*arguments)
    assert result.exit_code == code, result.output
    assert words in result.output and "Traceback" not in result.output


def test_a_file_with_a_mistake_is_told_with_its_line(tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text('[eos]\nlaw = "mie_gruneisen"\nrho0 = "8930 kg/m^3"\nc0 = "3940 m"\ns = 1.5\ngamma0 = 2.0\n', encoding="utf-8")
    result = eos("hugoniot", str(path))
    assert result.exit_code == 2 and "bad.toml:4" in result.output and "c0" in result.output


def test_an_extrapolation_is_told_once_with_both_numbers():
    from hugoniot.materials.library import find

    limit = find("copper").valid_up_to
    beyond = f"the data of copper end at up = {limit:.6g} m/s, but the shock has up = {limit + 500.0:.6g} m/s: extrapolated"
    ask = {"hugoniot": ("hugoniot", "copper", "--up-to", f"{limit + 500} m/s"),
           "state": ("hugoniot", "copper", "--at", f"particle_velocity = {limit + 500} m/s"),
           "isentrope": ("isentrope", "copper", "--at", f"particle_velocity = {limit + 500} m/s"),
           "show": ("show", "copper", "--at", f"particle_velocity = {limit + 500} m/s"),
           "match": ("match", "copper", "copper", "--velocity", f"{2 * limit + 1000} m/s"),
           "riemann": ("riemann", "copper", "copper", "--left", f"velocity = {2 * limit + 1000} m/s")}
    for name, arguments in ask.items():
        assert answer(*arguments)["warnings"].count(beyond) == 1, name
        result = eos(*arguments)
        assert result.stderr.count(beyond) == 1 and beyond not in result.stdout, name
    assert not any("extrapolated" in w for w in answer("match", "copper", "copper", "--velocity", "1 km/s")["warnings"])
    unknown = answer("match", "molybdenum", "copper", "--velocity", "1 km/s")["warnings"]
    assert sum("range of the data of molybdenum is not known" in w for w in unknown) == 1
    both = answer("hugoniot", "copper", "aluminum", "--up-to", f"{limit + 500} m/s")
    assert [any("extrapolated" in w for w in m["warnings"]) for m in both["materials"]][0]


def test_states_as_csv(tmp_path):
    out = tmp_path / "states.csv"
    for arguments, rows in ((("show", "copper", "--at", "pressure = 10 GPa"), 1), (("riemann", "copper", "water", "--left", "velocity = 500 m/s"), 2)):
        assert eos(*arguments, "--csv", str(out)).exit_code == 0
        found = list(csv.DictReader(out.open()))
        assert len(found) == rows and all(float(row["pressure (Pa)"]) > 1e9 for row in found)
    assert found[0]["pressure (Pa)"] == found[1]["pressure (Pa)"] and [r["material"] for r in found] == ["copper", "water"]


def test_second_shock_has_the_numbers_of_the_source():
    """W-3 and W-4: a = 0.73, b = 1.72, c = 1.60 Mbar, first shock to mu = 0.10."""
    found = answer("second-shock", "--mu", "0.15, 0.2, 0.25")
    assert found["second_pressure"] == pytest.approx([0.166002e11, 0.248564e11, 0.347520e11], rel=3e-6)
    assert found["difference"] == pytest.approx([-0.002407e11, -0.007150e11, -0.014980e11], rel=3e-4)
    assert (found["a"], found["c"], found["first_compression"]) == (0.73e11, 1.6, 0.1)
    # a material: the quadratic law of a linear Us-up fit, b = a (2 s - 1 - c/2)
    copper = answer("second-shock", "copper", "--mu", "0.001", "--first", "0.0005")
    assert copper["a"] == pytest.approx(8930.0 * 3940.0**2, rel=1e-12) and copper["c"] == pytest.approx(2.02, rel=1e-12)
    assert copper["b"] == pytest.approx(copper["a"] * (2.0 * 1.489 - 1.0 - 1.01), rel=1e-5)
    direct = answer("hugoniot", "copper", "--at", f"density = {copper['density'][0]!r}")
    assert copper["principal_pressure"][0] == pytest.approx(direct["pressure"], rel=1e-5)


def test_hugoniot_with_reaction_touches_its_rayleigh_line_at_cj(tmp_path):
    point = answer("cj", "comp_b")
    found = answer("hugoniot", "comp_b", "--reaction", "--points", "41")
    assert found["chapman_jouguet"]["pressure"] == pytest.approx(point["pressure"], rel=1e-12)
    # the front is slowest at the CJ point, and mass and momentum hold along the curve
    least = min(found["shock_velocity"])
    assert point["detonation_velocity"] <= least < 1.001 * point["detonation_velocity"]
    for p, u, d, rho in zip(*(found[k] for k in ("pressure", "particle_velocity", "shock_velocity", "density"))):
        assert p == pytest.approx(1717.0 * u * d, rel=1e-10) and rho == pytest.approx(1717.0 * d / (d - u), rel=1e-10)
    strong = answer("hugoniot", "comp_b", "--reaction", "--at", "shock_velocity = 8.5 km/s")
    assert strong["shock_velocity"] == pytest.approx(8500.0, rel=1e-10) and strong["pressure"] > point["pressure"]
    path = tmp_path / "gas.toml"
    path.write_text('[eos]\nlaw = "ideal_gas"\ngamma = 3.0\n', encoding="utf-8")
    gas = answer("hugoniot", str(path), "--heat", "6.27 MJ/kg", "--density", "1.77 g/cm^3", "--points", "5")
    assert gas["chapman_jouguet"]["pressure"] == pytest.approx(44.3916e9, rel=1e-6)
    porous = answer("hugoniot", "copper", "--density", "5 g/cm^3", "--at", "pressure = 20 GPa")
    assert porous["temperature"] > answer("hugoniot", "copper", "--at", "pressure = 20 GPa")["temperature"]


def test_fitted_points_as_csv(tmp_path):
    out = tmp_path / "fit.csv"
    assert eos("fit", "copper", "--csv", str(out)).exit_code == 0
    rows = list(csv.DictReader(out.open()))
    assert len(rows) == 141
    for row in rows[:5]:
        assert float(row["deviation (m/s)"]) == pytest.approx(float(row["shock_velocity (m/s)"]) - float(row["fitted_shock_velocity (m/s)"]))


def test_fits_of_jwl_and_of_gamma(tmp_path):
    import numpy as np

    volumes = np.geomspace(0.8, 7.0, 15)
    pressures = 524.229e9 * np.exp(-4.2 * volumes) + 7.678e9 * np.exp(-1.1 * volumes) + 1.082e9 * volumes**-1.34
    path = tmp_path / "cylinder.csv"
    path.write_text("V,pressure (GPa)\n" + "\n".join(f"{v},{p * 1e-9}" for v, p in zip(volumes, pressures)), encoding="utf-8")
    cj = ("--density", "1.717 g/cm^3", "--velocity", "7.98 km/s", "--pressure", "29.5 GPa", "--energy", "8.5 GJ/m^3")
    out = tmp_path / "fit.png"
    found = answer("fit-jwl", str(path), *cj, "--plot", str(out))
    assert (found["r1"], found["r2"], found["omega"]) == pytest.approx((4.2, 1.1, 0.34), rel=1e-3) and found["standard_deviation"] < 1e-4
    assert out.read_bytes()[1:4] == b"PNG"
    assert "more than rho0 D^2" in eos("fit-jwl", str(path), *cj[:-3], "200 GPa", *cj[-2:]).output
    path.write_text("volume,stress\n1,2\n", encoding="utf-8")
    result = eos("fit-jwl", str(path), *cj)
    assert result.exit_code == 2 and "cylinder.csv:1" in result.output and "pressure [GPa]" in result.output
    # Cu at 500 m/s: the adjusted law meets the jump, the truncated one does not
    gamma = answer("fit-gamma", "copper", "--at", "particle_velocity = 500 m/s")
    assert gamma["adjusted_pressure"] == pytest.approx(gamma["pressure"], rel=1e-12) != pytest.approx(gamma["truncated_pressure"], rel=1e-3)


def test_a_data_file_with_a_wrong_column_or_unit(tmp_path):
    path = tmp_path / "shots.csv"
    for text, place, words in (("speed,us\n1,2\n", "shots.csv:1", "up [km/s]"), ("up (GPa),us (km/s)\n1,4\n", "shots.csv:1", "expected a velocity"),
                               ("up,us\n100,4000\n200,abc\n", "shots.csv:3", "'abc' is not a velocity"), ("up,us\n100\n", "shots.csv:2", "1 value"), ("", "shots.csv", "empty")):
        path.write_text(text, encoding="utf-8")
        result = eos("fit", str(path))
        assert result.exit_code == 2 and place in result.output and words in result.output and len(result.output.splitlines()) == 1
    path.write_text("up,us\n0.1,4.0\n0.2,4.1\n0.5,4.7\n0.9,5.3\n", encoding="utf-8")
    assert "if they are in km/s" in eos("fit", str(path)).stderr
    path.write_text("up (KM/S), Us [km/s]\n0.1,4.0\n0.2,4.1\n0.5,4.7\n0.9,5.3\n", encoding="utf-8")
    assert answer("fit", str(path))["highest_particle_velocity"] == pytest.approx(900.0)
    assert "write a TOML file" in eos("show", str(path)).output


def test_error_bars_of_a_match_in_its_csv(tmp_path):
    out = tmp_path / "match.csv"
    found = answer("match", "copper", "pmma", "--velocity", "555 m/s", "--error", "velocity = 5 m/s", "--csv", str(out))
    row = next(csv.DictReader(out.open()))
    assert float(row["pressure_sigma (Pa)"]) == found["states"][0]["uncertainty"]["pressure"]["sigma"]


@pytest.mark.parametrize("words", [("show", "{}", "--at", "particle_velocity = 150 m/s"), ("lines", "{}", "--at", "particle_velocity = 150 m/s"),
                                   ("isentrope", "{}", "--at", "particle_velocity = 150 m/s"), ("hugoniot", "{}", "--at", "particle_velocity = 150 m/s"),
                                   ("match", "{}", "{}", "--velocity", "300 m/s"), ("riemann", "{}", "{}", "--left", "velocity = 300 m/s, pressure = 0 Pa")])
def test_every_command_reports_a_shock_that_splits(tmp_path, words):
    """Porous aluminium at 150 m/s: 361.85 MPa behind two waves, where a single jump would lead to 332.5 MPa."""
    path = tmp_path / "porous.toml"
    path.write_text('[material.por.eos]\nlaw = "p_alpha"\nalpha0 = 1.275\nelastic_pressure = "0.08 GPa"\ncompaction_pressure = "0.7 GPa"\n'
                    '[material.por.eos.base]\nlaw = "mie_gruneisen"\nrho0 = "2700 kg/m^3"\nc0 = "5350 m/s"\ns = 1.34\ngamma0 = 2.0\n')
    done = eos(*(word.format(path) for word in words))
    assert done.exit_code == 0 and "no single shock leads to up =" in done.stderr and "361.85 MPa" in done.stderr
