"""Decks of the solver `shock_structure` and the command `hugoniot structure`."""

import json
from pathlib import Path

import numpy as np
import pytest

import hugoniot
from hugoniot import simulate
from hugoniot.cli import main as front
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.problem.structure_start import profile_of

EXAMPLE = Path(__file__).parents[3] / "examples" / "argon-mach9.toml"
SMALL = {"solver.shock.mach": 2.0, "region.gas.zones": 60, "stop_time": "1 ns", "output.snapshots": "0.25 ns", "output.report": False}


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as ended:
        front.main(list(arguments))
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


def told(text):
    with pytest.raises(DeckError) as error:
        read_deck_text(text, "deck.toml")
    return str(error.value)


# -- decks -------------------------------------------------------------------------------------------------------------
def test_resolved_deck_reads_back_to_the_same_problem():
    deck = read_deck(EXAMPLE)
    again = read_deck_text(deck.resolved, EXAMPLE.name)
    assert again.problem == deck.problem and again.resolved == deck.resolved
    assert profile_of(deck.problem).ends.mach == pytest.approx(9.0, rel=1e-14)


def test_every_fault_of_a_deck_is_told_at_once():
    text = EXAMPLE.read_text()
    for old, new in (("mach = 9.0", "mach = 1.0"), ("prandtl = 0.6666666666666667", "prandtl = 0.0"), ('kind = "shock_structure"', 'kind = "shock_structure"\nthreads = 2')):
        assert old in text
        text = text.replace(old, new)
    message = told(text)
    for words in ("solver.shock.mach: must be greater than 1", "prandtl must be a positive number", "solver.threads: unknown key"):
        assert words in message


@pytest.mark.parametrize("old, new, words", [
    ('at = "0 um"', 'at = "5 um"', "lies outside the domain"),
    ("mach = 9.0", 'mach = 9.0\nparticle_velocity = "1 km/s"', "one measure of strength, not mach and particle_velocity"),
    ('law = "power_law", shear', 'law = "powerlaw", shear', "did you mean 'power_law'"),
    ("zones = 150", "zones = 150\nratio = 1.02", "this solver needs cells of equal width"),
    ("zones = 150", 'zones = 150\nprofile = {velocity = "1 m/s"}', "profile: unknown key"),
    ('specific_heat = "312.15 J/kg/K"', "specific_heat = nan", "temperature|specific_heat"),
    ('start = "step"', 'start = "jump"', "expected 'step' or 'steady'"),
])
def test_one_fault(old, new, words):
    text = EXAMPLE.read_text()
    assert old in text
    import re
    assert re.search(words, told(text.replace(old, new)))


@pytest.mark.parametrize("table", [
    '[material.argon.strength]\nlaw = "perfectly_plastic"\nshear_modulus = "1 GPa"\nyield_stress = "1 MPa"\n',
    '[material.argon.fracture]\nlaw = "spall_stress"\nstrength = "1 GPa"\n',
], ids=["strength", "fracture"])
def test_a_solids_laws_are_refused(table):
    family = table.split("]")[0].split(".")[-1]
    message = told(EXAMPLE.read_text().replace("[solver]\n", table + "\n[solver]\n", 1))
    assert f"material.argon.{family}: " in message and f"{family} has no effect in shock_structure" in message


def test_what_the_library_says_of_a_solid_is_left_out_with_a_warning():
    text = EXAMPLE.read_text()
    start, end = text.index("[material.argon.eos]"), text.index("[solver]")
    text = (text[:start] + text[end:]).replace('"argon"', '"copper, OFHC"').replace('density = "1.62 kg/m^3"\n', "")
    text = text.replace("mach = 9.0", "mach = 1.5")
    deck = read_deck_text(text.replace('{law = "power_law", shear_viscosity = "2.27e-5 Pa s", exponent = 0.81, reference_temperature = "300 K"}',
                                       '{law = "constant", shear_viscosity = "10 Pa s"}').replace("conduction = {", "# {"), "deck.toml")
    (material,) = deck.problem.materials.values()
    assert material.strength is None and any("ignores its strength" in warning for warning in deck.warnings)
    assert read_deck_text(deck.resolved, "deck.toml").problem.materials == deck.problem.materials


def test_domain_too_short_is_an_error_of_the_deck(tmp_path):
    with pytest.raises(DeckError, match="does not hold the shock.*end at .* m or more"):
        hugoniot.run(EXAMPLE, out=tmp_path / "run", **{"region.gas.to": "0.1 um"})


@pytest.mark.parametrize("old, new, words", [
    ('to = "1.2 um"', 'to = "0.1 um"', "does not hold the shock.*end at 3.004e-07 m or more"),
    ('frame = "standing"', 'frame = "moving"', "runs 1.742e-05 m until stop_time"),
    ("mach = 9.0", 'pressure = "1 Pa"', "law 'ideal_gas' has no such shock: a pressure of 1 Pa is below the 101137 Pa"),
])
def test_check_finds_a_shock_that_cannot_be(capsys, tmp_path, old, new, words):
    import re
    text = EXAMPLE.read_text()
    assert old in text
    (tmp_path / "deck.toml").write_text(text.replace(old, new))
    code, out, err = call(capsys, "check", str(tmp_path / "deck.toml"))
    assert code == 2 and re.search(words, err) and "sound" not in out


# -- run folders -----------------------------------------------------------------------------------------------------------
def test_run_folder_budget_and_profile(tmp_path):
    run = hugoniot.run(EXAMPLE, out=tmp_path / "run", **SMALL)
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["solver"] == "shock_structure" and summary["status"] == "done" and summary["time"] == 1e-9
    assert max(summary[f"{name}_error"] for name in ("mass", "momentum", "energy")) < 1e-12
    assert summary["density_thickness"] == pytest.approx(summary["cells_per_thickness"] * 3e-6 / 60, rel=1e-12)
    last = run.snapshots.isel(time=-1)
    profile = profile_of(read_deck(EXAMPLE, overrides=SMALL).problem)
    assert float(last["density"][0]) == pytest.approx(profile.ends.upstream.density, rel=1e-6)
    assert float(last["pressure"][-1]) == pytest.approx(profile.ends.downstream.pressure, rel=0.05)
    assert "deviator_radial" not in run.snapshots


def test_example_settles_to_the_steady_thickness(tmp_path):
    hugoniot.run(EXAMPLE, out=tmp_path / "run", **{"output.report": False})
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    steady = profile_of(read_deck(EXAMPLE).problem).thickness()
    assert summary["cells_per_thickness"] > 10.0
    assert summary["density_thickness"] == pytest.approx(steady, rel=1e-3)
    assert max(summary[f"{name}_error"] for name in ("mass", "momentum", "energy")) < 1e-12


def test_report_and_terminal_tell_the_thickness_its_definition_laws_and_sources(tmp_path, capsys):
    from hugoniot.cli.results import echo_results
    run = hugoniot.run(EXAMPLE, out=tmp_path / "run", **{**SMALL, "output.report": True})
    profile = profile_of(read_deck(EXAMPLE, overrides=SMALL).problem)
    assert run.summary["steady_density_thickness"] == pytest.approx(profile.thickness(), rel=1e-12)
    assert run.summary["entropy_viscous"] + run.summary["entropy_conductive"] == pytest.approx(run.summary["entropy_jump"], rel=1e-8)
    page = (tmp_path / "run" / "report.html").read_text()
    words = ("|ρ₂ − ρ₁| / max|dρ/dx|", f"{profile.thickness() * 1e6:.6g} µm".rstrip("0"), "shear viscosity: power_law", "2.27e-05 Pa s",
             "heat conduction: prandtl", "Prandtl number mu c_p / k", "Jordan 2011, chapters 2 and 6", "WENO-Z", "produced by conduction")
    assert [word for word in words if word not in page] == []
    assert page.count('class="picture') >= 5
    echo_results(run)
    out = capsys.readouterr().out
    words = ("density thickness |rho2 - rho1| / max|drho/dx|", "steady wave, Mach 2:", "10 to 90 % of density", "entropy gained",
             "shear viscosity: power_law (shear_viscosity 2.27e-05 Pa s, exponent 0.81, reference_temperature 300 K)", "heat conduction: prandtl",
             "bulk viscosity", "sources: ", "Jordan 2011")
    assert [word for word in words if word not in out] == [] and "voids" not in out


def test_a_shock_of_too_few_cells_is_told(tmp_path):
    run = hugoniot.run(EXAMPLE, out=tmp_path / "run", **{**SMALL, "solver.shock.mach": 9.0, "region.gas.zones": 40})
    assert run.summary["cells_per_thickness"] < 8.0
    told = [str(text) for kind, text in zip(run.arrays("events")["kind"], run.arrays("events")["text"]) if kind == "warning"]
    assert any("the thickness is the grid's" in text for text in told)


class _Stopper:
    """Interrupts a run after so many reports."""

    def __init__(self, count):
        self.left = count

    def update(self, report):
        self.left -= 1
        if self.left == 0:
            raise KeyboardInterrupt


def test_resume_is_bitwise(tmp_path):
    whole = hugoniot.run(EXAMPLE, out=tmp_path / "whole", **SMALL)
    with pytest.raises(KeyboardInterrupt):
        hugoniot.run(EXAMPLE, out=tmp_path / "cut", progress=_Stopper(2), **SMALL)
    cut = simulate.resume(tmp_path / "cut")
    for name in ("density", "velocity_left", "energy", "stress"):
        assert np.array_equal(whole.snapshots[name].values, cut.snapshots[name].values), name
    assert np.array_equal(whole.budget["energy_error"].values, cut.budget["energy_error"].values)
    a, b = (json.loads((tmp_path / name / "summary.json").read_text()) for name in ("whole", "cut"))
    assert a["cycles"] == b["cycles"]


# -- the command -------------------------------------------------------------------------------------------------------------
def test_profile_as_json(capsys):
    code, out, _ = call(capsys, "structure", "profile", "argon-jordan", "--mach", "9", "--json", "--points", "11")
    found = json.loads(out)
    assert code == 0 and found["density_thickness"] / found["mean_free_path_chapman_enskog"] == pytest.approx(3.1624, abs=6e-5)
    assert found["entropy_viscous"] + found["entropy_conductive"] == pytest.approx(738.31, rel=1e-4)
    assert len(found["profile"]["density"]) == 11


def test_a_gas_without_specific_heat_shows_no_temperature(capsys, tmp_path):
    (tmp_path / "gas.toml").write_text('[eos]\nlaw = "ideal_gas"\ngamma = 1.4\n')
    code, out, _ = call(capsys, "structure", "profile", str(tmp_path / "gas.toml"), "--mach", "2", "--viscosity", "2e-5 Pa s")
    assert code == 0 and "density thickness" in out and "nan" not in out and "temperature" not in out


def test_profile_of_a_deck_is_that_of_its_case(capsys):
    _, deck, _ = call(capsys, "structure", "profile", str(EXAMPLE), "--json")
    _, case, _ = call(capsys, "structure", "profile", "argon-jordan", "--mach", "9", "--json")
    deck, case = json.loads(deck), json.loads(case)
    assert deck["density_thickness"] == pytest.approx(case["density_thickness"], rel=1e-9)


def test_profile_of_a_library_material_with_csv_and_picture(capsys, tmp_path):
    code, out, _ = call(capsys, "structure", "profile", "copper", "--viscosity", "5 Pa s", "--particle-velocity", "500 m/s",
                        "--csv", str(tmp_path / "p.csv"), "--plot", str(tmp_path / "p.png"))
    assert code == 0 and "density thickness" in out
    table = np.genfromtxt(tmp_path / "p.csv", delimiter=",", names=True)
    assert np.all(np.diff(table["density"]) > 0.0) and (tmp_path / "p.png").stat().st_size > 10000


def test_fields_of_a_profile_hold_entropy_and_its_production(capsys):
    _, out, _ = call(capsys, "structure", "profile", "argon-jordan", "--mach", "3.38", "--json", "--points", "4001")
    found = json.loads(out)
    fields = {name: np.array(values) for name, values in found["profile"].items()}
    flux = fields["density"][0] * fields["velocity"][0]
    for kind in ("viscous", "conductive"):
        assert np.trapezoid(fields[f"entropy_production_{kind}"], fields["x"]) / flux == pytest.approx(found[f"entropy_{kind}"], rel=1e-4)
    assert fields["entropy"][-1] == pytest.approx(found["entropy_jump"], rel=1e-3)
    assert fields["entropy"].max() > 1.05 * found["entropy_jump"]   # conduction carries it ahead: more inside than behind


def test_bent_gruneisen_parameter_is_an_option(capsys):
    for name, nm in (("water_387", 3.574), ("water_858", 1.646)):
        _, out, _ = call(capsys, "structure", "profile", name, "--bent", "--json", "--points", "2")
        assert json.loads(out)["density_thickness"] * 1e9 == pytest.approx(nm, abs=5e-4)
    code, _, err = call(capsys, "structure", "profile", "argon-jordan", "--mach", "2", "--bent")
    assert code == 2 and "no adjusted Gr" in err


def test_profile_tells_definitions_laws_and_sources(capsys):
    _, out, _ = call(capsys, "structure", "profile", "argon-jordan", "--mach", "9")
    for words in ("|rho2 - rho1| / max|drho/dx|", "bsl: mean free path ahead, 3 mu / (rho cbar)", "equation of state: ideal_gas",
                  "shear viscosity: power_law (shear_viscosity 2.27e-05 Pa s", "heat conduction: prandtl (prandtl 0.666667)", "sources: "):
        assert words in out


def test_sweep_finds_the_thinnest(capsys, tmp_path):
    code, out, _ = call(capsys, "structure", "sweep", "argon-jordan", "--viscosity", "power_law", "--from", "3.8", "--to", "4.3", "--points", "11",
                        "--json", "--plot", str(tmp_path / "s.png"))
    rows = json.loads(out)
    best = max(rows, key=lambda row: row["reciprocal_thickness"])
    assert code == 0 and best["mach"] == pytest.approx(4.03, abs=0.05)
    assert 1.0 / best["reciprocal_thickness"] == pytest.approx(2.4964, abs=2e-4)
    assert (tmp_path / "s.png").stat().st_size > 5000


def test_tables_of_jordan(capsys):
    code, out, _ = call(capsys, "structure", "jordan")
    assert code == 0 and "6.2.1.1" in out and "water_387" in out and "3.1624" in out


@pytest.mark.parametrize("what, options, more", [
    ("argon-jordan", ("--bulk-ratio", "1"), (7.0 / 3.0) / (4.0 / 3.0)),
    ("argon-jordan", ("--conduction", "1e-6 W/m/K"), None),
    ("water_387", ("--bulk-ratio", "3"), 3.25),
    ("water_387", ("--prandtl", "7.01"), None),
    ("water_387", ("--density", "1010 kg/m^3", "--temperature", "300 K"), None),
    (str(EXAMPLE), ("--bulk-ratio", "1"), (7.0 / 3.0) / (4.0 / 3.0)),
    (str(EXAMPLE), ("--prandtl", "0.3"), None),
])
def test_no_option_is_dropped(capsys, what, options, more):
    """Every transport and state option changes the wave of every kind of subject; without conduction the thickness goes with 4/3 mu + zeta."""
    free = ("--conduction", '{law = "none"}') if more else ()
    strength = ("--mach", "2") if what == "argon-jordan" else ()
    lengths = []
    for given in (free, (*free, *options)):
        code, out, _ = call(capsys, "structure", "profile", what, *strength, *given, "--json", "--points", "2")
        assert code == 0
        lengths.append(json.loads(out)["density_thickness"])
    assert abs(lengths[1] / lengths[0] - 1.0) > 1e-4
    if more:
        assert lengths[1] / lengths[0] == pytest.approx(more, rel=1e-6)


@pytest.mark.parametrize("arguments, words, code", [
    (("argon-jordan", "--mach", "1"), "Mach 1 is not a shock", 3),
    (("argon-jordan", "--mach", "2", "--prandtl", "0"), "prandtl must be a positive number", 3),
    (("argon-jordan", "--mach", "2", "--viscosity", "honey"), "argon-jordan supports constant", 2),
    (("argon-jordan",), "give --mach", 2),
    (("argon-jordan", "--mach", "-2"), "Mach -2 is not a shock", 3),
    (("argon-jordan", "--mach", "nan"), "Mach nan is not a shock", 3),
    (("coppper", "--mach", "1.2"), "copper", 2),
    (("water_858", "--particle-velocity", "0 m/s"), "has no such shock", 3),
    (("water_858", "--bent", "--viscosity", "1 mPa s", "--prandtl", "7"), "has no such shock with heat conduction", 3),
    (("copper", "--mach", "1.2"), "--viscosity", 2),
    (("copper", "--mach", "1.2", "--viscosity", "5 mm"), "viscosity", 2),
    (("copper", "--mach", "1.2", "--viscosity", '{law = "constan", shear_viscosity = 1.0}'), "did you mean 'constant'", 2),
    (("silica_770", "--particle-velocity", "1800 m/s"), "law 'mie_gruneisen' has no such shock", 3),
])
def test_bad_input(capsys, arguments, words, code):
    found, out, err = call(capsys, "structure", "profile", *arguments)
    assert found == code and words in err and "Traceback" not in err


# -- the picture -------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name, rises", [("argon", True), ("water_387", False)])
def test_energies_of_the_picture(name, rises):
    """Jordan figures 6.6 and 7.1.6: total energy per volume rises through a shock of argon and falls in water, where kinetic energy stays the most."""
    from hugoniot.plotting.structure import profile_picture
    from hugoniot.theory.structure import jordan, steady
    if name == "argon":
        law, ahead = jordan.argon()
        profile = steady(law, jordan.argon_transport(), ahead, mach=3.38)
    else:
        case = jordan.CONDENSED[name]
        profile = steady(case.eos(), case.transport(), particle_velocity=case.particle_velocity)
    panels = {ax.get_ylabel(): {line.get_label(): line.get_ydata() for line in ax.get_lines()} for ax in profile_picture(profile).figure.axes}
    curves = panels["energy density / ρ₁c₁²"]
    assert np.allclose(curves["total"], curves["kinetic"] + curves["internal"])
    one = profile.ends.upstream
    assert curves["kinetic"][0] == pytest.approx(0.5 * (one.velocity / one.sound_speed) ** 2, rel=1e-3)
    assert (curves["total"][-1] > curves["total"][0]) == rises
    assert (curves["kinetic"][-1] > curves["internal"][-1]) == (not rises)
    for words in ("stress and heat flux", "momentum terms × δ / ρ₁c₁²", "energy terms × δ / ρ₁c₁³", "entropy; production × δ / jΔs"):
        assert words in panels


SECOND = '[[region]]\nname = "behind"\nmaterial = "argon"\nfrom = "1.2 um"\nto = "1.4 um"\nzones = 10\n'


@pytest.mark.parametrize("state, frame, words", [
    ('density = "5 kg/m^3"', "standing", "region.behind.density: has no effect"),
    ('velocity = "1 km/s"', "moving", "region.behind.velocity: has no effect"),
    ('velocity = "1 km/s"', "standing", "region.behind.velocity: has no effect"),
])
def test_states_that_the_shock_replaces_are_refused(state, frame, words):
    text = EXAMPLE.read_text().replace('frame = "standing"', f'frame = "{frame}"').replace("[material", f"{SECOND}{state}\n\n[material", 1)
    assert words in told(text)
    read_deck_text(text.replace(state, 'density = "1.62 kg/m^3"'))


def test_a_velocity_of_the_material_ahead_needs_a_moving_shock():
    text = EXAMPLE.read_text().replace("zones = 150", 'zones = 150\nvelocity = "500 m/s"')
    assert "region.gas.velocity: has no effect" in told(text)
    read_deck_text(text.replace('frame = "standing"', 'frame = "moving"'))


def test_no_thickness_without_a_shock():
    """Between the ends of a shock tube lie three waves: the difference of their densities is the jump of none."""
    text = EXAMPLE.read_text()
    start, end = text.index("[solver.shock]"), text.index("[output]")
    text = (text[:start] + text[end:]).replace("[material", f'{SECOND}density = "0.2 kg/m^3"\n\n[material', 1)
    assert "density_thickness" not in simulate.make_solver(read_deck_text(text).problem).results()


def test_only_gases_have_a_mean_free_path(capsys):
    """Water at 1 GPa has a pressure, but rho c^2 / p = 2.6; in argon it is 5/3."""
    for what, known in (("water", False), ("argon", True)):
        more = ["--pressure", "1 GPa"] if what == "water" else []
        code, out, _ = call(capsys, "structure", "profile", what, "--viscosity", "1 mPa s", "--mach", "1.5", "--json", *more)
        assert code == 0 and ("mean_free_path_bsl" in json.loads(out)) is known
