"""report.html of a run: one file that opens anywhere, without a network."""


def write_report(folder):
    """Write report.html into a finished run's folder, from what stands there; gives its path. Raises `FileTrouble`."""
    from hugoniot.report.page import write_report as write

    return write(folder)


__all__ = ["write_report"]
