"""hugoniot: a shock-physics workbench. `run`, `load`, `check` and the rooms below are the public names."""

from importlib import import_module
from typing import TYPE_CHECKING

__version__ = "0.1.0"

if TYPE_CHECKING:
    from hugoniot.output.run import Run, load
    from hugoniot.problem.model import Problem
    from hugoniot.simulate import resume, run

_PUBLIC = {
    "run": "hugoniot.simulate", "resume": "hugoniot.simulate", "load": "hugoniot.output.run", "Run": "hugoniot.output.run",
    "Problem": "hugoniot.problem.model",
}

__all__ = ["Problem", "Run", "__version__", "load", "resume", "run"]


def __getattr__(name: str):
    """Public names are imported on first use: `import hugoniot` costs milliseconds."""
    if name in _PUBLIC:
        return getattr(import_module(_PUBLIC[name]), name)
    raise AttributeError(f"module 'hugoniot' has no attribute '{name}'")
