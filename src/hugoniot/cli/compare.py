"""hugoniot compare: two runs, or a run and measured data, side by side."""

import dataclasses
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.opened import opened, partial_words
from hugoniot.cli.show import JSON, echo_json, echo_table
from hugoniot.units import format_si

FIRST = ("velocity", "stress", "velocity_x", "velocity_y", "normal_velocity", "line_velocity", "pressure")
_SHIFT = "shift in time: how much later b (the second) reaches half of the largest change of a (the first); no record was shifted"


def command(
    run: Annotated[Path, typer.Argument(help="A run folder.")],
    other: Annotated[Path, typer.Argument(help="Another run folder, or a CSV file with column headers such as 'time [us], velocity [m/s]'.",
                                           readable=False)],
    gauge: Annotated[str | None, typer.Option("--gauge", help="Gauge of the run to compare measured data with.")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Picture to write (.png, .pdf, .svg).")] = None,
    as_json: JSON = False,
) -> None:
    """Compare two runs, or a run and measured data, gauge by gauge: mean, root mean square and largest difference, and shift in time.

    Velocities and stress, or pressure in two dimensions, are printed first, the largest differences at the top. A column of measured data
    that names no gauge is compared with the surface of the body that was hit, or with the deck's only gauge; --gauge chooses another. The
    records are not shifted before they are compared. The shift in time says how much later OTHER reaches half of the largest change seen
    in RUN.

    Example: hugoniot compare flyer.run visar.csv --plot compare.png
    """
    from hugoniot.cli.plot import drawable
    from hugoniot.output.compare import compare

    if plot is not None:
        drawable(plot, "compare", "--plot")
    with opened(run) as first, opened(other) if other.is_dir() else nullcontext(other) as second:
        found = compare(first, second, gauge)
        partial = [f"{name}: {words}" for name, each in (("a", first), ("b", second)) if (words := partial_words(each))]
        found = dataclasses.replace(found, name_a=str(run), name_b=str(other), notes=(*partial, *found.notes))
    if as_json:
        echo_json({"a": found.name_a, "b": found.name_b, "pairs": found.rows(), "unmatched": list(found.unmatched),
                   "notes": list(found.notes)})
    else:
        typer.echo(f"a = {found.name_a}, b = {found.name_b}")
        for note in found.notes:
            typer.echo(note)
        rows, differing = [], [row for row in found.rows() if row["linf"] != 0.0]
        for r in sorted(differing, key=lambda row: (row["field"] not in FIRST, -row["l1_relative"])):
            shift = "none" if r["time_shift"] is None else format_si(r["time_shift"], "s", 3)
            norms = [f"{format_si(r[n], r['unit'], 4)} ({r[n + '_relative']:.2%})" for n in ("l1", "l2", "linf")]
            rows.append((r["gauge"], r["field"], *norms, shift))
        if rows:
            echo_table(["gauge", "field", "mean |b-a|", "rms", "largest", "shift in time"], rows)
            for start, end in dict.fromkeys((p.norms.start, p.norms.end) for p in found.pairs if _partly(p)):
                typer.echo(f"compared from {format_si(start, 's', 4)} to {format_si(end, 's', 4)}, where both records have values")
            typer.echo(_SHIFT)
        equal = [f"{row['field']} ({row['gauge']})" if row["gauge"] else row["field"] for row in found.rows() if row["linf"] == 0.0]
        if equal:
            typer.echo(f"equal: {', '.join(equal)}" if rows else f"all {len(equal)} records are equal")
        if found.unmatched:
            typer.echo(f"without a counterpart: {', '.join(found.unmatched)}")
    if plot is not None:
        from hugoniot.plotting import save_comparison

        save_comparison(found, plot)
        typer.echo(f"wrote {plot}", err=as_json)


def _partly(pair) -> bool:
    """Whether a record of the run was compared over a part of its time only, to a hundredth."""
    times, norms = pair.a.time, pair.norms
    return bool(norms.end - norms.start < 0.99 * (times[-1] - times[0]))
