"""A step that leaves the range of a law is repeated smaller: the run goes on, its events say so, and its bits depend on nothing else."""

import contextlib
import functools

import numpy as np
import pytest
from contact_builders import Contact2D, al, meeting
from plane_builders import Boundary2D, Pulse, Viscosity2D, gas, problem, ran, walls

from hugoniot.errors import UnphysicalState
from hugoniot.mesh.shapes import Sector
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import rewind
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

HERRMANN = Viscosity2D("herrmann", limited=False)


@functools.cache
def rough() -> float:
    """A Courant number with which a step leaves the range of the law: which ones do changes with every round-off."""
    for courant in (4.0, 3.5, 4.5, 3.0, 5.0, 2.5):
        solver = imploding(courant=courant)
        with contextlib.suppress(UnphysicalState):      # not even smaller steps help
            marched(solver, 10_000)
            if solver.counters[L.LEFT_RANGE]:
                return courant
    raise AssertionError("no step has left the range of the law")


def imploding(sampler=None, courant=None):
    """Noh's implosion in steps far longer than they may be, with a viscosity that bears them ill: zones become colder than their law
    allows."""
    block = Block2D("b", "gas", Sector((0.0, 0.0), (0.005, 1.0), (0.0, 0.5 * np.pi)), (40, 9), density=1.0, pressure=1e-10,
                    velocity=VelocityField(radial=-1.0))
    hole = Boundary2D(("b.left",), "velocity", Pulse("constant", 0.0), slip=False)
    given = problem(block, gas(), 0.6, (hole, *walls("b.bottom", "b.top")), viscosity=HERRMANN, courant=courant or rough(), initial_step=1e-2)
    return Lagrange2D(given, sampler)


def marched(solver, cycles, until=0.6):
    """Events of a run in bursts of so many cycles."""
    events = []
    while solver.time < until:
        events += solver.march(until, cycles)
    return events


@pytest.fixture(scope="module")
def whole():
    solver = imploding()
    return solver, marched(solver, 10_000)


def same(a, b):
    return all(np.array_equal(getattr(a, name), getattr(b, name), equal_nan=True) for name in ("zones", "nodes", "control", "counters", "chains"))


def test_the_run_goes_on_and_its_events_say_why(whole):
    solver, events = whole
    assert solver.time == 0.6 and solver.errors()["energy_error"] < 1e-12
    assert len(events) == solver.counters[L.LEFT_RANGE] > 0
    assert all(event.kind == "step_repeated" and "half the length: in block 'b' the sound speed" in event.text for event in events)
    assert solver.results()["steps_repeated"] == solver.counters[L.REPEATED] + len(events)


@pytest.mark.parametrize("cycles", [1, 7])
def test_the_bits_do_not_depend_on_the_length_of_bursts(whole, cycles):
    solver = imploding()
    events = marched(solver, cycles)
    assert same(solver, whole[0]) and events == whole[1]


def test_a_resumed_run_repeats_the_same_steps(whole):
    """Resumed shortly before the step in question and just after it."""
    first = whole[1][0].cycle
    for stop in (first - 3, first + 1):
        begun, resumed = imploding(), imploding()
        begun.march(0.6, stop)
        resumed.restore(begun.payload())
        marched(resumed, 10_000)
        assert same(resumed, whole[0])


def test_gauges_are_read_once(whole, monkeypatch):
    """Those between the copy and the step that is repeated were read before."""
    solver = imploding(lambda state: {"peak": np.array([state.zones["density"].max()])})
    solver.control[L.GAUGE_INTERVAL] = 1e-3
    events = marched(solver, 10_000)
    times, fields = solver.take_gauges()
    assert len(events) == len(whole[1]) and np.all(np.diff(times) > 0.0) and len(times) == len(fields["peak"]) > 200
    assert np.array_equal(solver.zones, whole[0].zones, equal_nan=True)


def test_a_state_without_hope_is_given_up_in_its_cycle(monkeypatch):
    """What no step can mend: each try is half as long as the one before, and the last one's fault is reported."""
    solver = imploding()
    solver.march(0.6, 3)
    solver.zones[Z.e, 30] = -1e3
    solver.begin()
    tried = []
    again = rewind.Rewind.again
    monkeypatch.setattr(rewind.Rewind, "again", lambda self, solver, *rest: tried.append(solver.step) or again(self, solver, *rest))
    with pytest.raises(UnphysicalState, match="sound speed of a zone is imaginary") as caught:
        solver.march(0.6, 100)
    assert caught.value.zone is not None and len(tried) == rewind.MOST_TRIES + 1
    assert np.allclose(np.array(tried[1:]) / tried[:-1], 0.5)


def test_what_is_kept_is_all_a_step_is_taken_from():
    """Bodies that slide with friction, strength and a wall: taken back and marched again, the same bits."""
    blocks = [al(6, 8, 3e-3, 4e-3, (0.0, -4e-3), "target"), al(5, 6, 2.5e-3, 2e-3, (0.2e-3, 1e-5), "flyer", (60.0, -700.0))]
    solver = ran(meeting(blocks, 1.2e-6, walls("target.bottom"), contacts=[Contact2D(("flyer", "target"), friction=0.2)]), cycles=40)
    kept, cycle = rewind.keep(solver), solver.cycle
    solver.march(1.0, 30)
    there = solver.payload()
    solver.forces[:] = np.nan       # scratch counts for nothing
    solver.nodes[[N.xh, N.yh, N.um, N.vm, N.fx, N.fy]] = np.nan
    rewind.put_back(solver, kept)
    assert solver.cycle == cycle
    solver.march(1.0, 30)
    again = solver.payload()
    scratch = np.zeros(len(Z), dtype=bool)
    scratch[rewind.ZONE_ROWS] = True
    assert np.array_equal(again["zones"][scratch], there["zones"][scratch])
    assert all(np.array_equal(again[name], there[name], equal_nan=True) for name in there if name != "zones")
