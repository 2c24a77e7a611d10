"""Writing a file so that it is there whole or not at all, and saying in one sentence why it could not be written.

A file is written under a temporary name in the same folder, flushed to the disk, read back, renamed, and the folder is
flushed too: a kill or a power cut at any moment leaves the old file or the new one, never a torn one. The temporary file is
always a new one: a link that stands under its name is removed, never followed.
"""

import contextlib
import errno
import hashlib
import os
import pathlib
from collections.abc import Callable, Iterable
from typing import NamedTuple

from hugoniot.errors import FileTrouble
from hugoniot.files import open_regular

_FULL = {errno.ENOSPC, errno.EDQUOT}
_FORBIDDEN = {errno.EACCES, errno.EPERM, errno.EROFS}
_PLAIN = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
_PIECE = 1 << 20    # bytes of a file read at a time


class Written(NamedTuple):
    """Length and SHA-256 of a file that was written."""

    bytes: int
    sha256: str


def trouble(path, error: OSError, kept: str = "nothing that was there before is lost") -> FileTrouble:
    """The `FileTrouble` that tells a user what the operating system refused at `path`, and the way out."""
    if isinstance(error, FileTrouble):
        return error
    if error.errno in _FULL:
        return FileTrouble(f"{path}: the disk is full; {kept}. Free some space, then continue with `hugoniot resume`")
    if error.errno == errno.EFBIG:
        return FileTrouble(f"{path}: the file would exceed the size limit set for this process (ulimit -f); {kept}")
    if error.errno in _FORBIDDEN:
        return FileTrouble(f"{path}: no permission to write here; choose another folder with --out, or change its permissions")
    if error.errno == errno.ELOOP:
        return FileTrouble(f"{path}: this is a link, and a run does not write through links; remove it or choose another folder with --out")
    if error.errno in (errno.ENOTDIR, errno.EEXIST, errno.EISDIR):
        return FileTrouble(f"{path}: a file or folder of that name is in the way; choose another folder with --out")
    return FileTrouble(f"{path}: {error.strerror or error}; {kept}")


@contextlib.contextmanager
def explained(path, kept: str = "nothing that was there before is lost"):
    """Turn an `OSError` of the block into a `FileTrouble` about `path`."""
    try:
        yield
    except OSError as error:
        raise trouble(path, error, kept) from error


@contextlib.contextmanager
def legible(path, lost: str = ""):
    """Turn an `OSError` while `path` is read into a `FileTrouble`; `lost` says what cannot be done without it."""
    try:
        yield
    except FileTrouble:
        raise
    except OSError as error:
        why = "no permission to read it" if error.errno in _FORBIDDEN else error.strerror or str(error)
        raise FileTrouble(f"{path}: {why}" + (f"; {lost}" if lost else "")) from error


def sync_folder(folder) -> None:
    """Flush a folder's list of names to the disk, where the system can."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def create(path) -> int:
    """Handle of a new, empty file, open for reading and writing; what stood there under that name, a link too, is removed first."""
    with contextlib.suppress(FileNotFoundError):
        os.unlink(path)
    return os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | _PLAIN, 0o666)


def put(handle: int, data) -> int:
    """Hand bytes to the operating system, which may take fewer: the one door through which files of a run reach the disk."""
    return os.write(handle, data)


def append(path, text: str) -> None:
    """Add text to the end of a regular file, made if it is not there; never through a link. Raises `FileTrouble`."""
    with explained(path):
        handle = open_regular(path, os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NONBLOCK", 0) | _PLAIN)
        try:
            _put_all(handle, text.encode())
        finally:
            os.close(handle)


def _put_all(handle: int, data: bytes) -> None:
    view = memoryview(data)
    while view:
        view = view[put(handle, view):]


def digest(path, look: Callable[[bytes], None] | None = None) -> Written:
    """Length and SHA-256 of a file as it stands on the disk, read in pieces, which `look` is shown; `OSError` as the system raises it."""
    with os.fdopen(open_regular(path), "rb") as file:
        hashed = hashlib.sha256()
        while piece := file.read(_PIECE):
            hashed.update(piece)
            if look is not None:
                look(piece)
        return Written(file.tell(), hashed.hexdigest())


def _write_parts(path: pathlib.Path, parts: Iterable[bytes], durable: bool) -> Written:
    handle, length, hashed = create(path), 0, hashlib.sha256()
    try:
        for data in parts:
            _put_all(handle, data)
            hashed.update(data)
            length += len(data)
        if durable:
            os.fsync(handle)
    finally:
        os.close(handle)
    return Written(length, hashed.hexdigest())


@contextlib.contextmanager
def in_place_of(path, durable: bool = True):
    """The temporary path to write to; when the block ends it takes the place of `path`, if it fails it is gone. Raises `FileTrouble`."""
    path = pathlib.Path(path)
    temporary = path.with_name(f".{path.name}.part")
    try:
        yield temporary
        os.replace(temporary, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise trouble(path, error) from error
    if durable:
        sync_folder(path.parent)


def write_parts(path, parts: Iterable[bytes], durable: bool = True) -> Written:
    """Put bytes that come in parts at `path`, whole or not at all, without holding them all in memory.

    durable   read back, and flush file and folder to the disk before returning; False trusts the operating system
              (survives a kill of the program, not a power cut)

    Raises `FileTrouble`; an older file at `path` then stands as it was and the temporary file is gone.
    """
    with in_place_of(path, durable) as temporary:
        written = _write_parts(temporary, parts, durable)
        if durable and digest(temporary) != written:
            raise FileTrouble(f"{path}: what was written could not be read back unchanged; the disk may be failing")
    return written


def write_whole(path, data: bytes | str, durable: bool = True) -> Written:
    """Put `data` at `path`, whole or not at all, as `write_parts` does."""
    return write_parts(path, (data.encode() if isinstance(data, str) else data,), durable)
