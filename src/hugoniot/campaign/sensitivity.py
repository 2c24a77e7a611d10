r"""Which parameter matters: Sobol' indices and Morris' elementary effects of every result of a sweep, and the spread of each result.

For parameters that vary independently over their ranges, the first-order index is the part of a result's variance that goes when one
parameter is known, the total index the part that stays when all others are known:

$$S_i = \frac{\mathrm{Var}\,E(y\,|\,x_i)}{\mathrm{Var}\,y}, \qquad S_{T_i} = \frac{E\,\mathrm{Var}(y\,|\,x_{\sim i})}{\mathrm{Var}\,y}$$

from n (d + 2) cases: two samples A and B, and for each parameter A with that parameter of B (A. Saltelli et al., Comput. Phys. Commun.
181 (2010) 259, eq. (b) of table 2; total indices: M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35). Intervals are percentiles of a
bootstrap over the n base cases; a base case of which any part failed is left out.

Morris' screening (M. D. Morris, Technometrics 33 (1991) 161) needs n (d + 1) cases: paths over a grid of LEVELS levels on which one
parameter after the other takes a step of DELTA of its range. The mean magnitude of the effects (F. Campolongo, J. Cariboni, A. Saltelli,
Environ. Modell. Softw. 22 (2007) 1509) says how much a parameter matters, their standard deviation how far it acts in curves or together
with others.
"""

from dataclasses import dataclass

import numpy as np

from hugoniot.output.sweep_file import Column, SweepTable, together

LEVELS = 4
DELTA = LEVELS / (2.0 * (LEVELS - 1.0))
LEVEL = 0.95
RESAMPLES = 500
QUANTILES = (0.025, 0.16, 0.5, 0.84, 0.975)
LEAST = 8             # base cases without which nothing is said


@dataclass(frozen=True)
class Index:
    """What one parameter means for one result: first-order and total index with 95 % limits; `lost` base cases had failed."""

    result: str
    parameter: str
    first: float
    first_low: float
    first_high: float
    total: float
    total_low: float
    total_high: float
    lost: int


@dataclass(frozen=True)
class Effect:
    """Morris' effects of one parameter on one result, in the result's unit for the whole range of the parameter (`Variable.across`).

    magnitude: mean of their magnitudes; mean; deviation: their standard deviation
    """

    result: str
    parameter: str
    magnitude: float
    mean: float
    deviation: float
    lost: int


@dataclass(frozen=True)
class Quantiles:
    """Spread of one result over the cases: mean, standard deviation and QUANTILES."""

    result: str
    mean: float
    deviation: float
    quantiles: tuple[float, ...]
    count: int


# -- designs ---------------------------------------------------------------------------------------------------------
def saltelli_shares(count: int, base: int, seed: int) -> np.ndarray:
    """(base * (count + 2), count) shares: all of A, all of B, then A with one parameter of B after the other."""
    from scipy.stats import qmc

    both = qmc.Sobol(2 * count, seed=seed).random(base)
    a, b = both[:, :count], both[:, count:]
    mixed = []
    for k in range(count):
        each = a.copy()
        each[:, k] = b[:, k]
        mixed.append(each)
    return np.concatenate([a, b, *mixed])


def morris_shares(count: int, base: int, seed: int) -> np.ndarray:
    """(base * (count + 1), count) shares: one path of count steps after the other."""
    random = np.random.default_rng(seed)
    paths = []
    for _ in range(base):
        here = random.integers(0, LEVELS // 2, count) / (LEVELS - 1.0)       # the lower half, so that a step up stays inside
        up = random.random(count) < 0.5
        here = np.where(up, here, here + DELTA)
        path = [here]
        for k in random.permutation(count):
            here = here.copy()
            here[k] += DELTA if up[k] else -DELTA
            path.append(here)
        paths.append(np.clip(np.array(path), 0.0, 1.0))
    return np.concatenate(paths)


# -- what the results say --------------------------------------------------------------------------------------------
def indices(table: SweepTable, result: Column, base: int, names: list[str], seed: int = 0) -> list[Index]:
    """The Sobol' indices of one result; none where it does not vary or too many cases failed."""
    rows = result.values.reshape(len(names) + 2, base)
    sound = np.isfinite(rows).all(axis=0)
    rows, lost = rows[:, sound], base - int(sound.sum())
    if rows.shape[1] < LEAST or not np.ptp(rows[:2]) > 1e-12 * np.max(np.abs(rows)):
        return []
    random = np.random.default_rng(seed)
    found = np.array(_estimates(rows))
    again = np.array([_estimates(rows[:, random.integers(0, rows.shape[1], rows.shape[1])]) for _ in range(RESAMPLES)])
    low, high = np.nanquantile(again, [0.5 - 0.5 * LEVEL, 0.5 + 0.5 * LEVEL], axis=0)
    return [Index(result.name, name, *(float(v) for which in (0, 1) for v in (found[which, k], low[which, k], high[which, k])), lost)
            for k, name in enumerate(names)]


def _estimates(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(first-order, total indices), (nparameter,) each, from the values at A, B and the mixed samples, (nparameter + 2, n)."""
    centred = rows - rows[:2].mean()      # the estimate of the first order would suffer from a large mean
    a, b, mixed = centred[0], centred[1], centred[2:]
    variance = np.var(centred[:2])
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.mean(b * (mixed - a), axis=1) / variance, 0.5 * np.mean((a - mixed) ** 2, axis=1) / variance


def effects(table: SweepTable, result: Column, shares: np.ndarray, names: list[str]) -> list[Effect]:
    """Morris' effects on one result; none where it does not vary."""
    count = len(names)
    values, places = result.values.reshape(-1, count + 1), shares.reshape(-1, count + 1, count)
    sound = np.isfinite(values).all(axis=1)
    lost = int((~sound).sum())
    if sound.sum() < 2 or not np.ptp(values[sound]) > 0.0:
        return []
    values, places = values[sound], places[sound]
    steps = np.diff(places, axis=1)
    which = np.argmax(np.abs(steps), axis=2)
    change = np.diff(values, axis=1) / np.take_along_axis(steps, which[..., None], axis=2)[..., 0]
    found = []
    for k, name in enumerate(names):
        own = change[which == k]
        found.append(Effect(result.name, name, float(np.mean(np.abs(own))), float(np.mean(own)), float(np.std(own, ddof=1)), lost))
    return found


def quantiles(result: Column, cases: int) -> Quantiles:
    """The spread of one result over the first cases of a table (of a Saltelli design the samples A and B)."""
    values = result.values[:cases]
    values = values[np.isfinite(values)]
    if not values.size:
        return Quantiles(result.name, np.nan, np.nan, (np.nan,) * len(QUANTILES), 0)
    return Quantiles(result.name, float(values.mean()), float(values.std(ddof=1)) if values.size > 1 else np.nan,
                     tuple(float(q) for q in np.quantile(values, QUANTILES)), int(values.size))


def bands(table: SweepTable, cases: int) -> dict[str, np.ndarray]:
    """QUANTILES of every kept record, (nquantile, ntime), over those of the first cases that have one; not-a-number at times that some of
    these have not reached."""
    found = {record.name: together(record.values[:cases]) for record in table.records}
    return {name: np.quantile(values, QUANTILES, axis=0) if len(values) else np.full((len(QUANTILES), values.shape[1]), np.nan)
            for name, values in found.items()}
