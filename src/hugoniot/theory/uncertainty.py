r"""Error bars of any result from the errors of its inputs.

**Linear propagation**: the variance of a result $y$ is $\sigma_y^2 = J C J^T$ with the covariance matrix $C$ of the inputs and the row
$J$ of derivatives of $y$ with respect to them. They are central differences over half a standard deviation on either side.

**Monte Carlo**: the inputs are normal samples with the same covariance. The standard deviation and the 16th and 84th percentiles of the
results are given. Use it for results that are far from linear in the inputs.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from hugoniot.errors import HugoniotError, OutOfRange
from hugoniot.theory.impedance import Match, match
from hugoniot.theory.states import law_of


@dataclass(frozen=True)
class Spread:
    """A result with its error bar.

    value       result at the nominal parameters
    sigma       standard deviation
    low, high   value - sigma and value + sigma; with Monte Carlo the 16th and 84th percentiles
    shares      fraction of the variance due to each parameter alone (linear propagation only)
    """

    value: float
    sigma: float
    low: float
    high: float
    shares: dict[str, float]


def vary(material, **values: float):
    """The parameters of a material's equation of state with some of them replaced, by name (SI).

    Raises OutOfRange for a parameter that the equation of state does not have, with the names of those that it has.
    """
    par = law_of(material)
    if stray := set(values) - set(par._fields):
        raise OutOfRange(f"the law has no parameter {', '.join(sorted(stray))}; it has {', '.join(par._fields)}")
    return par._replace(**{k: float(v) for k, v in values.items()})


def matched(layers: Sequence, answers: Sequence[str], solve: Callable[..., Sequence[Match]] = match) -> Callable[..., dict[str, float]]:
    """An impedance match as a function for `propagate`.

    layers    materials of the library: flyer first, then the targets, as in `match`
    answers   names of fields of `States` that are returned, such as pressure
    solve     a function (layers, velocity) that returns a list of `Match`: `match`, or `ring_up` with a fixed layer

    The function returned takes the velocity of the flyer as `velocity` (m/s) and parameters named MATERIAL.parameter, which apply to all
    layers of that material. It returns the fields on the right of the interface in each `Match`, under names such as "0.pressure", in which
    the number is the index in the list of `Match`.
    """
    def answer(**given: float) -> dict[str, float]:
        own = [{k.rpartition(".")[2]: v for k, v in given.items() if k.rpartition(".")[0] == m.name} for m in layers]
        found = solve([vary(m, **changed) for m, changed in zip(layers, own)], given["velocity"])
        return {f"{i}.{k}": getattr(m.right, k) for i, m in enumerate(found) for k in answers if getattr(m.right, k) is not None}

    return answer


def propagate(function: Callable[..., Mapping[str, float]], values: Mapping[str, float], sigmas: Mapping[str, float], *,
              correlation: Mapping[tuple[str, str], float] | None = None, samples: int = 0, seed: int = 0) -> dict[str, Spread]:
    """Error bars of every number that function(**values) returns.

    function      function of named numbers that returns a dict of numbers
    values        nominal parameters: name -> value, SI
    sigmas        standard deviations of the uncertain ones: name -> value, SI
    correlation   (name, name) -> coefficient, -1 to 1; pairs not given are independent
    samples       0: linear propagation; otherwise the number of Monte Carlo samples
    seed          seed of the samples

    Returns name -> `Spread`. Raises OutOfRange for unknown names, a negative sigma or an impossible set of correlations.
    """
    names = [n for n, s in sigmas.items() if s != 0.0]
    if stray := set(sigmas) - set(values):
        raise OutOfRange(f"no such parameter: {', '.join(sorted(stray))}; the parameters are {', '.join(values)}")
    covariance = _covariance(names, sigmas, correlation or {})
    centre = {k: float(v) for k, v in function(**values).items()}
    if not names:
        return {k: Spread(v, 0.0, v, v, {}) for k, v in centre.items()}
    if samples:
        return _monte_carlo(function, values, names, covariance, centre, samples, seed)
    jacobian = {k: np.zeros(len(names)) for k in centre}
    for i, name in enumerate(names):
        h = 0.5 * sigmas[name]
        up, down = (function(**{**values, name: values[name] + d}) for d in (h, -h))
        for k in centre:
            jacobian[k][i] = (float(up[k]) - float(down[k])) / (2.0 * h)
    result = {}
    for k, value in centre.items():
        variance = float(jacobian[k] @ covariance @ jacobian[k])
        sigma = float(np.sqrt(max(variance, 0.0)))
        alone = (jacobian[k] * np.sqrt(np.diag(covariance))) ** 2
        shares = {n: float(a / variance) if variance else 0.0 for n, a in zip(names, alone)}
        result[k] = Spread(value, sigma, value - sigma, value + sigma, shares)
    return result


def _covariance(names, sigmas, correlation):
    if any(not (np.isfinite(sigmas[n]) and sigmas[n] > 0.0) for n in names):
        raise OutOfRange("a standard deviation must be finite and not negative")
    matrix = np.diag([float(sigmas[n]) ** 2 for n in names])
    for (a, b), value in correlation.items():
        if a in names and b in names:
            i, j = names.index(a), names.index(b)
            matrix[i, j] = matrix[j, i] = value * sigmas[a] * sigmas[b]
    scale = np.sqrt(np.diag(matrix))
    if names and np.linalg.eigvalsh(matrix / np.outer(scale, scale)).min() < -1e-12:
        raise OutOfRange("these correlations contradict each other: their matrix is not positive semidefinite")
    return matrix


def _monte_carlo(function, values, names, covariance, centre, samples, seed):
    scale = np.sqrt(np.diag(covariance))
    normalised = covariance / np.outer(scale, scale)
    weights, vectors = np.linalg.eigh(normalised)
    draw = np.random.default_rng(seed).standard_normal((samples, len(names)))
    draw = scale * (draw @ (vectors * np.sqrt(np.maximum(weights, 0.0))).T)
    rows: dict[str, list[float]] = {k: [] for k in centre}
    refused = 0
    for shift in draw:
        try:
            answer = function(**{**values, **{n: values[n] + float(s) for n, s in zip(names, shift)}})
        except HugoniotError:
            refused += 1
            continue
        for k in rows:
            rows[k].append(float(answer[k]))
    if refused > 0.01 * samples:
        raise OutOfRange(f"{refused} of {samples} samples fall outside the range of the laws: the errors of the "
                         "inputs are larger than their distance to the limits of the laws")
    spreads = {}
    for k, found in rows.items():
        low, high = np.percentile(found, [15.865525393145708, 84.1344746068543])
        spreads[k] = Spread(centre[k], float(np.std(found, ddof=1)), float(low), float(high), {})
    return spreads
