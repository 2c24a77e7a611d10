"""What every artificial viscosity owes, and the printed forms."""

import math

import numpy as np
import pytest

import hugoniot.laws.viscosity  # noqa: F401  (enrols the laws)
from hugoniot.laws.viscosity import contract
from hugoniot.laws.viscosity.contract import VISCOSITY

LAWS = list(VISCOSITY)


def q(rho, c, p, du, psi, par):
    return rho * abs(du) * contract.viscous_speed(1.0 / rho, c, p, du, psi, par)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_signal_speed_is_never_negative_and_grows_with_the_jump(law):
    random = np.random.default_rng(5)
    for _ in range(100):
        v, c, p, du, psi = (random.uniform(*law.box[name]) for name in ("v", "c", "p", "du", "psi"))
        speed = contract.viscous_speed(v, c, p, du, psi, law.example)
        assert speed >= 0.0
        assert contract.viscous_speed(v, c, p, 1.1 * du, psi, law.example) >= speed
        assert q(1.0 / v, c, p, 0.0, psi, law.example) == 0.0


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_only_limited_laws_see_smoothness_and_vanish_in_linear_flow(law):
    rough = contract.viscous_speed(1.0 / 2000.0, 5000.0, 1e9, -100.0, 0.0, law.example)
    smooth = contract.viscous_speed(1.0 / 2000.0, 5000.0, 1e9, -100.0, 1.0, law.example)
    assert rough > 0.0
    assert smooth == (0.0 if "limited" in law.flags else rough)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_compiled_equals_python(law):
    numba = pytest.importorskip("numba")
    from hugoniot.core import binder

    binder.bind_family(VISCOSITY, contract.GENERICS)
    binder.bind_module(contract)
    speed = contract.viscous_speed

    @numba.njit(error_model="numpy")
    def compiled(rho, c, p, du, psi, par):
        return speed(rho, c, p, du, psi, par)

    for p in (-1e9, 0.0, 3e9):
        point = 2700.0, 5300.0, p, -321.0, 0.25
        assert compiled(*point, law.example) == pytest.approx(speed(*point, law.example), rel=1e-14)


def test_printed_forms():
    rho, c, p, du = 2700.0, 5300.0, 4e9, -210.0
    wilkins = 4.0 * rho * du**2 + 1.0 * math.sqrt(p / rho) * rho * abs(du)
    assert q(rho, c, p, du, 0.0, VISCOSITY.get("wilkins").build()) == pytest.approx(wilkins, rel=1e-14)
    assert q(rho, c, -p, du, 0.0, VISCOSITY.get("wilkins").build()) == pytest.approx(4.0 * rho * du**2, rel=1e-14)
    true = 1.96 * rho * du**2 + 0.3 * rho * c * abs(du)
    assert q(rho, c, p, du, 0.0, VISCOSITY.get("landshoff").build()) == pytest.approx(true, rel=1e-14)
    assert q(rho, c, p, du, 0.0, VISCOSITY.get("kb").build(quadratic=1.3)) == pytest.approx(1.3 * rho * du**2, rel=1e-14)
    # Herrmann's own variables: mesh size and rate of compression
    dx, rate = 1e-5, 210.0 / 1e-5
    herrmann = rho * (0.2 * dx * c * rate + (1.1 * dx * rate) ** 2)
    assert q(rho, c, p, du, 0.0, VISCOSITY.get("herrmann").build(quadratic=1.1, linear=0.2)) == pytest.approx(herrmann, rel=1e-14)


@pytest.mark.parametrize("gamma", [1.2, 1.4, 5.0 / 3.0, 3.0])
def test_kuropatenko_is_the_exact_pressure_jump_of_an_ideal_gas_shock(gamma):
    rho, p, du = 1.3, 2.0e5, -700.0
    c = math.sqrt(gamma * p / rho)
    jump = q(rho, c, p, du, 0.0, VISCOSITY.get("limited").build(quadratic=(gamma + 1) / 4, linear=1.0))
    behind = p + jump
    # the shock with that pressure ratio has, by the Rankine-Hugoniot relations, this velocity jump
    mu = (gamma - 1) / (gamma + 1)
    velocity = (behind - p) * math.sqrt((1 - mu) / (rho * (behind + mu * p)))
    assert velocity == pytest.approx(-du, rel=1e-12)


def test_only_the_printed_form_of_the_kb_codes_acts_in_expansion():
    assert [law.name for law in LAWS if "two_sided" in law.flags] == ["kb_two_sided"]
    assert q(2700.0, 5300.0, 1e9, 210.0, 0.0, VISCOSITY.get("kb_two_sided").example) == pytest.approx(2700.0 * 210.0**2, rel=1e-14)
