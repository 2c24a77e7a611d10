"""The wave diagram: a field over position and time, with interfaces, free surfaces and voids where the material has them."""

import numpy as np
from matplotlib.collections import LineCollection

from hugoniot.diagnostics.interface_gauges import sides
from hugoniot.diagnostics.wave_diagram import extent, gaps, interfaces, paths, raster
from hugoniot.output.result_columns import Records, record_by_record
from hugoniot.plotting.style import INK, STRESS, field_scale, halo, labelled, length_scale, new_axes, styled, time_scale, zone_records


@styled
def xt(run, field: str = "stress", ax=None, window=None, times=None, limits=None, size=(360, 640), colorbar=True):
    """Draw a zone field of the snapshots over position (across) and time (upwards); gives the axes.

    Between snapshots waves are carried along the direction in which the two records match best (diagnostics.wave_diagram).

    Snapshots are read one by one, so that those of a million zones fit into memory.

    A run that tracks fronts has them as lines: shocks (by strength) and detonations thick, elastic shocks dashed, edges of fans and
    expansions thin.

    window     (lowest, highest) position in m; default all material, but no further out than the bodies at t = 0 are wide together
    times      (first, last) time in s; default the whole run
    limits     (lowest, highest) value of the colour scale in SI; default from the data
    colorbar   True, or axes to draw it in, or False
    """
    rows, values = run.arrays("snapshots"), zone_records(run, field)
    time, left, right = rows["time"], record_by_record(rows, "position_left"), record_by_record(rows, "position_right")
    ax = ax if ax is not None else new_axes(6.4, 4.4)
    low, high = window or _extent(left, right)
    begin, end = times or (time[0], time[-1])
    kept = range(len(time))[max(int(np.searchsorted(time, begin, side="right")) - 1, 0):int(np.searchsorted(time, end)) + 1]
    time, left, right, values = time[kept.start:kept.stop], _some(left, kept), _some(right, kept), _some(values, kept)
    unit_t, ft = time_scale(end)
    unit_x, fx = length_scale(high - low)
    picture = raster(time, left, right, values, size, (low, high))
    colours, ends = colours_of(field, picture.values, limits)
    unit, factor, words = field_scale(field, np.array(ends))
    image = ax.imshow(picture.values * factor, extent=(low * fx, high * fx, time[0] * ft, time[-1] * ft), origin="lower", aspect="auto",
                      cmap=colours, vmin=ends[0] * factor, vmax=ends[1] * factor, interpolation="nearest", rasterized=True)
    ax.set_xlim(low * fx, high * fx)
    ax.set_ylim(begin * ft, end * ft)
    _draw_edges(ax, rows["region"], time * ft, left, right, fx)
    _draw_fronts(ax, run, fx, ft)
    _draw_gauges(ax, run, fx, ft)
    ax.set_xlabel(labelled("position" if run.setup["geometry"] == "planar" else "radius", unit_x))
    ax.set_ylabel(labelled("time", unit_t))
    if colorbar is not False:
        where = {"cax": colorbar} if colorbar is not True else {"ax": ax, "pad": 0.02}
        bar = ax.get_figure().colorbar(image, **where)
        bar.set_label(labelled(words, unit))
        bar.outline.set_visible(False)
    return ax


def _some(rows, kept: range) -> Records:
    """The records of a range of numbers."""
    return Records(len(kept), lambda k: rows[kept[k]])


def _extent(left, right) -> tuple[float, float]:
    """All that the material occupies, cut off where thin debris or expanding gas is further out than the bodies were wide at first."""
    low, high = float(left[0].min()), float(right[0].max())
    lowest, highest = extent(left, right)
    return max(lowest, low - (high - low)), min(highest, high + (high - low))


def colours_of(field, values, limits):
    """Colour map and limits: two-sided about zero where a stress goes into tension, else from low to high."""
    good = values[np.isfinite(values)]
    low, high = limits or ((float(np.quantile(good, 0.0005)), float(np.quantile(good, 0.9995))) if good.size else (0.0, 1.0))
    if field in ("stress", "pressure"):
        # zero keeps its grey: each side is stretched to its own extreme, the weaker at least a fifth of the stronger;
        # without tension worth showing there is one side only
        top = max(high, 0.2 * -min(low, 0.0), 1e-300)
        bottom = max(-low, 0.2 * top) if low < -0.02 * top else 0.0
        return _stretched(bottom, top), (-bottom, top)
    return "viridis", (low, high if high > low else low + 1.0)


def _stretched(bottom: float, top: float):
    """The stress colours with zero at its place between -bottom and top."""
    from matplotlib.colors import ListedColormap

    zero = bottom / (bottom + top)
    place = np.linspace(0.0, 1.0, 512)
    where = np.where(place < zero, 0.5 * place / max(zero, 1e-12), 0.5 + 0.5 * (place - zero) / (1.0 - zero))
    return ListedColormap(STRESS(where), name="stress")


def _draw_edges(ax, region, time, left, right, fx) -> None:
    """Outer surfaces, interfaces and both faces of every gap, as thin lines."""
    lowest, highest = extent(left, right)
    least, between = 1e-6 * (highest - lowest), interfaces(region)
    open_behind = gaps(left, right, least)
    one, other = paths(left, [0, *(k + 1 for k in open_behind)]), paths(right, [len(region) - 1, *between, *open_behind])
    count = 1 + len(between)
    before, behind = other[:, count:], one[:, 1:]
    is_open = behind - before > least
    edges = [one[:, 0], *other[:, :count].T, *np.where(is_open, before, np.nan).T, *np.where(is_open, behind, np.nan).T]
    ax.add_collection(LineCollection([np.column_stack([edge * fx, time]) for edge in edges], colors=INK, linewidths=0.7))
    top, cuts, final = time[-1], [0, *(k + 1 for k in between), len(region)], (left[-1], right[-1])
    width, taken = ax.get_figure().get_figwidth() * 72 * ax.get_position().width, -1e9
    shown, end = ax.get_xlim()
    for first, last in zip(cuts[:-1], cuts[1:]):
        name, middle = region[first], 0.5 * (max(final[0][first] * fx, shown) + min(final[1][last - 1] * fx, end))
        half = 0.5 * len(str(name)) * 4.8 * (end - shown) / width
        if middle - half > taken and shown <= middle <= end:
            ax.annotate(str(name), (middle, top), xytext=(0, 3), textcoords="offset points", ha="center", va="bottom", fontsize=8,
                        annotation_clip=False)
            taken = middle + half


def _draw_fronts(ax, run, fx, ft) -> None:
    """Every tracked wave as a line from where it arose to where it ended."""
    rows = run.fronts
    styles = (("shock", 1.6, "solid"), ("detonation", 1.6, "solid"), ("elastic shock", 1.2, (0, (3, 1.5))), ("fan", 0.6, "solid"),
              ("expansion", 0.6, "solid"))
    for words, width, dashes in styles:
        chosen = [k for k, kind in enumerate(rows.get("kind", ())) if kind == words or words in ("fan", "expansion") and words in kind]
        ends = [[(rows[f"{e}position"][k] * fx, rows[f"{e}time"][k] * ft) for e in ("", "end_")] for k in chosen]
        scale = [width * (0.3 + 0.7 * min(rows["strength"][k] ** 0.25, 1.0)) if words == "shock" else width for k in chosen]
        ax.add_collection(LineCollection(ends, colors=INK, linewidths=scale, linestyles=dashes))


def _draw_gauges(ax, run, fx, ft, most: int = 6) -> None:
    """Where the gauges go, as dotted lines with their names at the bottom."""
    rows = run.arrays("gauges")
    if "position" not in rows or not len(rows["time"]):
        return
    once, every = sides(run.setup["gauges"]), max(len(rows["time"]) // 200, 1)
    drawn = [k for k, name in enumerate(run.gauge_names()) if name not in once][:most]
    paths = [np.column_stack([rows["position"][::every, k] * fx, rows["time"][::every] * ft]) for k in drawn]
    ax.add_collection(LineCollection(paths, colors=INK, linewidths=0.7, linestyles=(0, (1, 2))))
    # free surfaces and interfaces are lines already; the others are named where they start
    at = {gauge["name"]: str(gauge["at"]) for gauge in run.setup["gauges"]}
    low, high = ax.get_xlim()
    taken = -np.inf
    for x, name in sorted((path[0, 0], run.gauge_names()[k]) for path, k in zip(paths, drawn)):
        if at.get(name) == name or not low <= x <= high or x - taken < 0.02 * (high - low):
            continue
        taken = x
        ax.annotate(name, (x, ax.get_ylim()[0]), xytext=(2, 3), textcoords="offset points", rotation=90, fontsize=7.5,
                    va="bottom", ha="left", path_effects=halo())
