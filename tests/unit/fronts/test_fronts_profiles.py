"""Initial states that vary along a region, behind tracked fronts: in the mode cells from a profile, and regions of one zone joined into one."""

import dataclasses

import numpy as np
import pytest

from hugoniot.campaign.tracked import joined, with_fronts
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.programmed import Programmed
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Lighting, Problem, Profile, Region, SolverOptions
from hugoniot.problem.standard import STANDARD, gases
from hugoniot.problem.standard.parts import gas
from hugoniot.simulate import make_solver

WAVES = Profile((), (("density", "1 kg/m^3 + 0.2 kg/m^3 * cos(2 * pi * x / 1 m)"), ("pressure", "2 Pa + x * 1 Pa / 1 m"),
                     ("velocity", "0.3 m/s * sin(2 * pi * x / 1 m)")))


def varying(geometry="planar", zones=40):
    regions = (Region("gas", "gas", 0.0, 1.0, zones, profile=WAVES),)
    return with_fronts(Problem("varying", geometry, 0.1, regions, {"gas": gas(1.4)}, Boundary("fixed"), Boundary("fixed")))


@pytest.mark.parametrize("geometry", ["planar", "cylindrical"])
def test_cells_start_from_the_profile(geometry):
    solver = make_solver(varying(geometry))
    state, d = solver.state(), solver.problem.dimension
    middle = 0.5 * (state.position_left + state.position_right)
    assert state.zones["density"] == pytest.approx(1.0 + 0.2 * np.cos(2.0 * np.pi * middle), abs=3e-3)
    assert state.velocity_left == pytest.approx(0.3 * np.sin(2.0 * np.pi * state.position_left), abs=4e-3)
    faces = np.linspace(0.0, 1.0, 41)
    assert state.position_left == pytest.approx(faces[:-1], abs=1e-3)      # zones are where the deck has them, by their mass
    fine = np.linspace(0.0, 1.0, 4001)
    middles = 0.5 * (fine[1:] + fine[:-1])
    mass = ((1.0 + 0.2 * np.cos(2.0 * np.pi * middles)) * np.diff(fine**d) / d).sum()
    assert solver.mesh.q[:, 0].sum() == pytest.approx(mass, rel=1e-6)
    solver.march(0.1, 10**9)
    assert solver.errors()["mass_error"] < 1e-13 and solver.errors()["energy_error"] < 1e-13


def test_the_algebraic_mode_refuses_a_profile():
    problem = dataclasses.replace(varying(), solver=SolverOptions("fronts"))
    with pytest.raises(OutOfRange, match="starts from one state along a region"):
        make_solver(problem)


def test_zones_of_a_profile_are_joined_and_jumps_are_not():
    kidder = joined(gases.build_kidder(50))
    assert len(kidder.regions) == 1 and kidder.regions[0].zones == 50 and not kidder.interfaces
    sod = gases.build_sod(50)
    assert joined(sod) is sod
    from hugoniot.campaign.guderley import build

    inside, outside = joined(build("spherical", 1.4, 30)).regions
    assert inside.end == outside.start == pytest.approx(1.0)
    velocity = dict(outside.profile.fields)["velocity"]
    assert velocity[0] < velocity[2] < 0.0      # the node at the shock stands for the gas ahead, at rest


def test_a_smooth_drive_of_many_points_ends_no_steps():
    """Kidder's shell: both ends follow tables, whose points are no kinks."""
    problem = STANDARD["kidder"].build(25)
    solver = make_solver(with_fronts(problem))
    solver.march(problem.stop_time, 10**9)
    assert solver.cycle < len(problem.left.pulse.times)


def test_a_detonator_fires_where_its_explosive_has_moved_to():
    """Unburned explosive keeps its velocities; what stands at 2 cm and moves at 60 m/s is lit 50 ns later, 3 um on."""
    explosive = Material("he", IdealGas(3.0, rho0=1875.0), burn=Programmed(8000.0), detonation_energy=8000.0**2 / 16.0)
    moving = Profile((), (("velocity", "30 m/s + x * 1500 m/s / 1 m"),))
    regions = (Region("charge", "he", 0.0, 0.05, 50, density=1875.0, profile=moving),)
    problem = Problem("moved", "planar", 1e-7, regions, {"he": explosive}, Boundary("free"), Boundary("free"), lighting=(Lighting(0.02, 5e-8),))
    solver = make_solver(with_fronts(problem))
    solver.march(5e-8, 10**9)
    assert [float(f.start) for f in solver.mesh.fronts if f.kind == "detonation"] == pytest.approx([0.02 + 60.0 * 5e-8] * 2, rel=1e-9)
