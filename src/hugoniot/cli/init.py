"""hugoniot init: writes a commented deck to start from."""

import shlex
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import echo_table
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.materials.collect import nearest, printable
from hugoniot.problem import catalogue


def command(
    problem: Annotated[str, typer.Argument(help="Name of the problem; without it the command lists all problems.")] = "",
    out: Annotated[Path | None, typer.Option("--out", "-o", help="File to write (default: PROBLEM.toml).")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace the file if it exists.")] = False,
    schema: Annotated[bool, typer.Option("--schema", help="Write the JSON Schema of decks for text editors instead, by default to "
        "deck.schema.json.")] = False,
    solver: Annotated[str, typer.Option("--solver", help="With --schema: the solver whose decks the schema describes (default: "
        "lagrange1d).")] = "",
) -> None:
    """Write a commented deck for a common problem.

    Example: hugoniot init flyer && hugoniot run flyer.toml
    """
    if solver and not schema:
        raise DeckError.single("init", None, "--solver", "only chooses the solver of a schema", "add --schema, or leave --solver out")
    if schema:
        if problem:
            raise DeckError.single("init", None, printable(problem), "has no effect with --schema", "omit one of them")
        import json

        from hugoniot.problem.editor_schema import json_schema
        from hugoniot.problem.solver_kinds import available_solvers

        solver = solver or "lagrange1d"
        if solver not in available_solvers():
            raise DeckError.single("init", None, "--solver", f"unknown solver '{printable(solver)}'", nearest(solver, available_solvers()))
        _write(out or Path("deck.schema.json"), json.dumps(json_schema(solver), indent=2, ensure_ascii=False) + "\n", overwrite)
        return
    if not problem:
        refuse_idle("without a problem", "--out", "--overwrite")
        echo_table(["problem", "what it shows"], [(p.name, p.summary) for p in catalogue.problems()])
        typer.echo("\nhugoniot init PROBLEM writes the deck.")
        return
    text = catalogue.deck_text(problem)
    path = out or Path(f"{problem}.toml")
    _write(path, text, overwrite)
    typer.echo(f"next: hugoniot run {shlex.quote(str(path))}")


def _write(path: Path, text: str, overwrite: bool) -> None:
    if path.exists() and not overwrite:
        raise FileTrouble(f"{path} exists already; choose another with --out, or replace it with --overwrite")
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None
    typer.echo(f"wrote {path}")
