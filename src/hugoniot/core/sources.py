"""The source files on which a kernel depends: its own, and those that it or the laws in its arguments import.

Machine code is stored under a hash of these files, so that an edit affects every kernel that may depend on it and no other. Imports are
read from the text: `import` statements anywhere in a file, also inside functions, and names of modules of the package in quotes. A file is
read once in a process; what is written later is not what the process runs, so code that depends on it is neither looked for nor kept.
"""

import functools
import hashlib
import os
import pathlib
import re
import sys
import sysconfig
import time
from collections.abc import Iterable
from typing import NamedTuple

PACKAGE = __name__.partition(".")[0]
ROOT = pathlib.Path(__file__).resolve().parents[1]
COMPUTING_ROOMS = ("core", "laws", "mesh", "theory", "zones", "solvers")


def _begun() -> float:
    """When this process began, as the clock of files shows it; where the system does not say, now, which is a little later."""
    try:
        ticks = int(pathlib.Path("/proc/self/stat").read_text().rpartition(")")[2].split()[19])
        return time.time() - time.clock_gettime(time.CLOCK_BOOTTIME) + (ticks + 1) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError, IndexError, AttributeError):
        return time.time()


_BEGUN = _begun()
_unchanged: dict[str, float] = {}     # when a file was last seen to be as old
_NOT_OURS = tuple(os.path.realpath(sysconfig.get_path(name)) + os.sep for name in ("stdlib", "platstdlib", "purelib", "platlib"))
_QUOTED = re.compile(rf"""["']({PACKAGE}(?:\.\w+)+)\.?["']""")
_BOUND = re.compile(rb"\bbind(?:_choice|_flag|_dispatch)?\(\s*(\w+)")
_IMPORT = re.compile(r"[ \t]*(?:from[ \t]+([.\w]+)[ \t]+import[ \t]+(\([^)]*\)|[^\n#]+)|import[ \t]+([^\n#]+))")


class Source(NamedTuple):
    """One file: hash of its bytes, and whether it says how kernels call functions that stand in other files."""

    digest: bytes
    binds: bool


class Imports(NamedTuple):
    """What the import statements of a file may name, and the names of the package's modules in quotes."""

    names: tuple[str, ...]
    quoted: tuple[str, ...]


@functools.cache
def _read(path: str) -> Source:
    with open(path, "rb") as file:
        data = file.read()
    bound = _BOUND.findall(data) if b"binder" in data or b"bind_flag" in data else ()
    return Source(hashlib.sha256(data).digest(), any(b"def " + name + b"(" not in data for name in bound))


@functools.cache
def _imports(path: str) -> Imports:
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read().replace("\\\n", " ")
    names: list[str] = []
    begins = {text.rfind("\n", 0, word.start()) + 1 for word in re.finditer("import", text)}    # of lines; searching each is 5 times slower
    for where, what, plain in (match.groups("") for begin in sorted(begins) if (match := _IMPORT.match(text, begin))):
        words = [part.split()[0] for part in re.sub(r"#[^\n]*", "", what or plain).strip("() \t\n").split(",") if part.split()]
        names += words if plain else [where, *(f"{where}{'' if where.endswith('.') else '.'}{word}" for word in words)]
    return Imports(tuple(names), tuple(_QUOTED.findall(text)) if PACKAGE in text else ())


def behind(modules: Iterable[str]) -> frozenset[str]:
    """Paths of the files of these modules, of all that they import, and of those that bind functions of other files to kernels.

    The last decide what a kernel calls without being imported by it. Installed packages and the standard library do not count, except
    this one. A package in quotes counts with every file of its folder.
    """
    return frozenset().union(_binding(), *map(_imported_by, modules))


@functools.cache
def _imported_by(module: str) -> frozenset[str]:
    waiting, found = [module], set()
    while waiting:
        name = waiting.pop()
        path = file_of(name)
        if path is None or path in found:
            continue
        found.add(path)
        package = name if path.endswith("__init__.py") else name.rpartition(".")[0]
        imports = _imports(path)
        waiting += [_absolute(imported, package) for imported in imports.names]
        waiting += [*imports.quoted, *_inside(imports.quoted)]
    return frozenset(found)


def concerns_package(module: str) -> bool:
    """Whether a module is of this package or imports from it."""
    if module.partition(".")[0] == PACKAGE:
        return True
    path = file_of(module)
    return path is not None and any(name.partition(".")[0] == PACKAGE for name in _imports(path).names)


@functools.cache
def digest(paths: frozenset[str]) -> str:
    """One hash of files as this process first found them."""
    total = hashlib.sha256()
    for path in sorted(paths):
        total.update(_read(path).digest)
    return total.hexdigest()


def changed_since_start(paths: Iterable[str]) -> bool:
    """Whether a file was written after this process began, so that what the process imported may differ from what stands there now.

    No file is looked at twice in a second. A time in the future, as unpacked archives have it, is no time of a change.
    """
    now, latest = time.monotonic(), time.time() + 2.0
    for path in paths:
        if now - _unchanged.get(path, -1.0) > 1.0:
            if _BEGUN <= os.stat(path).st_mtime <= latest:
                return True
            _unchanged[path] = now
    return False


@functools.cache
def source_hash() -> str:
    """SHA-256 of every source behind the kernels of the package, shortened: what a checkpoint keeps of the program that wrote it."""
    import numba

    total = hashlib.sha256(f"{sys.version_info[:2]} {numba.__version__}".encode())
    for path in _computing():
        total.update(_read(path).digest)
    return total.hexdigest()[:16]


def file_of(name: str) -> str | None:
    """Path of a module's file if it is of this package, or of a user's own that has been imported."""
    if name == PACKAGE or name.startswith(f"{PACKAGE}."):
        return _file_in_package(name)
    path = getattr(sys.modules.get(name), "__file__", None)
    return _users_file(path) if path and path.endswith(".py") else None


def is_known(name: str) -> bool:
    """Whether a module's text is known: in the package, in a file, or as part of what is installed."""
    module = sys.modules.get(name)
    path = getattr(module, "__file__", None)
    return file_of(name) is not None or (name in sys.builtin_module_names if path is None else os.path.realpath(path).startswith(_NOT_OURS))


@functools.cache
def _users_file(path: str) -> str | None:
    path = os.path.realpath(path)
    return None if path.startswith(_NOT_OURS) else path


@functools.cache
def _file_in_package(name: str) -> str | None:
    folder, own = os.path.join(str(ROOT), *name.split(".")[1:-1]), name.rpartition(".")[2]
    if name == PACKAGE or own not in _entries(folder):
        return os.path.join(folder, f"{own}.py") if f"{own}.py" in _entries(folder) else None
    return os.path.join(folder, own, "__init__.py") if "__init__.py" in _entries(os.path.join(folder, own)) else None


@functools.cache
def _entries(folder: str) -> frozenset[str]:
    return frozenset(os.listdir(folder)) if os.path.isdir(folder) else frozenset()


def _absolute(name: str, package: str) -> str:
    """A module's name, relative ones counted from their package."""
    dots = len(name) - len(name.lstrip("."))
    return name if not dots else ".".join([*package.split(".")[:len(package.split(".")) - dots + 1], name[dots:]])


def _inside(packages: Iterable[str]) -> list[str]:
    """Names of the modules in the folders of packages."""
    return [f"{name}.{file[:-3]}" for name in packages if (path := file_of(name)) and path.endswith("__init__.py")
            for file in sorted(_entries(os.path.dirname(path))) if file.endswith(".py") and file != "__init__.py"]


@functools.cache
def _computing() -> list[str]:
    """Every file of the rooms that compute."""
    return [str(path) for room in COMPUTING_ROOMS for path in sorted((ROOT / room).rglob("*.py"))]


@functools.cache
def _binding() -> frozenset[str]:
    return frozenset(path for path in _computing() if _read(path).binds)
