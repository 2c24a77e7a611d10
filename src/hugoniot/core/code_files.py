"""Compiled code on the disk: one file for each kernel and argument types, named after everything its machine code depends on.

There is no index: a name is a hash of the kernel, its argument types, what its code refers to and the sources behind it
(`core.sources`), in a folder named after the machine. After an edit, with another law of the same name or on another machine stale code is
therefore never used, and processes that write at the same time cannot interfere. Every file ends with a hash of its contents and is
compiled anew if the hash does not match. Importing this module imports numba and sets it up.

Code that refers to a class of the script itself (`__main__`) or to a file written after the process began is not kept.
"""

import contextlib
import hashlib
import os
import stat
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FunctionType
from typing import NamedTuple

from numba.core import caching, types

from hugoniot.core import sources
from hugoniot.core.cache import DAY, SUFFIX, cache_folder, cache_root, clear_away, not_kept
from hugoniot.core.compile_watch import not_found

_numbas_own = caching.IndexDataCacheFile
_HASH_BYTES = 32
_saved = False
_warned = False


class Kernel(NamedTuple):
    """Stands where numba keeps the age of a source file."""

    function: Callable


class Locator(caching._CacheLocator):
    """Says to numba that the code of a kernel is kept here; kernels that have nothing to do with this package go elsewhere."""

    def __init__(self, function, path):
        self._py_file, self._function = path, function

    def get_cache_path(self):
        return str(cache_root())

    def ensure_cache_path(self):
        """Left to `CodeFile.save`."""

    def get_source_stamp(self):
        return Kernel(self._function)

    def get_disambiguator(self):
        return str(self._function.__code__.co_firstlineno)

    @classmethod
    def from_function(cls, py_func, py_file):
        return cls(py_func, py_file) if sources.concerns_package(py_func.__module__) else None


class CodeFile(_numbas_own):
    """The files of one kernel."""

    def __init__(self, cache_path, filename_base, source_stamp):
        super().__init__(cache_path, filename_base, source_stamp)
        self.function = source_stamp.function

    def load(self, key):
        """What was compiled for a key; None if nothing is kept, or nothing sound."""
        path = path_of(self.function, key)
        found = None
        if path is not None and _is_sound(path):
            self._cache_path = str(path.parent)
            with contextlib.suppress(OSError, ImportError, AttributeError):
                found = self._load_data(path.name)
        if found is None:
            laws = ", ".join(dict.fromkeys(cls.__name__ for cls in _classes(key[0])))
            not_found(self.function.__name__ + (f" for {laws}" if laws else ""))
        return found

    def save(self, key, data):
        """Keep what was compiled for a key, if it may be kept. A disk that is full or cannot be written to is no reason to end a run."""
        global _saved, _warned
        path = path_of(self.function, key)
        if path is None:
            return
        self._cache_path = str(path.parent)
        try:
            self._save_data(path.name, data)
            if not _saved:
                _saved = True
                clear_away(cache_root())
        except OSError as error:
            if not _warned:
                _warned = True
                not_kept(f"{error.filename or path}: {error.strerror}")

    def flush(self):
        """Remove this kernel's files."""
        folder = cache_folder()
        for path in folder.glob(f"{self.function.__name__}-*{SUFFIX}") if folder else ():
            path.unlink(missing_ok=True)

    def _dump(self, obj):
        data = super()._dump(obj)
        return data + hashlib.sha256(data).digest()      # reading stops before it


def _is_sound(path: Path) -> bool:
    """Whether a file is one's own and holds what was written; says that it was used."""
    try:
        number = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0))
    except OSError:
        return False
    with open(number, "rb") as file:
        state = os.fstat(number)
        data = file.read() if stat.S_ISREG(state.st_mode) else b""
    if len(data) <= _HASH_BYTES or (hasattr(os, "getuid") and state.st_uid != os.getuid()):
        return False
    if hashlib.sha256(memoryview(data)[:-_HASH_BYTES]).digest() != data[-_HASH_BYTES:]:
        return False
    if time.time() - state.st_mtime > DAY:
        with contextlib.suppress(OSError):      # in a folder that is only read
            os.utime(path)
    return True


def kept_at(function, signature: tuple) -> Path | None:
    """File in which the code of a kernel's Python function for these argument types is kept, or will be; None if it cannot be."""
    return path_of(function, (signature, None, ("", "")))


def path_of(function, key) -> Path | None:
    """File for a kernel and a key as in `name_of`; None where its code cannot be kept."""
    folder = cache_folder()
    name = None if folder is None else name_of(function, key)
    return None if folder is None or name is None else folder / f"{name}{SUFFIX}"


# -- names of the files ------------------------------------------------------------------------------------------
def name_of(function, key) -> str | None:
    """Name for a kernel and numba's key (types, machine, hashes of code and enclosed values); None if its code must not be kept."""
    signature, _, (_, enclosed) = key
    classes = list(_classes(signature))
    modules = {function.__module__, *(cls.__module__ for cls in classes)}
    told = f"{signature} {[_full_name(cls) for cls in classes]} {_described(function, modules, enclosed)}"
    paths = sources.behind(modules)
    if " at 0x" in told or any(cls.__module__ == "__main__" for cls in classes) \
            or not all(map(sources.is_known, modules)) or sources.changed_since_start(paths):
        return None
    return f"{function.__name__.strip('<>')}-{hashlib.sha256(f'{told} {sources.digest(paths)}'.encode()).hexdigest()[:40]}"


def _full_name(thing) -> str:
    return f"{thing.__module__}.{thing.__qualname__}"


def _classes(kind) -> Iterator[type]:
    """The classes of named tuples in a signature or type, wherever the type keeps them: in its parts, or as what it refers to."""
    waiting, seen = [kind], set()
    while waiting:
        one = waiting.pop(0)
        if isinstance(one, (tuple, list)):
            waiting += one
        elif isinstance(one, types.Type) and id(one) not in seen:
            seen.add(id(one))
            waiting += vars(one).values()
        elif isinstance(one, type) and hasattr(one, "_fields") and one not in seen:
            seen.add(one)
            yield one


def _described(function, modules: set[str], enclosed: str) -> str:
    """A function's code, and what that names and encloses, as text; the modules of these are added to `modules`.

    Two kernels made by one factory have the same code and may differ in what they enclose, or in the globals they were given.
    """
    def thing(value) -> str:
        value = getattr(value, "py_func", value)
        if isinstance(value, (FunctionType, type)):
            modules.add(value.__module__)
        if isinstance(value, FunctionType):
            within = "" if value.__closure__ is None else _described(value, modules, enclosed)
            return f"{_full_name(value)} {_plain(value.__code__)} {within}"
        if isinstance(value, type):
            return _full_name(value)
        if isinstance(value, (tuple, list)):
            return f"{type(value).__qualname__} {[thing(part) for part in value]}"
        return repr(value) if isinstance(value, (int, float, complex, str, bytes, type(None))) else ""

    cells = [cell.cell_contents for cell in function.__closure__ or ()]
    named = [thing(function.__globals__.get(name)) for name in sorted(function.__code__.co_names)]
    held = [thing(value) or enclosed for value in cells]
    return f"{_full_name(function)} {_plain(function.__code__)} {named} {held}"


def _plain(code) -> str:
    """A code object as text that is the same in every process."""
    constants = [_plain(c) if hasattr(c, "co_code") else repr(c) for c in code.co_consts]
    return f"{code.co_name} {code.co_firstlineno} {code.co_code.hex()} {code.co_names} {constants}"


def _cache_file(cache_path, filename_base, source_stamp):
    kind = CodeFile if isinstance(source_stamp, Kernel) else _numbas_own
    return kind(cache_path=cache_path, filename_base=filename_base, source_stamp=source_stamp)


caching.CacheImpl._locator_classes.insert(0, Locator)
caching.IndexDataCacheFile = _cache_file
