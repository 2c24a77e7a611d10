"""Checks of a deck that need more than one of its values: overlaps, grading, states, neighbours, places of gauges."""

import math
from collections.abc import Sequence, Set
from dataclasses import replace
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import density_limits, sound_speed_squared
from hugoniot.materials import burning
from hugoniot.materials.collect import Collector, Hint, nearest, printable
from hugoniot.materials.initial_state import initial_state
from hugoniot.materials.material import Material
from hugoniot.materials.read import from_library
from hugoniot.mesh.line import graded_nodes
from hugoniot.problem import windows
from hugoniot.problem.gauges import is_interface, place_name
from hugoniot.problem.model import Gauge, Interface, Profile, Region
from hugoniot.problem.profiles import MOST, read_profile, size_of, values_at
from hugoniot.units import format_si

MOST_ZONES = 10_000_000
LONGEST_NAME = 60     # of a gauge
_STATE = ("density", "pressure", "temperature", "energy")
_SAME = 1e-9  # of a zone: a gap below it is round-off of the user's arithmetic


def read_regions(rows: Sequence, raw: Any, geometry: Any, own: dict[str, Material | None], collector: Collector,
                 warnings: list[str]) -> tuple[tuple[Region, ...], dict[str, Material]]:
    """Regions from left to right and the materials they use.

    Rows that did not fit their model are None and were reported; their materials are still looked up in the `raw` tables, so
    that a deck's mistakes are told at once.
    """
    found: list[tuple[Region, int]] = []
    used: dict[str, Material] = {}
    seen: dict[str, int] = {}
    failed: set[str] = set()
    held = 0        # values of profiles
    for i, row in enumerate(rows):
        path = ("region", i)
        if row is None:
            name = raw[i].get("material") if isinstance(raw[i], dict) else None
            if isinstance(name, str) and name not in own and name not in used and name not in failed:
                failed.update({name} if from_library(name, collector, (*path, "material"), tuple(own)) is None else ())
            continue
        check_name(row.name, seen, i, collector, path)
        look_up(row.material, own, used, failed, collector, (*path, "material"))
        before = collector.findings
        zones = _zones(row, collector, path)
        if geometry in ("cylindrical", "spherical") and row.start < 0.0:
            collector.add((*path, "from"), f"in {geometry} geometry positions are radii and must not be negative, got {row.start:g} m")
        check_state(row, used.get(row.material), collector, path)
        profile = None if held > MOST else checked_profile(row, zones, used.get(row.material), collector, path)
        held += size_of(profile)
        if profile is not None and held > MOST:
            collector.add((*path, "profile"), f"more than {MOST} values in the profiles up to here",
                          "use fewer: between them a profile is linear")
        if zones is not None and collector.findings == before:
            values = row.model_dump(exclude={"zone_size", "zones", "profile"})
            found.append((Region(**values, zones=zones, profile=profile), i))
    found.sort(key=lambda pair: pair[0].start)
    return _without_overlap(found, collector, warnings), used


def checked_profile(row: Any, zones: int | None, material: Material | None, collector: Collector, path: tuple) -> Profile | None:
    """The profile of a region's row, after reporting states that its material cannot be in."""
    if getattr(row, "profile", None) is None or zones is None:     # shock_structure has none
        return None
    path = (*path, "profile")
    profile = read_profile(row.profile, graded_nodes(row.start, row.end, zones, row.ratio), collector, path)
    if profile is None:
        return None
    names = {name for name, _ in profile.fields}
    for name in sorted(names & {key for key in _STATE if getattr(row, key) is not None}):
        collector.add((*path, name), "is given both in the region and in its profile", "give it once")
    if "velocity" in names and row.velocity != 0.0:
        collector.add((*path, "velocity"), "is given both in the region and in its profile", "give it once")
    if material is None or names == {"velocity"} or collector.reported(path):
        return profile
    if material.burn is not None:
        collector.add(path, f"'{material.name}' burns: only its velocity may have a profile", "split the region where the state changes")
        return profile
    places = np.linspace(row.start, row.end, 9)
    given = {name: values_at(profile, name, places) for name in names - {"velocity"}}
    for k, place in enumerate(places):
        before = collector.findings
        state = {key: float(given[key][k]) if key in given else getattr(row, key) for key in _STATE}
        check_state(SimpleNamespace(**state), material, collector, path)
        if collector.findings > before:
            collector.add(path, f"at {format_si(place, 'm')} the profile gives '{material.name}' a state that it cannot have "
                                "(see the error above)")
            break
    return profile


def look_up(name: str, own: dict[str, Material | None], used: dict[str, Material], failed: set[str], collector: Collector,
            path: tuple) -> None:
    """Put a material of the deck or of the library into `used`, or its name into `failed` after reporting why; each is asked for once."""
    if name in used or name in failed:
        return
    material = own[name] if name in own else from_library(name, collector, path, tuple(own))
    if material is None:
        failed.add(name)
    else:
        used[name] = replace(material, name=name)


def check_name(name: str, seen: dict[str, int], i: int, collector: Collector, path: tuple, kept: str = "/:") -> None:
    """Report a name that stands twice or cannot be one; `seen` holds the indices of those met, `kept` characters with a meaning."""
    if name in seen:
        collector.add((*path, "name"), f"{path[0]} {seen[name] + 1} is called '{printable(name)}' too", "names must differ")
    seen.setdefault(name, i)
    if name != name.strip() or not name.isprintable() or any(c in name for c in kept):
        hint = f"use printable characters, no {' or '.join(repr(c) for c in kept)}, no spaces at the ends"
        collector.add((*path, "name"), f"'{printable(name)}' is not a valid name", hint)


def _zones(row: Any, collector: Collector, path: tuple) -> int | None:
    """Number of zones, from `zones` or from the width of the first zone and the ratio."""
    width = row.end - row.start
    if not width > 0.0:
        collector.add((*path, "to"), f"must be greater than from = {format_si(row.start, 'm')}, got {format_si(row.end, 'm')}")
        return None
    if (row.zones is None) == (row.zone_size is None):
        collector.add((*path, "zones"), "give either zones or zone_size" + (", not both" if row.zones else ""), "for example zones = 200")
        return None
    zones, key = row.zones, "zones"
    if zones is None:
        key = "zone_size"
        part = row.zone_size / width
        grown = 1.0 + (row.ratio - 1.0) / part
        if grown <= 0.0:
            reach = format_si(row.zone_size / (1.0 - row.ratio), "m")
            message = f"zones shrinking from {format_si(row.zone_size, 'm')} fill only {reach}"
            collector.add((*path, "ratio"), message, "use a ratio nearer 1")
            return None
        number = 1.0 / part if row.ratio == 1.0 else math.log(grown) / math.log(row.ratio)
        if not number < MOST_ZONES + 0.5:
            collector.add((*path, key), f"{number:.3g} zones are too many", f"the limit is {MOST_ZONES}")
            return None
        zones = max(1, round(number))
    spread = abs(math.log(row.ratio)) * (zones - 1)
    if spread > math.log(1e8):
        message = f"over {zones} zones the widths would differ by a factor of 1e{spread / math.log(10):.0f}"
        collector.add((*path, "ratio"), message, "use a ratio nearer 1")
        return None
    if width / zones * math.exp(-spread) < 1e-13 * max(abs(row.start), abs(row.end)):
        collector.add((*path, key), "zones too thin for double precision at this position", "use fewer zones, or move the origin nearer")
        return None
    return zones


def check_state(row: Any, material: Material | None, collector: Collector, path: tuple) -> None:
    """Report an initial state (density, pressure, temperature, energy of a row) that its material cannot be in."""
    given = {key: value for key in _STATE if (value := getattr(row, key)) is not None}
    if len(given) > 2:
        collector.add((*path, list(given)[-1]), f"{', '.join(given)} over-determine the state", "give at most two of them")
        return
    if material is None or not given:
        return
    key = next(iter(given))
    if material.burn is not None:
        try:
            burning.start_state(material, row.density, row.pressure, row.temperature, row.energy)
        except (HugoniotError, ArithmeticError, ValueError) as error:
            collector.add((*path, key), printable(str(error), 300))
        return
    low, high = density_limits(material.eos)
    if row.density is not None and not low <= row.density < high:
        collector.add((*path, "density"), f"{row.density:g} kg/m^3 lies outside the range of the equation of state",
                      f"the law of '{material.name}' holds from {low:g} to {high:g} kg/m^3")
        return
    try:
        rho, e = initial_state(material.eos, row.density, row.pressure, row.temperature, row.energy)
        c2 = sound_speed_squared(rho, e, material.eos)
    except (HugoniotError, ArithmeticError, ValueError) as error:
        collector.add((*path, key), printable(str(error), 300))
        return
    if not (math.isfinite(rho) and rho > 0.0 and math.isfinite(e) and math.isfinite(c2) and c2 > 0.0):
        collector.add((*path, key), f"no real sound speed in this state: density {rho:g} kg/m^3, energy {e:g} J/kg, squared "
                      f"sound speed {c2:g} m^2/s^2", "change the initial state")


def _without_overlap(found: list[tuple[Region, int]], collector: Collector, warnings: list[str]) -> tuple[Region, ...]:
    """The regions, touching ends made equal bit for bit."""
    regions: list[Region] = []
    for region, i in found:
        if regions:
            left = regions[-1]
            gap, width = region.start - left.end, min((r.end - r.start) / r.zones for r in (left, region))
            if gap < -_SAME * width:
                message = f"overlaps region '{left.name}', which reaches from {format_si(left.start, 'm')} to {format_si(left.end, 'm')}"
                collector.add(("region", i, "from"), message, f"start it at {format_si(left.end, 'm', 15)} or beyond")
            elif abs(gap) <= _SAME * width:
                region = Region(**{**region.__dict__, "start": left.end})
            elif gap < 1e-3 * width:
                warnings.append(f"the gap of {format_si(gap, 'm')} between '{left.name}' and '{region.name}' is far thinner than a zone")
        regions.append(region)
    if sum(r.zones for r in regions) > MOST_ZONES:
        collector.add(("region",), f"{sum(r.zones for r in regions)} zones in all are too many", f"the limit is {MOST_ZONES}")
    return tuple(regions)


def unread(rows: object, regions: tuple[Region, ...]) -> set[str | None]:
    """Names (None: without one) of regions that stand in the deck but could not be read: what refers to them is no second mistake."""
    names = [row.get("name") if isinstance(row, dict) else None for row in rows] if isinstance(rows, list) else []
    return {name if isinstance(name, str) else None for name in names} - {region.name for region in regions}


def read_interfaces(rows: Sequence, regions: tuple[Region, ...], collector: Collector,
                    broken: Set[str | None] = frozenset()) -> tuple[Interface, ...]:
    """Interfaces between neighbours, left one first; `broken` as of `unread`."""
    order = {region.name: k for k, region in enumerate(regions)}
    found: dict[tuple[int, int], Interface] = {}
    for i, row in enumerate(rows):
        if row is None:
            continue
        path = ("interface", i)
        if (row.kind == "bond") != (row.strength is not None):
            hint = "kind = \"bond\" and strength belong together"
            collector.add((*path, "strength"), "missing" if row.kind == "bond" else f"a {row.kind} interface has no strength", hint)
        unknown = [(k, name) for k, name in enumerate(row.between) if name not in order]
        for k, name in unknown if None not in broken else ():
            if name not in broken:
                collector.add((*path, "between", k), f"no region '{printable(name)}'", partial(nearest, name, order))
        if unknown or broken:
            continue
        a, b = sorted(order[name] for name in row.between)
        if b != a + 1:
            collector.add((*path, "between"), f"'{row.between[0]}' and '{row.between[1]}' are not neighbours")
        elif (a, b) in found:
            collector.add((*path, "between"), f"the pair '{row.between[0]}' and '{row.between[1]}' is described twice")
        elif row.kind == "bond" and regions[b].start > regions[a].end:
            collector.add((*path, "between"), f"'{regions[a].name}' and '{regions[b].name}' do not touch, but a bond acts from the start",
                          'kind = "bonded" joins them when they meet')
        else:
            found[a, b] = Interface(regions[a].name, regions[b].name, row.kind, row.strength or 0.0)
    return tuple(found[key] for key in sorted(found))


def read_gauges(rows: Sequence, regions: tuple[Region, ...], materials: dict[str, Material], collector: Collector) -> tuple[Gauge, ...]:
    """Gauges, each at a place that exists."""
    found: dict[str, Gauge] = {}
    known = _places(regions)
    for i, row in enumerate(rows):
        if row is None:
            continue
        path, at = ("gauge", i), place_name(row.at, regions)
        if row.name in found:
            collector.add((*path, "name"), f"another gauge has the name '{printable(row.name)}'", "names must differ")
        elif row.name != row.name.strip() or not row.name.isprintable():
            collector.add((*path, "name"), f"'{printable(row.name)}' is not a valid name", "use printable characters, no spaces at the "
                                                                                           "ends")
        elif is_interface(at) and len(row.name) > LONGEST_NAME - len(" right"):
            collector.add((*path, "name"), f"too long a name for a gauge at an interface: '{printable(row.name)}'",
                          f"use up to {LONGEST_NAME - len(' right')} characters: the gauges on its two sides add ' left' and ' right'")
        if regions:
            wrong = None if at in known else _wrong_place(at, regions, known)
            if wrong:
                collector.add((*path, "at"), *wrong)
        factor = windows.factor_of(row, regions, materials, collector, path)
        found.setdefault(row.name, Gauge(row.name, at, row.window or "", factor))
    return tuple(found.values())


def _places(regions: tuple[Region, ...]) -> set[str]:
    """The places with a name at which a gauge may sit."""
    touching = {f"{a.name}/{b.name}" for a, b in zip(regions, regions[1:])}
    return {"free surface left", "free surface right"} | touching | {f"{r.name}:{side}" for r in regions for side in ("left", "right")}


def _wrong_place(at: float | str, regions: tuple[Region, ...], known: set[str]) -> tuple[str, Hint] | None:
    """Message and hint where a gauge has no material to sit on; `known` are the places with a name, and `at` is none of them."""
    if isinstance(at, float):
        if any(r.start <= at <= r.end for r in regions):
            return None
        spans = ", ".join(f"'{r.name}' ({format_si(r.start, 'm')} to {format_si(r.end, 'm')})" for r in regions[:4])
        return f"no material at {format_si(at, 'm')}", f"regions: {spans}" + (", ..." if len(regions) > 4 else "")
    turned = "/".join(reversed(at.split("/")))
    hint = f"name the left region first: '{turned}'" if turned in known else partial(_nearest_place, at, regions)
    return f"unknown place '{printable(at)}'", hint


def _nearest_place(at: str, regions: tuple[Region, ...]) -> str:
    touching = [f"{a.name}/{b.name}" for a, b in zip(regions, regions[1:])]
    sides = [f"{r.name}:{side}" for r in regions[:20] for side in ("left", "right")]
    known = ["free surface left", "free surface right", *touching, *sides]
    parts = [place for place in known if set(at.lower().split()) <= set(place.split())]
    if len(parts) == 1 and at.strip():
        return f"did you mean '{parts[0]}'?"
    return nearest(at, known, f"for example '4 mm', '{known[-1]}', 'free surface right'")
