"""The report of `hugoniot eos match`: states at the interfaces with their error bars."""

import typer

from hugoniot.cli.eos.input import Subject, error_bars
from hugoniot.cli.eos.output import SHOWN, cell, echo_notes, notes, row_of, write_csv
from hugoniot.cli.eos.splits import jump_notes
from hugoniot.cli.show import echo_json, echo_table, quantity
from hugoniot.errors import DeckError, HugoniotError, NoSolution, OutOfRange
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.theory.impedance import Match, first_jump, match
from hugoniot.theory.impedance import ring_up as ringing

LIBRARY = "library"     # as an error: the covariance of the library's own fits
ANSWERS = ("pressure", "particle_velocity", "shock_velocity", "density", "specific_internal_energy")


def report(subjects: list[Subject], velocity, error, samples, ring_up, as_json, as_csv, plot) -> None:
    """Solve, then print, write and draw what is asked."""
    layers = [s.material for s in subjects]
    names = [m.name for m in layers]

    def solve(laws, speed):
        return ringing(laws, speed, bounces=ring_up) if ring_up else match(laws, speed)

    met = _met(subjects, lambda laws: solve(laws, velocity))
    spreads = _spreads(subjects, velocity, error, samples, solve) if error else []
    rows = [_row(m, names, spread) for m, spread in zip(met, spreads or [{}] * len(met), strict=True)]
    told = _told(subjects, velocity, met)
    if plot:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.matches import impedance_match

        save(impedance_match(layers, velocity, met), plot)
    if as_csv:
        keys = ("pressure", "particle_velocity", "shock_velocity", "density", "specific_internal_energy", "temperature", "sound_speed")
        bars = {f"{k}_sigma": [r.get("uncertainty", {}).get(k, {}).get("sigma", float("nan")) for r in rows] for k in ANSWERS}
        values = {k: [r[k] if r[k] is not None else float("nan") for r in rows] for k in keys}
        write_csv(as_csv, [("", values | (bars if spreads else {}))])
    if as_json:
        echo_json({"flyer": names[0], "targets": names[1:], "velocity": velocity, "states": rows, "warnings": told})
        return
    typer.echo(f"{names[0]} at {velocity:.6g} m/s onto {', '.join(names[1:])}; states to the right of each interface, "
               "in chronological order")
    heads = ["interface", "pressure, GPa", "particle velocity, m/s", "shock velocity, m/s", "density, kg/m3", "reflected", "transmitted"]
    echo_table(heads, [[r["interface"], *(_with_error(k, r) for k in ANSWERS[:4]), r["reflected"], r["transmitted"]] for r in rows])
    echo_notes(told)


def _met(subjects: list[Subject], solve):
    """The states, or the error with the material whose law ends too early and the rows of the library that reach far enough."""
    layers = [s.material for s in subjects]
    try:
        return solve(layers)
    except (OutOfRange, NoSolution) as error:
        for subject in subjects:
            law, rho = EOS.of(subject.material.eos).name, reference_state(subject.material.eos)[0]
            if f"'{law}'" in str(error) and f"density ahead {rho:.6g} kg/m3" in str(error):
                rows = [row for row in _other_rows(subject) if _reaches(layers, subject.material.name, row, solve)]
                name = subject.material.name
                raise type(error)(f"material '{name}': {error}{_advice(rows, name)}") from None
        raise


def _advice(rows: list[str], name: str) -> str:
    """What to give in place of a material: the rows that reach further, in words; empty without any."""
    if not rows:
        return ""
    if len(rows) == 1:
        return f"; row {rows[0]} of the library reaches further: give it in place of '{name}'"
    return f"; rows {', '.join(rows[:-1])} and {rows[-1]} of the library reach further: give one of them in place of '{name}'"


def _other_rows(subject: Subject) -> list[str]:
    """Rows of the library with a Tillotson law of the same name, which holds at any compression."""
    from hugoniot.materials.schema import table
    from hugoniot.materials.search import spelling

    wanted = {spelling(name) for name in subject.names}
    return [row.id for row in table("tillotson").values() if spelling(row.material) in wanted]


def _reaches(layers, name: str, row: str, solve) -> bool:
    """Whether the match succeeds with a row of the library in place of the material."""
    from hugoniot.materials.library import find

    try:
        solve([find(row) if layer.name == name else layer for layer in layers])
    except (HugoniotError, ArithmeticError, ValueError):
        return False
    return True


def waves(subjects: list[Subject], velocity, thicknesses, until, as_json, as_csv, plot) -> None:
    """Follow all waves in time and space; print what meets at interfaces and free surfaces."""
    from hugoniot.theory.waves import wave_diagram

    layers = [s.material for s in subjects]
    names = [m.name for m in layers]
    found = wave_diagram(layers, thicknesses, velocity, until, fan=4, smallest=0.01, most_events=3000)
    if plot:
        from hugoniot.plotting.eos import save, waves_in_time

        save(waves_in_time(found, names), plot)
    rows = [_event(e, names) for e in found.events if e.layers[0] != e.layers[1]]
    told = _told(subjects, velocity, match(layers, velocity))
    if as_csv:
        keys = ("time", "position", "pressure", "particle_velocity")
        write_csv(as_csv, [("", {k: [r[k] for r in rows] for k in keys})])
    if as_json:
        echo_json({"flyer": names[0], "targets": names[1:], "velocity": velocity, "until": found.time, "states": rows,
                   "paths": [dict(zip(("kind", "start_time", "start", "end_time", "end"), p)) for p in found.paths], "warnings": told})
        return
    typer.echo(f"{names[0]} at {velocity:.6g} m/s; events at interfaces and free surfaces until {found.time * 1e6:.6g} us")
    echo_table(["time, us", "position, mm", "where", "pressure, GPa", "velocity, m/s"],
               [[f"{r['time'] * 1e6:.4f}", f"{r['position'] * 1e3:.4f}", r["interface"], cell("pressure", r["pressure"], unit=False),
                 cell("particle_velocity", r["particle_velocity"], unit=False)] for r in rows])
    echo_notes(told)


def _event(event, names: list[str]) -> dict:
    """A meeting at an interface or a surface as a row: the state of the material there afterwards."""
    sides = [names[k] if k >= 0 else "free surface" for k in event.layers]
    state = event.right or event.left
    return {"time": event.time, "position": event.position, "interface": "/".join(sides), "met": list(event.met),
            "pressure": state.pressure if state else None, "particle_velocity": state.particle_velocity if state else None}


def _told(subjects: list[Subject], velocity: float, met: list[Match]) -> list[str]:
    """The notes about every layer, each once."""
    jumps = [first_jump(i, velocity, met) for i in range(len(subjects))]
    return list(dict.fromkeys(text for s, jump in zip(subjects, jumps) for text in (*jump_notes(s.material, jump), *notes(s, jump))))


def _row(m: Match, names: list[str], spread) -> dict:
    """One interface: the state on its right under the field's words, the other side under `left`."""
    row = {"interface": f"{names[m.interface]}/{names[m.interface + 1]}", **row_of(m.right.table()), "separated": m.separated,
           "reflected": _word(m.wave_left), "transmitted": _word(m.wave_right),
           "left": {"material": names[m.interface], **row_of(m.left.table())}}
    if spread:
        row["uncertainty"] = {k: {"sigma": s.sigma, "low": s.low, "high": s.high, "shares": s.shares} for k, s in spread.items()}
    return row


def _word(kind: str) -> str:
    return {"fan": "release", "none": "-"}.get(kind, kind)


def _with_error(key: str, row: dict) -> str:
    text = cell(key, row[key], unit=False)
    if "uncertainty" in row and key in row["uncertainty"]:
        text += f" +- {row['uncertainty'][key]['sigma'] * SHOWN[key][1]:.2g}"
    return text


def _spreads(subjects: list[Subject], velocity, error, samples, solve) -> list[dict]:
    """The error bars of each state that `solve` gives: parameters are named MATERIAL.parameter, for all layers of that name."""
    from hugoniot.dossier.fits import uncertain
    from hugoniot.theory.uncertainty import matched, propagate

    layers = [s.material for s in subjects]
    values, sigmas, together = uncertain((s.rows, s.material) for s in subjects if LIBRARY in error)
    if LIBRARY in error and not sigmas:
        raise DeckError.single("command line", None, "--error", "the package has fitted no Hugoniot of these materials itself",
                               'give their errors: "copper.c0 = 20 m/s"')
    values["velocity"] = velocity
    for key, text in error_bars([text for text in error if text != LIBRARY]).items():
        layer, dot, parameter = key.rpartition(".")
        if key == "velocity":
            sigmas[key] = quantity(text, "m/s", "--error velocity")
            continue
        owners = [m for m in layers if m.name == layer]
        if not dot or not owners or parameter not in owners[0].eos._fields:
            known = ", ".join(f"{m.name}.{f}" for m in dict.fromkeys(layers) for f in m.eos._fields)
            raise DeckError.single("command line", None, "--error", f"'{key[:60]}' is not an input of this match",
                                   f"the inputs are velocity, {known}")
        values[key] = float(getattr(owners[0].eos, parameter))
        sigmas[key] = quantity(text, EOS.of(owners[0].eos).units.get(parameter, "1"), f"--error {key}")

    flat = propagate(matched(layers, ANSWERS, solve), values, sigmas, correlation=together, samples=samples)
    count = 1 + max(int(k.partition(".")[0]) for k in flat)
    return [{k.partition(".")[2]: s for k, s in flat.items() if k.startswith(f"{i}.")} for i in range(count)]
