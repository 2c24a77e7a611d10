"""A step taken band by band: a band of rows of the mesh stays in cache while all commands of the step are applied to it.

Each command lags behind the previous one by the rows that it needs from it, so that the results are the same as if each command
had been carried out over the whole mesh, whatever the height of the bands. Special nodes, on which something besides their own zones acts,
are handled with their rows; their data are sorted by rows. Where something connects rows that are
not neighbours (nodes shared by blocks, contact, transmitting edges), the whole mesh is one band.

Rows of the mesh are those of its nodes, block by block, each with the row of zones behind it.
"""

import numba as nb
import numpy as np

from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.commands import FROM, HEIGHT, TO

# rows of the table of what comes before each row; as those below numbers of arrays: a function is compiled anew for each plain one
LOADS, SPECIAL, HELD, AXIS, NODES, GHOSTS = np.arange(6)
FIRST = np.int64(0)      # row
# rows by which a step lags behind its drift to the middle: not at all, stress there, nodes held and moved, state at the end
NOW, STRESS, MOTION, END = np.arange(4)


def rows_of_nodes(mesh) -> np.ndarray:
    """Row of every node of the blocks."""
    heights = [block.ni + 1 for block in mesh.blocks]
    starts = np.cumsum([0, *heights])
    return np.concatenate([start + np.repeat(np.arange(block.ni + 1), block.nj + 1) for start, block in zip(starts, mesh.blocks)])


def in_rows(mesh, edges, axis, ratio):
    """Put what acts on nodes in the order of the last row it needs; (axis, ratio, before): how many of each come before a row.

    edges: `boundaries.Tables`, whose loads and held nodes are put in order too.
    """
    row = rows_of_nodes(mesh)
    loads, held = row[edges.loads[:, [L.LOAD_A, L.LOAD_B]]].max(axis=1, initial=0), row[edges.held[:, L.HOLD_NODE]]
    beside = row[axis].max(axis=1, initial=0)
    orders = [np.argsort(keys, kind="stable") for keys in (loads, held, beside)]
    edges.loads, edges.held, edges.held_normals = edges.loads[orders[0]], edges.held[orders[1]], edges.held_normals[orders[1]]
    keys = loads[orders[0]], row[edges.special], held[orders[1]], beside[orders[2]], row
    return axis[orders[2]], ratio[orders[2]], np.array([np.searchsorted(each, np.arange(row[-1] + 2)) for each in keys])


def local(run, erosion: bool) -> bool:
    """Whether nothing acts on rows that are not neighbours."""
    return not (erosion or run.touch or len(run.members) or len(run.gates))


@nb.njit(**BY_ADDRESS)
def between(before, which, last, top, lag, count):
    """(first, one after the last) of the `count` things of a kind in the rows that lag behind those from `last` to `top`."""
    rows = before.shape[1] - 1
    return before[which, max(last - lag, 0)], count if top == rows else before[which, max(top - lag, 0)]


@nb.njit(**BY_ADDRESS)
def take_rows(plan, last, top, lag):
    """Have the next commands take the rows that lag behind those from `last` to `top`; all that are left behind the last row."""
    rows = plan.before.shape[1] - 1
    plan.band[FROM], plan.band[TO] = max(last - lag, 0), rows if top == rows else max(top - lag, 0)


@nb.njit(**BY_ADDRESS)
def next_top(plan, top):
    """One after the last row of the band behind the row `top`."""
    return min(top + plan.band[HEIGHT], plan.before.shape[1] - 1)
