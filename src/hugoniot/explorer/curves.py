"""The curves of one material: Hugoniot with its measured states, isentropes, and what an explosive's products do."""

import math
from typing import Any

import numpy as np

from hugoniot.dossier import curves as house
from hugoniot.errors import HugoniotError, NoSolution, OutOfRange
from hugoniot.explorer.splits import about_split, farthest, split_of
from hugoniot.explorer.subjects import entry_of, inert_or_none, reacted
from hugoniot.explorer.surfaces import range_of
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library, schema
from hugoniot.materials.entry import Entry
from hugoniot.materials.validity import about_jump, about_law
from hugoniot.theory.chapman_jouguet import cj, detonation_hugoniot
from hugoniot.theory.exact.plate_push import gurney
from hugoniot.theory.fits import UsUpFit
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.isentrope import expansion_to, isentrope, reference, release
from hugoniot.theory.states import States

MOST = 130          # states of a curve; few enough that no compiler is needed
ALONG_A_RELEASE = 25
LEAST_TOP = 2000.0  # m/s: where no source states a range
BEYOND = 1.2        # how far beyond the range of its data a curve is drawn, dashed
_STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
_MORE = ("entropy", "gruneisen", "adiabatic_exponent")


def curves_of(name: str) -> dict[str, Any]:
    """All curves of a material, SI, under the names of their fields; `DeckError` for an unknown name."""
    entry = entry_of(name)
    material = inert_or_none(entry)
    found: dict[str, Any] = {"name": name, "title": entry.title, "law": EOS.of((material or entry.material).eos).name,
                             "valid_up_to": None if reacted(entry) else entry.material.valid_up_to, "hugoniot": None, "measured": [],
                             "products": None, "surface_range": range_of(material or entry.material), "pop": _pop(entry.material.library),
                             "gurney": _gurney(entry), "sources": [], "notes": []}
    if material is not None:
        found["measured"] = [{"label": s.label, "up": s.up, "us": s.us, "p": s.p} for s in house.measured(entry.name)]
        try:
            found |= _inert(material, entry, found["measured"])
        except HugoniotError as error:
            found["notes"].append(str(error))
    if reacted(entry):
        try:
            found["products"] = _products(entry)
        except HugoniotError as error:
            found["notes"].append(str(error))
    return found


def round_step(span: float, most: int = MOST) -> float:
    """A step of 1, 2, 2.5 or 5 times a power of ten with which at most `most` steps reach `span`."""
    least = span / most
    decade = 10.0 ** math.floor(math.log10(least))
    return next(decade * k for k in _STEPS if decade * k >= least * (1.0 - 1e-12))


def _inert(material, entry: Entry, measured: list) -> dict:
    ahead = Initial.at_rest(material)
    states = _reached(material, ahead, _top(material, ahead, measured))
    top = len(states) - 1
    ends = [states[round(k * top / 4)] for k in (1, 2, 3, 4)]
    split = split_of(entry)
    told = [split["range"]] if split and split["low"] <= float(states.particle_velocity[-1]) else []
    return {"ahead": {"density": ahead.density, "pressure": ahead.pressure, "energy": ahead.energy}, "hugoniot": columns(states),
            "releases": [r for r in (_release(material, s) for s in ends) if r], "isentrope": _from_rest(material, ends[-1]),
            "notes": [*told, *about_law(material)],
            "sources": _other_sources(entry, float(states.particle_velocity[-1]))}


def _top(material, ahead: Initial, measured: list) -> float:
    """The highest particle velocity to draw, m/s: what the data reach, at least some, and no more than the law does."""
    data = max((float(np.quantile(m["up"], 0.95)) for m in measured), default=0.0)
    wanted = BEYOND * material.valid_up_to if material.valid_up_to else max(LEAST_TOP, data)
    return farthest(material, ahead, wanted)


def _reached(material, ahead: Initial, top: float) -> States:
    """States at round particle velocities up to `top`, or as far as the law goes."""
    for _ in range(12):
        step = round_step(top)
        try:
            return shock(material, ahead, particle_velocity=ahead.velocity + step * np.arange(math.floor(top / step * (1 + 1e-9)) + 1))
        except (OutOfRange, NoSolution):
            top *= 0.8
    raise NoSolution("no Hugoniot in the range of particle velocities that is drawn")


def _release(material, start: States) -> dict | None:
    if about_law(material):
        return None
    try:
        return columns(release(material, start, max(float(reference(material).pressure), 0.0), points=ALONG_A_RELEASE))
    except HugoniotError:
        return None


def _from_rest(material, end: States) -> dict | None:
    """The isentrope through the state at rest, up to the pressure of `end`."""
    start = reference(material)
    if about_law(material):
        return None
    try:
        return columns(isentrope(material, start, pressure=np.linspace(start.pressure, end.pressure, 2 * ALONG_A_RELEASE)))
    except HugoniotError:
        return None


def _other_sources(entry: Entry, top: float) -> list[dict]:
    """Hugoniots of the other rows of a curated material."""
    if not entry.curated or reacted(entry):
        return []
    try:
        found = house.comparison([entry], top)
    except HugoniotError:
        return []
    return [{"label": c.label, "source": c.source, "status": c.status, "up": _short(c.up), "us": _short(c.us), "p": _short(c.p)}
            for c in found.curves if not c.default]


def _products(entry: Entry) -> dict:
    """Detonation Hugoniot, CJ state and the isentrope through it."""
    material = entry.material
    point = cj(material)
    state = point.state
    ahead = point.initial
    fallen = expansion_to(material, state, 1e5, 2 * ALONG_A_RELEASE)
    return {"cj": {**state.table(*_MORE), "shock_velocity": point.detonation_velocity}, "isentrope": columns(fallen),
            "ahead": {"density": ahead.density, "pressure": ahead.pressure},
            "hugoniot": columns(detonation_hugoniot(material, ahead, points=61, up_to=1.6 * float(state.particle_velocity))),
            "stated": {key: s.value for key, s in entry.detonation.items() if key in ("velocity", "pressure")}}


def _pop(name: str) -> list[dict]:
    """Measured Pop plots: log10(p/GPa) = a + b log10(x/mm) between two pressures."""
    keys = ("a", "b", "a_deviation", "b_deviation", "pressure_low", "pressure_high", "rho0")
    return [{"row": row.id, "label": row.material, "source": row.source, "status": row.status, **{k: row.get(k) for k in keys}}
            for row in library.pop_lines(name)]


def _gurney(entry: Entry) -> dict | None:
    """The Gurney velocity the library states, and the velocity of metal over the ratio of its mass to that of the explosive."""
    stated = entry.detonation.get("gurney_velocity")
    if stated is None:
        return None
    ratios = np.geomspace(0.1, 10.0, 41)
    return {"value": float(stated.value), "source": stated.source, "status": stated.status, "ratio": _short(ratios),
            "velocity": {kind: _short([gurney(kind, float(m), float(stated.value)) for m in ratios])
                         for kind in ("cylinder", "sphere", "symmetric", "open")}}


def columns(states: States) -> dict[str, Any]:
    """Columns of states for drawing and for the pointer: what `hugoniot eos` prints, and the specific volume."""
    table = {key: _short(values) for key, values in states.table("entropy").items() if values is not None}
    return table | {"specific_volume": _short(1.0 / np.asarray(states.density))}


def _short(values) -> Any:
    """Twelve digits of every number: twice as many as are shown."""
    return [float(f"{v:.12g}") for v in np.atleast_1d(np.asarray(values, float)).tolist()]


# -- single states ---------------------------------------------------------------------------------------------------
BY = {"particle_velocity": "m/s", "pressure": "Pa", "shock_velocity": "m/s", "density": "kg/m^3"}


def state_of(name: str, by: str, value: float) -> dict[str, Any]:
    """All numbers of one state of the principal Hugoniot, where its Rayleigh line starts, the release from it, and `warnings`.

    Raises `OutOfRange` with the limit of the law, `DeckError` for an unknown name or field.
    """
    if by not in BY:
        raise OutOfRange(f"a state needs exactly one of {', '.join(BY)}")
    entry = entry_of(name)
    material = inert_or_none(entry)
    if material is None:
        raise OutOfRange(f"{name}: the library has only its detonation products, which have no principal Hugoniot")
    ahead = Initial.at_rest(material)
    found = shock(material, ahead, **{by: value})
    jump = float(found.particle_velocity)
    return {"state": found.table(*(("entropy",) if about_law(material) else _MORE)), "release": _release(material, found),
            "ahead": {"density": ahead.density, "pressure": ahead.pressure},
            "warnings": [*about_split(entry, jump), *about_jump(material, jump), *about_law(material)]}


def bands() -> dict[str, dict]:
    """Fits of measured states that the library recomputes: row -> coefficients with their covariance, and the range of the states."""
    from hugoniot.dossier import fits

    def shown(fit: UsUpFit) -> dict:
        return {"coefficients": list(fit.coefficients), "covariance": fit.covariance, "least": fit.least, "highest": fit.highest}

    return {identity: shown(fits.recorded(identity)) for identity in fits.RECORDED if schema.is_row(identity)}
