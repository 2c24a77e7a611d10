"""The solvers' Riemann solver against the independent one of `theory`, exact elastic-plastic waves and the conservation laws."""

import math

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.eos.tillotson import Tillotson
from hugoniot.laws.riemann.branch import Matter, State, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve
from hugoniot.laws.riemann.solver import contact, riemann, surface, wall
from hugoniot.theory import riemann as reference
from hugoniot.theory.exact.elastic_plastic_piston import ALUMINIUM, COPPER, elastic_plastic_piston
from hugoniot.theory.isentrope import state as reference_state

AIR, WATER = IdealGas(1.4), StiffenedGas(4.4, 6e8)
LAWS = {"air": AIR, "water": WATER, "aluminium": EOS.get("mie_gruneisen").example, "products": EOS.get("jwl").example,
        "tillotson": EOS.get("tillotson").example, "cold curve": EOS.get("mie_gruneisen_cold").example}


def at(par, rho, u, p):
    from hugoniot.materials.initial_state import energy_at_pressure

    return State(rho, u, float(energy_at_pressure(rho, p, par)), p)


def given(par, state):
    return reference_state(par, velocity=state.u, density=state.rho, energy=state.e)


@pytest.mark.parametrize("left, right, star", [
    ((AIR, (1.0, 0.0, 1.0)), (AIR, (0.125, 0.0, 0.1)), (0.3031301780, 0.9274526200)),
    ((IdealGas(5 / 3), (1.0, 0.0, 0.2 / 3)), (IdealGas(5 / 3), (1e-3, 0.0, 2e-10 / 3)), (5.155779277e-4, 0.6218386714)),
    ((AIR, (1.0, -2.0, 0.4)), (AIR, (1.0, 2.0, 0.4)), (0.00189387342, 0.0)),
    ((AIR, (5.99924, 19.5975, 460.894)), (AIR, (5.99242, -6.19633, 46.095)), (1691.646955, 8.689774412)),
    ((WATER, (1000.0, 0.0, 1e9)), (AIR, (50.0, 0.0, 1e5)), (1.41904772e7, 482.610412)),
])
def test_tubes_agree_with_the_reference_to_round_off(left, right, star):
    (a, la), (b, rb) = left, right
    states = at(a, *la), at(b, *rb)
    found = riemann(Matter(a), states[0], Matter(b), states[1])
    exact = reference.riemann(a, given(a, states[0]), b, given(b, states[1]))
    assert found.stress == pytest.approx(star[0], rel=1e-8)
    assert found.stress == pytest.approx(exact.pressure, rel=1e-12)
    assert found.velocity[0] == pytest.approx(exact.velocity, rel=1e-12, abs=1e-13)
    for mine, theirs in ((found.left[0], exact.left), (found.right[0], exact.right)):
        assert mine.kind == theirs.kind
        assert (mine.head, mine.tail) == pytest.approx((theirs.head, theirs.tail), rel=1e-12)
        assert mine.behind.rho == pytest.approx(theirs.behind.density, rel=1e-12)


@pytest.mark.parametrize("first", sorted(LAWS))
@pytest.mark.parametrize("second", ["air", "aluminium", "products"])
def test_any_two_laws_agree_with_the_reference(first, second):
    a, b = LAWS[first], LAWS[second]
    for speed in (300.0, 1500.0, -200.0):
        sides = []
        for par, u, p in ((a, speed, 4e9), (b, 0.0, 1e9)):
            rho, e = contract.reference_state(par)
            held = "reacted" in EOS.of(par).flags or par is LAWS["tillotson"]     # their own rest state; the others squeezed
            rho *= 1.0 if held else 1.01      # at its rest density itself a solid is taken for a gas by the reference
            sides.append(State(rho, u, e, contract.pressure(rho, e, par)) if held else at(par, rho, u, 1e5 if par is AIR else p))
        found = riemann(Matter(a), sides[0], Matter(b), sides[1])
        exact = reference.riemann(a, given(a, sides[0]), b, given(b, sides[1]))
        assert found.vacuum == exact.vacuum
        if found.vacuum:
            edges = exact.left.behind.particle_velocity, exact.right.behind.particle_velocity
            assert found.velocity == pytest.approx(edges, rel=1e-8)
        else:
            c = math.sqrt(wave_speed_squared(sides[1].rho, sides[1].e, Curve(Matter(b), sides[1], 1).branch))
            assert found.stress == pytest.approx(exact.pressure, rel=1e-9, abs=1e-12 * sides[1].rho * c * c)
            assert found.velocity[0] == pytest.approx(exact.velocity, rel=1e-9, abs=1e-9 * c)


def test_every_jump_conserves_mass_momentum_and_energy():
    rng = np.random.default_rng(3)
    for par in (AIR, WATER, LAWS["aluminium"], LAWS["products"]):
        rho0, e0 = contract.reference_state(par)
        ahead = State(rho0, 100.0, e0, contract.pressure(rho0, e0, par))
        c2 = wave_speed_squared(rho0, e0, Curve(Matter(par), ahead, 1).branch)
        for scale in 10.0 ** rng.uniform(-9, 0.5, 20):
            wave = Curve(Matter(par), ahead, 1).waves(ahead.sigma + scale * rho0 * c2)[0]
            a, b, s = wave.ahead, wave.behind, wave.head
            energies = [x.rho * (x.e + 0.5 * x.u**2) for x in (a, b)]
            assert b.rho * (s - b.u) == pytest.approx(a.rho * (s - a.u), rel=1e-13)
            assert b.rho * b.u * (s - b.u) - b.sigma == pytest.approx(a.rho * a.u * (s - a.u) - a.sigma, rel=1e-12, abs=1e-13 * rho0 * c2)
            assert energies[1] * (s - b.u) - b.sigma * b.u == pytest.approx(energies[0] * (s - a.u) - a.sigma * a.u, rel=1e-12,
                                                                           abs=1e-12 * rho0 * c2 * s)
            assert contract.pressure(b.rho, b.e, par) == pytest.approx(b.sigma, rel=1e-11, abs=1e-13 * rho0 * c2)


def test_a_fan_keeps_entropy_and_its_characteristics():
    for par, name in ((LAWS["products"], "jwl"), (LAWS["aluminium"], "mie_gruneisen")):
        rho0, e0 = contract.reference_state(par)
        hot = State(1.3 * rho0, 0.0, e0 + 1e6, contract.pressure(1.3 * rho0, e0 + 1e6, par))
        wave = Curve(Matter(par), hot, 1).waves(0.3 * hot.sigma)[0]
        for xi in np.linspace(wave.tail, wave.head, 7)[1:-1]:
            node = wave.path.at_characteristic(xi - hot.u)
            here = wave.path.state(node, 1)
            assert here.u + wave.path.speed(node) == pytest.approx(xi, rel=1e-12)
            exact = reference_state(par, velocity=0.0, density=hot.rho, energy=hot.e)
            from hugoniot.theory.isentrope import isentrope

            there = isentrope(par, exact, density=here.rho, direction=1)
            assert here.e == pytest.approx(there.specific_internal_energy, rel=1e-10), name
            assert here.u == pytest.approx(there.particle_velocity, rel=1e-9)


@pytest.mark.parametrize("solid, speed", [(ALUMINIUM, 400.0), (COPPER, 20.0), (ALUMINIUM, 20.0), (ALUMINIUM, 3000.0)])
def test_elastic_precursor_and_plastic_shock_are_the_exact_ones(solid, speed):
    par = MieGruneisen(rho0=solid.rho0, c0=solid.c0, s=solid.s, gamma0=solid.gamma0)
    matter = Matter(par, solid.shear_modulus, solid.yield_stress)
    found = wall(Curve(matter, State(solid.rho0, 0.0, 0.0, 0.0), 1), speed)
    exact = elastic_plastic_piston(solid, speed).numbers
    assert len(found.right) == exact["wave_count"]
    for wave, label in ((found.right[0], "elastic"), (found.right[-1], "plastic")):
        assert wave.behind.sigma == pytest.approx(exact[f"{label}_stress"], rel=1e-10)
        assert wave.head == pytest.approx(exact[f"{label}_wave_speed"], rel=1e-10)
        assert wave.behind.rho == pytest.approx(exact[f"{label}_density"], rel=1e-10)


def test_release_of_a_yielded_solid_is_elastic_then_plastic():
    matter = Matter(LAWS["aluminium"], 27.6e9, 0.3e9)
    rho0 = contract.reference_state(matter.par)[0]
    pushed = wall(Curve(matter, State(rho0, 0.0, 0.0, 0.0), 1), 400.0).right[-1].behind
    assert pushed.s == pytest.approx(-0.2e9, rel=1e-12)
    freed = surface(Curve(matter, pushed, -1), 0.0).left
    assert [w.elastic for w in freed] == [True, False] and freed[-1].behind.s == pytest.approx(0.2e9, rel=1e-12)
    # the elastic release spans twice the yield strain, ln(rho1/rho2) = (4Y/3)/(4G/3) = Y/G
    assert math.log(freed[0].ahead.rho / freed[0].behind.rho) == pytest.approx(0.3 / 27.6, rel=1e-9)
    assert freed[0].tail < freed[1].head


def test_two_gases_that_part_leave_a_vacuum_and_a_bond_bears_tension():
    a = State(1.0, -20.0, 1.0, 0.4)
    found = contact(Curve(Matter(AIR), a, -1), Curve(Matter(AIR), a._replace(u=20.0), 1))
    c = math.sqrt(1.4 * 0.4)
    assert found.vacuum and found.velocity == pytest.approx((-20.0 + 5.0 * c, 20.0 - 5.0 * c), rel=1e-13)
    metal = LAWS["aluminium"]
    rho0, e0 = contract.reference_state(metal)
    still = State(rho0, 0.0, e0, 0.0)
    sides = Curve(Matter(metal), still._replace(u=-10.0), -1), Curve(Matter(metal), still._replace(u=10.0), 1)
    assert contact(*sides).vacuum and contact(*sides).velocity == (-10.0, 10.0)
    bonded = contact(*sides, bonded=True)
    impedance = rho0 * math.sqrt(wave_speed_squared(rho0, e0, sides[0].branch))
    assert bonded.stress == pytest.approx(-10.0 * impedance, rel=0.01)


def test_a_law_that_ends_says_so():
    lead = State(1.0, 0.0, -1e3, -400.0)
    with pytest.raises(OutOfRange, match="not a valid state"):
        Curve(Matter(AIR), lead, 1)


def test_jwl_is_the_law_of_the_library():
    assert isinstance(LAWS["products"], JWL) and isinstance(LAWS["tillotson"], Tillotson)
