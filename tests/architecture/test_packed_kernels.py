"""The machine code of every sweep holds packed arithmetic: a silent loss of vectorisation costs a factor of 4 to 9.

Each sweep is compiled here by itself, uncached (code from the disk cache cannot be inspected), for the laws most runs use.
"""

import dataclasses
import platform

import lagrange_builders as build
import numba as nb
import numpy as np
import pytest
import reactive_builders

from hugoniot.core.compile import SWEEP, packed
from hugoniot.laws.burn.threshold import Threshold
from hugoniot.materials import library
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d import node_sweeps, reactive_sweeps, wilkins_sweeps, zone_sweeps

pytestmark = pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="counts x86 instructions")
OPTIONS = {**SWEEP, "cache": False}


@pytest.fixture(scope="module")
def solver():
    return make_solver(build.flyer((8, 8)))


def compiled(sweep, solver, *rest):
    """A sweep compiled for the arguments at hand."""
    kernel = nb.njit(**OPTIONS)(sweep.py_func)
    values = (solver.table, solver.nodes, *rest)
    kernel.compile(tuple(nb.typeof(value) for value in values))
    return kernel


def counts(sweep, solver, *rest):
    """Its packed instructions."""
    return packed(compiled(sweep, solver, *rest))


def zone_arguments(solver):
    law, table = solver.laws.kinds[0], solver.laws.tables[0]
    rows = tuple(part[0] for part in table)
    return solver.gradient, 0, 16, 0, 1e-9, law, rows, solver.geometry, np.zeros(5)


@pytest.mark.parametrize("sweep, divisions, fused", [(zone_sweeps.predict, 3, 10), (zone_sweeps.correct, 3, 14), (wilkins_sweeps.advance, 4, 15)],
                         ids=["predict", "correct", "advance"])
def test_the_zone_sweeps_are_packed(solver, sweep, divisions, fused):
    found = counts(sweep, solver, *zone_arguments(solver))
    assert found["div"] >= divisions and found["fmadd"] + found["fnmadd"] >= fused, found


@pytest.mark.parametrize("sweep", [zone_sweeps.predict, zone_sweeps.correct, wilkins_sweeps.advance], ids=["predict", "correct", "advance"])
def test_a_zone_sweep_is_entered_without_comparing_rows_or_counting_references(solver, sweep):
    """Either costs as much as hundreds of zones, each time."""
    kernel = compiled(sweep, solver, *zone_arguments(solver))
    code = kernel.inspect_llvm(kernel.signatures[0])
    assert "vector.body" in code and "vector.memcheck" not in code and "NRT_incref" not in code


def burning_kernel(sweep, closure="thermal_isolation", rate=None):
    """A sweep compiled for LX-17, both phases JWL, with ignition and growth or another rate."""
    explosive = library.find("LX-17 reactive")
    explosive = dataclasses.replace(explosive, mixture=closure, burn=rate or explosive.burn)
    charge = make_solver(reactive_builders.driven(explosive, 1e-3, 16, 1400.0, 1e-6))
    return compiled(sweep, charge, *zone_arguments(charge))


def alike(sweep, known):
    """`predict_alike` or `correct_alike` of zones of which one thing is known, as a sweep with the arguments of the others."""
    @nb.njit(**OPTIONS)
    def kernel(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
        sweep(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, known)

    return kernel


ALIKE = pytest.mark.parametrize("sweep", [reactive_sweeps.predict_alike, reactive_sweeps.correct_alike], ids=["predict", "correct"])


@ALIKE
@pytest.mark.parametrize("known", [reactive_sweeps.UNBURNED, reactive_sweeps.BURNED], ids=["unburned", "burned"])
def test_zones_that_do_not_burn_are_packed_and_entered_like_inert_ones(sweep, known):
    """Most of a charge; two exponentials of a JWL are twenty-six fused products."""
    kernel = burning_kernel(alike(sweep, known))
    found, code = packed(kernel), kernel.inspect_llvm(kernel.signatures[0])
    assert found["div"] >= 3 and found["fmadd"] + found["fnmadd"] >= 26, found
    assert "vector.memcheck" not in code and "NRT_incref" not in code


@ALIKE
@pytest.mark.parametrize("closure", ["thermal_isolation", "thermal_equilibrium"])
def test_zones_that_burn_are_packed_but_for_the_searches_left_over(sweep, closure):
    """Two trials of a search, each with four exponentials of the JWL pair, and an exponential and a logarithm of the reactants."""
    found = packed(burning_kernel(alike(sweep, reactive_sweeps.PARTLY), closure))
    assert found["div"] >= 10 and found["fmadd"] + found["fnmadd"] >= 2 * 6 * 12, found


@pytest.mark.parametrize("sweep", [reactive_sweeps.predict_burning, reactive_sweeps.correct_burning], ids=["predict", "correct"])
def test_burn_fractions_are_packed_but_for_sub_steps(sweep):
    """Three terms of ignition and growth and the logarithms of four numbers, beside what zones of pressures weighted take."""
    def counted(rate):
        found = packed(burning_kernel(sweep, "weighted_pressures", rate))
        return found["fmadd"] + found["fnmadd"]

    assert counted(None) - counted(Threshold(1e10)) >= 7 * 12


@pytest.mark.parametrize("sweep, rest", [
    (node_sweeps.accelerate, (0, 16, 0, 1e-9)), (node_sweeps.move, (0, 16, 0, 1e-9)), (wilkins_sweeps.leap, (0, 16, 0, 1e-9, 1e-9)),
    (zone_sweeps.conduct, (0, 16, 0, 1e-9, 0.5))], ids=["accelerate", "move", "leap", "conduct"])
def test_the_node_sweeps_are_packed(solver, sweep, rest):
    found = counts(sweep, solver, *rest, solver.geometry)
    assert found["fmadd"] + found["fnmadd"] >= 2, found


def test_a_scalar_loop_is_found_out():
    """The count itself can fail: a recurrence cannot be packed."""
    def recurrence(x):
        for j in range(1, x.shape[0]):
            x[j] = 1.0 / (x[j] + x[j - 1] * x[j - 1])

    kernel = nb.njit(**OPTIONS)(recurrence)
    kernel.compile((nb.float64[::1],))
    assert packed(kernel)["div"] == 0
