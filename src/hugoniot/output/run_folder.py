"""The recorder of a run: takes what the time loop hands over and keeps it safe in the run folder.

    folder/deck.toml  result.h5  gauges.csv  summary.json  run.log  report.html
           checkpoint/  pieces/         only while the run is unfinished

A run is finished once summary.json stands there; until then `checkpoint/` and `pieces/` hold what `resume` needs.
"""

import hashlib
import json
import pathlib
import time

import numpy as np

from hugoniot.errors import FileTrouble, UnphysicalState
from hugoniot.output.atomic import explained, write_whole
from hugoniot.output.checkpoint import Checkpoints
from hugoniot.output.codec import encode
from hugoniot.output.plane_record import plane_record
from hugoniot.output.result_file import gauges_text, result_bytes
from hugoniot.output.series import Series
from hugoniot.output.setup_record import plain, setup_record
from hugoniot.output.vtkhdf import vtkhdf_bytes

PRODUCTS = ("result.h5", "gauges.csv", "fronts.csv", "summary.json", "result.vtkhdf", "report.html", "run.log", "post_mortem.h5",
            "post_mortem.txt")


class RunFolder:
    """One run's folder, from `start` to `finish`.

    folder      where; made if it is not there
    overwrite   replace the run that stands there (only files a run writes are removed)
    resume      go on with the unfinished run that stands there: nothing is removed, and `start` leaves deck.toml as it is

    Raises `FileTrouble` if the folder cannot be made or written, or holds a run and neither option is given.
    """

    def __init__(self, folder, *, overwrite: bool = False, resume: bool = False):
        self.folder, self.resumed = pathlib.Path(folder), resume
        self._series = Series(self.folder / "pieces")
        self._checkpoints = Checkpoints(self.folder / "checkpoint")
        self.warnings: list[str] = []
        self._setup: dict = {}
        if resume:
            if not (self.folder / "deck.toml").is_file():
                raise FileTrouble(f"{self.folder}: there is no run to resume here (deck.toml is missing)")
            return
        self._claim(overwrite)

    def _claim(self, overwrite: bool):
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
            standing = [name for name in (*PRODUCTS, "deck.toml", "checkpoint", "pieces") if (self.folder / name).exists()]
        if standing and not overwrite:
            raise FileTrouble(f"{self.folder}: holds {standing[0]} already; choose another folder with --out, or --overwrite the run")
        if standing and "run.log" not in standing:
            raise FileTrouble(f"{self.folder}: holds {standing[0]} but no run.log, so it is no run folder; give another folder with --out")
        with explained(self.folder):
            self._series.remove()
            self._checkpoints.remove()
            for name in PRODUCTS:
                (self.folder / name).unlink(missing_ok=True)

    @property
    def finished(self) -> bool:
        """Whether the run came to its end and its result stands on the disk."""
        return (self.folder / "summary.json").is_file()

    # -- what a run hands over ---------------------------------------------------------------------------------------
    def start(self, problem, deck_text: str, meta: dict) -> None:
        """Write the deck and remember the set-up.

        meta   solver (name), version, region (name of the region of each zone), mass (nzone,), centre (nzone,) of the zones at
               t = 0 in m (of two dimensions centre_x and centre_y, and mesh: see `result_file.result_bytes`), gauges (names,
               in the order of the values' second axis); and, where wanted, references (list of
               text), viscosity (parameter tuple in use), units {column: unit or (unit, long name)}, and the initial faces
               left, right (nzone,) in m
        """
        if not self.resumed:
            write_whole(self.folder / "deck.toml", deck_text, durable=False)
        digest = hashlib.sha256(deck_text.encode()).hexdigest()
        document = plane_record(problem, meta) if "mesh" in meta else setup_record(problem, meta)
        document["faces"] = {side: plain(np.asarray(meta[side])) for side in ("left", "right") if side in meta}
        self._setup = {
            "document": document, "deck": deck_text, "deck_sha256": digest, "gauges": list(meta.get("gauges", ())),
            "region": np.array(list(meta["region"]), dtype=object), "mass": np.array(meta["mass"], dtype=float),
            "centres": {name: np.array(meta[name], dtype=float) for name in ("centre", "centre_x", "centre_y") if name in meta},
            "mesh": dict(meta.get("mesh", {})), "units": dict(meta.get("units", {})),
        }
        word = "resume" if self.resumed else "start"
        self.log(f"{word}: {problem.title} (solver {meta.get('solver', '')}, version {meta.get('version', '')})")
        for material in document["materials"].values():
            for warning in material["warnings"]:
                self.log(f"warning: {material['name']}: {warning}")

    def snapshots(self, times, cycles, fields: dict[str, np.ndarray]) -> None:
        """Zone fields at some times: times, cycles (nt,), each field (nt, nzone), `position_left` and the like included."""
        cycles = np.atleast_1d(np.asarray(cycles, dtype=np.int64))
        self._series.append("snapshots", {"time": np.atleast_1d(times), "cycle": cycles, **fields})

    def gauges(self, times, values: dict[str, np.ndarray]) -> None:
        """Gauge records: times (n,), each field (n, ngauge)."""
        self._series.append("gauges", {"time": np.atleast_1d(times), **values})

    def budget(self, times, values: dict[str, np.ndarray]) -> None:
        """Budgets: times (n,), each quantity (n,) for the whole or (n, nregion) by region in the problem's order."""
        self._series.append("budget", {"time": np.atleast_1d(times), **values})

    def event(self, time: float, cycle: int, kind: str, text: str, **numbers) -> None:
        """Something that happened: kind void_opened, void_closed, joined, warning, cut_off, ...; text a sentence; numbers in SI."""
        self._series.event({"time": float(time), "cycle": int(cycle), "kind": kind, "text": text, "numbers": plain(numbers)})
        self.log(f"t = {time:.6e} s, cycle {cycle}: {kind}: {text}")

    def log(self, text: str) -> None:
        """Add a line to run.log, with the time of day."""
        with explained(self.folder / "run.log"), open(self.folder / "run.log", "a", encoding="utf-8") as file:
            file.write(f"{time.strftime('%Y-%m-%d %H:%M:%S')}  {text}\n")

    # -- safety --------------------------------------------------------------------------------------------------------
    def checkpoint(self, payload: dict) -> None:
        """Set down the rows recorded so far, then the state `payload` (arrays, numbers, words, lists, nested dictionaries).

        Raises `FileTrouble` when the disk refuses; the earlier checkpoints then still stand and the run may be resumed from them.
        """
        self._series.spill()
        self._checkpoints.write(payload, self._series.pieces, self._deck_digest())

    def _deck_digest(self) -> str:
        path = self.folder / "deck.toml"
        with explained(path):
            return hashlib.sha256(path.read_bytes()).hexdigest()

    def latest_checkpoint(self) -> dict | None:
        """The payload of the newest sound checkpoint, or None if there is none (the run then starts from the beginning).

        The record is put back to that moment. Each checkpoint passed over is named in `warnings` and in run.log.
        """
        for number in reversed(self._checkpoints.numbers()):
            try:
                payload, pieces, deck = self._checkpoints.read(number)
                if deck != self._deck_digest():
                    raise FileTrouble(f"{self.folder / 'deck.toml'}: not the deck that checkpoint {number:06d} was written with")
                if not self._series.intact(pieces):
                    raise FileTrouble(f"{self.folder / 'pieces'}: a piece that checkpoint {number:06d} needs is missing or damaged")
            except FileTrouble as error:
                self._warn(f"checkpoint {number:06d} is passed over: {error}")
                continue
            self._checkpoints.forget_after(number)
            with explained(self.folder / "pieces"):
                self._series.keep(pieces)
            return payload
        if self._checkpoints.numbers():
            self._warn("no sound checkpoint is left; the run starts from the beginning")
        with explained(self.folder):
            self._checkpoints.remove()
            self._series.keep([])
        return None

    def fronts(self, columns, kinds: list[str], rows: np.ndarray) -> None:
        """Write fronts.csv: one line per tracked front, its kind first, then the numbers of `columns` (SI)."""
        lines = [",".join(("kind", *columns)), *(",".join((kind, *map(repr, row))) for kind, row in zip(kinds, rows.tolist()))]
        write_whole(self.folder / "fronts.csv", "\n".join(lines) + "\n")

    def _warn(self, text: str) -> None:
        self.warnings.append(text)
        self.log(f"warning: {text}")

    # -- the end -------------------------------------------------------------------------------------------------------
    def finish(self, summary: dict, peaks: dict[str, np.ndarray] | None = None) -> None:
        """Write gauges.csv, result.h5 (and result.vtkhdf of two dimensions) and, last, summary.json; then remove checkpoints and pieces.

        Raises `FileTrouble`; pieces and checkpoints then still stand, so nothing that was on the disk is lost.
        """
        tables, events = self._series.collect()
        setup = self._setup
        table = gauges_text(tables["gauges"], setup["gauges"], setup["units"])
        write_whole(self.folder / "gauges.csv", table, durable=False)
        write_whole(self.folder / "result.h5", result_bytes(tables, events, dict(peaks or {}), setup))
        if setup["mesh"] and "position_x" in tables["snapshots"]:
            image = vtkhdf_bytes(tables["snapshots"], setup["mesh"]["zone_nodes"], setup["mesh"]["block_of"])
            write_whole(self.folder / "result.vtkhdf", image)
        summary = {"title": setup["document"]["title"], "solver": setup["document"]["solver"]["kind"], "status": "done",
                   "version": setup["document"]["version"], "deck_sha256": setup["deck_sha256"], **plain(summary)}
        if self.warnings:
            summary["checkpoint_warnings"] = self.warnings
        self.log(f"end: {summary['status']}")
        write_whole(self.folder / "summary.json", json.dumps(summary, indent=2) + "\n")
        with explained(self.folder):
            self._checkpoints.remove()
            self._series.remove()

    def post_mortem(self, error: UnphysicalState, payload: dict) -> pathlib.Path:
        """Keep the state in which a run failed: post_mortem.h5 (`run.read_post_mortem`) and post_mortem.txt; gives the latter's path."""
        values = "".join(f"  {name} = {value}\n" for name, value in error.values.items())
        text = f"{error}\n" + (f"\nFields there:\n{values}" if values else "")
        self.log(f"unphysical: {error}")
        write_whole(self.folder / "post_mortem.h5", encode(payload))
        write_whole(self.folder / "post_mortem.txt", text)
        return self.folder / "post_mortem.txt"
