"""Progress of a run: a bar in a terminal, lines elsewhere. Both take what the time loop reports."""

import contextlib
import math
import pathlib
import shlex
import sys
import time
from typing import NoReturn

import typer

from hugoniot.units import format_si

SECONDS_BETWEEN_LINES = 5.0


@contextlib.contextmanager
def progress(quiet: bool = False):
    """A context that gives a display with `update(report)`: a bar if standard error is a terminal, lines if not, or nothing.

    It also shows what has to be compiled first.
    """
    from hugoniot.core.compile_watch import when_compiling

    with Silent() if quiet else Bar() if sys.stderr.isatty() else Lines() as display, when_compiling(display.compiling):
        yield display


def duration(seconds: float) -> str:
    """A wall time as people say it: "12 s", "3:05", "2:10:00"; "unknown" for infinity."""
    if not math.isfinite(seconds):
        return "unknown"
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    hours, rest = divmod(whole, 3600)
    return f"{hours}:{rest // 60:02}:{rest % 60:02}" if hours else f"{rest // 60}:{rest % 60:02}"


def time_left(seconds: float) -> str:
    """The end of a progress line: "12 s left", or "time left unknown"."""
    return f"{duration(seconds)} left" if math.isfinite(seconds) else "time left unknown"


def end_interrupted(folder) -> NoReturn:
    """End the command with exit code 130, saying how an interrupted run goes on."""
    folder = pathlib.Path(folder)
    if (folder / "summary.json").is_file():
        state = "the results are complete; files that are missing, such as the report, are written by"
    elif any((folder / "checkpoint").glob("[0-9]*.json")):
        state = "a checkpoint is kept; continue with"
    else:
        state = "no checkpoint was written yet; start again with"
    typer.echo(f"interrupted; {state}: hugoniot resume {shlex.quote(str(folder))}", err=True)
    raise typer.Exit(130) from None


def words(report) -> str:
    """One line: time, step, limiting zone, energy error."""
    where = f"zone {report.limiting_zone}" + (f" of {report.limiting_region}" if report.limiting_region else "")
    return (f"t = {format_si(report.time, 's', 4)}, cycle {report.cycle}, step {format_si(report.step, 's', 3)} set by {where}, "
            f"energy error {report.energy_error:.1e}")


def compiling_words(news) -> str:
    """One line: which kernel is compiled, and of how many where that is known."""
    total = "" if news.left is None else f" of {news.number + news.left}"
    return f"compiling kernel {news.number}{total}, once for this machine"


class Silent:
    """Shows nothing; the others are made of it.

    The time left is estimated from the first report on, because the time before it may have gone into compiling kernels.
    """

    first: tuple[float, float] | None = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        return None

    def update(self, report) -> None:
        """Nothing to show."""

    def compiling(self, news) -> None:
        """Nothing to report."""

    def left(self, report) -> float:
        """Wall seconds to the end of the run; infinite while unknown."""
        now = time.monotonic()
        if self.first is None:
            self.first = now, report.time
        began, start = self.first
        done = report.time - start
        return (now - began) * (report.stop_time - report.time) / done if done > 0.0 else math.inf


class Lines(Silent):
    """A line on standard error every few seconds, for logs."""

    def __init__(self, interval: float = SECONDS_BETWEEN_LINES):
        self.interval, self.last, self.last_compiled = interval, time.monotonic(), -math.inf

    def update(self, report) -> None:
        now, left = time.monotonic(), self.left(report)
        if now - self.last < self.interval:
            return
        self.last = now
        share = report.time / report.stop_time
        typer.echo(f"{share:4.0%}  {words(report)}, {time_left(left)}", err=True)

    def compiling(self, news) -> None:
        now = time.monotonic()
        if now - self.last_compiled >= self.interval:
            self.last_compiled = now
            typer.echo(compiling_words(news), err=True)


class Bar(Silent):
    """A bar that redraws itself, on standard error."""

    def __init__(self):
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn

        self.display = Progress(TextColumn("{task.percentage:>3.0f}%"), BarColumn(24), TextColumn("{task.description}"),
                                console=Console(stderr=True), transient=True)
        self.task = self.display.add_task("starting", total=1.0)

    def __enter__(self):
        self.display.start()
        return self

    def __exit__(self, *_):
        self.display.stop()

    def update(self, report) -> None:
        self.display.update(self.task, completed=report.time / report.stop_time,
                            description=f"{words(report)}, {time_left(self.left(report))}")

    def compiling(self, news) -> None:
        self.display.update(self.task, description=compiling_words(news))
