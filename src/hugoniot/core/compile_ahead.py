"""Compiling what a run will need before it starts, by two processes where that is quicker.

numba compiles one kernel at a time. A process of the program's own may therefore call a helper, a copy of itself that compiles the
same kernels from the other end of the list into the folder of compiled code; what it has finished is read from there.
"""

import contextlib
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from hugoniot.core import compile_watch
from hugoniot.core.code_files import kept_at
from hugoniot.core.kinds import key_of_value, kinds_of

WORTH_HELP = 6          # kernels
PATIENCE = 5.0          # seconds a helper is given to finish the kernel it is at
_may_fork = False
_compiled: set = set()      # (kernel, key of its arguments) of what this process has


class Job(NamedTuple):
    """A kernel: the file its code is kept in (None: nowhere), and what compiles it, or reads it from there."""

    file: Path | None
    compile: Callable[[], object]
    done: bool = False      # compiled in this process

    def is_kept(self) -> bool:
        """Whether it need not be compiled."""
        return self.done or self.file is not None and self.file.exists()


DONE = Job(None, lambda: None, True)


def job_of(kernel, arguments: tuple) -> Job:
    """The job for a kernel and arguments like these."""
    key = kernel, key_of_value(arguments)
    if key in _compiled:
        return DONE
    job = job_of_types(kernel, kinds_of(arguments))
    if job.done:
        _compiled.add(key)
    return job


def job_of_types(kernel, kinds: tuple) -> Job:
    """The job for a kernel and argument types."""
    if kinds in kernel.overloads:
        return DONE
    return Job(kept_at(kernel.py_func, kinds), lambda: kernel.compile(kinds))


def allow_helper() -> None:
    """Let this process call a helper: for processes that are the program's own and have no threads yet."""
    global _may_fork
    _may_fork = sys.platform == "linux"


def compile_all(jobs: Sequence[Job]) -> None:
    """Compile what is not kept yet, the longest first; whoever watches is told how many are left."""
    waiting = [job for job in jobs if not job.is_kept()]
    helper = _helper(waiting) if _may_fork and len(waiting) >= WORTH_HELP and _cores() > 1 else None
    try:
        for k, job in enumerate(waiting):
            compile_watch.expect(1 + sum(not other.is_kept() for other in waiting[k + 1:]))
            job.compile()
    finally:
        compile_watch.expect(0)
        if helper is not None:
            _dismiss(helper)


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _helper(waiting: Sequence[Job]) -> int | None:
    """Number of the process that compiles from the end of the list until it meets what is kept; None where there is none."""
    try:
        helper = os.fork()
    except OSError:
        return None
    if helper:
        return helper
    try:
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_DFL)
        os.closerange(3, 4096)      # among them the lock of a run folder, which must not outlive its process
        compile_watch.silence()
        for job in reversed(waiting):
            if job.file is None or job.is_kept():
                break
            job.compile()
    finally:
        os._exit(0)


def _dismiss(helper: int) -> None:
    """Wait for the helper to finish the kernel it is at; end it if that takes long."""
    until = time.monotonic() + PATIENCE
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(helper, os.WNOHANG) == (0, 0):
            if time.monotonic() > until:
                os.kill(helper, signal.SIGKILL)
                os.waitpid(helper, 0)
                return
            time.sleep(0.01)
