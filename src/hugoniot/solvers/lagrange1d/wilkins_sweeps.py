"""Sweeps of the `wilkins` integrator: the leapfrog of Wilkins B.2, with its own energy equation.

Corrections and readings: |dU/dr| in q (W-E3); stresses at j+-1/2 (W-E5); the pressure and energy solved together, exactly
for laws linear in the energy (B.2 item 8, W-11) and by Newton otherwise; dZ included (J-E12); the Courant step with the
elastic sound speed (W-E4), and with the limit of the linear viscosity that W-7 leaves out (`signal_squared`).
"""

import numba as nb

from hugoniot.core.compile import GUARD, SWEEP, bind, bind_choice, parameters, rows_apart
from hugoniot.core.ops import fmax, late_over, vsqrt
from hugoniot.laws.eos.contract import EOS, compacted, pressure, pressure_derivatives, remembered, unloading
from hugoniot.laws.fracture.contract import damage_rate, failure
from hugoniot.laws.strength.contract import shear_modulus
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.mesh.line import area_per_radius, hoops, mean_area, volume
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.constitutive import (
    fails,
    flow_beside_voids,
    grows_voids,
    hoop_deviator,
    no,
    radial_return,
    remembers,
    resisted,
    strain_base,
    strain_rate,
    strength_temperature,
    trial_deviators,
    void_change,
    von_mises,
    wave_speed,
    yes,
    yield_at,
)
from hugoniot.solvers.lagrange1d.node_sweeps import outside_stress, pulse_value

SMALL = 1e-30
# weights of c2 and w2 in `signal_squared`; 4/9 is the Courant factor 2/3 of W-7 squared, which this limit does not need as well
SOUND_SHARE, VISCOUS_SHARE = 4.0 / 9.0 * (1.0 + 1.0 / 1.55), 4.0 / 9.0 * 5.5


@nb.njit(**SWEEP)
def leap(zones, nodes, first, last, segment, dt, dt_mean, geometry):
    """Inner nodes: velocity to n+1/2 and position to n+1 (B.2 item 2)."""
    a, b = first + segment, last + segment
    r, u, im = nodes[L.R, a + 1:b], nodes[L.U, a + 1:b], nodes[L.INVERSE_NODE_MASS, a + 1:b]
    sigma = zones[L.SIGMA, first:last]
    if hoops(geometry) == 0.0:
        for j in range(r.shape[0]):
            new = u[j] + dt_mean * (sigma[j] - sigma[j + 1]) * im[j]
            u[j] = new
            r[j] += dt * new
    else:
        force, width = zones[L.HOOP, first:last], zones[L.OLD, first:last]
        for j in range(r.shape[0]):
            phi = 0.5 * (width[j] + width[j + 1])
            beta = 0.5 * (force[j] + force[j + 1])
            new = u[j] + dt_mean * ((sigma[j] - sigma[j + 1]) / phi + beta * hoops(geometry))
            u[j] = new
            r[j] += dt * new


@nb.njit(**GUARD)
def end_inverse_mass(zones, nodes, ends, geometry):
    """Acceleration of a segment's end per stress (B.3), m2/kg."""
    node, zone, _ = ends
    return nodes[L.INVERSE_NODE_MASS, node] if hoops(geometry) == 0.0 else 1.0 / (0.5 * zones[L.OLD, zone])


@nb.njit(**GUARD)
def end_acceleration(zones, nodes, ends, left, outside, geometry):
    """Acceleration of a segment's end under an outside stress (B.3)."""
    _, zone, _ = ends
    push = (outside - zones[L.SIGMA, zone]) if left else (zones[L.SIGMA, zone] - outside)
    acceleration = push * end_inverse_mass(zones, nodes, ends, geometry)
    return acceleration if hoops(geometry) == 0.0 else acceleration + zones[L.HOOP, zone] * hoops(geometry)


@nb.njit(**GUARD)
def leap_end(zones, nodes, control, ends, left, dt, dt_mean, boundary, geometry):
    """One end of a segment: acceleration under the outside stress, or the prescribed velocity.

    A transmitting end answers with the impedance rho c of the zone inside, taken at the mean of the old and the new velocity: with the old
    one alone round-off grows.
    """
    node, zone, code = ends
    pulse, table = boundary
    sign = -1.0 if left else 1.0
    u, time = nodes[L.U, node], control[L.TIME]
    reference = control[L.REFERENCE_LEFT] if left else control[L.REFERENCE_RIGHT]
    outside = outside_stress(code, time, reference, pulse, table)
    if code == L.FIXED:
        new = 0.0
    elif code == L.VELOCITY:
        new = pulse_value(time + 0.5 * dt, pulse, table)
    else:
        impedance = zones[L.RHO, zone] * zones[L.C, zone] if code == L.TRANSMITTING else 0.0
        weight = 0.5 * dt_mean * end_inverse_mass(zones, nodes, ends, geometry) * impedance
        new = (u * (1.0 - weight) + dt_mean * end_acceleration(zones, nodes, ends, left, outside, geometry)) / (1.0 + weight)
        outside += sign * impedance * 0.5 * (u + new)
    face = nodes[L.R, node] ** hoops(geometry)
    nodes[L.U, node] = new
    nodes[L.R, node] += dt * new
    mass = nodes[L.NODE_MASS, node]
    if code == L.FIXED or code == L.VELOCITY:
        outer = mass * (new - u) / dt_mean - mass * end_acceleration(zones, nodes, ends, left, 0.0, geometry)
    else:
        outer = -sign * face * outside
    work, impulse = (L.WORK_LEFT, L.IMPULSE_LEFT) if left else (L.WORK_RIGHT, L.IMPULSE_RIGHT)
    control[work] += dt * outer * new
    control[impulse] += dt_mean * outer


def linear_in_energy(eos):
    """Whether p = A(rho) + B(rho) e, so that one Newton step solves the energy equation exactly."""
    return "linear_in_energy" in EOS.of(eos).flags


bind_choice(linear_in_energy, lambda cls: yes if "linear_in_energy" in EOS.of_class(cls).flags else no)


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


bind(signal_squared)


@nb.njit(**SWEEP)
def advance(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """State of a run of zones at n+1; `found` takes the largest signal rate (1/s), failure ratio, 0, capped zones."""
    a, b = first + segment, last + segment
    advance_zones(
        nodes[L.R, a:b + 1], nodes[L.U, a:b + 1], zones[L.INVERSE_MASS, first:last], zones[L.RHO, first:last], zones[L.E, first:last],
        zones[L.P, first:last], zones[L.C, first:last], zones[L.S1, first:last], zones[L.S2, first:last],
        zones[L.PLASTIC_STRAIN, first:last], zones[L.DAMAGE, first:last], zones[L.SIGMA, first:last], zones[L.Q, first:last],
        zones[L.FAILURE, first:last], zones[L.HOOP, first:last], zones[L.OLD, first:last], zones[L.SIGMA_HALF, first:last],
        zones[L.PLASTIC_WORK, first:last], zones[L.VISCOUS_WORK, first:last], zones[L.VOIDS, first:last],
        zones[L.COMPACTION, first:last], dt, law, rows, geometry, found)


@nb.njit(**SWEEP)
def advance_zones(r, u, im, rho_, e_, p_, c_, s1, s2, eps, hurt, sigma, q_, torn, force, width, old, plastic, viscous, voids, pores,
                  dt, law, rows, geometry, found):
    """`advance` over rows of the tables."""
    rows_apart()
    eos = parameters(law[0], rows[0])
    strength = parameters(law[1], rows[1])
    fracture = parameters(law[2], rows[2])
    viscosity = parameters(law[3], rows[3])
    rho0, noise = rows[4][0], rows[4][1]
    fastest, worst, capped = 0.0, 0.0, 0.0
    for j in range(im.shape[0]):
        u1, u2, r1, r2 = u[j], u[j + 1], r[j], r[j + 1]
        v_old = old[j]
        v = volume(r1, r2, geometry) * im[j]
        dv, v_half = v - v_old, 0.5 * (v + v_old)
        density, rho_half = 1.0 / v, 1.0 / v_half
        rho = density
        if grows_voids(fracture):
            rho = 1.0 / (v - voids[j])
        du, dr = u2 - u1, r2 - r1
        dilation = dv * rho_half
        radial, hoop = dilation, 0.0     # dilation and radial strain are one number in planar flow
        if hoops(geometry) > 0.0:
            drift, stretch = dt * (u1 + u2), dt * du
            across_half, width_half = r1 + r2 - 0.5 * drift + SMALL, dr - 0.5 * stretch
            each = 1.0 / (across_half * width_half)     # one division for two
            radial, hoop = stretch * across_half * each, drift * width_half * each
        crushed = remembered(pores[j], eos)
        p_rho, p_e = pressure_derivatives(rho, e_[j], unloading(crushed))
        heat = strength_temperature(rho, e_[j], crushed, strength)
        shear = shear_modulus(rho, p_[j], heat, rho * p_rho + p_[j] * p_e * v, strength)
        t1, t2 = trial_deviators(s1[j], hoop_deviator(s1[j], s2[j], geometry), radial, hoop, dilation, shear)
        pace = strain_rate(radial, hoop, dilation, dt, geometry, strength)
        limit, flow = yield_at(von_mises(t1, t2, geometry), shear, (rho, p_[j], heat, pace), eps[j], strength)
        t1, t2 = radial_return(t1, t2, limit, geometry)
        work = v_half * 0.5 * ((t1 + s1[j]) * radial + hoops(geometry) * (t2 + hoop_deviator(s1[j], s2[j], geometry)) * hoop)
        squeeze = resisted(du, dv, viscosity)
        # the P of a = sqrt(P/rho) is the one at the start of the step: q stands at n+1/2
        speed = viscous_speed(v_half, c_[j], p_[j], squeeze, 0.0, viscosity)
        q = -rho_half * squeeze * speed
        target = e_[j] + work - 0.5 * (p_[j] + q + q_[j]) * dv
        if linear_in_energy(eos):
            energy = late_over(target - 0.5 * pressure(rho, 0.0, crushed) * dv, 1.0 + 0.5 * p_e * dv)
        else:
            energy = target - 0.5 * p_[j] * dv
            for _ in range(4):
                _, slope = pressure_derivatives(rho, energy, crushed)
                miss = energy - target + 0.5 * pressure(rho, energy, crushed) * dv
                energy -= miss / (1.0 + 0.5 * slope * dv)
        p = pressure(rho, energy, crushed)
        if remembers(eos):
            pores[j] = compacted(pores[j], rho, energy, p, eos)
        p_rho, p_e = pressure_derivatives(rho, energy, unloading(remembered(pores[j], eos)))
        tension = t1 - p
        hurt_now = hurt[j] + dt * damage_rate(tension, fracture)
        ratio = failure(tension, p, strain_base(rho0, pores[j], eos) * v, hurt_now, fracture)
        bulk2 = p_rho + p * p_e * v * v
        if grows_voids(fracture):
            bulk2 = p_rho + p * p_e / (rho * rho)
            grown, relief = void_change(tension, rho * rho * bulk2, voids[j], rho, fracture)
            voids[j] += grown
            flow = flow_beside_voids(flow, grown, rho)
            p += relief
            energy -= 0.5 * relief * dv
            capped += 1.0 if relief > 0.0 else 0.0
        c2 = bulk2 + (4.0 / 3.0) * shear * v
        b2 = 8.0 * (viscous_speed(v, 0.0, 0.0, squeeze, 0.0, viscosity) + fmax(squeeze, -squeeze))
        inverse = mean_area(r1, r2, geometry) * im[j] * density     # 1/dr without a division
        fastest = fmax(fastest, signal_squared(c2, b2, speed) * (inverse * inverse))
        worst = fmax(worst, ratio)
        rho_[j] = density
        e_[j] = energy
        p_[j] = p
        c_[j] = wave_speed(c2, noise)
        s1[j] = t1
        if hoops(geometry) == 1.0:
            s2[j] = t2
        plastic[j] += limit * flow * v_half
        eps[j] += flow
        viscous[j] -= 0.5 * (q + q_[j]) * dv
        q_[j] = q
        old[j] = v
        if fails(fracture):
            hurt[j] = hurt_now
            torn[j] = ratio
        sigma[j] = p + q - t1
        if hoops(geometry) > 0.0:
            force[j] = (t1 - t2) * dr * im[j] * area_per_radius(r1, r2, geometry)
            width[j] = density * dr
    found[0], found[1], found[2], found[3] = vsqrt(fastest), worst, 0.0, capped
