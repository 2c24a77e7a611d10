"""The time spent compiling, messages about it, and what a process may omit. Importing this module imports numba.

The time of a kernel runs from the moment its code is not found in the folder of compiled code until the compiler is free again, and
includes what is compiled into it.
"""

import contextlib
import threading
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

from numba.core import event


class Compiling(NamedTuple):
    """A kernel that is about to be compiled: its name, which one it is of this process, and how many come after it (None: unknown)."""

    kernel: str
    number: int
    left: int | None


class _Spell(NamedTuple):
    began: float
    seconds: float


_spells: list[_Spell] = []
_listeners: list[Callable[[Compiling], None]] = []
_expected = 0               # kernels still to be compiled, this one included, as far as anybody said
_here = threading.local()   # depth: how often this thread holds the compiler; began: when it began to compile


def expect(kernels: int) -> None:
    """Say how many kernels are about to be compiled, so that whoever watches can show how many are left."""
    global _expected
    _expected = kernels


def not_found(kernel: str) -> None:
    """To be called while numba's lock is held, when the code of a kernel is not kept and will now be compiled."""
    if getattr(_here, "began", None) is None and getattr(_here, "depth", 0) > 0:
        _here.began = time.perf_counter()
        news = Compiling(kernel, len(_spells) + 1, _expected - 1 if _expected else None)
        for tell in list(_listeners):
            tell(news)


def silence() -> None:
    """Tell nobody of this process any more."""
    _listeners.clear()


def compile_seconds(since: float = 0.0) -> float:
    """Wall time spent compiling kernels in this process, s, of those begun after `since` (by `time.perf_counter`)."""
    return sum(spell.seconds for spell in list(_spells) if spell.began >= since)


@contextlib.contextmanager
def when_compiling(tell: Callable[[Compiling], None]) -> Iterator[None]:
    """A context in which `tell` is called whenever a kernel has to be compiled because it is not in the folder of compiled code."""
    _listeners.append(tell)
    try:
        yield
    finally:
        _listeners.remove(tell)


class _Lock(event.Listener):
    """Follows the compiler's lock: what was begun while it was held has ended when it is given back."""

    def on_start(self, event):
        _here.depth = getattr(_here, "depth", 0) + 1

    def on_end(self, event):
        global _expected
        _here.depth = getattr(_here, "depth", 1) - 1
        began = getattr(_here, "began", None)
        if _here.depth == 0 and began is not None:
            _spells.append(_Spell(began, time.perf_counter() - began))
            _here.began = None
            _expected = max(_expected - 1, 0)


event.register("numba:compiler_lock", _Lock())


def without_linear_algebra() -> None:
    """Keep numba from reading scipy's, which takes a tenth of a second and which no kernel of ours asks for.

    For processes that are the program's own: a user's kernels may want it.
    """
    from numba.np import linalg

    def refused():
        raise ImportError("hugoniot's own processes do without linear algebra in kernels")

    linalg.ensure_blas = refused
