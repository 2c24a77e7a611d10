"""Exact Riemann problems: verification.md B1, B2, B3, B13, B20, and the jump relations across every wave."""

import math
from dataclasses import replace

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the laws)
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.theory.hugoniot import Initial, residual
from hugoniot.theory.isentrope import isentrope, reference, state
from hugoniot.theory.riemann import riemann

AIR, MONATOMIC = IdealGas(1.4), IdealGas(5 / 3)
AL = MieGruneisen(2785.0, 5328.0, 1.338, 2.0)
CU = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
W, FE = MieGruneisen(19224.0, 4029.0, 1.237, 1.54), MieGruneisen(7850.0, 3574.0, 1.92, 1.69)


def gas_problem(gas, rho1, u1, p1, rho2, u2, p2):
    return riemann(gas, state(gas, u1, density=rho1, pressure=p1), gas, state(gas, u2, density=rho2, pressure=p2))


def test_b1_sod():
    found = gas_problem(AIR, 1.0, 0.0, 1.0, 0.125, 0.0, 0.1)
    assert (found.pressure, found.velocity) == pytest.approx((0.3031301780, 0.9274526200), abs=1e-10)
    assert (found.left.behind.density, found.right.behind.density) == pytest.approx((0.4263194281, 0.2655737117), abs=1e-10)
    assert found.right.head == pytest.approx(1.7521557320, abs=1e-10)
    assert [what for what, _ in found.jumps] == ["fan head", "fan tail", "contact", "shock"]


def test_b1_sampled_fan_is_the_closed_form():
    found = gas_problem(AIR, 1.0, 0.0, 1.0, 0.125, 0.0, 0.1)
    xi = np.linspace(-1.18, -0.071, 23)
    sample = found(xi * 0.2, 0.2)
    c1 = math.sqrt(1.4)
    u = 2 / 2.4 * (c1 + xi)
    assert sample["velocity"] == pytest.approx(u, abs=1e-10)
    assert sample["density"] == pytest.approx((1 - 0.2 * u / c1) ** 5, rel=1e-9)
    assert sample["pressure"] == pytest.approx((1 - 0.2 * u / c1) ** 7, rel=1e-9)
    edges = found(np.array([-1.3, 0.9, 0.93, 1.74, 1.76]), 1.0)
    assert edges["density"] == pytest.approx([1.0, 0.4263194281, 0.2655737117, 0.2655737117, 0.125], abs=1e-9)
    assert list(edges["side"]) == [-1, -1, 1, 1, 1]


def test_b2_leblanc():
    left, right = (state(MONATOMIC, density=r, energy=e) for r, e in ((1.0, 0.1), (1e-3, 1e-7)))
    found = riemann(MONATOMIC, left, MONATOMIC, right)
    assert found.pressure == pytest.approx(5.155779277e-4, rel=1e-9)
    assert found.velocity == pytest.approx(0.6218386714, abs=1e-10)
    assert (found.left.behind.density, found.right.behind.density) == pytest.approx((0.05407933535, 0.00399999806), rel=1e-9)
    assert found.right.head == pytest.approx(0.8291183625, abs=1e-10)
    assert 3 + 6 * found.right.head == pytest.approx(7.97471, abs=1e-5)


def test_b3_receding_and_colliding():
    found = gas_problem(AIR, 1.0, -2.0, 0.4, 1.0, 2.0, 0.4)
    assert found.pressure == pytest.approx(0.00189387342, rel=1e-8)
    assert found.velocity == pytest.approx(0.0, abs=1e-13)
    found = gas_problem(AIR, 5.99924, 19.5975, 460.894, 5.99242, -6.19633, 46.0950)
    assert (found.pressure, found.velocity) == pytest.approx((1691.646955, 8.689774412), rel=1e-9)


def test_b13_stiffened_liquid_and_gas():
    liquid, gas = StiffenedGas(4.4, 6e8, 1000.0), IdealGas(1.4)
    found = riemann(liquid, state(liquid, density=1000.0, pressure=1e9), gas, state(gas, density=50.0, pressure=1e5))
    assert found.pressure == pytest.approx(1.41904772e7, rel=1e-8)
    assert found.velocity == pytest.approx(482.610412, abs=1e-6)
    assert (found.left.behind.density, found.right.behind.density) == pytest.approx((804.444632, 288.168063), abs=1e-6)
    assert found.right.head == pytest.approx(583.927609, abs=1e-6)


@pytest.mark.parametrize(("flyer", "target", "velocity", "pressure", "up", "us"), [
    (AL, AL, 1900.0, 17.45957e9, 950.0, 6599.1), (AL, AL, 1200.0, 10.24457e9, 600.0, None),
    (CU, AL, 1000.0, 12.06699e9, 692.7178, None), (W, FE, 1500.0, 43.69319e9, 1009.689, None)])
def test_b20_flyers(flyer, target, velocity, pressure, up, us):
    found = riemann(flyer, reference(flyer, velocity), target, reference(target))
    assert found.velocity == pytest.approx(up, abs=6e-5 if up != 1009.689 else 6e-4)
    assert found.pressure == pytest.approx(pressure, rel=5e-7)
    if us:
        assert found.right.head == pytest.approx(us, abs=0.05)


def test_h1_h2_symmetric_impact_halves_the_velocity():
    for velocity in (1200.0, 1900.0):
        found = riemann(AL, reference(AL, velocity), AL, reference(AL))
        assert found.velocity == pytest.approx(velocity / 2, rel=1e-12)
        assert found.pressure == pytest.approx(2785.0 * (5328.0 + 1.338 * velocity / 2) * velocity / 2, rel=1e-12)


@pytest.mark.parametrize("law", [AL, StiffenedGas(4.4, 6e8, 1000.0), AIR])
def test_waves_obey_jumps_and_isentropes(law):
    start = reference(law)
    c = start.sound_speed
    left, right = state(law, 0.5 * c, density=1.1 * start.density, pressure=start.pressure + 0.2 * start.density * c**2), start
    found = riemann(law, left, law, right)
    for wave, ahead in ((found.left, left), (found.right, right)):
        if wave.kind == "shock":
            assert residual(law, Initial.of(ahead), wave.behind) < 1e-12
        else:
            again = isentrope(law, ahead, density=wave.behind.density, direction=wave.direction)
            assert again.particle_velocity == pytest.approx(wave.behind.particle_velocity, abs=1e-9 * c)
    assert found.left.behind.particle_velocity == pytest.approx(found.right.behind.particle_velocity, abs=1e-10 * c)
    # Galilean shift and mirror
    shifted = riemann(law, state(law, left.particle_velocity + 77.0, density=left.density, pressure=left.pressure), law,
                      state(law, right.particle_velocity + 77.0, density=right.density, pressure=right.pressure))
    assert shifted.pressure == pytest.approx(found.pressure, rel=1e-9)
    mirrored = riemann(law, state(law, -right.particle_velocity, density=right.density, pressure=right.pressure), law,
                       state(law, -left.particle_velocity, density=left.density, pressure=left.pressure))
    assert mirrored.velocity == pytest.approx(-found.velocity, abs=1e-9 * c)


def test_vacuum_between_gases_is_the_escape_velocity():
    found = gas_problem(AIR, 1.0, -10.0, 1.0, 0.5, 9.0, 0.2)
    assert found.vacuum and math.isnan(found.velocity)
    assert found.left.behind.particle_velocity == pytest.approx(-10.0 + 5 * math.sqrt(1.4), rel=1e-12)
    assert found.right.behind.particle_velocity == pytest.approx(9.0 - 5 * math.sqrt(1.4 * 0.4), rel=1e-12)
    assert found(0.0)["density"] == 0.0 and found(0.0)["side"] == 0


def test_solid_receding_from_a_gas_and_a_feeble_impact():
    """The gas follows as behind a piston: p = p0 (1 - (gamma - 1) U / (2 c0))^(2 gamma/(gamma - 1)) to the copper's compliance."""
    air = reference(AIR)
    found = riemann(CU, reference(CU, -500.0), AIR, air)
    expected = air.pressure * (1 - 0.2 * 500.0 / air.sound_speed) ** 7
    assert not found.vacuum and found.pressure == pytest.approx(expected, rel=1e-5)
    feeble = riemann(CU, reference(CU, 1e-3), AL, reference(AL))
    z1, z2 = 8930.0 * 3940.0, 2785.0 * 5328.0
    assert feeble.pressure == pytest.approx(1e-3 * z1 * z2 / (z1 + z2), rel=1e-6)
    assert feeble.right.behind.shock_velocity == pytest.approx(5328.0, rel=1e-6)


def test_bodies_part_unless_bonded():
    apart = riemann(CU, reference(CU, -100.0), AL, reference(AL))
    assert apart.vacuum and apart.left.behind.particle_velocity == -100.0
    held = riemann(CU, reference(CU, -100.0), AL, reference(AL), bonded=True)
    assert not held.vacuum and held.pressure < 0.0
    z1, z2 = 8930.0 * 3940.0, 2785.0 * 5328.0
    assert held.pressure == pytest.approx(-100.0 * z1 * z2 / (z1 + z2), rel=0.05)  # acoustic estimate


@pytest.mark.parametrize("seed", range(4))
def test_any_two_laws_meet(seed):
    """Pairs drawn from the registry, thrown together or apart at 10 m/s to 8 km/s: one pressure and one velocity, or a gap under none."""
    rng = np.random.default_rng(seed)
    # a table's example ends at 100 GPa, as it says; a power law presses at any density, and reaches no pressure at no finite one
    laws = [law for law in EOS if law.name not in ("table", "power_law")]
    for _ in range(25):
        left, right = (law.example for law in rng.choice(laws, 2))
        speed = rng.choice([10.0, 100.0, 500.0, 2e3, 8e3]) * rng.choice([-1.0, 1.0])
        found = riemann(left, replace(reference(left), particle_velocity=speed), right, reference(right))
        p, q = found.left.behind.pressure, found.right.behind.pressure
        u, w = found.left.behind.particle_velocity, found.right.behind.particle_velocity
        if found.vacuum:
            assert u <= w and max(abs(p), abs(q)) < 1e-3 * abs(speed) ** 2
        else:
            assert p == pytest.approx(q, rel=1e-10, abs=1e-3) and u == pytest.approx(w, rel=1e-8, abs=1e-8 * abs(speed))
        for wave in (found.left, found.right):
            if wave.kind == "shock":
                assert residual(wave.ahead.par, Initial.of(wave.ahead), replace(wave.behind, shock_velocity=wave.head)) < 1e-12
