"""The march along an isentrope against closed forms."""

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.mixture.isentrope import integrated_energy, is_linear, isentrope_energy, marched_energy, stride
from hugoniot.theory.isentrope import isentrope
from hugoniot.theory.states import States

UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, 1895.0, 0.0, 1312.4)


def jwl_energy(v0, e0, v1, par):
    """Starkenberg A-9.2, with the greatest cold tension kept beyond its volume."""
    torn = np.log(-par.a * par.r1 / (par.b * par.r2)) / (par.r1 - par.r2)

    def h(v):
        x = min(v * par.rho0, torn)
        first, second = par.a * np.exp(-par.r1 * x), par.b * np.exp(-par.r2 * x)
        return (first / par.r1 + second / par.r2 - (first + second) * (v * par.rho0 - x)) / par.rho0
    return h(v1) + (e0 - h(v0)) * (v0 / v1) ** par.omega


@pytest.mark.parametrize("ratio", (1.0 + 5e-7, 1.0 - 9e-5, 1.012, 0.6, 1.7, 5.0))
def test_march_meets_closed_forms(ratio):
    gas = IdealGas(5.0)
    assert marched_energy(1.0, 1.0, ratio, gas) == pytest.approx(ratio**-4.0, rel=2e-10)
    stiff = StiffenedGas(4.4, 2.0e9, 1000.0, 1400.0)
    v0, e0 = 1e-3, 3e6
    # de = -p dv with p + p_inf = (gamma - 1) rho (e - p_inf v): e - p_inf v falls as v^(1 - gamma)
    expected = (e0 - 2.0e9 * v0) * ratio**-3.4 + 2.0e9 * v0 * ratio
    assert marched_energy(v0, e0, v0 * ratio, stiff) == pytest.approx(expected, rel=2e-10)
    v0, e0 = 1.0 / 2500.0, 1.2e6
    kink = 2e-10 if ratio < 1.5 else 4e-9     # where the cold tension is greatest its second derivative jumps
    assert marched_energy(v0, e0, v0 * ratio, UNREACTED) == pytest.approx(jwl_energy(v0, e0, v0 * ratio, UNREACTED), rel=kink, abs=1e-4)
    assert isentrope_energy(v0, e0, v0 * ratio, UNREACTED) == pytest.approx(jwl_energy(v0, e0, v0 * ratio, UNREACTED), rel=1e-14)


def test_stride_is_of_sixth_order():
    gas = IdealGas(5.0)
    errors = []
    for n in (4, 8, 16):
        v, e, h = 1.0, 1.0, -0.4 / n
        for _ in range(n):
            e, v = stride(v, e, h, gas), v + h
        errors.append(abs(e * 0.6**4 - 1.0))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders[0] > 5.3 and 5.6 < orders[1] < 6.6


def test_march_returns_to_where_it_came_from():
    there = marched_energy(1.0 / 2500.0, 1.2e6, 1.0 / 1800.0, UNREACTED)
    assert marched_energy(1.0 / 1800.0, there, 1.0 / 2500.0, UNREACTED) == pytest.approx(1.2e6, rel=1e-10)


@pytest.mark.parametrize("name", [law.name for law in EOS if is_linear(law.example)])
def test_integral_of_laws_linear_in_energy_meets_the_extrapolated_integrator(name):
    """Through the density at rest, near it, and up to 3 % of volume from the pole of the Hugoniot."""
    par = EOS.get(name).example
    rest, e_rest = contract.reference_state(par)
    most = min(0.97 * contract.density_limits(par)[1] / rest, 1.8)
    energy = e_rest + 2e5 if e_rest < 1e6 else 1.2 * e_rest
    for x0, x1 in ((1.0, 1.15), (1.3, 1.05), (1.1, 0.95), (0.97, 1.2), (1.0, 1.012), (1.05, most), (most, 1.02)):
        way = isentrope(par, States(par, x0 * rest, contract.pressure(x0 * rest, energy, par), energy, 0.0), density=x1 * rest)
        found = integrated_energy(1.0 / (x0 * rest), energy, 1.0 / (x1 * rest), par)
        assert abs(found - way.specific_internal_energy) < 2e-12 * abs(way.specific_internal_energy - energy)
