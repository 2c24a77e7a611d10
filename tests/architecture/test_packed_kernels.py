"""The machine code of every pass holds packed arithmetic: a silent loss of vectorisation costs a factor of 4 to 9.

Each pass is compiled here by itself (code from the disk cannot be inspected), for the laws most runs use; by a fork, for
the compiler never gives its memory back: 200 MB for the passes of this file.
"""

import dataclasses
import json
import os
import platform

import numba as nb
import pytest

import compile_once
from hugoniot.core.inspection import packed
from hugoniot.core.passes import ROW, Pass, rows_type
from hugoniot.core.target import PASS
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.laws.viscosity.limited import Limited
from hugoniot.laws.viscosity.wilkins import Wilkins
from hugoniot.materials import burning, library
from hugoniot.mesh.line import Cylindrical, Planar, Spherical
from hugoniot.solvers.lagrange1d import compatible, leapfrog_passes, nodes, stress
from hugoniot.solvers.lagrange2d import heat_flux, quads, tensor
from hugoniot.zones import burn, closure, fracture, laws, mixture, soundness, strength, viscosity

pytestmark = pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="counts x86 instructions")


def compiled(each: Pass, law=None):
    """A pass compiled for a law, kept for those that run it; compiled again where it is kept already, since machine code shows nothing."""
    each.job(law)     # lets it call the functions it names
    kinds = (nb.int64, rows_type(each.rows), nb.float64, ROW, nb.types.TypeRef(nb.typeof(law)))
    for keep in True, False:
        kernel = nb.njit(**{**each.options, "cache": keep})(each.function)
        kernel.compile(kinds)
        if not kernel.stats.cache_hits:
            break
    return kernel


def seen(*passes_and_laws) -> list[dict[str, int]]:
    """What is found in the code of each pass compiled for a law (or None): counts of packed operations, and of words in the code."""
    source, target = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            compile_once.here()
            for each, law in passes_and_laws:
                kernel = compiled(each, float_parameters(law) if law is not None else None)
                code = "".join(kernel.inspect_llvm().values())
                words = {word: code.count(word) for word in ("vector.body", "vector.memcheck", "NRT_incref")}
                os.write(target, (json.dumps(packed(kernel) | words) + "\n").encode())
        finally:
            os._exit(0)
    os.close(target)
    with open(source) as answer:
        found = [json.loads(line) for line in answer]
    os.waitpid(child, 0)
    assert len(found) == len(passes_and_laws), f"{passes_and_laws[len(found)][0].__name__} could not be compiled"
    return found


HARDENING = library.find("iron").strength
METAL, SOLID, SPALL = library.find("copper").eos, PerfectlyPlastic(27.6e9, 0.3e9), SpallStress(1e9)
CASES = [(heat_flux.conduct, quads.Planar(), 4, 1), (closure.pressure_pass, METAL, 1, 3), (closure.state_pass, METAL, 1, 5), (closure.settle_pass, METAL, 2, 6),
         (closure.stiffness_pass, METAL, 1, 3), (strength.harden_pass, None, 0, 1),
         (fracture.fracture_pass, SPALL, 1, 1),
         (compatible.half_stress, viscosity.Resisting(Limited(), Planar()), 0, 2), (stress.strain_solid, strength.Strong(SOLID, strength.Inert(), Planar()), 0, 2),
         (stress.strain_solid, strength.Strong(HARDENING, strength.Burning(), Cylindrical()), 4, 20),
         (tensor.strain_solid, strength.Strong(HARDENING, strength.Inert(), ()), 4, 20), (nodes.drift, None, 0, 2),
         (nodes.move, Planar(), 0, 2), (nodes.leap, Planar(), 0, 2), (compatible.half_motion, Planar(), 2, 1),
         (compatible.end_motion, Planar(), 2, 1), (compatible.end_stress, Planar(), 0, 2), (compatible.heat_flux, Planar(), 0, 1),
         (compatible.half_motion, Spherical(), 3, 4), (compatible.end_motion, Spherical(), 3, 8), (compatible.end_stress_seen, Planar(), 0, 2),
         (leapfrog_passes.whole_motion, viscosity.Resisting(Wilkins(), Planar()), 2, 1),
         (leapfrog_passes.whole_motion, viscosity.Resisting(Wilkins(), Spherical()), 3, 4),
         (leapfrog_passes.strain_and_work, strength.Strong(SOLID, strength.Inert(), Planar()), 0, 3),
         (leapfrog_passes.end_stress, Planar(), 0, 3), (leapfrog_passes.end_stress_seen, Planar(), 0, 3)]


def test_passes_are_packed_and_entered_without_comparing_rows():
    """Comparing every pair of rows costs as much as hundreds of zones, each time."""
    *rest, last = seen(*((each, law) for each, law, _, _ in CASES), (soundness.look_over, None))
    assert last["vector.body"]
    for found, (each, law, divisions, fused) in zip(rest, CASES, strict=True):
        name = f"{each.__name__} for {type(law).__name__}"
        assert found["div"] >= divisions and found["fmadd"] + found["fnmadd"] >= fused, (name, found)
        assert found["vector.body"] and not found["vector.memcheck"] and not found["NRT_incref"], (name, found)


@pytest.mark.parametrize("closing", ["thermal_isolation", pytest.param("thermal_equilibrium", marks=pytest.mark.slow)])
def test_burning_material_is_packed_but_for_the_searches_left_over(closing):
    """Unburned and burned zones as inert ones; two trials of a search, each with four exponentials of the JWL pair, where both are."""
    laws.bind_burning()
    explosive = burning.reactive(dataclasses.replace(library.find("LX-17 reactive"), mixture=closing))
    search, rates = seen((mixture.solve_pass, explosive.mixture), (burn.burn_pass, explosive))
    assert search["div"] >= 10 and search["fmadd"] + search["fnmadd"] >= 2 * 6 * 12 + 2 * 26, search
    assert rates["fmadd"] + rates["fnmadd"] >= 7 * 12, rates


def test_a_scalar_loop_is_found_out():
    """The count itself can fail: a recurrence cannot be packed."""
    def recurrence(x):
        for j in range(1, x.shape[0]):
            x[j] = 1.0 / (x[j] + x[j - 1] * x[j - 1])

    kernel = nb.njit(**{**PASS, "cache": False})(recurrence)
    kernel.compile((nb.float64[::1],))
    assert packed(kernel)["div"] == 0
