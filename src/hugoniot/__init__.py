"""hugoniot: a shock-physics workbench.

`run` runs a deck, `resume` continues a run, `load` opens a run folder; `Run` and `Problem` are what they give and take. Tools without
a mesh stand in `hugoniot.theory`, materials in `hugoniot.materials.library`, exact solutions in `hugoniot.theory.exact`.
"""

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


def __dir__() -> list[str]:
    """The public names, imported already or not, beside what a module has anyway."""
    return sorted({*globals(), *__all__})
