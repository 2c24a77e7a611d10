"""The folder of compiled code: where it is, whether it may be trusted, and what is removed from it.

Compiled code is executed when it is read, so it is read only from a folder that belongs to the user and to which nobody else may write.
A process that finds any other folder does not store its compiled code, and gives one warning.
"""

import contextlib
import functools
import os
import pathlib
import re
import stat
import time
import warnings

from hugoniot.core.machine import machine_name

SUFFIX = ".code"
DAY = 86400.0
UNUSED_DAYS = 60.0
MOST_BYTES = 1_000_000_000
_OF_EARLIER_VERSIONS = re.compile(r"[0-9a-f]{16}")     # folders named after a hash of all sources


class CacheWarning(UserWarning):
    """Compiled code is not kept; every process compiles for itself."""


def cache_root() -> pathlib.Path:
    """Folder of the compiled code of all machines: HUGONIOT_CACHE, else the user's cache folder."""
    if named := os.environ.get("HUGONIOT_CACHE"):
        return pathlib.Path(named)
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return pathlib.Path(home) / "hugoniot"


@functools.cache
def cache_folder() -> pathlib.Path | None:
    """Folder of the code compiled on machines like this one, made if need be; None, after one warning, where it cannot be trusted."""
    root = cache_root()
    folder = root / machine_name()
    try:
        root.mkdir(mode=0o700, parents=True, exist_ok=True)
        if "HUGONIOT_CACHE" not in os.environ and _is_own(root):
            root.chmod(0o700)     # earlier versions made it with the rights of any folder
        folder.mkdir(mode=0o700, exist_ok=True)
        trouble = open_to_others(root) or open_to_others(folder)
    except OSError as error:
        trouble = f"{error.filename or folder}: {error.strerror}"
    if trouble:
        not_kept(f"{trouble}; set HUGONIOT_CACHE to another folder, or make this one private (chmod 700)")
        return None
    return folder


def not_kept(reason: str) -> None:
    """Warn that compiled code is not kept."""
    warnings.warn(f"compiled kernels cannot be kept, so every start recompiles them: {reason}", CacheWarning, stacklevel=2)


def _is_own(folder: pathlib.Path) -> bool:
    state = folder.lstat()
    return stat.S_ISDIR(state.st_mode) and (not hasattr(os, "getuid") or state.st_uid == os.getuid())


def open_to_others(folder: pathlib.Path) -> str | None:
    """Why somebody else could have put code into a folder; None where nobody could. A link of one's own is followed."""
    if not hasattr(os, "getuid"):
        return None
    if folder.lstat().st_uid != os.getuid() or folder.stat().st_uid != os.getuid():
        return f"{folder} belongs to another user"
    if folder.stat().st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        return f"other users may write to {folder}"
    return None


# -- what is cleared away ----------------------------------------------------------------------------------------
def clear_away(root: pathlib.Path, now: float | None = None, most_bytes: int = MOST_BYTES) -> None:
    """Remove compiled code that nothing has used for UNUSED_DAYS, and the longest unused beyond `most_bytes`; at most once a day.

    What was used within the last day stays in any case. A file that another process is about to read is compiled anew by it.
    """
    now = time.time() if now is None else now
    stamp = root / "cleared"
    with contextlib.suppress(OSError):
        if now - stamp.stat().st_mtime < DAY:
            return
    with contextlib.suppress(OSError):
        stamp.touch()
        os.utime(stamp, (now, now))
        files = sorted(_kept_files(root), reverse=True)
        total = 0
        for used, size, path in files:
            total += size
            unused = now - used
            if unused > UNUSED_DAYS * DAY or (total > most_bytes and unused > DAY) or (".tmp." in path.name and unused > DAY):
                with contextlib.suppress(OSError):
                    path.unlink()
        _remove_empty(root)


def _kept_files(root: pathlib.Path):
    """(when last used, size, path) of every file of compiled code beneath a root; no link is followed."""
    for folder, names, files in os.walk(root):
        here = pathlib.Path(folder)
        if here == root:
            names[:] = [name for name in names if _OF_EARLIER_VERSIONS.fullmatch(name) or re.search(r"-[0-9a-f]{12}$", name)]
            continue
        for name in files:
            state = (here / name).lstat()
            if re.search(r"\.(code|nbi|nbc)(\.tmp\.\w+)?$", name) and stat.S_ISREG(state.st_mode):
                yield max(state.st_mtime, state.st_atime), state.st_size, here / name


def _remove_empty(root: pathlib.Path) -> None:
    for folder, _, _ in os.walk(root, topdown=False):
        if pathlib.Path(folder) != root and pathlib.Path(folder) != cache_folder():
            with contextlib.suppress(OSError):
                os.rmdir(folder)      # fails, as it should, where anything is left
