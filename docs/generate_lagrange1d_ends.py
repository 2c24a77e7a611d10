"""Of `generate_lagrange1d`: spall, the plateau of a liquid against a gas, transmitting ends."""

import json

import numpy as np
from generate_lagrange1d_shocks import FLUORIDE, done, flyer, marched, percent, table

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.output.run_numbers import gauge_rows, spall_numbers
from hugoniot.problem.model import Boundary, Gauge, Problem, Pulse, Region, SolverOptions
from hugoniot.problem.standard.parts import bonded
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.layout import SEG_FIRST, Z
from hugoniot.theory.isentrope import state
from hugoniot.theory.riemann import riemann

ALUMINIUM = MieGruneisen(2700.0, 5200.0, 1.5, 2.0)


# -- spall -----------------------------------------------------------------------------------------------------------------
def spall() -> list[str]:
    rows = []
    for zones in (200, 300, 400, 800):
        for courant in (0.5, 0.7):
            run = done(flyer(region__flyer__zones=zones, region__target__zones=2 * zones, solver__courant=courant))
            events = run.arrays("events")
            places = [json.loads(numbers)["position"] for numbers, kind in zip(events["numbers"], events["kind"]) if kind == "void_opened"]
            last = {row["gauge"]: row["last_velocity"] for row in gauge_rows(run)}
            rows.append([f"{zones}", f"{courant}", ", ".join(f"{1e3 * place:.3f}" for place in places),
                         f"{last['2 mm into target']:.0f} m/s", f"{last['free surface']:.0f} m/s"])
    heads = ("zones in the flyer", "Courant number", "positions of the voids, mm", "velocity of the fragment",
             "velocity of the free surface")
    return ["Positions at which the two voids of the reference flyer (`hugoniot init flyer`, target initially from 2 to 6 mm) open, and "
            "final velocities of the fragment between them (gauge 2 mm into the target) and of the free surface:", "",
            *table(heads, rows), *readings(), *gradients()]


def readings() -> list[str]:
    rows = []
    for zones in (100, 200, 400):
        row = [str(zones)]
        for strength, shown in ((None, ("acoustic",)), (PerfectlyPlastic(24.8e9, 0.3e9), ("acoustic", "kanel"))):
            regions = (Region("flyer", "m", -2e-3, 0.0, zones, velocity=300.0), Region("target", "m", 0.0, 4e-3, 2 * zones))
            material = Material("m", ALUMINIUM, strength, SpallStress(1e9))
            found = spall_numbers(done(Problem("plates", "planar", 2.6e-6, regions, {"m": material}, gauges=(Gauge("surface", 4e-3),))))
            read = [found.get(f"spall_strength_{kind}") for kind in shown]
            row += ["not given" if value is None else f"{value / 1e9:.2f} GPa" for value in read]
        rows.append(row)
    return ["Spall strength from the free-surface velocity behind a square pulse: an aluminium flyer of 2 mm hits 4 mm of aluminium at "
            "300 m/s, prescribed spall strength 1 GPa. Kanel's correction is not given where it would exceed the pull-back.", "",
            *table(("zones in the flyer", "fluid, acoustic", "yield stress 0.3 GPa, acoustic",
                    "yield stress 0.3 GPa, with Kanel's correction"), rows)]


def gradients() -> list[str]:
    peak, duration, depth, width = 1e9, 0.5e-6, 0.5e-3, 4e-3
    slope, rows = 2.0 * peak / (ALUMINIUM.c0 * duration), []
    law = FRACTURE.get("stress_gradient").build(strength=slope * depth, gradient=slope, least=0.6 * slope * depth)
    pulse = Boundary("pressure", Pulse("table", times=(0.0, duration, 1.0), values=(peak, 0.0, 0.0)))
    for zones in (200, 400, 800):
        solver = marched(Problem("pulse", "planar", width / ALUMINIUM.c0 + 0.15e-6, (Region("plate", "m", 0.0, width, zones),),
                                 {"m": Material("m", ALUMINIUM, None, law)}, pulse, Boundary("free")))
        layer = solver.zones[Z.mass, solver.segments[-1, SEG_FIRST]:].sum() / ALUMINIUM.rho0
        rows.append([f"{1e6 * width / zones:.0f} µm", f"{1e3 * layer:.3f} mm"])
    return ["Fracture law `stress_gradient`: a triangular pulse of 1 GPa, 2.6 mm long, in aluminium without strength. By this law the "
            "spalled layer is exactly 0.5 mm thick.", "",
            *table(("zone size", "thickness of the spalled layer"), rows)]


# -- liquid against gas ------------------------------------------------------------------------------------------------------
def liquid() -> list[str]:
    rows = []
    for zones, grading, words in ((400, 1.0, "equal"), (800, 1.0, "equal"), (1600, 1.0, "equal"),
                                  (400, 3.0, "three times finer at the contact"), (400, 10.0, "ten times finer at the contact")):
        miss, part = liquid_miss(zones, grading)
        rows.append([f"{zones}, {words}", percent(miss), f"{miss * part:.0e}"])
    return [r"Liquid at 200 MPa (stiffened gas, $\gamma$ = 4.4, $p_\infty$ = 600 MPa, 0.7 m) against a gas at 0.2 MPa (0.3 m), "
            "after 0.24 ms. The exact pressure of the plateau between the rarefaction fan and the contact is 0.49 MPa. The error is that "
            "of the mean pressure in the middle fifth of the plateau.", "",
            *table(("zones", "error relative to the plateau", "error relative to the pressure drop"), rows)]


def liquid_miss(zones: int, grading: float) -> tuple[float, float]:
    """(error in the middle of the plateau, plateau over the drop); zones get finer towards the contact by `grading`."""
    law, gas, stop, wall = StiffenedGas(4.4, 6e8, 1000.0), IdealGas(1.4), 2.4e-4, Boundary("fixed")
    exact = riemann(law, state(law, density=1000.0, pressure=2e8), gas, state(gas, density=10.0, pressure=2e5))
    left, right = round(0.7 * zones), round(0.3 * zones)
    regions = (Region("liquid", "liquid", 0.0, 0.7, left, ratio=grading ** (-1.0 / (left - 1)), density=1000.0, pressure=2e8),
               Region("gas", "gas", 0.7, 1.0, right, ratio=grading ** (1.0 / (right - 1)), density=10.0, pressure=2e5))
    found = marched(Problem("tube", "planar", stop, regions, {"liquid": Material("liquid", law), "gas": Material("gas", gas)}, wall, wall,
                            bonded(regions))).state()
    tail, contact = (0.7 + float(speed) * stop for speed in (exact.left.tail, exact.velocity))
    middle = np.abs((found.position_middle - tail) / (contact - tail) - 0.5) < 0.1
    plateau = float(exact.pressure)
    return abs(float(np.mean(found.zones["pressure"][middle])) / plateau - 1.0), plateau / (2e8 - plateau)


# -- transmitting ends -------------------------------------------------------------------------------------------------------
def ends() -> list[str]:
    kinds = {"fluid": Material("m", FLUORIDE), "with strength": Material("m", FLUORIDE, PerfectlyPlastic(49e9, 0.36e9))}
    plane = [[f"{words}, {integrator}", *(echo(material, pressure, integrator) if material.strength or pressure > 2e9 else "not run"
                                          for pressure in (2e9, 5e9, 20e9, 50e9))]
             for words, material in kinds.items() for integrator in ("compatible", "wilkins")]
    curved = [[f"{geometry}, {words}", *(echo(material, pressure, "compatible", geometry, shape) for shape, pressure in (
               ("half_sine", 1e8), ("square", 5e9), ("square", 20e9), ("square", 50e9), ("constant", 50e9)))]
              for geometry in ("cylindrical", "spherical") for words, material in kinds.items()]
    return ["A body with a transmitting end is compared with one twice as long. The tables give the largest difference in stress, "
            "in all zones but the last ten, relative to the largest stress that arrives at the end. The material is LiF ($c_0$ = "
            "5150 m/s, $s$ = 1.35), as a fluid or with strength ($G$ = 49 GPa, $Y$ = 0.36 GPa). Square pulses enter 150 zones of 50 µm. "
            "They last 0.4 µs, but 1 µs with strength at 2 and 5 GPa.", "",
            *table(("material, integrator", "2 GPa", "5 GPa", "20 GPa", "50 GPa"), plane),
            "In curved geometry with `compatible`, pulses of 0.4 µs act on the wall of a cavity of 5 mm radius:", "",
            *table(("geometry, material", "half sine, 0.1 GPa", "square, 5 GPa", "square, 20 GPa", "square, 50 GPa", "sustained, 50 GPa"),
                   curved)]


def echo(material: Material, pressure: float, integrator: str, geometry: str = "planar", shape: str = "square") -> str:
    """The fraction of a wave that a transmitting end reflects, as the table shows it."""
    zones, length, step = 150, 7.5e-3, 0.2 * 50e-6 / 9000.0        # both bodies take the same steps
    start, stop = (0.0, 3e-6) if geometry == "planar" else (5e-3, 4e-6)
    duration = 1e-6 if material.strength and pressure <= 5e9 and geometry == "planar" else 0.4e-6
    drive = Boundary("pressure", Pulse(shape, amplitude=pressure, duration=duration))
    options = SolverOptions(integrator=integrator, largest_step=step, initial_step=step)
    bodies = [make_solver(Problem("body", geometry, stop, (Region("body", "m", start, start + k * length, k * zones),), {"m": material},
                                  drive, Boundary("transmitting"), solver=options)) for k in (1, 2)]
    worst = incident = 0.0
    for time in np.linspace(0.0, stop, 101)[1:]:
        for solver in bodies:
            while solver.time < time:
                solver.march(time, 10**5)
        short, free = (solver.zones[Z.sigma, :zones] for solver in bodies)
        worst, incident = max(worst, np.abs(short - free)[:-10].max()), max(incident, free[-30:].max())
    return f"{100 * worst / incident:.1f} %"
