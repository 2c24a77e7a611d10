"""A finished run, read from its folder: `hugoniot.load(folder)`.

`gauges`, `snapshots`, `budget`, `peaks` and `events` are xarray Datasets with units; `arrays` gives the same as plain arrays
(xarray takes half a second to import; reports and plots do without). Nothing is changed in the folder. A file that was
changed after the run is not read: its SHA-256 is in summary.json and is checked before HDF5 opens the file.
"""

import json
import os
import pathlib
import re
import shlex
from functools import cached_property
from typing import Any

import numpy as np

from hugoniot.diagnostics.interface_gauges import CONTINUOUS, sides
from hugoniot.errors import FileTrouble
from hugoniot.files import Hdf5Texts, hdf5_texts_end, read_regular, read_text
from hugoniot.output.atomic import digest, legible
from hugoniot.output.codec import decode
from hugoniot.output.hdf5 import h5py
from hugoniot.output.result_columns import Columns, extent, shape_of
from hugoniot.output.result_layout import Misfit, described
from hugoniot.output.seal import MARK, intact, read_sealed
from hugoniot.output.setup_layout import wrong_setup, wrong_summary

_ENDLESS = "cannot be read as a result (its strings are not terminated)"
GROUPS = ("snapshots", "gauges", "budget", "peaks", "events")


def load(folder, partial: bool = False) -> "Run":
    """Open the folder of a finished run, and return it as a `Run`.

    partial   whether a damaged result is read as far as possible: columns whose own checksums agree; names and texts may be wrong

    Raises `FileTrouble` if there is no run in the folder, or if it is unfinished or damaged.

    >>> run = hugoniot.load("flyer.run")
    >>> run.summary["status"]
    'done'
    """
    return Run(folder, partial)


class Run:
    """The results of a run, read from its folder. All numbers are in SI.

    Records are available as xarray Datasets (`gauges`, `snapshots`, `budget`, `peaks`, `events`) and as plain arrays (`arrays`, `gauge`).
    The files are checked against the checksums of the run before they are read, and they are never changed.

    folder    the run folder
    partial   as for `load`
    """

    plot: Any   # the pictures of this run: the room `plotting`, a layer above, puts it here

    def __init__(self, folder, partial: bool = False):
        self.folder, self.partial = pathlib.Path(folder), partial
        self._looked_at: dict[str, tuple] = {}
        if not self.folder.is_dir():
            what = "this is a file, not a run folder" if self.folder.exists() else "there is no such run folder"
            raise FileTrouble(f"{self.folder}: {what}")
        if not (self.folder / "result.h5").is_file() or not (partial or (self.folder / "summary.json").is_file()):
            raise FileTrouble(f"{self.folder}: {_what_is_there(self.folder)}")
        self._tables: dict[str, tuple[Columns, dict, dict]] = {}

    def __repr__(self):
        return f"<Run '{self.summary['title']}' ({self.summary['status']}) in {self.folder}>"

    @cached_property
    def summary(self) -> dict:
        """Contents of summary.json, such as title, status, number of time steps, and errors of mass, momentum and energy."""
        path = self.folder / "summary.json"
        if self.partial and not path.is_file():
            return _whatever(b"")
        with legible(path):
            data = read_regular(path)
        try:
            return _of_a_run(path, read_sealed(path, data, ("sha256", "run_log_bytes")))
        except FileTrouble as error:
            if self.partial:
                return _whatever(data)
            raise FileTrouble(f"{error}; see `hugoniot info {shlex.quote(str(self.folder))} --verify`") from error

    @cached_property
    def fronts(self) -> dict[str, np.ndarray]:
        """Columns of fronts.csv, which the solver fronts writes: `kind` as texts, all others as numbers in SI; empty for other solvers."""
        path = self.folder / "fronts.csv"
        if not path.is_file():
            if "fronts.csv" in self.summary.get("sha256", {}):
                raise FileTrouble(f"{path}: missing, although the run wrote it")
            return {}
        self._check("fronts.csv")
        try:
            with legible(path):
                head, *lines = read_text(path).splitlines()
            names, rows = head.split(","), [line.split(",") for line in lines]
            if lost := [name for name in ("kind", "time", "position", "end_time", "end_position", "strength") if name not in names]:
                raise ValueError(f"the column '{lost[0]}' is missing")
            columns = dict(zip(names, zip(*rows, strict=True), strict=True)) if rows else dict.fromkeys(names, ())
            return {name: np.array(values) if name == "kind" else np.array(values, dtype=float) for name, values in columns.items()}
        except ValueError as error:     # only a damaged file that is read on demand
            raise FileTrouble(f"{path}: not written by hugoniot, or damaged ({error})") from error

    @cached_property
    def _setup(self) -> tuple[dict, str]:
        try:
            if not self.partial:
                self._described  # noqa: B018  (raises where the file is none of a run)
            with self._open() as file:
                group = file["setup"]
                document, deck = json.loads(group["document"].asstr()[()]), group["deck"].asstr()[()]
                if not isinstance(document, dict):
                    raise ValueError("the document is not a table")
        except json.JSONDecodeError as error:
            raise FileTrouble(f"{self.folder / 'result.h5'}: setup: damaged, cannot be read (not JSON)") from error
        except (RuntimeError, KeyError, ValueError, TypeError, AttributeError, RecursionError) as error:
            raise FileTrouble(f"{self.folder / 'result.h5'}: setup: damaged, cannot be read ({error})") from error
        wrong = "" if self.partial else wrong_setup(document, "mesh" in self._described)
        if wrong:
            raise FileTrouble(f"{self.folder / 'result.h5'}: not written by hugoniot, or damaged (setup: {wrong})")
        return document, deck

    @property
    def setup(self) -> dict:
        """Description of the problem: regions, boundaries, gauges, and materials with every constant and its source."""
        return self._setup[0]

    @property
    def deck(self) -> str:
        """Text of the deck with every default written out, in SI."""
        return self._setup[1]

    def _check(self, name: str) -> None:
        """Raise `FileTrouble` unless a file has the SHA-256 the summary remembers; once for a file that stays as it is."""
        path = self.folder / name
        sums = self.summary.get("sha256", {})
        wanted = sums.get(name) if isinstance(sums, dict) else ""
        if self.partial or wanted is None:      # an early run has none
            return
        with legible(path):
            now = os.stat(path)
            state = now.st_ino, now.st_size, now.st_mtime_ns
            if state == self._looked_at.get(name):
                return
            texts = Hdf5Texts()
            found = digest(path, texts.feed if name == "result.h5" else None).sha256
            if found == wanted and not texts.end(path):
                raise FileTrouble(f"{path}: {_ENDLESS}")
        if found != wanted:
            raise FileTrouble(f"{path}: changed since the run ended (its SHA-256 does not agree with summary.json), so it is not read; "
                              f"`hugoniot info {shlex.quote(str(self.folder))} --verify` reports what can still be read")
        self._looked_at[name] = state

    def _open(self):
        path = self.folder / "result.h5"
        self._check("result.h5")
        try:
            if self.partial and not hdf5_texts_end(path):
                raise FileTrouble(f"{path}: {_ENDLESS}")
            return h5py().File(path, "r")
        except FileTrouble:
            raise
        except PermissionError as error:
            raise FileTrouble(f"{path}: no permission to read it") from error
        except (OSError, RuntimeError) as error:
            raise FileTrouble(f"{path}: cannot be read as a result ({error})") from error

    @cached_property
    def _described(self) -> dict:
        """What result.h5 holds (`result_layout`); `FileTrouble` that names what is missing in one that another program wrote."""
        path = self.folder / "result.h5"
        with self._open() as file:
            try:
                return described(file, listed="sha256" in self.summary)
            except (Misfit, OSError, RuntimeError, KeyError, ValueError, TypeError, AttributeError) as error:
                what = "not written by hugoniot, or damaged" if isinstance(error, Misfit) else "cannot be read as a result"
                raise FileTrouble(f"{path}: {what} ({error})") from error

    def _table(self, group: str) -> tuple[Columns, dict, dict]:
        if group not in self._tables:
            place = f"{self.folder / 'result.h5'}: {group}"
            if self.partial:
                with self._open() as file:
                    known = [name for name in file if name != "setup"]
                    if group in known:
                        self._tables[group] = Columns.described(self._open, place, file[group])
            elif group in (known := sorted(self._described)):
                self._tables[group] = Columns.of(self._open, place, group, self._described[group])
            if group not in self._tables:
                if group in GROUPS:
                    raise FileTrouble(f"{self.folder / 'result.h5'}: not written by hugoniot, or damaged (the group '{group}' is missing)")
                raise KeyError(f"no group '{group}' in a run; it has: {', '.join(known)}")
        return self._tables[group]

    def arrays(self, group: str) -> Columns:
        """Columns of one group (`snapshots`, `gauges`, `budget`, `peaks` or `events`) by name, as arrays in SI.

        Each column is read when it is first used. Raises KeyError for an unknown group.
        """
        return self._table(group)[0]

    def unit(self, group: str, name: str) -> str:
        """SI unit of a column of a group, "" if dimensionless. Raises KeyError, which lists the known columns, for an unknown one."""
        attributes = self._table(group)[1]
        if name not in attributes:
            raise KeyError(f"no column '{name}' in {group}; it has: {', '.join(attributes)}")
        return attributes[name].get("units", "")

    def dataset(self, group: str):
        """One group as an xarray Dataset; each variable has the attributes `units` and `long_name`.

        Large columns are read only where their values are used.
        """
        from hugoniot.output.datasets import dataset

        values, attributes, dims = self._table(group)
        axes = {name for name, along in dims.items() if along == (name,)}
        extra = {name for name in ("region", "centre", "centre_x", "centre_y", "mass") if name in values and "zone" in dims[name]}
        extra |= {"cycle"} & set(values) if group == "snapshots" else set()
        about = {"title": self.summary["title"], "solver": self.summary["solver"], "version": self.summary["version"]}
        return dataset(values, dims, attributes, axes | extra, about)

    @cached_property
    def gauges(self):
        """Records of the gauges: a Dataset with the dimensions (time, gauge)."""
        return self.dataset("gauges")

    @cached_property
    def snapshots(self):
        """Fields of the zones: a Dataset with the dimensions (time, zone), with the region, the centre at t = 0 and the mass of each zone.

        In two dimensions also fields of the nodes, with the dimensions (time, node).
        """
        return self.dataset("snapshots")

    @cached_property
    def budget(self):
        """Energies and momentum: a Dataset with the dimensions (time) or (time, region)."""
        return self.dataset("budget")

    @cached_property
    def peaks(self):
        """Extreme values that each zone reached: a Dataset with the dimension (zone)."""
        return self.dataset("peaks")

    @cached_property
    def events(self):
        """Events, such as voids opened: a Dataset with the dimension (event), holding time, cycle, kind, text and numbers (as JSON)."""
        return self.dataset("events")

    def gauge_names(self) -> list[str]:
        """Names of the gauges in the order of the deck, followed by those of free surfaces that have no gauge in the deck."""
        names = [str(name) for name in self.arrays("gauges")["gauge"]]
        pairs = {} if self.partial else sides(self.setup["gauges"])
        lost = [whole for side, whole in pairs.items() if side in names and whole not in names]
        if lost:
            raise FileTrouble(f"{self.folder / 'result.h5'}: not written by hugoniot, or damaged (gauges/gauge: '{lost[0]}' is missing)")
        return names

    def gauge(self, field: str, name: str | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Record of one field at one gauge: arrays (time (n,) in s, value (n,) in SI).

        field   name of a field, such as "velocity" or "stress"
        name    name of the gauge (default: the first one)

        Raises KeyError, which lists the known names, for an unknown gauge or field, and for a field that differs on the two sides of the
        interface of a gauge (use NAME left or NAME right).

        >>> time, stress = run.gauge("stress", "2 mm into target")
        """
        rows, names = self.arrays("gauges"), self.gauge_names()
        name = names[0] if name is None and names else name
        if name not in names:
            raise KeyError(f"no gauge '{name}'; this run has: {', '.join(names) or 'none'}")
        if field not in rows or rows[field].ndim != 2:
            known = ", ".join(key for key, values in rows.items() if values.ndim == 2)
            raise KeyError(f"no gauge field '{field}'; this run has: {known}")
        values = rows[field][:, names.index(name)]
        if field not in CONTINUOUS and name in set(sides(self.setup["gauges"]).values()):
            raise KeyError(f"{field} differs on the two sides of an interface: use '{name} left' or '{name} right'")
        return rows["time"], values


def read_post_mortem(folder) -> dict:
    """The state kept by a run that failed: what the solver handed to `RunFolder.post_mortem`.

    Raises `FileTrouble` if it was changed since.
    """
    path = pathlib.Path(folder) / "post_mortem.h5"
    with legible(path):
        found, words = digest(path), read_regular(path.with_suffix(".txt")).decode("utf-8", "surrogateescape")
    wanted = re.search(r"SHA-256 of post_mortem.h5: ([0-9a-f]{64})", words)
    if intact(words) is False or (wanted is None and MARK in words) or (wanted and wanted[1] != found.sha256):
        raise FileTrouble(f"{path}: changed since it was written (its SHA-256 does not agree with post_mortem.txt)")
    return decode(path)


def _of_a_run(path, summary: dict) -> dict:
    """The summary, or `FileTrouble` where it lacks what that of every run has: it was made by another program."""
    if wrong := wrong_summary(summary):
        raise FileTrouble(f"{path}: not written by hugoniot, or damaged ({wrong})")
    return summary


def _whatever(data: bytes) -> dict:
    """What a damaged summary still says."""
    try:
        document = json.loads(data.decode("utf-8", "replace"))
    except (ValueError, RecursionError):
        document = {}
    return {"title": "?", "status": "damaged", "solver": "?", "version": "?", **(document if isinstance(document, dict) else {})}


def _what_is_there(folder: pathlib.Path) -> str:
    if (folder / "post_mortem.txt").is_file():
        return "the run failed and left no result; see post_mortem.txt"
    again = f"hugoniot resume {shlex.quote(str(folder))}"
    if (folder / "result.h5").is_file() and not (folder / "checkpoint").is_dir():
        return (f"summary.json is missing, so result.h5 cannot be checked; `{again}` computes the run again, and "
                "hugoniot.load(folder, partial=True) reads result.h5 unchecked")
    if (folder / "deck.toml").is_file() and not (folder / "pieces").is_dir() and not any((folder / "checkpoint").glob("[0-9]*.json")):
        return f"the run is unfinished and has no checkpoint yet; `{again}` starts it again"
    if (folder / "checkpoint").is_dir() or (folder / "pieces").is_dir():
        return f"the run is unfinished; continue with `{again}`, or see its results so far with `hugoniot info {shlex.quote(str(folder))}`"
    return "this is not a run folder (no result.h5)"


def largest_value(run, field: str) -> float:
    """The largest size of a field, or of its components, in the gauges and snapshots of a run, SI."""
    tables = [run.arrays(group) for group in ("gauges", "snapshots")]
    ends = [extent(table, name) for table in tables for name in table if name.startswith(field) and 0 not in shape_of(table, name)]
    return max((max(highest, -lowest) for lowest, highest in ends), default=0.0)
