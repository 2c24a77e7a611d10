"""Isentropes: closed forms of gases, JWL and stiffened gas; the first law by independent quadrature; ends that are told."""

import contextlib
import math

import numpy as np
import pytest
from pace import calls

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS, pressure
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory import expansion
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import escape, isentrope, reference, release, residual, state

COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 390.0)
TNT = JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9)


@pytest.mark.parametrize("gamma", [1.2, 1.4, 3.0])
def test_gas(gamma):
    gas = IdealGas(gamma)
    start = state(gas, 50.0, density=2.0, pressure=4e5)
    found = isentrope(gas, start, pressure=np.array([1e7, 4e5, 1e3, 1e-3]), direction=-1)
    assert found.density == pytest.approx(2.0 * (found.pressure / 4e5) ** (1 / gamma), rel=1e-12)
    c = np.sqrt(gamma * found.pressure / found.density)
    assert found.particle_velocity == pytest.approx(50.0 + 2 / (gamma - 1) * (start.sound_speed - c), rel=1e-11)
    assert escape(gas, start) == pytest.approx(2 * start.sound_speed / (gamma - 1), rel=1e-13)


def test_jwl_keeps_its_principal_isentrope():
    """p_S = A e^-R1V + B e^-R2V + C V^-(1+omega) with one C along the path."""
    start = state(TNT, density=2200.0, pressure=2.0e10)
    found = isentrope(TNT, start, density=np.array([2500.0, 2200.0, 1000.0, 100.0, 2.0]))
    v = 1630.0 / found.density
    c = (found.pressure - TNT.a * np.exp(-TNT.r1 * v) - TNT.b * np.exp(-TNT.r2 * v)) * v**1.3
    assert c == pytest.approx(np.full(5, c[1]), rel=1e-11)


def test_entropy_is_constant_and_temperature_follows_the_source():
    start = shock(COPPER, pressure=60e9)
    found = release(COPPER, start, points=30)
    assert found.entropy == pytest.approx(np.full(30, start.entropy), rel=1e-11)
    # Starkenberg A-4: T = T1 exp(Gamma0 rho0 (v1 - v)) for rho Gamma constant
    expected = start.temperature * np.exp(1.99 * 8930.0 * (1 / start.density - 1 / found.density))
    assert found.temperature == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize(("law", "start", "end"), [
    (COPPER, shock(COPPER, pressure=90e9), 0.0), (TNT, state(TNT, density=2200.0, pressure=2e10), 1e5),
    (IdealGas(1.4), state(IdealGas(1.4), density=1.0, pressure=1e5), 1.0)])
def test_first_law_holds_by_quadrature(law, start, end):
    path = isentrope(law, start, pressure=np.linspace(start.pressure, end, 12))
    assert residual(path) < 1e-11


def test_release_direction_and_free_surface_rule():
    """A weak release adds about as much velocity as the shock did (free-surface approximation), exactly so as p -> 0."""
    weak = shock(COPPER, pressure=1e7)
    assert release(COPPER, weak).particle_velocity == pytest.approx(2 * weak.particle_velocity, rel=1e-5)
    assert release(COPPER, weak, direction=1).particle_velocity == pytest.approx(0.0, abs=1e-5 * weak.particle_velocity)
    strong = shock(COPPER, pressure=50e9)
    assert release(COPPER, strong).particle_velocity > 2 * strong.particle_velocity


def test_by_velocity_is_the_inverse_of_by_pressure():
    start = shock(COPPER, pressure=40e9)
    path = release(COPPER, start, points=6)
    again = isentrope(COPPER, start, particle_velocity=path.particle_velocity, direction=-1)
    assert again.pressure == pytest.approx(path.pressure, rel=1e-9, abs=0.1)  # rho c du of round-off in u


def test_the_state_it_starts_from_comes_back_to_the_last_digit():
    start = reference(COPPER)
    assert isentrope(COPPER, pressure=[0.0, 1e9]).density[0] == start.density
    assert isentrope(COPPER, start, particle_velocity=0.0).density == start.density


def test_compiled_path_equals_the_plain_one():
    start = shock(COPPER, pressure=40e9)
    rho = np.linspace(9000.0, 10500.0, 450)
    many, few = isentrope(COPPER, start, density=rho), isentrope(COPPER, start, density=rho[::50])
    assert many.specific_internal_energy[::50] == pytest.approx(few.specific_internal_energy, rel=1e-12)


def test_strong_tension_is_refused_with_the_limit():
    """The cold solid bears 3 rho0 c0^2/(8 s) at most; the answer says where the isentrope ends."""
    bound = 3 * 8930.0 * 3940.0**2 / (8 * 1.489)
    with pytest.raises(OutOfRange, match=r"ends at .* supports no greater tension"):
        isentrope(COPPER, pressure=-1.01 * bound)
    found = isentrope(COPPER, pressure=-0.5 * bound)
    assert found.pressure == -0.5 * bound and found.density < 8930.0
    assert isentrope(COPPER, pressure=-0.998 * bound).density > 8930.0 / 20.0


@pytest.mark.parametrize("given", [{"pressure": -1e12}, {"particle_velocity": 3e4}])
def test_a_release_without_end_is_refused_as_soon_as_the_tension_has_levelled_off(given):
    """Refusing costs what the path to a twentieth of the density costs, not an integration until its steps run out (sixteen times that)."""
    def effort(**wanted):
        def work():
            with contextlib.suppress(OutOfRange):
                isentrope(COPPER, direction=-1, **wanted)

        work()
        return calls(work)

    assert effort(**given) < 4.0 * effort(density=8930.0 / 20.0)


def test_solids_do_not_escape_and_release_never_rises():
    with pytest.raises(OutOfRange, match="does not expand to a gas"):
        escape(COPPER, shock(COPPER, pressure=1e9))
    with pytest.raises(OutOfRange, match="must start above"):
        release(COPPER, reference(COPPER), 1e9)
    with pytest.raises(OutOfRange, match="is outside the range"):
        isentrope(COPPER, density=1e6)


def test_integrator_crosses_a_kink_of_the_law():
    """The solid changes branch at rho0; e must still be exact: in tension e_R is the isentrope through rest (closed form)."""
    start = reference(COPPER)
    found = isentrope(COPPER, isentrope(COPPER, start, density=9300.0), density=8600.0)
    eta = 1 - 8930.0 / 8600.0
    assert found.specific_internal_energy == pytest.approx(0.5 * 3940.0**2 * eta**2 / (1 - 4 / 3 * 1.489 * eta), rel=1e-10)


def test_an_isentrope_leaves_a_point_where_the_law_is_not_smooth():
    """P-lambda crushes as p^1.2 from rest on: slopes there are finite but no power series holds. First law by Gauss in the root of the way."""
    par = EOS.get("p_lambda").example
    y0, y1 = math.log(2100.0), math.log(2160.0)
    status, y, e, _ = expansion.advance(y0, 0.0, 0.0, y1, par)
    assert (status, y) == (expansion.REACHED, y1)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    work, here, energy, speed = 0.0, y0, 0.0, 0.0
    for x, w in zip(0.5 * (nodes + 1.0), 0.5 * weights):
        _, here, energy, speed = expansion.advance(here, energy, speed, y0 + (y1 - y0) * x**4, par)
        work += w * 4.0 * x**3 * (y1 - y0) * pressure(math.exp(here), energy, par) / math.exp(here)
    assert e == pytest.approx(work, rel=1e-10)


def test_extrapolation_reaches_round_off():
    status, y, e, u = expansion.advance(0.0, 2.5, 0.0, -5.0, IdealGas(1.4))
    assert status == expansion.REACHED and y == -5.0
    assert e == pytest.approx(2.5 * math.exp(-2.0), rel=1e-13)
    assert u == pytest.approx(-5 * math.sqrt(1.4) * (1 - math.exp(-1.0)), rel=1e-13)


@pytest.mark.parametrize("given", [{"density": 9000.0, "temperature": 400.0}, {"pressure": 5e9, "temperature": 500.0}, {"density": 9100.0},
                                   {"pressure": 3e9, "energy": 1e4}, {"energy": 2e4}])
def test_state_from_two_values(given):
    found = state(COPPER, 7.0, **given)
    for name, value in given.items():
        mine = found.specific_internal_energy if name == "energy" else getattr(found, name)
        assert mine == pytest.approx(value, rel=1e-10)
    assert found.particle_velocity == 7.0
    if given == {"density": 9100.0}:
        assert found.pressure == pytest.approx(0.0, abs=1.0)
