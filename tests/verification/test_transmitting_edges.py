"""Transmitting edges of the two-dimensional solver against bodies that go on: what comes back is below 1 % of the wave.

Strips between smooth walls, along either direction, in the plane and in a cylinder; the equations are those of one dimension.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "unit" / "solvers2d"))
from plane_builders import Boundary2D, Pulse, Viscosity2D, box, problem, ran, walls

from hugoniot.diagnostics.transmitting import measured_at_edges
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Region, SolverOptions
from hugoniot.problem.plane.model import VelocityField
from hugoniot.simulate import final_warnings, make_solver
from hugoniot.solvers.lagrange1d.transmitting import missing as missing_on_the_line
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.solvers.lagrange2d.transmitting import missing

FLUORIDE, COPPER = MieGruneisen(2640.0, 5150.0, 1.35, 1.6), MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
MATERIALS = {"fluid": Material("m", FLUORIDE), "LiF": Material("m", FLUORIDE, PerfectlyPlastic(49e9, 0.36e9)),
             "copper": Material("m", COPPER, PerfectlyPlastic(47e9, 0.3e9))}
ZONES, LENGTH, NEAR = 150, 7.5e-3, 10
STEP = 0.2 * LENGTH / ZONES / 9000.0     # both bodies take the same steps
OPPOSITE = {"top": "bottom", "bottom": "top", "left": "right", "right": "left"}


def strip(times, material, shape, pressure, duration=0.4e-6, side="top", geometry="plane", inner=0.0, stop=3e-6, **more):
    """A pulse on the side of a strip opposite to the transmitting one, `times` as long as the one that is looked at."""
    count, length, upright = times * ZONES, times * LENGTH, side in ("top", "bottom")
    zones, size = ((1, count), (0.1e-3, length)) if upright else ((count, 1), (length, 0.1e-3))
    origin = (inner, -length if side == "bottom" else 0.0) if upright else (-length if side == "left" else inner, 0.0)
    smooth = ("left", "right") if upright else ("bottom", "top")
    held = [name for name in smooth if not (geometry == "axisymmetric" and upright and name == "left" and inner == 0.0)]
    sides = (Boundary2D((f"b.{OPPOSITE[side]}",), "pressure", Pulse(shape, amplitude=pressure, duration=duration)),
             Boundary2D((f"b.{side}",), "transmitting"), *walls(*(f"b.{name}" for name in held)))
    return Lagrange2D(problem(box(*zones, *size, origin, material="m"), MATERIALS[material], stop, sides, geometry, viscosity=Viscosity2D(),
                              initial_step=STEP, largest_step=STEP, **more))


def stress(solver, times, side):
    """Stress along the strip, from the driven end on, of the part that is looked at."""
    z = solver.zones
    found = z[Z.p] + (z[Z.qyy] - z[Z.syy] if side in ("top", "bottom") else z[Z.qxx] - z[Z.sxx])
    assert found.shape == (times * ZONES,)
    return (found if side in ("top", "right") else found[::-1])[:ZONES]


def echo(*args, side="top", stop=3e-6, **how):
    """(largest difference in stress from a body without an end, largest stress that reaches the end, the solver), Pa."""
    short, long = (strip(times, *args, side=side, stop=stop, **how) for times in (1, 2))
    worst = incident = 0.0
    for time in np.linspace(0.0, stop, 61)[1:]:
        for solver in (short, long):
            while solver.time < time:
                solver.march(time, 100_000)
        found, free = stress(short, 1, side), stress(long, 2, side)
        worst = max(worst, np.max(np.abs(found - free)[:-NEAR]))
        incident = max(incident, np.max(free[-3 * NEAR:]))
    return worst, incident, short


@pytest.mark.parametrize("material, shape, pressure, duration, where", [
    ("fluid", "square", 20e9, 0.4e-6, {"side": "right"}),       # a shock and the fan behind it
    ("LiF", "square", 5e9, 1e-6, {"side": "top", "geometry": "axisymmetric"}),      # elastic and plastic shock, elastic and plastic release
    pytest.param("LiF", "square", 2e9, 1e-6, {"side": "left"}, marks=pytest.mark.slow),
    pytest.param("LiF", "square", 50e9, 0.4e-6, {"side": "bottom"}, marks=pytest.mark.slow),
    pytest.param("LiF", "half_sine", 10e9, 0.4e-6, {"side": "bottom", "geometry": "axisymmetric", "scheme": "area_weighted"},
                 marks=pytest.mark.slow),       # smooth, until it steepens
    pytest.param("copper", "square", 5e9, 0.4e-6, {"side": "right"}, marks=pytest.mark.slow),       # the release catches the shock at the end
])
def test_a_strong_wave_leaves_to_one_percent(material, shape, pressure, duration, where):
    worst, incident, solver = echo(material, shape, pressure, duration, **where)
    assert incident > (0.5 if shape == "half_sine" else 0.85) * pressure and worst < 0.01 * incident
    errors = solver.errors()
    assert errors["energy_error"] < 1e-12 and (where.get("scheme") or errors["momentum_y_error"] < 1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("material, pressure, bound", [("LiF", 5e9, 0.02), ("copper", 5e9, 0.01), ("LiF", 50e9, 0.01)])
def test_a_short_pulse_leaves_upwards(material, pressure, bound):
    worst, incident, _ = echo(material, "square", pressure)
    assert worst < bound * incident


@pytest.mark.slow
def test_sound_that_spreads_about_the_axis_leaves():
    """Taken for a plane wave it would leave 4 % behind."""
    worst, incident, _ = echo("fluid", "half_sine", 1e8, side="right", geometry="axisymmetric", inner=5e-3, stop=4e-6)
    assert incident > 3e7 and worst < 0.01 * incident


@pytest.mark.parametrize("motion", [(0.0, 0.0), (300.0, -200.0)])
def test_a_uniform_state_and_motion_go_on(motion):
    """Nothing happens at edges through which material goes on as it is; a hydrostatic stress of 2 GPa holds outside."""
    block = box(4, 3, 1.0, 0.8, material="m", density=2800.0, pressure=2e9, velocity=VelocityField(base=motion))
    solver = ran(problem(block, MATERIALS["LiF"], 1e-4, tuple(Boundary2D((f"b.{side}",), "transmitting") for side in OPPOSITE)))
    assert solver.cycle > 5 and np.allclose(solver.zones[Z.p], 2e9, rtol=1e-9)
    assert all(np.allclose(solver.nodes[row], speed, rtol=0, atol=1e-6) for row, speed in zip((N.u, N.v), motion))


def test_a_run_with_transmitting_edges_resumes_in_the_same_bits():
    """In the middle of the shock's passage, in bursts of other lengths; what the edges know is in the checkpoint."""
    whole, begun, resumed = (strip(1, "fluid", "square", 20e9, side="right", stop=2e-6) for _ in range(3))
    begun.march(2e-6, 9000)
    resumed.restore(begun.payload())
    for solver, cycles in ((whole, 10_000), (resumed, 777)):
        while solver.time < 2e-6:
            solver.march(2e-6, cycles)
    assert all(np.array_equal(getattr(whole, name), getattr(resumed, name)) for name in ("zones", "nodes", "chains", "ends"))


@pytest.mark.parametrize("side", ["right", "bottom"])
def test_the_echo_that_is_missing_is_estimated_and_warned_of_as_in_one_dimension(side):
    """Beyond the end of LiF under 4 GPa for 0.5 us the elastic release overtakes the shock (`test_transmitting_ends`); in time, or not."""
    for stop, warned in ((4e-6, True), (1.6e-6, False)):
        solver = strip(1, "LiF", "square", 4e9, 0.5e-6, side, stop=stop)
        while solver.time < stop:
            solver.march(stop, 100_000)
        pulse = Boundary("pressure", Pulse("square", amplitude=4e9, duration=0.5e-6))
        line = make_solver(Problem("line", "planar", stop, (Region("b", "m", 0.0, LENGTH, ZONES),), {"m": MATERIALS["LiF"]}, pulse,
                                   Boundary("transmitting"), solver=SolverOptions(largest_step=STEP, initial_step=STEP)))
        while line.time < stop:
            line.march(stop, 100_000)
        (echoes,) = missing(solver.problem, solver.ends).values()
        assert echoes == pytest.approx([missing_on_the_line(line.control)[1]], rel=1e-3, abs=1e3)
        words = measured_at_edges(solver.problem, solver.peaks()["peak_stress"], {f"b.{side}": echoes})
        assert len(words) == warned
        if warned:
            assert f"edge 'b.{side}' would send back a wave of up to about {echoes[0] / solver.peaks()['peak_stress'][{'right': -1, 'bottom': 0}[side]]:.0%}" in words[0]
            assert words == final_warnings(solver.problem, solver, ())[-1:]
