"""Runs as the commands that look at them open them: a finished run, or an unfinished one up to its newest checkpoint."""

import contextlib
import tempfile
from collections.abc import Iterator
from pathlib import Path


@contextlib.contextmanager
def opened(folder: Path) -> Iterator:
    """The `Run` of a folder. That of an unfinished run is put together in a temporary folder; its own is left as it is."""
    from hugoniot.plotting import load

    if not _unfinished(folder):
        yield load(folder)
        return
    from hugoniot.simulate import so_far

    with tempfile.TemporaryDirectory(prefix="hugoniot-") as room:
        yield so_far(folder, room)


def _unfinished(folder: Path) -> bool:
    """Whether a run has left checkpoints and neither a result nor the state in which it failed."""
    ended = any((folder / name).is_file() for name in ("summary.json", "post_mortem.txt"))
    return not ended and any((folder / "checkpoint").glob("[0-9]*.json"))


def partial_words(run) -> str:
    """What to write beside the results of an unfinished run; empty for any other run, and for data."""
    from hugoniot.units import format_si

    status = "" if isinstance(run, Path) else run.summary["status"]
    return f"{status}, results to {format_si(run.summary['time'], 's', 4)}" if status.startswith("partial") else ""
