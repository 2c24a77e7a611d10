"""hugoniot eos lines, gurney: Rayleigh and Fanno lines of a shock; metal driven by the explosives of the library."""

from typing import Annotated, Any

import numpy as np
import typer

from hugoniot.cli.eos.input import find_inert, one_state
from hugoniot.cli.eos.options import CSV, MATERIAL, PLOT
from hugoniot.cli.eos.output import deliver, echo_columns, echo_notes, notes
from hugoniot.cli.eos.splits import split_notes
from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.errors import DeckError

FASTEST = 1e5      # m/s: 5 GJ/kg, a thousand explosives
SLOW = 100.0       # m/s: slower than any; a number whose unit was forgotten
SHAPES = ("open", "symmetric", "cylinder", "sphere")
TAMPED = ("asymmetric", "tamper")


def lines(
    material: MATERIAL, at: Annotated[str, typer.Option("--at", help='The shock, such as "particle_velocity = 858 m/s".')],
    points: Annotated[int, typer.Option("--points", min=3, max=10000, help="Number of states along each line.")] = 41,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute Rayleigh and Fanno lines of a shock.

    The Rayleigh line (mass and momentum), the Fanno line (mass and energy) and the Hugoniot meet at the two states of the shock.

    Example: hugoniot eos lines copper --at "particle_velocity = 1 km/s" --plot lines.png
    """
    from hugoniot.theory.shock_lines import shock_lines

    subject = find_inert(material)
    found = shock_lines(subject.material, points=points, **one_state(at))
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import shock_lines_picture

        save(shock_lines_picture(subject.material.name, found), plot)
    told = [*split_notes(subject.material, found.behind), *notes(subject, float(found.behind.particle_velocity))]
    if not deliver([(subject.material.name, found.table())], as_json=as_json, as_csv=as_csv, told=[told]):
        return
    typer.echo(f"{subject.title or subject.material.name}: shock of {float(found.behind.shock_velocity):.6g} m/s to "
               f"{float(found.behind.density):.6g} kg/m3, {float(found.behind.pressure) * 1e-9:.6g} GPa")
    echo_columns(found.table())
    echo_notes(told)


def gurney(
    explosives: Annotated[list[str] | None, typer.Argument(
        metavar="EXPLOSIVE", help="Explosives of the library (default: all). Their Gurney velocities are tabulated or derived "
        "from the products.")] = None,
    ratio: Annotated[str, typer.Option("--ratio", help="Ratio of metal mass to explosive mass, or several separated by commas.")] = "1",
    tamper: Annotated[str | None, typer.Option("--tamper", help="Ratio of tamper mass to explosive mass, for the asymmetric "
        "sandwich.")] = None,
    velocity: Annotated[str | None, typer.Option("--velocity", help='Gurney velocity sqrt(2E), such as "2.7 km/s", instead of an '
        'explosive.')] = None,
    as_json: JSON = False,
) -> None:
    """Compute metal velocities by Gurney's formulas.

    The geometries are open, symmetric and asymmetric sandwich, cylinder and sphere.

    Example: hugoniot eos gurney pbx9404 petn --ratio "0.5, 1, 2"
    """
    from hugoniot.dossier.gurney import GurneyVelocity, gurney_velocities
    from hugoniot.theory.exact.plate_push import asymmetric_sandwich
    from hugoniot.theory.exact.plate_push import gurney as metal_velocity

    ratios = [quantity(part.strip(), "1", "--ratio") for part in ratio.split(",")]
    behind = None if tamper is None else quantity(tamper, "1", "--tamper")
    if velocity is not None:
        if explosives:
            raise DeckError.single("command line", None, "--velocity", "cannot be combined with named explosives", "give one or the other")
        speed = quantity(velocity, "m/s", "--velocity")
        if not 0.0 < speed < FASTEST:
            raise DeckError.single("command line", None, "--velocity", f"{speed:g} m/s is not a valid Gurney "
                                                                       "velocity", 'write it like "2.7 km/s"')
        known = [GurneyVelocity("given", speed, "command line", False)]
    else:
        known = gurney_velocities(explosives or [])
    rows: list[dict[str, Any]] = []
    for name, speed, source, derived, marks in known:
        for m in ratios:
            row = {"explosive": name, "gurney_velocity": speed, "derived": derived, "source": source, "marks": list(marks), "mass_ratio": m,
                   **{shape: metal_velocity(shape, m, speed) for shape in SHAPES}}
            if behind is not None:
                row |= {"tamper_ratio": behind, **dict(zip(TAMPED, asymmetric_sandwich(m, behind, speed)))}
            rows.append(row)
    if as_json:
        echo_json(rows)
        return
    shapes = (*SHAPES, *(TAMPED if behind is not None else ()))
    echo_table(["explosive", "sqrt(2E), m/s", "", "M/C", *(f"{shape}, m/s" for shape in shapes)],
               [(r["explosive"], f"{r['gurney_velocity']:.0f}", "derived" if r["derived"] else "", f"{r['mass_ratio']:g}",
                 *(f"{r[shape]:.1f}" for shape in shapes)) for r in rows])
    told = {f"{'' if r['derived'] else 'source of the '}Gurney velocities{',' if r['derived'] else ':'} {r['source']}" for r in rows}
    told |= {mark for r in rows for mark in r["marks"]}
    if velocity is not None and speed < SLOW:
        told.add(f"a Gurney velocity of {speed:g} m/s? A bare number is SI; write \"{speed:g} km/s\" if that is what you mean")
    if behind is not None:
        told.add(f"asymmetric: a plate of M/C and, on the other side, a tamper of N/C = {behind:g}; both velocities are outward")
    echo_notes(sorted(told | {"the metal velocities are accurate to about 10 %"}))
    if np.max(ratios) > 10.0 or np.min(ratios) < 0.1:
        echo_notes(["Gurney's velocity profile has been tested for M/C between 0.1 and 10"])
