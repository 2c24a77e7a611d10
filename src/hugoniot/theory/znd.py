r"""Structure of a steady detonation (Zeldovich, von Neumann, Doering) for any law, any mixture and any rate.

The positions follow from the rate $r = d\lambda/dt$. In the frame of the front the material moves at the speed $w = m v$, so the distance
$X$ behind the front and the time since the shock are integrals over the reacted fraction,

$$\frac{dX}{d\lambda} = \frac wr, \qquad \frac{dt}{d\lambda} = \frac1r$$

Implementation: Gauss-Legendre quadrature between the states; no differential equation is integrated in steps, so stiff rates take no
longer. The variable of integration is s = -ln(1 - lambda), and near lambda = 0 it is lambda^(1/9), so that integrands of rates that begin
as a power of lambda below 1, or end as a power of 1 - lambda, are smooth.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.burn.contract import rate as burn_rate
from hugoniot.laws.mixture import contract
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.characteristics import thermicity
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.mixture import MixtureState
from hugoniot.theory.reaction_zone import OfMixture, OneLaw, Point, is_mixture
from hugoniot.theory.states import States, law_of

Rate = Callable[[float, float, float, float], float]
STARTING = (1e-4, 1e-3, 1e-2, 0.1)  # panels towards fraction 0, where a rate may begin as a power of it
PANEL = 0.35


@dataclass(frozen=True)
class Structure:
    """A steady reaction zone.

    states                     states along the zone (`States` of one equation of state, `MixtureState` of a mixture)
    velocity                   velocity D of the front, m/s
    chapman_jouguet_velocity   CJ velocity, m/s
    von_neumann                state just behind the shock
    half_reaction_length       distance from the shock to the reacted fraction 1/2, m
    half_reaction_time         time from the shock to the reacted fraction 1/2, s
    reaction                   reacted fraction
    position                   distance behind the front, m
    time                       time since the shock, s
    particle_velocity          m/s
    rates                      rate of the reacted fraction, 1/s
    temperature                K; None if it is not known
    """

    states: Any
    velocity: float
    chapman_jouguet_velocity: float
    von_neumann: States
    half_reaction_length: float
    half_reaction_time: float
    reaction: np.ndarray
    position: np.ndarray
    time: np.ndarray
    particle_velocity: np.ndarray
    rates: np.ndarray
    temperature: np.ndarray | None

    @property
    def overdrive(self) -> float:
        """(D/D_CJ)^2."""
        return (self.velocity / self.chapman_jouguet_velocity) ** 2

    def table(self) -> dict:
        """Field word -> array: the columns of a CSV file and the keys of JSON output."""
        mixed = isinstance(self.states, MixtureState)
        energy = self.states.energy if mixed else self.states.specific_internal_energy
        found = {"position": self.position, "time": self.time, "reaction": self.reaction, "reaction_rate": self.rates,
                 "pressure": self.states.pressure, "density": self.states.density, "particle_velocity": self.particle_velocity,
                 "specific_internal_energy": energy, "temperature": self.temperature, "sound_speed": self.states.sound_speed}
        if mixed:
            found |= {"reactant_density": self.states.reactant_density, "product_density": self.states.product_density,
                      "thermicity": thermicity(self.states, self.rates)}
        return found


def znd(material, initial: Initial, rate: Rate | Any, *, overdrive: float = 1.0, velocity: float | None = None, points: int = 100,
        complete: float = 1.0 - 1e-6) -> Structure:
    """The steady reaction zone behind a front.

    material    an equation of state that releases `initial.heat`, or the parameters of a mixture (`theory.mixture.mixture`)
    initial     state ahead, an `Initial`; for a mixture that of its reactants, with their thermal energy and no heat
    rate        parameters of a burn law, or a function (density, energy, pressure, fraction) that returns the rate in 1/s, positive below
                fraction 1
    overdrive   (D/D_CJ)^2, at least 1, unless `velocity` is given
    velocity    velocity D of the front, m/s
    points      number of states
    complete    fraction at which the profile ends, because with a first-order rate the burn fraction never reaches 1

    Raises OutOfRange for a velocity below the CJ velocity, a zone that chokes or a rate that never begins, NoSolution for a rate that stops
    inside the zone.
    """
    if not (points >= 3 and 0.0 < complete < 1.0):
        raise OutOfRange("a reaction zone needs at least 3 points, and a burn fraction at its end (complete) between 0 and 1")
    par, mixed = law_of(material), is_mixture(material)
    zone, least, times = zone_of(material, initial, rate, overdrive=overdrive, velocity=velocity)
    d = zone.flux / initial.density
    fractions = _stations(points, complete)
    steps = np.array([times.between(a, b) for a, b in zip(fractions, fractions[1:])])
    length, time = (np.concatenate([[0.0], np.cumsum(steps[:, k])]) for k in (0, 1))
    rows = [zone.at(float(f)) for f in fractions]
    rho = np.array([row.density for row in rows])
    rates = np.array([times.rate(row) for row in rows])
    temperature = np.array([zone.temperature(row) for row in rows])
    u = initial.velocity + d - d * initial.density / rho
    states = _mixture_states(par, rows) if mixed else States(
        par, rho, np.array([r.pressure for r in rows]), np.array([r.energy for r in rows]), u, np.full(points, initial.velocity + d),
        {"reaction": fractions, "position": length, "time": time})
    return Structure(states, d, least, zone.spike, *times.between(0.0, 0.5), fractions, length, time, u, rates,
                     temperature if np.isfinite(temperature).all() else None)


def zone_of(material, initial: Initial, rate: Rate | Any, *, overdrive: float = 1.0, velocity: float | None = None):
    """(the states of the zone by burn fraction, the Chapman-Jouguet velocity in m/s, lengths and times between fractions); see `znd`."""
    par, mixed = law_of(material), is_mixture(material)
    if not mixed and not initial.heat > 0.0:
        raise OutOfRange("a reaction zone needs heat of reaction: give an Initial with heat > 0")
    if not overdrive > 0.0:
        raise OutOfRange("a reaction zone needs a positive overdrive")
    burned = replace(initial, energy=initial.energy + par.detonation_energy, heat=0.0) if mixed else initial
    least = cj(par.products if mixed else par, burned)
    d = velocity if velocity is not None else math.sqrt(overdrive) * least.detonation_velocity
    if d < least.detonation_velocity * (1.0 - 1e-12):
        raise OutOfRange(f"a front of {d:.6g} m/s is slower than the Chapman-Jouguet velocity {least.detonation_velocity:.6g} m/s")
    x_cj = 1.0 / initial.density - 1.0 / least.state.density
    zone = OfMixture(par, initial, d) if mixed else OneLaw(par, initial, d, x_cj)
    return zone, least.detonation_velocity, _Times(zone, _rate_function(rate, zone), _limits(rate))


def _stations(points: int, complete: float) -> np.ndarray:
    """Fractions from 0 to `complete` that crowd at both ends: a rate may begin slowly, and one of first order dwells at the end."""
    early = points // 3
    turn = 0.2 * complete
    late = 1.0 - np.geomspace(1.0 - turn, 1.0 - complete, points - early)
    return np.concatenate([turn * np.linspace(0.0, 1.0, early + 1)[:-1] ** 3, late])


def _mixture_states(par, rows: Sequence[Point]) -> MixtureState:
    slopes = [contract.slopes(r.density, r.energy, r.fraction, r.mixed, par) for r in rows]
    first = [np.array([getattr(r, name) for r in rows]) for name in ("density", "energy", "fraction")]
    # the pressure of the Rayleigh line, which the mixture's search meets to round-off
    phases = np.array([r.mixed._replace(pressure=r.pressure) for r in rows], float).T
    return MixtureState(par, *first, *phases, *np.array(slopes, float).T)


def _rate_function(rate, zone) -> Callable[[Point], float]:
    """The rate at a point, 1/s, of a function or of a burn law."""
    if not BURN.knows(rate):
        return lambda point: rate(point.density, point.energy, point.pressure, point.fraction)
    law = BURN.of(rate)
    if {"programmed", "instantaneous"} & law.flags:
        raise OutOfRange(f"the burn law '{law.name}' has no reaction rate, so there is no reaction zone to compute: "
                         "use a law with a rate, such as ignition_growth, arrhenius or pressure_power")
    warm = "temperature_driven" in law.flags
    if warm and not math.isfinite(zone.temperature(zone.at(0.0))):
        raise OutOfRange(f"the burn law '{law.name}' needs a temperature, which the equation of state does not give: state its "
                         "specific_heat")
    return lambda point: float(burn_rate(point.fraction, point.density, point.pressure, zone.temperature(point) if warm else 0.0, rate))


def _limits(rate) -> tuple[float, ...]:
    """Fractions at which a burn law switches terms on or off."""
    found = [v for name, v in zip(rate._fields, rate) if name.endswith("_limit")] if BURN.knows(rate) else []
    return tuple(sorted({float(v) for v in found if 0.0 < v < 1.0}))


class _Times:
    """Lengths and times between reacted fractions of one zone."""

    def __init__(self, zone, rate: Callable[[Point], float], limits: Sequence[float]):
        self.zone, self.rate, self.breaks = zone, rate, sorted({*STARTING, *limits})
        small = [rate(zone.at(f)) for f in (1e-9, 1e-6)]
        if small[0] <= 0.0 or (small[1] > 0.0 and math.log(small[1] / small[0]) > 0.98 * math.log(1e3)):
            raise OutOfRange("the rate vanishes where nothing has burned yet, so that burning never begins in a steady zone: give the law "
                             "an ignition term, or a power of the burned fraction below 1")

    def between(self, start: float, end: float) -> tuple[float, float]:
        """(length, time) from one fraction to another, panel by panel."""
        edges = [start, *(b for b in self.breaks if start < b < end), end]
        total = np.zeros(2)
        for a, b in zip(edges, edges[1:]):
            if a == 0.0:
                total += self._panel(lambda y, top=b: (top * y**9, 9.0 * top * y**8), 0.0, 1.0)
                continue
            s1, s2 = -math.log1p(-a), -math.log1p(-b)
            inner = np.linspace(s1, s2, max(1, math.ceil((s2 - s1) / PANEL)) + 1).tolist()
            for low, high in zip(inner, inner[1:]):
                total += self._panel(lambda s: (-math.expm1(-s), math.exp(-s)), low, high)
        return float(total[0]), float(total[1])

    def _panel(self, fraction, low: float, high: float) -> np.ndarray:
        """Sixteen points of Gauss and Legendre of w/r and 1/r over a variable that `fraction` maps to (fraction, its slope)."""
        length = time = 0.0
        for node, weight in zip(_NODES, _WEIGHTS):
            f, slope = fraction(0.5 * (low + high) + 0.5 * (high - low) * node)
            point = self.zone.at(f)
            r = self.rate(point)
            if not r > 0.0:
                raise NoSolution(f"the rate is {r:.4g} 1/s at burn fraction {f:.4g}, {point.pressure:.4g} Pa: the reaction stops inside "
                                 "the zone")
            step = 0.5 * (high - low) * weight * slope / r
            time += step
            length += step * self.zone.flux / point.density
        return np.array([length, time])


_NODES, _WEIGHTS = (list(map(float, part)) for part in np.polynomial.legendre.leggauss(16))
