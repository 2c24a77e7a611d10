r"""Pop plots as records of a fit: measured run distances to detonation over input pressure, beside those of an explosive of the deck.

A file whose columns are `pressure [GPa], distance [mm]` is a Pop plot; `distance sigma [mm]` is the uncertainty. The residual of a point is

$$r = \frac{\ln(x/x_d)}{\sigma/x_d}$$

since run distances span decades. Every run has the same number of zones in the distance it is meant to have, so that all points are read
equally well; a shock that does not turn within `ROOM` of these counts as that long.
"""

import math
import pathlib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from hugoniot.campaign.pop_plot import Charge, Initiation, charge_of, initiation
from hugoniot.campaign.targets import Target
from hugoniot.errors import DeckError
from hugoniot.files import csv_rows, read_regular
from hugoniot.output.atomic import legible
from hugoniot.output.compare import split_unit
from hugoniot.units import UnitError, parse

ROOM = 8.0            # charge, in run distances of the data; what has not turned within it counts as that long
ZONES = 200           # in a run distance
RELATIVE_SIGMA = 0.05     # of a run distance for which no uncertainty is given
_UNITS = {"pressure": "Pa", "distance": "m", "distance sigma": "m"}


@dataclass(frozen=True)
class PopTarget(Target):
    """A Pop plot: `time` holds the input pressures (n,) Pa in rising order, `values` the run distances (n,) m."""

    def model(self, answer: Mapping, shift: float = 0.0, scale: float = 0.0) -> np.ndarray:
        """Run distances of the model, m."""
        return np.asarray(answer["records"][self.name][1], dtype=float)

    def beside(self, model: np.ndarray) -> np.ndarray:
        """ln(model / data) / (sigma / data)."""
        return np.log(model / self.values) * self.values / self.sigma


def is_pop_plot(path: str) -> bool:
    """Whether a file's first column is an input pressure. Raises `FileTrouble`."""
    head = _lines(path)[:1]
    return bool(head) and split_unit(head[0][1][0])[0] == "pressure"


def read_pop_plot(path: str, number: int, sigma: str | None, notes: list[str]) -> PopTarget:
    """The Pop plot of a file, the `number`-th of a fit; `sigma` is the uncertainty of a distance where the file has none.

    Raises `DeckError`, `FileTrouble`.
    """
    lines, name = _lines(path), pathlib.Path(path).name
    heads = [split_unit(head) for head in lines[0][1]]
    for k, (head, unit) in enumerate(heads):
        if head not in _UNITS or unit is None:
            wrong = "has no unit" if head in _UNITS else "is not a column of a Pop plot"
            raise DeckError.single(name, 1, f"column {k + 1}", f"'{lines[0][1][k].strip()}' {wrong}",
                                   "write: pressure [GPa], distance [mm], distance sigma [mm]")
    if "distance" not in dict(heads) or len(lines) < 2:
        raise DeckError.single(name, 1, "table", "a Pop plot needs input pressures and run distances",
                               "write: pressure [GPa], distance [mm]")
    rows = sorted(_row(name, line, cells, heads) for line, cells in lines[1:])
    columns = dict(zip([head for head, _ in heads], np.array(rows).T))
    values = columns["distance"]
    if "distance sigma" in columns:
        spread = columns["distance sigma"]
    elif sigma is not None:
        spread = np.full(len(values), _si("command line", None, sigma, "m", "--sigma"))
    else:
        notes.append(f"{name}: no uncertainty is given; {100 * RELATIVE_SIGMA:g} % of each run distance is taken")
        spread = RELATIVE_SIGMA * values
    if not (np.all(columns["pressure"] > 0.0) and np.all(values > 0.0) and np.all(spread > 0.0)):
        raise DeckError.single(name, None, "table", "pressures, run distances and their uncertainties must be above 0")
    return PopTarget(name, f"pop plot {number}.distance", "m", columns["pressure"], values, spread)


def _lines(path: str) -> list[tuple[int, list[str]]]:
    with legible(pathlib.Path(path), "no data can be read"):
        text = read_regular(pathlib.Path(path)).decode("utf-8-sig", errors="replace")
    return csv_rows(text, path)


def _row(name: str, line: int, cells: list[str], heads) -> list[float]:
    if len(cells) != len(heads):
        raise DeckError.single(name, line, "row", f"values: {len(cells)}, column headers: {len(heads)}",
                               "give one value for each column")
    return [_si(name, line, f"{cell.strip()} {unit}", _UNITS[head]) for cell, (head, unit) in zip(cells, heads)]


def _si(name: str, line: int | None, text: str, unit: str, key: str = "value") -> float:
    try:
        return parse(text, unit)
    except UnitError as error:
        raise DeckError.single(name, line, key, error.message, error.hint) from None


# -- the model -------------------------------------------------------------------------------------------------------------
def explosive_of(problem):
    """The material of a problem that burns by a rate. Raises `DeckError` where there is none, or more than one."""
    found = [material for material in problem.materials.values() if material.burn is not None]
    if len(found) != 1:
        message = (f"the deck has {len(found)} materials that burn, but a Pop plot belongs to one" if found else
                   "a Pop plot needs an explosive with a rate law, and the deck has none")
        raise DeckError.single("deck", None, "material", message, "use a deck in which one material burns, by a rate law")
    return found[0]


def initiations(charge: Charge, pressures: Sequence[float], wanted: Sequence[float], zones: int, jobs: int = 1,
                fine: int = 1) -> list[Initiation]:
    """One run for each pressure, with fine * zones in the distance it is wanted to have."""
    def one(task):
        pressure, distance = task
        return initiation(charge, pressure, distance / (fine * zones), ROOM * distance, int(2.6 * fine * zones))

    with ThreadPoolExecutor(max_workers=max(1, jobs)) as pool:
        return [*pool.map(one, zip(pressures, wanted))]


def run_distance(point: Initiation, wanted: float) -> float:
    """The run distance; where there is none, eight times what is wanted, or an eighth of it where the charge detonated at once."""
    if math.isfinite(point.distance):
        return point.distance
    return wanted / ROOM if point.at_once else wanted * ROOM


def distances(material, pressures: Sequence[float], wanted: Sequence[float]) -> list[float]:
    """The run distances of a material at input pressures (Pa), m. Raises `OutOfRange` for one that does not burn by a rate."""
    points = initiations(charge_of(material), pressures, wanted, ZONES)
    return [run_distance(point, distance) for point, distance in zip(points, wanted)]
