"""The report of `hugoniot eos show`: a law, its parameters, its state at rest or on the Hugoniot."""

import typer

from hugoniot.cli.eos.input import Subject, find_inert, find_material, one_state
from hugoniot.cli.eos.output import cell, echo_notes, echo_states, notes, row_of, write_csv
from hugoniot.cli.eos.splits import split_notes
from hugoniot.cli.show import echo_json, echo_table
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import reference
from hugoniot.theory.states import States


def report(material: str, at: str | None, as_json: bool, as_csv, plot) -> None:
    """Print, write and draw one material."""
    subject = find_material(material)
    par = subject.material.eos
    law = EOS.of(par)
    inert = find_inert(material).material if at else None
    state = shock(inert, **one_state(at)) if at else reference(subject.material)
    more = ("entropy",) if "shocks_only" in law.flags else ("gruneisen", "entropy")
    told = [*(split_notes(inert, state) if at else ()), *notes(subject, state.particle_velocity)]
    if plot:
        _portrait(material, subject, state if at else None, plot)
    if as_csv:
        write_csv(as_csv, [("", state.table(*more))])
    if as_json:
        echo_json({"material": subject.material.name, "law": law.name, "parameters": _parameters(par),
                   "references": list(law.references), **({"unreacted": True} if subject.reacted and at else {}),
                   **row_of(state.table(*more)), "warnings": told})
        return
    typer.echo(f"{subject.title or subject.material.name}: {law.name} - {law.summary}")
    echo_table(["", "", "", ""], _parameter_rows(par))
    typer.echo(f"Source of the law: {'; '.join(law.references)}")
    rest = "Products at the density and energy of the explosive" if subject.reacted else "At rest"
    on = f"On the Hugoniot{' of the unreacted explosive' if subject.reacted else ''} at {at}"
    typer.echo(f"\n{on if at else rest}:")
    echo_states(state, *more[:-1])
    echo_notes(told)


def _parameters(par) -> dict:
    """Parameters that have a value; a law inside another one is a table of its own, with its name as `law`."""
    found = {}
    for name, value in zip(par._fields, par):
        if EOS.knows(value):
            found[name] = {"law": EOS.of(value).name, **_parameters(value)}
        elif getattr(value, "ndim", 0) or isinstance(value, (int, float)) and value == value:
            found[name] = value
    return found


def _parameter_rows(par, indent: str = "  ") -> list[tuple[str, str, str, str]]:
    """Name, value, unit and meaning of each, those of a law inside indented below it; of a table its extent."""
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


def _portrait(name: str, subject: Subject, state: States | None, path) -> None:
    """The picture of `show`: the planes of the field, or the detonation of products that have no unreacted explosive."""
    from hugoniot.dossier.fits import library_points
    from hugoniot.plotting.eos import detonations, save

    if subject.reacted and (state is None or subject.unreacted is None):
        from hugoniot.theory.chapman_jouguet import cj as tangency

        save(detonations([(subject.material.name, tangency(subject.material))]), path)
        return
    from hugoniot.plotting.waves import portrait

    inert = find_inert(name)
    save(portrait(inert.material.name, inert.material, state, library_points(inert.names)), path)
