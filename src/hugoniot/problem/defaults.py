"""What a run does where a deck is silent: options of the solvers, snapshots and gauges; written out in every resolved deck.

Of lagrange1d, by integrator:

compatible   measured best over the standard problems of `problem.standard` with one set of numbers; where something burns, the jump of
             detonation products, (gamma + 1)/4 with gamma near 3, stands for that of a gas or a metal, and burn laws were calibrated
             with one thickness of shock; the linear part beside them stays that of inert materials, whose free surfaces it keeps from
             overshooting; where all materials are condensed and nothing burns, steps are longer: shocks overshoot by
             0.03 % more at 0.7 of the Courant step than at 0.5, in gases by 1 to 6 %
wilkins      as printed: C0 = 2, CL = 1 with sqrt(P/rho), two thirds of the Courant step (Wilkins B.2 items 7 and 9)
"""

import dataclasses
from types import MappingProxyType

from hugoniot.laws import viscosity as _laws  # noqa: F401  (enrols the laws)
from hugoniot.laws.eos.contract import is_condensed
from hugoniot.laws.viscosity.contract import VISCOSITY as LAWS
from hugoniot.problem.gauges import with_automatic_gauges
from hugoniot.problem.model import Problem

COURANT = {"compatible": 0.5, "wilkins": 2.0 / 3.0}
COURANT_CONDENSED = {**COURANT, "compatible": 0.7}
VISCOSITY = {"compatible": ("limited", {"quadratic": 2.0 / 3.0, "linear": 0.3, "linear_condensed": 1.0}),
             "wilkins": ("wilkins", {"quadratic": 2.0, "linear": 1.0})}
FOR_PRODUCTS = {"compatible": ("limited", {"quadratic": 1.0, "linear": 0.3, "linear_condensed": 1.0}), "wilkins": VISCOSITY["wilkins"]}
HEAT_FLUX = {"compatible": 0.5, "wilkins": 0.0}
COURANT_OF_FLOW = 0.9   # of shock_structure
SNAPSHOTS = 100         # intervals
LAGRANGIAN = ("lagrange1d", "fronts")   # solvers of bodies with ends


def completed(problem: Problem) -> Problem:
    """The whole problem that a run solves: no option left open, and the gauges recorded unasked; a complete one is returned as it is."""
    problem = with_defaults(problem)
    if isinstance(problem, Problem) and problem.output.snapshots is None:
        output = dataclasses.replace(problem.output, snapshots=problem.stop_time / SNAPSHOTS)
        problem = dataclasses.replace(problem, output=output)
    return with_automatic_gauges(problem) if problem.solver.kind in LAGRANGIAN else problem


def with_defaults(problem: Problem) -> Problem:
    """A problem whose solver's options leave nothing open; problems of solvers not known here pass unchanged."""
    if problem.solver.kind == "shock_structure":
        return dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, courant=problem.solver.courant or COURANT_OF_FLOW))
    return _with_hydrocode_defaults(problem) if problem.solver.kind == "lagrange1d" else problem


def _with_hydrocode_defaults(problem: Problem) -> Problem:
    options = problem.solver
    materials = [problem.materials[region.material] for region in problem.regions]
    burning = any(material.burn is not None for material in materials)
    long_steps = options.viscosity is None and not burning and all(is_condensed(material.eos) for material in materials)
    courant = (COURANT_CONDENSED if long_steps else COURANT)[options.integrator]
    viscosity = (FOR_PRODUCTS if burning else VISCOSITY)[options.integrator]
    own = {"heat_flux": HEAT_FLUX[options.integrator], **options.options}
    return dataclasses.replace(problem, solver=dataclasses.replace(
        options, courant=options.courant or courant, viscosity=whole_viscosity(*(options.viscosity or viscosity)),
        options=MappingProxyType(own)))


def whole_viscosity(name: str, given) -> tuple[str, dict[str, float]]:
    """(law, every parameter of it) of an artificial viscosity: what is not given has the law's default.

    A linear coefficient that is given alone holds in every material, so that of condensed ones without strength follows it.
    """
    preset, given = LAWS.get(name).defaults, dict(given)
    if "linear_condensed" in preset and "linear" in given:
        given.setdefault("linear_condensed", given["linear"])
    return name, {**preset, **given}
