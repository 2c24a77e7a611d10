"""Passes of the leapfrog of Wilkins B.2: motion and strains of a step, its viscous pressure, and the stress at its end.

Source: Wilkins B.2 items 2 and 5 to 9; KB codes equations 1.8 to 1.11; the step and its corrections in `leapfrog`.
"""

from hugoniot.core.binder import bind
from hugoniot.core.mathematics import NAN_LAW
from hugoniot.core.ops import fmax, vsqrt
from hugoniot.core.passes import kind_of, law_of, named, rows_apart, zone_pass
from hugoniot.mesh.line import area_per_radius, hoops, mean_area, volume
from hugoniot.solvers.lagrange1d.stress import strained
from hugoniot.zones.constants import Constants
from hugoniot.zones.soundness import FOUND_RATE, PeakRows, keep_peaks, new_peaks, unsound, wave_speed
from hugoniot.zones.strength import Solid
from hugoniot.zones.viscosity import resisted, resisting_speed, smoothness

SMALL = 1e-30
# weights of c2 and w2 in `signal_squared`; 4/9 is the Courant factor 2/3 of W-7 squared, which this limit does not need as well
SOUND_SHARE, VISCOUS_SHARE = 4.0 / 9.0 * (1.0 + 1.0 / 1.55), 4.0 / 9.0 * 5.5


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


# -- passes of the geometry ----------------------------------------------------------------------------------------
@zone_pass("r u inverse_mass c p smooth v q viscous_work dv v_half rho_half rho radial hoop dilation speed printed given")
def whole_motion(count, z, dt, numbers, law):
    """Specific volume at n+1, its change, mean density and strains of the step; viscous pressure q at n+1/2, and its heat into `given`.

    `printed` is b of `signal_squared`. `law` is a `zones.viscosity.Resisting`; `smooth` is 0 but where the viscosity acts only as far as
    the velocity field is not smooth.
    """
    rows_apart()
    resisting = law_of(law, numbers)
    geometry = resisting.geometry
    for j in range(count):
        u1, u2, r1, r2 = z.u[j], z.u[j + 1], z.r[j], z.r[j + 1]
        v, v_old = volume(r1, r2, geometry) * z.inverse_mass[j], z.v[j]
        dv, v_half = v - v_old, 0.5 * (v + v_old)
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
        squeeze, uneven = resisted(du, dv, resisting.law), 1.0 - z.smooth[j]
        speed = uneven * resisting_speed(v_half, z.c[j], z.p[j], squeeze, 0.0, resisting.law)
        q = -rho_half * squeeze * speed
        heat = -0.5 * (q + z.q[j]) * dv
        z.radial[j] = radial
        z.v[j] = v
        z.dv[j] = dv
        z.v_half[j] = v_half
        z.rho_half[j] = rho_half
        z.rho[j] = 1.0 / v
        z.speed[j] = speed
        # with the speed of the quadratic part alone, at the end of the step
        z.printed[j] = 8.0 * uneven * (resisting_speed(v, 0.0, 0.0, squeeze, 0.0, resisting.law) + fmax(squeeze, -squeeze))
        z.q[j] = q
        z.given[j] = heat
        z.viscous_work[j] += heat


@zone_pass("solid s1 s2 radial hoop dilation v_half shear limit flow given", solid=Solid)
def strain_and_work(count, z, dt, numbers, law):
    """Deviators at n+1 and their work dZ, added to `given`; `law` is a `zones.strength.Strong`."""
    rows_apart()
    strong = law_of(law, numbers)
    geometry = strong.geometry
    for j in range(count):
        s1, s2, radial = z.s1[j], z.s2[j], z.radial[j]
        t1, t2, shear, limit, flow = strained(z, j, dt, strong)
        hoop = z.hoop[j] if hoops(geometry) > 0.0 else 0.0
        z.given[j] += z.v_half[j] * 0.5 * ((t1 + s1) * radial + hoops(geometry) * (t2 + s2) * hoop)
        z.s1[j] = t1
        z.s2[j] = t2
        z.shear[j] = shear
        z.limit[j] = limit
        z.flow[j] = flow


@zone_pass("q dv given viscous_work")
def heat_before(count, z, dt, numbers, law):
    """The heat of the viscous pressure that moved the nodes in the place of that of the step (KB codes)."""
    rows_apart()
    for j in range(count):
        heat = -z.q[j] * z.dv[j]
        z.viscous_work[j] += heat - z.given[j]
        z.given[j] = heat


def keep_stress(z, j, q, geometry):
    """What pushes the nodes next."""
    t1, t2 = z.s1[j], z.s2[j]
    z.seen.sigma[j] = z.seen.p[j] + q - t1
    if hoops(geometry) > 0.0:
        dr = z.r[j + 1] - z.r[j]
        z.pull[j] = (t1 - t2) * dr * z.inverse_mass[j] * area_per_radius(z.r[j], z.r[j + 1], geometry)
        z.width[j] = z.seen.rho[j] * dr


def stand(z, j, geometry, constants):
    """Sound speed and stress of a zone at n+1; the square of its signal rate, 1/s2."""
    c2 = z.c2[j] + (4.0 / 3.0) * z.shear[j] * z.v[j]
    inverse_width = mean_area(z.r[j], z.r[j + 1], geometry) * z.inverse_mass[j] * z.seen.rho[j]     # without a division
    z.inverse_width[j] = inverse_width
    z.seen.c[j] = wave_speed(c2, constants.noise)
    keep_stress(z, j, z.q[j], geometry)
    return signal_squared(fmax(c2, constants.front * constants.front), z.printed[j], z.speed[j]) * (inverse_width * inverse_width)


@zone_pass("r inverse_mass v c2 shear s1 s2 q speed printed pull width inverse_width seen", seen=PeakRows)
def end_stress(count, z, dt, numbers, law):
    """Sound speed and stress at n+1, to which something will be added; the largest signal rate, 1/s; `seen` as in `compatible`."""
    rows_apart()
    geometry, constants, fastest = kind_of(law), named(Constants, numbers), 0.0
    for j in range(count):
        fastest = fmax(fastest, stand(z, j, geometry, constants))
    z.seen.found[FOUND_RATE] = fmax(z.seen.found[FOUND_RATE], vsqrt(fastest))


@zone_pass(end_stress.rows, finite=False)
def end_stress_seen(count, z, dt, numbers, law):
    """The same where nothing will, checked at once (`zones.soundness.look_over`)."""
    rows_apart()
    geometry, constants, fastest = kind_of(law), named(Constants, numbers), 0.0
    bad = new = 0
    for j in range(count):
        fastest = fmax(fastest, stand(z, j, geometry, constants))
        bad += unsound(z.seen, j)
        new += new_peaks(z.seen, j)
    z.seen.found[FOUND_RATE] = fmax(z.seen.found[FOUND_RATE], vsqrt(fastest))
    keep_peaks(count, z.seen, bad, new)


@zone_pass("r u inverse_mass v dv c2 shear s1 s2 q pull width inverse_width constants seen", seen=PeakRows)
def end_stress_at_once(count, z, dt, numbers, law):
    """The same of the KB codes' step: its viscous pressure is that of n+1. `law` is a `zones.viscosity.Resisting`."""
    rows_apart()
    resisting, constants, fastest = law_of(law, numbers), named(Constants, z.constants), z.seen.found[FOUND_RATE]
    for j in range(count):
        v, squeeze = z.v[j], resisted(z.u[j + 1] - z.u[j], z.dv[j], resisting.law)
        speed = resisting_speed(v, z.seen.c[j], z.seen.p[j], squeeze, 0.0, resisting.law)
        q, c2 = -z.seen.rho[j] * squeeze * speed, z.c2[j] + (4.0 / 3.0) * z.shear[j] * v
        c, inverse_width = wave_speed(c2, constants.noise), 1.0 / (z.r[j + 1] - z.r[j])
        fastest = fmax(fastest, (c + 4.0 * speed) * inverse_width)
        z.inverse_width[j] = inverse_width
        z.seen.c[j] = c
        z.q[j] = q
        keep_stress(z, j, q, resisting.geometry)
    z.seen.found[FOUND_RATE] = fastest


@zone_pass("r u node_mass mass smooth")
def look_around(count, z, dt, numbers, law):
    """Smoothness of the velocity field in every zone; beyond an end of its body the field is continued from inside."""
    rows_apart()
    for j in range(count):
        own = (z.u[j + 1] - z.u[j]) / (z.r[j + 1] - z.r[j])
        # the node at an end of a body has the half of one zone
        left = own if z.node_mass[j] == 0.5 * z.mass[j] else (z.u[j] - z.u[j - 1]) / (z.r[j] - z.r[j - 1])
        right = own if z.node_mass[j + 1] == 0.5 * z.mass[j] else (z.u[j + 2] - z.u[j + 1]) / (z.r[j + 2] - z.r[j + 1])
        z.smooth[j] = smoothness(left, own, right)


@zone_pass("relief dv e")
def take_relief(count, z, dt, numbers, law):
    """The energy that the relieved part of the pressure did not give."""
    rows_apart()
    for j in range(count):
        z.e[j] -= 0.5 * z.relief[j] * z.dv[j]


@zone_pass("one other mean")
def mean(count, z, dt, numbers, law):
    """Mean of two rows."""
    rows_apart()
    for j in range(count):
        z.mean[j] = 0.5 * (z.one[j] + z.other[j])


@zone_pass("target p_start p_end dv e")
def after_work(count, z, dt, numbers, law):
    """Energy after the work of the mean pressure."""
    rows_apart()
    for j in range(count):
        z.e[j] = z.target[j] - 0.5 * (z.p_start[j] + z.p_end[j]) * z.dv[j]


@zone_pass("expected led dv p_e e p e_r e_p")
def newton_step(count, z, dt, numbers, law):
    """From the pressure expected, p', and the one it led to, p'', to that which agrees with its own work."""
    rows_apart()
    for j in range(count):
        rest = 0.5 * (z.expected[j] - z.led[j]) * z.dv[j] / (1.0 + 0.5 * z.p_e[j] * z.dv[j])
        z.e[j] += rest
        z.p[j] = z.led[j] + z.p_e[j] * rest
        z.e_r[j] += rest
        z.e_p[j] += rest


bind(keep_stress, **NAN_LAW)
bind(stand, **NAN_LAW)
