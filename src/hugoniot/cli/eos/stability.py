"""`hugoniot eos stability`: growth rates and frequencies of a plane one-step detonation."""

from typing import Annotated

import typer

from hugoniot.cli.show import JSON, echo_json, echo_table


def stability(
    gamma: Annotated[float, typer.Option("--gamma", help="Ratio of specific heats.")] = 1.2,
    heat: Annotated[float, typer.Option("--heat", help="Heat release over pressure/density ahead.")] = 50.0,
    activation: Annotated[float, typer.Option("--activation", help="Activation energy over pressure/density ahead.")] = 50.0,
    overdrive: Annotated[float, typer.Option("--overdrive", help="f = (D/D_CJ)^2, at least 1.0005; CJ is the limit from above.")] = 1.6,
    highest: Annotated[float, typer.Option("--highest", help="Highest frequency to search, in radians per unit time.")] = 3.0,
    as_json: JSON = False,
) -> None:
    """Normal modes of a plane ZND wave of an ideal gas with one Arrhenius step.

    Lengths are half-reaction lengths; times are these over sqrt(pressure/density) ahead.
    Other rates are not taken: where the reactants keep an isentrope the wrinkle also moves their reference state, and where a rate sets
    in at a burn fraction it jumps. Run such a wave with the solver fronts, mode "cells".

    Example: hugoniot eos stability --activation 26 --overdrive 1.001 --highest 1
    """
    from hugoniot.theory.stability import Wave

    wave = Wave(gamma, heat, activation, overdrive)
    modes = wave.modes(highest)
    if as_json:
        echo_json({"detonation_velocity": wave.velocity, "rate_constant": wave.rate_constant, "von_neumann_pressure": wave.state(0.0)[2],
                   "modes": [{"growth_rate": m.growth, "frequency": m.frequency} for m in modes]})
        return
    typer.echo(f"D = {wave.velocity:.6g}, rate constant k = {wave.rate_constant:.7g}, von Neumann pressure {wave.state(0.0)[2]:.6g}")
    if not modes:
        typer.echo(f"no growing mode with a frequency up to {highest:g}: the plane wave is stable as far as searched")
        return
    echo_table(["growth rate", "frequency", "period"], [[f"{m.growth:.6g}", f"{m.frequency:.6g}",
               f"{6.283185307179586 / m.frequency:.6g}" if m.frequency else "-"] for m in modes])
