"""Fields found for a snapshot in two dimensions: against the same plane wave in one, the budget, and the entropy of a gas."""

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck_text

PLATE = """stop_time = "0.2 us"
[solver]
kind = "lagrange2d"
[[block]]
name = "plate"
material = "aluminum 6061"
x = ["0 mm", "2 mm"]
y = ["0 mm", "0.1 mm"]
zones = [60, 3]
[[boundary]]
on = "plate.left"
kind = "velocity"
velocity = "100 m/s"
[[boundary]]
on = "plate.bottom"
kind = "wall"
[[boundary]]
on = "plate.top"
kind = "wall"
[output]
fields = ["energy", "density", "kinetic_energy", "momentum_x", "momentum_y", "entropy", "elastic_deviator_energy", "pressure_work_and_heat",
          "plastic_work", "viscous_work", "von_mises", "lode_angle", "principal_angle", "deviator_xx", "deviator_yy"]
"""


@pytest.fixture(scope="module")
def plate(tmp_path_factory):
    run = simulate.run(read_deck_text(PLATE, "deck.toml"), tmp_path_factory.mktemp("plate") / "run", report=False)
    return run, {name: run.snapshots[name].values for name in run.snapshots}


def test_the_modes_add_up_to_the_energy_and_the_motion_to_the_budget(plate):
    run, found = plate
    parts = sum(found[name][-1] for name in ("pressure_work_and_heat", "elastic_deviator_energy", "plastic_work", "viscous_work"))
    assert parts == pytest.approx(found["energy"][-1] - found["energy"][0], rel=1e-9, abs=1e-6)
    mass, budget = run.snapshots["mass"].values, run.arrays("budget")
    assert np.sum(mass * found["kinetic_energy"][-1]) == pytest.approx(budget["kinetic_energy"][-1].sum(), rel=1e-9)
    assert np.sum(found["momentum_x"][-1]) == pytest.approx(budget["momentum_x"][-1].sum(), rel=1e-12)
    assert np.abs(found["momentum_y"][-1]).max() < 1e-9 * found["momentum_x"][-1].max()


def test_behind_a_plane_wave_the_stress_is_that_of_uniaxial_compression(plate):
    _, found = plate
    behind = slice(0, 15)
    sxx = found["deviator_xx"][-1][behind]
    assert found["von_mises"][-1][behind] == pytest.approx(1.5 * np.abs(sxx), rel=1e-9) and np.abs(sxx).min() > 1e8
    assert found["lode_angle"][-1][behind] == pytest.approx(np.pi / 6.0, abs=1e-9)
    assert np.abs(found["principal_angle"][-1][behind]) == pytest.approx(np.pi / 2.0, abs=1e-6)     # the larger stress lies across
    assert found["elastic_deviator_energy"][-1][behind].min() > 0.0
    assert found["entropy"][-1][behind].min() > found["entropy"][0].max()       # a shock, and plastic work


def test_fields_of_one_dimension_are_refused_with_their_names_in_two():
    for name in ("momentum", "deviator_hoop", "compaction"):
        with pytest.raises(DeckError, match=f"no field '{name}' in two dimensions"):
            read_deck_text(PLATE.replace('"momentum_x"', f'"{name}"'))
    with pytest.raises(DeckError, match="no material of this problem has an entropy"):
        read_deck_text(PLATE.replace('"aluminum 6061"', '"T001"'))


def test_a_void_fraction_is_refused_where_nothing_opens_voids():
    text = 'stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "{}"\nfrom = 0.0\nto = 1e-3\nzones = 4\n[output]\nfields = ["void_fraction"]\n'
    with pytest.raises(DeckError, match="no material of this problem opens voids"):
        read_deck_text(text.format("water"))
    assert read_deck_text(text.format("copper")).problem is not None
