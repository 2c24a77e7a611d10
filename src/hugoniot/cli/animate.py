"""hugoniot animate: a film of a two-dimensional run."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.typed import refuse_idle


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    field: Annotated[str, typer.Argument(help="Field to show, such as pressure, speed or von_mises.")] = "pressure",
    out: Annotated[Path | None, typer.Option("--out", "-o", help="File to write, .gif or .mp4 (default: a .gif in the run "
        "folder).")] = None,
    fps: Annotated[float, typer.Option("--fps", min=0.1, max=120.0, help="Frames per second.")] = 12.0,
    every: Annotated[int, typer.Option("--every", min=1, help="Use every Nth snapshot.")] = 1,
    mesh: Annotated[bool, typer.Option("--mesh", help="Draw the mesh lines.")] = False,
    mirror: Annotated[bool, typer.Option("--mirror/--no-mirror", help="In axisymmetric geometry, show the other half too.")] = True,
) -> None:
    """Write a film of a two-dimensional run, with one frame per snapshot.

    Example: hugoniot animate taylor.run plastic_strain --out taylor.mp4
    """
    from hugoniot.output.atomic import explained
    from hugoniot.plotting import load
    from hugoniot.plotting.animate import animate

    path = out or folder / f"{field}.gif"
    run = load(folder)
    if run.setup["geometry"] != "axisymmetric":
        refuse_idle(f"in {run.setup['geometry']} geometry, which has no other half", "--mirror", "--no-mirror")
    with explained(path, "no film is written"):
        frames = animate(run, field, path, fps, every, mesh=mesh, mirror=mirror)
    typer.echo(f"wrote {path}, {frames} frames")
