"""Solid bodies: shells that fall inward until their strength has taken the energy, Taylor bars."""

from functools import partial

import numpy as np

from hugoniot.campaign.plane.parts import Bar, N, PlaneProblem, Z, box, node_radii, quarter_ring, solver_of, walls
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.johnson_cook import JohnsonCook
from hugoniot.laws.strength.linear_hardening import LinearHardening
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.plane.model import VelocityField
from hugoniot.theory.exact.shell_stopping import howell_ball, verney

BERYLLIUM = Material("be", MieGruneisen(1845.0, 7998.0, 1.124, 1.11), PerfectlyPlastic(151e9, 330e6))
LENGTH, RADIUS = 32.4e-3, 3.2e-3      # of Taylor bars, m
RING, SPHERE = howell_ball().numbers, verney().numbers


# -- shells -----------------------------------------------------------------------------------------------------------------
def shell(geometry, speed, power, n, asked):
    """A quarter of a beryllium shell of 8 to 10 cm that falls inward as if it were incompressible."""
    block = quarter_ring((n, n), (0.08, 0.10), "s", "be", velocity=VelocityField(radial=-speed, radius=0.08, power=power))
    sides = walls("s.bottom", "s.top") if geometry == "plane" else walls("s.bottom")
    return solver_of("shell", geometry, 1.0, block, [BERYLLIUM], sides, asked, scheme="area_weighted")


def stopped(radius, solver):
    """Radius of the inner surface beside that of a rigid-plastic shell, and how round it is."""
    inside = node_radii(solver)[0]
    return {"stop_radius": float(abs(inside.mean() / radius - 1.0)), "asymmetry": float(np.ptp(inside) / inside.mean())}


# -- Taylor bars --------------------------------------------------------------------------------------------------------------
def copper():
    young, poisson = 117e9, 0.35
    bulk, shear = young / 3.0 / (1.0 - 2.0 * poisson), young / 2.0 / (1.0 + poisson)
    return Material("cu", MieGruneisen(8930.0, np.sqrt(bulk / 8930.0), 1.49, 2.0), LinearHardening(shear, 400e6, 100e6))


def steel():
    """42CrMo4; nine tenths of the plastic work are heat in the references: a specific heat of 460 over 0.9."""
    eos = MieGruneisen(7830.0, 4692.6, 1.49, 1.7, specific_heat=511.0, reference_temperature=293.15)
    return Material("st", eos, JohnsonCook(79.58e9, 806e6, 614e6, 0.168, 0.0089, 1.1, 293.15, 1813.15))


def bar(material, speed, ratio, n, asked):
    """A bar with n zones across its radius on a wall without friction."""
    block = box((n, round(n * ratio)), (0.0, RADIUS), (0.0, LENGTH), "bar", material.name, velocity=VelocityField(base=(0.0, -speed)))
    return solver_of("Taylor bar", "axisymmetric", 80e-6, block, [material], walls("bar.bottom"), asked)


def shortened(length, foot, strain, solver):
    """Length, radius of the foot and largest plastic strain beside those of other codes."""
    x, y, z = solver.nodes[N.x], solver.nodes[N.y], solver.zones
    found = {"length": y.max() / length, "foot": x.max() / foot, "plastic_strain": z[Z.plastic_strain].max() / strain}
    heat = float(np.sum(z[Z.mass] * z[Z.e]))
    return {name: float(abs(part - 1.0)) for name, part in found.items()} | {"filter_work": solver.results()["filter_work"] / heat}


PROBLEMS = (
    PlaneProblem("howell_ring", "Howell and Ball's beryllium ring, which moves inwards and stops, n x n zones",
                 partial(shell, "plane", 417.1, -1.0), 1.02 * RING["stop_time"], partial(stopped, RING["stop_radius"]),
                 (Bar("stop_radius", 20, goal=0.006), Bar("asymmetry", 20, goal=1e-6)), (10, 20)),
    PlaneProblem("verney_sphere", "Verney's beryllium sphere, which moves inwards and stops, n x n zones, scheme area_weighted",
                 partial(shell, "axisymmetric", 675.036, -2.0), 1.02 * SPHERE["stop_time"], partial(stopped, SPHERE["stop_radius"]),
                 (Bar("stop_radius", 20, goal=0.0167), Bar("asymmetry", 20, goal=0.003)), (10, 20)),
    PlaneProblem("taylor_copper", "Taylor bar of copper, 227 m/s, compared with other codes",
                 partial(bar, copper(), 227.0, LENGTH / RADIUS), 80e-6, partial(shortened, 21.5e-3, 7.1e-3, 2.875),
                 (Bar("length", 20, goal=0.007), Bar("foot", 20, goal=0.0211), Bar("plastic_strain", 20, goal=0.13),
                  Bar("filter_work", 20, goal=0.01)), (5, 20)),
    PlaneProblem("taylor_steel", "Taylor bar of steel, Johnson-Cook, 287 m/s, 5 x 50 zones, compared with the code DynELA",
                 partial(bar, steel(), 287.0, 10.0), 80e-6, partial(shortened, 26.52e-3, 0.5 * 11.15e-3, 1.78),
                 (Bar("length", 5, goal=0.003), Bar("foot", 5, goal=0.015), Bar("plastic_strain", 5, goal=0.04)), (5,)),
)
