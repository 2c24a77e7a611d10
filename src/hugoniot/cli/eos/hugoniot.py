"""The report of `hugoniot eos hugoniot`: principal, porous, second-shock and detonation Hugoniots."""

from typing import NamedTuple

import numpy as np
import typer

from hugoniot.cli.eos.burning import initial
from hugoniot.cli.eos.input import Subject, find_inert, find_material, one_state
from hugoniot.cli.eos.output import cell, deliver, echo_notes, echo_states, notes, row_of
from hugoniot.cli.eos.splits import split_notes
from hugoniot.cli.show import quantity
from hugoniot.dossier.fits import library_points
from hugoniot.errors import DeckError, OutOfRange
from hugoniot.materials.validity import rounded
from hugoniot.theory.fits import read_points
from hugoniot.theory.hugoniot import Initial, curve, shock
from hugoniot.theory.split import split_range
from hugoniot.theory.states import States

SMOOTH = 60     # states with which a curve looks like one


class Question(NamedTuple):
    """What was asked, as typed."""

    at: str | None
    points: int
    up_to: str | None
    density: str | None
    after: str | None
    reaction: bool
    heat: str | None
    data: list[str]


class Answer(NamedTuple):
    """One material: the state ahead, the states asked for, the CJ point of a detonation Hugoniot, measured points."""

    subject: Subject
    ahead: Initial
    states: States
    cj: States | None = None
    data: np.ndarray | None = None


def solve_all(names: list[str], asked: Question) -> list[Answer]:
    """Every material, with the measured points given for it."""
    if len(asked.data) > len(names):
        raise DeckError.single("command line", None, "--data", f"files: {len(asked.data)}, materials: {len(names)}",
                               "give at most one for each material")
    measured = [np.column_stack(read_points(file)) for file in asked.data]
    return [solve(name, asked)._replace(data=measured[i] if i < len(measured) else None) for i, name in enumerate(names)]


def solve(name: str, asked: Question) -> Answer:
    """The states of one material; DeckError for questions that exclude each other."""
    if asked.reaction or asked.heat:
        return _with_reaction(name, asked)
    subject = find_inert(name)
    ahead = Initial.at_rest(subject.material, density=quantity(asked.density, "kg/m^3", "--density") if asked.density else None)
    if asked.after:
        ahead = Initial.of(shock(subject.material, ahead, **one_state(asked.after, "--after")))
    end = quantity(asked.up_to, "m/s", "--up-to") if asked.up_to else None
    if not asked.at:
        return Answer(subject, ahead, curve(subject.material, ahead, points=asked.points, up_to=end, once=True))
    return Answer(subject, ahead, shock(subject.material, ahead, **one_state(asked.at)))


def _with_reaction(name: str, asked: Question) -> Answer:
    from hugoniot.theory.chapman_jouguet import cj, detonation_hugoniot, overdriven

    if asked.after:
        raise DeckError.single("command line", None, "--after", "a detonation Hugoniot starts from the unreacted explosive",
                               "omit it")
    subject = find_material(name)
    ahead = initial(subject, asked.density, asked.heat, "")
    point = cj(subject.material, ahead).state
    end = quantity(asked.up_to, "m/s", "--up-to") if asked.up_to else None
    if asked.at:
        return Answer(subject, ahead, overdriven(subject.material, ahead, **one_state(asked.at)), point)
    return Answer(subject, ahead, detonation_hugoniot(subject.material, ahead, points=asked.points, up_to=end, once=True), point)


def _drawn(found: Answer, single: bool) -> States:
    """The curve of the picture: smooth to the last state asked for, or through the single one and somewhat beyond, as far as it goes."""
    from hugoniot.theory.chapman_jouguet import detonation_hugoniot

    if not single and len(found.states) >= SMOOTH:
        return found.states
    if found.cj:
        end = None if single else float(found.states.particle_velocity[-1])
        return detonation_hugoniot(found.subject.material, found.ahead, up_to=end)
    if not single:
        return curve(found.subject.material, found.ahead, up_to=float(found.states.particle_velocity[-1]) - found.ahead.velocity)
    up = max(float(found.states.particle_velocity) - found.ahead.velocity, 1.0)
    try:
        return curve(found.subject.material, found.ahead, up_to=1.3 * up)
    except OutOfRange:
        return curve(found.subject.material, found.ahead, up_to=up)


def report(found: list[Answer], single: bool, kind: str, as_json, as_csv, plot) -> None:
    """Print, write and draw what was solved; `single` if one state of each curve was asked."""
    if plot:
        from hugoniot.plotting.eos import hugoniots, save

        marks = [f.states if single else f.cj for f in found]
        curves = [(f.subject.material.name, f.ahead, _drawn(f, single)) for f in found]
        save(hugoniots(curves, kind, points=[_points(f, kind) for f in found],
                       mark=marks if single or all(m is not None for m in marks) else None), plot)
    # a detonation obeys its products' own range, not that of the shocks of the unreacted explosive
    told = [[*_splits(f, single), *notes(f.subject, 0.0 if f.cj else _strongest(f.states))] for f in found]
    more = [{"chapman_jouguet": row_of(f.cj.table())} if f.cj else {} for f in found]
    tables = [(f.subject.material.name, f.states.table("entropy")) for f in found]
    if not deliver(tables, as_json=as_json, as_csv=as_csv, told=told, more=more):
        return
    for f, said in zip(found, told):
        typer.echo(f"{f.subject.title or f.subject.material.name}{_from(f)}")
        if f.cj:
            point = [cell(k, getattr(f.cj, k)) for k in ("pressure", "particle_velocity", "shock_velocity")]
            typer.echo(f"with complete reaction; CJ point at {point[0]}, {point[1]}, front {point[2]}")
        echo_states(f.states)
        echo_notes(said)


def _splits(f: Answer, single: bool) -> list[str]:
    """What to say where no single shock leads to a state: the wave splits in two."""
    if f.cj:
        return []
    if not single:
        between = split_range(f.subject.material, f.ahead, float(np.max(f.states.particle_velocity)) - f.ahead.velocity)
        return [] if between is None else [
            f"from {rounded(between[0])} to {rounded(between[1])} no single shock exists: a faster precursor runs ahead; --at gives the "
            "states behind both waves"]
    return split_notes(f.subject.material, f.states, f.ahead)


def _from(f: Answer) -> str:
    """Where a Hugoniot starts, if not from rest."""
    rest = Initial.at_rest(f.subject.material)
    if f.cj or f.ahead == rest:
        return ""
    state = f"{cell('pressure', f.ahead.pressure)} and {cell('density', f.ahead.density)}"
    porous = f.ahead.density < rest.density and f.ahead.pressure == 0.0
    return f", porous: {cell('density', f.ahead.density)} ahead of the shock" if porous else f", from {state}"


def _points(f: Answer, kind: str):
    """Measured (up, us): the user's, or in the Us-up plane the library's, which belong to shocks from rest into full density."""
    if f.data is not None or kind != "us-up":
        return f.data
    whole = not f.cj and f.ahead == Initial.at_rest(f.subject.material)
    return library_points(f.subject.names) if whole else None


def _strongest(states: States) -> float:
    """The largest particle velocity of states, m/s."""
    return max(states.particle_velocity.tolist()) if hasattr(states.particle_velocity, "tolist") else states.particle_velocity
