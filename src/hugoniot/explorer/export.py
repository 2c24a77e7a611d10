"""The page with its data as a folder that opens from the disk: no server, no network, nothing to install.

A browser lets a page from the disk read scripts beside it, not files; so each answer is a script that hands its data to the page.
"""

import base64
import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble, HugoniotError
from hugoniot.explorer.answers import QUESTIONS
from hugoniot.explorer.places import Places
from hugoniot.explorer.transcribed import theory
from hugoniot.output.atomic import explained
from hugoniot.page import files, run_data
from hugoniot.page.reply import encoded

MARK = "hugoniot-explorer.txt"
MOST_RECORDS = 60       # of a two-dimensional run
_FIELDS = ("stress", "pressure", "velocity", "density", "temperature", "plastic_strain", "burn_fraction", "energy")
_PLANE_FIELDS = ("pressure", "speed", "plastic_strain", "temperature", "burn_fraction")


def export(places: Places, folder: Path, *, progress: Callable[[str], None] = lambda text: None) -> int:
    """Write the page and what it may ask into `folder`; the number of files.

    The materials named, or the whole library without any; the runs, sweeps and decks named. Raises `FileTrouble` for a folder that
    holds something else.
    """
    _claim(folder)
    _put(folder / "index.html", files.index(exported=True))
    pages = files.files() | {files.THEORY: theory()}
    for name, data in pages.items():
        _put(folder / name, data)
    known: dict[str, str] = {}
    for question, query in _asked(places):
        key = key_of(question, query)
        try:
            answer = QUESTIONS[question](known_by_name(places), {k: str(v) for k, v in query.items()})
        except HugoniotError as error:
            answer = {"error": str(error)}
        if question == "start":
            answer["files"] = {name: Path(file).name for name, file in answer["files"].items()}
        name = f"data/{len(known):04d}.js"
        _put(folder / name, f"hugoniotData({json.dumps(key)},".encode() + _packed(answer) + b");\n")
        known[key] = name
        progress(key)
    _put(folder / "data" / "data.js", b"window.hugoniotFiles=" + encoded(known) + b";\n")
    return len(known) + len(pages) + 3


def known_by_name(places: Places) -> Places:
    """The same places without the folders of this machine, which are nobody's business elsewhere."""
    named = {key: [p._replace(typed=p.name) for p in getattr(places, key)] for key in ("runs", "sweeps", "fits", "decks")}
    return replace(places, **named)


def key_of(question: str, query: dict[str, Any]) -> str:
    """The name of an answer: the question with its words in the order of the alphabet, as the page makes it."""
    return question + "".join(f"&{key}={query[key]}" for key in sorted(query))


def _claim(folder: Path) -> None:
    if folder.exists() and any(folder.iterdir()) and not (folder / MARK).is_file():
        raise FileTrouble(f"{folder}: not empty, and not an earlier export; choose a new folder")
    with explained(folder):
        (folder / "data").mkdir(parents=True, exist_ok=True)
        for old in (folder / "data").glob("*.js"):
            old.unlink()
    _put(folder / MARK, b"Open index.html in a browser. Written by hugoniot explore --export.\n")


def _put(path: Path, data: bytes) -> None:
    with explained(path):
        path.write_bytes(data)


def _packed(answer: Any) -> bytes:
    if isinstance(answer, np.ndarray):
        data = base64.b64encode(np.ascontiguousarray(answer, "<f8").tobytes()).decode()
        return encoded({"shape": list(answer.shape), "doubles": data})
    return encoded(answer)


def _asked(places: Places) -> Iterator[tuple[str, dict]]:
    yield "start", {}
    yield "materials", {}
    yield "layers", {}
    listed = [m["name"] for m in QUESTIONS["materials"](places, {})["materials"] if m["alone"]]
    for name in dict.fromkeys(places.materials) if places.materials else listed:
        yield "material", {"name": name}
        yield "about", {"name": name}
    for k in range(len(places.runs)):
        yield "run", {"run": k}
        yield from _of_run(places, k)
    yield from (("sweep", {"sweep": k}) for k in range(len(places.sweeps)))
    yield from (("fit", {"fit": k}) for k in range(len(places.fits)))
    yield from (("deck", {"deck": k}) for k in range(len(places.decks)))


def _of_run(places: Places, k: int) -> Iterator[tuple[str, dict]]:
    found = run_data.description(places.run(k).path)
    fields = [f["name"] for f in found["fields"]]
    where = [] if found["plane"] else ["position"]
    gauges = ["time", *where, *(f["name"] for f in found["gauge_fields"])] if found["gauge_times"] else []
    yield from (("array", {"run": k, "group": "gauges", "name": name}) for name in gauges)
    if not found["plane"]:
        names = ["position_left", "position_right", *(f for f in _FIELDS if f in fields)] if len(found["times"]) else []
        yield from (("array", {"run": k, "group": "snapshots", "name": name}) for name in names)
        return
    for record in range(0, len(found["times"]), max(1, -(-len(found["times"]) // MOST_RECORDS))):
        for name in ("position_x", "position_y", *(f for f in _PLANE_FIELDS if f in fields)):
            yield "array", {"run": k, "group": "snapshots", "name": name, "record": record}
