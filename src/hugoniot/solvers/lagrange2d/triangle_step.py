"""The triangles of a material in a step, as lists of passes: both triangles of each cell together.

The physics of a zone is that of `zone_step`. In materials with strength the two triangles may share their pressure (`shared`): both then
have the density of their cell and the mean of their pressures, whose work is divided between them by mass, but keep their own deviators.
Separate triangles are too stiff in plastic flow, with as many volume constraints as nodes; a cell with one pressure has one constraint.
Marti & Cundall, Int. J. Numer. Anal. Methods Geomech. 6 (1982) 129.
"""

from typing import Any, NamedTuple

from hugoniot.core.pass_lists import Place
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import triangle_passes as passes
from hugoniot.solvers.lagrange2d import triangle_viscosity as viscosity
from hugoniot.solvers.lagrange2d.hoop_viscosity import HoopOf, hoop_viscosity
from hugoniot.solvers.lagrange2d.quads import AreaWeighted
from hugoniot.solvers.lagrange2d.shown import TraceOf, trace
from hugoniot.solvers.lagrange2d.zone_passes import SettleOf, ShapeOf, StandOf, StrainOf, StressOf, stand
from hugoniot.solvers.lagrange2d.zone_step import pressure_at_end, pressure_in_middle, stress_at_end, stress_in_middle
from hugoniot.zones.steps import MaterialSteps


def ahead(points: L.Points) -> L.Points:
    """A row of nodes from its next node on."""
    return L.Points(*(Place(row.address + 8, row.origin) for row in points))


class Triangles(NamedTuple):
    """Rows of the lower or the upper triangles of a row of cells.

    at      `plane_rows.PlaneRows`
    own     what triangles have besides
    third   scratch for the third corners
    upper   whether they are the upper ones
    """

    at: Any
    own: L.OfTriangles
    third: L.Points
    upper: bool

    def corners(self, low: L.Points, high: L.Points):
        """(a, b, across, beside): corners a and b and both that may be the third, from the rows of nodes on both sides of the cells."""
        four = low, high, ahead(high), ahead(low)
        return four[2:] + four[:2] if self.upper else four

    def thirds(self, low: L.Points, high: L.Points) -> passes.ThirdsOf:
        """Rows that gather the third corners."""
        _, _, across, beside = self.corners(low, high)
        return passes.ThirdsOf(across, beside, self.own.way, self.third)

    @property
    def mid(self) -> L.Vertices:
        """Corners in the middle of the step, once `thirds` are gathered from there."""
        a, b, _, _ = self.corners(*self.at.mid)
        return L.Vertices(a, b, self.third)

    @property
    def now(self) -> L.VerticesNow:
        """Places of the corners now, once `thirds` are gathered from there."""
        a, b, _, _ = self.corners(self.at.now_low, self.at.now_high)
        return places_of(L.Vertices(a, b, self.third))

    @property
    def f(self) -> L.VertexForces:
        """Corner forces."""
        return L.VertexForces(*self.at.f[:6])

    @property
    def rest(self) -> L.VertexForces:
        """Forces that no stress gives."""
        return L.VertexForces(*self.at.rest[:6])


def places_of(corners: L.Vertices) -> L.VerticesNow:
    """Corners without their velocities."""
    return L.VerticesNow(*(L.Positions(row.x, row.y) for row in corners))


def look_rows(lower: Triangles) -> passes.LookOf:
    """Rows of the pass that looks for tangled triangles, from those of the lower ones."""
    at = lower.at
    rows = at.now_low, at.now_high, *map(ahead, (at.now_low, at.now_high)), *at.mid, *map(ahead, at.mid)
    return passes.LookOf(*(L.Positions(row.x, row.y) for row in rows), lower.own.way, at.tangled)


class Cell:
    """Writes the passes of one material into the list `operations`, for both triangles of its cells.

    shared     whether they share their pressure
    numbers    the material's constants and those of `layout` behind them
    """

    def __init__(self, laws, pair: tuple[Triangles, Triangles], geometry, numbers, shared: bool):
        self.pair, self.geometry, self.numbers, self.shared = pair, geometry, numbers, shared
        self.steps = [MaterialSteps(laws, part.at, explicit=True) for part in pair]
        self.operations = self.steps[0].operations
        self.steps[1].operations = self.operations

    def do(self, of, rows, step=None) -> None:
        """Add a pass made for the geometry that takes the material's numbers."""
        self.steps[0].do(of, rows, step, kind=self.geometry, numbers=self.numbers)

    # -- the step ----------------------------------------------------------------------------------------------------------
    def predict(self, kind: str) -> None:
        """Write how stress and forces in the middle of the step are found; kind: of the viscosity."""
        for part, s in zip(self.pair, self.steps):
            at, z, w = part.at, part.at.z, part.at.w
            self.do(passes.gather_thirds, part.thirds(*at.mid))
            self.do(passes.strain, StrainOf(part.mid, z.inverse_mass, z.e, z.p, at.s, at.q, at.d, w.v, s.rho_half, w.e,
                                            at.tangled))
        if self.shared:
            self._share_work([part.at.z.p for part in self.pair], [part.at.w.e for part in self.pair], self.pair[0].at.half)
            self._share_density([s.rho_half for s in self.steps])
        solid = [pressure_in_middle(s) for s in self.steps]
        if self.shared:
            self._average(*(s.p_half for s in self.steps))
        for s, rho in zip(self.steps, solid):
            stress_in_middle(s, rho)
        self._keep_stress()
        for part, s, rho in zip(self.pair, self.steps, solid):
            self._resist(part, s, rho, kind)
            at = part.at
            self.do(passes.push, StressOf(places_of(part.mid), s.p_half, at.q, at.new, part.f))
            if kind == "edge":
                self.do(passes.add_rest, passes.RestOf(part.mid, part.rest, part.f))
            if s.laws.burns:
                s.keep_half()

    def _resist(self, part, s, solid, kind) -> None:
        """Write how the viscous stress in the middle of the step is found, from the density row `solid`."""
        at, z, w, law = part.at, part.at.z, part.at.w, s.laws.viscosity
        if kind == "herrmann":
            s.do(viscosity.resist_triangles_along_axes,
                 viscosity.AxesOf(part.mid, at.d, w.v, z.c, s.p_half, solid, at.q, z.viscous_speed), law=law)
            return
        state = at.d, self.pair[0].at.smooth, w.v, z.c, s.p_half, solid, L.Tensor(*at.q[:3])      # smoothness is the cell's
        if kind == "edge":
            rows = viscosity.EdgesOf(part.mid, part.own.way, *state, part.rest, z.viscous_speed, w.rate)
            s.do(viscosity.resist_triangle_edges, rows, law=law)
        else:
            rows = viscosity.TensorOf(part.mid, part.own.way, *state, z.viscous_speed, w.rate)
            s.do(viscosity.resist_triangles, rows, law=law)
        if isinstance(self.geometry, AreaWeighted):
            s.do(hoop_viscosity, HoopOf(at.d, w.rate, at.q, at.rest))

    def correct(self) -> None:
        """Write how the state at the end of the step is found."""
        for part in self.pair:
            at, z = part.at, part.at.z
            self.do(passes.gather_thirds, part.thirds(*at.mid))
            self.do(passes.settle, SettleOf(part.mid, part.f, z.inverse_mass, at.power, at.d, z.e,
                                            at.w.heat, at.q, at.found))
            self.steps[0].add_some(at.w.heat, z.viscous_work)
            self.do(trace, TraceOf(at.q, z.q))
        if isinstance(self.geometry, AreaWeighted):
            self._divide_work()
        if self.shared:
            self._share_work([part.own.p_half for part in self.pair], [part.at.z.e for part in self.pair], self.pair[0].at.whole)
        for part in self.pair:
            at = part.at
            self.do(passes.gather_thirds, part.thirds(at.now_low, at.now_high))
            self.do(passes.shape, ShapeOf(part.now, at.z.inverse_mass, at.w.v, at.z.rho, at.w.inverse_length))
        if self.shared:
            self._share_density([part.at.z.rho for part in self.pair])
        closed = [pressure_at_end(s) for s in self.steps]
        if self.shared:
            self._average(*(part.at.z.p for part in self.pair))
        for s, (rho, _) in zip(self.steps, closed):
            stress_at_end(s, rho)      # of the mean: the relief of voids is each triangle's own
        volumes = [solid_v for _, solid_v in closed]
        for part, s, solid_v in zip(self.pair, self.steps, volumes):
            at, z, w = part.at, part.at.z, part.at.w
            s.do(stand, StandOf(at.new, w.c2, s.shear, solid_v, z.viscous_speed, w.inverse_length, at.s, s.seen))
            s.pace(w.inverse_length)

    # -- area weighted -------------------------------------------------------------------------------------------------------
    def _keep_stress(self) -> None:
        """Keep what the division of the work of the forces needs at the end of the step."""
        for part, s in zip(self.pair, self.steps):
            own, at = part.own, part.at
            if self.shared or isinstance(self.geometry, AreaWeighted):
                s.copy(s.p_half, own.p_half)
            if isinstance(self.geometry, AreaWeighted):
                for row, kept in zip(at.new, (own.sxx, own.syy, own.sxy)):
                    s.copy(row, kept)

    def _divide_work(self) -> None:
        """Divide the work of the forces as the stresses of both triangles do it.

        Forces weighted with the radius of each node do the work of the pressure to second order in a cell, to first order only in a
        triangle: of two triangles beside the axis one would get half too much and the other nothing.
        """
        for part in self.pair:
            at, own, z = part.at, part.own, part.at.z
            self.do(passes.gather_thirds, part.thirds(*at.mid))
            self.do(passes.take_own_work, passes.OwnWorkOf(part.mid, part.f, at.d, own.p_half, L.Tensor(own.sxx, own.syy, own.sxy), at.q,
                                                           z.inverse_mass, z.e, at.w.pace))
        self.do(passes.give_back, passes.GiveBackOf(*self._masses(), *(part.at.w.pace for part in self.pair),
                                                    *(part.at.z.e for part in self.pair)))

    # -- what both share -----------------------------------------------------------------------------------------------------
    def _masses(self) -> list[Place]:
        return [part.at.z.inverse_mass for part in self.pair]

    def _average(self, one, other) -> None:
        """Write the mean by mass into both rows."""
        self.do(passes.average, passes.PairOf(*self._masses(), one, other))

    def _share_density(self, densities) -> None:
        """Write the specific volume and the density of the cell."""
        volumes = [part.at.w.v for part in self.pair]
        self._average(*volumes)
        for v, rho in zip(volumes, densities):
            self.do(passes.density, passes.DensityOf(v, rho))

    def _share_work(self, pressures, energies, step) -> None:
        """Divide the work of the pressure in a motion through the middle of the step."""
        corners = [places_of(part.mid) for part in self.pair]
        dilations = [part.at.d.dilation for part in self.pair]
        self.do(passes.share_work, passes.WorkOf(*corners, *self._masses(), *pressures, *dilations, *energies), step)
