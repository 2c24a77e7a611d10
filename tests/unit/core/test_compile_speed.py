"""Functions inside kernels are optimised with them, and what that leaves out is made up for where it is needed."""

import gc

import numba as nb
import pytest
from numba.core import event

from hugoniot.core import code_files
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.errors import OutOfRange


def kernels():
    """A function, one that calls it, and a kernel that calls both, all yet to be compiled."""
    @nb.njit(**BY_ADDRESS)
    def root(x):
        if x < 0.0:
            raise OutOfRange("negative")
        return x ** 0.5

    @nb.njit(**BY_ADDRESS)
    def length(x, y):
        return root(x * x + y * y)

    @nb.njit(**GUARD)
    def kernel(x, y):
        return length(x, y) + root(x)

    return root, length, kernel


def library_of(function):
    return next(iter(function.overloads.values())).library


@pytest.fixture(autouse=True)
def nothing_kept(monkeypatch):
    monkeypatch.setattr(code_files, "cache_folder", lambda: None)


def test_functions_inside_a_kernel_are_finished_only_when_their_address_is_asked_for():
    root, length, kernel = kernels()
    assert kernel(9.0, 12.0) == 18.0
    assert library_of(kernel)._finalized and not library_of(root)._finalized and not library_of(length)._finalized
    result = next(iter(length.overloads.values()))
    assert result.library.get_pointer_to_function(result.fndesc.llvm_func_name) != 0
    assert result.library._finalized
    assert kernel(9.0, 12.0) == 18.0


def test_errors_of_functions_inside_a_kernel_arrive():
    *_, kernel = kernels()
    with pytest.raises(OutOfRange, match="negative"):
        kernel(-1.0, 0.0)


def test_nothing_is_searched_for_unreachable_objects_while_a_kernel_is_compiled():
    states = []

    class Watch(event.Listener):
        def on_start(self, event):
            states.append(gc.isenabled())

        def on_end(self, event):
            pass

    @nb.njit(**GUARD)
    def wrong(x):
        return x.nothing

    assert gc.isenabled()
    with event.install_listener("numba:compile", Watch()):
        kernels()[-1](3.0, 4.0)
        with pytest.raises(nb.TypingError):
            wrong(1.0)
    assert len(states) == 4 and not any(states) and gc.isenabled()
