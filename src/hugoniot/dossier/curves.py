"""Curves for comparing Hugoniots: materials with each other, or the sources of one material, with the measured states."""

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from hugoniot.dossier import fits
from hugoniot.dossier.derived import material_hugoniot, shock_velocity
from hugoniot.errors import DeckError, NoSolution, OutOfRange
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.schema import Row

SAMPLES = 121


@dataclass(frozen=True)
class Curve:
    """A principal Hugoniot: up, us in m/s, p in Pa (p0 neglected); `reliable` tells where up is within the stated range."""

    label: str
    up: np.ndarray
    us: np.ndarray
    p: np.ndarray
    reliable: np.ndarray
    source: str
    status: str
    default: bool = False
    material: str = ""

    @property
    def middle(self) -> tuple[float, float]:
        """(up, us) half way along the curve, m/s."""
        k = len(self.up) // 2
        return float(self.up[k]), float(self.us[k])


@dataclass(frozen=True)
class States:
    """Measured states of one material."""

    label: str
    up: np.ndarray
    us: np.ndarray
    p: np.ndarray
    material: str = ""


@dataclass(frozen=True)
class Comparison:
    title: str
    curves: tuple[Curve, ...]
    states: tuple[States, ...]
    notes: tuple[str, ...] = field(default=())

    def table(self) -> dict:
        """Plain data for programs."""
        curves = [{"label": c.label, "source": c.source, "status": c.status, "up": c.up, "us": c.us, "p": c.p} for c in self.curves]
        return {"title": self.title, "curves": curves, "notes": list(self.notes),
                "states": [{"label": s.label, "up": s.up, "us": s.us, "p": s.p} for s in self.states]}


# names in the points table that belong to a curated material
MEASURED = {
    "copper": ("Copper",), "iron": ("Iron",), "water": ("Water",), "fused_silica": ("Fused silica",), "forsterite": ("Forsterite Mg2SiO4",),
    "graphite": ("Graphite, pressed (rho 2.13)",), "olivine": ("Olivine (San Carlos)",),
    "basalt": ("Basalt (rho 2672)", "Basalt, Vacaville (rho 2860)"), "nickel": ("Nickel",), "beryllium": ("Beryllium", "Beryllium S-200"),
    "magnesia": ("Periclase MgO (single crystal)",), "pmma": ("PMMA",), "lead": ("Lead",), "platinum": ("Platinum",),
    "silicon_carbide": ("SiC",), "tin": ("Tin",), "vanadium": ("Vanadium",), "polystyrene": ("Polystyrene",),
    "tungsten": ("Tungsten",), "tantalum": ("Tantalum",), "steel_304": ("Stainless steel 304",), "lithium_fluoride": ("LiF",),
    "ice": ("Ice",), "aluminum_6061": ("Aluminum 6061",),
}


def comparison(entries: Sequence[Entry], up_max: float | None = None) -> Comparison:
    """One material: its default and every other source. Several: their defaults. Measured states in both cases."""
    if not entries:
        raise DeckError.single("material compare", None, "names", "nothing to compare", "give a material, or several")
    for entry in entries:
        if "reacted" in EOS.of(entry.material.eos).flags and entry.unreacted is None:
            raise DeckError.single("material compare", None, entry.name, "detonation products have no principal Hugoniot",
                                   "compare materials with an unreacted equation of state")
    top = up_max or _top(entries, [s for entry in entries for s in measured(entry.name)])
    states = tuple(s for entry in entries for s in measured(entry.name, 1.03 * top))
    if len(entries) == 1:
        curves, notes = _sources(entries[0], top)
        title = f"{entries[0].title}: Hugoniots from several sources"
    else:
        made = [(entry, _material_curve(entry, top)) for entry in entries]
        curves = [c for _, c in made if c]
        notes = [f"{e.name}: no Hugoniot in this range" for e, c in made if c is None]
        title = ", ".join(e.title for e in entries)
    return Comparison(title, tuple(curves), states, tuple(notes))


def measured(name: str, up_max: float | None = None) -> list[States]:
    """Measured states of a curated material; porous ones are left out, they lie on other Hugoniots."""
    found = []
    for material in MEASURED.get(name, ()):
        rows = [p for p in schema.points() if p.material == material and p["up"] > 0.0 and p.get("porosity", 1.0) < 1.01
                and (up_max is None or p["up"] <= up_max)]
        if rows:
            up, us, rho = (np.array([p[k] for p in rows]) for k in ("up", "us", "rho0"))
            found.append(States(f"{material}, {len(rows)} states", up, us, rho * us * up, name))
    return found


def _top(entries: Sequence[Entry], states: Sequence[States]) -> float:
    """A range that holds most measured states, or the stated ranges, or 3 km/s."""
    if states:
        return float(max(np.quantile(s.up, 0.95) for s in states)) * 1.1
    stated = [e.material.valid_up_to for e in entries if e.material.valid_up_to]
    return max(stated, default=3000.0)


def _sources(entry: Entry, top: float) -> tuple[list[Curve], list[str]]:
    curves, notes = [], []
    rows = [schema.row(i) for i in entry.comparison_rows() if i[0] in "UT"]
    own = _material_curve(entry, top)
    if own is not None:
        curves.append(own)
    used = entry.rows[0] if entry.rows else ""
    for row in rows:
        if row.id == used or "rho0" not in row and row.id not in fits.RECORDED:
            continue
        curve = _row_curve(row, top)
        if curve is None:
            notes.append(f"{row.id}: no Hugoniot in this range")
        else:
            curves.append(curve)
    return curves, notes


def _row_curve(row: Row, top: float) -> Curve | None:
    speed = partial(shock_velocity, row) if row.table == "us_up" else partial(material_hugoniot, library.find(row.id))
    mark = " (not checked)" if row.status == "recalled" else " (doubtful)" if row.marks else ""
    up, us = _sample(speed, top)
    if len(up) < 2:
        return None
    reliable = (up >= (row.get("up_min") or 0.0)) & (up <= (row.get("up_max") or math.inf))
    return Curve(f"{row.id} {short_source(row)}{mark}", up, us, row["rho0"] * us * up, reliable, row.source, row.status)


def short_source(row: Row) -> str:
    """A source in a few words: the first author or name, or what was fitted."""
    if row.id in fits.RECORDED:
        selection, degree = fits.RECORDED[row.id]
        return f"{'linear' if degree == 1 else 'quadratic'} fit to {selection.words or 'measured states'}"
    if row.table == "tillotson":
        return f"Tillotson, {row.material}"
    first = row.source.split(",")[0].split(":")[0]
    year = re.search(r"\b(19|20)\d\d\b", row.source)
    first = first.replace(" Community Wiki", " Wiki")
    return first[:40] + (f" {year.group(0)}" if year and year.group(0) not in first else "")


def _material_curve(entry: Entry, top: float) -> Curve | None:
    material, title = entry.material, entry.title
    first = schema.row(entry.rows[0]) if entry.rows else None
    if "reacted" in EOS.of(material.eos).flags:
        material, title = replace(material, eos=entry.unreacted), f"{entry.title}, unreacted"
        first = _unreacted_row(entry) or first
    own = first is not None and first.table == "us_up" and material.valid_up_to      # else its row's range is not this material's
    low = (first.get("up_min") or 0.0) if own else 0.0
    high = material.valid_up_to or math.inf
    rho0 = float(reference_state(material.eos)[0])
    label = f"{title} (row {first.id}, used here)" if entry.curated and first is not None else title
    source = first.source if first is not None else entry.file
    up, us = _sample(partial(material_hugoniot, material), top)
    if len(up) < 2:
        return None
    status = first.status if first else "user"
    return Curve(label, up, us, rho0 * us * up, (up >= low) & (up <= high), source, status, True, entry.name)


def _unreacted_row(entry: Entry) -> Row | None:
    """The row of a material's rows that the equation of state of the unreacted explosive is taken from."""
    sources = {source.source for source in entry.material.sources if source.quantity.startswith("unreacted.")}
    return next((row for row in map(schema.row, entry.rows) if row.source in sources), None)


def _sample(speed: Callable[[float], float], top: float) -> tuple[np.ndarray, np.ndarray]:
    """(up, us) at even steps to `top`, or to where the Hugoniot ends."""
    ups, speeds = [], []
    for up in np.linspace(0.0, top, SAMPLES)[1:]:
        try:
            us = float(speed(float(up)))
        except (NoSolution, OutOfRange):
            break
        if not math.isfinite(us) or us <= up:
            break
        ups.append(float(up))
        speeds.append(us)
    return np.array(ups), np.array(speeds)
