"""Checkpoints: the state a run can go on from, bit for bit, and the deck it belongs to.

`checkpoint/start.json` holds the deck of the run. `checkpoint/000012.h5` holds a state and `checkpoint/000012.json` its manifest:
length, SHA-256, the pieces of the record that belong to it, and the deck. A checkpoint exists once its manifest does; it is
believed only if length and hash agree, before HDF5 opens the file. The newest two are kept, so a damaged one costs the time
since the one before. All JSON files here are sealed (`seal`).
"""

import contextlib
import hashlib
import pathlib
import re

from hugoniot.errors import FileTrouble
from hugoniot.files import read_regular
from hugoniot.output.atomic import digest, explained, write_whole
from hugoniot.output.codec import decode, store
from hugoniot.output.seal import read_sealed, sealed_json
from hugoniot.output.series import own_folder, remove_files, remove_folder

KEEP = 2
START = "start.json"
_OURS = re.compile(r"\d{6,}\.(json|h5)|\.\d{6,}\.(json|h5)\.part|\.?start\.json(\.part)?")


class Checkpoints:
    """The checkpoints of one run folder."""

    def __init__(self, folder: pathlib.Path):
        self.folder = pathlib.Path(folder)

    def numbers(self) -> list[int]:
        """Numbers of the checkpoints that have a manifest, oldest first."""
        if not self.folder.is_dir():
            return []
        found = (re.fullmatch(r"(\d{6,})\.json", path.name) for path in self.folder.iterdir())
        return sorted(int(match[1]) for match in found if match)

    def start(self, deck: str) -> None:
        """Keep the deck with which a run starts."""
        self._make()
        write_whole(self.folder / START, sealed_json({"deck_sha256": _sha256(deck), "deck": deck}), durable=False)

    def _make(self) -> None:
        own_folder(self.folder)
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)

    def write(self, payload: dict, pieces: list, deck: str) -> None:
        """Write the next checkpoint and drop all but the newest two. Raises `FileTrouble`; the older ones then still stand."""
        self._make()
        numbers = self.numbers()
        stem = f"{(numbers[-1] + 1 if numbers else 0):06d}"
        written = store(self.folder / f"{stem}.h5", payload)
        manifest = {"file": f"{stem}.h5", "bytes": written.bytes, "sha256": written.sha256, "pieces": [list(piece) for piece in pieces],
                    "deck_sha256": _sha256(deck), "deck": deck}
        write_whole(self.folder / f"{stem}.json", sealed_json(manifest))
        for number in numbers[: len(numbers) + 1 - KEEP]:
            self._drop(number)

    def _drop(self, number: int) -> None:
        for suffix in ("json", "h5"):
            with contextlib.suppress(OSError):
                (self.folder / f"{number:06d}.{suffix}").unlink()

    def manifest(self, name: str) -> dict:
        """A sealed document of the folder, or `FileTrouble` if it is missing, damaged or not what a run writes."""
        path = self.folder / name
        try:
            return read_sealed(path, read_regular(path), ("deck_sha256",))
        except OSError as error:
            if isinstance(error, FileTrouble):
                raise
            raise FileTrouble(f"{path}: cannot be read ({error.strerror or error})") from error

    def read(self, number: int) -> tuple[dict, list]:
        """(payload, pieces) of one checkpoint, or `FileTrouble` if anything about it does not agree."""
        manifest, path = self.check(number)
        return decode(path), [tuple(piece) for piece in manifest["pieces"]]

    def check(self, number: int) -> tuple[dict, pathlib.Path]:
        """Manifest and file of one checkpoint whose bytes are those that were written, or `FileTrouble`."""
        path = self.folder / f"{number:06d}.h5"
        manifest = self.manifest(f"{number:06d}.json")
        try:
            length, wanted = manifest["bytes"], manifest["sha256"]
            found = digest(path)
        except (OSError, KeyError) as error:
            raise FileTrouble(f"{path}: the checkpoint or its manifest cannot be read ({error})") from error
        if found.bytes != length:
            raise FileTrouble(f"{path}: cut off ({found.bytes} of {length} bytes)")
        if found.sha256 != wanted:
            raise FileTrouble(f"{path}: changed since it was written (its SHA-256 does not agree with the manifest)")
        return manifest, path

    def deck(self) -> str | None:
        """The deck this run was started with, from the first sound document that holds it; None if none does."""
        for name in (START, *(f"{number:06d}.json" for number in reversed(self.numbers()))):
            with contextlib.suppress(FileTrouble):
                document = self.manifest(name)
                if isinstance(document.get("deck"), str) and _sha256(document["deck"]) == document.get("deck_sha256"):
                    return document["deck"]
        return None

    def forget_after(self, number: int) -> None:
        """Drop the checkpoints newer than `number`, which proved unusable."""
        for newer in self.numbers():
            if newer > number:
                self._drop(newer)

    def forget_all(self) -> None:
        """Drop every checkpoint, so that the run starts again; the deck stays."""
        remove_files(self.folder, lambda name: _OURS.fullmatch(name) and name != START)

    def remove(self) -> None:
        """Remove all checkpoints, once the run is finished."""
        remove_files(self.folder, _OURS.fullmatch)
        remove_folder(self.folder)


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
