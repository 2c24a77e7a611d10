r"""Guderley's problem: a strong shock that converges on an axis or a centre in cold gas, focuses at t = 0 and is reflected.

It tests a solver in self-similar implosion, where the shock accelerates without bound, and gives the similarity exponent for any gamma.

The shock is at $R = A\,(-t)^{\alpha}$ before focusing and at $R = A\,(t/B)^\alpha$ after it, with the similarity exponent $\alpha$ and a
constant $B$. With $A = 1$, $b = 1/\alpha$ and $\eta = t\,r^{-b}$ the flow is

$$u = r^{1-b}U(\eta), \qquad c^2 = r^{2-2b}S(\eta), \qquad \rho = \rho_0e^{L(\eta)}$$

* $\rho_0$: density of the gas ahead, `density`; $A$: `amplitude`, so that the shock is at the radius $A$ at the time $-1$
* $\gamma$: ratio of specific heats; $d$: 2 cylindrical, 3 spherical

With $m = 1 - b\eta U$ the equations of motion, regular at $\eta = 0$ (the moment of focusing), are

$$U'\,(m^2 - b^2\eta^2S) = -m\left[(1-b)U^2 + \tfrac{2-2b}{\gamma}S\right] - b\eta SU\left[(d-b) + \tfrac{2-2b}{\gamma}\right]$$
$$L' = \left[b\eta U' - (d-b)U\right]/m, \qquad S' = S\left[(\gamma-1)L' - (2-2b)U/m\right]$$

**Exponent.** The factor of $U'$ vanishes on a characteristic between the shock ($\eta = -1$) and $\eta = 0$, and only for one exponent
does the flow pass through it smoothly. In terms of $v = b\eta U$ and $z = b^2\eta^2S$ the flow satisfies

$$\frac{dz}{dv} = \frac{z}{v-1}\left\{\left[2(b-v) - (\gamma-1)d\,v\right]\frac{\Delta}{\Delta_1} - (\gamma-1)\right\}, \qquad
\Delta = (1-v)^2 - z, \quad \Delta_1 = z\left(d\,v - \tfrac{2(b-1)}{\gamma}\right) - v(v-b)(v-1)$$

from the shock, $v = 2/(\gamma+1)$, $z = 2\gamma(\gamma-1)/(\gamma+1)^2$, to a common zero of $\Delta$ and $\Delta_1$. With too large an
exponent $\Delta$ vanishes first, with too small an exponent $\Delta_1$, so the exponent is found by bisection. The constant $B$ is found
by bisection from the condition $v \to 2(b-1)/(d\gamma)$ at the centre.

Implementation: the crossing of the characteristic is computed by Chebyshev collocation.

Source: Guderley, Luftfahrtforschung 19 (1942) 302; Lazarus, SIAM J. Numer. Anal. 18 (1981) 316; equations derived for this project.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution

_REACH = 16.0  # the flow behind the reflected shock is integrated over this many e-foldings of eta


def _meets_sonic_first(alpha, gamma, d, tolerance):
    """Whether the curve from the shock meets Delta = 0 before Delta_1 = 0."""
    k, b = 2.0 * (1.0 / alpha - 1.0) / gamma, 1.0 / alpha

    def sonic(s, y):
        return (1.0 - y[0]) ** 2 - y[1]

    def balance(s, y):
        return y[1] * (d * y[0] - k) - y[0] * (y[0] - b) * (y[0] - 1.0)

    def along(s, y):
        delta, delta_1 = sonic(s, y), balance(s, y)
        return [-delta_1, -y[1] * ((2.0 * (b - y[0]) - (gamma - 1.0) * d * y[0]) * delta - (gamma - 1.0) * delta_1) / (y[0] - 1.0)]

    sonic.terminal = balance.terminal = True
    start = [2.0 / (gamma + 1.0), 2.0 * gamma * (gamma - 1.0) / (gamma + 1.0) ** 2]
    run = solve_ivp(along, (0.0, 1e4), start, method="DOP853", rtol=tolerance, atol=1e-14, events=[sonic, balance])
    return len(run.t_events[0]) > 0


@lru_cache(maxsize=64)
def exponent(geometry: str, gamma: float) -> float:
    """Similarity exponent alpha, to about 1e-10."""
    d = DIMENSION[geometry]
    if d == 1 or not 1.0 < gamma <= 20.0:
        raise OutOfRange(f"a converging shock must be cylindrical or spherical, with 1 < gamma <= 20, got {geometry}, gamma = {gamma:g}")
    high = 0.995
    low = next((a for a in np.arange(0.98, 0.4, -0.01) if not _meets_sonic_first(a, gamma, d, 1e-7)), None)
    if low is None or not _meets_sonic_first(high, gamma, d, 1e-7):
        raise NoSolution(f"no similarity exponent between 0.4 and 0.995 for gamma = {gamma:g}")
    high = min(high, low + 0.01) if low < 0.98 else high
    while high - low > 1e-13:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if _meets_sonic_first(middle, gamma, d, 1e-13) else (middle, high)
    return float(0.5 * (low + high))


class _Flow:
    """Right-hand sides of the equations in eta for one (gamma, d, alpha)."""

    def __init__(self, gamma, d, alpha):
        self.gamma, self.d, self.alpha, self.b = gamma, d, alpha, 1.0 / alpha

    def parts(self, eta, y):
        """(coefficient of U', the other side) of the first equation."""
        b, g = self.b, self.gamma
        u, s = y[0], y[1]
        m = 1.0 - b * eta * u
        side = -m * ((1.0 - b) * u * u + (2.0 - 2.0 * b) / g * s) - b * eta * s * u * ((self.d - b) + (2.0 - 2.0 * b) / g)
        return m * m - b * b * eta * eta * s, side

    def others(self, eta, y, slope):
        """(S', L') for a given U'."""
        m = 1.0 - self.b * eta * y[0]
        dl = (self.b * eta * slope - (self.d - self.b) * y[0]) / m
        return y[1] * ((self.gamma - 1.0) * dl - (2.0 - 2.0 * self.b) * y[0] / m), dl

    def __call__(self, eta, y):
        left, side = self.parts(eta, y)
        return [side / left, *self.others(eta, y, side / left)]

    def logarithmic(self, x, y):
        eta = np.exp(x)
        return [eta * f for f in self(eta, y)]

    def behind(self, eta, y):
        """State behind a shock that stands at eta > 0, from the state ahead."""
        g, speed = self.gamma, self.alpha / eta
        w = speed - y[0]
        mach = w * w / y[1]
        ratio = (g + 1.0) * mach / ((g - 1.0) * mach + 2.0)
        return [speed - w / ratio, y[1] * (1.0 + 2.0 * g / (g + 1.0) * (mach - 1.0)) / ratio, y[2] + np.log(ratio)]


def _cross(flow, before, start, half, count=18):
    """Carry the flow over the characteristic: (right end, state there, polynomial) on an interval of half-width `half`."""
    k = np.arange(count)
    x = -np.cos(np.pi * k / (count - 1))
    eta = start + half * (x + 1.0)
    basis = np.polynomial.chebyshev.chebvander(x, count - 1)
    slopes = np.stack([np.polynomial.chebyshev.chebval(x, np.polynomial.chebyshev.chebder(c)) for c in np.eye(count)], axis=1)
    inverse = np.linalg.inv(basis)
    derivative = slopes @ inverse / half

    def equations(flat):
        y = flat.reshape(3, count)
        dy = y @ derivative.T
        left, side = flow.parts(eta, y)
        ds, dl = flow.others(eta, y, dy[0])
        rows = np.stack([left * dy[0] - side, dy[1] - ds, dy[2] - dl])
        rows[:, 0] = y[:, 0] - before(start)
        return rows.ravel()

    # a straight line through the last smooth stretch is a good enough start for Newton's method
    near, far = before(start), before(start - half)
    guess = near[:, None] + (near - far)[:, None] / half * (eta - start)
    values, _, status, message = fsolve(equations, guess.ravel(), full_output=True, xtol=1e-13)
    if status != 1 and np.max(np.abs(equations(values))) > 1e-9:
        raise NoSolution(f"the flow could not be continued across the sonic line: {message}")
    y = values.reshape(3, count)
    coefficients = inverse @ y.T
    return eta[-1], y[:, -1], lambda e: np.polynomial.chebyshev.chebval((np.asarray(e) - start) / half - 1.0, coefficients)


class Converging(NamedTuple):
    """The similarity flow: pieces (from, to, function eta -> (U, S, L)), exponent and B of the reflected shock."""

    alpha: float
    reflected: float
    pieces: tuple


def _incoming(flow):
    """Pieces from the shock at eta = -1 through the characteristic to eta = +infinity as if nothing were reflected."""
    g = flow.gamma
    v, z = 2.0 / (g + 1.0), 2.0 * g * (g - 1.0) / (g + 1.0) ** 2
    start = [-flow.alpha * v, flow.alpha**2 * z, np.log((g + 1.0) / (g - 1.0))]

    def close(eta, y):
        return flow.parts(eta, y)[0] / (1.0 - flow.b * eta * y[0]) ** 2 + 0.05

    # Delta is negative behind the shock; stop a little before it vanishes
    close.terminal = True
    one = solve_ivp(flow, (-1.0, 0.0), start, method="DOP853", rtol=1e-12, atol=1e-13, events=close, dense_output=True)
    stop = one.t[-1]
    slope = (close(stop, one.y[:, -1]) - close(stop - 1e-4, one.sol(stop - 1e-4))) / 1e-4
    half = 0.05 / slope
    right, state, crossing = _cross(flow, one.sol, stop, half)
    two = solve_ivp(flow, (right, 20.0), state, method="DOP853", rtol=1e-12, atol=1e-13, dense_output=True)
    return [(-1.0, stop, one.sol), (stop, right, crossing), (right, two.t[-1], two.sol)]


def _approach(flow, incoming, eta):
    """The run behind a reflected shock tried at eta, and the sign with which v leaves its value at the centre."""
    centre = 2.0 * (flow.b - 1.0) / (flow.d * flow.gamma)

    def left(x, y):
        return abs(flow.b * np.exp(x) * y[0] - centre) - 0.9 * min(1.0 - centre, 1.0)

    left.terminal = True
    run = solve_ivp(flow.logarithmic, (np.log(eta), np.log(eta) + _REACH), flow.behind(eta, incoming(eta)), method="DOP853",
                    rtol=1e-12, atol=1e-300, events=left, dense_output=True)
    return run, np.sign(flow.b * np.exp(run.t[-1]) * run.y[0, -1] - centre)


@lru_cache(maxsize=16)
def converging(geometry: str, gamma: float) -> Converging:
    """The similarity flow of a converging and reflected strong shock."""
    alpha = exponent(geometry, gamma)
    flow = _Flow(gamma, DIMENSION[geometry], alpha)
    pieces = _incoming(flow)
    incoming = pieces[-1][2]
    tries = np.geomspace(0.05, pieces[-1][1], 40)
    signs = [_approach(flow, incoming, eta)[1] for eta in tries]
    turn = next((i for i in range(len(tries) - 1) if signs[i] * signs[i + 1] < 0.0), None)
    if turn is None:
        raise NoSolution(f"no reflected shock found for gamma = {gamma:g}")
    low, high = tries[turn], tries[turn + 1]
    while high - low > 4e-16 * high:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if _approach(flow, incoming, middle)[1] == signs[turn] else (low, middle)
    return Converging(alpha, float(0.5 * (low + high)), (*pieces, _approach(flow, incoming, low)[0]))


def guderley(geometry: str = "spherical", gamma: float = 1.4, density: float = 1.0, amplitude: float = 1.0) -> Solution:
    """Guderley's converging and reflected shock in cold gas, focused at time 0.

    geometry    cylindrical or spherical
    gamma       ratio of specific heats, above 1
    density     density of the gas ahead
    amplitude   A in R = A (-t)^alpha, a number without unit: the radius of the shock in m at the time -1 s

    Valid for all times: negative before focusing, positive after it. Closer to the centre than about 1e-5 of the radius of the reflected
    shock, pressure and density are kept constant.

    Fields: density, velocity, pressure, energy, sound_speed, at r > 0. Numbers: alpha (similarity exponent), reflected_time (B),
    focus_density (at time 0), reflected_density (behind the reflected shock).
    """
    if density <= 0.0 or amplitude <= 0.0:
        raise OutOfRange(f"a converging shock needs positive density and amplitude, got density = {density:g} kg/m3 and amplitude = "
                         f"{amplitude:g} m/s^alpha")
    flow = converging(geometry, gamma)
    b, pieces = 1.0 / flow.alpha, flow.pieces
    deepest = flow.reflected * np.exp(_REACH)

    def state(eta):
        values = np.zeros((3, eta.size))
        for low, high, function in pieces[:3]:
            here = (eta >= low) & (eta <= min(high, flow.reflected))
            values[:, here] = np.reshape(function(eta[here]), (3, -1)) if np.any(here) else 0.0
        here = eta > flow.reflected
        if np.any(here):
            values[:, here] = pieces[3].sol(np.log(np.minimum(eta[here], deepest)))
        return values

    def profile(r, time):
        radius = np.maximum(r / amplitude, 1e-300).ravel()
        if time > 0.0:
            held = np.maximum(radius, (time / deepest) ** flow.alpha)
        else:
            held = radius
        eta = time * held**-b
        u, s, log_density = state(eta)
        scale = amplitude * held ** (1.0 - b)
        ahead = eta < -1.0
        c2 = np.where(ahead, 0.0, scale**2 * s)
        rho = density * np.where(ahead, 1.0, np.exp(log_density))
        fields = {"density": rho, "velocity": np.where(ahead, 0.0, scale * u * radius / held), "pressure": rho * c2 / gamma,
                  "energy": c2 / (gamma * (gamma - 1.0)), "sound_speed": np.sqrt(c2)}
        return {name: np.reshape(value, r.shape) for name, value in fields.items()}

    def fronts(time):
        if time == 0.0:
            return ()
        return (amplitude * ((-time) if time < 0.0 else time / flow.reflected) ** flow.alpha,)

    just_after = pieces[3].sol(np.log(flow.reflected))
    numbers = {"alpha": flow.alpha, "reflected_time": flow.reflected, "focus_density": density * float(np.exp(pieces[2][2](0.0)[2])),
               "reflected_density": density * float(np.exp(just_after[2]))}
    return Solution(f"Guderley, {geometry}", geometry, profile, fronts, numbers, (-float("inf"), float("inf")))
