"""HDF5 files, written so that they are there whole or not at all: small ones made in memory, large ones straight on the disk.

Both come from the same function and hold the same; which way a file goes is decided by the size of its contents alone, so that the
same contents always give the same bytes. Files have the layout of HDF5 1.10, which keeps checksums of its own structure; `sound_layout`
adds one for the numbers.
"""

import io
import os
from collections.abc import Callable

from hugoniot.errors import FileTrouble
from hugoniot.output import atomic
from hugoniot.output.atomic import Written, create, digest, in_place_of, write_whole

IN_MEMORY = 48_000_000      # bytes of contents up to which a file is made in memory
CHUNK_BYTES = 1 << 20
_LAYOUT = ("v110", "v110")


def h5py():
    """The h5py module, imported when the first file is written or read."""
    import h5py

    return h5py


def new_image(name: str = "memory"):
    """An HDF5 file in memory, open for writing; `image_bytes` gives its bytes."""
    return h5py().File(name, "w", driver="core", backing_store=False, block_size=1 << 20, libver=_LAYOUT)


def image_bytes(file) -> bytes:
    """The bytes the in-memory file would have on disk."""
    file.flush()
    return file.id.get_file_image()


def sound_layout(shape: tuple[int, ...], itemsize: int) -> dict:
    """How h5py lays out a dataset of numbers so that each chunk of about a megabyte has a checksum (Fletcher32)."""
    if not shape or 0 in shape:
        return {}
    left, chunk = max(1, CHUNK_BYTES // itemsize), []
    for extent in reversed(shape):
        chunk.insert(0, max(1, min(extent, left)))
        left //= max(1, extent)
    return {"chunks": tuple(chunk), "fletcher32": True}


class _Sink(io.RawIOBase):
    """The file HDF5 writes to. What the system refuses is remembered and not passed on: HDF5 does not survive it at the closing."""

    def __init__(self, handle: int):
        self.handle, self.at = handle, 0
        self.error: OSError | None = None

    def readable(self):
        return True

    def writable(self):
        return True

    def seekable(self):
        return True

    def seek(self, offset, whence=0):
        start = (0, self.at, os.fstat(self.handle).st_size)[whence]
        self.at = start + offset
        return self.at

    def tell(self):
        return self.at

    def truncate(self, size=None):
        size = self.at if size is None else size
        self._trying(os.ftruncate, self.handle, size)
        return size

    def readinto(self, buffer):
        data = os.pread(self.handle, len(buffer), self.at)
        buffer[:len(data)] = data
        self.at += len(data)
        return len(data)

    def write(self, data):
        view = memoryview(data).cast("B")
        length = len(view)
        self._trying(self._put_all, view)
        self.at += length
        return length

    def _put_all(self, view):
        os.lseek(self.handle, self.at, os.SEEK_SET)
        while view:
            view = view[atomic.put(self.handle, view):]

    def _trying(self, call, *arguments):
        if self.error is None:
            try:
                call(*arguments)
            except OSError as error:
                self.error = error

    def check(self):
        """Raise what the system refused, if anything."""
        if self.error is not None:
            raise self.error


def write_hdf5(path, fill: Callable, size: int, durable: bool = True) -> Written:
    """Write an HDF5 file to `path`, whole or not at all, flushed to the disk and read back if `durable`.

    fill   fill(file, check) puts the contents into the open file; check() raises what the disk has refused so far
    size   how many bytes the contents have

    Raises `FileTrouble`; an older file at `path` then stands as it was.
    """
    if size <= IN_MEMORY:
        with new_image() as file:
            fill(file, lambda: None)
            data = image_bytes(file)
        return write_whole(path, data, durable)
    with in_place_of(path, durable) as temporary:
        _stream(temporary, fill)
        if durable:
            _read_back(temporary, path)
        return digest(temporary)


def _stream(temporary, fill: Callable) -> None:
    sink = _Sink(create(temporary))
    try:
        try:
            with h5py().File(sink, "w", libver=_LAYOUT) as file:
                fill(file, sink.check)
        finally:
            sink.check()
        os.fsync(sink.handle)
    finally:
        os.close(sink.handle)


def _read_back(temporary, path) -> None:
    """Read every number of a file through its checksums."""
    try:
        with h5py().File(temporary, "r") as file:
            file.visititems(lambda name, item: _read_through(item))
    except (OSError, RuntimeError) as error:
        raise FileTrouble(f"{path}: what was written could not be read back unchanged; the disk may be failing ({error})") from error


def _read_through(dataset) -> None:
    if hasattr(dataset, "iter_chunks") and dataset.chunks:
        for chunk in dataset.iter_chunks():
            dataset[chunk]
    elif hasattr(dataset, "dtype"):
        dataset[()]
