r"""Compaction waves that spread: a fan of rising stress along a crush curve that bends like that of no gas.

Where the curve p(v) of the closing pores is concave, weak waves run ahead of stronger ones. The wave that closes pores then is a fan

$$\frac{de}{d\ln\rho} = \frac{p}{\rho}, \qquad \frac{dw}{d\ln\rho} = c,$$

as long as the impedance rho c falls along it, and, for stresses beyond, a shock from that state of the fan whose characteristic runs with
it,

$$\frac{p - p_t}{v_t - v} = (\rho c)_t^2 .$$

Together they are the upper concave hull of the crush curve. The law p_lambda with an exponent above 1 is of this kind; p_alpha, snow_plough
and p_lambda with the exponent 1 have convex curves and shocks alone.

Source: Oleinik, Uspekhi Mat. Nauk 14 (1959) 165, and Liu, J. Differ. Equations 18 (1975) 218, for the waves of laws that are not convex;
Zel'dovich and Raizer, Physics of Shock Waves, chapter XI, section 20.
"""

import math
from bisect import bisect_left
from itertools import pairwise

from hugoniot.laws.eos.contract import compacted
from hugoniot.laws.riemann import jump
from hugoniot.laws.riemann.bracket import root
from hugoniot.laws.riemann.branch import Branch, State, stress, wave_speed_squared
from hugoniot.laws.riemann.fan import Fan

AT_LIMIT = 1e-12      # of the stiffness: stress that close to the elastic limit is at it
NARROW = 1e-9         # of the sound speed: waves whose speeds differ by less run together
ABOVE = 1e-9          # of the density: how far above a kink its upper slopes are looked at
SMALLEST = 1e-9       # step in ln(rho): the slope of a crush curve may begin with a power of the stress
SHORT = 1e-3         # of the last step of a fan: so close to its end the impedance is still falling, or a shock is due
FEEBLE = 1e-6         # of the stiffness: rise of a jump whose speed is that of sound but for rounding
CARELESS = 1e-6       # of a squared speed
OVERTAKEN = ("law '{}': the compaction shock to {:.6g} Pa would outrun the sound behind it, because the uncompacted material there "
             "is hardly less dense than the compacted one; use a stiffer matrix (matrix_modulus), or lagrange1d")
REVERSED = "law '{}': a compaction wave would spread ahead of its elastic precursor; use lagrange1d"


def loading_square(state: State, branch: Branch) -> float:
    """c^2 (m2/s2) of the weakest wave that closes pores beyond a state at its elastic limit."""
    e = state.e + ABOVE * state.sigma / state.rho
    return max(wave_speed_squared(state.rho * (1.0 + ABOVE), e, branch), 0.0)


def overtaken(behind: State, flux: float, branch: Branch, missed: float = 0.0) -> bool:
    """Whether sound behind a shock that closes pores is slower than it: no such shock lasts.

    missed   share of its rise by which the state ahead may have missed the elastic limit
    """
    square = wave_speed_squared(behind.rho * (1.0 - ABOVE), behind.e - ABOVE * behind.sigma / behind.rho, branch)
    return not behind.rho * behind.rho * square >= (1.0 - CARELESS - 2.0 * missed) * flux * flux


def crushed(state: State, par) -> State:
    """The state with the pores closed that it closes."""
    return state._replace(compaction=float(compacted(state.compaction, state.rho, state.e, state.sigma, par)))


class Spreading(Fan):
    """The fan of a compaction wave, from a state at its elastic limit towards higher stresses; `first` is the law of the first loading."""

    way, smallest, tolerance = 1.0, SMALLEST, 1e-12

    def __new__(cls, ahead: State, branch: Branch, first):
        return object.__new__(cls)

    def __init__(self, ahead: State, branch: Branch, first):
        super().__init__(ahead, branch)
        self.first, self._next = first, SMALLEST

    def until(self, node) -> "Spreading":
        """The part of the fan up to a node."""
        while self.nodes[-1][0] < node[0]:
            self._extend()
        part = Spreading(self.ahead, self.branch, self.first)
        part.nodes = [*(one for one in self.nodes if one[0] < node[0]), node]
        part.sigmas = [*self.sigmas[:len(part.nodes) - 1], self.state(node, 1).sigma]
        return part

    def state(self, node, direction: int) -> State:
        return crushed(super().state(node, direction), self.first)

    def kept(self, state: State) -> State:
        return crushed(state, self.first)

    def impedance(self, node) -> float:
        """rho c there, kg/m2/s."""
        return self.ahead.rho * math.exp(node[0]) * self.speed(node)

    def _search(self, value, slope_of, target: float):
        """The node, between two of a fan that ends, where a value falls to the target; the last one where rounding leaves it above."""
        for low, high in pairwise(self.nodes):
            if value(high) <= target:
                return self._root(lambda node: value(node) - target, low, high[0] - low[0])
        return self.nodes[-1]

    def _root(self, value, base, most: float):
        """The node at most `most` beyond a node where a value changes its sign."""
        ends = value(base), value(self._step(base, most))
        if ends[0] * ends[1] > 0.0:
            return base if abs(ends[0]) < abs(ends[1]) else self._step(base, most)
        step = root(lambda step: value(self._step(base, step)), 0.0, most, *ends)
        return self._step(base, step) if step else base

    def at_stress(self, sigma: float):
        """The node of a stress above the one ahead: Newton's method between two nodes."""
        while self.sigmas[-1] < sigma:
            self._extend()
        k = next(k for k, found in enumerate(self.sigmas) if found >= sigma) - 1
        base, most = self.nodes[k], self.nodes[k + 1][0] - self.nodes[k][0]
        step, last = most * (sigma - self.sigmas[k]) / (self.sigmas[k + 1] - self.sigmas[k]), math.inf
        for _ in range(20):
            node = self._step(base, step)
            rho = self.ahead.rho * math.exp(node[0])
            new = step - (stress(rho, node[1], self.branch) - sigma) / (rho * self.speed(node) ** 2)
            moved = abs(new - step)
            if moved <= 1e-15 * most or (moved >= last and moved <= 1e-11 * most):
                return node
            if not 0.0 < new <= most:
                break
            last, step = moved, new
        return self._root(lambda node: self.state(node, 1).sigma - sigma, base, most)

    def shock_to(self, sigma: float):
        """The node at which a shock to a stress leaves the fan; None where the fan reaches that stress by itself."""
        def excess(node):
            """Mass flux of the shock over the impedance it leaves from, less 1: it grows along the fan."""
            return jump.behind(sigma, self.state(node, 1), self.branch, 1, None, self.speed(node) ** 2)[1] / self.impedance(node) - 1.0

        while self.sigmas[-1] < sigma and (len(self.nodes) < 2 or self.impedance(self.nodes[-1]) < self.impedance(self.nodes[-2])):
            self._extend()
        below = [node for node, found in zip(self.nodes, self.sigmas) if found < sigma]
        if self.sigmas[-1] >= sigma:      # short of it the impedance has fallen all the way, or a shock takes over
            end = self.at_stress(sigma)
            near = self._step(below[-1], (1.0 - SHORT) * (end[0] - below[-1][0]))
            if self.impedance(end) < self.impedance(near):
                return None
            below.append(near)
        first = bisect_left(below, 0.0, 1, len(below) - 1, key=excess)
        return self._root(excess, below[first - 1], below[first][0] - below[first - 1][0])
