"""Fields found for a snapshot: entropy against the jump of a gas, energies and momentum against the budget, Lode angle of uniaxial strain."""

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck_text

PISTON = """stop_time = "0.4 ms"
[[region]]
name = "gas"
material = "gas"
from = 0.0
to = 1.0
zones = 100
density = 1.2
pressure = 1e5
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
rho0 = 1.2
specific_heat = 717.5
[boundary]
left = {velocity = 1000.0}
right = "fixed"
[output]
fields = ["density", "pressure", "entropy", "kinetic_energy", "momentum", "pressure_work_and_heat", "viscous_work", "energy"]
"""
PLATE = """stop_time = "0.2 us"
[[region]]
name = "plate"
material = "copper"
from = 0.0
to = "2 mm"
zones = 100
[boundary]
left = {velocity = "100 m/s"}
[output]
fields = ["lode_angle", "von_mises", "elastic_deviator_energy", "plastic_work", "viscous_work", "pressure_work_and_heat", "energy", "density"]
"""


def test_entropy_energy_and_momentum_of_a_shocked_gas(tmp_path):
    run = simulate.run(read_deck_text(PISTON, "deck.toml"), tmp_path / "run", report=False)
    last = {name: run.snapshots[name].values[-1] for name in ("density", "energy", "entropy", "kinetic_energy", "momentum")}
    last["mass"], behind = run.snapshots["mass"].values, slice(15, 40)
    jump = 717.5 * (np.log(0.4 * 1.2 * last["energy"][behind] / 1e5) - 0.4 * np.log(last["density"][behind] / 1.2))
    assert last["entropy"][behind] - last["entropy"][-1] == pytest.approx(jump, rel=1e-9)
    # a strong shock of 1 km/s: p/p0 from the jump conditions, Us = 0.6 up + sqrt((0.6 up)^2 + c^2)
    speed = 600.0 + np.sqrt(600.0**2 + 1.4e5 / 1.2)
    ratio, crowd = 1.0 + 1.2 * speed * 1000.0 / 1e5, speed / (speed - 1000.0)
    assert last["entropy"][behind].mean() - last["entropy"][-1] == pytest.approx(717.5 * (np.log(ratio) - 1.4 * np.log(crowd)), rel=1e-3)
    budget = run.arrays("budget")
    assert np.sum(last["mass"] * last["kinetic_energy"]) == pytest.approx(budget["kinetic_energy"][-1].sum(), rel=1e-12)
    assert np.sum(last["momentum"]) == pytest.approx(budget["momentum"][-1].sum(), rel=1e-12)
    assert np.sum(last["mass"] * run.snapshots["pressure_work_and_heat"].values[-1]) == pytest.approx(
        budget["pressure_work_and_heat"][-1].sum(), rel=1e-12)


def test_the_lode_angle_of_uniaxial_compression(tmp_path):
    """Behind a plane wave two deviators are alike: 30 degrees, at the flow stress."""
    run = simulate.run(read_deck_text(PLATE, "deck.toml"), tmp_path / "run", report=False)
    angle, stress = (run.snapshots[name].values[-1] for name in ("lode_angle", "von_mises"))
    assert angle[:20] == pytest.approx(np.pi / 6.0, abs=1e-9) and stress[:20].min() > 1e7
    parts = sum(run.snapshots[name].values[-1] for name in ("pressure_work_and_heat", "elastic_deviator_energy", "plastic_work", "viscous_work"))
    gained = run.snapshots["energy"].values[-1] - run.snapshots["energy"].values[0]
    assert parts == pytest.approx(gained, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize("field, words", [("deviator_xy", "no field 'deviator_xy' in one dimension"), ("entropie", "did you mean 'entropy'")])
def test_fields_that_cannot_be(field, words):
    with pytest.raises(DeckError, match=words):
        read_deck_text(PISTON.replace('"entropy"', f'"{field}"'), "deck.toml")
