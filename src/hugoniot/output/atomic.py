"""Writing a file so that it is there whole or not at all, and saying in one sentence why it could not be written.

A file is written under a temporary name in the same folder, flushed to the disk, read back, renamed, and the folder is
flushed too: a kill or a power cut at any moment leaves the old file or the new one, never a torn one.
"""

import contextlib
import errno
import os
import pathlib

from hugoniot.errors import FileTrouble

_FULL = {errno.ENOSPC, errno.EDQUOT}
_FORBIDDEN = {errno.EACCES, errno.EPERM, errno.EROFS}


def trouble(path, error: OSError, kept: str = "nothing that was there before is lost") -> FileTrouble:
    """The `FileTrouble` that tells a user what the operating system refused at `path`, and the way out."""
    if isinstance(error, FileTrouble):
        return error
    if error.errno in _FULL:
        return FileTrouble(f"{path}: the disk is full; {kept}. Make room, then continue with `hugoniot resume`")
    if error.errno == errno.EFBIG:
        return FileTrouble(f"{path}: the file would exceed the size limit set for this process (ulimit -f); {kept}")
    if error.errno in _FORBIDDEN:
        return FileTrouble(f"{path}: no permission to write here; choose another folder with --out, or change its permissions")
    if error.errno in (errno.ENOTDIR, errno.EEXIST):
        return FileTrouble(f"{path}: a file of that name is in the way; choose another folder with --out")
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


def _write_all(path: pathlib.Path, data: bytes, durable: bool) -> None:
    with open(path, "wb", buffering=0) as file:
        view = memoryview(data)
        while view:
            view = view[file.write(view):]
        if durable:
            os.fsync(file.fileno())


def write_whole(path, data: bytes | str, durable: bool = True) -> None:
    """Put `data` at `path`, whole or not at all.

    durable   read back, and flush file and folder to the disk before returning; False trusts the operating system
              (survives a kill of the program, not a power cut)

    Raises `FileTrouble`; an older file at `path` then stands as it was and the temporary file is gone.
    """
    path = pathlib.Path(path)
    data = data.encode() if isinstance(data, str) else data
    temporary = path.with_name(f".{path.name}.part")
    try:
        _write_all(temporary, data, durable)
        if durable and temporary.read_bytes() != data:
            raise FileTrouble(f"{path}: what was written could not be read back unchanged; the disk may be failing")
        os.replace(temporary, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise trouble(path, error) from error
    if durable:
        sync_folder(path.parent)
