"""Standard problems of solids: elastic-plastic pistons, stopping shells, flyer plates."""

import numpy as np

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import GEOMETRIES, Boundary, Problem, Region
from hugoniot.problem.standard.parts import Bar, Measure, StandardProblem, constant_velocity, frozen, profiled, simple

ALUMINIUM = MieGruneisen(2785.0, 5328.0, 1.338, 2.0)
COPPER = MieGruneisen(8930.0, 3940.0, 1.49, 2.0)
FLYER_COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)  # the slope with which the impact figures of the flyer impacts were computed
TUNGSTEN = MieGruneisen(19224.0, 4029.0, 1.237, 1.54)
IRON = MieGruneisen(7850.0, 3574.0, 1.92, 1.69)
FREE = Boundary("free")
FLYER_STOP = 1.2e-6


def build_piston(title: str, eos, strength: PerfectlyPlastic, speed: float, length: float, stop: float, zones: int) -> Problem:
    material = Material("solid", eos, strength)
    return simple(title, stop, (Region("solid", "solid", 0.0, length, zones),), {"solid": material}, constant_velocity(speed), FREE)


def build_aluminium_piston(zones: int) -> Problem:
    return build_piston("Aluminium piston, 400 m/s", ALUMINIUM, PerfectlyPlastic(27.6e9, 0.3e9), 400.0, 0.05, 5e-6, zones)


def build_copper_piston(zones: int) -> Problem:
    return build_piston("Copper piston, 20 m/s", COPPER, PerfectlyPlastic(45e9, 0.09e9), 20.0, 1.0, 150e-6, zones)


def build_udaykumar_piston(zones: int) -> Problem:
    eos = MieGruneisen(2790.0, 5330.0, 1.34, 2.0)
    return build_piston("Aluminium piston, 100 m/s", eos, PerfectlyPlastic(28.6e9, 0.26e9), 100.0, 0.05, 5e-6, zones)


def build_shell(geometry: str, speed: float, stop: float, zones: int) -> Problem:
    """Beryllium shell, 8 to 10 cm, flying inwards with u ~ 1/r^(d-1); stiff, so that the incompressible answer applies."""
    faces = np.linspace(0.08, 0.10, zones + 1)
    velocity = -speed * (0.08 / faces) ** (GEOMETRIES[geometry] - 1)
    beryllium = Material("beryllium", MieGruneisen(1845.0, 8000.0, 1.124, 1.11), PerfectlyPlastic(151e9, 330e6))
    regions = profiled("beryllium", faces, velocity=velocity)
    return simple(f"Stopping shell, {geometry}", stop, regions, {"beryllium": beryllium}, FREE, FREE, geometry=geometry)


def build_flyer(flyer, target, speed: float, zones: int) -> Problem:
    """A 5 mm flyer on a 10 mm target, without strength; ended before any release reaches the middle of the target."""
    a = max(1, round(zones / 3))
    regions = (Region("flyer", "flyer", -0.005, 0.0, a, velocity=speed), Region("target", "target", 0.0, 0.010, max(1, zones - a)))
    return simple("Flyer plate", FLYER_STOP, regions, {"flyer": Material("flyer", flyer), "target": Material("target", target)}, FREE, FREE)


def _piston(name, description, build, l1, hel, numbers, length, stop):
    """Bars: L1(rho)/rho0 of the KO scheme; goals of the elastic limit, which is the stress on the precursor's plateau."""
    rho0, elastic, plastic, elastic_speed, plastic_speed = numbers
    low, high = plastic_speed * stop, elastic_speed * stop
    # where the KO scheme shows the errors of the table: just behind the middle of the precursor's plateau
    place = low + 0.58 * (high - low)
    measures = (Measure("density_l1", "l1", "density", scale=rho0), Measure("elastic_limit", "value", "stress", (place, place), elastic),
                Measure("plastic_stress", "mean", "stress", (0.5 * low, 0.9 * low), plastic))
    bars = [Bar("density_l1", n, ko, goal=goal) for n, ko, goal in l1] + [Bar("elastic_limit", n, ko, goal=goal) for n, ko, goal in hel]
    return StandardProblem(name, description, build, measures, tuple(bars), name, zones=(125, 250, 500, 1000))


def _flyer(name, description, flyer, target, speed, pressure, velocity):
    shock = (target.c0 + target.s * velocity) * FLYER_STOP
    measures = (Measure("plateau_pressure", "mean", "pressure", (0.0025, 0.0050), pressure),
                Measure("plateau_velocity", "mean", "velocity", (0.0025, 0.0050), velocity),
                Measure("shock_position", "front", "pressure", (0.0055, 0.0100), shock, scale=shock))
    bars = (Bar("plateau_pressure", 300, goal=1e-3), Bar("plateau_velocity", 300, goal=1e-3), Bar("shock_position", 300, goal=2e-3))
    return StandardProblem(name, description, lambda zones: build_flyer(flyer, target, speed, zones), measures, bars, zones=(150, 300))


def _shell(name, description, geometry, speed, stop, exact):
    measures = (Measure("stop_radius", "smallest", "position", exact=exact),)
    return StandardProblem(name, description, lambda zones: build_shell(geometry, speed, stop, zones), measures,
                           (Bar("stop_radius", 100, goal=5e-3),), "shell_stopping", frozen(geometry=geometry, speed=speed), zones=(50, 100))


PROBLEMS = (
    _piston("aluminium_piston", "Aluminium piston at 400 m/s: elastic precursor and plastic shock", build_aluminium_piston,
            ((125, 1.07e-3, None), (250, 5.7e-4, 4e-4), (500, 2.9e-4, None), (1000, 1.5e-4, None)),
            ((125, 0.095, 2e-3), (250, 2.1e-3, None), (500, 1e-4, None)),
            (2785.0, 0.6358785336e9, 6.635878530e9, 6490.425968, 5908.518885), 0.05, 5e-6),
    _piston("copper_piston", "Copper piston at 20 m/s: elastic precursor and plastic shock", build_copper_piston,
            ((125, 7.9e-5, 3.95e-5), (250, 4.7e-5, 2.35e-5), (500, 2.9e-5, 1.45e-5), (1000, 1.8e-5, 9e-6)), (),
            (8930.0, 0.1990301038e9, 0.7415909734e9, 4722.176547, 3976.947540), 1.0, 150e-6),
    _piston("udaykumar_piston", "Aluminium piston at 100 m/s with the constants of ExactPack's ep_piston",
            build_udaykumar_piston, (), (),
            (2790.0, 0.5379910161e9, 1.618843349e9, 6520.637842, 5505.311233), 0.05, 5e-6),
    _shell("howell_ball", "Cylindrical beryllium shell that stops at 5 cm", "cylindrical", 417.1, 150e-6, 0.04999722783),
    _shell("verney", "Spherical beryllium shell that stops at 3 cm", "spherical", 675.036, 120e-6, 0.0300001048),
    _flyer("flyer_al_al_1900", "Aluminium on aluminium at 1900 m/s", ALUMINIUM, ALUMINIUM, 1900.0, 17.45957e9, 950.0),
    _flyer("flyer_al_al_1200", "Aluminium on aluminium at 1200 m/s", ALUMINIUM, ALUMINIUM, 1200.0, 10.24457e9, 600.0),
    _flyer("flyer_cu_al_1000", "Copper on aluminium at 1000 m/s", FLYER_COPPER, ALUMINIUM, 1000.0, 12.06699e9, 692.7178),
    _flyer("flyer_w_fe_1500", "Tungsten on iron at 1500 m/s", TUNGSTEN, IRON, 1500.0, 43.69319e9, 1009.689),
)
