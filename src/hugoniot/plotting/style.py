"""How pictures look: colours that colour-blind readers tell apart (Okabe and Ito), labels on the lines, units in words people use."""

import difflib
import re
import sys
from collections.abc import Callable
from functools import wraps

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from hugoniot.core.fields import FIELDS
from hugoniot.errors import DeckError
from hugoniot.output.columns import describe
from hugoniot.output.result_columns import Records, record_by_record
from hugoniot.units import UnitError, convert

INK, QUIET, FAINT = "#222222", "#767676", "#d9d9d9"
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7a6a00", "#000000")

RC = {
    "font.size": 9.0, "axes.titlesize": 10.0, "axes.labelsize": 9.0, "xtick.labelsize": 8.5, "ytick.labelsize": 8.5,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.linewidth": 0.8, "xtick.major.width": 0.8, "ytick.major.width": 0.8,
    "lines.linewidth": 1.3, "lines.solid_capstyle": "round", "path.simplify": True, "path.simplify_threshold": 0.2,
    "agg.path.chunksize": 20000, "axes.prop_cycle": matplotlib.cycler(color=COLOURS), "svg.fonttype": "none",
    "svg.hashsalt": "hugoniot", "text.parse_math": False,  # names come from decks: a dollar sign is a dollar sign
    "axes.formatter.useoffset": False, "axes.formatter.limits": (-4, 5), "savefig.dpi": 200, "figure.dpi": 110,
}

# zero stress is grey, never white: white is where there is no material
STRESS = LinearSegmentedColormap.from_list("stress", [
    (0.0, "#08306b"), (0.25, "#2171b5"), (0.42, "#9ecae1"), (0.5, "#e3e1dc"), (0.58, "#fdd49e"), (0.72, "#fc8d59"),
    (0.87, "#d7301f"), (1.0, "#67000d"),
])
_TIMES = (("s", 1.0), ("ms", 1e3), ("µs", 1e6), ("ns", 1e9), ("ps", 1e12))
_LENGTHS = (("m", 1.0), ("mm", 1e3), ("µm", 1e6), ("nm", 1e9))


def styled(function: Callable) -> Callable:
    """Run a drawing function under the house style without touching the user's own settings."""
    @wraps(function)
    def inside(*args, **kwargs):
        with matplotlib.rc_context(RC):
            return function(*args, **kwargs)
    return inside


def new_axes(width: float = 6.4, height: float = 3.6):
    """Axes of a new figure (inches): one that pyplot manages if the caller uses pyplot, else a free one that can be saved."""
    return new_panels(1, 1, width, height)[0, 0]


def new_panels(rows: int, columns: int, width: float, height: float) -> np.ndarray:
    """As `new_axes`, a grid of them: array (rows, columns)."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    figure = Figure(figsize=(width, height), layout="constrained") if pyplot is None else pyplot.figure(figsize=(width, height),
                                                                                                      layout="constrained")
    if pyplot is None:
        FigureCanvasAgg(figure)
    return figure.subplots(rows, columns, squeeze=False)


def scale_of(span: float, units) -> tuple[str, float]:
    """The unit in which a span (SI) reads as a number of at least about one."""
    for name, factor in units:
        if span * factor >= 0.9:
            return name, factor
    return units[-1]


def time_scale(span: float) -> tuple[str, float]:
    """(unit, factor) for times up to `span` seconds; microseconds are preferred where they fit, as is the habit of the field."""
    return ("µs", 1e6) if 2e-7 <= span < 2e-3 else scale_of(span, _TIMES)


def length_scale(span: float) -> tuple[str, float]:
    """(unit, factor) for lengths up to `span` metres."""
    return ("mm", 1e3) if 2e-4 <= span < 2.0 else scale_of(span, _LENGTHS)


def field_scale(field: str, values=None) -> tuple[str, float, str]:
    """(unit, factor, long name) in which a field is drawn; large and small values (SI, optional) choose a fitting prefix."""
    unit, words = describe(field)
    shown, factor = FIELDS[field].display if field in FIELDS else (unit if unit != "1" else "", 1.0)
    top = float(np.nanmax(np.abs(values))) if values is not None and np.size(values) and np.isfinite(values).any() else 0.0
    if unit == "Pa" and top > 0:
        shown, factor = next(((u, f) for u, f in (("GPa", 1e-9), ("MPa", 1e-6), ("kPa", 1e-3)) if top * f >= 0.1), ("Pa", 1.0))
    elif unit == "m" and top > 0:
        shown, factor = length_scale(top)
    elif unit == "m/s" and top >= 5000.0:
        shown, factor = "km/s", 1e-3
    return shown, factor, words.partition(" (")[0]


def zone_field(run, group: str, field: str):
    """A two-dimensional column of `snapshots` or `gauges`, or a column of `peaks`; `DeckError` names those there are.

    Of a field at the nodes, such as `velocity`, snapshots hold both faces of every zone: a zone has their mean.
    """
    rows = run.arrays(group)
    if _at_faces(run, group, field):
        return 0.5 * (rows[f"{field}_left"] + rows[f"{field}_right"])
    return rows[field]


def zone_records(run, field: str):
    """`zone_field` of the snapshots by their numbers; large ones are read one at a time."""
    rows = run.arrays("snapshots")
    if not _at_faces(run, "snapshots", field):
        return record_by_record(rows, field)
    left, right = record_by_record(rows, f"{field}_left"), record_by_record(rows, f"{field}_right")
    return Records(len(left), lambda k: 0.5 * (left[k] + right[k]))


def _at_faces(run, group: str, field: str) -> bool:
    """Whether a field is one of nodes, kept at both faces of every zone. Refuses what the run does not hold."""
    rows = run.arrays(group)    # of which no column is read: that takes minutes where there are a million zones
    known = [name for name, shape in rows.shapes.items() if rows.kinds[name].kind == "f" and len(shape) == (1 if group == "peaks" else 2)]
    nodal = [name.removesuffix("_left") for name in known if name.endswith("_left")]
    if field not in known and field not in nodal:
        known = known + nodal
        near = difflib.get_close_matches(str(field), known, n=1)
        hint = f"did you mean '{near[0]}'?" if near else f"it has: {', '.join(known) or 'none'}"
        raise DeckError.single(run.folder, None, "field", f"the {group} of this run do not contain '{field}'", hint)
    return field in nodal


def labelled(words: str, unit: str) -> str:
    """An axis label: `particle velocity (m/s)`."""
    return f"{words} ({unit})" if unit else words


def spread(values, least: float, low: float = -np.inf, high: float = np.inf) -> np.ndarray:
    """Move label heights apart by at least `least` within [low, high], keeping their order and, as far as can be, their places."""
    values = np.asarray(values, dtype=float)
    order = np.argsort(values, kind="stable")
    placed = values[order].copy()
    for _ in range(50):
        gap = np.diff(placed)
        short = np.maximum(least - gap, 0.0)
        if not (short > 1e-9 * least).any():
            break
        placed[:-1] -= 0.5 * short
        placed[1:] += 0.5 * short
    for k in range(len(placed)):
        placed[k] = max(placed[k], low + k * least, placed[k - 1] + least if k else low)
    for k in reversed(range(len(placed))):
        placed[k] = min(placed[k], high - (len(placed) - 1 - k) * least)
    result = np.empty_like(values)
    result[order] = placed
    return result


def label_lines(ax, texts, heights, colours, x: float = 1.01, size: float = 8.5) -> None:
    """Names of lines at the right edge of the axes, in the lines' colours, at the heights (data) where the lines end."""
    low, high = ax.get_ylim()
    inches = ax.get_figure().get_figheight() * ax.get_position().height
    least = (high - low) * (size * 1.15 / 72.0) / max(inches, 1e-6)
    for text, height, colour in zip(texts, spread(heights, least, low, high), colours):
        ax.text(x, height, text, color=colour, fontsize=size, va="center", ha="left", transform=ax.get_yaxis_transform(), clip_on=False)


def show_only(ax, across=None, values=None) -> None:
    """Limit the axes of a finished picture to (low, high) in SI; None leaves an axis as it is. Units are read from the axis labels."""
    for axis, limits, setter in ((ax.xaxis, across, ax.set_xlim), (ax.yaxis, values, ax.set_ylim)):
        if limits is None:
            continue
        unit = re.search(r"\(([^()]+)\)$", axis.get_label_text())
        factor = si_factor(unit.group(1)) if unit else 1.0
        setter(limits[0] / factor, limits[1] / factor)


def si_factor(unit: str) -> float:
    """What one unit of an axis label, such as µs or kg/m³, is in SI."""
    plain = unit.replace("µ", "u").replace("²", "^2").replace("³", "^3")
    known = {"s": "s", "m": "m", "Pa": "Pa", "m/s": "m/s", "kg/m^3": "kg/m^3", "J/kg": "J/kg", "K": "K", "J": "J"}
    for si in known:
        try:
            return convert(1.0, plain, si)
        except UnitError:
            continue
    return 1.0


def fit_pressure(axis) -> None:
    """Tick labels of an axis in GPa as MPa or kPa, where all it shows is less than a tenth of a GPa."""
    top = max(abs(v) for v in axis.get_view_interval())
    if top >= 0.1:
        return
    unit, factor = ("MPa", 1e3) if top >= 1e-3 else ("kPa", 1e6)
    axis.set_major_formatter(lambda value, _: f"{value * factor:.6g}")
    axis.set_label_text(axis.get_label_text().replace("GPa", unit))


def halo() -> list:
    """Path effects of a text that lines may cross."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=2.2, foreground="white")]


def quiet_grid(ax) -> None:
    """Faint horizontal lines behind the data."""
    ax.grid(axis="y", color=FAINT, linewidth=0.5)
    ax.set_axisbelow(True)
