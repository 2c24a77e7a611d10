"""What every test may rely on, wherever the tests were started from; and how little memory and time they take together."""

import gc
import os
import signal
import sys

import pytest
from hypothesis import HealthCheck, settings

import compile_once

try:
    import resource
except ImportError:     # no Unix
    resource = None


# matrices of some dozen rows: other threads of the linear algebra would spend the workers' cores waiting; read when numpy is imported
for _threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_threads, "1")

# hypothesis fails a test whose examples take more than 0.2 s, or are drawn slowly: on a busy machine any may
settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")


@pytest.fixture(scope="session", autouse=True)
def _interrupts_are_heard():
    """A shell starts what it runs in the background with SIGINT ignored, and its children inherit that: Ctrl-C could not be tested."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session", autouse=True)
def _without_waiting_for_the_disk():
    """What a process was given to write is there for the next one, whatever becomes of the process: only a power cut needs flushing."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "fsync", lambda handle: None)
        yield


@pytest.hookimpl(wrapper=True)
def pytest_collection(session):
    """Thousands of tests and all libraries live to the end: looked through for unreachable objects neither now nor while the tests run.

    Their forks need not copy them either, as a search writes to every object it looks at.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


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
    compile_once.end()
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


def pytest_configure(config):
    compile_once.begin()
