"""The zones of a material in a step, as lists of passes: stress and forces in the middle, and the state at the end."""

from hugoniot.solvers.lagrange2d import edge_viscosity, heat_flux, herrmann_viscosity, hoop_viscosity, shown, tensor, viscosity
from hugoniot.solvers.lagrange2d import zone_passes as passes
from hugoniot.solvers.lagrange2d.layout import Tensor
from hugoniot.solvers.lagrange2d.quads import AreaWeighted


def deviators(s, solid, e, p, lam, step):
    """Write the deviators at the end of a strain into w.new, with `limit` and `flow`; zero for a fluid.

    s           `zones.steps.MaterialSteps` with the rows of `plan`
    e, p, lam   rows of the state whose modulus and yield count (lam: of burning material only); its c^2 is w.c2
    step        the time of the strain
    """
    w, at = s.at.w, s.at
    if not s.laws.is_strong:
        s.clear(*at.new)
        return
    solid_rows = s.asked(solid, e, p, lam)
    s.do(tensor.strain_solid, tensor.StrengthOf(solid_rows, at.s, at.d, w.shear, at.new, w.limit, w.flow), step, law=s.strong(()))
    if s.laws.breaks:
        s.do(tensor.largest_deviator, tensor.LargestOf(at.new, w.t1))


def resist(s, geometry, solid, kind):
    """Write how the viscous stress in the middle of the step is found, from the density row `solid`; kind: of the viscosity."""
    z, w, at = s.at.z, s.at.w, s.at
    if kind == "herrmann":
        s.do(herrmann_viscosity.resist_along_axes, herrmann_viscosity.HerrmannOf(
            at.mid_low, at.mid_high, at.d, w.v, z.c, s.p_half, solid, at.q, at.rest, z.viscous_speed), law=s.laws.viscosity)
        return
    rows = viscosity.ResistOf(at.mid_low, at.mid_high, at.d, at.smooth, w.v, z.c, s.p_half, solid,
                              w.closes, Tensor(at.q.xx, at.q.yy, at.q.xy), at.rest, z.viscous_speed, w.rate)
    s.do(edge_viscosity.resist_edges if kind == "edge" else viscosity.resist, rows, law=s.laws.viscosity)
    if isinstance(geometry, AreaWeighted):
        s.do(hoop_viscosity.hoop_viscosity, hoop_viscosity.HoopOf(at.d, w.rate, at.q, at.rest))


def state_in_middle(s):
    """Write pressure and deviators in the middle of the step, from density and energy there; the row of the solid's density."""
    solid = pressure_in_middle(s)
    stress_in_middle(s, solid)
    return solid


def pressure_in_middle(s):
    """The first part of `state_in_middle`: without deviators, and before voids take their relief."""
    b, w, at = s.at.b, s.at.w, s.at
    solid, solid_v = s.solid(s.rho_half)
    if s.laws.burns:
        s.burn(at.half, at.z.rho, at.z.rho, at.z.p, at.z.q, b.lam_half)
        s.do(tensor.viscous_heat, tensor.HeatOf(w.v, at.q, at.d, w.heat), at.half)
        s.close_half(solid)
    else:
        s.pressure(solid, solid_v, w.e, s.p_half)
    return solid


def stress_in_middle(s, solid):
    """The second part."""
    deviators(s, solid, s.at.w.e, s.p_half, s.at.b.lam_half, s.at.half)
    s.relieve(solid)


def state_at_end(s):
    """Write pressure, deviators, fracture and hardening at the end of the step; the row of the solid's specific volume."""
    solid, solid_v = pressure_at_end(s)
    stress_at_end(s, solid)
    return solid_v


def pressure_at_end(s):
    """The first part of `state_at_end`; rows of density and specific volume of the solid."""
    solid, solid_v = s.solid(s.at.z.rho)
    if s.laws.burns:
        s.close_end(solid)
    else:
        s.state(solid_v, s.at.z.e, s.at.z.p)
    return solid, solid_v


def stress_at_end(s, solid):
    """The second part."""
    z, b, w, at = s.at.z, s.at.b, s.at.w, s.at
    deviators(s, solid, z.e, z.p, b.lam, at.whole)
    s.tear(solid)
    s.harden(w.v)


def predict(s, geometry, numbers, fluid, kind):
    """Write how stress and forces in the middle of the step are found; numbers: the material's constants and
    those of `layout` behind them; kind: of the viscosity."""
    z, w, at = s.at.z, s.at.w, s.at
    s.do(passes.strain, passes.StrainOf(at.mid, z.inverse_mass, z.e, z.p, at.s, at.q, at.d, w.v, s.rho_half, w.e, at.tangled),
         kind=geometry, numbers=numbers)
    solid = state_in_middle(s)
    resist(s, geometry, solid, kind)
    push = passes.push_fluid if fluid else passes.push_solid
    s.do(push, passes.PushOf(at.mid, s.p_half, at.new, at.q, z.t0, z.t1, s.rho_half, z.c, at.f, at.power), kind=geometry, numbers=numbers)
    if kind != "herrmann":
        s.do(passes.add_rest, passes.RestOf(at.mid, at.rest, w.closes if kind == "tensor" else at.everywhere, at.f), kind=geometry,
             numbers=numbers)
    if s.laws.burns:
        s.keep_half()


def correct(s, geometry, numbers, conduction, keeps_trace):
    """Write how the state at the end of the step is found; conduction: rows and numbers of the artificial heat flux, or
    None; keeps_trace: whether other steps need the trace of the viscous stress."""
    z, w, at = s.at.z, s.at.w, s.at
    s.do(passes.settle, passes.SettleOf(at.mid, at.f, z.inverse_mass, at.power, at.d, z.e, w.heat, at.q, at.found), kind=geometry,
         numbers=numbers)
    s.add_some(w.heat, z.viscous_work)
    if keeps_trace:
        s.do(shown.trace, shown.TraceOf(at.q, z.q))
    if conduction:
        s.do(heat_flux.conduct, conduction[0], kind=geometry, numbers=conduction[1])
    s.do(passes.shape, passes.ShapeOf(at.now, z.inverse_mass, w.v, z.rho, w.inverse_length), kind=geometry, numbers=numbers)
    solid_v = state_at_end(s)
    s.do(passes.stand, passes.StandOf(at.new, w.c2, s.shear, solid_v, z.viscous_speed, w.inverse_length, at.s, s.seen))
    s.pace(w.inverse_length)
