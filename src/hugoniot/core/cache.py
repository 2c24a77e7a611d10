"""The folder of compiled code.

It is named after a hash of the package's sources: an edit anywhere in the package can never meet stale machine code (numba itself only
watches the file that holds the kernel). Importing this module imports numba and sets its folder.
"""

import hashlib
import os
import pathlib
import sys

import numba as nb
from numba.core import caching


def source_hash() -> str:
    """SHA-256 of every Python source of the package, shortened: the name of the compiled code's folder."""
    root = pathlib.Path(__file__).resolve().parents[1]
    digest = hashlib.sha256(f"{sys.version_info[:2]} {nb.__version__}".encode())
    for room in ("core", "laws", "mesh", "theory", "solvers"):
        for path in sorted((root / room).rglob("*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def cache_root() -> pathlib.Path:
    """Folder of the compiled code: HUGONIOT_CACHE, else the user's cache folder."""
    if named := os.environ.get("HUGONIOT_CACHE"):
        return pathlib.Path(named)
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return pathlib.Path(home) / "hugoniot"


def _use_cache_folder():
    if os.environ.get("NUMBA_CACHE_DIR"):
        return pathlib.Path(os.environ["NUMBA_CACHE_DIR"])
    folder = cache_root() / source_hash()
    nb.core.config.CACHE_DIR = str(folder)
    return folder


CACHE_FOLDER = _use_cache_folder()
_whole_index = caching.IndexDataCacheFile._load_index


def _known_index(self):
    """Index of a kernel's compiled code; empty where it names a law that this process does not have, such as one of a test or a script.

    The index is read whole: one class that cannot be imported would keep every run from its own compiled code.
    """
    try:
        return _whole_index(self)
    except (ImportError, AttributeError):
        return {}


caching.IndexDataCacheFile._load_index = _known_index
