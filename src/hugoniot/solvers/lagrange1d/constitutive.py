"""What one zone's material does in one step: the scalar pieces both integrators share.

The deviators follow Wilkins B.2 items 5 and 6: elastic trial from the deviatoric strain increments, then radial return
to the von Mises surface. In planar and spherical flow the two hoop directions are alike, so s1 = -2 s2 and the return is
a clamp of s1 (Herrmann A.18, with the corrected result sgn 2Y/3); cylindrical flow needs the full second invariant.
"""

import sys

from hugoniot.core.compile import bind_choice, bind_module
from hugoniot.core.ops import fmax, fmin, late_over, vsqrt
from hugoniot.laws.eos.contract import EOS, reference_state, remembered, temperature
from hugoniot.laws.fracture.contract import FRACTURE, tension_cap
from hugoniot.laws.strength.contract import STRENGTH, flow_stress
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.mesh.line import hoops

TINY = 1e-300
OPENING_OF_A_SPRAY = 0.01    # part of the volume
NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


def strength_temperature(rho, e, eos, strength):
    """Temperature for a strength law that asks for one; 0 for the others, at no cost."""
    return temperature(rho, e, eos) if "needs_temperature" in STRENGTH.of(strength).flags else 0.0


def no_temperature(rho, e, eos, strength):
    return 0.0


def law_temperature(rho, e, eos, strength):
    return temperature(rho, e, eos)


def remembers(eos):
    """Whether the equation of state has a history variable."""
    return "remembers" in EOS.of(eos).flags


def strain_base(rho0, compaction, eos):
    """Density from which the volume strain of a fracture law counts, kg/m3: that of the material at rest, as compacted as it is."""
    return reference_state(remembered(compaction, eos))[0] if remembers(eos) else rho0


def hardens(strength):
    """Whether the flow stress depends on the plastic strain."""
    return "hardens" in STRENGTH.of(strength).flags


def fails(fracture):
    """Whether a zone can fail at all, and its damage and failure ratio are worth keeping."""
    return "never" not in FRACTURE.of(fracture).flags


def grows_voids(fracture):
    """Whether a failing zone grows voids at a tension its law caps."""
    return "voids" in FRACTURE.of(fracture).flags


def void_change(tension, stiffness, voids, density, fracture):
    """(change of the void volume per mass, change of the pressure): voids grow at the capped tension and close at zero stress.

    stiffness = rho^2 c_b^2 of the solid, -dp/dv: the changes are consistent to first order, and the next step's equation of
    state, which sees the solid's own volume, takes up the rest. Where the solid's pressure does not answer (a tension cut-off)
    voids take OPENING_OF_A_SPRAY of the volume in a step, until it does.
    """
    excess = fmax(tension - tension_cap(voids * density, fracture), 0.0)
    closing = fmin(voids * stiffness, fmax(-tension, 0.0))
    answers = stiffness if stiffness > excess * density else excess * density * (1.0 / OPENING_OF_A_SPRAY)
    return (excess - closing) / fmax(answers, TINY), excess - closing


def flow_beside_voids(flow, grown, density):
    """Plastic strain increment of the solid when part of the stretch, grown * density, was the opening of voids."""
    return fmax(flow - (2.0 / 3.0) * fmax(grown, 0.0) * density, 0.0)


def resisted(du, growth, viscosity):
    """The velocity jump an artificial viscosity resists: 0 unless the zone narrows and shrinks (`growth` < 0), but for two-sided laws."""
    return both_ways(du, growth, viscosity) if "two_sided" in VISCOSITY.of(viscosity).flags else in_compression(du, growth, viscosity)


def in_compression(du, growth, viscosity):
    return fmin(du if growth < 0.0 else 0.0, 0.0)


def both_ways(du, growth, viscosity):
    return du


def wave_speed(c2, noise):
    """sqrt(c2); -1, which the watch refuses, for an imaginary speed; 0 for what is zero but for round-off (a cold gas)."""
    return vsqrt(fmax(c2, 0.0)) if c2 > -noise else -1.0


def yes(par):
    return True


def no(par):
    return False


def strain_rate(radial, hoop, dilation, dt, geometry, strength):
    """Equivalent deviatoric strain rate sqrt(2/3 e':e') for a law that asks for it; 0 for the others."""
    return equivalent_rate(radial, hoop, dilation, dt, geometry, strength) if "needs_rate" in STRENGTH.of(strength).flags else 0.0


def no_rate(radial, hoop, dilation, dt, geometry, strength):
    return 0.0


def equivalent_rate(radial, hoop, dilation, dt, geometry, strength):
    third = dilation * (1.0 / 3.0)
    e1 = radial - third
    e2 = hoop - third
    e3 = -(e1 + e2)
    return vsqrt((2.0 / 3.0) * (e1 * e1 + e2 * e2 + e3 * e3)) / dt


def von_mises(s1, s2, geometry):
    """Equivalent stress sqrt(3/2 s:s)."""
    if hoops(geometry) == 1.0:
        return vsqrt(3.0 * (s1 * s1 + s1 * s2 + s2 * s2))
    return 1.5 * fmax(s1, -s1)


def hoop_deviator(s1, s2, geometry):
    """s2 at the start of a step: its row of the zone table is kept in cylindrical flow only, for elsewhere it is -s1/2."""
    return s2 if hoops(geometry) == 1.0 else -0.5 * s1


def radial_return(s1, s2, limit, geometry):
    """Deviators brought back to the yield surface of flow stress `limit` (Wilkins B.2 item 6)."""
    if hoops(geometry) == 1.0:
        square = 3.0 * (s1 * s1 + s1 * s2 + s2 * s2)
        # limit / sqrt(J) as limit sqrt(J) / J: the division need not wait for the root
        scale = fmin(1.0, late_over(limit * vsqrt(square), square + NO_STRESS))
        return s1 * scale, s2 * scale
    bound = (2.0 / 3.0) * limit
    s1 = fmax(fmin(s1, bound), -bound)
    return s1, -0.5 * s1


def trial_deviators(s1, s2, radial, hoop, dilation, shear):
    """Elastic deviators after the strain increments; `dilation` is dV/V."""
    third = dilation * (1.0 / 3.0)
    return s1 + 2.0 * shear * (radial - third), s2 + 2.0 * shear * (hoop - third)


def yield_at(equivalent, shear, state, plastic_strain, strength):
    """(stress on the yield surface or above the trial, plastic strain increment) of an elastic trial state.

    `state` = (rho, p, temperature, rate). A hardening law is met implicitly: 3 G d = trial - Y(eps + d) by one secant
    step, which is exact for linear hardening. Where the excess would take a strain of more than 1, the modulus itself has gone
    (a melt): the stress is lost without plastic strain.
    """
    rho, p, heat, rate = state
    limit = flow_stress(rho, p, heat, plastic_strain, rate, strength)
    stiffness = 3.0 * shear
    excess = fmax(equivalent - limit, 0.0)
    increment = excess / fmax(stiffness, TINY) if stiffness > excess else 0.0
    if hardens(strength):
        further = flow_stress(rho, p, heat, plastic_strain + increment, rate, strength)
        increment = increment * excess / fmax(excess + (further - limit), TINY)  # a sum with TINY may be reordered and lose it
        limit = limit + excess - increment * stiffness if stiffness > excess else limit
    return limit, increment


def bind():
    """Let kernels call these functions; what a law does not need is decided when the kernel is compiled."""
    def asks(flag, then, otherwise):
        return lambda *classes: then if flag in STRENGTH.of_class(classes[-1]).flags else otherwise

    bind_choice(strength_temperature, asks("needs_temperature", law_temperature, no_temperature))
    bind_choice(strain_rate, asks("needs_rate", equivalent_rate, no_rate))
    bind_choice(remembers, lambda cls: yes if "remembers" in EOS.of_class(cls).flags else no)
    bind_choice(hardens, asks("hardens", yes, no))
    bind_choice(resisted, lambda *classes: both_ways if "two_sided" in VISCOSITY.of_class(classes[-1]).flags else in_compression)
    bind_choice(fails, lambda cls: no if "never" in FRACTURE.of_class(cls).flags else yes)
    bind_choice(grows_voids, lambda cls: yes if "voids" in FRACTURE.of_class(cls).flags else no)
    bind_module(sys.modules[__name__])
