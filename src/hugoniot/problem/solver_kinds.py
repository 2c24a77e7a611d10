"""The solvers a deck may ask for by `[solver] kind`, each with the module that reads and writes its decks."""

from types import ModuleType

from hugoniot.problem import fronts, lagrangian, shock_structure
from hugoniot.problem.plane import deck as plane

# solver kind -> module with `Model` (the deck's pydantic model), `read(raw, model, materials, collector)` -> (problem, warnings)
# where `model` is None if the deck did not fit it, and `write(problem)` -> dict of the resolved deck's tables
SOLVERS: dict[str, ModuleType] = {"fronts": fronts, "lagrange1d": lagrangian, "shock_structure": shock_structure, "lagrange2d": plane}


def solver_module(kind: str) -> ModuleType:
    """The module that reads decks of a solver."""
    return SOLVERS[kind]


def available_solvers() -> list[str]:
    """The solver kinds a deck may name."""
    return list(SOLVERS)
