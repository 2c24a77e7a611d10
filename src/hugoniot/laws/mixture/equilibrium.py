r"""Mechanical and thermal equilibrium of reactants and products: equal pressures and equal temperatures.

$$v = (1-\lambda)v_r + \lambda v_p,\quad e = (1-\lambda)e_r + \lambda e_p,$$
$$p_r(v_r, e_r - Q) = p_p(v_p, e_p),\quad T_r(v_r, e_r - Q) = T_p(v_p, e_p)$$

* $\lambda$: burn fraction, the mass fraction of products
* $v$, $e$: specific volume and specific internal energy of the mixture; the subscripts r and p denote reactants and products
* $p_r$, $p_p$, $T_r$, $T_p$: pressures and temperatures of the two equations of state
* $Q$: chemical energy, `detonation_energy`; $e$ and $e_r$ include it, but the equation of state of the reactants does not

Use it for slow burning, in which the phases have time to exchange heat. Both equations of state must give a temperature and a specific heat
consistent with their pressure: the slopes of the temperature are taken as $(\partial T/\partial v)_e = p/c_v - T (\partial p/\partial e)_v$
and $(\partial T/\partial e)_v = 1/c_v$.

**Numerical solution.** The unknowns are $w = v_r - v_p$ and $z = e_r - e_p$, with which the equations for $v$ and $e$ above are satisfied
identically. Newton's method is applied to both. If it does not converge, the search is nested: at fixed $w$ the temperature difference
increases with $z$, and along the function $z(w)$ so found the pressure difference decreases with $w$, so both roots can be bracketed.
The equations are regular at $\lambda$ = 0 and 1.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, fmin
from hugoniot.laws.eos.contract import pressure, specific_heat, temperature
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import MIXTURE, Mixed, PhaseSlopes, Slopes, volume_slopes
from hugoniot.laws.mixture.search import CLOSE, NASCENT, SHORT, inverse_cubic, is_close, limits

ITERATIONS = 100
COUPLED = 15          # trials of both unknowns at once
NEARLY = 1e-7
CLOSE_STEP = 1e-8         # step from which the nested search ends, relative
CLOSE_TOGETHER = 1e-7     # of the coupled one


class ThermalEquilibrium(NamedTuple):
    reactants: NamedTuple
    products: NamedTuple
    detonation_energy: float
    reactant_density_limit: float = 1e30
    product_density_limit: float = 1e30


def temperature_slopes(rho, e, par):
    """(dT/dv at e, dT/de at v) of one phase."""
    c_v = specific_heat(rho, e, par)
    p_e = volume_slopes(rho, e, par)[1]
    return pressure(rho, e, par) / c_v - temperature(rho, e, par) * p_e, 1.0 / c_v


def share_energy(v_r, v_p, e, lam, z, par):
    """z = e_r - e_p at which both phases have one temperature, at given volumes."""
    low = high = z
    bounded_below = bounded_above = False
    for _ in range(ITERATIONS):
        e_r, e_p = e + lam * z - par.detonation_energy, e - (1.0 - lam) * z
        t_r, t_p = temperature(1.0 / v_r, e_r, par.reactants), temperature(1.0 / v_p, e_p, par.products)
        excess = t_r - t_p
        rise = lam / specific_heat(1.0 / v_r, e_r, par.reactants) + (1.0 - lam) / specific_heat(1.0 / v_p, e_p, par.products)
        step = -excess / rise
        if excess > 0.0:
            high, bounded_above = z, True
        else:
            low, bounded_below = z, True
        target = z + step
        if bounded_above and bounded_below and not low <= target <= high:
            target = 0.5 * (low + high)
        small = abs(target - z) <= 1e-13 * (abs(z) + abs(e) + abs(par.detonation_energy))
        z = target
        if small:
            break
    return z


def solve(rho, e, burn_fraction, before, par):
    """`before` only gives the starting values."""
    if burn_fraction <= NASCENT:
        return Mixed(pressure(rho, e - par.detonation_energy, par.reactants), rho, e, before.rho_p, before.e_p, 0.0)
    if burn_fraction >= 1.0 - NASCENT:
        return Mixed(pressure(rho, e, par.products), 0.0, before.e_r, rho, e, 0.0)
    return equilibrate(rho, e, burn_fraction, before, par)


def pull(v, e, par):
    """(p, p_v, p_e, T, T_v, T_e) of one phase at volume v, energy e of its own law."""
    rho = 1.0 / v
    p, t, cold = pressure(rho, e, par), temperature(rho, e, par), 1.0 / specific_heat(rho, e, par)
    p_v, p_e = volume_slopes(rho, e, par)
    return p, p_v, p_e, t, p * cold - t * p_e, cold


def reach(v_r, v_p, lam, rest):
    """(back, ahead): the longest steps of w; none compresses a phase by more than a third, products may expand fourfold."""
    back = fmin(0.33 * v_r / fmax(lam, 1e-12), 3.0 * v_p / fmax(rest, 1e-12))
    return back, 0.33 * fmin(v_r / fmax(lam, 1e-12), v_p / fmax(rest, 1e-12))


def coupled(v, e, lam, w, z, low, high, par):
    """(found, p, v_r, e_r thermal, v_p, e_p) by Newton's method in w and z at once, from any start."""
    rest, q = 1.0 - lam, par.detonation_energy
    for _ in range(COUPLED):
        v_r, v_p = v + lam * w, v - rest * w
        e_r, e_p = e + lam * z - q, e - rest * z
        p, r_v, r_e, hot, t_rv, t_re = pull(v_r, e_r, par.reactants)
        p_p, p_v, p_e, cool, t_pv, t_pe = pull(v_p, e_p, par.products)
        rise = 1.0 / (lam * t_re + rest * t_pe)
        level = (cool - hot) * rise
        along = -(lam * t_rv + rest * t_pv) * rise
        by_z = lam * r_e + rest * p_e
        decline = -(lam * r_v + rest * p_v) - by_z * along
        if not (decline > 0.0 and rise > 0.0):
            break
        step = (p - p_p + by_z * level) / decline
        change = level + along * step
        if abs(step) <= CLOSE_TOGETHER * (v + abs(w)) and abs(change) <= CLOSE_TOGETHER * (abs(e) + abs(z) + q):
            # the last step, with which what is left is of order CLOSE_TOGETHER squared
            return True, p + lam * (r_v * step + r_e * change), v_r + lam * step, e_r + lam * change, v_p - rest * step, e_p - rest * change
        back, ahead = reach(v_r, v_p, lam, rest)
        step = fmax(-back, fmin(ahead, step))
        w, z = w + step, z + level + along * step
        if not low < w < high:
            break
    return False, 0.0, v, e, v, e


def equilibrate(rho, e, burn_fraction, before, par):
    """Both unknowns at once, else the nested search of the module's docstring, for 0 <= lambda <= 1."""
    v, lam, q = 1.0 / rho, burn_fraction, par.detonation_energy
    known = before.rho_p > 0.0
    w = 1.0 / before.rho_r - 1.0 / before.rho_p if known else 0.0
    z = before.e_r - before.e_p if known else 0.0
    low, high = limits(v, lam, par)
    if w <= low or w >= high:
        w = 0.0
    found, p, v_r, e_r, v_p, e_p = coupled(v, e, lam, w, z, low, high, par)
    if found:
        return Mixed(p, 1.0 / v_r, e_r + q, 1.0 / v_p, e_p, contract.CONVERGED)
    return nested(v, e, lam, w, z, low, high, par)


def nested(v, e, lam, w, z, low, high, par):
    """The bracketed search of the module's docstring."""
    rest, q = 1.0 - lam, par.detonation_energy
    status = contract.NOT_CONVERGED
    p = v_r = v_p = e_r = e_p = 0.0
    for _ in range(ITERATIONS):
        v_r, v_p = v + lam * w, v - rest * w
        z = share_energy(v_r, v_p, e, lam, z, par)
        e_r, e_p = e + lam * z - q, e - rest * z
        p = pressure(1.0 / v_r, e_r, par.reactants)
        excess = p - pressure(1.0 / v_p, e_p, par.products)
        r_v, r_e = volume_slopes(1.0 / v_r, e_r, par.reactants)
        p_v, p_e = volume_slopes(1.0 / v_p, e_p, par.products)
        t_rv, t_re = temperature_slopes(1.0 / v_r, e_r, par.reactants)
        t_pv, t_pe = temperature_slopes(1.0 / v_p, e_p, par.products)
        along = -(lam * t_rv + rest * t_pv) / (lam * t_re + rest * t_pe)
        decline = -(lam * r_v + rest * p_v) - (lam * r_e + rest * p_e) * along
        if excess > 0.0:
            low = w
        else:
            high = w
        step = excess / decline if decline > 0.0 else 0.5 * (low + high) - w
        if decline > 0.0 and abs(step) <= CLOSE_STEP * (v + abs(w)):
            # one last Newton step along equal temperatures: what it leaves out is of order CLOSE_STEP squared
            p = p + lam * step * (r_v + r_e * along)
            v_r, v_p = v_r + lam * step, v_p - rest * step
            e_r, e_p = e_r + lam * step * along, e_p - rest * step * along
            status = contract.CONVERGED
            break
        back, ahead = reach(v_r, v_p, lam, rest)
        target = w + fmax(-back, fmin(ahead, step))
        if not low < target < high:
            target = 0.5 * (low + high)
        if abs(target - w) <= 1e-15 * (v + abs(w)):
            # the bracket is at round-off: a root if the last step was small, otherwise a jump between branches
            status = contract.CONVERGED if decline > 0.0 and abs(step) <= NEARLY * (v + abs(w)) else contract.NO_BRACKET
            break
        w = target
    return Mixed(p, 1.0 / v_r, e_r + q, 1.0 / v_p, e_p, status)


def level(rho_r, rho_p, e, lam, z, par):
    """Change of z that makes the temperatures equal at given densities: exact where they are linear in the energy, else Newton's."""
    e_r, e_p = e + lam * z - par.detonation_energy, e - (1.0 - lam) * z
    apart = temperature(rho_p, e_p, par.products) - temperature(rho_r, e_r, par.reactants)
    return apart / (lam / specific_heat(rho_r, e_r, par.reactants) + (1.0 - lam) / specific_heat(rho_p, e_p, par.products))


def trial(v, e, lam, w, z, par):
    """(F, -dF/dw, p, dp/dw, z, dz/dw, last change of z) at w along equal temperatures, found from a z near them; p is the reactant's."""
    rest = 1.0 - lam
    v_r, v_p = v + lam * w, v - rest * w
    z = z + level(1.0 / v_r, 1.0 / v_p, e, lam, z, par)
    change = level(1.0 / v_r, 1.0 / v_p, e, lam, z, par)
    z = z + change
    p, r_v, r_e, _, t_rv, t_re = pull(v_r, e + lam * z - par.detonation_energy, par.reactants)
    p_p, p_v, p_e, _, t_pv, t_pe = pull(v_p, e - rest * z, par.products)
    along = -(lam * t_rv + rest * t_pv) / (lam * t_re + rest * t_pe)
    by_w = lam * (r_v + r_e * along)
    return p - p_p, -by_w - rest * (p_v + p_e * along), p, by_w, z, along, change


def attempt(rho, e, burn_fraction, before, par):
    """`solve` by two trials of w along equal temperatures, without a branch, so that a loop over zones is packed.

    NOT_CONVERGED, and `before` as it was, where that does not do: at first burning, in the last grains, and far from `before`.
    """
    v, lam = 1.0 / rho, burn_fraction
    fits = (before.rho_r > 0.0) & (before.rho_p > 0.0) & (lam > NASCENT) & (lam < 1.0 - NASCENT)
    w_0 = 1.0 / (before.rho_r if fits else rho) - 1.0 / (before.rho_p if fits else rho)
    low, high = limits(v, lam, par)
    fits = fits & (low < w_0) & (w_0 < high)
    w_0, z = (w_0, before.e_r - before.e_p) if fits else (0.0, 0.0)
    lam = lam if fits else 0.5
    rest = 1.0 - lam
    excess_0, decline_0, _, by_w0, z, along_0, _ = trial(v, e, lam, w_0, z, par)
    step_0 = excess_0 / decline_0
    fits = fits & (decline_0 > 0.0) & (abs(step_0) < SHORT * fmin(v + lam * w_0, v - rest * w_0))
    fits = fits & (low < w_0 + step_0) & (w_0 + step_0 < high)
    w = w_0 + step_0 if fits else w_0
    excess, decline, p, by_w, z, along, change = trial(v, e, lam, w, z + along_0 * (w - w_0), par)
    step = excess / decline
    scale = v + abs(w)
    fits = fits & (decline > 0.0) & is_close(step, step_0, scale)
    fits = fits & (abs(change) <= CLOSE_TOGETHER * (abs(e) + abs(z) + par.detonation_energy))
    bends = fits & (abs(step) > CLOSE * scale)
    moved = w - w_0 if bends else v
    step = inverse_cubic(excess, decline, moved, excess_0 if bends else 2.0 * excess + 1.0, decline_0) if bends else step
    curvature, turn = ((by_w - by_w0) / moved, (along - along_0) / moved) if bends else (0.0, 0.0)
    p, z, w = p + step * (by_w + 0.5 * curvature * step), z + step * (along + 0.5 * turn * step), w + step
    return Mixed(p if fits else before.pressure, 1.0 / (v + lam * w) if fits else before.rho_r, e + lam * z if fits else before.e_r,
                 1.0 / (v - rest * w) if fits else before.rho_p, e - rest * z if fits else before.e_p,
                 contract.CONVERGED if fits else contract.NOT_CONVERGED)


def minors(lam, mixed, par):
    """The rows a_3j and a_4j of appendix B-2 for thermal equilibrium."""
    e_r = mixed.e_r - par.detonation_energy
    r_v, r_e = volume_slopes(mixed.rho_r, e_r, par.reactants)
    p_v, p_e = volume_slopes(mixed.rho_p, mixed.e_p, par.products)
    t_rv, t_re = temperature_slopes(mixed.rho_r, e_r, par.reactants)
    t_pv, t_pe = temperature_slopes(mixed.rho_p, mixed.e_p, par.products)
    return (r_v, r_e, -p_v, -p_e), (t_rv, t_re, -t_pv, -t_pe)


def phase_slopes(burn_fraction, mixed, par):
    """Appendix B-2, general form: Cramer's rule on the differentiated mixture equations."""
    lam, rest = burn_fraction, 1.0 - burn_fraction
    a, b = minors(lam, mixed, par)
    a34, a23 = a[2] * b[3] - a[3] * b[2], a[1] * b[2] - a[2] * b[1]
    a41, a12 = a[3] * b[0] - a[0] * b[3], a[0] * b[1] - a[1] * b[0]
    a13, a24 = a[0] * b[2] - a[2] * b[0], a[1] * b[3] - a[3] * b[1]
    d = rest * (rest * a34 + lam * a23) + lam * (rest * a41 + lam * a12)
    v_r_v, e_r_v = (rest * a34 + lam * a23) / d, -lam * a13 / d
    v_p_v, e_p_v = (rest * a41 + lam * a12) / d, rest * a13 / d
    v_r_e, e_r_e = lam * a24 / d, (rest * a34 + lam * a41) / d
    v_p_e, e_p_e = -rest * a24 / d, (rest * a23 + lam * a12) / d
    w, z = 1.0 / mixed.rho_r - 1.0 / mixed.rho_p, mixed.e_r - mixed.e_p
    return PhaseSlopes(v_r_v, e_r_v, v_p_v, e_p_v, v_r_e, e_r_e, v_p_e, e_p_e,
                       w * v_r_v + z * v_r_e, w * e_r_v + z * e_r_e, w * v_p_v + z * v_p_e, w * e_p_v + z * e_p_e)


def slopes(rho, e, burn_fraction, mixed, par):
    """By the chain rule through the reactant (the products at lambda = 1); where `solve` left a phase unknown, lambda's slope is 0."""
    # alternatives are chosen among arguments, so that a loop over zones evaluates each phase once and is packed
    burned, whole = mixed.rho_r <= 0.0, mixed.rho_p <= 0.0
    single = burned | whole
    rho_r, e_r, rho_p, e_p = (rho, e, rho, e) if single else (mixed.rho_r, mixed.e_r, mixed.rho_p, mixed.e_p)
    s = phase_slopes(burn_fraction, Mixed(mixed.pressure, rho_r, e_r, rho_p, e_p, mixed.status), par)
    r_v, r_e = volume_slopes(rho_r, e_r - par.detonation_energy, par.reactants)
    p_v, p_e = volume_slopes(rho_p, e_p, par.products)
    if (not burned) & (burn_fraction < 1.0):
        p_v, p_e = (r_v, r_e) if whole else (r_v * s.v_r_v + r_e * s.e_r_v, r_v * s.v_r_e + r_e * s.e_r_e)
    p_l = 0.0 if single else (1.0 / mixed.rho_r - 1.0 / mixed.rho_p) * p_v + (mixed.e_r - mixed.e_p) * p_e
    return Slopes(p_v, p_e, p_l)


def mixture_temperature(burn_fraction, mixed, par):
    """The common temperature."""
    if mixed.rho_r <= 0.0 or burn_fraction >= 1.0:
        return temperature(mixed.rho_p, mixed.e_p, par.products)
    return temperature(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)


def mixture_specific_heat(burn_fraction, mixed, par):
    """C_v = 1 / (dT/de at v and lambda)."""
    if mixed.rho_r <= 0.0 or burn_fraction >= 1.0:
        return specific_heat(mixed.rho_p, mixed.e_p, par.products)
    if burn_fraction <= 0.0 or mixed.rho_p <= 0.0:
        return specific_heat(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    s = phase_slopes(burn_fraction, mixed, par)
    t_v, t_e = temperature_slopes(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    return 1.0 / (t_v * s.v_r_e + t_e * s.e_r_e)


MIXTURE.add(
    "thermal_equilibrium", ThermalEquilibrium,
    functions={"solve": solve, "attempt": attempt, "equilibrate": equilibrate, "slopes": slopes, "phase_slopes": phase_slopes,
               "temperature": mixture_temperature, "specific_heat": mixture_specific_heat},
    example=ThermalEquilibrium(IdealGas(5.0, 1000.0, 1600.0), IdealGas(2.8, 1200.0, 1600.0), 5.0e6),
    units={"reactants": "", "products": "", "detonation_energy": "J/kg", "reactant_density_limit": "kg/m^3",
           "product_density_limit": "kg/m^3"},
    meaning={"reactants": "equation of state of the unreacted material", "products": "equation of state of the products",
             "detonation_energy": "chemical energy Q released by burning, not negative",
             "reactant_density_limit": "upper bound of the search: highest density at which the law of the reactants is defined",
             "product_density_limit": "upper bound of the search: highest density at which the law of the products is defined"},
    box={"rho": (1200.0, 3000.0), "e": (6e6, 9e6), "burn_fraction": (0.0, 1.0)},
    references=("Starkenberg, ARL-TR-2161, section 4.2 and appendix B",),
    flags=("needs_temperature",),
)
