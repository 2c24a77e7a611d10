"""hugoniot pop-plot: run distance to detonation over input pressure, from runs of a reactive explosive."""

import csv
import math
import re
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, MATERIALS, echo_json, echo_table
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, FileTrouble, OutOfRange

COLUMNS = {"pressure": "Pa", "piston_velocity": "m/s", "shock_velocity": "m/s", "distance": "m", "time": "s"}


def command(
    material: Annotated[str, typer.Argument(help='Explosive with a reaction rate: a name such as "LX-17 reactive", a row of the '
        'library (G014), or a TOML file.')],
    pressures: Annotated[str, typer.Option("--pressures", "-p", help='Input pressures: a range, "3..15 GPa", or values, "8, 11, 15 '
        'GPa".')] = "3..15 GPa",
    points: Annotated[int, typer.Option("--points", min=2, max=200, help="Number of runs in a range, spaced logarithmically in "
        "pressure.")] = 6,
    zone_size: Annotated[str, typer.Option("--zone-size", help="Width of the zones.")] = "20 um",
    longest: Annotated[str, typer.Option("--longest", help="Length of the longest charge that is tried.")] = "60 mm",
    closure: Annotated[str, typer.Option("--closure", help="How reactants and products share a zone, instead of the choice of the "
        "material (hugoniot list mixture).")] = "",
    published: Annotated[str, typer.Option("--published", help="Explosive of the library whose measured line is the comparison "
        "(default: MATERIAL).")] = "",
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=256, help="Number of runs at the same time.")] = 1,
    materials: MATERIALS = None, as_json: JSON = False,
    as_csv: Annotated[Path | None, typer.Option("--csv", help="Write the numbers, in SI, to this file.")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw the picture into this file (.png, .pdf, .svg).")] = None,
) -> None:
    """Compute the Pop plot of an explosive: run distance and time to detonation against input pressure.

    Each point is a simulation in which a piston drives a shock into the explosive. A line is fitted to the points and compared with the
    measured one.

    Example: hugoniot pop-plot "LX-17 reactive" --pressures "10..15 GPa" --points 4 --plot pop.png
    """
    from dataclasses import replace

    from hugoniot.campaign.pop_plot import pop_plot
    from hugoniot.materials import library

    chosen = material_named(material, materials)
    if closure:
        chosen = replace(chosen, mixture=_closure(closure))
    wanted = pressure_list(pressures, points)
    size, most = _quantity(zone_size, "m", "--zone-size"), _quantity(longest, "m", "--longest")
    lines = library.pop_lines(published or chosen.library)
    if published and not lines:
        raise DeckError.single("command line", None, "--published", f"the library has no measured Pop plot of '{published[:60]}'",
                               f"it has: {', '.join(row.material for row in library.schema.table('pop_plot').values())}")
    try:
        found = pop_plot(chosen, wanted, size, most, workers)
    except OutOfRange as error:
        message, _, hint = str(error).partition("; ")
        raise DeckError.single("command line", None, "pop-plot", message, hint) from None
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.initiation import pop_picture
        save(pop_picture(found, lines), plot)
    if as_csv:
        _write_csv(as_csv, found, lines)
    if as_json:
        echo_json(_record(found, lines))
        return
    _tell(found, lines)


# -- input -----------------------------------------------------------------------------------------------------------
def material_named(name: str, places):
    if places:
        from hugoniot.materials.users import find, user_materials
        return find(name, user_materials(places)).material
    from hugoniot.cli.eos.input import find_material
    return find_material(name).material


def _closure(name: str) -> str:
    from hugoniot.core.registry import UnknownName
    from hugoniot.materials.burning import MIXTURE
    try:
        return MIXTURE.get(name).name
    except UnknownName as error:
        message, _, hint = str(error).partition("; ")
        raise DeckError.single("command line", None, "--closure", message, hint) from None


def _quantity(text: str, unit: str, option: str) -> float:
    from hugoniot.cli.show import quantity
    value = quantity(text, unit, option)
    if not value > 0.0:
        raise DeckError.single("command line", None, option, f"{text} is not positive")
    return value


def pressure_list(text: str, points: int) -> list[float]:
    """Pa, from "3..15 GPa" (points at equal ratios) or "8, 11, 15 GPa": the last unit holds for the numbers without one."""
    unit = re.search(r"[A-Za-z]+\s*$", text)
    parts = [part.strip() for part in (text.split("..") if ".." in text else text.split(","))]
    given = [part if re.search(r"[A-Za-z]\s*$", part) or unit is None else f"{part} {unit.group(0)}" for part in parts]
    values = [_quantity(part, "Pa", "--pressures") for part in given]
    if ".." not in text:
        refuse_idle("on pressures that are listed", "--points")
        return values
    if len(values) != 2 or not values[0] < values[1]:
        raise DeckError.single("command line", None, "--pressures", f"'{text[:40]}' is not a range", 'write "3..15 GPa", lower one first')
    low, high = values
    return [low * (high / low) ** (k / (points - 1)) for k in range(points)]


# -- output ----------------------------------------------------------------------------------------------------------
def _record(found, lines) -> dict:
    return {
        "material": found.material, "detonation_velocity": found.detonation_velocity, "zone_size": found.zone_size,
        "points": [{name: getattr(p, name) for name in COLUMNS} | {"zones": p.zones, "note": p.note} for p in found.points],
        "line": {name: getattr(found.line, name) for name in ("a", "b", "deviation")} if found.line else None,
        "published": [{"row": row.id, "material": row.material, "density": row["rho0"], "a": row["a"], "b": row["b"],
                       "pressure_low": row["pressure_low"], "pressure_high": row["pressure_high"], "source": row.source,
                       "status": row.status, "distance_ratios": [_ratio(p, row) for p in found.points]} for row in lines]}


def _ratio(point, row) -> float:
    """Run distance over that of a measured line; not-a-number outside the line's pressures."""
    from hugoniot.diagnostics.detonation import PopLine

    if not row["pressure_low"] * (1.0 - 1e-9) <= point.pressure <= row["pressure_high"] * (1.0 + 1e-9):
        return math.nan
    return point.distance / float(PopLine(row["a"], row["b"]).distance(point.pressure))


def _write_csv(path: Path, found, lines) -> None:
    heads = [f"{name} ({unit})" for name, unit in COLUMNS.items()] + [f"distance over {row.id}" for row in lines] + ["note"]
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file)
            out.writerow(heads)
            for p in found.points:
                numbers = [getattr(p, name) for name in COLUMNS] + [_ratio(p, row) for row in lines]
                out.writerow([*("" if math.isnan(v) else repr(float(v)) for v in numbers), p.note])
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None


def _tell(found, lines) -> None:
    typer.echo(f"{found.material}: detonation velocity {found.detonation_velocity:.0f} m/s (Chapman-Jouguet), "
               f"zones of {found.zone_size * 1e6:.4g} um")
    rows = []
    for p in found.points:
        cells = [f"{p.pressure * 1e-9:.4g}", f"{p.piston_velocity:.0f}", "-" if math.isnan(p.distance) else f"{p.distance * 1e3:.4g}",
                 "-" if math.isnan(p.time) else f"{p.time * 1e6:.4g}"]
        rows.append([*cells, *("-" if math.isnan(r := _ratio(p, row)) else f"{r:.3f}" for row in lines)])
    echo_table(["pressure, GPa", "piston, m/s", "run distance, mm", "time, us", *(f"ratio to {row.id}" for row in lines)], rows)
    if found.line:
        line = found.line
        told = f"log10(p/GPa) = {line.a:.4f} {line.b:+.4f} log10(x/mm)"
        if not math.isnan(line.deviation):
            count = sum(1 for p in found.points if math.isfinite(p.distance))
            told += (f"; the {count} runs scatter about this line by {line.deviation:.2g} in log10 p, which says nothing about the "
                     "error of the mesh")
        typer.echo(told)
    for row in lines:
        doubt = "; not checked against the printed source" if row.status == "recalled" else ""
        typer.echo(f"{row.id} {row.material}, {row['rho0']:g} kg/m3: log10(p/GPa) = {row['a']:g} {row['b']:+g} log10(x/mm), "
                   f"{row['pressure_low'] * 1e-9:g} to {row['pressure_high'] * 1e-9:g} GPa ({row.source}{doubt})")
    for p in found.points:
        if p.note:
            typer.echo(f"note: {p.pressure * 1e-9:.4g} GPa: {p.note}", err=True)
