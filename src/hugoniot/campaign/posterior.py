r"""What a fit's data say of its parameters beyond a minimum and its curvature: a sample of their posterior distribution.

$$p(\theta \,|\, d) \propto e^{-\chi^2(\theta)/2}$$

within the ranges, all values (of a logarithmic range, all logarithms) alike beforehand; what has a mean and a standard deviation brings
them along in $\chi^2$. Drawn by an ensemble of walkers whose steps do not mind correlations (J. Goodman, J. Weare, Commun. Appl. Math.
Comput. Sci. 5 (2010) 65; D. Foreman-Mackey, D. W. Hogg, D. Lang, J. Goodman, Publ. Astron. Soc. Pac. 125 (2013) 306, the package emcee),
over a surrogate (`campaign.surrogate`) or over the runs themselves. The draws are correlated along the way: there are as many independent
ones as draws divided by the autocorrelation time.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy import stats

from hugoniot.campaign.fit import Problem
from hugoniot.campaign.planes import Minimum, covariance
from hugoniot.campaign.surrogate import Surrogate, surrogate_of
from hugoniot.campaign.targets import Target
from hugoniot.errors import DeckError, NoSolution

KINDS = ("surrogate", "runs")
QUANTILES = (0.025, 0.16, 0.5, 0.84, 0.975)
LONG_ENOUGH = 50.0        # autocorrelation times of a chain
MOST_STEPS = 10_000       # of a walker over a surrogate
MOST_RUNS = 2000          # of a posterior over runs, unless another number is given
PREDICTIVE = 32           # runs of each predictive distribution
LEAST_EFFECTIVE = 100.0
_BURNED, _CHUNK = 5.0, 250     # autocorrelation times left out at the start; steps between looks


@dataclass(frozen=True)
class Posterior:
    """A sample of the posterior.

    kind            "surrogate" or "runs"
    names, units    of the parameters, shifts and scales too
    draws           (ndraw, nparameter) SI
    quantiles       (len(QUANTILES), nparameter); mean, deviation (nparameter,); correlation (nparameter, nparameter)
    autocorrelation steps, (nparameter,); effective: independent draws that the sample is worth
    surrogate       what stood for the runs, None for the runs themselves
    prior, predicted   of each target what runs of the prior and of the posterior have, the quantiles 0.025, 0.5, 0.975, (3, n)
    doubts          sentences a reader has to know
    """

    kind: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    draws: np.ndarray
    quantiles: np.ndarray
    mean: np.ndarray
    deviation: np.ndarray
    correlation: np.ndarray
    autocorrelation: np.ndarray
    effective: float
    surrogate: Surrogate | None
    prior: tuple[np.ndarray, ...]
    predicted: tuple[np.ndarray, ...]
    doubts: tuple[str, ...]


def checked(kind: str) -> None:
    """Raise `DeckError` for a posterior that does not exist, or where emcee is missing."""
    if kind not in KINDS:
        raise DeckError.single("command line", None, "--posterior", f"unknown kind of posterior '{kind}'", f"known: {', '.join(KINDS)}")
    try:
        import emcee  # noqa: F401
    except ImportError:
        raise DeckError.single("command line", None, "--posterior", "the package emcee is not installed",
                               "install it with: pip install 'hugoniot[posterior]'") from None


def posterior_of(problem: Problem, best: Minimum, kind: str, runs: int | None = None, seed: int = 0) -> Posterior:
    """A sample of the posterior of a problem whose best minimum is known.

    kind   "surrogate" or "runs"; runs: of the surrogate's sample, or the most that the walkers make
    Raises `DeckError`, and `NoSolution` for a surrogate that is not good enough.
    """
    checked(kind)
    spread = covariance(best)
    stand_in = surrogate_of(problem, best.x, spread, runs, seed) if kind == "surrogate" else None
    answers = problem.answers if stand_in is None else stand_in.answers
    walkers = max(4 * len(best.x), 12)
    steps = MOST_STEPS if stand_in is not None else max((runs or MOST_RUNS) // walkers, 2)
    random = np.random.default_rng(seed)
    chain, times = _walked(problem, answers, _around(problem, best.x, spread, walkers, random), steps, random)
    burned = min(int(_BURNED * np.max(times)), len(chain) // 2)
    flat = chain[burned:].reshape(-1, len(best.x))
    effective = len(flat) / float(np.max(times))
    draws = np.array([[problem.value(k, c) for k, c in enumerate(x)] for x in flat])
    doubts = _doubts(problem, stand_in, flat, effective, len(chain) / float(np.max(times)))
    count = min(PREDICTIVE, len(flat))
    chosen = flat[random.choice(len(flat), count, replace=False)]
    return Posterior(kind, tuple(problem.names), tuple(problem.units), draws, np.quantile(draws, QUANTILES, axis=0), draws.mean(axis=0),
                     draws.std(axis=0, ddof=1), _correlation(draws), times, effective, stand_in,
                     _predicted(problem, _of_the_prior(problem, seed)), _predicted(problem, chosen), tuple(doubts))


def _around(problem: Problem, best: np.ndarray, spread: np.ndarray, walkers: int, random) -> np.ndarray:
    """Where the walkers begin, (walkers, nparameter): near the minimum, inside the ranges."""
    low, high = problem.ends
    inside = np.empty((0, len(best)))
    for _ in range(100):
        points = random.multivariate_normal(best, 0.25 * spread, 8 * walkers, method="svd")
        inside = np.vstack([inside, points[np.all((points > low) & (points < high), axis=1)]])
        if len(inside) >= walkers:
            return inside[:walkers]
    width = np.minimum(0.5 * np.sqrt(np.diag(spread)), 0.1 * (high - low))      # a minimum in a corner
    return np.clip(best + width * random.standard_normal((walkers, len(best))), low + 1e-9, high - 1e-9)


def _walked(problem: Problem, answers: Callable, start: np.ndarray, most: int, random) -> tuple[np.ndarray, np.ndarray]:
    """(chain (nstep, nwalker, nparameter), autocorrelation times (nparameter,) in steps)."""
    import emcee

    low, high = problem.ends

    def log_probability(points: np.ndarray) -> np.ndarray:
        found = np.full(len(points), -np.inf)
        inside = np.flatnonzero(np.all((points >= low) & (points <= high), axis=1))
        for k, answer in zip(inside, answers([points[k] for k in inside]) if len(inside) else ()):
            if "numbers" in answer:
                found[k] = -0.5 * problem.cost(points[k], answer)
        return found

    sampler: Any = emcee.EnsembleSampler(len(start), start.shape[1], log_probability, vectorize=True)
    sampler.random_state = np.random.RandomState(random.integers(2**31)).get_state()
    state, times = start, np.full(start.shape[1], np.nan)
    while sampler.iteration < most:
        state = sampler.run_mcmc(state, min(_CHUNK, most - sampler.iteration), skip_initial_state_check=True)
        times = np.maximum(np.nan_to_num(sampler.get_autocorr_time(quiet=True, tol=0), nan=float(sampler.iteration)), 1.0)
        if sampler.iteration > LONG_ENOUGH * np.max(times) and sampler.iteration >= 4 * _CHUNK:
            break
    if not np.isfinite(sampler.get_log_prob()).any():
        raise NoSolution("no run near the minimum of the fit succeeded: there is nothing to draw from")
    return sampler.get_chain(), times


def _doubts(problem: Problem, stand_in: Surrogate | None, flat: np.ndarray, effective: float, long: float) -> list[str]:
    found = []
    if effective < LEAST_EFFECTIVE or long < LONG_ENOUGH:
        found.append(f"the chains were short: {long:.0f} autocorrelation times ({LONG_ENOUGH:g} are enough) and {effective:.0f} "
                     "independent draws; "
                     "the quantiles are inaccurate" + ("; allow more runs (--posterior-runs)" if stand_in is None else ""))
    if stand_in is not None:
        rim = np.mean(np.any(np.abs(stand_in.places(flat)) > 0.9, axis=1))
        if rim > 0.02:
            found.append(f"{100.0 * rim:.0f} % of the posterior lies at the edge of the region that the surrogate's runs cover: the true "
                         "posterior is wider")
    low, high = problem.ends
    for k, name in enumerate(problem.names):
        share = (flat[:, k] - low[k]) / (high[k] - low[k])
        if np.mean((share < 0.02) | (share > 0.98)) > 0.05:
            found.append(f"the posterior of {name} is cut off by the limits of its range, so its quantiles depend on the range")
    return found


def _correlation(draws: np.ndarray) -> np.ndarray:
    scale = draws.std(axis=0)
    scaled = (draws - draws.mean(axis=0)) / np.where(scale > 0.0, scale, 1.0)
    return np.where(np.eye(draws.shape[1]) > 0.0, 1.0, scaled.T @ scaled / len(draws))


def _of_the_prior(problem: Problem, seed: int) -> np.ndarray:
    """Points drawn from what is known beforehand, (PREDICTIVE, nparameter)."""
    low, high = problem.ends
    shares = stats.qmc.Sobol(len(low), seed=seed).random(PREDICTIVE)
    points = low + shares * (high - low)
    for k, free in enumerate(problem.free):
        if free.prior:
            points[:, k] = np.clip(stats.norm.ppf(shares[:, k]), low[k], high[k])
    return points


def _predicted(problem: Problem, points: np.ndarray) -> tuple[np.ndarray, ...]:
    """Of each target what runs at these points have: the quantiles 0.025, 0.5, 0.975, (3, n); not-a-number where none succeeds."""
    pairs = [(x, answer) for x, answer in zip(points, problem.answers(list(points))) if "numbers" in answer]

    def band(target: Target) -> np.ndarray:
        if not pairs:
            return np.full((3, len(target.values)), np.nan)
        return np.quantile([problem.model(x, target, answer) for x, answer in pairs], (0.025, 0.5, 0.975), axis=0)

    return tuple(band(target) for target in problem.targets)
