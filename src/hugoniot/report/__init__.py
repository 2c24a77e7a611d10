"""report.html of a run: one file that opens anywhere, without a network."""

from collections.abc import Callable


def write_report(folder, into=None):
    """Write report.html of the finished run in a folder into that folder, or into another; gives its path. Raises `FileTrouble`."""
    from hugoniot.report.page import write_report as write

    return write(folder, into=into)


def write_or_note(folder, write: Callable | None = None) -> None:
    """Write the report as a face of a finished run: if that fails, the result stands and the run's log says why.

    write   writes the report of a folder (default: `write_report`)
    """
    from hugoniot.output.run_folder import log_line

    try:
        (write or write_report)(folder)
    except (OSError, ValueError, KeyError) as error:
        log_line(folder, f"warning: the report could not be written: {error}")


__all__ = ["write_or_note", "write_report"]
