"""report.html of a sweep: what was asked, pictures of the results, the table of cases, and why cases failed."""

import collections
import pathlib

from hugoniot.dossier.uncertainty import AT_LEAST
from hugoniot.output.atomic import write_whole
from hugoniot.output.seal import sealed
from hugoniot.output.sweep_file import Column, SweepTable, together
from hugoniot.plotting.inline import svg
from hugoniot.plotting.sensitivity import draw_sensitivity
from hugoniot.plotting.sweep import (
    LEAST_FOR_BANDS,
    banded,
    draw,
    draw_bands,
    draw_records,
    draw_spread,
    kind_of,
    worth_drawing,
)
from hugoniot.report.sections import cards, number, table, text

_BANDS = "the median, with bands containing 68 and 95 % of the cases"
MOST_ROWS = 400        # of the table on the page; cases.csv has all


def page(swept: SweepTable, title: str, asked: str, version: str, sensitivity=None, constants=()) -> str:
    """The whole page as HTML text; `asked` says what was varied, `sensitivity` has rows of indices or effects by result, `constants` those
    of materials: name, constant, value, unit, standard deviation, sources."""
    css = (pathlib.Path(__file__).parent / "page.css").read_text(encoding="utf-8")
    failed = [reason for reason in swept.reasons if reason]
    numbers = cards([("cases", str(len(swept))), ("failed", str(len(failed))), ("design", text(swept.attributes.get("design", ""))),
                     ("seed", text(swept.attributes.get("seed", "")))])
    drawn = _spreads(swept) if constants else _pictures(swept)
    pictures = "".join(f"<figure>{picture}<figcaption>{text(words)}</figcaption></figure>" for picture, words in drawn)
    reasons = collections.Counter(failed).most_common(20)
    why = table(["cases", "reason"], [[str(count), text(reason)] for reason, count in reasons]) if reasons else ""
    return "".join([
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{text(title)}</title><style>{css}</style></head><body><main><h1>{text(title)}</h1>",
        f"<p class=quiet>hugoniot {text(version)}</p><pre>{text(asked)}</pre>", numbers,
        *(f'<p class="warning">{text(words)}</p>' for words in swept.warnings),
        _sensitivities(swept, sensitivity or {}),
        f"<section><h2>Results</h2>{pictures}</section>" if pictures else "",
        _constants(constants),
        f"<section><h2>Cases that failed</h2>{why}</section>" if why else "",
        f"<section><h2>Cases</h2>{_rows(swept)}</section></main></body></html>\n"])


def _sensitivities(swept: SweepTable, sensitivity) -> str:
    figures = []
    for k, column in enumerate(worth_drawing(swept)):
        rows = sensitivity.get(column.name)
        if rows:
            height = 0.42 * len(rows) + 0.4 if hasattr(rows[0], "total") else 2.6
            picture = svg(lambda ax, r=rows, c=column: draw_sensitivity(ax, r, c), f"sensitivity-{k}", 7.4, height + 0.9,
                          (2.3 if hasattr(rows[0], "total") else 0.8, 0.5, 4.6, height))      # names left of bars, right of points
            lost = f" Base cases without a value, which are left out: {rows[0].lost}." if rows[0].lost else ""
            words = ("Sobol' indices with 95 % intervals." if hasattr(rows[0], "total") else
                     "Morris' elementary effects, each over the whole range of its parameter: points further right "
                     "have a stronger influence; points further up a nonlinear influence or an interaction.")
            figures.append(f"<figure>{picture}<figcaption>{text(words + lost)}</figcaption></figure>")
    return f"<section><h2>Sensitivity</h2>{''.join(figures)}</section>" if figures else ""


def _pictures(swept: SweepTable) -> list[tuple[str, str]]:
    kind = kind_of(swept)
    found = []
    for k, record in enumerate(swept.records):
        found.append((svg(lambda ax, r=record: draw_records(ax, swept, r), f"record-{k}", 7.4, 3.2, (0.7, 0.5, 6.0, 2.3)),
                      f"Records of {record.name}: " + (_BANDS if banded(swept, record) else "one line for each case") + "."))
    for k, result in enumerate(worth_drawing(swept)):
        rects = {"map": [(0.8, 0.5, 5.2, 2.5), (6.3, 0.5, 0.14, 2.5)], "family": [(0.9, 0.5, 4.6, 2.4)]}.get(kind, [(0.9, 0.5, 5.9, 2.4)])
        picture = svg(lambda ax, bar=None, r=result: draw(ax, swept, r, bar), f"result-{k}", 7.4, 3.2, *rects)
        found.append((picture, _caption(swept, result)))
    return found


def _spreads(swept: SweepTable) -> list[tuple[str, str]]:
    """The records of a sample of constants, and how far apart they lie."""
    if swept.times is None or len(together(swept.records[0].values)) < LEAST_FOR_BANDS:
        return _pictures(swept)
    found = []
    for k, record in enumerate(swept.records):
        for name, draw_one, words in (
                ("record", draw_bands, _BANDS),
                ("spread", draw_spread, "the same bands, relative to the median")):
            picture = svg(lambda ax, d=draw_one, r=record: d(ax, swept.times, r), f"{name}-{k}", 7.4, 3.2, (0.8, 0.5, 6.0, 2.3))
            found.append((picture, f"{record.name}: {words}."))
    return found


def _named(swept: SweepTable) -> str:
    """The parameter of a grid that has names, not numbers."""
    return next((column.name for column in swept.steps if column.values.dtype.kind != "f"), "case")


def _caption(swept: SweepTable, result: Column) -> str:
    return {"map": f"{result.name} over both parameters; blank or – where a case has no value.",
            "line": f"{result.name}.", "family": f"{result.name}, a line for each {_named(swept)}.",
            "points": f"{result.name}, a dot for each case."}[kind_of(swept)]


def _constants(rows) -> str:
    """The constants that varied, and how many others have no known uncertainty."""
    if not rows:
        return ""
    shown = [[text(material), text(name), number(float(value), unit), number(float(deviation), unit) if deviation else "",
              text(words)] for material, name, value, unit, deviation, words in rows if deviation]
    held = [f"{material}: {name} ({words})" for material, name, _, _, deviation, words in rows if name and not deviation]
    others = f"<details><summary>Constants held fixed, as the library gives no uncertainty for them: {len(held)}</summary><p>"\
             f"{text('; '.join(held))}</p></details>" if held else ""
    return (f"<section><h2>Constants of the library</h2>{table(['material', 'constant', 'value', 'standard deviation', 'rows'], shown)}"
            f"<p>{text(AT_LEAST[0].upper() + AT_LEAST[1:])}.</p>{others}</section>")


def _rows(swept: SweepTable) -> str:
    columns: tuple[Column, ...] = (*swept.parameters, *worth_drawing(swept, 8))
    rows = [[str(k + 1), *(_cell(c, k) for c in columns), text(swept.reasons[k])] for k in range(min(len(swept), MOST_ROWS))]
    more = f"<p class=quiet>The first {MOST_ROWS} of {len(swept)}; cases.csv has all.</p>" if len(swept) > MOST_ROWS else ""
    return table(["case", *(c.name for c in columns), "reason"], rows) + more


def _cell(column: Column, k: int) -> str:
    value = column.values[k]
    return number(float(f"{value:.5g}"), column.unit) if column.values.dtype.kind == "f" else text(value)


def write_sweep_report(folder, swept: SweepTable, title: str, asked: str, version: str, sensitivity=None, constants=()) -> pathlib.Path:
    """Write report.html into the folder of a sweep; gives its path. Raises `FileTrouble`."""
    path = pathlib.Path(folder) / "report.html"
    write_whole(path, sealed(page(swept, title, asked, version, sensitivity, constants), "<!-- ", " -->\n"), durable=False)
    return path
