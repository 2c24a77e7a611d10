"""The recorder of a run: takes what the time loop hands over and keeps it safe in the run folder.

    folder/deck.toml  result.h5  gauges.csv  summary.json  run.log  report.html
           checkpoint/  pieces/  .lock         only while the run is unfinished

A run is finished once summary.json stands there; until then `checkpoint/` and `pieces/` hold what `resume` needs. The summary
keeps the SHA-256 of the other files and of itself (`verify`).
"""

import hashlib
import pathlib
import time

import numpy as np

from hugoniot.errors import FileTrouble, UnphysicalState
from hugoniot.output import claim
from hugoniot.output.atomic import append, digest, explained, write_whole
from hugoniot.output.checkpoint import Checkpoints
from hugoniot.output.codec import store
from hugoniot.output.lock import Lock
from hugoniot.output.plane_record import plane_record
from hugoniot.output.result_file import write_gauges, write_result
from hugoniot.output.seal import sealed, sealed_json
from hugoniot.output.series import Series
from hugoniot.output.setup_record import plain, setup_record
from hugoniot.output.vtkhdf import write_vtkhdf


class RunFolder:
    """One run's folder, from `start` to `finish`; as a context, it gives the folder free at the end, however that comes.

    folder      where; made if it is not there
    overwrite   replace the run that stands there (only files a run writes are removed)
    resume      go on with the run that stands there: nothing is removed, and `start` leaves deck.toml as it is

    Raises `FileTrouble` if the folder cannot be made or written, is in use by another process, or holds a run and neither option is given.
    """

    def __init__(self, folder, *, overwrite: bool = False, resume: bool = False):
        self.folder, self.resumed = pathlib.Path(folder), resume
        self._series = Series(self.folder / "pieces")
        self._checkpoints = Checkpoints(self.folder / "checkpoint")
        self.warnings: list[str] = []
        self._setup: dict = {}
        if resume and not (self.folder / "deck.toml").is_file() and not self.finished and self._checkpoints.deck() is None:
            raise FileTrouble(f"{self.folder}: there is no run to resume here (deck.toml is missing)")
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
        if not resume:
            claim.refuse_foreign(self.folder, overwrite, self._checkpoints)
        self._lock = Lock(self.folder)
        if not resume:
            self._clear(overwrite)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self) -> None:
        """Give the folder free for other processes."""
        self._lock.release()

    def _clear(self, overwrite: bool) -> None:
        """Make room for a new run, now that nobody else works here."""
        try:
            claim.refuse_foreign(self.folder, overwrite, self._checkpoints)
            self._series.remove()
            self._checkpoints.remove()
            claim.remove_products(self.folder)
        except FileTrouble:
            self.close()
            raise

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
            write_whole(self.folder / "run.log", "", durable=False)
            self._checkpoints.start(deck_text)
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
        log_line(self.folder, text)

    # -- safety --------------------------------------------------------------------------------------------------------
    def checkpoint(self, payload: dict) -> None:
        """Set down the rows recorded so far, then the state `payload` (arrays, numbers, words, lists, nested dictionaries).

        Raises `FileTrouble` when the disk refuses; the earlier checkpoints then still stand and the run may be resumed from them.
        """
        self._series.spill()
        self._checkpoints.write(payload, self._series.pieces, self._setup["deck"])

    def checked_deck(self, restore: bool = False) -> str:
        """The text of deck.toml of a run that goes on, which must be that of its checkpoints.

        restore   put the deck of the checkpoints back first

        Raises `FileTrouble` with the difference where they disagree.
        """
        path, kept = self.folder / "deck.toml", self._checkpoints.deck()
        if restore and kept is not None:
            write_whole(path, kept)
        return claim.same_deck(path, kept)

    def latest_checkpoint(self) -> dict | None:
        """The payload of the newest sound checkpoint, or None if there is none (the run then starts from the beginning).

        The record is put back to that moment. Each checkpoint passed over is named in `warnings` and in run.log.
        """
        for number in reversed(self._checkpoints.numbers()):
            try:
                payload, pieces = self._checkpoints.read(number)
                if not self._series.intact(pieces):
                    raise FileTrouble(f"{self.folder / 'pieces'}: a piece that checkpoint {number:06d} needs is missing or damaged")
            except FileTrouble as error:
                self._warn(f"checkpoint {number:06d} is skipped: {error}")
                continue
            self._checkpoints.forget_after(number)
            self._series.keep(pieces)
            return payload
        if self._checkpoints.numbers():
            self._warn("no intact checkpoint is left; the run starts from the beginning")
        self._checkpoints.forget_all()
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
        sums = {"deck.toml": setup["deck_sha256"],
                "gauges.csv": write_gauges(self.folder / "gauges.csv", tables["gauges"], setup["gauges"], setup["units"]).sha256,
                "result.h5": write_result(self.folder / "result.h5", tables, events, dict(peaks or {}), setup).sha256}
        sums |= self._write_others(tables["snapshots"])
        summary = {"title": setup["document"]["title"], "solver": setup["document"]["solver"]["kind"], "status": "done",
                   "version": setup["document"]["version"], "deck_sha256": setup["deck_sha256"], **plain(summary)}
        if self.warnings:
            summary["checkpoint_warnings"] = self.warnings
        with explained(self.folder / "report.html"):
            (self.folder / "report.html").unlink(missing_ok=True)       # of the run while it was unfinished
        self.log(f"end: {summary['status']}")
        with explained(self.folder / "run.log"):
            log = digest(self.folder / "run.log")
        summary |= {"run_log_bytes": log.bytes, "sha256": {**sums, "run.log": log.sha256}}
        write_whole(self.folder / "summary.json", sealed_json(summary))
        self.tidy()

    def _write_others(self, snapshots) -> dict[str, str]:
        """Files that only some runs have, name -> SHA-256: result.vtkhdf of two dimensions, fronts.csv of tracked fronts."""
        sums = {}
        mesh = self._setup["mesh"]
        if mesh and "position_x" in snapshots.names:
            sums["result.vtkhdf"] = write_vtkhdf(self.folder / "result.vtkhdf", snapshots, mesh["zone_nodes"], mesh["block_of"]).sha256
        if (self.folder / "fronts.csv").is_file():
            sums["fronts.csv"] = digest(self.folder / "fronts.csv").sha256
        return sums

    def tidy(self) -> list[str]:
        """Remove what an unfinished run needs and a finished one does not; what was there. Raises `FileTrouble`."""
        left = [name for name in ("checkpoint", "pieces") if (self.folder / name).is_dir()]
        self._checkpoints.remove()
        self._series.remove()
        return left + claim.remove_unfinished(self.folder)

    def post_mortem(self, error: UnphysicalState, payload: dict) -> pathlib.Path:
        """Keep the state in which a run failed: post_mortem.h5 (`run.read_post_mortem`) and post_mortem.txt; gives the latter's path."""
        values = "".join(f"  {name} = {value}\n" for name, value in error.values.items())
        self.log(f"unphysical: {error}")
        state = store(self.folder / "post_mortem.h5", payload)
        text = f"{error}\n" + (f"\nFields there:\n{values}" if values else "") + f"\nSHA-256 of post_mortem.h5: {state.sha256}\n"
        write_whole(self.folder / "post_mortem.txt", sealed(text))
        return self.folder / "post_mortem.txt"


def log_line(folder, text: str) -> None:
    """Add a line to the run.log of a folder, with the time of day. Raises `FileTrouble`."""
    append(pathlib.Path(folder) / "run.log", f"{time.strftime('%Y-%m-%d %H:%M:%S')}  {text}\n")
