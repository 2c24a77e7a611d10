"""Which measured Us-up states are fitted for the library, and the fits recomputed: `theory.fits.us_up` does the least squares.

The states come from `us_up_points.csv`; a `Selection` says which of them a fit takes.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from hugoniot.materials.material import Material
from hugoniot.materials.schema import Row, points
from hugoniot.materials.search import spelling
from hugoniot.theory.fits import UsUpFit, us_up


@dataclass(frozen=True)
class Selection:
    """Which states a fit takes: a material of the points table, a range of up (m/s), and what else the source says."""

    material: str
    up_min: float = 0.0
    up_max: float = float("inf")
    source: str = ""
    porosity_below: float = float("inf")
    words: str = ""

    def states(self) -> list[Row]:
        """The states, in file order."""
        return [p for p in points() if p.material == self.material and p["use_for_fit"] == 1.0 and self.up_min <= p["up"] <= self.up_max
                and self.source in p.source and p.get("porosity", 1.0) < self.porosity_below]


MARSH = "S. P. Marsh"
# Above 1540 m/s iron is past its alpha-epsilon transition and the region where both phases are present.
IRON = {"up_min": 1540.0, "porosity_below": 1.01}
# row id of the recorded fit -> (selection, degree)
RECORDED = {
    "U202": (Selection("Copper", words="all shock states of Marsh"), 1),
    "U203": (Selection("Copper", words="all shock states of Marsh"), 2),
    "U204": (Selection("Water", words="all states of Marsh"), 1),
    "U205": (Selection("Water", words="all states of Marsh"), 2),
    "U206": (Selection("Iron", source=MARSH, up_max=3200.0, words="solid, above the transition, Marsh only, to 3.2 km/s", **IRON), 1),
    "U207": (Selection("Iron", up_max=5000.0, words="solid, above the transition, to 5 km/s", **IRON), 1),
    "U208": (Selection("Iron", source=MARSH, up_max=3200.0, words="solid, above the transition, Marsh only, to 3.2 km/s", **IRON), 2),
    "U209": (Selection("Iron", up_max=10000.0, words="solid, above the transition, to 10 km/s", **IRON), 2),
    "U210": (Selection("Water", up_max=2600.0, words="Marsh, to 2.6 km/s"), 1),
    "U211": (Selection("Basalt, Vacaville (rho 2860)", up_min=2000.0, words="above 2 km/s"), 1),
    "U212": (Selection("Fused silica", words="all states"), 1),
    "U213": (Selection("Forsterite Mg2SiO4", words="all states"), 1),
    "U214": (Selection("Olivine (San Carlos)", words="all states"), 1),
}


def fit(states: Iterable[Row], degree: int) -> UsUpFit:
    """A polynomial of degree 1 or 2 through measured states; OutOfRange with too few of them."""
    chosen = list(states)
    return us_up([p["up"] for p in chosen], [p["us"] for p in chosen], degree)


@cache
def recorded(identity: str) -> UsUpFit:
    """The fit behind a row with status `derived`, recomputed from the measured states."""
    selection, degree = RECORDED[identity]
    return fit(selection.states(), degree)


_SLOPES = {1: ("c0", "s"), 2: ("c0", "s1", "s2")}   # parameters that a fit of that degree gives a law


def of_law(rows: Sequence[str], par) -> tuple[tuple[str, ...], np.ndarray] | None:
    """(parameters, their covariance) of a law whose Hugoniot is the recorded fit behind the first of a material's rows; None else."""
    if not rows or rows[0] not in RECORDED:
        return None
    names = _SLOPES[RECORDED[rows[0]][1]]
    return (names, np.asarray(recorded(rows[0]).covariance)) if set(names) <= set(par._fields) else None


def uncertain(layers: Iterable[tuple[Sequence[str], Material]]) -> tuple[dict, dict, dict]:
    """(values, standard deviations, correlations) of the parameters MATERIAL.parameter that recorded fits give the laws of these
    materials, each with its rows: what `theory.uncertainty.propagate` takes."""
    values: dict[str, float] = {}
    sigmas: dict[str, float] = {}
    together: dict[tuple[str, str], float] = {}
    for rows, material in layers:
        known = of_law(rows, material.eos)
        if known is None:
            continue
        names, covariance = [f"{material.name}.{n}" for n in known[0]], known[1]
        deviations = np.sqrt(np.diag(covariance))
        values |= {name: float(getattr(material.eos, name.rpartition(".")[2])) for name in names}
        sigmas |= dict(zip(names, deviations.tolist()))
        together |= {(names[i], names[j]): float(covariance[i, j] / deviations[i] / deviations[j])
                     for i in range(len(names)) for j in range(i)}
    return values, sigmas, together


def library_points(names: Sequence[str]) -> np.ndarray | None:
    """Measured (up, us) in m/s of a material of the library that is fully dense, or None."""
    wanted = {spelling(n) for n in names}
    found = [(p["up"], p["us"]) for p in points()
             if spelling(p.material) in wanted and p["use_for_fit"] == 1.0 and p.get("porosity", 1.0) < 1.01]
    return np.array(found, float) if found else None
