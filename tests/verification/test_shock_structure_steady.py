"""Steady shock structure: verification A5 (004), B29 and B30, and an independent integration of the same physics."""

import math
import time

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws import eos as _laws  # noqa: F401
from hugoniot.laws.eos.contract import EOS, has_temperature
from hugoniot.laws.eos.polynomial import Polynomial
from hugoniot.laws.transport.contract import make
from hugoniot.theory.structure import equations, find_ends, jordan, steady
from hugoniot.theory.structure.analytic import BeckerShock
from hugoniot.theory.structure.sweep import argon_rows, condensed_rows, thinnest

GAS, AHEAD = jordan.argon()
MACHS = jordan.ARGON_MACHS


def argon(mach, law="power_law", prandtl=2.0 / 3.0, **options):
    return steady(GAS, jordan.argon_transport(law, prandtl), AHEAD, mach=mach, **options)


# -- 004's tables ------------------------------------------------------------------------------------------------------
EXACT = {  # A5: block -> thickness in its mean free path, tolerance of the source
    "constant": ((2.9680, 0.5493, 0.1607), "constant", "bsl"),
    "power_law": ((5.7917, 2.5427, 3.1624), "power_law", "chapman_enskog"),
    "maxwell": ((3.9329, 1.7266, 2.1475), "power_law", "bsl"),
}


@pytest.mark.parametrize("block", EXACT)
def test_nine_argon_thicknesses(block):
    values, law, unit = EXACT[block]
    for mach, value in zip(MACHS, values):
        profile = argon(mach, law)
        assert profile.thickness() / profile.mean_free_path(unit) == pytest.approx(value, abs=6e-5)


def test_source_at_its_finest_grid_agrees_where_it_is_converged():
    for row in argon_rows():
        if row["table"] == "6.2.1.1" and row["quantity"].startswith("density"):
            unconverged = row["block"] == "constant" and row["mach"] > 2.0   # J-E5
            away = abs(row["printed"] / row["ours"] - 1.0)
            assert (away > 0.015) if unconverged else (away < 0.015)


@pytest.mark.parametrize("law", ["constant", "power_law", "sutherland", "hard_sphere", "maxwell_molecules"])
def test_entropy_is_the_same_for_every_viscosity_law(law):
    for mach, value in zip(MACHS, (16.4917, 224.548, 738.310)):
        profile = argon(mach, law)
        assert profile.entropy_produced == pytest.approx(profile.ends.entropy_jump, rel=1e-8)
        assert profile.entropy_produced == pytest.approx(value, rel=1e-4)


def test_entropy_does_not_depend_on_the_prandtl_number_but_its_split_does():
    few, many = argon(3.38, prandtl=0.2), argon(3.38, prandtl=5.0)
    assert few.entropy_produced == pytest.approx(many.entropy_produced, rel=1e-8)
    assert few.entropy_conductive > 2.0 * many.entropy_conductive


def test_printed_entropy_integral_lacks_the_mass_flux():
    assert argon(1.55).entropy_literal() == pytest.approx(25.56, abs=0.01)          # J-E2
    assert argon(1.55).entropy_literal() / argon(1.55).entropy_produced == pytest.approx(1.55, rel=1e-4)


def test_analytic_table():
    for mach, velocity, density, entropy in zip(MACHS, (3.0982, 0.7242, 0.2346), (2.8591, 0.5373, 0.1578), (16.49, 224.55, 738.31)):
        closed = BeckerShock(mach)
        assert closed.velocity_thickness == pytest.approx(velocity, abs=6e-5)
        assert closed.density_thickness == pytest.approx(density, abs=6e-5)
        assert closed.entropy_jump(208.1) == pytest.approx(entropy, rel=1e-4, abs=5e-3)


def test_nanometres_of_argon():
    for mach, ours, printed in zip(MACHS, (414.3, 181.9, 226.2), (419.0, 184.0, 228.0)):
        nm = argon(mach).thickness() * 1e9
        assert nm == pytest.approx(ours, rel=1e-3)
        assert nm == pytest.approx(printed, rel=0.02)


def test_thinnest_argon_shock_is_at_mach_4_03():
    mach, length = thinnest(GAS, jordan.argon_transport(), AHEAD)
    unit = argon(mach).mean_free_path("chapman_enskog")
    assert mach == pytest.approx(4.03, abs=0.005)
    assert length / unit == pytest.approx(2.4964, abs=6e-5)
    assert argon(5.0).thickness() / unit == pytest.approx(2.5534, abs=6e-5)


def test_hard_spheres_are_not_the_maxwell_rows():
    for mach, value in zip(MACHS, (5.20, 1.64, 1.17)):
        profile = argon(mach, "hard_sphere")
        assert profile.thickness() / profile.mean_free_path("chapman_enskog") == pytest.approx(value, abs=0.005)


# -- closed solutions ----------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("mach", [1.05, 1.55, 3.38, 9.0, 20.0])
def test_becker_profile(mach):
    profile = argon(mach, "constant", prandtl=0.75, rtol=1e-13)
    closed = BeckerShock(mach)
    path = profile.mean_free_path("bsl")
    one = profile.ends.upstream
    half = 2.0 / (1.0 + 1.0 / closed.alpha)   # velocity ratio at the density half way
    zeta0 = brentq(lambda z: float(closed.velocity(z)) - half, -500.0, 500.0, xtol=1e-14)
    x = np.linspace(*profile.extent(1e-5), 400)
    fields = profile.at(x)
    assert np.abs(fields["velocity"] / one.velocity - closed.velocity(x / path + zeta0)).max() < 1e-8
    enthalpy = fields["energy"] + fields["pressure"] / fields["density"] + 0.5 * fields["velocity"] ** 2
    assert np.abs(enthalpy / enthalpy[0] - 1.0).max() < 1e-12
    assert profile.thickness("velocity") / path == pytest.approx(closed.velocity_thickness, rel=1e-9)
    assert profile.thickness() / path == pytest.approx(closed.density_thickness, rel=1e-9)


def test_closed_solution_solves_its_equation_for_any_gamma():
    for gamma in (1.1, 1.4, 5.0 / 3.0, 3.0):
        shock = BeckerShock(2.5, gamma)
        zeta = np.linspace(-6.0, 1.5, 31)
        phi, a = shock.velocity(zeta), shock.alpha
        left = np.log(1.0 - phi) - a * np.log(phi - a)
        noise = 1e-15 / np.minimum(1.0 - phi, phi - a)   # of the logarithms' arguments
        assert np.all(np.abs(left - shock.beta * (1.0 - a) * shock.mach * zeta) < 1e-12 + 4.0 * noise)
        d = 1e-5
        slope = (shock.velocity(zeta + d) - shock.velocity(zeta - d)) / (2.0 * d)
        assert np.allclose(slope, shock.slope(phi), atol=1e-8)
        per_viscous_length = 3.0 * shock.mach * (gamma + 1.0) / (8.0 * gamma)   # B29: K, x in mu1/(rho1 a1)
        path = 3.0 * math.sqrt(math.pi * gamma / 8.0)                           # lambda_bsl in that unit
        assert shock.beta * shock.mach == pytest.approx(per_viscous_length * path, rel=1e-14)


# -- an independent integration -----------------------------------------------------------------------------------------------
def independent_thickness(mach, exponent, prandtl, gamma=5.0 / 3.0):
    """Density thickness in mu1/(rho1 u1): temperature as a function of velocity, no position, in T and u of an ideal gas."""
    kappa = 1.0 / (gamma * mach**2)
    phi2 = (gamma - 1.0) / (gamma + 1.0) + 2.0 / ((gamma + 1.0) * mach**2)
    theta2 = (1.0 + (gamma - 1.0) / 2.0 * mach**2 * (1.0 - phi2**2))

    def slopes(phi, theta):
        mu = theta**exponent
        phi_x = (phi - 1.0 + kappa * (theta / phi - 1.0)) / (4.0 / 3.0 * mu)
        heat = (theta - 1.0) - (gamma - 1.0) * (1.0 - phi) - 0.5 * gamma * (gamma - 1.0) * mach**2 * (1.0 - phi) ** 2
        return phi_x, prandtl / (gamma * mu) * heat

    a, d = slopes(phi2 + 1e-6, theta2), slopes(phi2 - 1e-6, theta2)
    b, e = slopes(phi2, theta2 + 1e-6), slopes(phi2, theta2 - 1e-6)
    matrix = np.array([[(a[0] - d[0]) / 2e-6, (b[0] - e[0]) / 2e-6], [(a[1] - d[1]) / 2e-6, (b[1] - e[1]) / 2e-6]])
    values, vectors = np.linalg.eig(matrix)
    v = vectors[:, np.argmin(values)]
    start = 1e-7 * (1.0 - phi2)
    found = solve_ivp(lambda phi, y: [slopes(phi, y[0])[1] / slopes(phi, y[0])[0]], (phi2 + start, 1.0 - 1e-4 * (1.0 - phi2)),
                      [theta2 + start * v[1] / v[0]], method="DOP853", rtol=3e-14, atol=1e-14, dense_output=True)
    assert found.success
    best = minimize_scalar(lambda phi: slopes(phi, found.sol(phi)[0])[0] / phi**2,
                           bounds=(phi2 + 0.01 * (1 - phi2), 1.0 - 0.01 * (1 - phi2)), method="bounded", options={"xatol": 1e-10})
    return (1.0 / phi2 - 1.0) / -best.fun


@pytest.mark.parametrize("mach, exponent, prandtl", [(1.05, 0.81, 2 / 3), (1.1, 0.0, 2 / 3), (1.55, 0.0, 2 / 3), (3.38, 0.81, 2 / 3), (9.0, 0.81, 2 / 3),
                                                     (9.0, 1.0, 1.5), (20.0, 0.0, 2 / 3), (50.0, 0.81, 0.75)])
def test_thickness_against_an_independent_integration(mach, exponent, prandtl):
    law = {0.0: "constant", 0.81: "power_law", 1.0: "maxwell_molecules"}[exponent]
    profile = argon(mach, law, prandtl)
    unit = jordan.ARGON_VISCOSITY / profile.ends.mass_flux
    assert profile.thickness() / unit == pytest.approx(independent_thickness(mach, exponent, prandtl), rel=1e-7)


@pytest.mark.parametrize("name", jordan.CONDENSED)
def test_water_and_silica_against_the_closed_slope(name):
    """Without conduction the slope is closed in v: mu_l m v' = p + m^2 v - P0 on the Rayleigh line, with the law written out here."""
    case = jordan.CONDENSED[name]
    profile = steady(case.eos(), case.transport(), particle_velocity=case.particle_velocity)
    r0, c, s, g = case.density, case.sound_speed, case.slope, case.bent
    m = r0 * (c + s * case.particle_velocity)

    def gradient(x):
        compression = x * r0
        hugoniot = r0 * c * c * compression / (1.0 - s * compression) ** 2
        p = hugoniot * (1.0 - 0.5 * g * compression) + r0 * g * 0.5 * m * m * x * x
        return (p - m * m * x) / (4.0 / 3.0 * case.shear_viscosity * m) / (1.0 / r0 - x) ** 2

    most = case.particle_velocity / m
    grid = np.linspace(0.0, most, 2001)[1:-1]
    i = int(np.argmin(gradient(grid)))
    best = minimize_scalar(gradient, bounds=(grid[max(i - 1, 0)], grid[min(i + 1, 1998)]), method="bounded", options={"xatol": 1e-12 * most})
    length = (1.0 / (1.0 / r0 - most) - r0) / -best.fun
    assert profile.thickness() == pytest.approx(length, rel=1e-8)


def test_the_two_methods_meet(monkeypatch):
    slow = argon(1.02)
    weak = argon(1.1)
    monkeypatch.setattr(equations, "STIFF", 1e9)
    for curve, along_x in ((slow, argon(1.02)), (weak, argon(1.1))):
        assert curve._curve is not None and along_x._curve is None
        assert curve.thickness() == pytest.approx(along_x.thickness(), rel=1e-8)
        assert curve.entropy_conductive == pytest.approx(along_x.entropy_conductive, rel=1e-7)


@pytest.mark.parametrize("mach", [1.001, 1.003, 1.01])
def test_weak_shocks_follow_the_exact_weak_limit(mach):
    """Taylor's weak shock: thickness = 4 diffusivity/((gamma+1)/2 ... ) -> delta (M - 1) tends to a constant; here to second order."""
    gamma, prandtl = 5.0 / 3.0, 2.0 / 3.0
    nu = jordan.ARGON_VISCOSITY / jordan.ARGON_DENSITY
    sound = math.sqrt(gamma * jordan.GAS_CONSTANT * 300.0)
    diffusivity = nu * (4.0 / 3.0 + (gamma - 1.0) / prandtl)
    # Lighthill: u = tanh profile of full change 2a and slope a^2 (gamma+1)/(2 diffusivity): thickness = 4 diff / ((gamma+1) a)
    a = 2.0 * sound * (mach - 1.0) / (gamma + 1.0)
    weak = 4.0 * diffusivity / ((gamma + 1.0) * a)
    assert argon(mach).thickness() == pytest.approx(weak, rel=3.0 * (mach - 1.0))


# -- any equation of state -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("law", list(EOS), ids=lambda law: law.name)
def test_every_registered_equation_of_state_has_a_structure(law):
    """End states of the same law to round-off; where the law has an entropy, production through the shock equals its jump."""
    par = law.example
    for conduction in (None, {"law": "prandtl", "prandtl": 1.0}):
        if conduction and not has_temperature(par):
            with pytest.raises(OutOfRange, match="temperature"):
                steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, conduction), mach=1.5)
            continue
        begun = time.perf_counter()
        profile = steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, conduction), mach=1.5)
        assert profile.thickness() > 0.0
        took = time.perf_counter() - begun
        ends = profile.ends
        assert abs(ends.excess(1.0 / ends.downstream.density)) < 1e-12 * ends.downstream.pressure
        terms = profile.balance_terms(np.linspace(*profile.extent(1e-2), 9))
        for kind in ("momentum", "energy"):
            parts = [value for name, value in terms.items() if name.startswith(kind)]
            # the slope of energy conduction follows the identity of a consistent law; difference quotients reach 1e-6
            assert np.abs(sum(parts)).max() < 2e-6 * max(np.abs(p).max() for p in parts)
        if math.isfinite(ends.entropy_jump):
            assert profile.entropy_produced == pytest.approx(ends.entropy_jump, rel=1e-8)
        assert took < 4.0, "a profile must take about a second, also on a busy machine"


# (law, conducting) -> Mach numbers of (1.01, 1.1, 2, 5, 20) that have no steady shock, and the words that say so
NO_SHOCK = {
    ("mie_gruneisen_quadratic", False): ((20.0,), "has no such shock.*compression limit"),
    ("mie_gruneisen_quadratic", True): ((20.0,), "has no such shock.*compression limit"),
    ("mie_gruneisen_cubic", False): ((5.0, 20.0), "has no such shock.*beyond the fit"),
    ("mie_gruneisen_cubic", True): ((5.0, 20.0), "has no such shock.*beyond the fit"),
    ("p_lambda", True): ((20.0,), "has no such shock with this heat conduction.*no single stable state"),
    ("table", False): ((2.0, 5.0, 20.0), "has no such shock.*the Hugoniot ends at density 4300"),
    ("table", True): ((2.0, 5.0, 20.0), "has no such shock.*the Hugoniot ends at density 4300"),
    ("tait", False): ((20.0,), "has no such shock.*compression limit"),
    ("tait", True): ((20.0,), "has no such shock.*compression limit"),
}


def check_shock_of(name, conducting, mach):
    par = EOS.get(name).example
    fluid = make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0} if conducting else None)
    refused, words = NO_SHOCK.get((name, conducting), ((), ""))
    if conducting and not has_temperature(par):
        refused, words = (mach,), "no temperature"
    if mach in refused:
        with pytest.raises((OutOfRange, NoSolution), match=words):
            steady(par, fluid, mach=mach)
        return
    begun = time.process_time()
    profile = steady(par, fluid, mach=mach)
    assert profile.thickness() > 0.0 and profile.ends.mach == pytest.approx(mach, rel=1e-12)
    assert time.process_time() - begun < 2.0
    low, high = profile.extent(1e-6)
    density = profile.at(np.linspace(low, high, 41))["density"]
    assert np.all(np.diff(density) > 0.0)
    scale = profile.ends.downstream.density - profile.ends.upstream.density
    assert density[0] == pytest.approx(profile.ends.upstream.density + 1e-6 * scale, abs=1e-9 * scale)
    assert density[-1] == pytest.approx(profile.ends.downstream.density - 1e-6 * scale, abs=1e-9 * scale)
    if math.isfinite(profile.ends.entropy_jump):
        assert profile.entropy_produced == pytest.approx(profile.ends.entropy_jump, rel=2e-8)


@pytest.mark.parametrize("name, conducting, mach", [
    ("snow_plough", True, 20.0), ("p_alpha", True, 1.01), ("p_lambda", True, 5.0), ("p_lambda", True, 20.0), ("mie_gruneisen_cubic", False, 5.0),
    ("mie_gruneisen_cubic", True, 5.0), ("table", True, 1.01), ("table", False, 20.0), ("tait", True, 20.0), ("jwl", True, 20.0)])
def test_from_mach_1_01_to_20_sampled(name, conducting, mach):
    check_shock_of(name, conducting, mach)


@pytest.mark.slow
@pytest.mark.parametrize("law", list(EOS), ids=lambda law: law.name)
def test_from_mach_1_01_to_20_with_and_without_conduction(law):
    """The matrix of docs/theory/shock_structure_numbers.md."""
    for conducting in (False, True):
        for mach in (1.01, 1.1, 2.0, 5.0, 20.0):
            check_shock_of(law.name, conducting, mach)


def test_heat_that_runs_ahead_of_a_porous_shock_keeps_the_flux_of_energy():
    """k dT/dx = m h with dT/dx from the profile itself: in pores temperature and energy do not follow from one potential."""
    fluid = make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0})
    for name, mach in (("p_lambda", 5.0), ("p_alpha", 5.0), ("snow_plough", 20.0)):
        profile = steady(EOS.get(name).example, fluid, mach=mach)
        x = np.linspace(*profile.extent(1e-2), 24)
        d = 1e-5 * profile.thickness()
        slope = (profile.at(x + d)["temperature"] - profile.at(x - d)["temperature"]) / (2.0 * d)
        fields = profile.at(x)
        assert np.allclose(-fields["conductivity"] * slope, fields["heat_flux"], rtol=1e-3, atol=1e-4 * np.abs(fields["heat_flux"]).max()), name


def test_a_strong_conducting_shock_in_a_porous_solid_is_followed_to_its_end():
    """Mach 20 in p_alpha with conduction: hundreds of viscous lengths ahead of it are warm; production equals what its state gains."""
    par = EOS.get("p_alpha").example
    profile = steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0}), mach=20.0)
    m, mu = profile.ends.mass_flux, 4e-3 / 3.0
    low, _ = profile.extent(1e-3)
    assert low < -200.0 * mu / m
    assert profile.at(np.array([profile.x[0]]))["temperature"][0] == pytest.approx(profile.ends.upstream.temperature, rel=1e-3)


def test_the_law_meets_its_own_jump_for_any_gruneisen_parameter():
    for case in jordan.CONDENSED.values():
        for gamma0 in (0.05, 0.3, 1.0, case.bent):
            ends = find_ends(case.eos(gamma0), particle_velocity=case.particle_velocity)
            speed = case.sound_speed + case.slope * case.particle_velocity
            assert ends.downstream.pressure == pytest.approx(case.density * speed * case.particle_velocity, rel=1e-12)
            assert abs(ends.excess(1.0 / ends.downstream.density)) < 1e-12 * ends.downstream.pressure


def test_bent_gruneisen_parameters_are_recovered():
    found = {case.name: [jordan.adjusted_gruneisen(case.density, case.sound_speed, case.slope, g, case.particle_velocity)
                         for g in (0.1, 0.15, 0.3, 1.0)] for case in jordan.CONDENSED.values()}
    assert found["water_387"][1] == pytest.approx(2.83879, abs=5e-6)
    assert found["water_858"][1] == pytest.approx(2.95439, abs=6e-6)
    for name, case in jordan.CONDENSED.items():   # within 1 % for some literature value the source may have used; Up column swapped
        assert min(abs(g / case.bent - 1.0) for g in found[name]) < 0.01
    swapped = jordan.CONDENSED["silica_100"]
    assert jordan.adjusted_gruneisen(100.0, 121.0, 0.9736, 0.3, 704.0) > 1.3 * swapped.bent     # J-E10: not with the printed Up


def test_water_and_silica_numbers():
    rows = {row["block"]: row for row in condensed_rows()}
    assert rows["water_387"]["ours_bent"] == pytest.approx(3.57, abs=0.005) and rows["water_387"]["ours"] == pytest.approx(3.06, abs=0.005)
    assert rows["water_858"]["ours_bent"] == pytest.approx(1.65, abs=0.005) and rows["water_858"]["ours"] == pytest.approx(1.22, abs=0.005)
    for name, value in (("silica_100", 0.30), ("silica_250", 0.39), ("silica_770", 3.9)):
        assert rows[name]["ours"] == pytest.approx(value, abs=0.03)
    case = jordan.CONDENSED["water_387"]
    bulk = steady(case.eos(), make({"law": "constant", "shear_viscosity": 1.003e-3}, bulk_ratio=3.0), particle_velocity=387.5)
    assert bulk.thickness() * 1e9 / rows["water_387"]["ours_bent"] == pytest.approx(3.25, rel=1e-9)


def test_water_entropy_and_temperature_of_the_jump():
    for name, entropy in (("water_387", 61.0), ("water_858", 429.0)):
        case = jordan.CONDENSED[name]
        profile = steady(case.eos(0.15), case.transport(conducting=True), particle_velocity=case.particle_velocity)
        assert profile.ends.entropy_jump == pytest.approx(entropy, rel=0.01)
        assert profile.entropy_produced == pytest.approx(profile.ends.entropy_jump, rel=1e-8)
        assert profile.entropy_conductive < 0.02 * profile.entropy_viscous   # "conduction is small": true in water


def test_extent_reaches_beyond_the_integration():
    """Behind a thirtyfold compression the density changes 200 times as fast as the volume: 1e-6 of its jump lies in the tail."""
    profile = steady(EOS.get("mie_gruneisen_cold_series").example, make({"law": "constant", "shear_viscosity": 1e-3}), mach=20.0)
    one, two = profile.ends.upstream.density, profile.ends.downstream.density
    for part in (1e-3, 1e-6, 1e-10):
        gained = (profile.at(np.array(profile.extent(part)))["density"] - one) / (two - one)
        assert gained[0] == pytest.approx(part, rel=1e-4) and 1.0 - gained[1] == pytest.approx(part, rel=1e-4)
    assert profile.extent(1e-6)[1] > profile.x[-1]


# -- profiles ----------------------------------------------------------------------------------------------------------------
def test_fields_and_gradients_belong_together():
    profile = argon(3.38)
    x = np.linspace(*profile.extent(1e-3), 60)
    d = 1e-4 * profile.thickness()
    for name in ("density", "velocity", "pressure", "energy", "temperature"):
        numeric = (profile.at(x + d)[name] - profile.at(x - d)[name]) / (2.0 * d)
        assert np.allclose(profile.gradient(name, x), numeric, rtol=1e-5, atol=1e-6 * np.abs(numeric).max()), name
    fields = profile.at(x)
    assert np.allclose(fields["viscous_stress"], 4.0 / 3.0 * fields["viscosity"] * profile.gradient("velocity", x), rtol=1e-8)
    assert np.allclose(fields["heat_flux"], -fields["conductivity"] * profile.gradient("temperature", x), rtol=1e-8)
    mass = fields["density"] * fields["velocity"]
    assert np.allclose(mass, profile.ends.mass_flux, rtol=1e-13)


def test_width_of_the_middle_and_tails():
    profile = argon(9.0)
    low, high = profile.extent(0.1)
    assert profile.width() == pytest.approx(high - low, rel=2e-3)
    assert profile.at(0.0)["density"][0] == pytest.approx(0.5 * (profile.ends.upstream.density + profile.ends.downstream.density), rel=1e-9)
    far = profile.at(np.array([-1.0, 1.0]))["density"]
    assert far == pytest.approx([profile.ends.upstream.density, profile.ends.downstream.density], rel=1e-12)


@pytest.mark.parametrize("law", ["constant", "power_law", "sutherland", "hard_sphere", "maxwell_molecules"])
def test_no_more_than_three_hundred_nodes(law):
    """B30; 004 had 19 200 cells."""
    for mach in (1.001, 1.01, 1.03, 1.05, 1.07, 1.1, 1.2, *MACHS, 20.0):
        assert argon(mach, law).steps <= 300


def test_nine_profiles_take_less_than_five_seconds():
    begun = time.process_time()
    for law in ("constant", "power_law", "hard_sphere"):
        for mach in MACHS:
            one = time.process_time()
            argon(mach, law).thickness()
            assert time.process_time() - one < 1.0
    assert time.process_time() - begun < 5.0


# -- bad input -------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("mach", [1.0, 0.5, -3.0, math.nan, math.inf])
def test_mach_at_or_below_one(mach):
    with pytest.raises(OutOfRange, match="makes no shock.*give mach above 1"):
        argon(mach)


def test_mach_together_with_another_measure():
    with pytest.raises(OutOfRange, match="given once"):
        argon(2.0, pressure=1e6)


def test_a_law_that_splits_its_shock_is_told():
    """Convex, then concave: beyond the point of tangency the Rayleigh line from rest crosses the Hugoniot."""
    par = Polynomial(1000.0, 4e9, 2e10, -2e10, 0.01)
    fluid = make({"law": "constant", "shear_viscosity": 1e-3})
    assert steady(par, fluid, density=1500.0).thickness() > 0.0
    with pytest.raises(NoSolution, match="so the wave splits; ask for"):
        steady(par, fluid, density=1750.0)


def test_a_law_that_softens_has_no_compressive_shock():
    par = Polynomial(1000.0, 4e9, -1.1e10, 1.1e10, 0.5)
    with pytest.raises(OutOfRange, match="has no such shock: a compressive shock.*2000 m/s"):
        steady(par, make({"law": "constant", "shear_viscosity": 1e-3}), density=1500.0)


def test_bent_gruneisen_cannot_conduct():
    case = jordan.CONDENSED["water_858"]
    with pytest.raises(OutOfRange, match="c_p is negative.*smaller"):
        steady(case.eos(), case.transport(conducting=True), particle_velocity=858.0)


def test_more_than_the_law_can_do():
    case = jordan.CONDENSED["silica_770"]   # s < 1: Us falls to up at 1798 m/s (J-E16)
    with pytest.raises((OutOfRange, NoSolution), match="has no such shock"):
        steady(case.eos(), case.transport(), particle_velocity=1800.0)
    with pytest.raises(OutOfRange, match="ends at no volume left, where the shock runs no faster than the material behind it, pressure"):
        steady(EOS.get("tait").example, case.transport(), mach=20.0)
