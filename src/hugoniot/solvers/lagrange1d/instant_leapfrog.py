r"""The sweep over a run of burning zones for the leapfrog: the KB codes' own step, in which a zone burns at once.

Between n and n+1, with w the artificial viscosity that moved the nodes at n,

$$e' = e^n - (p^n + w^n)\,\Delta v, \quad p' = p(\rho^{n+1}, e'), \qquad
  e^{n+1} = e^n - \left[\tfrac12(p^n + p') + w^n\right]\Delta v, \quad p^{n+1} = p(\rho^{n+1}, e^{n+1})$$

A zone whose $p^{n+1}$ passes the threshold burns there and then: its pressure is already that of the products when its nodes are moved
next. The step keeps to the signal speed c + 4 w/(rho |du|), the limit of diffusion by a quadratic viscosity (Richtmyer & Morton); the KB
codes do not print theirs, and the speed of their wave depends on it.

A burning zone's energy holds Q from the start (`materials.burning`), so nothing is added to it. The energy is not that of the
motion to round-off, as in every leapfrog of its kind (W-E6).

Source: 001 (KB codes) equations 1.8 to 1.11 with the viscous term of K-E5, and section 4.
"""

import numba as nb

from hugoniot.core.compile import SWEEP, parameters
from hugoniot.core.ops import fmax
from hugoniot.laws.burn.contract import advance
from hugoniot.laws.mixture.contract import Mixed, slopes, solve, sound_speed_squared
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.mesh.line import hoops, volume
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d import reactive_sweeps  # noqa: F401  (lets kernels call burn and mixture laws)
from hugoniot.solvers.lagrange1d.constitutive import resisted, wave_speed


@nb.njit(**SWEEP)
def burn_at_once(zones, nodes, gradient, first, last, segment, dt, law, rows, geometry, found):
    """The step of the KB codes; `found` takes the largest signal rate (1/s), 0, 0, 0."""
    par = parameters(law[0], rows[0])
    viscosity = parameters(law[3], rows[3])
    a, b = first + segment, last + segment
    r, u, im = nodes[L.R, a:b + 1], nodes[L.U, a:b + 1], zones[L.INVERSE_MASS, first:last]
    rho_, e_, p_, c_ = zones[L.RHO, first:last], zones[L.E, first:last], zones[L.P, first:last], zones[L.C, first:last]
    sigma, q_, viscous = zones[L.SIGMA, first:last], zones[L.Q, first:last], zones[L.VISCOUS_WORK, first:last]
    old, width, burned = zones[L.SIGMA_HALF, first:last], zones[L.OLD, first:last], zones[L.BURN_FRACTION, first:last]
    rho_r, e_r, rho_p, e_p = zones[L.RHO_R, first:last], zones[L.E_R, first:last], zones[L.RHO_P, first:last], zones[L.E_P, first:last]
    status, noise = zones[L.MIX_STATUS, first:last], rows[4][1]
    fastest = 0.0
    for j in range(last - first):
        v = volume(r[j], r[j + 1], geometry) * im[j]
        dv, rho, dr, du = v - old[j], 1.0 / v, r[j + 1] - r[j], u[j + 1] - u[j]
        before = Mixed(p_[j], rho_r[j], e_r[j], rho_p[j], e_p[j], 0.0)
        lam = burned[j]
        target = e_[j] - (0.5 * p_[j] + q_[j]) * dv
        guess = solve(rho, target - 0.5 * p_[j] * dv, lam, before, par.mixture)
        energy = target - 0.5 * guess.pressure * dv
        mixed = solve(rho, energy, lam, guess, par.mixture)
        after = advance(lam, dt, rho, mixed.pressure, 0.0, par.rate)
        if after > lam:
            lam = after
            mixed = solve(rho, energy, lam, mixed, par.mixture)
        p = mixed.pressure
        squeeze = resisted(du, dv, viscosity)
        speed = viscous_speed(v, c_[j], p, squeeze, 0.0, viscosity)
        q = -rho * squeeze * speed
        fault = guess.status + mixed.status
        c = wave_speed(sound_speed_squared(rho, p, slopes(rho, energy, lam, mixed, par.mixture)), noise) if fault == 0.0 else -1.0
        fastest = fmax(fastest, (c + (4.0 * speed if squeeze != 0.0 else 0.0)) / dr)
        viscous[j] -= q_[j] * dv
        burned[j] = lam
        rho_r[j], e_r[j], rho_p[j], e_p[j] = mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p
        rho_[j], e_[j], p_[j], c_[j], q_[j], old[j], status[j] = rho, energy, p, c, q, v, fault
        sigma[j] = p + q
        if hoops(geometry) > 0.0:
            width[j] = rho * dr
    found[0], found[1], found[2], found[3] = fastest, 0.0, 0.0, 0.0
