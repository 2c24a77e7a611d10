"""Mixtures against independent differentiation, entropy and the conservation laws: Starkenberg ARL-TR-2161 sections 5.1 to 5.9, appendix B."""

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.mixture import contract, equilibrium
from hugoniot.laws.mixture.isentrope import isentrope_energy
from hugoniot.theory import mixture as tool
from hugoniot.theory import mixture_kernels

RHO0 = 1895.0
PRODUCTS = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, RHO0, 6.9e9, 1.0e6 / RHO0)
UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, RHO0, 0.0, 2.487e6 / RHO0)
PAIRS = {
    "two gases": (IdealGas(5.0, 1000.0, RHO0), IdealGas(2.8, 1200.0, RHO0)),
    "jwl, jwl": (UNREACTED, PRODUCTS),
    "mie-grueneisen, jwl": (MieGruneisen(RHO0, 2900.0, 1.68, 1.1, 1100.0), PRODUCTS),
    "stiffened gas, gas": (StiffenedGas(4.4, 2.0e9, RHO0, 1400.0), IdealGas(2.8, 1200.0, RHO0)),
}
Q = 4.5e6
KINDS = ("thermal_isolation", "thermal_equilibrium")


def shocked(par, pressure=2.0e10):
    """(rho, thermal energy) behind a shock of that pressure into material of RHO0 at rest and zero pressure."""
    e = (0.0 - eos.pressure(RHO0, 0.0, par)) / eos.pressure_derivatives(RHO0, 0.0, par)[1]
    v = tool.hugoniot_volume(pressure, RHO0, e, 0.0, par)
    return 1.0 / v, e + 0.5 * pressure * (1.0 / RHO0 - v)


def states(pair, kind, count=12, seed=1):
    """Mixture and states about the isentrope of the shocked reactant, as (par, v, e, lambda, reference).

    The energy's distance from that isentrope is a share of lambda Q: all of it belongs to the products.
    """
    par = tool.mixture(kind, *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    rng = np.random.default_rng(seed)
    rho = rho_k * rng.uniform(0.75, 1.03, count)
    lam = rng.uniform(0.05, 0.98, count)
    along = np.array([isentrope_energy(1.0 / rho_k, e_k, 1.0 / r, par.reactants) for r in rho])
    e = along + Q * (1.0 + lam * rng.uniform(-0.1, 0.3, count))
    return par, 1.0 / rho, e, lam, (rho_k, e_k + Q)


def derivative(function, x, h):
    """Sixth-order central difference."""
    f = [function(x + k * h) - function(x - k * h) for k in (1, 2, 3)]
    return (45.0 * f[0] - 9.0 * f[1] + f[2]) / (60.0 * h)


@pytest.mark.parametrize("pair", PAIRS)
def test_an_attempt_is_the_answer_of_the_search_or_says_that_it_is_none(pair):
    """From the state of a step before, near or far: where two trials converge they give what the search gives, to 1e-12."""
    par, v, e, lam, reference = states(pair, "thermal_isolation", 40)
    rng, near, far = np.random.default_rng(5), 0, 0
    for k in range(len(v)):
        before = contract.solve(1.0 / v[k], e[k], lam[k], contract.at_rest(*reference), par)
        for size in (1e-4, 1e-3, 0.05, 0.5):
            rho, more = 1.0 / v[k] * (1.0 + size * rng.uniform(-1.0, 1.0)), e[k] * (1.0 + 0.1 * size * rng.uniform(-1.0, 1.0))
            fraction = min(1.0, max(0.0, lam[k] + size * rng.uniform(-1.0, 1.0)))
            tried = contract.attempt(rho, more, fraction, before, par)
            if tried.status == contract.CONVERGED:
                answer = contract.solve(rho, more, fraction, before, par)
                assert answer.status == contract.CONVERGED and np.allclose(tried, answer, rtol=1e-12, atol=0.0)
                near, far = near + (size < 0.01), far + (size > 0.01)
            else:
                assert tried == (*before[:5], contract.NOT_CONVERGED)
    closed = pair != "mie-grueneisen, jwl"      # a Hugoniot's isentrope is integrated
    assert (near >= 60 and far < 60) if closed else near == far == 0


@pytest.mark.parametrize("strange", [
    {"burn_fraction": 0.0}, {"burn_fraction": 1e-9}, {"burn_fraction": 1e-4}, {"burn_fraction": 1.0}, {"rho_r": 0.0}, {"rho_p": 0.0},
    {"rho_p": 1e-3}, {"rho_p": 1e7}, {"rho": 1.0}, {"rho": 1e6}, {"e": -1e9}, {"e": float("nan")}, {"rho": float("nan")}])
def test_an_attempt_leaves_ends_of_burning_and_bad_states_to_the_search(strange):
    par, v, e, lam, reference = states("jwl, jwl", "thermal_isolation")
    par = par._replace(nascent_limit=1e-3)
    before = contract.solve(1.0 / v[0], e[0], lam[0], contract.at_rest(*reference), par)
    before = before._replace(**{name: value for name, value in strange.items() if name in before._fields})
    values = {"rho": 1.0 / v[0], "e": e[0], "burn_fraction": lam[0]} | {k: x for k, x in strange.items() if k not in before._fields}
    with np.errstate(all="ignore"):
        assert contract.attempt(*values.values(), before, par).status == contract.NOT_CONVERGED


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
        assert np.allclose(entropy, reference_entropy, rtol=0, atol=1e-10 * eos.specific_heat(2500.0, 1e6, par.reactants))
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
    """003 sections 5.4 and 5.5: 1/i^2, (v/c)^2 and v/gamma are sums over the phases; Gamma = gamma/gamma_p Gamma_p."""
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
    volumes = np.linspace(v0, 1.3 * v0, 401)
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


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_no_search_fails_where_a_state_exists(pair, kind):
    """2000 states from tension to compression, burn fractions to 1e-9 of both ends: solved; refusals are checked by a dense scan.

    A Mie-Grueneisen solid of constant rho Gamma cannot release below its thermal pressure: as hot as products, it may have no equilibrium.
    """
    par = tool.mixture(kind, *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    rng = np.random.default_rng(5)
    n = 2000
    rho = rho_k * rng.uniform(0.6, 1.1, n)
    lam = np.concatenate([10.0 ** rng.uniform(-9, 0, n // 2), 1.0 - 10.0 ** rng.uniform(-9, 0, n // 2)])
    along = np.array([isentrope_energy(1.0 / rho_k, e_k, 1.0 / r, par.reactants) for r in rho])
    e = along + Q * (1.0 + lam * rng.uniform(-0.1, 0.3, n))
    phases = np.zeros((6, n))
    phases[1], phases[2] = rho_k, e_k + Q
    mixture_kernels.solve_rows(rho, e, lam, phases, par)
    refused = np.flatnonzero(phases[5] != contract.CONVERGED)
    if (pair, kind) != ("mie-grueneisen, jwl", "thermal_equilibrium"):
        assert refused.size == 0
    else:
        assert 0 < refused.size < 0.05 * n
    for j in refused[:5]:
        v, f, rest = 1.0 / rho[j], lam[j], 1.0 - lam[j]
        tight = (v - 1.001 / par.reactant_density_limit) / max(f, rest)
        for w in np.linspace(-tight, 0.7 * v, 141):
            z = equilibrium.share_energy(v + f * w, v - rest * w, e[j], f, 0.0, par)
            p_r = eos.pressure(1.0 / (v + f * w), e[j] + f * z - Q, par.reactants)
            assert p_r > eos.pressure(1.0 / (v - rest * w), e[j] - rest * z, par.products)


def test_heat_shared_by_both_phases_does_not_all_go_to_the_products():
    """A weak viscous shock in a zone of burn fraction 1e-3: 10 kJ/kg must not raise the nascent gas by 10 MJ/kg."""
    par = tool.mixture("thermal_isolation", *PAIRS["jwl, jwl"], Q)
    rho, e_th = shocked(par.reactants)
    quiet = contract.solve(rho, e_th + Q, 1e-3, contract.at_rest(rho, e_th + Q), par)
    heat = 1.0e4
    left_behind = contract.solve(rho, e_th + Q + heat, 1e-3, quiet, par)
    shared = contract.solve(rho, e_th + Q + heat, 1e-3, contract.heated(quiet, heat), par)
    assert abs(shared.e_p - quiet.e_p) < 3.0 * heat
    assert left_behind.e_p - quiet.e_p > 100.0 * heat
    assert shared.pressure == pytest.approx(eos.pressure(rho, e_th + heat, par.reactants), rel=2e-3)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_marched_reference_gives_the_fixed_one(pair):
    """A solver hands each step's phases to the next: after 300 steps the pressure is that of one search from the shocked state."""
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    steps = 300
    phases = np.zeros((6, 1))
    phases[1], phases[2] = rho_k, e_k + Q
    for k in range(1, steps + 1):
        rho = np.array([rho_k * (1.0 - 0.2 * k / steps)])
        lam = np.array([0.9 * k / steps])
        e = isentrope_energy(1.0 / rho_k, e_k, 1.0 / rho[0], par.reactants) + Q * np.array([1.0 + 0.1 * lam[0]])
        mixture_kernels.solve_rows(rho, e, lam, phases, par)
        assert phases[5, 0] == contract.CONVERGED
    assert phases[0, 0] == pytest.approx(float(tool.solve(rho[0], e[0], lam[0], par, (rho_k, e_k + Q)).pressure), rel=1e-10)


def test_refusals_name_the_state_and_the_cause():
    par = tool.mixture("thermal_isolation", *PAIRS["mie-grueneisen, jwl"], Q)
    rho_k, e_k = shocked(par.reactants)
    with pytest.raises(NoSolution, match="burn fraction 0.5"):
        tool.solve(3.0 * rho_k, 1e6, 0.5, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="reference"):
        tool.solve(rho_k, e_k + Q, 0.5, par)
    with pytest.raises(OutOfRange, match="0..1"):
        tool.solve(rho_k, e_k + Q, 1.2, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="positive"):
        tool.solve(-1.0, e_k + Q, 0.2, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="vanishing_series"):
        tool.solve(rho_k, e_k + Q, 0.0, par, (rho_k, e_k + Q)).phase_slopes()
    cold = PRODUCTS._replace(specific_heat=float("nan"))
    with pytest.raises(OutOfRange, match="products.*specific_heat"):
        tool.mixture("thermal_equilibrium", UNREACTED, cold)
    isolated = tool.solve(rho_k, e_k + Q, 0.3, tool.mixture("thermal_isolation", PAIRS["mie-grueneisen, jwl"][0], cold, Q), (rho_k, e_k + Q))
    assert isolated.pressure > 0.0
    with pytest.raises(OutOfRange, match="temperature"):
        _ = isolated.temperature
    with pytest.raises(OutOfRange, match="reactants"):
        tool.mixture("weighted_pressures", None, PRODUCTS)
    with pytest.raises(OutOfRange, match="no specific heat"):
        _ = tool.solve(rho_k, e_k + Q, 0.3, tool.mixture("weighted_pressures", UNREACTED, PRODUCTS)).specific_heat
