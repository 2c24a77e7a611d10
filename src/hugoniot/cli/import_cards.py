"""hugoniot import: a material of another program as a table of a deck."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import quantity
from hugoniot.errors import DeckError, DeckProblem, FileTrouble
from hugoniot.materials.ls_dyna import material_tables, read_cards, scale_of
from hugoniot.materials.read import build_material
from hugoniot.problem.write import to_toml


def command(
    file: Annotated[Path, typer.Argument(help="LS-DYNA keyword file with the cards of one material.")],
    units: Annotated[str, typer.Option(help='Units of mass, length and time of the file: "g cm us", "tonne mm s".')],
    name: Annotated[str, typer.Option(help="What the deck calls the material.")] = "imported",
    density: Annotated[str | None, typer.Option(help='Where no MAT card gives it: "7.85 g/cm^3".')] = None,
) -> None:
    """The table of a material for a deck, in SI, from *EOS_GRUNEISEN or *EOS_JWL and *MAT_JOHNSON_COOK; checked as a deck would be.

    Example: hugoniot import steel.k --units "g cm us" --name steel
    """
    try:
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise FileTrouble(f"cannot read {file}: {error.strerror or error}") from None
    given = quantity(density, "kg/m^3", "--density") if density else None
    tables, left = material_tables(read_cards(text, file.name), scale_of(units), file.name, given)
    problems: list[DeckProblem] = []
    build_material(name, tables, problems, file.name, lambda path: None)
    if problems:
        raise DeckError(problems)
    typer.echo(to_toml({"material": {name: tables}}).strip())
    for text in left:
        typer.echo(f"note: {text}", err=True)
