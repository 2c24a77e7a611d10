r"""What stands for the runs of a fit near its minimum: a Gaussian process through each scalar that the data ask for.

The scalars are the measured numbers and, of each record, the weights of the few principal shapes in which the records of a sample of runs
differ. The sample fills a box of REACH standard deviations round the minimum, along the axes of the covariance of the fit. How good it
is: each run of the sample is predicted from all others, and the logarithm of its probability compared with that of the run itself.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from hugoniot.campaign.fit import Problem
from hugoniot.campaign.gaussian_process import Process, process_through
from hugoniot.errors import NoSolution

REACH = 4.0            # standard deviations to each side of the minimum
LEFT_OUT = 0.02        # of the data's standard deviation: what the shapes that are left out may add up to, root mean square
MOST_SHAPES = 12
GOOD_ENOUGH = 0.5      # of the logarithm of the probability: its error, root mean square, where the probability is not small
RUNS_PER_PARAMETER = 24
_BULK = 0.99           # of the probability, in which the error counts


@dataclass(frozen=True)
class _Shapes:
    """The records of one name: times and mean record (ntime,), shapes (nshape, ntime), a process for the weight of each."""

    times: np.ndarray
    mean: np.ndarray
    shapes: np.ndarray
    weights: tuple[Process, ...]


@dataclass(frozen=True)
class Surrogate:
    """What stands for the runs.

    centre (nfree,) and axes (nfree, nfree) of the box: x = centre + axes z, |z| <= 1
    numbers, records   what stands for each number and each record, by name
    errors             result -> root mean square of what leaving a run out misses, in standard deviations of the data
    log_error          the same for the logarithm of the probability
    """

    centre: np.ndarray
    axes: np.ndarray
    numbers: dict[str, Process]
    records: dict[str, _Shapes]
    errors: dict[str, float]
    log_error: float

    def places(self, points: np.ndarray) -> np.ndarray:
        """Points (m, nparameter) in the coordinates of the box, (m, nfree)."""
        return np.linalg.solve(self.axes, (np.asarray(points)[:, :len(self.centre)] - self.centre).T).T

    def answers(self, points: Sequence[np.ndarray]) -> list[dict]:
        """As `Problem.answers`; a point outside the box has only a reason."""
        z = self.places(np.array(points))
        numbers = {name: process.mean(z) for name, process in self.numbers.items()}
        records = {name: s.mean + np.array([w.mean(z) for w in s.weights]).T @ s.shapes for name, s in self.records.items()}
        inside = np.all(np.abs(z) <= 1.0, axis=1)
        return [{"numbers": {name: float(v[k]) for name, v in numbers.items()},
                 "records": {name: (self.records[name].times, v[k]) for name, v in records.items()}} if inside[k]
                else {"reason": "outside the region that the runs sample"} for k in range(len(z))]


def surrogate_of(problem: Problem, best: np.ndarray, covariance: np.ndarray, runs: int | None = None, seed: int = 0) -> Surrogate:
    """What stands for the runs near the best point (nparameter,) with its covariance.

    runs   of the sample; RUNS_PER_PARAMETER for each free parameter unless given
    Raises `NoSolution` where too many of the runs fail or it is not good enough.
    """
    count = len(problem.free)
    low, high = (ends[:count] for ends in problem.ends)
    spread = np.sqrt(np.diag(covariance)[:count])
    narrowed = np.minimum(1.0, (high - low) / (REACH * spread))      # of a parameter that the data leave open: its range
    axes = REACH * narrowed[:, None] * np.linalg.cholesky(covariance[:count, :count])
    z, answers = _sampled(problem, best, axes, runs or RUNS_PER_PARAMETER * count, seed)
    numbers = {t.name: process_through(z, np.array([a["numbers"][t.name] for a in answers])) for t in problem.targets if t.clock < 0}
    finest: dict[str, float] = {}
    for t in problem.targets:
        if t.clock >= 0:
            finest[t.name] = min(finest.get(t.name, math.inf), float(t.sigma.min()))
    records = {name: _shapes(z, answers, name, LEFT_OUT * sigma) for name, sigma in finest.items()}
    away = z @ axes.T
    clocks = np.linalg.solve(covariance[:count, :count], covariance[:count, count:])     # how shifts and scales follow the constants
    points = np.clip(best + np.hstack([away, away @ clocks]), *problem.ends)
    errors, log_error = _errors(problem, points, answers, numbers, records)
    found = Surrogate(best[:count], axes, numbers, records, errors, log_error)
    if not log_error <= GOOD_ENOUGH:
        worst = max(errors, key=lambda name: errors[name])
        raise NoSolution("the surrogate is not good enough: in leave-one-out tests it misses the logarithm of the probability by "
                         f"{log_error:.2g} (limit {GOOD_ENOUGH:g}), and {worst} by {errors[worst]:.2g} times the standard deviation of the "
                         "data; use more runs (--posterior-runs), a finer mesh, a shorter --window, or --posterior runs")
    return found


def _sampled(problem: Problem, best: np.ndarray, axes: np.ndarray, runs: int, seed: int) -> tuple[np.ndarray, list[dict]]:
    """(places in the box (n, nfree), answers) of a sample of the part of the box that lies within the ranges."""
    count = len(axes)
    low, high = (ends[:count] for ends in problem.ends)
    shares = stats.qmc.Sobol(count, seed=seed).random(1 << math.ceil(math.log2(8 * runs)))
    z = 2.0 * shares - 1.0
    x = best[:count] + z @ axes.T
    z = z[np.all((x >= low) & (x <= high), axis=1)][:runs]
    answers = problem.answers([np.concatenate([best[:count] + axes @ each, best[count:]]) for each in z])
    sound = [k for k, answer in enumerate(answers) if "numbers" in answer]
    if len(sound) < max(4 * count, 8):
        raise NoSolution(f"only {len(sound)} of {len(z)} runs for the surrogate succeeded: too few to build a surrogate; "
                         "use more runs (--posterior-runs), or --posterior runs")
    return z[sound], [answers[k] for k in sound]


def _shapes(z: np.ndarray, answers: list[dict], name: str, left_out: float) -> _Shapes:
    """What stands for one record; the smaller shapes, which add up to `left_out`, are not kept."""
    times: np.ndarray = min((a["records"][name][0] for a in answers), key=len)
    values = np.array([np.interp(times, *a["records"][name]) for a in answers])
    mean = values.mean(axis=0)
    left, size, shapes = np.linalg.svd(values - mean, full_matrices=False)
    rest = np.append(np.cumsum(size[::-1] ** 2)[::-1], 0.0) / values.size
    kept = int(np.clip(np.argmax(rest <= left_out**2), 1, MOST_SHAPES))
    return _Shapes(times, mean, shapes[:kept], tuple(process_through(z, left[:, k] * size[k]) for k in range(kept)))


def _errors(problem: Problem, points, answers, numbers, records) -> tuple[dict[str, float], float]:
    """(errors, log_error) of `Surrogate`, from each run predicted without itself; points (n, nparameter)."""
    count = len(problem.free)
    missed = {name: process.left_out() for name, process in numbers.items()}
    weights = {name: np.array([w.left_out() for w in s.weights]).T for name, s in records.items()}
    squares: dict[str, list] = {t.label: [] for t in problem.targets}
    costs, without = [], []
    for k, (x, answer) in enumerate(zip(points, answers)):
        guess = {"numbers": {name: answer["numbers"][name] - missed[name][k] for name in numbers},
                 "records": {name: (s.times, s.mean + (_weights(s, answer, name) - weights[name][k]) @ s.shapes)
                             for name, s in records.items()}}
        costs.append(problem.cost(x, answer))
        without.append(problem.cost(x, guess))
        shifts, scales = problem.clock(x)
        for t in problem.targets:
            clock = (float(shifts[t.clock]), float(scales[t.clock])) if t.clock >= 0 else (0.0, 0.0)
            squares[t.label].append(np.mean((t.residuals(guess, *clock) - t.residuals(answer, *clock)) ** 2))
    rise = np.array(costs) - min(costs)
    counted = np.argsort(rise)[:max(int(np.sum(rise <= stats.chi2.ppf(_BULK, count))), 2 * count)]
    off = 0.5 * (np.array(without) - np.array(costs))[counted]
    return {label: float(np.sqrt(np.mean(each))) for label, each in squares.items()}, float(np.sqrt(np.mean(off**2)))


def _weights(shapes: _Shapes, answer: dict, name: str) -> np.ndarray:
    return shapes.shapes @ (np.interp(shapes.times, *answer["records"][name]) - shapes.mean)
