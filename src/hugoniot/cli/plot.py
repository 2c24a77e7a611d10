"""hugoniot plot: pictures of a run."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    kind: Annotated[str, typer.Argument(help="Kind of picture: xt, gauge, profile, free_surface, budget, peaks, ...")] = "xt",
    field: Annotated[str, typer.Argument(help="Field of an xt, gauge or profile picture, such as pressure.")] = "",
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Picture to write: .png, .pdf or .svg.")] = None,
) -> None:
    """Draw a picture of a run.

    Example: hugoniot plot flyer.run xt pressure --out wave.png
    """
    from hugoniot.output.run import load

    pictures = load(folder).plot
    kinds = [name for name in dir(pictures) if not name.startswith("_") and callable(getattr(pictures, name))]
    if kind not in kinds:
        raise DeckError.single("plot", None, "kind", f"unknown kind of picture '{kind[:40]}'", nearest(kind, kinds))
    axes = getattr(pictures, kind)(*([field] if field else []))
    path = out or folder / f"{'-'.join(word for word in (kind, field) if word)}.png"
    figure = getattr(axes if not hasattr(axes, "__len__") else axes[0], "figure", axes)
    figure.savefig(path, dpi=150)
    typer.echo(f"wrote {path}")
