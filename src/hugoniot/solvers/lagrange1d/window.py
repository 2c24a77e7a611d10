"""A window of zones that follows a wave: it starts with given states and moves on over material like that ahead.

For one planar region of equal zones with the compatible integrator, whose right end moves with the material ahead of it.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import B, H, Z
from hugoniot.solvers.lagrange1d.solver import Lagrange1D
from hugoniot.solvers.lagrange1d.start import plan_first_step, renew_gradients
from hugoniot.solvers.lagrange1d.transmitting import remember

OF_ZONES = {"energy": (Z.e,), "pressure": (Z.p, Z.sigma), "sound_speed": (Z.c,)}
OF_CHARGE = {"burn_fraction": B.lam, "reactant_density": B.rho_r, "reactant_energy": B.e_r, "product_density": B.rho_p,
             "product_energy": B.e_p}


class Window:
    """The zones of a solver that has not begun, as a window; what they hold now is what lies ahead of it for good.

    Raises `OutOfRange` for a run of several regions, in curved geometry, of graded zones or with another integrator.
    """

    def __init__(self, solver: Lagrange1D):
        problem = solver.problem
        region = problem.regions[0]
        if len(problem.regions) > 1 or problem.dimension > 1 or region.ratio != 1.0 or solver.staggered:
            raise OutOfRange("a moving window needs one planar region of equal zones and integrator \"compatible\"")
        self.solver, self.size = solver, (region.end - region.start) / region.zones
        self._behind = 0.0
        self.mass = float(solver.zones[Z.mass, 0])
        self._zone, self._charge, self._node = solver.zones[:, -1].copy(), solver.charge[:, -1:].copy(), solver.nodes[:, 1].copy()

    def lay_out(self, position, velocity, fields: dict[str, np.ndarray], behind: float) -> None:
        """Start from given states.

        position, velocity   of every node, m and m/s
        fields               of the first zones, the others staying as they are: names of `OF_ZONES` and `OF_CHARGE` -> values;
                             densities follow from masses
        behind               the pressure that a transmitting left end holds against, Pa
        """
        solver = self.solver
        zones, nodes = solver.zones, solver.nodes
        nodes[H.r], nodes[H.u] = position, velocity
        zones[Z.rho] = zones[Z.mass] / np.diff(nodes[H.r])
        for name, values in fields.items():
            for row in OF_ZONES.get(name, ()):
                zones[row, :len(values)] = values
            if name in OF_CHARGE:
                solver.charge[OF_CHARGE[name], :len(values)] = values
        self._behind = behind
        self._hold()
        plan_first_step(solver)

    def move_on(self, count: int) -> None:
        """Drop `count` zones at the left end and lay as many, as they were at the start, at the right."""
        zones, nodes = self.solver.zones, self.solver.nodes
        for table, column in ((zones, self._zone[:, None]), (self.solver.charge, self._charge), (nodes, self._node[:, None])):
            if table.shape[1]:
                table[:, :-count] = table[:, count:].copy()
                table[:, -count:] = column
        nodes[H.r, -count:] = nodes[H.r, -count - 1] + self.size * np.arange(1, count + 1)
        nodes[H.u, -count - 1:] = self._node[H.u]
        whole = self._node[H.mass]
        nodes[H.mass], nodes[H.inverse_mass] = whole, 1.0 / whole
        for end in (0, -1):
            nodes[H.mass, end], nodes[H.inverse_mass, end] = 0.5 * whole, 2.0 / whole
        self._hold()
        renew_gradients(self.solver)

    def _hold(self) -> None:
        """Let the left end hold against the state behind, which is at rest: p - rho c u of a wave that runs out there."""
        zones, control = self.solver.zones, self.solver.control
        control[L.END_LEFT + L.OUTSIDE] = self._behind - zones[Z.rho, 0] * zones[Z.c, 0] * self.solver.nodes[H.u, 0]
        remember(control, zones)
