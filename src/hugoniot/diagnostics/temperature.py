"""Temperatures of a run, from density and energy by each material's own law; the solver carries none.

A material has a temperature if its equation of state gives one with the constants it was given (a specific heat, as a rule). A burning
material has that of its mixture (docs/theory/mixtures.md): the products' in thermal isolation, the common one in equilibrium, the mean
by mass where pressures are weighted; both laws must give one. Products that have not formed yet have none. Where there is none the value
is nan.
"""


import numpy as np

from hugoniot.laws.arrays import float_parameters, recorded_temperature
from hugoniot.laws.eos.contract import has_temperature
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.materials import burning


def laws_with_temperature(problem) -> list:
    """The equation of state of each region's material, or the mixture law of what burns; None where it gives no temperature."""
    return [_law(problem.materials[region.material]) for region in problem.regions]


def _law(material):
    known = has_temperature(material.eos)
    if material.burn is None:
        return material.eos if known else None
    known = known and (not burning.has_reactants(material) or has_temperature(material.unreacted))
    return burning.reactive(material).mixture if known else None


def zone_temperature(state, region_of: np.ndarray, laws: list, phases: np.ndarray | None = None) -> np.ndarray:
    """Temperature of every zone, K, (nzone,); `phases` (5, nzone) are the solver's of a run in which something burns."""
    found = np.full(region_of.shape, np.nan)
    for k, law in enumerate(laws):
        here = region_of == k
        if _is_mixture(law):
            found[here] = mixed_temperature(phases[:, here].T, law)
        elif law is not None:
            found[here] = _temperature({name: values[here] for name, values in state.zones.items()}, law)
    return found


def gauge_temperature(values: dict, gauge_laws: list) -> np.ndarray:
    """Temperature at every gauge, K, (n, ngauge), from its records of density and energy, or of the phases of its two zones."""
    found = np.full(values["density"].shape, np.nan)
    for k, law in enumerate(gauge_laws):
        if _is_mixture(law):
            share = values["share"][:, k]
            first, second = (mixed_temperature(values["phases"][:, k, side], law) for side in (0, 1))
            found[:, k] = np.where(share > 0.0, (1.0 - share) * first + share * second, first)
        elif law is not None:
            found[:, k] = _temperature({name: values[name][:, k] for name in ("density", "energy", "compaction", "void_fraction")
                                        if name in values}, law)
    return found


def _temperature(values: dict, law) -> np.ndarray:
    """Temperature of records of density and energy, and of the compaction where the law remembers it, K."""
    return recorded_temperature(solid_density(values), values["energy"], law, values.get("compaction"))


def solid_density(values) -> np.ndarray:
    """Density of the material itself, kg/m3, where fracture has opened voids: `density` is the mass over the volume with them."""
    return values["density"] / (1.0 - values["void_fraction"]) if "void_fraction" in values else values["density"]


def mixed_temperature(phases: np.ndarray, par) -> np.ndarray:
    """Temperature, K, (n,), of mixtures given as (n, 5): burn fraction, rho_r, e_r, rho_p, e_p (energies with the chemical one)."""
    from hugoniot.laws.mixture_kernels import temperature_rows

    phases, par = np.ascontiguousarray(phases, dtype=float), float_parameters(par)
    out = np.empty(len(phases))
    temperature_rows(phases, par, out)      # however few they are: by Python they would have other bits
    if "no_reactants" in MIXTURE.of(par).flags:
        out[phases[:, 0] <= 0.0] = np.nan
    return out


def _is_mixture(law) -> bool:
    return law is not None and MIXTURE.knows(law)
