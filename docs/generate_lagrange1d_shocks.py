"""Of `generate_lagrange1d`: symmetric impacts, the shape of captured shocks, the length of the step."""

import dataclasses
import tempfile

import numpy as np

import hugoniot
from hugoniot.campaign.verify import run_problem
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.library import find
from hugoniot.materials.material import Material
from hugoniot.output.run_numbers import gauge_rows, highest
from hugoniot.problem import catalogue
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.model import Boundary, Gauge, Lighting, Problem, Region, SolverOptions
from hugoniot.problem.standard import STANDARD
from hugoniot.simulate import make_solver
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.exact.elastic_plastic_piston import Solid, elastic_plastic_piston
from hugoniot.theory.hugoniot import shock

FOLDER = tempfile.TemporaryDirectory()
SMALL = ("limited", {"linear": 0.3})      # c1 alone: `linear_condensed` follows `linear`
FLUORIDE = MieGruneisen(2640.0, 5150.0, 1.35, 1.6)
METALS = ("copper", "iron", "aluminum_6061", "tantalum", "steel_304", "tungsten", "nickel")
THICK, ZONES = 5e-3, 100
IMPACT = "Symmetric impact of 5 mm plates, 100 zones each"


def table(heads, rows) -> list[str]:
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


def percent(value: float) -> str:
    """A relative difference in per cent."""
    return f"{100 * value:.1f} %" if abs(value) >= 0.01 else f"{round(100 * value, 2) + 0.0:.2f} %"


def done(problem: Problem):
    """The run of a problem, in a folder that lasts as long as this process."""
    quiet = dataclasses.replace(problem.output, report=False)
    return hugoniot.run(dataclasses.replace(problem, output=quiet), tempfile.mkdtemp(dir=FOLDER.name), overwrite=True)


def marched(problem: Problem):
    """The solver of a problem at its stop time."""
    solver = make_solver(problem)
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 10**6)
    return solver


# -- impacts ---------------------------------------------------------------------------------------------------------------
def impact(material: Material, speed: float, viscosity, crossings: float):
    """The run of a plate on a plate like it, until the shock has crossed `crossings` plates; gauges at 0.5, 2 mm and the surface."""
    stop = crossings * THICK / float(shock(material, particle_velocity=speed / 2).shock_velocity)
    regions = (Region("flyer", "m", -THICK, 0.0, ZONES, velocity=speed), Region("target", "m", 0.0, THICK, ZONES))
    return done(Problem("impact", "planar", stop, regions, {"m": material}, solver=SolverOptions(viscosity=viscosity, courant=0.7),
                        gauges=(Gauge("half", 0.5e-3), Gauge("inside", 2e-3), Gauge("surface", THICK))))


def surface_excess(run) -> float:
    velocity = run.gauge("velocity", "surface")[1]
    return velocity.max() / velocity[-1] - 1.0


def first_zones(run) -> float:
    """Largest stress of the two zones of the target at the impact, Pa."""
    return float(run.arrays("peaks")["peak_stress"][ZONES:ZONES + 2].max())


def fluids() -> list[str]:
    rows = []
    for name, law in (("copper", MieGruneisen(8930.0, 3940.0, 1.489, 1.99)), ("LiF", FLUORIDE)):
        for speed in (200.0, 1000.0, 2000.0):
            level, row, cycles = float(shock(law, particle_velocity=speed / 2).pressure), [], []
            for viscosity in (None, SMALL):
                run = impact(Material("m", law), speed, viscosity, 1.35)
                row += [percent(run.gauge("stress", "half")[1].max() / level - 1), percent(first_zones(run) / level - 1),
                        percent(surface_excess(run))]
                cycles.append(run.summary["cycles"])
            rows.append([f"{name}, {speed:.0f} m/s", *row, f"{cycles[0] / cycles[1]:.1f}"])
    return [f"{IMPACT}, without strength; Courant number 0.7. The table gives the overshoot of the largest stress above the exact "
            "plateau, 0.5 mm from the impact face and in the first two zones of the target, and the overshoot of the largest velocity "
            "of the free surface above its final value. Three columns are for the defaults, three for a linear coefficient of 0.3. The "
            "last column is the number of time steps with the defaults divided by that with 0.3.", "",
            *table(("impact", "stress at 0.5 mm", "stress in first two zones", "surface velocity", "with 0.3: stress at 0.5 mm",
                    "with 0.3: stress in first two zones", "with 0.3: surface velocity", "ratio of numbers of steps"), rows)]


def solids() -> list[str]:
    rows, widths = [], []
    for name in METALS:
        material = dataclasses.replace(find(name), name="m")
        row, firsts, rises = [], [], []
        for viscosity in (None, SMALL):
            for speed in (500.0, 1000.0, 2000.0):
                run = impact(material, speed, viscosity, 1.5)
                level = next(found["plateau_stress"] for found in gauge_rows(run) if found["gauge"] == "inside")
                row.append(percent(surface_excess(run)) + (" (spalled)" if run.summary["voids_opened"] else ""))
                firsts.append(f"{100 * (first_zones(run) / level - 1):.0f}")
                rises.append(rise(run, level))
        widths += [wide / thin for wide, thin in zip(rises[:3], rises[3:])]
        rows.append([name, *row, ", ".join(firsts[:3]) + " %"])
    return [f"{IMPACT}, of library materials; Courant number 0.7. For three impact velocities the table gives the overshoot of the "
            "largest velocity of the free surface above its final value, with the defaults and with a linear coefficient of 0.3. The "
            "last column gives the overshoot of the stress in the first two zones of the target above the plateau at the three "
            "velocities, with the defaults.", "",
            *table(("material", "500 m/s", "1000 m/s", "2000 m/s", "with 0.3: 500 m/s", "with 0.3: 1000 m/s", "with 0.3: 2000 m/s",
                    "stress in first two zones"), rows),
            f"With the defaults plastic shocks (between 50 and 90 % of the stress) are {min(widths):.1f} to {max(widths):.1f} times as "
            "wide as with 0.3.",
            "", *limits()]


def rise(run, level: float) -> float:
    """Time in which the stress at the gauge 2 mm inside rises from 0.5 to 0.9 of a level: in a strong wave its plastic shock."""
    time, stress = run.gauge("stress", "inside")
    end = int(np.argmax(stress > 0.97 * level)) + 1
    start, stop = np.interp((0.5 * level, 0.9 * level), stress[:end], time[:end])
    return stop - start


def limits() -> list[str]:
    rows, measure = [], limit_of("aluminium_piston")
    for zones in (125, 250):
        row = [str(zones)]
        for viscosity in (None, SMALL):
            found = run_problem(STANDARD["aluminium_piston"], zones, viscosity=viscosity, courant=0.7)[0].state()
            row.append(percent(abs(np.interp(measure.window[0], found.position_middle, found.zones["stress"]) / measure.exact - 1)))
        rows.append(row)
    return ["Error of the stress behind the elastic precursor in the problem `aluminium_piston` of `hugoniot verify`:", "",
            *table(("zones", "defaults", "linear coefficient 0.3"), rows)]


def limit_of(name: str):
    """The measure of a piston's elastic limit: where, and the exact stress."""
    return next(measure for measure in STANDARD[name].measure if measure.key == "elastic_limit")


# -- the captured shock ----------------------------------------------------------------------------------------------------
def shocks() -> list[str]:
    rows = []
    cases = {"flyer_al_al_1900": ("impact at 1.9 km/s, aluminium as a fluid", "pressure", 110),
             "aluminium_piston": ("piston at 400 m/s, aluminium with strength", "stress", 20),
             "copper_piston": ("piston at 20 m/s, copper with strength", "stress", 20),
             "noh_planar": ("Noh's problem, planar, gas with $\\gamma$ = 5/3", "density", 20)}
    for name, (words, field, settled) in cases.items():
        f = run_problem(STANDARD[name], 300)[0].state().zones[field][settled:]
        front = int(np.argmax(f < 0.7 * np.median(f[:20])))
        level = float(np.mean(f[:front - 20]))
        ahead = limit_of(name).exact if "piston" in name else 1.0 if name == "noh_planar" else 0.0
        places = [crossing(f, ahead + part * (level - ahead), front) for part in (0.9, 0.1)]
        rows.append([words, f"{places[1] - places[0]:.1f}", percent(max(f[front - 20:].max() / level - 1, 0.0)),
                     f"{100 * np.std(f[:front - 20]) / level:.3f} %"])
    return ["Runs on 300 zones. The width of a shock is measured between 10 and 90 % of its height (for a plastic shock, of its height "
            "above the elastic limit). The overshoot is the largest within 20 zones behind the front; ripples are the root mean square "
            "deviation farther behind. Both are relative to the plateau.", "",
            *table(("problem", "width in zones", "overshoot", "ripples"), rows)]


def crossing(values, level, near) -> float:
    """The place, in zones, nearest to `near` where falling values pass a level."""
    below = np.flatnonzero((values[:-1] >= level) & (values[1:] < level))
    k = int(below[np.argmin(np.abs(below - near))])
    return k + float((values[k] - level) / (values[k] - values[k + 1]))


# -- the length of the step --------------------------------------------------------------------------------------------------
def flyer(**keys) -> Problem:
    """The deck of `hugoniot init flyer` with some keys changed."""
    changes = {key.replace("__", "."): value for key, value in keys.items()}
    return read_deck_text(catalogue.deck_text("flyer"), "flyer.toml", changes).problem


def steps() -> list[str]:
    solid = flyer().materials["al"]
    shape = Solid(*solid.eos[:4], solid.strength.shear_modulus, solid.strength.yield_stress)
    exact = elastic_plastic_piston(shape, 350.0).numbers["plastic_stress"]
    rows = []
    for courant in (0.5, 0.6, 0.7, 0.8, 0.9):
        run = done(flyer(solver__courant=courant, stop_time=0.5e-6))
        rows.append([f"{courant}", percent(highest(run)["stress"] / exact - 1), f"{run.summary['cycles']}"])
    return ["Overshoot of the highest stress of the reference flyer (`hugoniot init flyer`) above the exact plateau of "
            f"{exact / 1e9:.3f} GPa, with twelve zones at the impact face left out:", "",
            *table(("Courant number", "overshoot", "steps until 0.5 µs"), rows), *burning()]


def burning() -> list[str]:
    charge, rows = dataclasses.replace(find("Composition B"), name="x"), []
    front, regions = cj(charge), (Region("charge", "x", 0.0, 0.04, 400),)
    stop = 0.04 / front.detonation_velocity
    for courant in (0.5, 0.7):
        solver = marched(Problem("charge", "planar", stop, regions, {"x": charge}, Boundary("fixed"), Boundary("free"),
                                 lighting=(Lighting(0.0),), solver=SolverOptions(courant=courant)))
        highest_pressure = float(solver.state().zones["pressure"].max())
        rows.append([f"{courant}", f"{highest_pressure / 1e9:.2f} GPa", percent(highest_pressure / front.state.pressure - 1)])
    return ["Highest pressure in Composition B when a programmed detonation that starts at a wall has run through 4 cm, with zones of "
            f"0.1 mm (CJ pressure {front.state.pressure / 1e9:.2f} GPa):", "",
            *table(("Courant number", "highest pressure", "difference from the CJ pressure"), rows)]
