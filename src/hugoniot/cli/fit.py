"""hugoniot fit: constants of a deck from measured records."""

import time
from pathlib import Path
from typing import Annotated

import typer

from hugoniot.cli.show import JSON, MATERIALS, echo_json, echo_table
from hugoniot.units import format_si

_TO = 'Measured record or Pop plot (.csv), or a measured number such as "free surface.arrival = 0.63 +- 0.01 us"; repeatable.'
_FREE = 'Constant to find and its range, such as "material.al.fracture.strength = 0.5..3 GPa"; repeatable.'


def command(
    deck: Annotated[Path, typer.Argument(help="The deck, a TOML file.", readable=False)],
    to: Annotated[list[str] | None, typer.Option("--to", help=_TO)] = None,
    free: Annotated[list[str] | None, typer.Option("--free", "-f", help=_FREE)] = None,
    tie: Annotated[list[str] | None, typer.Option("--tie", help='Key that follows from others, such as "region.target.from = '
        'region.flyer.to"; repeatable.')] = None,
    gauge: Annotated[str | None, typer.Option("--gauge", help="Gauge that columns without a gauge name are compared with.")] = None,
    sigma: Annotated[str | None, typer.Option("--sigma", help='Standard deviation of records that give none, such as "5 m/s".')] = None,
    window: Annotated[list[str] | None, typer.Option("--window", help='Range of times used, such as "0.5..2 us", or for one file '
        '"FILE = 0.5..2 us"; repeatable.')] = None,
    shift: Annotated[str | None, typer.Option("--shift", help='Also fit a time shift of the records within this limit, such as "20 '
        'ns".')] = None,
    scale: Annotated[str | None, typer.Option("--scale", help='Also fit a scale factor of the records within this limit, such as "2 '
        '%".')] = None,
    loss: Annotated[str, typer.Option("--loss", help="Loss function: linear, or soft_l1, huber or cauchy for data with "
                                                     "outliers.")] = "linear",
    starts: Annotated[int, typer.Option("--starts", help="Number of searches from different starting points.")] = 2,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the random starting points.")] = 0,
    profile: Annotated[bool, typer.Option("--profile", help="Also find 95 % limits of each constant by profile likelihood.")] = False,
    local: Annotated[bool, typer.Option("--local", help="Do not search the whole ranges if no search leads to a match.")] = False,
    posterior: Annotated[str | None, typer.Option("--posterior", help="Sample the posterior distribution with a surrogate model "
        "(surrogate) or with runs (runs).")] = None,
    posterior_runs: Annotated[int | None, typer.Option("--posterior-runs", help="Number of runs for the posterior distribution.")] = None,
    workers: Annotated[int | None, typer.Option("--workers", "-w", help="Number of worker processes (default: one per processor).")] = None,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="Folder to write (default: DECK.fit).")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Picture to write (.png, .pdf, .svg).")] = None,
    materials: MATERIALS = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show no progress.")] = False,
    as_json: JSON = False,
) -> None:
    """Find constants of a deck so that its runs agree with measured records, with intervals and correlations.

    A record is a CSV file whose columns have units in their headers, such as time [us], velocity [m/s] and, for the uncertainty, velocity
    sigma [m/s]. Columns pressure [GPa], distance [mm] are a Pop plot (run distance to detonation
    against input pressure) of the deck's explosive.

    The folder DECK.fit receives fitted.toml (the deck with the fitted values, ready to run), fit.json, residuals.csv and report.html. A
    record that the model cannot match is reported: read the notes before you use a value.

    Example: hugoniot fit flyer.toml --to visar.csv --free "material.al.fracture.strength = 0.5..3 GPa" --shift "20 ns"
    """
    from hugoniot.campaign.fit_files import record_of
    from hugoniot.campaign.run_fit import FitWishes, run_fit

    if plot is not None:
        from hugoniot.cli.plot import drawable

        drawable(plot, "fit", "--plot")
    wishes = FitWishes(list(to or ()), list(free or ()), list(tie or ()), gauge, sigma, list(window or ()), shift, scale, loss, starts,
                       seed, profile, local, posterior, posterior_runs)
    found = run_fit(deck, wishes, out, workers=workers, materials=materials or (), show=None if quiet or as_json else _show())
    if plot is not None:
        from hugoniot.plotting.eos import save
        from hugoniot.plotting.fit import fit_figure

        save(fit_figure([(t.label, t.name, t.unit, t.time, t.values, t.sigma, m) for t, m in zip(found.targets, found.models)]), plot)
    echo_json({"folder": str(found.folder), **record_of(found)}) if as_json else _echo(found)


def _show():
    last = [time.monotonic()]

    def show(runs: int) -> None:
        now = time.monotonic()
        if now - last[0] > 2.0:
            last[0] = now
            typer.echo(f"{runs} runs", err=True)

    return show


def _echo(found) -> None:
    fit = found.fit
    for note in found.notes:
        typer.echo(note)
    rows = []
    for p in fit.parameters:
        cells = [p.name, format_si(p.value, p.unit, 5), format_si(p.sigma, p.unit, 2),
                 f"{format_si(p.low, p.unit, 5)} .. {format_si(p.high, p.unit, 5)}"]
        if p.profile_low == p.profile_low or p.profile_high == p.profile_high:
            cells.append(" .. ".join("?" if v != v else format_si(v, p.unit, 5) for v in (p.profile_low, p.profile_high)))
        rows.append(cells)
    widest = max(len(row) for row in rows)
    heads = ["parameter", "value", "standard deviation", "95 % interval", "95 % by profile"][:widest]
    echo_table(heads, [row + ["?"] * (widest - len(row)) for row in rows])
    degrees = f"{fit.freedom} degree{'' if fit.freedom == 1 else 's'} of freedom"
    typer.echo(f"\nreduced chi-square {fit.reduced:.4g} for {degrees}; {fit.runs} runs")
    for doubt in fit.doubts:
        typer.echo(f"note: {doubt}")
    if found.posterior is not None:
        _echo_posterior(found.posterior)
    typer.echo(f"fitted deck in {found.folder / 'fitted.toml'}, report: {found.folder / 'report.html'}")


def _echo_posterior(p) -> None:
    where = "a surrogate" if p.surrogate else "runs of the deck"
    typer.echo(f"\nposterior sampled with {where}: {len(p.draws)} draws, equivalent to {p.effective:.0f} independent ones")
    if p.surrogate:
        missed = ", ".join(f"{name} {error:.2g} sigma" for name, error in p.surrogate.errors.items())
        typer.echo(f"in leave-one-out tests the surrogate misses the logarithm of the probability by {p.surrogate.log_error:.2g}; {missed}")
    echo_table(["parameter", "mean", "standard deviation", "median", "95 % interval", "autocorrelation"],
               [[name, format_si(p.mean[k], unit, 5), format_si(p.deviation[k], unit, 2), format_si(p.quantiles[2, k], unit, 5),
                 f"{format_si(p.quantiles[0, k], unit, 5)} .. {format_si(p.quantiles[-1, k], unit, 5)}",
                 f"{p.autocorrelation[k]:.0f} steps"]
                for k, (name, unit) in enumerate(zip(p.names, p.units))])
    for doubt in p.doubts:
        typer.echo(f"note: {doubt}")
