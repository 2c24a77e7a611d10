r"""Shock polars of any equation of state: the pressure behind a steady oblique wave against the angle by which it deflects the stream.

A wave changes the pressure of a stream of speed q to p. **Shock** (p above the stream's): only the normal velocity changes; with
v(p) on the Hugoniot

$$u_n = v_1\sqrt{\frac{p - p_1}{v_1 - v}}, \quad \sin\beta = \frac{u_n}{q}, \quad \tan(\beta - \theta) = \frac{v}{v_1}\tan\beta$$

with $\theta$ the deflection, towards the shock. **Prandtl-Meyer fan** (p below): on the isentrope, with $q^2 + 2h$ constant and M the local
Mach number,

$$\theta(p) = -\int_p^{p_1} \frac{\sqrt{M^2 - 1}}{\rho q^2}\,dp$$

Between the pressure of largest deflection (detachment) and that of the normal shock lies the strong branch. For the ideal gas this is
the theta-beta-M relation and the Prandtl-Meyer function, which the tests compare.

Source: Courant and Friedrichs, Supersonic Flow and Shock Waves, sec. 121 and 111; Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.isentrope import isentrope
from hugoniot.theory.states import States, evaluate

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)  # on the logarithm of the pressure of a fan


@dataclass(frozen=True)
class Stream:
    """A uniform supersonic stream and every wave it can meet.

    par      parameters of its equation of state
    ahead    its state (particle_velocity is not used)
    speed    q, m/s; above the sound speed
    """

    par: Any
    ahead: States
    speed: float

    def __post_init__(self):
        if not self.mach > 1.0:
            raise OutOfRange(f"steady waves need a supersonic stream: {self.speed:.6g} m/s is Mach {self.mach:.5g}")

    @cached_property
    def mach(self) -> float:
        """Mach number of the stream."""
        c2 = contract.sound_speed_squared(self.ahead.density, self.ahead.specific_internal_energy, self.par)
        return self.speed / math.sqrt(float(c2))

    def behind(self, p: float) -> States:
        """The state behind the wave to the pressure p: shocked above the stream's pressure, expanded below."""
        if p > self.ahead.pressure:
            still = replace(self.ahead, particle_velocity=0.0)
            return shock(self.par, Initial.of(still), pressure=p)
        return isentrope(self.par, self.ahead, pressure=p)

    def shock_angle(self, p: float) -> float:
        """beta, rad: between the stream and an oblique shock to the pressure p."""
        return math.asin(min(self._normal(self.behind(p), p) / self.speed, 1.0))

    def deflection(self, p: float) -> float:
        """theta, rad: how far a wave to the pressure p turns the stream, positive for a shock (towards it), negative for a fan.

        Raises OutOfRange beyond the normal shock, and where the stream cannot expand that far.
        """
        if p == self.ahead.pressure:
            return 0.0
        if p < self.ahead.pressure:
            return -self._turning(p, self.ahead.pressure)
        state = self.behind(p)
        normal = self._normal(state, p)
        if normal > self.speed * (1.0 + 1e-12):
            raise OutOfRange(f"a shock to {p:.6g} Pa is faster than the stream: the normal shock gives {self.normal_shock:.6g} Pa")
        beta = math.asin(min(normal / self.speed, 1.0))
        return beta - math.atan2(self.ahead.density / state.density * math.sin(beta), math.cos(beta))

    def speed_behind(self, p: float) -> float:
        """Speed of the stream behind the wave, m/s: both shock and fan keep q^2/2 + h."""
        state = self.behind(p)
        return math.sqrt(max(self.speed**2 + 2.0 * (_enthalpy(self.ahead) - _enthalpy(state)), 0.0))

    @cached_property
    def normal_shock(self) -> float:
        """Pressure behind the normal shock, Pa."""
        still = replace(self.ahead, particle_velocity=0.0)
        return float(shock(self.par, Initial.of(still), shock_velocity=self.speed).pressure)

    @cached_property
    def detachment(self) -> tuple[float, float]:
        """(pressure, deflection) of the largest deflection by a shock, by golden section between the stream and the normal shock."""
        low, high = self.ahead.pressure, self.normal_shock
        ratio = 0.5 * (math.sqrt(5.0) - 1.0)
        a, b = high - ratio * (high - low), low + ratio * (high - low)
        fa, fb = self.deflection(a), self.deflection(b)
        for _ in range(70):
            if fa < fb:
                low, a, fa = a, b, fb
                b = low + ratio * (high - low)
                fb = self.deflection(b)
            else:
                high, b, fb = b, a, fa
                a = high - ratio * (high - low)
                fa = self.deflection(a)
        p = 0.5 * (low + high)
        return p, self.deflection(p)

    def shock_polar(self, points: int = 201) -> tuple[np.ndarray, np.ndarray]:
        """(deflection rad, pressure Pa) of the whole polar, from the undisturbed stream over detachment to the normal shock."""
        share = np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, points))  # denser towards the normal shock, where the curve is steep
        p = self.ahead.pressure + (self.normal_shock - self.ahead.pressure) * share
        return np.array([self.deflection(float(v)) if v < self.normal_shock * (1.0 - 1e-14) else 0.0 for v in p]), p

    def fan(self, p: float, points: int = 201) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(pressure Pa, deflection rad, Mach angle rad) along the fan from the stream's pressure down to p."""
        pressures = self.ahead.pressure * (p / self.ahead.pressure) ** np.linspace(0.0, 1.0, points)
        turned = np.array([self._turning(float(b), float(a)) for a, b in zip(pressures, pressures[1:])])
        q2, c2, _ = self._along(pressures)
        return pressures, -np.concatenate([[0.0], np.cumsum(turned)]), np.arcsin(np.minimum(np.sqrt(c2 / q2), 1.0))

    def _normal(self, state: States, p: float) -> float:
        v1, v = 1.0 / self.ahead.density, 1.0 / state.density
        return v1 * math.sqrt(max(p - self.ahead.pressure, 0.0) / (v1 - v)) if v1 > v else 0.0

    def _turning(self, low: float, high: float) -> float:
        """Turning angle of the part of the fan between two pressures, rad."""
        if not low > 0.0:
            raise OutOfRange(f"the final pressure of a fan must be positive, got {low:.6g} Pa")
        middle, half = 0.5 * math.log(low * high), 0.5 * math.log(high / low)
        p = np.exp(middle + half * _NODES)
        q2, c2, rho = self._along(p)
        return float(half * np.sum(_WEIGHTS * np.sqrt(np.maximum(q2 / c2 - 1.0, 0.0)) * p / (rho * q2)))

    def _along(self, p: np.ndarray):
        """(q^2, c^2, rho) on the isentrope through the stream, at an array of pressures."""
        states = isentrope(self.par, self.ahead, pressure=p)
        rho, e = np.asarray(states.density), np.asarray(states.specific_internal_energy)
        q2 = self.speed**2 + 2.0 * (_enthalpy(self.ahead) - (e + p / rho))
        return q2, evaluate(contract.sound_speed_squared, rho, e, self.par), rho


def _enthalpy(state: States) -> float:
    return float(state.specific_internal_energy + state.pressure / state.density)


@dataclass(frozen=True)
class Meeting:
    """Two streams behind the waves of their meeting: one pressure, one direction (rad), and the slip line between them."""

    below: Stream
    above: Stream
    pressure: float
    direction: float


def meeting(below: Stream, above: Stream, angle: float = 0.0) -> Meeting:
    """The steady Riemann problem: where the waves of two streams that meet at a point leave equal pressure and direction.

    angle   of the upper stream to the lower one, rad; negative: it flows into the lower one. Weak shocks are taken.
    Raises NoSolution where no pair of attached weak waves exists (irregular reflection), naming the largest deflection there is.
    """
    def excess(p: float) -> float:  # how far the two turn apart, less what parts them; rises with p
        return below.deflection(p) + above.deflection(p) + angle

    high = min(below.detachment[0], above.detachment[0])
    if high <= max(below.ahead.pressure, above.ahead.pressure) and excess(high) < 0.0:
        raise NoSolution("no attached shock raises the stream of lower pressure to the pressure of the other")
    if excess(high) < 0.0:
        raise NoSolution(f"the streams meet at {math.degrees(-angle):.5g} degrees; attached weak shocks can deflect them by at most "
                         f"{math.degrees(below.deflection(high) + above.deflection(high)):.5g} degrees: the wave detaches")
    low = min(below.ahead.pressure, above.ahead.pressure)
    while excess(low) > 0.0:
        if low < 1e-9 * high or low <= 0.0:
            raise NoSolution("the streams move apart faster than they can expand: a vacuum opens between them")
        low *= 0.7
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0.0 else (low, middle)
        if high - low <= 4e-16 * high:
            break
    p = 0.5 * (low + high)
    return Meeting(below, above, p, -below.deflection(p))
