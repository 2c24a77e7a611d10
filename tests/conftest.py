"""What every test may rely on, wherever the tests were started from; and how little memory and compiling they take together."""

import contextlib
import gc
import os
import signal
import sys
import tempfile
import threading

import pytest
from hypothesis import HealthCheck, settings

try:
    import fcntl
    import resource
except ImportError:     # no Unix
    fcntl = resource = None


# hypothesis fails a test whose examples take more than 0.2 s, or are drawn slowly: on a busy machine any may
settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")


@pytest.fixture(scope="session", autouse=True)
def _interrupts_are_heard():
    """A shell starts what it runs in the background with SIGINT ignored, and its children inherit that: Ctrl-C could not be tested."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_runtest_teardown(item, nextitem):
    """Figures that a test has drawn and not closed would stay in memory to the end."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None and pyplot.get_fignums():
        pyplot.close("all")


# -- what the tests need -------------------------------------------------------------------------------------------------
_workers: list[tuple[int, float]] = []


def _used() -> tuple[int, float]:
    """(peak memory of this process in MB as Linux counts, processor time of it and its children in s)."""
    own, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_maxrss // 1000, own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def pytest_sessionfinish(session):
    if resource is not None and hasattr(session.config, "workeroutput"):
        session.config.workeroutput["used"] = _used()


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node, error):
    if used := getattr(node, "workeroutput", {}).get("used"):
        _workers.append(used)


def pytest_terminal_summary(terminalreporter):
    if _workers:
        terminalreporter.write_line(f"workers: at most {max(mb for mb, _ in _workers)} MB of memory each, "
                                    f"{sum(spent for _, spent in _workers):.0f} s of processor time together")


# -- compiling once -----------------------------------------------------------------------------------------------------
# A process that compiles keeps some megabytes for every kernel, which numba never gives back, and two workers that begin with an empty
# folder of compiled code would compile the same kernels at once. Here a kernel that is not kept yet is compiled by a fork, which writes it
# to the folder and ends, while whoever wants the same kernel waits; then it is read from there, which costs next to nothing.

OWN = 8         # kernels that a process compiles itself, so that its forks need not begin with what all kernels have in common
_in_fork, _own = False, 0


@contextlib.contextmanager
def _alone(name: str):
    """Whoever wants the kernel of this name too waits until the block ends."""
    folder = os.path.join(tempfile.gettempdir(), f"hugoniot-compiling-{os.getuid()}")
    os.makedirs(folder, mode=0o700, exist_ok=True)
    with open(os.path.join(folder, name), "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _in_a_fork(work) -> None:
    global _in_fork
    child = os.fork()
    if child:
        os.waitpid(child, 0)
        return
    try:
        _in_fork = True
        gc.disable()        # a collection would touch, and so copy, all memory
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 2)    # whatever is wrong is said by the process that compiles it again
        work()
    finally:
        os._exit(0)


def _compiled_once(real, function_of, target_of):
    from numba.core.compiler_lock import global_compiler_lock

    from hugoniot.core import code_files

    def compile(self, *signature):
        global _own
        cache, sig = self._cache, signature[0] if signature else self._sig
        with global_compiler_lock:      # taken first by everybody, so that no two threads wait for each other
            if not isinstance(getattr(cache, "_cache_file", None), code_files.CodeFile) or threading.active_count() > 2:
                return real(self, *signature)
            if signature and tuple(sig if isinstance(sig, tuple) else sig.args) in self.overloads:
                return real(self, *signature)
            path = code_files.path_of(function_of(self), cache._index_key(sig, target_of(self).codegen()))
            if path is None or path.exists():
                return real(self, *signature)
            with _alone(path.name):
                if not path.exists() and not _in_fork:
                    _own += 1
                    if _own > OWN:
                        _in_a_fork(lambda: real(self, *signature))
                return real(self, *signature)

    return compile


def pytest_configure(config):
    if fcntl is None:
        return
    from numba.core.ccallback import CFunc
    from numba.core.dispatcher import Dispatcher

    Dispatcher.compile = _compiled_once(Dispatcher.compile, lambda self: self.py_func, lambda self: self.targetctx)
    CFunc.compile = _compiled_once(CFunc.compile, lambda self: self._pyfunc, lambda self: self._targetdescr.target_context)
