"""`hugoniot verify`: the standard problems against their exact answers and limits."""

import math
from dataclasses import asdict
from typing import Annotated

import typer

from hugoniot.cli.show import echo_json
from hugoniot.errors import DeckError

INTEGRATORS = ("compatible", "wilkins")
SOLVERS = ("lagrange1d", "fronts")
FEWEST_ZONES = 10


def verify(
    problems: Annotated[list[str] | None, typer.Argument(help="Names of standard problems (default: all).")] = None,
    zones: Annotated[list[int] | None, typer.Option("--zones", "-n", help="Number of zones, instead of the standard meshes; "
        "repeatable.")] = None,
    integrator: Annotated[str, typer.Option(help="Integrator of lagrange1d: compatible or wilkins.")] = "compatible",
    solver: Annotated[str, typer.Option(help='Solver: lagrange1d, or fronts with mode = "cells".')] = "lagrange1d",
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON instead of tables.")] = False,
) -> None:
    """Run the built-in standard problems and print the errors, their limits, and the observed order of convergence.

    Each error is compared with two limits: the goal of this package, and the error of other codes on the same mesh (in one dimension the
    code KO and a second-order Godunov scheme, in two dimensions the best open code). With --zones or --integrator, problems in two
    dimensions and problems for the solver fronts are run only if they are named.

    Example: hugoniot verify sod noh_planar
    """
    from hugoniot.campaign.verify import FRONTS, LINE, PROBLEMS, TRACKED, verify_problem
    from hugoniot.materials.collect import nearest, printable

    if integrator not in INTEGRATORS:
        unknown = f"unknown integrator '{printable(integrator)}'"
        raise DeckError.single("verify", None, "--integrator", unknown, nearest(integrator, INTEGRATORS))
    for name in problems or ():
        if name not in PROBLEMS:
            alike = [problem for problem in PROBLEMS if name and name in problem]
            hint = f"known: {', '.join(alike)}" if alike else nearest(name, PROBLEMS, f"known: {', '.join(PROBLEMS)}")
            raise DeckError.single("verify", None, "problem", f"unknown problem '{printable(name)}'", hint)
    if few := [n for n in zones or () if n < FEWEST_ZONES]:
        raise DeckError.single("verify", None, "--zones", f"{few[0]} zones are too few", f"use {FEWEST_ZONES} or more")
    if solver not in SOLVERS:
        raise DeckError.single("verify", None, "--solver", f"unknown solver '{printable(solver)}'", nearest(solver, SOLVERS))
    if solver == FRONTS and integrator != "compatible":
        raise DeckError.single("verify", None, "--integrator", "does not apply to the fronts solver", "leave out --integrator or --solver")
    if solver == FRONTS:
        names = problems or [*LINE, *(() if zones else TRACKED)]
    else:
        names = problems or list(LINE if zones or integrator != "compatible" else PROBLEMS)
    if solver == FRONTS:
        names, integrator = _taken_by_fronts(names, bool(problems)), FRONTS
    results = []
    for name in names:
        found = verify_problem(name, zones or None, integrator)
        results.append(found)
        if not as_json:
            _show(found)
    if as_json:
        rows = [{"problem": r.problem.name, "orders": r.orders, "seconds": r.seconds, "energy_error": r.energy_error,
                 "momentum_error": r.momentum_error, "measures": [asdict(j) for j in r.judged]} for r in results]
        echo_json(rows)
    else:
        _total(results)


def _taken_by_fronts(names: list[str], asked: bool) -> list[str]:
    """The problems that tracked fronts take; one that was asked for by name and is not among them is refused, others are named."""
    from hugoniot.campaign.tracked import beyond_fronts
    from hugoniot.campaign.verify import LINE, PLANE

    taken = []
    for name in names:
        why = beyond_fronts(LINE.get(name)) if name in LINE or name in PLANE else ""
        if why and asked:
            raise DeckError.single("verify", None, "problem", f"'{name}': {why}", "leave out --solver")
        if why:
            typer.echo(f"left out: {name}: {why}", err=True)
        else:
            taken.append(name)
    return taken


def _mark(value, beaten):
    return "" if value is None else f"{value:.3g} " + ("[green]met[/green]" if beaten else "[yellow]missed[/yellow]")


def _show(found) -> None:
    from rich.console import Console
    from rich.table import Table

    orders = ", ".join(f"{key} {slope:.2f}" for key, slope in found.orders.items())
    orders = f"order: {orders}; " if orders else ""
    momentum = "" if math.isnan(found.momentum_error) else f", momentum to {found.momentum_error:.1e}"
    table = Table(title=f"{found.problem.name}: {found.problem.description}", title_justify="left",
                  caption=f"{orders}energy closed to {found.energy_error:.1e}{momentum}; {found.seconds:.1f} s", caption_justify="left")
    peers = any(j.peer is not None for j in found.judged)
    for head in ("measure", "zones", "value", *(("open codes",) if peers else ("KO", "G2")), "goal"):
        table.add_column(head, justify="left" if head == "measure" else "right", no_wrap=head == "measure")
    for j in found.judged:
        table.add_row(j.measure, str(j.zones), f"{j.value:.4g}",
                      *(_mark(limit, j.beats(limit)) for limit in (*((j.peer,) if peers else (j.ko, j.g2)), j.goal)))
    Console().print(table)


def _total(results) -> None:
    """One line per problem, and the sums."""
    from hugoniot.cli.show import echo_table

    def met(judged, name):
        marks = [j.beats(getattr(j, name)) for j in judged if getattr(j, name) is not None]
        return f"{sum(marks)} of {len(marks)}" if marks else "-"

    typer.echo("")
    names = {"ko": "KO", "g2": "second-order Godunov", "peer": "open codes", "goal": "goals"}
    rows = [(r.problem.name, *(met(r.judged, name) for name in names), f"{r.energy_error:.1e}",
             f"{r.seconds:.{0 if r.seconds >= 100.0 else 1}f} s") for r in results]
    echo_table(["", "", "second-order", "open", "", "energy", ""],      # two lines of heads, in 80 columns
               [("problem", "KO", "Godunov", "codes", "goals", "error", "time"), *rows])
    counts = {}
    for name in names:
        marks = [j.beats(getattr(j, name)) for r in results for j in r.judged if getattr(j, name) is not None]
        counts[name] = f"{sum(marks)} of {len(marks)}"
    told = [f"{words} {counts[name]}" for name, words in names.items()]
    typer.echo(f"limits met: {', '.join(told[:2])},\n            {', '.join(told[2:])}")
