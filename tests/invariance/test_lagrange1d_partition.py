"""How a run is divided must not show: regions of one material, order of names, bursts of cycles, threads."""

import dataclasses

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.core import team
from hugoniot.problem.model import Boundary, Interface, Region
from hugoniot.simulate import make_solver


def same_bits(one, other):
    a, b = one.state().fields(), other.state().fields()
    assert set(a) == set(b)
    for name, values in a.items():
        assert np.array_equal(values, b[name]), name
    assert (one.time, one.cycle) == (other.time, other.cycle)


def divided(problem, which, parts):
    """The problem with a region cut into bonded regions of the same material at its own nodes."""
    regions, interfaces = [], list(problem.interfaces)
    for region in problem.regions:
        if region.name != which:
            regions.append(region)
            continue
        nodes = np.linspace(region.start, region.end, region.zones + 1)
        cuts = np.cumsum((0, *parts))
        names = [f"{which} {k}" for k in range(len(parts))]
        regions += [dataclasses.replace(region, name=n, start=float(nodes[a]), end=float(nodes[b]), zones=int(b - a))
                    for n, a, b in zip(names, cuts[:-1], cuts[1:])]
        interfaces += [Interface(a, b, "bonded") for a, b in zip(names[:-1], names[1:])]
    return dataclasses.replace(problem, regions=tuple(regions), interfaces=tuple(interfaces), gauges=())


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_region_cut_in_three_of_the_same_material_changes_nothing(integrator):
    """Nodes at powers of two are the same bits however they are counted, and so is all that follows."""
    base = build.flyer((32, 64), stop=1.6e-6, integrator=integrator)
    sizes = ((0.0, 2.0**-9), (2.0**-9, 3.0 * 2.0**-9))
    problem = dataclasses.replace(base, gauges=(), regions=tuple(dataclasses.replace(r, start=a, end=b) for r, (a, b) in zip(base.regions, sizes)))
    whole, _ = build.run(problem)
    parts, _ = build.run(divided(problem, "target", (16, 32, 16)))
    assert whole.voids_opened >= 1
    same_bits(whole, parts)


def test_a_shocked_gas_cut_in_two_heats_the_same():
    """The artificial heat flux does not stop at the border between two regions of one gas."""
    piston = build.constant("velocity", 2.0)
    problem = build.gas_tube((64, 32), left=piston, right=Boundary("free"), stop=0.1)
    one = dataclasses.replace(problem, regions=(Region("gas", "gas", 1.0, 2.5, 96, density=1.0, pressure=1e-3),), interfaces=())
    whole, _ = build.run(one)
    parts, _ = build.run(divided(one, "gas", (48, 48)))
    assert whole.state().zones["density"].max() > 3.0
    same_bits(whole, parts)


def test_the_order_and_names_of_materials_do_not_matter():
    base = build.flyer((32, 64), stop=1.6e-6)
    regions = tuple(dataclasses.replace(r, material=m) for r, m in zip(base.regions, ("one", "two")))
    soft = dataclasses.replace(build.aluminium(name="two"), eos=build.EOS._replace(c0=4000.0))
    table = {"one": build.aluminium(name="one"), "two": soft}
    first, _ = build.run(dataclasses.replace(base, regions=regions, materials=table))
    second, _ = build.run(dataclasses.replace(base, regions=regions, materials=dict(reversed(table.items()))))
    same_bits(first, second)


def test_a_material_given_twice_is_one_material():
    base = build.flyer((32, 64), stop=1.6e-6)
    regions = tuple(dataclasses.replace(r, material=m) for r, m in zip(base.regions, ("one", "two")))
    twice = dataclasses.replace(base, regions=regions, materials={n: build.aluminium(name=n) for n in ("one", "two")})
    first, _ = build.run(base)
    second, _ = build.run(twice)
    same_bits(first, second)


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_bursts_of_any_length_give_the_same_bits(integrator):
    """One cycle at a time, or a thousand: through impact, yield, spall and parting."""
    problem = build.flyer((32, 64), stop=1.6e-6, gap=2e-5, integrator=integrator)
    one, other, third = (make_solver(problem) for _ in range(3))
    for solver, burst in ((one, 1), (other, 1000), (third, 7)):
        while solver.time < problem.stop_time:
            solver.march(problem.stop_time, burst)
            solver.take_gauges()
    assert one.voids_opened >= 1 and one.voids_closed >= 1
    same_bits(one, other)
    same_bits(one, third)


@pytest.mark.skipif(not team.possible(), reason="a team of threads needs a POSIX system")
def test_two_threads_give_the_same_bits_as_one():
    """Twelve thousand zones, so that the team is really formed; through impact and yield."""
    problem = build.flyer((4096, 8192), stop=2.5e-6)
    alone, pair = (make_solver(build.changed(problem, threads=n)) for n in (1, 2))
    assert alone.team.threads == 1 and pair.team.threads == 2
    for solver in (alone, pair):
        build.march_cycles(solver, 400)
    assert alone.state().zones["stress"].max() > 1e9
    same_bits(alone, pair)


def test_a_gauge_changes_no_bit():
    problem = build.flyer((32, 64), stop=1.6e-6)
    first, _ = build.run(problem)
    second, _ = build.run(dataclasses.replace(problem, gauges=()))
    same_bits(first, second)


def test_snapshots_at_the_same_times_change_no_bit_whoever_looks():
    problem = build.flyer((32, 64), stop=1.2e-6)
    first, _ = build.run(problem, build.Watcher(keep_snapshots=True), snapshots=5)
    second, _ = build.run(problem, build.Watcher(), snapshots=5, checkpoint_cycles=13)
    same_bits(first, second)
