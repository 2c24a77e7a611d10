"""Transmitting edges: the material is assumed to continue beyond them unchanged, by the equations of `lagrange1d.transmitting`.

Every edge of such a chain is an end: the zones of its row give the impedance of the path that the material follows, with the
stress and the viscosity along the edge's normal, and the stress outside follows the normal velocity of the edge. Tangentially the edge is
free. Beyond it the limiter of the viscosity uses the previous velocity gradient of the last zone. In axisymmetric flow a wave leaving along
the radius decays as a cylindrical wave.
"""

import numba as nb
import numpy as np

from hugoniot.core.passes import rows
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.lagrange1d import layout as one
from hugoniot.solvers.lagrange1d.transmitting import BEHIND, answer_of, await_echo, begin_memory, follow
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.quads import PLANAR
from hugoniot.solvers.lagrange2d.smoothness import DIRECTION, GHOST, NODE_A, NODE_B, OWN
from hugoniot.solvers.lagrange2d.special_nodes import edge_force

STRESS, DENSITY, VISCOUS = range(3)      # rows of what an end sees
BEYOND_X, BEYOND_Y = one.END_FLOATS, one.END_FLOATS + 1      # columns of what it knows: velocity gradient beyond it
COLUMNS = one.END_FLOATS + 2


@nb.njit(**GUARD)
def normal_of(n, edge, kind, near):
    """(unit outward normal x, y, area) of a transmitting edge now."""
    a, b, sign = edge[L.OPEN_A], edge[L.OPEN_B], edge[L.OPEN_OUTWARD]
    x1, y1, x2, y2 = edge_force(n.x[a], n.y[a], n.x[b], n.y[b], kind, near)
    x, y = sign * (x1 + x2), sign * (y1 + y2)
    area = (x * x + y * y) ** 0.5
    return x / area, y / area, area


@nb.njit(**GUARD)
def look(z, edge, nx, ny, seen):
    """Stress along the normal, density and viscous pressure of the zones from an edge inward."""
    for k in range(edge[L.OPEN_COUNT]):
        zone = edge[L.OPEN_ZONE] + k * edge[L.OPEN_INWARD]
        viscous = z.qxx[zone] * nx * nx + 2.0 * z.qxy[zone] * nx * ny + z.qyy[zone] * ny * ny
        strong = z.sxx[zone] * nx * nx + 2.0 * z.sxy[zone] * nx * ny + z.syy[zone] * ny * ny
        seen[STRESS, k], seen[DENSITY, k], seen[VISCOUS, k] = z.p[zone] + viscous - strong, z.rho[zone], viscous


@nb.njit(**BY_ADDRESS)
def listen(run, dt, kind, near):
    """At the start of a step: impedance and lead of every transmitting edge, and what they are at its nodes."""
    n, z = rows(L.Nodes, run.nodes, 0), rows(L.Zones, run.zones, 0)
    for i in range(run.gate_normals.shape[0]):
        run.gate_normals[i, 0], run.gate_normals[i, 1] = 0.0, 0.0
    for k in range(run.open_edges.shape[0]):
        edge, memory = run.open_edges[k], run.ends[k]
        nx, ny, area = normal_of(n, edge, kind, near)
        look(z, edge, nx, ny, run.seen)
        zone = edge[L.OPEN_ZONE]
        follow(memory, run.seen, (STRESS, DENSITY, VISCOUS), 0, 1, z.rho[zone] * z.c[zone], z.mass[zone] / area, dt)
        x1, y1, x2, y2 = edge_force(n.x[edge[L.OPEN_A]], n.y[edge[L.OPEN_A]], n.x[edge[L.OPEN_B]], n.y[edge[L.OPEN_B]], kind, near)
        impedance = memory[one.IMPEDANCE] * edge[L.OPEN_OUTWARD]
        for end, x, y in ((L.OPEN_GATE_A, x1, y1), (L.OPEN_GATE_B, x2, y2)):
            for i in range(edge[end], edge[end] + edge[end + 1]):       # of all copies of the node
                run.gate_normals[i, 0] += impedance * x
                run.gate_normals[i, 1] += impedance * y


@nb.njit(**BY_ADDRESS)
def lag(run):
    """Velocity gradients beyond transmitting edges, after `fill_ghosts`: they follow those of the zones inside."""
    for k in range(run.open_edges.shape[0]):
        i, memory = run.open_edges[k, L.OPEN_GHOST], run.ends[k]
        if i >= 0:
            row, own, ghost = run.ghosts[i, DIRECTION], run.ghosts[i, OWN], run.ghosts[i, GHOST]
            share = min(BEHIND * memory[one.PASSED], 1.0)
            memory[BEYOND_X] += share * (run.gradients[row, own] - memory[BEYOND_X])
            memory[BEYOND_Y] += share * (run.gradients[row + 1, own] - memory[BEYOND_Y])
            run.gradients[row, ghost], run.gradients[row + 1, ghost] = memory[BEYOND_X], memory[BEYOND_Y]


@nb.njit(**BY_ADDRESS)
def answer(run, dt, kind, near):
    """At the end of a step: the stress outside after what the nodes' velocities have changed by, 2 (um - u)."""
    n, z = rows(L.Nodes, run.nodes, 0), rows(L.Zones, run.zones, 0)
    for k in range(run.open_edges.shape[0]):
        edge, memory = run.open_edges[k], run.ends[k]
        a, b = edge[L.OPEN_A], edge[L.OPEN_B]
        nx, ny, _ = normal_of(n, edge, kind, near)
        faster = nx * (n.um[a] - n.u[a] + n.um[b] - n.u[b]) + ny * (n.vm[a] - n.v[a] + n.vm[b] - n.v[b])
        radius, spreading = 0.5 * (n.x[a] + n.x[b]), 0.0
        if kind != PLANAR and nx > 0.0 and radius > 0.0:
            spreading = 0.5 * nx * memory[one.IMPEDANCE] / (z.rho[edge[L.OPEN_ZONE]] * radius)
        answer_of(memory, faster, spreading, dt)


def tables(edges, ghosts, numbering) -> tuple:
    """Of `march.Run`: gate normals, transmitting edges, what they know now and at the start of the step, scratch."""
    beyond = {frozenset(row[[NODE_A, NODE_B]].tolist()): k for k, row in enumerate(ghosts)}
    for edge in edges.open_edges:
        ends_of = numbering.representative[numbering.nodes[edge[[L.OPEN_A, L.OPEN_B]]]]
        edge[L.OPEN_GHOST] = beyond.get(frozenset(ends_of.tolist()), -1)
    ends = np.zeros((len(edges.open_edges), COLUMNS))
    return np.zeros((len(edges.gates), 2)), edges.open_edges, ends, ends.copy(), np.zeros((3, one.REACH))


def begin(run, kind, near, problem) -> None:
    """Edges at t = 0: the stress of their zones holds outside."""
    n, z = L.Nodes(*run.nodes), L.Zones(*run.zones)
    for edge, memory in zip(run.open_edges, run.ends):
        nx, ny, _ = normal_of(n, edge, kind, near)
        look(z, edge, nx, ny, run.seen)
        count = edge[L.OPEN_COUNT]
        memory[:] = 0.0
        memory[one.ZONES] = count
        memory[one.OUTSIDE] = memory[one.AMBIENT] = run.seen[STRESS, 0]
        begin_memory(memory[:one.END_FLOATS], run.seen[STRESS, :count], run.seen[DENSITY, :count])
        zone = edge[L.OPEN_ZONE]
        material = problem.materials[problem.blocks[problem.mesh.block_of[zone]].material]
        await_echo(memory, material, z.rho[zone], z.e[zone], problem.stop_time)


def missing(problem, ends) -> dict[str, np.ndarray]:
    """Stress (n,), Pa, of the echo that material beyond each edge of a transmitting chain would have sent back so far, were waves plane."""
    found, first = {}, 0
    for name, boundary in problem.chain_boundaries().items():
        if boundary.kind == "transmitting":
            last = first + len(problem.mesh.chains[name].edges)
            found[name], first = ends[first:last, one.MISSING].copy(), last
    return found


def open_edge_table(mesh, numbering, chains: list[str], gates, loads) -> np.ndarray:
    """(edge; columns OPEN_* of `layout`) of the transmitting edges of the loads whose pulse is none.

    gates   (copy, chain, booked) of `boundaries`: copies of a node stand together
    """
    first: dict[tuple[int, int], tuple[int, int]] = {}
    for row, (copy, chain, _) in enumerate(gates.tolist()):
        node = int(numbering.nodes[copy])
        begin, count = first.get((node, chain), (row, 0))
        first[node, chain] = begin, count + 1
    found = []
    for a, b, zone, chain, pulse, outward in loads.tolist():
        if pulse >= 0:
            continue
        on = mesh.chains[chains[chain]]
        block = mesh.blocks[on.block]
        inward, count = {"left": (block.nj, block.ni), "right": (-block.nj, block.ni), "bottom": (1, block.nj),
                         "top": (-1, block.nj)}[on.side]
        gate = [first[int(numbering.nodes[node]), chain] for node in (a, b)]
        found.append((a, b, zone, inward, min(count, one.REACH), outward, *gate[0], *gate[1], -1))
    return np.array(found, dtype=np.int64).reshape(-1, L.OPEN_GHOST + 1)
