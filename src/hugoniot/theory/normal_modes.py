r"""Normal modes of a plane detonation for any law, any mixture and any rate: small disturbances of the reaction zone of `theory.znd`.

**Any equation of state, mixture and rate.** The fields are functions of the burn fraction $\lambda$ and time, so that a term of the rate
that is switched on or off at a given $\lambda$ causes no discontinuity. The rate must be positive at $\lambda = 0$. The material runs
towards $-x$: $x$ is the position relative to the displaced front, negative behind it, and the velocity $u$ is in the frame of the steady
front. With $r = d\lambda/dt$, $X = \partial x/\partial\lambda$ and the derivative $D/Dt = \partial_t + r\,\partial_\lambda$ along the path
of a particle,

$$\frac{D\rho}{Dt} = -\frac{\rho u_\lambda}X,\quad \frac{Du}{Dt} = -\frac{p_\lambda}{\rho X},\quad
  \frac{Dp}{Dt} = -\rho c^2\frac{u_\lambda}X + \left(\frac{\partial p}{\partial\lambda}\right)_{v,e} r,\quad
  \frac{Dx}{Dt} = u - \dot\psi,\quad \frac{DK}{Dt} = 0$$

* $c$: sound speed without reaction; $\psi$: displacement of the front; the index $\lambda$ denotes a derivative
* $K$: velocity of the front at which a particle was shocked, which selects the isentrope of the reactants in thermal isolation

These equations are linearised about the steady wave, in which $X = u/r$, for perturbations that vary as $e^{\alpha t}$ and begin at the
perturbed shock. $\alpha$ is a mode if no acoustic wave runs from the end of the zone towards the front, $p' + \rho c u' = 0$.

Implementation: the linear equations are integrated by Gauss-Legendre collocation of order sixteen. Its coefficients are computed once for
each zone: the slopes of rho c^2, (dp/dlambda) at v and e, and r by fourth-order differences. `theory.stability` has another form of the
equations, at given places, for one rate and law.
"""

import cmath
import math
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.burn.contract import rate as burn_rate
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import Mixed
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.reaction_zone import OneLaw
from hugoniot.theory.stability import CLOSEST, Mode, growing, nearest
from hugoniot.theory.znd import zone_of

END = 1e-10          # what is left to burn where the far condition is put
STAGES = 8
BREAKS = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1)      # panels towards burn fraction 0
PANEL = 0.5          # of -ln(1 - lambda)
STEP = 2e-3          # relative, of the differences
SOME, PLENTY = 2e-3, 0.1      # burn fractions of a mixture: the least at which slopes are taken, and that from which their steps are whole
_FOURTH = ((-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0))


class ModesOfZone:
    """The steady reaction zone of any explosive; its method `modes()` gives the growing modes.

    material, initial, rate   as for `theory.znd.znd`, with the parameters of a burn law as `rate`
    overdrive                 (D/D_CJ)^2, at least 1.0005
    panel                     length of the integration panels in -ln(1 - lambda)

    The attributes `velocity` (D, m/s), `length` (half-reaction length, m) and `time` (s) give the scales: growth rates and frequencies are
    in units of 1/`time`, with `time` = `length`/D. Raises OutOfRange and NoSolution as `znd` does, and OutOfRange for a rate that is zero
    where nothing has burned.
    """

    def __init__(self, material, initial: Initial, rate: Any, overdrive: float, panel: float = PANEL):
        if not overdrive >= CLOSEST:
            raise OutOfRange(f"the overdrive {overdrive:g} must be at least {CLOSEST:g}: at 1 the end of the zone is sonic, "
                             "and that limit can only be approached from above")
        if not BURN.knows(rate):
            raise OutOfRange("normal modes need a burn law: the derivatives of its rate by density, pressure and temperature are used")
        self.zone, self.chapman_jouguet, times = zone_of(material, initial, rate, overdrive=overdrive)
        self.par, self.initial, self.law, self.overdrive = self.zone.par, initial, rate, overdrive
        self.velocity = self.zone.flux / initial.density
        self.length, _ = times.between(0.0, 0.5)
        self.time = self.length / self.velocity
        self._warm, self._anchors = "temperature_driven" in BURN.of(rate).flags, {}
        if not times.rate(self.zone.at(0.0)) > 0.0:
            raise OutOfRange("the rate is zero where nothing has burned, so burning cannot begin by itself and the linearised "
                             "equations have no solution at the start of the reaction zone; choose a rate that is positive at zero burn "
                             "fraction, or add an ignition term")
        self._tabulate(panel, times.breaks)

    # -- the material ------------------------------------------------------------------------------------------------
    def _medium(self, rho: float, e: float, burned: float, anchor) -> np.ndarray:
        """p, rho c^2, (dp/dlambda)_{v,e} and, where the rate asks for it, T; anchor: the shocked state of isolated reactants."""
        if isinstance(self.zone, OneLaw):
            e += burned * self.initial.heat
            p, p_rho, p_e = (float(value) for value in eos.pressure_and_derivatives(rho, e, self.par))
            temperature = float(eos.temperature(rho, e, self.par)) if self._warm else 0.0
            return np.array([p, rho * p_rho + p * p_e / rho, self.initial.heat * p_e, temperature])
        mixed = contract.equilibrate(rho, e, burned, anchor, self.par)
        if mixed.status != contract.CONVERGED:
            raise NoSolution(f"near the zone no mixture state exists at burn fraction {burned:.6g}: {contract.MEANING[mixed.status]}")
        return self._mixture(rho, e, burned, mixed)

    def _mixture(self, rho, e, burned, mixed) -> np.ndarray:
        slope, p = contract.slopes(rho, e, burned, mixed, self.par), mixed.pressure
        temperature = float(contract.mixture_temperature(burned, mixed, self.par)) if self._warm else 0.0
        return np.array([p, (p * slope.by_energy - slope.by_volume) / rho, slope.by_burn_fraction, temperature])

    def _anchor(self, velocity: float):
        """The reactants behind a shock of that velocity, through which the isentrope of isolated ones runs."""
        if isinstance(self.zone, OneLaw):
            return None
        if velocity not in self._anchors:
            spike = shock(self.par.reactants, self.initial, shock_velocity=self.initial.velocity + velocity)
            e = spike.specific_internal_energy + self.par.detonation_energy
            self._anchors[velocity] = Mixed(spike.pressure, spike.density, e, 0.0, 0.0, 0.0)
        return self._anchors[velocity]

    def _medium_slopes(self, lam: float) -> np.ndarray:
        """Slopes of rho c^2, (dp/dlambda)_{v,e} and T (rows) by density at given pressure, by pressure, and by K, on the steady zone."""
        if isinstance(self.zone, OneLaw) or lam >= SOME:
            return self._differences(lam)
        # next to nothing of the products would take up what a step leaves to them: the parabola through where there are some
        y = lam / SOME
        weights = 0.5 * (2.0 - y) * (3.0 - y), (y - 1.0) * (3.0 - y), 0.5 * (y - 1.0) * (y - 2.0)
        return np.sum([weight * slopes for weight, slopes in zip(weights, self._first)], axis=0)

    @cached_property
    def _first(self) -> list[np.ndarray]:
        return [self._differences(k * SOME) for k in (1.0, 2.0, 3.0)]

    def _differences(self, burned: float) -> np.ndarray:
        mixed, d = not isinstance(self.zone, OneLaw), self.velocity
        h = STEP * min(1.0, burned / PLENTY) if mixed else STEP
        point = self.zone.at(burned)
        rho, e = point.density, point.energy - (0.0 if mixed else burned * self.initial.heat)
        scale, own = max(abs(e), point.pressure / rho), self._anchor(d)
        by_rho, by_e, by_k = np.zeros((3, 4))
        for steps, weight in _FOURTH:
            by_rho += weight / (h * rho) * self._medium(rho * (1.0 + steps * h), e, burned, own)
            by_e += weight / (h * scale) * self._medium(rho, e + steps * h * scale, burned, own)
            if mixed:
                by_k += weight / (h * d) * self._medium(rho, e, burned, self._anchor(d * (1.0 + steps * h)))
        at_p = by_e / by_e[0]
        return np.stack([by_rho - at_p * by_rho[0], at_p, by_k - at_p * by_k[0]], axis=1)[1:]

    def _rate(self, lam, rho, p, temperature) -> float:
        return float(burn_rate(lam, rho, p, temperature, self.law))

    def _rate_slopes(self, lam, rho, p, temperature, of_temperature) -> np.ndarray:
        """Slopes of the rate like those of `_medium_slopes`, whose row of the temperature is `of_temperature`."""
        total = np.zeros(3)
        for steps, weight in _FOURTH:
            total[0] += weight / (STEP * rho) * self._rate(lam, rho * (1.0 + steps * STEP), p, temperature)
            total[1] += weight / (STEP * p) * self._rate(lam, rho, p * (1.0 + steps * STEP), temperature)
            if self._warm:
                by_t = weight / (STEP * temperature) * self._rate(lam, rho, p, temperature * (1.0 + steps * STEP))
                total += by_t * of_temperature
        return total

    @cached_property
    def _shock_slopes(self) -> np.ndarray:
        """d(rho, u in the frame at rest, p)/dD behind the inert shock, SI."""
        law = self.par if isinstance(self.zone, OneLaw) else self.par.reactants
        ahead, h = replace(self.initial, heat=0.0), STEP * self.velocity
        total = np.zeros(3)
        for steps, weight in _FOURTH:
            s = shock(law, ahead, shock_velocity=ahead.velocity + self.velocity + steps * h)
            total += weight * np.array([s.density, s.particle_velocity, s.pressure]) / h
        return total

    # -- coefficients --------------------------------------------------------------------------------------------------
    def _tabulate(self, panel: float, limits) -> None:
        """A, B and a of dy/ds = (A + alpha B) y + a, y = (rho', u', p', x', K'), at the nodes s of all panels, without units."""
        edges = [0.0, *sorted({*BREAKS, *(b for b in limits if BREAKS[0] < b < 1.0 - 2.0 * END)}), 1.0 - END]
        nodes, self._weights, self._matrix = _collocation(STAGES)
        places, steps, slopes = [], [], []
        for a, b in zip(edges, edges[1:]):
            if a == 0.0:      # over the ninth root: a rate may begin as a power of the burn fraction
                places.append(b * nodes**9)
                steps.append(1.0)
                slopes.append(9.0 * b * nodes**8)
                continue
            s1, s2 = -math.log1p(-a), -math.log1p(-b)
            inner = np.linspace(s1, s2, max(2, math.ceil((s2 - s1) / panel)) + 1)
            for low, high in zip(inner, inner[1:]):
                s = low + (high - low) * nodes
                places.append(-np.expm1(-s))
                steps.append(high - low)
                slopes.append(np.exp(-s))
        self._steps = np.array(steps)
        lam, by = np.array(places), np.array(slopes)
        rows = [self._row(float(x)) for x in lam.ravel()]
        shape = (*lam.shape, 5, 5)
        constant, by_alpha, forced, run, impedance = (np.array(part) for part in zip(*rows))
        self._constant = constant.reshape(shape) * by[..., None, None]
        self._by_alpha = by_alpha.reshape(shape) * by[..., None, None]
        self._forced = forced.reshape(*lam.shape, 5) * by[..., None]
        self._run = float((run.reshape(lam.shape) * by * self._weights * self._steps[:, None]).sum())      # int dx/(u + c) through the zone
        self._impedance = float(impedance[-1])

    def _row(self, lam: float):
        """(A, B, a, dx/dlambda / (u + c), rho c) at a burn fraction, in units of the density ahead, D and the half-reaction length."""
        point = self.zone.at(lam)
        rho, p = point.density, point.pressure
        if point.mixed is None:
            _, stiffness, p_burned, temperature = self._medium(rho, point.energy - lam * self.initial.heat, lam, None)
        else:
            _, stiffness, p_burned, temperature = self._mixture(rho, point.energy, lam, point.mixed)
        medium = self._medium_slopes(lam)
        by = np.stack([medium[0], medium[1], self._rate_slopes(lam, rho, p, temperature, medium[2])])
        unit_rho, unit_u, unit_p = self.initial.density, self.velocity, self.initial.density * self.velocity**2
        by *= np.array([unit_rho, unit_p, unit_u]) / np.array([[unit_p], [unit_p], [1.0 / self.time]])
        rate = self._rate(lam, rho, p, temperature) * self.time
        return _equations(rho / unit_rho, -self.zone.flux / rho / unit_u, stiffness / unit_p, p_burned / unit_p, rate, by)

    # -- modes -------------------------------------------------------------------------------------------------------
    def residual(self, alpha: complex) -> complex:
        """Amplitude of the acoustic wave from the end of the zone towards the front, relative to alpha psi; zero for a mode."""
        y = self.perturbation(alpha)
        return complex(y[2] + self._impedance * y[1]) * cmath.exp(alpha * self._run)

    def perturbation(self, alpha: complex) -> np.ndarray:
        """(rho', u', p', x', K') where all has burned, per velocity of the front, in units of the density ahead, D and the half length."""
        count, d = len(self._steps), self.initial.density * self.velocity
        h = self._steps[:, None, None, None]
        system = h * (self._constant + alpha * self._by_alpha)                     # (panels, stages, 5, 5)
        # stages: Z_i = y + sum_j a_ij (S_j Z_j + f_j)
        left = np.eye(5 * STAGES) - np.einsum("ij,pjkl->pikjl", self._matrix, system).reshape(count, 5 * STAGES, 5 * STAGES)
        f = self._steps[:, None, None] * self._forced
        push = np.einsum("ij,pjk->pik", self._matrix, f).reshape(count, 5 * STAGES, 1)
        start = np.tile(np.eye(5), (STAGES, 1))[None].repeat(count, axis=0)
        stages = np.linalg.solve(left, np.concatenate([start, push], axis=2)).reshape(count, STAGES, 5, 6)
        moved = np.einsum("i,pikl,pilm->pkm", self._weights, system, stages)
        carry = np.eye(5) + moved[..., :5]
        added = moved[..., 5] + np.einsum("i,pik->pk", self._weights, f)
        slopes = self._shock_slopes * np.array([self.velocity / self.initial.density, 1.0, 1.0 / d])
        y = np.array([*slopes, 0.0, 1.0], dtype=complex)
        for k in range(count):
            y = carry[k] @ y + added[k]
        return y

    def mode(self, guess: complex) -> Mode:
        """The mode nearest to a guess of alpha, by the secant method; NoSolution where it diverges."""
        return nearest(self.residual, guess)

    def modes(self, highest: float = 3.0, spacing: float = 0.25) -> list[Mode]:
        """The growing modes with frequencies up to `highest`, fastest growth first; the guesses lie `spacing` apart in frequency."""
        return growing(self.residual, highest, spacing)


def _equations(rho, u, stiffness, p_burned, rate, by):
    """(A, B, a) of the linear equations at a burn fraction, dx/dlambda / (u + c), and rho c.

    by (3, 3)   slopes of stiffness, p_burned and rate (rows) by density at given pressure, by pressure, and by K
    """
    u_l = p_burned * u / (stiffness - rho * u * u)      # along the steady zone
    p_l, rho_l = -rho * u * u_l, -rho * u_l / u
    # linear forms: five coefficients, five that go with alpha, and what the moving front itself does
    unit = np.eye(11)
    density, velocity, pressure, place, shocked = unit[:5]
    growth, front = unit[5:10], unit[10]
    d_stiffness, d_burned, d_rate = (row[0] * density + row[1] * pressure + row[2] * shocked for row in by)
    place_l = (velocity - front - growth[3] - d_rate * u / rate) / rate
    first = -(growth[0] + d_rate * rho_l) / rate - density * u_l / u + rho * u_l * rate / u**2 * place_l
    second = -(growth[1] + d_rate * u_l) / rate + density * p_l / (rho * rho * u) + p_l * rate / (rho * u * u) * place_l
    third = ((d_burned * rate + p_burned * d_rate - growth[2] - d_rate * p_l) / rate - d_stiffness * u_l / u
             + stiffness * u_l * rate / u**2 * place_l)
    velocity_l = (second - third / (rho * u)) / (1.0 - stiffness / (rho * u * u))
    rows = np.array([first - rho / u * velocity_l, velocity_l, rho * u * (second - velocity_l), place_l, -growth[4] / rate])
    impedance = math.sqrt(rho * stiffness)
    return rows[:, :5], rows[:, 5:10], rows[:, 10], u / rate / (u + impedance / rho), impedance


def _collocation(stages: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes and weights of Gauss and Legendre on (0, 1), and the integrals from 0 to each node of the polynomials that are 1 at one."""
    x, weights = np.polynomial.legendre.leggauss(stages)
    to = np.polynomial.legendre.legvander(x, stages)
    count = np.arange(stages)
    # the integral of P_k from -1 is (P_{k+1} - P_{k-1}) / (2 k + 1)
    below = np.concatenate([-np.ones((stages, 1)), to[:, :stages - 1]], axis=1)
    integrals = (to[:, 1:] - below) / (2 * count + 1)
    integrals[:, 0] = x + 1.0
    lagrange = (2 * count[:, None] + 1) / 2.0 * to[:, :stages].T * weights
    return 0.5 * (x + 1.0), 0.5 * weights, 0.5 * integrals @ lagrange
