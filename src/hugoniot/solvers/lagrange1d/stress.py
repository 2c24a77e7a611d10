"""Stress deviators in one dimension: elastic trial from the strain increments of a step, and the return to the yield surface.

Wilkins B.2 items 5 and 6. In planar and spherical flow the two transverse directions are equivalent, so s1 = -2 s2 and the return limits s1
(Herrmann A.18, with the corrected result sgn 2Y/3); cylindrical flow needs the full second invariant.
"""

from hugoniot.core.binder import bind_family
from hugoniot.core.ops import fmax, fmin, late_over, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.mesh.line import GENERICS, GEOMETRY, area_per_radius, hoops
from hugoniot.zones.strength import Solid, modulus, needs_rate, yielding

bind_family(GEOMETRY, GENERICS)     # geometry in kernels: every list of the solver's passes takes this module

NO_STRESS = 1e-30     # Pa2, beside which no stress squared counts


def trial_deviators(s1, s2, radial, hoop, dilation, shear):
    """Elastic deviators after the strain increments; `dilation` is dV/V."""
    third = dilation * (1.0 / 3.0)
    return s1 + 2.0 * shear * (radial - third), s2 + 2.0 * shear * (hoop - third)


def von_mises(s1, s2, geometry):
    """Equivalent stress sqrt(3/2 s:s)."""
    if hoops(geometry) == 1.0:
        return vsqrt(3.0 * (s1 * s1 + s1 * s2 + s2 * s2))
    return 1.5 * fmax(s1, -s1)


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


def hoop_force(r1, r2, t1, t2, q, geometry):
    """Force of the hoop stress on each node of a zone, of stresses t1, t2 and the viscous pressure q along the motion."""
    return 0.5 * hoops(geometry) * (r2 - r1) * area_per_radius(r1, r2, geometry) * (t2 + q - t1)


def equivalent_rate(radial, hoop, dilation, dt):
    """Equivalent deviatoric strain rate sqrt(2/3 e':e'), 1/s."""
    third = dilation * (1.0 / 3.0)
    e1 = radial - third
    e2 = hoop - third
    e3 = -(e1 + e2)
    return vsqrt((2.0 / 3.0) * (e1 * e1 + e2 * e2 + e3 * e3)) / dt


def strained(z, j, dt, strong):
    """Elastic trial, yield and return of a zone: (deviators along the motion and around it, shear modulus, flow stress, plastic strain)."""
    geometry, solid = strong.geometry, z.solid
    radial, hoop, dilation, lam = z.radial[j], z.hoop[j], z.dilation[j], solid.lam[j]
    rate = equivalent_rate(radial, hoop, dilation, dt) if needs_rate(strong.law) else 0.0
    state = (solid.rho[j], solid.p[j], solid.temperature[j], rate)
    shear = modulus(state, solid.c2[j], lam, strong)
    t1, t2 = trial_deviators(z.s1[j], z.s2[j], radial, hoop, dilation, shear)
    limit, flow = yielding(von_mises(t1, t2, geometry), shear, state, solid.plastic_strain[j], lam, strong)
    t1, t2 = radial_return(t1, t2, limit, geometry)
    return t1, t2, shear, limit, flow


@zone_pass("solid s1 s2 radial hoop dilation shear t1 t2 limit flow", solid=Solid)
def strain_solid(count, z, dt, numbers, law):
    """State; s1, s2 at the start; radial and hoop strains and dilation of the step -> shear, t1, t2, limit, flow; `law` is a
    `zones.strength.Strong`."""
    rows_apart()
    strong = law_of(law, numbers)
    for j in range(count):
        z.t1[j], z.t2[j], z.shear[j], z.limit[j], z.flow[j] = strained(z, j, dt, strong)


def strains(s, geometry):
    """Rows of hoop strain and dilation; s: `zones.steps.MaterialSteps`."""
    w = s.at.w
    return (w.hoop, w.dilation) if hoops(geometry) > 0.0 else (w.zero, w.radial)   # one number in planar flow


def deviators(s, geometry, solid, e, p, lam, step):
    """Write the deviators at the end of a strain, with `limit` and `flow`; gives their rows (along the motion, around it).

    s           `zones.steps.MaterialSteps`
    e, p, lam   rows of the state whose modulus and yield count (lam: of burning material only); its c^2 is w.c2
    step        the time of the strain
    """
    z, w = s.at.z, s.at.w
    if not s.laws.is_strong:
        return w.zero, w.zero
    s.do(strain_solid, (s.asked(solid, e, p, lam), z.s1, z.s2, w.radial, *strains(s, geometry), w.shear, w.t1, w.t2, w.limit, w.flow), step,
         law=s.strong(geometry))
    return w.t1, w.t2
