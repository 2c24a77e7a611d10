"""hugoniot list: every name a deck may use, in a line with its source."""

from typing import Annotated

import typer

from hugoniot.cli.show import JSON, echo_json, echo_table
from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest

KINDS = {
    "eos": "equations of state, [material.NAME.eos] law = ...",
    "strength": "strength laws, [material.NAME.strength] law = ...",
    "fracture": "fracture laws, [material.NAME.fracture] law = ...",
    "viscosity": "laws of artificial viscosity, [solver.viscosity] law = ...",
    "transport": "laws of shear viscosity, [transport.MATERIAL] viscosity = {law = ...}; shock_structure: [solver.transport]",
    "conduction": "laws of heat conduction, [transport.MATERIAL] conduction = {law = ...}; shock_structure: [solver.transport]",
    "burn": "burn laws of explosives, [material.NAME.burn] law = ...",
    "mixture": "mixtures of reactants and products, [material.NAME] mixture = ...",
    "exact": "exact solutions, hugoniot exact NAME",
    "materials": "materials of the library, material = ...",
    "fields": "fields of snapshots, gauges and plots",
    "problems": "decks that hugoniot init writes",
    "solvers": "solvers, [solver] kind = ...",
    "schema": "JSON Schema of decks, for text editors",
}


def command(
    kind: Annotated[str, typer.Argument(help=f"What to list: {', '.join(KINDS)}.")] = "",
    name: Annotated[str, typer.Argument(help="Name of a law, whose parameters are then listed.")] = "",
    as_json: JSON = False,
) -> None:
    """List laws, materials, fields, problems and solvers, with their sources.

    With the name of a law, its parameters are listed. Without arguments the command says what can be listed.

    Example: hugoniot list eos mie_gruneisen
    """
    if name and kind in KINDS and kind not in _families():
        raise DeckError.single("list", None, name[:40], f"is not the name of a law, and has no effect with '{kind}'", "omit it")
    if not kind:
        if as_json:
            echo_json([{"list": kind, "what": what} for kind, what in KINDS.items()])
        else:
            echo_table(["list", "what"], KINDS.items())
    elif kind not in KINDS:
        raise DeckError.single("list", None, "kind", f"nothing called '{kind[:40]}' to list", nearest(kind, KINDS))
    elif kind == "schema":
        from hugoniot.problem.editor_schema import json_schema
        echo_json(json_schema())
    elif kind in _families():
        _laws(kind, name, as_json)
    else:
        rows = _ROWS[kind]()
        if as_json:
            echo_json(rows)
        else:
            echo_table(list(rows[0]), [row.values() for row in rows])


def _families() -> dict:
    from hugoniot.laws import mixture, transport  # noqa: F401  (enrols the closures, transport and conduction laws)
    from hugoniot.laws.mixture.contract import MIXTURE
    from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
    from hugoniot.laws.viscosity.contract import VISCOSITY
    from hugoniot.materials.tables import families
    from hugoniot.problem import schema  # noqa: F401  (enrols the viscosity laws)
    return {**families(), "mixture": MIXTURE, "viscosity": VISCOSITY, "transport": TRANSPORT, "conduction": CONDUCTION}


def _laws(kind: str, name: str, as_json: bool) -> None:
    from hugoniot.materials.tables import accepted

    registry = _families()[kind]
    if not name:
        laws = [registry.get(each) for each in registry.names()]
        rows = [{"law": law.name, "summary": law.summary, "source": law.references[0]} for law in laws]
        if as_json:
            echo_json(rows)
        else:
            echo_table(["law", "what", "source"], [row.values() for row in rows])
        return
    if name not in registry.names():
        raise DeckError.single("list", None, kind, f"unknown {kind} law '{name[:40]}'", nearest(name, registry.names()))
    law = registry.get(name)
    names, required = accepted(law)
    rows = [{"parameter": n, "unit": law.units.get(n, "1"), "default": "required" if n in required else _default(law, n),
             "meaning": law.meaning.get(n, "").replace("`", "")} for n in names]
    if as_json:
        echo_json({"law": law.name, "summary": law.summary, "parameters": rows, "references": list(law.references)})
        return
    typer.echo(f"{law.name}: {law.summary}\n")
    if rows:
        echo_table(["parameter", "unit", "default", "meaning"], [row.values() for row in rows])
    typer.echo("\nsources: " + "\n         ".join(law.references))


def _default(law, name: str) -> str:
    value = law.defaults.get(name)
    return "optional" if value is None or value != value else str(value)


def _materials() -> list[dict]:
    from hugoniot.materials import library
    return [{"material": item.name, "category": item.category, "title": item.title, "also": ", ".join(item.aliases)}
            for item in library.index().values()]


def _fields() -> list[dict]:
    from hugoniot.core.fields import FIELDS
    return [{"field": f.name, "symbol": f.symbol, "unit": f.unit, "at": f.place, "meaning": f.long_name} for f in FIELDS.values()]


def _problems() -> list[dict]:
    from hugoniot.problem import catalogue
    return [{"problem": p.name, "what it shows": p.summary} for p in catalogue.problems()]


def _solvers() -> list[dict]:
    from hugoniot.problem.solver_kinds import available_solvers, solver_module
    return [{"solver": kind, "what": (solver_module(kind).Model.__doc__ or "").strip().splitlines()[0].removeprefix("A deck of the ")}
            for kind in available_solvers()]


def _exact() -> list[dict]:
    from hugoniot.cli.exact_report import listing
    return listing()


_ROWS = {"exact": _exact, "materials": _materials, "fields": _fields, "problems": _problems, "solvers": _solvers}
