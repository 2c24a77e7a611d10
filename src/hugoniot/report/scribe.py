"""The report, written by a process of its own that reads the drawing library while the run computes.

Reading that library takes as long as a short run does. A `Scribe` is started with the run, waits for the folder of the finished
run, and writes its report while the run's numbers are told; where there is no second core, or the process cannot be had or fails,
the caller writes it itself.
"""

import contextlib
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable

from hugoniot.report import write_or_note

DONE = "done"


class Scribe:
    """A context in which a run takes place: `write(folder)` has the report written, which stands when the context ends, or `wait` returns.

    wanted    False: nothing is started, and `write` writes as `report.write_report` does
    """

    def __init__(self, wanted: bool = True):
        self.process = _start() if wanted and _a_second_core() else None
        self.folder = None      # of the report that is being written

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        try:
            if kind is None:
                self.wait()
        finally:
            if self.process is not None:
                self.process.kill()
                self.process.communicate()

    def write(self, folder) -> None:
        """Have the report of a finished run written into its folder, by the waiting process if there is one."""
        if self._asked(folder):
            self.folder = folder
        else:
            write_or_note(folder)

    def wait(self) -> None:
        """Return when the report stands. What the process could not write is written here; if that fails too, the run's log says why."""
        folder, self.folder = self.folder, None
        if folder is not None and not self._answered():
            write_or_note(folder)

    def _asked(self, folder) -> bool:
        if self.process is None:
            return False
        try:
            self.process.stdin.write(json.dumps(os.path.abspath(folder)) + "\n")
            self.process.stdin.flush()
        except OSError:
            return False
        return True

    def _answered(self) -> bool:
        try:
            return self.process.stdout.readline().strip() == DONE
        except OSError:
            return False


def _a_second_core() -> bool:
    return hasattr(os, "sched_getaffinity") and len(os.sched_getaffinity(0)) > 1


def _start():
    """The waiting process, or None. It does not look for modules in the current folder (-P), where a deck and anything else may stand."""
    if not sys.executable:
        return None
    with contextlib.suppress(OSError):
        return subprocess.Popen([sys.executable, "-P", "-c", "from hugoniot.report.scribe import serve; serve()"],
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return None


def serve() -> None:
    """Get ready, wait for a folder on the standard input, write its report and say so."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)     # Ctrl-C is the run's to answer; when it ends, so does the input
    from hugoniot.plotting.inline import rehearse
    from hugoniot.report.page import write_report

    rehearse()
    line = sys.stdin.readline()
    if line:
        write_report(json.loads(line), by_two)
        sys.stdout.write(DONE + "\n")
        sys.stdout.flush()
    os._exit(0)     # the library takes its time to leave


def by_two(tasks: dict[str, Callable[[], str]]) -> dict[str, str]:
    """The pictures the tasks draw, with a copy of this process: who is free takes the next. What the copy fails to give is drawn here."""
    names = list(tasks)
    queue, given = os.pipe()
    os.write(given, bytes(range(len(names))))    # a byte is read by one of the two only
    os.close(given)

    def drawn() -> dict[str, str]:
        return {names[place[0]]: tasks[names[place[0]]]() for place in iter(lambda: os.read(queue, 1), b"")}

    answer, its_end = os.pipe()
    copy = os.fork()
    if copy == 0:
        with contextlib.suppress(Exception), open(its_end, "w", encoding="utf-8") as out:
            json.dump(drawn(), out)
        os._exit(0)
    os.close(its_end)
    found = drawn()
    with contextlib.suppress(ValueError), open(answer, encoding="utf-8") as its:
        found |= json.load(its)
    os.waitpid(copy, 0)
    os.close(queue)
    return {name: found.get(name) or tasks[name]() for name in names}
