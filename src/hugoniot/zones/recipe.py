"""Recipes: which passes the zones of a material take, with their addresses and numbers. The march reads them and knows no law.

A recipe is one row of integers: addresses of passes (0 where a material needs none), addresses of the numbers of its laws, and what is
asked once for a material instead of in every zone. Beside it stand the material's `Constants`.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from hugoniot.core.passes import numbers_of
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.burn.contract import BURN, Reactive
from hugoniot.laws.eos.contract import reference_state
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.zones import burn, closure, fracture, mixture, rows, soundness, strength, viscosity
from hugoniot.zones.constants import Constants
from hugoniot.zones.laws import bind_burning

EXPLICIT, IMPLICIT = "explicit", "implicit"     # closures at a given energy, or with the energy


class Recipe(NamedTuple):
    """Addresses of passes and of numbers (0 where a material needs none), and flags (0 or 1)."""

    # closure of inert material
    pressure: int = 0
    state: int = 0
    settle: int = 0
    stiffness: int = 0
    temperature: int = 0
    eos: int = 0
    # strength
    shear: int = 0
    yields: int = 0
    harden: int = 0
    strength: int = 0
    # fracture and voids
    rest: int = 0
    fracture: int = 0
    worst: int = 0
    breaking: int = 0
    solid: int = 0
    relief: int = 0
    hold: int = 0
    # viscosity
    speed: int = 0
    speeds: int = 0
    viscosity: int = 0
    # burning
    burn: int = 0
    rates: int = 0
    solve: int = 0
    slopes: int = 0
    reactive: int = 0
    pace: int = 0
    was_passing: int = 0
    is_passing: int = 0
    share_heat: int = 0
    lead_on: int = 0
    keep_phases: int = 0
    unburned_shear: int = 0
    unburned_limit: int = 0
    plastic_heat: int = 0
    # everywhere
    clear: int = 0
    copy: int = 0
    add: int = 0
    look_over: int = 0
    # flags
    remembers: int = 0
    needs_rate: int = 0       # the strength law asks for a strain rate
    bulk_first: int = 0       # the bulk modulus is asked for before the state is known
    bare: int = 0             # nothing stands for the explosive before it burns
    instant: int = 0          # burns at once


@dataclass
class Cookbook:
    """The recipes of a problem: `recipes` (n, fields), `constants` (n, fields); it keeps the numbers alive that recipes point to."""

    recipes: np.ndarray
    constants: np.ndarray
    kept: list[Any] = field(default_factory=list)


class _Pantry:
    """Numbers of laws by their parameters, kept where they are."""

    def __init__(self):
        self.kept: list[Any] = []

    def put(self, par) -> int:
        numbers = numbers_of(par)
        self.kept.append((par, numbers))
        return numbers.ctypes.data


def recipe_of(pantry: _Pantry, eos, strength_law, fracture_law, viscosity_law, closing: str) -> Recipe:
    """The recipe of one material; `eos` may be a `Reactive` pair. Compiles what is not on disk yet."""
    burning = isinstance(eos, Reactive)
    found: dict[str, int] = {"clear": rows.clear_pass.address(), "copy": rows.copy_pass.address(), "add": rows.add_pass.address(),
                             "look_over": soundness.look_over.address(),
                             **_viscous_passes(viscosity_law, closing, burning and mixture.bare(eos.mixture)),
                             "viscosity": pantry.put(viscosity_law)}
    found |= _burning_passes(eos) if burning else _inert_passes(eos, closing)
    found["reactive" if burning else "eos"] = pantry.put(eos)
    flags = STRENGTH.of(strength_law).flags
    if "fluid" not in flags:
        found |= {"shear": strength.shear_pass.address(strength_law), "yields": strength.yield_pass.address(strength_law),
                  "harden": strength.harden_pass.address(), "strength": pantry.put(strength_law), "needs_rate": int("needs_rate" in flags)}
        if "needs_temperature" in flags:
            found["temperature"] = (mixture.mixture_temperature_pass if burning else closure.temperature_pass).address(eos)
        if burning:
            found |= {"unburned_shear": strength.unburned_shear_pass.address(), "unburned_limit": strength.unburned_limit_pass.address(),
                      "plastic_heat": strength.plastic_heat_pass.address()}
    breaks = FRACTURE.of(fracture_law).flags
    if "never" not in breaks:
        remembers = not burning and closure.remembers(eos)
        found |= {"fracture": fracture.fracture_pass.address(fracture_law), "worst": fracture.worst_pass.address(),
                  "breaking": pantry.put(fracture_law), "remembers": int(remembers),
                  "rest": closure.rest_pass.address(eos) if remembers else rows.rest_pass.address()}
        if "voids" in breaks:
            found |= {"relief": fracture.relief_pass.address(fracture_law), "solid": fracture.solid_pass.address(),
                      "hold": fracture.hold_pass.address()}
    found["bulk_first"] = int("needs_bulk_modulus" in flags or (closing == EXPLICIT and "relief" in found))
    if found["bulk_first"] and not burning:
        found["stiffness"] = closure.stiffness_pass.address(eos)
    return Recipe(**found)


def _viscous_passes(law, closing: str, bare: bool) -> dict[str, int]:
    if closing == IMPLICIT and not bare:
        return {"speed": viscosity.speed_pass.address(law), "speeds": viscosity.speeds_pass.address(law)}
    return {"speed": viscosity.speed_pass.address(law)}


def _inert_passes(eos, closing: str) -> dict[str, int]:
    if closing == IMPLICIT:
        return {"settle": closure.settle_pass.address(eos)}
    return {"pressure": closure.pressure_pass.address(eos), "state": closure.state_pass.address(eos)}


def _burning_passes(reactive: Reactive) -> dict[str, int]:
    bind_burning()
    of_laws = {"burn": burn.burn_pass, "rates": burn.rates_pass, "solve": mixture.solve_pass, "slopes": mixture.slopes_pass}
    of_none = {"pace": burn.pace_pass, "was_passing": burn.was_passing_pass, "is_passing": burn.is_passing_pass,
               "share_heat": burn.share_heat_pass, "lead_on": burn.lead_on_pass, "keep_phases": burn.keep_phases_pass}
    return ({name: each.address(reactive) for name, each in of_laws.items()} | {name: each.address() for name, each in of_none.items()}
            | {"bare": int(mixture.bare(reactive.mixture)), "instant": int("instantaneous" in BURN.of(reactive.rate).flags)})


def constants_of(laws, noise: float, per_rate: float = 0.0, front: float = 0.0, freezes: float = 0.0) -> Constants:
    """The constants of a material of these laws (eos or Reactive, strength, fracture, viscosity)."""
    eos, viscosity_law = laws[0], laws[3]
    burning = isinstance(eos, Reactive)
    return Constants(float(reference_state(eos.mixture.products if burning else eos)[0]), noise,
                     float("two_sided" in VISCOSITY.of(viscosity_law).flags), per_rate, front,
                     float(burning and mixture.isolates(eos.mixture)), freezes)


def cookbook(materials, closing: str) -> Cookbook:
    """Recipes of materials, each given as ((eos or Reactive, strength, fracture, viscosity), Constants)."""
    pantry = _Pantry()
    recipes = [recipe_of(pantry, *map(float_parameters, laws), closing) for laws, _ in materials]
    return Cookbook(np.array(recipes, dtype=np.int64), np.array([tuple(constants) for _, constants in materials], dtype=float), pantry.kept)
