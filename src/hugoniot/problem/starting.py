"""The state in which a region or block starts, as numbers: what warnings compare."""

import contextlib
from typing import TYPE_CHECKING

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import pressure, reference_state
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.model import Problem, Region
from hugoniot.problem.profiles import values_at

if TYPE_CHECKING:
    from hugoniot.problem.plane.model import Block2D, Problem2D


def start_at_ends(problem: "Problem | Problem2D", region: "Region | Block2D") -> tuple[tuple[float, float], tuple[float, float]]:
    """(density in kg/m3, pressure in Pa) in which a region starts at its left and at its right end; a block is uniform.

    Of explosives, and of states that a law does not have, the values given in the region, or the reference density and no pressure.
    """
    material, names = problem.materials[region.material], ("density", "pressure", "temperature", "energy")
    given = [np.full(2, np.nan if (value := getattr(region, name)) is None else value) for name in names]
    for name, _ in region.profile.fields if isinstance(region, Region) and region.profile is not None else ():
        if name in names:
            given[names.index(name)] = values_at(region.profile, name, np.array((region.start, region.end)))
    left, right = ([None if np.isnan(value) else float(value) for value in values] for values in np.transpose(given))
    return _density_and_pressure(material, left), _density_and_pressure(material, right)


def _density_and_pressure(material, given: list[float | None]) -> tuple[float, float]:
    """The same of one state from density, pressure, temperature and energy, None where not given."""
    if material.burn is None:
        with contextlib.suppress(HugoniotError, ArithmeticError, ValueError):
            rho, e = initial_state(material.eos, *given)
            return float(rho), float(pressure(rho, e, material.eos))
    return given[0] or float(reference_state(material.eos)[0]), given[1] or 0.0
