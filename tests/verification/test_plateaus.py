"""Symmetric impact of plates: the plateau that a run reports is that of the jump conditions, and so is its peak."""

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot import run
from hugoniot.diagnostics.velocimetry import durations, flat_stretch, flat_top, plateau
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.material import Material
from hugoniot.output.run_numbers import gauge_rows, highest, highest_rows
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Pulse, Region
from hugoniot.problem.standard.parts import bonded
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.assemble import viscosity_in
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import free_surface
from hugoniot.theory.isentrope import state
from hugoniot.theory.riemann import riemann

LAWS = {"copper": MieGruneisen(8930.0, 3940.0, 1.489, 1.99), "LiF": MieGruneisen(2640.0, 5150.0, 1.35, 1.6)}


@pytest.mark.parametrize("material, speed", [("copper", 200.0), ("copper", 1000.0), ("copper", 2000.0), ("LiF", 1000.0), ("LiF", 2000.0)])
def test_the_plateaus_of_an_impact(tmp_path, material, speed):
    """rho0 (c0 + s v/2) v/2 and v/2 inside, by hand; at the surface that of the release from there."""
    law, thick = LAWS[material], 5e-3
    regions = (Region("flyer", "m", -thick, 0.0, 100, velocity=speed), Region("target", "m", 0.0, thick, 100))
    stop = 1.35 * thick / (law.c0 + law.s * speed / 2)
    problem = Problem("impact", "planar", stop, regions, {"m": Material("m", law)}, gauges=(Gauge("inside", 2e-3), Gauge("surface", thick)),
                      output=OutputOptions(report=False))
    rows = {row["gauge"]: row for row in gauge_rows(run(problem, tmp_path / "run"))}
    jump = law.rho0 * (law.c0 + law.s * speed / 2) * speed / 2
    assert rows["inside"]["plateau_stress"] == pytest.approx(jump, rel=1e-3)
    surface = rows["surface"]["plateau_velocity"]
    assert surface == pytest.approx(float(free_surface(law, shock(law, particle_velocity=speed / 2)).particle_velocity), rel=2e-3)
    # the overshoot of a numerical shock stays below half a percent
    assert rows["inside"]["peak_stress"] < 1.005 * jump
    assert surface <= rows["surface"]["peak_velocity"] < 1.005 * surface


@pytest.mark.parametrize("speed", [1000.0, 2000.0])
def test_strength_does_not_bring_the_overshoot_back(tmp_path, speed):
    """Copper that yields at 0.12 GPa: the surface stays within 0.6 % of its plateau, and that of the faster impact, whose shock
    outruns the precursor, is the exact 2010.79 m/s of tracked fronts to a thousandth. With one small coefficient it jumped to 2173 m/s."""
    copper = Material("m", MieGruneisen(8930.0, 3940.0, 1.489, 2.02), PerfectlyPlastic(47.7e9, 0.12e9))
    regions = (Region("flyer", "m", -5e-3, 0.0, 100, velocity=speed), Region("target", "m", 0.0, 5e-3, 100))
    problem = Problem("impact", "planar", 1.5e-6, regions, {"m": copper}, gauges=(Gauge("surface", 5e-3),), output=OutputOptions(report=False))
    done = run(problem, tmp_path / "run")
    found, peaks = done.arrays("gauges"), done.arrays("peaks")["peak_stress"]
    level = 0.08e9 + float(shock(copper, particle_velocity=0.5 * speed).pressure)     # about: the elastic part of the compression is stiffer
    assert peaks.max() > 1.05 * level and highest(done)["stress"] == pytest.approx(level, rel=0.01)    # the first zones at the impact overshoot
    velocity = found["velocity"][:, 0]
    assert velocity.max() < 1.006 * velocity[-1]
    assert found["stress"][:, 0].min() > -1.35e9     # no spall of the last zones, to which the overshoot led at a strength of 1.35 GPa
    if speed == 2000.0:
        assert velocity[-1] == pytest.approx(2010.79, rel=1e-3)


@pytest.mark.parametrize("gap, thick, zones", [(5e-5, 2e-3, 100), (1e-3, 5e-3, 80)])
def test_an_impact_after_a_gap_starts_as_one_between_plates_that_touch(tmp_path, gap, thick, zones):
    """The jump of the velocity where they meet is no acceleration that goes on: taken for one, it left three times the stress there."""
    law, speed = LAWS["copper"], 1000.0
    regions = (Region("flyer", "m", -thick, 0.0, zones, velocity=speed), Region("target", "m", gap, thick + gap, zones))
    stop = gap / speed + 0.6 * thick / (law.c0 + law.s * speed / 2)
    done = run(Problem("impact", "planar", stop, regions, {"m": Material("m", law)}, output=OutputOptions(report=False)), tmp_path / "run")
    jump = law.rho0 * (law.c0 + law.s * speed / 2) * speed / 2
    assert done.arrays("peaks")["peak_stress"].max() < 1.2 * jump


@pytest.mark.parametrize("start", [0.0, 1e-7])
def test_a_driven_end_starts_its_shock_alike_at_any_time(tmp_path, start):
    """The zones see the velocity that the end is given: led on by its jump, they saw half more of it, and the first peaked at 1.7."""
    law, speed = LAWS["copper"], 500.0
    problem = Problem("piston", "planar", start + 5e-7, (Region("target", "m", 0.0, 5e-3, 100),), {"m": Material("m", law)},
                      left=Boundary("velocity", Pulse("constant", speed, start)), output=OutputOptions(report=False))
    peaks = run(problem, tmp_path / "run").arrays("peaks")["peak_stress"] / (law.rho0 * (law.c0 + law.s * speed) * speed)
    assert peaks[0] < 1.15 and peaks[1] < 1.06 and abs(peaks[10] - 1.0) < 2e-3


def test_the_highest_stress_of_a_wave_that_has_not_left_the_first_zones(tmp_path):
    """It is that of those zones, marked as one that may overshoot; the zones ahead of the wave are at rest."""
    law = LAWS["copper"]
    regions = (Region("flyer", "m", -1e-3, 0.0, 100, velocity=1000.0), Region("target", "m", 0.0, 1e-3, 100))
    done = run(Problem("impact", "planar", 8e-9, regions, {"m": Material("m", law)}, output=OutputOptions(report=False)), tmp_path / "run")
    jump, found = law.rho0 * (law.c0 + law.s * 500.0) * 500.0, highest(done)
    assert found["stress_forming"] and 0.9 * jump < found["stress"] < 1.2 * jump and abs(found["stress_at"][0]) < 12e-5
    assert "overshoots" in next(where for word, _, where in highest_rows(done) if word == "stress")
    assert "surface_velocity" not in found      # of the rear face, which the wave has not reached: round-off of either sign


def test_precursors_and_gases_keep_the_smaller_linear_coefficient():
    """A material with strength or pores (in weak jumps) or a gas has c1 = `linear`; another viscosity law has its own coefficient."""
    law, limited = LAWS["copper"], VISCOSITY.get("limited").example

    def coefficient(*parts):
        return viscosity_in(Material("m", *parts), limited).linear
    assert coefficient(law) == coefficient(EOS.get("stiffened_gas").example) == limited.linear_condensed == 1.0
    others = [(law, PerfectlyPlastic(45e9, 0.1e9)), (EOS.get("p_alpha").example,), (IdealGas(1.4, 1.0, 1e5),), (IdealGas(5.0 / 3.0),)]
    assert [coefficient(*parts) for parts in others] == [limited.linear] * 4
    strong = [viscosity_in(Material("m", *parts), limited).linear_condensed for parts in others]
    assert strong == [limited.linear_condensed, limited.linear_condensed, limited.linear, limited.linear]
    landshoff = VISCOSITY.get("landshoff").example
    assert viscosity_in(Material("m", law), landshoff) is landshoff


def top(overshoot):
    """A front at t = 1, an overshoot that rings out over 0.2, a top of 7 until t = 3 and a fall to 2."""
    time = np.linspace(0.0, 4.0, 2001)
    since = np.maximum(time - 1.0, 0.0)
    values = np.where(time < 1.0, 0.0, 7.0 * (1.0 + overshoot * np.exp(-since / 0.02) * np.cos(100.0 * since)))
    return time, np.where(time > 3.0, 2.0, values)


@pytest.mark.parametrize("overshoot", [0.0, 0.02, 0.1, 0.3])
def test_an_overshoot_does_not_move_the_level(overshoot):
    assert flat_top(*top(overshoot)) == pytest.approx(7.0, rel=1e-4)
    assert plateau(*top(overshoot)) == flat_top(*top(overshoot))


def test_what_has_no_flat_top_has_no_level():
    time = np.linspace(0.0, 1.0, 500)
    for values in (time, np.sin(3.0 * time), np.exp(-5.0 * time), np.zeros(500)):
        assert np.isnan(flat_top(time, values))
    assert plateau(time, np.sin(3.0 * time)) == pytest.approx(1.0, rel=1e-4)
    assert np.isnan(flat_top([0.0, 1.0], [1.0, 1.0]))


def test_the_plateaus_of_a_gauge_are_those_of_its_loading(tmp_path):
    """The reference flyer: 2 mm into the target rides on the spalled layer in the end, for longer than the shock lasted. Both plateaus
    are those behind the shock: 350 m/s by symmetry, and the jump conditions of elastic and plastic wave to 1 %."""
    c, s, g, y, v = 5200.0, 1.5, 24.8e9, 0.3e9, 350.0
    rows = {row["gauge"]: row for row in gauge_rows(run(build.flyer((100, 200)), tmp_path / "run"))}
    inside, surface = rows["2 mm"], rows["surface"]
    assert inside["plateau_velocity"] == pytest.approx(v, rel=1e-3) and abs(inside["last_velocity"] - v) > 10.0
    longitudinal = np.sqrt(c**2 + 4.0 * g / (3.0 * 2700.0))
    limit = 0.5 * y * (2700.0 * c**2 / g + 4.0 / 3.0)
    precursor = limit / (2700.0 * longitudinal)
    assert inside["plateau_stress"] == pytest.approx(limit + 2700.0 * (c + s * v) * (v - precursor), rel=1e-2)
    assert surface["plateau_velocity"] == pytest.approx(2.0 * v, rel=2e-2)
    assert all(np.isnan(surface[f"{name}_stress"]) for name in ("peak", "plateau", "lowest"))


def test_the_first_flat_stretch_is_the_plateau():
    """A top of 7 for a second, then of 7.1 for two: the first; one of 0.02 s, a spike, is none."""
    time = np.linspace(0.0, 5.0, 5001)
    values = np.select([time < 1.0, time < 2.0, time < 2.5], [0.0, 7.0, 3.0], 7.1)
    assert flat_top(time, values) == pytest.approx(7.0, rel=1e-12)
    assert time[flat_stretch(durations(time), values)[0]][[0, -1]] == pytest.approx([1.0, 2.0], abs=2e-3)
    assert flat_top(time, np.where((time > 1.0) & (time < 1.98), 3.0, values)) == pytest.approx(7.1, rel=1e-12)
    assert flat_stretch(durations(time), np.zeros(5001))[0] == slice(0, 0)


def test_points_too_few_for_quartiles_are_no_flat_top():
    """A hump sampled so coarsely that one or two points lie within 5 % of its height: each alone would be flat."""
    for count in (8, 9, 12, 13):
        time = np.linspace(0.0, np.pi, count)
        assert np.isnan(flat_top(time, np.sin(time)))


def pushed_gas():
    """(pressure, velocity) of the contact of a stiffened gas (4.4, 0.6 GPa, 1000 kg/m3) at 200 MPa with a gas (1.4) of 10 kg/m3 at 0.2 MPa:
    the isentrope of the one meets the shock adiabat of the other, by bisection."""
    def excess(p):
        released = 2.0 * np.sqrt(4.4 * 8e8 / 1000.0) / 3.4 * (1.0 - ((p + 6e8) / 8e8) ** (3.4 / 8.8))
        driven = (p - 2e5) * np.sqrt(2.0 / 10.0 / (2.4 * p + 0.4 * 2e5))
        return released - driven, driven
    low, high = 2e5, 2e6
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle)[0] > 0.0 else (low, middle)
    return low, excess(low)[1]


def test_the_plateau_of_a_gauge_whose_start_up_exceeds_it_many_times(tmp_path):
    """A liquid that pushes a gas: for the first microsecond the stress between the half zones is up to 4.4 times the level. The level is
    that of the stress where the velocity is flat."""
    regions = (Region("liquid", "liquid", 0.0, 0.7, 280, density=1000.0, pressure=2e8),
               Region("gas", "gas", 0.7, 1.0, 120, density=10.0, pressure=2e5))
    materials = {"liquid": Material("liquid", StiffenedGas(4.4, 6e8, 1000.0)), "gas": Material("gas", IdealGas(1.4))}
    done = run(Problem("tube", "planar", 2.4e-4, regions, materials, Boundary("fixed"), Boundary("fixed"),
                       gauges=(Gauge("contact", "liquid/gas"),), output=OutputOptions(report=False)), tmp_path / "run")
    row, (pressure, velocity) = gauge_rows(done)[0], pushed_gas()
    assert row["peak_stress"] > 4.0 * pressure
    assert row["plateau_stress"] == pytest.approx(pressure, rel=2e-3) and row["plateau_velocity"] == pytest.approx(velocity, rel=1e-3)


def liquid_plateau_miss(grading):
    """Relative miss of the pressure in the middle fifth of the liquid between fan and contact, 200 MPa against a gas at 0.2 MPa."""
    liquid, gas = StiffenedGas(4.4, 6e8, 1000.0), IdealGas(1.4)
    exact = riemann(liquid, state(liquid, density=1000.0, pressure=2e8), gas, state(gas, density=10.0, pressure=2e5))
    regions = (Region("liquid", "liquid", 0.0, 0.7, 280, ratio=grading ** (-1.0 / 279), density=1000.0, pressure=2e8),
               Region("gas", "gas", 0.7, 1.0, 120, ratio=grading ** (1.0 / 119), density=10.0, pressure=2e5))
    wall, stop = Boundary("fixed"), 2.4e-4
    solver = make_solver(Problem("tube", "planar", stop, regions, {"liquid": Material("liquid", liquid), "gas": Material("gas", gas)}, wall, wall,
                                 bonded(regions), output=OutputOptions(report=False)))
    while solver.time < stop:
        solver.march(stop, 10_000)
    found = solver.state()
    x = 0.5 * (found.position_left + found.position_right)
    tail, contact = (0.7 + float(speed) * stop for speed in (exact.left.tail, exact.velocity))
    middle = np.abs((x - tail) / (contact - tail) - 0.5) < 0.1
    return abs(float(np.mean(found.zones["pressure"][middle])) / exact.pressure - 1.0)


def test_the_plateau_behind_a_fan_is_decided_by_the_zones_in_which_it_starts():
    """Three times finer at the contact, with as many zones and the same size at the end of the fan: below 0.5 %, a third of the miss."""
    even, fine = liquid_plateau_miss(1.0), liquid_plateau_miss(3.0)
    assert even < 0.02 and fine < 0.005 and fine < even / 3.0


def test_nothing_arrives_at_a_gauge_in_a_body_that_rests_under_pressure(tmp_path):
    """Its velocities are the round-off of its stress: no wave, whatever their ratio to the largest of them."""
    region = Region("body", "m", 0.0, 1e-3, 50, density=1.2 * LAWS["copper"].rho0, energy=0.0)
    done = run(Problem("rest", "planar", 2e-7, (region,), {"m": Material("m", LAWS["copper"])}, Boundary("fixed"), Boundary("fixed"),
                       gauges=(Gauge("inside", 3e-4),), output=OutputOptions(report=False)), tmp_path / "run")
    assert np.abs(done.gauge("velocity", "inside")[1]).max() > 0.0
    row, = gauge_rows(done)
    assert np.isnan(row["arrival"]) and row["peak_velocity"] == row["last_velocity"] == 0.0
