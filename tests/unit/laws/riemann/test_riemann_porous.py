"""Shocks that close pores: admissible wherever they are followed, and the same in Python and in kernels' plain functions."""

import math

import numpy as np
import pytest

from hugoniot.errors import HugoniotError, OutOfRange
from hugoniot.laws.eos import p_alpha, p_lambda, snow_plough
from hugoniot.laws.eos.contract import density_limits, elastic_limit, reference_state, remembered, unloading
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.riemann import jump, spreading
from hugoniot.laws.riemann.branch import Branch, Matter, State, elastic, loading, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve

SOLID = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)


def laws(kind, rng):
    """A random law over a random solid; the matrix of p_lambda is stiff beside its crush strength, as matrices are."""
    base = MieGruneisen(rng.uniform(1000, 19000), rng.uniform(1500, 6000), rng.uniform(1.1, 1.8), rng.uniform(0.5, 2.5), 863.0)
    stiff, distension = base.rho0 * base.c0**2, rng.uniform(1.02, 3.0)
    if kind == "p_alpha":
        closed = stiff * 10.0 ** rng.uniform(-3.5, -1.0)
        return p_alpha.build(base, distension, closed * rng.choice([0.0, rng.uniform(0.0, 0.9)]), closed), closed
    if kind == "snow_plough":
        crush = stiff * 10.0 ** rng.uniform(-5.0, -1.5) * (1.0 - 1.0 / distension)
        return snow_plough.build(base, base.rho0 / distension, crush), crush
    strength = stiff * 10.0 ** rng.uniform(-3.5, -2.0) * (distension - 1.0)
    exponent = 1.0 if kind == "n = 1" else rng.uniform(1.01, 2.0)
    return p_lambda.build(base, base.rho0 / distension, stiff * rng.uniform(0.3, 1.0), strength, exponent), strength


@pytest.mark.parametrize("kind", ["p_alpha", "snow_plough", "n = 1", "n > 1"])
def test_a_shock_that_closes_pores_is_faster_than_weaker_ones_and_than_no_sound_behind(kind):
    """Mass fluxes of the jumps from the elastic limit rise with the pressure; where n > 1, once the curve has turned."""
    rng = np.random.default_rng(7)
    for _ in range(25):
        law, scale = laws(kind, rng)
        k = float(rng.choice([0.0, rng.uniform(0.0, 0.99)]))
        crushed = remembered(k, law)
        rho, e = reference_state(crushed)
        rest, limit, path = State(rho, 0.0, e, 0.0, 0.0, k), elastic_limit(crushed), Branch(crushed)
        ahead = jump.behind(limit, rest, Branch(unloading(crushed)), 1)[0] if limit > 0.0 else rest
        square = spreading.loading_square(ahead, path)
        found = [jump.behind(ahead.sigma + scale * x, ahead, path, 1, None, square) for x in 10.0 ** np.linspace(-3.0, 1.5, 46)]
        fluxes = np.array([flux for _, flux in found])
        behind = np.array([after.rho * math.sqrt(wave_speed_squared(after.rho, after.e, path)) for after, _ in found])
        turn = int(np.argmin(fluxes)) if kind == "n > 1" else 0
        assert (np.diff(fluxes[turn:]) > -1e-7 * fluxes[turn:-1]).all()
        assert (np.diff(fluxes[:turn + 1]) < 0.0).all()
        beyond = turn + (turn > 0)      # the least flux lies between two of the samples
        assert (behind[beyond:] >= fluxes[beyond:] * (1.0 - 1e-6)).all()
        assert turn or fluxes[0] >= ahead.rho * math.sqrt(square) * (1.0 - 1e-6)


def test_a_matrix_that_gives_way_before_its_pores_do_is_told():
    """Softer than its crush strength, it would be compacted to something less dense."""
    law = p_lambda.build(SOLID, 2481.0, 7.7e8, 9.3e7, 1.0)
    with pytest.raises(OutOfRange, match="matrix_modulus"):
        Curve(Matter(law), State(2481.0, 0.0, 0.0, 0.0), 1).waves(3.5e8)


@pytest.mark.parametrize("law", [p_alpha.build(SOLID, 1.275, 0.08e9, 0.7e9), snow_plough.build(SOLID, 2100.0, 0.2e9),
                                 p_lambda.build(SOLID, 2100.0, 25e9, 0.4e9, 1.0)], ids=["p_alpha", "snow_plough", "p_lambda"])
def test_kernels_and_python_have_the_same_waves(law):
    """Release, precursor, both waves, one shock: from rest and from partly crushed states."""
    from hugoniot.laws.riemann.medium import Porous, porous_answer
    from hugoniot.laws.riemann.porous import porous_waves
    from hugoniot.laws.riemann.wave import Side, sound_squared

    rng = np.random.default_rng(3)
    checked = 0
    for _ in range(60):
        k = float(rng.choice([0.0, rng.uniform(0.0, 0.95)]))
        rho, e = reference_state(remembered(k, law))
        rho, e = rho * (1.0 + rng.uniform(-1e-4, 3e-4)), e + rng.uniform(0.0, 100.0)
        p, p_rho, p_e = porous_answer(rho, e, 0.0, 0.0, k, Porous(law))
        k = float(spreading.crushed(State(rho, 0.0, e, p, 0.0, k), law).compaction)
        target = rng.choice([p - rng.uniform(0.0, 2e7), p + rng.uniform(0.0, 5e8), rng.uniform(1e9, 6e10)])
        limit = density_limits(law)[1]
        try:
            found = Curve(Matter(law), State(rho, 0.0, e, p, 0.0, k), 1).waves(target)
        except HugoniotError:
            continue
        side = Side(rho, e, p, sound_squared(rho, p, p_rho, p_e), 0.0, 0.0, k, limit, limit, limit)
        ours, first = porous_waves(target, side, Porous(law))
        last = found[-1].behind
        within = 1e-5 if "matrix_modulus" in law._fields and target < 0.0 else 1e-9      # the slope of c leaps where its matrix is unloaded
        assert (ours.rise, ours.rho, ours.e) == pytest.approx((last.u, last.rho, last.e), rel=within, abs=1e-12)
        assert ours.energy == pytest.approx(last.compaction, rel=1e-9, abs=1e-12)
        assert (first.flux > 0.0) == (len(found) == 2)
        checked += 1
    assert checked > 40


def test_the_elastic_branch_has_the_compaction_of_its_state():
    law = p_alpha.build(SOLID, 1.275, 0.08e9, 0.7e9)
    state = State(2400.0, 0.0, 1e3, 0.0, 0.0, 0.4)
    assert elastic(Matter(law), state).par == unloading(remembered(0.4, law))
    assert loading(Matter(law), state).par == remembered(0.4, law)
    assert elastic(Matter(SOLID), state).par == SOLID
