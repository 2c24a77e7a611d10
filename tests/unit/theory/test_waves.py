"""Wave diagrams: times and places of the classical flyer-plate problem, conservation, ring-up, spall tension, gaps."""

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import ring_up
from hugoniot.theory.isentrope import release
from hugoniot.theory.waves import wave_diagram

AL = MieGruneisen(2785.0, 5328.0, 1.338, 2.0)
CU = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
PMMA = MieGruneisen(1186.0, 2598.0, 1.516, 0.97)
H, L, V = 2e-3, 4e-3, 700.0
US = 5328.0 + 1.338 * V / 2


def totals(diagram, e0=0.0):
    rows = [((b - a) * s.density, s.particle_velocity, s.specific_internal_energy) for a, b, _, s in diagram.profile()]
    m, u, e = np.array(rows).T
    return m.sum(), (m * u).sum(), (m * (e + 0.5 * u * u)).sum()


def test_first_meetings_are_where_they_must_be():
    found = wave_diagram([AL, AL], [H, L], V, 6.8e-7)
    impact, rear, *fans = found.events
    assert impact.left.pressure == pytest.approx(2785.0 * US * V / 2, rel=1e-10) and impact.time == 0.0
    # the flyer's shock runs at V - Us towards its rear, which comes at V
    assert rear.time == pytest.approx(H / US, rel=1e-12) and rear.met == ("surface", "shock")
    assert rear.position == pytest.approx(-H + V * H / US, rel=1e-9)
    # the free surface of the flyer then moves with V less the exact release
    state = shock(AL, pressure=impact.left.pressure)
    gain = release(AL, state).particle_velocity - state.particle_velocity
    assert found.fronts[0].velocity == pytest.approx(V / 2 - gain, abs=1e-8)
    arrival = H / US + H * 2785.0 / state.density / (state.sound_speed + 0.0)
    head = [e for e in fans if e.met == ("fan", "interface")][0]
    assert head.time == pytest.approx(arrival, rel=5e-3)  # the first step moves with the mean speed of its two states


@pytest.mark.parametrize(("fan", "momentum", "energy"), [(2, 3e-4, 2.5e-2), (8, 2e-5, 1.6e-3)])
def test_conservation_improves_as_the_square_of_the_step(fan, momentum, energy):
    mass, p, e = totals(wave_diagram([AL, AL], [H, L], V, 2.2e-6, fan=fan))
    assert mass == pytest.approx(2785.0 * (H + L), rel=1e-5)
    assert p == pytest.approx(2785.0 * H * V, rel=momentum)
    assert e == pytest.approx(0.5 * 2785.0 * H * V * V, rel=energy)


def test_tension_opens_no_bond_but_parts_separate_bodies():
    found = wave_diagram([AL, AL], [H, L], V, 1.35e-6, fan=4)
    spall = min(found.profile(), key=lambda piece: piece[3].pressure)
    assert -7e9 < spall[3].pressure < -4e9  # nearly the impact stress, reversed
    assert spall[0] < 0.236e-3 + (L - H) + 0.5e-3 and spall[1] > 0.236e-3 + (L - H) - 0.6e-3  # one flyer thickness from the rear
    later = wave_diagram([AL, AL], [H, L], V, 1.7e-6, fan=4)
    assert -1 in [cell.layer for cell in later.cells[1:-1]]  # the gap between flyer and target


def test_ring_up_is_that_of_impedance_matching():
    found = wave_diagram([CU, PMMA, CU], [20e-3, 1e-3, 20e-3], 555.0, 1.25e-6)
    expected = ring_up([CU, PMMA, CU], 555.0, bounces=6)
    assert [e.layers for e in found.events] == [(m.interface, m.interface + 1) for m in expected[: len(found.events)]]
    assert [e.left.pressure for e in found.events] == pytest.approx([m.pressure for m in expected[: len(found.events)]], rel=1e-9)
    assert found.events[1].time == pytest.approx(1e-3 / expected[0].right.shock_velocity, rel=1e-10)
    assert len(found.events) >= 7


def test_attenuation_begins_where_the_release_catches_the_shock():
    """H-4: X/h = (C + Us)/(C - Us) with C the Lagrangian sound speed behind the shock, rho c/rho0."""
    v = 1900.0
    state = shock(AL, particle_velocity=v / 2)
    c, us = state.density * state.sound_speed / 2785.0, float(state.shock_velocity)
    ratio = (c + us) / (c - us)
    found = wave_diagram([AL, AL], [1e-3, 14e-3], v, 1.95e-6, fan=32)
    catch = [e for e in found.events if e.met == ("fan", "shock")][0]
    assert catch.position / us < catch.time * 1.001
    assert catch.position * 1e3 == pytest.approx(ratio, rel=0.06)  # a fan of 32 steps: its first step is 1/64 of the pressure slow


def test_impossible_input():
    with pytest.raises(OutOfRange, match="positive thickness"):
        wave_diagram([AL, AL], [1e-3, -1e-3], 100.0, 1e-6)
    with pytest.raises(OutOfRange, match="interactions of waves"):
        wave_diagram([AL, AL], [H, L], V, 1e-3, most_events=30)
