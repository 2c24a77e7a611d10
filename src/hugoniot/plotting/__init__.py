"""Pictures of runs, read from their folders. matplotlib is imported here only, when the first picture is drawn."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hugoniot.output.compare import Comparison


def save_comparison(compared: "Comparison", path):
    """Draw two runs, or a run and data, over each other with their difference, and write the picture. Raises `FileTrouble`."""
    from hugoniot.output.atomic import explained
    from hugoniot.plotting.comparison import comparison

    figure = comparison(compared)
    with explained(path, "no picture is written"):
        figure.savefig(path)
    return path


__all__ = ["save_comparison"]
