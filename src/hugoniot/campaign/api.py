"""`hugoniot.sweep` and its relatives: campaigns from Python, which give xarray Datasets."""

import os
from collections.abc import Mapping, Sequence
from typing import Any

from hugoniot.campaign.ask import Wishes, engine_of, run_sweep
from hugoniot.campaign.sweep import TABLE
from hugoniot.output.sweep_file import open_sweep


def texts(vary: Mapping[str, Any] | Sequence[str] | str) -> list[str]:
    """What varies as texts: given as texts already, or as {key: "300..1200 m/s : 10"} or {key: [values]}."""
    if isinstance(vary, str):
        return [vary]
    if not isinstance(vary, Mapping):
        return list(vary)
    return [f"{key} = {value}" if isinstance(value, str) else f"{key} = {_listed(value)}" for key, value in vary.items()]


def _listed(values) -> str:
    """Numbers (SI), quantities such as "1 GPa", or names."""
    from hugoniot.units import UnitError, powers_of

    def one(value) -> str:
        if not isinstance(value, str):
            return repr(float(value)) if not isinstance(value, int) else str(value)
        try:
            powers_of(value)
        except UnitError:
            return f'"{value}"'
        return value

    values = values.tolist() if hasattr(values, "tolist") else values
    return ", ".join(one(value) for value in (values if isinstance(values, (list, tuple)) else [values]))


def sweep(deck: str | os.PathLike | None = None, vary: Mapping[str, Any] | Sequence[str] | str = (), *, tie: Sequence[str] = (),
          out: str | os.PathLike | None = None, workers: int | None = None, engine: str = "local", scheduler: str | None = None,
          materials: Sequence = (), report: bool = True, **options):
    """Run a deck many times with some of its keys varied, and return an xarray Dataset of the results.

    The parameters are the coordinates. Results are in SI, and NaN for a case that failed; the variable `reason` says why it failed, and
    the attribute `warnings` holds those of the runs, one per line.

    deck        path of a deck, which may contain a table [sweep]; None with `match`
    vary        what varies: {"region.flyer.velocity": "300..1200 m/s : 10", "material.al.fracture.strength": ["1 GPa", "2 GPa"]},
                or strings as for hugoniot sweep --vary
    tie         keys that follow from others, such as "region.target.to = region.flyer.to + 4 mm"
    out         folder to write (default: the deck's name with .sweep); cases that it already holds are not run again
    workers     number of processes (default: one per processor)
    engine      "local", or "dask" with the address of a `scheduler`
    scheduler   address of a Dask scheduler (default: workers on this machine)
    materials   files and folders with your own materials
    report      whether report.html is written
    options     design, samples, seed, match, output, record, keep, time_limit, uncertain: as the options of hugoniot sweep

    Raises `DeckError` and `FileTrouble`.

    >>> table = hugoniot.sweep("flyer.toml", {"region.flyer.velocity": "300..1200 m/s : 10"})
    """
    tie = [tie] if isinstance(tie, str) else list(tie)
    chosen = None if (engine, scheduler) == ("local", None) else engine_of(engine, scheduler, workers, options.get("time_limit"))
    asked = Wishes(vary=texts(vary), tie=tie, **options)
    swept = run_sweep(deck, asked, out, engine=chosen, materials=materials, workers=workers, report=report)
    return open_sweep(swept.folder / TABLE)


def fit(deck: str | os.PathLike, to: Sequence[str] | str, free: Mapping[str, str] | Sequence[str] | str, *, tie: Sequence[str] = (),
        out: Any = None, workers: int | None = None, materials: Sequence = (), **options):
    """Find constants of a deck from measured records, and return an xarray Dataset of the fitted parameters.

    For each `parameter` the Dataset has `value`, `sigma` (standard deviation), `low` and `high` (limits of the 95 % interval), in SI, and
    the SI `unit`; `correlation` has the dimensions (parameter, other). The attributes hold `reduced_chi_square`, whether the model
    `matches` the records (1 or 0), the text `doubts`, which should be read before a value is used, and the fitted `deck`.

    deck        path of the deck
    to          files of measured records (.csv), or numbers such as "free surface.arrival = 0.63 +- 0.01 us"
    free        constants to find and their ranges: {"material.al.fracture.strength": "0.5..3 GPa"}, or strings as for hugoniot fit --free
    tie         keys that follow from others, as for `sweep`
    out         folder to write (default: the deck's name with .fit); False writes nothing
    workers     number of processes (default: one per processor)
    materials   files and folders with your own materials
    options     gauge, sigma, window, shift, scale, loss, starts, seed, profile, local, posterior, posterior_runs: as the options of
                hugoniot fit

    With posterior="surrogate" or "runs" the Dataset also has `draws` (draw, parameter) of the posterior distribution, its `quantiles`,
    and the bands `prior_predictive` and `posterior_predictive` (level, point) of all data in the order given.

    Raises `DeckError`, `FileTrouble` and `NoSolution`.

    >>> found = hugoniot.fit("flyer.toml", "visar.csv", {"material.al.fracture.strength": "0.5..3 GPa"}, shift="20 ns")
    """
    import xarray

    from hugoniot.campaign.run_fit import FitWishes, run_fit

    asked = FitWishes([str(to)] if isinstance(to, (str, os.PathLike)) else [str(each) for each in to], texts(free),
                      [tie] if isinstance(tie, str) else list(tie), **options)
    found = run_fit(deck, asked, out, workers=workers, materials=materials)
    rows = found.fit.parameters
    columns = {name: ("parameter", [getattr(row, name) for row in rows])
               for name in ("value", "sigma", "low", "high", "profile_low", "profile_high", "at_end", "unit")}
    names = [row.name for row in rows]
    drawn, about = _posterior(found.posterior) if found.posterior is not None else ({}, {})
    return xarray.Dataset({**columns, "correlation": (("parameter", "other"), found.fit.correlation), **drawn},
                          {"parameter": names, "other": names},
                          {"reduced_chi_square": found.fit.reduced, "degrees_of_freedom": found.fit.freedom, "runs": found.fit.runs,
                           "matches": int(found.fit.matches), "doubts": "\n".join(found.fit.doubts), "deck": found.deck, **about})


def _posterior(p) -> tuple[dict[str, Any], dict[str, Any]]:
    """(columns, attributes) of a posterior."""
    import numpy as np

    columns = {"draws": (("draw", "parameter"), p.draws), "quantiles": (("quantile", "parameter"), p.quantiles),
               "prior_predictive": (("level", "point"), np.hstack(p.prior)),
               "posterior_predictive": (("level", "point"), np.hstack(p.predicted))}
    about = {"effective_draws": p.effective, "posterior_doubts": "\n".join(p.doubts)}
    return columns, about | ({} if p.surrogate is None else {"surrogate_log_error": p.surrogate.log_error})
