"""hugoniot report: writes the report of a run again."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.opened import opened
from hugoniot.cli.show import JSON, echo_json


def command(folder: Annotated[Path, typer.Argument(help="The run folder.")], as_json: JSON = False) -> None:
    """Write report.html of a run again, a single file that needs no network.

    That of an unfinished run shows the results up to the last checkpoint.

    Example: hugoniot report flyer.run
    """
    from hugoniot.report import write_report

    with opened(folder) as run:
        path = write_report(run.folder, into=folder) or folder / "report.html"
    if as_json:
        echo_json({"report": str(path)})
    else:
        typer.echo(f"wrote {path}")
