r"""Ignition and growth of Lee and Tarver: three terms for hot spots, the growth of burning around them, and its completion.

$$\dot\lambda = \underbrace{I(1-\lambda)^b\left(\tfrac{\rho}{\rho_0} - 1 - a\right)^x}_{\lambda < \lambda_{ig}}
 + \underbrace{G_1(1-\lambda)^c\lambda^d p^y}_{\lambda < \lambda_{G1}}
 + \underbrace{G_2(1-\lambda)^e\lambda^g p^z}_{\lambda \ge \lambda_{G2}}$$

* $\lambda$: burned mass fraction, 0 to 1; $\dot\lambda$: its rate of change
* $\rho$: density; $\rho_0$: reference density, `rho0`; $p$: pressure of the mixture
* $I$, $a$, $b$, $x$: `i`, `a`, `b`, `x`; $G_1$, $c$, $d$, $y$: `g1`, `c`, `d`, `y`; $G_2$, $e$, $g$, $z$: `g2`, `e`, `g`, `z`
* $\lambda_{ig}$, $\lambda_{G1}$, $\lambda_{G2}$: `ignition_limit`, `growth_limit`, `completion_limit`

The ignition term is zero for $\rho/\rho_0 < 1 + a$. The growth and completion terms are zero in tension and at $\lambda = 0$. The example
is LX-17 with the constants of Kapila et al., Combustion Theory and Modelling 11 (2007) 781.

Within a time step the equation is integrated at constant density and pressure with error control (Bogacki and Shampine, Appl. Math.
Letters 2 (1989) 321), stopping exactly at the limits. Burning ends at exactly $\lambda = 1$ if the powers of $1 - \lambda$ are below 1.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, fmin, vexp, vlog, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, no_schedule
from hugoniot.laws.burn.depletion import deplete, power, with_unit

TOLERANCE = 3e-6     # of a sub-step, relative to the burn fraction
LEAST = 1e-4         # burn fraction below which it is absolute: a power of lambda below 1 has no slope at 0, and noise at rest no meaning
SMALL = 0.03         # change, relative to what has burned and to what is left, up to which the Taylor series does
TINY = 1e-300
FLOOR = 0.05         # burn fraction below which the size of a sub-step is left to the error estimate
SUBSTEPS = 1000
LAST = 0.01
QUARTER = 0.25
LOG2 = 0.6931471805599453


class IgnitionGrowth(NamedTuple):
    rho0: float
    i: float
    b: float
    a: float
    x: float
    g1: float
    c: float
    d: float
    y: float
    g2: float = 0.0
    e: float = 1.0
    g: float = 1.0
    z: float = 1.0
    ignition_limit: float = 1.0
    growth_limit: float = 1.0
    completion_limit: float = 0.0


def strengths(lam, rho, p, par):
    """What the terms still to act owe to the state: I (rho/rho0 - 1 - a)^x, G1 p^y, G2 p^z, 1/s."""
    excess = rho / par.rho0 - 1.0 - par.a
    ignition = par.i * power(excess, par.x) if lam < par.ignition_limit and excess > 0.0 else 0.0
    # what has not ignited cannot grow, unless a growth term starts from nothing
    alive = p > 0.0 and (lam > 0.0 or ignition > 0.0 or par.d == 0.0 or par.g == 0.0)
    growth = par.g1 * power(p, par.y) if alive and lam < par.growth_limit else 0.0
    completion = par.g2 * power(p, par.z) if alive and par.g2 > 0.0 else 0.0
    return ignition, growth, completion


def burning(lam, ignition, growth, completion, par):
    """(rate at burn fraction lam for given strengths, 1/s; its slope by lam)."""
    left = 1.0 - lam
    if left <= 0.0 or ignition + growth + completion <= 0.0:
        return 0.0, 0.0
    # the logarithms are shared by the powers: half the cost of five calls of vpow; at lam = 0 only a zeroth power is not zero
    log_left = vlog(left)
    log_burned = vlog(lam) if lam > 0.0 else 0.0
    burned = fmax(lam, TINY)
    total = slope = 0.0
    if lam < par.ignition_limit and ignition > 0.0:
        term = ignition * vexp(par.b * log_left)
        total += term
        slope -= term * par.b / left
    if lam < par.growth_limit and growth > 0.0 and (lam > 0.0 or par.d == 0.0):
        term = growth * vexp(par.c * log_left + par.d * log_burned)
        total += term
        slope += term * (par.d / burned - par.c / left)
    if lam >= par.completion_limit and completion > 0.0 and (lam > 0.0 or par.g == 0.0):
        term = completion * vexp(par.e * log_left + par.g * log_burned)
        total += term
        slope += term * (par.g / burned - par.e / left)
    return total, slope


def next_limit(lam, par):
    """The lowest limit above lam, or 1."""
    limit = 1.0
    if lam < par.ignition_limit:
        limit = fmin(limit, par.ignition_limit)
    if lam < par.growth_limit:
        limit = fmin(limit, par.growth_limit)
    if lam < par.completion_limit:
        limit = fmin(limit, par.completion_limit)
    return limit


def rate_and_slope(lam, rho, p, par):
    """`burning` with the `strengths` of a state, without a branch, so that a loop over zones is packed: one exponential for each term."""
    left, burned, excess = 1.0 - lam, fmax(lam, TINY), rho / par.rho0 - 1.0 - par.a
    log_left, log_burned, log_p = vlog(fmax(left, TINY)), vlog(burned), vlog(fmax(p, TINY))
    ignites = (lam < par.ignition_limit) & (excess > 0.0) & (left > 0.0)
    ignition = par.i * vexp(par.x * vlog(fmax(excess, TINY)) + par.b * log_left) if ignites else 0.0
    alive = (p > 0.0) & (left > 0.0) & ((lam > 0.0) | (ignition > 0.0) | (par.d == 0.0) | (par.g == 0.0))
    grows = alive & (lam < par.growth_limit) & ((lam > 0.0) | (par.d == 0.0))
    growth = par.g1 * vexp(par.y * log_p + par.c * log_left + par.d * log_burned) if grows else 0.0
    ends = alive & (lam >= par.completion_limit) & ((lam > 0.0) | (par.g == 0.0))
    completion = par.g2 * vexp(par.z * log_p + par.e * log_left + par.g * log_burned) if ends else 0.0
    slope = (par.d * growth + par.g * completion) / burned - (par.b * ignition + par.c * growth + par.e * completion) / fmax(left, TINY)
    return ignition + growth + completion, slope


def rate(burn_fraction, rho, p, temperature, par):
    return rate_and_slope(burn_fraction, rho, p, par)[0]


def advance(burn_fraction, dt, rho, p, temperature, par):
    ignition, growth, completion = strengths(burn_fraction, rho, p, par)
    lam, left = burn_fraction, dt
    if ignition + growth + completion <= 0.0 or lam >= 1.0:
        return lam
    trial = dt
    for _ in range(SUBSTEPS):
        limit = next_limit(lam, par)
        k1, slope = burning(lam, ignition, growth, completion, par)
        if k1 <= 0.0:
            return lam
        if left * k1 <= SMALL * fmin(lam, 1.0 - lam):
            end = lam + left * k1 * (1.0 + 0.5 * left * slope)
            if end < limit:
                return end
        if limit >= 1.0 and 1.0 - lam < LAST:
            half = burning(0.5 + 0.5 * lam, ignition, growth, completion, par)[0]
            if half <= 0.0:
                return lam
            order = vlog(k1 / half) / LOG2
            return deplete(lam, left * k1 / vpow(1.0 - lam, order), order)
        # stages beyond a limit would mix two sets of terms: they stay below it
        below = limit * (1.0 - 1e-15)
        # no step beyond a quarter of what has burned or is left: the error estimate alone is blind where it changes sign
        h = fmin(fmin(left, trial), QUARTER * fmin(1.0 - lam, fmax(lam, FLOOR)) / k1)
        k2 = burning(fmin(below, lam + 0.5 * h * k1), ignition, growth, completion, par)[0]
        k3 = burning(fmin(below, lam + 0.75 * h * k2), ignition, growth, completion, par)[0]
        mean = (2.0 * k1 + 3.0 * k2 + 4.0 * k3) / 9.0
        k4 = burning(fmin(below, lam + h * mean), ignition, growth, completion, par)[0]
        error = h * abs(-5.0 * k1 + 6.0 * k2 + 8.0 * k3 - 9.0 * k4) / 72.0 / (TOLERANCE * fmax(lam + h * mean, LEAST))
        if error > 1.0:
            # the error grows as the cube of the step
            trial = h * fmax(0.1, 0.9 / vpow(error, 1.0 / 3.0))
            continue
        trial = 3.0 * h if error < 0.02 else h * 0.9 / vpow(error, 1.0 / 3.0)
        if lam + h * mean >= limit:
            left = left - (limit - lam) / mean
            lam = limit
        else:
            left = left - h
            lam = lam + h * mean
        if left <= 1e-14 * dt or lam >= 1.0:
            return lam
    # out of sub-steps (the rate grows without bound within dt): what is left of the step is burned at the last rate
    return fmin(1.0, lam + left * burning(lam, ignition, growth, completion, par)[0])


def short_advance(burn_fraction, dt, rho, p, temperature, par):
    """`advance` where the Taylor series does all of the step or nothing burns."""
    lam = burn_fraction
    speed, slope = rate_and_slope(lam, rho, p, par)
    end = lam + dt * speed * (1.0 + 0.5 * dt * slope)
    rests = (speed <= 0.0) | (lam >= 1.0)
    short = (dt * speed <= SMALL * fmin(lam, 1.0 - lam)) & (end < next_limit(lam, par))
    return lam if rests else end, rests | short


def ignition_growth(rho0, i, b, a, x, g1, c, d, y, **others) -> IgnitionGrowth:
    """Parameters; OutOfRange for negative constants or powers, or limits outside 0..1 (a negative a ignites in tension)."""
    par = IgnitionGrowth(rho0, i, b, a, x, g1, c, d, y, **others)
    for name, value in par._asdict().items():
        if name != "a" and not value >= 0.0:
            raise OutOfRange(f"ignition_growth: {name} must not be negative, got {with_unit(par, name)}")
        if name.endswith("_limit") and value > 1.0:
            raise OutOfRange(f"ignition_growth: {name} is a burn fraction and must lie between 0 and 1, got {value:.6g}")
    if not par.rho0 > 0.0:
        raise OutOfRange("ignition_growth: rho0 must be positive, got 0 kg/m^3")
    return par


_MEANING = {
    "rho0": "reference density of the unreacted explosive", "i": "I, ignition constant",
    "b": "power of the unburned fraction in the ignition term",
    "a": "compression rho/rho0 - 1 below which nothing ignites", "x": "power of the compression above a in the ignition term",
    "g1": "G1, growth constant", "c": "power of the unburned fraction in the growth term",
    "d": "power of the burned fraction in the growth term", "y": "power of the pressure in the growth term",
    "g2": "G2, completion constant", "e": "power of the unburned fraction in the completion term",
    "g": "power of the burned fraction in the completion term",
    "z": "power of the pressure in the completion term", "ignition_limit": "burn fraction at which ignition ends",
    "growth_limit": "burn fraction at which growth ends", "completion_limit": "burn fraction at which completion begins",
}
_UNITS = dict.fromkeys(_MEANING, "1") | {"rho0": "kg/m^3", "i": "1/s", "g1": "1/(Pa^y s)", "g2": "1/(Pa^z s)"}

BURN.add(
    "ignition_growth", IgnitionGrowth,
    functions={"rate": rate, "advance": advance, "short_advance": short_advance, "scheduled": no_schedule},
    # LX-17, A. K. Kapila et al., Combustion Theory and Modelling 11 (2007) 781
    example=IgnitionGrowth(1905.0, 4.0e12, 0.667, 0.22, 7.0, 4.5e-24, 0.667, 1.0, 3.0, 3.0e-4, 0.667, 0.667, 1.0, 0.02, 0.8, 0.8),
    units=_UNITS, meaning=_MEANING, build=ignition_growth,
    defaults={"g2": 0.0, "e": 1.0, "g": 1.0, "z": 1.0, "ignition_limit": 1.0, "growth_limit": 1.0, "completion_limit": 0.0},
    box={"rho": (1700.0, 3000.0), "p": (0.0, 60.0e9)},
    references=("Lee and Tarver, Physics of Fluids 23 (1980) 2362",
                "Tarver, Hallquist and Erickson, 8th Symposium on Detonation, 1985, for three terms"),
    flags=("pressure_driven", "compression_driven", "subcycled"),
)
