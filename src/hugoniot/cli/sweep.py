"""hugoniot sweep: a deck many times, with some of its keys varied."""

import time
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.progress import duration, time_left
from hugoniot.cli.show import JSON, MATERIALS, echo_json, echo_table

MOST_ROWS = 30
MOST_COLUMNS = 5
SECONDS_BETWEEN_LINES = 5.0

_VARY = 'Key to vary and its values, as described above; repeatable.'


def command(
    deck: Annotated[Path | None, typer.Argument(help="The deck, which may contain a table [sweep] instead of the options; not "
        "needed with --match.", readable=False)] = None,
    vary: Annotated[list[str] | None, typer.Option("--vary", "-v", help=_VARY)] = None,
    tie: Annotated[list[str] | None, typer.Option("--tie", help='Key that follows from others, such as "region.target.from = '
        'region.flyer.to"; repeatable.')] = None,
    design: Annotated[str, typer.Option("--design", help="Choice of cases: grid, sobol, lhs, saltelli, morris, or a table of cases "
        "(.csv).")] = "grid",
    samples: Annotated[int | None, typer.Option("--samples", "-n", help="Number of cases of a sample; with saltelli, of base cases; "
        "with morris, of paths.")] = None,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the random numbers; another seed gives another sample.")] = 0,
    match: Annotated[str | None, typer.Option("--match", help="Vary an impedance match of these materials instead of a deck: "
        "FLYER,TARGET[,...].")] = None,
    output: Annotated[list[str] | None, typer.Option("--output", help='Results to tabulate, such as "*.arrival" (default: all); '
        'repeatable.')] = None,
    record: Annotated[list[str] | None, typer.Option("--record", help='Record to keep of every case, such as "free '
        'surface.velocity"; repeatable.')] = None,
    uncertain: Annotated[str | None, typer.Option("--uncertain", help="\"library\": vary constants of materials within their "
        "uncertainties.")] = None,
    keep: Annotated[bool, typer.Option("--keep", help="Keep the run folder of every case.")] = False,
    time_limit: Annotated[float | None, typer.Option("--time-limit", help="Wall-clock time in seconds after which a case is "
        "stopped. Loading does not count, and every function that a case has to compile adds 120 s.")] = None,
    workers: Annotated[int | None, typer.Option("--workers", "-w", help="Number of worker processes (default: one per processor).")] = None,
    engine: Annotated[str, typer.Option("--engine", help="Where cases run: local (this machine) or dask (a cluster).")] = "local",
    scheduler: Annotated[str | None, typer.Option("--scheduler", help="With dask: address of the scheduler, such as "
        "tcp://10.0.0.1:8786.")] = None,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Folder to write (default: DECK.sweep).")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Picture to write (.png, .pdf, .svg).")] = None,
    materials: MATERIALS = None,
    report: Annotated[bool, typer.Option("--report/--no-report", help="Write report.html at the end.")] = True,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show no progress.")] = False,
    as_json: JSON = False,
) -> None:
    """Run a deck many times with some of its keys varied, and collect the results in one table.

    The folder DECK.sweep receives cases.csv, sweep.h5 (a netCDF file, with the parameters as coordinates) and report.html. Finished cases
    are not run again: the same command continues after an interruption, or extends a sweep to which values were added. The row of a case
    that fails gives the reason.

    \b
    --vary takes one of these forms:
      KEY = LOW..HIGH UNIT : COUNT      values in equal steps
      KEY = LOW..HIGH UNIT : COUNT log  values in equal ratios
      KEY = 1, 2, 5 GPa                 the values listed
      KEY = "copper", "aluminum"        the texts listed
      KEY = MEAN +- SIGMA UNIT          a normal distribution, for sampled designs

    \b
    --design takes one of these names:
      grid      all combinations of the values
      sobol     quasi-random cases: spreads of the results
      lhs       Latin hypercube: spreads of the results
      saltelli  Sobol' sensitivity indices, with confidence intervals
      morris    screening of many parameters

    --uncertain library varies the constants of library materials within their uncertainties (covariances of fits, or the spread
    between sources), and gives bands of the records at the gauges. A name that is not a key of the deck can be varied too, for use in
    --tie.

    Example: hugoniot sweep flyer.toml --vary "region.flyer.velocity = 300..1200 m/s : 10"
    """
    from hugoniot.campaign.ask import Wishes, engine_of, run_sweep

    wishes = Wishes(None, None if match is None else [part.strip() for part in match.split(",") if part.strip()], list(vary or ()),
                    list(tie or ()), design, samples, seed, list(output or ()), list(record or ()), keep, time_limit, uncertain)
    if plot is not None:
        from hugoniot.cli.plot import drawable

        drawable(plot, "sweep", "--plot")
    chosen = None if engine == "local" and scheduler is None else engine_of(engine, scheduler, workers, time_limit, _tell_dashboard)
    with _display(quiet or as_json) as show:
        try:
            swept = run_sweep(deck, wishes, out, engine=chosen, materials=materials or (), workers=workers, show=show, report=report)
        except KeyboardInterrupt:
            typer.echo("interrupted; finished cases are kept, and the same command continues", err=True)
            raise typer.Exit(130) from None
    if plot is not None:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.sensitivity import sensitivity_figure
        from hugoniot.plotting.sweep import sweep_figure, uncertainty_figure

        sensitive = swept.analysis.sensitivity if swept.analysis else {}
        banded = swept.constants and swept.table.records and swept.analysis and swept.analysis.bands
        save(sensitivity_figure(sensitive, swept.table) if sensitive else uncertainty_figure(swept.table) if banded else
             sweep_figure(swept.table), plot)
    echo_json(_record(swept)) if as_json else _echo(swept)


def _tell_dashboard(address: str) -> None:
    typer.echo(f"dashboard of the cluster: {address}", err=True)


def _record(swept) -> dict:
    from hugoniot.campaign.sensitivity import QUANTILES

    table = swept.table
    columns = (*table.parameters, *table.results)
    rows = [{**{c.name: c.values[k] for c in columns}, "reason": table.reasons[k]} for k in range(len(table))]
    found, told = swept.analysis, {}
    if found is not None:
        told = {"sensitivity": [asdict(row) for each in found.sensitivity.values() for row in each],
                "spread": [{**asdict(row), "quantiles": dict(zip(map(str, QUANTILES), row.quantiles))} for row in found.spread.values()]}
    return {"folder": str(swept.folder), "cases": len(table), "failed": sum(map(bool, table.reasons)), "warnings": table.warnings,
            "units": {c.name: c.unit for c in columns}, **told, "rows": rows}


def _echo(swept) -> None:
    from hugoniot.plotting.sweep import scale, worth_drawing

    table, progress = swept.table, swept.progress
    columns = (*table.parameters, *worth_drawing(table, MOST_COLUMNS))
    heads = [f"{c.name}, {scale(c)[0]}" if scale(c)[0] else c.name for c in columns]
    rows = [[str(k + 1), *(_cell(c, k, scale(c)[1]) for c in columns), table.reasons[k]] for k in range(min(len(table), MOST_ROWS))]
    if not swept.constants:     # of which there are many, and no case says anything by itself
        echo_table(["case", *heads, "reason" if any(table.reasons) else ""], rows)
    if len(table) > MOST_ROWS and not swept.constants:
        typer.echo(f"... and {len(table) - MOST_ROWS} more")
    failed, page = sum(map(bool, table.reasons)), swept.folder / "report.html"
    known = f", {progress.known} of them known from an earlier run" if progress.known else ""
    count = f"{len(table)} case{'' if len(table) == 1 else 's'}"
    typer.echo(f"\n{count} in {duration(swept.seconds)}{known}" + (f"; {failed} failed" if failed else ""))
    _echo_analysis(swept)
    _echo_constants(swept.constants)
    for text in table.warnings:
        typer.echo(f"warning: {text}", err=True)
    typer.echo(f"table in {swept.folder / 'cases.csv'} and sweep.h5" + (f", report: {page}" if page.is_file() else ""))


def _echo_analysis(swept) -> None:
    """Sensitivities or spreads of the results that are shown."""
    from hugoniot.plotting.sweep import scale, worth_drawing

    found = swept.analysis
    if found is None:
        return
    shown = worth_drawing(swept.table, MOST_COLUMNS)
    rows = [row for column in shown for row in found.sensitivity.get(column.name, ())]
    typer.echo("")
    if found.kind == "saltelli" and rows:
        echo_table(["result", "parameter", "first order", "95 % interval", "total", "95 % interval"],
                   [[r.result, r.parameter, f"{r.first:.3f}", f"{r.first_low:.3f} .. {r.first_high:.3f}", f"{r.total:.3f}",
                     f"{r.total_low:.3f} .. {r.total_high:.3f}"] for r in rows])
        lost = max(r.lost for r in rows)
        if lost:
            typer.echo(f"note: up to {lost} base cases have no value of these results and are left out")
    elif found.kind == "morris" and rows:
        units = {column.name: scale(column) for column in shown}
        echo_table(["result", "parameter", "mean magnitude", "mean effect", "standard deviation", "unit"],
                   [[r.result, r.parameter, *(f"{v * units[r.result][1]:.4g}" for v in (r.magnitude, r.mean, r.deviation)),
                     units[r.result][0]] for r in rows])
    elif found.spread:
        spread = [(found.spread[column.name], *scale(column)) for column in shown]
        echo_table(["result", "mean", "standard deviation", "2.5 %", "median", "97.5 %", "unit", "cases"],
                   [[s.result, *(f"{v * factor:.5g}" for v in (s.mean, s.deviation, s.quantiles[0], s.quantiles[2], s.quantiles[4])), unit,
                     str(s.count)] for s, unit, factor in spread])
    typer.echo("")


def _echo_constants(rows) -> None:
    """The constants that varied by their uncertainty in the library, and how many it knows none of."""
    if not rows:
        return
    from hugoniot.dossier.uncertainty import AT_LEAST

    moved = [[material, name, f"{float(value):.6g}", deviation, unit, words]
             for material, name, value, unit, deviation, words in rows if deviation]
    echo_table(["material", "constant", "value", "standard deviation", "unit", "rows of the library"], moved)
    typer.echo(f"note: {AT_LEAST}")
    held = sum(1 for row in rows if row[1] and not row[4])
    if held:
        typer.echo(f"{held} further constants were held fixed: the library has no uncertainty for them (constants.csv)")
    typer.echo("")


def _cell(column, k: int, factor: float) -> str:
    value = column.values[k]
    if isinstance(value, str):
        return value
    return "-" if value != value else f"{value * factor:.5g}"


class _display:
    """A line that renews itself in a terminal; elsewhere a line every few seconds, on standard error; gives a function for the progress."""

    def __init__(self, quiet: bool):
        import sys

        self.quiet, self.last, self.renewing = quiet, 0.0, sys.stderr.isatty()

    def __enter__(self):
        return None if self.quiet else self.show

    def __exit__(self, *_):
        if self.renewing and self.last:
            typer.echo("", err=True)

    def show(self, progress) -> None:
        """Show how far it is."""
        now = time.monotonic()
        if now - self.last < (0.2 if self.renewing else SECONDS_BETWEEN_LINES) and progress.done < progress.total:
            return
        self.last = now
        line = (f"{progress.done} of {progress.total} cases, {progress.rate:.3g} cases/s, {time_left(progress.left)}"
                + (f", {progress.failed} failed" if progress.failed else "") + (f", {progress.known} known" if progress.known else ""))
        typer.echo(f"\r\x1b[K{line}" if self.renewing else line, err=True, nl=not self.renewing)
