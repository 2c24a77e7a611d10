"""An impact of a flyer on a stack of layers: the states at the interfaces, their error bands and the wave curves that meet in them."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from hugoniot.dossier import fits
from hugoniot.errors import HugoniotError, OutOfRange
from hugoniot.explorer.subjects import entry_of, inert
from hugoniot.materials.entry import Entry
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.impedance import Match, match
from hugoniot.theory.isentrope import reference, unload
from hugoniot.theory.states import States
from hugoniot.theory.uncertainty import matched, propagate

MOST_LAYERS = 8
ALONG, ALONG_DRAFT = 18, 7     # states of a drawn curve; of one that the next step of a drag replaces
ANSWERS = ("pressure", "particle_velocity", "shock_velocity", "density")
_SLOPES = {1: ("c0", "s"), 2: ("c0", "s1", "s2")}   # parameters that a recorded fit of that degree gives a law


def impact(names: Sequence[str], velocity: float, sigma: float = 0.0, bands: bool = False, draft: bool = False) -> dict[str, Any]:
    """The states at every interface of the stack, flyer first, SI; `uncertainty` of each where anything is uncertain.

    sigma   standard deviation of the velocity, m/s
    bands   whether the covariance of the library's own fits counts as well
    draft   curves with fewer states between, for a picture that changes at once; the states at the interfaces are the same
    Raises `OutOfRange` or `NoSolution` with the limit, `DeckError` for an unknown material.
    """
    if not 2 <= len(names) <= MOST_LAYERS:
        raise OutOfRange(f"an impact needs a flyer and 1 to {MOST_LAYERS - 1} layers, got {len(names)} materials")
    entries = [entry_of(name) for name in names]
    layers = [inert(entry) for entry in entries]
    met = match(layers, velocity)
    spreads, used = _spreads(entries, layers, velocity, sigma, bands)
    rows = [_row(m, names, [s for s in spreads if s[0] == i]) for i, m in enumerate(met)]
    curves = _curves(layers, velocity, met, ALONG_DRAFT if draft else ALONG)
    return {"layers": list(names), "velocity": velocity, "states": rows, "curves": curves, "uncertain": used,
            "warnings": _warnings(layers, velocity, met)}


def _row(m: Match, names: Sequence[str], spreads: list) -> dict:
    row = {"interface": f"{names[m.interface]}/{names[m.interface + 1]}", **m.right.table(), "separated": m.separated,
           "reflected": m.wave_left, "transmitted": m.wave_right, "left": m.left.table()}
    return row | ({"uncertainty": {key: sigma for _, key, sigma in spreads}} if spreads else {})


def _warnings(layers: Sequence, velocity: float, met: Sequence[Match]) -> list[str]:
    """Where a shock is stronger than the data of a material reach, and the materials' own warnings."""
    found: list[str] = []
    for i, layer in enumerate(layers):
        jump = velocity - met[0].left.particle_velocity if i == 0 else met[i - 1].right.particle_velocity
        if layer.valid_up_to and jump > layer.valid_up_to * (1.0 + 1e-9):
            found.append(f"the data of {layer.name} reach {layer.valid_up_to:.6g} m/s particle velocity, the shock {jump:.6g} m/s: "
                         "extrapolated")
        found += layer.warnings
    return list(dict.fromkeys(found))


# -- error bands -----------------------------------------------------------------------------------------------------
def known_bands(entry: Entry) -> tuple[tuple[str, ...], Any] | None:
    """(parameters, their covariance) of a material whose Hugoniot is a fit that the library recomputes; None for others."""
    row = entry.rows[0] if entry.rows else ""
    if row not in fits.RECORDED:
        return None
    names = _SLOPES[fits.RECORDED[row][1]]
    return (names, fits.recorded(row).covariance) if set(names) <= set(getattr(inert(entry).eos, "_fields", ())) else None


def _spreads(entries, layers, velocity: float, sigma: float, bands: bool) -> tuple[list[tuple[int, str, float]], list[str]]:
    """(interface, field, standard deviation) of every answer, and what was taken as uncertain."""
    values: dict[str, float] = {"velocity": velocity}
    sigmas: dict[str, float] = {"velocity": sigma} if sigma > 0.0 else {}
    together: dict[tuple[str, str], float] = {}
    for entry, layer in zip(entries, layers) if bands else ():
        known = known_bands(entry)
        if known is None:
            continue
        names, covariance = [f"{layer.name}.{n}" for n in known[0]], np.asarray(known[1])
        deviations = np.sqrt(np.diag(covariance))
        values |= {name: float(getattr(layer.eos, name.rpartition(".")[2])) for name in names}
        sigmas |= dict(zip(names, deviations.tolist()))
        together |= {(names[i], names[j]): float(covariance[i, j] / deviations[i] / deviations[j])
                     for i in range(len(names)) for j in range(i)}
    if not sigmas:
        return [], []
    found = propagate(matched(layers, ANSWERS), values, sigmas, correlation=together)
    flat = [(int(key.partition(".")[0]), key.partition(".")[2], spread.sigma) for key, spread in found.items()]
    return flat, list(dict.fromkeys(name.rpartition(".")[0] or name for name in sigmas))


# -- the drawn curves ------------------------------------------------------------------------------------------------
def _curves(layers: Sequence, velocity: float, met: Sequence[Match], along: int) -> list[dict]:
    """Per interface the curve of the layer behind, which the reflected wave follows, and that of the layer ahead."""
    top = 1.3 * max(m.pressure for m in met)
    arriving, found = reference(layers[0], velocity), []
    for k, m in enumerate(met):
        ahead = reference(layers[k + 1])
        sides = ("behind", layers[k], arriving, m.left, -1), ("ahead", layers[k + 1], ahead, m.right, 1)
        found.append({**{side: _wave_curve(layer, start, (through, top), direction, along)
                         for side, layer, start, through, direction in sides},
                      "from": [arriving.particle_velocity, arriving.pressure], "state": [m.particle_velocity, m.pressure]})
        arriving = m.right
    return found


def _wave_curve(layer, start: States, ends: tuple[States, float], direction: int, along: int) -> dict[str, list]:
    """(particle velocity, pressure) of the states behind a wave into `start`: release below its pressure, shock above.

    ends   a state of the curve that is among those drawn, and the highest pressure
    """
    through, top = ends
    floor = max(min(float(reference(layer).pressure), start.pressure), 0.0)
    below, above = [], []
    if start.pressure > floor + 1e-6 * top:
        below = _tried(lambda share: _released(layer, start, through, (floor, share), direction, along))
    if start.pressure < top:
        above = _tried(lambda share: _shocked(layer, start, through, (top, share), direction, along))
    drawn = [*reversed(below), (start.particle_velocity, start.pressure), *above]
    return {"particle_velocity": [u for u, _ in drawn], "pressure": [p for _, p in drawn]}


def _released(layer, start: States, through: States, way: tuple[float, float], direction: int, along: int) -> list[tuple[float, float]]:
    """States on the release from `start` over a share of the way to a pressure, named by their densities: those need no search."""
    goal, bend = start.pressure + way[1] * (way[0] - start.pressure), float(reference(layer).density)
    near = unload(layer, start, direction=direction, density=bend) if start.density > bend else start
    end = unload(layer, near if near.pressure > goal else start, direction=direction, pressure=goal)
    # at its density at rest a law may bend, and an integrator that steps across has to look for the place
    between = [rho for rho in (through.density, bend) if end.density < rho < start.density]
    span = np.unique(np.append(np.linspace(end.density, start.density, along)[:-1], between))[::-1]
    found = unload(layer, start, direction=direction, density=span)
    return list(zip(found.particle_velocity.tolist(), found.pressure.tolist()))


def _shocked(layer, start: States, through: States, way: tuple[float, float], direction: int, along: int) -> list[tuple[float, float]]:
    """States behind shocks into `start` over a share of the way up to a pressure, closer together where they are weak."""
    span = start.pressure + way[1] * (way[0] - start.pressure) * np.linspace(0.0, 1.0, along)[1:] ** 2
    span = np.sort(np.append(span, through.pressure)) if start.pressure < through.pressure < span[-1] else span
    found = shock(layer, Initial.of(start), direction=direction, pressure=span)
    return list(zip(found.particle_velocity.tolist(), found.pressure.tolist()))


def _tried(states_over) -> list[tuple[float, float]]:
    """The states as far as the law goes."""
    for share in (1.0, 0.75, 0.5, 0.25):
        try:
            return states_over(share)
        except HugoniotError:
            continue
    return []


# -- the deck --------------------------------------------------------------------------------------------------------
FLYER_MM, LAYER_MM, ZONE_UM = 2.0, 4.0, 20.0


def deck(names: Sequence[str], velocity: float) -> str:
    """The deck of this impact: a flyer of 2 mm on layers of 4 mm, with gauges at the interfaces and on the free surface.

    Raises `OutOfRange` for an explosive, which would burn in a run where the match takes it as inert.
    """
    entries = [entry_of(name) for name in names]
    for entry in entries:
        if entry.category.startswith("explosive") and entry.unreacted is not None:
            raise OutOfRange(f"{entry.name}: an explosive, which burns in a run; the match takes it as inert, so no deck is offered")
    met = match([inert(entry) for entry in entries], velocity)
    layers = ["flyer", *(("target", "window") if len(names) == 3 else [f"layer {k}" for k in range(1, len(names))])]
    layers = ["flyer", "target"] if len(names) == 2 else layers
    speeds = [m.right.shock_velocity or m.right.sound_speed for m in met]
    stop = 1.6 * sum(LAYER_MM * 1e-3 / s for s in speeds)
    words = " on ".join(entry.title for entry in entries).replace('"', "'").replace("\\", "/")
    lines = ["# Expected from impedance matching, without strength:"]
    lines += [f"#   {a.name}/{b.name}: {m.pressure * 1e-9:.5g} GPa, {m.particle_velocity:.5g} m/s"
              for a, b, m in zip(entries, entries[1:], met)]
    lines += [f'title = "{words}, {velocity:.6g} m/s"', 'geometry = "planar"', f'stop_time = "{stop * 1e6:.3g} us"']
    edge = 0.0
    for k, (entry, layer) in enumerate(zip(entries, layers)):
        end = edge + (FLYER_MM if k == 0 else LAYER_MM)
        lines += ["", "[[region]]", f'name = "{layer}"', f'material = "{entry.name}"', f'from = "{edge:g} mm"', f'to = "{end:g} mm"',
                  f'zone_size = "{ZONE_UM:g} um"', *([f'velocity = "{velocity:.9g} m/s"'] if k == 0 else [])]
        edge = end
    for a, b in zip(layers, layers[1:]):
        lines += ["", "[[gauge]]", f'name = "{a}/{b}"', f'at = "{a}/{b}"']
    lines += ["", "[[gauge]]", 'name = "free surface"', 'at = "free surface right"', "", "[output]",
              f'snapshots = "{stop * 1e6 / 150:.3g} us"']
    return "\n".join(lines) + "\n"
