"""What a run has recorded so far: rows in memory, and on the disk as numbered pieces.

A short run keeps its rows in memory and writes them once. A long one sets them down in piece files at every checkpoint,
each whole or not at all; a checkpoint names the pieces that belong to it, so `resume` forgets the later ones. How the rows
were cut into pieces leaves no trace in the result.
"""

import hashlib
import pathlib

import numpy as np

from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import explained, write_whole
from hugoniot.output.codec import decode, encode

TABLES = ("snapshots", "gauges", "budget")
SPILL_BYTES = 64_000_000


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
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
        name = f"{len(self.pieces):06d}.h5"
        data = encode({"tables": {table: _joined(blocks) for table, blocks in self._blocks.items()}, "events": self._events})
        write_whole(self.folder / name, data)
        self.pieces.append((name, hashlib.sha256(data).hexdigest()))
        self._clear()

    def keep(self, pieces: list) -> None:
        """Take `pieces` as all there is, forget what is in memory and remove later pieces from the disk."""
        self.pieces = [(name, digest) for name, digest in pieces]
        self._clear()
        named = {name for name, _ in self.pieces}
        if self.folder.is_dir():
            for path in self.folder.iterdir():
                if path.name not in named:
                    path.unlink()

    def _piece(self, name: str, digest: str) -> dict:
        with explained(self.folder / name):
            data = (self.folder / name).read_bytes()
        if hashlib.sha256(data).hexdigest() != digest:
            raise FileTrouble(f"{self.folder / name}: this piece of the run was changed or cut off after it was written")
        return decode(data)

    def intact(self, pieces: list) -> bool:
        """Whether every named piece is on the disk as it was written."""
        for name, digest in pieces:
            path = self.folder / name
            if not path.is_file() or hashlib.sha256(path.read_bytes()).hexdigest() != digest:
                return False
        return True

    def collect(self) -> tuple[dict[str, dict[str, np.ndarray]], list[dict]]:
        """All rows, from the pieces and from memory, as {table: {column: array}}, and all events."""
        blocks: dict[str, list] = {name: [] for name in TABLES}
        events: list[dict] = []
        for name, digest in self.pieces:
            piece = self._piece(name, digest)
            for table, columns in piece["tables"].items():
                blocks[table] += [columns] if columns else []
            events += piece["events"]
        for table in TABLES:
            blocks[table] += self._blocks[table]
        return {table: _joined(blocks[table]) for table in TABLES}, events + self._events

    def remove(self) -> None:
        """Remove the pieces from the disk, once their rows stand in the result."""
        self.keep([])
        if self.folder.is_dir():
            with explained(self.folder):
                self.folder.rmdir()


def _joined(blocks: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    if not blocks:
        return {}
    return {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
