r"""Normal modes of a plane detonation: how fast a small disturbance of the ZND wave grows, and at what frequency.

**Ideal gas.** A gas of constant $\gamma$ burns in one step at the rate $r = k(1-\lambda)e^{-E\rho/p}$, with the burn fraction $\lambda$,
and releases the heat $q$ per mass. Units: $\rho = p = 1$ ahead of the wave; the activation energy $E$ and $q$ are in units of the pressure
divided by the density ahead, lengths in half-reaction lengths, which fixes $k$. The front is displaced by $\psi = \epsilon e^{\alpha t}$
with a small $\epsilon$. Let $x$ be the position relative to the displaced front, negative behind it, $u$ the velocity in the frame of the
steady front, and $w'$ the perturbation of the state $w = (\rho, u, p, \lambda)$ at given $x$, per unit of the perturbation $\alpha\psi$ of
the front's velocity. Then

$$A\,w'_x = w^*_x - \alpha w' - \left(\frac{\partial A}{\partial w}w'\right)w^*_x + \frac{\partial R}{\partial w}w'$$

where $w^*$ is the steady wave, $A$ the matrix of the Euler equations, $R$ the reaction source and the index $x$ a derivative. The
equation is integrated from the perturbed shock to the end of the zone. No acoustic wave may run from there towards the front. $\alpha$ is
a mode if this condition holds; its real part is the growth rate and its imaginary part the frequency.

Implementation: at the end of the zone the part of p' + rho c u' that is not forced by the decaying lambda' must vanish.

Source: J. J. Erpenbeck, Phys. Fluids 5 (1962) 604, and H. I. Lee and D. S. Stewart, J. Fluid Mech. 216 (1990) 103, for the problem; the
equations are the Euler equations linearised.
"""

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.integrate import quad, solve_ivp

from hugoniot.errors import NoSolution, OutOfRange

END = 1e-8           # what is left to burn where the far condition is put
ZERO = 1e-6          # of the residual at the guess, or of 1: what counts as zero
CLOSEST = 1.0005     # overdrive from which the tail is no longer sonic to the accuracy of the search


@dataclass(frozen=True)
class Mode:
    """A mode of the disturbed wave.

    growth      growth rate, real part of alpha; for a `Wave` in units of the velocity sqrt(p/rho) ahead per half-reaction length, for
                `ModesOfZone` in units of the detonation velocity per half-reaction length
    frequency   imaginary part of alpha, in the same unit
    residual    absolute value of the residual at alpha, zero for an exact mode
    """

    growth: float
    frequency: float
    residual: float


@dataclass(frozen=True)
class Wave:
    """A one-step detonation of an ideal gas; its method `modes()` gives the growing modes.

    gamma        ratio of specific heats
    heat         heat release q, in units of p/rho ahead
    activation   activation energy E, in units of p/rho ahead
    overdrive    (D/D_CJ)^2, at least 1.0005
    """

    gamma: float
    heat: float
    activation: float
    overdrive: float

    def __post_init__(self):
        if not self.gamma > 1.0 or not self.heat > 0.0 or not self.activation >= 0.0:
            raise OutOfRange(f"gamma must exceed 1, the heat must be positive and the activation energy must not be negative, got "
                             f"{self.gamma:g}, {self.heat:g} and {self.activation:g}")
        if not self.overdrive >= CLOSEST:
            raise OutOfRange(f"the overdrive {self.overdrive:g} must be at least {CLOSEST:g}: at 1 the end of the zone is sonic, "
                             "and that limit can only be approached from above")

    @cached_property
    def velocity(self) -> float:
        """Velocity of the front, sqrt(overdrive) D_CJ, in units of sqrt(p/rho) ahead."""
        a = 0.5 * (self.gamma**2 - 1.0) * self.heat / self.gamma
        return math.sqrt(self.overdrive * self.gamma) * (math.sqrt(1.0 + a) + math.sqrt(a))

    def state(self, burned: float) -> tuple[float, float, float]:
        """(density, velocity, pressure) of the steady wave where a fraction has burned, in the frame of the front."""
        g, d2 = self.gamma, self.velocity**2
        # momentum and energy through the front: a quadratic for the specific volume, subsonic branch
        root = math.sqrt(max((d2 - g) ** 2 - 2.0 * (g * g - 1.0) * burned * self.heat * d2, 0.0))
        v = (g * (1.0 + d2) - root) / ((g + 1.0) * d2)
        return 1.0 / v, -self.velocity * v, 1.0 + d2 * (1.0 - v)

    @cached_property
    def rate_constant(self) -> float:
        """The constant k of the rate, with which half the material burns within a unit of length."""
        def pace(burned):
            rho, u, p = self.state(burned)
            return -u / ((1.0 - burned) * math.exp(-self.activation * rho / p))
        return quad(pace, 0.0, 0.5, epsabs=0.0, epsrel=1e-12)[0]

    @cached_property
    def _shock_slopes(self) -> np.ndarray:
        """d(rho, u in the frame at rest, p, lambda)/dD behind the inert shock."""
        g, d = self.gamma, self.velocity
        v = ((g - 1.0) * d * d + 2.0 * g) / ((g + 1.0) * d * d)
        v_d = -4.0 * g / ((g + 1.0) * d**3)
        return np.array([-v_d / v**2, 1.0 - v - d * v_d, 2.0 * d * (1.0 - v) - d * d * v_d, 0.0])

    def residual(self, alpha: complex) -> complex:
        """Amplitude of the acoustic wave from the end of the zone towards the front, relative to alpha psi; zero for a mode."""
        start = np.append(self._shock_slopes, 0.0).astype(complex)
        # with s = -ln(1 - lambda) the zone has a finite length and the rate no small denominator
        found = solve_ivp(self._slope, (0.0, -math.log(END)), start, args=(complex(alpha),), method="DOP853", rtol=1e-10, atol=1e-12)
        if not found.success:
            raise NoSolution(f"the perturbation could not be followed for the growth rate alpha = {alpha}: {found.message}")
        # less the growth of what runs towards the front, exp(-alpha int dx/(u + c)), which has no zero
        return self._incoming(found.y[:4, -1], complex(alpha)) * cmath.exp(complex(alpha) * found.y[4, -1].real)

    def _slope(self, s, w, alpha):
        burned = -math.expm1(-s)
        rho, u, p = self.state(burned)
        g, q, e = self.gamma, self.heat, self.activation
        c2 = g * p / rho
        rate = self.rate_constant * math.exp(-s - e * rho / p)
        source = (g - 1.0) * rho * q * rate
        # the steady slopes follow from the same equations without time
        u_x = source / (rho * (c2 - u * u))
        rho_x, p_x, l_x = -rho * u_x / u, -rho * u * u_x, rate / u
        r, v, pr, la, _ = w
        rate_by = rate * (-e / p * r + e * rho / p**2 * pr) - self.rate_constant * math.exp(-e * rho / p) * la
        right = (rho_x - alpha * r - v * rho_x - r * u_x,
                 u_x - alpha * v - v * u_x + r * p_x / rho**2,
                 p_x - alpha * pr - v * p_x - g * pr * u_x + (g - 1.0) * q * (r * rate + rho * rate_by),
                 l_x - alpha * la - v * l_x + rate_by)
        v_x = (right[2] - rho * u * right[1]) / (rho * (c2 - u * u))
        p_s = rho * (right[1] - u * v_x)
        slopes = np.array([(right[0] - rho * v_x) / u, v_x, p_s, right[3] / u, 1.0 / (u + math.sqrt(c2))])
        return slopes * (u * (1.0 - burned) / rate)      # dx/ds = u (1 - lambda) / rate

    def _incoming(self, w, alpha) -> complex:
        rho, u, p = self.state(1.0)
        c = math.sqrt(self.gamma * p / rho)
        pace = self.rate_constant * math.exp(-self.activation * rho / p)
        forced = -(self.gamma - 1.0) * rho * self.heat * pace / (alpha - (u + c) * (alpha + pace) / u)
        return complex(w[2] + rho * c * w[1] - forced * w[3])

    # -- modes -------------------------------------------------------------------------------------------------------
    def mode(self, guess: complex) -> Mode:
        """The mode nearest to a guess of alpha, by the secant method; NoSolution where it diverges."""
        return nearest(self.residual, guess)

    def modes(self, highest: float = 3.0, spacing: float = 0.25) -> list[Mode]:
        """The growing modes with frequencies up to `highest`, fastest growth first; the guesses lie `spacing` apart in frequency."""
        return growing(self.residual, highest, spacing)


def nearest(residual: Callable[[complex], complex], guess: complex) -> Mode:
    """The mode nearest to a guess of alpha, by the secant method; NoSolution where it diverges.

    residual   function of alpha that vanishes for a mode
    """
    a, b = guess, guess * (1.0 + 1e-3) + 1e-5
    fa, fb = residual(a), residual(b)
    most = ZERO * max(1.0, abs(fa))
    for _ in range(40):
        if fb == fa:
            break
        new = b - fb * (b - a) / (fb - fa)
        if abs(new - b) > 0.5 * abs(guess):
            new = b + 0.5 * abs(guess) * cmath.exp(1j * cmath.phase(new - b))
        if abs(new - guess) > 1.5 or new.real < -1.0:
            break
        a, fa, b, fb = b, fb, new, residual(new)
        if abs(b - a) <= 1e-10 * abs(b) and abs(fb) <= most:      # beside a steep rise the secants shrink where there is no zero
            return Mode(b.real, abs(b.imag), abs(fb))
    raise NoSolution(f"no mode was found near the starting value {guess:.4g}")


def growing(residual: Callable[[complex], complex], highest: float, spacing: float) -> list[Mode]:
    """The growing modes, fastest growth first.

    residual   function of alpha that vanishes for a mode
    highest    highest frequency of the search
    spacing    distance in frequency of the guesses
    """
    found: list[Mode] = []
    for k in range(max(math.ceil(highest / spacing), 1)):
        try:
            mode = nearest(residual, complex(0.05, (k + 0.5) * spacing))
        except (NoSolution, OverflowError, ZeroDivisionError):
            continue
        new = all(abs(complex(mode.growth - m.growth, mode.frequency - m.frequency)) > 1e-5 for m in found)
        if new and mode.growth > 0.0 and mode.frequency <= highest:
            found.append(mode)
    return sorted(found, key=lambda mode: -mode.growth)


def neutral_activation(gamma: float, heat: float, overdrive: float, low: float, high: float, guess: complex,
                       tolerance: float = 1e-4) -> Mode:
    """The activation energy between `low` and `high` at which a mode neither grows nor decays.

    gamma, heat, overdrive   as in `Wave`
    guess                    alpha at which the search for the mode begins
    tolerance                accuracy of the activation energy

    Returns a `Mode` whose `growth` is this activation energy and whose `frequency` is that of the neutral mode.
    """
    def at(activation, start):
        return Wave(gamma, heat, activation, overdrive).mode(start)

    a, b = at(low, guess), at(high, guess)
    if not a.growth * b.growth < 0.0:
        raise NoSolution(f"the growth rate of the mode does not change sign between E = {low:g} "
                         f"({a.growth:.4g}) and E = {high:g} ({b.growth:.4g})")
    while high - low > tolerance:
        middle = low - a.growth * (high - low) / (b.growth - a.growth)
        here = at(middle, complex(0.5 * (a.growth + b.growth), 0.5 * (a.frequency + b.frequency)))
        if abs(here.growth) < 1e-8:
            return Mode(middle, here.frequency, here.residual)
        if here.growth * a.growth > 0.0:
            low, a = middle, here
        else:
            high, b = middle, here
    return Mode(0.5 * (low + high), 0.5 * (a.frequency + b.frequency), 0.0)
