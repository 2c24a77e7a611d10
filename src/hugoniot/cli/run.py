"""hugoniot run: a deck in, a run folder out."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.progress import end_interrupted, progress
from hugoniot.cli.show import JSON, MATERIALS, SET, echo_json, overrides_of
from hugoniot.report.scribe import Scribe


def command(
    deck: Annotated[Path, typer.Argument(help="The deck, a TOML file.", readable=False)],
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Run folder to write (default: DECK.run).")] = None,
    setting: SET = None,
    materials: MATERIALS = None,
    threads: Annotated[int | None, typer.Option("--threads", "-t", min=1, help="Number of threads; it does not affect the result.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace an existing run in that folder.")] = False,
    report: Annotated[bool, typer.Option("--report/--no-report", help="Write report.html at the end.")] = True,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show no progress.")] = False,
    as_json: JSON = False,
) -> None:
    """Run a deck and write its run folder: result.h5, gauges.csv, summary.json, report.html.

    Example: hugoniot run flyer.toml --set region.flyer.velocity="800 m/s" --out faster.run

    Ctrl-C or a request to end (SIGTERM) writes a checkpoint and exits with code 130; hugoniot resume continues from there.
    """
    with Scribe(report) as scribe:      # first of all: it gets ready while this process does
        run, told = _run(deck, out, overrides_of(setting) | ({} if threads is None else {"solver.threads": threads}), materials or (),
                         overwrite, report and scribe.write, quiet or as_json)
        if not as_json:
            from hugoniot.cli.results import echo_results

            echo_results(run, told)     # while the report is being drawn
    if as_json:
        from hugoniot.output.run_numbers import record

        echo_json(record(run))
    else:
        from hugoniot.cli.results import echo_place

        echo_place(run)


def _run(deck, out, changes, materials, overwrite, report, quiet):
    """The finished run, and the warnings already printed."""
    from hugoniot.problem.deck import read_deck

    found = read_deck(deck, changes, materials)
    for warning in found.warnings:
        typer.echo(f"warning: {warning}", err=True)
    folder = out or Path(f"{deck.stem}.run")
    from hugoniot import simulate
    from hugoniot.core.compile_ahead import allow_helper
    from hugoniot.core.compile_watch import without_linear_algebra

    without_linear_algebra()
    allow_helper()
    try:
        with progress(quiet) as display:
            return simulate.run(found, folder, progress=display, overwrite=overwrite, report=report), found.warnings
    except KeyboardInterrupt:
        end_interrupted(folder)
