"""From a Problem2D to the solver's arrays: nodes and their masses, zones and their initial states, laws as recipes, pieces, boundaries."""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import density_limits, pressure
from hugoniot.laws.fracture.contract import FRACTURE, asked_at_nodes
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.laws.viscosity.limited import Limited
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.explosives import crushing_density
from hugoniot.problem.plane.contact import trouble_on_the_axis
from hugoniot.problem.plane.model import CELLS, VISCOSITIES, Problem2D
from hugoniot.solvers.lagrange1d import reactive
from hugoniot.solvers.lagrange1d.assemble import ROUND_OFF, longitudinal_speed, start_compaction, viscosity_in
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import quads as G
from hugoniot.solvers.lagrange2d.coefficients import Viscous
from hugoniot.solvers.lagrange2d.zone_shapes import areas, corner_shares, over_nodes, quad_corners, volumes, zone_corners
from hugoniot.zones.laws import keeps_time, laws_of

N = L.Nodes(*range(len(L.Nodes._fields)))
Z = L.Zones(*range(len(L.Zones._fields)))


def kind_of(problem: Problem2D) -> int:
    """Code of the geometry. OutOfRange for options this solver does not have."""
    options = problem.solver
    for name, value, known in (("cells", options.cells, CELLS), ("viscosity.kind", options.viscosity.kind, VISCOSITIES),
                               ("integrator", options.integrator, ("compatible",))):
        if value not in known:
            raise OutOfRange(f"solver.{name} = {value!r} is not available in two dimensions; use {' or '.join(map(repr, known))}")
    if options.viscosity.kind == "herrmann" and options.viscosity.limited:
        raise OutOfRange("Herrmann's viscosity has no limiter; use solver.viscosity.limited = false")
    for material in problem.materials.values():
        if asked_at_nodes(material.fracture):
            raise OutOfRange(f"material '{material.name}': its fracture law opens voids at nodes, but in two dimensions zones fail and "
                             'nodes stay joined; use "pressure_volume" or "spall_stress"')
    if wrong := trouble_on_the_axis(problem):
        raise OutOfRange(f'{wrong}; use solver.scheme = "true_volume"')
    if problem.geometry == "plane":
        return G.PLANAR
    return G.AREA_WEIGHTED if problem.solver.scheme == "area_weighted" else G.TRUE_VOLUME


# -- nodes ------------------------------------------------------------------------------------------------------------------
class Numbering:
    """Where the nodes of blocks stand in the node table: `first` of each block, `copies` (flat) of global nodes, table nodes of each."""

    def __init__(self, mesh):
        self.mesh = mesh
        sizes = [(b.ni + 1) * (b.nj + 1) for b in mesh.blocks]
        self.first = np.concatenate(([0], np.cumsum(sizes)))
        self.total = int(self.first[-1])
        self.nodes = np.concatenate([b.nodes.ravel() for b in mesh.blocks])       # global number of each node of the table
        order = np.argsort(self.nodes, kind="stable")
        self.representative = order[np.searchsorted(self.nodes[order], np.arange(mesh.nodes.shape[1]))]
        self.copies = np.bincount(self.nodes, minlength=mesh.nodes.shape[1])
        self.alone = np.array_equal(self.representative, np.arange(self.total))      # whether table and mesh number nodes alike

    def local(self, block: int, i, j):
        """Place in the table of node (i, j) of a block."""
        return self.first[block] + np.asarray(i) * (self.mesh.blocks[block].nj + 1) + j

    def all_copies(self, node: int):
        """Places in the table of every copy of a global node."""
        return np.flatnonzero(self.nodes == node)

    def shared(self):
        """(starts, members): the groups of nodes that are one."""
        mesh = self.mesh
        members = [int(self.local(b, i, j)) for b, i, j in mesh.shared]
        return np.asarray(mesh.shared_start, dtype=np.int64), np.array(members, dtype=np.int64)


def block_masses(mesh, block, mass, kind: int, shared: bool):
    """Masses of a block's nodes (flat) from those of its zones; triangles that share their pressure push as their cell, and weigh so."""
    if mesh.quads is None or shared:
        x, y = quad_corners(block)
        return over_nodes(block, corner_shares(x, y, kind) * mass.reshape(block.ni, block.per_cell, block.nj).sum(axis=1).ravel())
    (x, y), place = zone_corners(mesh, block)
    return np.bincount(place.ravel(), (corner_shares(x, y, kind) * mass).ravel(), minlength=(block.ni + 1) * (block.nj + 1))


def shares_pressure(problem: Problem2D, block) -> bool:
    """Whether both triangles of each cell of a block share their pressure."""
    options = problem.solver
    return options.cells == "triangles" and options.average_pressure and problem.materials[block.material].strength is not None


def node_tables(problem: Problem2D, numbering: Numbering, kind: int, zones):
    """(node table, kinetic energy lost where blocks of different velocity share nodes, as heat of their zones)."""
    mesh = problem.mesh
    table = np.zeros((len(N), numbering.total))
    heat = np.zeros(zones.shape[1])
    own, momentum = np.zeros(numbering.total), np.zeros((2, numbering.total))
    energy = np.zeros(numbering.total)
    for k, (block, velocity) in enumerate(zip(mesh.blocks, problem.velocities())):
        part = slice(numbering.first[k], numbering.first[k + 1])
        table[N.x, part], table[N.y, part] = block.x.ravel(), block.y.ravel()
        own[part] = block_masses(mesh, block, zones[Z.mass, block.first_zone : block.first_zone + block.zones], kind,
                                 shares_pressure(problem, problem.blocks[k]))
        momentum[:, part] = velocity.reshape(2, -1) * own[part]
        energy[part] = 0.5 * own[part] * np.sum(velocity.reshape(2, -1) ** 2, axis=0)
    whole = np.bincount(numbering.nodes, own)
    carried = np.stack([np.bincount(numbering.nodes, part) for part in momentum])
    safe = np.where(whole > 0.0, whole, 1.0)
    united = carried / safe
    for k, velocity in enumerate(problem.velocities()):       # a node of one block keeps its velocity to the last bit
        part = slice(numbering.first[k], numbering.first[k + 1])
        alone = numbering.copies[numbering.nodes[part]] == 1
        united[:, numbering.nodes[part][alone]] = velocity.reshape(2, -1)[:, alone]
        if kind == G.AREA_WEIGHTED:                           # nodes on the axis weigh nothing
            light = whole[numbering.nodes[part]] == 0.0
            united[:, numbering.nodes[part][light]] = velocity.reshape(2, -1)[:, light]
    table[N.u], table[N.v] = united[0, numbering.nodes], united[1, numbering.nodes]
    table[N.own] = whole[numbering.nodes] / numbering.copies[numbering.nodes]
    table[N.im] = 1.0 / np.where(whole > 0.0, whole, 1.0)[numbering.nodes]
    table[N.xh], table[N.yh], table[N.um], table[N.vm] = table[N.x], table[N.y], table[N.u], table[N.v]
    lost = np.bincount(numbering.nodes, energy) - 0.5 * whole * np.sum(united**2, axis=0)
    lost = np.where(numbering.copies > 1, np.maximum(lost, 0.0), 0.0)
    if lost.any():
        touching = np.bincount(mesh.zone_nodes.ravel(), np.repeat(zones[Z.mass], mesh.zone_nodes.shape[1]), minlength=whole.size)
        heat = np.sum((lost / touching)[mesh.zone_nodes], axis=1)      # J/kg: by mass among the zones around the node
    return table, heat


def planar_shares(problem: Problem2D, block, index: int):
    """Parts of the area that belong to a block's nodes (flat)."""
    mesh = problem.mesh
    if mesh.quads is not None and not shares_pressure(problem, problem.blocks[index]):
        (x, y), place = zone_corners(mesh, block)
        return np.bincount(place.ravel(), np.tile(areas(x, y) / 3.0, 3), minlength=(block.ni + 1) * (block.nj + 1))
    x, y = quad_corners(block)
    area = volumes(x, y, G.PLANAR)
    triangle = 0.5 * ((np.roll(x, -1, 0) - x) * (np.roll(y, 1, 0) - y) - (np.roll(y, -1, 0) - y) * (np.roll(x, 1, 0) - x))
    return over_nodes(block, 0.125 * area + 0.25 * triangle)


def axis_tables(problem: Problem2D, numbering: Numbering, nodes, kind: int):
    """Area weighted: (axis nodes and a neighbour off the axis, ratio of their areal masses at t = 0)."""
    if kind != G.AREA_WEIGHTED:
        return np.zeros((0, 2), dtype=np.int64), np.zeros(0)
    pairs, ratios, known = [], [], set()
    planar = np.zeros(nodes.shape[1])
    for k, block in enumerate(numbering.mesh.blocks):
        planar[numbering.first[k]:numbering.first[k + 1]] = planar_shares(problem, block, k)
    planar = np.bincount(numbering.nodes, planar)[numbering.nodes]
    for k, block in enumerate(numbering.mesh.blocks):
        i, j = np.nonzero(block.x == 0.0)
        for a, b in zip(i.tolist(), j.tolist()):
            near = [(p, q) for p, q in ((a + 1, b), (a - 1, b), (a, b + 1), (a, b - 1))
                    if 0 <= p <= block.ni and 0 <= q <= block.nj and block.x[p, q] > 0.0]
            node = int(block.nodes[a, b])
            if near and node not in known:
                known.add(node)
                beside = int(numbering.local(k, *near[0]))
                for copy in numbering.all_copies(node):
                    pairs.append((int(copy), beside))
                    ratios.append(planar[copy] / planar[beside])
    return np.array(pairs, dtype=np.int64).reshape(-1, 2), np.array(ratios)


# -- zones --------------------------------------------------------------------------------------------------------------------
def viscosity_law(problem: Problem2D, material, eos):
    """Parameters of the viscous speed in a material, `Viscous` or Herrmann's law; eos: its equation of state, or its `Reactive` pair."""
    given = problem.solver.viscosity
    kind = "explosive_" if material.burn is not None else "solid_" if material.strength is not None else ""
    quadratic, linear = getattr(given, kind + "quadratic"), getattr(given, kind + "linear")
    if keeps_time(eos):
        linear = 0.0      # it would compress what has no pressure yet, ahead of the front, whose pressure then grows without end
    shear = given.solid_shear if kind == "solid_" else linear
    if given.kind == "herrmann":      # B1 enters squared; a strong shock is resisted as by the others
        return VISCOSITY.get("herrmann").build(quadratic=float(np.sqrt(2.0 * quadratic)), linear=shear)
    # burn laws were calibrated with one thickness of shock
    condensed = linear if material.burn is not None else getattr(given, kind + "linear_condensed")
    return Viscous(*viscosity_in(material, Limited(quadratic, linear, condensed)), shear)


def start_block(problem: Problem2D, block):
    """(rho, e, p, sound speed) of a block at t = 0."""
    material = problem.materials[block.material]
    if material.burn is not None:
        return reactive.start_region(material, block)
    rho, e = initial_state(material.eos, block.density, block.pressure, block.temperature, block.energy)
    low, high = density_limits(material.eos)
    if not low < rho < high:
        raise OutOfRange(f"block '{block.name}' starts at {rho:g} kg/m3, outside the range of its law, {low:g} to {high:g} kg/m3")
    return rho, e, float(pressure(rho, e, material.eos)), longitudinal_speed(material, rho, e)


def zone_tables(problem: Problem2D, kind: int):
    """Zone table at t = 0."""
    mesh = problem.mesh
    zones = np.zeros((len(Z), len(mesh.zone_nodes)))
    for block, part in zip(problem.blocks, mesh.blocks):
        zone = slice(part.first_zone, part.first_zone + part.zones)
        rho, e, p, c = start_block(problem, block)
        (x, y), _ = zone_corners(mesh, part)
        material = problem.materials[block.material]
        zones[Z.mass, zone] = rho * volumes(x, y, kind)
        zones[Z.rho, zone], zones[Z.e, zone], zones[Z.p, zone], zones[Z.c, zone] = rho, e, p, c
        zones[Z.compaction, zone] = start_compaction(material.eos, rho, e) if material.burn is None else 0.0
        if len(x) == 3:
            continue
        area = volumes(x, y, G.PLANAR)
        zones[Z.t0, zone] = 0.5 * ((x[1] - x[0]) * (y[3] - y[0]) - (y[1] - y[0]) * (x[3] - x[0])) / area
        zones[Z.t1, zone] = 0.5 * ((x[2] - x[1]) * (y[0] - y[1]) - (y[2] - y[1]) * (x[0] - x[1])) / area
    zones[Z.inverse_mass] = 1.0 / zones[Z.mass]
    zones[Z.sigma] = zones[Z.p]
    return zones


def materials_of(problem: Problem2D, speed: float, near: float):
    """(laws, numbers behind their constants included, whether it is a fluid, whether triangles share their pressure) of each material, and
    which of them each block follows."""
    found, noise = {}, ROUND_OFF * speed**2
    for block in problem.blocks:
        if block.material in found:
            continue
        material = problem.materials[block.material]
        fluid, burns = material.strength is None, material.burn is not None
        alike = [other for other in problem.blocks if other.material == block.material]
        own = {"crushed": crushing_density(material, alike), **reactive.constants(problem, block)} if burns else {}
        eos = burning.reactive(material) if burns else material.eos
        laws = laws_of(eos, material.strength or STRENGTH.get("none").example,
                       material.fracture or FRACTURE.get("none").example, viscosity_law(problem, material, eos),
                       noise=noise + (1.0 if burns else 0.0), **own)
        coefficient = problem.solver.subzonal_pressure if fluid else problem.solver.flanagan_belytschko
        found[block.material] = laws, np.array([*laws.constants, near, coefficient]), fluid, shares_pressure(problem, block)
    return list(found.values()), [list(found).index(block.material) for block in problem.blocks]


def unburned(problem: Problem2D, charge, zones, size) -> None:
    """Fill the table of burning zones at t = 0: nothing burned, the clock of their lighting; size: width of every zone, m."""
    from hugoniot.problem.plane.lighting import zone_lighting_times

    rows = L.Charge(*charge)
    rows.rho_r[:], rows.e_r[:], rows.size[:] = zones[Z.rho], zones[Z.e], size
    rows.resolution[:] = 1e300
    rows.since[:] = -zone_lighting_times(problem)
