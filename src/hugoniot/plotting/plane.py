"""Pictures of two-dimensional runs: maps of a field, profiles along a line, the set-up to scale."""

import difflib

import numpy as np
from matplotlib.collections import LineCollection

from hugoniot.diagnostics.stress2d import DERIVED, derived_field
from hugoniot.errors import DeckError
from hugoniot.mesh.locate import find_zone
from hugoniot.output.result_columns import extent, record_by_record, shape_of
from hugoniot.plotting.polygons import polygons
from hugoniot.plotting.records import snapshots_at
from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, length_scale, new_axes, quiet_grid, styled, time_scale
from hugoniot.plotting.xt import colours_of

_NODAL = ("velocity_x", "velocity_y", "speed")
_OF_SURFACES = ("contact_pressure", "gap", "sliding_distance")
MESH_LINES = 2_000       # zones: the lines of a finer mesh would hide what they bound
ROOM = 0.15              # width of a block over the extent of all, from which its name finds room in it
BESIDE = 0.05            # difference in height of two gauges over that extent, up to which their labels are stacked
EDGES = {"axis": (QUIET, (0, (8, 3, 1, 3))), "wall": (INK, "-"), "velocity": (COLOURS[3], "-"), "pressure": (COLOURS[2], "-"),
         "transmitting": (COLOURS[4], (0, (2, 1)))}


def needs_plane(run, picture: str) -> None:
    """Refuse a picture of two dimensions for a run of one."""
    if "axes" not in run.setup:
        raise DeckError.single(run.folder, None, "kind", f"a {picture} needs a two-dimensional run",
                               f"this run is one-dimensional: use hugoniot plot {run.folder} xt")


def plane_field(run, field: str, k) -> np.ndarray:
    """A zone field of snapshot k: kept, derived from stress, or the mean of a zone's nodes. `DeckError` names those there are."""
    rows = run.arrays("snapshots")
    corners = run.arrays("mesh")["zone_nodes"]

    def shot(name):
        return record_by_record(rows, name)[k]

    if field == "speed" and "velocity_x" in rows:
        return np.hypot(shot("velocity_x"), shot("velocity_y"))[..., corners].mean(axis=-1)
    if field in DERIVED and "deviator_zz" in rows:
        return derived_field(field, {name: shot(name) for name in rows if name.startswith("deviator")})
    if field in _OF_SURFACES and field in rows:      # known on surfaces only: the mean of those corners of a zone that lie there
        values = shot(field)[..., corners]
        known = np.isfinite(values)
        return np.where(known.any(axis=-1), np.where(known, values, 0.0).sum(axis=-1) / np.maximum(known.sum(axis=-1), 1), np.nan)
    if field in _NODAL and field in rows:
        return shot(field)[..., corners].mean(axis=-1)
    known = [name for name in rows if shape_of(rows, name)[1:] == (len(corners),)]
    if field in known:
        return shot(field)
    known += [*_NODAL, *(DERIVED if "deviator_zz" in rows else ())]
    near = difflib.get_close_matches(str(field), known, n=1)
    hint = f"did you mean '{near[0]}'?" if near else f"it has: {', '.join(known)}"
    raise DeckError.single(run.folder, None, "field", f"the snapshots of this run do not contain '{field}'", hint)


def borders(corners: np.ndarray, block_of: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Node pairs (n, 2) of the outline, and of the interfaces between blocks."""
    sides = corners.shape[1]
    edges = np.concatenate([corners[:, [k, (k + 1) % sides]] for k in range(sides)])
    owner = np.tile(block_of, sides)
    order = np.lexsort(np.sort(edges, axis=1).T[::-1])
    ordered, owner = np.sort(edges, axis=1)[order], owner[order]
    twin = (ordered[1:] == ordered[:-1]).all(axis=1)
    single = ~(np.append(twin, False) | np.append(False, twin))
    between = np.append(twin & (owner[1:] != owner[:-1]), False)
    return ordered[single], ordered[between]


def needs_map(run, field: str) -> None:
    """Refuse a map of a run in one dimension, and of what a map cannot show."""
    needs_plane(run, "map")
    if field == "eroded":
        raise DeckError.single(run.folder, None, "field", "zones removed from the mesh are not drawn, and in all others it is 0",
                               "draw another field, in which they are missing")


@styled
def map_(run, field: str = "pressure", time=None, mesh: bool | None = None, mirror: bool = True, contours: int = 0, limits=None,
         window=None, ax=None, colorbar=True):
    """A field over the plane at one time, with outline and interfaces; gives the axes.

    time       s or "1.2 us": the nearest snapshot (default the last)
    mesh       whether the lines of the mesh are drawn (default: of no more than 2 000 zones)
    mirror     axisymmetric: the other half of the body on the left
    contours   number of contour lines; 0 for none
    window     (lowest, highest) x (or r) in m to show
    limits     (lowest, highest) value of the colour scale in SI; default from the data
    colorbar   True, or axes to draw it in, or False
    """
    needs_map(run, field)
    rows = run.arrays("snapshots")
    k = snapshots_at(run, rows["time"], rows["time"][-1] if time is None else time)[0]
    values = plane_field(run, field, k)
    ax = ax if ax is not None else new_axes(*_size(run, k, mirror))
    image, factor = _draw_zones(run, ax, k, values, field, mesh, mirror, limits)
    if contours:
        _draw_contours(run, ax, k, values, contours, mirror)
    _finish(run, ax, mirror)
    if window is not None:
        ax.set_xlim(*(edge * _scale(run)[1] for edge in window))
    unit_t, ft = time_scale(rows["time"][-1])
    ax.set_title(f"t = {rows['time'][k] * ft:.4g} {unit_t}", loc="left")
    if colorbar is not False:
        unit, _, words = field_scale(field, np.array(image.get_clim()) / factor)
        where = {"cax": colorbar} if colorbar is not True else {"ax": ax, "pad": 0.02, "shrink": 0.85}
        bar = ax.get_figure().colorbar(image, **where)
        bar.set_label(labelled(words, unit))
        bar.outline.set_visible(False)
    return ax


def _size(run, k, mirror: bool, height: float = 4.8) -> tuple[float, float]:
    """Width and height (inches) of a figure for the body of snapshot k, with room for a colour bar."""
    rows = run.arrays("snapshots")
    x, y = (float(np.ptp(record_by_record(rows, name)[k])) for name in ("position_x", "position_y"))
    return min(max(height * x * len(_halves(run, mirror)) / max(y, 1e-300) + 1.8, 3.4), 8.0), height


def _halves(run, mirror: bool) -> tuple[float, ...]:
    return (1.0, -1.0) if mirror and run.setup["geometry"] == "axisymmetric" else (1.0,)


def _scale(run) -> tuple[str, float]:
    return length_scale(max(reach(run)))


def reach(run) -> list[float]:
    """How far the nodes of all snapshots lie apart along x and y, m."""
    return [high - low for low, high in (extent(run.arrays("snapshots"), name) for name in ("position_x", "position_y"))]


def places_of(run, k: int) -> np.ndarray:
    """Where the nodes are at snapshot k, (nnode, 2) m."""
    return np.stack([record_by_record(run.arrays("snapshots"), name)[k] for name in ("position_x", "position_y")], axis=1)


def _draw_zones(run, ax, k, values, field, mesh, mirror, limits):
    topology = run.arrays("mesh")
    stays = _in_the_mesh(run, k)
    corners, block_of, values = topology["zone_nodes"][stays], topology["block_of"][stays], values[stays]
    _, fx = _scale(run)
    places = places_of(run, k) * fx
    colours, ends = colours_of(field, values, limits)
    _, factor, _ = field_scale(field, np.array(ends))
    lines = mesh if mesh is not None else len(corners) <= MESH_LINES
    image = None
    for side in _halves(run, mirror):
        part = places * [side, 1.0]
        style = {"edgecolors": INK, "linewidths": 0.2} if lines else {"edgecolors": "face", "linewidths": 0.1}
        image = polygons(part[corners], array=values * factor, cmap=colours, **style)
        image.set_clim(ends[0] * factor, ends[1] * factor)
        ax.add_collection(image)
        outline, interface = borders(corners, block_of)
        if len(_halves(run, mirror)) == 2:      # where both halves meet there is no surface
            outline = outline[(part[outline, 0] != 0.0).any(axis=1)]
        ax.add_collection(LineCollection(part[outline], colors=INK, linewidths=0.8))
        ax.add_collection(LineCollection(part[interface], colors=INK, linewidths=0.8))
    _draw_rigid(run, ax, k, mirror)
    return image, factor


def _in_the_mesh(run, k) -> np.ndarray:
    """Whether each zone is in the mesh at snapshot k: none has left it in a run without erosion."""
    rows = run.arrays("snapshots")
    return record_by_record(rows, "eroded")[k] == 0.0 if "eroded" in rows else np.ones(len(run.arrays("mesh")["zone_nodes"]), dtype=bool)


def _draw_rigid(run, ax, k, mirror) -> None:
    """Rigid bodies of snapshot k; the budget has how far they have moved."""
    budget, (_, fx) = run.arrays("budget"), _scale(run)
    for body in run.setup.get("rigid", ()):
        n = min(int(np.abs(budget["time"] - run.arrays("snapshots")["time"][k]).argmin()), len(budget["time"]) - 1)
        moved = np.array([budget[f"moved_{axis} {body['name']}"][n] for axis in "xy"])
        points = np.array(body["points"])
        if body.get("turns"):
            centre, angle = np.array(body["centre"]), budget[f"turned {body['name']}"][n]
            cosine, sine = np.cos(angle), np.sin(angle)
            points = centre + (points - centre) @ np.array([[cosine, sine], [-sine, cosine]])
        places = (points + moved) * fx
        for side in _halves(run, mirror):
            if body["closed"]:
                ax.fill(side * places[:, 0], places[:, 1], facecolor=QUIET, edgecolor=INK, linewidth=0.8, alpha=0.5)
            else:
                ax.plot(side * places[:, 0], places[:, 1], color=QUIET, linewidth=2.5)


def _draw_contours(run, ax, k, values, count, mirror):
    """Lines of equal value, of the field carried to the nodes as the mean of the zones about them."""
    from matplotlib.tri import Triangulation

    places, stays = places_of(run, k), _in_the_mesh(run, k)
    corners, values = run.arrays("mesh")["zone_nodes"][stays], values[stays]
    _, fx = _scale(run)
    about = np.bincount(corners.ravel(), minlength=len(places))
    nodal = np.bincount(corners.ravel(), weights=np.repeat(values, corners.shape[1]), minlength=len(about)) / np.maximum(about, 1)
    triangles = corners if corners.shape[1] == 3 else np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
    if not np.isfinite(nodal).all() or np.ptp(nodal) == 0.0:
        return
    levels = np.linspace(nodal.min(), nodal.max(), count + 2)[1:-1]
    for side in _halves(run, mirror):
        grid = Triangulation(side * places[:, 0] * fx, places[:, 1] * fx, triangles)
        ax.tricontour(grid, nodal, levels=levels, colors=INK, linewidths=0.6)


def _finish(run, ax, mirror) -> None:
    axes = run.setup["axes"]
    unit, _ = _scale(run)
    ax.set_aspect("equal")
    ax.autoscale_view()
    if len(_halves(run, mirror)) == 2:
        ax.axvline(0.0, color=QUIET, linewidth=0.6, linestyle=(0, (8, 3, 1, 3)))
        ax.xaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
    ax.set_xlabel(labelled(axes[0], unit))
    ax.set_ylabel(labelled(axes[1], unit))


@styled
def line_profile(run, field: str = "pressure", time=None, start=None, end=None, ax=None):
    """A zone field along the straight line from `start` to `end` ((x, y), m; default: along y at the least x) at one or more times.

    A zone gives its value between the places where the line enters and leaves it, sampled at 400 points; gaps are left open.
    """
    needs_plane(run, "profile along a line")
    rows, corners = run.arrays("snapshots"), run.arrays("mesh")["zone_nodes"]
    picked = snapshots_at(run, rows["time"], rows["time"][-1] if time is None else time)
    nodes = [places_of(run, k).T for k in picked]
    first = places_of(run, 0)[:, 0]
    edge = first.min() + 1e-6 * np.ptp(first)
    start = np.array((edge, min(y.min() for _, y in nodes)) if start is None else start, dtype=float)
    end = np.array((edge, max(y.max() for _, y in nodes)) if end is None else end, dtype=float)
    length = float(np.hypot(*(end - start)))
    if length == 0.0:
        raise DeckError.single(run.folder, None, "--from", "the line has no length", "give two different points")
    ax = ax if ax is not None else new_axes()
    place = np.linspace(0.0, length, 400)
    points = start[:, None] + (end - start)[:, None] * (place / length)
    found = [_along(there, corners, points, plane_field(run, field, k)) for k, there in zip(picked, nodes)]
    if not np.isfinite(found).any():
        raise DeckError.single(run.folder, None, "--from", "the line crosses no material", "coordinates refer to the time of the snapshot")
    unit, factor, words = field_scale(field, np.array(found)[np.isfinite(found)])
    unit_x, fx = length_scale(length)
    unit_t, ft = time_scale(rows["time"][-1])
    for n, k in enumerate(picked):
        ax.plot(place * fx, found[n] * factor, color=COLOURS[n % len(COLOURS)], label=f"{rows['time'][k] * ft:.4g} {unit_t}")
    ax.set_xlabel(labelled(f"distance from ({start[0] * fx:.4g}, {start[1] * fx:.4g})", unit_x))
    ax.set_ylabel(labelled(words, unit))
    quiet_grid(ax)
    if len(picked) == 1:
        ax.set_title(f"t = {rows['time'][picked[0]] * ft:.4g} {unit_t}", loc="left")
    else:
        ax.legend(frameon=False, fontsize=8.5)
    return ax


def _along(nodes, corners, points, values) -> np.ndarray:
    """The value of the zone that holds each point (2, n); NaN outside."""
    found = np.full(points.shape[1], np.nan)
    low, high = nodes[:, corners].min(axis=2), nodes[:, corners].max(axis=2)
    near = np.flatnonzero(((high >= points.min(axis=1)[:, None]) & (low <= points.max(axis=1)[:, None])).all(axis=0)
                          & np.isfinite(values))
    for n, point in enumerate(points.T):
        place = find_zone(nodes, corners[near], point) if len(near) else None
        if place is not None:
            found[n] = values[near[place[0]]]
    return found


@styled
def plane_setup(run, ax=None):
    """The blocks at t = 0 to scale, coloured by material, with boundaries, gauges and detonators; gives the axes."""
    needs_plane(run, "set-up of blocks")
    ax = ax if ax is not None else new_axes(6.4, 4.4)
    record, topology = run.setup, run.arrays("mesh")
    unit, fx = _scale(run)
    places = places_of(run, 0) * fx
    corners, block_of = topology["zone_nodes"], topology["block_of"]
    names = list(dict.fromkeys(region["material"] for region in record["regions"]))
    for n, region in enumerate(record["regions"]):
        mine = block_of == n
        colour = COLOURS[names.index(region["material"]) % len(COLOURS)]
        ax.add_collection(polygons(places[corners[mine]], facecolors=colour, edgecolors=INK if mine.sum() <= MESH_LINES else "face",
                                   linewidths=0.15, alpha=0.38))
        ni, nj = region["zones"]
        per_cell = int(mine.sum()) // (ni * nj)
        label = f"{region['name']}: {region['material']}, {ni} x {nj} {'zones' if per_cell == 1 else 'cells of two triangles'}"
        ax.plot([], [], marker="s", linestyle="", color=colour, alpha=0.5, label=label)
        middle = places[corners[mine].reshape(per_cell * ni, nj, -1)[per_cell * ni // 2, nj // 2]].mean(axis=0)
        if len(record["regions"]) > 1 and np.ptp(places[corners[mine], 0]) > ROOM * np.ptp(places, axis=0).max():
            paper = {"facecolor": "white", "alpha": 0.6, "linewidth": 0.0}
            ax.text(*middle, region["name"], ha="center", va="center", fontsize=8, bbox=paper)
    outline, interface = borders(corners, block_of)
    ax.add_collection(LineCollection(places[np.concatenate([outline, interface])], colors=INK, linewidths=0.8))
    _mark_edges_and_places(ax, record, fx, np.ptp(places, axis=0).max())
    ax.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0), frameon=False, fontsize=8, handletextpad=0.3)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.set_xlabel(labelled(record["axes"][0], unit))
    ax.set_ylabel(labelled(record["axes"][1], unit))
    return ax


def _mark_edges_and_places(ax, record, fx, extent) -> None:
    """Boundaries that are not free, gauges and detonators. Lines are named in the legend, labels of gauges beside each other stacked."""
    kinds = {name: boundary["kind"] for name, boundary in record["boundaries"].items() if boundary["kind"] != "free"}
    for kind in dict.fromkeys(kinds.values()):
        edges = np.concatenate([np.array(record["chains"][name]) for name in kinds if kinds[name] == kind]) * fx
        colour, dashes = EDGES.get(kind, (COLOURS[3], "-"))
        ax.add_collection(LineCollection(edges, linewidths=2.5, colors=colour, linestyles=[dashes], zorder=2.5))
        ax.plot([], [], linewidth=2.5, color=colour, linestyle=dashes, label=kind)
    heights = []
    for gauge in (gauge for gauge in record["gauges"] if gauge["at"] is not None):
        at = np.array(gauge["at"]) * fx
        if gauge["kind"] == "slit":
            ax.axline(at, at + gauge["direction"], color=INK, linewidth=0.7, linestyle=(0, (4, 3)))
        else:
            ax.plot(*at, marker="^", color=INK, markersize=4)
        above = sum(abs(height - at[1]) < BESIDE * extent for height in heights)
        ax.annotate(gauge["name"], at, xytext=(4, 3 + 9 * above), textcoords="offset points", fontsize=7.5)
        heights.append(at[1])
    for point in record["lighting"]:
        ends = np.array([point["at"], point.get("to") or point["at"]]) * fx
        ax.plot(*ends.T, marker="*", color=COLOURS[1], markersize=8, linewidth=1.5, zorder=3)
