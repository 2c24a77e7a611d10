"""hugoniot fit-rate: constants of a burn law calibrated to a measured Pop plot."""

import math
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, MATERIALS, echo_json, echo_table
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, OutOfRange


def command(
    material: Annotated[str, typer.Argument(help='Explosive to start from: a name such as "PBX-9404 reactive", a row of the library '
        '(G014), or a TOML file.')],
    to: Annotated[str, typer.Option("--to", help="Explosive of the library whose measured line is fitted, or the id of a line, such "
        "as R001 (default: MATERIAL).")] = "",
    line: Annotated[str, typer.Option("--line", help='Line to fit instead of a measured one: "a, b" of log10(p/GPa) = a + b '
        'log10(x/mm), with run distance x.')] = "",
    adjust: Annotated[str, typer.Option("--adjust", help="Constants of the burn law to fit.")] = "g1, y",
    start: Annotated[str, typer.Option("--start", help='Constants to set before the search, in SI, such as "y = 2.5, g1 = 8e-19, g2 '
        '= 0".')] = "",
    pressures: Annotated[str, typer.Option("--pressures", "-p", help='Input pressures: a range, "3..15 GPa", or values, "8, 11, 15 '
        'GPa".')] = "3..15 GPa",
    points: Annotated[int, typer.Option("--points", min=2, max=50, help="Number of runs in a range, spaced logarithmically in "
        "pressure.")] = 5,
    zones: Annotated[int, typer.Option("--zones", min=50, max=5000, help="Number of zones per run distance during the search.")] = 200,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=256, help="Number of runs at the same time.")] = 1,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Folder to write fit.json, residuals.csv and report.html to "
        "(default: none).")] = None,
    materials: MATERIALS = None, as_json: JSON = False,
) -> None:
    """Fit a few constants of a burn law to a measured Pop plot.

    All other constants and both equations of state are kept. The search, its standard deviations, intervals and notes are those of
    hugoniot fit. At the end every run is repeated with zones of half the width, and the table of the burn law is printed for a deck. The
    command takes a few minutes.

    Example: hugoniot fit-rate "PBX-9502 reactive" --adjust "g2, z" --pressures "10..15 GPa"
    """
    from hugoniot.campaign.fit_files import claimed, fit_record, write_fit
    from hugoniot.campaign.rate_fit import as_fitted, fit_rate
    from hugoniot.cli.pop_plot import material_named, pressure_list

    if line:
        refuse_idle("with --line", "--to")
    chosen = _started(material_named(material, materials), start)
    wanted, described, span = _line(to or material, line)
    folder = None if out is None else claimed(out)
    names = [name.strip() for name in adjust.split(",") if name.strip()]
    try:
        found = fit_rate(chosen, wanted, pressure_list(pressures, points), names, zones, workers)
        told = _told(found, span)
    except OutOfRange as error:
        message, _, hint = str(error).partition("; ")
        raise DeckError.single("command line", None, "fit-rate", message, hint) from None
    if folder is not None:
        write_fit(folder, as_fitted(found, _toml(found, material), [f"calibrated to {described}", *told], folder), material)
    if as_json:
        echo_json({"material": chosen.name, "line": described, "before": found.before, "after": found.after, "zones": found.zones,
                   "runs": found.runs, "burn": _table(found.material.burn), "fit": fit_record(found.fit), "notes": told, "points": [
                       {"pressure": p.pressure, "distance": p.distance, "ratio": coarse, "refined_ratio": fine, "note": p.note}
                       for p, coarse, fine in zip(found.points, found.ratios, found.refined)]})
        return
    _print_found(found, described, material, told)


# -- input -----------------------------------------------------------------------------------------------------------
def _started(material, text: str):
    """The material with the constants of --start."""
    from dataclasses import replace

    from hugoniot.laws.burn.contract import BURN
    given = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not name and not equals:
            continue
        try:
            given[name] = float(value)
        except ValueError:
            raise DeckError.single("command line", None, "--start", f"'{part.strip()[:40]}' is not of the form NAME = NUMBER",
                                   'write "y = 2.5, g1 = 8e-19"') from None
    if not given:
        return material
    if material.burn is None:
        raise DeckError.single("command line", None, "--start", f"material '{material.name}' has no burn law",
                               "omit --start, or name an explosive with a rate")
    law = BURN.of(material.burn)
    strange = [name for name in given if name not in law.parameters._fields]
    if strange:
        raise DeckError.single("command line", None, "--start", f"the burn law {law.name} has no constant '{strange[0]}'",
                               f"it has: {', '.join(law.parameters._fields)}")
    return replace(material, burn=law.build(**{**material.burn._asdict(), **given}))


def _line(name: str, own: str):
    """(PopLine, what to call it, the pressures in Pa between which it was measured) of a published line, or of the one given."""
    from hugoniot.diagnostics.detonation import PopLine
    from hugoniot.materials import library
    if own:
        try:
            a, b = (float(part) for part in own.split(","))
        except ValueError:
            raise DeckError.single("command line", None, "--line", f"'{own[:40]}' is not a pair of numbers a, b",
                                   'write "1.11, -0.66"') from None
        if not b < 0.0:
            raise DeckError.single("command line", None, "--line",
                                   f"the run distance must fall with pressure, so b must be negative, got {b:g}")
        return PopLine(a, b), f"log10(p/GPa) = {a:g} {b:+g} log10(x/mm)", (0.0, math.inf)
    rows = [row for row in library.schema.table("pop_plot").values() if row.id == name.strip().upper()] or list(library.pop_lines(name))
    if not rows:
        raise DeckError.single("command line", None, "--to", f"the library has no measured Pop plot of '{name[:60]}'",
                               "it has: " + ", ".join(f"{r.id} {r.material}" for r in library.schema.table("pop_plot").values())
                               + '; or give your own with --line "a, b"')
    row = rows[0]
    doubt = "; not checked against the printed source" if row.status == "recalled" else ""
    span = f"{row['pressure_low'] * 1e-9:g} to {row['pressure_high'] * 1e-9:g} GPa"
    words = f"{row.id} {row.material}, {row['rho0']:g} kg/m3, measured from {span} ({row.source}{doubt})"
    return PopLine(row["a"], row["b"]), words, (row["pressure_low"], row["pressure_high"])


# -- output ----------------------------------------------------------------------------------------------------------
def _table(burn) -> dict:
    from hugoniot.laws.burn.contract import BURN
    return {"law": BURN.of(burn).name, **{name: float(value) for name, value in burn._asdict().items()}}


def _toml(found, material: str) -> str:
    from hugoniot.problem.write import to_toml
    return to_toml({"material": {"fitted": {"base": material, "burn": _table(found.material.burn)}}})


def _told(found, span: tuple[float, float]) -> list[str]:
    """What the standard deviations assume, and where the line is used beyond its data."""
    from hugoniot.campaign.pop_target import RELATIVE_SIGMA

    count = len(found.points)
    said = [f"each of the {count} run distances of the line counts as an independent measurement with a standard deviation of "
            f"{100 * RELATIVE_SIGMA:g} %: the standard deviations of the constants depend on this and on the number of runs, not on the "
            "scatter of the measured points"]
    beyond = [f"{p.pressure * 1e-9:.4g}" for p in found.points if not span[0] * (1.0 - 1e-9) <= p.pressure <= span[1] * (1.0 + 1e-9)]
    if beyond:
        said.append(f"at {', '.join(beyond)} GPa the line is extrapolated beyond its measured points")
    return said


def _print_found(found, described: str, material: str, told: list[str]) -> None:
    typer.echo(f"{material} calibrated to {described}: {found.runs} runs, {found.zones} zones in a run distance")
    echo_table(["constant", "before", "after"], [[name, f"{found.before[name]:.6g}", f"{found.after[name]:.6g}"] for name in found.after])
    echo_table(["parameter", "value", "standard deviation", "95 % interval"],
               [[p.name, f"{p.value:.5g}", f"{p.sigma:.2g}", f"{p.low:.5g} .. {p.high:.5g}"] for p in found.fit.parameters])
    echo_table(["pressure, GPa", "run distance, mm", "ratio to the line", "with zones half the size"],
               [[f"{p.pressure * 1e-9:.4g}", f"{p.distance * 1e3:.4g}", f"{coarse:.3f}", f"{fine:.3f}"]
                for p, coarse, fine in zip(found.points, found.ratios, found.refined)])
    for doubt in (*told, *found.fit.doubts):
        typer.echo(f"note: {doubt}", err=True)
    off, mesh = (max(abs(v - 1.0) for v in values) for values in (found.refined, [f / c for f, c in zip(found.refined, found.ratios)]))
    typer.echo(f"with zones half the size within {100 * off:.1f} % of the line; they changed run distances by up to {100 * mesh:.1f} %")
    if not off < 0.1:
        typer.echo("note: these constants alone do not bring the run distances to the line; adjust others, or start elsewhere", err=True)
    typer.echo(_toml(found, material))
