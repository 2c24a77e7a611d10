"""The rules every row and every material keeps, those of the library and a user's own alike.

A `Finding` says what was looked at, what came out and against which limit. `fail` is a broken rule: wrong units, a misprint, a missing
source. `mark` is a misfit the data themselves have: it is shown wherever the row is used (see `marks`), never hidden.
"""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from hugoniot.dossier import fits
from hugoniot.dossier.derived import closure, isentrope_of, material_hugoniot, shock_velocity
from hugoniot.errors import HugoniotError, NoSolution
from hugoniot.laws.eos.contract import EOS, pressure, reference_state, sound_speed_squared
from hugoniot.materials import cards, library, schema
from hugoniot.materials.entry import Entry, make_entry
from hugoniot.materials.marks import ENERGY_LIMIT, PRESSURE_LIMIT, REST_LIMIT, VELOCITY_LIMIT, unreacted_pressure
from hugoniot.materials.schema import Row
from hugoniot.theory.chapman_jouguet import cj, on_isentrope

MODULI_LIMIT = 0.10  # bulk modulus rho0 c0^2 against the elastic one
POINT_LIMIT = 0.02  # rho0 Us up of a measured state against the pressure its source reports
RECORDED_LIMIT = 5e-5  # CJ velocity and pressure recorded in a row, to five digits: its marks are read from them

# column -> (lowest, highest) plausible value: a slip of a unit is a factor of ten or a thousand
RANGES: dict[str, tuple[float, float]] = {
    "rho0": (20.0, 23000.0), "rho_solid": (80.0, 23000.0), "c0": (140.0, 12000.0), "s": (0.25, 8.0), "gamma0": (0.05, 4.0),
    "heat_capacity": (90.0, 4500.0), "shear_modulus": (3e8, 3e11), "yield_stress": (1e6, 1.2e10), "largest_yield_stress": (1e6, 1.2e10),
    "pressure_coefficient": (0.0, 2e-10), "temperature_coefficient": (0.0, 5e-3), "melt_temperature": (250.0, 5000.0),
    "johnson_cook_yield": (1e7, 2e9), "johnson_cook_hardening": (1e7, 6e10), "johnson_cook_exponent": (0.05, 1.5),
    "johnson_cook_rate": (0.0, 0.2), "johnson_cook_thermal": (0.3, 2.0), "bulk_modulus": (1e9, 5e11), "spall_strength": (1e6, 1e10),
    "elastic_limit": (1e7, 2e10), "a": (-1e16, 1e16), "r1": (3.0, 60.0), "r2": (0.1, 10.0), "omega": (0.1, 1.5),
    "detonation_velocity": (2000.0, 10000.0), "cj_pressure": (1e9, 5e10), "e_incipient": (1e5, 2e7), "e_complete": (1e6, 3e7),
    "bulk_a": (1e9, 5e11), "bulk_b": (-1e11, 5e11), "gurney_velocity": (1500.0, 3300.0), "growth1": (0.0, 1e-4),
    "up_max": (200.0, 50000.0), "us_deviation": (1.0, 2000.0),
    "bulk_modulus_slope": (1.5, 12.0), "expansivity": (1e-6, 3e-4), "debye_temperature": (100.0, 2500.0), "gamma_exponent": (-1.0, 8.0),
    "molar_mass": (1e-3, 20.0), "wavelength": (2e-7, 1e-5), "index": (1.0, 2.5), "velocity_factor": (0.4, 1.1),
    "detonation.velocity": (2000.0, 10000.0), "detonation.pressure": (1e9, 5e10),
}


class Finding(NamedTuple):
    """where: row or material; check; verdict ok, mark or fail; value and limit (nan where words say more); text."""

    where: str
    check: str
    verdict: str
    value: float = math.nan
    limit: float = math.nan
    text: str = ""


def check_all() -> list[Finding]:
    """Every rule on every row, every measured state and every curated material of the library."""
    found = [f for row in schema.all_rows() for f in check_row(row)]
    found += [f for k, point in enumerate(schema.points()) for f in check_point(k, point)]
    found += [f for identity in fits.RECORDED for f in check_fit(identity)]
    with_states = {row.id for row in schema.table("us_up").values() if "states" in row or fits.belonging(row.id)}
    found += [f for identity in sorted(with_states) for f in check_states(identity)]
    for entry in library.find_all():
        found += check_entry(entry)
    return found


def _judge(where: str, check: str, misfit: float, limit: float, text: str = "", otherwise: str = "fail") -> Finding:
    return Finding(where, check, "ok" if abs(misfit) <= limit else otherwise, misfit, limit, text)


# -- rows --------------------------------------------------------------------------------------------------------
def check_row(row: Row) -> Iterator[Finding]:
    """Provenance, ranges, and the rules of the row's table; the row's own doubts come as marks."""
    ok = bool(row.source and row.via) and row.status in schema.STATUSES and (row.status == "recalled") == row.via.startswith("recalled")
    yield Finding(row.id, "provenance", "ok" if ok else "fail", text=f"{row.status}; {row.source}; {row.via}")
    for name, value in row.values.items():
        if name in RANGES and not isinstance(value, str):
            yield from _in_range(row.id, name, value, bool(row.marks))
    for mark in row.marks:
        yield Finding(row.id, "caveat of the row", "mark", text=mark)
    rules = {"us_up": _us_up, "strength": _strength, "jwl": _jwl, "jwlb": _jwlb, "ignition_growth": _ignition_growth,
             "tillotson": _tillotson, "porous": _porous, "gases": _gas, "compression": _compression}
    if row.table in rules:
        yield from rules[row.table](row)


def _in_range(where: str, name: str, value: float, doubted: bool = False) -> Iterator[Finding]:
    low, high = RANGES[name]
    if name == "a" or value == 0.0 and low > 0.0 and name in ("yield_stress",):
        return
    inside = low <= value <= high
    text = "" if inside else f"{name} = {value:g} is outside the plausible range, {low:g} to {high:g} in SI units"
    yield Finding(where, f"range of {name}", "ok" if inside else ("mark" if doubted else "fail"), value, math.nan, text)


def _us_up(row: Row) -> Iterator[Finding]:
    top = row.get("up_max") or 2000.0
    low = row.get("up_min") or 0.0
    speeds = []
    for k in range(1, 21):
        up = low + (top - low) * k / 20.0
        try:
            speeds.append((up, shock_velocity(row, up)))
        except NoSolution as error:
            yield Finding(row.id, "branch", "mark", up, math.nan, str(error))
            break
    slowest = min((us / up for up, us in speeds), default=math.inf)
    yield Finding(row.id, "shock velocity above particle velocity", "ok" if slowest > 1.0 else "fail", slowest, 1.0)
    products = [up * us for up, us in speeds]
    rising = all(b > a for a, b in zip(products, products[1:]))
    yield Finding(row.id, "pressure rises with particle velocity", "ok" if rising else "fail")
    try:
        law = cards.card(row)
    except ValueError as error:
        yield Finding(row.id, "law", "mark", text=str(error))
        return
    entry = make_entry(row.id, {"eos": {"row": row.id}}, f"row {row.id}")
    yield from _at_rest(row.id, entry.material.eos)
    worst = max((_rankine_hugoniot(entry.material.eos, law["rho0"].value, up, us) for up, us in speeds), default=0.0)
    yield _judge(row.id, "Rankine-Hugoniot", worst, 1e-9, "pressure of the law on the row's own Hugoniot against rho0 Us up")


def _rankine_hugoniot(par: Any, rho0: float, up: float, us: float) -> float:
    p = float(pressure(rho0 / (1.0 - up / us), 0.5 * up * up, par))
    return abs(p / (rho0 * us * up) - 1.0)


def _at_rest(where: str, par: Any) -> Iterator[Finding]:
    rho, e = reference_state(par)
    modulus = float(rho * sound_speed_squared(rho, e, par))
    p = float(pressure(rho, e, par))
    yield _judge(where, "zero pressure in the reference state", p / modulus, 1e-12, f"{p:g} Pa at {rho:g} kg/m^3")


def _strength(row: Row) -> Iterator[Finding]:
    if "largest_yield_stress" in row:
        ratio = row["yield_stress"] / row["largest_yield_stress"]
        yield Finding(row.id, "Y0 not above Ymax", "ok" if ratio <= 1.0 else "fail", ratio, 1.0)
    if row["model"] == "SG" and "pressure_coefficient" in row:
        hardening = row["pressure_coefficient"] * row["shear_modulus"]
        verdict = "ok" if hardening <= 3.5 else "mark"
        yield Finding(row.id, "dG/dp", verdict, hardening, 3.5, "" if verdict == "ok" else "dG/dp is unusually large")
    if "bulk_modulus" in row and "shear_modulus" in row:
        k, g = row["bulk_modulus"], row["shear_modulus"]
        poisson = (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g))
        inside = 0.0 < poisson < 0.5
        yield Finding(row.id, "Poisson's ratio", "ok" if inside else "mark", poisson, 0.5, "" if inside else f"nu = {poisson:.3f}")


def _jwl(row: Row) -> Iterator[Finding]:
    if row["role"] == "unreacted":
        p = unreacted_pressure(row.id)
        yield _judge(row.id, "constants of an unreacted JWL at rest", p, REST_LIMIT, f"{p / 1e6:.2f} MPa at V = 1, 298 K", "mark")
        yield from _at_rest(row.id, make_entry(row.id, {"eos": {"row": row.id}}, f"row {row.id}").material.eos)
        return
    state = closure(row.id)
    if state is None:
        yield Finding(row.id, "CJ closure", "mark", text="no energy E0: CJ state not checked, not usable as products")
        return
    for name, misfit, limit in (("D", state.velocity_misfit, VELOCITY_LIMIT), ("p", state.pressure_misfit, PRESSURE_LIMIT)):
        if math.isnan(misfit):
            yield Finding(row.id, f"CJ closure of {name}", "mark", text=f"the row states no {name} to compare the CJ state with")
        else:
            yield _judge(row.id, f"CJ closure of {name}", misfit, limit, f"{100 * misfit:+.2f} % from the stated value", "mark")
    for name, mine in (("recorded_d", state.velocity), ("recorded_p", state.pressure)):
        yield _judge(row.id, f"CJ state as {name}", mine / row.get(name, math.inf) - 1.0, RECORDED_LIMIT)
    if "e0_from_isentrope" in row:
        energy = on_isentrope(isentrope_of(row), row["rho0"]).energy
        yield _judge(row.id, "E0 from tangency", energy / row["e0_from_isentrope"] - 1.0, 1e-3)


def _jwlb(row: Row) -> Iterator[Finding]:
    energy, velocity, p, _ = on_isentrope(isentrope_of(row), row["rho0"])
    misfit = energy / row["e0"] - 1.0
    text = f"E0 from tangency deviates by {100 * misfit:+.2f} % from the stated value; D = {velocity:.0f} m/s, p = {p / 1e9:.1f} GPa"
    yield _judge(row.id, "E0 from tangency", misfit, ENERGY_LIMIT, text, "mark")


def _ignition_growth(row: Row) -> Iterator[Finding]:
    if "unreacted_a" in row:
        p = unreacted_pressure(row.id)
        yield _judge(row.id, "constants of an unreacted JWL at rest", p, REST_LIMIT, f"{p / 1e6:.2f} MPa at V = 1, 298 K", "mark")
    positive = all(row.get(n, 0.0) >= 0.0 for n in ("ignition_rate", "growth1", "growth2"))
    yield Finding(row.id, "rates not negative", "ok" if positive else "fail")


def _tillotson(row: Row) -> Iterator[Finding]:
    ordered = row["e_complete"] > row["e_incipient"]
    yield Finding(row.id, "vaporisation energies in order", "ok" if ordered else "fail", row["e_complete"] / row["e_incipient"], 1.0)
    speed = math.sqrt(row["bulk_a"] / row["rho0"])
    inside = 1000.0 < speed < 10000.0
    yield Finding(row.id, "sqrt(A/rho0)", "ok" if inside else "mark", speed, math.nan)
    yield from _at_rest(row.id, make_entry(row.id, {"eos": {"row": row.id}}, f"row {row.id}").material.eos)


def _porous(row: Row) -> Iterator[Finding]:
    yield Finding(row.id, "distension above 1", "ok" if row["alpha0"] > 1.0 else "fail", row["alpha0"], 1.0)


def _compression(row: Row) -> Iterator[Finding]:
    """At rest without pressure, with sound of a credible speed, a credible Gamma, and a shock faster than its particles to 1 km/s."""
    entry = make_entry(row.id, {"eos": {"row": row.id}}, f"row {row.id}")
    par = entry.material.eos
    yield from _at_rest(row.id, par)
    for name, value, low, high in (("sound speed", math.sqrt(par.bulk_modulus / par.rho0), 1000.0, 12500.0),
                                   ("Gamma", par.gamma0, 0.05, 4.0), ("K_S/K_T", par.bulk_modulus / row["bulk_modulus"], 1.0, 1.12)):
        yield Finding(row.id, name, "ok" if low <= value <= high else ("mark" if row.marks else "fail"), value, math.nan)
    slowest = min(material_hugoniot(entry.material, up) / up for up in (250.0, 500.0, 1000.0))
    yield Finding(row.id, "shock velocity above particle velocity", "ok" if slowest > 1.0 else "fail", slowest, 1.0)


def _gas(row: Row) -> Iterator[Finding]:
    par = make_entry(row.id, {"eos": {"row": row.id}}, f"row {row.id}").material.eos
    p = float(pressure(*reference_state(par), par))
    yield _judge(row.id, "pressure in the reference state", p / row["pressure"] - 1.0, 1e-12, f"{p:g} Pa")


# -- measured states and fits ------------------------------------------------------------------------------------
def check_point(k: int, point: Row) -> Iterator[Finding]:
    """A measured state: shock velocity above particle velocity, and the pressure its source reports."""
    where = f"us_up_points, state {k + 1} ({point.material})"
    ok = bool(point.source and point.via) and point.status in schema.STATUSES
    yield Finding(where, "provenance", "ok" if ok else "fail", text=f"{point.status}; {point.source}; {point.via}")
    up, us = point["up"], point["us"]
    yield Finding(where, "shock velocity above particle velocity", "ok" if us > up else "fail", us, up)
    if point.get("pressure"):
        misfit = point["rho0"] * us * up / point["pressure"] - 1.0
        text = f"{100 * misfit:+.2f} % from the pressure reported"
        yield _judge(where, "pressure = rho0 Us up", misfit, POINT_LIMIT, text, "mark")


def check_fit(identity: str) -> Iterator[Finding]:
    """A recorded fit against the same fit recomputed from the measured states, to the digits recorded."""
    row, mine = schema.row(identity), fits.recorded(identity)
    recorded = [row["c0"], row["s"], row.get("quadratic"), row["c0_deviation"], row["s_deviation"]]
    again = [*mine.coefficients[:2], mine.coefficients[2] if len(mine.coefficients) > 2 else None, *mine.deviations[:2]]
    worst = max(abs(a / r - 1.0) for a, r in zip(again, recorded, strict=True) if r is not None)
    yield _judge(identity, "fit recomputed", worst, 2e-5, f"{len(mine.points)} states, residual {mine.deviation:.0f} m/s")


def check_states(identity: str) -> Iterator[Finding]:
    """Range and deviation of the measured states about a row's line, recomputed against those recorded."""
    row = schema.row(identity)
    mine = fits.scatter(row)
    if mine is None or "states" not in row:
        yield Finding(identity, "measured states", "fail", text="measured states are assigned to the row or recorded in it, but not both")
        return
    recorded = (row["up_min"], row["up_max"], row["us_deviation"], row["states"])
    worst = max(abs(a / r - 1.0) for a, r in zip(mine, recorded))
    yield _judge(identity, "measured states recomputed", worst, 2e-3, f"{mine.count} states, {mine.deviation:.1f} m/s about the line")


# -- materials ---------------------------------------------------------------------------------------------------
def check_entry(entry: Entry) -> Iterator[Finding]:
    """The rules for a whole material, from the library or from a user's file."""
    name, material = entry.name, entry.material
    law = EOS.of(material.eos)
    for source in material.sources:
        stated = source.source not in ("", "not stated")
        if not stated or entry.curated and source.status == "user" and entry.category != "user":
            yield Finding(name, "source", "mark" if entry.category == "user" else "fail", text=f"{source.quantity}: no source stated")
        column = source.quantity if source.quantity in RANGES else source.quantity.split(".")[-1]
        if column == "rho0" and "gas" in law.flags and "reacted" not in law.flags:
            continue
        if column in RANGES and isinstance(source.value, (int, float)) and not source.quantity.startswith("detonation."):
            yield from _in_range(name, column, source.value, "DOUBT" in source.note)
    for warning in material.warnings:
        yield Finding(name, "warning", "mark", text=warning)
    try:
        if "reacted" in law.flags:
            yield from _detonation(entry)
        elif "gas" not in law.flags:
            yield from _at_rest(name, material.eos)
            yield from _hugoniot(entry)
            yield from _moduli(entry)
    except HugoniotError as error:
        yield Finding(name, "physics", "fail", text=str(error))


def _hugoniot(entry: Entry) -> Iterator[Finding]:
    top = entry.material.valid_up_to or 2000.0
    speeds = [(top * k / 8.0, material_hugoniot(entry.material, top * k / 8.0)) for k in range(1, 9)]
    slowest = min(us / up for up, us in speeds)
    yield Finding(entry.name, "shock velocity above particle velocity", "ok" if slowest > 1.0 else "fail", slowest, 1.0)
    par = entry.material.eos
    for row in (schema.row(i) for i in entry.rows[:1] if i.startswith("U")):
        if (getattr(par, "c0", None), par.rho0) != (row["c0"], row.get("rho0")):
            continue  # a user's file that takes only some constants from the row
        low = row.get("up_min") or 0.0
        worst = max((abs(us / shock_velocity(row, up) - 1.0) for up, us in speeds if up >= low), default=0.0)
        yield _judge(entry.name, f"Hugoniot of {row.id} recovered", worst, 1e-9)


def _moduli(entry: Entry) -> Iterator[Finding]:
    rho, e = reference_state(entry.material.eos)
    bulk = float(rho * sound_speed_squared(rho, e, entry.material.eos))
    rows = dict.fromkeys((*entry.rows, *(i for ids in entry.others.values() for i in ids)))
    for row in (schema.row(i) for i in rows if i.startswith("S")):
        if "bulk_modulus" in row:
            misfit = bulk / row["bulk_modulus"] - 1.0
            text = f"rho0 c0^2 = {bulk / 1e9:.1f} GPa, elastic K = {row['bulk_modulus'] / 1e9:.1f} GPa"
            yield _judge(entry.name, f"c0 against moduli of {row.id}", misfit, MODULI_LIMIT, text, "mark")


def _detonation(entry: Entry) -> Iterator[Finding]:
    point = cj(entry.material.eos)
    for key, mine, limit in (("velocity", point.detonation_velocity, VELOCITY_LIMIT), ("pressure", point.state.pressure, PRESSURE_LIMIT)):
        if key in entry.detonation:
            misfit = mine / float(entry.detonation[key].value) - 1.0
            text = f"{100 * misfit:+.2f} % from the stated value"
            yield _judge(entry.name, f"CJ {key} against the stated value", misfit, limit, text, "mark")
    if entry.unreacted is not None:
        yield from _at_rest(entry.name, entry.unreacted)


def tally(findings: list[Finding]) -> dict[str, int]:
    """Number of findings by verdict."""
    return {verdict: sum(f.verdict == verdict for f in findings) for verdict in ("ok", "mark", "fail")}

