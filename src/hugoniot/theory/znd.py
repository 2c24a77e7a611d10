r"""Structure of a steady detonation (Zeldovich, von Neumann, Doering) for any law and any rate.

Every state lies on the Rayleigh line of mass flux $m = \rho_0 D$ and differs only in the fraction $\lambda$ reacted, which
releases $\lambda Q$ into the same law. With $x = v_0 - v$, $p = p_0 + m^2 x$ and the law's inverse $e(\rho, p)$,

$$\lambda(x)\,Q = e(\rho, p) - e_0 - p_0 x - \tfrac12 m^2 x^2,$$

falls from the von Neumann spike to the end of reaction, and in the frame of the front $dX/d\lambda = w/r$, $w = m v$, for a rate
$r = d\lambda/dt$. Distances follow by Gauss-Legendre quadrature between the states; no ordinary differential equation is stepped,
so stiffness costs nothing. Source: 003 section 6; Fickett and Davis, Detonation.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import States, energy_at, law_of

Rate = Callable[[float, float, float, float], float]


@dataclass(frozen=True)
class Structure:
    """`states` (fields along the zone; extra: reaction, position behind the front in m, time since the shock in s), velocities in m/s."""

    states: States
    velocity: float
    chapman_jouguet_velocity: float
    von_neumann: States
    half_reaction_length: float
    half_reaction_time: float

    @property
    def overdrive(self) -> float:
        """f = (D / D_CJ)^2."""
        return (self.velocity / self.chapman_jouguet_velocity) ** 2


def znd(material, initial: Initial, rate: Rate, *, overdrive: float = 1.0, velocity: float | None = None, points: int = 100,
        complete: float = 1.0 - 1e-6) -> Structure:
    """The steady reaction zone behind a front.

    initial     the state ahead; its `heat` is Q, released in proportion to the reaction
    rate        function (density, energy, pressure, fraction) -> d(fraction)/dt, 1/s, positive below fraction 1
    overdrive   f = (D/D_CJ)^2 >= 1, unless `velocity` (m/s) is given
    complete    fraction at which the profile ends: a first-order rate never finishes
    Raises `OutOfRange` for a velocity below the CJ one or a rate that stops inside the zone.
    """
    par = law_of(material)
    if not initial.heat > 0.0:
        raise OutOfRange("a reaction zone needs heat of reaction: give an Initial with heat > 0")
    least = cj(par, initial)
    d = velocity if velocity is not None else math.sqrt(overdrive) * least.detonation_velocity
    if d < least.detonation_velocity * (1.0 - 1e-12):
        raise OutOfRange(f"a front of {d:.6g} m/s is slower than the Chapman-Jouguet velocity {least.detonation_velocity:.6g} m/s")
    spike = shock(par, replace(initial, heat=0.0), shock_velocity=initial.velocity + d)
    zone = _Zone(par, initial, d, spike, 1.0 / initial.density - 1.0 / least.state.density)
    # nodes crowd towards complete reaction, where a first-order rate dwells
    fractions = 1.0 - np.geomspace(1.0, 1.0 - complete, points)
    length, time = np.zeros(points), np.zeros(points)
    for i in range(1, points):
        dx, dt = zone.between(fractions[i - 1], fractions[i], rate)
        length[i], time[i] = length[i - 1] + dx, time[i - 1] + dt
    half = zone.between(0.0, 0.5, rate)
    rows = np.array([zone.state(f) for f in fractions])
    u = initial.velocity + d - d * initial.density / rows[:, 0]
    states = States(par, rows[:, 0], rows[:, 1], rows[:, 2], u, np.full(points, initial.velocity + d),
                    {"reaction": fractions, "position": length, "time": time})
    return Structure(states, d, least.detonation_velocity, spike, *half)


class _Zone:
    """States of one reaction zone by reacted fraction."""

    def __init__(self, par, initial: Initial, velocity: float, spike: States, x_cj: float):
        self.par, self.initial, self.v0 = par, initial, 1.0 / initial.density
        self.flux2 = (initial.density * velocity) ** 2
        self.flux = initial.density * velocity
        self.spike_x = self.v0 - 1.0 / spike.density
        # the strong branch ends where the fraction is largest: at or before the CJ volume
        self.end_x = self._end(x_cj)

    def fraction(self, x: float) -> float:
        ahead = self.initial
        p = ahead.pressure + self.flux2 * x
        e = energy_at(self.par, 1.0 / (self.v0 - x), p)
        return (e - ahead.energy - ahead.pressure * x - 0.5 * self.flux2 * x * x) / ahead.heat

    def _end(self, x_cj: float) -> float:
        low, high = x_cj, self.spike_x
        if self.fraction(low) <= 1.0:
            return low
        for _ in range(200):
            x = 0.5 * (low + high)
            low, high = (x, high) if self.fraction(x) > 1.0 else (low, x)
            if high - low <= 1e-16 * high:
                break
        return 0.5 * (low + high)

    def at(self, fraction: float) -> float:
        """x of the strong branch at a fraction: bisection and secants in [end, spike], where the fraction falls with x."""
        low, high = self.end_x, self.spike_x
        f_low, f_high = self.fraction(low) - fraction, -fraction
        if f_low <= 0.0:
            return low
        for i in range(200):
            x = (low * f_high - high * f_low) / (f_high - f_low) if i % 3 else 0.5 * (low + high)
            if not low < x < high:
                x = 0.5 * (low + high)
            f = self.fraction(x) - fraction
            if f > 0.0:
                low, f_low = x, f
            else:
                high, f_high = x, f
            if f == 0.0 or high - low <= 1e-15 * high:
                break
        return x

    def state(self, fraction: float):
        x = self.at(fraction) if fraction > 0.0 else self.spike_x
        p = self.initial.pressure + self.flux2 * x
        rho = 1.0 / (self.v0 - x)
        return rho, p, energy_at(self.par, rho, p)

    def between(self, start: float, end: float, rate: Rate):
        """(length, time) from one fraction to another: Gauss-Legendre in -ln(1 - fraction), 16 points on panels of at most 0.35."""
        s1, s2 = -math.log1p(-start), -math.log1p(-end)
        panels = max(1, math.ceil((s2 - s1) / 0.35))
        length = time = 0.0
        for k in range(panels):
            a, b = s1 + (s2 - s1) * k / panels, s1 + (s2 - s1) * (k + 1) / panels
            for node, weight in zip(_NODES, _WEIGHTS):
                s = 0.5 * (a + b) + 0.5 * (b - a) * node
                left = math.exp(-s)
                rho, p, e = self.state(1.0 - left)
                r = rate(rho, e, p, 1.0 - left)
                if not r > 0.0:
                    raise NoSolution(f"the rate is {r:.4g} 1/s at fraction {1.0 - left:.4g}, {p:.4g} Pa: "
                                     "the reaction stops inside the zone")
                step = 0.5 * (b - a) * weight * left / r
                time += step
                length += step * self.flux / rho
        return length, time


_NODES, _WEIGHTS = (list(map(float, part)) for part in np.polynomial.legendre.leggauss(16))
