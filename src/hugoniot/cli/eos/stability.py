"""`hugoniot eos stability`: growth rates and frequencies of a plane detonation."""

import math
from typing import Annotated

import typer

from hugoniot.cli.eos.detonation import CLOSURE
from hugoniot.cli.eos.options import RATE
from hugoniot.cli.eos.output import echo_notes
from hugoniot.cli.show import JSON, echo_json, echo_table, quantity
from hugoniot.errors import DeckError


def stability(
    explosive: Annotated[str | None, typer.Argument(help="Name of the library or TOML file; omit it for the ideal gas.")] = None,
    gamma: Annotated[float | None, typer.Option("--gamma", help="Ratio of specific heats of the gas (default: 1.2).")] = None,
    heat: Annotated[str | None, typer.Option("--heat", help='Gas: heat release divided by p/rho ahead (default: 50). Explosive with '
        'a single law: heat of reaction, such as "5 MJ/kg".')] = None,
    activation: Annotated[float | None, typer.Option("--activation",
                                                              help="Activation energy of the gas divided by p/rho ahead (default: "
        "50).")] = None,
    overdrive: Annotated[float, typer.Option("--overdrive", help="Overdrive f = (D/D_CJ)^2, at least 1.0005.")] = 1.6,
    highest: Annotated[float, typer.Option("--highest", help="Highest frequency to search, in radians per unit time.")] = 3.0,
    closure: Annotated[str | None, typer.Option("--closure", help=CLOSURE + " (default: that of the material).")] = None,
    rate: RATE = None, as_json: JSON = False,
) -> None:
    """Find the unstable modes of a plane detonation.

    Prints growth rates and frequencies of the normal modes of a ZND wave, of an explosive with its equations of state, mixture and rate, or
    of an ideal gas with one Arrhenius step.

    For an explosive the unit of time is its half-reaction length divided by D, the velocity of the front. For the gas it is the
    half-reaction length divided by sqrt(p/rho) of the gas ahead.

    Examples: hugoniot eos stability lx_17 --overdrive 1.1; hugoniot eos stability --activation 26 --overdrive 1.001 --highest 1
    """
    given = {"--gamma": gamma, "--activation": activation}
    if explosive is not None:
        for name, value in given.items():
            if value is not None:
                raise DeckError.single("command line", None, name, "applies to the ideal gas only, but an explosive is given", "omit one")
        _of_explosive(explosive, closure, rate, heat, overdrive, highest, as_json)
        return
    for name, value in {"--closure": closure, "--rate": rate}.items():
        if value is not None:
            raise DeckError.single("command line", None, name, "applies to explosives only", "name one, such as lx_17")
    _of_gas(1.2 if gamma is None else gamma, 50.0 if heat is None else quantity(heat, "", "--heat"),
            50.0 if activation is None else activation, overdrive, highest, as_json)


def _of_gas(gamma, heat, activation, overdrive, highest, as_json) -> None:
    from hugoniot.theory.stability import Wave

    wave = Wave(gamma, heat, activation, overdrive)
    modes = wave.modes(highest)
    if as_json:
        echo_json({"detonation_velocity": wave.velocity, "rate_constant": wave.rate_constant, "von_neumann_pressure": wave.state(0.0)[2],
                   "modes": [{"growth_rate": m.growth, "frequency": m.frequency} for m in modes]})
        return
    typer.echo(f"D = {wave.velocity:.6g}, rate constant k = {wave.rate_constant:.7g}, von Neumann pressure {wave.state(0.0)[2]:.6g}")
    _show(modes, highest)


def _of_explosive(name, closure, rate, heat, overdrive, highest, as_json) -> None:
    from hugoniot.cli.eos.burning import Zone, burning_of
    from hugoniot.theory.normal_modes import ModesOfZone

    law, ahead, burn, kind, subject, said = burning_of(name, Zone(closure, rate, heat, None, "", overdrive, None, 1.0, 0))
    zone = ModesOfZone(law, ahead, burn, overdrive)
    modes = zone.modes(highest)
    if as_json:
        echo_json({"material": subject.material.name, "closure": kind, "detonation_velocity": zone.velocity, "overdrive": overdrive,
                   "half_reaction_length": zone.length, "unit_of_time": zone.time,
                   "modes": [{"growth_rate": m.growth, "frequency": m.frequency} for m in modes], "warnings": said})
        return
    typer.echo(f"{subject.material.name}: D = {zone.velocity:.6g} m/s, half-reaction length {1e6 * zone.length:.5g} um, unit of time "
               f"{1e9 * zone.time:.5g} ns")
    _show(modes, highest)
    echo_notes(said)


def _show(modes, highest: float) -> None:
    if not modes:
        typer.echo(f"no growing mode with a frequency up to {highest:g}: the plane wave is stable in the range searched")
        return
    echo_table(["growth rate", "frequency", "period"], [[f"{m.growth:.6g}", f"{m.frequency:.6g}",
               f"{2.0 * math.pi / m.frequency:.6g}" if m.frequency else "-"] for m in modes])
