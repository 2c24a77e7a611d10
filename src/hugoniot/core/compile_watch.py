"""What a process is told about compiling, and what it may leave out of it."""

from collections.abc import Callable

from numba.core import event


class _Teller(event.Listener):
    def __init__(self, tell: Callable[[], None]):
        self.tell, self.told = tell, False

    def on_start(self, event):
        if not self.told:
            self.told = True
            self.tell()

    def on_end(self, event):
        """Nothing to tell."""


def when_compiling(tell: Callable[[], None]):
    """A context in which `tell` is called, once, when a kernel has to be compiled because it is not in the folder of compiled code."""
    return event.install_listener("numba:compile", _Teller(tell))


def without_linear_algebra() -> None:
    """Keep numba from reading scipy's, which takes a tenth of a second and which no kernel of ours asks for.

    For processes that are the program's own: a user's kernels may want it.
    """
    from numba.np import linalg

    def refused():
        raise ImportError("hugoniot's own processes do without linear algebra in kernels")

    linalg.ensure_blas = refused
