"""What the one-dimensional solver does where a deck is silent, by integrator; written out in every resolved deck.

compatible   measured best over the standard problems of `problem.standard` with one set of numbers
wilkins      as printed: C0 = 2, CL = 1 with sqrt(P/rho), two thirds of the Courant step (Wilkins B.2 items 7 and 9)
"""

import dataclasses
from types import MappingProxyType

from hugoniot.problem.model import Problem, SolverOptions

COURANT = {"compatible": 0.5, "wilkins": 2.0 / 3.0}
VISCOSITY = {"compatible": ("limited", {"quadratic": 2.0 / 3.0, "linear": 0.3}), "wilkins": ("wilkins", {"quadratic": 2.0, "linear": 1.0})}
HEAT_FLUX = {"compatible": 0.5, "wilkins": 0.0}


def complete(options: SolverOptions) -> SolverOptions:
    """Options of the lagrange1d solver with nothing left open."""
    own = {"heat_flux": HEAT_FLUX[options.integrator], **options.options}
    return dataclasses.replace(options, courant=options.courant or COURANT[options.integrator],
                               viscosity=options.viscosity or VISCOSITY[options.integrator], options=MappingProxyType(own))


def completed(problem: Problem) -> Problem:
    """A problem with its solver's options complete; problems of other solvers pass unchanged."""
    return dataclasses.replace(problem, solver=complete(problem.solver)) if problem.solver.kind == "lagrange1d" else problem
