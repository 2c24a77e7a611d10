"""What a piece of zones does in a step: stress and forces in its middle, state and forces at its end, each a list of passes."""

from typing import NamedTuple

import numba as nb

from hugoniot.core.compile import INLINE, SWEEP
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import call_pass, row, row_at, rows, rows_apart
from hugoniot.solvers.lagrange1d import compatible, material
from hugoniot.solvers.lagrange2d import geometry, hourglass, smoothness, tensor, viscosity
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.zones.closure import PressureRows, StateRows, TemperatureRows
from hugoniot.zones.mixture import MixtureTemperatureRows
from hugoniot.zones.soundness import PeakRows, look_over, wave_speed
from hugoniot.zones.strength import ShearRows, YieldRows
from hugoniot.zones.viscosity import SpeedRows


class Passes(NamedTuple):
    """Addresses of the passes of one geometry."""

    shape: int
    rates: int
    stress_forces: int
    power: int
    rates_now: int
    gradient_along: int
    gradient_across: int
    compare: int
    metric: int
    closing: int
    resist: int
    closing_along: int
    resist_along: int
    mean_viscosity: int
    corner_forces: int
    subzonal: int
    subzonal_mean: int
    viscous: int
    stress_at_start: int
    stress_in_middle: int
    trial: int
    return_to_yield: int
    strain_rates: int
    no_deviators: int
    keep: int


def passes_of(kind: int) -> Passes:
    """The passes for a geometry (codes of `geometry`); compiled now unless they are on disk."""
    shape = (geometry.planar, geometry.true_volume, geometry.area_weighted)[kind]
    rates = geometry.area_rates if kind == geometry.AREA_WEIGHTED else geometry.mean_rates
    found = {"shape": shape, "rates": rates}
    for name in Passes._fields[2:]:
        module = next(m for m in (geometry, smoothness, viscosity, hourglass, tensor) if hasattr(m, name))
        found[name] = getattr(module, name)
    return Passes(**{name: chosen.address for name, chosen in found.items()})


# -- shape and rates of a piece ---------------------------------------------------------------------------------------------
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
def shape_in_middle(passes, near, piece, nodes, scratch):
    """Shape and strain rates of a piece in the middle of the step."""
    for r in range(piece[L.P_ROWS]):
        first, offset, count = piece[L.P_NODE] + r * piece[L.P_STRIDE], r * piece[L.P_COUNT], piece[L.P_COUNT]
        low, high = middle(nodes, first), middle(nodes, first + piece[L.P_STRIDE])
        s, d = rows(L.Shape, scratch[L.SHAPE:], offset), rows(L.Rates, scratch[L.RATES:], offset)
        call_pass(passes.shape, count, geometry.ShapeOf(low, high, s), 0.0, near)
        call_pass(passes.rates, count, geometry.RatesOf(low, high, s, d), 0.0, near)


# -- motion ---------------------------------------------------------------------------------------------------------------------
@nb.njit(**SWEEP)
def half_motion(count, z, w, s, d, t, dt):
    """Density and energy in the middle of the step, by the stress at its start; how many volumes are not positive."""
    rows_apart()
    half = 0.5 * dt
    bad = 0
    for j in range(count):
        power = t.xx[j] * d.xx[j] + t.yy[j] * d.yy[j] + 2.0 * t.xy[j] * d.xy[j] + t.hoop[j] * d.hoop[j]
        v = s.volume[j] * z.inverse_mass[j]
        w.v[j] = v
        w.rho[j] = 1.0 / v
        w.e[j] = z.e[j] + half * v * power
        bad += 0 if s.volume[j] > 0.0 else 1
    return bad


@nb.njit(**SWEEP)
def viscous_heat(count, z, w, d, dt, v):
    """Work of the mean viscous stress, J/kg."""
    rows_apart()
    for j in range(count):
        w.heat[j] = -dt * v[j] * (z.qxx[j] * d.xx[j] + z.qyy[j] * d.yy[j] + 2.0 * z.qxy[j] * d.xy[j])


@nb.njit(**SWEEP)
def end_motion(count, z, w, dt):
    """Energy at the end of the step, by the work of the corner forces; viscous work."""
    rows_apart()
    for j in range(count):
        z.e[j] += dt * z.inverse_mass[j] * w.power[j]
        z.viscous_work[j] += w.heat[j]


@nb.njit(**SWEEP)
def end_density(count, z, w, s):
    """Specific volume and density at the end of the step."""
    rows_apart()
    for j in range(count):
        v = s.volume[j] * z.inverse_mass[j]
        w.v[j] = v
        z.rho[j] = 1.0 / v


@nb.njit(**SWEEP)
def longest_edges(count, low, high, s, inverse):
    """Longest edge over area, 1/m: the inverse of the smallest altitude."""
    rows_apart()
    for j in range(count):
        ax, ay, bx, by = high.x[j] - low.x[j], high.y[j] - low.y[j], high.x[j + 1] - high.x[j], high.y[j + 1] - high.y[j]
        cx, cy = low.x[j + 1] - high.x[j + 1], low.y[j + 1] - high.y[j + 1]
        dx, dy = low.x[j] - low.x[j + 1], low.y[j] - low.y[j + 1]
        longest = fmax(fmax(ax * ax + ay * ay, bx * bx + by * by), fmax(cx * cx + cy * cy, dx * dx + dy * dy))
        inverse[j] = vsqrt(longest) / s.area[j]


@nb.njit(**SWEEP)
def end_speed(count, z, w, solid_v, constants):
    """Sound speed at the end of the step; the largest signal rate, 1/s."""
    rows_apart()
    fastest = 0.0
    for j in range(count):
        c = wave_speed(w.c2[j] + (4.0 / 3.0) * w.shear[j] * solid_v[j], constants.noise)
        fastest = fmax(fastest, (fmax(c, constants.front) + 2.0 * z.viscous_speed[j]) * w.inverse_length[j])
        z.c[j] = c
    return fastest


# -- material -----------------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def strengthen(passes, count, at, d, recipe, state, lam, dt):
    """Deviators at the end of a strain, with `limit` and `flow`; zero for a fluid.

    state: rows (rho of the solid, e, p, c2) whose modulus and yield count; lam: burn fractions, of burning material only.
    """
    z, b, w = at.z, at.b, at.w
    solid, e, p, c2 = state
    numbers = row_at(recipe.strength)
    if recipe.shear == 0:
        call_pass(passes.no_deviators, count, tensor.WorkOf(w), 0.0, numbers)
        return
    heat, rate = w.zero, w.zero
    if recipe.temperature != 0:
        heat = w.temperature
        if recipe.solve == 0:
            call_pass(recipe.temperature, count, TemperatureRows(solid, e, z.compaction, heat), dt, row_at(recipe.eos))
        else:
            call_pass(recipe.temperature, count, MixtureTemperatureRows(b.lam, z.p, b.rho_r, b.e_r, b.rho_p, b.e_p, heat), dt,
                      row_at(recipe.reactive))
    if recipe.needs_rate != 0:
        rate = w.rate
        call_pass(passes.strain_rates, count, tensor.RateOf(d, rate), dt, numbers)
    call_pass(recipe.shear, count, ShearRows(solid, p, heat, c2, w.shear), dt, numbers)
    if recipe.solve != 0:
        material.unburned_part(count, lam, w.shear)
    call_pass(passes.trial, count, tensor.TrialOf(z, w, d), dt, numbers)
    call_pass(recipe.yields, count, YieldRows(solid, p, heat, rate, w.shear, w.equivalent, z.plastic_strain, w.limit, w.flow), dt, numbers)
    if recipe.solve != 0:
        material.unburned_limit(count, lam, w)
    call_pass(passes.return_to_yield, count, tensor.WorkOf(w), dt, numbers)


@nb.njit(**INLINE)
def close_half(count, at, recipe, constants, d, solid, dt):
    """Burn fraction and mixture in the middle of the step, by the pressure at its start."""
    z, b, w = at.z, at.b, at.w
    material.burn(count, at, recipe, 0.5 * dt, z.rho, z.rho, z.p, z.q, b.lam_half)
    viscous_heat(count, z, w, d, 0.5 * dt, w.v)
    material.shock_was_passing(count, b.reference, w.drive)
    material.share_heat(count, recipe, constants, w.drive, w.heat, b.heat)
    material.mix(count, at, recipe, solid, w.e, b.lam_half, b.heat, w.p, b.status)
    if recipe.bulk_first != 0:
        material.mixture_slopes(count, at, recipe, solid, w.e, b.lam_half, w.p)


# -- viscosity and filters ----------------------------------------------------------------------------------------------------
@nb.njit(**SWEEP)
def set_stiffness(count, z, w):
    """rho c^2 and rho c of the zones, for the filters."""
    rows_apart()
    for j in range(count):
        w.stiffness[j] = w.rho[j] * z.c[j] * z.c[j]
        w.power[j] = w.rho[j] * z.c[j]


@nb.njit(**SWEEP)
def keep_mean(count, mean, z):
    """The mean viscous stress goes with the state."""
    rows_apart()
    for j in range(count):
        z.qxx[j] = mean.xx[j]
        z.qyy[j] = mean.yy[j]
        z.qxy[j] = mean.xy[j]
        z.q[j] = mean.xx[j] + mean.yy[j]


LEFT, RIGHT, BOTTOM, TOP = range(4)


@nb.njit(**INLINE)
def mirrored(x, y, mirrors, side):
    """The difference of velocity across a zone beyond the edge of a block: its mirror image behind a wall, else the same once more."""
    nx, ny = mirrors[side, 0], mirrors[side, 1]
    if nx == 0.0 and ny == 0.0:
        return x, y
    along = 2.0 * (x * nx + y * ny)
    return along * nx - x, along * ny - y


@nb.njit(**INLINE)
def mirror_row(count, g, out, mirrors, side):
    for j in range(count):
        out.x[j], out.y[j] = mirrored(g.x[j], g.y[j], mirrors, side)


@nb.njit(**INLINE)
def look_around(passes, piece, r, nodes, scratch, limited, mirrors):
    """Smoothness and strain rates at the start of the step, of the r-th row of zones of a piece."""
    stride, count, offset = piece[L.P_STRIDE], piece[L.P_COUNT], r * piece[L.P_COUNT]
    first = piece[L.P_NODE] + r * stride
    low, high = now(nodes, first), now(nodes, first + stride)
    smooth = rows(L.Smoothness, scratch[L.SMOOTH:], offset)
    none = smooth.xi
    call_pass(passes.rates_now, count, smoothness.RatesNow(low, high, smooth), 0.0, none)
    if not limited:
        material.fill(count, smooth.xi, 0.0)
        material.fill(count, smooth.eta, 0.0)
        return
    before, here, behind = (rows(L.Vector, scratch[L.GRADIENTS:], 1), rows(L.Vector, scratch[L.GRADIENTS + 2:], 1),
                            rows(L.Vector, scratch[L.GRADIENTS + 4:], 1))
    start = 0 if piece[L.P_FIRST] else 1
    reach = count + start + (0 if piece[L.P_LAST] else 1)
    g = rows(L.Vector, scratch[L.GRADIENTS + 2:], 1 - start)
    call_pass(passes.gradient_along, reach, smoothness.GradientOf(now(nodes, first - start), now(nodes, first + stride - start), g), 0.0, none)
    wide = rows(L.Vector, scratch[L.GRADIENTS + 2:], 0)
    if piece[L.P_FIRST]:
        wide.x[0], wide.y[0] = mirrored(wide.x[1], wide.y[1], mirrors, 4 * piece[L.P_BLOCK] + BOTTOM)
    if piece[L.P_LAST]:
        wide.x[count + 1], wide.y[count + 1] = mirrored(wide.x[count], wide.y[count], mirrors, 4 * piece[L.P_BLOCK] + TOP)
    call_pass(passes.compare, count, smoothness.Compared(wide, here, rows(L.Vector, scratch[L.GRADIENTS + 2:], 2), smooth.xi), 0.0, none)
    call_pass(passes.gradient_across, count, smoothness.GradientOf(low, high, here), 0.0, none)
    if r == 0 and piece[L.P_FIRST_ROW]:
        mirror_row(count, here, before, mirrors, 4 * piece[L.P_BLOCK] + LEFT)
    else:
        call_pass(passes.gradient_across, count, smoothness.GradientOf(now(nodes, first - stride), low, before), 0.0, none)
    if r == piece[L.P_ROWS] - 1 and piece[L.P_LAST_ROW]:
        mirror_row(count, here, behind, mirrors, 4 * piece[L.P_BLOCK] + RIGHT)
    else:
        call_pass(passes.gradient_across, count, smoothness.GradientOf(high, now(nodes, first + 2 * stride), behind), 0.0, none)
    call_pass(passes.compare, count, smoothness.Compared(before, here, behind, smooth.eta), 0.0, none)


@nb.njit(**INLINE)
def corner_offset(k, stride):
    """Place of corner k in the rows of nodes."""
    return (0, stride, stride + 1, 1)[k]


@nb.njit(**INLINE)
def corner_viscosity(passes, piece, nodes, scratch, at, solid, recipe, limiting):
    """Viscous stress of the four corners, and their mean."""
    z, w, total = at.z, at.w, piece[L.P_ROWS] * piece[L.P_COUNT]
    stride = piece[L.P_STRIDE]
    closing = rows(L.Closing, scratch[L.CLOSING:], 0)
    speed1, speed2 = row_of(scratch, L.SPEEDS, 0), row_of(scratch, L.SPEEDS + 1, 0)
    numbers = row_at(recipe.viscosity)
    for r in range(piece[L.P_ROWS]):
        first, offset = piece[L.P_NODE] + r * stride, r * piece[L.P_COUNT]
        look_around(passes, piece, r, nodes, scratch, limiting[0], limiting[1])
        metric = viscosity.MetricOf(middle(nodes, first), middle(nodes, first + stride), rows(L.Metric, scratch[L.METRIC:], offset))
        call_pass(passes.metric, piece[L.P_COUNT], metric, 0.0, numbers)
    m, along = rows(L.Metric, scratch[L.METRIC:], 0), rows(L.Tensor, scratch[L.ALONG:], 0)
    edges = viscosity.AlongOf(rows(L.Rates, scratch[L.RATES:], 0), m, rows(L.Smoothness, scratch[L.SMOOTH:], 0), closing)
    call_pass(passes.closing_along, total, edges, 0.0, numbers)
    call_pass(recipe.speed, total, SpeedRows(w.v, z.c, w.p, closing.du1, closing.psi1, speed1), 0.0, numbers)
    call_pass(recipe.speed, total, SpeedRows(w.v, z.c, w.p, closing.du2, closing.psi2, speed2), 0.0, numbers)
    call_pass(passes.resist_along, total, viscosity.ResistAlongOf(solid, closing, m, speed1, speed2, along, z.viscous_speed), 0.0, numbers)
    for k in range(4):
        for r in range(piece[L.P_ROWS]):
            first, offset = piece[L.P_NODE] + r * stride, r * piece[L.P_COUNT]
            corner = viscosity.ClosingOf(
                middle(nodes, first + corner_offset(k, stride)), middle(nodes, first + corner_offset((k + 1) % 4, stride)),
                middle(nodes, first + corner_offset((k + 3) % 4, stride)), rows(L.Metric, scratch[L.METRIC:], offset),
                rows(L.Smoothness, scratch[L.SMOOTH:], offset), rows(L.Closing, scratch[L.CLOSING:], offset))
            call_pass(passes.closing, piece[L.P_COUNT], corner, 0.0, numbers)
        call_pass(recipe.speed, total, SpeedRows(w.v, z.c, w.p, closing.du1, closing.psi1, speed1), 0.0, numbers)
        call_pass(recipe.speed, total, SpeedRows(w.v, z.c, w.p, closing.du2, closing.psi2, speed2), 0.0, numbers)
        resisted = viscosity.ResistOf(solid, closing, speed1, speed2, along, corner_stress(scratch, k), z.viscous_speed)
        call_pass(passes.resist, total, resisted, 0.0, numbers)
    mean = rows(L.Tensor, scratch[L.MEAN:], 0)
    corners = viscosity.MeanOf(rows(L.Shape, scratch[L.SHAPE:], 0), corner_stress(scratch, 0), corner_stress(scratch, 1),
                               corner_stress(scratch, 2), corner_stress(scratch, 3), mean)
    call_pass(passes.mean_viscosity, total, corners, 0.0, numbers)
    keep_mean(total, mean, z)


@nb.njit(**INLINE)
def row_of(scratch, which, offset):
    """One row of a thread's scratch table."""
    return row(scratch[which], offset)


@nb.njit(**INLINE)
def corner_stress(scratch, k):
    """Viscous stress of corner k."""
    return rows(L.Tensor, scratch[L.CORNERS + 3 * k:], 0)


@nb.njit(**INLINE)
def corner_row(zones, k, first):
    """Force rows of corner k."""
    return rows(L.Vector, zones[FORCES + 2 * k:], first)


FORCES = L.Zones._fields.index("f0x")


@nb.njit(**INLINE)
def forces_in_middle(passes, piece, nodes, zones, scratch, at, filters, dt):
    """Corner forces of stress, viscosity and filters in the middle of the step; filters: a row of merit factor and coefficient."""
    z, w, total, stride = at.z, at.w, piece[L.P_ROWS] * piece[L.P_COUNT], piece[L.P_STRIDE]
    t, s, mean = rows(L.Stress, scratch[L.STRESS:], 0), rows(L.Shape, scratch[L.SHAPE:], 0), rows(L.Tensor, scratch[L.MEAN:], 0)
    call_pass(passes.stress_in_middle, total, tensor.MiddleOf(w, mean, t), 0.0, filters)
    call_pass(passes.stress_forces, total, geometry.ForcesOf(s, t, rows(L.Corners, zones[FORCES:], piece[L.P_ZONE])), 0.0, filters)
    call_pass(passes.subzonal, total, hourglass.SubzonalOf(s, z.t0, z.t1, w.stiffness, row_of(scratch, L.EXTRA, 0), row_of(
        scratch, L.EXTRA + 1, 0), row_of(scratch, L.EXTRA + 2, 0), row_of(scratch, L.EXTRA + 3, 0)), 0.0, filters)
    for r in range(piece[L.P_ROWS]):
        first, offset, count = piece[L.P_NODE] + r * stride, r * piece[L.P_COUNT], piece[L.P_COUNT]
        zone = piece[L.P_ZONE] + offset
        s = rows(L.Shape, scratch[L.SHAPE:], offset)
        low, high, f = middle(nodes, first), middle(nodes, first + stride), rows(L.Corners, zones[FORCES:], zone)
        if filters[0] > 0.0:
            call_pass(passes.subzonal_mean, count, hourglass.SubzonalMeanOf(low, high, s, row_of(scratch, L.EXTRA, offset), row_of(
                scratch, L.EXTRA + 1, offset), row_of(scratch, L.EXTRA + 2, offset), row_of(scratch, L.EXTRA + 3, offset), f), 0.0, filters)
        if filters[1] > 0.0:
            part = rows(L.Zones, zones, zone)
            call_pass(passes.viscous, count, hourglass.ViscousOf(low, high, s, row_of(scratch, L.WORK + IMPEDANCE, offset), part.inverse_mass, f,
                                                                 part.filter_work), dt, filters)
        for k in range(4):
            after, before = (k + 1) % 4, (k + 3) % 4
            corner = viscosity.CornerForcesOf(
                middle(nodes, first + corner_offset(k, stride)), middle(nodes, first + corner_offset(after, stride)),
                middle(nodes, first + corner_offset(before, stride)), rows(L.Tensor, scratch[L.CORNERS + 3 * k:], offset),
                rows(L.Tensor, scratch[L.MEAN:], offset), row_of(scratch, L.EXTRA + k, offset),
                row_of(scratch, L.SHAPE + WEIGHTS + k, offset), row_of(scratch, L.SHAPE + WEIGHTS + after, offset),
                row_of(scratch, L.SHAPE + WEIGHTS + before, offset),
                corner_row(zones, k, zone), corner_row(zones, after, zone), corner_row(zones, before, zone))
            call_pass(passes.corner_forces, count, corner, 0.0, filters)


WEIGHTS = L.Shape._fields.index("w0")
IMPEDANCE = L.Work._fields.index("power")


# -- the two halves of a step ---------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def predict(piece, nodes, zones, charge, scratch, recipe, constants, dt, options):
    """Stress and forces in the middle of the step; how many volumes are not positive."""
    passes, near, limiting, filters = options
    total = piece[L.P_ROWS] * piece[L.P_COUNT]
    at = L.Plane(rows(L.Zones, zones, piece[L.P_ZONE]), charge_rows(charge, piece[L.P_ZONE]), rows(L.Work, scratch, 0))
    z, b, w = at.z, at.b, at.w
    s, d, t = rows(L.Shape, scratch[L.SHAPE:], 0), rows(L.Rates, scratch[L.RATES:], 0), rows(L.Stress, scratch[L.STRESS:], 0)
    shape_in_middle(passes, near, piece, nodes, scratch)
    call_pass(passes.stress_at_start, total, tensor.StartOf(z, t), dt, near)
    bad = half_motion(total, z, w, s, d, t, dt)
    solid = w.rho
    if recipe.relief != 0:
        material.solid_volume(total, at)
        solid = w.solid
    if recipe.solve == 0:
        call_pass(recipe.pressure, total, PressureRows(solid, w.e, z.compaction, w.p), dt, row_at(recipe.eos))
        material.stiffness(total, at, recipe, solid, w.e, w.p, dt)
    else:
        close_half(total, at, recipe, constants, d, solid, dt)
    strengthen(passes, total, at, d, recipe, (solid, w.e, w.p, w.c2), b.lam_half, 0.5 * dt)
    material.relieve(total, at, recipe, solid, dt)
    set_stiffness(total, z, w)
    corner_viscosity(passes, piece, nodes, scratch, at, solid, recipe, limiting)
    forces_in_middle(passes, piece, nodes, zones, scratch, at, filters, dt)
    if recipe.solve != 0:
        compatible.keep_half(total, at, recipe)
    return bad


@nb.njit(**INLINE)
def charge_rows(charge, first):
    """Rows of burning zones; where nothing burns, rows that nobody reads."""
    return rows(L.Charge, charge, first)


@nb.njit(**INLINE)
def work_of_forces(passes, piece, nodes, zones, scratch):
    """Power that the corner forces put into the zones of a piece, with the mean velocities of the step."""
    stride = piece[L.P_STRIDE]
    for r in range(piece[L.P_ROWS]):
        first, offset = piece[L.P_NODE] + r * stride, r * piece[L.P_COUNT]
        found = row_of(scratch, L.WORK + IMPEDANCE, offset)
        given = geometry.PowerOf(middle(nodes, first), middle(nodes, first + stride), rows(L.Corners, zones[FORCES:], piece[L.P_ZONE] + offset), found)
        call_pass(passes.power, piece[L.P_COUNT], given, 0.0, found)


@nb.njit(**INLINE)
def shape_at_end(passes, near, piece, nodes, scratch):
    """Shape of a piece and its smallest altitudes at the end of the step."""
    stride = piece[L.P_STRIDE]
    for r in range(piece[L.P_ROWS]):
        first, offset, count = piece[L.P_NODE] + r * stride, r * piece[L.P_COUNT], piece[L.P_COUNT]
        low, high, s = now(nodes, first), now(nodes, first + stride), rows(L.Shape, scratch[L.SHAPE:], offset)
        call_pass(passes.shape, count, geometry.ShapeOf(low, high, s), 0.0, near)
        longest_edges(count, low, high, s, rows(L.Work, scratch, offset).inverse_length)


@nb.njit(**INLINE)
def push(passes, piece, zones, scratch, z):
    """Corner forces of the state as it stands, which push at the start of the next step."""
    total = piece[L.P_ROWS] * piece[L.P_COUNT]
    t = rows(L.Stress, scratch[L.STRESS:], 0)
    call_pass(passes.stress_at_start, total, tensor.StartOf(z, t), 0.0, z.mass)
    f = rows(L.Corners, zones[FORCES:], piece[L.P_ZONE])
    call_pass(passes.stress_forces, total, geometry.ForcesOf(rows(L.Shape, scratch[L.SHAPE:], 0), t, f), 0.0, z.mass)


@nb.njit(**INLINE)
def correct(piece, nodes, zones, charge, scratch, recipe, constants, dt, options):
    """State at the end of the step, and its forces: (largest signal rate, failure ratio, capped zones, unsound zones)."""
    passes, near, _, _ = options
    total = piece[L.P_ROWS] * piece[L.P_COUNT]
    at = L.Plane(rows(L.Zones, zones, piece[L.P_ZONE]), charge_rows(charge, piece[L.P_ZONE]), rows(L.Work, scratch, 0))
    z, b, w = at.z, at.b, at.w
    s, d = rows(L.Shape, scratch[L.SHAPE:], 0), rows(L.Rates, scratch[L.RATES:], 0)
    shape_in_middle(passes, near, piece, nodes, scratch)
    work_of_forces(passes, piece, nodes, zones, scratch)
    end_density(total, z, w, s)
    viscous_heat(total, z, w, d, dt, w.v)
    end_motion(total, z, w, dt)
    shape_at_end(passes, near, piece, nodes, scratch)
    end_density(total, z, w, s)
    solid, solid_v = z.rho, w.v
    if recipe.relief != 0:
        material.solid_volume(total, at)
        solid, solid_v = w.solid, w.solid_v
    if recipe.solve == 0:
        call_pass(recipe.state, total, StateRows(solid, z.e, z.compaction, z.p, w.c2), dt, row_at(recipe.eos))
    else:
        compatible.close_end(total, at, recipe, constants, solid, dt)
    strengthen(passes, total, at, d, recipe, (solid, z.e, z.p, w.c2), b.lam, dt)
    capped = material.tear(total, at, recipe, constants, solid, dt)
    if recipe.shear != 0:
        material.harden(total, at, w.v)
    call_pass(passes.keep, total, tensor.KeepOf(z, w), 0.0, near)
    rate = end_speed(total, z, w, solid_v, constants)
    if recipe.solve != 0:
        material.rates(total, at, recipe, z.q)
        rate = max(rate, burning_pace(total, at, constants))
    failure = material.worst(total, z.failure) if recipe.fracture != 0 else 0.0
    bad = look_over(total, PeakRows(z.rho, z.c, z.sigma, z.p, z.peak_stress, z.peak_tension, z.peak_pressure, z.peak_density))
    push(passes, piece, zones, scratch, z)
    return rate, failure, capped, bad


@nb.njit(**SWEEP)
def burning_pace(count, at, constants):
    """Largest signal rate of burning, 1/s; notes how well it is resolved, and marks zones whose mixture was not found."""
    rows_apart()
    z, b, w = at.z, at.b, at.w
    quickest = 0.0
    for j in range(count):
        quickest = fmax(quickest, constants.per_rate * w.pace[j])
        if b.lam[j] > material.IGNITED and w.pace[j] > 0.0:
            b.resolution[j] = fmin(b.resolution[j], z.c[j] * w.inverse_length[j] / w.pace[j])
        z.c[j] = z.c[j] if b.status[j] == 0.0 else -1.0
    return quickest
