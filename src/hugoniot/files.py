"""Files that come from outside: only regular ones are read, and never more of them than a limit.

A device (`/dev/zero`) has no end, a pipe may never answer: neither is waited for.
"""

import os
import stat

from hugoniot.errors import FileTrouble

LARGEST = 256_000_000   # bytes; more than any deck, material file or table of measured data has
_WITHOUT_WAITING = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


def open_regular(path, flags: int = _WITHOUT_WAITING) -> int:
    """Handle of a regular file, opened without waiting.

    `FileTrouble` for a device, a pipe or a folder; `OSError` as the system raises it.
    """
    handle = os.open(path, flags)
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise FileTrouble(f"{path}: not a regular file but {_kind(path)}; nothing is read from it")
    return handle


def read_regular(path, limit: int = LARGEST) -> bytes:
    """The bytes of a regular file of at most `limit` bytes.

    `FileTrouble` for any other kind or a larger one; `OSError` as the system raises it.
    """
    with os.fdopen(open_regular(path), "rb") as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise FileTrouble(f"{path}: more than {limit / 1e6:g} MB; was another file meant?")
    return data


def read_text(path, limit: int = LARGEST) -> str:
    """The text (UTF-8, with or without a byte order mark) of a regular file; `UnicodeDecodeError` where it is none."""
    return read_regular(path, limit).decode("utf-8-sig")


def _kind(path) -> str:
    mode = os.stat(path).st_mode
    for test, name in ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device")):
        if test(mode):
            return name
    return "something else"
