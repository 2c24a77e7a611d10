"""Viscosity, filters and corner forces of a piece of zones, and the power of these forces: lists of passes over its rows and corners."""

import numba as nb

from hugoniot.core.ops import vsqrt
from hugoniot.core.passes import call_pass, row, row_at, rows
from hugoniot.core.target import INLINE, SWEEP
from hugoniot.solvers.lagrange2d import geometry, hourglass, smoothness, tensor, viscosity
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.row_pass import spread
from hugoniot.zones import material

FORCES = L.Zones._fields.index("f0x")
COMING = L.Zones._fields.index("nxx")
AREA = L.SHAPE + L.Shape._fields.index("area")
WEIGHTS = L.SHAPE + L.Shape._fields.index("w0")
POWER = L.WORK + L.Work._fields.index("power")      # and, before the forces are known, rho c
LEFT, RIGHT, BOTTOM, TOP = range(4)


@nb.njit(**INLINE)
def middle(nodes, first):
    """A row of nodes in the middle of the step."""
    n = rows(L.Nodes, nodes, first)
    return L.Points(n.xh, n.yh, n.um, n.vm)


@nb.njit(**INLINE)
def now(nodes, first):
    """A row of nodes as it stands."""
    n = rows(L.Nodes, nodes, first)
    return L.Points(n.x, n.y, n.u, n.v)


@nb.njit(**INLINE)
def corner(k, stride):
    """Place of corner k in the rows of nodes."""
    return (0, stride, stride + 1, 1)[k]


# -- smoothness --------------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def mirrored(x, y, mirrors, side):
    """The difference of velocity across a zone beyond an edge of the mesh: its mirror image behind a wall, else the same once more."""
    nx, ny = mirrors[side, 0], mirrors[side, 1]
    if nx == 0.0 and ny == 0.0:
        return x, y
    along = 2.0 * (x * nx + y * ny)
    return along * nx - x, along * ny - y


@nb.njit(**INLINE)
def mirror_row(count, g, out, mirrors, side):
    """The same for a row of zones."""
    for j in range(count):
        out.x[j], out.y[j] = mirrored(g.x[j], g.y[j], mirrors, side)


@nb.njit(**SWEEP)
def look_beyond(n, beyond, edge, a, b, g, j, way):
    """The difference of velocity across the zone on the far side of an edge between the nodes a and b, if there is one, into g[j].

    way: 1 where the second or the first logical direction leads to that zone, -1 where it comes from there.
    """
    c, d = beyond[edge, 0], beyond[edge, 1]
    if c >= 0:
        ex, ey = n.x[c] + n.x[d] - n.x[a] - n.x[b], n.y[c] + n.y[d] - n.y[a] - n.y[b]
        inverse = way / vsqrt(ex * ex + ey * ey)
        g.x[j] = (n.u[c] + n.u[d] - n.u[a] - n.u[b]) * inverse
        g.y[j] = (n.v[c] + n.v[d] - n.v[a] - n.v[b]) * inverse


@nb.njit(**SWEEP)
def look_beyond_row(count, n, beyond, edge, first, g, way):
    """The same for a row of zones whose edges begin at the node `first`."""
    for j in range(count):
        look_beyond(n, beyond, edge + j, first + j, first + j + 1, g, j, way)


@nb.njit(**INLINE)
def look_around(passes, piece, r, nodes, scratch, mirrors, far):
    """Smoothness of the r-th row of zones of a piece, at the start of the step."""
    n = rows(L.Nodes, nodes, 0)
    stride, count, offset = piece[L.P_STRIDE], piece[L.P_COUNT], r * piece[L.P_COUNT]
    first, side = piece[L.P_NODE] + r * stride, 4 * piece[L.P_BLOCK]
    low, high = now(nodes, first), now(nodes, first + stride)
    smooth = spread(L.Smoothness, scratch[L.SMOOTH:], offset)
    none = smooth.xi
    wide, along, beyond = gradient(scratch, 0, 0), gradient(scratch, 0, 1), gradient(scratch, 0, 2)
    before, here, behind = gradient(scratch, 1, 0), gradient(scratch, 2, 0), gradient(scratch, 3, 0)
    start = 0 if piece[L.P_FIRST] else 1
    reach = count + start + (0 if piece[L.P_LAST] else 1)
    given = smoothness.GradientOf(now(nodes, first - start), now(nodes, first + stride - start), gradient(scratch, 0, 1 - start))
    call_pass(passes.gradient_along, reach, given, 0.0, none)
    if piece[L.P_FIRST]:
        wide.x[0], wide.y[0] = mirrored(along.x[0], along.y[0], mirrors, side + BOTTOM)
        look_beyond(n, far, piece[L.P_BOTTOM] + r, first, first + stride, wide, 0, -1.0)
    if piece[L.P_LAST]:
        wide.x[count + 1], wide.y[count + 1] = mirrored(wide.x[count], wide.y[count], mirrors, side + TOP)
        look_beyond(n, far, piece[L.P_TOP] + r, first + count, first + count + stride, wide, count + 1, 1.0)
    call_pass(passes.gradient_across, count, smoothness.GradientOf(low, high, here), 0.0, none)
    call_pass(passes.compare, count, smoothness.Compared(wide, along, beyond, here, smooth.xi), 0.0, none)
    if r == 0 and piece[L.P_FIRST_ROW]:
        mirror_row(count, here, before, mirrors, side + LEFT)
        look_beyond_row(count, n, far, piece[L.P_LEFT], first, before, -1.0)
    else:
        call_pass(passes.gradient_across, count, smoothness.GradientOf(now(nodes, first - stride), low, before), 0.0, none)
    if r == piece[L.P_ROWS] - 1 and piece[L.P_LAST_ROW]:
        mirror_row(count, here, behind, mirrors, side + RIGHT)
        look_beyond_row(count, n, far, piece[L.P_RIGHT], first + stride, behind, 1.0)
    else:
        call_pass(passes.gradient_across, count, smoothness.GradientOf(high, now(nodes, first + 2 * stride), behind), 0.0, none)
    call_pass(passes.compare, count, smoothness.Compared(before, here, behind, along, smooth.eta), 0.0, none)


@nb.njit(**INLINE)
def gradient(scratch, which, first):
    """Velocity differences: 0 along the row (from the zone before it), 1 across the row before, 2 across it, 3 across the one behind."""
    return spread(L.Vector, scratch[L.GRADIENTS + 2 * which:], first)


# -- viscosity ------------------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def speeds(count, at, recipe, closing, speed1, speed2):
    """Viscous speeds of both directions."""
    z, w = at.z, at.w
    material.viscous(count, recipe, w.v, z.c, w.p, closing.du1, closing.psi1, speed1)
    material.viscous(count, recipe, w.v, z.c, w.p, closing.du2, closing.psi2, speed2)


@nb.njit(**INLINE)
def corner_viscosity(passes, piece, nodes, scratch, at, solid, recipe, limited, mirrors, beyond):
    """Viscous stress of the four corners, and their mean."""
    z, total, count, stride = at.z, at.total, piece[L.P_COUNT], piece[L.P_STRIDE]
    speed1, speed2, numbers = row(scratch[L.SPEEDS], 0), row(scratch[L.SPEEDS + 1], 0), row_at(recipe.viscosity)
    for r in range(piece[L.P_ROWS]):
        first, offset = piece[L.P_NODE] + r * stride, r * count
        smooth = spread(L.Smoothness, scratch[L.SMOOTH:], offset)
        call_pass(passes.rates_now, count, smoothness.RatesNow(now(nodes, first), now(nodes, first + stride), smooth), 0.0, numbers)
        if limited:
            look_around(passes, piece, r, nodes, scratch, mirrors, beyond)
        else:
            material.clear(count, recipe, smooth.xi)
            material.clear(count, recipe, smooth.eta)
        edges = viscosity.MetricOf(middle(nodes, first), middle(nodes, first + stride), spread(L.Metric, scratch[L.METRIC:], offset))
        call_pass(passes.metric, count, edges, 0.0, numbers)
    m, smooth = spread(L.Metric, scratch[L.METRIC:], 0), spread(L.Smoothness, scratch[L.SMOOTH:], 0)
    c = spread(L.Closing, scratch[L.CLOSING:], 0)
    along = spread(L.Tensor, scratch[L.ALONG:], 0)
    call_pass(passes.closing_along, total, viscosity.AlongOf(at.rates, row(scratch[AREA], 0), m, smooth, c), 0.0, numbers)
    speeds(total, at, recipe, c, speed1, speed2)
    call_pass(passes.resist_along, total, viscosity.ResistAlongOf(solid, c, m, speed1, speed2, along, z.viscous_speed), 0.0, numbers)
    for k in range(4):
        for r in range(piece[L.P_ROWS]):
            first, offset = piece[L.P_NODE] + r * stride, r * count
            given_corner = viscosity.ClosingOf(
                middle(nodes, first + corner(k, stride)), middle(nodes, first + corner((k + 1) % 4, stride)),
                middle(nodes, first + corner((k + 3) % 4, stride)), row(scratch[AREA], offset),
                spread(L.Metric, scratch[L.METRIC:], offset), spread(L.Smoothness, scratch[L.SMOOTH:], offset),
                spread(L.Closing, scratch[L.CLOSING:], offset))
            call_pass(passes.closing, count, given_corner, 0.0, numbers)
        speeds(total, at, recipe, c, speed1, speed2)
        resisting = viscosity.ResistOf(solid, c, speed1, speed2, along, corner_stress(scratch, k, 0), z.viscous_speed)
        call_pass(passes.resist, total, resisting, 0.0, numbers)
    given = viscosity.MeanOf(at.shape, corner_stress(scratch, 0, 0), corner_stress(scratch, 1, 0), corner_stress(scratch, 2, 0),
                             corner_stress(scratch, 3, 0), at.coming)
    call_pass(passes.mean_viscosity, total, given, 0.0, numbers)
    if passes.hoop_viscosity != 0:
        call_pass(passes.hoop_viscosity, total, viscosity.HoopOf(at.rates, at.coming), 0.0, numbers)


@nb.njit(**INLINE)
def corner_stress(scratch, k, offset):
    """Viscous stress of corner k."""
    return spread(L.Tensor, scratch[L.CORNERS + 3 * k:], offset)


# -- forces ------------------------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def forces_in_middle(passes, piece, nodes, zones, scratch, at, filters):
    """Corner forces of stress, viscosity and filters in the middle of the step; filters: a row of merit factor and coefficient."""
    z, w, stride, count = at.z, at.w, piece[L.P_STRIDE], piece[L.P_COUNT]
    call_pass(passes.pushing_stress, at.total, tensor.StartOf(w.p, at.new, at.coming, at.stress), 0.0, filters)
    corners = spread(L.Corners, zones[FORCES:], piece[L.P_ZONE])
    call_pass(passes.stress_forces, at.total, geometry.ForcesOf(at.shape, at.stress, corners), 0.0, filters)
    call_pass(passes.subzonal, at.total, hourglass.SubzonalOf(at.shape, z.t0, z.t1, w.stiffness, extra(scratch, 0, 0), extra(
        scratch, 1, 0), extra(scratch, 2, 0), extra(scratch, 3, 0)), 0.0, filters)
    for r in range(piece[L.P_ROWS]):
        first, offset = piece[L.P_NODE] + r * stride, r * count
        zone = piece[L.P_ZONE] + offset
        s, part = spread(L.Shape, scratch[L.SHAPE:], offset), rows(L.Zones, zones, zone)
        low, high, f = middle(nodes, first), middle(nodes, first + stride), spread(L.Corners, zones[FORCES:], zone)
        if filters[0] > 0.0:
            call_pass(passes.subzonal_mean, count, hourglass.SubzonalMeanOf(low, high, s, extra(scratch, 0, offset), extra(
                scratch, 1, offset), extra(scratch, 2, offset), extra(scratch, 3, offset), f), 0.0, filters)
        if filters[1] > 0.0:
            call_pass(passes.viscous, count, hourglass.ViscousOf(low, high, s, row(scratch[POWER], offset), part.inverse_mass, f,
                                                                 part.filter_power), 0.0, filters)
        for k in range(4):
            after, before = (k + 1) % 4, (k + 3) % 4
            given = viscosity.CornerForcesOf(
                middle(nodes, first + corner(k, stride)), middle(nodes, first + corner(after, stride)),
                middle(nodes, first + corner(before, stride)), corner_stress(scratch, k, offset), spread(L.Stress, zones[COMING:], zone),
                extra(scratch, k, offset), weight(scratch, k, offset), weight(scratch, after, offset), weight(scratch, before, offset),
                corner_force(zones, k, zone), corner_force(zones, after, zone), corner_force(zones, before, zone))
            call_pass(passes.corner_forces, count, given, 0.0, filters)


@nb.njit(**INLINE)
def extra(scratch, k, offset):
    """Half the subzonal pressure of corner k."""
    return row(scratch[L.EXTRA + k], offset)


@nb.njit(**INLINE)
def weight(scratch, k, offset):
    """Weight of planar forces on corner k."""
    return row(scratch[WEIGHTS + k], offset)


@nb.njit(**INLINE)
def corner_force(zones, k, first):
    """Force rows of corner k."""
    return spread(L.Vector, zones[FORCES + 2 * k:], first)


@nb.njit(**INLINE)
def work_of_forces(passes, piece, nodes, zones, scratch):
    """Power that the corner forces put into the zones of a piece, with the mean velocities of the step."""
    for r in range(piece[L.P_ROWS]):
        first, offset = piece[L.P_NODE] + r * piece[L.P_STRIDE], r * piece[L.P_COUNT]
        found = row(scratch[POWER], offset)
        given = geometry.PowerOf(middle(nodes, first), middle(nodes, first + piece[L.P_STRIDE]),
                                 spread(L.Corners, zones[FORCES:], piece[L.P_ZONE] + offset), found)
        call_pass(passes.power, piece[L.P_COUNT], given, 0.0, found)
