"""The answers of a sweep as they come: one line each, with a checksum, added to the end of one file by one process.

A kill at any moment leaves whole lines and at most one torn one, the last, which is dropped; a line that was changed later is passed over,
and its case asked again. What stands here is never asked again: the key of a line is that of the resolved deck and of the program that
ran it (`questions.address`).
"""

import contextlib
import json
import os
import pathlib
import time
import zlib
from collections.abc import Iterator

from hugoniot.errors import FileTrouble
from hugoniot.files import open_regular
from hugoniot.output.atomic import append, explained

HEAD = '{"format": "hugoniot-sweep-1"}\n'
FLUSH_SECONDS = 2.0      # between requests to put lines on the disk: a power cut loses no more


def kept_answers(path) -> Iterator[dict]:
    """The sound answers in the file of a sweep, in the order in which they came. Reads only; raises `FileTrouble`."""
    with explained(pathlib.Path(path)), os.fdopen(open_regular(path), "rb") as file:
        if file.readline() != HEAD.encode():
            return
        for line in file:
            found = _opened(line)
            if found is not None:
                yield found


def is_journal(path) -> bool:
    """Whether a file is the answers of a sweep, or the beginning of one that a kill has torn."""
    try:
        with os.fdopen(open_regular(path), "rb") as file:
            head = file.readline(len(HEAD))
    except OSError:
        return False
    return HEAD.encode().startswith(head)


class Journal:
    """The answers in a file. `places` maps the key of an answer to where its line begins.

    Raises `FileTrouble` where the file is none of ours, or cannot be written.
    """

    def __init__(self, path):
        self.path, self.places = pathlib.Path(path), {}
        self._handle, self._flushed = -1, time.monotonic()
        if not self.path.exists():
            append(self.path, HEAD)
        with explained(self.path):
            self._handle = open_regular(self.path, os.O_RDWR | os.O_APPEND | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NOFOLLOW", 0))
            end = self._read()
            os.ftruncate(self._handle, end)

    def _read(self) -> int:
        """Note where the answers are; the length of what is whole lines."""
        with open(os.dup(self._handle), "rb") as file:
            file.seek(0)
            head = file.readline()
            if HEAD.encode().startswith(head) and head != HEAD.encode():      # a kill has torn the very first write
                os.ftruncate(self._handle, 0)
                append(self.path, HEAD)
                return len(HEAD)
            if head != HEAD.encode():
                raise FileTrouble(f"{self.path}: this file was not written by a sweep; choose another folder with --out")
            at = file.tell()
            for line in file:
                if not line.endswith(b"\n"):
                    break       # torn by a kill: nothing comes after it
                found = _opened(line)
                if found is not None:
                    self.places[found["key"]] = at
                at += len(line)
        return at

    def add(self, answer: dict) -> None:
        """Keep an answer that has a key."""
        text = json.dumps(answer)
        data = f"{zlib.crc32(text.encode()):08x} {text}\n".encode()
        with explained(self.path, "the cases that have run are kept"):
            place = os.fstat(self._handle).st_size
            while data:
                data = data[os.write(self._handle, data):]
            if time.monotonic() - self._flushed > FLUSH_SECONDS:
                os.fsync(self._handle)
                self._flushed = time.monotonic()
        self.places[answer["key"]] = place

    def answers(self, keys: list[str]) -> Iterator[dict]:
        """The answers of some keys, one at a time."""
        with explained(self.path), open(self.path, "rb") as file:
            for key in keys:
                file.seek(self.places[key])
                found = _opened(file.readline())
                if found is None:
                    raise FileTrouble(f"{self.path}: the file was changed while the sweep was running")
                yield found

    def close(self) -> None:
        """Put everything on the disk and let the file go."""
        handle, self._handle = self._handle, -1
        if handle >= 0:
            with contextlib.suppress(OSError):
                os.fsync(handle)
            os.close(handle)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def _opened(line: bytes) -> dict | None:
    """The answer in a line; None for a torn or changed one."""
    try:
        check, text = line[:8].decode(), line[9:].rstrip(b"\n")
        if not line.endswith(b"\n") or int(check, 16) != zlib.crc32(text):
            return None
        found = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) and isinstance(found.get("key"), str) else None
