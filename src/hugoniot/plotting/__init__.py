"""Pictures of runs, read from their folders. matplotlib is imported here only, when the first picture is drawn.

Importing this room gives every `Run` its `plot`: files know nothing of pictures, which stand a layer above.
"""

from typing import TYPE_CHECKING

from hugoniot.output.run import Run, load

if TYPE_CHECKING:
    from hugoniot.output.compare import Comparison
    from hugoniot.plotting.accessor import RunPlots


def _plot(run: Run) -> "RunPlots":
    """Pictures of this run: run.plot.xt("pressure") draws a wave diagram and returns its matplotlib axes."""
    from hugoniot.plotting.accessor import RunPlots

    return RunPlots(run)


Run.plot = property(_plot)


def save_comparison(compared: "Comparison", path):
    """Draw two runs, or a run and data, over each other with their difference, and write the picture. Raises `FileTrouble`."""
    from hugoniot.output.atomic import explained
    from hugoniot.plotting.comparison import comparison

    figure = comparison(compared)
    with explained(path, "no picture is written"):
        figure.savefig(path)
    return path


__all__ = ["Run", "load", "save_comparison"]
