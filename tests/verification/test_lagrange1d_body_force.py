"""Body force: a column in equilibrium stays so, a free body falls as it must, work and impulse are booked."""

import numpy as np
import pytest

from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck_text
from hugoniot.solvers.lagrange1d.layout import Z
from hugoniot.solvers.lagrange1d.solver import Lagrange1D

GAS = '[material.gas.eos]\nlaw = "ideal_gas"\ngamma = 1.4\nrho0 = 1.2\nspecific_heat = 717.5\n'


def deck(regions, more="", geometry="planar", stop="1 s", integrator="compatible"):
    rows = "".join(f'[[region]]\nname = "{n}"\nmaterial = "gas"\nfrom = {a}\nto = {b}\nzones = {z}\n{rest}\n' for n, a, b, z, rest in regions)
    return f'geometry = "{geometry}"\nstop_time = "{stop}"\n{rows}\n{GAS}\n{more}\n[solver]\nintegrator = "{integrator}"\n'


def solver_of(*args, **kwargs):
    return Lagrange1D(read_deck_text(deck(*args, **kwargs), "deck.toml").problem)


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_column_in_equilibrium_stays_so_for_a_hundred_thousand_steps(integrator):
    """1 km of air of uniform density on the ground: p falls by rho g dx from zone to zone, by half of that to the top."""
    count, dx, top, rho, g = 20, 50.0, 1e5, 1.2, 9.81
    rows = [(f"z{k}", k * dx, (k + 1) * dx, 1, f"density = {rho}\npressure = {top + rho * g * dx * (count - k - 0.5)!r}") for k in range(count)]
    more = f"[boundary]\nleft = \"fixed\"\nright = {{pressure = {top}}}\n[body_force]\nacceleration = {-g}\n"
    held = solver_of(rows, more, stop="1e6 s", integrator=integrator)
    before = held.state()
    held.march(1e6, 100_000)
    after = held.state()
    assert held.cycle == 100_000
    sound = np.sqrt(1.4 * top / rho)
    assert np.abs(after.velocity_left).max() < 1e-9 * sound
    assert np.abs(after.zones["pressure"] / before.zones["pressure"] - 1.0).max() < 1e-9
    assert held.errors()["energy_error"] < 1e-12 and held.errors()["momentum_error"] < 1e-9


@pytest.mark.parametrize("integrator, tight", [("compatible", 1e-12), ("wilkins", 2e-3)])
def test_a_body_that_nothing_holds_falls_freely(integrator, tight):
    """In vacuum, a gas too cold to spread, the acceleration rising to 4 m/s2 in 1 s: u = 2 m/s, and the work is the kinetic energy.

    The velocities of the leapfrog stand half a step of 1 ms behind: 1e-3 of u, 2e-3 of its square.
    """
    more = "[body_force]\nacceleration = {times = [0, 1], values = [0, 4]}\n"
    text = deck([("body", 0.0, 1.0, 10, "density = 1.2\npressure = 1e-12")], more, integrator=integrator)
    run = Lagrange1D(read_deck_text(text + "largest_step = 1e-3\n", "deck.toml").problem)
    while run.time < 1.0:
        run.march(1.0, 10_000)
    assert run.momentum() == pytest.approx(1.2 * 2.0, rel=0.5 * tight + 1e-8)
    assert run.exchanges()["force_work"] == pytest.approx(0.5 * 1.2 * 4.0, rel=tight + 1e-6)
    assert run.errors()["energy_error"] < tight and run.errors()["momentum_error"] < 1e-12


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_the_impulse_of_the_force_is_that_on_the_whole_mass_when_a_gap_has_closed(integrator):
    """g M t; once two surfaces are one, a node fewer is there."""
    rows = [("one", 0.0, 1.0, 10, "velocity = 300\npressure = 1e4"), ("other", 1.01, 2.0, 10, "pressure = 1e4")]
    run = solver_of(rows, "[body_force]\nacceleration = 1e4\n", stop="2 ms", integrator=integrator)
    mass = run.zones[Z.mass].sum()
    while run.time < 2e-3:
        run.march(2e-3, 10_000)
    assert run.counts()["voids_closed"] == 1
    assert run.exchanges()["force_impulse"] == pytest.approx(mass * 1e4 * 2e-3, rel=0.01 if run.staggered else 1e-12)
    assert run.errors()["momentum_error"] < 1e-12 and (run.staggered or run.errors()["energy_error"] < 1e-12)


def test_a_shell_falls_in_a_central_field():
    """A shell in the field of a point mass, too cold to spread: u^2 is twice the fall of the potential."""
    more = "[body_force]\nacceleration = -1.0\nexponent = -2\nradius = 1.0\n"
    text = deck([("shell", 2.0, 2.02, 4, "density = 1.2\npressure = 1e-14")], more, geometry="spherical", stop="0.5 s")
    run = Lagrange1D(read_deck_text(text + "largest_step = 1e-3\n", "deck.toml").problem)
    while run.time < 0.5:
        run.march(0.5, 10_000)
    state = run.state()
    fallen = (1.0 / state.position_left[2] - 0.5 / 1.005) * 2.0      # u^2 = 2 (1/r - 1/r0), middle node from 2.01 m
    assert state.velocity_left[2] ** 2 == pytest.approx(fallen, rel=1e-4)
    assert run.errors()["energy_error"] < 1e-12 and run.errors()["momentum_error"] < 1e-9


@pytest.mark.parametrize("geometry, force, words", [
    ("spherical", "acceleration = -9.81", "a uniform force has no spherical symmetry"),
    ("planar", 'acceleration = -9.81\nexponent = 1\nradius = "1 m"', "apply to curved geometry only"),
    ("planar", 'acceleration = "5 m/s"', "body_force.acceleration"),
])
def test_forces_that_cannot_be(geometry, force, words):
    with pytest.raises(DeckError, match=words):
        read_deck_text(deck([("body", 1.0, 2.0, 10, "")], f"[body_force]\n{force}\n", geometry=geometry), "deck.toml")


def test_a_resolved_deck_keeps_its_terms():
    more = "[body_force]\nacceleration = {shape = \"ramp\", amplitude = 3, duration = \"1 ms\"}\n" \
           "[[heat_source]]\nregion = \"body\"\nintensity = \"1 GW/m^2\"\nabsorption_length = \"1 mm\"\n" \
           "[transport.gas]\nviscosity = {law = \"constant\", shear_viscosity = 1e-5}\n"
    found = read_deck_text(deck([("body", 1.0, 2.0, 10, "")], more), "deck.toml")
    again = read_deck_text(found.resolved, "deck.toml")
    assert again.problem == found.problem and found.problem.heat_sources[0].absorption_length == 1e-3
