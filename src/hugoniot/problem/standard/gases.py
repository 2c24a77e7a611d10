"""Standard problems of gases and liquids: shock tubes, interacting blasts, implosions, explosions, smooth flows."""

import math

import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.materials.material import Material
from hugoniot.problem.model import GEOMETRIES, Boundary, Problem, Region
from hugoniot.problem.standard.parts import (
    Bar,
    Measure,
    StandardProblem,
    constant_velocity,
    frozen,
    gas,
    pressure_table,
    profiled,
    simple,
)

FIXED = Boundary("fixed")


def _split(zones: int, fraction: float) -> tuple[int, int]:
    first = max(1, round(zones * fraction))
    return first, max(1, zones - first)


def build_sod(zones: int) -> Problem:
    a, b = _split(zones, 0.5)
    regions = (Region("left", "gas", 0.0, 0.5, a, density=1.0, pressure=1.0),
               Region("right", "gas", 0.5, 1.0, b, density=0.125, pressure=0.1))
    return simple("Sod shock tube", 0.2, regions, {"gas": gas(1.4)}, FIXED, FIXED)


def build_leblanc(zones: int) -> Problem:
    a, b = _split(zones, 1.0 / 3.0)
    regions = (Region("left", "gas", 0.0, 3.0, a, density=1.0, energy=0.1), Region("right", "gas", 3.0, 9.0, b, density=1e-3, energy=1e-7))
    return simple("LeBlanc shock tube", 6.0, regions, {"gas": gas(5.0 / 3.0)}, FIXED, FIXED)


def build_two_rarefactions(zones: int) -> Problem:
    a, b = _split(zones, 0.5)
    regions = (Region("left", "gas", 0.0, 0.5, a, velocity=-2.0, density=1.0, pressure=0.4),
               Region("right", "gas", 0.5, 1.0, b, velocity=2.0, density=1.0, pressure=0.4))
    return simple("123 problem", 0.15, regions, {"gas": gas(1.4)}, constant_velocity(-2.0), constant_velocity(2.0))


def build_collision(zones: int) -> Problem:
    # the left boundary follows its gas and must not overtake the slow left shock before the end: hence the long tube
    a, b = _split(zones, 0.5)
    regions = (Region("left", "gas", -0.5, 0.5, a, velocity=19.5975, density=5.99924, pressure=460.894),
               Region("right", "gas", 0.5, 1.5, b, velocity=-6.19633, density=5.99242, pressure=46.0950))
    return simple("colliding streams", 0.035, regions, {"gas": gas(1.4)}, constant_velocity(19.5975), constant_velocity(-6.19633))


def build_woodward_colella(zones: int) -> Problem:
    edges, pressures = (0.0, 0.1, 0.9, 1.0), (1000.0, 0.01, 100.0)
    counts = (max(1, round(0.1 * zones)), max(1, zones - 2 * max(1, round(0.1 * zones))), max(1, round(0.1 * zones)))
    regions = tuple(Region(f"part {k + 1}", "gas", edges[k], edges[k + 1], counts[k], density=1.0, pressure=pressures[k]) for k in range(3))
    return simple("Interacting blast waves", 0.038, regions, {"gas": gas(1.4)}, FIXED, FIXED)


def build_noh(geometry: str, zones: int) -> Problem:
    region = Region("gas", "gas", 0.0, 1.0, zones, velocity=-1.0, density=1.0, energy=0.0)
    return simple(f"Noh, {geometry}", 0.6, (region,), {"gas": gas(5.0 / 3.0)}, FIXED, Boundary("free"), geometry=geometry)


SEDOV_ENERGY = {"planar": 0.0673185, "cylindrical": 0.311357, "spherical": 0.851072}
SEDOV_EDGE = {"planar": 0.6, "cylindrical": 0.9, "spherical": 1.2}
_SOLID_ANGLE = {1: 1.0, 2: 2.0 * math.pi, 3: 4.0 * math.pi}


def build_sedov(geometry: str, zones: int) -> Problem:
    """The energy starts in the innermost zone alone; it is that of one side, of a metre, or of the whole sphere."""
    d, edge = GEOMETRIES[geometry], SEDOV_EDGE[geometry]
    width = edge / zones
    energy = SEDOV_ENERGY[geometry] / (_SOLID_ANGLE[d] * width**d / d)
    regions = (Region("spark", "gas", 0.0, width, 1, density=1.0, energy=energy),
               Region("gas", "gas", width, edge, zones - 1, density=1.0, energy=0.0))
    return simple(f"Sedov, {geometry}", 1.0, regions, {"gas": gas(1.4)}, FIXED, FIXED, geometry=geometry)


KIDDER_STOP = 0.9  # of the focussing time: volume compression by 1 / (1 - 0.81)


def build_kidder(zones: int) -> Problem:
    """Cylindrical shell of a gamma = 2 gas, driven on both faces by the pressure of the isentropic solution."""
    r1, r2, p1, p2, rho2, gamma = 0.9, 1.0, 0.1, 10.0, 0.01, 2.0
    constant = p2 / rho2**gamma
    rho1 = math.sqrt(p1 / constant)
    tau = math.sqrt(0.5 * (r2**2 - r1**2) / (gamma * constant * (rho2 - rho1)))
    faces = np.linspace(r1, r2, zones + 1)
    middle = 0.5 * (faces[1:] ** 2 + faces[:-1] ** 2)  # rho0 is linear in r^2, so this gives each zone its exact mass
    density = ((r2**2 - middle) * rho1 + (middle - r1**2) * rho2) / (r2**2 - r1**2)
    stop = KIDDER_STOP * tau
    drives = [pressure_table(lambda t, p=p: p * (1.0 - (t / tau) ** 2) ** (-gamma), stop) for p in (p1, p2)]
    regions = profiled("gas", faces, density=density, pressure=constant * density**gamma)
    return simple("Kidder shell", stop, regions, {"gas": Material("gas", IdealGas(gamma, 1.0, 1.0))}, *drives, geometry="cylindrical")


def build_double_burgers(zones: int) -> Problem:
    """Standing wave of a gamma = 3 gas, density 1 + 0.1 cos(2 pi x), half way to breaking."""
    faces = np.linspace(0.0, 1.0, zones + 1)
    k = 2.0 * math.pi
    density = 1.0 + 0.1 * np.diff(np.sin(k * faces)) / (k * np.diff(faces))
    regions = profiled("gas", faces, density=density, pressure=density**3 / 3.0)
    return simple("gamma = 3 standing wave", 0.8, regions, {"gas": gas(3.0)}, FIXED, FIXED)


def build_water_gas(zones: int) -> Problem:
    a, b = _split(zones, 0.7)
    materials = {"liquid": Material("liquid", StiffenedGas(4.4, 6e8)), "gas": Material("gas", IdealGas(1.4))}
    regions = (Region("liquid", "liquid", 0.0, 0.7, a, density=1000.0, pressure=1e9),
               Region("gas", "gas", 0.7, 1.0, b, density=50.0, pressure=1e5))
    return simple("liquid-gas shock tube", 2.4e-4, regions, materials, FIXED, FIXED)


def _noh(geometry, ko, g2, first_ko, first_g2, mean_ko, mean_g2, first_goal, mean_goal, l1_goal):
    plateau = 4.0 ** GEOMETRIES[geometry]
    bars = [Bar("density_l1", n, k, g, l1_goal if n == 200 else None) for n, k, g in zip((100, 200, 400), ko, g2)]
    bars.append(Bar("wall_density", 200, first_ko, first_g2, first_goal, "above"))
    bars.append(Bar("plateau_density", 200, mean_ko, mean_g2, mean_goal))
    measures = (Measure("density_l1", "l1", "density", (0.0, 0.39), scale=plateau),
                Measure("wall_density", "first", "density", exact=plateau),
                Measure("plateau_density", "mean", "density", (0.08, 0.15), plateau))
    return StandardProblem(f"noh_{geometry}", f"Noh's implosion, {geometry}: cold gas stops against a wall, axis or centre",
                           lambda zones: build_noh(geometry, zones), measures, tuple(bars), "noh",
                           frozen(geometry=geometry, gamma=5.0 / 3.0), zones=(100, 200, 400))


def _sedov(geometry):
    measures = (Measure("shock_position", "front", "density", scale={"planar": 0.5, "cylindrical": 0.75, "spherical": 1.0}[geometry]),
                Measure("peak_density", "maximum", "density", exact=6.0), Measure("density_l1", "l1", "density"))
    bars = (Bar("shock_position", 400, goal=1e-3), Bar("peak_density", 400, goal=5.7, sense="above"))
    return StandardProblem(f"sedov_{geometry}", f"Point explosion, {geometry}: shock at r = {measures[0].scale:g} at t = 1",
                           lambda zones: build_sedov(geometry, zones), measures, bars, "sedov",
                           frozen(geometry=geometry, gamma=1.4, energy=SEDOV_ENERGY[geometry]), zones=(100, 200, 400))


PROBLEMS = (
    StandardProblem(
        "sod", "Sod's shock tube: rarefaction, contact, shock", build_sod,
        (Measure("density_l1", "l1", "density", (0.0, 1.0)),),
        (Bar("density_l1", 100, 6.81e-3, 5.27e-3, 4.0e-3), Bar("density_l1", 200, 3.42e-3, 2.65e-3),
         Bar("density_l1", 400, 1.72e-3, 1.32e-3), Bar("density_l1", 800, 8.7e-4, 6.6e-4)),
        "sod", rates=frozen(density_l1=1.0), zones=(100, 200, 400, 800)),
    StandardProblem(
        "leblanc", "LeBlanc's shock tube: ratio of energies 10^6", build_leblanc,
        (Measure("shock_position", "front", "density", at=1), Measure("density_l1", "l1", "density", (0.0, 9.0)),
         Measure("energy_l1", "l1", "energy", (0.0, 9.0))),
        (Bar("shock_position", 360, 0.272, 0.143), Bar("shock_position", 720, 0.191, 0.128, 0.05),
         Bar("shock_position", 1440, 0.081, 0.088, 0.02),
         Bar("density_l1", 360, 1.81e-3), Bar("density_l1", 720, 9.7e-4), Bar("density_l1", 1440, 4.4e-4),
         Bar("energy_l1", 360, 9.5e-3), Bar("energy_l1", 720, 6.0e-3), Bar("energy_l1", 1440, 2.8e-3)),
        "leblanc", zones=(360, 720, 1440)),
    StandardProblem(
        "two_rarefactions", "The 123 problem: two rarefactions that leave almost a vacuum", build_two_rarefactions,
        (Measure("energy_minimum", "minimum", "energy"), Measure("density_l1", "l1", "density"), Measure("energy_l1", "l1", "energy")),
        (Bar("energy_minimum", 200, goal=0.0, sense="above"),), "two_rarefactions"),
    StandardProblem(
        "collision", "Two colliding streams: two strong shocks", build_collision,
        (Measure("density_l1", "l1", "density", (0.72, 1.25)), Measure("energy_l1", "l1", "energy", (0.72, 1.25))), (), "collision"),
    StandardProblem(
        "woodward_colella", "Two interacting blast waves, compared with a run on 3200 zones and with four reference densities",
        build_woodward_colella,
        (Measure("density_self_l1", "self_l1", "density", (0.0, 1.0), exact=3200.0), Measure("reference_density", "points", "density"),
         Measure("peak_density", "maximum", "density")),
        (Bar("density_self_l1", 400, 0.0343, 0.0195, 0.015), Bar("density_self_l1", 800, 0.0185, 0.0088, 0.007)),
        "woodward_colella", zones=(400, 800)),
    _noh("planar", (0.0199, 0.0100, 0.0050), (0.0073, 0.0037, 0.0019), 0.535, 0.775, None, None, 0.95, None, 0.005),
    _noh("cylindrical", (0.133, 0.078, 0.043), (0.028, 0.015, 0.0083), 0.22, 0.54, 1 - 14.94 / 16, 1 - 15.81 / 16, None, 0.01, None),
    _noh("spherical", (0.257, 0.164, 0.097), (0.071, 0.040, 0.022), 0.10, 0.31, 1 - 52.1 / 64, 1 - 61.6 / 64, None, 0.03, None),
    _sedov("planar"), _sedov("cylindrical"), _sedov("spherical"),
    StandardProblem(
        "kidder", "Kidder's shell: isentropic compression by a smooth drive, no shock", build_kidder,
        (Measure("outer_radius", "boundary", "position", exact=math.sqrt(1.0 - KIDDER_STOP**2), at=1),
         Measure("density_l1", "l1", "density", scale=0.01)),
        (Bar("outer_radius", 100, goal=1e-4),), "kidder", rates=frozen(outer_radius=1.9), zones=(25, 50, 100, 200)),
    StandardProblem(
        "double_burgers", "Smooth standing wave of a gamma = 3 gas: converges with second order", build_double_burgers,
        (Measure("density_l1", "l1", "density"), Measure("velocity_l1", "l1", "velocity")), (), "double_burgers",
        rates=frozen(density_l1=1.95, velocity_l1=1.95), zones=(50, 100, 200, 400)),
    StandardProblem(
        "water_gas", "Shock tube, compressed liquid against a gas: ratio of pressures 10^4", build_water_gas,
        (Measure("plateau_pressure", "mean", "pressure", (0.72, 0.80), "star_pressure"),
         Measure("plateau_velocity", "mean", "velocity", (0.50, 0.80), "star_velocity"),
         Measure("density_l1", "l1", "density", scale=1000.0)),
        (Bar("plateau_pressure", 400, goal=1e-3), Bar("plateau_velocity", 400, goal=1e-3)), "water_gas"),
)
