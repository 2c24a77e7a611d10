"""hugoniot structure: the inside of a steady shock, resolved by viscosity and heat conduction."""

import csv
import tomllib
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.cli.typed import refuse_idle
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import toml_tables, toml_trouble

app = typer.Typer(no_args_is_help=True, help=(
    "Compute the steady internal structure of a shock, to which viscosity and heat conduction give a width, without time steps.\n\n"
    "WHAT is a deck of the solver shock_structure, a case of Jordan (2011), or a material of the library (then give --viscosity). "
        "The cases are argon-jordan, water_387, water_858, silica_100, silica_250 and silica_770.\n\n"
    "Example: hugoniot structure profile argon-jordan --mach 9 --plot mach9.png"))

WHAT = Annotated[str, typer.Argument(metavar="WHAT", help="A deck, a case of Jordan (2011), or a material of the library.")]
VISCOSITY = Annotated[str | None, typer.Option(
    "--viscosity", help='Shear viscosity, such as "22.7 uPa s", a table {law = "power_law", ...}, or for argon-jordan the name of a law.')]
CONDUCTION = Annotated[str | None, typer.Option("--conduction", help='Thermal conductivity, such as "0.02 W/m/K", or a table {law = ...}.')]
PRANDTL = Annotated[float | None, typer.Option("--prandtl", help="Prandtl number, from which the conductivity follows, instead of "
        "--conduction.")]
BULK = Annotated[float | None, typer.Option("--bulk-ratio", help="Ratio of bulk to shear viscosity.")]
DENSITY = Annotated[str | None, typer.Option("--density", help='Density ahead of the shock, such as "1.62 kg/m^3".')]
TEMPERATURE = Annotated[str | None, typer.Option("--temperature", help='Temperature ahead of the shock, such as "300 K".')]
PRESSURE = Annotated[str | None, typer.Option("--pressure", help='Pressure ahead of the shock, such as "1 bar".')]
UNIT = Annotated[str, typer.Option("--mean-free-path", help="Definition of the mean free path: bsl, chapman_enskog, viscous or vhs.")]
BENT = Annotated[bool, typer.Option("--bent", help="Water and silica cases: use the Grüneisen parameter that was adjusted to fit "
        "the jump.")]
CSV = Annotated[Path | None, typer.Option("--csv", help="Write the numbers, in SI, to this file.")]
PLOT = Annotated[Path | None, typer.Option("--plot", help="Draw the picture into this file (.png, .pdf, .svg).")]


@app.command()
def profile(
    what: WHAT, mach: Annotated[float | None, typer.Option("--mach", help="Mach number of the shock.")] = None,
    particle_velocity: Annotated[str | None, typer.Option("--particle-velocity", help='Jump in particle velocity, such as "858 '
                                                                                      'm/s".')] = None,
    shock_velocity: Annotated[str | None, typer.Option("--shock-velocity", help='Speed of the shock, such as "3 km/s".')] = None,
    viscosity: VISCOSITY = None, conduction: CONDUCTION = None, prandtl: PRANDTL = None, bulk_ratio: BULK = None,
    density: DENSITY = None, temperature: TEMPERATURE = None, pressure: PRESSURE = None, bent: BENT = False,
    points: Annotated[int, typer.Option("--points", min=2, max=100000, help="Number of points of the profile in --csv and --json.")] = 201,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute the profile of one shock.

    Prints its thickness, widths, entropy, entropy production and end states. Give one of --mach, --particle-velocity and
    --shock-velocity, unless the deck or case states the strength of the shock.

    Example: hugoniot structure profile water_858 --json
    """
    if not (as_json or as_csv):
        refuse_idle("without --csv or --json", "--points")
    subject = _subject(what, viscosity, conduction, prandtl, bulk_ratio, (density, temperature, pressure), bent)
    strength = {"mach": mach, "particle_velocity": _number(particle_velocity, "m/s", "--particle-velocity"),
                "shock_velocity": _number(shock_velocity, "m/s", "--shock-velocity")}
    strength = {name: value for name, value in strength.items() if value is not None} or subject["shock"]
    if len(strength) != 1:
        raise DeckError.single("command line", None, "--mach", "give exactly one measure of shock strength",
                               "give --mach, --particle-velocity or --shock-velocity")
    from hugoniot.theory.structure import steady
    from hugoniot.theory.structure.sweep import measures

    found = steady(subject["eos"], subject["transport"], subject["ahead"], **strength)
    numbers = measures(found) | _paths(found)
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.structure import profile_picture
        save(profile_picture(found, f"{what}, Mach {found.ends.mach:.4g}"), plot)
    if as_csv or as_json:
        import numpy as np
        x = np.linspace(*found.extent(1e-4), points)
        table = {"x": x, **found.at(x)}
        if as_csv:
            _write_csv(as_csv, table)
        if as_json:
            echo_json({"what": what, **numbers, "profile": table})
            return
    _tell(numbers, found, subject["transport"])


@app.command()
def sweep(
    what: WHAT, start: Annotated[float, typer.Option("--from", help="First Mach number.")] = 1.1,
    end: Annotated[float, typer.Option("--to", help="Last Mach number.")] = 11.0,
    points: Annotated[int, typer.Option("--points", min=2, max=1000, help="Number of Mach numbers.")] = 41,
    viscosity: VISCOSITY = None, conduction: CONDUCTION = None, prandtl: PRANDTL = None, bulk_ratio: BULK = None,
    density: DENSITY = None, temperature: TEMPERATURE = None, pressure: PRESSURE = None, unit: UNIT = "chapman_enskog",
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute shock thickness as a function of Mach number.

    Prints the reciprocal thickness: for a gas the mean free path divided by the thickness, for anything else in 1/nm.

    Example: hugoniot structure sweep argon-jordan --plot thickness.png
    """
    import numpy as np

    from hugoniot.theory.structure.sweep import measures
    from hugoniot.theory.structure.sweep import sweep as run

    laws = [viscosity] if viscosity or what != "argon-jordan" else ["constant", "power_law", "sutherland"]
    machs = np.geomspace(start, end, points) if start > 0.0 else np.linspace(start, end, points)
    curves, rows, gas = [], [], False
    for law in laws:
        subject = _subject(what, law, conduction, prandtl, bulk_ratio, (density, temperature, pressure))
        profiles = run(subject["eos"], subject["transport"], machs, subject["ahead"])
        gas = bool(_paths(profiles[0]))
        if not gas:
            refuse_idle("on a material whose mean free path is unknown; the reciprocal thickness is given in 1/nm", "--mean-free-path")
        lengths = [p.mean_free_path(unit) if gas else 1e-9 for p in profiles]
        values = [length / p.thickness() for length, p in zip(lengths, profiles)]
        curves.append((law or what, machs, values))
        rows += [{"viscosity": law or "", "reciprocal_thickness": v, **measures(p)} for p, v in zip(profiles, values)]
    label = f"mean free path ({unit}) / thickness" if gas else "1 / thickness (1/nm)"
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.structure import thickness_picture
        save(thickness_picture(curves, label), plot)
    if as_csv:
        _write_csv(as_csv, {key: [row[key] for row in rows] for key in rows[0]})
    if as_json:
        echo_json(rows)
        return
    typer.echo(label)
    echo_table(["Mach", *(name for name, _, _ in curves)],
               [(f"{m:.4g}", *(f"{values[i]:.5g}" for _, _, values in curves)) for i, m in enumerate(machs)])


@app.command()
def jordan(as_json: JSON = False) -> None:
    """Print the tables of Jordan (2011).

    They are for argon, water and silica; the printed values stand beside those that the equations give.

    Example: hugoniot structure jordan
    """
    from hugoniot.theory.structure.sweep import argon_rows, condensed_rows

    argon, condensed = argon_rows(), condensed_rows()
    if as_json:
        echo_json({"argon": argon, "condensed": condensed})
        return
    echo_table(["table", "block", "Mach", "quantity", "printed", "here"],
               [(r["table"], r["block"], f"{r['mach']:g}", r["quantity"], "-" if r["printed"] is None else f"{r['printed']:g}",
                 f"{r['ours']:.4f}") for r in argon])
    typer.echo("\nThickness in nm; the printed values reflect the source's grid (see docs/theory/shock_structure.md)")
    echo_table(["case", "Mach", "printed", "grid spacing", "here, adjusted Grüneisen", "here, literature's Grüneisen"],
               [(r["block"], f"{r['mach']:.4g}", f"{r['printed']:g}", f"{r['spacing']:.4g}", f"{r['ours_bent']:.4g}", f"{r['ours']:.4g}")
                for r in condensed])


# -- input -----------------------------------------------------------------------------------------------------------
def _subject(what: str, viscosity, conduction, prandtl, bulk_ratio, state, bent: bool = False) -> dict:
    """{"eos", "transport", "ahead", "shock"} of a deck, a case or a material."""
    from hugoniot.theory.structure import jordan as cases

    if bent and what not in cases.CONDENSED:
        raise DeckError.single("command line", None, "--bent", f"'{what}' has no adjusted Grüneisen parameter",
                               f"the cases that have one are {', '.join(cases.CONDENSED)}")
    if what == "argon-jordan":
        law, ahead = cases.argon()
        found = {"eos": law, "ahead": ahead, "shock": {}, "transport": cases.argon_transport(_law_name(viscosity) or "power_law")}
        viscosity = None
    elif what in cases.CONDENSED:
        case = cases.CONDENSED[what]
        law = case.eos(case.bent if bent else case.literature)
        found = {"eos": law, "ahead": None, "shock": {"particle_velocity": case.particle_velocity}, "transport": case.transport()}
    elif what.endswith(".toml") and viscosity is None:
        found = _deck(what)
    else:
        from hugoniot.cli.eos.input import find_inert

        found = {"eos": find_inert(what).material.eos, "ahead": None, "shock": {}, "transport": None}
        if viscosity is None:
            case = next((name for name in ("argon-jordan", *cases.CONDENSED) if name.startswith(what.lower())), None)
            ready = f"'{case}' has one (Jordan 2011); or " if case else ""
            raise DeckError.single("command line", None, "--viscosity", f"the library has no viscosity for '{what}'",
                                   ready + 'give one, such as --viscosity "1 mPa s"')
    if any(state):
        found["ahead"] = _ahead(found["eos"], *state)
    return found | {"transport": _transport(found["transport"], viscosity, conduction, prandtl, bulk_ratio)}


def _law_name(viscosity: str | None) -> str | None:
    known = ("constant", "power_law", "sutherland", "hard_sphere", "maxwell_molecules")
    if viscosity is not None and viscosity not in known:
        raise DeckError.single("command line", None, "--viscosity", f"argon-jordan supports {', '.join(known)}, not '{viscosity[:40]}'",
                               "for argon with another viscosity write a deck (examples/argon-mach9.toml)")
    return viscosity


def _deck(path: str) -> dict:
    from hugoniot.problem.deck import read_deck
    from hugoniot.problem.structure_start import MEASURES, setting

    problem = read_deck(path).problem
    if problem.solver.kind != "shock_structure":
        raise DeckError.single(path, None, "solver.kind", f"the solver '{problem.solver.kind}' does not resolve shocks "
                               "with a physical viscosity",
                               'give a deck with kind = "shock_structure" (examples/argon-mach9.toml), or --viscosity')
    eos, transport, ahead = setting(problem)
    shock = problem.solver.options.get("shock") or {}
    return {"eos": eos, "transport": transport, "ahead": ahead,
            "shock": {name: shock[name] for name in MEASURES if shock.get(name) is not None}}


def _ahead(law, density, temperature, pressure):
    from hugoniot.laws.eos import contract
    from hugoniot.materials.initial_state import initial_state
    from hugoniot.theory.hugoniot import Initial

    if not (density or temperature or pressure):
        return None
    rho, e = initial_state(law, _number(density, "kg/m^3", "--density"), _number(pressure, "Pa", "--pressure"),
                           _number(temperature, "K", "--temperature"))
    return Initial(rho, float(contract.pressure(rho, e, law)), e)


def _transport(base, viscosity, conduction, prandtl, bulk_ratio):
    """The transport laws that the options give; what they leave open is that of `base`, or none."""
    from hugoniot.laws.transport.contract import CONDUCTION as conductions
    from hugoniot.laws.transport.contract import TRANSPORT, make

    if prandtl is not None and conduction is not None:
        raise DeckError.single("command line", None, "--prandtl", "heat conduction is given twice", "leave --prandtl or --conduction out")
    shear = _law_table(viscosity, "--viscosity", "Pa s", "shear_viscosity", TRANSPORT) if viscosity else base.shear
    heat = base.conduction if base else None
    if prandtl is not None:
        heat = {"law": "prandtl", "prandtl": prandtl}
    elif conduction is not None:
        heat = _law_table(conduction, "--conduction", "W/m/K", "conductivity", conductions)
    if bulk_ratio is None:
        bulk_ratio = base.bulk_ratio if base else 0.0
    return make(shear, heat, bulk_ratio, base.bulk_viscosity if base else 0.0)


def _law_table(text: str, option: str, unit: str, parameter: str, registry):
    """{"law": ..., parameter: SI} from a quantity (law "constant") or an inline table with units."""
    if not text.lstrip().startswith("{"):
        return {"law": "constant", parameter: _number(text, unit, option)}
    try:
        table = toml_tables(f"value = {text}")["value"]
    except ValueError as error:
        why = toml_trouble(error, text)[1] if isinstance(error, tomllib.TOMLDecodeError) else f"not a table: {error}"
        raise DeckError.single("command line", None, option, why, 'write it like {law = "power_law", shear_viscosity = ...}') from None
    from hugoniot.materials.collect import Collector
    from hugoniot.materials.law_reader import read_law

    problems: list = []
    par = read_law(registry, table, Collector(problems, "command line", lambda key: None), (option,))
    if par is None:
        raise DeckError(problems)
    return par


def _number(text: str | None, unit: str, option: str) -> float | None:
    return None if text is None else quantity(text, unit, option)


# -- output ----------------------------------------------------------------------------------------------------------
def _paths(found) -> dict:
    from hugoniot.errors import OutOfRange
    from hugoniot.laws.transport.mean_free_path import MEAN_FREE_PATHS
    try:
        return {f"mean_free_path_{name}": found.mean_free_path(name) for name in MEAN_FREE_PATHS}
    except OutOfRange:
        return {}


def _tell(numbers: dict, found, transport) -> None:
    from hugoniot.cli.results import echo_transport
    from hugoniot.laws.eos.contract import EOS
    from hugoniot.laws.transport.mean_free_path import MEAN_FREE_PATHS
    from hugoniot.output.setup_record import transport_record

    one, two = found.ends.upstream, found.ends.downstream
    typer.echo(f"Mach {found.ends.mach:.6g}, shock velocity {found.ends.shock_velocity:.6g} m/s, "
               f"particle velocity {found.ends.particle_velocity:.6g} m/s")
    echo_table(["", "ahead", "behind", ""], [
        ("  density", f"{one.density:.6g}", f"{two.density:.6g}", "kg/m^3"),
        ("  pressure", f"{one.pressure:.6g}", f"{two.pressure:.6g}", "Pa"),
        *([("  temperature", f"{one.temperature:.6g}", f"{two.temperature:.6g}", "K")] if one.temperature == one.temperature else []),
        ("  velocity relative to the shock", f"{one.velocity:.6g}", f"{two.velocity:.6g}", "m/s")])
    rows = [("density thickness", "density_thickness"), ("velocity thickness", "velocity_thickness"),
            ("density width 10-90 %", "density_width_10_90"), ("velocity width 10-90 %", "velocity_width_10_90")]
    typer.echo("")
    echo_table(["", "nm", *(name.removeprefix("mean_free_path_") for name in numbers if name.startswith("mean_free_path_"))],
               [(f"  {word}", f"{numbers[key] * 1e9:.6g}",
                 *(f"{numbers[key] / value:.5g}" for name, value in numbers.items() if name.startswith("mean_free_path_")))
                for word, key in rows])
    if found.entropy_viscous == found.entropy_viscous:
        typer.echo(f"\nentropy gained {numbers['entropy_viscous'] + numbers['entropy_conductive']:.6g} J/(kg K): "
                   f"viscosity {numbers['entropy_viscous']:.6g}, conduction {numbers['entropy_conductive']:.6g}"
                   f" (jump of the law's entropy: {numbers['entropy_jump']:.6g})")
    typer.echo("\nthickness: jump over steepest gradient, |rho2 - rho1| / max|drho/dx| and |u2 - u1| / max|du/dx|; "
               "widths: 10 to 90 % of the jump")
    for name, words in MEAN_FREE_PATHS.items():
        if f"mean_free_path_{name}" in numbers:
            typer.echo(f"{name}: mean free path ahead, {words}: {numbers[f'mean_free_path_{name}'] * 1e9:.6g} nm")
    record, law = transport_record(transport), EOS.of(found.ends.eos)
    typer.echo(f"equation of state: {law.name}")
    echo_transport(record)
    typer.echo("sources: " + "; ".join(dict.fromkeys((*law.references, *(r for one in record["laws"] for r in one["references"])))))


def _write_csv(path: Path, table: dict) -> None:
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(table)
            writer.writerows(zip(*table.values()))
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None
