"""Silica powder between PMMA plates (source Jordan, chapters 4 and 5): what each order of the cold curve bears, the first shock, the ring-up.

Impedance matching by hand: the front plate releases from the state of equal plates on impact until the powder's p = rho0 (c0 + s u) u meets it;
at the end of the ring-up it has been shocked again, against the back plate, and the powder between them has their pressure.
"""

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.eos import grain_contact, mie_gruneisen_cold, mie_gruneisen_cold_series
from hugoniot.laws.eos.contract import pressure, pressure_derivatives
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.problem import catalogue
from hugoniot.problem.model import OutputOptions, Problem, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.theory.hugoniot import shock

PMMA = Material("pmma", MieGruneisen(1186.0, 2598.0, 1.516, 0.97))
POWDERS = {100.0: (121.0, 0.9736), 250.0: (97.0, 1.2509), 770.0: (1070.9, 0.4045)}     # table 7.2.1 with J-E10
SPEEDS = (220.0, 405.0, 900.0, 1100.0)
DEPTH, BEGIN = 2e-3, 240     # of the powder, and its first zone


def powder(rho0, order):
    """The powder's law: a series of that order, the exact curve ("exact"), or that with the contact of its grains ("grains")."""
    c0, s = POWDERS[rho0]
    if order == "exact":
        return mie_gruneisen_cold.MieGruneisenCold(rho0, c0, s, 0.3)
    if order == "grains":
        return grain_contact.build(powder(rho0, "exact"), 2200.0, 23.4e9, 4.34)     # U212 of the library: rho0 c0^2 and 4 s - 1
    return mie_gruneisen_cold_series.build(rho0, c0, s, 0.3, order)


def sandwich(rho0, speed, order, crossings=3.0):
    """A 10 mm flyer on 2 mm of PMMA, 2 mm of powder and 15 mm of PMMA, for so many times the shock takes through the powder."""
    u, shock_velocity = first_shock(rho0, speed)
    stop = 2e-3 / (2598.0 + 0.5 * 1.516 * speed) + crossings * DEPTH / shock_velocity
    ends, zones, names = (0.0, 10e-3, 12e-3, 14e-3, 29e-3), (200, 40, 200, 300), ("flyer", "front", "powder", "back")
    regions = tuple(Region(name, "silica" if name == "powder" else "pmma", a, b, n, velocity=speed if name == "flyer" else 0.0)
                    for name, a, b, n in zip(names, ends, ends[1:], zones))
    return Problem("silica powder", "planar", stop, regions, {"pmma": PMMA, "silica": Material("silica", powder(rho0, order))},
                   output=OutputOptions(report=False))


def released(rho0, speed):
    """(p, v, e, u) of the front plate where its release isentrope, here integrated, meets the powder's first shock."""
    rho, c, s, gamma = 1186.0, 2598.0, 1.516, 0.97
    half = 0.5 * speed
    p, eta = rho * (c + s * half) * half, half / (c + s * half)
    e, v, u = 0.5 * half**2, (1.0 - eta) / rho, half
    law = MieGruneisen(rho, c, s, gamma)
    c0, slope = POWDERS[rho0]
    step = 2e-5 * v
    while p > rho0 * (c0 + slope * u) * u:
        p_rho, p_e = pressure_derivatives(1.0 / v, e, law)
        impedance = np.sqrt(max(p_rho + p * p_e * v * v, 0.0)) / v
        v, e, u = v + step, e - p * step, u + impedance * step
        p = pressure(1.0 / v, e, law)
    return p, v, e, u


def first_shock(rho0, speed):
    """(particle velocity, shock velocity) in the powder."""
    u = released(rho0, speed)[3]
    return u, POWDERS[rho0][0] + POWDERS[rho0][1] * u


def plates(rho0, speed):
    """Pressure to which the plates ring the powder up: the released front plate shocked again meets the back plate's Hugoniot."""
    p1, v1, e1, u1 = released(rho0, speed)

    def again(v):
        """On the second Hugoniot: the law is linear in the energy e1 + (p + p1)(v1 - v)/2."""
        return pressure(1.0 / v, e1 + 0.5 * p1 * (v1 - v), PMMA.eos) / (1.0 - 0.5 * 1186.0 * 0.97 * (v1 - v))

    def excess(v):
        u = u1 - np.sqrt((again(v) - p1) * (v1 - v))
        return again(v) - 1186.0 * (2598.0 + 1.516 * u) * u

    return again(brentq(excess, 0.75 * v1, (1.0 - 1e-6) * v1))


def march_to(solver, time):
    """Through whatever events come."""
    while solver.time < time:
        solver.march(time, 10**6)
    return solver.state()


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("rho0", POWDERS)
def test_the_exact_curve_carries_the_first_shock_at_every_speed_and_density(rho0, speed):
    """Plateau pressure within 1.5 %, particle and shock velocity within 1 % of impedance matching (asked: 2 %).

    The pressure is 1.3 % high behind the fastest plate over the lightest powder: the shock that meets the powder is as wide as the viscosity
    of the plate makes it (0.7 % with `linear_condensed = 0.3`).
    """
    u, shock_velocity = first_shock(rho0, speed)
    solver, fronts = make_solver(sandwich(rho0, speed, "grains", crossings=0.8)), []
    stop = solver.problem.stop_time
    for time in (stop - 0.4 * DEPTH / shock_velocity, stop):
        state = march_to(solver, time)
        squeezed = state.zones["density"][BEGIN:BEGIN + 200] / rho0
        half = 0.5 * (1.0 + np.median(squeezed[5:30]))
        last = int(np.flatnonzero(squeezed > half)[-1])
        fronts.append((time, (last + (squeezed[last] - half) / (squeezed[last] - squeezed[last + 1])) * DEPTH / 200))
    here = slice(BEGIN + 20, BEGIN + 100)
    assert np.mean(state.zones["pressure"][here]) == pytest.approx(rho0 * shock_velocity * u, rel=0.015)
    assert np.mean(0.5 * (state.velocity_left + state.velocity_right)[here]) == pytest.approx(u, rel=0.01)
    assert (fronts[1][1] - fronts[0][1]) / (fronts[1][0] - fronts[0][0]) == pytest.approx(shock_velocity, rel=0.01)
    assert solver.errors()["energy_error"] < 1e-12


@pytest.mark.parametrize("speed, expected", [(900.0, 1.7468e9), (1100.0, 2.2315e9)])
def test_the_plates_ring_the_lightest_powder_up_to_their_own_pressure(speed, expected):
    """Denser than its grains; at 1100 m/s the back gauge of Jordan reads 2.25 GPa, where the fit alone bears 1.8 GPa at no volume at all."""
    solver = make_solver(sandwich(100.0, speed, "grains", crossings=2.2))
    found = march_to(solver, solver.problem.stop_time)
    here = slice(BEGIN, BEGIN + 200)
    assert plates(100.0, speed) == pytest.approx(expected, rel=1e-4)
    assert np.median(found.zones["pressure"][here]) == pytest.approx(expected, rel=5e-3)
    assert 2300.0 < np.median(found.zones["density"][here]) < 2400.0
    assert solver.errors()["energy_error"] < 1e-12


def as_004_had_it(deck):
    """The deck with the law it carries as a comment, a series without grains, in the place of its own."""
    head, rest = deck.split("[material.silica.eos]", 1)
    comment, tail = rest[rest.index("# [material.silica.eos]"):].split("[[gauge]]", 1)
    return head + comment.replace("# ", "", 1).replace("\n# ", "\n") + "[[gauge]]" + tail


def test_order_3_collapses_in_the_first_powder_zones_and_says_why(tmp_path):
    """Jordan at 0.10 g/cm3 and 405 m/s: volumes of cells go to zero at the first silica cells, zone 600 and those behind it. Exit code 3,
    the zone, cause and remedy."""
    (tmp_path / "silica.toml").write_text(as_004_had_it(catalogue.deck_text("silica-powder")), encoding="utf-8")
    found = CliRunner().invoke(build_app("run"), ["run", str(tmp_path / "silica.toml"), "--out", str(tmp_path / "silica.run")])
    told = " ".join(found.output.split())
    assert found.exit_code == 3
    assert re.search("zone 60[0-2] of region 'powder'", told) and "zone collapsed: its equation of state cannot support more than" in told
    assert "grain_contact" in told.split("zone collapsed")[1] and "mie_gruneisen_cold" in told.split("zone collapsed")[1]


# the table of docs/theory/porous.md: how the runs end over three crossings; None: it ran
SHOCK, RING = "first shock", "ring-up"
ENDS = {
    100.0: {3: (SHOCK,) * 4, 4: (RING, SHOCK, SHOCK, SHOCK), 5: (RING, SHOCK, SHOCK, SHOCK), 6: (RING, RING, SHOCK, SHOCK),
            "exact": (None, None, RING, RING), "grains": (None,) * 4},
    250.0: {3: (SHOCK,) * 4, 4: (RING, SHOCK, SHOCK, SHOCK), 5: (RING, SHOCK, SHOCK, SHOCK), 6: (RING, RING, SHOCK, SHOCK), "exact": (None,) * 4,
            "grains": (None,) * 4},
    770.0: {3: (None, None, None, RING), 4: (None, None, None, RING), 5: (None,) * 4, 6: (None,) * 4, "exact": (None,) * 4,
            "grains": (None,) * 4},
}


@pytest.mark.slow
@pytest.mark.parametrize("order", [3, 4, 5, 6, "exact", "grains"])
@pytest.mark.parametrize("rho0", POWDERS)
def test_the_table_of_densities_speeds_and_orders(rho0, order):
    for speed, end in zip(SPEEDS, ENDS[rho0][order]):
        problem = sandwich(rho0, speed, order)
        solver = make_solver(problem)
        if end is None:
            march_to(solver, problem.stop_time)
            assert solver.errors()["energy_error"] < 1e-12
            continue
        with pytest.raises(UnphysicalState, match="cannot support more than") as told:
            march_to(solver, problem.stop_time)
        _, shock_velocity = first_shock(rho0, speed)
        crossed = problem.stop_time - 2.0 * DEPTH / shock_velocity
        assert ("powder" in str(told.value)) and (told.value.time < crossed) == (end == SHOCK), (speed, told.value.time / crossed)


def apart(one, two):
    """Largest difference of two states in pressure, density or energy, over the largest value."""
    return max(np.abs(one.zones[name] - two.zones[name]).max() / np.abs(one.zones[name]).max() for name in ("pressure", "density", "energy"))


@pytest.mark.slow
@pytest.mark.parametrize("rho0", POWDERS)
def test_the_contact_of_the_grains_leaves_the_first_shock_alone(rho0):
    """As far as the last digits of the flyer's speed do. Below its contact the law returns its base's numbers, but a processor sums the two
    laws in another order, and the viscosity's limiter makes the differences grow: with the thin shock to 1.5e-11 to 8e-11, on some
    processors to 1e-9. At 100 kg/m3 and 220 m/s a limit that one step meets or misses by its last digit leaves two sets of runs, 1.4e-7
    apart; the run with grains belongs to either. With the wide shock (`linear_condensed` = 1) the differences grow steadily inside the
    front, to 4e-3 at 0.77 g/cm3 and 900 m/s.
    """
    thin = SolverOptions(viscosity=("limited", {"linear": 0.3, "linear_condensed": 0.3}))

    def found(order, speed, digits=0):
        problem = replace(sandwich(rho0, speed, order, crossings=0.95), solver=thin)
        nudged = tuple(replace(region, velocity=region.velocity * (1.0 + digits * 2.0**-52)) for region in problem.regions)
        return march_to(make_solver(replace(problem, regions=nudged)), problem.stop_time)

    for speed in SPEEDS:
        grains = found("grains", speed)
        assert min(apart(found("exact", speed, digits), grains) for digits in (-2, -1, 0, 1, 2, 3, 4)) < 3e-9, speed


@pytest.mark.slow
@pytest.mark.parametrize("speed", SPEEDS[1:])
def test_a_truncated_curve_with_grains_is_swept_up_to_their_density(speed):
    """The first shock is that of a snow plough, slower than the powder's; a lower Courant number lets soft zones meet their grains. At
    220 m/s they are torn first, where the truncated curve has no sound speed."""
    truncated = sandwich(100.0, speed, 3, crossings=0.8)
    law = grain_contact.build(truncated.materials["silica"].eos, 2200.0, 23.4e9, 4.34)
    solver = make_solver(replace(truncated, materials={"pmma": PMMA, "silica": Material("silica", law)},
                                 solver=replace(truncated.solver, courant=0.1)))
    found = march_to(solver, truncated.stop_time)
    assert np.median(found.zones["density"][BEGIN + 20:BEGIN + 100]) == pytest.approx(2200.0, rel=1e-2)


@pytest.mark.slow
@pytest.mark.parametrize("speed, expected", [(900, 1.7468e9), (1100, 2.2315e9)])
def test_the_deck_runs_at_other_speeds(tmp_path, speed, expected):
    (tmp_path / "silica.toml").write_text(catalogue.deck_text("silica-powder").replace('"405 m/s"', f'"{speed} m/s"'), encoding="utf-8")
    run = hugoniot.run(tmp_path / "silica.toml", out=tmp_path / "silica.run")
    time, stress = run.gauge("stress", "back of powder")
    assert np.mean(stress[(time > 4e-6) & (time < 5.5e-6)]) == pytest.approx(expected, rel=1e-3)
    assert run.summary["energy_error"] < 1e-12


@pytest.mark.parametrize("rho0, end", [(100.0, 4583.3), (770.0, 1798.3)])
def test_powders_with_a_slope_below_1_have_no_shock_beyond_their_limit(rho0, end):
    law = powder(rho0, "exact")
    assert shock(law, particle_velocity=0.99 * end).shock_velocity > 0.99 * end
    with pytest.raises(OutOfRange, match="particle velocit"):
        shock(law, particle_velocity=1.01 * end)
