r"""Constants of a deck from measured records: weighted least squares with bounds, over runs of the deck.

The parameters are sought in coordinates of their own ranges (0 to 1; of a parameter with a prior, its standard deviations). Shifts and
scales of the records (`targets`) are parameters too, for which no run is needed. The sum of squares

$$\chi^2 = \sum_i \rho\!\left(r_i^2\right) + \sum_k c_k^2$$

contains the residuals of all targets, with the loss $\rho$, and the priors, to which no loss applies. Results change in small jumps (a
void opens in one zone or in the next), so that derivatives are useless. The search is therefore Gauss and Newton's method without
derivatives: a plane is fitted to the residuals of a sample of runs. The sample spans what the data can distinguish, in the end two
standard deviations. Searches begin at the best points of a sample of the ranges, so that a wrong minimum is noticed; if none of them
matches the data, differential evolution searches further. With J the slopes of the plane, the covariance is $(J^T J)^{-1}$, times the
reduced $\chi^2$ if that exceeds one, plus the scatter of the parameters due to the deviations of the sample from the plane.

Sources: C. Cartis, J. Fiala, B. Marteau, L. Roberts, ACM Trans. Math. Softw. 45 (2019) 32, for planes by regression; R. Storn, K. Price,
J. Global Optim. 11 (1997) 341 (`scipy.optimize.differential_evolution`).
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy import optimize, stats

from hugoniot.campaign.plan import Plan
from hugoniot.campaign.planes import RHO, WEIGHT, Minimum, Plane, through
from hugoniot.campaign.targets import Target
from hugoniot.campaign.variables import Variable
from hugoniot.errors import NoSolution

REACH = 0.06          # of a range: how far the first sample of a search goes
LEAST_REACH = 2e-4    # of a range, the last one
LEAST_SAMPLE = 10     # points of a sample
ROUNDS = 14           # of one search, at most
POPULATION, GENERATIONS = 6, 25    # of differential evolution: members for each parameter
PRIOR_ENDS = 5.0      # standard deviations of a prior within which is sought
PER_PARAMETER = 8     # sampled starting points for each parameter
SAME = 0.05           # of a range: minima that are nearer are one
JUMPS = 1.0           # rise of the sum of squares for each parameter that jumps of the runs may cost the middle of a plane


@dataclass(frozen=True)
class Free:
    """A parameter of the deck that is sought: a variable with a range, or with a mean and a standard deviation (a prior)."""

    variable: Variable

    @property
    def prior(self) -> bool:
        """Whether a mean and a standard deviation are known beforehand."""
        return self.variable.kind == "normal"

    @property
    def ends(self) -> tuple[float, float]:
        return (-PRIOR_ENDS, PRIOR_ENDS) if self.prior else (0.0, 1.0)

    def given(self, c: float) -> Any:
        """What the deck is given at a coordinate."""
        return self.variable.given(self.variable.low + c * self.variable.high) if self.prior else self.variable.at(c)

    def value(self, c: float) -> float:
        """The SI value at a coordinate."""
        return self.variable.number(self.given(c))

    def coordinate(self, value: float) -> float | None:
        """The coordinate of an SI value; None outside the range."""
        low, high = (self.value(end) for end in self.ends)
        if not low <= value <= high:
            return None
        share = math.log(value / low) / math.log(high / low) if self.variable.kind == "log" else (value - low) / (high - low)
        return self.ends[0] + share * (self.ends[1] - self.ends[0])


@dataclass
class Problem:
    """A fit: parameters, targets, and a function that runs the deck at several points (see `answers`).

    shift, scale   largest magnitude of the shift (s) and the scale of each file, 0 for none
    smooth         the runs answer without jumps: a plane needs few of them
    ask            ask(changes of each case) -> answers, with "records" {name: (times, values)} or a "reason"
    """

    plan: Plan
    free: tuple[Free, ...]
    targets: tuple[Target, ...]
    clocks: int
    shift: float
    scale: float
    loss: str
    ask: Callable[[list[dict]], list[dict]]
    runs: int = 0
    seen: dict[tuple, dict] = field(default_factory=dict)
    smooth: bool = False

    # -- coordinates -------------------------------------------------------------------------------------------------
    @property
    def names(self) -> list[str]:
        """Of every coordinate: keys of the deck, then shifts and scales of the files."""
        several = [f" {k + 1}" if self.clocks > 1 else "" for k in range(self.clocks)]
        return [*(f.variable.name for f in self.free), *([f"shift{s}" for s in several] if self.shift else []),
                *([f"scale{s}" for s in several] if self.scale else [])]

    @property
    def units(self) -> list[str]:
        """SI units of the coordinates' values."""
        shifts, scales = ["s"] * self.clocks if self.shift else [], ["1"] * self.clocks if self.scale else []
        return [*(f.variable.si for f in self.free), *shifts, *scales]

    @property
    def ends(self) -> tuple[np.ndarray, np.ndarray]:
        """(lowest, highest) coordinates."""
        nuisance = len(self.names) - len(self.free)
        pairs = [f.ends for f in self.free] + [(-1.0, 1.0)] * nuisance
        return np.array([low for low, _ in pairs]), np.array([high for _, high in pairs])

    def value(self, k: int, c: float) -> float:
        """The SI value of coordinate k."""
        if k < len(self.free):
            return self.free[k].value(c)
        return c * (self.shift if self.shift and k < len(self.free) + self.clocks else self.scale)

    def clock(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(shift, scale) of each file."""
        rest = x[len(self.free):]
        shifts = self.shift * rest[:self.clocks] if self.shift else np.zeros(self.clocks)
        scales = self.scale * rest[-self.clocks:] if self.scale else np.zeros(self.clocks)
        return shifts, scales

    def model(self, x: np.ndarray, target: Target, answer: dict) -> np.ndarray:
        """What an answer has for a target with the shift and the scale of a point."""
        shifts, scales = self.clock(x)
        return target.model(answer, *((float(shifts[target.clock]), float(scales[target.clock])) if target.clock >= 0 else ()))

    # -- runs --------------------------------------------------------------------------------------------------------
    def answers(self, points: Sequence[np.ndarray]) -> list[dict]:
        """What the deck answers at some points; each is run once."""
        keys = [tuple(float(c) for c in x[:len(self.free)]) for x in points]
        fresh = [key for key in dict.fromkeys(keys) if key not in self.seen]
        changes = [self.plan.changes_of([f.given(c) for f, c in zip(self.free, key)]) for key in fresh]
        for key, answer in zip(fresh, self.ask(changes) if fresh else []):
            self.seen[key] = answer
        self.runs += len(fresh)
        return [self.seen[key] for key in keys]

    def residuals(self, x: np.ndarray, answer: dict | None = None) -> np.ndarray:
        """Of all targets, then of the priors."""
        answer = self.answers([x])[0] if answer is None else answer
        prior = np.array([c for c, f in zip(x, self.free) if f.prior])
        if "numbers" not in answer:     # a case that failed fits nothing
            return np.concatenate([*(3.0 * np.abs(t.values) / t.sigma + 3.0 for t in self.targets), prior])
        shifts, scales = self.clock(x)
        return np.concatenate([*(t.residuals(answer, *((shifts[t.clock], scales[t.clock]) if t.clock >= 0 else ())) for t in self.targets),
                               prior])

    def cost(self, x: np.ndarray, answer: dict | None = None) -> float:
        """The sum of squares with the loss."""
        squares = self.residuals(x, answer) ** 2
        data = self.data_of(squares)
        return float(np.sum(RHO[self.loss](data)) + np.sum(squares[data.size:]))

    def data_of(self, residuals: np.ndarray) -> np.ndarray:
        """Those of `residuals` that belong to data, not to priors."""
        return residuals[:residuals.size - sum(f.prior for f in self.free)]

    def weight(self, residuals: np.ndarray) -> np.ndarray:
        """The weights (nresidual,) of iterated least squares."""
        data = self.data_of(residuals)
        return np.append(WEIGHT[self.loss](data**2), np.ones(residuals.size - data.size))

    # -- searches ------------------------------------------------------------------------------------------------------
    def search(self, start: np.ndarray, fixed: Sequence[int] = (), rounds: int = ROUNDS, reach: np.ndarray | None = None) -> Minimum:
        """The minimum near a start; coordinates `fixed` stay. `reach` is how far the first sample goes (a share of the ranges by default).

        Each round samples the parameters round the best point, fits a plane to the residuals over the sample, and goes where that plane
        has its least squares within twice the sample; the sample shrinks to twice the standard deviations.
        """
        low, high = self.ends
        count = len(self.free)
        moving = np.array([k for k in range(count) if k not in fixed], dtype=int)
        x = np.array(start, dtype=float) if fixed else self.with_best_nuisance(np.array(start, dtype=float))
        reach = REACH * (high - low) if reach is None else np.array(reach)
        best, quiet, plane = self.cost(x), 0, Plane.nothing(len(x))
        for k in range(rounds):
            sample = self._sample(x, moving, reach, k)
            plane = self._plane(x, moving, sample)
            step = plane.step(x, (low, high), 2.0 * reach, fixed)
            answers = self.answers([x + step])
            there = x + step if fixed or "numbers" not in answers[0] else self.with_best_nuisance(x + step)
            costs = [self.cost(point) for point in [*sample, there]]
            least = int(np.argmin(costs))
            spread = plane.spread()
            moved = 0.0
            if costs[least] < best:
                better = [*sample, there][least]
                moved = float(np.max(np.abs(better - x) / np.maximum(spread, 1e-12)))
                x, best = better, costs[least]
            wanted = np.clip(2.0 * spread, LEAST_REACH * (high - low), 0.25 * (high - low))
            fits = np.all(np.abs(np.log(np.maximum(reach[moving], 1e-300) / wanted[moving])) < 0.5) if len(moving) else True
            reach = np.clip(wanted, reach / 3.0, 1.5 * reach)
            quiet = quiet + 1 if moved < 0.5 and fits else 0
            if quiet >= 2:
                break
        sample = self._sample(x, moving, reach, rounds)
        x, sample = (x, sample) if fixed else self._middle(x, moving, reach)
        plane = self._plane(x, moving, sample)
        return Minimum(x, self.cost(x), plane.slopes, plane.weight, plane.rough, quiet >= 1, best)

    def _middle(self, x: np.ndarray, moving: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
        """(where the plane through all runs near the best point has its least squares, those runs).

        Where the runs answer in jumps, the best one is best by chance, anywhere on its step; the plane takes the mean over the steps, and
        it is for its least squares that the covariance holds. The best point stays where that place fits worse than jumps explain.
        """
        count = len(self.free)
        near = [np.array(key) for key in self.seen if np.all(np.abs(np.array(key) - x[:count]) <= 1.001 * reach[:count])]
        sample = [np.concatenate([key, x[count:]]) for key in near if not np.array_equal(key, x[:count])]
        plane = self._plane(x, moving, sample)
        middle = x + plane.step(x, self.ends, reach, ())
        middle = self.with_best_nuisance(middle) if "numbers" in self.answers([middle])[0] else x
        scatter = max(self.cost(x) / max(plane.offset.size - len(x), 1), 1.0)
        return (middle if self.cost(middle) - self.cost(x) <= JUMPS * len(x) * scatter else x), sample

    def _sample(self, x: np.ndarray, moving: np.ndarray, reach: np.ndarray, seed: int) -> list[np.ndarray]:
        """Points round x, each run."""
        if not len(moving):
            return []
        low, high = self.ends
        size = 2 * len(moving) + 1 if self.smooth else max(2 * len(moving) + 4, LEAST_SAMPLE)
        shares = 2.0 * stats.qmc.LatinHypercube(len(moving), seed=seed).random(size) - 1.0
        points = []
        for share in shares:
            point = x.copy()
            point[moving] = np.clip(x[moving] + reach[moving] * share, low[moving], high[moving])
            points.append(point)
        self.answers([x, *points])
        return points

    def _plane(self, x: np.ndarray, moving: np.ndarray, sample: list[np.ndarray]) -> Plane:
        """The plane through the residuals of a sample round x; slopes in shifts and scales need no runs."""
        here = self.residuals(x)
        slopes = np.zeros((here.size, len(x)))
        offset, rough = here, np.zeros((0, here.size))
        if len(moving):
            away = np.array([point[moving] - x[moving] for point in sample])
            offset, slopes[:, moving], rough = through(here, away, np.array([self.residuals(point) for point in sample]))
        answer = self.answers([x])[0]
        for k in range(len(self.free), len(x)):
            ahead, behind = _moved(x, k, x[k] + 1e-4), _moved(x, k, x[k] - 1e-4)
            slopes[:, k] = (self.residuals(ahead, answer) - self.residuals(behind, answer)) / 2e-4
        return Plane(offset, slopes, self.weight(offset), rough)

    def widely(self, starts: Sequence[np.ndarray], seed: int) -> np.ndarray:
        """The best point that differential evolution finds over the whole ranges, beginning with `starts` and a sample."""
        low, high = self.ends
        count = len(self.free)
        size = max(POPULATION * count, 12)
        sample = low[:count] + stats.qmc.LatinHypercube(count, seed=seed).random(size) * (high - low)[:count]
        known = [x[:count] for x in starts[:size // 2]]
        sample[:len(known)] = known

        def costs(columns):
            points = [np.concatenate([column, np.zeros(len(low) - count)]) for column in np.atleast_2d(columns.T)]
            self.answers(points)
            return np.array([self.cost(self.with_best_nuisance(x)) for x in points])

        found = optimize.differential_evolution(costs, list(zip(low[:count], high[:count])), init=sample, maxiter=GENERATIONS, tol=1e-4,
                                                polish=False, vectorized=True, updating="deferred", seed=seed)
        return self.with_best_nuisance(np.concatenate([found.x, np.zeros(len(low) - count)]))

    def with_best_nuisance(self, x: np.ndarray) -> np.ndarray:
        """The point with the shifts and scales that suit its run best: no further run is needed."""
        count = len(self.free)
        if len(x) == count:
            return x
        answer = self.answers([x])[0]
        if "numbers" not in answer:
            return x
        best = min((np.concatenate([x[:count], np.full(len(x) - count, c)]) for c in np.linspace(-0.9, 0.9, 13)),
                   key=lambda point: self.cost(point, answer))
        found = optimize.least_squares(lambda rest: self.residuals(np.concatenate([x[:count], rest]), answer), best[count:],
                                       bounds=(-1.0, 1.0), max_nfev=20)
        return np.concatenate([x[:count], found.x])

    def starts(self, own: np.ndarray | None, count: int, seed: int) -> list[np.ndarray]:
        """The best `count` points of a sample of the ranges, and of the deck's own values where they lie inside; apart from each other."""
        low, high = self.ends
        free = len(self.free)
        size = 1 << math.ceil(math.log2(PER_PARAMETER * free)) if count > 1 or own is None else 0
        shares = stats.qmc.Sobol(free, seed=seed).random(size) if size else np.empty((0, free))
        sample = [np.concatenate([low[:free] + share * (high - low)[:free], np.zeros(len(low) - free)]) for share in shares]
        points = ([own] if own is not None else []) + sample
        self.answers(points)
        if all("numbers" not in self.answers([x])[0] for x in points):
            raise NoSolution("no run within the ranges succeeded; the first failed with: "
                             f"{self.answers(points[:1])[0].get('reason', 'no answer')}")
        points = sorted((self.with_best_nuisance(x) for x in points), key=self.cost)
        kept: list[np.ndarray] = []
        for x in points:
            apart = all(np.max(np.abs(x - other)[:free] / (high - low)[:free]) > SAME for other in kept)
            if apart and len(kept) < count:
                kept.append(x)
        return kept


def _moved(x: np.ndarray, k: int, value: float) -> np.ndarray:
    there = x.copy()
    there[k] = value
    return there
