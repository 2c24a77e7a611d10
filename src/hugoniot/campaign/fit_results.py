r"""What a fit has found: values, intervals, correlations, whether the model matches at all, and profiles.

An interval is the value with the 97.5 % point of Student's distribution times the standard deviation on both sides, and further where
a run that was made beyond it has a $\chi^2$ within 3.84 of the least: a model may answer in steps, one void a time step later, and a step
that the data allow belongs to the interval as far as it goes. A profile goes further: the parameter is held, all others are sought anew,
and the 95 % limits are where $\chi^2$ has risen by 3.84 (times the reduced $\chi^2$ where that is above one). Limits of a profile need
not be symmetric; one that meets the end of a range is not known.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from hugoniot.campaign.fit import Problem
from hugoniot.campaign.planes import WEIGHT, Minimum, covariance

LEVEL = 0.95
RISE = float(stats.chi2.ppf(LEVEL, 1))
UNLIKELY = 1e-6       # probability of so large a sum of squares below which the model is said not to match
PROFILE_STEPS = 5
_NEAR = 1e-3          # of a range: a value nearer to an end lies at it


@dataclass(frozen=True)
class Parameter:
    """One number that was sought, SI: value, standard deviation, 95 % limits, those of its profile (not-a-number: not asked or not met)."""

    name: str
    unit: str
    value: float
    sigma: float
    low: float
    high: float
    at_end: bool
    profile_low: float = math.nan
    profile_high: float = math.nan


@dataclass(frozen=True)
class Fit:
    """A finished fit.

    correlation   (nparameter, nparameter)
    chi_square    sum of squares of the residuals; `freedom` degrees of freedom; `probability` of as large a one by chance
    others        (parameters' values, sum of squares) of other minima
    doubts        sentences a reader has to know before trusting it
    """

    parameters: tuple[Parameter, ...]
    correlation: np.ndarray
    chi_square: float
    freedom: int
    probability: float
    minimum: Minimum
    others: tuple[tuple[tuple[float, ...], float], ...]
    doubts: tuple[str, ...]
    runs: int

    @property
    def reduced(self) -> float:
        """chi_square for each degree of freedom: one where model, data and uncertainties agree."""
        return self.chi_square / self.freedom if self.freedom > 0 else math.nan

    @property
    def matches(self) -> bool:
        """Whether the model can be what was measured."""
        return not bool(self.probability < UNLIKELY)


def weighed(problem: Problem, minima: Sequence[Minimum], profiles: bool = False) -> Fit:
    """What the minima of a problem, the best one first, say about its parameters."""
    best = minima[0]
    squares = problem.residuals(best.x) ** 2
    freedom = squares.size - len(best.x)
    weight = WEIGHT[problem.loss](squares)
    chi_square = float(np.sum(weight * squares))
    probability = float(stats.chi2.sf(chi_square, freedom)) if freedom > 0 else math.nan
    inflated = max(1.0, chi_square / freedom) if freedom > 0 else 1.0
    spread_of = covariance(best, inflated)
    spread = np.sqrt(np.maximum(np.diag(spread_of), 0.0))
    student = float(stats.t.ppf(0.5 + 0.5 * LEVEL, max(freedom, 1)))
    reached = _reached(problem, best, inflated)
    parameters = tuple(_parameter(problem, best, k, (spread[k], student, reached[:, k]),
                                  _profile(problem, best, k, spread[k], spread_of, inflated) if profiles else (math.nan, math.nan))
                       for k in range(len(best.x)))
    scale = np.where(spread > 0.0, spread, 1.0)
    correlation = np.where(np.eye(len(spread)) > 0.0, 1.0, spread_of / np.outer(scale, scale))
    others = tuple((tuple(problem.value(k, c) for k, c in enumerate(m.x)), m.cost) for m in minima[1:] if _apart(problem, best, m))
    doubts = _doubts(problem, best, parameters, correlation, chi_square, freedom, probability, others)
    return Fit(parameters, correlation, chi_square, freedom, probability, best, others, tuple(doubts), problem.runs)


def likely(problem: Problem, minimum: Minimum) -> bool:
    """Whether so large a sum of squares may be chance."""
    squares = problem.residuals(minimum.x) ** 2
    freedom = squares.size - len(minimum.x)
    weight = WEIGHT[problem.loss](squares)
    return freedom < 1 or bool(stats.chi2.sf(np.sum(weight * squares), freedom) >= UNLIKELY)


def _apart(problem: Problem, best: Minimum, other: Minimum) -> bool:
    low, high = problem.ends
    return bool(np.max(np.abs(best.x - other.x) / (high - low)) > 0.05)


def _reached(problem: Problem, best: Minimum, inflated: float) -> np.ndarray:
    """(lowest, highest) coordinates of the runs made so far whose sum of squares is within the 95 % limit of the least, (2, nparameter).

    In a model that answers smoothly they lie inside the intervals of the covariance; where it answers in steps, a step that the data
    allow may reach further.
    """
    count = len(problem.free)
    points = [np.concatenate([key, best.x[count:]]) for key, answer in problem.seen.items() if "numbers" in answer]
    costs = np.array([problem.cost(x) for x in points])
    inside = np.array(points)[costs <= min(best.cost, best.least) + RISE * inflated]
    return np.array([inside.min(axis=0), inside.max(axis=0)]) if len(inside) else np.array([best.x, best.x])


def _parameter(problem: Problem, best: Minimum, k: int, width: tuple[float, float, np.ndarray], profile: tuple[float, float]) -> Parameter:
    spread, student, reached = width
    low, high = (ends[k] for ends in problem.ends)
    c = best.x[k]
    step = 1e-4 * (high - low)
    slope = (problem.value(k, min(c + step, high)) - problem.value(k, max(c - step, low))) / (min(c + step, high) - max(c - step, low))
    at_end = bool(min(c - low, high - c) < _NEAR * (high - low))
    ends = min(c - student * spread, reached[0]), max(c + student * spread, reached[1])
    limits = [problem.value(k, float(np.clip(end, low, high))) for end in ends]
    return Parameter(problem.names[k], problem.units[k], problem.value(k, c), abs(slope) * spread, limits[0], limits[1], at_end, *profile)


def _profile(problem: Problem, best: Minimum, k: int, spread: float, spread_of: np.ndarray, inflated: float) -> tuple[float, float]:
    """The 95 % limits of parameter k with all others sought anew; not-a-number where the end of the range comes first."""
    low, high = (ends[k] for ends in problem.ends)
    found = []
    for sign in (-1.0, 1.0):
        step, limit = math.sqrt(RISE) * spread, math.nan
        for _ in range(PROFILE_STEPS):
            place = best.x[k] + sign * step
            if not low < place < high or not step > 0.0:
                break
            start = best.x + spread_of[:, k] / spread_of[k, k] * (place - best.x[k])
            start[k] = place
            rise = (problem.search(np.clip(start, *problem.ends), (k,), 3, 2.0 * np.sqrt(np.diag(spread_of))).cost - best.cost) / inflated
            if abs(rise - RISE) < 0.03 * RISE:
                limit = problem.value(k, place)
                break
            step *= float(np.clip(math.sqrt(RISE / max(rise, 0.05 * RISE)), 0.4, 2.5))
        found.append(limit)
    return found[0], found[1]


def _doubts(problem, best, parameters, correlation, chi_square, freedom, probability, others) -> list[str]:
    found = []
    if freedom < 1:
        found.append(f"there are no more data than parameters ({len(best.x)}): the fit cannot show whether the model matches")
    elif probability < UNLIKELY:
        found.append("the model does not match the data within their uncertainty: reduced chi-square "
                     f"{chi_square / freedom:.3g} for {freedom} degree{'' if freedom == 1 else 's'} of freedom. "
                     "Look at the residuals before using a value; the intervals are widened to include the misfit, "
                     "but they are not reliable for a model that does not match")
    estimated = [t.label for t in problem.targets if t.estimated]
    if estimated:
        sigmas = ", ".join(f"{float(t.sigma[0]):.3g} {t.unit}" for t in problem.targets if t.estimated)
        found.append(f"no uncertainty was given for {', '.join(estimated)}: it was estimated from the noise of the record ({sigmas})")
    for p in parameters:
        if p.at_end:
            found.append(f"{p.name} lies at a limit of its range: the data favour a value outside the range, or do not depend on this "
                         "parameter")
        elif p.sigma > 0.3 * abs(_width(problem, p.name)):
            found.append(f"{p.name} is not determined by these data: its standard deviation is more than 0.3 times its range")
    for j in range(len(parameters)):
        for k in range(j):
            if abs(correlation[j, k]) > 0.95:
                pair = f"{parameters[k].name} and {parameters[j].name}"
                found.append(f"{pair} cannot be separated by these data (correlation {correlation[j, k]:+.3f})")
    if not best.settled:
        found.append("the search ended before it converged: the values are not at the minimum")
    near = [cost for _, cost in others if cost < best.cost + 10.0 * max(1.0, best.cost / max(freedom, 1))]
    if near:
        found.append(f"{len(near)} other minimum fits nearly as well: see 'others' in fit.json" if len(near) == 1 else
                     f"{len(near)} other minima fit nearly as well: see 'others' in fit.json")
    return found


def _width(problem: Problem, name: str) -> float:
    k = problem.names.index(name)
    low, high = problem.ends
    return problem.value(k, high[k]) - problem.value(k, low[k])
