"""hugoniot: a shock-physics workbench.

`run` runs a deck or a `Problem`, `resume` continues an interrupted run, and `load` opens the folder of a run; each returns a `Run`.
`sweep` runs a deck many times, and `fit` finds constants of a deck from measured records; each returns an xarray Dataset.
Solutions without a mesh are in `hugoniot.theory`, exact solutions in `hugoniot.theory.exact`, materials in
`hugoniot.materials.library`.
"""

from typing import TYPE_CHECKING

from hugoniot.version import __version__

if TYPE_CHECKING:
    from hugoniot.campaign.api import fit, sweep
    from hugoniot.plotting import Run, load
    from hugoniot.problem.model import Problem
    from hugoniot.simulate import resume, run

__all__ = ["Problem", "Run", "__version__", "fit", "load", "resume", "run", "sweep"]


def __getattr__(name: str):
    """Public names are imported on first use: `import hugoniot` costs milliseconds."""
    if name in ("run", "resume"):
        from hugoniot import simulate as holder
    elif name in ("Run", "load"):
        from hugoniot import plotting as holder
    elif name in ("fit", "sweep"):
        from hugoniot.campaign import api as holder
    elif name == "Problem":
        from hugoniot.problem import model as holder
    else:
        raise AttributeError(f"module 'hugoniot' has no attribute '{name}'")
    return getattr(holder, name)


def __dir__() -> list[str]:
    """The public names, imported already or not, beside what a module has anyway."""
    return sorted({*globals(), *__all__})
