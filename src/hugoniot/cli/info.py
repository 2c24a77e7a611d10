"""hugoniot info: what a run folder holds."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.opened import opened
from hugoniot.cli.results import echo_results
from hugoniot.cli.show import JSON, echo_json, echo_table
from hugoniot.cli.typed import refuse_idle
from hugoniot.units import format_si

MOST_EVENTS = 40


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    events: Annotated[bool, typer.Option(
        "--events", help="List the events, such as voids opened or closed and interfaces separated.")] = False,
    deck: Annotated[bool, typer.Option("--deck", help="Print the deck of the run with every default written out.")] = False,
    verify: Annotated[bool, typer.Option("--verify", help="Check every file against the checksums that the run wrote.")] = False,
    as_json: JSON = False,
) -> None:
    """Print a summary of a run: status, conservation errors, gauges, estimate of the spall strength.

    Of an unfinished run it prints the results up to the last checkpoint.

    Example: hugoniot info flyer.run --events

    With --verify the exit code is 4 if a file is missing or has changed since the run.
    """
    if verify:
        refuse_idle("with --verify", "--events", "--deck")
        _verify(folder, as_json)
        return
    if deck:
        refuse_idle("with --deck", "--events", "--json")
    from hugoniot.output.run_numbers import record

    with opened(folder) as run:
        if deck:
            typer.echo(run.deck, nl=False)
            return
        if as_json:
            echo_json(record(run) | {"folder": str(folder)})
            return
        echo_results(run)
        if events:
            typer.echo("")
            rows = record(run)["events"]
            shown = [(format_si(r["time"], "s"), r["cycle"], r["kind"], r["text"]) for r in rows[:MOST_EVENTS]]
            echo_table(["time", "cycle", "event", ""], shown)
            if len(rows) > MOST_EVENTS:
                typer.echo(f"... and {len(rows) - MOST_EVENTS} more (--json lists all)")


def _verify(folder: Path, as_json: bool) -> None:
    from hugoniot.output.verify import verify

    found = verify(folder)
    if as_json:
        echo_json({"folder": str(folder), "sound": not any(f.bad for f in found), "files": [f._asdict() for f in found]})
    else:
        echo_table(["file", "", ""], found)
    if any(f.bad for f in found):
        raise typer.Exit(4)
