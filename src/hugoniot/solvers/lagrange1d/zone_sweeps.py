"""Sweeps over a run of zones of one material for the compatible integrator (predictor and corrector).

Forces are the transpose of the strain rates: with the volume rate A2 u2 - A1 u1 and the hoop rate (u1+u2)/(r1+r2), the power
put into a zone is -sigma (A2 u2 - A1 u1) + H (u1 + u2), sigma = p + q - s1, H = (d-1) V (s2 + q - s1)/(r1 + r2), and the force
on a node is minus its derivative by that node's velocity. Work and force use the same numbers, so the energy a zone gains is
the kinetic energy its nodes lose, to round-off, in every geometry.

The artificial viscosity is uniaxial: q resists the radial closing alone, with the power -q V (radial rate), and not the hoop
convergence of a flow that narrows towards the axis, which is no shock (Schulz, Methods Comput. Phys. 3 (1964) 1; Noh, J. Comput.
Phys. 72 (1987) 78). Hence the q in H: it takes away what sigma, which multiplies the whole volume rate, has too much.
"""

import numba as nb

from hugoniot.core.compile import INLINE, SWEEP, parameters, rows_apart
from hugoniot.core.ops import fmax, fmin
from hugoniot.laws.eos.contract import compacted, pressure, pressure_derivatives, remembered, unloading
from hugoniot.laws.fracture.contract import damage_rate, failure
from hugoniot.laws.strength.contract import shear_modulus
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.mesh.line import area, area_per_radius, hoops, mean_area, volume
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.constitutive import (
    fails,
    flow_beside_voids,
    grows_voids,
    hoop_deviator,
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
    yield_at,
)

SMALL = 1e-30


@nb.njit(**SWEEP)
def predict(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """Stress in the middle of the step, from the state at its start and the predicted mean velocity."""
    a, b = first + segment, last + segment
    predict_zones(
        nodes[L.R_HALF, a:b + 1], nodes[L.U_MEAN, a:b + 1], gradient[first + 2 * segment:last + 2 * segment + 2],
        zones[L.INVERSE_MASS, first:last], zones[L.E, first:last], zones[L.C, first:last], zones[L.S1, first:last],
        zones[L.S2, first:last], zones[L.PLASTIC_STRAIN, first:last], zones[L.SIGMA, first:last], zones[L.HOOP, first:last],
        zones[L.Q, first:last], zones[L.VISCOUS_SPEED, first:last], zones[L.SIGMA_HALF, first:last], zones[L.HOOP_HALF, first:last],
        zones[L.VOIDS, first:last], zones[L.COMPACTION, first:last], dt, law, rows, geometry)


@nb.njit(**SWEEP)
def predict_zones(rh, u, g, im, e, c, s1, s2, eps, sigma, hoop_force, q_out, speed_out, sigma_half, hoop_half, voids, pores,
                  dt, law, rows, geometry):
    """`predict` over rows of the tables."""
    rows_apart()
    eos = parameters(law[0], rows[0])
    strength = parameters(law[1], rows[1])
    fracture = parameters(law[2], rows[2])
    viscosity = parameters(law[3], rows[3])
    half = 0.5 * dt
    for j in range(im.shape[0]):
        r1, r2, u1, u2 = rh[j], rh[j + 1], u[j], u[j + 1]
        rate = area(r2, geometry) * u2 - area(r1, geometry) * u1
        size = volume(r1, r2, geometry)
        v = size * im[j]
        density = 1.0 / v
        rho = density
        if grows_voids(fracture):
            rho = 1.0 / (v - voids[j])
        power = -sigma[j] * rate
        if hoops(geometry) > 0.0:
            power += hoop_force[j] * (u1 + u2)
        energy = e[j] + half * im[j] * power
        crushed = remembered(pores[j], eos)
        p = pressure(rho, energy, crushed)
        dilation = half * rate * (im[j] * density)
        hoop = 0.0
        if hoops(geometry) > 0.0:
            hoop = half * (u1 + u2) / (r1 + r2 + SMALL)
        radial = dilation - hoops(geometry) * hoop
        p_rho, p_e = pressure_derivatives(rho, energy, unloading(crushed))
        bulk = rho * p_rho + p * p_e / rho
        heat = strength_temperature(rho, energy, crushed, strength)
        shear = shear_modulus(rho, p, heat, bulk, strength)
        t1, t2 = trial_deviators(s1[j], hoop_deviator(s1[j], s2[j], geometry), radial, hoop, dilation, shear)
        pace = strain_rate(radial, hoop, dilation, half, geometry, strength)
        limit, _ = yield_at(von_mises(t1, t2, geometry), shear, (rho, p, heat, pace), eps[j], strength)
        t1, t2 = radial_return(t1, t2, limit, geometry)
        if grows_voids(fracture):
            p += void_change(t1 - p, rho * bulk, voids[j], rho, fracture)[1]
        du = u2 - u1
        # smoothness of the velocity field (Caramana, Shashkov and Whalen 1998, J. Comput. Phys. 144, 70): ratios of the
        # neighbours' gradients to this one; 1 in a linear field, 0 at a shock or an extremum
        steep = -g[j + 1]
        left, right = -g[j], -g[j + 2]
        smooth = fmax(0.0, fmin(fmin(0.5 * (left + right), steep), 2.0 * fmin(left, right)))
        psi = fmin(smooth / (fmax(steep, 0.0) + SMALL), 1.0)
        squeeze = resisted(du, radial if hoops(geometry) > 0.0 else du, viscosity)
        speed = viscous_speed(v, c[j], p, squeeze, psi, viscosity)
        q = -rho * squeeze * speed
        q_out[j] = q
        speed_out[j] = speed if squeeze != 0.0 else 0.0
        sigma_half[j] = p + q - t1
        if hoops(geometry) > 0.0:
            hoop_half[j] = 0.5 * hoops(geometry) * (r2 - r1) * area_per_radius(r1, r2, geometry) * (t2 + q - t1)


@nb.njit(**SWEEP)
def correct(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """State at the end of the step; `found` takes the largest signal rate (1/s), failure ratio, geometric impulse, capped zones."""
    a, b = first + segment, last + segment
    correct_zones(
        nodes[L.R, a:b + 1], nodes[L.R_HALF, a:b + 1], nodes[L.U_MEAN, a:b + 1], nodes[L.U, a:b + 1],
        gradient[first + 2 * segment + 1:last + 2 * segment + 1], zones[L.INVERSE_MASS, first:last],
        zones[L.RHO, first:last], zones[L.E, first:last], zones[L.P, first:last], zones[L.C, first:last], zones[L.S1, first:last],
        zones[L.S2, first:last], zones[L.PLASTIC_STRAIN, first:last], zones[L.DAMAGE, first:last], zones[L.SIGMA, first:last],
        zones[L.HOOP, first:last], zones[L.Q, first:last], zones[L.VISCOUS_SPEED, first:last], zones[L.FAILURE, first:last],
        zones[L.SIGMA_HALF, first:last], zones[L.HOOP_HALF, first:last], zones[L.PLASTIC_WORK, first:last],
        zones[L.VISCOUS_WORK, first:last], zones[L.VOIDS, first:last], zones[L.COMPACTION, first:last], dt, law, rows, geometry, found)


@nb.njit(**SWEEP)
def correct_zones(r, rh, u, ue, g, im, rho_, e_, p_, c_, s1, s2, eps, hurt, sigma, hoop_force, q, speed, torn, sigma_half, hoop_half,
                  plastic, viscous, voids, pores, dt, law, rows, geometry, found):
    """`correct` over rows of the tables."""
    rows_apart()
    eos = parameters(law[0], rows[0])
    strength = parameters(law[1], rows[1])
    fracture = parameters(law[2], rows[2])
    rho0, noise = rows[4][0], rows[4][1]
    fastest, worst, radial_impulse, capped = 0.0, 0.0, 0.0, 0.0
    for j in range(im.shape[0]):
        u1, u2, r1, r2 = u[j], u[j + 1], rh[j], rh[j + 1]
        rate = area(r2, geometry) * u2 - area(r1, geometry) * u1
        size = volume(r1, r2, geometry)
        power = -sigma_half[j] * rate
        if hoops(geometry) > 0.0:
            power += hoop_half[j] * (u1 + u2)
            radial_impulse += sigma_half[j] * (area(r2, geometry) - area(r1, geometry)) - 2.0 * hoop_half[j]
        energy = e_[j] + dt * im[j] * power
        dilation = dt * rate / size
        hoop, closing = 0.0, rate
        if hoops(geometry) > 0.0:
            turn = (u1 + u2) / (r1 + r2 + SMALL)
            hoop, closing = dt * turn, rate - hoops(geometry) * size * turn
        radial = dilation - hoops(geometry) * hoop
        end_size = volume(r[j], r[j + 1], geometry)
        v = end_size * im[j]
        density = 1.0 / v
        rho, solid = density, v
        if grows_voids(fracture):
            solid = v - voids[j]
            rho = 1.0 / solid
        crushed = remembered(pores[j], eos)
        p = pressure(rho, energy, crushed)
        if remembers(eos):
            pores[j] = compacted(pores[j], rho, energy, p, eos)
        # sound is elastic: a release outruns the wave that crushes
        p_rho, p_e = pressure_derivatives(rho, energy, unloading(remembered(pores[j], eos)))
        c2 = p_rho + p * p_e / (rho * rho)
        heat = strength_temperature(rho, energy, crushed, strength)
        shear = shear_modulus(rho, p, heat, rho * c2, strength)
        t1, t2 = trial_deviators(s1[j], hoop_deviator(s1[j], s2[j], geometry), radial, hoop, dilation, shear)
        pace = strain_rate(radial, hoop, dilation, dt, geometry, strength)
        limit, flow = yield_at(von_mises(t1, t2, geometry), shear, (rho, p, heat, pace), eps[j], strength)
        t1, t2 = radial_return(t1, t2, limit, geometry)
        tension = t1 - p
        hurt_now = hurt[j] + dt * damage_rate(tension, fracture)
        ratio = failure(tension, p, strain_base(rho0, pores[j], eos) * v, hurt_now, fracture)
        if grows_voids(fracture):
            grown, relief = void_change(tension, rho * rho * c2, voids[j], rho, fracture)
            voids[j] += grown
            flow = flow_beside_voids(flow, grown, rho)
            p += relief
            capped += 1.0 if relief > 0.0 else 0.0
        c = wave_speed(c2 + (4.0 / 3.0) * shear * solid, noise)
        inverse = mean_area(r[j], r[j + 1], geometry) * im[j] * density
        g[j] = (ue[j + 1] - ue[j]) * inverse
        fastest = fmax(fastest, (c + 2.0 * speed[j]) * inverse)
        worst = fmax(worst, ratio)
        rho_[j] = density
        e_[j] = energy
        p_[j] = p
        c_[j] = c
        s1[j] = t1
        if hoops(geometry) == 1.0:
            s2[j] = t2
        if fails(fracture):
            hurt[j] = hurt_now
            torn[j] = ratio
        plastic[j] += limit * flow * v
        eps[j] += flow
        viscous[j] -= dt * q[j] * closing * im[j]
        sigma[j] = p + q[j] - t1
        if hoops(geometry) > 0.0:
            hoop_force[j] = 0.5 * hoops(geometry) * (r[j + 1] - r[j]) * area_per_radius(r[j], r[j + 1], geometry) * (t2 + q[j] - t1)
    found[0], found[1], found[2], found[3] = fastest, worst, radial_impulse, capped


@nb.njit(**INLINE)
def shrinking(r1, r2, u1, u2, geometry):
    """Speed with which a zone closes along the motion, or shrinks, if that is more, m/s."""
    closing = u1 - u2
    if hoops(geometry) > 0.0:
        return fmax(closing, (area(r1, geometry) * u1 - area(r2, geometry) * u2) / mean_area(r1, r2, geometry))
    return closing


@nb.njit(**SWEEP)
def conduct(zones, nodes, first, last, segment, dt, coefficient, geometry):
    """Artificial heat flux inside a run of zones, where a shock is: h rho w (e_left - e_right) through each face.

    w is the speed with which a zone closes along the motion, |du|, or that with which it shrinks, minus its volume rate over its
    mean area, if that is more: where a flow converges, a shock that takes its time makes heat of the hoop convergence as well.
    Spreads the excess heat a shock leaves where it starts or is reflected (wall heating). Conservative: what leaves one zone
    enters the next. Noh, J. Comput. Phys. 72 (1987) 78, section on artificial heat conduction; nothing flows where q = 0.
    """
    a = first + segment
    n = last - first
    u, r = nodes[L.U_MEAN, a:a + n + 1], nodes[L.R_HALF, a:a + n + 1]
    rho, e, q, im = zones[L.RHO, first:last], zones[L.E, first:last], zones[L.Q, first:last], zones[L.INVERSE_MASS, first:last]
    flux = zones[L.OLD, first:last]
    for j in range(n - 1):
        left = shrinking(r[j], r[j + 1], u[j], u[j + 1], geometry) if q[j] > 0.0 else 0.0
        right = shrinking(r[j + 1], r[j + 2], u[j + 1], u[j + 2], geometry) if q[j + 1] > 0.0 else 0.0
        flux[j] = dt * coefficient * area(r[j + 1], geometry) * fmin(rho[j], rho[j + 1]) * fmax(left, right) * (e[j] - e[j + 1])
    if n < 2:
        return
    # one difference for each zone: subtracted and added one after the other, the mirror image would be rounded otherwise
    e[0] -= flux[0] * im[0]
    for j in range(1, n - 1):
        e[j] += (flux[j - 1] - flux[j]) * im[j]
    e[n - 1] += flux[n - 2] * im[n - 1]
