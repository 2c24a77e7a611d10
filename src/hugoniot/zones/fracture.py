"""Fracture of a zone: damage, how close it is to failure, and the growth of voids at the largest tension that its law allows.

Voids grow at that tension and close at zero stress. The changes are consistent to first order; the equation of state of the next step,
evaluated at the volume of the solid alone, corrects the rest.
"""

from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import flag_of, law_of, rows_apart, zone_pass
from hugoniot.laws.fracture.contract import FRACTURE, damage_rate, failure, tension_cap
from hugoniot.zones.soundness import FOUND_CAPPED, FOUND_FAILURE

TINY = 1e-300
OPENING_OF_A_SPRAY = 0.01    # part of the volume
grows_voids = flag_of(FRACTURE, "voids")     # whether a failing zone grows voids at a tension its law caps


def void_change(tension, stiffness, voids, density, fracture):
    """(change of the void volume per mass, change of the pressure).

    stiffness = rho^2 c_b^2 of the solid, -dp/dv. Where the solid's pressure does not answer (a tension cut-off) voids take
    OPENING_OF_A_SPRAY of the volume in a step, until it does.
    """
    excess = fmax(tension - tension_cap(voids * density, fracture), 0.0)
    closing = fmin(voids * stiffness, fmax(-tension, 0.0))
    answers = stiffness if stiffness > excess * density else excess * density * (1.0 / OPENING_OF_A_SPRAY)
    return (excess - closing) / fmax(answers, TINY), excess - closing


def at_work(tension, voids, density, fracture):
    """More than 0 where voids stand, or would grow: elsewhere `void_change` is nothing."""
    return fmax(fmax(voids, -voids), tension - tension_cap(voids * density, fracture))


def flow_beside_voids(flow, grown, density):
    """Plastic strain increment of the solid when part of the stretch, grown * density, was the opening of voids."""
    return fmax(flow - (2.0 / 3.0) * fmax(grown, 0.0) * density, 0.0)


@zone_pass("t1 p c2 rho v rest flow damage voids failure relief grown found")
def fracture_pass(count, z, dt, numbers, law):
    """Damage, failure and its largest ratio; voids, the pressure they relieve and the flow beside them, and how many zones they held.

    t1 (Pa), c2, rho of the solid, v (of solid and voids), rest density -> failure, relief (Pa), how much voids grew (m3/kg, where any
    stand); what is found. p, flow, damage and voids (m3/kg) are advanced. Voids are looked after only in pieces that have some, or a zone
    at the tension its law caps: most have neither.
    """
    rows_apart()
    fracture, worst, most, capped = law_of(law, numbers), z.found[FOUND_FAILURE], 0.0, 0.0
    for j in range(count):
        p = z.p[j]
        tension = z.t1[j] - p
        hurt = z.damage[j] + dt * damage_rate(tension, fracture)
        ratio = failure(tension, p, z.rest[j] * z.v[j], hurt, fracture)
        worst = fmax(worst, ratio)
        z.damage[j] = hurt
        z.failure[j] = ratio
        if grows_voids(fracture):
            most = fmax(most, at_work(tension, z.voids[j], z.rho[j], fracture))
            z.relief[j] = 0.0
    z.found[FOUND_FAILURE] = worst
    if most > 0.0:
        for j in range(count):
            p, rho = z.p[j], z.rho[j]
            grown, relief = void_change(z.t1[j] - p, rho * rho * z.c2[j], z.voids[j], rho, fracture)
            z.voids[j] += grown
            z.grown[j] = grown
            z.relief[j] = relief
            z.flow[j] = flow_beside_voids(z.flow[j], grown, rho)
            z.p[j] = p + relief
            capped += 1.0 if relief > 0.0 else 0.0
        z.found[FOUND_CAPPED] += capped


@zone_pass("t1 p c2 rho voids")
def relief_pass(count, z, dt, numbers, law):
    """Takes off the tension what the voids would now; none of them grows."""
    rows_apart()
    fracture, most = law_of(law, numbers), 0.0
    for j in range(count):
        most = fmax(most, at_work(z.t1[j] - z.p[j], z.voids[j], z.rho[j], fracture))
    if most > 0.0:
        for j in range(count):
            p, rho = z.p[j], z.rho[j]
            z.p[j] = p + void_change(z.t1[j] - p, rho * rho * z.c2[j], z.voids[j], rho, fracture)[1]


@zone_pass("v rho voids solid solid_v")
def solid_pass(count, z, dt, numbers, law):
    """Specific volume and density of the solid between the voids; v and rho are those of both."""
    rows_apart()
    most = 0.0
    for j in range(count):
        most = fmax(most, fmax(z.voids[j], -z.voids[j]))
    if most > 0.0:
        for j in range(count):
            solid = z.v[j] - z.voids[j]
            z.solid_v[j] = solid
            z.solid[j] = 1.0 / solid
    else:
        for j in range(count):
            z.solid_v[j] = z.v[j]
            z.solid[j] = z.rho[j]
