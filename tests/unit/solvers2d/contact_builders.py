"""Problems in which bodies meet."""

import dataclasses
import math

import numpy as np
from plane_builders import aluminium, box, problem, ran, walls

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.contact_model import Contact2D, Rigid2D
from hugoniot.problem.plane.model import Block2D, Boundary2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.solver import Lagrange2D


def meeting(blocks, stop, boundaries=(), geometry="plane", contacts=(), rigid=(), material=None, **options):
    """A problem with laws of contact and rigid bodies."""
    made = problem(blocks, material or aluminium(), stop, boundaries, geometry, **options)
    return dataclasses.replace(made, contacts=tuple(contacts), rigid=tuple(rigid))


def al(nx, ny, width, height, origin=(0.0, 0.0), name="a", velocity=(0.0, 0.0)):
    """A box of aluminium."""
    return box(nx, ny, width, height, origin, name, "al", velocity=VelocityField(base=velocity))


def strip(across_target=3, across_flyer=3, gap=1e-3, along=40, stop=1.2e-6, **options):
    """A flyer of 2 mm at 700 m/s and a target of 4 mm between walls, so that the motion is one-dimensional."""
    blocks = [al(across_target, 2 * along, 0.5e-3, 4e-3, (0.0, -4e-3), "target"),
              al(across_flyer, along, 0.5e-3, 2e-3, (0.0, gap), "flyer", (0.0, -700.0))]
    sides = walls("target.left", "target.right", "flyer.left", "flyer.right")
    return meeting(blocks, stop + gap / 700.0, sides, **options)


def bars(zones, stop=12e-6):
    """Two equal bars of 20 mm, one of them at 20 m/s, between walls."""
    return meeting([al(1, zones, 1e-3, 20e-3), al(1, zones, 1e-3, 20e-3, (0.0, 20.001e-3), "b", (0.0, -20.0))], stop,
                   walls("a.left", "a.right", "b.left", "b.right"))


def rebound(given):
    """(time in touch over that in which a wave runs through a bar and back, relative velocity in the end over that before) of `bars`."""
    solver, touching = Lagrange2D(given), []
    while solver.time < given.stop_time:
        solver.march(given.stop_time, 1)
        if np.abs(solver.contact.tables.of_points[:, C.FORCE_Y]).max() > 1e3:
            touching.append(solver.time)
    c = np.sqrt((2700.0 * 5200.0**2 + 4.0 / 3.0 * 24.8e9) / 2700.0)
    return (touching[-1] - touching[0]) * c / 40e-3, (mean_velocity(solver, 1) - mean_velocity(solver, 0))[1] / 20.0


def sphere(n, radius, centre, speed, material="al"):
    """A sphere of four arcs about the axis."""
    q, e = radius * math.sqrt(0.5), radius * math.sin(math.pi / 8)
    f = radius * math.cos(math.pi / 8)
    shape = Edges(Curve("line", ((0.0, centre - radius), (0.0, centre + radius))), Curve("arc", ((q, centre - q), (radius, centre), (q, centre + q))),
                  Curve("arc", ((0.0, centre - radius), (e, centre - f), (q, centre - q))),
                  Curve("arc", ((0.0, centre + radius), (e, centre + f), (q, centre + q))), "winslow")
    return Block2D("ball", material, shape, (n, 2 * n), velocity=VelocityField(base=(0.0, speed)))


def askew(swapped=False, **options):
    """Two boxes of different meshes that strike each other off centre."""
    blocks = [al(4, 6, 4e-3, 6e-3, name="a"), al(5, 7, 4e-3, 6e-3, (4.2e-3, 3.1e-3), "b", (-300.0, 20.0))]
    return meeting(blocks[::-1] if swapped else blocks, 9e-6, **options)


def angular_momentum(solver):
    """About the origin, kg m2/s per metre."""
    n = solver.nodes
    return float(np.sum(n[N.own] * (n[N.x] * n[N.v] - n[N.y] * n[N.u])))


def moment(places, forces):
    """Of forces at places, both (2, n), about the origin."""
    return float(np.sum(places[0] * forces[1] - places[1] * forces[0]))


def moment_of_contact(solver):
    """Moment of the impulses of contact in the last step, at the places of nodes in its middle, about the origin, kg m2/s per metre."""
    contact, n, found = solver.contact.tables, solver.nodes, 0.0
    for (node, *_), numbers in zip(contact.movers, contact.mover_numbers):
        found += n[N.xh, node] * numbers[C.JY] - n[N.yh, node] * numbers[C.JX]
    return float(found)


def mean_velocity(solver, block):
    """Mass mean of the velocity of a block."""
    part = slice(solver.numbering.first[block], solver.numbering.first[block + 1])
    mass = solver.nodes[N.own, part]
    return np.array([np.sum(mass * solver.nodes[row, part]) / mass.sum() for row in (N.u, N.v)])


__all__ = ["Boundary2D", "Contact2D", "Material", "MieGruneisen", "N", "Pulse", "Rigid2D", "Z", "al", "angular_momentum", "askew", "bars",
           "mean_velocity", "meeting", "moment", "moment_of_contact", "ran", "rebound", "sphere", "strip", "walls"]
