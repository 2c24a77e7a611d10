"""hugoniot exact: the exact solutions, their numbers, fields and jumps."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, echo_json, echo_table
from hugoniot.cli.typed import refuse_idle

_FIELDS = ("--time", "--at", "--from", "--to", "--points")


def command(
    name: Annotated[str, typer.Argument(metavar="SOLUTION", help="Name of a solution; without it the command lists all solutions.")] = "",
    settings: Annotated[list[str] | None, typer.Argument(metavar="PARAMETER=VALUE", help='Parameters, such as gamma=1.4 or "speed=2 '
                                                                                              'km/s".')] = None,
    times: Annotated[list[str] | None, typer.Option("--time", help='Time at which fields are printed, such as "2 us"; repeatable.')] = None,
    at: Annotated[str, typer.Option("--at", help='Positions, such as "1 mm, 2 mm"; in two or three dimensions separated by '
        'semicolons, such as "0, 4 m; 3 m, 2 m".')] = "",
    start: Annotated[str | None, typer.Option("--from", help="First position (default: 0, or a little beyond the leftmost wave).")] = None,
    end: Annotated[str | None, typer.Option("--to", help="Last position (default: a little beyond the outermost front).")] = None,
    points: Annotated[int, typer.Option("--points", min=2, max=1000000, help="Number of positions; two more are added at each "
        "jump.")] = 201,
    as_json: JSON = False,
    as_csv: Annotated[Path | None, typer.Option("--csv", help="Write the fields, in SI, to this file.")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw the fields into this file (.png, .pdf, .svg).")] = None,
) -> None:
    """Print exact solutions: characteristic numbers, fields at positions and times, and jumps.

    Without a name the command lists the solutions. With a name it prints the parameters and characteristic numbers, with --time also the
    fields. Parameters are quantities with units or numbers in SI; a problem stated in another consistent set of units may be given in
    plain numbers.

    Example: hugoniot exact sedov gamma=1.4 "energy=1 MJ" "density=1.2 kg/m^3" --time "1 ms" --plot blast.png
    """
    from hugoniot.cli import exact_report

    if not name:
        refuse_idle("without the name of a solution", *_FIELDS, "--csv", "--plot")
        rows = exact_report.listing()
        if as_json:
            echo_json(rows)
        else:
            echo_table(["solution", "what", "source"], [(r["solution"], r["what"], r["source"].partition(";")[0]) for r in rows])
        return
    if at:
        refuse_idle("with --at", "--from", "--to", "--points")
    asked = exact_report.Grid(times or [], at, start, end, points)
    exact_report.report(name, settings or [], asked, as_json, as_csv, plot)
