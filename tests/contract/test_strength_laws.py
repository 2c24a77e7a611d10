"""What every strength law owes, and published or independently computed values of each."""

import math

import numpy as np
import pytest

import hugoniot.laws.strength  # noqa: F401  (enrols the laws)
from hugoniot.errors import OutOfRange
from hugoniot.laws.strength import contract
from hugoniot.laws.strength.contract import STRENGTH

LAWS = list(STRENGTH)
SHEAR = ("rho", "p", "temperature", "bulk_modulus")
FLOW = ("rho", "p", "temperature", "plastic_strain", "strain_rate")


def samples(law, names, count=60):
    random = np.random.default_rng(7)
    for _ in range(count):
        yield [random.uniform(*law.box[name]) for name in names]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_nothing_is_negative_or_undefined_inside_the_box(law):
    for point in samples(law, SHEAR):
        assert 0.0 <= contract.shear_modulus(*point, law.example) < 1e13
    for point in samples(law, FLOW):
        assert 0.0 <= contract.flow_stress(*point, law.example) < 1e11


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_hardening_never_softens(law):
    for rho, p, temperature, strain, rate in samples(law, FLOW):
        low = contract.flow_stress(rho, p, temperature, strain, rate, law.example)
        assert contract.flow_stress(rho, p, temperature, strain + 0.1, rate, law.example) >= low
        assert ("hardens" in law.flags) or contract.flow_stress(rho, p, temperature, 0.0, rate, law.example) == low


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_only_flagged_laws_depend_on_temperature_and_rate(law):
    changed = {"temperature": False, "rate": False}
    for rho, p, temperature, strain, rate in samples(law, FLOW):
        base = contract.flow_stress(rho, p, temperature, strain, rate, law.example)
        changed["temperature"] |= contract.flow_stress(rho, p, 0.5 * temperature, strain, rate, law.example) != base
        changed["rate"] |= contract.flow_stress(rho, p, temperature, strain, 1e-3 * rate, law.example) != base
    assert changed["temperature"] == ("needs_temperature" in law.flags)
    assert changed["rate"] == ("needs_rate" in law.flags)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_compiled_equals_python(law):
    numba = pytest.importorskip("numba")
    from hugoniot.core import binder

    binder.bind_family(STRENGTH, contract.GENERICS)
    binder.bind_module(contract)
    shear, flow = contract.shear_modulus, contract.flow_stress

    @numba.njit(error_model="numpy")
    def both(rho, p, temperature, bulk_modulus, strain, rate, par):
        return shear(rho, p, temperature, bulk_modulus, par), flow(rho, p, temperature, strain, rate, par)

    for point in samples(law, (*SHEAR, "plastic_strain", "strain_rate"), 20):
        rho, p, temperature, bulk, strain, rate = point
        expected = shear(rho, p, temperature, bulk, law.example), flow(rho, p, temperature, strain, rate, law.example)
        assert both(*point, law.example) == pytest.approx(expected, rel=1e-13, abs=1e-3)


def test_constant_poisson_keeps_the_ratio_of_the_wave_speeds():
    for nu in (0.0, 0.25, 1.0 / 3.0, 0.45):
        par = STRENGTH.get("constant_poisson").build(nu, 1e8)
        shear = contract.shear_modulus(1.0, 0.0, 0.0, 80e9, par)
        assert (80e9 + 4.0 / 3.0 * shear) / 80e9 == pytest.approx(3.0 * (1.0 - nu) / (1.0 + nu), rel=1e-14)
        assert (3 * 80e9 - 2 * shear) / (2 * (3 * 80e9 + shear)) == pytest.approx(nu, abs=1e-15)
    with pytest.raises(OutOfRange, match="poisson_ratio"):
        STRENGTH.get("constant_poisson").build(0.6, 1e8)


def test_herrmann_aluminium_gives_the_printed_poisson_ratio_and_wave_speed():
    par = STRENGTH.get("herrmann").example
    shear = contract.shear_modulus(2780.0, 0.0, 0.0, 0.0, par)
    bulk = 76.4e9
    assert (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)) == pytest.approx(0.3336, abs=5e-5)
    assert math.sqrt((bulk + 4 * shear / 3) / 2780.0) == pytest.approx(6419.0, abs=0.5)
    # his eta is (rho - rho0)/rho: a fifth at rho = 1.25 rho0
    assert contract.shear_modulus(1.25 * 2780.0, 0.0, 0.0, 0.0, par) == pytest.approx(28.6e9 * (1 + 0.2 * 5.86 + 0.04 * 8.44), rel=1e-13)


def test_steinberg_guinan_6061_aluminium():
    par = STRENGTH.get("steinberg_guinan").example
    assert contract.shear_modulus(2703.0, 0.0, 300.0, 0.0, par) == pytest.approx(27.6e9, rel=1e-15)
    assert contract.flow_stress(2703.0, 0.0, 300.0, 0.0, 0.0, par) == pytest.approx(0.29e9, rel=1e-14)
    # 20 GPa, 600 K, eta = 1.2, eps = 0.05: the factor is 1 + 65.2e-3/GPa 20/1.2^(1/3) - 6.16e-4 300
    factor = 1.0 + 0.0652 * 20.0 / 1.2 ** (1.0 / 3.0) - 6.16e-4 * 300.0
    assert contract.shear_modulus(1.2 * 2703.0, 20e9, 600.0, 0.0, par) == pytest.approx(27.6e9 * factor, rel=1e-13)
    assert contract.flow_stress(1.2 * 2703.0, 20e9, 600.0, 0.05, 0.0, par) == pytest.approx(0.29e9 * 7.25**0.1 * factor, rel=1e-13)
    assert contract.flow_stress(2703.0, 0.0, 300.0, 1e3, 0.0, par) == pytest.approx(0.68e9, rel=1e-14)
    melt = 1220.0 * math.exp(3.0 * (1 - 1 / 1.2)) * 1.2 ** (2 * (1.97 - 1.5 - 1 / 3))
    assert contract.flow_stress(1.2 * 2703.0, 20e9, melt * 0.9999, 0.0, 0.0, par) > 0.0
    assert contract.flow_stress(1.2 * 2703.0, 20e9, melt * 1.0001, 0.0, 0.0, par) == 0.0
    assert contract.shear_modulus(1.2 * 2703.0, 20e9, melt * 1.0001, 0.0, par) == 0.0
    kept = par._replace(melt_shear_fraction=0.1)
    assert contract.shear_modulus(1.2 * 2703.0, 20e9, melt * 1.0001, 0.0, kept) == pytest.approx(2.76e9, rel=1e-14)


def test_johnson_cook_copper():
    par = STRENGTH.get("johnson_cook").example
    expected = (90e6 + 292e6 * 0.3**0.31) * (1 + 0.025 * math.log(1e4)) * (1 - (206.0 / 1062.0) ** 1.09)
    assert contract.flow_stress(8960.0, 0.0, 500.0, 0.3, 1e4, par) == pytest.approx(expected, rel=1e-13)
    assert expected == pytest.approx(298e6, rel=2e-3)
    assert contract.flow_stress(8960.0, 0.0, 200.0, 0.0, 0.0, par) == 90e6
    assert contract.flow_stress(8960.0, 0.0, 1356.0, 0.3, 1e4, par) == 0.0
    with pytest.raises(OutOfRange, match="melt_temperature"):
        STRENGTH.get("johnson_cook").build(**(par._asdict() | {"melt_temperature": 200.0}))


def test_linear_hardening_and_its_ceiling():
    law = STRENGTH.get("linear_hardening")
    open_ended = law.build(shear_modulus=43.3e9, yield_stress=0.4e9, hardening_modulus=0.1e9)
    assert contract.flow_stress(8930.0, 0.0, 0.0, 2.5, 0.0, open_ended) == pytest.approx(0.65e9, rel=1e-15)
    assert contract.flow_stress(8930.0, 0.0, 0.0, 50.0, 0.0, law.example) == 0.7e9
