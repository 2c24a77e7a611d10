r"""Physical viscosity in one dimension: viscous stresses from the strains of a step, and their effect on nodes and energies.

$$\tau_r = 2\mu\left(\dot\epsilon_r - \tfrac13\dot\vartheta\right) + \zeta\dot\vartheta, \qquad
  \tau_h = 2\mu\left(\dot\epsilon_h - \tfrac13\dot\vartheta\right) + \zeta\dot\vartheta, \qquad \zeta = r_b\mu + \zeta_0$$

with $\dot\vartheta$ the rate of volume strain. They are added to the stress that moves the nodes, so in the compatible integrator their
work equals their dissipation to round-off; the leapfrog adds their work over the step to the energy before the pressure work.

The scheme is explicit. With the velocities extrapolated to the middle of the step it is that of Adams and Bashforth, stable in steps of
up to a quarter of the viscous diffusion time of a zone; the leapfrog, with those of the step before, in steps of up to half of it.

Source: Herrmann equations 3.1 to 3.5; Jordan chapter 2 (4/3 mu + zeta along the motion).
"""

from hugoniot.core.ops import fmax
from hugoniot.core.passes import kind_of, rows_apart, zone_pass
from hugoniot.mesh.line import area_per_radius, hoops, mean_area
from hugoniot.solvers.lagrange1d.stress import hoop_force, strains
from hugoniot.zones.soundness import FOUND_RATE
from hugoniot.zones.transport import find_viscosity

EXTRAPOLATED = 4.0     # by it, viscous zones that close and open in turn are damped in any step of up to a Courant number of 1


# -- passes ------------------------------------------------------------------------------------------------------------
@zone_pass("viscosity strain hoop_strain dilation radial around")
def friction_pass(count, z, dt, numbers, law):
    """Viscous stresses; `numbers` are bulk ratio and bulk viscosity."""
    rows_apart()
    ratio, bulk, per_time = numbers[0], numbers[1], 1.0 / dt
    for j in range(count):
        mu, dilation = z.viscosity[j], z.dilation[j]
        third, whole = dilation * (1.0 / 3.0), (ratio * mu + bulk) * dilation
        z.radial[j] = (2.0 * mu * (z.strain[j] - third) + whole) * per_time
        z.around[j] = (2.0 * mu * (z.hoop_strain[j] - third) + whole) * per_time


@zone_pass("r radial around sigma hoop")
def push_pass(count, z, dt, numbers, law):
    """What pushes the nodes, with the viscous stress."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        z.sigma[j] -= z.radial[j]
        if hoops(geometry) > 0.0:
            z.hoop[j] += hoop_force(z.r[j], z.r[j + 1], z.radial[j], z.around[j], 0.0, geometry)


@zone_pass("r radial around inverse_mass sigma pull")
def pull_pass(count, z, dt, numbers, law):
    """The same of the leapfrog."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        z.sigma[j] -= z.radial[j]
        if hoops(geometry) > 0.0:
            dr = z.r[j + 1] - z.r[j]
            z.pull[j] += (z.radial[j] - z.around[j]) * dr * z.inverse_mass[j] * area_per_radius(z.r[j], z.r[j + 1], geometry)


@zone_pass("viscosity v c speed inverse_width found")
def hasten_pass(count, z, dt, numbers, law):
    """The largest signal rate with the physical viscosity, whose kinematic one over a zone's width is a speed."""
    rows_apart()
    ratio, bulk, fastest = numbers[0], numbers[1], z.found[FOUND_RATE]
    for j in range(count):
        along = ((4.0 / 3.0 + ratio) * z.viscosity[j] + bulk) * z.v[j] * z.inverse_width[j]
        fastest = fmax(fastest, (z.c[j] + 2.0 * z.speed[j] + EXTRAPOLATED * along) * z.inverse_width[j])
    z.found[FOUND_RATE] = fastest


@zone_pass("r inverse_mass viscosity v speed")
def slow_pass(count, z, dt, numbers, law):
    """That speed added to the artificial viscosity's, from which the leapfrog finds its step."""
    rows_apart()
    geometry, ratio, bulk = kind_of(law), numbers[0], numbers[1]
    for j in range(count):
        inverse_width = mean_area(z.r[j], z.r[j + 1], geometry) * z.inverse_mass[j] / z.v[j]
        z.speed[j] += ((4.0 / 3.0 + ratio) * z.viscosity[j] + bulk) * z.v[j] * inverse_width


@zone_pass("radial around strain hoop_strain v given")
def work_pass(count, z, dt, numbers, law):
    """Work of the viscous stresses over the strains of a step, J/kg."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        z.given[j] += z.v[j] * (z.radial[j] * z.strain[j] + hoops(geometry) * z.around[j] * z.hoop_strain[j])


# -- written into a step -----------------------------------------------------------------------------------------------
def acts(s) -> bool:
    """Whether a material has a physical viscosity; s: `zones.steps.MaterialSteps` with the rows of `plan`."""
    return s.at.transport is not None and s.at.transport.shear is not None


def _strained(s, geometry, rho, e, step):
    """Write the viscous stresses of the strains of a time `step`, at density and energy `rho`, `e`."""
    t, w = s.at.t, s.at.w
    find_viscosity(s, rho, e)
    s.do(friction_pass, (t.viscosity, w.radial, *strains(s, geometry), t.radial, t.around), step, numbers=s.at.bulk)


def rub_half(s, geometry, solid) -> None:
    """Write what viscosity adds to the stress in the middle of a step."""
    if acts(s):
        z, t = s.at.z, s.at.t
        _strained(s, geometry, solid, s.at.w.e, s.at.half)
        s.do(push_pass, (s.at.h.r_half, t.radial, t.around, z.sigma_half, z.hoop_half), kind=geometry)


def rub_end(s, geometry, solid) -> None:
    """Write what it adds to the stress at the end of a step, and to the signal rate."""
    if acts(s):
        z, t, w = s.at.z, s.at.t, s.at.w
        _strained(s, geometry, solid, z.e, s.at.whole)
        s.do(push_pass, (s.at.h.r, t.radial, t.around, z.sigma, z.hoop), kind=geometry)
        s.do(hasten_pass, (t.viscosity, w.v, z.c, z.viscous_speed, w.inverse_width, s.at.found), numbers=s.at.bulk)


def rub_leaping(s, geometry) -> None:
    """Write the leapfrog's viscous stress at n+1/2, its work and what it requires of the step; `rub_leapt` lets it pull the nodes."""
    if acts(s):
        z, h, t, w = s.at.z, s.at.h, s.at.t, s.at.w
        _strained(s, geometry, w.rho, z.e, s.at.whole)
        s.do(work_pass, (t.radial, t.around, w.radial, strains(s, geometry)[0], w.v_half, w.given), kind=geometry)
        s.do(slow_pass, (h.r, z.inverse_mass, t.viscosity, w.v, w.speed), kind=geometry, numbers=s.at.bulk)


def rub_leapt(s, geometry) -> None:
    """Write what the viscous stress adds to what moves the nodes next."""
    if acts(s):
        z, t = s.at.z, s.at.t
        s.do(pull_pass, (s.at.h.r, t.radial, t.around, z.inverse_mass, z.sigma, z.pull), kind=geometry)
