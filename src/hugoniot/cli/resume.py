"""hugoniot resume: goes on with an interrupted run."""

import shlex
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.progress import progress
from hugoniot.cli.results import echo_place, echo_results
from hugoniot.cli.show import JSON, echo_json


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show no progress.")] = False,
    as_json: JSON = False,
) -> None:
    """Continue an interrupted or killed run from its newest intact checkpoint.

    The result is identical, bit for bit, to that of an uninterrupted run.

    Example: hugoniot resume flyer.run
    """
    from hugoniot import simulate

    try:
        with progress(quiet or as_json) as display:
            run = simulate.resume(folder, progress=display)
    except KeyboardInterrupt:
        typer.echo(f"interrupted; a checkpoint was written, continue with: hugoniot resume {shlex.quote(str(folder))}", err=True)
        raise typer.Exit(130) from None
    if as_json:
        from hugoniot.output.run_numbers import results

        echo_json({"folder": str(run.folder), **run.summary, **results(run)})
    else:
        echo_results(run)
        echo_place(run)
