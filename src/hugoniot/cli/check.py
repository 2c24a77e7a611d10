"""hugoniot check: reads a deck without running it."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, MATERIALS, SET, echo_json, echo_table, overrides_of
from hugoniot.errors import DeckError, NoSolution, OutOfRange
from hugoniot.materials import burning
from hugoniot.materials.reach import reach
from hugoniot.materials.validity import range_of
from hugoniot.problem.cost import estimate
from hugoniot.problem.deck import Deck, read_deck
from hugoniot.units import format_si


def command(
    deck: Annotated[Path, typer.Argument(help="The deck, a TOML file.", readable=False)],
    setting: SET = None,
    materials: MATERIALS = None,
    resolved: Annotated[bool, typer.Option("--resolved", help="Print the deck with every default written out and all numbers in "
        "SI.")] = False,
    as_json: JSON = False,
) -> None:
    """Report all errors and warnings in a deck.

    Example: hugoniot check flyer.toml
    """
    try:
        found = read_deck(deck, overrides_of(setting), materials or ())
        _require_shock(found.problem, str(deck))
    except DeckError as error:
        if as_json:
            number = {"count": len(error.problems) + error.more, "at_least": error.at_least}
            echo_json({"ok": False, **number, "problems": [vars(p) for p in error.problems]})
            raise typer.Exit(error.exit_code) from None
        raise
    warnings = [*found.warnings, *_echoes(found.problem)]
    if as_json:
        cost = estimate(found.problem)._asdict()
        ranges = {name: {"up_to": m.valid_up_to, "estimated_up_to": None if (end := range_of(m)).stated else end.up, "words": reach(m)}
                  for name, m in found.problem.materials.items()}
        echo_json({"ok": True, "warnings": warnings, "ranges": ranges, "estimate": cost, "resolved": found.resolved})
    elif resolved:
        typer.echo(found.resolved, nl=False)
    else:
        _tell(found, warnings)


def _echoes(problem) -> list[str]:
    """Warnings of transmitting ends that strong waves will reach."""
    if problem.solver.kind != "lagrange1d" or "transmitting" not in (problem.left.kind, problem.right.kind):
        return []
    from hugoniot.diagnostics.transmitting import expected

    return expected(problem)


def _require_shock(problem, name: str) -> None:
    """Raise `DeckError` where the shock that a deck asks to resolve does not exist in its law, or does not fit into its domain."""
    if problem.solver.kind != "shock_structure":
        return
    from hugoniot.problem.structure_start import shock_start

    try:
        shock_start(problem)
    except (OutOfRange, NoSolution) as error:
        raise DeckError.single(name, None, "solver.shock", str(error)) from None


def _tell(deck: Deck, warnings: list[str]) -> None:
    problem = deck.problem
    typer.echo(f"{problem.title}: {getattr(problem, 'geometry', problem.solver.kind)}, until {format_si(problem.stop_time, 's')}")
    rows = []
    for region in getattr(problem, "regions", ()):
        extent = _block_extent(problem, region) if hasattr(region, "shape") else (
            f"{format_si(region.start, 'm')} to {format_si(region.end, 'm')}", f"{region.zones} zones", _speed(region))
        rows.append((region.name, *extent, region.material, _laws(problem.materials[region.material])))
    echo_table(["region", "extent", "", "velocity", "material", "laws"], rows)
    cost = estimate(problem)
    typer.echo(f"{cost.zones} zones, {cost.snapshots} snapshots: about {_bytes(cost.memory)} of memory, "
               f"result.h5 about {_bytes(cost.result)} not counting gauges (twice that on disk until the run ends)")
    for name, material in problem.materials.items():
        typer.echo(f"range of the data of {name}: {reach(material)}")
    for warning in warnings:
        typer.echo(f"warning: {warning}")
    typer.echo("the deck is valid")


def _block_extent(problem, block) -> tuple[str, str, str]:
    """Extent, zones and velocity of a block, in words."""
    part = problem.mesh.blocks[problem.blocks.index(block)]
    spans = [f"{axis} {format_si(float(values.min()), 'm')} to {format_si(float(values.max()), 'm')}"
             for axis, values in zip(problem.axes, (part.x, part.y))]
    uniform = block.velocity == type(block.velocity)(base=block.velocity.base)
    speed = ", ".join(format_si(v, "m/s") for v in block.velocity.base) if uniform else "a field"
    return ", ".join(spans), f"{part.ni} x {part.nj} " + ("zones" if part.per_cell == 1 else "cells of two triangles"), speed


def _bytes(count: float) -> str:
    for size, unit in ((1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if count >= size:
            return f"{count / size:.{3 if count >= 100.0 * size else 2}g} {unit}"
    return f"{count:g} bytes"


def _laws(material) -> str:
    """The laws of a material in a run; of a burning one what each is to it: equation of state before and after, closure, rate."""
    laws = material.laws()
    if material.burn is None:
        laws.pop("unreacted", None)
        return ", ".join(laws.values())
    before = f"{laws['unreacted']} burning to " if burning.has_reactants(material) else ""
    return f"{before}{laws['eos']}, {burning.closure(material)}, {laws['burn']}"


def _speed(region) -> str:
    velocity, profile = region.velocity, getattr(region, "profile", None)
    if profile is not None and "velocity" in dict(profile.fields):
        return "profile"
    if isinstance(velocity, tuple):
        return " to ".join(format_si(v, "m/s") for v in velocity)
    return format_si(velocity, "m/s")
