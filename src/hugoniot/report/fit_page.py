"""report.html of a fit: the values with their intervals, whether the model matches, residuals, correlations and the fitted deck."""

import pathlib

import numpy as np

from hugoniot.output.atomic import write_whole
from hugoniot.output.seal import sealed
from hugoniot.plotting.fit import draw_correlation, draw_target
from hugoniot.plotting.inline import svg
from hugoniot.plotting.posterior import draw_corner, draw_predictive
from hugoniot.report.sections import cards, number, table, text
from hugoniot.version import __version__


def page(title: str, fit: dict, records, deck: str, posterior=None) -> str:
    """The whole page as HTML text; fit as in fit.json, records as of `plotting.fit.draw_target`, posterior a `Posterior` or None."""
    css = (pathlib.Path(__file__).parent / "page.css").read_text(encoding="utf-8")
    doubts = "".join(f'<p class="warning">{text(words)}</p>' for words in fit["doubts"])
    doubts += "".join(f"<p>{text(words)}</p>" for words in fit["notes"])
    facts = cards([("reduced chi-square", number(float(f"{fit['reduced_chi_square']:.4g}"))),
                   ("degrees of freedom", str(fit["degrees_of_freedom"])), ("runs", str(fit["runs"]))])
    figures = []
    for k, shown in enumerate(records):
        if len(shown[3]) > 1:
            figures.append(svg(lambda above, below, s=shown: draw_target(above, below, s), f"record-{k}", 7.4, 4.2,
                               (0.8, 1.5, 6.3, 2.4), (0.8, 0.5, 6.3, 0.85)))
    names = [p["name"] for p in fit["parameters"]]
    if len(names) > 1:
        side = 0.55 * len(names)
        figures.append(svg(lambda ax: draw_correlation(ax, names, fit["correlation"]), "correlation", 3.2 + side, 1.8 + side,
                           (2.7, 1.4, side, side)))
    pictures = "".join(f"<figure>{picture}</figure>" for picture in figures)
    points = [[text(s[0]), number(float(s[4][0]), s[2]), number(float(s[6][0]), s[2]), f"{(s[6][0] - s[4][0]) / s[5][0]:+.2f}"]
              for s in records if len(s[3]) == 1]
    numbers = table(["quantity", "measured", "model", "(model − data) / σ"], points) if points else ""
    return "".join([
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{text(title)}</title><style>{css}</style></head><body><main><h1>{text(title)}</h1>",
        f"<p class=quiet>hugoniot {text(__version__)}</p>", doubts, facts,
        f"<section><h2>Parameters</h2>{_parameters(fit)}</section>",
        f"<section><h2>Data and model</h2>{pictures}{numbers}</section>",
        "" if posterior is None else f"<section><h2>Posterior</h2>{_posterior(fit['posterior'], posterior, records)}</section>",
        f"<section><h2>Fitted deck</h2><pre>{text(deck)}</pre></section></main></body></html>\n"])


def _parameters(fit: dict) -> str:
    rows = []
    for p in fit["parameters"]:
        def shown(key, p=p):
            return "–" if p[key] is None or p[key] != p[key] else number(float(f"{p[key]:.5g}"), p["unit"])

        rows.append([text(p["name"]), shown("value"), shown("sigma"), f"{shown('low')} to {shown('high')}",
                     f"{shown('profile_low')} to {shown('profile_high')}"])
    heads = ["parameter", "value", "standard deviation", "95 % interval", "95 % profile-likelihood interval"]
    profiled = any(p["profile_low"] == p["profile_low"] or p["profile_high"] == p["profile_high"] for p in fit["parameters"])
    return table(heads, rows) if profiled else table(heads[:-1], [row[:-1] for row in rows])


def _posterior(record: dict, posterior, records) -> str:
    """Quantiles, how good the draws and what they were drawn over are, every pair of parameters, and what prior and posterior predict."""
    def shown(value, unit):
        return number(float(f"{value:.5g}"), unit)

    rows = [[text(p["name"]), *(shown(v, p["unit"]) for v in (p["mean"], p["deviation"], p["quantiles"][2])),
             f"{shown(p['quantiles'][0], p['unit'])} to {shown(p['quantiles'][-1], p['unit'])}"] for p in record["parameters"]]
    facts = [("draws", str(record["draws"])), ("effective number of independent draws", f"{record['effective']:.0f}")]
    if "surrogate" in record:
        facts.append(("error of the surrogate in log probability (leave-one-out)", f"{record['surrogate']['log_error']:.2g}"))
    doubts = "".join(f'<p class="warning">{text(words)}</p>' for words in record["doubts"])
    count = len(posterior.names)
    side = 1.35 * count
    pictures = [svg(lambda *axes: draw_corner(np.array(axes).reshape(count, count), posterior), "corner", side + 1.2, side + 0.8,
                    *((0.9 + 1.35 * j, 0.6 + 1.35 * (count - 1 - i), 1.25, 1.25) for i in range(count) for j in range(count)))]
    for k, shown in enumerate(records):
        if len(shown[3]) > 1:
            pictures.append(svg(lambda ax, k=k, s=shown: draw_predictive(ax, s, posterior.prior[k], posterior.predicted[k]),
                                f"predictive-{k}", 7.4, 3.2, (0.8, 0.5, 6.3, 2.4)))
    heads = ["parameter", "mean", "standard deviation", "median", "95 % interval"]
    return doubts + cards(facts) + table(heads, rows) + "".join(f"<figure>{picture}</figure>" for picture in pictures)


def write_fit_report(folder, title: str, fit: dict, records, deck: str, posterior=None) -> pathlib.Path:
    """Write report.html into the folder of a fit; gives its path. Raises `FileTrouble`."""
    path = pathlib.Path(folder) / "report.html"
    write_whole(path, sealed(page(title, fit, records, deck, posterior), "<!-- ", " -->\n"), durable=False)
    return path
