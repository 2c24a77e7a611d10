"""Pictures of a sweep: a result over one parameter (line or points), over two of a grid (heat map), and families of records."""

import math

import numpy as np

from hugoniot.output.sweep_file import Column, SweepTable, together
from hugoniot.plotting.style import (
    COLOURS,
    INK,
    QUIET,
    field_scale,
    label_lines,
    labelled,
    new_panels,
    quiet_grid,
    styled,
    time_scale,
)

MOST_PANELS = 6
MOST_LABELS = 7        # lines of a family that are named one by one; more are shown by colour
MAP = "cividis"
SAMPLED = ("sobol", "lhs")
LEAST_FOR_BANDS = 10   # records of a sample that are worth bands
_FIRST = ("pull_back", "spall_strength_acoustic", "spall_strength_at_least", "peak_velocity", "plateau_stress", "peak_stress", "arrival",
          "pressure", "particle_velocity", "shock_velocity", "last_velocity")
_UNITS = (("Pa", (("GPa", 1e-9), ("MPa", 1e-6), ("kPa", 1e-3))), ("m", (("mm", 1e3), ("µm", 1e6))), ("m/s", (("m/s", 1.0),)),
          ("J/kg", (("MJ/kg", 1e-6), ("kJ/kg", 1e-3), ("J/kg", 1.0))))
_SIGNS = {"^2": "²", "^3": "³"}


def scale(column: Column) -> tuple[str, float]:
    """(unit, factor) in which the numbers of a column read well."""
    values = np.abs(column.values[np.isfinite(column.values)]) if column.values.dtype.kind == "f" else np.empty(0)
    top = float(values.max()) if values.size else 0.0
    if column.unit == "s":
        return time_scale(top)
    for unit, choices in _UNITS:
        if column.unit == unit and top > 0.0:
            return next(((shown, factor) for shown, factor in choices if top * factor >= 0.1), (unit, 1.0))
    return ("" if column.unit == "1" else column.unit), 1.0


def words_of(name: str) -> str:
    """A column's name as an axis label says it."""
    return name.replace("_", " ").replace(".", ", ") if not name.startswith(("region.", "material.", "block.")) else name.replace("_", " ")


def axis_label(column: Column) -> str:
    """Name and unit of a column."""
    unit = scale(column)[0]
    for sign, printed in _SIGNS.items():
        unit = unit.replace(sign, printed)
    return labelled(words_of(column.name), unit)


def worth_drawing(table: SweepTable, most: int = MOST_PANELS) -> list[Column]:
    """The results that differ between cases, those a reader asks for first at the front."""
    def rank(column):
        owner, _, last = column.name.rpartition(".")
        place = _FIRST.index(last) if last in _FIRST else len(_FIRST)
        return (owner == "free surface left", place, owner not in ("spall", "free surface"), owner)

    varied = [c for c in table.results if np.isfinite(c.values).sum() > 1 and np.nanmax(c.values) > np.nanmin(c.values)
              and not c.name.endswith("error") and c.name != "cycles"]
    return sorted(varied, key=rank)[:most]


def kind_of(table: SweepTable) -> str:
    """"map" for a grid of two parameters with numbers, "family" for one with numbers and a few names, "line" for one parameter, else
    "points"."""
    numeric = [column for column in table.steps if column.values.dtype.kind == "f"]
    if len(table.shape) == 2 and len(numeric) == 2:
        return "map"
    if len(table.shape) == 2 and len(numeric) == 1 and table.shape[1 - table.steps.index(numeric[0])] <= MOST_LABELS:
        return "family"
    return "line" if len(table.parameters) == 1 or len(table.shape) == 1 else "points"


def draw(ax, table: SweepTable, result: Column, bar=None) -> None:
    """The picture that fits the design: `draw_map` or `draw_family` for two parameters, else `draw_over` the first parameter."""
    kind = kind_of(table)
    if kind == "map":
        draw_map(ax, table, result, bar)
    elif kind == "family":
        draw_family(ax, table, result)
    else:
        draw_over(ax, table, result, (table.steps or table.parameters)[0].name)


def draw_over(ax, table: SweepTable, result: Column, parameter: str) -> None:
    """A result over one parameter: a line where nothing else varies, points where something does."""
    along = table.column(parameter)
    (_, fy), joined = scale(result), kind_of(table) == "line"
    if along.values.dtype.kind == "f":
        x = along.values * scale(along)[1]
        order = np.argsort(x, kind="stable")
        ax.plot(x[order], result.values[order] * fy, "o-" if joined else "o", color=COLOURS[0], markersize=3.5 if len(x) < 60 else 1.8,
                linewidth=1.1)
        ax.set_xlabel(axis_label(along))
    else:
        names = list(dict.fromkeys(along.values.tolist()))
        ax.plot([names.index(name) for name in along.values], result.values * fy, "o", color=COLOURS[0], markersize=3.5)
        ax.set_xticks(range(len(names)), names)
        ax.set_xlabel(words_of(along.name))
    ax.set_ylabel(axis_label(result))
    quiet_grid(ax)


def draw_family(ax, table: SweepTable, result: Column) -> None:
    """A result over the parameter of a grid that has numbers, a line for each name of the other, with the name at its end."""
    along = next(column for column in table.steps if column.values.dtype.kind == "f")
    place = table.steps.index(along)
    names, values = table.steps[1 - place].values, np.moveaxis(result.values.reshape(table.shape), place, 1) * scale(result)[1]
    x, colours, ends = along.values * scale(along)[1], [COLOURS[k % len(COLOURS)] for k in range(len(names))], []
    order = np.argsort(x, kind="stable")
    for row, colour in zip(values[:, order], colours):
        ax.plot(x[order], row, "o-", color=colour, markersize=3.5, linewidth=1.1)
        ends.append(next((v for v in row[::-1] if math.isfinite(v)), math.nan))
    known = [k for k, end in enumerate(ends) if math.isfinite(end)]
    label_lines(ax, [str(names[k]) for k in known], [ends[k] for k in known], [colours[k] for k in known])
    ax.set_xlabel(axis_label(along))
    ax.set_ylabel(axis_label(result))
    quiet_grid(ax)


def draw_map(ax, table: SweepTable, result: Column, bar=None) -> None:
    """A result over the two parameters of a grid as colours, with its numbers where they have room."""
    across, up = table.steps
    values = result.values.reshape(table.shape).T * scale(result)[1]
    x, y = across.values * scale(across)[1], up.values * scale(up)[1]
    shown = ax.pcolormesh(_edges(x), _edges(y), np.ma.masked_invalid(values), cmap=MAP, rasterized=True)
    ax.set_facecolor("#ffffff")
    ax.set_xlabel(axis_label(across))
    ax.set_ylabel(axis_label(up))
    figure = ax.get_figure()
    colours = figure.colorbar(shown, cax=bar) if bar is not None else figure.colorbar(shown, ax=ax)
    colours.set_label(axis_label(result))
    colours.outline.set_visible(False)
    if values.size <= 64:
        low, high = np.nanmin(values), np.nanmax(values)
        for j, i in np.ndindex(values.shape):
            if math.isfinite(values[j, i]):
                dark = values[j, i] < low + 0.6 * (high - low)
                ax.text(x[i], y[j], f"{values[j, i]:.4g}", ha="center", va="center", fontsize=7, color="#ffffff" if dark else INK)
            else:
                ax.text(x[i], y[j], "–", ha="center", va="center", fontsize=8, color=QUIET)


def _edges(x: np.ndarray) -> np.ndarray:
    middle = 0.5 * (x[1:] + x[:-1])
    return np.concatenate([[x[0] - (middle[0] - x[0])], middle, [x[-1] + (x[-1] - middle[-1])]])


def banded(table: SweepTable, record: Column) -> bool:
    """Whether `draw_records` shows bands, not a line for each case."""
    return table.attributes.get("design") in SAMPLED and len(together(record.values)) >= LEAST_FOR_BANDS


def draw_records(ax, table: SweepTable, record: Column) -> None:
    """The records of all cases over time, in the colour of the first parameter; few of them with their values beside them."""
    import matplotlib

    if table.times is None:
        return
    if banded(table, record):
        draw_bands(ax, table.times, record)
        return
    along = (table.steps or table.parameters)[0]
    along = table.column(along.name)
    unit, ft = time_scale(float(table.times[-1]))
    field = record.name.rpartition(".")[2]
    shown, fy, words = field_scale(field, record.values)
    numeric = along.values.dtype.kind == "f"
    level = along.values * scale(along)[1] if numeric else np.arange(len(along.values), dtype=float)
    low, high = float(np.nanmin(level)), float(np.nanmax(level))
    colours = matplotlib.colormaps[MAP](0.9 * (level - low) / (high - low or 1.0))
    for values, colour in zip(record.values, colours):
        ax.plot(table.times * ft, values * fy, color=colour, linewidth=1.0)
    ax.set_xlim(0.0, float(table.times[-1]) * ft)
    ax.set_xlabel(labelled("time", unit))
    ax.set_ylabel(labelled(words, shown))
    ax.set_title(record.name.rpartition(".")[0], loc="left")
    quiet_grid(ax)
    ends = [values[np.isfinite(values)][-1] * fy if np.isfinite(values).any() else math.nan for values in record.values]
    kept = [k for k in range(len(ends)) if math.isfinite(ends[k])]
    if len(kept) <= MOST_LABELS and len(table.parameters) == 1:
        names = [f"{level[k]:.4g}" if numeric else str(along.values[k]) for k in kept]
        label_lines(ax, names, [ends[k] for k in kept], [colours[k] for k in kept])
        ax.text(1.0, 1.02, axis_label(along), transform=ax.transAxes, ha="right", va="bottom", fontsize=8, color=QUIET)
        return
    shades = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(low, high), matplotlib.colors.ListedColormap(
        matplotlib.colormaps[MAP](np.linspace(0.0, 0.9, 128))))
    bar = ax.get_figure().colorbar(shades, ax=ax)
    bar.set_label(axis_label(along) if numeric else words_of(along.name))
    bar.outline.set_visible(False)


def draw_bands(ax, times, record: Column) -> None:
    """The median of a sample's records over time, with the bands that hold 68 and 95 % of them."""
    unit, ft = time_scale(float(times[-1]))
    shown, fy, words = field_scale(record.name.rpartition(".")[2], record.values)
    values = together(record.values)
    sound = np.isfinite(values).all(axis=0)
    low, lower, middle, upper, high = np.quantile(values[:, sound], (0.025, 0.16, 0.5, 0.84, 0.975), axis=0) * fy
    t = times[sound] * ft
    ax.fill_between(t, low, high, color=COLOURS[0], alpha=0.18, linewidth=0, label="95 %")
    ax.fill_between(t, lower, upper, color=COLOURS[0], alpha=0.38, linewidth=0, label="68 %")
    ax.plot(t, middle, color=INK, linewidth=1.2, label="median")
    ax.set_xlim(0.0, float(times[-1]) * ft)
    ax.set_xlabel(labelled("time", unit))
    ax.set_ylabel(labelled(words, shown))
    ax.set_title(f"{record.name.rpartition('.')[0]}, {len(values)} cases", loc="left")
    ax.legend(frameon=False, fontsize=8, loc="best")
    quiet_grid(ax)


def draw_spread(ax, times, record: Column) -> None:
    """How far the records of a sample lie from their median: the bands that hold 68 and 95 % of them."""
    unit, ft = time_scale(float(times[-1]))
    values = together(record.values)
    sound = np.isfinite(values).all(axis=0)
    away = values[:, sound] - np.median(values[:, sound], axis=0)
    shown, fy, words = field_scale(record.name.rpartition(".")[2], away)
    low, lower, upper, high = np.quantile(away, (0.025, 0.16, 0.84, 0.975), axis=0) * fy
    t = times[sound] * ft
    ax.fill_between(t, low, high, color=COLOURS[0], alpha=0.18, linewidth=0)
    ax.fill_between(t, lower, upper, color=COLOURS[0], alpha=0.38, linewidth=0)
    ax.axhline(0.0, color=INK, linewidth=0.8)
    ax.set_xlim(0.0, float(times[-1]) * ft)
    ax.set_xlabel(labelled("time", unit))
    ax.set_ylabel(labelled("difference from the median", shown))
    ax.set_title(f"{record.name.rpartition('.')[0]}: spread of the {words}", loc="left")
    quiet_grid(ax)


@styled
def uncertainty_figure(table: SweepTable):
    """Of every record its bands, and beside it how far they lie from the median.

    Equal records, such as those of an interface and of its two sides, are drawn once.
    """
    own = [record for k, record in enumerate(table.records)
           if not any(np.array_equal(record.values, other.values, equal_nan=True) for other in table.records[:k])]
    axes = new_panels(len(own), 2, 9.6, 2.9 * len(own)).reshape(-1, 2)
    for (ax, beside), record in zip(axes, own):
        draw_bands(ax, table.times, record)
        draw_spread(beside, table.times, record)
    return axes[0, 0].get_figure()


@styled
def sweep_figure(table: SweepTable, results: list[Column] | None = None):
    """A figure with the records, if any were kept, and up to `MOST_PANELS` results."""
    chosen = worth_drawing(table) if results is None else list(results)
    count = len(table.records) + len(chosen)
    columns = min(max(count, 1), 2)
    rows = max(1, -(-count // columns))
    axes = new_panels(rows, columns, 4.6 * columns, 3.2 * rows).ravel()
    for ax, record in zip(axes, table.records):
        draw_records(ax, table, record)
    for ax, result in zip(axes[len(table.records):], chosen):
        draw(ax, table, result)
    for ax in axes[count:]:
        ax.set_visible(False)
    return axes[0].get_figure()
