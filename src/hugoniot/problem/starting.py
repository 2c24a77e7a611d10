"""The state in which a region or block starts, as numbers: what warnings compare."""

import contextlib
from typing import TYPE_CHECKING

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import is_condensed, pressure, reference_state, sound_speed_squared
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.model import Problem, Region
from hugoniot.problem.profiles import end_velocities, values_at

if TYPE_CHECKING:
    from hugoniot.problem.plane.model import Block2D, Problem2D

NO_PRESSURE = 1e-9     # of rho c^2


def part_freely(problem: Problem, left: Region, right: Region) -> bool:
    """Whether two regions that touch move apart at t = 0 without a wave: condensed bodies without pressure that nothing holds together."""
    held = [law.kind != "separable" for law in problem.interfaces if {law.left, law.right} == {left.name, right.name}]
    if any(held) or problem.left.kind == "periodic" or not end_velocities(right)[0] > end_velocities(left)[1]:
        return False
    for region, (_, p) in ((left, start_at_ends(problem, left)[1]), (right, start_at_ends(problem, right)[0])):
        material = problem.materials[region.material]
        if material.eos is None or material.burn is not None or not is_condensed(material.eos):
            return False
        rho, e = reference_state(material.eos)
        if not abs(p) <= NO_PRESSURE * rho * sound_speed_squared(rho, e, material.eos):
            return False
    return True


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
