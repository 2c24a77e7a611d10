"""hugoniot eos second-shock: how far a second shock strays from the principal Hugoniot (Wilkins A.1 to A.4)."""

from typing import Annotated

import typer

from hugoniot.cli.eos.options import CSV, PLOT
from hugoniot.cli.show import JSON


def second_shock(
    material: Annotated[str, typer.Argument(metavar="MATERIAL", help="Material whose reference state gives a, b and c (bulk "
        "modulus, curvature of the Hugoniot, Gamma).")] = "",
    a: Annotated[str | None, typer.Option("--a", help='Constant a (default without MATERIAL: "0.73 Mbar").')] = None,
    b: Annotated[str | None, typer.Option("--b", help='Constant b (default without MATERIAL: "1.72 Mbar").')] = None,
    c: Annotated[float | None, typer.Option("--c", help="Constant c, dimensionless (default without MATERIAL: 1.60, "
        "which the source prints as 1.60 Mbar).")] = None,
    first: Annotated[float, typer.Option("--first", help="Compression mu = rho/rho0 - 1 behind the first shock.")] = 0.1,
    mu: Annotated[str, typer.Option("--mu", help='Compressions mu of the table, such as "0.15, 0.2, 0.25" (default: 11 values up to '
        '2.5 times --first).')] = "",
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compare principal and second-shock Hugoniots.

    The law is Wilkins' quadratic law p = a mu + b mu^2 + c (1 + mu) E, with mu = rho/rho0 - 1 and the energy E per reference volume.
    Both curves are computed exactly and as series, with the leading difference between them.

    Example: hugoniot eos second-shock copper --first 0.1 --plot second.png
    """
    import numpy as np

    from hugoniot.cli.eos.input import find_inert
    from hugoniot.cli.eos.output import cell, deliver, echo_columns, echo_notes, notes
    from hugoniot.cli.show import quantity
    from hugoniot.errors import DeckError
    from hugoniot.theory import second_shock as tool

    told: list[str] = []
    if material:
        subject = find_inert(material)
        law, density, name, told = *tool.of_material(subject.material), subject.material.name, notes(subject)
    else:
        law, density, name = tool.Quadratic(0.73e11, 1.72e11, 1.60), None, "quadratic law"
    law = tool.Quadratic(quantity(a, "Pa", "--a") if a else law.a, quantity(b, "Pa", "--b") if b else law.b, law.c if c is None else c)
    if not (law.a > 0.0 and law.c > 0.0 and first > 0.0):
        raise DeckError.single("command line", None, "second-shock", "a, c and the first compression must be positive",
                               f"got a = {law.a:g} Pa, c = {law.c:g}, mu = {first:g}")
    ahead = np.array([quantity(part.strip(), "1", "--mu") for part in mu.split(",")]) if mu else np.linspace(first, 2.5 * first, 11)
    table = {"compression": ahead, **({"density": density * (1.0 + ahead)} if density else {}),
             **tool.comparison(ahead, first, law)}
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import second_shocks

        save(second_shocks(name, law, first, max(float(ahead.max()), 1.5 * first)), plot)
    more = [{"a": law.a, "b": law.b, "c": law.c, "first_compression": first}]
    if not deliver([(name, table)], as_json=as_json, as_csv=as_csv, told=[told], more=more):
        return
    typer.echo(f"{name}: a = {cell('pressure', law.a)}, b = {cell('pressure', law.b)}, c = {law.c:.6g}; first shock to mu = {first:g}, "
               f"{cell('pressure', float(tool.principal(first, law)))}")
    echo_columns(table)
    typer.echo("Wilkins A.1: principal, A.2: its cubic, A.3: second shock, A.4: its series (corrected); "
               "difference A.3 - A.1 and its leading term")
    echo_notes(told)
