r"""The sweeps of the viscous flow solver: one loop each, any equation of state and transport law by the class of its parameters.

Conservative finite volumes of one width h for $U = (\rho, \rho u, \rho e + \tfrac12\rho u^2)$,

$$\partial_t U + \partial_x F = 0,\qquad F = (\rho u,\ \rho u^2 + p - \tau,\ (E + p - \tau)u + q),\qquad
  \tau = (\tfrac43\mu + \zeta)\,u_x,\quad q = -kT_x .$$

Inviscid part: fifth-order values on both sides of a face and the local Lax-Friedrichs flux, reduced by the dissipation that the physical
viscosity provides. With s = |u| + c and the diffusion speed 2 nu/h of the cell, nu = (4/3 mu + zeta)/rho, the artificial speed is

$$a = \max(s/10,\ s - 2\nu/h)$$

(hybrid differencing: Spalding, Int. J. Numer. Meth. Eng. 4 (1972) 551). For sound and shocks it is small where the cell Reynolds
number s h/nu is below two; the remaining tenth couples odd and even cells. For entropy waves, which viscosity does not damp, the speed is
at least |u|. As a falls, the face values change from those of WENO-Z (Borges et al., J. Comput. Phys. 227 (2008) 3191) to linear upwind
values, so that a resolved wave is computed by an almost linear scheme of fifth order. Viscous part: sixth-order gradients of the conserved
averages, converted to those of u and T by the chain rule; the slopes of T with respect to (rho, e) are central differences of the law's own
temperature.
"""

import numba as nb

from hugoniot.core.binder import bind_choice, bind_family, bind_module
from hugoniot.core.ops import fmax, vsqrt
from hugoniot.core.target import INLINE
from hugoniot.laws.eos import contract as eos_contract
from hugoniot.laws.eos.contract import EOS, pressure, pressure_derivatives
from hugoniot.laws.transport import contract as transport_contract
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT, conductivity, isobaric_heat, longitudinal_viscosity, viscosity
from hugoniot.solvers.shock_structure.layout import ADVECTIVE, CULPRIT, DIFFUSIVE, FALLBACKS, GHOSTS, LIMITING, RHO, WALL, E, J
from hugoniot.solvers.shock_structure.reconstruction import sides, slope

bind_family(EOS, eos_contract.GENERICS)
bind_family(TRANSPORT, transport_contract.GENERICS)
bind_family(CONDUCTION, transport_contract.CONDUCTION_GENERICS)
bind_module(eos_contract)
bind_module(transport_contract)

FAINT = 0.1     # Grüneisen parameter below which an entropy wave is measured by its energy
LEAST = 0.1     # of the signal speed: parts odd and even cells, which a central pressure does not see
_PROBE = 1e-4   # relative step of the temperature's slope: its error is the square


def temperature_if_any(rho, e, par):
    """The law's temperature, K; 0 where it has none."""
    law = EOS.of(par)
    return law.functions["temperature"](rho, e, par) if "temperature" in law.functions else 0.0


def no_temperature(rho, e, par):
    return 0.0


bind_choice(temperature_if_any, lambda *classes: EOS.of_class(classes[-1]).functions.get("temperature") or no_temperature)


@nb.njit(**INLINE)
def artificial_speed(U, r, h, eos, transport):
    """Speed a of the artificial dissipation at the face left of cell r, over the signal speed there: LEAST resolved, 1 not."""
    rho = 0.5 * (U[RHO, r - 1] + U[RHO, r])
    u, _, c = signal(rho, 0.5 * (U[J, r - 1] + U[J, r]), 0.5 * (U[E, r - 1] + U[E, r]), eos)
    if c < 0.0:
        return 1.0
    T = temperature_if_any(rho, 0.5 * (U[E, r - 1] + U[E, r]) / rho - 0.5 * u * u, eos)
    nu = longitudinal_viscosity(viscosity(rho, T, transport.shear), transport) / rho
    return fmax(LEAST, 1.0 - 2.0 * nu / (h * (abs(u) + c)))


@nb.njit(**INLINE)
def signal(rho, j, E_total, eos):
    """(u, p, c) of a conserved state; c is negative where the state is none."""
    if not rho > 0.0:
        return 0.0, 0.0, -1.0
    u = j / rho
    e = E_total / rho - 0.5 * u * u
    p = pressure(rho, e, eos)
    p_rho, p_e = pressure_derivatives(rho, e, eos)
    c2 = p_rho + p * p_e / (rho * rho)
    if not (c2 > 0.0 and c2 < 1e30):
        return u, p, -1.0
    return u, p, vsqrt(c2)


@nb.njit(**INLINE)
def fill_ghosts(U, kinds, ends, eos):
    """Cells beyond the ends. A wall mirrors; a transmitting end lets outgoing waves pass and takes incoming ones from `ends` (2, 3).

    The three characteristic amplitudes are those of the deviation from the end state, so that it is also the far field held.
    """
    last = U.shape[1] - GHOSTS - 1
    for side in range(2):
        edge, inward, normal = (GHOSTS, 1, -1.0) if side == 0 else (last, -1, 1.0)
        if kinds[side] == WALL:
            for g in range(GHOSTS):
                U[RHO, edge - inward * (g + 1)] = U[RHO, edge + inward * g]
                U[J, edge - inward * (g + 1)] = -U[J, edge + inward * g]
                U[E, edge - inward * (g + 1)] = U[E, edge + inward * g]
            continue
        u0, p0, c0 = signal(ends[side, 0], ends[side, 1], ends[side, 2], eos)
        rho0 = ends[side, 0]
        u, p, c = signal(U[RHO, edge], U[J, edge], U[E, edge], eos)
        impedance = rho0 * c0
        d_rho, d_u, d_p = U[RHO, edge] - rho0, normal * (u - u0), p - p0
        speed = normal * u0
        outward = d_p + impedance * d_u if speed + c0 > 0.0 else 0.0
        inward_wave = d_p - impedance * d_u if speed - c0 > 0.0 else 0.0
        entropy = d_rho - d_p / (c0 * c0) if speed > 0.0 else 0.0
        g_p = 0.5 * (outward + inward_wave)
        g_u = 0.5 * (outward - inward_wave) / impedance
        rho = rho0 + entropy + g_p / (c0 * c0)
        v = u0 + normal * g_u
        e0 = ends[side, 2] / rho0 - 0.5 * u0 * u0
        p_rho, p_e = pressure_derivatives(rho0, e0, eos)
        # pores that close at a pressure no heat changes leave the energy to the work done on them
        e = e0 + ((g_p - p_rho * (rho - rho0)) / p_e if p_e != 0.0 else p0 * (rho - rho0) / (rho0 * rho0))
        for g in range(GHOSTS):
            ghost = edge - inward * (g + 1)
            U[RHO, ghost], U[J, ghost], U[E, ghost] = rho, rho * v, rho * (e + 0.5 * v * v)


@nb.njit(**INLINE)
def heat_flow(rho, e, rho_x, e_x, mu, eos, transport, conducting):
    """(heat flux q, thermal diffusivity k (dT/de) / rho) at a state with gradients; zero where the fluid does not conduct."""
    if not conducting:
        return 0.0, 0.0
    T = temperature_if_any(rho, e, eos)
    p = pressure(rho, e, eos)
    p_rho, p_e = pressure_derivatives(rho, e, eos)
    c2 = p_rho + p * p_e / (rho * rho)
    wider, closer, more = rho / (1.0 + _PROBE), rho / (1.0 - _PROBE), _PROBE * c2
    T_v = (temperature_if_any(wider, e, eos) - temperature_if_any(closer, e, eos)) * rho / (2.0 * _PROBE)
    T_e = (temperature_if_any(rho, e + more, eos) - temperature_if_any(rho, e - more, eos)) / (2.0 * more)
    k = conductivity(rho, T, mu, isobaric_heat(rho, c2, p_rho, p_e, T_v, T_e), transport.conduction)
    size = abs(rho_x) / rho + abs(e_x) / c2
    if size == 0.0:
        return 0.0, k * T_e / rho
    step = _PROBE / size
    warmer = temperature_if_any(rho + step * rho_x, e + step * e_x, eos)
    colder = temperature_if_any(rho - step * rho_x, e - step * e_x, eos)
    return -k * (warmer - colder) / (2.0 * step), k * T_e / rho


@nb.njit(**INLINE)
def flux_sweep(U, F, h, rough, control, counters, eos, transport, conducting):
    """F (3, n+1) at every face; the largest signal speed and diffusivity go to `control`. True if every state was one.

    rough   first-order values and two-point gradients everywhere: for the first moments of an unresolved jump
    """
    n = F.shape[1] - 1
    fastest, widest, sound = 0.0, 0.0, True
    for i in range(n + 1):
        r = i + GHOSTS          # cell to the right of face i
        part = 1.0 if rough else artificial_speed(U, r, h, eos, transport)
        rl, rr = sides(U[RHO], r, part)
        jl, jr = sides(U[J], r, part)
        el, er = sides(U[E], r, part)
        ul, pl, cl = signal(rl, jl, el, eos)
        ur, pr, cr = signal(rr, jr, er, eos)
        if rough or cl < 0.0 or cr < 0.0:  # an overshoot is no state: first order there
            part = 1.0
            rl, jl, el, rr, jr, er = U[RHO, r - 1], U[J, r - 1], U[E, r - 1], U[RHO, r], U[J, r], U[E, r]
            ul, pl, cl = signal(rl, jl, el, eos)
            ur, pr, cr = signal(rr, jr, er, eos)
            counters[FALLBACKS] += 0 if rough else 1
            if sound and (cl < 0.0 or cr < 0.0):
                sound = False
                counters[CULPRIT] = max(i - 1, 0) if cl < 0.0 else min(i, n - 1)
        speed = fmax(abs(ul) + cl, abs(ur) + cr)
        rho, u = 0.5 * (rl + rr), 0.5 * (jl + jr) / (0.5 * (rl + rr))
        total = 0.5 * (el + er) / rho
        e = total - 0.5 * u * u
        rho_x, j_x, E_x = slope(U[RHO], r, rough, h), slope(U[J], r, rough, h), slope(U[E], r, rough, h)
        u_x = (j_x - u * rho_x) / rho
        e_x = (E_x - total * rho_x) / rho - u * u_x
        mu = viscosity(rho, temperature_if_any(rho, e, eos), transport.shear)
        mu_l = longitudinal_viscosity(mu, transport)
        q, spread = heat_flow(rho, e, rho_x, e_x, mu, eos, transport, conducting)
        tau = mu_l * u_x
        damp = part * speed
        F[RHO, i] = 0.5 * (jl + jr) - 0.5 * damp * (rr - rl)
        F[J, i] = 0.5 * (jl * ul + pl + jr * ur + pr) - 0.5 * damp * (jr - jl) - tau
        F[E, i] = 0.5 * ((el + pl) * ul + (er + pr) * ur) - 0.5 * damp * (er - el) - tau * u + q
        if abs(u) > damp:       # entropy waves have no viscosity of their own
            p_rho, p_e = pressure_derivatives(rho, e, eos)
            square, p = 0.5 * (cl * cl + cr * cr), 0.5 * (pl + pr)
            acoustic = (pr - pl) / square if p_e > 0.0 else 0.0    # part of the jump of density that is sound; open pores have none
            if p_e < FAINT * rho:   # by their energy: where pores close p_e is next to nothing, and must not be divided by
                jump = er / rr - 0.5 * ur * ur - el / rl + 0.5 * ul * ul - p / (rho * rho) * acoustic
                amount = -0.5 * (abs(u) - damp) * jump
                heat = -amount * rho
                amount *= p_e / p_rho if p_rho > 0.0 else 0.0   # open pores have neither slope
                heat += amount * total
            else:                             # by their density
                amount = 0.5 * (abs(u) - damp) * (rr - rl - acoustic)
                heat = amount * (total - rho * p_rho / p_e)
            F[RHO, i] -= amount
            F[J, i] -= amount * u
            F[E, i] -= heat
        if speed > fastest:
            fastest = speed
            counters[LIMITING] = min(i, n - 1)
        widest = fmax(widest, fmax(mu_l / rho, spread))
    control[ADVECTIVE], control[DIFFUSIVE] = fastest, widest
    return sound


@nb.njit(**INLINE)
def stage(U, V, F, ratio):
    """V = U advanced by the fluxes F over ratio = dt/h; ghosts untouched."""
    n = F.shape[1] - 1
    for k in range(3):
        for i in range(n):
            V[k, i + GHOSTS] = U[k, i + GHOSTS] + ratio * (F[k, i] - F[k, i + 1])


@nb.njit(**INLINE)
def gather(F0, F1, k):
    """The fluxes of stage k of three into the sum that the next stage, and at last the step, is made with."""
    for j in range(3):
        for i in range(F0.shape[1]):
            if k == 0:
                F0[j, i] = F1[j, i]
            elif k == 1:
                F0[j, i] += F1[j, i]
            else:
                F0[j, i] = (F0[j, i] + 4.0 * F1[j, i]) / 6.0


@nb.njit(**INLINE)
def all_sound(U, scratch, counters, eos):
    """Whether every cell is a state of the law; pressures into the first row of `scratch`."""
    for i in range(GHOSTS, U.shape[1] - GHOSTS):
        _, p, c = signal(U[RHO, i], U[J, i], U[E, i], eos)
        if c < 0.0:
            counters[CULPRIT] = i - GHOSTS
            return False
        scratch[0, i - GHOSTS] = p
    return True


@nb.njit(**INLINE)
def keep_peaks(peaks, U, scratch):
    """Largest pressure and density of every cell after a step, (2, n)."""
    for i in range(peaks.shape[1]):
        peaks[0, i] = fmax(peaks[0, i], scratch[0, i])
        peaks[1, i] = fmax(peaks[1, i], U[RHO, i + GHOSTS])


@nb.njit(**INLINE)
def update(U, rest, F, ratio):
    """The same in place, with what rounding drops kept in `rest` (3, n) so that totals stay exact over any number of steps."""
    n = F.shape[1] - 1
    for k in range(3):
        for i in range(n):
            change = ratio * (F[k, i] - F[k, i + 1]) + rest[k, i]
            new = U[k, i + GHOSTS] + change
            rest[k, i] = change - (new - U[k, i + GHOSTS])
            U[k, i + GHOSTS] = new


@nb.njit(**INLINE)
def account(passed, rest, F, dt):
    """Add what passed the two ends, (2, 3), with compensation."""
    for side in range(2):
        face = 0 if side == 0 else F.shape[1] - 1
        for k in range(3):
            change = dt * F[k, face] + rest[side, k]
            new = passed[side, k] + change
            rest[side, k] = change - (new - passed[side, k])
            passed[side, k] = new
