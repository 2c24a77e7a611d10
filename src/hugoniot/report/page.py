"""Puts report.html together: warnings, numbers, pictures, tables, deck. Reads only the run folder."""

import pathlib
from collections.abc import Callable

from hugoniot.output.atomic import write_whole
from hugoniot.output.columns import PER_AREA
from hugoniot.output.run import Run, load
from hugoniot.output.run_numbers import GAUGE_UNITS, IN_PLANE, SPALL, eroded_rows, gauge_rows, highest_rows, is_lower_bound, spall_numbers
from hugoniot.output.seal import sealed
from hugoniot.output.spall_records import SURFACE, called, surface_record
from hugoniot.page import one_run
from hugoniot.plotting.inline import picture_tasks
from hugoniot.report import sections
from hugoniot.report.sections import number, printed, text


def key_numbers(run: Run) -> list[tuple[str, str]]:
    """(name, HTML text) of the numbers a reader looks for first."""
    summary = run.summary
    rows = [("simulated time", number(summary["time"], "s")), ("zones", str(len(run.arrays("peaks").get("zone", ())))),
            ("cycles", f"{summary['cycles']:,}".replace(",", "\u202f"))]
    if summary["wall_seconds"] is not None:
        rows.append(("wall time", f"{summary['wall_seconds']:.2f} s"))
    spall = spall_numbers(run)
    rows += [(f"highest {name}", printed(value) + (f"<small>{text(place)}</small>" if place else ""))
             for name, value, place in highest_rows(run)]
    for key, name, unit in SPALL:
        if key in spall:
            least = "at least " if is_lower_bound(key, spall) else ""
            rows.append((name, least + number(float(f"{spall[key]:.4g}"), unit)))
    if summary.get("voids_opened") or summary.get("voids_closed"):
        rows.append(("voids opened / closed", f"{summary.get('voids_opened', 0)} / {summary.get('voids_closed', 0)}"))
    if summary.get("interfaces_separated"):
        rows.append(("interfaces separated", str(summary["interfaces_separated"])))
    if summary.get("cells_halved"):
        finest = f"<small>to 1/{2 ** int(summary['finest_halving'])} of a zone</small>"
        rows.append(("cells halved where they burn fast", f"{summary['cells_halved']:.0f}{finest}"))
    rows += [(f"eroded {name}", value) for name, value in ((name, printed(value)) for name, value in eroded_rows(run))]
    if "contact_heat" in summary:
        unit = "J" + PER_AREA[run.setup["geometry"]]
        rows += [("heat from contact", number(summary["contact_heat"], unit)), ("work of friction", number(summary["friction_work"], unit))]
    for name in ("mass", "momentum", "energy"):
        error = summary.get(f"{name}_error")
        rows.append((f"relative {name} error", "not known" if error is None else f"{error:.1e}" if error else "0"))
    return rows


_CAPTIONS = {
    "structure": "The last snapshot (dots, one per cell) and the steady wave of the same law (lines).",
    "structure_terms": "The steady wave: fields as fractions of their jumps; energies per volume in the frame of the shock; viscous stress "
                       "and heat flux; the terms that balance in momentum and in energy, times the density thickness δ; entropy and its "
                       "production, whose integral over x/δ is one.",
    "map_pressure": "Pressure at the end of the run; both halves in axisymmetric geometry. Lines are outlines and interfaces.",
    "map_plastic_strain": "Equivalent plastic strain at the end of the run.",
    "map_burn_fraction": "Burn fraction at the end of the run.",
    "map_speed": "Speed of the material at the end of the run.",
    "gauge_pressure": "Pressure at the gauges.",
    "gauge_velocity_x": "Velocity along the first coordinate at the gauges.",
    "gauge_velocity_y": "Velocity along the second coordinate at the gauges.",
    "gauge_line_velocity": "Velocity at which the surface crosses the lines of sight.",
    "setup": "Regions at t = 0 to scale; triangles are gauges.",
    "wave": "Longitudinal stress over position and time: compression red, tension blue, blank where there is no material. "
            "Dotted lines are gauges. At the snapshots the field is as computed; between them waves are carried along "
            "the direction in which neighbouring snapshots match best.",
    "gauge_stress": "Longitudinal stress at the gauges, positive in compression.",
    "gauge_velocity": "Particle velocity at the gauges.",
    "free_surface": "Velocity of the surface that an interferometer would see.",
    "budget": "Parts of the energy of all regions together, divided as by Herrmann (WL-TR-64-107, A.6). Internal energy is measured "
              "from its "
              "initial value; dashed lines are its parts.",
    "errors": "Largest relative error of mass, momentum and total energy up to each time.",
}


def _figure(pictures: dict, name: str, more: str = "") -> str:
    if name not in pictures:
        return ""
    return f"<figure>{pictures[name]}<figcaption>{text(_CAPTIONS[name] + more)}</figcaption></figure>"


def _spall_words(setup, spall: dict) -> str:
    """How the spall strength was read, or why it is not given."""
    if "reason" in spall:
        return f"Spall strength not given: {spall['reason']}."
    if not spall:
        return ""
    window = f", corrected for the impedance of {called(setup, spall['window'])}" if spall["window"] else ""
    corrected = "spall_strength_kanel" in spall
    kanel = ", and with Kanel's (2001) correction for the erosion of the spall pulse by its elastic front" if corrected else ""
    note = f" Note: {spall['note']}." if "note" in spall else ""
    return f"Spall strength of '{spall['region']}' from the pull-back: acoustic (Novikov 1966){window}{kanel}.{note}"


def _section(title: str, *parts: str) -> str:
    body = "".join(parts)
    return f"<section><h2>{text(title)}</h2>{body}</section>" if body else ""


def _through(setup, seen) -> str:
    """What the light of the interferometer has to pass, which may be any neighbour of a body, transparent or not."""
    if not seen.window:
        return ""
    name = called(setup, seen.window)
    return f" It would look through {name}{'' if name.startswith('the window') else ', which has to be transparent for this'}."


def one_by_one(tasks: dict[str, Callable[[], str]]) -> dict[str, str]:
    """The pictures the tasks draw, by the tasks' names."""
    return {name: draw() for name, draw in tasks.items()}


def page(run: Run, drawn: Callable = one_by_one) -> str:
    """The whole page as HTML text, with the run to walk through where scripts run; `drawn` does the tasks that draw its pictures."""
    setup, summary, pictures = run.setup, run.summary, drawn(picture_tasks(run))
    seen = surface_record(run)
    css = (pathlib.Path(__file__).parent / "page.css").read_text(encoding="utf-8")
    title = text(setup["title"])
    deck = f"<pre>{text(run.deck)}</pre><p class=quiet>SHA-256 {text(summary.get('deck_sha256', 'not known'))}</p>"
    solver = setup["solver"]["kind"] + (f" ({setup['solver']['integrator']})" if setup["solver"]["kind"].startswith("lagrange") else "")
    intro = (f"{text(setup['geometry'])}, solver {text(solver)}, "
             f"hugoniot {text(setup['version'])}; status: {text(summary['status'])}")
    velocities = IN_PLANE if "axes" in setup else ""
    body = "".join([
        f"<h1>{title}</h1><p class=quiet>{intro}</p>", sections.cautions(sections.warnings(run)),
        _section("At the gauges", sections.gauges(gauge_rows(run), GAUGE_UNITS, velocities)), sections.cards(key_numbers(run)),
        _section("Set-up", _figure(pictures, "setup")),
        _section("Shock structure", sections.structure(summary), _figure(pictures, "structure"), _figure(pictures, "structure_terms")),
        _section("Wave diagram", _figure(pictures, "wave")),
        _section("Maps", *(_figure(pictures, name) for name in pictures if name.startswith("map_"))),
        _section("Gauge records", *(_figure(pictures, name) for name in _CAPTIONS if name.startswith("gauge_"))),
        _section("Free surface" if seen.kind == SURFACE else "Interface",
                 _figure(pictures, "free_surface", f"{_through(run.setup, seen)} Recorded by: {seen.source}. "
                         f"{_spall_words(run.setup, spall_numbers(run))}")),
        _section("Energy and momentum", _figure(pictures, "budget"), _figure(pictures, "errors")),
        _section("Events", sections.events(run)),
        _section("Materials", sections.materials(setup)),
        _section("Numerics", sections.numerics(setup)),
        _section("Sources", sections.bibliography(setup)),
        _section("Deck with every default written out", deck),
    ])
    return one_run.shell(run.folder, setup["title"], body, css) or (
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{css}</style></head><body><main>{body}</main></body></html>\n")


def write_report(folder, drawn: Callable = one_by_one, into=None) -> pathlib.Path:
    """Write report.html of the finished run in a folder into that folder, or `into` another; gives its path. Raises `FileTrouble`."""
    run = load(folder)
    path = pathlib.Path(into or run.folder) / "report.html"
    write_whole(path, sealed(page(run, drawn), "<!-- ", " -->\n"), durable=False)
    return path
