"""The machine code of every pass holds packed arithmetic: a silent loss of vectorisation costs a factor of 4 to 9.

Each pass is compiled here by itself, uncached (code from the disk cache cannot be inspected), for the laws most runs use.
"""

import platform

import numba as nb
import pytest

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
    """A pass compiled for a law."""
    kernel = nb.njit(**{**each.options, "cache": False})(each.function)
    kernel.compile((nb.int64, rows_type(each.rows), nb.float64, ROW, nb.types.TypeRef(nb.typeof(law))))
    return kernel


HARDENING = library.find("iron").strength
METAL, SOLID, SPALL = library.find("copper").eos, PerfectlyPlastic(27.6e9, 0.3e9), SpallStress(1e9)
CASES = [(heat_flux.conduct, quads.Planar(), 4, 1), (closure.pressure_pass, METAL, 1, 3), (closure.state_pass, METAL, 1, 5), (closure.settle_pass, METAL, 2, 6),
         (closure.stiffness_pass, METAL, 1, 3), (strength.harden_pass, None, 0, 1),
         (fracture.fracture_pass, SPALL, 1, 1),
         (compatible.half_stress, viscosity.Resisting(Limited(), Planar()), 0, 2), (stress.strain_solid, strength.Strong(SOLID, strength.Inert(), Planar()), 0, 2),
         (stress.strain_solid, strength.Strong(HARDENING, strength.Burning(), Cylindrical()), 4, 20),
         (tensor.strain_solid, strength.Strong(HARDENING, strength.Inert(), ()), 4, 20), (nodes.accelerate, Planar(), 0, 2),
         (nodes.move, Planar(), 0, 2), (nodes.leap, Planar(), 0, 2), (compatible.half_motion, Planar(), 2, 1),
         (compatible.end_motion, Planar(), 2, 1), (compatible.end_stress, Planar(), 0, 2), (compatible.heat_flux, Planar(), 0, 1),
         (compatible.half_motion, Spherical(), 3, 4), (compatible.end_motion, Spherical(), 3, 8), (compatible.end_stress_seen, Planar(), 0, 2),
         (leapfrog_passes.whole_motion, viscosity.Resisting(Wilkins(), Planar()), 2, 1),
         (leapfrog_passes.whole_motion, viscosity.Resisting(Wilkins(), Spherical()), 3, 4),
         (leapfrog_passes.strain_and_work, strength.Strong(SOLID, strength.Inert(), Planar()), 0, 3),
         (leapfrog_passes.end_stress, Planar(), 0, 3), (leapfrog_passes.end_stress_seen, Planar(), 0, 3)]


@pytest.mark.parametrize("each, law, divisions, fused", CASES, ids=[f"{c[0].__name__}-{type(c[1]).__name__}" for c in CASES])
def test_a_pass_is_packed_and_entered_without_comparing_rows(each, law, divisions, fused):
    """Comparing every pair of rows costs as much as hundreds of zones, each time."""
    kernel = compiled(each, float_parameters(law) if law is not None else None)
    found, code = packed(kernel), kernel.inspect_llvm(kernel.signatures[0])
    assert found["div"] >= divisions and found["fmadd"] + found["fnmadd"] >= fused, found
    assert "vector.body" in code and "vector.memcheck" not in code and "NRT_incref" not in code


def test_states_are_looked_over_in_packed_code():
    code = compiled(soundness.look_over).inspect_llvm()
    assert all("vector.body" in text for text in code.values())


@pytest.mark.parametrize("closing", ["thermal_isolation", "thermal_equilibrium"])
def test_burning_material_is_packed_but_for_the_searches_left_over(closing):
    """Unburned and burned zones as inert ones; two trials of a search, each with four exponentials of the JWL pair, where both are."""
    import dataclasses

    laws.bind_burning()
    reactive = float_parameters(burning.reactive(dataclasses.replace(library.find("LX-17 reactive"), mixture=closing)))
    found = packed(compiled(mixture.solve_pass, reactive))
    assert found["div"] >= 10 and found["fmadd"] + found["fnmadd"] >= 2 * 6 * 12 + 2 * 26, found
    found = packed(compiled(burn.burn_pass, reactive))
    assert found["fmadd"] + found["fnmadd"] >= 7 * 12, found


def test_a_scalar_loop_is_found_out():
    """The count itself can fail: a recurrence cannot be packed."""
    def recurrence(x):
        for j in range(1, x.shape[0]):
            x[j] = 1.0 / (x[j] + x[j - 1] * x[j - 1])

    kernel = nb.njit(**{**PASS, "cache": False})(recurrence)
    kernel.compile((nb.float64[::1],))
    assert packed(kernel)["div"] == 0
