"""What a run has recorded so far: rows in memory, and on the disk as numbered pieces.

A short run keeps its rows in memory and writes them once. A long one sets them down in piece files at every checkpoint,
each whole or not at all; a checkpoint names the pieces that belong to it, so `resume` forgets the later ones. How the rows
were cut into pieces leaves no trace in the result. However many there are, no more than IN_MEMORY, or one column of one piece, is in
memory at a time.
"""

import contextlib
import pathlib
import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import digest, explained
from hugoniot.output.codec import opened, store

TABLES = ("snapshots", "gauges", "budget")
SPILL_BYTES = 64_000_000
IN_MEMORY = 2 * SPILL_BYTES     # pieces that are no more together are read once, and not anew for every column
_PIECE = re.compile(r"\d{6,}\.h5|\.\d{6,}\.h5\.part")


class Table:
    """The rows of one table, read column by column: `names`, `length` (rows), `shapes` {name: shape of a row}, `kinds` {name: dtype}."""

    def __init__(self, sources: list):
        self._sources = sources     # of (number of rows, function from a name to the rows of its column)
        self.length = sum(rows for rows, *_ in sources)
        self.shapes, self.kinds = sources[0][2:] if sources else ({}, {})
        self.names = list(self.shapes)

    def column(self, name: str, rows: int) -> Iterator[np.ndarray]:
        """The column in blocks of exactly `rows` rows, the last one shorter: the same blocks however the rows were set down."""
        waiting: list[np.ndarray] = []
        count = 0
        for _, read, *_ in self._sources:
            block = read(name)
            while count + len(block) >= rows:
                part = block[: rows - count]
                yield np.concatenate([*waiting, part]) if waiting else part
                block, waiting, count = block[rows - count:], [], 0
            if len(block):
                waiting.append(block)
                count += len(block)
        if waiting:
            yield np.concatenate(waiting)

    @classmethod
    def of(cls, columns: Mapping) -> "Table":
        """The table of columns that are in memory, or come when they are asked for."""
        return cls([_held(columns)] if len(columns) else [])

    @property
    def bytes(self) -> int:
        """Size of all columns."""
        return self.length * sum(int(np.prod(self.shapes[name])) * self.kinds[name].itemsize for name in self.names)


class Series:
    """Rows of the tables `snapshots`, `gauges` and `budget`, and events.

    folder   where pieces go; made when the first piece is written
    pieces   [(file name, sha256)] of the pieces that hold the rows already set down
    """

    def __init__(self, folder: pathlib.Path):
        self.folder, self.pieces = pathlib.Path(folder), []
        self._clear()

    def _clear(self):
        self._blocks: dict[str, list[dict[str, np.ndarray]]] = {name: [] for name in TABLES}
        self._events: list[dict] = []
        self._bytes = 0

    def append(self, table: str, columns: dict[str, np.ndarray]) -> None:
        """Add rows: every column has the rows as its first axis. The arrays are copied, so the caller may reuse its buffers."""
        block = {name: np.array(values) for name, values in columns.items()}
        lengths = {len(values) for values in block.values()}
        if len(lengths) > 1:
            raise ValueError(f"{table}: columns of different lengths {sorted(lengths)}")
        if lengths == {0}:
            return
        self._blocks[table].append(block)
        self._bytes += sum(values.nbytes for values in block.values())
        if self._bytes > SPILL_BYTES:
            self.spill()

    def event(self, row: dict) -> None:
        self._events.append(row)

    @property
    def empty(self) -> bool:
        """Whether memory holds nothing that is not on the disk."""
        return not self._events and not any(self._blocks.values())

    def spill(self) -> None:
        """Set the rows in memory down as the next piece."""
        if self.empty:
            return
        own_folder(self.folder)
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
        name = f"{len(self.pieces):06d}.h5"
        tables = {table: _joined(blocks) for table, blocks in self._blocks.items()}
        written = store(self.folder / name, {"tables": tables, "events": self._events})
        self.pieces.append((name, written.sha256))
        self._clear()

    def keep(self, pieces: list) -> None:
        """Take `pieces` as all there is, forget what is in memory and remove later pieces from the disk."""
        self.pieces = [(name, digest) for name, digest in pieces]
        self._clear()
        named = {name for name, _ in self.pieces}
        remove_files(self.folder, lambda name: _PIECE.fullmatch(name) and name not in named)

    def intact(self, pieces: list) -> bool:
        """Whether every named piece is on the disk as it was written."""
        return all(self._sound(name, wanted) for name, wanted in pieces)

    def _sound(self, name: str, wanted: str) -> bool:
        try:
            return bool(_PIECE.fullmatch(name)) and digest(self.folder / name).sha256 == wanted
        except OSError:
            return False

    def collect(self) -> tuple[dict[str, Table], list[dict]]:
        """All rows, from the pieces and from memory, as {table: Table}, and all events. `FileTrouble` if a piece was changed."""
        sources: dict[str, list] = {name: [] for name in TABLES}
        events: list[dict] = []
        small = sum(_size(self.folder / name) for name, _ in self.pieces) <= IN_MEMORY
        for name, wanted in self.pieces:
            path = self.folder / name
            if not self._sound(name, wanted):
                raise FileTrouble(f"{path}: this piece of the run was changed or cut off after it was written")
            with opened(path) as piece:
                for table, columns in piece["tables"].items():
                    if columns:
                        held = {column: values[()] for column, values in columns.items()} if small else {}
                        sources[table].append(_held(held) if small else _stored(path, table, columns))
                events += piece["events"]
        for table in TABLES:
            sources[table] += [_held(block) for block in self._blocks[table]]
        return {table: Table(sources[table]) for table in TABLES}, events + self._events

    def remove(self) -> None:
        """Remove the pieces from the disk, once their rows stand in the result."""
        self.keep([])
        remove_folder(self.folder)


def _size(path: pathlib.Path) -> int:
    """Bytes of a file; more than any memory where it cannot be looked at."""
    try:
        return path.stat().st_size
    except OSError:
        return 2**62


def _described(columns: Mapping) -> tuple[dict, dict]:
    return {name: tuple(values.shape[1:]) for name, values in columns.items()}, {name: values.dtype for name, values in columns.items()}


def _held(block: Mapping) -> tuple:
    return (len(next(iter(block.values()))), block.__getitem__, *_described(block))


def _stored(path: pathlib.Path, table: str, columns: dict[str, Any]) -> tuple:
    def read(name: str) -> np.ndarray:
        with opened(path) as piece:
            return piece["tables"][table][name][()]

    return (len(next(iter(columns.values()))), read, *_described(columns))


def _joined(blocks: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    if len(blocks) < 2:
        return blocks[0] if blocks else {}
    return {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}


def own_folder(folder: pathlib.Path) -> None:
    """Raise `FileTrouble` if what stands there is a link: a run makes none, and follows none."""
    if folder.is_symlink():
        raise FileTrouble(f"{folder}: this is a link, and a run does not write or remove anything through a link; remove it")


def remove_files(folder: pathlib.Path, wanted) -> None:
    """Remove the files of a folder whose names are `wanted`, and nothing else. Raises `FileTrouble`."""
    own_folder(folder)
    if not folder.is_dir():
        return
    with explained(folder):
        for path in folder.iterdir():
            if wanted(path.name):
                path.unlink(missing_ok=True)


def remove_folder(folder: pathlib.Path) -> None:
    """Remove a folder that is empty; one in which somebody keeps files stays."""
    if folder.is_dir():
        with contextlib.suppress(OSError):
            folder.rmdir()
