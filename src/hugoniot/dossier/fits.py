"""Which measured Us-up states are fitted for the library or belong to a row of it, and the fits recomputed.

The states come from `us_up_points.csv`; a `Selection` says which of them a fit takes, or which a published line is compared with.
`theory.fits.us_up` does the least squares; `scatter` gives range and deviation of the states about any row's line.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np

from hugoniot.dossier.derived import shock_velocity
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
DENSE = "initially non-porous iron above the alpha-epsilon region"
IRON = {"up_min": 1540.0, "porosity_below": 1.01}
MAGNESIA = "Periclase MgO (single crystal)"
# row id of the recorded fit -> (selection, degree)
RECORDED = {
    "U202": (Selection("Copper", words="shock states of Marsh except 3 from free-surface velocities"), 1),
    "U203": (Selection("Copper", words="shock states of Marsh except 3 from free-surface velocities"), 2),
    "U204": (Selection("Water", words="all shock states of Marsh"), 1),
    "U205": (Selection("Water", words="all shock states of Marsh"), 2),
    "U206": (Selection("Iron", source=MARSH, up_max=3200.0, words=f"{DENSE}, Marsh only", **IRON), 1),
    "U207": (Selection("Iron", up_max=5000.0, words=f"{DENSE}, up below 5 km/s", **IRON), 1),
    "U208": (Selection("Iron", source=MARSH, up_max=3200.0, words=f"{DENSE}, Marsh only", **IRON), 2),
    "U209": (Selection("Iron", up_max=10000.0, words=f"{DENSE}, up below 10 km/s", **IRON), 2),
    "U210": (Selection("Water", up_max=2600.0, words="states of Marsh at up below 2.6 km/s"), 1),
    "U211": (Selection("Basalt, Vacaville (rho 2860)", up_min=2000.0, words="states at up above 2 km/s"), 1),
    "U212": (Selection("Fused silica", words="all states"), 1),
    "U213": (Selection("Forsterite Mg2SiO4", words="all states of forsterite"), 1),
    "U214": (Selection("Olivine (San Carlos)", words="all states of San Carlos olivine"), 1),
    "U218": (Selection("Nickel", words="all shock states of Marsh"), 1),
    "U219": (Selection("Argon (liquid)", words="all shock states of Marsh"), 2),
    "U220": (Selection("Pyrolusite MnO2", words="all shock states of Marsh"), 1),
    "U221": (Selection("Serpentine", up_min=2200.0, words="states of Marsh at up above 2.2 km/s"), 1),
    "U222": (Selection("Toluene", up_max=2900.0, words="states of Marsh at up below 2.9 km/s"), 1),
    "U223": (Selection("Beryllium", words="all shock states of Marsh"), 1),
    "U224": (Selection("Beryllium S-200", words="states from a gas gun"), 1),
    "U225": (Selection("Bismuth", up_min=1300.0, words="states at up above 1.3 km/s"), 1),
    "U226": (Selection("Germanium", up_min=1500.0, words="states at up above 1.5 km/s"), 1),
    "U227": (Selection("KCl", up_min=1300.0, words="states above the transition"), 1),
    "U228": (Selection(MAGNESIA, up_max=5500.0, words="states at up below 5.5 km/s"), 1),
    "U229": (Selection(MAGNESIA, words="all states except a doubtful one"), 1),
    "U230": (Selection("Sodium", words="all states"), 1),
    "U231": (Selection("NiAl", words="all states"), 1),
    "U232": (Selection("PMMA", up_min=500.0, up_max=2600.0, words="states with up from 0.5 to 2.6 km/s"), 1),
    "U233": (Selection("PMMA", up_min=2600.0, up_max=8000.0, words="states with up from 2.6 to 8 km/s"), 1),
    "U234": (Selection("PMMA", up_min=2600.0, words="states at up above 2.6 km/s"), 2),
    "U235": (Selection("Lead", words="all shock states of Marsh"), 1),
    "U236": (Selection("Platinum", words="all shock states"), 1),
    "U237": (Selection("SiC", up_min=1600.0, words="states of Marsh at up above 1.6 km/s"), 1),
    "U238": (Selection("Tin", words="all shock states of Marsh"), 1),
    "U239": (Selection("Vanadium", words="all shock states"), 2),
    "U240": (Selection("Polystyrene", words="states from laser-driven shocks"), 1),
    "U261": (Selection("Tungsten", up_max=4000.0, words="states of the rusbank database at up below 4 km/s"), 1),
    "U262": (Selection("Tungsten", words="all shock states that the rusbank database lists"), 2),
    "U263": (Selection("Tantalum", words="all shock states that the rusbank database lists"), 1),
    "U264": (Selection("Stainless steel 304", words="all shock states that the rusbank database lists"), 1),
    "U265": (Selection("LiF", words="all shock states that the rusbank database lists"), 1),
    "U266": (Selection("Ice", words="all shock states that the rusbank database lists"), 1),
    "U267": (Selection("Aluminum 6061", words="all shock states that the rusbank database lists"), 1),
}
_COPPER, _BERYLLIUM, _NICKEL, _LEAD = (RECORDED[i][0] for i in ("U202", "U223", "U218", "U235"))
_TIN, _PLATINUM, _WATER, _IRON = (RECORDED[i][0] for i in ("U238", "U236", "U210", "U206"))
_PMMA = Selection("PMMA", up_min=500.0, up_max=5500.0, words="states with up from 0.5 to 5.5 km/s")
_VANADIUM = Selection("Vanadium", up_max=5000.0, words="states at up below 5 km/s")
_TUNGSTEN, _STEEL, _ALUMINUM = (RECORDED[i][0] for i in ("U261", "U264", "U267"))
_TANTALUM = Selection("Tantalum", up_max=2300.0, words="states at up below 2.3 km/s")
_LIF = Selection("LiF", up_max=4000.0, words="states at up below 4 km/s")
# rows that were fitted elsewhere -> the states of the same material at the same density that they are compared with
STATES = {
    "U007": _COPPER, "U058": _COPPER, "U189": _COPPER, "U194": _COPPER, "U110": _WATER, "U178": _WATER, "U179": _WATER,
    "U094": _IRON, "U165": _IRON, "U215": _IRON, "U005": _BERYLLIUM, "U059": _BERYLLIUM, "U187": _BERYLLIUM,
    "U257": RECORDED["U224"][0], "U016": _NICKEL, "U099": _NICKEL, "U186": _NICKEL, "U011": _LEAD, "U100": _LEAD, "U183": _LEAD,
    "U185": _LEAD, "U020": _PLATINUM, "U075": _PLATINUM, "U167": _PLATINUM, "U031": _TIN, "U102": _TIN, "U192": _TIN,
    "U258": Selection("Platinum", source="Morgan", words="states of Morgan"),
    "U040": _VANADIUM, "U065": _VANADIUM, "U047": _PMMA, "U169": _PMMA,
    "U084": Selection("PMMA", up_max=3000.0, words="states at up below 3 km/s"),
    "U147": Selection("PMMA", up_max=17000.0, words="states at up below 17 km/s"),
    "U076": RECORDED["U237"][0], "U125": RECORDED["U228"][0], "U159": RECORDED["U229"][0], "U098": RECORDED["U230"][0],
    "U091": Selection("Bismuth", up_max=2500.0, words="states at up below 2.5 km/s"),
    "U105": Selection("KCl", up_min=1300.0, up_max=5000.0, words="states above the transition, at up below 5 km/s"),
    "U149": RECORDED["U212"][0], "U150": RECORDED["U212"][0], "U034": _TUNGSTEN, "U070": _TUNGSTEN, "U177": _TUNGSTEN,
    "U027": _TANTALUM, "U067": _TANTALUM, "U174": _TANTALUM, "U145": RECORDED["U263"][0], "U193": RECORDED["U263"][0],
    "U024": _STEEL, "U078": _STEEL, "U143": _STEEL, "U156": _STEEL, "U180": _STEEL, "U190": _STEEL,
    "U046": _LIF, "U106": _LIF, "U158": _LIF, "U170": _LIF, "U151": RECORDED["U265"][0], "U155": RECORDED["U266"][0],
    "U003": _ALUMINUM, "U108": _ALUMINUM, "U142": _ALUMINUM, "U181": _ALUMINUM,
}


class Scatter(NamedTuple):
    """What measured states say of a row: range of their particle velocities, root mean square of Us about its line (m/s), number."""

    least: float
    highest: float
    deviation: float
    count: int


def belonging(identity: str) -> Selection | None:
    """The measured states that belong to a row, fitted here or not; None where the library has none."""
    return RECORDED[identity][0] if identity in RECORDED else STATES.get(identity)


def scatter(row: Row) -> Scatter | None:
    r"""Range and deviation $\sqrt{\sum_n(U_s(u_n) - U_n)^2/N}$ of the measured states about the row's own line; None without states."""
    chosen = belonging(row.id)
    if chosen is None:
        return None
    states = chosen.states()
    misses = [shock_velocity(row, p["up"]) - p["us"] for p in states]
    velocities = [p["up"] for p in states]
    return Scatter(min(velocities), max(velocities), float(np.sqrt(np.mean(np.square(misses)))), len(states))


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
