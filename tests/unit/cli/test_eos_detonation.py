"""`hugoniot eos cj`, `znd` and `mixture`: their words, numbers, files, pictures, and what they say to bad input."""

import csv
import json

import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.materials import library

GAS = '[eos]\nlaw = "ideal_gas"\ngamma = 1.2\nspecific_heat = 5.0\n[burn]\nlaw = "arrhenius"\nfrequency = 231.16\nactivation_temperature = 50\n'
LX17 = ("lx_17", "--shocked", "pressure = 20 GPa")


def eos(*arguments):
    return CliRunner().invoke(build_app("eos"), ["eos", *arguments])


def answer(*arguments):
    result = eos(*arguments, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def test_one_step_detonation_of_the_textbooks(tmp_path):
    """B23: gamma = 1.2, Q = E = 50, f = 1.6; the rate constant makes the half-reaction length one."""
    path = tmp_path / "gas.toml"
    path.write_text(GAS, encoding="utf-8")
    ask = (str(path), "--heat", "50 J/kg", "--ahead", "density = 1 kg/m^3, pressure = 1 Pa")
    found = answer("znd", *ask, "--overdrive", "1.6")
    assert found["detonation_velocity"] == pytest.approx(8.61337980, abs=1e-8) and found["chapman_jouguet_velocity"] == pytest.approx(6.80947463, abs=1e-8)
    assert found["von_neumann"]["pressure"] == pytest.approx(67.354829, abs=1e-6)
    assert found["half_reaction_length"] == pytest.approx(1.0, abs=3e-5) and found["closure"] is None
    assert answer("cj", *ask)["detonation_velocity"] == pytest.approx(6.80947463, abs=1e-8)
    other = answer("znd", *ask, "--overdrive", "1.6", "--rate", "arrhenius: frequency = 462.32 1/s, activation_temperature = 50 K")
    assert other["half_reaction_length"] == pytest.approx(0.5 * found["half_reaction_length"], rel=1e-9)


def test_zone_of_an_explosive_of_the_library(tmp_path):
    out = tmp_path / "zone.csv"
    found = answer("znd", "lx_17", "--points", "20", "--csv", str(out))
    assert {"pressure", "density", "particle_velocity", "specific_internal_energy", "temperature", "sound_speed", "position", "time"} <= set(found)
    assert found["closure"] == "thermal_isolation" and any("lx_17 reactive" in w for w in found["warnings"])
    assert found["position"][0] == 0.0 and np.all(np.diff(found["position"]) > 0.0) and found["pressure"][0] == pytest.approx(found["von_neumann"]["pressure"])
    assert found["reaction_zone_length"] == found["position"][-1] > 5.0 * found["half_reaction_length"] > 0.0
    assert len(list(csv.reader(out.open()))) == 21
    both = answer("znd", "lx_17", "c4", "--points", "9", "--closure", "weighted_pressures")
    assert [m["closure"] for m in both["materials"]] == ["weighted_pressures"] * 2


def test_a_zone_tells_the_chemical_energy_it_counts():
    found = answer("znd", "lx_17", "--points", "20")
    inside = found["specific_internal_energy"][0] - found["von_neumann"]["specific_internal_energy"]
    assert found["detonation_energy"] == pytest.approx(inside, rel=1e-9)
    assert "included in the internal energy" in eos("znd", "lx_17", "--points", "20").stdout


def test_states_of_a_mixture_in_both_closures():
    isolation, equilibrium = answer("mixture", *LX17, "--burn-fraction", "0, 0.5, 1")["materials"]
    assert (isolation["closure"], equilibrium["closure"]) == ("thermal_isolation", "thermal_equilibrium")
    keys = {"pressure", "density", "specific_internal_energy", "temperature", "sound_speed", "gruneisen", "adiabatic_exponent", "specific_heat",
            "burn_fraction", "pressure_by_volume", "pressure_by_energy", "pressure_by_burn_fraction", "product_density"}
    assert keys <= set(isolation) and isolation["burn_fraction"] == [0.0, 0.5, 1.0]
    assert isolation["pressure"][0] == pytest.approx(20e9, rel=1e-9) == pytest.approx(equilibrium["pressure"][0], rel=1e-9)
    assert isolation["pressure"][2] == pytest.approx(equilibrium["pressure"][2], rel=1e-9)
    # a state by density and energy above that at rest is the same one
    rho, e = isolation["density"][0], isolation["specific_internal_energy"][0] - isolation["energy_at_rest"]
    again = answer("mixture", *LX17, "--at", f"density = {rho!r}, energy = {e!r}", "--burn-fraction", "0.5", "--closure", "thermal_isolation")
    assert again["pressure"] == [pytest.approx(isolation["pressure"][1], rel=1e-12)]


def test_an_energy_counts_from_the_unreacted_explosive_at_rest(tmp_path):
    """A stiffened gas at rest holds gamma P / ((gamma - 1) rho0) = 0.350 MJ/kg: energy = 0 is no pressure all the same."""
    path = tmp_path / "liquid.toml"
    path.write_text('detonation_energy = "5 MJ/kg"\n[eos]\nlaw = "jwl"\na = "5e11 Pa"\nb = "5e9 Pa"\nr1 = 4.2\nr2 = 1.0\n'
                    'omega = 0.3\nrho0 = 1100.0\ne0 = "6e9 J/m^3"\n[unreacted]\nlaw = "stiffened_gas"\ngamma = 2.85\np_infinity = "2.5e8 Pa"\n'
                    'rho0 = 1100.0\nspecific_heat = 1500.0\n', encoding="utf-8")
    ask = ("mixture", str(path), "--burn-fraction", "0", "--closure", "weighted_pressures", "--at")
    at_rest = answer(*ask, "density = 1100 kg/m^3, energy = 0 J/kg")
    assert at_rest["pressure"][0] == pytest.approx(0.0, abs=1.0)
    warm = answer(*ask, "density = 1100 kg/m^3, energy = 0.1 MJ/kg")
    assert warm["pressure"][0] == pytest.approx(1.85 * 1100.0 * 1e5, rel=1e-9)     # (gamma - 1) rho e


@pytest.mark.parametrize("closure", ["thermal_isolation", "thermal_equilibrium", "weighted_pressures"])
def test_a_state_of_a_mixture_may_be_given_by_its_pressure_or_temperature(closure):
    ask = ("mixture", *LX17, "--closure", closure, "--burn-fraction", "0, 0.3, 1")
    for word, value, unit in (("pressure", 25.0, "GPa"), ("temperature", 2500.0, "K")):
        found = answer(*ask, "--at", f"density = 2.4 g/cm^3, {word} = {value} {unit}")
        assert found[word] == pytest.approx([value * (1e9 if unit == "GPa" else 1.0)] * 3, rel=1e-9)
        assert found["density"] == pytest.approx([2400.0] * 3) and len(set(found["specific_internal_energy"])) == 3


def test_adiabats_hugoniots_and_series_of_a_mixture(tmp_path):
    way = answer("mixture", *LX17, "--adiabat", "1.2 g/cm^3", "--burn-to", "1", "--closure", "thermal_isolation", "--points", "161")
    v, p, e = 1.0 / np.array(way["density"]), np.array(way["pressure"]), np.array(way["specific_internal_energy"])
    assert way["burn_fraction"][0] == 0.0 and way["burn_fraction"][-1] == pytest.approx(1.0)
    assert np.diff(e) == pytest.approx(-0.5 * (p[1:] + p[:-1]) * np.diff(v), rel=5e-3)
    shocks = answer("mixture", "lx_17", "--at", "density = 1.9 g/cm^3, energy = 0.5 MJ/kg", "--burn-fraction", "0.3", "--hugoniot", "40 GPa", "--points", "5")
    for one in shocks["materials"]:
        p, u, d = (np.array(one[k]) for k in ("pressure", "particle_velocity", "shock_velocity"))
        assert p[1:] - p[0] == pytest.approx(1900.0 * u[1:] * d[1:], rel=1e-11)
    out = tmp_path / "series.csv"
    series = answer("mixture", *LX17, "--series", "--csv", str(out))
    assert len(list(csv.reader(out.open()))) == 4
    state = answer("mixture", *LX17, "--burn-fraction", "1e-4", "--closure", "thermal_isolation")
    assert 1.0 / state["reactant_density"][0] == pytest.approx(series["reactant_volume"][0] + 1e-4 * series["reactant_volume"][1], rel=1e-7)


@pytest.mark.parametrize("arguments", [("znd", "comp_b", "lx_17"), ("mixture", *LX17), ("mixture", *LX17, "--burn-fraction", "0.5", "--adiabat", "1.2 g/cm^3"),
                                       ("mixture", *LX17, "--burn-fraction", "0.4", "--hugoniot", "60 GPa")])
def test_pictures(tmp_path, arguments):
    out = tmp_path / "picture.png"
    result = eos(*arguments, "--plot", str(out))
    assert result.exit_code == 0, result.output
    assert out.read_bytes()[1:4] == b"PNG" and out.stat().st_size > 10_000


@pytest.mark.parametrize(("arguments", "code", "words"), [
    (("znd", "tnt"), 2, "tnt: has a programmed burn only, and the library has no rate for it; sets"), (("znd", "copper"), 2, "no rate"), (("znd", "lx17x"), 2, "nearest"), (("znd", "lx_17", "--closure", "thermal_isolaton"), 2, "did you mean"),
    (("znd", "lx_17", "--velocity", "7 km/s"), 3, "slower than the Chapman-Jouguet"), (("znd", "lx_17", "--velocity", "7 km"), 2, "expected a velocity"),
    (("znd", "lx_17", "--rate", "arhenius: frequency = 1"), 2, "did you mean 'arrhenius'"), (("znd", "lx_17", "--rate", "arrhenius: frequency"), 2, "gives no parameter"),
    (("znd", "lx_17", "--rate", "arrhenius: frequency = 1e6 1/s"), 2, "activation_temperature: missing"),
    (("znd", "lx_17", "--complete", "1"), 3, "(complete) between 0 and 1"), (("znd", "lx_17", "--heat", "1 MJ/kg", "--closure", "thermal_isolation"), 2, "omit one"),
    (("znd", "copper", "--heat", "1 MJ/kg"), 2, "has no burn law"), (("mixture", "lx_17"), 2, "no state is given"), (("mixture", "copper", "--shocked", "pressure = 1 GPa"), 2, "unreacted"),
    (("mixture", *LX17, "--burn-fraction", "1.5"), 2, "not a mass fraction"), (("mixture", *LX17, "--at", "density = 2 g/cm^3"), 2, "density of the mixture and its energy, pressure or temperature"),
    (("mixture", *LX17, "--at", "energy = 2 MJ/kg, pressure = 9 GPa"), 2, "density = 2.4 g/cm^3, pressure = 20 GPa"),
    (("mixture", *LX17, "--series", "--plot", "x.png"), 2, "table of coefficients"),
    (("mixture", *LX17, "--closure", "burned_products"), 3, "no reactants"), (("mixture", *LX17, "--series", "--hugoniot", "9 GPa"), 2, "cannot be combined"),
    (("mixture", *LX17, "--hugoniot", "9 GPa"), 2, "give a higher pressure"), (("mixture", "lx_17", "--shocked", "pressure = -20 GPa"), 3, "pressure"),
    (("mixture", "lx_17", "--at", "density = 90 g/cm^3, energy = 3 MJ/kg"), 3, "mixture"), (("cj", "comp_b", "--ahead", "density = 1 kg"), 2, "--ahead density")])
def test_bad_input_is_answered_with_the_way_out(arguments, code, words):
    result = eos(*arguments)
    assert result.exit_code == code, result.output
    assert words in result.output and "Traceback" not in result.output and "defect" not in result.output


def test_a_closure_without_an_answer_is_a_note_and_none_at_all_an_error(tmp_path):
    """A solid without specific heat has no thermal equilibrium; isolation answers, and where it cannot its own reason is told."""
    path = tmp_path / "he.toml"
    path.write_text('[eos]\nlaw = "jwl"\na = "609.77 GPa"\nb = "12.95 GPa"\nr1 = 4.5\nr2 = 1.4\nomega = 0.25\nrho0 = 1601.0\ne0 = "9 GJ/m^3"\n'
                    '[unreacted]\nlaw = "mie_gruneisen"\nrho0 = 1601.0\nc0 = "2.3 km/s"\ns = 1.9\ngamma0 = 1.0\n', encoding="utf-8")
    found = answer("mixture", str(path), "--shocked", "pressure = 10 GPa")
    assert found["closure"] == "thermal_isolation" and any("thermal_equilibrium needs the temperature" in w for w in found["warnings"])
    result = eos("mixture", str(path), "--shocked", "pressure = 10 GPa", "--adiabat", "0.01 g/cm^3", "--burn-to", "1")
    assert result.exit_code == 3 and "the adiabat" in result.output
    detonation = answer("cj", str(path))
    zone = answer("znd", str(path), "--rate", "pressure_power: rate_constant = 1e6 1/s, pressure_exponent = 1.5, depletion_exponent = 0.5", "--points", "9")
    assert zone["detonation_velocity"] == pytest.approx(detonation["detonation_velocity"], rel=1e-9)


def test_whose_temperature_a_mixture_in_isolation_has_is_stated():
    """LX-17 at 20 GPa, a quarter burned: 1446 K are the products', (e - e_c)/c_v by hand."""
    told = eos("mixture", *LX17, "--burn-fraction", "0.25").output
    assert "in thermal isolation, the temperature is that of the products" in told
    assert "isolation, the temp" not in eos("mixture", *LX17, "--closure", "thermal_equilibrium").output
    found = answer("mixture", *LX17, "--burn-fraction", "0.25", "--closure", "thermal_isolation")
    found = found["materials"][0] if "materials" in found else found
    par = library.find("lx_17").eos
    v = par.rho0 / found["product_density"][0]
    cold = (par.a / par.r1 * np.exp(-par.r1 * v) + par.b / par.r2 * np.exp(-par.r2 * v)) / par.rho0
    assert found["temperature"][0] == pytest.approx((found["product_energy"][0] - cold) / par.specific_heat, rel=1e-9)
    assert any("is that of the products" in note for note in found["warnings"])
    assert any("is that of the products" in note for note in answer("znd", "lx_17")["warnings"])


def test_which_explosive_an_answer_is_about_is_stated():
    """The unreacted one in a Hugoniot; the products in a Riemann problem, with the state they start in: 11.88 GPa at constant volume."""
    assert eos("hugoniot", "comp_b", "--at", "pressure = 10 GPa").output.startswith("Composition B (unreacted)")
    par = library.find("comp_b").eos
    a, b = par.a * (1.0 - par.omega / par.r1) * np.exp(-par.r1), par.b * (1.0 - par.omega / par.r2) * np.exp(-par.r2)
    told = eos("riemann", "comp_b", "copper").output
    assert f"comp_b stands for its detonation products, which start at {(a + b + par.omega * par.e0) / 1e9:.5g} GPa and 1717 kg/m3" in told
