"""Prints the measured numbers of docs/theory: detonation.md, detonation_verification.md, initiation.md. The problems are those of
tests/verification.

    python benchmarks/detonation_numbers.py                # all, half an hour on one core
    python benchmarks/detonation_numbers.py programmed     # parts: see PARTS, at the end

The pages are written by hand, because their tables set what is found beside what is required. Percentages are of the value compared with.
"""

import dataclasses
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[1] / "tests"
sys.path[:0] = [str(ROOT / "verification"), str(ROOT / "unit" / "solvers")]

import cylinder_sweep as tube  # noqa: E402
import test_calibrated_sets as calibrated  # noqa: E402
import test_detonation_programmed as by_schedule  # noqa: E402
import test_detonation_rates as by_rate  # noqa: E402
import test_end_on_plate as plates  # noqa: E402
import test_ignition_growth_sets as published_sets  # noqa: E402
import test_leapfrog_burning as staggered  # noqa: E402
import test_moving_window as moving  # noqa: E402
import test_reaction_zones as zones_of  # noqa: E402
import test_reference_state as reference  # noqa: E402
from reactive_builders import PENTOLITE, PENTOLITE_HEAT, PENTOLITE_SPEED, QUIET, charge, comp_b, driven, run  # noqa: E402

from hugoniot.campaign.pop_plot import charge_of, initiation, pop_plot  # noqa: E402
from hugoniot.diagnostics.detonation import PopLine, body_motion, front_speed, von_neumann_pressure  # noqa: E402
from hugoniot.errors import HugoniotError  # noqa: E402
from hugoniot.laws.burn.programmed import Beta, Programmed  # noqa: E402
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen  # noqa: E402
from hugoniot.laws.mixture.reference_state import BEHIND, WHILE_BURNING  # noqa: E402
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic  # noqa: E402
from hugoniot.materials import library  # noqa: E402
from hugoniot.materials.library import schema  # noqa: E402
from hugoniot.materials.material import Material  # noqa: E402
from hugoniot.problem.model import Boundary, Interface, Lighting, Problem, Region  # noqa: E402
from hugoniot.theory.chapman_jouguet import cj  # noqa: E402
from hugoniot.theory.exact.ehep import ehep  # noqa: E402
from hugoniot.theory.exact.mader import mader  # noqa: E402
from hugoniot.theory.hugoniot import Initial  # noqa: E402


def show(*parts) -> None:
    print("| " + " | ".join(str(part) for part in parts) + " |", flush=True)


def off(value, exact, digits=2) -> str:
    """Relative difference in per cent, with its sign."""
    return f"{100.0 * (float(value) / float(exact) - 1.0):+.{digits}f} %"


# -- programmed burn ---------------------------------------------------------------------------------------------------------
def programmed() -> None:
    """Composition B, 4 cm: D against 7.98 km/s, highest pressure in the last profile against CJ, energy error; `beta` behind a piston."""
    material = comp_b()
    ideal = cj(material.eos).state.pressure
    cases = [("planar", material, "planar", {}), ("cylindrical", material, "cylindrical", {"part": 0.85}),
             ("spherical", material, "spherical", {"part": 0.85}),
             ("planar, programmed_beta", by_schedule.with_compression(material), "planar", {})]
    for words, explosive, geometry, more in cases:
        for count in (200, 400, 800, *((1600,) if "beta" in words else ())):
            row = [words, f"{count // 4} zones/cm"]
            for asked in (charge(explosive, zones=count, geometry=geometry, **more),
                          staggered.leapfrog(charge(explosive, zones=count, geometry=geometry, **more))):
                _, seen = run(asked)
                near, far = (0.005, np.inf) if geometry == "planar" else (0.008, 0.032)
                highest = seen.states[-1].zones["pressure"].max()
                row += [off(front_speed(seen.times, seen.path(), near, far), 7980.0, 3), off(highest, ideal, 1), f"{seen.energy_error:.0e}"]
            show(*row)
    for count in (800, 1600):
        damped = ("limited", {"quadratic": 1.0, "linear": 0.0, "linear_condensed": 0.3})
        for words, viscosity in (("default", None), ("linear = 0", damped)):
            problem = charge(material, zones=count)
            try:
                _, seen = run(dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, viscosity=viscosity)))
                found = ", ".join(off(state.zones["pressure"].max(), ideal, 1) for state in seen.states[5::5])
            except HugoniotError as error:
                found = str(error)[:60]
            show(f"{count} zones, after a quarter, half, three quarters and all of the run", words, found)


    point = by_schedule.with_compression(material).burn
    alone = dataclasses.replace(material, burn=Beta(point.rho0, point.rho_cj))
    speed = float(cj(material.eos).state.particle_velocity)
    for part in (0.7, 0.9, 1.0):
        for count in (400, 800, 1600):
            _, seen = run(driven(alone, 0.04, count, part * speed, 0.036 / 7980.0))
            first, *later = [100.0 * (state.zones["pressure"].max() / ideal - 1.0) for state in seen.states[1:]]
            show(f"beta, piston at {part:g} of the CJ velocity, {count} zones",
                 f"{first:+.1f} %, then {min(later):+.1f} to {max(later):+.1f} %")


def initiated() -> None:
    """LX-17, ignition and growth, pushed at 1.5 km/s: D against CJ, both integrators."""
    material = by_rate.lx17()
    ideal = cj(material.eos).detonation_velocity
    for count in (500, 1000, 2000):
        row = ["LX-17", f"{count // 2} zones/cm"]
        for asked in (driven(material, 0.02, count, 1500.0, 2.5e-6), staggered.leapfrog(driven(material, 0.02, count, 1500.0, 2.5e-6))):
            _, seen = run(asked, 50)
            row += [off(front_speed(seen.times, by_rate.shock_path(seen), 0.010, 0.019), ideal), f"{seen.energy_error:.0e}"]
        show(*row)


def library_explosives() -> None:
    """All explosives of the library at 100 zones/cm, at the CJ velocity of their products and at the published one."""
    for name in by_schedule.EXPLOSIVES:
        material = dataclasses.replace(library.find(name), name="x")
        point, row = cj(material.eos), [name]
        stated = library.entry(name).detonation.get("velocity")     # not that of `material`, where the library burns at the CJ velocity
        published = material.burn.detonation_velocity if stated is None else stated.value
        for velocity in (point.detonation_velocity, published):
            asked = dataclasses.replace(material, burn=Programmed(velocity))
            try:
                _, seen = run(charge(asked))
                row += [off(front_speed(seen.times, seen.path(), 0.005), point.detonation_velocity, 3),
                        off(seen.states[-1].zones["pressure"].max(), point.state.pressure)]
            except HugoniotError as error:
                row += [str(error)[:60], ""]
        show(*row)


def taylor_waves() -> None:
    """L1 of pressure, density, velocity of EHEP after 1, 2, 3 us and of Mader's Taylor wave, 200 and 400 zones; two `spread_zones`."""
    make, spread = by_schedule.gamma_explosive, {}

    def explosive(gamma=3.0, speed=8000.0, rho0=1600.0):
        return make(gamma, speed, rho0, Programmed(speed, **spread))

    by_schedule.gamma_explosive = explosive
    for words, more in (("default", {}), ("spread_zones = 1.5", {"spread_zones": 1.5})):
        spread.update(more)
        for count in (200, 400):
            states = by_schedule.from_a_piston("ehep", 8500.0, 1600.0, 0.01, 500.0, 3e-6, count)[-3:]
            found = [[by_schedule.distance(state, ehep(), field) for field in ("pressure", "density", "velocity")] for state in states]
            state = by_schedule.from_a_piston("mader", 8000.0, 1875.0, 0.05, 0.0, 5.94e-6, count)[-1]
            found.append([by_schedule.distance(state, mader(), field) for field in ("pressure", "density", "velocity")])
            show(words, count, *(", ".join(f"{100 * value:.2f}" for value in row) for row in found))
    by_schedule.gamma_explosive = make


def pentolite() -> None:
    """H-5, H-6, H-7, H-8: CJ state; surface arrival, burn time and cavity at 20 and 100 us."""
    _, seen = run(charge(Material("pentolite", PENTOLITE, burn=Programmed(PENTOLITE_SPEED), detonation_energy=PENTOLITE_HEAT), zones=400))
    last = seen.states[-1]
    show("H-5", off(front_speed(seen.times, seen.path(), 0.005), PENTOLITE_SPEED), off(last.zones["pressure"].max(), 29.03e9),
         off(last.zones["density"].max(), 2332.77), off(last.velocity_left.max(), 2119.6))
    for series in ("literal", "RMW"):
        for zone in (1e-3, 5e-4, 2.5e-4):
            problem = by_schedule.sphere(series, zone=zone)
            solver, seen = run(problem, 320)
            surface, inside = seen.velocity("right"), solver.region_of == 0
            lit = np.array([state.zones["burn_fraction"][inside].min() for state in seen.states])
            show(series, f"{1e3 * zone} mm", f"cavity {100 * by_schedule.cavity(seen.states[-1], problem):.3f} cm",
                 f"shock {1e6 * seen.times[np.argmax(surface > 0.5 * surface.max())]:.1f} us",
                 f"burned {1e6 * seen.times[np.argmax(lit > 0.5)]:.2f} us")
        for zone in (1e-3, 5e-4, 2.5e-4):
            places, cavities = [], []
            for strength, stop in ((0.276e9, 1e-4), (0.0, 2e-5)):
                problem = by_schedule.sphere(series, strength, zone, stop, by_schedule.SPALL[series])
                _, seen = run(problem, 20)
                places.append(max((event.position for event in seen.events if event.kind == "void_opened"), default=0.0))
                cavities.append(by_schedule.cavity(seen.states[-1], problem))
            show(series, f"{1e3 * zone} mm", f"spall {100 * places[0]:.2f}, Y = 0: {100 * places[1]:.2f} cm",
                 f"cavity at 100 us {100 * cavities[0]:.2f}, Y = 0 at 20 us {100 * cavities[1]:.2f} cm")


# -- reaction zones ------------------------------------------------------------------------------------------------------------
def reaction_zones() -> None:
    """Six rates, 20 and 40 zones per half-reaction length: spike (mean, least, largest), highest zone at the end, L1, speed; peaks."""
    for name in zones_of.RATES:
        for per_half in (20, 40):
            exact, state, seen = zones_of.supported(zones_of.explosive(name), Initial(1600.0, 0.0, 0.0), per_half, 12, 1.1)
            high, profile = zones_of.misfit(exact, state)
            spikes = 100 * np.array([von_neumann_pressure(s) / float(exact.von_neumann.pressure) - 1.0 for s in seen.states[12:]])
            path = seen.path("pressure", 0.4 * float(exact.von_neumann.pressure))
            speed = np.polyfit(seen.times[20:], path[20:], 1)[0] / exact.velocity - 1.0
            _, _, sharp = zones_of.supported(zones_of.explosive(name), Initial(1600.0, 0.0, 0.0), per_half, 12, 1.1, linear=0.4)
            saw = sharp.solver.peaks()["peak_pressure"][4 * per_half:10 * per_half] / float(exact.von_neumann.pressure) - 1.0
            show(name, per_half, f"{spikes.mean():+.2f} ({spikes.min():+.2f}, {spikes.max():+.2f})", f"peaks {100 * np.median(saw):+.2f}",
                 f"highest {100 * high:+.1f}", f"L1 {100 * profile:.2f}", f"speed {100 * speed:+.2f}")
    for per_zone in (25, 50, 80):
        solver, seen = run(by_rate.supported_zone(per_zone))
        show("Fickett-Rivard", per_zone, f"L1 {100 * by_rate.profile_error(seen.states[-1]):.2f} %",
             off(seen.states[-1].zones["pressure"].max(), by_rate.SOLUTION.numbers["vn_pressure"]))


def reference_states() -> None:
    """LX-17: the reactant's isentrope against the exact one, median (largest), per cent of the energy rise."""
    cases = (("15 GPa", reference.slow_burn, (12, 25, 50, 100)), ("detonation", reference.detonation, (25, 50, 100, 200)))
    for words, case, meshes in cases:
        for per_mm in meshes:
            row = [words, per_mm]
            for kind in ("frozen", "rolling"):
                _, code, error, _ = reference.isentrope_error(*case(per_mm, kind))
                found = "behind" if (code == BEHIND).all() else "while burning" if (code == WHILE_BURNING).all() else "both"
                row += [kind, found, f"{100 * np.median(error):+.2f} % ({100 * np.abs(error).max():.2f})"]
            show(*row)


def thresholds() -> None:
    """Threshold burn in `compatible`, 200 zones: speeds at 5, 10, 20, 30, 40 GPa."""
    speeds = []
    for limit in (5e9, 10e9, 20e9, 30e9, 40e9):
        _, seen = run(driven(by_rate.kb(limit), 0.1, 200, 2504.0, 4.5e-6))
        speeds.append(f"{front_speed(seen.times, seen.path('pressure', 1e10), 0.015) / 1e3:.2f}")
    show("threshold", ", ".join(speeds))


# -- driven metal ------------------------------------------------------------------------------------------------------------
def end_on_plates() -> None:
    """Velocity of the plate against the exact one of each problem, 400 zones (p = K rho^3: and 800), and against the closed form."""
    make = plates.barotropic.__wrapped__ if hasattr(plates.barotropic, "__wrapped__") else plates.barotropic._get_wrapped_function()
    products = make()
    law = next(products)
    for ratio in plates.RATIOS:
        gas, thick = plates.exact(ratio, "shock"), plates.exact(ratio, "barotropic")
        found, coarse, fine = plates.pushed(ratio), plates.pushed(ratio, law), plates.pushed(ratio, law, 800)
        closed = plates.closed(ratio)
        show(ratio, off(found, gas), off(coarse, thick), off(fine, thick), off(found, closed), off(coarse, closed))


def cylinders() -> None:
    """Wall by energy and surface at 6 and 19 mm against published; burned at once, without strength and with it; lit on the axis."""
    published = {"tnt": (0.735, 0.975), "comp_b": (0.960, 1.330), "pbx_9404": (1.235, 1.620)}
    regions = (Region("charge", "x", 0.0, tube.INNER, 127), Region("wall", "copper", tube.INNER, tube.OUTER, 26))
    for name, energies in published.items():
        metal = PerfectlyPlastic(47.7e9, 0.2e9)
        for words, strength, lit in (("at once", None, False), ("at once, 0.2 GPa", metal, False), ("lit on the axis", None, True)):
            material = dataclasses.replace(library.find(name), name="x", **({} if lit else {"burn": None}))
            copper = Material("copper", MieGruneisen(tube.WALL_DENSITY, 3940.0, 1.489, 1.99), strength)
            problem = Problem("cylinder", "cylindrical", 2.4e-5, regions, {"x": material, "copper": copper}, Boundary("fixed"),
                              Boundary("free"), (Interface("charge", "wall", "bonded"),), lighting=(Lighting(0.0),) if lit else (),
                              output=QUIET)
            solver, seen = run(problem, 320)
            row = [name, words]
            for moved, energy in zip((0.006, 0.019), energies):
                k = next(i for i, state in enumerate(seen.states) if state.position_right[-1] > tube.OUTER + moved)
                wall, exact = body_motion(seen.states[k], solver.region_of, 1), np.sqrt(2.0 * energy) * 1e3
                row.append(f"{1e3 * moved:.0f} mm: {off(np.sqrt(2.0 * wall['kinetic_energy'] / wall['mass']), exact, 1)}, surface "
                           f"{off(seen.velocity('right')[k - 8:k + 9].mean(), exact, 1)}")
            show(*row)


# -- ignition and growth --------------------------------------------------------------------------------------------------------
def sets() -> None:
    """Sets of the library: steady speed and pressure at the piston against CJ, isolation and equilibrium."""
    for name, (per_mm, length) in published_sets.SETS.items():
        row, end = [name], length * 1e-3
        for mixture in ("thermal_isolation", "thermal_equilibrium"):
            material = dataclasses.replace(published_sets.the_set(name), mixture=mixture)
            point = cj(material.eos)
            pressure, piston = float(point.state.pressure), float(point.state.particle_velocity)
            _, seen = run(driven(material, end, per_mm * length, piston, 0.93 * end / point.detonation_velocity), 80)
            found = front_speed(seen.times, seen.path("pressure", 0.4 * pressure), 0.6 * end, 0.97 * end)
            row += [f"{found:.0f} m/s", off(found, point.detonation_velocity),
                    off(np.median(seen.states[-1].zones["pressure"][:per_mm * length // 10]), pressure)]
        show(*row)


DISTANCES = {"G003": (10, 12, 15), "G002": (10, 12, 15), "G015": (10, 12.2, 15), "G001": (8, 11, 15), "G004": (10, 12, 15),
             "G016": (10, 12.2, 15), "G014": (3, 5, 8, 15), "G007": (2.4, 3.5, 5, 7.2), "G006": (4, 5, 8, 12), "G005": (5, 8, 15)}


def distances() -> None:
    """Run distances of the published sets, mm, and slope of the line through them, at the zones `hugoniot pop-plot` chooses."""
    for name, pressures in DISTANCES.items():
        found = pop_plot(library.find(name), np.array(pressures) * 1e9)
        show(name, ", ".join(f"{1e3 * point.distance:.2f}" for point in found.points) + f" at {pressures} GPa", f"slope {found.line.b:.3f}")
    for name, pressure, sizes in (("G001", 15e9, (2e-5, 1e-5, 5e-6)), ("G003", 15e9, (4e-5, 2e-5, 1e-5))):
        show(name, "zones of " + ", ".join(f"{1e6 * size:.0f}" for size in sizes) + " um",
             ", ".join(f"{1e3 * pop_plot(library.find(name), (pressure,), size).points[0].distance:.3f}" for size in sizes))


def calibrated_sets() -> None:
    """Run distance of the calibrated sets over the measured line at six pressures of the fit, 480 and 240 zones in a run distance."""
    for name, (identity, pressures) in calibrated.CALIBRATED.items():
        row, charge_ = schema.row(identity), charge_of(library.find(name))
        line = PopLine(row["a"], row["b"], np.nan, np.nan, np.nan)
        wanted = np.geomspace(3e9 if min(pressures) < 9 else 10e9, 15e9, 6)
        for count in (480, 240):
            ratios = [initiation(charge_, p, x / count, 6.0 * x, int(2.6 * count)).distance / x
                      for p, x in zip(wanted, line.distance(wanted))]
            show(name, count, ", ".join(f"{ratio:.3f}" for ratio in ratios))


def pulsation() -> None:
    """Crests and period of the settled cycle by zones, window and linear viscosity."""
    for count, window, linear, stop in ((5, 15, 1.0, 80), (10, 30, 1.0, 150), (20, 30, 1.0, 150), (20, 60, 1.0, 150), (20, 8, 1.0, 84),
                                        (40, 8, 1.0, 67), (20, 30, 0.5, 150)):
        found = moving.follow(zones_of.one_step(moving.RATE), zones_of.START, float(stop), overdrive=1.6, zones=count, window=float(window),
                              viscosity={"quadratic": 0.55, "linear": linear})
        times, crests = found.crests(after=45.0)
        show(count, window, linear, f"{crests.min():.1f} to {crests.max():.1f}", f"{np.diff(times).mean():.2f}", stop)


PARTS = (programmed, initiated, library_explosives, taylor_waves, pentolite, reaction_zones, reference_states, thresholds, end_on_plates,
         cylinders, sets, distances, calibrated_sets, pulsation)

if __name__ == "__main__":
    for part in PARTS:
        if len(sys.argv) < 2 or part.__name__ in sys.argv[1:]:
            print(f"\n{part.__name__}: {part.__doc__}", flush=True)
            part()
