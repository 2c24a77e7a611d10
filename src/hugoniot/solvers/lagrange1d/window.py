"""A window of zones that follows what runs through it: laid out with given states, and moved on over material like that ahead.

For one planar region of like zones with the compatible integrator, whose right end moves with the material ahead of it.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.solver import Lagrange1D

ROWS = {"energy": (L.E,), "pressure": (L.P, L.SIGMA, L.SIGMA_HALF), "sound_speed": (L.C,), "burn_fraction": (L.BURN_FRACTION,),
        "reactant_density": (L.RHO_R,), "reactant_energy": (L.E_R,), "product_density": (L.RHO_P,), "product_energy": (L.E_P,)}


class Window:
    """The zones of a solver that has not begun, as a window; what they hold now is what lies ahead of it for good.

    Raises `OutOfRange` for a run of several regions, in curved geometry, of graded zones or with another integrator.
    """

    def __init__(self, solver: Lagrange1D):
        problem = solver.problem
        region = problem.regions[0]
        if len(problem.regions) > 1 or problem.dimension > 1 or region.ratio != 1.0 or solver.staggered:
            raise OutOfRange("a window moves over one planar region of equal zones with integrator \"compatible\"")
        self.solver, self.size = solver, (region.end - region.start) / region.zones
        self.mass = float(solver.zones[L.MASS, 0])
        self._zone, self._node = solver.zones[:, -1].copy(), solver.nodes[:, 1].copy()

    def lay_out(self, position, velocity, fields: dict[str, np.ndarray], behind: float) -> None:
        """Start from given states.

        position, velocity   of every node, m and m/s
        fields               of the first zones, the others staying as they are: names of `ROWS` -> values; densities follow from masses
        behind               the pressure that a transmitting left end holds against, Pa
        """
        solver = self.solver
        zones, nodes = solver.zones, solver.nodes
        nodes[L.R], nodes[L.U] = position, velocity
        zones[L.RHO] = zones[L.MASS] / np.diff(nodes[L.R])
        for name, values in fields.items():
            for row in ROWS[name]:
                zones[row, :len(values)] = values
        solver.control[L.REFERENCE_LEFT] = behind
        solver.plan_first_step()

    def move_on(self, count: int) -> None:
        """Drop `count` zones at the left end and lay as many, as they were at the start, at the right."""
        zones, nodes = self.solver.zones, self.solver.nodes
        for table, column in ((zones, self._zone), (nodes, self._node)):
            table[:, :-count] = table[:, count:].copy()
            table[:, -count:] = column[:, None]
        nodes[L.R, -count:] = nodes[L.R, -count - 1] + self.size * np.arange(1, count + 1)
        nodes[L.U, -count - 1:] = self._node[L.U]
        whole = self._node[L.NODE_MASS]
        nodes[L.NODE_MASS], nodes[L.INVERSE_NODE_MASS] = whole, 1.0 / whole
        for end in (0, -1):
            nodes[L.NODE_MASS, end], nodes[L.INVERSE_NODE_MASS, end] = 0.5 * whole, 2.0 / whole
        self.solver.renew_gradients()
