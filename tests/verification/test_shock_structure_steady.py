"""Steady shock structure against closed solutions (B29) and an independent integration (1e-6, B30); its profiles, speed and refusals."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws import eos as _laws  # noqa: F401
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.polynomial import Polynomial
from hugoniot.laws.transport.contract import make
from hugoniot.theory.structure import equations, jordan, steady
from hugoniot.theory.structure.analytic import BeckerShock

GAS, AHEAD = jordan.argon()
MACHS = jordan.ARGON_MACHS


def argon(mach, law="power_law", prandtl=2.0 / 3.0, **options):
    return steady(GAS, jordan.argon_transport(law, prandtl), AHEAD, mach=mach, **options)


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


@pytest.mark.parametrize("mach", [1.0001, 1.0005, 1.001, 1.003, 1.01])
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


@pytest.mark.parametrize("mach", [1.00003, 1.00001, 1.000001])
def test_shocks_that_round_off_hides_are_refused(mach):
    with pytest.raises(NoSolution, match="too weak"):
        argon(mach)


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
    """B30; Jordan had 19 200 cells."""
    for mach in (1.001, 1.01, 1.03, 1.05, 1.07, 1.1, 1.2, *MACHS, 20.0):
        assert argon(mach, law).steps <= 300



# -- bad input -------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("mach", [1.0, 0.5, -3.0, math.nan, math.inf])
def test_mach_at_or_below_one(mach):
    with pytest.raises(OutOfRange, match="is not a shock.*give a finite mach above 1"):
        argon(mach)


def test_mach_together_with_another_measure():
    with pytest.raises(OutOfRange, match="not by both"):
        argon(2.0, pressure=1e6)


def test_a_law_that_splits_its_shock_is_told():
    """Convex, then concave: beyond the point of tangency the Rayleigh line from rest crosses the Hugoniot."""
    par = Polynomial(1000.0, 4e9, 2e10, -2e10, 0.01)
    fluid = make({"law": "constant", "shear_viscosity": 1e-3})
    assert steady(par, fluid, density=1500.0).thickness() > 0.0
    with pytest.raises(NoSolution, match="so the wave splits; try"):
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
    with pytest.raises(OutOfRange, match="where the specific volume would be zero"):
        steady(EOS.get("tait").example, case.transport(), mach=20.0)
