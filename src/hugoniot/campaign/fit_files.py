"""The folder of a fit: the deck, what was found, data beside the model, draws of the posterior, and the report."""

import csv
import io
import json
import pathlib
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from hugoniot.campaign.fit_results import Fit
from hugoniot.campaign.posterior import QUANTILES, Posterior
from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import explained, write_whole

OURS = ("fitted.toml", "fit.json", "residuals.csv", "posterior.csv", "predictive.csv", "report.html", "run.log")
MOST_DRAWS = 10_000      # that are written


def claimed(folder: pathlib.Path) -> pathlib.Path:
    """A folder that a fit may write into, made if it is not there. Raises `FileTrouble`."""
    with explained(folder):
        folder.mkdir(parents=True, exist_ok=True)
        foreign = sorted(path.name for path in folder.iterdir() if path.name not in OURS and not path.name.endswith(".part"))
    if foreign:
        raise FileTrouble(f"{folder}: contains {foreign[0]} and is not the folder of a fit; choose another folder with --out")
    return folder


def record_of(found) -> dict[str, Any]:
    """A `run_fit.Fitted` as plain data."""
    drawn = {} if found.posterior is None else {"posterior": posterior_record(found.posterior)}
    return {**fit_record(found.fit), "notes": list(found.notes),
            "targets": [{"label": t.label, "name": t.name, "points": len(t.values)} for t in found.targets], **drawn}


def fit_record(fit: Fit) -> dict[str, Any]:
    """A fit as plain data."""
    return {"parameters": [asdict(p) for p in fit.parameters], "correlation": fit.correlation.tolist(), "chi_square": fit.chi_square,
            "degrees_of_freedom": fit.freedom, "reduced_chi_square": fit.reduced, "probability": fit.probability, "matches": fit.matches,
            "others": [{"values": list(values), "chi_square": cost} for values, cost in fit.others], "doubts": list(fit.doubts),
            "runs": fit.runs}


def posterior_record(p: Posterior) -> dict[str, Any]:
    """What a posterior says, without its draws."""
    stand_in = p.surrogate
    error = {} if stand_in is None else {"surrogate": {"log_error": stand_in.log_error, "errors": stand_in.errors}}
    rows = [{"name": name, "unit": unit, "mean": float(p.mean[k]), "deviation": float(p.deviation[k]),
             "quantiles": [float(q) for q in p.quantiles[:, k]], "autocorrelation": float(p.autocorrelation[k])}
            for k, (name, unit) in enumerate(zip(p.names, p.units))]
    return {"kind": p.kind, "parameters": rows, "levels": list(QUANTILES), "correlation": p.correlation.tolist(), "draws": len(p.draws),
            "effective": p.effective, "doubts": list(p.doubts), **error}


def write_fit(folder: pathlib.Path, found, name: str) -> None:
    """Write everything of a fit into its folder; `name` is that of the deck."""
    from hugoniot.report import write_or_note

    write_whole(folder / "fitted.toml", found.deck)
    write_whole(folder / "fit.json", json.dumps(_finite(record_of(found)), indent=2) + "\n")
    rows = ([t.label, *(repr(float(v)) for v in (t.time[k], t.values[k], model[k], t.sigma[k], beside[k]))]
            for t, model in zip(found.targets, found.models) for beside in [t.beside(model)] for k in range(len(t.values)))
    heads = ["target", "time [s] or input pressure [Pa]", "data", "model", "sigma", "(model - data) / sigma"]
    _write_rows(folder / "residuals.csv", heads, rows)
    if found.posterior is None:
        for stale in ("posterior.csv", "predictive.csv"):     # of an earlier fit of the folder
            (folder / stale).unlink(missing_ok=True)
    else:
        _write_posterior(folder, found)

    def report(place) -> None:
        from hugoniot.report.fit_page import write_fit_report

        shown = [(t.label, t.name, t.unit, t.time, t.values, t.sigma, model) for t, model in zip(found.targets, found.models)]
        write_fit_report(place, f"Fit of {name}", record_of(found), shown, found.deck, found.posterior)

    write_or_note(folder, report)


def _write_posterior(folder: pathlib.Path, found) -> None:
    """Draws, one a line, and the bands in which runs of prior and posterior lie."""
    p = found.posterior
    draws = p.draws[np.linspace(0, len(p.draws) - 1, min(len(p.draws), MOST_DRAWS)).astype(int)]
    _write_rows(folder / "posterior.csv", [f"{name} [{unit}]" for name, unit in zip(p.names, p.units)],
                ([repr(float(v)) for v in row] for row in draws))
    heads = [f"{which} {q:g} quantile" for which in ("prior", "posterior") for q in (0.025, 0.5, 0.975)]
    rows = ([t.label, *(repr(float(v)) for v in (t.time[k], t.values[k], *prior[:, k], *after[:, k]))]
            for t, prior, after in zip(found.targets, p.prior, p.predicted) for k in range(len(t.values)))
    _write_rows(folder / "predictive.csv", ["target", "time [s]", "data", *heads], rows)


def _write_rows(path: pathlib.Path, heads: Sequence[str], rows: Iterable[list]) -> None:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    write_whole(path, out.getvalue())


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_finite(inner) for inner in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
