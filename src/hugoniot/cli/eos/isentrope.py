"""The report of `hugoniot eos isentrope`: releases from shocked states, expansions of products, compressions from rest."""

import typer

from hugoniot.cli.eos.input import Subject, find_material, one_state
from hugoniot.cli.eos.output import cell, deliver, echo_notes, echo_states, notes
from hugoniot.cli.eos.splits import split_notes
from hugoniot.cli.show import quantity
from hugoniot.theory import hugoniot as curves
from hugoniot.theory.chapman_jouguet import cj, overdriven
from hugoniot.theory.isentrope import AMBIENT, expansion_to, reference
from hugoniot.theory.states import States


def report(materials: list[str], at: str | None, points: int, to: str | None, as_json: bool, as_csv, plot) -> None:
    """Trace the isentrope of every material; print, write and draw what is asked."""
    paths = []
    for name in materials:
        subject = find_material(name)
        start = _start(subject, at)
        paths.append((subject, start, _expansion(subject, start, to, points)))
    if plot:
        from hugoniot.plotting.eos import releases, save

        drawn = [(s.material.name, None if s.reacted else curves.curve(s.material, up_to=1.15 * max(st.particle_velocity, 1.0)),
                  states if points >= 60 else _expansion(s, st, to, 60)) for s, st, states in paths]
        save(releases(drawn), plot)
    told = [notes(s) if s.reacted else [*(split_notes(s.material, start) if at else ()), *notes(s, start.particle_velocity),
                                        *([] if at else _beyond(s, states))] for s, start, states in paths]
    if not deliver([(s.material.name, st.table("entropy")) for s, _, st in paths], as_json=as_json, as_csv=as_csv, told=told):
        return
    for (subject, start, states), said in zip(paths, told):
        what = ", detonation products" if subject.reacted else ""
        typer.echo(f"{subject.title or subject.material.name}{what}: isentrope from {cell('pressure', start.pressure)}")
        echo_states(states)
        echo_notes(said)


def _beyond(subject: Subject, states: States) -> list[str]:
    """What must be said of a compression from rest to a density that no shock within the range of the data reaches."""
    limit = subject.material.valid_up_to
    if not limit:
        return []
    end, reached = float(curves.shock(subject.material, particle_velocity=limit).density), float(states.density.max())
    return [] if reached <= end else [f"the data of {subject.material.name} end at up = {limit:.6g} m/s, where the density is "
                                      f"{cell('density', end)}, but the isentrope reaches {cell('density', reached)}: extrapolated"]


def _expansion(subject: Subject, start: States, to: str | None, points: int) -> States:
    """States along the isentrope from `start` to the pressure `to`, by default the one at rest, or some higher one from there."""
    rest = max(float(reference(subject.material).pressure), 0.0)
    falls = start.pressure > rest * (1.0 + 1e-9)
    gas = rest > AMBIENT and not subject.reacted
    default = (1e5 if subject.reacted else rest if gas else 0.0) if falls else 1e7 if gas else 1e10
    return expansion_to(subject.material, start, quantity(to, "Pa", "--to") if to else default, points)


def _start(subject: Subject, at: str | None) -> States:
    """Where an isentrope begins: a state of the Hugoniot, the CJ state of products, or rest."""
    if subject.reacted:
        return overdriven(subject.material, **one_state(at)) if at else cj(subject.material).state
    return curves.shock(subject.material, **one_state(at)) if at else reference(subject.material)
