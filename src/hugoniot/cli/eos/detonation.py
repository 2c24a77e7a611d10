"""hugoniot eos cj, znd, mixture: explosives without a mesh."""

from typing import Annotated

import typer

from hugoniot.cli.eos.input import find_material
from hugoniot.cli.eos.options import AHEAD, CSV, DENSITY, EXPLOSIVE, HEAT, MATERIALS, PLOT, RATE
from hugoniot.cli.eos.output import cell, deliver, echo_notes, notes, row_of, words
from hugoniot.cli.show import JSON, echo_table
from hugoniot.cli.typed import refuse_idle

CLOSURE = "How reactants and products share a zone: thermal_isolation, thermal_equilibrium, weighted_pressures or two_state"


def cj(
    materials: MATERIALS, density: DENSITY = None, heat: HEAT = None, ahead: AHEAD = "", as_json: JSON = False, as_csv: CSV = None,
    plot: PLOT = None,
) -> None:
    """Compute Chapman-Jouguet states.

    The CJ state is where the Rayleigh line touches the detonation Hugoniot; any law of products can be used.

    Example: hugoniot eos cj comp_b tnt --json
    """
    from hugoniot.cli.eos.burning import initial
    from hugoniot.theory.chapman_jouguet import cj as tangency

    subjects = [find_material(m) for m in materials]
    found = [tangency(s.material, initial(s, density, heat, ahead)) for s in subjects]
    if plot:
        from hugoniot.plotting.eos import detonations, save

        save(detonations([(s.material.name, d) for s, d in zip(subjects, found)]), plot)
    if not deliver([(s.material.name, d.table()) for s, d in zip(subjects, found)], as_json=as_json, as_csv=as_csv,
                   told=[notes(s) for s in subjects]):
        return
    for subject, point in zip(subjects, found):
        typer.echo(f"{subject.title or subject.material.name}: CJ state")
        echo_table(["", ""], [(words(k), cell(k, v)) for k, v in row_of(point.table()).items()
                              if v is not None and k != "shock_velocity"])
        echo_notes(notes(subject))


def znd(
    explosives: MATERIALS, closure: Annotated[str | None, typer.Option("--closure", help=CLOSURE + " (default: that of the "
        "material).")] = None,
    rate: RATE = None, heat: HEAT = None, density: DENSITY = None, ahead: AHEAD = "",
    overdrive: Annotated[float, typer.Option("--overdrive", min=1.0, help="Overdrive f = (D/D_CJ)^2, with the velocity D of the "
        "front.")] = 1.0,
    velocity: Annotated[str | None, typer.Option("--velocity", help='Velocity of the front, such as "9 km/s", instead of '
        '--overdrive.')] = None,
    complete: Annotated[float, typer.Option("--complete", help="Burn fraction at which the profile ends.")] = 1.0 - 1e-6,
    points: Annotated[int, typer.Option("--points", min=3, max=10000, help="Number of states along the zone.")] = 100,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute the reaction zone of a detonation.

    Prints the von Neumann spike, the half-reaction length and time, and states along the steady (ZND) zone.

    An explosive of the library burns at its calibrated rate; --closure says how reactants and products share a zone. With --heat a
    single law, such as that of a gas, releases this heat as the reaction proceeds.

    Example: hugoniot eos znd lx_17 --plot zone.png
    """
    from hugoniot.cli.eos import burning as eos_burning

    if velocity is not None:
        refuse_idle("with --velocity", "--overdrive")
    eos_burning.zones(explosives, eos_burning.Zone(closure, rate, heat, density, ahead, overdrive, velocity, complete, points),
                      as_json, as_csv, plot)


def mixture(
    explosive: EXPLOSIVE,
    at: Annotated[str, typer.Option("--at", help='State of the mixture: density and one of energy, pressure and temperature, such '
        'as "density = 2.4 g/cm^3, energy = 3 MJ/kg". The energy is that above the reference state of the unreacted explosive; the '
        'chemical energy is added.')] = "",
    shocked: Annotated[str, typer.Option("--shocked", help='Shock that the reactants pass through first, such as "pressure = 20 '
        'GPa"; sets their isentrope and, without --at, the state.')] = "",
    fractions: Annotated[str, typer.Option("--burn-fraction", help="Burn fractions, separated by commas.")] = "0, 0.25, 0.5, 0.75, 1",
    closure: Annotated[list[str] | None, typer.Option("--closure", help=CLOSURE + " (default: thermal_isolation and "
        "thermal_equilibrium); repeatable.")] = None,
    adiabat: Annotated[str | None, typer.Option("--adiabat", help='Density to which the adiabat is followed from the state of the '
        'first burn fraction, such as "1 g/cm^3".')] = None,
    burn_to: Annotated[float | None, typer.Option("--burn-to", min=0.0, max=1.0, help="Burn fraction at the end of the adiabat, "
        "approached in proportion to the volume (default: it does not change).")] = None,
    frozen: Annotated[str | None, typer.Option("--hugoniot", help='Highest pressure of shocks into the state, such as "40 GPa"; '
        'nothing burns inside them without --reacted.')] = None,
    reacted: Annotated[float, typer.Option("--reacted", min=0.0, max=1.0, help="With --hugoniot: mass fraction that burns inside "
        "the shock.")] = 0.0,
    series: Annotated[bool, typer.Option("--series", help="Print the series for small burn fractions instead.")] = False,
    heat: Annotated[str | None, typer.Option("--heat", help='Chemical energy, such as "5 MJ/kg" (default: from the equations of '
        'state).')] = None,
    points: Annotated[int, typer.Option("--points", min=2, max=10000, help="Number of states along an adiabat or Hugoniot.")] = 41,
    as_json: JSON = False, as_csv: CSV = None, plot: PLOT = None,
) -> None:
    """Compute states of a partly burned explosive.

    Prints pressure and its derivatives, sound speed, Gamma, adiabatic exponent, temperature and specific heat of the mixture.

    Reactants and products have equal pressures, with thermal isolation (the reactants stay on their isentrope) or equal temperatures.

    Example: hugoniot eos mixture lx_17 --shocked "pressure = 20 GPa" --adiabat "1 g/cm^3" --burn-to 1
    """
    from hugoniot.cli.eos import mixture as eos_mixture

    if adiabat is None:
        refuse_idle("without --adiabat", "--burn-to", *(["--points"] if frozen is None else []))
    if series:
        refuse_idle("with --series, which starts at burn fraction 0", "--burn-fraction")

    asked = eos_mixture.Question(at, shocked, fractions, closure or [], adiabat, burn_to, frozen, series, heat, points,
                                   reacted)
    eos_mixture.report(explosive, asked, as_json, as_csv, plot)
