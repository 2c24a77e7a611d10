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
    """Run a deck with some of its keys varied; return an xarray Dataset of the results with the parameters as coordinates.

    deck       path of a deck, or of a file with a [sweep] table; None for impedance matches
    vary       {"region.flyer.velocity": "300..1200 m/s : 10", "material.al.fracture.strength": ["1 GPa", "2 GPa"]}, or strings
    tie        strings such as "region.target.to = region.flyer.to + 4 mm"
    out        folder (default: the deck's name with .sweep); cases that are already there are not run again
    workers    processes (default: one for each processor)
    engine     "local", or "dask"; with Dask, `scheduler` is the address of a scheduler (None: workers on this machine)
    materials  files and folders of your own materials
    options    design, samples, seed, match, output, record, keep, time_limit, uncertain: as the options of `hugoniot sweep`

    Results are in SI units. Where a case failed they are NaN, and the variable `reason` says why. Raises `DeckError` and `FileTrouble`.
    """
    tie = [tie] if isinstance(tie, str) else list(tie)
    chosen = None if (engine, scheduler) == ("local", None) else engine_of(engine, scheduler, workers, options.get("time_limit"))
    asked = Wishes(vary=texts(vary), tie=tie, **options)
    swept = run_sweep(deck, asked, out, engine=chosen, materials=materials, workers=workers, report=report)
    return open_sweep(swept.folder / TABLE)


def fit(deck: str | os.PathLike, to: Sequence[str] | str, free: Mapping[str, str] | Sequence[str] | str, *, tie: Sequence[str] = (),
        out: Any = None, workers: int | None = None, materials: Sequence = (), **options):
    """Find constants of a deck from measured records; return a Dataset of the parameters with intervals and correlations.

    to       files of measured records, or numbers such as "free surface.arrival = 0.69 +- 0.01 us"
    free     {"material.ta.fracture.strength": "1..8 GPa"}, or strings
    out      folder (default: the deck's name with .fit); False writes nothing
    tie      strings such as "region.target.to = region.flyer.to + 4 mm"
    options  gauge, sigma, window, shift, scale, loss, starts, seed, profile, local, posterior: as the options of `hugoniot fit`

    Values are in SI units. The attributes are the reduced chi-square, `matches` (whether the model matches the data), `doubts` (to be
    read before a value is used) and `deck` (the text of the fitted deck).

    With posterior="surrogate" or "runs" the Dataset also has the `draws` (draw, parameter) of the posterior, its `quantiles`, and the
    bands `prior_predictive` and `posterior_predictive` (level, point) of all data in the order given.

    Raises `DeckError`, `FileTrouble`, `NoSolution`.
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
