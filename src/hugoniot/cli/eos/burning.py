"""The report of `hugoniot eos znd`, and what the commands about explosives share."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import typer

from hugoniot.cli.eos.input import Subject, find_material, find_reactive, read_rate, several_states
from hugoniot.cli.eos.output import cell, echo_columns, echo_notes, notes, row_of, words, write_csv
from hugoniot.cli.show import echo_json, echo_table, quantity
from hugoniot.errors import DeckError, OutOfRange
from hugoniot.theory.hugoniot import Initial

SCALARS = ("detonation_velocity", "chapman_jouguet_velocity", "overdrive", "half_reaction_length", "half_reaction_time",
           "reaction_zone_length")
ISOLATED = ("in thermal isolation, the temperature is that of the products; at burn fraction 0, and in the von Neumann spike, it is that "
            "of the reactants")


class Zone(NamedTuple):
    """What was asked of a reaction zone, as typed."""

    closure: str | None
    rate: str | None
    heat: str | None
    density: str | None
    ahead: str
    overdrive: float
    velocity: str | None
    complete: float
    points: int


def initial(subject: Subject, density: str | None, heat: str | None, ahead: str) -> Initial:
    """The state ahead of a detonation of one law: given, or the explosive at rest.

    With `heat` and no state a condensed explosive is meant: the energy of the law's gas at rest is no part of it.
    """
    from hugoniot.theory.chapman_jouguet import explosive

    released = quantity(heat, "J/kg", "--heat") if heat else 0.0
    if heat and subject.reacted:
        raise DeckError.single("command line", None, "--heat", f"'{subject.material.name}' already has a chemical energy, of "
                               f"{cell('specific_internal_energy', explosive(subject.material).energy)}",
                               "omit it; another energy goes into the e0 or detonation_energy of a TOML file")
    if ahead:
        if density:
            raise DeckError.single("command line", None, "--density", "--ahead already gives the state", "write the density there")
        return replace(_given(subject.material, ahead), heat=released)
    found = explosive(subject.material, quantity(density, "kg/m^3", "--density") if density else None, released)
    return replace(found, pressure=0.0, energy=0.0) if heat else found


def _given(law, ahead: str) -> Initial:
    from hugoniot.theory.isentrope import state

    given = several_states(ahead, "--ahead")
    return Initial.of(state(law, given.pop("velocity", 0.0), **given))


def closure_of(text: str) -> str:
    """The name of a closure; `DeckError` with the nearest one."""
    from hugoniot.laws import mixture as _mixtures  # noqa: F401  (enrols the closures)
    from hugoniot.laws.mixture.contract import MIXTURE
    from hugoniot.materials.collect import nearest

    if text not in MIXTURE.names():
        raise DeckError.single("command line", None, "--closure", f"unknown mixture '{text[:40]}'", nearest(text, MIXTURE.names()))
    return text


def mixture_of(subject: Subject, closure: str | None = None, heat: float | None = None):
    """Parameters of the mixture of an explosive: its closure, unless one is named."""
    from hugoniot.materials import burning
    from hugoniot.theory.mixture import mixture

    material = subject.material
    if material.unreacted is None:
        raise DeckError.single("command line", None, material.name, "the unreacted explosive has no equation of state",
                               "give it an [unreacted] table in a TOML file (eos znd and stability also take one law with --heat)")
    kind = closure_of(closure) if closure else burning.closure(material)
    found = mixture(kind, material.unreacted, material.eos, material.detonation_energy if heat is None else heat)
    if hasattr(found, "detonation_energy") and not found.detonation_energy > 0.0:
        raise OutOfRange(f"burning {material.name} would release {found.detonation_energy:.6g} J/kg, which is not positive: give its "
                         "chemical energy as "
                         "detonation_energy in a TOML file (for eos mixture also with --heat), or products with their E0")
    return found


def whose_temperature(law, temperature) -> list[str]:
    """A note on states of a mixture whose phases have different temperatures; none where there is no temperature."""
    from hugoniot.laws.mixture.contract import MIXTURE

    apart = MIXTURE.knows(law) and "follows_isentrope" in MIXTURE.of(law).flags
    return [ISOLATED] if apart and temperature is not None else []


def zones(names: list[str], asked: Zone, as_json, as_csv, plot) -> None:
    """Resolve the zone of every explosive; print, write and draw what is asked."""
    solved = [_solved(name, asked) for name in names]
    titles = [title for title, *_ in solved]
    if plot:
        from hugoniot.plotting.detonation import reaction_zones
        from hugoniot.plotting.eos import save

        save(reaction_zones([(title, zone, par, ahead) for title, zone, par, ahead, _, _ in solved]), plot)
    if as_csv:
        write_csv(as_csv, [(title, zone.table()) for title, zone, *_ in solved])
    rows = [_row(*each) for each in solved]
    if as_json:
        echo_json(rows[0] if len(rows) == 1 else {"materials": rows})
        return
    for title, row, (_, zone, _, _, _, said) in zip(titles, rows, solved):
        typer.echo(f"{title}: steady reaction zone, {row['closure'] or 'one law with heat of reaction'}")
        echo_table(["", ""], [(words(k), cell(k, row[k])) for k in SCALARS])
        typer.echo("\nvon Neumann spike")
        echo_columns(zone.von_neumann.table())
        energy = cell("specific_internal_energy", row["detonation_energy"])
        typer.echo("\nbehind it" + (f", chemical energy {energy} included in the internal energy" if row["closure"] else ""))
        echo_columns(zone.table())
        echo_notes(said)


def burning_of(name: str, asked: Zone):
    """(law or mixture, state ahead, burn law, closure or None, subject, notes) of one explosive as it was asked for."""
    from hugoniot.laws.mixture.contract import MIXTURE

    if asked.heat:
        if asked.closure:
            raise DeckError.single("command line", None, "--closure", "--heat applies to a single law that releases heat",
                                   "omit one of them")
        subject = find_material(name)
        burn = read_rate(asked.rate) if asked.rate else subject.material.burn
        if burn is None:
            raise DeckError.single("command line", None, name, "has no burn law, so its reaction rate is unknown",
                                   'give --rate "pressure_power: ...", or a TOML file with [burn]')
        return subject.material.eos, initial(subject, asked.density, asked.heat, asked.ahead), burn, None, subject, notes(subject)
    subject, said = find_reactive(name, asked.rate)
    if asked.density:
        raise DeckError.single("command line", None, "--density", "a mixture starts at the density of its unreacted explosive",
                               "omit it, or give --ahead")
    law, reactants = mixture_of(subject, asked.closure), subject.material.unreacted
    ahead = _given(reactants, asked.ahead) if asked.ahead else Initial.at_rest(reactants)
    return law, ahead, subject.material.burn, MIXTURE.of(law).name, subject, [*said, *notes(subject)]


def _solved(name: str, asked: Zone):
    """(title, zone, law or mixture, state ahead, closure, notes) of one explosive."""
    from hugoniot.theory.znd import znd

    velocity = quantity(asked.velocity, "m/s", "--velocity") if asked.velocity else None
    law, ahead, burn, kind, subject, said = burning_of(name, asked)
    zone = znd(law, ahead, burn, overdrive=asked.overdrive, velocity=velocity, points=asked.points, complete=asked.complete)
    return subject.material.name, zone, law, ahead, kind, [*said, *whose_temperature(law, zone.table()["temperature"])]


def _row(title, zone, law, ahead, closure, said) -> dict:
    table = row_of(zone.table())
    energy = getattr(law, "detonation_energy", ahead.heat)
    return {"material": title, "closure": closure, "detonation_energy": energy, "detonation_velocity": zone.velocity,
            "chapman_jouguet_velocity": zone.chapman_jouguet_velocity, "overdrive": zone.overdrive,
            "half_reaction_length": zone.half_reaction_length, "half_reaction_time": zone.half_reaction_time,
            "reaction_zone_length": float(np.max(zone.position)), "von_neumann": row_of(zone.von_neumann.table()), **table,
            "warnings": said}
