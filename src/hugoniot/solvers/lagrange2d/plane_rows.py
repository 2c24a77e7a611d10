"""Locations of the rows that the lists of passes use: rows of zones and of nodes of a block, scratch, and results of the passes."""

from typing import Any, NamedTuple

import numpy as np

from hugoniot.core.pass_lists import FIXED, Place, place, places
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import node_step, triangle_step

# origins: a row of zones and the one before it, the rows of nodes on both its sides, its gradients and those of the rows beside it
# and, of triangles, the upper ones of the rows of cells whose lower ones are the zones; where the forces of each row of zones are, and
# the rows of nodes in the middle of the step (`rings`)
(AT_ZONES, AT_BEFORE, AT_LOW, AT_HIGH, AT_GRADIENTS, AT_GRADIENTS_BEFORE, AT_GRADIENTS_BEHIND, AT_UPPER, AT_UPPER_BEFORE,
 AT_FORCES, AT_FORCES_BEFORE, AT_UPPER_FORCES, AT_UPPER_FORCES_BEFORE, AT_LOW_HALF, AT_HIGH_HALF, ORIGINS) = range(1, 17)
OF_ZONES = (AT_ZONES, AT_BEFORE, AT_UPPER, AT_UPPER_BEFORE)
OF_FORCES = (AT_FORCES, AT_FORCES_BEFORE, AT_UPPER_FORCES, AT_UPPER_FORCES_BEFORE)
BY_FORCES = dict(zip(OF_ZONES, OF_FORCES))
DT, DT_HALF, DT_BACK, AHEAD = range(4)                        # of the row of time steps
BOTH, BEHIND_ONLY, BEFORE_ONLY = range(3)                     # rows of zones beside a row of nodes


class PlaneRows(NamedTuple):
    """Rows of a row of zones: those of `zones.steps.MaterialSteps`, its nodes now and in the middle of the step, and its own."""

    z: Any
    b: Any
    w: Any
    now_low: Any
    now_high: Any
    mid_low: Any
    mid_high: Any
    s: Any               # deviators of the state
    q: Any               # mean viscous stress: of the step before, then of the step
    f: Any               # corner forces
    power: Place         # W/kg that the viscous filter takes in the middle of the step
    d: Any               # strain rates
    new: Any             # deviators found
    smooth: Any
    rest: Any            # forces of what the corners' viscous stress has beyond the mean
    everywhere: Place    # ones: all stretches, for viscosities that pass over none
    found: Place
    tangled: Place
    whole: Place
    half: Place

    @property
    def mid(self):
        """Corners in the middle of the step."""
        return L.Sides(self.mid_low, self.mid_high)

    @property
    def now(self):
        """Corners now."""
        return L.SidesNow(L.Positions(self.now_low.x, self.now_low.y), L.Positions(self.now_high.x, self.now_high.y))


class RowsOfRun:
    """Places of the rows of a run.

    tables     zones, forces, charge, nodes, gradients, further fields of triangles (None: of quadrilaterals), which stay where they are
    threads    members of the team, each with scratch of its own, for both triangles of a cell
    longest    most zones of a row
    """

    def __init__(self, tables, threads: int, longest: int):
        self.zones, self.forces, self.charge, self.nodes, self.gradients, self.own = tables
        self.threads, self.dts, self.seen = threads, np.zeros(4), np.zeros((threads, L.FOUND_COLUMNS))
        self.scratch = zone_table(L.SCRATCH_ROWS, threads * L.PIECE * (1 if self.own is None else 2))
        self._nothing, self._everywhere = np.zeros(longest + 2), np.ones(L.PIECE)

    def rows(self, member: int, room: int, origin: int = AT_ZONES) -> PlaneRows:
        """Rows of a member, with the scratch number `room`."""
        z, forces = places(L.Zones, self.zones, origin), places(L.Forces, self.forces, BY_FORCES[origin])
        low, high, low_half, high_half = (places(L.Nodes, self.nodes, at) for at in (AT_LOW, AT_HIGH, AT_LOW_HALF, AT_HIGH_HALF))

        def scratch(cls, first):
            return places(cls, self.scratch[first:], FIXED, room * L.PIECE)

        return PlaneRows(
            z, places(L.Charge, self.charge, origin), scratch(L.Work, 0),
            L.Points(low.x, low.y, low.u, low.v), L.Points(high.x, high.y, high.u, high.v),
            L.Points(low_half.xh, low_half.yh, low_half.um, low_half.vm),
            L.Points(high_half.xh, high_half.yh, high_half.um, high_half.vm),
            L.Tensor(z.sxx, z.syy, z.sxy), L.Stress(z.qxx, z.qyy, z.qxy, z.qhoop),
            L.Corners(*forces[:len(L.Corners._fields)]), forces.filter_power, scratch(L.Rates, L.RATES), scratch(L.Tensor, L.NEW),
            scratch(L.Smoothness, L.SMOOTH), scratch(L.Corners, L.REST), place(self._everywhere),
            place(self.seen[member]),
            place(self.seen[member, L.FOUND_TANGLED:]), place(self.dts[DT:]), place(self.dts[DT_HALF:]))

    def pair(self, member: int):
        """Rows of the lower and the upper triangles of a row of cells."""
        def triangles(upper):
            origin, room = AT_UPPER if upper else AT_ZONES, member + upper * self.threads
            third = places(L.Points, self.scratch[L.THIRD:], FIXED, room * L.PIECE)
            return triangle_step.Triangles(self.rows(member, room, origin), places(L.OfTriangles, self.own, origin), third, upper)

        return triangles(False), triangles(True)

    def beside(self, which: int):
        """Corner forces of the rows of zones behind and before a row of nodes."""
        none = L.Vector(place(self._nothing), place(self._nothing))
        f, g = (places(L.Forces, self.forces, origin) for origin in (AT_FORCES, AT_FORCES_BEFORE))
        if self.own is not None:
            behind = before = node_step.OfPairs(none, none, none, none, *none)
            if which != BEFORE_ONLY:
                upper, own = places(L.Forces, self.forces, AT_UPPER_FORCES), places(L.OfTriangles, self.own, AT_ZONES)
                behind = node_step.OfPairs(L.Vector(f.f0x, f.f0y), L.Vector(upper.f1x, upper.f1y), L.Vector(f.f2x, f.f2y),
                                           L.Vector(upper.f2x, upper.f2y), own.way, own.back)
            if which != BEHIND_ONLY:
                upper, own = places(L.Forces, self.forces, AT_UPPER_FORCES_BEFORE), places(L.OfTriangles, self.own, AT_BEFORE)
                before = node_step.OfPairs(L.Vector(g.f1x, g.f1y), L.Vector(upper.f0x, upper.f0y), L.Vector(g.f2x, g.f2y),
                                           L.Vector(upper.f2x, upper.f2y), own.back, own.way)
            return behind, before
        behind, before = node_step.Behind(none, none), node_step.Before(none, none)
        if which != BEFORE_ONLY:
            behind = node_step.Behind(L.Vector(f.f0x, f.f0y), L.Vector(f.f3x, f.f3y))
        if which != BEHIND_ONLY:
            before = node_step.Before(L.Vector(g.f1x, g.f1y), L.Vector(g.f2x, g.f2y))
        return behind, before
