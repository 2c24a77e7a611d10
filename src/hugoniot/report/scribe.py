"""The report, written by a process of its own that reads the drawing library while the run computes.

Reading that library takes as long as a short run does. A `Scribe` is started with the run, waits for the folder of the finished
run, and writes its report; where there is no second core, or the process cannot be had or fails, the caller writes it itself.
"""

import contextlib
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable

DONE = "done"


class Scribe:
    """A context in which a run takes place: `write(folder)` at its end writes the report.

    wanted    False: nothing is started, and `write` writes as `report.write_report` does
    """

    def __init__(self, wanted: bool = True):
        self.process = _start() if wanted and _a_second_core() else None

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        if self.process is not None:
            self.process.kill()
            self.process.communicate()

    def write(self, folder) -> None:
        """Write the report of a finished run into its folder. Raises `FileTrouble`."""
        if not self._asked(folder):
            from hugoniot.report import write_report

            write_report(folder)

    def _asked(self, folder) -> bool:
        """Whether the waiting process wrote the report."""
        if self.process is None:
            return False
        try:
            self.process.stdin.write(json.dumps(os.path.abspath(folder)) + "\n")
            self.process.stdin.flush()
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
    from hugoniot.report.page import write_report

    line = sys.stdin.readline()
    if line:
        write_report(json.loads(line), by_two)
        sys.stdout.write(DONE + "\n")
        sys.stdout.flush()
    os._exit(0)     # the library takes its time to leave


def by_two(tasks: dict[str, Callable[[], str]]) -> dict[str, str]:
    """The pictures the tasks draw, every second one by a copy of this process; what it fails to give is drawn here."""
    names = list(tasks)
    pipe, its_end = os.pipe()
    copy = os.fork()
    if copy == 0:
        with contextlib.suppress(Exception), open(its_end, "w", encoding="utf-8") as out:
            json.dump({name: tasks[name]() for name in names[1::2]}, out)
        os._exit(0)
    os.close(its_end)
    found = {name: tasks[name]() for name in names[::2]}
    with contextlib.suppress(ValueError), open(pipe, encoding="utf-8") as given:
        found |= json.load(given)
    os.waitpid(copy, 0)
    return {name: found.get(name) or tasks[name]() for name in names}
