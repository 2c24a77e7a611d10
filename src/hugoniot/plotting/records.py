"""Records over time and profiles over position: gauges, free surface, profiles, budget, errors."""

from dataclasses import replace

import numpy as np

from hugoniot.diagnostics.interface_gauges import CONTINUOUS, sides
from hugoniot.diagnostics.velocimetry import visar_velocity
from hugoniot.diagnostics.wave_diagram import interfaces
from hugoniot.errors import DeckError
from hugoniot.output.result_columns import record_by_record
from hugoniot.output.spall_reading import read_record, spall_reading
from hugoniot.output.spall_records import INTERFACE, SURFACE, called, spalled_regions, surface_record
from hugoniot.plotting.style import (
    COLOURS,
    INK,
    QUIET,
    field_scale,
    label_lines,
    labelled,
    length_scale,
    new_axes,
    quiet_grid,
    styled,
    time_scale,
    zone_field,
    zone_records,
)
from hugoniot.units import format_si, parse


@styled
def gauge(run, field: str = "", names=None, times=None, limits=None, ax=None):
    """One field at the gauges over time, each line with its gauge's name; gives the axes.

    field   default the stress, or the pressure in two dimensions
    names   gauges to draw, default those at which the field ever changes (at most eight)
    times   (first, last) time in s; default the whole record
    limits  (lowest, highest) value in SI; default from the data. A line that ends outside is named at the edge, with "above" or "below"
    """
    rows, known = run.arrays("gauges"), run.gauge_names()
    field = field or ("pressure" if "axes" in run.setup else "stress")
    zone_field(run, "gauges", field)
    _check_gauges(run, names or ())
    ax = ax if ax is not None else new_axes()
    once = sides(run.setup["gauges"]) if field in CONTINUOUS else {}
    least, most = (end.reduce(rows[field], axis=0) for end in (np.fmin, np.fmax))      # a gauge may have been lost on the way (NaN)
    moving = [k for k in range(len(known)) if known[k] not in once and most[k] > least[k]][: len(COLOURS)]
    columns = [k for k in map(known.index, names) if most[k] >= least[k]] if names else moving      # one without any value has no line
    values = rows[field][:, columns]
    unit, factor, words = field_scale(field, values)
    unit_t, ft = time_scale(rows["time"][-1] if len(rows["time"]) else 1.0)
    colours = [COLOURS[k % len(COLOURS)] for k in range(len(columns))]
    for colour, column in zip(colours, columns):
        ax.plot(rows["time"] * ft, rows[field][:, column] * factor, color=colour)
    _time_axis(ax, rows["time"] if times is None else np.array(times), unit_t, ft)
    last = len(values) - 1 if times is None else max(min(int(np.searchsorted(rows["time"], times[1])), len(values)) - 1, 0)
    ax.set_ylabel(labelled(words, unit))
    quiet_grid(ax)
    if limits is not None:
        ax.set_ylim(*(edge * factor for edge in limits))
    if columns:
        low, high = ax.get_ylim()
        seen = (line[np.isfinite(line)] for line in values[: last + 1].T)
        ends = [line[-1] * factor if len(line) else low for line in seen]
        beyond = (" (above)" if end > high else " (below)" if end < low else "" for end in ends)
        label_lines(ax, [known[k] + where for k, where in zip(columns, beyond)], ends, colours)
    return ax


def _check_gauges(run, names) -> None:
    known = run.gauge_names()
    for name in names:
        if name not in known:
            raise DeckError.single(run.folder, None, "gauge", f"no gauge '{name}'", f"this run has: {', '.join(known) or 'none'}")


def _time_axis(ax, time, unit, factor):
    ax.set_xlabel(labelled("time", unit))
    if len(time) > 1:
        start = 0.0 if 0.0 < time[0] < 0.02 * time[-1] else time[0]
        ax.set_xlim(start * factor, time[-1] * factor)


@styled
def free_surface(run, name: str | None = None, delay: float = 0.0, ax=None):
    """Velocity of a free surface or window interface over time, with the pull-back marked where its body spalled; gives the axes.

    name    gauge there; default that of the body that was hit
    delay   s or "1 ns", of the VISAR through which it is seen; 0 shows the surface itself
    """
    _check_gauges(run, () if name is None else (name,))
    delay = parse(delay, "s")
    if delay < 0.0:
        raise DeckError.single(run.folder, None, "delay", f"must not be negative, got {format_si(delay, 's', 4)}")
    reading, record = spall_reading(run, name), surface_record(run, name)
    record = reading.record or record
    time, velocity = record.time, record.velocity
    if not len(time):
        raise DeckError.single(run.folder, None, "gauge", "this run has recorded no free surface", "add a gauge at 'free surface right'")
    if delay >= time[-1] - time[0]:
        raise DeckError.single(run.folder, None, "delay", f"{format_si(delay, 's', 4)} is longer than the record",
                               f"give less than {format_si(time[-1] - time[0], 's', 4)}")
    ax = ax if ax is not None else new_axes()
    unit_t, ft = time_scale(time[-1])
    unit, fu, _ = field_scale("velocity", velocity)
    if delay > 0.0:
        ax.plot(time * ft, velocity * fu, color=QUIET, linewidth=0.8)
        time, velocity = visar_velocity(time, velocity, delay, record.start)
    ax.plot(time * ft, velocity * fu, color=COLOURS[0])
    _time_axis(ax, time, unit_t, ft)
    # of a surface or window on the left the record is minus the velocity along the axis, which the table of the gauges gives
    towards = f" towards {called(run.setup, record.window)}" if record.kind == INTERFACE else ""
    words = "free-surface velocity out of the body" if record.kind == SURFACE else f"velocity at {record.gauge}{towards}"
    ax.set_ylabel(labelled(words, unit))
    quiet_grid(ax)
    ax.margins(y=0.08)
    if "pull_back" in reading.numbers:
        opened = spalled_regions(run).get(record.region, -np.inf)
        seen = read_record(run, replace(record, time=time, velocity=velocity), opened)     # through the delay
        if "pull_back" in seen.numbers:
            _mark_pull_back(ax, seen, ft, fu, unit)
    return ax


def _mark_pull_back(ax, seen, ft, fu, unit):
    found, reading = seen.found, seen.numbers
    x = found.minimum_time * ft
    ax.hlines([found.peak * fu, found.minimum * fu], found.peak_time * ft, x, color=INK, linewidth=0.6, linestyle=(0, (4, 3)))
    arrow = {"arrowstyle": "<->", "color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", (x, found.minimum * fu), (x, found.peak * fu), arrowprops=arrow)
    text = f"pull-back {found.drop * fu:.4g} {unit}"
    if "spall_strength_acoustic" in reading:
        least = "at least " if seen.note else ""     # the note says why
        text += f"\nspall strength {least}{reading['spall_strength_acoustic'] * 1e-9:.3g} GPa"
    if "spall_strength_kanel" in reading:
        text += f"\nKanel: {reading['spall_strength_kanel'] * 1e-9:.3g} GPa"
    ax.annotate(text, (x, found.minimum * fu), xytext=(0, -8), textcoords="offset points", ha="center", va="top", fontsize=8.5,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1.5})
    low, high = ax.get_ylim()
    inches = ax.get_figure().get_figheight() * ax.get_position().height
    ax.set_ylim(min(low, found.minimum * fu - (high - low) * 0.6 / max(inches, 1e-6)), high)


@styled
def profile(run, field: str = "stress", time=None, ax=None):
    """A zone field over position at one or more times (s or "1 us"; the nearest snapshots; default the last); gives the axes."""
    rows = run.arrays("snapshots")
    picked = snapshots_at(run, rows["time"], rows["time"][-1] if time is None else time)
    ax = ax if ax is not None else new_axes()
    left, right, values = (np.array([found[k] for k in picked]) for found in (
        record_by_record(rows, "position_left"), record_by_record(rows, "position_right"), zone_records(run, field)))
    unit, factor, words = field_scale(field, values)
    unit_x, fx = length_scale(float(right.max() - left.min()))
    unit_t, ft = time_scale(rows["time"][-1])
    least = 1e-6 * float(right.max() - left.min())
    for n, k in enumerate(picked):
        x, y = 0.5 * (left[n] + right[n]) * fx, values[n] * factor
        holes = np.flatnonzero(left[n][1:] - right[n][:-1] > least) + 1
        ax.plot(np.insert(x, holes, np.nan), np.insert(y, holes, np.nan), color=COLOURS[n % len(COLOURS)],
                label=f"{rows['time'][k] * ft:.4g} {unit_t}")
    ax.set_xlabel(labelled("position" if run.setup["geometry"] == "planar" else "radius", unit_x))
    ax.set_ylabel(labelled(words, unit))
    quiet_grid(ax)
    if len(picked) == 1:
        ax.set_title(f"t = {rows['time'][picked[0]] * ft:.4g} {unit_t}", loc="left")
    else:
        ax.legend(frameon=False, fontsize=8.5)
    return ax


def snapshots_at(run, known, wanted) -> list[int]:
    """Index of the snapshot nearest to each wanted time (s or text, one or several); times the run did not reach are refused."""
    times = [parse(t, "s") for t in ([wanted] if isinstance(wanted, str) or not np.iterable(wanted) else wanted)]
    reach = f"its snapshots run from {format_si(known[0], 's', 4)} to {format_si(known[-1], 's', 4)}"
    if not times:
        raise DeckError.single(run.folder, None, "time", "no time was given", reach)
    for t in times:
        if not known[0] <= t <= known[-1] * (1.0 + 1e-9):
            raise DeckError.single(run.folder, None, "time", f"the run has no state at {format_si(t, 's', 4)}", reach)
    return [int(np.argmin(np.abs(known - t))) for t in times]


@styled
def peaks(run, field: str = "stress", ax=None):
    """The extreme value of a field that each zone met, over its place at t = 0: the attenuation curve; gives the axes."""
    ax = ax if ax is not None else new_axes()
    rows = run.arrays("peaks")
    field = f"peak_{field}" if f"peak_{field}" in rows else field
    values = zone_field(run, "peaks", field)
    unit, factor, words = field_scale(field, values)
    unit_x, fx = length_scale(float(np.ptp(rows["centre"])))
    cuts = [0, *(k + 1 for k in interfaces(rows["region"])), len(values)]
    for k, (first, last) in enumerate(zip(cuts[:-1], cuts[1:])):
        ax.plot(rows["centre"][first:last] * fx, values[first:last] * factor, color=COLOURS[k % len(COLOURS)])
        ax.text(rows["centre"][first:last].mean() * fx, 1.01, rows["region"][first], color=COLOURS[k % len(COLOURS)], ha="center",
                va="bottom", fontsize=8.5, transform=ax.get_xaxis_transform())
    ax.set_xlabel(labelled("position at t = 0" if run.setup["geometry"] == "planar" else "radius at t = 0", unit_x))
    ax.set_ylabel(labelled(words if words.startswith("peak") else f"peak {words}", unit))
    quiet_grid(ax)
    return ax


_PARTS = (("kinetic_energy", "kinetic"), ("internal_energy", "internal"), ("pressure_work_and_heat", "pressure work and heat"),
          ("elastic_deviator_energy", "elastic shear energy"), ("plastic_work", "plastic work"), ("viscous_work", "viscous work"),
          ("boundary_work", "boundary work"), ("released_heat", "heat released"),
          ("supplied_heat", "heat supplied"), ("force_work", "work of the body force"), ("eroded_energy", "energy of dropped mass"))
PALE = ("#999999", "#8c564b")      # more parts than there are colours
_WHOLE = ("kinetic", "internal", "boundary work", "heat supplied", "work of the body force", "energy of dropped mass")


@styled
def budget(run, ax=None):
    """The parts of the energy over time, summed over regions, in Herrmann's partition (A.6); gives the axes."""
    ax = ax if ax is not None else new_axes()
    rows = run.arrays("budget")
    lines = [(words, rows[name].sum(axis=1) if rows[name].ndim == 2 else rows[name]) for name, words in _PARTS if name in rows]
    ends = [rows[name] for name in rows if name in ("work_left", "work_right") or name.startswith("work ")]     # in 2d: of every chain
    if ends and "boundary_work" not in rows:
        lines.append(("boundary work", np.sum(ends, axis=0)))
    # internal energy counts from where it starts: only its change takes part in the exchange
    lines = [(words, values - values[0] if words == "internal" and len(values) else values) for words, values in lines]
    top = max((float(np.max(np.abs(values))) for _, values in lines if len(values)), default=0.0)
    lines = [(words, values) for words, values in lines if len(values) and np.max(np.abs(values)) > 1e-4 * top]
    prefix, factor = next(((p, f) for p, f in (("GJ", 1e-9), ("MJ", 1e-6), ("kJ", 1e-3)) if top * f >= 1.0), ("J", 1.0))
    unit_t, ft = time_scale(rows["time"][-1] if len(rows["time"]) else 1.0)
    # the others make up the internal energy: dashed, so that nothing seems to be counted twice
    lines.sort(key=lambda line: line[0] not in _WHOLE)
    colours = [*COLOURS, *(PALE * len(lines))]
    for colour, (words, values) in zip(colours, lines):
        ax.plot(rows["time"] * ft, values * factor, color=colour, linestyle="-" if words in _WHOLE else (0, (4, 2)))
    _time_axis(ax, rows["time"], unit_t, ft)
    per = {"planar": "m²", "cylindrical": "(m rad)", "spherical": "sr", "plane": "m", "axisymmetric": "rad"}[run.setup["geometry"]]
    ax.set_ylabel(f"energy ({prefix}/{per})")
    quiet_grid(ax)
    label_lines(ax, [words for words, _ in lines], [values[-1] * factor for _, values in lines], colours)
    return ax


@styled
def errors(run, ax=None):
    """Largest relative errors of mass, momentum and energy so far, over time, on a logarithmic scale; gives the axes."""
    ax = ax if ax is not None else new_axes()
    rows = run.arrays("budget")
    unit_t, ft = time_scale(rows["time"][-1] if len(rows["time"]) else 1.0)
    names = [name for name in ("mass_error", "momentum_error", "energy_error") if name in rows and np.isfinite(rows[name]).any()]
    lines = [(name.removesuffix("_error"), np.maximum(np.maximum.accumulate(np.abs(rows[name])), 1e-17)) for name in names]
    ax.set_yscale("log", subs=[])
    ax.yaxis.set_major_formatter(lambda value, _: f"{value:.0e}".replace("e-0", "e-"))
    for colour, (_, values) in zip(COLOURS, lines):
        ax.plot(rows["time"] * ft, values, color=colour)
    _time_axis(ax, rows["time"], unit_t, ft)
    ax.set_ylabel("relative error")
    ax.set_ylim(1e-17, max([1e-11, *(3.0 * float(v.max()) for _, v in lines)]))
    quiet_grid(ax)
    for n, (name, _) in enumerate(lines):
        ax.text(0.99, 0.95 - 0.09 * n, name, color=COLOURS[n], ha="right", va="top", transform=ax.transAxes, fontsize=8.5)
    return ax
