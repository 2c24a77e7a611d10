"""hugoniot import: a material or a deck of another program as a table or a deck of this one."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import quantity
from hugoniot.errors import DeckError, DeckProblem, FileTrouble
from hugoniot.files import read_regular
from hugoniot.materials.ls_dyna import material_tables, read_cards, scale_of, tension_note
from hugoniot.materials.read import build_material
from hugoniot.problem.write import to_toml

LARGEST = 20_000_000     # bytes of a file that is read


def command(
    file: Annotated[Path, typer.Argument(help="Deck of pyKO (.yml), deck of KO (.in), or LS-DYNA keyword file of one material.")],
    units: Annotated[str | None, typer.Option(help='LS-DYNA, required: units of mass, length and time, such as "g cm us" or "tonne '
        'mm s".')] = None,
    name: Annotated[str, typer.Option(help="LS-DYNA: name of the material table, [material.NAME].")] = "imported",
    density: Annotated[str | None, typer.Option(help='LS-DYNA, if no *MAT card gives it: density, such as "7.85 g/cm^3".')] = None,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="File to write (default: print the result).")] = None,
) -> None:
    """Convert a deck of pyKO or KO into a deck, or LS-DYNA cards into a material table.

    Decks of the one-dimensional hydrocodes pyKO (.yml, .yaml) and KO (.in) are converted to SI, with the integrator, viscosity and time
    step of those codes. LS-DYNA cards may be *EOS_GRUNEISEN or *EOS_JWL, with *MAT_JOHNSON_COOK, *MAT_HIGH_EXPLOSIVE_BURN (only its
    density is used) or --density.

    Example: hugoniot import impact.yml --out impact.toml

    Example: hugoniot import steel.k --units "g cm us" --name steel
    """
    text = _text(file)
    kind = file.suffix.lower()
    if kind in (".yml", ".yaml", ".in"):
        if units or density or name != "imported":
            raise DeckError.single("command line", None, "--units, --name, --density", "apply to LS-DYNA cards only", "omit them")
        shown, left = _deck(text, file, kind)
    elif units is None:
        raise DeckError.single("command line", None, "--units", f"'{file.name}' is read as LS-DYNA cards, whose units are not given",
                               'write --units "g cm us", or give a deck of pyKO or KO, whose name ends in .yml, .yaml or .in')
    else:
        given = quantity(density, "kg/m^3", "--density") if density else None
        cards, scale = read_cards(text, file.name), scale_of(units)
        tables, left = material_tables(cards, scale, file.name, given)
        problems: list[DeckProblem] = []
        made = build_material(name, tables, problems, file.name, lambda path: None)
        if problems or made is None:
            raise DeckError(problems)
        shown = to_toml({"material": {name: tables}})
        if "EOS_GRUNEISEN" in cards:
            left.append(tension_note(cards["EOS_GRUNEISEN"], made.eos, scale))
        if doubts := _as_a_deck(name, shown, file.name):
            left += [*doubts, f'the numbers above are SI, converted from --units "{units}": are these the units of the file?']
    if out is None:
        typer.echo(shown.strip())
    else:
        _write(out, shown)
    for sentence in left:
        typer.echo(f"note: {sentence}", err=True)


def _as_a_deck(name: str, shown: str, file: str) -> list[str]:
    """Warnings of a deck that uses the material, read as such a deck is; DeckError for what it would refuse."""
    from hugoniot.problem.deck import read_deck_text

    region = {"region": [{"name": "body", "material": name, "from": 0.0, "to": 1e-3, "zones": 10}]}
    return list(read_deck_text(f"stop_time = 1e-6\n{to_toml(region)}\n{shown}", file).warnings)


def _deck(text: str, path: Path, kind: str) -> tuple[str, list[str]]:
    """A deck that this program has read back, and what is left out."""
    from hugoniot.problem.deck import read_deck_text
    from hugoniot.problem.ko_columns import read_columns
    from hugoniot.problem.ko_decks import deck_tables
    from hugoniot.problem.ko_yaml import read_yaml

    file, folder = path.name, path.resolve().parent
    source = read_columns(text, file) if kind == ".in" else read_yaml(text, file, (folder, folder.parent, Path()))
    tables, left = deck_tables(source, file)
    shown = f"# From {file}, every number in SI.\n" + to_toml(tables)
    read_deck_text(shown, file)
    return shown, left


def _text(file: Path) -> str:
    try:
        return read_regular(file, LARGEST).decode("utf-8-sig", errors="replace")
    except FileTrouble:
        raise
    except OSError as error:
        raise FileTrouble(f"cannot read {file}: {error.strerror or error}") from None


def _write(out: Path, text: str) -> None:
    try:
        with out.open("x", encoding="utf-8") as target:
            target.write(text)
    except FileExistsError:
        raise FileTrouble(f"{out} exists; choose another name or remove it") from None
    except OSError as error:
        raise FileTrouble(f"cannot write {out}: {error.strerror or error}") from None
    typer.echo(f"wrote {out}", err=True)
