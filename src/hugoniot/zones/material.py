"""What the material of a piece of zones does in a step, in the order in which it happens: passes called by a recipe.

A solver hands over `at`, its rows: at.z fields of zones, at.b further fields of burning zones, at.w scratch, by the names used here;
`recipe` and `constants`, a row of `Constants`; and `found`, a row that takes what passes find (`soundness`). Nothing here knows a
dimension: strains, the elastic trial and the return to the yield surface stand between `moduli` and `flow`, and are the solver's.
"""

import numba as nb

from hugoniot.core.passes import call_pass, row_at
from hugoniot.core.target import INLINE
from hugoniot.zones.burn import BurnRows, HeatRows, KeepRows, LeadRows, PaceRows, PassedRows, PassingRows
from hugoniot.zones.burn import RateRows as BurnRateRows
from hugoniot.zones.closure import RestRows, StiffnessRows, TemperatureRows
from hugoniot.zones.fracture import FractureRows, HoldRows, ReliefRows, SolidRows, WorstRows
from hugoniot.zones.mixture import MixtureTemperatureRows, SlopeRows, SolveRows
from hugoniot.zones.rows import AddRows, CopyRows, FillRows
from hugoniot.zones.soundness import PeakRows
from hugoniot.zones.strength import HardenRows, PlasticHeatRows, ShearRows, UnburnedLimitRows, UnburnedShearRows, YieldRows
from hugoniot.zones.viscosity import SpeedRows, SpeedsRows


# -- everywhere ----------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def clear(count, recipe, row):
    """Zeros in a row."""
    call_pass(recipe.clear, count, FillRows(row), 0.0, row)


@nb.njit(**INLINE)
def copy(count, recipe, row, to):
    """A row into another."""
    call_pass(recipe.copy, count, CopyRows(row, to), 0.0, row)


@nb.njit(**INLINE)
def add(count, recipe, more, to):
    """A row added to another."""
    call_pass(recipe.add, count, AddRows(more, to), 0.0, more)


@nb.njit(**INLINE)
def look_over(count, at, recipe, found):
    """Peaks, and how many zones are not sound."""
    z = at.z
    call_pass(recipe.look_over, count, PeakRows(z.rho, z.c, z.sigma, z.p, z.peak_stress, z.peak_tension, z.peak_pressure, z.peak_density,
                                                found), 0.0, found)


@nb.njit(**INLINE)
def viscous(count, recipe, v, c, p, squeeze, smooth, speed):
    """Signal speed of the artificial viscosity."""
    call_pass(recipe.speed, count, SpeedRows(v, c, p, squeeze, smooth, speed), 0.0, row_at(recipe.viscosity))


@nb.njit(**INLINE)
def viscous_both(count, at, recipe, v, c, p):
    """The same of a leapfrog, with the speed of its quadratic part alone at the end of the step."""
    w = at.w
    call_pass(recipe.speeds, count, SpeedsRows(v, c, p, w.squeeze, w.v, w.speed, w.weak_speed), 0.0, row_at(recipe.viscosity))


# -- inert closure ---------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def stiffness(count, at, recipe, solid, solid_v, e, p):
    """c^2 before the state is known, where it is asked for: of inert material, or of the phases of the step before."""
    b, w = at.b, at.w
    if recipe.bulk_first != 0:
        if recipe.solve == 0:
            call_pass(recipe.stiffness, count, StiffnessRows(solid_v, e, p, at.z.compaction, w.c2), 0.0, row_at(recipe.eos))
        else:
            call_pass(recipe.slopes, count, SlopeRows(solid, e, b.lam, p, b.rho_r, b.e_r, b.rho_p, b.e_p, w.c2, w.p_e), 0.0,
                      row_at(recipe.reactive))


# -- strength ----------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def moduli(count, at, recipe, solid, e, p, lam):
    """Shear modulus of a state, and its temperature for laws that ask for one; lam counts in burning material only."""
    z, b, w = at.z, at.b, at.w
    heat = w.zero
    if recipe.temperature != 0:
        heat = w.temperature
        if recipe.solve == 0:
            call_pass(recipe.temperature, count, TemperatureRows(solid, e, z.compaction, heat), 0.0, row_at(recipe.eos))
        else:
            call_pass(recipe.temperature, count, MixtureTemperatureRows(b.lam, z.p, b.rho_r, b.e_r, b.rho_p, b.e_p, heat), 0.0,
                      row_at(recipe.reactive))
    call_pass(recipe.shear, count, ShearRows(solid, p, heat, w.c2, w.shear), 0.0, row_at(recipe.strength))
    if recipe.solve != 0:
        call_pass(recipe.unburned_shear, count, UnburnedShearRows(lam, w.shear), 0.0, w.shear)


@nb.njit(**INLINE)
def flow(count, at, recipe, solid, p, lam):
    """Flow stress and plastic strain that meet the equivalent stress of the elastic trial."""
    w = at.w
    heat = w.temperature if recipe.temperature != 0 else w.zero
    rate = w.rate if recipe.needs_rate != 0 else w.zero
    call_pass(recipe.yields, count, YieldRows(solid, p, heat, rate, w.shear, w.equivalent, at.z.plastic_strain, w.limit, w.flow), 0.0,
              row_at(recipe.strength))
    if recipe.solve != 0:
        call_pass(recipe.unburned_limit, count, UnburnedLimitRows(lam, w.shear, w.equivalent, w.limit, w.flow), 0.0, w.limit)


@nb.njit(**INLINE)
def harden(count, at, recipe, v):
    """Plastic strain and work of the step, of volume v per mass."""
    z, w = at.z, at.w
    if recipe.shear != 0:
        call_pass(recipe.harden, count, HardenRows(w.limit, w.flow, v, z.plastic_work, z.plastic_strain), 0.0, v)


@nb.njit(**INLINE)
def add_plastic_heat(count, at, recipe, v, heat):
    """Plastic work of a strain, J/kg, added to a row."""
    w = at.w
    if recipe.shear != 0:
        call_pass(recipe.plastic_heat, count, PlasticHeatRows(w.limit, w.flow, v, heat), 0.0, v)


# -- fracture ----------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def solid_volume(count, at, recipe):
    """Specific volume and density of the solid between the voids of the scratch row v."""
    w = at.w
    call_pass(recipe.solid, count, SolidRows(w.v, at.z.voids, w.solid, w.solid_v), 0.0, w.v)


@nb.njit(**INLINE)
def relieve(count, at, recipe, solid):
    """Take off the pressure in the middle of a step what voids would take off now."""
    w = at.w
    if recipe.relief != 0:
        call_pass(recipe.relief, count, ReliefRows(w.t1, w.p, w.c2, solid, at.z.voids, w.relief), 0.0, row_at(recipe.breaking))
        add(count, recipe, w.relief, w.p)


@nb.njit(**INLINE)
def tear(count, at, recipe, constants, found, solid, dt):
    """Damage, failure and voids at the end of a step, the pressure relieved. t1 is the stress deviator along the tension."""
    z, w = at.z, at.w
    if recipe.fracture == 0:
        return
    if recipe.remembers != 0:
        call_pass(recipe.rest, count, RestRows(z.compaction, w.rest), 0.0, row_at(recipe.eos))
    else:
        call_pass(recipe.rest, count, FillRows(w.rest), 0.0, constants)
    call_pass(recipe.fracture, count, FractureRows(w.t1, z.p, w.c2, solid, w.v, w.rest, z.damage, z.voids, z.failure, w.grown, w.relief),
              dt, row_at(recipe.breaking))
    call_pass(recipe.worst, count, WorstRows(z.failure, found), 0.0, found)
    if recipe.relief != 0:
        call_pass(recipe.hold, count, HoldRows(solid, w.grown, w.relief, w.flow, z.p, found), 0.0, found)


# -- burning -----------------------------------------------------------------------------------------------------------
@nb.njit(**INLINE)
def burn(count, at, recipe, dt, rho, end_rho, drive, q, new):
    """Burn fractions after dt into the row `new`."""
    z, b = at.z, at.b
    call_pass(recipe.burn, count, BurnRows(b.lam, b.since, b.size, rho, end_rho, drive, q, z.p, b.rho_r, b.e_r, b.rho_p, b.e_p, new), dt,
              row_at(recipe.reactive))


@nb.njit(**INLINE)
def mix(count, at, recipe, solid, e, lam, heat, p, status):
    """Pressure into the row p and phases into the scratch rows, from those of the step before warmed by `heat`."""
    z, b, w = at.z, at.b, at.w
    call_pass(recipe.solve, count, SolveRows(solid, e, lam, heat, z.p, b.rho_r, b.e_r, b.rho_p, b.e_p, p, w.rho_r, w.e_r, w.rho_p, w.e_p,
                                             status), 0.0, row_at(recipe.reactive))


@nb.njit(**INLINE)
def mixture_slopes(count, at, recipe, solid, e, lam, p):
    """c^2 and dp/de of the phases in the scratch rows."""
    w = at.w
    call_pass(recipe.slopes, count, SlopeRows(solid, e, lam, p, w.rho_r, w.e_r, w.rho_p, w.e_p, w.c2, w.p_e), 0.0, row_at(recipe.reactive))


@nb.njit(**INLINE)
def keep_phases(count, at, recipe):
    """The phases in the scratch rows become those of the step."""
    b, w = at.b, at.w
    call_pass(recipe.keep_phases, count, KeepRows(w.rho_r, w.e_r, w.rho_p, w.e_p, w.status, b.rho_r, b.e_r, b.rho_p, b.e_p, b.status), 0.0,
              w.status)


@nb.njit(**INLINE)
def share_old_heat(count, at, recipe, constants, heat):
    """What phases take of `heat`, as far as a shock was passing at the end of the step before, into b.heat."""
    b, w = at.b, at.w
    call_pass(recipe.was_passing, count, PassedRows(b.reference, w.shocked), 0.0, constants)
    call_pass(recipe.share_heat, count, HeatRows(w.shocked, heat, b.heat), 0.0, constants)


@nb.njit(**INLINE)
def share_heat(count, at, recipe, constants, q, p, rho, heat):
    """The same, as far as a shock of viscous pressure q is passing now."""
    b, w = at.b, at.w
    call_pass(recipe.is_passing, count, PassingRows(q, p, rho, at.z.c, w.shocked), 0.0, constants)
    call_pass(recipe.share_heat, count, HeatRows(w.shocked, heat, b.heat), 0.0, constants)


@nb.njit(**INLINE)
def lead_on(count, at, recipe, constants, lam, dt):
    """Burn fractions, clock and code of the reference state at the end of the step; w.shocked says where a shock is passing."""
    b = at.b
    call_pass(recipe.lead_on, count, LeadRows(lam, at.w.shocked, b.lam, b.since, b.reference), dt, constants)


@nb.njit(**INLINE)
def pace(count, at, recipe, constants, found, inverse_width):
    """What burning asks of the time step, at the end of a step."""
    z, b, w = at.z, at.b, at.w
    if recipe.solve != 0:
        call_pass(recipe.rates, count, BurnRateRows(b.lam, z.rho, z.p, z.q, b.rho_r, b.e_r, b.rho_p, b.e_p, w.pace), 0.0,
                  row_at(recipe.reactive))
        call_pass(recipe.pace, count, PaceRows(b.lam, w.pace, inverse_width, b.status, b.resolution, z.c, found), 0.0, constants)
