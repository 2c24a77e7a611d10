"""A window over like material: a shock runs on as it moves with it, what is laid out is what is seen, and who cannot have one."""

import dataclasses

import numpy as np
import pytest
from lagrange_builders import GAS, constant, gas_tube

from hugoniot.errors import OutOfRange
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Region
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.window import Window
from hugoniot.theory.hugoniot import Initial, shock

DRIFT = -0.3


def stream(**region) -> Problem:
    """A gas that runs to the left between an open end and a piston that runs with it."""
    regions = (Region("gas", "gas", 0.0, 1.0, 50, velocity=DRIFT, density=1.0, pressure=1.0, **region),)
    return Problem("stream", "planar", 10.0, regions, {"gas": GAS}, Boundary("transmitting"), constant("velocity", DRIFT),
                   output=OutputOptions(report=False))


def test_a_shock_runs_on_as_its_window_moves_with_it():
    """The exact state behind a shock laid out at rest on 20 zones: after 63 more have passed, the plateau, the front's place and the mass."""
    behind = shock(GAS.eos, Initial(1.0, 1.0, 2.5), particle_velocity=-DRIFT)
    window = Window(make_solver(stream()))
    solver, n = window.solver, 20
    squeezed = window.size / behind.density
    position = window.size * n + np.concatenate((squeezed * np.arange(-n, 0), window.size * np.arange(31)))
    fields = {"pressure": behind.pressure, "energy": behind.specific_internal_energy, "sound_speed": behind.sound_speed}
    window.lay_out(position, np.where(np.arange(51) < n, 0.0, DRIFT), {k: np.full(n, v) for k, v in fields.items()}, behind.pressure)
    for _ in range(9):
        while np.count_nonzero(solver.state().zones["pressure"] > 1.05) < n + 7:
            solver.march(10.0, 1)
        window.move_on(7)
    state = solver.state()
    p, front = state.zones["pressure"], np.count_nonzero(state.zones["pressure"] > 0.5 * (1.0 + behind.pressure))
    assert p[:front - 5] == pytest.approx(behind.pressure, rel=0.01) and p[:5] == pytest.approx(behind.pressure, rel=2e-3)
    assert np.allclose(p[front + 8:], 1.0, rtol=1e-4) and np.allclose(p[-10:], 1.0, rtol=1e-12)
    assert np.allclose(state.velocity_right[-10:], DRIFT, rtol=1e-12)
    reached = window.size * n + (behind.shock_velocity + DRIFT) * solver.time
    assert state.position_left[front] == pytest.approx(reached, abs=2.0 * window.size)
    assert solver.errors()["mass_error"] < 1e-14


def test_what_is_laid_out_is_what_is_seen_and_what_lies_ahead_is_left_alone():
    window = Window(make_solver(stream()))
    position = np.linspace(0.0, 1.0, 51)
    position[:11] = np.linspace(0.1, 0.2, 11)
    window.lay_out(position, np.where(position < 0.2, 0.0, DRIFT), {"pressure": np.full(10, 3.0), "energy": np.full(10, 5.0)}, 3.0)
    state = window.solver.state()
    assert np.allclose(state.zones["density"], np.where(np.arange(50) < 10, 2.0, 1.0), rtol=1e-12)
    assert (state.zones["pressure"] == np.where(np.arange(50) < 10, 3.0, 1.0)).all() and (state.zones["energy"][:10] == 5.0).all()
    window.solver.march(1e-3, 1000)
    assert window.solver.time == 1e-3 and window.solver.state().zones["pressure"][-1] == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("problem", [gas_tube(), stream(ratio=1.01), dataclasses.replace(gas_tube(), regions=gas_tube().regions[:1], geometry="spherical"),
                                     dataclasses.replace(stream(), solver=dataclasses.replace(stream().solver, integrator="wilkins"))],
                         ids=["two regions", "graded", "spherical", "wilkins"])
def test_a_window_needs_one_planar_region_of_equal_zones(problem):
    with pytest.raises(OutOfRange, match="one planar region of equal zones"):
        Window(make_solver(problem))
