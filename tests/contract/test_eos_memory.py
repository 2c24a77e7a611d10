"""Laws with a memory (crushed pores): what was compacted stays so, unloads elastically and reloads to where it came from."""

import math

import numpy as np
import pytest
from dual import Dual, slopes

import hugoniot.laws.eos  # noqa: F401  (enrols every law)
from hugoniot.laws.eos import p_alpha
from hugoniot.laws.eos.contract import (
    EOS,
    compacted,
    density_limits,
    entropy,
    pressure,
    pressure_derivatives,
    reference_state,
    remembered,
    sound_speed_squared,
    unloading,
)
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.isentrope import isentrope, reference, release
from hugoniot.theory.states import States

LAWS = [law for law in sorted(EOS, key=lambda law: law.name) if "remembers" in law.flags]
SOLID = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)


def loaded(law, count=300, seed=3):
    """(rho, e, p, compaction) of states first loaded, from nothing crushed to all pores closed."""
    rng = np.random.default_rng(seed)
    rest, top = reference_state(law.example)[0], 1.02 * EOS.of(law.example.base).functions["reference_state"](law.example.base)[0]
    for rho, e in zip(rng.uniform(rest, top, count).tolist(), rng.uniform(0.0, 2e4, count).tolist()):
        p = pressure(rho, e, law.example)
        yield rho, e, p, compacted(0.0, rho, e, p, law.example)


def test_the_porous_laws_remember():
    assert [law.name for law in LAWS] == ["p_alpha", "p_lambda", "snow_plough"]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_nothing_remembered_is_the_first_loading(law):
    fresh = remembered(0.0, law.example)
    for rho, e, p, _ in loaded(law, 100):
        assert pressure(rho, e, fresh) == pytest.approx(p, rel=1e-11, abs=1e-3)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_a_loaded_state_stands_at_the_edge_of_its_elastic_branch(law):
    """The crushed law answers the state that crushed it, elastically or not; crushes no further there; and a further load does."""
    seen = set()
    for rho, e, p, k in loaded(law):
        crushed = remembered(k, law.example)
        seen.add(0 if k == 0.0 else 1 if k < 1.0 else 2)
        assert 0.0 <= k <= 1.0
        for par in (crushed, unloading(crushed)):
            assert pressure(rho, e, par) == pytest.approx(p, rel=1e-8, abs=1.0)
        assert compacted(k, rho, e, p, law.example) == k
        more = 1.0002 * rho
        assert compacted(k, more, e, pressure(more, e, crushed), law.example) >= k
        assert k in (0.0, 1.0) or pressure(more, e, crushed) < pressure(more, e, unloading(crushed))
    assert seen >= ({1} if law.name == "p_lambda" else {1, 2})      # an exponential closes the last pore at no pressure


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_crushed_material_unloads_elastically_to_rest_and_bears_tension(law):
    for rho, e, _, k in loaded(law, 100):
        crushed = remembered(k, law.example)
        rest, e0 = reference_state(crushed)
        assert pressure(rest, e0, crushed) == pytest.approx(0.0, abs=2e-9 * rho * sound_speed_squared(rho, e, crushed))
        low = 0.999 * rho
        below = pressure(low, e, crushed)
        assert below == pytest.approx(pressure(low, e, unloading(crushed)), rel=1e-11, abs=1e-3)
        assert k == 0.0 or below < pressure(low, e, law.example) or pressure(low, e, law.example) == pytest.approx(below, rel=1e-3)
        assert sound_speed_squared(low, e, crushed) >= 0.99 * sound_speed_squared(low, e, law.example) > 0.0
        for par in (crushed, unloading(crushed)):
            p_rho, p_e = pressure_derivatives(low, e, par)
            s_rho, s_e = slopes(pressure(Dual(low, 1.0, 0.0), Dual(e, 0.0, 1.0), par))
            assert s_rho == pytest.approx(p_rho, rel=1e-10) and s_e == pytest.approx(p_e, rel=1e-9, abs=1e-6 * rho)


def test_at_fixed_distension_the_solid_is_isentropic():
    """Carroll and Holt's 1/alpha: unloading of crushed material does on its solid the work that keeps the solid's entropy."""
    par = p_alpha.build(SOLID, 1.5, 0.1e9, 2e9)
    start = States(par, 2200.0, pressure(2200.0, 5e4, par), 5e4, 0.0)
    k = compacted(0.0, 2200.0, 5e4, start.pressure, par)
    alpha = 1.5 - 0.5 * k
    assert 0.2 < k < 0.8
    fall = release(par, start, 0.0, points=9)
    found = [entropy(alpha * rho, e, SOLID) for rho, e in zip(fall.density, fall.specific_internal_energy)]
    assert np.ptp(found) < 1e-9 * 863.0
    solid = isentrope(SOLID, States(SOLID, alpha * 2200.0, alpha * start.pressure, 5e4, 0.0), pressure=0.0)
    assert fall.density[-1] == pytest.approx(solid.density / alpha, rel=1e-10)
    assert fall.pressure[-1] == pytest.approx(0.0, abs=1.0) and not math.isclose(fall.density[-1], reference(par).density, rel_tol=0.02)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_crushed_laws_keep_their_limits(law):
    low, high = density_limits(remembered(1.0, law.example))
    assert low < reference_state(remembered(1.0, law.example))[0] < high
    solid = EOS.of(law.example.base).functions["reference_state"](law.example.base)[0]
    assert reference_state(remembered(1.0, law.example))[0] == pytest.approx(solid, rel=1e-12)
