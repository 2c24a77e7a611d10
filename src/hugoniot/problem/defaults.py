"""What the one-dimensional solver does where a deck is silent, by integrator; written out in every resolved deck.

compatible   measured best over the standard problems of `problem.standard` with one set of numbers; where something burns, the jump of
             detonation products, (gamma + 1)/4 with gamma near 3, stands for that of a gas or a metal
wilkins      as printed: C0 = 2, CL = 1 with sqrt(P/rho), two thirds of the Courant step (Wilkins B.2 items 7 and 9)
"""

import dataclasses
from types import MappingProxyType

from hugoniot.problem.model import Problem

COURANT = {"compatible": 0.5, "wilkins": 2.0 / 3.0}
VISCOSITY = {"compatible": ("limited", {"quadratic": 2.0 / 3.0, "linear": 0.3}), "wilkins": ("wilkins", {"quadratic": 2.0, "linear": 1.0})}
FOR_PRODUCTS = {"compatible": ("limited", {"quadratic": 1.0, "linear": 0.3}), "wilkins": VISCOSITY["wilkins"]}
HEAT_FLUX = {"compatible": 0.5, "wilkins": 0.0}


def completed(problem: Problem) -> Problem:
    """A problem whose lagrange1d solver's options leave nothing open; problems of other solvers pass unchanged."""
    options = problem.solver
    if options.kind != "lagrange1d":
        return problem
    burning = any(problem.materials[region.material].burn is not None for region in problem.regions)
    viscosity = (FOR_PRODUCTS if burning else VISCOSITY)[options.integrator]
    own = {"heat_flux": HEAT_FLUX[options.integrator], **options.options}
    return dataclasses.replace(problem, solver=dataclasses.replace(
        options, courant=options.courant or COURANT[options.integrator], viscosity=options.viscosity or viscosity,
        options=MappingProxyType(own)))
