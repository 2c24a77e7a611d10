r"""Constants of a rate from a Pop plot: run distances of pistons brought to a line $\log_{10} p = a + b\log_{10} x^*$.

A few constants of the burn law are changed until the run distances agree with the line in the sense of least squares of
$\ln(x/x^*)$; all others, and both equations of state, stay. Constants with a unit are sought by their logarithm, powers as they are,
and a coefficient of a power of pressure by its rate at the middle of the pressures (else both would be nearly the same unknown). The
search is that of Levenberg and Marquardt, its slopes by differences of run distances. Each run has a fixed number of zones in the run
distance it is meant to have, so all pressures are read equally well; at the end every run is repeated with zones half the size.

Source of the search: D. W. Marquardt, J. Soc. Indust. Appl. Math. 11 (1963) 431.
"""

import math
import re
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from hugoniot.campaign.pop_plot import Initiation, charge_of, initiation
from hugoniot.diagnostics.detonation import PopLine
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN
from hugoniot.materials.material import Material

ROOM = 8.0            # charge, in run distances of the line; what has not turned within it counts as that long
DIFFERENCE = 0.05     # of an unknown, for slopes: well above what the mesh does to a reading, 0.3 %
LONGEST_STEP = 1.0    # of an unknown
SETTLED = 2e-3        # step of all unknowns at which the search ends
ITERATIONS = 12
GIVE_UP = 1e3         # damping at which no shorter step helps


@dataclass(frozen=True)
class RateFit:
    """A calibrated rate.

    material   with the constants found
    before     constants at the start, by name; `after` those found
    points     the runs with them, by rising pressure
    ratios     run distances over those of the line; `refined` the same with zones half the size
    zones      in a run distance
    runs       how many were made
    """

    material: Material
    before: dict[str, float]
    after: dict[str, float]
    points: tuple[Initiation, ...]
    ratios: tuple[float, ...]
    refined: tuple[float, ...]
    zones: int
    runs: int


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
    runs = 0

    def misfit(values, fine=1):
        nonlocal runs
        runs += wanted.size
        charge = charge_of(unknowns.material(values))

        def one(task):
            pressure, distance = task
            return initiation(charge, pressure, distance / (fine * zones), ROOM * distance, int(2.6 * fine * zones))

        with ThreadPoolExecutor(max_workers=max(1, jobs)) as pool:
            points = [*pool.map(one, zip(unknowns.pressures, wanted))]
        return np.log([_distance(p, x) / x for p, x in zip(points, wanted)]), points

    values = unknowns.start()
    found, points = misfit(values)
    if not any(math.isfinite(p.distance) for p in points):
        raise OutOfRange(f"with the constants it starts from no run turned within {ROOM:g} run distances of the line, or all did at once; "
                         f"start from constants that are nearer ({points[-1].note})")
    values, found, points = _search(lambda v: misfit(v), values, found, points)
    refined, _ = misfit(values, 2)
    after = unknowns.material(values)
    burn = dict(zip(adjust, (float(getattr(after.burn, name)) for name in adjust)))
    return RateFit(after, {name: float(getattr(material.burn, name)) for name in adjust}, burn, tuple(points),
                   tuple(float(math.exp(v)) for v in found), tuple(float(math.exp(v)) for v in refined), zones, runs)


def _distance(point: Initiation, wanted: float) -> float:
    """The run distance; where there is none, the room of the charge or, where it turned at once, an eighth of what is wanted."""
    if math.isfinite(point.distance):
        return point.distance
    return wanted / ROOM if point.note.startswith("turned") else wanted * ROOM


class _Unknowns:
    """The constants sought, as numbers of order one."""

    def __init__(self, material: Material, adjust: Sequence[str], pressures: Sequence[float]):
        self.base, self.names = material, tuple(adjust)
        law = BURN.of(material.burn)
        strange = [name for name in self.names if name not in law.parameters._fields]
        if strange or not self.names or len(set(self.names)) < len(self.names):
            raise OutOfRange(f"the burn law {law.name} has no constant '{', '.join(strange)}' to adjust" if strange else
                             f"name the constants to adjust once each; {law.name} has: {', '.join(law.parameters._fields)}")
        self.pressures = tuple(sorted(set(float(p) for p in pressures)))
        if len(self.pressures) < len(self.names) or not all(0.0 < p < math.inf for p in self.pressures):
            raise OutOfRange(f"{len(self.names)} constants need as many pressures at least, all positive")
        self.middle = math.exp(sum(map(math.log, self.pressures)) / len(self.pressures))
        self.power = {name: match.group(1) for name in law.parameters._fields
                      if (match := re.search(r"Pa\^(\w+)", law.units[name])) is not None}
        self.logarithmic = [law.units[name] != "1" for name in self.names]
        lone = [name for name in self.names if name in self.power.values() and not any(self.power.get(n) == name for n in self.names)]
        if lone:
            factor = next(n for n, p in self.power.items() if p == lone[0])
            raise OutOfRange(f"the power '{lone[0]}' of the pressure cannot be adjusted without its coefficient '{factor}': name both")
        zero = [name for name, log in zip(self.names, self.logarithmic) if log and not getattr(material.burn, name) > 0.0]
        if zero:
            raise OutOfRange(f"the constant '{zero[0]}' starts from 0 and has no logarithm to adjust; give it a value to start from")

    def _scale(self, name: str, burn) -> float:
        """Pa^y of a coefficient at the middle pressure; 1 for other constants."""
        return self.middle ** getattr(burn, self.power[name]) if name in self.power else 1.0

    def start(self) -> np.ndarray:
        burn = self.base.burn
        return np.array([math.log(getattr(burn, name) * self._scale(name, burn)) if log else getattr(burn, name)
                         for name, log in zip(self.names, self.logarithmic)])

    def material(self, values) -> Material:
        plain = {name: max(float(v), 0.0) for name, v, log in zip(self.names, values, self.logarithmic) if not log}
        burn = self.base.burn._replace(**plain)
        return replace(self.base, burn=burn._replace(**{name: math.exp(v) / self._scale(name, burn)
                                                        for name, v, log in zip(self.names, values, self.logarithmic) if log}))


def _search(misfit, values, found, points):
    """Levenberg and Marquardt from `values`, where misfit(values) is (found, points)."""
    damping = 1e-3
    for _ in range(ITERATIONS):
        slopes = np.empty((found.size, values.size))
        for k in range(values.size):
            ahead = values.copy()
            ahead[k] += DIFFERENCE
            slopes[:, k] = (misfit(ahead)[0] - found) / DIFFERENCE
        square = slopes.T @ slopes
        while True:
            step = -np.linalg.solve(square + damping * np.diag(np.diag(square) + 1e-12), slopes.T @ found)
            step *= min(1.0, LONGEST_STEP / np.abs(step).max())
            there, its_points = misfit(values + step)
            if there @ there < found @ found:
                break
            damping *= 10.0
            if damping > GIVE_UP or np.abs(step).max() < SETTLED:
                return values, found, points
        values, found, points, damping = values + step, there, its_points, 0.1 * damping
        if np.abs(step).max() < SETTLED:
            break
    return values, found, points
