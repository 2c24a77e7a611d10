"""hugoniot explore: the library, impacts, runs, decks and sweeps in a browser, without a network."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError


def command(
    what: Annotated[list[str] | None, typer.Argument(
        metavar="WHAT", help="What to show: folders of runs, sweeps or fits, a folder of run folders, tables (.csv), decks (.toml), "
        "materials (names or .toml).")] = None,
    work: Annotated[Path, typer.Option("--work", "-w", help="Folder for runs started from the page; created with the first "
                                                            "run.")] = Path("explorer-runs"),
    no_runs: Annotated[bool, typer.Option("--no-runs", help="Do not allow runs to be started from the page.")] = False,
    export: Annotated[Path | None, typer.Option("--export", help="Write the page with its data to this folder instead; it can be "
        "opened without a server.")] = None,
    port: Annotated[int, typer.Option("--port", min=0, max=65535, help="Port on this machine; 0: any free port.")] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")] = True,
    view: Annotated[str, typer.Option("--view", help='View to open: the part of its address from # on, such as '
        '"#/match?layers=copper,pmma&v=800".')] = "",
) -> None:
    """Explore materials, impacts, runs, decks and sweeps in a browser.

    Example: hugoniot explore flyer.run copper

    Only this machine can reach the page. Its address contains a token that changes with every start. Ctrl-C ends the server.
    """
    from hugoniot.explorer.places import places_of

    if export is not None:
        refuse_idle("with --export", "--work", "--no-runs", "--port", "--browser", "--no-browser", "--view")
    if no_runs:
        refuse_idle("with --no-runs", "--work")

    places = places_of(what or [], None if no_runs else work)
    if export is not None:
        _export(places, export)
        return
    try:
        from hugoniot.explorer.serve import serve
    except ModuleNotFoundError as error:
        raise DeckError.single("explore", None, "package", f"'{error.name}' is not installed", "pip install 'hugoniot[explore]' installs "
                               "what the server needs; --export FOLDER works without it") from None
    serve(places, port, browser=browser, view=view, announce=lambda address: typer.echo(f"explorer at {address}\nCtrl-C ends it"))


def _export(places, folder: Path) -> None:
    from hugoniot.explorer.export import export

    count = export(places, folder)
    typer.echo(f"{count} files in {folder}; open {folder / 'index.html'} in a browser")
