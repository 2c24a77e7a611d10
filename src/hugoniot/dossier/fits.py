r"""Least-squares fits of measured Us-up states, with the standard deviations of their coefficients.

$U_s = \sum_k a_k u_p^k$, unweighted: $a = (X^TX)^{-1}X^TU_s$, residual variance $\hat\sigma^2 = \sum r^2/(n - m)$, covariance
$\hat\sigma^2 (X^TX)^{-1}$. The states come from `us_up_points.csv`; a `Selection` says which of them a fit takes.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import numpy as np

from hugoniot.materials.schema import Row, points


@dataclass(frozen=True)
class Fit:
    """coefficients and deviations (1 sd) in SI, constant term first; residual sd m/s; correlation of the first two coefficients."""

    coefficients: tuple[float, ...]
    deviations: tuple[float, ...]
    residual: float
    correlation: float
    count: int
    up_min: float
    up_max: float
    rho0: float

    def shock_velocity(self, up):
        """Us at `up` (number or array), m/s."""
        return sum(a * up ** k for k, a in enumerate(self.coefficients))

    def deviation(self, up: float) -> float:
        """Standard deviation of the fitted line (not of a state) at `up`, from the two-parameter covariance; linear fits only."""
        a, b = self.deviations[:2]
        return float(np.sqrt(max(a * a + b * b * up * up + 2.0 * self.correlation * a * b * up, 0.0)))


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


def fit(states: Iterable[Row], degree: int) -> Fit:
    """Fit a polynomial of that degree through measured states; ValueError with fewer states than coefficients + 1."""
    chosen = list(states)
    up, us = np.array([p["up"] for p in chosen]), np.array([p["us"] for p in chosen])
    if len(chosen) < degree + 2:
        raise ValueError(f"a fit of degree {degree} needs at least {degree + 2} states, got {len(chosen)}")
    scale = float(up.max())
    design = np.vander(up / scale, degree + 1, increasing=True)
    inverse = np.linalg.inv(design.T @ design)
    scaled = np.linalg.lstsq(design, us, rcond=None)[0]
    variance = float(np.sum((us - design @ scaled) ** 2)) / (len(chosen) - degree - 1)
    spread = np.sqrt(variance * np.diag(inverse))
    powers = scale ** -np.arange(degree + 1.0)
    return Fit(tuple(float(v) for v in scaled * powers), tuple(float(v) for v in spread * powers), variance ** 0.5,
               float(inverse[0, 1] / np.sqrt(inverse[0, 0] * inverse[1, 1])), len(chosen), float(up.min()), float(up.max()),
               float(np.mean([p["rho0"] for p in chosen])))


@cache
def recorded(identity: str) -> Fit:
    """The fit behind a row with status `derived`, recomputed from the measured states."""
    selection, degree = RECORDED[identity]
    return fit(selection.states(), degree)


def fits_of(material: str) -> dict[str, Fit]:
    """Recomputed fits of a material of the points table, by row id."""
    return {identity: recorded(identity) for identity, (selection, _) in RECORDED.items() if selection.material == material}


def measured_materials() -> list[str]:
    """Names with measured states."""
    return list(dict.fromkeys(p.material for p in points()))
