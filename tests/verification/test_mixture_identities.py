"""Mixtures against independent differentiation, entropy and the conservation laws: Starkenberg ARL-TR-2161 sections 5.1 to 5.9, appendix B."""

import numpy as np
import pytest
from mixture_states import KINDS, PAIRS, PRODUCTS, RHO0, UNREACTED, Q, derivative, shocked, states

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.theory import mixture as tool


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_phases_meet_the_mixture_equations(pair, kind):
    par, v, e, lam, reference = states(pair, kind, 200)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    scale = s.density * s.sound_speed**2
    for j in range(len(v)):
        p_r = eos.pressure(s.reactant_density[j], s.reactant_energy[j] - Q, par.reactants)
        p_p = eos.pressure(s.product_density[j], s.product_energy[j], par.products)
        assert abs(p_r - s.pressure[j]) < 1e-12 * scale[j]
        assert abs(p_p - s.pressure[j]) < 1e-12 * scale[j]
    assert np.allclose((1 - lam) / s.reactant_density + lam / s.product_density, v, rtol=1e-14, atol=0)
    assert np.allclose((1 - lam) * s.reactant_energy + lam * s.product_energy, e, rtol=1e-14, atol=0)
    if kind == "thermal_isolation":
        entropy = [eos.entropy(r, x - Q, par.reactants) for r, x in zip(s.reactant_density, s.reactant_energy)]
        reference_entropy = eos.entropy(reference[0], reference[1] - Q, par.reactants)
        assert np.allclose(entropy, reference_entropy, rtol=0, atol=1e-13 * eos.specific_heat(2500.0, 1e6, par.reactants))
    else:
        t_r = [eos.temperature(r, x - Q, par.reactants) for r, x in zip(s.reactant_density, s.reactant_energy)]
        assert np.allclose(t_r, s.temperature, rtol=1e-12)
        assert np.allclose([eos.temperature(r, x, par.products) for r, x in zip(s.product_density, s.product_energy)], t_r, rtol=1e-11)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_slopes_equal_differences(pair, kind):
    """p_v, p_e, p_lambda and the twelve phase slopes to 1e-9 (S-E13 corrected), each relative to its size in the state."""
    par, v, e, lam, reference = states(pair, kind)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    twelve = s.phase_slopes()

    def fields(v, e, lam):
        x = tool.solve(1.0 / v, e, lam, par, reference)
        return np.array([x.pressure, 1.0 / x.reactant_density, x.reactant_energy, 1.0 / x.product_density, x.product_energy])

    for name, found in (("v", derivative(lambda x: fields(x, e, lam), v, 4e-4 * v)),
                        ("e", derivative(lambda x: fields(v, x, lam), e, 1e-3 * e)),
                        ("l", derivative(lambda x: fields(v, e, x), lam, 4e-3 * np.minimum(lam, 1 - lam)))):
        word = {"v": "volume", "e": "energy", "l": "burn_fraction"}[name]
        expected = [getattr(s, f"pressure_by_{word}")] + [getattr(twelve, f"{x}_{name}") for x in ("v_r", "e_r", "v_p", "e_p")]
        natural = np.abs(fields(v, e, lam)) / {"v": v, "e": e, "l": 1.0}[name]
        for got, want, scale in zip(expected, found, natural):
            assert np.all(np.abs(got - want) <= 1e-9 * (np.abs(want) + scale))


@pytest.mark.parametrize("pair", ("two gases", "jwl, jwl", "stiffened gas, gas"))
def test_slopes_equal_complex_steps_of_the_entropy_form(pair):
    """The same system written with the reactant's entropy, differentiated by complex steps: shares no isentrope march and no formula."""
    par, v, e, lam, reference = states(pair, "thermal_isolation", 6, seed=3)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    twelve = s.phase_slopes()
    s_k = eos.entropy(reference[0], reference[1] - Q, par.reactants)

    def residual(x, given):
        v_r, e_r, v_p, e_p = x
        vol, en, frac = given
        return np.array([(1 - frac) * v_r + frac * v_p - vol, (1 - frac) * e_r + frac * e_p - en,
                         eos.pressure(1 / v_r, e_r - Q, par.reactants) - eos.pressure(1 / v_p, e_p, par.products),
                         eos.entropy(1 / v_r, e_r - Q, par.reactants) - s_k])

    def jacobian(function, x):
        columns = []
        for k in range(len(x)):
            z = np.array(x, complex)
            z[k] += 1j * 1e-30 * abs(x[k])
            columns.append(function(z).imag / (1e-30 * abs(x[k])))
        return np.array(columns).T

    for j in range(len(v)):
        x = (1 / s.reactant_density[j], s.reactant_energy[j], 1 / s.product_density[j], s.product_energy[j])
        given = (v[j], e[j], lam[j])
        inner, outer = jacobian(lambda z, g=given: residual(z, g), x), jacobian(lambda z, y=x: residual(y, z), given)
        scale = np.array(x)
        slope = -np.linalg.solve(inner * scale / np.abs(inner * scale).max(axis=1)[:, None], outer / np.abs(inner * scale).max(axis=1)[:, None])
        slope = slope * scale[:, None]
        for column, name in enumerate("vel"):
            got = np.array([getattr(twelve, f"{f}_{name}")[j] for f in ("v_r", "e_r", "v_p", "e_p")])
            assert np.allclose(got, slope[:, column], rtol=2e-10, atol=1e-10 * np.max(np.abs(slope[:, column] / scale)) * scale.min())


@pytest.mark.parametrize("pair", PAIRS)
def test_printed_product_energy_slopes_are_wrong(pair):
    """S-E13: the three slopes of e_p as printed in appendix B miss the differences that the corrected ones meet to 1e-9."""
    par, v, e, lam, reference = states(pair, "thermal_isolation", 6, seed=9)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    good = s.phase_slopes()
    for j in range(len(v)):
        i_r = contract.impedance_squared(s.reactant_density[j], s.reactant_energy[j] - Q, par.reactants)
        p_v, p_e = contract.volume_slopes(s.product_density[j], s.product_energy[j], par.products)
        p, f = s.pressure[j], lam[j]
        whole = f * i_r + (1 - f) * (p * p_e - p_v)
        w, z = 1 / s.reactant_density[j] - 1 / s.product_density[j], s.reactant_energy[j] - s.product_energy[j]
        printed = (-(1 - f) * p * p_e / (f * whole), -(1 - f) * p_e / (f * whole),
                   (-w * (1 - f) * p * p_v - z * ((1 - f) * p_v + f * i_r)) / (f * whole))
        corrected = (-(1 - f) * p * p_v / (f * whole), -(1 - f) * p_v / (f * whole) + i_r / whole,
                     (-w * (1 - f) * p * p_v - z * ((1 - f) * p_v - f * i_r)) / (f * whole))
        for got, right, wrong in zip((good.e_p_v[j], good.e_p_e[j], good.e_p_l[j]), corrected, printed):
            assert got == pytest.approx(right, rel=1e-11)
            assert abs(wrong / right - 1.0) > 1e-2


@pytest.mark.parametrize("pair", PAIRS)
def test_sound_speed_gruneisen_and_exponent_saturate(pair):
    """Starkenberg sections 5.4 and 5.5: 1/i^2, (v/c)^2 and v/gamma are sums over the phases; Gamma = gamma/gamma_p Gamma_p."""
    par, v, e, lam, reference = states(pair, "thermal_isolation", 50)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    i_r = np.array([contract.impedance_squared(r, x - Q, par.reactants) for r, x in zip(s.reactant_density, s.reactant_energy)])
    i_p = np.array([contract.impedance_squared(r, x, par.products) for r, x in zip(s.product_density, s.product_energy)])
    assert np.allclose(1 / s.impedance_squared, (1 - lam) / i_r + lam / i_p, rtol=1e-11)
    gamma_r, gamma_p = i_r / (s.reactant_density * s.pressure), i_p / (s.product_density * s.pressure)
    eta = s.volume_fraction
    assert np.allclose(s.adiabatic_exponent, gamma_r * gamma_p / ((1 - eta) * gamma_p + eta * gamma_r), rtol=1e-11)
    gruneisen_p = np.array([eos.gruneisen(r, x, par.products) for r, x in zip(s.product_density, s.product_energy)])
    assert np.allclose(s.gruneisen, s.adiabatic_exponent / gamma_p * gruneisen_p, rtol=1e-11)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_specific_heat_is_the_slope_of_energy_by_temperature(pair, kind):
    par, v, e, lam, reference = states(pair, kind, 8)
    s = tool.solve(1.0 / v, e, lam, par, reference)
    rise = derivative(lambda x: tool.solve(1.0 / v, x, lam, par, reference).temperature, e, 1e-3 * e)
    assert np.allclose(s.specific_heat, 1.0 / rise, rtol=1e-9)


def test_two_gases_in_thermal_equilibrium_have_a_closed_form():
    """p v = e_thermal-like sum: T = (e - (1-lambda) Q) / sum(c_v), p = T sum((gamma-1) c_v) / v."""
    par, v, e, lam, _ = states("two gases", "thermal_equilibrium", 100)
    r, p = par.reactants, par.products
    t = (e - (1 - lam) * Q) / ((1 - lam) * r.specific_heat + lam * p.specific_heat)
    expected = t / v * ((1 - lam) * (r.gamma - 1) * r.specific_heat + lam * (p.gamma - 1) * p.specific_heat)
    s = tool.solve(1.0 / v, e, lam, par)
    assert np.allclose(s.pressure, expected, rtol=1e-13)
    assert np.allclose(s.temperature, t, rtol=1e-13)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_pressure_and_sound_speed_are_continuous_at_both_ends(pair, kind):
    """Values approach those of the pure phases linearly in lambda and 1 - lambda, across the switch of formulas near lambda = 1e-6."""
    par = tool.mixture(kind, *PAIRS[pair], Q)
    rho, e_th = shocked(par.reactants)
    e, reference = e_th + Q, (rho, e_th + Q)
    ends = ((0.0, eos.pressure(rho, e - Q, par.reactants), eos.sound_speed(rho, e - Q, par.reactants), 1.0),
            (1.0, eos.pressure(rho, e, par.products), eos.sound_speed(rho, e, par.products), -1.0))
    for end, p, c, sign in ends:
        small = np.array([1e-3, 1e-4, 1e-5, 2e-6, 5e-7, 1e-8])
        s = tool.solve(rho, e, end + sign * small, par, reference)
        exact = tool.solve(rho, e, end, par, reference)
        assert abs(exact.pressure - p) <= 1e-12 * p and abs(exact.sound_speed - c) <= 1e-9 * c
        for value, limit in ((s.pressure, p), (s.sound_speed, c)):
            ratio = (value / limit - 1.0) / small
            assert np.allclose(ratio, ratio[2], rtol=3e-2, atol=1e-6 / small * 1e-3)
            assert np.max(np.abs(ratio)) < 20.0


@pytest.mark.parametrize("pair", PAIRS)
def test_gruneisen_and_temperature_jump_where_burning_begins_and_only_there(pair):
    """The source leaves this open (5.5, 5.6): the limit lambda -> 0 gives all heat to the products, so Gamma does not join the reactant's."""
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho, e_th = shocked(par.reactants)
    s = tool.solve(rho, e_th + Q, [1e-7, 1e-5, 1.0 - 1e-7], par, (rho, e_th + Q))
    own = eos.gruneisen(rho, e_th, par.reactants)
    assert abs(s.gruneisen[0] / s.gruneisen[1] - 1.0) < 1e-3
    assert abs(s.gruneisen[0] / own - 1.0) > 0.03
    assert abs(s.gruneisen[2] / eos.gruneisen(rho, e_th + Q, par.products) - 1.0) < 1e-5
    assert abs(s.temperature[2] / eos.temperature(rho, e_th + Q, par.products) - 1.0) < 1e-5


@pytest.mark.parametrize("pair", PAIRS)
def test_vanishing_series_is_the_limit_of_the_solution(pair):
    """S-E3: slopes of the nascent products against differences; the printed forms miss by far more than the tolerance."""
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho, e_th = shocked(par.reactants)
    e = e_th + Q
    series = tool.vanishing_series(rho, e, par)
    lam = 1e-3 * np.array([1.0, 2.0, 3.0, 4.0])
    s = tool.solve(rho, e, lam, par, (rho, e))
    for x, (x0, x1) in ((1.0 / s.product_density, series.v_p), (s.product_energy, series.e_p)):
        # fit through x0 of the cubic remainder: x = x0 + x1 l + a l^2 + b l^3 + c l^4
        slope = np.linalg.solve(np.vander(lam, 4, increasing=True), (x - x0) / lam)[0]
        assert slope == pytest.approx(x1, rel=1e-6)
    for x, c in ((1.0 / s.reactant_density, series.v_r), (s.reactant_energy, series.e_r)):
        curve = np.linalg.solve(np.vander(lam, 4, increasing=True), (x - c[0] - c[1] * lam) / lam**2)[0]
        assert curve == pytest.approx(c[2], rel=1e-5)
    v, v_p0, e_p0 = 1.0 / rho, series.v_p[0], series.e_p[0]
    p = eos.pressure(rho, e_th, par.reactants)
    p0 = -contract.impedance_squared(rho, e_th, par.reactants) * (v - v_p0)
    p_v, p_e = contract.volume_slopes(1.0 / v_p0, e_p0, par.products)
    printed = (((v - v_p0) * (p - 0.5 * p0) + e - e_p0) * p_e - p0) / (p * p_e - p_v)
    assert abs(printed / series.v_p[1] - 1.0) > 0.02
    assert 0.5 * p0 * (v - v_p0) == pytest.approx((v - v_p0) * (p + 0.5 * p0) + e - e_p0, rel=1e-6)


@pytest.mark.parametrize("pair", PAIRS)
def test_frozen_adiabat_keeps_both_entropies(pair):
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho, e_th = shocked(par.reactants)
    start = tool.solve(rho, e_th + Q, 0.4, par, (rho, e_th + Q))
    path = tool.adiabat(start, np.linspace(1.0 / rho, 1.5 / rho, 6))
    s_p = np.array([eos.entropy(r, x, par.products) for r, x in zip(path.product_density, path.product_energy)])
    assert np.allclose(s_p, s_p[0], rtol=0, atol=1e-9 * par.products.specific_heat)
    v = 1.0 / path.density
    middle = tool.adiabat(start, [v[0], v[2], 0.5 * (v[2] + v[3])])
    h = 1e-4 * v[2]
    trio = tool.adiabat(start, [v[2] - h, v[2], v[2] + h])
    assert -(trio.pressure[2] - trio.pressure[0]) / (2 * h) == pytest.approx(middle.impedance_squared[1], rel=1e-6)


def test_reacting_adiabat_conserves_energy_and_makes_entropy():
    par = tool.mixture("thermal_isolation", *PAIRS["jwl, jwl"], Q)
    rho, e_th = shocked(par.reactants)
    start = tool.solve(rho, e_th + Q, 0.1, par, (rho, e_th + Q))
    v0 = 1.0 / rho
    volumes = np.linspace(v0, 1.3 * v0, 199)
    path = tool.adiabat(start, volumes, lambda v: 0.1 + 2.0 * (v / v0 - 1.0))
    work = np.trapezoid(path.pressure, volumes)
    assert path.energy[-1] - path.energy[0] == pytest.approx(-work, rel=1e-5)
    frozen = tool.adiabat(start, volumes[[0, -1]])
    assert path.pressure[-1] > 1.2 * frozen.pressure[-1]


@pytest.mark.parametrize("pair", PAIRS)
def test_frozen_hugoniot_keeps_the_jump_conditions(pair):
    """The phases' energy jumps add up to the mixture's; the foot of the curve moves at the frozen sound speed (tangency)."""
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho, e_th = shocked(par.reactants)
    up = tool.solve(rho, e_th + Q, 0.3, par, (rho, e_th + Q))
    p_u, v_u = float(up.pressure), 1.0 / rho
    h = tool.frozen_hugoniot(up, p_u * np.array([1.0, 1.0 + 1e-4, 1.5, 2.0]))
    v = 1.0 / h.density
    assert np.allclose(h.energy - float(up.energy), 0.5 * (h.pressure + p_u) * (v_u - v), rtol=0, atol=1e-12 * h.energy)
    assert np.allclose(rho * h.shock_velocity[1:] * h.particle_velocity[1:], h.pressure[1:] - p_u, rtol=1e-12)
    assert h.shock_velocity[1] == pytest.approx(float(up.sound_speed), rel=2e-4)
    assert h.shock_velocity[0] == pytest.approx(float(up.sound_speed), rel=1e-12)
    assert np.allclose([eos.pressure(r, e, par.products) for r, e in zip(h.product_density, h.product_energy)], h.pressure, rtol=1e-12)


def test_heat_of_detonation_is_the_difference_of_the_reference_energies():
    assert tool.detonation_energy(UNREACTED._replace(e0=1.0e8), PRODUCTS) == pytest.approx((6.9e9 - 1.0e8) / RHO0, rel=1e-14)
    assert tool.mixture("thermal_isolation", UNREACTED, PRODUCTS).detonation_energy == pytest.approx(6.9e9 / RHO0, rel=1e-14)
