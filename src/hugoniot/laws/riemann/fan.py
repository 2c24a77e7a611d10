r"""The isentrope of a fan, from the state ahead of it to any stress, density or characteristic.

$$\frac{de}{d\ln\rho} = \frac{\sigma}{\rho}, \qquad \frac{dw}{d\ln\rho} = c, \qquad \xi = u + d\,c, \qquad u = u_0 + d\,w$$

An ideal or stiffened gas has it in closed form, a law whose pressure depends on the energy alone by quadrature. Others are integrated in
ln(rho) by Gauss-Legendre collocation with four stages (order eight; nodes and matrix are computed, not copied), steps halved until a
step and its two halves agree to 1e-13. The nodes passed are kept: a search along the fan starts from the nearest one.

Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.7 (collocation).
"""

import math

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.shock_energy import REST, ShockEnergy
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.laws.riemann import energy_alone
from hugoniot.laws.riemann.bracket import root
from hugoniot.laws.riemann.branch import Branch, State, stress_and_slopes, wave_speed_squared
from hugoniot.laws.riemann.medium import Frozen, limits_of, name_of

LARGEST, SMALLEST = 0.4, 1e-4    # steps in ln(rho)
TOLERANCE = 1e-14
NOTHING_LEFT = 1e-60             # density over the one ahead at which an expansion counts as complete
SPRAY = ("the material is stretched to the largest tension that its law '{}' supports, {:.6g} Pa: no wave can travel there, and a "
         "surface would open inside the body (use lagrange1d, or a law that supports more tension)")


def _collocation(stages: int):
    """(nodes on [0, 1], matrix, weights): integrals of the Lagrange polynomials of the Gauss nodes."""
    x, w = np.polynomial.legendre.leggauss(stages)
    nodes = 0.5 * (x + 1.0)
    matrix = np.zeros((stages, stages))
    for j in range(stages):
        others = np.delete(nodes, j)
        polynomial = np.poly1d(np.poly(others) / np.prod(nodes[j] - others)).integ()
        matrix[:, j] = polynomial(nodes) - polynomial(0.0)
    return nodes.tolist(), matrix.tolist(), (0.5 * w).tolist()


_NODES, _MATRIX, _WEIGHTS = _collocation(4)


class Fan:
    """A path (rho, e, w) along the isentrope through `ahead`, w = integral of c d ln(rho) (negative on release).

    way   -1 towards lower densities; +1 is for the waves of `spreading`
    """

    way, smallest, tolerance = -1.0, SMALLEST, TOLERANCE

    def __new__(cls, ahead: State, branch: Branch):
        if branch.a or branch.b:
            return object.__new__(Fan)
        closed = isinstance(branch.par, (IdealGas, StiffenedGas))
        return object.__new__(_ClosedFan if closed else _EnergyFan if isinstance(branch.par, ShockEnergy) else Fan)

    def __init__(self, ahead: State, branch: Branch):
        self.ahead, self.branch = ahead, branch
        self.nodes = [(0.0, ahead.e, 0.0)]        # (ln(rho/rho0), e, w), falling
        self.sigmas = [ahead.sigma]
        self._next = 0.1

    # -- the integration ---------------------------------------------------------------------------------------------
    def _rates(self, s: float, e: float) -> tuple[float, float]:
        rho = self.ahead.rho * math.exp(s)
        sigma, by_rho, by_e = stress_and_slopes(rho, e, self.branch)
        square = by_rho + sigma * by_e / (rho * rho)
        if not square >= 0.0:
            raise OutOfRange(f"law '{name_of(self.branch.par)}' becomes unstable on release at {rho:.6g} kg/m3: "
                             f"c^2 = {square:.4g} m2/s2")
        return sigma / rho, math.sqrt(square)

    def _step(self, node, h: float):
        s0, e0, w0 = node
        energies = [e0] * len(_NODES)
        rates = [self._rates(s0 + h * c, e0) for c in _NODES]
        for _ in range(60):
            moved = 0.0
            for i, row in enumerate(_MATRIX):
                new = e0 + h * sum(a * r[0] for a, r in zip(row, rates))
                moved = max(moved, abs(new - energies[i]))
                energies[i] = new
            rates = [self._rates(s0 + h * c, e) for c, e in zip(_NODES, energies)]
            if moved <= 1e-16 * max(abs(e0), rates[0][1] ** 2):
                break
        e = e0 + h * sum(b * r[0] for b, r in zip(_WEIGHTS, rates))
        return s0 + h, e, w0 + h * sum(b * r[1] for b, r in zip(_WEIGHTS, rates))

    def _extend(self) -> None:
        """One more node on the way."""
        node, h = self.nodes[-1], self._next
        while True:
            whole = self._step(node, self.way * h)
            half = self._step(self._step(node, 0.5 * self.way * h), 0.5 * self.way * h)
            scale = max(self._rates(*node[:2])[1] ** 2, self._rates(*half[:2])[1] ** 2)
            if (abs(whole[1] - half[1]) <= self.tolerance * scale and abs(whole[2] - half[2]) <= self.tolerance * math.sqrt(scale)
                    or h <= self.smallest):
                break
            h *= 0.5
        self.nodes.append(half)
        self.sigmas.append(self.state(half, 1).sigma)
        self._next = min(2.0 * h, LARGEST)

    # -- places on it ------------------------------------------------------------------------------------------------
    def state(self, node, direction: int) -> State:
        """The state at (ln(rho/rho0), e, w) of a fan that runs in `direction`."""
        s, e, w = node
        rho = self.ahead.rho * math.exp(s)
        sigma = stress_and_slopes(rho, e, self.branch)[0]
        return State(rho, self.ahead.u + direction * w, e, sigma, self.ahead.s - self.branch.b * s, self.ahead.compaction)

    def kept(self, state: State) -> State:
        """A state near the fan with the history of the fan's."""
        return state

    def speed(self, node) -> float:
        """Sound speed there, m/s."""
        return math.sqrt(wave_speed_squared(self.ahead.rho * math.exp(node[0]), node[1], self.branch))

    def _search(self, value, slope_of, target: float):
        """The node where `value(node)`, falling along the nodes, equals the target."""
        k = 0
        while value(self.nodes[-1]) > target:
            before = self.nodes[-1]
            lowest = limits_of(self.branch.par)[0]
            if before[0] < math.log(NOTHING_LEFT) or self.ahead.rho * math.exp(before[0]) <= lowest:
                raise OutOfRange(f"law '{name_of(self.branch.par)}' has no state on this release beyond "
                                 f"{self.ahead.rho * math.exp(before[0]):.6g} kg/m3")
            self._extend()
        while k + 1 < len(self.nodes) and value(self.nodes[k + 1]) > target:
            k += 1
        here, last = self.nodes[k], math.inf
        base, low = self.nodes[k], (self.nodes[k + 1][0] if k + 1 < len(self.nodes) else here[0])
        for _ in range(60):
            miss, slope = value(here) - target, slope_of(here)
            if slope == 0.0 and miss != 0.0 and target < 0.0:      # a law whose tension is cut off
                raise OutOfRange(SPRAY.format(name_of(self.branch.par), -value(here)))
            s = here[0] - miss / slope if miss else here[0]
            s = min(max(s, low), base[0])
            moved = abs(s - here[0])
            if moved <= 1e-16 or moved >= last and moved <= 1e-12:
                return here
            last, here = moved, self._step(base, s - base[0]) if s != base[0] else base
        if last <= 1e-9:
            return here
        return self._leap(value, target, base, low)

    def _leap(self, value, target: float, base, low: float):
        """The node, between `base` and the density of ln `low`, at which a value leaps across the target (slopes of a table leap)."""
        high = base[0]
        if not value(self._step(base, low - high) if low < high else base) <= target < value(base):
            raise NoSolution(f"the search for a state in the rarefaction of law '{name_of(self.branch.par)}' did not converge")
        while high - low > 1e-15 * max(1.0, abs(low)):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if value(self._step(base, middle - base[0])) <= target else (low, middle)
        return self._step(base, high - base[0]) if high != base[0] else base

    def at_stress(self, sigma: float):
        """The node of a stress below the one ahead."""
        def value(node):
            return stress_and_slopes(self.ahead.rho * math.exp(node[0]), node[1], self.branch)[0]

        def slope_of(node):
            rho = self.ahead.rho * math.exp(node[0])
            return rho * wave_speed_squared(rho, node[1], self.branch)
        return self._search(value, slope_of, sigma)

    def at_density(self, rho: float):
        """The node of a density below the one ahead."""
        return self._search(lambda node: node[0], lambda node: 1.0, math.log(rho / self.ahead.rho))

    def at_impedance(self, impedance: float):
        """The node where rho c has fallen to a value: mass in a centred fan is counted by it."""
        def value(node):
            return self.ahead.rho * math.exp(node[0]) * self.speed(node)

        def slope_of(node):
            h = 1e-4
            return (value(node) - value(self._step(node, -h))) / h
        return self._search(value, slope_of, impedance)

    def at_characteristic(self, relative: float):
        """The node whose characteristic runs with d (xi - u0) = w + c = relative."""
        def slope_of(node):   # d(w + c)/ds = c + dc/ds, the latter by differences along the isentrope
            h = 1e-4
            near = self._step(node, -h)
            c = self.speed(node)
            return c + (c - self.speed(near)) / h
        return self._search(lambda node: node[2] + self.speed(node), slope_of, relative)

    def complete(self) -> float | None:
        """w of the expansion to nothing (negative), m/s; None for a release that meets zero stress at a finite density."""
        start = self.speed(self.nodes[0])
        while self.speed(self.nodes[-1]) > 1e-14 * start and self.nodes[-1][0] > math.log(NOTHING_LEFT):
            try:
                self._extend()
            except OutOfRange:
                return None
            if self.sigmas[-1] <= 0.0:
                return None
            if (tail := self._ideal_tail()) is not None:
                return self.nodes[-1][2] - tail
        return self.nodes[-1][2]

    def _ideal_tail(self) -> float | None:
        """What is left of w, 2c/Gamma, once p = Gamma rho (e - e0) has held at two thin states in a row; None before.

        e0 is zero, or the chemical energy of what has not burned.
        """
        if len(self.nodes) < 3 or self.nodes[-2][0] > math.log(0.1):
            return None
        rest, gamma, thermal = [], 0.0, 0.0
        for node, sigma in zip(self.nodes[-2:], self.sigmas[-2:]):
            rho = self.ahead.rho * math.exp(node[0])
            gamma = stress_and_slopes(rho, node[1], self.branch)[2] / rho
            if not gamma > 0.0:
                return None
            thermal = sigma / (gamma * rho)
            rest.append(node[1] - thermal)
        heat = getattr(self.branch.par, "energy", 0.0) if isinstance(self.branch.par, Frozen) else 0.0
        if max(map(abs, rest)) > 1e-13 * thermal and abs(rest[1] - rest[0]) > 1e-14 * abs(heat):
            return None
        return 2.0 * self.speed(self.nodes[-1]) / gamma


class _ClosedFan(Fan):
    """Ideal and stiffened gas: P = p + P_inf falls as rho^gamma."""

    def __init__(self, ahead: State, branch: Branch):
        super().__init__(ahead, branch)
        self.gamma, self.stiffness = branch.par.gamma, getattr(branch.par, "p_infinity", 0.0)
        self.c = math.sqrt(max(self.gamma * (ahead.sigma + self.stiffness) / ahead.rho, 0.0))

    def _node(self, s: float):
        w = 2.0 / (self.gamma - 1.0) * self.c * math.expm1(0.5 * (self.gamma - 1.0) * s)
        # e - P_inf/rho grows as rho^(gamma - 1)
        rho0, g = self.ahead.rho, self.gamma
        thermal = (self.ahead.sigma + self.stiffness) / ((g - 1.0) * rho0) * math.exp((g - 1.0) * s)
        return s, thermal + self.stiffness / (rho0 * math.exp(s)) if s > -700.0 else 0.0, w

    def at_stress(self, sigma: float):
        if not sigma + self.stiffness > 0.0:
            raise OutOfRange(f"law '{name_of(self.branch.par)}' cannot support a stress of {sigma:.6g} Pa")
        return self._node(math.log((sigma + self.stiffness) / (self.ahead.sigma + self.stiffness)) / self.gamma)

    def at_density(self, rho: float):
        return self._node(math.log(rho / self.ahead.rho))

    def at_characteristic(self, relative: float):
        c = ((self.gamma - 1.0) * relative + 2.0 * self.c) / (self.gamma + 1.0)
        return self._node(2.0 / (self.gamma - 1.0) * math.log(c / self.c)) if c > 0.0 else self._node(-690.0)

    def at_impedance(self, impedance: float):
        least = max(impedance / (self.ahead.rho * self.c), 1e-300)
        return self._node(2.0 / (self.gamma + 1.0) * math.log(least))

    def speed(self, node) -> float:
        return self.c * math.exp(0.5 * (self.gamma - 1.0) * node[0])

    def complete(self) -> float:
        return -2.0 / (self.gamma - 1.0) * self.c


class _EnergyFan(Fan):
    """A pressure that depends on the energy alone: every place on the isentrope is known by its u_p (`energy_alone`)."""

    def __init__(self, ahead: State, branch: Branch):
        super().__init__(ahead, branch)
        self.start = energy_alone.velocity_of(ahead.sigma, branch.par)

    def _node(self, u: float):
        grown, w = energy_alone.release(u, self.start, self.branch.par)
        return -math.log1p(self.ahead.rho * grown), 0.5 * (u * u - REST * REST), w

    def state(self, node, direction: int) -> State:
        u = energy_alone.of_energy(node[1])
        sigma = self.branch.par.rho0 * (self.branch.par.c0 + u * (self.branch.par.s + u * self.branch.par.s2)) * u
        return State(self.ahead.rho * math.exp(node[0]), self.ahead.u + direction * node[2], node[1], sigma)

    def speed(self, node) -> float:
        return energy_alone.impedance(energy_alone.of_energy(node[1]), self.branch.par) / (self.ahead.rho * math.exp(node[0]))

    def _where(self, value, target: float):
        """The node where a value that falls along the isentrope equals the target; the end of it at rest or at the start."""
        ends = value(self._node(0.0)) - target, value(self._node(self.start)) - target
        if ends[0] >= 0.0 or ends[1] <= 0.0:
            return self._node(0.0 if ends[0] >= 0.0 else self.start)
        return self._node(root(lambda u: value(self._node(u)) - target, 0.0, self.start, *ends))

    def at_stress(self, sigma: float):
        return self._node(energy_alone.velocity_of(sigma, self.branch.par))

    def at_density(self, rho: float):
        return self._where(lambda node: node[0], math.log(rho / self.ahead.rho))

    def at_impedance(self, impedance: float):
        return self._where(lambda node: self.ahead.rho * math.exp(node[0]) * self.speed(node), impedance)

    def at_characteristic(self, relative: float):
        return self._where(lambda node: node[2] + self.speed(node), relative)
