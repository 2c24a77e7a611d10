"""hugoniot info: what a run folder holds."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.results import echo_results
from hugoniot.cli.show import JSON, echo_json, echo_table
from hugoniot.units import format_si

MOST_EVENTS = 40


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    events: Annotated[bool, typer.Option(
        "--events", help="List the events: voids opened or closed, interfaces separated, warnings.")] = False,
    deck: Annotated[bool, typer.Option("--deck", help="Print the deck that ran, every default written out.")] = False,
    verify: Annotated[bool, typer.Option("--verify", help="Compare every file with the checksums of the run.")] = False,
    as_json: JSON = False,
) -> None:
    """Summarise a run: status, errors, gauges, spall reading, events.

    Example: hugoniot info flyer.run --events

    With --verify: whether every file is as the run left it; exit code 4 if one is not.
    """
    if verify:
        _verify(folder, as_json)
        return
    from hugoniot.output.run import load
    from hugoniot.output.run_numbers import record

    run = load(folder)
    if deck:
        typer.echo(run.deck, nl=False)
        return
    if as_json:
        echo_json(record(run))
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
