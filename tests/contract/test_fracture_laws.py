"""What every fracture law owes, and the failure point of each."""

import numpy as np
import pytest

import hugoniot.laws.fracture  # noqa: F401  (enrols the laws)
from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture import contract
from hugoniot.laws.fracture.contract import FRACTURE

LAWS = list(FRACTURE)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_compression_never_breaks_and_more_tension_never_heals(law):
    par = law.example
    random = np.random.default_rng(3)
    for _ in range(50):
        tension, v = random.uniform(0.0, 5e9), random.uniform(0.5, 1.5)
        assert contract.failure(-tension, tension, v, 0.0, par) < 1.0
        assert contract.damage_rate(-tension, par) == 0.0
        assert contract.failure(1.1 * tension, -1.1 * tension, v, 0.3, par) >= contract.failure(tension, -tension, v, 0.3, par)
        assert contract.damage_rate(1.1 * tension, par) >= contract.damage_rate(tension, par)
        assert contract.tension_cap(0.0, par) > 0.0


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_compiled_equals_python(law):
    numba = pytest.importorskip("numba")
    from hugoniot.core import binder

    binder.bind_family(FRACTURE, contract.GENERICS)
    binder.bind_module(contract)
    fail, rate, cap = contract.failure, contract.damage_rate, contract.tension_cap

    @numba.njit(error_model="numpy")
    def all_three(tension, p, v, damage, par):
        return fail(tension, p, v, damage, par), rate(tension, par), cap(0.01, par)

    for tension in (-2e9, 0.0, 0.4e9, 0.9e9, 3e9):
        point = tension, -0.9 * tension, 1.02, 0.4
        expected = fail(*point, law.example), rate(tension, law.example), cap(0.01, law.example)
        assert all_three(*point, law.example) == pytest.approx(expected, rel=1e-13)


def test_spall_stress_fails_at_its_strength():
    par = FRACTURE.get("spall_stress").build(strength=1.2e9)
    assert contract.failure(1.2e9, 0.0, 1.0, 0.0, par) == 1.0
    assert contract.failure(1.19e9, 0.0, 1.0, 0.0, par) < 1.0
    assert contract.tension_cap(0.0, par) == 1.2e9
    assert contract.tension_cap(0.05, par) == pytest.approx(0.6e9)
    assert contract.tension_cap(0.2, par) == 0.0
    with pytest.raises(OutOfRange, match="positive"):
        FRACTURE.get("spall_stress").build(strength=-1.0)


def test_pressure_volume_needs_both_conditions():
    par = FRACTURE.get("pressure_volume").build(pressure_limit=-1e9, volume_limit=1.02)
    assert contract.failure(0.0, -1.01e9, 1.021, 0.0, par) > 1.0
    assert contract.failure(0.0, -1.01e9, 1.019, 0.0, par) < 1.0
    assert contract.failure(0.0, -0.99e9, 1.021, 0.0, par) < 1.0
    with pytest.raises(OutOfRange, match="negative"):
        FRACTURE.get("pressure_volume").build(pressure_limit=1e9)


def test_tuler_butcher_breaks_when_the_literature_integral_reaches_its_constant():
    par = FRACTURE.get("tuler_butcher").build(threshold=0.5e9, exponent=1.7, reference_stress=0.8e9, critical_time=0.3e-6)
    constant = 0.8e9**1.7 * 0.3e-6
    times = np.linspace(0.0, 1e-6, 20001)
    tension = 2.0e9 * np.sin(np.pi * times / 1e-6)
    rates = np.array([contract.damage_rate(s, par) for s in tension])
    damage = np.concatenate([[0.0], np.cumsum(0.5 * (rates[1:] + rates[:-1]) * np.diff(times))])
    excess = np.maximum(tension - 0.5e9, 0.0) ** 1.7
    integral = np.concatenate([[0.0], np.cumsum(0.5 * (excess[1:] + excess[:-1]) * np.diff(times))])
    at = np.searchsorted(integral, constant)
    assert 0 < at < len(times) - 1
    assert damage[at - 1] < 1.0 <= damage[at] * (1 + 1e-12)
    assert contract.failure(2e9, -2e9, 1.05, damage[at], par) == damage[at]
    assert contract.damage_rate(0.5e9, par) == 0.0
