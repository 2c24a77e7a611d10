"""What a piece of zones does in a step: stress and forces in its middle, state and forces at its end, each a list of passes."""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.passes import call_pass, row, row_at, rows
from hugoniot.core.target import INLINE
from hugoniot.solvers.lagrange2d import forces, geometry, smoothness, tensor, viscosity, zone_passes
from hugoniot.solvers.lagrange2d import hourglass as filters
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.row_pass import spread
from hugoniot.zones import material
from hugoniot.zones.closure import PressureRows, StateRows


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
    hoop_viscosity: int      # 0 but in area-weighted geometry
    corner_forces: int
    subzonal: int
    subzonal_mean: int
    viscous: int
    pushing_stress: int
    trial: int
    return_to_yield: int
    strain_rates: int
    keep: int
    half_motion: int
    viscous_heat: int
    end_energy: int
    density: int
    altitudes: int
    end_speed: int
    stiffnesses: int
    keep_viscosity: int


def passes_of(kind: int) -> Passes:
    """The passes for a geometry (codes of `geometry`); compiled now unless they are on disk."""
    shape = (geometry.planar, geometry.true_volume, geometry.area_weighted)[kind]
    rates = geometry.area_rates if kind == geometry.AREA_WEIGHTED else geometry.mean_rates
    found = {"shape": shape, "rates": rates}
    for name in Passes._fields[2:]:
        found[name] = next(getattr(m, name) for m in (geometry, smoothness, viscosity, filters, tensor, zone_passes) if hasattr(m, name))
    addresses = {name: chosen.address for name, chosen in found.items() if name != "hoop_viscosity" or kind == geometry.AREA_WEIGHTED}
    return Passes(**{"hoop_viscosity": 0} | addresses)


class Rows(NamedTuple):
    """What the passes of a piece work on: zones, charge and scratch under the names of `zones.material`, and the solver's own rows."""

    z: Any
    b: Any
    w: Any
    deviators: Any       # of the state
    viscous: Any         # mean viscous stress of the state
    coming: Any          # the same of the step that is being taken
    new: Any             # deviators found
    shape: Any
    rates: Any
    stress: Any
    total: Any           # zones of the piece


@nb.njit(**INLINE)
def rows_of(a, piece, scratch):
    """`Rows` of a piece; a: march.Run."""
    first = piece[L.P_ZONE]
    return Rows(rows(L.Zones, a.zones, first), rows(L.Charge, a.charge, first), rows(L.Work, scratch, 0),
                spread(L.Tensor, a.zones[SXX:], first), spread(L.Stress, a.zones[QXX:], first), spread(L.Stress, a.zones[NXX:], first),
                spread(L.Tensor, scratch[TXX:], 0), spread(L.Shape, scratch[L.SHAPE:], 0), spread(L.Rates, scratch[L.RATES:], 0),
                spread(L.Stress, scratch[L.STRESS:], 0), piece[L.P_ROWS] * piece[L.P_COUNT])


SXX, QXX, NXX = (L.Zones._fields.index(name) for name in ("sxx", "qxx", "nxx"))
TXX = L.WORK + L.Work._fields.index("txx")


# -- shape and rates of a piece ---------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def shape_in_middle(passes, near, piece, nodes, scratch):
    """Shape and strain rates of a piece in the middle of the step."""
    for r in range(piece[L.P_ROWS]):
        first, offset, count = piece[L.P_NODE] + r * piece[L.P_STRIDE], r * piece[L.P_COUNT], piece[L.P_COUNT]
        low, high = forces.middle(nodes, first), forces.middle(nodes, first + piece[L.P_STRIDE])
        s, d = spread(L.Shape, scratch[L.SHAPE:], offset), spread(L.Rates, scratch[L.RATES:], offset)
        call_pass(passes.shape, count, geometry.ShapeOf(low, high, s), 0.0, near)
        call_pass(passes.rates, count, geometry.RatesOf(low, high, s, d), 0.0, near)


@nb.njit(**INLINE)
def shape_at_end(passes, near, piece, nodes, scratch):
    """Shape of a piece and its smallest altitudes at the end of the step."""
    for r in range(piece[L.P_ROWS]):
        first, offset, count = piece[L.P_NODE] + r * piece[L.P_STRIDE], r * piece[L.P_COUNT], piece[L.P_COUNT]
        low, high = forces.now(nodes, first), forces.now(nodes, first + piece[L.P_STRIDE])
        s, w = spread(L.Shape, scratch[L.SHAPE:], offset), rows(L.Work, scratch, offset)
        call_pass(passes.shape, count, geometry.ShapeOf(low, high, s), 0.0, near)
        call_pass(passes.altitudes, count, zone_passes.AltitudeOf(low, high, s.area, w.inverse_length), 0.0, near)


# -- material -----------------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def deviators(passes, at, recipe, solid, e, p, lam, dt):
    """Deviators at the end of a strain, with `limit` and `flow`; zero for a fluid.

    e, p, lam   rows of the state whose modulus and yield count (lam: of burning material only); its c^2 is w.c2
    """
    w, count = at.w, at.total
    if recipe.shear == 0:
        for found in (w.txx, w.tyy, w.txy, w.t1, w.shear):
            material.clear(count, recipe, found)
        return
    if recipe.needs_rate != 0:
        call_pass(passes.strain_rates, count, tensor.RateOf(at.rates, w.rate), dt, w.rate)
    material.moduli(count, at, recipe, solid, e, p, lam)
    call_pass(passes.trial, count, tensor.TrialOf(at.deviators, w.shear, at.rates, at.new, w.equivalent), dt, w.t1)
    material.flow(count, at, recipe, solid, p, lam)
    call_pass(passes.return_to_yield, count, tensor.ReturnOf(w.equivalent, w.limit, at.new, w.t1), dt, w.t1)


@nb.njit(**INLINE)
def close_half(passes, at, recipe, constants, solid, dt):
    """Burn fraction and mixture in the middle of the step, by the pressure at its start."""
    z, b, w, count = at.z, at.b, at.w, at.total
    material.burn(count, at, recipe, 0.5 * dt, z.rho, z.rho, z.p, z.q, b.lam_half)
    call_pass(passes.viscous_heat, count, zone_passes.HeatOf(w.v, at.viscous, at.rates, w.heat), 0.5 * dt, constants)
    material.share_old_heat(count, at, recipe, constants, w.heat)
    material.mix(count, at, recipe, solid, w.e, b.lam_half, b.heat, w.p, b.status)
    if recipe.bulk_first != 0:
        material.mixture_slopes(count, at, recipe, solid, w.e, b.lam_half, w.p)


@nb.njit(**INLINE)
def keep_half(count, at, recipe):
    """Keep density and pressure of the middle of the step, and twice the plastic heat of its first half: that of the whole."""
    b, w = at.b, at.w
    material.copy(count, recipe, w.rho, b.rho_half)
    material.copy(count, recipe, w.p, b.p_half)
    material.clear(count, recipe, b.heat)
    material.add_plastic_heat(count, at, recipe, w.v, b.heat)
    material.add_plastic_heat(count, at, recipe, w.v, b.heat)


@nb.njit(**INLINE)
def close_end(count, at, recipe, constants, solid, dt):
    """Burn fraction and mixture at the end of the step, by the pressure in its middle; what burns at once, by that at its start."""
    z, b, w = at.z, at.b, at.w
    drive = z.p if recipe.instant != 0 else b.p_half
    material.burn(count, at, recipe, dt, b.rho_half, b.rho_half, drive, z.q, w.lam)
    material.add(count, recipe, b.heat, w.heat)
    material.share_heat(count, at, recipe, constants, z.q, b.p_half, b.rho_half, w.heat)
    material.lead_on(count, at, recipe, constants, w.lam, dt)
    material.mix(count, at, recipe, solid, z.e, b.lam, b.heat, w.p, w.status)
    material.keep_phases(count, at, recipe)
    material.copy(count, recipe, w.p, z.p)
    material.mixture_slopes(count, at, recipe, solid, z.e, b.lam, z.p)


# -- the two halves of a step ---------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def predict(a, passes, limited, piece, scratch, recipe, constants, found, dt):
    """Stress and forces in the middle of the step; found[FOUND_TANGLED] counts volumes that are not positive."""
    at, near = rows_of(a, piece, scratch), row(a.near, 0)
    z, b, w, count = at.z, at.b, at.w, at.total
    shape_in_middle(passes, near, piece, a.nodes, scratch)
    call_pass(passes.pushing_stress, count, tensor.StartOf(z.p, at.deviators, at.viscous, at.stress), dt, near)
    call_pass(passes.half_motion, count, zone_passes.HalfOf(at.shape.volume, z.inverse_mass, z.e, at.rates, at.stress, w.v, w.rho, w.e,
                                                            found), dt, near)
    solid, solid_v = w.rho, w.v
    if recipe.relief != 0:
        material.solid_volume(count, at, recipe)
        solid, solid_v = w.solid, w.solid_v
    if recipe.solve == 0:
        call_pass(recipe.pressure, count, PressureRows(solid_v, w.e, z.compaction, w.p), dt, row_at(recipe.eos))
        material.stiffness(count, at, recipe, solid, solid_v, w.e, w.p)
    else:
        close_half(passes, at, recipe, constants, solid, dt)
    deviators(passes, at, recipe, solid, w.e, w.p, b.lam_half, 0.5 * dt)
    material.relieve(count, at, recipe, solid)
    call_pass(passes.stiffnesses, count, zone_passes.StiffnessOf(w.rho, z.c, w.stiffness, w.power), dt, near)
    forces.corner_viscosity(passes, piece, a.nodes, scratch, at, solid, recipe, limited, a.mirrors, a.beyond)
    forces.forces_in_middle(passes, piece, a.nodes, a.zones, scratch, at, row(a.filters, 2 * piece[L.P_RECIPE]))
    if recipe.solve != 0:
        keep_half(count, at, recipe)


@nb.njit(**INLINE)
def correct(a, passes, piece, scratch, recipe, constants, found, dt):
    """State at the end of the step, and its forces."""
    at, near = rows_of(a, piece, scratch), row(a.near, 0)
    z, b, w, count = at.z, at.b, at.w, at.total
    kept = zone_passes.KeptViscosity(at.coming, z.filter_power, at.viscous, z.q, z.filter_work)
    call_pass(passes.keep_viscosity, count, kept, dt, near)
    shape_in_middle(passes, near, piece, a.nodes, scratch)
    forces.work_of_forces(passes, piece, a.nodes, a.zones, scratch)
    call_pass(passes.density, count, zone_passes.DensityOf(at.shape.volume, z.inverse_mass, w.v, z.rho), dt, near)
    call_pass(passes.viscous_heat, count, zone_passes.HeatOf(w.v, at.viscous, at.rates, w.heat), dt, near)
    call_pass(passes.end_energy, count, zone_passes.EnergyOf(z.inverse_mass, w.power, w.heat, z.e, z.viscous_work), dt, near)
    shape_at_end(passes, near, piece, a.nodes, scratch)
    call_pass(passes.density, count, zone_passes.DensityOf(at.shape.volume, z.inverse_mass, w.v, z.rho), dt, near)
    solid, solid_v = z.rho, w.v
    if recipe.relief != 0:
        material.solid_volume(count, at, recipe)
        solid, solid_v = w.solid, w.solid_v
    if recipe.solve == 0:
        call_pass(recipe.state, count, StateRows(solid_v, z.e, z.compaction, z.p, w.c2), dt, row_at(recipe.eos))
    else:
        close_end(count, at, recipe, constants, solid, dt)
    deviators(passes, at, recipe, solid, z.e, z.p, b.lam, dt)
    material.tear(count, at, recipe, constants, found, solid, dt)
    material.harden(count, at, recipe, w.v)
    call_pass(passes.keep, count, tensor.KeepOf(z.p, at.viscous, at.new, at.deviators, z.sigma), dt, near)
    speed = zone_passes.SpeedOf(w.c2, w.shear, solid_v, z.viscous_speed, w.inverse_length, z.c, found)
    call_pass(passes.end_speed, count, speed, dt, constants)
    material.pace(count, at, recipe, constants, found, w.inverse_length)
    material.look_over(count, at, recipe, found)
    push(a, passes, piece, at)


@nb.njit(**INLINE)
def push(a, passes, piece, at):
    """Corner forces of the state as it stands, which push at the start of the next step."""
    call_pass(passes.pushing_stress, at.total, tensor.StartOf(at.z.p, at.deviators, at.viscous, at.stress), 0.0, at.z.p)
    f = spread(L.Corners, a.zones[forces.FORCES:], piece[L.P_ZONE])
    call_pass(passes.stress_forces, at.total, geometry.ForcesOf(at.shape, at.stress, f), 0.0, at.z.p)
