"""Checkpoints: the state a run can go on from, bit for bit.

`checkpoint/000012.h5` holds the state and `checkpoint/000012.json` its manifest: length, SHA-256 and the pieces of the record
that belong to it. A checkpoint exists once its manifest does; it is believed only if length and hash agree, before HDF5
opens the file. The newest two are kept, so a damaged one costs the time since the one before.
"""

import contextlib
import hashlib
import json
import pathlib
import re

from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import explained, write_whole
from hugoniot.output.codec import decode, encode

KEEP = 2


class Checkpoints:
    """The checkpoints of one run folder."""

    def __init__(self, folder: pathlib.Path):
        self.folder = pathlib.Path(folder)

    def numbers(self) -> list[int]:
        """Numbers of the checkpoints that have a manifest, oldest first."""
        if not self.folder.is_dir():
            return []
        found = (re.fullmatch(r"(\d{6})\.json", path.name) for path in self.folder.iterdir())
        return sorted(int(match[1]) for match in found if match)

    def write(self, payload: dict, pieces: list, deck_sha256: str) -> None:
        """Write the next checkpoint and drop all but the newest two. Raises `FileTrouble`; the older ones then still stand."""
        with explained(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
        numbers = self.numbers()
        stem = f"{(numbers[-1] + 1 if numbers else 0):06d}"
        data = encode(payload)
        write_whole(self.folder / f"{stem}.h5", data)
        manifest = {"file": f"{stem}.h5", "bytes": len(data), "sha256": hashlib.sha256(data).hexdigest(),
                    "pieces": [list(piece) for piece in pieces], "deck_sha256": deck_sha256}
        write_whole(self.folder / f"{stem}.json", json.dumps(manifest, indent=1))
        for number in numbers[: len(numbers) + 1 - KEEP]:
            self._drop(number)

    def _drop(self, number: int) -> None:
        for suffix in ("json", "h5"):
            with contextlib.suppress(OSError):
                (self.folder / f"{number:06d}.{suffix}").unlink()

    def read(self, number: int) -> tuple[dict, list, str]:
        """(payload, pieces, deck hash) of one checkpoint, or `FileTrouble` if anything about it does not agree."""
        stem = self.folder / f"{number:06d}"
        try:
            manifest = json.loads(stem.with_suffix(".json").read_text())
            data = stem.with_suffix(".h5").read_bytes()
            length, digest, pieces = manifest["bytes"], manifest["sha256"], manifest["pieces"]
            deck = manifest["deck_sha256"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise FileTrouble(f"{stem}.h5: the checkpoint or its manifest cannot be read ({error})") from error
        if len(data) != length:
            raise FileTrouble(f"{stem}.h5: cut off ({len(data)} of {length} bytes)")
        if hashlib.sha256(data).hexdigest() != digest:
            raise FileTrouble(f"{stem}.h5: changed since it was written (its SHA-256 does not agree with the manifest)")
        return decode(data), [tuple(piece) for piece in pieces], deck

    def forget_after(self, number: int) -> None:
        """Drop the checkpoints newer than `number`, which proved unusable."""
        for newer in self.numbers():
            if newer > number:
                self._drop(newer)

    def remove(self) -> None:
        """Remove all checkpoints, once the run is finished."""
        if self.folder.is_dir():
            with explained(self.folder):
                for path in self.folder.iterdir():
                    path.unlink()
                self.folder.rmdir()
