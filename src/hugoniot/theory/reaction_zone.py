r"""States of a steady reaction zone as functions of the reacted fraction, for one law that releases heat or for a mixture.

In the frame of the front every state lies on the Rayleigh line of the mass flux $m = \rho_0 D$. With the specific volume $v = 1/\rho$,
the index 0 for the state ahead and $x = v_0 - v$,

$$p = p_0 + m^2x, \qquad e = e_0 + p_0x + \tfrac12m^2x^2$$

and the equation of state gives the reacted fraction $\lambda$ at each $x$. For one equation of state, $e_{eos}(\rho, p)$, with the heat $Q$
it is

$$\lambda = \frac{e_{eos}(\rho, p) - e}{Q}$$

In a mixture $Q$ is part of the energy of the reactants, and $\lambda$ is found from the pressure of the mixture,

$$p_{mix}(\rho, e, \lambda) = p_0 + m^2x$$

On the branch behind a shock the flow is subsonic, that is, the frozen impedance $i = \rho c$ exceeds $m$. If $i = m$ before burning is
complete, no steady zone with that velocity exists.

Implementation: the residual of the mixture's pressure has the slope i^2 - m^2 > 0 in x, so Newton's method from the compressed side
converges monotonically.

Source: Starkenberg, ARL-TR-2161, sections 3, 5 and 6; Fickett and Davis, Detonation (1979), chapters 2 and 5.
"""

import math
from bisect import bisect_right
from dataclasses import replace
from typing import Any, NamedTuple

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import MIXTURE, Mixed
from hugoniot.materials.initial_state import energy_at_pressure
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import has


class Point(NamedTuple):
    """density kg/m3, pressure Pa, energy J/kg (with Q in a mixture), the solved mixture or None, burn fraction."""

    density: float
    pressure: float
    energy: float
    mixed: Any
    fraction: float


class OneLaw:
    """The zone of one law whose `initial.heat` is released in proportion to the reacted fraction."""

    def __init__(self, par, initial: Initial, velocity: float, x_cj: float):
        self.par, self.initial, self.v0 = par, initial, 1.0 / initial.density
        self.flux = initial.density * velocity
        self.flux2 = self.flux**2
        self.spike = shock(par, replace(initial, heat=0.0), shock_velocity=initial.velocity + velocity)
        self.spike_x = self.v0 - 1.0 / self.spike.density
        # the strong branch ends where the fraction is largest: at or before the CJ volume
        self.end_x = self._end(x_cj)

    def fraction(self, x: float) -> float:
        ahead = self.initial
        p = ahead.pressure + self.flux2 * x
        e = energy_at_pressure(1.0 / (self.v0 - x), p, self.par)
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

    def place(self, fraction: float) -> float:
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

    def at(self, fraction: float) -> Point:
        x = self.place(fraction) if fraction > 0.0 else self.spike_x
        p = self.initial.pressure + self.flux2 * x
        rho = 1.0 / (self.v0 - x)
        return Point(rho, p, float(energy_at_pressure(rho, p, self.par)), None, fraction)

    def temperature(self, point: Point) -> float:
        """K, or NaN where the law has none."""
        return float(eos.temperature(point.density, point.energy, self.par)) if has(self.par, "temperature") else math.nan


class OfMixture:
    """The zone of a mixture law: `par` holds reactants, products and Q; `initial` the unreacted explosive with its thermal energy."""

    def __init__(self, par, initial: Initial, velocity: float):
        self.par, self.initial, self.v0 = par, initial, 1.0 / initial.density
        self.velocity = velocity
        self.flux = initial.density * velocity
        self.flux2 = self.flux**2
        self.spike = shock(par.reactants, initial, shock_velocity=initial.velocity + velocity)
        q = par.detonation_energy
        self.spike_x = self.v0 - 1.0 / self.spike.density
        start = Mixed(self.spike.pressure, self.spike.density, self.spike.specific_internal_energy + q, 0.0, 0.0, 0.0)
        # solved states in order of fraction: each new search starts, and its reactant isentrope runs, from the one below
        self._fractions, self._found = [0.0], [(self.spike_x, start)]

    def energy(self, x: float) -> float:
        """J/kg with Q."""
        ahead = self.initial
        return ahead.energy + self.par.detonation_energy + ahead.pressure * x + 0.5 * self.flux2 * x * x

    def at(self, fraction: float) -> Point:
        """The state on the strong branch; OutOfRange where the flow chokes before that fraction."""
        k = bisect_right(self._fractions, fraction) - 1
        x, before = self._found[k]
        for _ in range(100):
            rho, e, p_line = 1.0 / (self.v0 - x), self.energy(x), self.initial.pressure + self.flux2 * x
            mixed = contract.equilibrate(rho, e, fraction, before, self.par)
            if mixed.status != contract.CONVERGED:
                raise NoSolution(f"the reaction zone has no mixture state at burn fraction {fraction:.6g}, {p_line:.6g} Pa: "
                                 f"{contract.MEANING[mixed.status]}")
            slope = contract.slopes(rho, e, fraction, mixed, self.par)
            excess = mixed.pressure - p_line
            rise = mixed.pressure * slope.by_energy - slope.by_volume - self.flux2
            if abs(excess) <= 2e-15 * p_line:
                break
            step = excess / rise if rise > 0.0 else math.inf
            if step > 0.25 * x:
                raise OutOfRange(f"the flow becomes sonic at burn fraction {fraction:.6g}: no steady zone runs at {self.velocity:.6g} m/s "
                                 "with this mixture; give a higher velocity (or overdrive)")
            x -= step
            if abs(step) <= 1e-15 * x:
                break
        if fraction > 1e-6 and fraction != self._fractions[k]:
            self._fractions.insert(k + 1, fraction)
            self._found.insert(k + 1, (x, mixed))
        return Point(1.0 / (self.v0 - x), self.initial.pressure + self.flux2 * x, self.energy(x), mixed, fraction)

    def temperature(self, point: Point) -> float:
        """K, or NaN where closure or laws have none."""
        parts = [getattr(self.par, role) for role in ("reactants", "products")]
        if "temperature" not in MIXTURE.of(self.par).functions or not all(has(p, "temperature") for p in parts):
            return math.nan
        return float(contract.mixture_temperature(point.fraction, point.mixed, self.par))


def is_mixture(material) -> bool:
    """Whether it is the parameter tuple of a mixture of reactants and products."""
    if MIXTURE.knows(material) and "no_reactants" in MIXTURE.of(material).flags:
        raise OutOfRange(f"a reaction zone needs reactants, which a mixture of kind '{MIXTURE.of(material).name}' does not have: use "
                         "thermal_isolation, thermal_equilibrium or weighted_pressures")
    return MIXTURE.knows(material)
