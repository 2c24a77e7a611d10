"""A gauge on an interface records both sides: no density or temperature between two materials, velocity and stress once."""

import numpy as np
import pytest

from hugoniot import run
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.output.compare import compare, run_records
from hugoniot.output.run_numbers import gauge_rows, highest
from hugoniot.problem.model import BodyForce, Gauge, Interface, OutputOptions, Problem, Pulse, Region
from hugoniot.theory.impedance import match

TANTALUM = MieGruneisen(16650.0, 3414.0, 1.2, 1.6, 140.0)
FLUORIDE = MieGruneisen(2640.0, 5150.0, 1.35, 1.6, 1560.0)
SPEED = 400.0


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """Tantalum on LiF at 400 m/s, to a time at which the interface still holds the state of the impact."""
    materials = {"ta": Material("ta", TANTALUM), "lif": Material("lif", FLUORIDE)}
    regions = (Region("Ta", "ta", -3e-3, 0.0, 100, velocity=SPEED), Region("LiF", "lif", 0.0, 5e-3, 120))
    problem = Problem("sides", "planar", 0.8e-6, regions, materials, gauges=(Gauge("Ta/LiF", "Ta/LiF"), Gauge("inside", 1e-3)),
                      output=OutputOptions(report=False))
    return run(problem, tmp_path_factory.mktemp("sides") / "run")


def test_each_side_has_its_own_density_and_temperature(done):
    met = match([TANTALUM, FLUORIDE], SPEED)[0]
    for side, state in (("left", met.left), ("right", met.right)):
        density, temperature = (done.gauge(field, f"Ta/LiF {side}")[1] for field in ("density", "temperature"))
        assert density[-1] == pytest.approx(state.density, rel=0.01)
        assert np.all((temperature > 250.0) & (temperature < 1500.0))
    assert done.gauge("velocity", "Ta/LiF")[1][-1] == pytest.approx(met.particle_velocity, rel=0.01)
    assert done.gauge("stress", "Ta/LiF")[1][-1] == pytest.approx(met.pressure, rel=0.01)


def test_nothing_between_two_materials_is_recorded(done):
    with pytest.raises(KeyError, match="use 'Ta/LiF left' or 'Ta/LiF right'"):
        done.gauge("temperature", "Ta/LiF")
    heads = (done.folder / "gauges.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    assert "Ta/LiF velocity [m/s]" in heads and "Ta/LiF left temperature [K]" in heads
    assert not {"Ta/LiF temperature [K]", "Ta/LiF density [kg/m^3]"} & set(heads)
    assert not any(record.gauge == "Ta/LiF" and record.field == "density" for record in run_records(done))
    assert all(np.isfinite(pair.norms.linf) for pair in compare(done, done).pairs)


def test_a_table_names_an_interface_once_while_it_is_joined(done):
    assert [row["gauge"] for row in gauge_rows(done)][:2] == ["Ta/LiF", "inside"]


def test_round_off_before_a_wave_does_not_part_an_interface(tmp_path):
    """Curved zones under pressure have velocities of round-off until the wave comes: the same on both sides."""
    state = {"density": 17000.0, "energy": 0.0}
    regions = (Region("core", "ta", 0.0, 4e-3, 30, **state), Region("shell", "ta", 4e-3, 8e-3, 30, **state))
    problem = Problem("released", "spherical", 1.5e-6, regions, {"ta": Material("ta", TANTALUM)}, gauges=(Gauge("both", "core/shell"),),
                      interfaces=(Interface("core", "shell", "bonded"),), output=OutputOptions(report=False))
    released = run(problem, tmp_path / "run")
    velocity = released.gauge("velocity", "both")[1]
    assert 0.0 < np.abs(velocity[velocity != 0.0]).min() < 1e-9 < np.abs(velocity).max()
    assert [row["gauge"] for row in gauge_rows(released)] == ["both", "free surface right"]


@pytest.mark.parametrize("kind, strength, least", [("separable", 0.0, 0.0), ("bond", 2e8, -2e8), ("bonded", 0.0, -1e9)])
def test_the_tension_of_an_interface_is_not_above_its_strength(tmp_path, kind, strength, least):
    """A thin plate pulls at the interface once its release has come back: in the step in which this opens, its two zones have tension."""
    regions = (Region("thin", "ta", -0.5e-3, 0.0, 10, velocity=SPEED), Region("thick", "ta", 0.0, 2e-3, 40), Region("back", "ta", 2e-3, 2.4e-3, 8))
    joint = () if kind == "separable" else (Interface("thick", "back", kind, strength),)
    problem = Problem("pulled", "planar", 1e-6, regions, {"ta": Material("ta", TANTALUM)}, gauges=(Gauge("joint", "thick/back"),),
                      interfaces=joint, output=OutputOptions(report=False))
    pulled = run(problem, tmp_path / "run")
    assert pulled.summary["interfaces_separated"] > 0 or kind == "bonded"
    for name in ("joint", "joint left", "joint right"):
        lowest = float(pulled.gauge("stress", name)[1].min())
        assert lowest == least if kind != "bonded" else lowest < least


def test_round_off_of_a_body_in_free_fall_is_no_stress(tmp_path):
    """Plates that a body force accelerates alike stay free of stress: 2 mPa of round-off were printed as peak and lowest stress."""
    regions = (Region("Ta", "ta", 0.0, 1e-3, 20), Region("LiF", "lif", 1e-3, 2e-3, 20))
    problem = Problem("falling", "planar", 1e-6, regions, {"ta": Material("ta", TANTALUM), "lif": Material("lif", FLUORIDE)},
                      gauges=(Gauge("inside", 0.5e-3),), body_force=BodyForce(Pulse("constant", 1e8)), output=OutputOptions(report=False))
    falling = run(problem, tmp_path / "run")
    row = gauge_rows(falling)[0]
    assert np.abs(falling.gauge("stress", "inside")[1]).max() > 0.0 and np.isnan(row["peak_stress"]) and np.isnan(row["lowest_stress"])
    assert row["last_velocity"] == pytest.approx(100.0) and highest(falling)["stress"] == 0.0 and "tension" not in highest(falling)
