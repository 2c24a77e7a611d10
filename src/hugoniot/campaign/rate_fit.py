r"""Constants of a rate from a Pop plot: run distances of pistons brought to a line $\log_{10} p = a + b\log_{10} x^*$.

A few constants of the burn law are changed until the run distances agree with the line in the sense of least squares of
$\ln(x/x^*)$; all others, and both equations of state, stay. This is a fit as any other (`campaign.fit`): the run distances of the line are
a Pop plot (`campaign.pop_target`), the covariance and the intervals are those of the fit, and so is what they mean. Constants with a
unit are sought by their logarithm, powers as they are, and a coefficient of a power of pressure by its rate at the middle of the
pressures (else both would be nearly the same unknown). The search begins at the constants given, and run distances answer smoothly, so
that a few runs make a plane. Each run has a fixed number of zones in the run distance it is meant to have, so all pressures are read
equally well; at the end every run is repeated with zones half the size.
"""

import math
import pathlib
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from hugoniot.campaign.fit import Free, Problem
from hugoniot.campaign.fit_results import Fit, weighed
from hugoniot.campaign.pop_plot import Initiation, charge_of
from hugoniot.campaign.pop_target import RELATIVE_SIGMA, ROOM, PopTarget, initiations, run_distance
from hugoniot.campaign.run_fit import Fitted
from hugoniot.campaign.variables import Variable
from hugoniot.diagnostics.detonation import PopLine
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN
from hugoniot.materials.material import Material

WIDTH = 4.0           # of the range of an unknown on both sides of its start: a factor of e^4 for what is sought by its logarithm
TARGET = "pop plot 1.distance"


@dataclass(frozen=True)
class RateFit:
    """A calibrated rate.

    material   with the constants found
    before     constants at the start, by name; `after` those found
    points     the runs with them, by rising pressure
    ratios     run distances over those of the line; `refined` the same with zones half the size
    zones      in a run distance
    runs       how many were made
    fit        of the unknowns: values, standard deviations, intervals, correlations, chi-square, doubts; the uncertainty of the line's
               distances is taken as RELATIVE_SIGMA
    target, model   the line as a Pop plot, and the run distances beside it, m
    """

    material: Material
    before: dict[str, float]
    after: dict[str, float]
    points: tuple[Initiation, ...]
    ratios: tuple[float, ...]
    refined: tuple[float, ...]
    zones: int
    runs: int
    fit: Fit
    target: PopTarget
    model: np.ndarray


def fit_rate(material: Material, line: PopLine, pressures: Sequence[float], adjust: Sequence[str] = ("g1", "y"), zones: int = 200,
             jobs: int = 1) -> RateFit:
    """Change the constants `adjust` of the material's burn law until its run distances at `pressures` (Pa) are those of the line.

    zones   in a run distance while the search goes on
    Raises OutOfRange for a material that does not burn by a rate, constants its law does not have or that cannot be sought, too few
    pressures, or a start so far off that no run says where to go.
    """
    charge_of(material)
    unknowns = _Unknowns(material, adjust, pressures)
    wanted = np.array([float(line.distance(p)) for p in unknowns.pressures])
    made: dict[tuple, list[Initiation]] = {}

    def points_of(values, fine=1):
        return initiations(charge_of(unknowns.material(values)), unknowns.pressures, wanted, zones, jobs, fine)

    def ask(changes: list[dict]) -> list[dict]:
        found = []
        for each in changes:
            points = made[tuple(each["values"])] = points_of(each["values"])
            found.append({"numbers": {}, "records": {TARGET: (None, [run_distance(p, x) for p, x in zip(points, wanted)])}})
        return found

    target = PopTarget("line", TARGET, "m", np.array(unknowns.pressures), wanted, RELATIVE_SIGMA * wanted)
    problem: Problem = Problem(unknowns, unknowns.free(), (target,), 0, 0.0, 0.0, "linear", ask, smooth=True)
    start = np.full(len(unknowns.names), 0.5)
    problem.answers([start])
    first = made[tuple(f.given(0.5) for f in problem.free)]
    if not any(math.isfinite(p.distance) for p in first):
        raise OutOfRange(f"with the starting constants {_no_distance(first)}; start from constants that are closer to the data")
    fit = weighed(problem, [problem.search(start)])
    values = [f.given(c) for f, c in zip(problem.free, fit.minimum.x)]
    model = target.model(problem.answers([fit.minimum.x])[0])
    finer = points_of(values, 2)
    after = unknowns.material(values)
    burn = {name: float(getattr(after.burn, name)) for name in adjust}
    refined = tuple(run_distance(p, x) / x for p, x in zip(finer, wanted))
    runs = (len(made) + 1) * wanted.size
    return RateFit(after, {name: float(getattr(material.burn, name)) for name in adjust}, burn, tuple(made[tuple(values)]),
                   tuple(float(v) for v in model / wanted), refined, zones, runs, fit, target, model)


def _no_distance(points: Sequence[Initiation]) -> str:
    """Why runs have no run distance, none of them."""
    at_once = sum(point.at_once for point in points)
    never = f"within {ROOM:g} times the measured run distance"
    if at_once == len(points):
        return "every run detonated at once: the rate is too high"
    if not at_once:
        return f"no run detonated {never}: the rate is too low"
    return f"{at_once} of {len(points)} runs detonated at once, the others not {never}"


def as_fitted(found: RateFit, deck: str, notes: Sequence[str], folder: pathlib.Path | None = None) -> Fitted:
    """The same as `hugoniot fit` has it, with the table of the burn law for a deck: what `fit_files.write_fit` writes."""
    return Fitted(found.fit, (found.target,), (found.model,), deck, tuple(notes), folder)


class _Unknowns:
    """The constants sought, as numbers of order one."""

    def __init__(self, material: Material, adjust: Sequence[str], pressures: Sequence[float]):
        self.base, self.names = material, tuple(adjust)
        law = BURN.of(material.burn)
        strange = [name for name in self.names if name not in law.parameters._fields]
        if strange:
            raise OutOfRange(f"the burn law {law.name} has no constant '{', '.join(strange)}' to adjust")
        if not self.names:
            raise OutOfRange(f"no constant to adjust is named; {law.name} has: {', '.join(law.parameters._fields)}")
        if len(set(self.names)) < len(self.names):
            raise OutOfRange(f"a constant to adjust is named twice: {', '.join(self.names)}")
        self.pressures = tuple(sorted(set(float(p) for p in pressures)))
        if len(self.pressures) < len(self.names) or not all(0.0 < p < math.inf for p in self.pressures):
            raise OutOfRange(f"give at least as many input pressures as constants to fit ({len(self.names)}), all positive")
        self.middle = math.exp(sum(map(math.log, self.pressures)) / len(self.pressures))
        self.power = {name: match.group(1) for name in law.parameters._fields
                      if (match := re.search(r"Pa\^(\w+)", law.units[name])) is not None}
        self.logarithmic = [law.units[name] != "1" for name in self.names]
        lone = [name for name in self.names if name in self.power.values() and not any(self.power.get(n) == name for n in self.names)]
        if lone:
            factor = next(n for n, p in self.power.items() if p == lone[0])
            raise OutOfRange(f"the power '{lone[0]}' of the pressure cannot be adjusted without its coefficient '{factor}': adjust both")
        zero = [name for name, log in zip(self.names, self.logarithmic) if log and not getattr(material.burn, name) > 0.0]
        if zero:
            raise OutOfRange(f"the constant '{zero[0]}' starts from 0, but its logarithm is adjusted; start from a positive value")

    def _scale(self, name: str, burn) -> float:
        """Pa^y of a coefficient at the middle pressure; 1 for other constants."""
        return self.middle ** getattr(burn, self.power[name]) if name in self.power else 1.0

    def start(self) -> np.ndarray:
        burn = self.base.burn
        return np.array([math.log(getattr(burn, name) * self._scale(name, burn)) if log else getattr(burn, name)
                         for name, log in zip(self.names, self.logarithmic)])

    def free(self) -> tuple[Free, ...]:
        """The unknowns as parameters of a fit, the start in the middle of their ranges."""
        return tuple(Free(Variable(self.word(name), "range", "", v - WIDTH, v + WIDTH)) for name, v in zip(self.names, self.start()))

    def word(self, name: str) -> str:
        """What is sought for a constant."""
        if name in self.power:
            return f"ln of the rate of {name} at {self.middle * 1e-9:.3g} GPa"
        return f"ln {name}" if self.logarithmic[self.names.index(name)] else name

    @staticmethod
    def changes_of(values) -> dict:
        """What a run is asked for."""
        return {"values": [float(value) for value in values]}

    def material(self, values) -> Material:
        plain = {name: max(float(v), 0.0) for name, v, log in zip(self.names, values, self.logarithmic) if not log}
        burn = self.base.burn._replace(**plain)
        return replace(self.base, burn=burn._replace(**{name: math.exp(v) / self._scale(name, burn)
                                                        for name, v, log in zip(self.names, values, self.logarithmic) if log}))
