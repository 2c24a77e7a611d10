"""hugoniot plot: pictures of a run."""

from pathlib import Path
from typing import Annotated, Any

import typer

from hugoniot.cli.opened import opened, partial_words
from hugoniot.cli.show import quantity, span
from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest, printable

WITH_FIELD = ("xt", "gauge", "profile", "peaks", "map")
WITH_X, WITH_T = ("xt", "profile", "peaks", "setup", "map"), ("xt", "gauge", "pi_plane", "free_surface", "budget", "errors")
WITH_VALUES = ("xt", "gauge", "free_surface", "profile", "peaks", "map")
LAYERS = {"mesh": ("mesh", True), "no mesh": ("mesh", False), "one half": ("mirror", False), "contours": ("contours", 8)}   # of a map
SUFFIXES = (".png", ".pdf", ".svg")


def command(
    folder: Annotated[Path, typer.Argument(help="The run folder.")],
    kind: Annotated[str, typer.Argument(
        help="Picture, one of those above (default: xt, or map in two dimensions).")] = "",
    field: Annotated[str, typer.Argument(help="Field to show in xt, map, gauge, profile or peaks, such as pressure (hugoniot list "
        "fields).")] = "",
    gauge: Annotated[list[str] | None, typer.Option("--gauge", help="Gauge to show in gauge, pi_plane or free_surface; in the first two "
        "it may be given several times.")] = None,
    time: Annotated[str | None, typer.Option("--time", help="Time of map or profile, such as \"1.2 us\" (default: the last "
        "snapshot).")] = None,
    delay: Annotated[str | None, typer.Option("--delay", help="In free_surface: show the record of a VISAR with this delay, such as "
        "\"2 ns\".")] = None,
    x: Annotated[str | None, typer.Option(
        "--x", help="Range of positions to show in xt, map, profile, peaks or setup, such as \"0..5 mm\".")] = None,
    t: Annotated[str | None, typer.Option("--t", help="Range of times to show in xt, gauge, pi_plane, free_surface, budget or "
        "errors, such as \"0..2 us\".")] = None,
    shown: Annotated[str | None, typer.Option(
        "--range", help="Range of values on the axis, or of the colours in xt and map, such as \"-1..6 GPa\".")] = None,
    line: Annotated[str | None, typer.Option("--line", help="In profile, two dimensions: from one point to another, such as \"0 mm, "
        "0 mm .. 0 mm, 30 mm\".")] = None,
    layers: Annotated[str | None, typer.Option("--layers", help="In map: one or more of \"mesh\", \"no mesh\", \"contours\", \"one "
        "half\", separated by commas.")] = None,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="File to write, .png, .pdf or .svg (default: a .png in the run "
        "folder).")] = None,
) -> None:
    """Draw a picture of a run: by default its wave diagram or, in two dimensions, a map of the pressure.

    Of an unfinished run it draws the results up to the last checkpoint.

    \b
    xt            wave diagram: a field against position and time (one dimension)
    map           a field in the plane at one time (two dimensions)
    profile       a field against position, or along a line, at one time
    gauge         a field at the gauges against time
    free_surface  free-surface velocity with its pull-back (one dimension)
    pi_plane      stress deviators at the gauges, with the yield surface
    peaks         extreme value in each zone (one dimension)
    budget        parts of the energy against time
    errors        errors of mass, momentum and energy against time
    setup         the bodies at t = 0, to scale

    Examples: hugoniot plot flyer.run xt pressure --out wave.png; hugoniot plot taylor.run map plastic_strain --time "40 us"
    """
    from hugoniot.output.atomic import explained
    from hugoniot.plotting.accessor import PICTURES, PLANE_PICTURES

    known = {*PICTURES, *PLANE_PICTURES}
    if kind and kind not in known:
        raise DeckError.single("plot", None, "kind", f"unknown picture '{printable(kind)}'", nearest(kind, known))
    with opened(folder) as run:
        plane = "axes" in run.setup
        there = PLANE_PICTURES if plane else PICTURES
        kind = kind or there[0]
        if kind not in there:
            words = "two" if plane else "one"
            message = f"there is no picture '{kind}' of a {words}-dimensional run"
            raise DeckError.single("plot", None, "kind", message, f"use {', '.join(there)}")
        path = out or folder / f"{'-'.join(word for word in (kind, field) if word)}.png"
        drawable(path, "plot", "--out")
        options = _options(kind, field, gauge, time, delay) | _of_the_plane(kind, plane, line, layers)
        if "mirror" in options and run.setup["geometry"] != "axisymmetric":
            raise DeckError.single("plot", None, "--layers", "a body in plane geometry is drawn whole anyway", 'omit "one half"')
        limits = _limits(kind, field, x, t, shown, plane)
        _within(run, kind, limits[0], limits[1])
        if kind in ("xt", "gauge", "pi_plane", "map"):
            taken = {"xt": ("window", "times", "limits"), "map": ("window", "", "limits"),
                     "gauge": ("", "times", "limits")}.get(kind, ("", "times"))
            options |= {name: value for name, value in zip(taken, limits) if value is not None}
        axes = getattr(run.plot, kind)(**options)
        if kind not in ("xt", "map", "pi_plane"):
            from hugoniot.plotting.style import show_only

            show_only(axes, *(limits[:1] if kind in WITH_X else limits[1:2]), limits[2])
        if words := partial_words(run):
            axes.figure.text(0.995, 0.005, words, ha="right", va="bottom", fontsize=8)
        with explained(path, "no picture is written"):
            axes.figure.savefig(path, bbox_inches="tight" if plane and kind == "setup" else None)      # its legend stands beside the body
        typer.echo(f"wrote {path}" + (f", {words}" if words else ""))


def _within(run, kind: str, positions: tuple[float, float] | None, times: tuple[float, float] | None) -> None:
    """Refuse positions and times of which the run has no record: the picture would be empty."""
    if positions is None and times is None:
        return
    from hugoniot.output.result_columns import extent

    rows = run.arrays("snapshots")
    if times is not None:
        _inside(run, "--t", "times", times, rows["time"][0], rows["time"][-1], "s")
    if positions is not None and "position_left" in rows:
        _inside(run, "--x", "positions", positions, extent(rows, "position_left")[0], extent(rows, "position_right")[1], "m")
    elif positions is not None and kind == "map":
        first, last = extent(rows, "position_x")
        first = -last if run.setup["geometry"] == "axisymmetric" else first     # a map is drawn on both sides of the axis
        _inside(run, "--x", "positions", positions, first, last, "m")


def _inside(run, option: str, what: str, asked: tuple[float, float], first: float, last: float, unit: str) -> None:
    from hugoniot.units import format_si

    if asked[1] < first or asked[0] > last:
        reach = f"it covers {format_si(first, unit, 4)} to {format_si(last, unit, 4)}"
        raise DeckError.single(run.folder, None, option, f"these {what} lie outside the run", reach)


def _limits(kind: str, field: str, x: str | None, t: str | None, shown: str | None,
            plane: bool = False) -> list[tuple[float, float] | None]:
    """(positions, times, values) to show, SI; an axis that the picture does not have is an error."""
    from hugoniot.output.columns import describe

    for option, text, kinds in (("--x", x, WITH_X), ("--t", t, WITH_T), ("--range", shown, WITH_VALUES)):
        if text is not None and kind not in kinds:
            raise DeckError.single("plot", None, option, f"does not apply to the picture '{kind}'",
                                   f"it applies to {', '.join(kinds)}")
    unit = "m/s" if kind == "free_surface" else describe(field or ("pressure" if plane else "stress"))[0]
    return [None if text is None else span(text, kind_of, option)
            for option, text, kind_of in (("--x", x, "m"), ("--t", t, "s"), ("--range", shown, unit))]


def drawable(path: Path, command: str, option: str) -> None:
    """Refuse a picture of a kind that is not drawn."""
    if path.suffix.lower() not in SUFFIXES:
        raise DeckError.single(command, None, option, f"cannot draw '{printable(path.name)}'",
                               f"end its name with {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]}")


def _options(kind: str, field: str, gauge: list[str] | None, time: str | None, delay: str | None) -> dict[str, Any]:
    """The options of one picture; an option that it does not have is an error."""
    one = kind == "free_surface"
    if one and gauge and len(gauge) > 1:
        raise DeckError.single("plot", None, "--gauge", f"{len(gauge)} gauges are given, and the picture 'free_surface' shows one",
                               "use the picture 'gauge velocity'")
    wanted: list[tuple[str, Any, tuple[str, ...], str]] = [
        ("field", field, WITH_FIELD, "field"),
        ("--gauge", gauge[0] if one and gauge else gauge, ("gauge", "pi_plane", "free_surface"), "name" if one else "names"),
        ("--time", time, ("profile", "map"), "time"), ("--delay", delay, ("free_surface",), "delay")]
    options: dict[str, Any] = {}
    for shown, value, kinds, name in wanted:
        if not value:
            continue
        if kind not in kinds:
            raise DeckError.single("plot", None, shown, f"does not apply to the picture '{kind}'",
                                   f"it applies to {', '.join(kinds)}")
        options[name] = quantity(value, "s", shown) if name in ("time", "delay") else value
    return options


def _of_the_plane(kind: str, plane: bool, line: str | None, layers: str | None) -> dict[str, Any]:
    """The options that only pictures of two dimensions have."""
    for option, text, wanted in (("--line", line, "profile"), ("--layers", layers, "map")):
        if text is not None and (kind != wanted or not plane):
            raise DeckError.single("plot", None, option, f"does not apply to the picture '{kind}'",
                                   f"it applies to a {wanted} in two dimensions")
    options: dict[str, Any] = {}
    if line is not None:
        ends = [end.split(",") for end in line.split("..")]
        if [len(end) for end in ends] != [2, 2]:
            shown = 'for example "0 mm, 0 mm .. 0 mm, 30 mm"'
            raise DeckError.single("plot", None, "--line", f"expected two points, got '{printable(line)}'", shown)
        options["start"], options["end"] = (tuple(quantity(part.strip(), "m", "--line") for part in end) for end in ends)
    for word in (layers or "").split(","):
        name = " ".join(word.split())
        if name and name not in LAYERS:
            raise DeckError.single("plot", None, "--layers", f"unknown layer '{printable(name)}'", nearest(name, LAYERS))
        options |= dict([LAYERS[name]]) if name else {}
    return options
