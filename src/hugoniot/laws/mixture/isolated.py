r"""Mechanical equilibrium with thermal isolation: equal pressures, while the reactants stay on their isentrope.

$$v = (1-\lambda)v_r + \lambda v_p,\quad e = (1-\lambda)e_r + \lambda e_p,$$
$$p_r(v_r, e_r - Q) = p_p(v_p, e_p),\quad e_r - Q = e_S(v_r)$$

* $\lambda$: burn fraction, the mass fraction of products
* $v$, $e$: specific volume and specific internal energy of the mixture; the subscripts r and p denote reactants and products
* $p_r$, $p_p$: pressures of the two equations of state
* $Q$: chemical energy, `detonation_energy`; $e$ and $e_r$ include it, but the equation of state of the reactants does not
* $e_S$: energy on the isentrope of the reactants through their state behind the last shock

Use it for fast burning at hot spots, in which the phases have no time to exchange heat. It is the default with the burn laws `arrhenius`,
`forest_fire`, `ignition_growth`, `pressure_power` and `rate_table`.

**Temperature.** The two phases have different temperatures. The temperature of the mixture is that of the products (Starkenberg, section
5.6), and that of the reactants before anything has burned.

**Small burn fractions.** The energy of the products is $e_p = (e - (1-\lambda) e_r)/\lambda$. At small $\lambda$ this magnifies any error
of $e$. Below the burn fraction `nascent_limit` the isentrope of the reactants is therefore taken through the state of the mixture itself.
The limit is 1e-6 in the tools without a mesh, whose energies are exact to round-off, and larger in a run.

**Numerical solution.** The unknown is $w = v_r - v_p$; with $v_r = v + \lambda w$ and $v_p = v - (1-\lambda)w$ the equation for $v$ is
satisfied identically. While both phases are stable the pressure difference $p_r - p_p$ decreases with $w$, so the root is unique. There its
slope is $-I^2$, with $I^2 = \lambda i_r^2 + (1-\lambda) i_p^2$ and the acoustic impedance $i = \rho c$ of a phase. Newton's method runs
inside a bracket that only shrinks.
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmax, fmin
from hugoniot.laws.eos.contract import pressure, specific_heat, temperature
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import MIXTURE, Mixed, PhaseSlopes, Slopes, impedance_squared, volume_slopes
from hugoniot.laws.mixture.isentrope import isentrope_energy, knows_isentropes
from hugoniot.laws.mixture.search import CLOSE, NASCENT, SHORT, inverse_cubic, is_close, limits

ITERATIONS = 100
# While the reactant's volume differs from the mixture's by less than NEAR, the expansion of its isentrope to second order replaces the
# march and its cancellation.
NEAR = 1e-6
# A phase of less than this mass fraction is left out where the reactants alone would be in tension, as those of less than NASCENT are
# everywhere: bubbles of that mass press by some 20 MPa.
FAINT = 1e-5
# Products of more than this volume, in those of the reactants, have pushed these off the volume of the mixture: see `opened`.
OPEN = 3e-3


class ThermalIsolation(NamedTuple):
    reactants: NamedTuple
    products: NamedTuple
    detonation_energy: float
    reactant_density_limit: float = 1e30
    product_density_limit: float = 1e30
    nascent_limit: float = 1e-6


def solve(rho, e, burn_fraction, before, par):
    """`before` must lie on the reactant's isentrope: the shocked state, or the reactant of the step before."""
    if burn_fraction <= FAINT:
        p = pressure(rho, e - par.detonation_energy, par.reactants)
        if burn_fraction <= NASCENT:
            return Mixed(p, rho, e, before.rho_p, before.e_p, 0.0)
        if p < 0.0:
            return Mixed(p, rho, e, 0.0, 0.0, 0.0)
    if burn_fraction >= 1.0 - NASCENT:
        return Mixed(pressure(rho, e, par.products), 0.0, before.e_r, rho, e, 0.0)
    return equilibrate(rho, e, burn_fraction, before, par)


def opened(rho, e, lam, before, par):
    """Whether nascent products fill bubbles: a notable volume in the step before, in what by itself would be in tension.

    The isentrope through the mixture state then is no longer that of the reactants: these would be given a tension they never bore, and
    the products its energy, as heat.
    """
    if before.rho_p <= 0.0 or lam * (before.rho_r - before.rho_p) <= OPEN * before.rho_p:
        return False
    return pressure(rho, e - par.detonation_energy, par.reactants) < 0.0


def reactant(v, e, lam, w, v_k, e_k, vanishing, par):
    """(p, i^2, thermal energy, z) of the reactant at v + lambda w, on the isentrope through (v_k, e_k), or through (v, e - Q)."""
    q = par.detonation_energy
    if vanishing and abs(lam * w) < NEAR * v:
        p = pressure(1.0 / v, e - q, par.reactants)
        i_r = impedance_squared(1.0 / v, e - q, par.reactants)
        z = -w * (p - 0.5 * i_r * lam * w)
        return p - i_r * lam * w, i_r, e - q + lam * z, z
    there = 1.0 / (v + lam * w)
    e_r = isentrope_energy(v_k, e_k, v + lam * w, par.reactants)
    return pressure(there, e_r, par.reactants), impedance_squared(there, e_r, par.reactants), e_r, (e_r + q - e) / lam


def trial(v, e, lam, w, v_k, e_k, vanishing, par):
    """(F, p, i_r^2, i_p^2, thermal e_r, v_p, e_p) at w: the excess of the reactant's pressure p over the products', and both phases."""
    p, i_r, e_r, z = reactant(v, e, lam, w, v_k, e_k, vanishing, par)
    v_p, e_p = v - (1.0 - lam) * w, e - (1.0 - lam) * z
    p_v, p_e = volume_slopes(1.0 / v_p, e_p, par.products)
    return p - pressure(1.0 / v_p, e_p, par.products), p, i_r, p * p_e - p_v, e_r, v_p, e_p


def arrive(lam, step, curvature, p, i_r, v_r, e_r, v_p, e_p):
    """(p, v_r, e_r, v_p, e_p) at the root, a short step in w from a trial; curvature is the slope of i_r^2 by w."""
    e_r = e_r - lam * step * (p - 0.5 * i_r * lam * step)
    e_p = e_p + (1.0 - lam) * step * (p - 0.5 * lam * i_r * step)
    return p - lam * step * (i_r + 0.5 * curvature * step), v_r + lam * step, e_r, v_p - (1.0 - lam) * step, e_p


def equilibrate(rho, e, burn_fraction, before, par):
    """The bracketed Newton search of the module's docstring, for 0 <= lambda <= 1 (nascent products, last grain)."""
    v, lam, rest = 1.0 / rho, burn_fraction, 1.0 - burn_fraction
    q = par.detonation_energy
    vanishing = lam < par.nascent_limit and not opened(rho, e, lam, before, par)
    v_r = v_k = v if vanishing else 1.0 / before.rho_r
    e_r = e_k = e - q if vanishing else before.e_r - q
    w = v_r - 1.0 / before.rho_p if before.rho_p > 0.0 else 0.0
    low, high = limits(v, lam, par)
    if w <= low or w >= high:
        w = 0.0
    status = contract.NOT_CONVERGED
    p = v_p = e_p = 0.0
    w_0, excess_0, decline_0, i_r0, step_0 = w, 0.0, 1.0, 0.0, NO_LIMIT     # of the trial before
    for _ in range(ITERATIONS):
        excess, p, i_r, i_p, e_r, v_p, e_p = trial(v, e, lam, w, v_k, e_k, vanishing, par)
        v_r = v + lam * w
        if not knows_isentropes(par.reactants):   # a march is the shorter the nearer it starts
            v_k, e_k = v_r, e_r
        decline = lam * i_r + rest * i_p
        if excess > 0.0:
            low = w
        else:
            high = w
        step = excess / decline if decline > 0.0 else 0.5 * (low + high) - w
        scale = v + abs(w)
        if decline > 0.0 and is_close(step, step_0, scale):
            # the last step: Newton's when it is short, else along the cubic through both trials and their slopes
            curvature = 0.0
            if abs(step) > CLOSE * scale:
                step = inverse_cubic(excess, decline, w - w_0, excess_0, decline_0)
                curvature = (i_r - i_r0) / (w - w_0)
            p, v_r, e_r, v_p, e_p = arrive(lam, step, curvature, p, i_r, v_r, e_r, v_p, e_p)
            status = contract.CONVERGED if i_r > 0.0 and i_p > 0.0 else contract.UNSTABLE
            break
        # no step may compress a phase by more than a third; products may expand fourfold
        back = fmin(0.33 * v_r / fmax(lam, 1e-12), 3.0 * v_p / fmax(rest, 1e-12))
        ahead = 0.33 * fmin(v_r / fmax(lam, 1e-12), v_p / fmax(rest, 1e-12))
        target = w + fmax(-back, fmin(ahead, step))
        if not low < target < high:
            target = 0.5 * (low + high)
        if abs(target - w) <= 1e-15 * (v + abs(w)):
            status = contract.NO_BRACKET
            break
        w_0, excess_0, decline_0, i_r0, step_0 = w, excess, decline, i_r, step if decline > 0.0 else NO_LIMIT
        w = target
    return Mixed(p, 1.0 / v_r, e_r + q, 1.0 / v_p, e_p, status)


def attempt(rho, e, burn_fraction, before, par):
    """`solve` by two trials of the search, without a branch, so that a loop over zones is packed.

    NOT_CONVERGED, and `before` as it was, where that does not do: at first burning, in the last grains, far from `before`, and for
    reactants whose isentropes are integrated.
    """
    if not knows_isentropes(par.reactants):
        return Mixed(before.pressure, before.rho_r, before.e_r, before.rho_p, before.e_p, contract.NOT_CONVERGED)
    v, lam, q = 1.0 / rho, burn_fraction, par.detonation_energy
    known = (before.rho_r > 0.0) & (before.rho_p > 0.0) & (lam >= par.nascent_limit) & (lam < 1.0 - NASCENT)
    v_k = 1.0 / (before.rho_r if known else rho)
    w_0 = v_k - 1.0 / (before.rho_p if known else rho)
    low, high = limits(v, lam, par)
    fits = known & (low < w_0) & (w_0 < high)
    w_0 = w_0 if fits else 0.0
    lam = lam if fits else 0.5
    excess_0, _, i_r0, i_p0, _, v_p, _ = trial(v, e, lam, w_0, v_k, before.e_r - q, False, par)
    decline_0 = lam * i_r0 + (1.0 - lam) * i_p0
    step_0 = excess_0 / decline_0
    fits = fits & (decline_0 > 0.0) & (abs(step_0) < SHORT * fmin(v_k, v_p)) & (low < w_0 + step_0) & (w_0 + step_0 < high)
    w = w_0 + step_0 if fits else w_0
    excess, p, i_r, i_p, e_r, v_p, e_p = trial(v, e, lam, w, v_k, before.e_r - q, False, par)
    decline = lam * i_r + (1.0 - lam) * i_p
    step = excess / decline
    scale = v + abs(w)
    fits = fits & (i_r > 0.0) & (i_p > 0.0) & is_close(step, step_0, scale)
    bends = fits & (abs(step) > CLOSE * scale)
    moved = w - w_0 if bends else v
    step = inverse_cubic(excess, decline, moved, excess_0 if bends else 2.0 * excess + 1.0, decline_0) if bends else step
    curvature = (i_r - i_r0) / moved if bends else 0.0
    p, v_r, e_r, v_p, e_p = arrive(lam, step, curvature, p, i_r, v + lam * w, e_r, v_p, e_p)
    return Mixed(p if fits else before.pressure, 1.0 / v_r if fits else before.rho_r, e_r + q if fits else before.e_r,
                 1.0 / v_p if fits else before.rho_p, e_p if fits else before.e_p, contract.CONVERGED if fits else contract.NOT_CONVERGED)


def slopes(rho, e, burn_fraction, mixed, par):
    r"""$p_v = (i_r^2/I^2)\,p_{p,v}$, $p_e = (i_r^2/I^2)\,p_{p,e}$ (Starkenberg 5.3); $p_\lambda = (v_r-v_p)p_v + (e_r-e_p)p_e$ (B-2).

    Before any burning the slopes are the reactant's own: the source's limit for vanishing lambda, in which all heat goes into the
    products, is another number (its jump at lambda = 0 is real; the sound speed has none). Where `solve` left a phase unknown the slope
    by burn fraction is 0.
    """
    q, lam = par.detonation_energy, burn_fraction
    # alternatives are chosen among arguments, so that a loop over zones evaluates each phase once and is packed
    burned, whole = mixed.rho_r <= 0.0, mixed.rho_p <= 0.0
    single = burned | whole
    rho_r, e_r = (rho, e) if single | (lam <= 0.0) else (mixed.rho_r, mixed.e_r)
    rho_p, e_p = (rho, e) if single else (mixed.rho_p, mixed.e_p)
    r_v, r_e = volume_slopes(rho_r, e_r - q, par.reactants)
    p_v, p_e = volume_slopes(rho_p, e_p, par.products)
    i_r = pressure(rho_r, e_r - q, par.reactants) * r_e - r_v
    share = 1.0 if single else i_r / (lam * i_r + (1.0 - lam) * (mixed.pressure * p_e - p_v))
    p_v, p_e = share * p_v, share * p_e
    p_l = 0.0 if single else (1.0 / mixed.rho_r - 1.0 / mixed.rho_p) * p_v + (mixed.e_r - mixed.e_p) * p_e
    unburned = (not burned) & (whole | (lam <= 0.0))
    return Slopes(r_v if unburned else p_v, r_e if unburned else p_e, p_l)


def phase_slopes(burn_fraction, mixed, par):
    """Appendix B-2 with S-E13, for 0 < lambda <= 1; the products' slopes by v and e grow as 1/lambda when lambda vanishes."""
    lam, p = burn_fraction, mixed.pressure
    i_r = impedance_squared(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    p_v, p_e = volume_slopes(mixed.rho_p, mixed.e_p, par.products)
    i_p = p * p_e - p_v
    whole = lam * i_r + (1.0 - lam) * i_p
    rest = (1.0 - lam) / (lam * whole)
    share = i_r / whole
    w, z = 1.0 / mixed.rho_r - 1.0 / mixed.rho_p, mixed.e_r - mixed.e_p
    v_r_v, v_r_e = -p_v / whole, -p_e / whole
    v_p_v, v_p_e = share + rest * p * p_e, rest * p_e
    e_p_v, e_p_e = -rest * p * p_v, share - rest * p_v
    v_r_l, v_p_l = w * v_r_v + z * v_r_e, w * v_p_v + z * v_p_e
    e_p_l = w * e_p_v + z * e_p_e
    return PhaseSlopes(v_r_v, -p * v_r_v, v_p_v, e_p_v, v_r_e, -p * v_r_e, v_p_e, e_p_e, v_r_l, -p * v_r_l, v_p_l, e_p_l)


def mixture_temperature(burn_fraction, mixed, par):
    """The products' temperature (Starkenberg section 5.6); the reactant's before any burning."""
    if burn_fraction <= 0.0 or mixed.rho_p <= 0.0:
        return temperature(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    return temperature(mixed.rho_p, mixed.e_p, par.products)


def mixture_specific_heat(burn_fraction, mixed, par):
    r"""$C_v = \lambda I^2 c_{vp} / [I^2 - (1-\lambda) c_{vp} T_p (\Gamma_p/v_p)^2]$ (Starkenberg section 5.6)."""
    if burn_fraction <= 0.0 or mixed.rho_p <= 0.0:
        return specific_heat(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    i_r = impedance_squared(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    p_v, p_e = volume_slopes(mixed.rho_p, mixed.e_p, par.products)
    whole = burn_fraction * i_r + (1.0 - burn_fraction) * (mixed.pressure * p_e - p_v)
    c_v = specific_heat(mixed.rho_p, mixed.e_p, par.products)
    t_p = temperature(mixed.rho_p, mixed.e_p, par.products)
    return burn_fraction * whole * c_v / (whole - (1.0 - burn_fraction) * c_v * t_p * p_e * p_e)


MIXTURE.add(
    "thermal_isolation", ThermalIsolation,
    functions={"solve": solve, "attempt": attempt, "equilibrate": equilibrate, "slopes": slopes, "phase_slopes": phase_slopes,
               "temperature": mixture_temperature, "specific_heat": mixture_specific_heat},
    example=ThermalIsolation(IdealGas(5.0, 1000.0, 1600.0), IdealGas(2.8, 1200.0, 1600.0), 5.0e6),
    units={"reactants": "", "products": "", "detonation_energy": "J/kg", "reactant_density_limit": "kg/m^3",
           "product_density_limit": "kg/m^3", "nascent_limit": "1"},
    meaning={"reactants": "equation of state of the unreacted material", "products": "equation of state of the products",
             "detonation_energy": "chemical energy Q released by burning, not negative",
             "reactant_density_limit": "upper bound of the search: highest density at which the law of the reactants is defined",
             "product_density_limit": "upper bound of the search: highest density at which the law of the products is defined",
             "nascent_limit": "burn fraction below which the isentrope of the reactants passes through the state of the mixture"},
    box={"rho": (1200.0, 3000.0), "e": (6e6, 9e6), "burn_fraction": (0.0, 1.0)},
    references=("Starkenberg, ARL-TR-2161, sections 5.1 to 5.9 and appendix B, corrected (S-E2, S-E3, S-E13)",),
    flags=("follows_isentrope",),
)
