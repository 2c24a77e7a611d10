"""The report of `hugoniot eos riemann`: waves, contact or vacuum between two materials."""

import typer

from hugoniot.cli.eos.input import find_material, several_states
from hugoniot.cli.eos.output import cell, echo_notes, echo_states, notes, row_of, write_csv
from hugoniot.cli.eos.splits import jump_notes
from hugoniot.cli.show import echo_json, echo_table
from hugoniot.materials.initial_state import refuse_below_zero
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.isentrope import state
from hugoniot.theory.riemann import riemann


def report(materials: tuple[str, str], given_states: tuple[str, str], bonded: bool, as_json: bool, as_csv, plot) -> None:
    """Solve the problem of the material on the left and that on the right; print, write and draw what is asked."""
    subjects = [find_material(name) for name in materials]
    given = [several_states(text, option) if text else {} for text, option in zip(given_states, ("--left", "--right"))]
    states = [state(s.material, g.pop("velocity", 0.0), **g) for s, g in zip(subjects, given)]
    for subject, start in zip(subjects, states):
        refuse_below_zero(float(start.density), float(start.specific_internal_energy), subject.material.eos)
    found = riemann(subjects[0].material, states[0], subjects[1].material, states[1], bonded=bonded)
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.waves import riemann_waves

        save(riemann_waves((subjects[0].material.name, subjects[1].material.name), found, (states[0], states[1])), plot)
    jumps = [abs(found.velocity - s.particle_velocity) if w.kind == "shock" else 0.0 for s, w in zip(states, (found.left, found.right))]
    told = list(dict.fromkeys(text for s, start, jump in zip(subjects, states, jumps)
                              for text in (*jump_notes(s.material, jump, Initial.of(start)), *notes(s, jump))))
    told += [f"{s.material.name} stands for its detonation products, which start at {cell('pressure', start.pressure)} and "
             f"{start.density:.6g} kg/m3" for s, start in zip(subjects, states) if s.reacted]
    first = {f"{side}_initial": row_of(s.table()) for side, s in zip(("left", "right"), states)}
    waves = {side: {"wave": w.kind, "head": w.head, "tail": w.tail, **row_of(w.behind.table())}
             for side, w in (("left", found.left), ("right", found.right)) if w.behind.density > 0.0}
    if as_csv:
        write_csv(as_csv, [(s.material.name, w.behind.table()) for s, w in zip(subjects, (found.left, found.right))
                           if w.behind.density > 0.0])
    if as_json:
        echo_json({"pressure": found.pressure, "particle_velocity": found.velocity, "vacuum": found.vacuum, **first, **waves,
                   "edges": [{"what": what, "velocity": v} for what, v in found.jumps], "warnings": told})
        return
    for side, subject, s in zip(("left", "right"), subjects, states):
        known = row_of(s.table())
        shown = [cell(k, known[k]) for k in ("pressure", "density", "temperature", "particle_velocity") if known[k] is not None]
        what = " (detonation products)" if subject.reacted else ""
        typer.echo(f"{side}, initial{what}: {', '.join(shown)}")
    contact = f"contact: {cell('pressure', found.pressure)}, {cell('particle_velocity', found.velocity)}"
    typer.echo("a gap opens between the two" if found.vacuum else contact)
    echo_table(["edge", "velocity"], [(what, f"{v:.6g} m/s") for what, v in found.jumps])
    for side, wave in (("left", found.left), ("right", found.right)):
        if wave.behind.density > 0.0:
            typer.echo(f"\n{side}, {'undisturbed' if wave.kind == 'none' else f'behind the {wave.kind}'}:")
            echo_states(wave.behind)
    echo_notes(told)
