"""What the commands of `hugoniot eos` print and write: tables for people, SI numbers as JSON and CSV, pictures."""

import csv
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import typer

from hugoniot.cli.show import echo_json, echo_table
from hugoniot.errors import FileTrouble
from hugoniot.materials.validity import about_shock
from hugoniot.theory.states import UNITS, States
from hugoniot.units import format_si

# field word -> (unit for people, factor, format)
SHOWN = {"pressure": ("GPa", 1e-9, "10.5g"), "density": ("kg/m3", 1.0, "9.2f"), "particle_velocity": ("m/s", 1.0, "9.2f"),
         "shock_velocity": ("m/s", 1.0, "9.2f"), "specific_internal_energy": ("kJ/kg", 1e-3, "10.5g"), "temperature": ("K", 1.0, "8.1f"),
         "sound_speed": ("m/s", 1.0, "9.2f"), "entropy": ("J/kg/K", 1.0, "9.3f"), "adiabatic_exponent": ("", 1.0, "8.4f"),
         "gruneisen": ("", 1.0, "8.4f"), "detonation_velocity": ("m/s", 1.0, "9.2f"), "chapman_jouguet_velocity": ("m/s", 1.0, "9.2f"),
         "burn_fraction": ("", 1.0, "8.5f"), "reaction": ("", 1.0, "9.6f"), "volume_fraction": ("", 1.0, "8.5f"),
         "overdrive": ("", 1.0, "8.5g"), "adjusted_gruneisen": ("", 1.0, "8.4f"),
         "position": ("um", 1e6, "10.5g"), "time": ("ns", 1e9, "10.5g"), "reaction_rate": ("1/us", 1e-6, "10.5g"),
         "thermicity": ("1/us", 1e-6, "10.5g"), "specific_heat": ("J/kg/K", 1.0, "9.2f"), "reactant_density": ("kg/m3", 1.0, "9.2f"),
         "product_density": ("kg/m3", 1.0, "9.2f"), "reactant_energy": ("kJ/kg", 1e-3, "10.5g"), "product_energy": ("kJ/kg", 1e-3, "10.5g"),
         "half_reaction_length": ("um", 1e6, "10.5g"), "reaction_zone_length": ("um", 1e6, "10.5g"),
         "half_reaction_time": ("ns", 1e9, "10.5g")}
SHOWN |= dict.fromkeys(("principal_pressure", "principal_series", "second_pressure", "second_series", "difference", "leading_difference",
                        "stress", "truncated_pressure", "adjusted_pressure", "rayleigh_pressure", "fanno_pressure",
                        "hugoniot_pressure"), ("GPa", 1e-9, "10.6g"))
WORDS = {"specific_internal_energy": "internal energy", "gruneisen": "Grüneisen parameter",
         "adjusted_gruneisen": "adjusted Grüneisen parameter"}


def words(name: str) -> str:
    """A field word for people."""
    return WORDS.get(name, name.replace("_", " "))


def row_of(table: dict) -> dict[str, Any]:
    """Values ready for JSON: numbers, lists of numbers, None where a law has no such field (or gives no number)."""
    return {k: plain(v) for k, v in table.items()}


def plain(value):
    """A number or array as JSON holds it; None for NaN throughout."""
    if value is None:
        return None
    if np.ndim(value):
        values = [plain(v) for v in np.asarray(value).tolist()]
        return None if values and all(v is None for v in values) else values
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def echo_states(states: States, *more: str) -> None:
    """Print one state as lines, many as a table of about 25 rows."""
    echo_columns(states.table(*more))


def echo_columns(given: dict) -> None:
    """Print fields by word: numbers as lines, arrays as a table of about 25 rows."""
    table = row_of(given)
    if np.ndim(next(v for v in given.values() if v is not None)) == 0:
        echo_table(["", ""], [(words(k), cell(k, v)) for k, v in table.items() if v is not None])
        return
    count = max(len(v) for v in table.values() if v is not None)
    chosen = sorted({int(round(i)) for i in np.linspace(0, count - 1, min(count, 25))})
    columns = [k for k, v in table.items() if v is not None]
    shown = {k: _unit_of(k, table[k]) for k in columns}
    heads = [f"{words(k)}{', ' + shown[k][0] if shown[k][0] else ''}" for k in columns]
    echo_table(heads, [[_number(table[k][i], *shown[k][1:]) for k in columns] for i in chosen])
    if count > len(chosen):
        typer.echo(f"{len(chosen)} of {count} states shown; --csv and --json give all")


def _unit_of(name: str, values) -> tuple[str, float, str]:
    """(unit, factor, format) of a column; pressures of gases in MPa or kPa."""
    shown, factor, form = SHOWN.get(name, (UNITS.get(name, ""), 1.0, ".6g"))
    top = max((abs(v) for v in values if v is not None), default=0.0)
    if shown == "GPa" and 0.0 < top < 1e8:
        shown, factor = ("MPa", 1e-6) if top >= 1e6 else ("kPa", 1e-3)
    return "" if shown == "1" else shown, factor, form


def _number(value, factor: float, form: str) -> str:
    return "-" if value is None else f"{value * factor:{form}}".strip()


def cell(name: str, value, unit: bool = True) -> str:
    """A value in the unit people use."""
    if value is None:
        return "-"
    if unit and UNITS.get(name) in ("Pa", "J/kg"):
        return format_si(float(value), UNITS[name], 5)
    shown, factor, form = SHOWN.get(name, (UNITS.get(name, ""), 1.0, ".6g"))
    return (f"{value * factor:{form}}".strip() + (f" {shown}" if unit else "")).strip()


def notes(subject, jump: float = 0.0) -> list[str]:
    """`materials.ranges.about_shock` of the material of a command."""
    return about_shock(subject.material, jump)


def echo_notes(found: Sequence[str]) -> None:
    """Each note once, on the error stream."""
    for text in dict.fromkeys(found):
        typer.echo(f"note: {text}", err=True)


def write_csv(path: Path, tables: Sequence[tuple[str, dict]]) -> None:
    """SI numbers with the units in the header, `pressure (Pa)`; a column `material` if there are several tables."""
    several = len(tables) > 1
    names = list(dict.fromkeys(k for _, table in tables for k, v in table.items() if plain(v) is not None))
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file)
            units = [UNITS.get(n.removesuffix("_sigma"), "1") for n in names]
            heads = [n if unit == "1" else f"{n} ({unit})" for n, unit in zip(names, units)]
            out.writerow([*(["material"] if several else []), *heads])
            for title, table in tables:
                columns = [np.atleast_1d(np.asarray(table[n], float)) if table.get(n) is not None else None for n in names]
                count = max(c.size for c in columns if c is not None)
                for i in range(count):
                    cells = ["" if c is None or not math.isfinite(c[i]) else repr(float(c[i])) for c in columns]
                    out.writerow([*([title] if several else []), *cells])
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None


def deliver(tables: Sequence[tuple[str, dict]], *, as_json: bool, as_csv: Path | None,
            told: Sequence[Sequence[str]] = (), more: Sequence[dict] = ()) -> bool:
    """Write the CSV file and print JSON where asked, with the notes `told` about each table as its `warnings`.

    more   further facts of each table for JSON.

    Tells whether the table for people is still wanted.
    """
    if as_csv:
        write_csv(as_csv, tables)
    if as_json:
        rows = [{"material": title, **facts, **row_of(table), "warnings": list(said)}
                for (title, table), said, facts in zip(tables, told or [()] * len(tables), more or [{}] * len(tables), strict=True)]
        echo_json(rows[0] if len(rows) == 1 else {"materials": rows})
    return not as_json
