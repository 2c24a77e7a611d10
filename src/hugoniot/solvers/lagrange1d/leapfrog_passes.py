"""Passes of the leapfrog of Wilkins B.2: motion and strains of a step, its viscous pressure, and the stress at its end.

Source: Wilkins B.2 items 2 and 5 to 9; KB codes equations 1.8 to 1.11; the step and its corrections in `leapfrog`.
"""

from collections import namedtuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, vsqrt
from hugoniot.core.passes import kind_of, law_of, named, rows_apart, zone_pass
from hugoniot.mesh.line import area_per_radius, hoops, mean_area, volume
from hugoniot.zones.constants import Constants
from hugoniot.zones.soundness import FOUND_RATE, wave_speed
from hugoniot.zones.viscosity import resisted, resisting_speed, smoothness

SMALL = 1e-30
# weights of c2 and w2 in `signal_squared`; 4/9 is the Courant factor 2/3 of W-7 squared, which this limit does not need as well
SOUND_SHARE, VISCOUS_SHARE = 4.0 / 9.0 * (1.0 + 1.0 / 1.55), 4.0 / 9.0 * 5.5

MotionRows = namedtuple("MotionRows", "r u inverse_mass v_old v dv v_half rho_half rho radial hoop dilation squeeze")
TargetRows = namedtuple("TargetRows", "t1 t2 s1 s2 radial hoop v v_half dv rho_half c p squeeze smooth e q_old speed weak_speed q heat "
                        "target viscous_work")
BeforeRows = namedtuple("BeforeRows", "t1 t2 s1 s2 radial hoop v_half dv e q_old target")
StressRows = namedtuple("StressRows", "r inverse_mass rho v c2 shear t1 t2 p new_q speed weak_speed squeeze c s1 s2 q v_old sigma pull "
                        "width inverse_width found")
AtOnceRows = namedtuple("AtOnceRows", "r inverse_mass rho v dv c2 shear t1 t2 p squeeze c s1 s2 q v_old sigma pull width "
                        "inverse_width viscous_work constants found")
LookRows = namedtuple("LookRows", "r u node_mass mass smooth")
DampRows = namedtuple("DampRows", "smooth row")
ReliefRows = namedtuple("ReliefRows", "relief dv e")
MeanRows = namedtuple("MeanRows", "one other mean")
WorkRows = namedtuple("WorkRows", "target p_start p_end dv e")
NewtonRows = namedtuple("NewtonRows", "expected led dv p_e e p e_r e_p")


def signal_squared(c2, printed, viscous):
    """Square of the speed a step is found from: the step is 2/3 of a zone's width over it (W-7), m2/s2.

    c2        sound speed squared
    printed   b of W-7, 8 (C0^2 + CL) |du|, m/s
    viscous   w of q = rho |du| w, which acts on the nodes one step late

    Linear waves of the leapfrog with q a step late, of wave number k, go on by the roots of x^2 - (2 - n s - m^2 s) x + 1 - n s = 0,
    s = 4 sin^2(k dr/2), m = c dt/dr, n = w dt/dr. None is above 1 as long as m^2 + 2 n <= 1, which is dt <= dr/(w + root), root =
    sqrt(w^2 + c^2). Its square holds 2 w root, at most k w^2 + root^2/k for any k, so (w + root)^2 is at most (1 + 1/k) c^2 +
    (2 + k + 1/k) w^2, and no root has to be taken. k = 1.55 makes the two equal in a gas of 1.4 with CL = 1; with 5.5 for the 4.2 of the
    second bracket its step is 0.91 of the limit.
    """
    sound = fmax(c2, 0.0)
    return fmax(sound + printed * printed, SOUND_SHARE * sound + VISCOUS_SHARE * viscous * viscous)


def deviator_work(t1, t2, s1, s2, radial, hoop, v_half, geometry):
    """Work dZ of the deviators in a step, J/kg."""
    return v_half * 0.5 * ((t1 + s1) * radial + hoops(geometry) * (t2 + s2) * hoop)


bind(signal_squared)
bind(deviator_work)


# -- passes of the geometry ----------------------------------------------------------------------------------------
@zone_pass(MotionRows)
def whole_motion(count, z, dt, numbers, law):
    """Specific volume at n+1, its change, mean density and strains of the step."""
    rows_apart()
    geometry, two_sided = kind_of(law), named(Constants, numbers).two_sided > 0.0
    for j in range(count):
        u1, u2, r1, r2 = z.u[j], z.u[j + 1], z.r[j], z.r[j + 1]
        v = volume(r1, r2, geometry) * z.inverse_mass[j]
        dv, v_half = v - z.v_old[j], 0.5 * (v + z.v_old[j])
        rho_half = 1.0 / v_half
        du, dr = u2 - u1, r2 - r1
        radial = dv * rho_half     # dilation and radial strain are one number in planar flow
        if hoops(geometry) > 0.0:
            drift, stretch = dt * (u1 + u2), dt * du
            across_half, width_half = r1 + r2 - 0.5 * drift + SMALL, dr - 0.5 * stretch
            each = 1.0 / (across_half * width_half)     # one division for two
            z.dilation[j] = radial
            z.hoop[j] = drift * width_half * each
            radial = stretch * across_half * each
        z.radial[j] = radial
        z.v[j] = v
        z.dv[j] = dv
        z.v_half[j] = v_half
        z.rho_half[j] = rho_half
        z.rho[j] = 1.0 / v
        z.squeeze[j] = resisted(du, dv, two_sided)


@zone_pass(TargetRows)
def energy_target(count, z, dt, numbers, law):
    """Viscous pressure q at n+1/2, its heat, and the energy before the pressure has worked: e + dZ - qbar dv.

    `weak_speed` is that of the quadratic part alone at the end of the step. `law` is a `zones.viscosity.Resisting`; `smooth` is 0 but
    where the viscosity acts only as far as the velocity field is not smooth.
    """
    rows_apart()
    resisting = law_of(law, numbers)
    geometry = resisting.geometry
    for j in range(count):
        hoop = z.hoop[j] if hoops(geometry) > 0.0 else 0.0
        work = deviator_work(z.t1[j], z.t2[j], z.s1[j], z.s2[j], z.radial[j], hoop, z.v_half[j], geometry)
        squeeze, uneven = z.squeeze[j], 1.0 - z.smooth[j]
        speed = uneven * resisting_speed(z.v_half[j], z.c[j], z.p[j], squeeze, 0.0, resisting.law)
        q = -z.rho_half[j] * squeeze * speed
        heat = -0.5 * (q + z.q_old[j]) * z.dv[j]
        z.speed[j] = speed
        z.weak_speed[j] = uneven * resisting_speed(z.v[j], 0.0, 0.0, squeeze, 0.0, resisting.law)
        z.q[j] = q
        z.heat[j] = heat
        z.target[j] = z.e[j] + work + heat
        z.viscous_work[j] += heat


@zone_pass(BeforeRows)
def energy_before(count, z, dt, numbers, law):
    """e + dZ - q dv with the viscous pressure that moved the nodes (KB codes)."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        hoop = z.hoop[j] if hoops(geometry) > 0.0 else 0.0
        work = deviator_work(z.t1[j], z.t2[j], z.s1[j], z.s2[j], z.radial[j], hoop, z.v_half[j], geometry)
        z.target[j] = z.e[j] + work - z.q_old[j] * z.dv[j]


def keep_stress(z, j, q, geometry):
    """What pushes the nodes next, and what the next step looks back at."""
    t1, t2 = z.t1[j], z.t2[j]
    z.s1[j] = t1
    z.s2[j] = t2
    z.q[j] = q
    z.v_old[j] = z.v[j]
    z.sigma[j] = z.p[j] + q - t1
    if hoops(geometry) > 0.0:
        dr = z.r[j + 1] - z.r[j]
        z.pull[j] = (t1 - t2) * dr * z.inverse_mass[j] * area_per_radius(z.r[j], z.r[j + 1], geometry)
        z.width[j] = z.rho[j] * dr


@zone_pass(StressRows)
def end_stress(count, z, dt, numbers, law):
    """Sound speed and stress at n+1; the largest signal rate, 1/s."""
    rows_apart()
    geometry, constants, fastest = kind_of(law), named(Constants, numbers), 0.0
    for j in range(count):
        q, c2 = z.new_q[j], z.c2[j] + (4.0 / 3.0) * z.shear[j] * z.v[j]
        b2 = 8.0 * (z.weak_speed[j] + fmax(z.squeeze[j], -z.squeeze[j]))
        inverse_width = mean_area(z.r[j], z.r[j + 1], geometry) * z.inverse_mass[j] * z.rho[j]     # without a division
        signal = signal_squared(fmax(c2, constants.front * constants.front), b2, z.speed[j])
        fastest = fmax(fastest, signal * (inverse_width * inverse_width))
        z.inverse_width[j] = inverse_width
        z.c[j] = wave_speed(c2, constants.noise)
        keep_stress(z, j, q, geometry)
    z.found[FOUND_RATE] = fmax(z.found[FOUND_RATE], vsqrt(fastest))


@zone_pass(AtOnceRows)
def end_stress_at_once(count, z, dt, numbers, law):
    """The same of the KB codes' step: its viscous pressure is that of n+1. `law` is a `zones.viscosity.Resisting`."""
    rows_apart()
    resisting, constants, fastest = law_of(law, numbers), named(Constants, z.constants), z.found[FOUND_RATE]
    for j in range(count):
        v, squeeze = z.v[j], z.squeeze[j]
        speed = resisting_speed(v, z.c[j], z.p[j], squeeze, 0.0, resisting.law)
        q, c2 = -z.rho[j] * squeeze * speed, z.c2[j] + (4.0 / 3.0) * z.shear[j] * v
        c, inverse_width = wave_speed(c2, constants.noise), 1.0 / (z.r[j + 1] - z.r[j])
        fastest = fmax(fastest, (c + 4.0 * speed) * inverse_width)
        z.inverse_width[j] = inverse_width
        z.c[j] = c
        z.viscous_work[j] -= z.q[j] * z.dv[j]
        keep_stress(z, j, q, resisting.geometry)
    z.found[FOUND_RATE] = fastest


@zone_pass(LookRows)
def look_around(count, z, dt, numbers, law):
    """Smoothness of the velocity field in every zone; beyond an end of its body the field goes on as inside."""
    rows_apart()
    for j in range(count):
        own = (z.u[j + 1] - z.u[j]) / (z.r[j + 1] - z.r[j])
        # the node at an end of a body has the half of one zone
        left = own if z.node_mass[j] == 0.5 * z.mass[j] else (z.u[j] - z.u[j - 1]) / (z.r[j] - z.r[j - 1])
        right = own if z.node_mass[j + 1] == 0.5 * z.mass[j] else (z.u[j + 2] - z.u[j + 1]) / (z.r[j + 2] - z.r[j + 1])
        z.smooth[j] = smoothness(left, own, right)


@zone_pass(DampRows)
def damp(count, z, dt, numbers, law):
    """A row of the viscosity as far as the velocity field is not smooth."""
    rows_apart()
    for j in range(count):
        z.row[j] *= 1.0 - z.smooth[j]


@zone_pass(ReliefRows)
def take_relief(count, z, dt, numbers, law):
    """The energy that the relieved part of the pressure did not give."""
    rows_apart()
    for j in range(count):
        z.e[j] -= 0.5 * z.relief[j] * z.dv[j]


@zone_pass(MeanRows)
def mean(count, z, dt, numbers, law):
    """Mean of two rows."""
    rows_apart()
    for j in range(count):
        z.mean[j] = 0.5 * (z.one[j] + z.other[j])


@zone_pass(WorkRows)
def after_work(count, z, dt, numbers, law):
    """Energy after the work of the mean pressure."""
    rows_apart()
    for j in range(count):
        z.e[j] = z.target[j] - 0.5 * (z.p_start[j] + z.p_end[j]) * z.dv[j]


@zone_pass(NewtonRows)
def newton_step(count, z, dt, numbers, law):
    """From the pressure expected, p', and the one it led to, p'', to that which agrees with its own work."""
    rows_apart()
    for j in range(count):
        rest = 0.5 * (z.expected[j] - z.led[j]) * z.dv[j] / (1.0 + 0.5 * z.p_e[j] * z.dv[j])
        z.e[j] += rest
        z.p[j] = z.led[j] + z.p_e[j] * rest
        z.e_r[j] += rest
        z.e_p[j] += rest


bind(keep_stress)
