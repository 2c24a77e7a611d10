"""The parts of the report page that are words and tables. Everything from the run folder is escaped."""

import json
import math
from html import escape

from hugoniot.units import format_si

_UNIT_SIGNS = ((" us", " µs"), (" um", " µm"), ("^2", "²"), ("^3", "³"), ("^-1", "⁻¹"), ("^-3", "⁻³"))
_STATUS = {"verified": "read in the stated file", "corrected": "read in the stated file, a mistake corrected", "derived": "derived",
           "recalled": "not checked against the printed source", "user": "from the deck, or a default"}
_FAMILIES = {"eos": "equation of state", "viscosity": "artificial viscosity", "transport": "shear viscosity",
             "conduction": "heat conduction"}
MOST_EVENTS = 200
_SHOCK_UNITS = {"shock, shock velocity": "m/s", "shock, particle velocity": "m/s", "shock, pressure": "Pa", "shock, at": "m"}


def text(value) -> str:
    """Any value as safe HTML text."""
    return escape(str(value))


def number(value, unit: str = "") -> str:
    """A number with its unit for people; words and tables of numbers come out as they are."""
    if value is None:
        return "–"
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return text(value if not isinstance(value, list) else f"table of {len(value)}")
    if math.isnan(value):
        return "not given"
    shown = f"{value}" if not math.isfinite(value) or isinstance(value, int) and unit in ("", "1") else format_si(value, unit)
    return printed(shown)


def printed(quantity: str) -> str:
    """A quantity in words as HTML text, its unit as in print: µs, m²."""
    for sign, in_print in _UNIT_SIGNS:
        quantity = quantity.replace(sign, in_print)
    return text(quantity)


def cards(rows) -> str:
    """Key numbers as a list of (name, HTML text)."""
    return '<dl class="numbers">' + "".join(f"<div><dt>{text(name)}</dt><dd>{value}</dd></div>" for name, value in rows) + "</dl>"


def table(heads, rows, stacked: bool = False) -> str:
    """A table; `rows` hold HTML text. Stacked: on a narrow screen each row stands below its first cell, every number below its head."""
    head = "".join(f"<th>{text(h)}</th>" for h in heads)
    starts = ["<td>", *(f'<td data-head="{text(h)}">' if stacked else "<td>" for h in heads[1:])]
    body = "".join("<tr>" + "".join(f"{start}{cell}</td>" for start, cell in zip(starts, row)) + "</tr>" for row in rows)
    kind = " class=stacked" if stacked else ""
    return f'<div class="wide"><table{kind}><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def _mark(status: str) -> str:
    return f'<span class="mark {text(status)}">{text(_STATUS.get(status, status))}</span>' if status else ""


class _Citations:
    """The sources of one material, each written once and cited by number."""

    def __init__(self):
        self.places: dict[tuple[str, str], int] = {}

    def cite(self, constant: dict) -> str:
        """[1] for a constant with a source, nothing for one without."""
        key = (constant["source"], constant["note"])
        return f"[{self.places.setdefault(key, len(self.places) + 1)}]" if any(key) else ""

    def listed(self) -> str:
        rows = [(f"[{n}]", text(source) + (f" ({text(note)})" if note else "")) for (source, note), n in self.places.items()]
        return table(("", "source"), rows) if rows else ""


def _laws(laws: list[dict], sources: _Citations | None = None, depth: int = 0) -> str:
    """Laws with their constants; the sources are listed below them, unless the caller does it."""
    own = sources or _Citations()
    parts = []
    for law in laws:
        rows = [(text(c["name"]), number(c["value"], c["unit"]), text(c["meaning"]), own.cite(c), _mark(c["status"]))
                for c in law["constants"]]
        family = _FAMILIES.get(law["family"], law["family"])
        parts.append(f"<h3>{text(family)}: {text(law['law'])}</h3><p class=quiet>{text(law['summary'])}</p>")
        parts.append(table(("constant", "value", "meaning", "source", ""), rows) if rows else "")
        parts.append(_laws(law["inner"], own, depth + 1) if depth < 4 else "")
    return "".join(parts) + (own.listed() if sources is None else "")


def materials(setup: dict) -> str:
    """Every material with its laws, constants, sources and warnings, and the viscosity."""
    parts = []
    for name, material in setup["materials"].items():
        limit = f" Range of its data: {text(material['reach'])}." if "reach" in material else ""
        where = ", ".join(text(r["name"]) for r in setup["regions"] if r["material"] == name)
        parts.append(f"<h3>{text(name)}</h3><p class=quiet>Used in {where}.{limit}</p>")
        parts += [f'<p class="warning">{text(warning)}</p>' for warning in material["warnings"]]
        sources = _Citations()
        parts.append(_laws(material["laws"], sources))
        parts.append(f"<p class=quiet>{_bulk(material['bulk'])}.</p>" if "bulk" in material else "")
        if material["other_sources"]:
            rows = [(text(s["quantity"]), number(s["value"], s["unit"]), sources.cite(s), _mark(s["status"]))
                    for s in material["other_sources"]]
            parts.append(table(("also stated", "value", "source", ""), rows))
        parts.append(sources.listed())
    return "".join(parts)


def _flat(options: dict, before: str = ""):
    """(words, value) of nested options."""
    for key, value in options.items():
        name = f"{before}{key.replace('_', ' ')}"
        if isinstance(value, dict):
            yield from _flat(value, f"{name}, ")
        else:
            yield name, value


_THICKNESSES = (
    ("density thickness of this run", "density_thickness", "m", "|ρ₂ − ρ₁| / max|dρ/dx|, from the cells"),
    ("cells in this thickness", "cells_per_thickness", "", "density thickness over cell width"),
    ("density thickness, steady", "steady_density_thickness", "m", "|ρ₂ − ρ₁| / max|dρ/dx|"),
    ("velocity thickness, steady", "steady_velocity_thickness", "m", "|u₂ − u₁| / max|du/dx|"),
    ("density width, steady", "steady_density_width_10_90", "m", "from 10 % to 90 % of the jump of density"),
    ("velocity width, steady", "steady_velocity_width_10_90", "m", "from 10 % to 90 % of the jump of velocity"),
    ("Mach number", "mach", "", "shock velocity over sound speed ahead"),
    ("shock velocity", "shock_velocity", "m/s", "into the material ahead"),
    ("particle velocity", "particle_velocity", "m/s", "jump of velocity"),
    ("entropy gained", "entropy_jump", "J/kg/K", "jump of the law's entropy, the same for every viscosity and conduction"),
    ("produced by viscosity", "entropy_viscous", "J/kg/K", "∫ (4/3 μ + ζ) (du/dx)² / T dx / ρu"),
    ("produced by conduction", "entropy_conductive", "J/kg/K", "∫ k (dT/dx)² / T² dx / ρu"),
)


def gauges(rows: list[dict], units: dict[str, str], note: str = "") -> str:
    """The numbers of the gauges (`output.run_numbers.gauge_rows`), as the terminal shows them, and a note below."""
    if not rows:
        return ""
    heads = [key for key in rows[0] if key != "gauge"]
    lines = [(text(row["gauge"]), *("none" if math.isnan(row[h]) else number(float(f"{row[h]:.5g}"), units[h]) for h in heads))
             for row in rows]
    below = f"<p class=quiet>{text(note)}.</p>" if note else ""
    return table(("gauge", *(h.replace("_", " ") for h in heads)), lines, stacked=True) + below


def structure(summary: dict) -> str:
    """Thicknesses with their definitions, and the entropy, of a run that resolves a shock; nothing for others."""
    if "density_thickness" not in summary:
        return ""
    rows = [(text(name), number(float(f"{summary[key]:.6g}"), unit), text(how)) for name, key, unit, how in _THICKNESSES
            if isinstance(summary.get(key), (int, float)) and not math.isnan(summary[key])]
    return table(("measure", "value", "definition"), rows)


def _bulk(record: dict) -> str:
    return f"Bulk viscosity ζ = {number(record['bulk_ratio'])} μ + {number(record['bulk_viscosity'], 'Pa s')}"


def _transport(record: dict) -> str:
    words = f"{_bulk(record)}; stress τ = (4/3 μ + ζ) du/dx, heat flux q = −k dT/dx."
    return _laws(record["laws"]) + f"<p class=quiet>{words}</p>"


def numerics(setup: dict) -> str:
    """Integrator, step control and artificial viscosity."""
    solver = setup["solver"]
    known = {"kind": "solver", "integrator": "integrator", "courant": "Courant number", "growth": "largest growth of the step",
             "initial_step": "first step", "largest_step": "largest step", "threads": "threads", "max_cycles": "limit on cycles"}
    known = known if solver["kind"] == "lagrange1d" else {"kind": "solver"}
    given = [(key, label) for key, label in known.items() if solver.get(key) is not None]
    rows = [(label, number(solver[key], "s" if key.endswith("step") else "")) for key, label in given]
    if solver["kind"] == "lagrange2d":
        own = ("kind", "initial_step", "largest_step", "max_cycles")
        rows = [(text(key), number(value)) for key, value in _flat({k: v for k, v in solver.items() if k not in own and v is not None})]
        rows.insert(0, ("solver", "lagrange2d"))
    options = {key: value for key, value in (solver.get("options") or {}).items() if key != "transport" or not setup.get("transport")}
    rows += [(text(key), number(value, _SHOCK_UNITS.get(key, ""))) for key, value in _flat(options)]
    parts = [table(("setting", "value"), rows)]
    if setup.get("transport"):
        parts.append(_transport(setup["transport"]))
    if setup["viscosity"]:
        parts.append(_laws([setup["viscosity"]]))
    return "".join(parts)


def cautions(words: list[str]) -> str:
    """Warnings as one block; nothing where there are none."""
    return f'<div class="warning">{"".join(f"<p>{text(each)}</p>" for each in words)}</div>' if words else ""


def warnings(run) -> list[str]:
    """Everything the reader must know before trusting the numbers."""
    rows = run.arrays("events")
    found = [str(words) for kind, words in zip(rows["kind"], rows["text"]) if kind == "warning"]
    found += [f"{name}: {words}" for name, material in run.setup["materials"].items() for words in material["warnings"]]
    found += list(run.summary.get("checkpoint_warnings", ()))
    if run.summary["status"] != "done":
        found.insert(0, f"The run did not reach its end: {run.summary['status']}")
    return list(dict.fromkeys(found))


def events(run) -> str:
    """What happened, in order (the first two hundred)."""
    rows = run.arrays("events")
    if not len(rows["time"]):
        return "<p class=quiet>No events.</p>"
    lines = []
    for time, cycle, kind, words, numbers in list(zip(*(rows[k] for k in ("time", "cycle", "kind", "text", "numbers"))))[:MOST_EVENTS]:
        extra = json.loads(numbers)
        place = number(extra["position"], "m") if isinstance(extra.get("position"), float) and math.isfinite(extra["position"]) else ""
        lines.append((number(float(time), "s"), text(cycle), text(str(kind).replace("_", " ")), place, text(words)))
    left = len(rows["time"]) - len(lines)
    more = f"<p class=quiet>and {left} more in result.h5</p>" if left else ""
    return table(("time", "cycle", "what", "where", ""), lines) + more


def bibliography(setup: dict) -> str:
    """The sources of the laws, constants and methods this run used."""
    return "<ol>" + "".join(f"<li>{text(reference)}</li>" for reference in setup["references"]) + "</ol>"
