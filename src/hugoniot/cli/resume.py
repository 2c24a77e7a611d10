"""hugoniot resume: goes on with an interrupted run."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.progress import end_interrupted, progress
from hugoniot.cli.results import echo_place, echo_results
from hugoniot.cli.show import JSON, echo_json


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    restore_deck: Annotated[bool, typer.Option("--restore-deck", help="First restore deck.toml of the folder from the copy kept "
        "with the checkpoints.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show no progress.")] = False,
    as_json: JSON = False,
) -> None:
    """Continue an interrupted or killed run from its newest intact checkpoint.

    The result is identical, bit for bit, to that of an uninterrupted run.

    Example: hugoniot resume flyer.run

    For a finished run it writes whatever is missing: report, gauges.csv, deck.
    """
    from hugoniot import simulate

    finished = (folder / "summary.json").is_file()
    try:
        with progress(quiet or as_json) as display:
            run = simulate.resume(folder, progress=display, restore_deck=restore_deck)
    except KeyboardInterrupt:
        end_interrupted(folder)
    if as_json:
        from hugoniot.output.run_numbers import record

        echo_json(record(run))
    else:
        if finished:
            typer.echo(f"{folder} was finished already: nothing was run, only missing files are written")
        echo_results(run)
        echo_place(run)
    _warn_of_changes(folder)


def _warn_of_changes(folder: Path) -> None:
    """Of a finished run only the files that are missing are written: whoever resumes it hears of those that were changed."""
    from hugoniot.output.verify import verify

    changed = [finding.file for finding in verify(folder, survey=False) if finding.bad]
    if changed:
        typer.echo(f"warning: changed since the run ended, and left as it is: {', '.join(changed)}; "
                   f"see `hugoniot info {folder} --verify`", err=True)
