r"""What a fit has found: values, intervals, correlations, whether the model matches at all, and profiles.

An interval is the value with 1.96 standard deviations on both sides, or, where the scatter of the residuals has widened them, with the
97.5 % point of Student's distribution. It reaches further where a run that was made beyond it has a $\chi^2$ within 3.84 of the least: a
model may answer in steps, one void a time step later, and a step that the data allow belongs to the interval as far as it goes. A profile
goes further: the parameter is held, all others are sought anew, and the 95 % limits are where $\chi^2$ has risen by 3.84 (times the
reduced $\chi^2$ where that is above one). Limits of a profile need not be symmetric; one that meets the end of a range is not known.

The sum of squares says how well a model matches only where it is not bounded: with a robust loss the number of outliers decides.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from hugoniot.campaign.fit import Problem
from hugoniot.campaign.planes import EXPECTED, Minimum, covariance

LEVEL = 0.95
RISE = float(stats.chi2.ppf(LEVEL, 1))
UNLIKELY = 1e-6       # probability of so large a sum of squares below which the model is said not to match
PROFILE_STEPS = 5
OUTLYING, MOST_OUTLYING = 3.0, 0.25    # standard deviations of an outlier; share of them that a robust loss is for
IDLE = 0.9            # of the standard deviation of a prior that is left, above which the data have added little
CORRELATED, FACTOR = 4.0, 1.25   # standard deviations of the correlation of neighbours without any; least factor that is worth a note
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
    chi_square    sum of squares of the residuals, with a robust loss weighted and over its mean for normal residuals; `freedom` degrees
                  of freedom; `probability` of as large a one by chance, not-a-number with a robust loss
    outlying      number of data further than OUTLYING standard deviations from the model
    matches       whether the model can be what was measured
    others        (parameters' values, sum of squares) of other minima
    doubts        sentences a reader has to know before trusting it
    """

    parameters: tuple[Parameter, ...]
    correlation: np.ndarray
    chi_square: float
    freedom: int
    probability: float
    outlying: int
    matches: bool
    minimum: Minimum
    others: tuple[tuple[tuple[float, ...], float], ...]
    doubts: tuple[str, ...]
    runs: int

    @property
    def reduced(self) -> float:
        """chi_square for each degree of freedom: one where model, data and uncertainties agree."""
        return self.chi_square / self.freedom if self.freedom > 0 else math.nan


@dataclass(frozen=True)
class _Agreement:
    """How well a minimum agrees with the data: see `Fit`; scatter: weighted sum of squares over the degrees of freedom, at least 1."""

    chi_square: float
    freedom: int
    probability: float
    outlying: int
    scatter: float
    matches: bool


def _agreement(problem: Problem, minimum: Minimum) -> _Agreement:
    residuals = problem.residuals(minimum.x)
    data, freedom = problem.data_of(residuals), residuals.size - len(minimum.x)
    squares = problem.weight(residuals) * residuals**2
    chi_square = float(np.sum(squares[:data.size]) / EXPECTED[problem.loss] + np.sum(squares[data.size:]))
    scatter = max(1.0, float(np.sum(squares)) / freedom) if freedom > 0 else 1.0
    outlying = int(np.sum(np.abs(data) > OUTLYING))
    if problem.loss != "linear":
        return _Agreement(chi_square, freedom, math.nan, outlying, scatter, outlying <= MOST_OUTLYING * data.size)
    # without degrees of freedom the sum is zero, unless the model cannot reach the data
    probability = float(stats.chi2.sf(chi_square, max(freedom, 1)))
    return _Agreement(chi_square, freedom, probability, outlying, scatter, not probability < UNLIKELY)


def weighed(problem: Problem, minima: Sequence[Minimum], profiles: bool = False) -> Fit:
    """What the minima of a problem, the best one first, say about its parameters."""
    best = minima[0]
    found = _agreement(problem, best)
    inflated, freedom = found.scatter, found.freedom
    spread_of = covariance(best, inflated)
    spread = np.sqrt(np.maximum(np.diag(spread_of), 0.0))
    quantile = float(stats.t.ppf(0.5 + 0.5 * LEVEL, freedom) if inflated > 1.0 else stats.norm.ppf(0.5 + 0.5 * LEVEL))
    reached = _reached(problem, best, inflated)
    parameters = tuple(_parameter(problem, best, k, (spread[k], quantile, reached[:, k]),
                                  _profile(problem, best, k, spread[k], spread_of, inflated) if profiles else (math.nan, math.nan))
                       for k in range(len(best.x)))
    scale = np.where(spread > 0.0, spread, 1.0)
    correlation = np.where(np.eye(len(spread)) > 0.0, 1.0, spread_of / np.outer(scale, scale))
    others = tuple((tuple(problem.value(k, c) for k, c in enumerate(m.x)), m.cost) for m in minima[1:] if _apart(problem, best, m))
    doubts = _doubts(problem, best, parameters, correlation, found, others)
    return Fit(parameters, correlation, found.chi_square, freedom, found.probability, found.outlying, found.matches, best, others,
               tuple(doubts), problem.runs)


def likely(problem: Problem, minimum: Minimum) -> bool:
    """Whether the model can be what was measured."""
    return _agreement(problem, minimum).matches


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
    spread, quantile, reached = width
    low, high = (ends[k] for ends in problem.ends)
    c = best.x[k]
    step = 1e-4 * (high - low)
    slope = (problem.value(k, min(c + step, high)) - problem.value(k, max(c - step, low))) / (min(c + step, high) - max(c - step, low))
    at_end = bool(min(c - low, high - c) < _NEAR * (high - low))
    ends = min(c - quantile * spread, reached[0]), max(c + quantile * spread, reached[1])
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


def _doubts(problem, best, parameters, correlation, agreement: _Agreement, others) -> list[str]:
    found, freedom = [], agreement.freedom
    data = problem.data_of(problem.residuals(best.x)).size
    if freedom < 1:
        found.append(f"there are no more data than parameters ({len(best.x)}): the fit cannot show whether the model matches")
    robust, far = problem.loss != "linear", f"{agreement.outlying} of {data} points are more than {OUTLYING:g} standard deviations"
    if not agreement.matches:
        how = (f"{far} away" if robust else f"chi-square {agreement.chi_square:.3g} without degrees of freedom" if freedom < 1 else
               f"reduced chi-square {agreement.chi_square / freedom:.3g} for {freedom} degree{'' if freedom == 1 else 's'} of freedom")
        widened = "the intervals are widened to include the misfit, but they" if agreement.scatter > 1.0 else "the intervals"
        found.insert(0, f"the model does not match the data within their uncertainty: {how}. Look at the residuals before using a value; "
                     f"{widened} are not reliable for a model that does not match")
    elif robust and agreement.outlying:
        found.append(f"{far} from the model; the loss '{problem.loss}' gives them little weight, as outliers")
    found += _correlated(problem, best)
    estimated = [t.label for t in problem.targets if t.estimated]
    if estimated:
        sigmas = ", ".join(f"{float(t.sigma[0]):.3g} {t.unit}" for t in problem.targets if t.estimated)
        found.append(f"no uncertainty was given for {', '.join(estimated)}: it was estimated from the noise of the record ({sigmas})")
    priors = {f.variable.name: abs(f.value(1.0) - f.value(0.0)) for f in problem.free if f.prior}
    for p in parameters:
        if p.at_end:
            found.append(f"{p.name} lies at a limit of its range: the data favour a value outside the range, or do not depend on this "
                         "parameter")
        elif p.sigma > 0.3 * abs(_width(problem, p.name)):
            found.append(f"{p.name} is not determined by these data: its standard deviation is more than 0.3 times its range")
        elif p.sigma > IDLE * priors.get(p.name, math.inf):
            found.append(f"these data say little about {p.name}: its value and uncertainty are nearly those of the prior")
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


def _correlated(problem: Problem, best: Minimum) -> list[str]:
    r"""About records whose neighbouring residuals are correlated with a coefficient r: noise that a filter has smoothed, or a model that
    is off. The variance of a parameter is then too small by about $(1 + r)/(1 - r)$, that of a mean (G. E. P. Box, G. M. Jenkins, Time
    Series Analysis, 1970)."""
    answer, found = problem.answers([best.x])[0], []
    for t in problem.targets:
        left = t.beside(np.nan_to_num(problem.model(best.x, t, answer)))
        if t.clock < 0 or left.size < 20 or not np.ptp(left) > 0.0:
            continue
        left = left - left.mean()
        r = float(np.sum(left[1:] * left[:-1]) / np.sum(left**2))
        factor = math.sqrt((1.0 + r) / (1.0 - r))
        if r > CORRELATED / math.sqrt(left.size) and factor > FACTOR:
            found.append(f"{t.label}: the residuals of neighbouring points are correlated (coefficient {r:.2f}), but the fit takes all "
                         "points as independent: its standard deviations and intervals are too small by a factor of about "
                         f"{factor:.1f}")
    return found


def _width(problem: Problem, name: str) -> float:
    k = problem.names.index(name)
    low, high = problem.ends
    return problem.value(k, high[k]) - problem.value(k, low[k])
