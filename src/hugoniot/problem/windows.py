"""Gauges that look at an interface through a window, as a velocity interferometer does."""

from collections.abc import Set
from functools import partial

from hugoniot.materials import library
from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.materials.material import Material
from hugoniot.problem.gauges import is_interface
from hugoniot.problem.model import Problem, Region
from hugoniot.units import format_si

WAVELENGTH = 532e-9     # m: of a deck that gives none
_SAME = 0.01            # of a wavelength: rows of the library that count as of it


def factor_of(row, regions: tuple[Region, ...], materials: dict[str, Material], collector: Collector, path: tuple) -> float | None:
    """The window factor of a gauge of a deck: the one given, or the library's for the material of its window; None where there is none."""
    if row.window is None:
        for key in ("window_factor", "wavelength"):
            if getattr(row, key) is not None:
                collector.add((*path, key), f"{key} needs window", 'name the region that is looked through: window = "REGION"')
        return None
    region = next((r for r in regions if r.name == row.window), None)
    if region is None:
        if regions:
            names = [r.name for r in regions]
            collector.add((*path, "window"), f"no region '{printable(row.window)}'", partial(nearest, row.window, names))
        return None
    if row.window_factor is not None:
        if row.wavelength is not None:
            collector.add((*path, "wavelength"), "wavelength selects the library's index, and window_factor gives another",
                          "leave one of them out")
        return row.window_factor
    wavelength = row.wavelength or WAVELENGTH
    if region.material not in materials:     # reported already
        return None
    rows = [optical for optical in library.windows(materials[region.material].library) if "index_intercept" in optical]
    found = [optical for optical in rows if abs(optical["wavelength"] - wavelength) < _SAME * wavelength]
    if not found:
        known = sorted({optical["wavelength"] for optical in rows})
        others = f"it does at {', '.join(format_si(w, 'm') for w in known)}: wavelength chooses one; or " if known else ""
        collector.add((*path, "window"), f"the library does not say how the index of '{printable(region.material)}' changes with density "
                      f"at {format_si(wavelength, 'm')}", f"{others}give window_factor, the constant a of the index n = a + b rho")
        return None
    return found[0]["index_intercept"]


def defects(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of windows that cannot be looked through."""
    found: list[tuple[tuple, str, str]] = []
    for k, gauge in enumerate(problem.gauges):
        if not gauge.window:
            continue
        path = ("gauge", k, "window")
        sides = [part.strip() for part in str(gauge.at).split("/", 1)] if is_interface(gauge.at) else []
        ends = {problem.regions[0].name: problem.left, problem.regions[-1].name: problem.right}
        if gauge.window not in sides:
            found.append((path, f"'{gauge.window}' does not touch the gauge: a window is one of the two regions of an interface",
                          f'at = "REGION/{gauge.window}"'))
        elif gauge.window not in ends:
            found.append((path, f"the light has to pass through other bodies before it reaches the window '{gauge.window}'",
                          "a window is the first or the last region"))
        elif problem.geometry != "planar":
            found.append((path, f"windows are plane, not {problem.geometry}", "leave window out"))
        elif ends[gauge.window].kind not in ("free", "fixed", "transmitting"):
            found.append((path, "the far surface of a window is free, fixed or transmitting", "leave window out"))
    return found


def broken(problem: Problem, regions: Set[str]) -> list[str]:
    """Warnings of gauges that look through a window in which a void opened; `regions` are the names of those that broke."""
    return [f"a void opened in the window '{gauge.window}': from then on the apparent velocity at gauge '{gauge.name}' is not what an "
            "interferometer would see" for gauge in problem.gauges if gauge.window in regions]


def advice(problem: Problem) -> list[str]:
    """What to know of the factors in use."""
    names = {region.name: problem.materials[region.material].library for region in problem.regions}
    said = []
    for gauge in problem.gauges:
        for row in library.windows(names[gauge.window]) if gauge.window else ():
            if row.get("index_intercept") == gauge.window_factor and row.status == "recalled":
                said.append(f"gauge '{gauge.name}': the window factor {gauge.window_factor:g} is not checked against the printed source "
                            f"({row.source})")
    return said
