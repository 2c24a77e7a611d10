"""The set-up to scale: what lies where before anything moves, which way it goes, and where the gauges are."""

from matplotlib.patches import FancyArrowPatch, Polygon, Rectangle

from hugoniot.diagnostics.interface_gauges import sides
from hugoniot.plotting.style import COLOURS, INK, QUIET, labelled, length_scale, new_axes, styled


@styled
def setup(run, ax=None):
    """Draw the regions at t = 0 to scale along the axis, coloured by material; gives the axes."""
    ax = ax if ax is not None else new_axes(6.4, 2.2)
    record = run.setup
    regions, planar = record["regions"], record["geometry"] == "planar"
    low, high = regions[0]["start"], regions[-1]["end"]
    # a thin shell is shown without the empty middle
    start = low if planar or low == 0.0 else max(0.0, low - 0.5 * (high - low))
    unit, f = length_scale(high - start)
    margin = 0.04 * (high - start) * f
    ax.set_xlim(start * f - margin, high * f + margin)
    ax.set_ylim(-0.9, 2.1)
    names = list(dict.fromkeys(region["material"] for region in regions))
    tint = {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(names)}
    for k, region in enumerate(regions):
        _draw_region(ax, region, f, high * f, tint[region["material"]], planar)
        _label_region(ax, region, f, unit, k)
    _draw_boundaries(ax, record, low * f, high * f)
    _draw_gauges(ax, run, regions, f)
    ax.spines["left"].set_visible(False)
    ax.set_yticks([])
    ax.set_xlabel(labelled("position at t = 0" if planar else "radius at t = 0", unit))
    return ax


def _draw_region(ax, region, f, outer, colour, planar):
    start, end = region["start"] * f, region["end"] * f
    style = {"facecolor": colour, "alpha": 0.38, "linewidth": 0.0}
    if planar:
        ax.add_patch(Rectangle((start, 0.0), end - start, 1.0, **style))
        ax.add_patch(Rectangle((start, 0.0), end - start, 1.0, fill=False, edgecolor=INK, linewidth=0.8))
        return
    # curved geometry: the strip opens towards larger radii, as a sector does, but keeps room for words
    corners = [(x, 0.5 + side * (0.18 + 0.32 * x / outer)) for x, side in ((start, -1), (end, -1), (end, 1), (start, 1))]
    ax.add_patch(Polygon(corners, closed=True, **style))
    ax.add_patch(Polygon(corners, closed=True, fill=False, edgecolor=INK, linewidth=0.8))


def _points(ax, span) -> float:
    """Width in points of a stretch of the axis."""
    low, high = ax.get_xlim()
    return ax.get_figure().get_figwidth() * 72 * ax.get_position().width * span / (high - low)


def _label_region(ax, region, f, unit, order):
    start, end = region["start"] * f, region["end"] * f
    middle, thickness = 0.5 * (start + end), end - start
    room = _points(ax, thickness)
    text = f"{region['name']}\n{region['material']}, {thickness:.4g} {unit}\n{region['zones']} zones"
    narrow = room < 4.6 * max(len(line) for line in text.split("\n"))
    if narrow:
        text = region["name"]
    rotate = narrow and room < 4.6 * len(text)
    ax.text(middle, 0.5, text, ha="center", va="center", fontsize=8, rotation=90 if rotate else 0)
    velocity = region["velocity"]
    values = velocity if isinstance(velocity, list) else [velocity]
    if not any(values):
        return
    words = " to ".join(f"{value:.5g}" for value in values) + " m/s"
    lift = 0.26 * (order % 2) if room < 4.6 * len(words) else 0.0
    low, high = ax.get_xlim()
    reach = min(0.06 * (high - low), 0.45 * thickness) * (1 if sum(values) >= 0 else -1)
    tail, head = (middle - reach, 1.4), (middle + reach, 1.4)     # above the kinds of the ends
    ax.add_patch(FancyArrowPatch(tail, head, arrowstyle="-|>", mutation_scale=9, color=INK, linewidth=1.2, shrinkA=0, shrinkB=0))
    ax.text(middle, 1.5 + lift, words, ha="center", va="bottom", fontsize=8)


def _draw_boundaries(ax, record, low, high):
    """A hatched wall where fixed, an arrow where driven; the kind in words under each end."""
    wall = 0.018 * (high - low)
    for side, x, outward, align in (("left", low, -1, "left"), ("right", high, 1, "right")):
        boundary = record["boundaries"][side]
        kind = boundary["kind"]
        if record["geometry"] != "planar" and side == "left" and x == 0.0:
            ax.text(x, 1.06, "axis" if record["geometry"] == "cylindrical" else "centre", ha=align, va="bottom", fontsize=7.5, color=QUIET)
            continue
        if kind == "fixed":
            corner = (x if outward > 0 else x - wall, -0.1)
            ax.add_patch(Rectangle(corner, wall, 1.2, facecolor="none", edgecolor=INK, hatch="/////", linewidth=0.0))
        elif kind in ("velocity", "pressure"):
            tail = (x + outward * 3 * wall, 0.5)
            ax.add_patch(FancyArrowPatch(tail, (x, 0.5), arrowstyle="-|>", mutation_scale=8, color=INK))
        pulse = boundary.get("pulse") or {}
        amount = f": {pulse['shape'].replace('_', ' ')}" if pulse else ""
        ax.text(x, 1.06, kind + amount, ha=align, va="bottom", fontsize=7.5, color=QUIET)


def gauge_place(run, gauge, regions) -> float | None:
    """Where a gauge sits at t = 0, m; None where the words name no place."""
    at = gauge["at"]
    if isinstance(at, (int, float)):
        return float(at)
    ends = {region["name"]: (region["start"], region["end"]) for region in regions}
    if at.startswith("free surface"):
        return regions[0]["start"] if at.endswith("left") else regions[-1]["end"]
    name, mark, side = at.partition(":")
    if mark and name in ends:
        return ends[name][0 if side == "left" else 1]
    name = at.partition("/")[0]
    return ends[name][1] if name in ends else None


def _draw_gauges(ax, run, regions, f):
    """Ticks under the bodies with the gauges' names, on two rows so that neighbours do not touch."""
    places = [(gauge["name"], gauge_place(run, gauge, regions)) for gauge in run.setup["gauges"]
              if gauge["name"] not in sides(run.setup["gauges"])]
    places = sorted(((name, x * f) for name, x in places if x is not None), key=lambda item: item[1])
    for k, (name, x) in enumerate(places):
        drop = -0.46 - 0.22 * (k % 2)
        ax.plot([x, x], [drop + 0.1, 0.0], color=INK, linewidth=0.7, linestyle=(0, (1, 2)))
        ax.plot([x], [0.0], marker="^", color=INK, markersize=4, clip_on=False)
        ax.text(x, drop + 0.06, name, ha="center", va="top", fontsize=7.5)


