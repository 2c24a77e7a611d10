"""The process of a run started from the page: a deck on standard input, its progress as lines of JSON on standard output.

Exit codes as of `hugoniot run`.
"""

import contextlib
import json
import sys
import time
from pathlib import Path

from hugoniot.errors import HugoniotError
from hugoniot.explorer.decks import LARGEST, read

BETWEEN = 0.2   # s
COMMAND = "import sys; from hugoniot.explorer.worker import main; sys.exit(main(sys.argv[1]))"


def tell(**news) -> None:
    """A line of JSON; where nobody reads any more the run goes on."""
    with contextlib.suppress(OSError):
        sys.stdout.write(json.dumps(news) + "\n")
        sys.stdout.flush()


class Display:
    """Progress of the time loop, a few times a second."""

    def __init__(self):
        self.last = 0.0

    def update(self, report) -> None:
        """What the loop reports."""
        now = time.monotonic()
        if now - self.last < BETWEEN and report.time < report.stop_time:
            return
        self.last = now
        tell(time=report.time, stop_time=report.stop_time, cycle=report.cycle, step=report.step, energy_error=report.energy_error)


def main(folder: str) -> int:
    """Run the deck of standard input into `folder`; the exit code."""
    from hugoniot import simulate
    from hugoniot.core.compile_watch import when_compiling, without_linear_algebra

    try:
        found = read(sys.stdin.read(LARGEST), Path(folder).parent)
        for warning in found.warnings:
            tell(message=f"warning: {warning}")
        without_linear_algebra()
        with when_compiling(lambda news: tell(message=f"compiling kernel {news.number}, once for this machine")):
            simulate.run(found, folder, progress=Display())
    except HugoniotError as error:
        tell(message="\n".join(str(p) for p in getattr(error, "problems", [error])))
        return error.exit_code
    except KeyboardInterrupt:
        tell(message=f"stopped; hugoniot resume {folder} continues from the checkpoint")
        return 130
    return 0
