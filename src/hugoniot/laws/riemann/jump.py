r"""Jumps that conserve mass, momentum and energy: shocks, and the feeble expansions that stand for a slice of a fan.

With the drop of specific volume $x = v_0 - v$ and the mass flux m through the front,

$$m^2 = \frac{\sigma-\sigma_0}{x}, \qquad u - u_0 = d\,\frac{\sigma-\sigma_0}{m}, \qquad e - e_0 = \tfrac12(\sigma+\sigma_0)\,x$$

for a front that runs into the material in the direction d = +-1. x is found from sigma(1/(v0 - x), e0 + (sigma + sigma0) x / 2) = sigma
by Newton's method inside a bracket (ideal and stiffened gas, and `energy_alone`, have it in closed form); solving for the difference keeps
feeble jumps as accurate as strong ones. An expansion obeys the same three relations: its entropy falls with the cube of its strength, its
conservation is exact.

Source: Courant and Friedrichs, Supersonic Flow and Shock Waves, sections 54 and 65.
"""

import math

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.shock_energy import ShockEnergy
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.riemann import energy_alone
from hugoniot.laws.riemann.branch import Branch, State, stress, stress_and_slopes, wave_speed_squared
from hugoniot.laws.riemann.medium import limits_of, name_of

FEEBLE = 3e-8      # rise over rho c^2 below which a jump is acoustic to round-off
_STEPS = 200


def volume_drop(sigma: float, ahead: State, branch: Branch, square: float | None = None) -> float:
    """x = v0 - v behind a jump to the stress sigma; `OutOfRange` where the law has no such state.

    square   c^2 of the weakest jump in that direction (m2/s2), where the branch has a kink at the state ahead; None: the branch's own
    """
    if square is None:
        square = wave_speed_squared(ahead.rho, ahead.e, branch)
    if not square > 0.0 and not (square == 0.0 and sigma > ahead.sigma):
        raise OutOfRange(f"law '{name_of(branch.par)}' is unstable at {ahead.rho:.6g} kg/m3 and {ahead.e:.6g} J/kg: "
                         f"c^2 = {square:.4g} m2/s2")
    v0, rise = 1.0 / ahead.rho, sigma - ahead.sigma
    if isinstance(branch.par, (IdealGas, StiffenedGas)) and not branch.a and not branch.b:
        g, stiff = branch.par.gamma, getattr(branch.par, "p_infinity", 0.0)
        under = (g + 1.0) * (sigma + stiff) + (g - 1.0) * (ahead.sigma + stiff)
        if not sigma + stiff >= 0.0:
            raise OutOfRange(f"law '{name_of(branch.par)}' cannot support a stress of {sigma:.6g} Pa")
        return 2.0 * rise * v0 / under if rise else 0.0
    if isinstance(branch.par, ShockEnergy) and not branch.a and not branch.b:
        return energy_alone.drop(sigma, ahead.sigma, branch.par)
    if abs(rise) <= FEEBLE * ahead.rho * square:
        return rise / (ahead.rho * ahead.rho * square)
    rest, highest = limits_of(branch.par)
    ends = (0.0, v0 - 1.0 / highest) if rise > 0.0 else (v0 - 1.0 / max(rest, 1e-12 * ahead.rho), 0.0)
    x = rise / (ahead.rho * ahead.rho * square) if square > 0.0 else math.inf
    x = x if ends[0] < x < ends[1] and abs(x) < 0.5 * v0 else (0.5 * ends[1] if rise > 0.0 else max(0.5 * ends[0], -v0))
    x = _newton(x, sigma, ahead, branch, ends)
    found = stress(1.0 / (v0 - x), ahead.e + 0.5 * (sigma + ahead.sigma) * x, branch) if sigma < 0.0 else sigma
    if not abs(found - sigma) <= 1e-6 * ahead.rho * square:
        raise NoSolution(f"law '{name_of(branch.par)}' does not support a tension of {-sigma:.6g} Pa")
    return x


def _newton(x, sigma, ahead: State, branch: Branch, ends) -> float:
    v0, mean = 1.0 / ahead.rho, 0.5 * (sigma + ahead.sigma)
    low, high = ends
    best, last = x, math.inf
    for _ in range(_STEPS):
        rho = 1.0 / (v0 - x)
        found, by_rho, by_e = stress_and_slopes(rho, ahead.e + mean * x, branch)
        miss = found - sigma
        if miss == 0.0:
            return x
        if math.isfinite(miss):
            low, high = (low, x) if miss > 0.0 else (x, high)
        elif x > 0.0:
            high = x
        else:
            low = x
        stiff = rho * rho * by_rho + mean * by_e
        step = miss / stiff if math.isfinite(miss) and stiff != 0.0 else math.nan
        new = min(x - step, 0.5 * (x + v0))      # no step more than doubles the density: far beyond, a law may turn to tension
        if not low < new < high or not math.isfinite(new):
            new = 0.5 * (low + high)
        moved = abs(new - x)
        if moved <= 1e-16 * v0 or (moved <= 1e-13 * abs(x) and moved >= last):
            return new if moved < last else best
        best, last, x = (new, moved, new)
    if last <= 1e-9 * abs(x):
        return x
    raise NoSolution(f"no shock of law '{name_of(branch.par)}' from {ahead.sigma:.6g} Pa reaches {sigma:.6g} Pa")


def behind(sigma: float, ahead: State, branch: Branch, direction: int, deviator: float | None = None,
           square: float | None = None) -> tuple[State, float]:
    """(state behind, mass flux kg/m2/s) of a jump to the stress sigma that runs in `direction`.

    deviator   s1 behind; None: what the branch gives from the state ahead
    square     see `volume_drop`
    """
    x = volume_drop(sigma, ahead, branch, square)
    rise = sigma - ahead.sigma
    flux = math.sqrt(rise / x) if x != 0.0 else ahead.rho * math.sqrt(max(wave_speed_squared(ahead.rho, ahead.e, branch), 0.0))
    rho = 1.0 / (1.0 / ahead.rho - x)
    if deviator is None:
        deviator = ahead.s - branch.b * math.log(rho / ahead.rho) if branch.b else ahead.s
    u = ahead.u + direction * (rise / flux if flux else 0.0)
    return State(rho, u, ahead.e + 0.5 * (sigma + ahead.sigma) * x, sigma, deviator, ahead.compaction), flux


def slope(sigma: float, ahead: State, after: State, branch: Branch, flux: float) -> float:
    """d|u - u0|/dsigma along the jumps from `ahead`, at the one to `after`."""
    x, rise = 1.0 / ahead.rho - 1.0 / after.rho, sigma - ahead.sigma
    if abs(rise) <= 1e-6 * ahead.rho * flux * flux / (ahead.rho * ahead.rho):
        return 1.0 / flux
    # a pressure that depends on the energy alone has an infinite slope at rest, where rounding must not decide on the energy
    e = 0.5 * energy_alone.velocity_of(sigma, branch.par) ** 2 if isinstance(branch.par, ShockEnergy) else after.e
    _, by_rho, by_e = stress_and_slopes(after.rho, e, branch)
    # the energy behind rises with sigma at fixed volume by x/2, and with x at fixed sigma by (sigma + sigma0)/2
    stiff = after.rho**2 * by_rho + 0.5 * by_e * (sigma + ahead.sigma)
    if stiff == 0.0:      # a law whose tension is cut off supports no more of it
        return math.inf
    growth = (1.0 - 0.5 * by_e * x) / stiff
    return (x + rise * growth) / (2.0 * rise / flux)


def to_density(rho: float, ahead: State, branch: Branch, direction: int, deviator: float) -> tuple[State, float]:
    """(state, mass flux) of the jump from `ahead` to a density: the elastic limit."""
    x = 1.0 / ahead.rho - 1.0 / rho
    sigma = ahead.sigma
    for _ in range(100):
        e = ahead.e + 0.5 * (sigma + ahead.sigma) * x
        found, _, by_e = stress_and_slopes(rho, e, branch)
        new = sigma + (found - sigma) / (1.0 - 0.5 * by_e * x)
        if abs(new - sigma) <= 2e-16 * abs(new):
            break
        sigma = new
    rise = sigma - ahead.sigma
    if not rise * x > 0.0:
        return State(rho, ahead.u, ahead.e, stress(rho, ahead.e, branch), deviator), 0.0
    flux = math.sqrt(rise / x)
    return State(rho, ahead.u + direction * rise / flux, ahead.e + 0.5 * (sigma + ahead.sigma) * x, sigma, deviator), flux
