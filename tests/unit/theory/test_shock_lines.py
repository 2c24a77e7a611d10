"""Rayleigh and Fanno lines meet in the two states of the shock, in solids and gases; Gurney's command answers as the equation."""

import json

import numpy as np
import pytest

from hugoniot.cli import main as front
from hugoniot.dossier.gurney import derived_velocity
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials import library
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.shock_lines import shock_lines

GAS = IdealGas(1.4, 717.5, 1.2)


@pytest.mark.parametrize("material, ahead, strength", [
    (MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 385.0), None, {"particle_velocity": 1000.0}),
    (GAS, Initial(1.2, 1e5, 1e5 / (0.4 * 1.2)), {"particle_velocity": 600.0}),
])
def test_the_lines_and_the_hugoniot_meet_in_both_states_and_nowhere_else(material, ahead, strength):
    found = shock_lines(material, ahead, points=101, **strength)
    end = int(np.argmin(np.abs(found.density - float(found.behind.density))))
    scale = float(found.behind.pressure)
    for k in (0, end):
        assert found.fanno_pressure[k] == pytest.approx(found.rayleigh_pressure[k], abs=1e-9 * scale)
        assert found.hugoniot_pressure[k] == pytest.approx(found.rayleigh_pressure[k], abs=1e-9 * scale)
    inside = slice(1, end)
    assert np.all(found.rayleigh_pressure[inside] > found.hugoniot_pressure[inside])
    gap = (found.fanno_pressure - found.rayleigh_pressure)[inside]
    assert np.all(gap > 0.0) or np.all(gap < 0.0)


def test_fannos_entropy_is_largest_where_the_flow_is_sonic():
    ahead = Initial(1.2, 1e5, 1e5 / (0.4 * 1.2))
    found = shock_lines(GAS, ahead, points=2001, particle_velocity=600.0)
    entropy = np.log(found.fanno_pressure * found.density**-1.4)
    top = int(np.argmax(entropy))
    flow = 1.2 * float(found.behind.shock_velocity) / found.density[top]
    assert flow == pytest.approx(np.sqrt(1.4 * found.fanno_pressure[top] / found.density[top]), rel=2e-3)


def answer(capsys, *words):
    with pytest.raises(SystemExit) as done:
        front.main(list(words))
    return done.value.code, capsys.readouterr().out


def test_gurney_answers_for_every_explosive_of_the_library(capsys):
    code, out = answer(capsys, "eos", "gurney", "--tamper", "0.5", "--json")
    rows = {r["explosive"]: r for r in json.loads(out)}
    assert not code and all(1900.0 < r["gurney_velocity"] < 3200.0 and r["source"] for r in rows.values())
    assert {"Cyclotol", "TNT", "Composition C-4"} < set(rows) and len(rows) == 21
    assert [name for name in ("TNT", "HMX") if rows[name]["derived"]] == ["TNT"]
    assert rows["TNT"]["asymmetric"] > rows["TNT"]["open"] and "not checked against" in rows["Pentolite 50/50"]["marks"][0]
    code, out = answer(capsys, "eos", "gurney", "--velocity", "2.7 km/s", "--json")
    one = json.loads(out)[0]
    assert [one[k] for k in ("open", "symmetric", "cylinder", "sphere")] == pytest.approx([1478.9, 2338.3, 2204.5, 2134.5], abs=0.1)
    code, _ = answer(capsys, "eos", "gurney", "copper")
    assert code == 2


def test_derived_gurney_velocities_are_the_energy_of_the_isentrope_and_near_the_table():
    """The energy by the closed form of JWL's isentrope through the CJ point; the distance from the table as the help has it."""
    deviations = []
    for name in ("comp_b", "petn", "hmx", "rdx", "pbx_9404", "pbx_9502", "lx_14", "octol", "tetryl"):
        entry = library.entry(name)
        par, point = entry.material.eos, cj(entry.material.eos)
        v = par.rho0 / point.state.density
        sums = {n: [a * np.exp(-r * x) / d for x, d in ((v, 1.0), (4.0, r))] for n, a, r in (("a", par.a, par.r1), ("b", par.b, par.r2))}
        c = (point.state.pressure - sums["a"][0] - sums["b"][0]) * v ** (1.0 + par.omega)
        left = sums["a"][1] + sums["b"][1] + c * 4.0**-par.omega / par.omega
        speed = np.sqrt(2.0 * (par.e0 - left) / par.rho0)
        assert derived_velocity(entry) == pytest.approx(speed, rel=1e-5)
        deviations.append(speed / entry.detonation["gurney_velocity"].value - 1.0)
    assert min(deviations) > 0.0 and max(deviations) < 0.08
    assert float(np.median(deviations)) == pytest.approx(0.032, abs=2e-3)


def test_the_lines_command(capsys, tmp_path):
    code, out = answer(capsys, "eos", "lines", "copper", "--at", "particle_velocity = 1 km/s", "--plot", str(tmp_path / "l.png"))
    assert not code and "fanno" in out and (tmp_path / "l.png").stat().st_size > 10_000


@pytest.mark.parametrize("velocity", ["-1 m/s", "0 m/s", "1e9 m/s"])
def test_a_velocity_that_no_explosive_has_is_refused(capsys, velocity):
    code, _ = answer(capsys, "eos", "gurney", f"--velocity={velocity}")
    assert code == 2


def test_the_example_of_the_help_runs(capsys):
    from hugoniot.cli.eos.lines import gurney

    example = gurney.__doc__.split("Example: hugoniot ")[1].split(" --ratio")[0]
    assert not answer(capsys, *example.split(), "--json")[0]


def told(capsys, *words):
    """What `hugoniot eos gurney` writes on the error stream."""
    with pytest.raises(SystemExit):
        front.main(["eos", "gurney", *words])
    return capsys.readouterr().err


@pytest.mark.parametrize("words, message", [
    ("--ratio=-1", "mass_ratio = -1 must be positive\n"), ("--tamper=-1", "tamper_ratio = -1 must not be negative\n")])
def test_a_ratio_that_cannot_be_is_named_alone(capsys, words, message):
    assert message in told(capsys, "petn", words)


def test_a_gurney_velocity_without_its_unit_is_questioned(capsys):
    assert 'write "2.7 km/s"' in told(capsys, "--velocity", "2.7")
    assert "bare number" not in told(capsys, "--velocity", "2.7 km/s")
