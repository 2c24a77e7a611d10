"""Pictures as SVG text for a page: drawn with fixed margins (no layout pass, a tenth of the time), in colours the page can change."""

import io
import re
from collections.abc import Callable

import matplotlib
import numpy as np
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from hugoniot.output.result_columns import record_by_record
from hugoniot.output.spall_records import surface_record
from hugoniot.plotting import records
from hugoniot.plotting.setup import setup
from hugoniot.plotting.style import FAINT, INK, QUIET, RC
from hugoniot.plotting.xt import xt

_PAGE_COLOURS = ((INK, "currentColor"), (QUIET, "var(--quiet)"), (FAINT, "var(--faint)"))
NARROW = 4.4    # inches, of a drawing for narrow screens: the type, of the same size in both, is then read on a telephone


def svg(draw: Callable, name: str, width: float, height: float, *rects, narrow: tuple | None = None) -> str:
    """The SVG text of a figure (inches) with axes at `rects` (left, bottom, width, height in inches); draw(*axes) fills it.

    A figure wider than `NARROW` is drawn a second time, as wide as that, and the style sheet of the page shows the drawing that fits.

    narrow  (height, rects) of the second drawing; default: axes are narrower, all margins stay. Axes that stand side by side are drawn
            once only, and are scrolled sideways on a narrow screen
    """
    narrow = narrow or _narrower(width, height, rects)
    if width <= NARROW:
        return _drawn(draw, name, "", width, height, rects)
    if narrow is None:
        return f'<div class="wide">{_drawn(draw, name, "lone", width, height, rects)}</div>'
    return _drawn(draw, name, "broad", width, height, rects) + _drawn(draw, name, "narrow", NARROW, *narrow)


def _narrower(width: float, height: float, rects) -> tuple | None:
    """(height, rects) with axes as much narrower as the figure is to be, and what stands right of them; None for axes side by side."""
    left, across = max(((x, w) for x, _, w, _ in rects), key=lambda at: at[1])
    if any(x != left and w == across for x, _, w, _ in rects):
        return None
    lost = width - NARROW
    return height, [(x, y, w - lost, h) if x == left else (x - lost, y, w, h) for x, y, w, h in rects]


def _drawn(draw: Callable, title: str, kind: str, width: float, height: float, rects) -> str:
    name = f"{title}-narrow" if kind == "narrow" else title
    with matplotlib.rc_context({**RC, "svg.hashsalt": name, "savefig.dpi": 130}):
        figure = Figure(figsize=(width, height))
        FigureCanvasSVG(figure)
        figure.patch.set_visible(False)
        axes = [figure.add_axes((x / width, y / height, w / width, h / height)) for x, y, w, h in rects]
        for ax in axes:
            ax.patch.set_visible(False)
        draw(*axes)
        out = io.StringIO()
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    return _for_page(out.getvalue(), title, name, " ".join(filter(None, ("picture", kind))))


def rehearse() -> None:
    """Draw a picture of nothing and forget it: the first one pays for fonts, colours and the writing of images."""
    def draw(ax, bar):
        ax.get_figure().colorbar(ax.imshow([[0.0, 1.0]], rasterized=True), cax=bar).set_label("µs")
        ax.plot([1.0, 2.0], label="1")
        ax.legend()

    svg(draw, "rehearsal", 2.0, 2.0, (0.5, 0.5, 1.0, 1.0), (1.7, 0.5, 0.1, 1.0))


def _for_page(text: str, title: str, name: str, kind: str) -> str:
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.S)
    text = re.sub(r"<svg ", f'<svg role="img" aria-label="{title}" class="{kind}" ', text, count=1)
    text = re.sub(r'(<svg[^>]*?) width="[^"]*pt" height="[^"]*pt"', r"\1", text, count=1)
    # ids are counted per figure, so a page with several needs them told apart
    text = re.sub(r'id="([\w.-]+)"', rf'id="{name}-\1"', text)
    text = re.sub(r'url\(#([\w.-]+)\)', rf"url(#{name}-\1)", text)
    text = re.sub(r'href="#([\w.-]+)"', rf'href="#{name}-\1"', text)
    # the page's own typeface, in whichever way this matplotlib writes fonts
    text = re.sub(r"font-family: [^;\"]*(; )?", "", text)
    text = re.sub(r"font: ([\d.]+px) '[^;\"]*", r"font-size: \1", text)
    for ink, page in _PAGE_COLOURS:
        text = text.replace(ink, page)
    return text


def _structure_tasks(run) -> dict[str, Callable[[], str]]:
    """The cells of a shock-structure run upon its steady wave, and that wave's balances and entropy."""
    from hugoniot.plotting.structure import draw_cells, draw_profile
    from hugoniot.problem.deck import read_deck_text
    from hugoniot.problem.structure_start import profile_of

    profile = profile_of(read_deck_text(run.deck, "deck.toml").problem)
    shot = run.arrays("snapshots")
    last = {name: record_by_record(shot, name)[-1] for name in ("density", "pressure", "temperature") if name in shot}
    centres = 0.5 * (record_by_record(shot, "position_left")[-1] + record_by_record(shot, "position_right")[-1])
    panels = [(0.7 + 3.75 * column, 0.5 + 2.3 * row, 2.9, 1.95) for row in (2, 1, 0) for column in (0, 1)]
    stacked = 14.1, [(0.7, 0.5 + 2.3 * row, 3.55, 1.95) for row in (5, 4, 3, 2, 1, 0)]
    found = {"structure_terms": lambda: svg(lambda *axes: draw_profile(axes, profile), "structure-terms", 7.5, 7.2, *panels,
                                            narrow=stacked)}
    if "density" in last:
        found["structure"] = lambda: svg(lambda ax: draw_cells(ax, profile, centres, last), "structure", 7.4, 3.0, (0.7, 0.5, 6.5, 2.4))
    return found


def _plane_tasks(run) -> dict[str, Callable[[], str]]:
    """Set-up to scale, maps of the last snapshot, and what the gauges recorded, of a two-dimensional run."""
    from hugoniot.plotting.plane import map_, plane_setup, reach

    shot, rows, found = run.arrays("snapshots"), run.arrays("gauges"), {}
    wide, high = reach(run)
    wide *= 2.0 if run.setup["geometry"] == "axisymmetric" else 1.0

    def tall(across: float) -> float:
        return min(max(across * high / max(wide, 1e-300), 1.6), 5.5)

    height, less, least = tall(6.0), tall(2.8), tall(2.0)
    for name in ("pressure", "plastic_strain", "burn_fraction", "speed"):
        if name == "speed" or name in shot and np.ptp(record_by_record(shot, name)[-1]) > 0.0:
            found[f"map_{name}"] = lambda f=name: svg(lambda ax, bar: map_(run, f, ax=ax, colorbar=bar), f"map-{f}".replace("_", "-"),
                                                      7.4, height + 0.9, (0.6, 0.5, 5.7, height), (6.5, 0.5, 0.14, height),
                                                      narrow=(less + 0.9, [(0.6, 0.5, 2.7, less), (3.5, 0.5, 0.14, less)]))
    found["setup"] = lambda: svg(lambda ax: plane_setup(run, ax=ax), "setup", 7.4, height + 0.7, (0.6, 0.5, 4.6, height),
                                 narrow=(least + 0.7, [(0.6, 0.5, 1.7, least)]))
    for record in ("pressure", "velocity_x", "velocity_y", "line_velocity"):
        if record in rows and len(rows["time"]) > 1 and np.nanmax(np.abs(rows[record]), initial=0.0) > 0.0:
            found[f"gauge_{record}"] = lambda f=record: svg(lambda ax: records.gauge(run, f, ax=ax), f"gauge-{f}".replace("_", "-"),
                                                            7.4, 2.6, (0.7, 0.5, 5.4, 2.0))
    return found


def picture_tasks(run) -> dict[str, Callable[[], str]]:
    """What draws each picture a report shows, by name, the longest first; those for which the run has no data are left out."""
    tasks: dict[str, Callable[[], str]] = {}

    def task(name, draw, *size):
        tasks[name] = lambda: svg(draw, name.replace("_", "-"), *size)

    if "axes" in run.setup:
        return _plane_tasks(run) | _budget_tasks(run)
    shot = run.arrays("snapshots")
    field = next((name for name in ("stress", "pressure", "density") if name in shot), None)
    if field and len(shot["time"]) > 1:
        task("wave", lambda ax, bar: xt(run, field, ax=ax, colorbar=bar, size=(300, 560)), 7.4, 4.3,
             (0.6, 0.5, 5.75, 3.6), (6.5, 0.5, 0.14, 3.6))
    task("setup", lambda ax: setup(run, ax=ax), 7.4, 2.0, (0.15, 0.5, 7.1, 1.45))
    if "steady_density_thickness" in run.summary:
        tasks |= _structure_tasks(run)
    rows = run.arrays("gauges")
    for record in ("stress", "velocity"):
        if record in rows and len(rows["time"]):
            task(f"gauge_{record}", lambda ax, f=record: records.gauge(run, f, ax=ax), 7.4, 2.6, (0.7, 0.5, 5.4, 2.0))
    seen = surface_record(run)
    if (seen.velocity != seen.start).any():
        task("free_surface", lambda ax: records.free_surface(run, ax=ax), 7.4, 3.0, (0.7, 0.5, 6.5, 2.4))
    return tasks | _budget_tasks(run)


def _budget_tasks(run) -> dict[str, Callable[[], str]]:
    if not len(run.arrays("budget")["time"]):
        return {}
    return {"budget": lambda: svg(lambda ax: records.budget(run, ax=ax), "budget", 7.4, 2.4, (0.7, 0.5, 5.4, 1.8)),
            "errors": lambda: svg(lambda ax: records.errors(run, ax=ax), "errors", 7.4, 2.0, (0.7, 0.5, 6.5, 1.45))}
