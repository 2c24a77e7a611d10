"""One process at a time works on a run folder.

The lock is the operating system's own (flock), on the file `.lock` of the folder: whoever is killed loses it at once, so there are
no stale locks to clear, and the file that is left says nothing. Whoever ends takes the file away.
"""

import contextlib
import errno
import os
import pathlib
import socket
import stat

from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import trouble

try:
    import fcntl
except ImportError:     # no Unix
    fcntl = None

NAME = ".lock"
_FLAGS = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NONBLOCK", 0)
_MOST = 200     # characters of the holder's name worth showing


class Lock:
    """The right to change a run folder, held until `release` or the end of the process.

    Raises `FileTrouble` if another process, or another run of this one, holds it. `held` is False where the file system knows no
    locks: there the second process is not noticed.
    """

    def __init__(self, folder):
        self.path, self.held = pathlib.Path(folder) / NAME, False
        self.handle: int | None = None
        if fcntl is None:
            return
        while self.handle is None:
            try:
                handle = os.open(self.path, _FLAGS, 0o666)
            except OSError as error:
                if error.errno in (errno.EACCES, errno.EPERM, errno.EROFS):
                    return      # whoever may not write here disturbs nobody, and hears of it with the first file
                raise trouble(self.path, error) from error
            try:
                self._take(handle)
            except OSError:
                os.close(handle)
                raise

    def _take(self, handle: int) -> None:
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            raise FileTrouble(f"{self.path}: not a regular file; remove it or choose another folder with --out")
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise FileTrouble(f"{self.path.parent}: in use by another process ({_holder(handle)}); "
                              f"wait for it to end, or choose another folder with --out") from None
        except OSError:     # a file system without locks
            self.handle = handle
            return
        if not _same_file(handle, self.path):   # its holder has just ended and taken the file away
            os.close(handle)
            return
        with contextlib.suppress(OSError):      # the lock holds without the holder's name, which a full disk does not take
            os.ftruncate(handle, 0)
            os.pwrite(handle, f"process {os.getpid()} on {socket.gethostname()}\n".encode(), 0)
        self.handle, self.held = handle, True

    def release(self) -> None:
        """Give the folder free."""
        handle, self.handle, self.held = self.handle, None, False
        if handle is not None:
            with contextlib.suppress(OSError):
                if _same_file(handle, self.path):
                    self.path.unlink()
            os.close(handle)

    def __del__(self):
        self.release()


def _same_file(handle: int, path) -> bool:
    try:
        return os.path.samestat(os.fstat(handle), os.lstat(path))
    except OSError:
        return False


def _holder(handle: int) -> str:
    text = os.pread(handle, _MOST, 0).decode("utf-8", "replace").strip()
    return "".join(c if c.isprintable() else "?" for c in text) or "it has just begun"
