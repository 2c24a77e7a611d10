"""hugoniot eos: what a material does in shocks, releases and detonations, without a mesh."""

from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.eos.convert import convert
from hugoniot.cli.eos.detonation import cj, mixture, znd
from hugoniot.cli.eos.input import find_inert, find_material
from hugoniot.cli.eos.lines import gurney, lines
from hugoniot.cli.eos.options import AT, CSV, HEAT, MATERIAL, MATERIALS, PLOT, POINTS
from hugoniot.cli.eos.second_shock import second_shock
from hugoniot.cli.eos.sesame import sesame
from hugoniot.cli.eos.stability import stability
from hugoniot.cli.show import JSON, quantity
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError

app = typer.Typer(no_args_is_help=True, help=(
    "Compute Hugoniots, isentropes, impedance matches and detonations, without a simulation.\n\n"
    "A material is given by its name in the library (hugoniot material list) or by a TOML file with the tables of a deck's "
        "[material.NAME].\n\n"
    "Example: hugoniot eos match copper aluminum --velocity \"1 km/s\""))


@app.command()
def show(material: MATERIAL, at: AT = None, as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None) -> None:
    """Show a law, its parameters and a state.

    The state is the reference state or, with --at, a state on its Hugoniot.

    Example: hugoniot eos show copper --at "pressure = 10 GPa"
    """
    from hugoniot.cli.eos import show as eos_show

    eos_show.report(material, at, as_json, as_csv, plot)


@app.command()
def hugoniot(
    materials: MATERIALS, at: AT = None, points: POINTS = 101,
    up_to: Annotated[str | None, typer.Option("--up-to", help='Particle velocity at which the curve ends, such as "3 km/s".')] = None,
    density: Annotated[str | None, typer.Option("--density", help='Initial density of a porous material, such as "5 g/cm^3".')] = None,
    after: Annotated[str | None, typer.Option("--after", help="State behind a first shock, in the form of --at; the curve is then "
        "that of a second shock.")] = None,
    reaction: Annotated[bool, typer.Option("--reaction", help="Assume complete reaction behind the shock.")] = False,
    heat: HEAT = None,
    data: Annotated[list[str] | None, typer.Option("--data", help="CSV file of measured points (columns up and us) to draw in the "
        "picture; repeatable, one per material.")] = None,
    kind: Annotated[str, typer.Option("--axes", help="Axes of the picture: p-up, us-up, p-v or t-p.")] = "p-up",
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute a Hugoniot, or one state of it.

    It starts from the reference state, from a lower density (--density), or behind a first shock (--after). With --reaction it is the
    detonation Hugoniot of the products.

    Example: hugoniot eos hugoniot copper aluminum --plot hugoniots.png
    """
    from hugoniot.cli.eos import hugoniot as eos_hugoniot

    if data and (plot is None or kind not in ("us-up", "p-up")):
        raise DeckError.single("command line", None, "--data", "measured points are drawn in pictures of the axes us-up and p-up only",
                               "add --plot, and --axes us-up or p-up")
    if at is not None:
        refuse_idle("with --at, which gives one state", "--points", "--up-to")
    if plot is None:
        refuse_idle("without --plot", "--axes")
    asked = eos_hugoniot.Question(at, points, up_to, density, after, reaction, heat, data or [])
    eos_hugoniot.report(eos_hugoniot.solve_all(materials, asked), at is not None, kind, as_json, as_csv, plot)


@app.command()
def isentrope(
    materials: MATERIALS, at: AT = None, points: POINTS = 51,
    to: Annotated[str | None, typer.Option("--to", help='Final pressure (default: with --at, 0 for a solid, "1 bar" for products, '
        'and for others the pressure of the reference state; without --at, "10 GPa", or "100 bar" for a gas).')] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute an isentrope or a release.

    With --at the isentrope runs from that state of the Hugoniot down to the pressure --to. Without --at it runs from the reference
    state up to that pressure.

    For detonation products it starts at the CJ state unless --at gives another. Particle velocities are those behind a release wave
    that runs back into the material, as from a free surface.

    Example: hugoniot eos isentrope copper --at "pressure = 50 GPa" --plot release.png
    """
    from hugoniot.cli.eos import isentrope as eos_isentrope

    eos_isentrope.report(materials, at, points, to, as_json, as_csv, plot)


@app.command()
def match(
    materials: Annotated[list[str], typer.Argument(metavar="FLYER TARGET", help="Materials of the flyer and of the layers that "
        "it hits, in order.")],
    velocity: Annotated[str, typer.Option("--velocity", help='Velocity of the flyer, such as "1 km/s".')],
    error: Annotated[list[str] | None, typer.Option("--error", help='Standard deviation of an input, such as "velocity = 5 m/s" or '
        '"copper.c0 = 20 m/s", or "library" for the covariances of fits in the library; repeatable.')] = None,
    samples: Annotated[int, typer.Option("--samples", min=0, max=1000000, help="Number of Monte Carlo samples; 0: linear error "
        "propagation.")] = 0,
    ring_up: Annotated[int, typer.Option("--ring-up", min=0, max=1000, help="Number of further reverberations in the first target "
        "to compute.")] = 0,
    thickness: Annotated[list[str] | None, typer.Option("--thickness", help='Thickness of a layer, such as "2 mm", repeated for '
        "each layer, flyer first; all waves are then followed up to --until.")] = None,
    until: Annotated[str | None, typer.Option("--until", help='With --thickness: time up to which waves are followed (default: '
        '"1 us").')] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Solve the impedance match of an impact.

    Prints pressures and velocities at every interface, in the order in which the first shock reaches them.

    Example: hugoniot eos match copper aluminum --velocity "1 km/s" --error "velocity = 5 m/s"
    """
    from hugoniot.cli.eos import match as eos_match

    if len(materials) < 2:
        raise DeckError.single("command line", None, "match", "an impact needs a flyer and at least one target",
                               "name two materials or more")
    if ring_up and len(materials) < 3:
        raise DeckError.single("command line", None, "--ring-up", "--ring-up needs a layer between two "
                                                                  "others", "name three materials or more")
    if len(materials) > 3 and ring_up:
        raise DeckError.single("command line", None, "--ring-up", "the first target reverberates between two neighbours, which are "
                               f"taken as semi-infinite, so that {', '.join(materials[3:])} would have no effect",
                               "name three materials, or follow all waves with --thickness")
    if samples and not error:
        raise DeckError.single("command line", None, "--samples", "no input is uncertain", 'add --error "velocity = 5 m/s"')
    if until is not None and not thickness:
        raise DeckError.single("command line", None, "--until", "waves are followed in time only if the thicknesses are known",
                               "add --thickness for each layer")
    speed = quantity(velocity, "m/s", "--velocity")
    if thickness:
        if error or ring_up:
            raise DeckError.single("command line", None, "--error" if error else "--ring-up",
                                   "is not supported with --thickness" if error else "--thickness already follows all reverberations",
                                   "omit it, or omit --thickness")
        if len(thickness) != len(materials):
            given = f"{len(thickness)} thickness{'' if len(thickness) == 1 else 'es'}"
            raise DeckError.single("command line", None, "--thickness", f"{given} for {len(materials)} layers", "give one for each layer")
        sizes = [quantity(t, "m", "--thickness") for t in thickness]
        eos_match.waves([find_inert(m) for m in materials], speed, sizes, quantity(until or "1 us", "s", "--until"), as_json, as_csv, plot)
        return
    eos_match.report([find_inert(m) for m in materials], speed, error, samples, ring_up, as_json, as_csv, plot)


@app.command()
def riemann(
    left: Annotated[str, typer.Argument(metavar="LEFT", help="Material on the left.")],
    right: Annotated[str, typer.Argument(metavar="RIGHT", help="Material on the right.")],
    left_state: Annotated[str, typer.Option("--left", help='State on the left, such as "pressure = 1 GPa, velocity = 100 m/s" '
        '(default: the reference state at rest).')] = "",
    right_state: Annotated[str, typer.Option("--right", help="State on the right, in the same form.")] = "",
    bonded: Annotated[bool, typer.Option("--bonded", help="Keep the materials bonded, so that the contact supports tension.")] = False,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Solve the Riemann problem of two materials.

    Prints the waves to both sides and the state at the contact, or that the materials separate.

    Example: hugoniot eos riemann copper water --left "velocity = 500 m/s"
    """
    from hugoniot.cli.eos import riemann as eos_riemann

    eos_riemann.report((left, right), (left_state, right_state), bonded, as_json, as_csv, plot)


app.command()(cj)
app.command()(znd)
app.command()(mixture)
app.command()(stability)
app.command()(lines)
app.command()(gurney)
app.command("second-shock")(second_shock)
app.command()(convert)
app.command()(sesame)


@app.command()
def fit(
    points: Annotated[str, typer.Argument(metavar="POINTS", help="A CSV file with columns such as up [km/s], us [km/s], or a material "
        "whose measured points are in the library.")],
    quadratic: Annotated[bool, typer.Option("--quadratic", help="Fit Us = c0 + s up + s2 up^2 instead of a line.")] = False,
    least: Annotated[str | None, typer.Option("--from", help="Ignore points below this particle velocity.")] = None,
    highest: Annotated[str | None, typer.Option("--to", help="Ignore points above this particle velocity.")] = None,
    as_toml: Annotated[bool, typer.Option("--toml", help="Print the fit as a material table for a deck.")] = False,
    density: Annotated[str | None, typer.Option("--density", help="With --toml: reference density (default: the library's).")] = None,
    gruneisen: Annotated[float | None, typer.Option("--gruneisen", help="With --toml: Grüneisen parameter (default: 2 s - 1).")] = None,
    solid_jwl: Annotated[bool, typer.Option("--jwl-proportional", help="Fit the law jwl_proportional instead and print its material "
        "table for a deck.")] = False,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Fit Us-up data of a material.

    Prints the constants of the shock velocity Us as a function of the particle velocity up, with standard deviations and the range of
    the points.

    Example: hugoniot eos fit shots.csv --toml --density "8.93 g/cm^3"
    """
    from hugoniot.cli.eos import fit as eos_fit

    mode = "--jwl-proportional" if solid_jwl else "--toml" if as_toml else ""
    given = {"--quadratic": quadratic, "--json": as_json, "--csv": as_csv, "--plot": plot, "--density": density,
             "--gruneisen": gruneisen is not None, "--toml": as_toml}
    idle = {"--toml": ("--json", "--csv", "--plot"), "--jwl-proportional": ("--quadratic", "--csv", "--plot", "--toml"),
            "": ("--density", "--gruneisen")}[mode]
    for option in idle:
        if given[option]:
            where = f"with {mode}" if mode else "without --toml or --jwl-proportional"
            raise DeckError.single("command line", None, option, f"has no effect {where}", "omit it")
    low, high = quantity(least, "m/s", "--from") if least else 0.0, quantity(highest, "m/s", "--to") if highest else float("inf")
    if solid_jwl:
        eos_fit.solid_table(points, low, high, quantity(density, "kg/m^3", "--density") if density else None, gruneisen, as_json)
        return
    if as_toml:
        rest = quantity(density, "kg/m^3", "--density") if density else None
        eos_fit.deck_table(points, 2 if quadratic else 1, low, high, rest, gruneisen)
        return
    eos_fit.report(points, 2 if quadratic else 1, low, high, as_json, as_csv, plot)


@app.command("fit-jwl")
def fit_jwl(
    curve: Annotated[str, typer.Argument(metavar="CURVE", help="A CSV file of the expansion with the columns volume (V = v/v0) and "
        "pressure [GPa].")],
    density: Annotated[str, typer.Option("--density", help='Density of the explosive, such as "1.717 g/cm^3".')],
    velocity: Annotated[str, typer.Option("--velocity", help='Detonation velocity, such as "7.98 km/s".')],
    pressure: Annotated[str, typer.Option("--pressure", help='CJ pressure, such as "29.5 GPa".')],
    energy: Annotated[str, typer.Option("--energy", help='Detonation energy E0 per volume of explosive, such as "8.5 GJ/m^3" or "85 '
                                                         'kbar".')],
    omega: Annotated[float | None, typer.Option("--omega", help="Fix omega at this value instead of fitting it.")] = None,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Fit JWL constants to an expansion curve.

    The isentrope goes exactly through the CJ state given by the options. The points below that state are fitted by least squares.

    Example: hugoniot eos fit-jwl cylinder.csv --density "1.717 g/cm^3" --velocity "7.98 km/s" --pressure "29.5 GPa" --energy "8.5
    GJ/m^3"
    """
    from hugoniot.cli.eos import fit as eos_fit

    eos_fit.jwl(curve, density, velocity, pressure, energy, omega, as_json, as_csv, plot)


@app.command("fit-gamma")
def fit_gamma(
    material: MATERIAL, at: Annotated[str, typer.Option("--at", help='Shock state that the law must pass through, such as '
        '"particle_velocity = 500 m/s".')],
    ambient: Annotated[str, typer.Option("--ambient", help="Pressure ahead of the shock.")] = "1 atm", as_json: JSON = False,
) -> None:
    """Fit the Grüneisen parameter to a shock state.

    Finds the value with which a truncated law, of third order in the compression, passes through the state.

    Example: hugoniot eos fit-gamma copper --at "particle_velocity = 500 m/s"
    """
    from hugoniot.cli.eos import fit as eos_fit

    eos_fit.gamma(find_inert(material), at, quantity(ambient, "Pa", "--ambient"), as_json)


@app.command()
def table(
    material: MATERIAL,
    densities: Annotated[str, typer.Option("--densities", help='Lowest and highest density, such as "8 g/cm^3, 14 g/cm^3" (default: '
        '0.9 and 1.5 times the reference density).')] = "",
    temperatures: Annotated[str, typer.Option("--temperatures", help='Lowest and highest temperature, or three or more values; 0 K '
        'is the cold curve.')] = "200 K, 3000 K",
    points: Annotated[int, typer.Option("--points", min=2, max=1000, help="Number of densities and of temperatures, where a range "
        "is given.")] = 21,
    as_json: JSON = False, as_csv: CSV = None,
    hdf5: Annotated[Path | None, typer.Option("--hdf5", help="Write the grid to this HDF5 file.")] = None, plot: PLOT = None,
) -> None:
    """Tabulate an equation of state.

    Writes pressure and energy as functions of density and temperature, for codes that read tables.

    In a deck, [material.NAME.eos] with law = "table" and file = "copper.csv" uses the file.

    Example: hugoniot eos table copper --points 50 --csv copper.csv
    """
    from hugoniot.cli.eos import table as eos_table

    eos_table.report(find_material(material), densities, temperatures, points, as_json, as_csv, hdf5, plot)
