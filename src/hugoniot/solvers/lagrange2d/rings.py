"""Rows that only the current step needs, kept in a few lines that stay in cache.

Corner forces, nodes in the middle of a step and velocity gradients of a band of rows overwrite those of an earlier band, which are
no longer needed: the line for a row of the mesh is stored at the front of the table. The lists of passes account for this by
their origins, and references to single nodes and cells by tables of positions. Results do not depend on it.
"""

import numpy as np

from hugoniot.solvers.lagrange2d.bands import END, rows_of_nodes
from hugoniot.solvers.lagrange2d.plane_rows import (
    AT_BEFORE,
    AT_GRADIENTS,
    AT_GRADIENTS_BEFORE,
    AT_GRADIENTS_BEHIND,
    AT_HIGH_HALF,
    AT_LOW,
    AT_LOW_HALF,
    AT_UPPER_BEFORE,
    AT_ZONES,
    BY_FORCES,
)
from hugoniot.solvers.lagrange2d.rows_of_blocks import WORD, cells, node_rows
from hugoniot.solvers.lagrange2d.smoothness import GHOST, OWN

IN_FLIGHT = END + 1      # rows before a band that its commands still need, and one to spare


def moved(first, lines: int, longest: int):
    """By how much each line of a table moves (bytes) where `lines` of them, of at most `longest` bytes, are needed at once; `first`: where
    they begin. 0 where the table is no longer than that."""
    if lines * longest > first[-1]:
        return np.zeros(len(first), dtype=np.int64)
    return np.arange(len(first)) % lines * longest - first


class Rings:
    """Where the lines of a run stand: of each row of nodes. Leads `run.middle` and `run.ghosts` on."""

    def __init__(self, mesh, numbering, run):
        of_nodes = node_rows(mesh, numbering)
        self._zones, self._nodes = (np.array([row[1 + at] for row in of_nodes]) for at in (AT_ZONES, AT_LOW))
        self._of_zones, self._of_nodes = np.diff(self._zones).max(initial=0), WORD * max(count for count, *_ in of_nodes)
        each = list(zip(cells(mesh), np.cumsum([0, *(block.ni + 2 for block in mesh.blocks)]), mesh.blocks))
        self._cells = WORD * np.concatenate([start + np.arange(b.ni + 2) * (b.nj + 2) for start, _, b in each])
        self._line = np.concatenate([first + np.arange(1, b.ni + 2) for _, first, b in each])      # of the cells behind each row of nodes
        self.longest = max(b.nj for b in mesh.blocks)      # zones of a row
        self._of_cells = WORD * (self.longest + 2)
        self._row_of_node, self._middle, self._ghosts, self._first_ghosts = rows_of_nodes(mesh), run.middle, run.ghosts, run.ghosts.copy()

    def _lines(self, height: int) -> int:
        """Lines of cells, those around the blocks among them, that bands of a height need at once."""
        rows = min(height + IN_FLIGHT, len(self._line))
        return int((self._line[rows - 1:] - self._line[:len(self._line) - rows + 1]).max()) + 3

    def move(self, height: int, row):
        """Have bands of a height keep what they need; (origin, bytes by which it moves) in the share of each row of the array `row`."""
        forces, nodes = moved(self._zones, height + IN_FLIGHT, self._of_zones), moved(self._nodes, height + IN_FLIGHT, self._of_nodes)
        lines, last = moved(self._cells, self._lines(height), self._of_cells), len(self._cells) - 1
        places = np.arange(len(self._row_of_node))
        self._middle[:len(places)] = places + nodes[self._row_of_node] // WORD
        for column in (GHOST, OWN):
            cell = self._first_ghosts[:, column]
            self._ghosts[:, column] = cell + lines[np.searchsorted(self._cells, WORD * cell, side="right") - 1] // WORD
        for of_zones, origin in BY_FORCES.items():
            yield origin, forces[row - (of_zones in (AT_BEFORE, AT_UPPER_BEFORE))]
        yield AT_LOW_HALF, nodes[row]
        yield AT_HIGH_HALF, nodes[np.minimum(row + 1, len(nodes) - 1)]
        for origin, way in ((AT_GRADIENTS, 0), (AT_GRADIENTS_BEFORE, -1), (AT_GRADIENTS_BEHIND, 1)):
            yield origin, lines[np.minimum(self._line[row] + way, last)]
