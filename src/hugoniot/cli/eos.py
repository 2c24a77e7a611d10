"""hugoniot eos: what a material does in shocks, releases and detonations, without a mesh."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.eos_convert import convert
from hugoniot.cli.eos_detonation import cj, mixture, znd
from hugoniot.cli.eos_input import Subject, find_inert, find_material, one_state, several_states
from hugoniot.cli.eos_options import AT, CSV, HEAT, MATERIAL, MATERIALS, PLOT, POINTS
from hugoniot.cli.eos_output import cell, deliver, echo_notes, echo_states, notes, row_of, write_csv
from hugoniot.cli.eos_second_shock import second_shock
from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.errors import DeckError
from hugoniot.theory.states import States

app = typer.Typer(no_args_is_help=True, help=(
    "Hugoniots, isentropes, impedance matches and detonations without a mesh.\n\n"
    "MATERIAL is a name of the library (hugoniot material list) or a TOML file with the tables of a deck's [material.x].\n\n"
    "Example: hugoniot eos match copper aluminum --velocity \"1 km/s\""))


@app.command()
def show(material: MATERIAL, at: AT = None, as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None) -> None:
    """The law, its parameters, its state at rest and, with --at, on the Hugoniot.

    Example: hugoniot eos show copper --at "pressure = 10 GPa"
    """
    from hugoniot.laws.eos.contract import EOS
    from hugoniot.theory.isentrope import reference

    subject = find_material(material)
    par = subject.material.eos
    law = EOS.of(par)
    state = _shocked(find_inert(material), at) if at else reference(par)
    told = notes(subject, state.particle_velocity)
    if plot:
        _portrait(material, subject, state if at else None, plot)
    if as_csv:
        write_csv(as_csv, [("", state.table("gruneisen", "entropy"))])
    if as_json:
        echo_json({"material": subject.material.name, "law": law.name, "parameters": _parameters(par),
                   "references": list(law.references), **({"unreacted": True} if subject.reacted and at else {}),
                   **row_of(state.table("gruneisen", "entropy")), "warnings": told})
        return
    typer.echo(f"{subject.title or subject.material.name}: {law.name} - {law.summary}")
    echo_table(["", "", "", ""], _parameter_rows(par))
    typer.echo(f"Source of the law: {'; '.join(law.references)}")
    rest = "Products at the density and energy of the explosive" if subject.reacted else "At rest"
    on = f"On the Hugoniot{' of the unreacted explosive' if subject.reacted else ''} at {at}"
    typer.echo(f"\n{on if at else rest}:")
    echo_states(state, "gruneisen")
    echo_notes(told)


@app.command()
def hugoniot(
    materials: MATERIALS, at: AT = None, points: POINTS = 101,
    up_to: Annotated[str | None, typer.Option("--up-to", help='Last particle velocity, "3 km/s".')] = None,
    density: Annotated[str | None, typer.Option("--density", help='Initial density: porous material, "5 g/cm^3".')] = None,
    after: Annotated[str | None, typer.Option("--after", help="A first shock, as in --at; then the curve of a second.")] = None,
    reaction: Annotated[bool, typer.Option("--reaction", help="With complete reaction: the detonation Hugoniot of the products.")] = False,
    heat: HEAT = None,
    data: Annotated[list[str] | None, typer.Option("--data", help="CSV file of measured up, us for the picture, one per material.")] = None,
    kind: Annotated[str, typer.Option("--axes", help="Picture: p-up, us-up, p-v or t-p.")] = "p-up",
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """The Hugoniot, or one state of it: from rest, from a lower density (porous), from a first shock, or with reaction.

    Example: hugoniot eos hugoniot copper aluminum --plot hugoniots.png
    """
    from hugoniot.cli import eos_hugoniot

    asked = eos_hugoniot.Question(at, points, up_to, density, after, reaction, heat, data or [])
    eos_hugoniot.report(eos_hugoniot.solve_all(materials, asked), at is not None, kind, as_json, as_csv, plot)


@app.command()
def isentrope(
    materials: MATERIALS, at: AT = None, points: POINTS = 51,
    to: Annotated[str | None, typer.Option("--to", help='Pressure at the end; default that at rest, 0 for a solid ("1 bar" for products, '
                                                        '"10 GPa" without --at, "100 bar" for a gas).')] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """The isentrope through a state of the Hugoniot (--at) down to the pressure at rest, or from rest up to a pressure.

    For detonation products the start is the CJ state unless --at says otherwise. Particle velocities are those behind a release
    that runs back into the material, as below a free surface.

    Example: hugoniot eos isentrope copper --at "pressure = 50 GPa" --plot release.png
    """
    from hugoniot.theory import hugoniot as curves

    paths = []
    for name in materials:
        subject = find_material(name)
        start = _start(subject, name, at)
        paths.append((subject, start, _expansion(subject, start, to, points)))
    if plot:
        from hugoniot.plotting.eos import releases, save

        drawn = [(s.material.name, None if s.reacted else curves.curve(s.material, up_to=1.15 * max(st.particle_velocity, 1.0)),
                  states if points >= 60 else _expansion(s, st, to, 60)) for s, st, states in paths]
        save(releases(drawn), plot)
    told = [notes(s, 0.0 if s.reacted else st.particle_velocity) for s, st, _ in paths]
    if not deliver([(s.material.name, st.table("entropy")) for s, _, st in paths], as_json=as_json, as_csv=as_csv, told=told):
        return
    for (subject, start, states), said in zip(paths, told):
        typer.echo(f"{subject.title or subject.material.name}: isentrope from {cell('pressure', start.pressure)}")
        echo_states(states)
        echo_notes(said)


@app.command()
def match(
    materials: Annotated[list[str], typer.Argument(metavar="FLYER TARGET...", help="Flyer first, then the layers it meets.")],
    velocity: Annotated[str, typer.Option("--velocity", help='Velocity of the flyer, "1 km/s".')],
    error: Annotated[list[str] | None, typer.Option("--error", help='One standard deviation of an input: "velocity = 5 m/s" or '
                                                                    '"copper.c0 = 20 m/s"; as often as needed.')] = None,
    samples: Annotated[int, typer.Option("--samples", min=0, max=1000000, help="Monte Carlo samples instead of linear error bars.")] = 0,
    ring_up: Annotated[int, typer.Option("--ring-up", min=0, max=1000, help="Further meetings while the first layer rings up.")] = 0,
    thickness: Annotated[list[str] | None, typer.Option("--thickness", help="Of each layer, flyer first: follows all "
                                                                            "waves to --until; --plot draws them.")] = None,
    until: Annotated[str, typer.Option("--until", help='Last time of the wave diagram, "2 us".')] = "1 us",
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Pressures and velocities at every interface of an impact, in the order in which the waves arrive.

    Example: hugoniot eos match copper aluminum --velocity "1 km/s" --error "velocity = 5 m/s"
    """
    from hugoniot.cli import eos_match

    if len(materials) < 2:
        raise DeckError.single("command line", None, "match", "an impact needs a flyer and at least one target", "name two or more")
    if ring_up and len(materials) < 3:
        raise DeckError.single("command line", None, "--ring-up", "a layer rings between two neighbours", "name three materials or more")
    speed = quantity(velocity, "m/s", "--velocity")
    if thickness:
        if len(thickness) != len(materials):
            raise DeckError.single("command line", None, "--thickness", f"{len(thickness)} thicknesses for {len(materials)} layers",
                                   "give one of each")
        sizes = [quantity(t, "m", "--thickness") for t in thickness]
        eos_match.waves([find_inert(m) for m in materials], speed, sizes, quantity(until, "s", "--until"), as_json, as_csv, plot)
        return
    eos_match.report([find_inert(m) for m in materials], speed, error, samples, ring_up, as_json, as_csv, plot)


@app.command()
def riemann(
    left: Annotated[str, typer.Argument(metavar="LEFT", help="Material on the left.")],
    right: Annotated[str, typer.Argument(metavar="RIGHT", help="Material on the right.")],
    left_state: Annotated[str, typer.Option("--left", help='"pressure = 1 GPa, velocity = 100 m/s"; default at rest.')] = "",
    right_state: Annotated[str, typer.Option("--right", help="As --left.")] = "",
    bonded: Annotated[bool, typer.Option("--bonded", help="The contact bears tension.")] = False,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """The exact Riemann problem of two materials: waves, contact or vacuum.

    Example: hugoniot eos riemann copper water --left "velocity = 500 m/s"
    """
    from hugoniot.theory.isentrope import state
    from hugoniot.theory.riemann import riemann as solve

    subjects = [find_material(left), find_material(right)]
    given = [several_states(text, option) if text else {} for text, option in ((left_state, "--left"), (right_state, "--right"))]
    states = [state(s.material, g.pop("velocity", 0.0), **g) for s, g in zip(subjects, given)]
    found = solve(subjects[0].material, states[0], subjects[1].material, states[1], bonded=bonded)
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import riemann_waves

        save(riemann_waves((subjects[0].material.name, subjects[1].material.name), found, (states[0], states[1])), plot)
    jumps = [abs(found.velocity - s.particle_velocity) if w.kind == "shock" else 0.0 for s, w in zip(states, (found.left, found.right))]
    told = list(dict.fromkeys(text for s, jump in zip(subjects, jumps) for text in notes(s, jump)))
    waves = {side: {"wave": w.kind, "head": w.head, "tail": w.tail, **row_of(w.behind.table())}
             for side, w in (("left", found.left), ("right", found.right)) if w.behind.density > 0.0}
    if as_csv:
        write_csv(as_csv, [(s.material.name, w.behind.table()) for s, w in zip(subjects, (found.left, found.right))
                           if w.behind.density > 0.0])
    if as_json:
        echo_json({"pressure": found.pressure, "particle_velocity": found.velocity, "vacuum": found.vacuum, **waves,
                   "edges": [{"what": what, "velocity": v} for what, v in found.jumps], "warnings": told})
        return
    contact = f"contact: {cell('pressure', found.pressure)}, {cell('particle_velocity', found.velocity)}"
    typer.echo("a gap opens between the two" if found.vacuum else contact)
    echo_table(["edge", "velocity"], [(what, f"{v:.6g} m/s") for what, v in found.jumps])
    for side, wave in (("left", found.left), ("right", found.right)):
        if wave.behind.density > 0.0:
            typer.echo(f"\n{side}, behind the {wave.kind if wave.kind != 'none' else 'undisturbed edge'}:")
            echo_states(wave.behind)
    echo_notes(told)


app.command()(cj)
app.command()(znd)
app.command()(mixture)
app.command("second-shock")(second_shock)
app.command()(convert)


@app.command()
def fit(
    points: Annotated[str, typer.Argument(metavar="POINTS", help="A CSV file with columns up and us, or a material of the library.")],
    quadratic: Annotated[bool, typer.Option("--quadratic", help="Fit Us = c0 + s up + s2 up^2.")] = False,
    least: Annotated[str | None, typer.Option("--from", help="Ignore points of lower particle velocity.")] = None,
    highest: Annotated[str | None, typer.Option("--to", help="Ignore points of higher particle velocity.")] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Fit shock velocity against particle velocity, with standard deviations and the range of the points.

    Example: hugoniot eos fit shots.csv --quadratic --plot fit.png
    """
    from hugoniot.cli import eos_fit

    eos_fit.report(points, 2 if quadratic else 1, quantity(least, "m/s", "--from") if least else 0.0,
                   quantity(highest, "m/s", "--to") if highest else float("inf"), as_json, as_csv, plot)


@app.command("fit-jwl")
def fit_jwl(
    curve: Annotated[str, typer.Argument(metavar="CURVE", help="A CSV file of the expansion: columns volume (V = v/v0) and pressure.")],
    density: Annotated[str, typer.Option("--density", help='Of the explosive, "1.717 g/cm^3".')],
    velocity: Annotated[str, typer.Option("--velocity", help='Detonation velocity, "7.98 km/s".')],
    pressure: Annotated[str, typer.Option("--pressure", help='CJ pressure, "29.5 GPa".')],
    energy: Annotated[str, typer.Option("--energy", help='E0 per volume of explosive, "8.5 GJ/m^3" or "85 kbar".')],
    omega: Annotated[float | None, typer.Option("--omega", help="Keep this omega instead of fitting it.")] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """JWL constants from a CJ state, which is kept exactly, and points of the expansion below it.

    Example: hugoniot eos fit-jwl cylinder.csv --density "1.717 g/cm^3" --velocity "7.98 km/s" --pressure "29.5 GPa" --energy "8.5 GPa"
    """
    from hugoniot.cli import eos_fit

    eos_fit.jwl(curve, density, velocity, pressure, energy, omega, as_json, as_csv, plot)


@app.command("fit-gamma")
def fit_gamma(
    material: MATERIAL, at: Annotated[str, typer.Option("--at", help='The shock state to meet, "particle_velocity = 500 m/s".')],
    ambient: Annotated[str, typer.Option("--ambient", help="Pressure ahead of the shock.")] = "1 atm", as_json: JSON = False,
) -> None:
    """The Grüneisen parameter with which a truncated (third-order) law passes through a shock state.

    Example: hugoniot eos fit-gamma copper --at "particle_velocity = 500 m/s"
    """
    from hugoniot.cli import eos_fit

    eos_fit.gamma(find_inert(material), at, quantity(ambient, "Pa", "--ambient"), as_json)


@app.command()
def table(
    material: MATERIAL,
    densities: Annotated[str, typer.Option("--densities", help='Range, "8 g/cm^3, 14 g/cm^3"; default 0.9 to 1.5 of rest.')] = "",
    temperatures: Annotated[str, typer.Option("--temperatures", help='Range of temperature, "200 K, 3000 K", with the one at rest '
                                                                     'inside.')] = "200 K, 3000 K",
    points: Annotated[int, typer.Option("--points", min=2, max=1000, help="Values of each.")] = 21,
    as_json: JSON = False, as_csv: CSV = None,
    hdf5: Annotated[Path | None, typer.Option("--hdf5", help="Write the grid to this HDF5 file.")] = None, plot: PLOT = None,
) -> None:
    """Tabulate p and e over density and temperature, for codes that read tables.

    A deck reads the file back: [material.x.eos] law = "table", file = "copper.csv".

    Example: hugoniot eos table copper --points 50 --csv copper.csv
    """
    from hugoniot.cli import eos_table

    eos_table.report(find_material(material), densities, temperatures, points, as_json, as_csv, hdf5, plot)


# -- shared ------------------------------------------------------------------------------------------------------
def _parameters(par) -> dict:
    """Parameters that have a value; a law inside another one is a table of its own, with its name as `law`."""
    from hugoniot.laws.eos.contract import EOS

    found = {}
    for name, value in zip(par._fields, par):
        if EOS.knows(value):
            found[name] = {"law": EOS.of(value).name, **_parameters(value)}
        elif getattr(value, "ndim", 0) or isinstance(value, (int, float)) and value == value:
            found[name] = value
    return found


def _parameter_rows(par, indent: str = "  ") -> list[tuple[str, str, str, str]]:
    """Name, value, unit and meaning of each, those of a law inside indented below it; of a table its extent."""
    from hugoniot.laws.eos.contract import EOS

    law, rows = EOS.of(par), []
    for name, value in zip(par._fields, par):
        told = f"{indent}{name}", law.units.get(name, ""), law.meaning.get(name, "")
        if EOS.knows(value):
            rows += [(told[0], EOS.of(value).name, "", told[2]), *_parameter_rows(value, indent + "  ")]
        elif getattr(value, "ndim", 0):
            rows.append((told[0], f"{' x '.join(str(n) for n in value.shape)} values, {value.min():.5g} to {value.max():.5g}", *told[1:]))
        elif isinstance(value, (int, float)) and value == value:
            rows.append((told[0], cell("", value), *told[1:]))
    return rows


def _shocked(subject: Subject, at: str) -> States:
    from hugoniot.theory.hugoniot import shock

    return shock(subject.material, **one_state(at))


def _portrait(name: str, subject: Subject, state: States | None, path) -> None:
    """The picture of `show`: the planes of the field, or the detonation of products that have no unreacted explosive."""
    from hugoniot.cli.eos_fit import library_points
    from hugoniot.plotting.eos import detonations, save

    if subject.reacted and (state is None or subject.unreacted is None):
        from hugoniot.theory.chapman_jouguet import cj as tangency

        save(detonations([(subject.material.name, tangency(subject.material))]), path)
        return
    from hugoniot.plotting.waves import portrait

    inert = find_inert(name)
    save(portrait(inert.material.name, inert.material, state, library_points(inert.names)), path)


def _expansion(subject: Subject, start: States, to: str | None, points: int) -> States:
    """States along the isentrope from `start` to the pressure `to`: a release of crushed pores is elastic, products fall by factors."""
    import numpy as np

    from hugoniot.theory.isentrope import isentrope as trace
    from hugoniot.theory.isentrope import reference, release

    rest = max(float(reference(subject.material).pressure), 0.0)
    falls = start.pressure > rest * (1.0 + 1e-9)
    gas = rest > 1e3 and not subject.reacted
    default = (1e5 if subject.reacted else rest if gas else 0.0) if falls else 1e7 if gas else 1e10
    end = quantity(to, "Pa", "--to") if to else default
    if end <= start.pressure and not subject.reacted:
        release(subject.material, start, end)       # an end out of reach is refused by its own number, not by one on the way
        return release(subject.material, start, end, points=points)
    by_factors = (subject.reacted or gas) and end > 0.0
    span = np.geomspace(start.pressure, end, points) if by_factors else np.linspace(start.pressure, end, points)
    return trace(subject.material, start, pressure=span, direction=-1)


def _start(subject: Subject, name: str, at: str | None) -> States:
    """Where an isentrope begins: a state of the Hugoniot, the CJ state of products, or rest."""
    from hugoniot.theory.isentrope import reference

    if subject.reacted:
        from hugoniot.theory.chapman_jouguet import cj as tangency
        from hugoniot.theory.chapman_jouguet import overdriven

        return overdriven(subject.material, **one_state(at)) if at else tangency(subject.material).state
    return _shocked(subject, at) if at else reference(subject.material)
