"""The page with the record of one run inside one file: what a report adds to its pictures, for browsers that run scripts.

Arrays are thinned to what a file to send may weigh. They stand as doubles, byte by byte of their places (all first bytes, then all
second ones), deflated: so a browser reads the digits of the run.
"""

import base64
import hashlib
import zlib
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.page import files, run_data
from hugoniot.page.reply import encoded
from hugoniot.version import __version__

BYTES = 1_000_000       # of the doubles of all fields together
MOST_BYTES = 16_000_000     # of a single record: a larger one is no file to send
FIELDS = ("stress", "pressure", "velocity", "density", "temperature", "plastic_strain")
PLANE_FIELDS = ("pressure", "speed", "plastic_strain", "burn_fraction", "density")
MOST_FIELDS = 4
KEY = "answers"


def shell(folder: Path, name: str, body: str, style: str) -> str | None:
    """The page of a report: `body` is what is read without scripts. None for a run whose record no view of the page draws, or one file
    does not hold."""
    try:
        known = answers(Path(folder), name)
    except (HugoniotError, KeyError, ValueError, IndexError):
        return None
    script = files.report_script()
    allowed = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = (f"default-src 'none'; script-src 'sha256-{allowed}'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; "
              "form-action 'none'")
    dress = files.files()["style.css"].decode()
    return "".join([
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}"><title>{escape(name)}</title>',
        f'<style id="of-report">{style}</style><style id="of-page" media="not all">{dress}</style></head><body>',
        files.frame(), f'<main id="report">{body}</main>',
        f'<script type="application/json" id="{KEY}">{json_text(known)}</script><script>{script}</script></body></html>\n'])


def json_text(known: dict[str, Any]) -> str:
    """The answers as JSON that ends no script."""
    return encoded({key: packed(value) if isinstance(value, np.ndarray) else value for key, value in known.items()}).decode()


def packed(values: np.ndarray) -> dict[str, Any]:
    """Shape, and the doubles with their bytes sorted by place, deflated, as text."""
    places = np.ascontiguousarray(values, "<f8").view(np.uint8).reshape(-1, 8).T
    return {"shape": list(values.shape), "deflated": base64.b64encode(zlib.compress(places.tobytes(), 6)).decode()}


def answers(folder: Path, name: str) -> dict[str, Any]:
    """Question -> answer, under the names the page asks by, thinned so that all arrays together hold about `BYTES`."""
    found = run_data.description(folder)
    runs = [{"name": folder.name, "title": found["title"], "status": found["status"]}]
    start = {"version": __version__, "runs": runs, "sweeps": [], "fits": [], "decks": [], "materials": [], "files": {}, "may_run": False,
             "views": ["report", "runs"]}
    known: dict[str, Any] = {"start": start}
    wanted = [f for name in (PLANE_FIELDS if found["plane"] else FIELDS) for f in found["fields"] if f["name"] == name][:MOST_FIELDS]
    columns = _plane(folder, found, wanted) if found["plane"] else _line(folder, found, wanted)
    known |= columns | _gauges(folder, found)
    mesh = {name: packed(np.asarray(found[name], float)) for name in ("zone_nodes", "block_of") if name in found}
    return known | {"run&run=0": {**found, **mesh, "fields": wanted}}


def _key(**query) -> str:
    return "array" + "".join(f"&{key}={query[key]}" for key in sorted(query))


def _thin(found: dict, bytes_of_a_record: int) -> int:
    """How many records go by for one that is kept; the description says so. ValueError where a single one is too large."""
    if bytes_of_a_record > MOST_BYTES:
        raise ValueError("a record is too large for a page in one file")
    step = max(1, -(-len(found["times"]) * bytes_of_a_record // BYTES))
    found["times"] = np.asarray(found["times"])[::step]
    found["every"] *= step
    return step


def _line(folder: Path, found: dict, wanted: list) -> dict[str, np.ndarray]:
    if not len(found["times"]):
        return {}
    names = ["position_left", "position_right", *(f["name"] for f in wanted)]
    step = _thin(found, 8 * found["zones"] * len(names))
    return {_key(run=0, group="snapshots", name=name): run_data.column(folder, "snapshots", name, {}, step) for name in names}


def _plane(folder: Path, found: dict, wanted: list) -> dict[str, np.ndarray]:
    if not len(found["times"]):
        return {}
    step = _thin(found, 8 * (2 * int(np.max(found["zone_nodes"]) + 1) + len(wanted) * len(found["zone_nodes"])))
    names = ["position_x", "position_y", *(f["name"] for f in wanted)]
    return {_key(run=0, group="snapshots", name=name, record=k): run_data.column(folder, "snapshots", name, {"record": k * step})
            for k in range(len(found["times"])) for name in names}


def _gauges(folder: Path, found: dict) -> dict[str, np.ndarray]:
    if not found["gauge_times"]:
        return {}
    names = ["time", *([] if found["plane"] else ["position"]), *(f["name"] for f in found["gauge_fields"])]
    columns = {}
    for name in names:
        try:
            columns[name] = run_data.column(folder, "gauges", name, {})
        except HugoniotError:       # gauges of some solvers stand still
            continue
    step = max(1, -(-sum(values.nbytes for values in columns.values()) // (BYTES // 3)))
    return {_key(run=0, group="gauges", name=name): values[::step] for name, values in columns.items()}
