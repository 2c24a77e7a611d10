"""Temperatures of a run, from density and energy by each material's own law; the solver carries none.

A material has a temperature if its equation of state gives one with the constants it was given (a specific heat, as a rule) and
does not burn: a burning mixture has two phases, each with its own. Where there is none the value is nan.
"""

import numpy as np

from hugoniot.laws.arrays import temperature_array
from hugoniot.laws.eos.contract import has_temperature


def laws_with_temperature(problem) -> list:
    """The equation of state of each region's material, None where it gives no temperature."""
    materials = [problem.materials[region.material] for region in problem.regions]
    return [m.eos if m.burn is None and has_temperature(m.eos) else None for m in materials]


def zone_temperature(state, region_of: np.ndarray, laws: list) -> np.ndarray:
    """Temperature of every zone, K, (nzone,)."""
    found = np.full(region_of.shape, np.nan)
    for k, law in enumerate(laws):
        if law is not None:
            here = region_of == k
            found[here] = temperature_array(state.zones["density"][here], state.zones["energy"][here], law)
    return found


def gauge_temperature(values: dict, gauge_laws: list) -> np.ndarray:
    """Temperature at every gauge, K, (n, ngauge), from its records of density and energy."""
    found = np.full(values["density"].shape, np.nan)
    for k, law in enumerate(gauge_laws):
        if law is not None:
            found[:, k] = temperature_array(values["density"][:, k], values["energy"][:, k], law)
    return found
