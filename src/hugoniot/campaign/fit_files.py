"""The folder of a fit: the deck, what was found, data beside the model, draws of the posterior, and the report."""

import csv
import io
import pathlib
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from hugoniot.campaign.fit_results import Fit
from hugoniot.campaign.posterior import QUANTILES, Posterior
from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import digest, explained, legible, write_whole
from hugoniot.output.listed import read_listed, write_listed
from hugoniot.output.seal import sealed_json

FOUND, FITTED = "fit.json", "fitted.toml"
FILES = (FITTED, "residuals.csv", "posterior.csv", "predictive.csv")
MOST_DRAWS = 10_000      # that are written


def claimed(folder: pathlib.Path) -> pathlib.Path:
    """A folder that a fit may write into, made if it is not there. Raises `FileTrouble` where it holds anything but an earlier fit."""
    with explained(folder):
        folder.mkdir(parents=True, exist_ok=True)
        standing = sorted(path.name for path in folder.iterdir())
    foreign = [name for name in standing if name not in (FOUND, *FILES, "report.html", "run.log") and not name.endswith(".part")]
    if foreign:
        raise FileTrouble(f"{folder}: contains {foreign[0]}, which is not a file of a fit; choose another folder with --out")
    if standing and FOUND not in standing:
        raise FileTrouble(f"{folder}: contains {standing[0]}, but no {FOUND}, so it is not recognised as the folder of a fit; "
                          "choose another with --out")
    if FOUND in standing:
        _refuse_changed(folder)
    return folder


def _refuse_changed(folder: pathlib.Path) -> None:
    """A fit.json of something else, or a fitted deck that somebody has worked on since, is not replaced."""
    found = read_listed(folder / FOUND)
    if not {"parameters", "chi_square"} <= set(found):
        raise FileTrouble(f"{folder / FOUND}: this file was not written by a fit and would be overwritten; choose another folder with "
                          "--out")
    wanted, path = found["sha256"].get(FITTED), folder / FITTED
    with legible(path):
        if wanted is not None and path.exists() and digest(path).sha256 != wanted:
            raise FileTrouble(f"{path}: changed since the fit, and the changes would be lost; move it elsewhere "
                            f"or choose another folder with --out")


def record_of(found) -> dict[str, Any]:
    """A `run_fit.Fitted` as plain data."""
    drawn = {} if found.posterior is None else {"posterior": posterior_record(found.posterior)}
    return {**fit_record(found.fit), "notes": list(found.notes),
            "targets": [{"label": t.label, "name": t.name, "unit": t.unit, "points": len(t.values)} for t in found.targets], **drawn}


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

    record = _finite(record_of(found))
    write_whole(folder / FOUND, sealed_json(record))    # first, to mark the folder as a fit's; at the end with checksums
    write_whole(folder / FITTED, found.deck)
    rows = ([t.label, *(repr(float(v)) for v in (t.time[k], t.values[k], model[k], t.sigma[k], beside[k]))]
            for t, model in zip(found.targets, found.models) for beside in [t.beside(model)] for k in range(len(t.values)))
    heads = ["target", "time [s] or input pressure [Pa]", "data", "model", "sigma", "(model - data) / sigma"]
    _write_rows(folder / "residuals.csv", heads, rows)
    if found.posterior is None:
        for stale in ("posterior.csv", "predictive.csv"):     # of an earlier fit of the folder
            (folder / stale).unlink(missing_ok=True)
    else:
        _write_posterior(folder, found)
    write_listed(folder / FOUND, record, FILES)

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
    _write_rows(folder / "predictive.csv", ["target", "time [s] or input pressure [Pa]", "data", *heads], rows)


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
