"""Strength of a zone: shear modulus, and the flow stress with the plastic strain that satisfies it.

The elastic trial and the return to the yield surface depend on the tensor of a dimension; a solver combines them with `modulus` and
`yielding` in one pass (`stress`, `tensor`), compiled for a law and a tensor. The quantity passed between them is the equivalent stress
sqrt(3/2 s:s) of the trial state.

Source: Wilkins B.2 items 5 and 6; Herrmann A.18.
"""

from collections import namedtuple
from typing import Any, NamedTuple

from hugoniot.core.binder import only_if
from hugoniot.core.ops import fmax
from hugoniot.core.passes import flag_of, rows_apart, zone_pass
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.zones.rows import STRETCH

TINY = 1e-300
hardens = flag_of(STRENGTH, "hardens")           # whether the flow stress depends on the plastic strain
needs_rate = flag_of(STRENGTH, "needs_rate")     # whether it depends on the strain rate


class Inert(NamedTuple):
    """Zones that keep their strength."""


class Burning(NamedTuple):
    """Zones whose burned mass fraction has none."""


class Strong(NamedTuple):
    """What a pass of strength is compiled for.

    law         parameters of the strength law
    material    Inert() or Burning()
    geometry    that of the solver's tensor
    """

    law: Any
    material: Any
    geometry: Any


class Solid(namedtuple("Solid", "rho p temperature c2 lam plastic_strain")):
    """Rows of what a strength law is asked with: rho (kg/m3), p (Pa), temperature (K), c2 (bulk, m2/s2), burn fraction, plastic strain."""


def yield_at(equivalent, shear, state, plastic_strain, strength):
    """(stress on the yield surface or above the trial, plastic strain increment) of an elastic trial state.

    `state` = (rho, p, temperature, rate). A hardening law is met implicitly: 3 G d = trial - Y(eps + d) by one secant
    step, which is exact for linear hardening. Where the excess would take a strain of more than 1, the modulus itself has gone
    (a melt): the stress is lost without plastic strain.
    """
    rho, p, heat, rate = state
    limit = flow_stress(rho, p, heat, plastic_strain, rate, strength)
    stiffness = 3.0 * shear
    excess = fmax(equivalent - limit, 0.0)
    increment = excess / fmax(stiffness, TINY) if stiffness > excess else 0.0
    if hardens(strength):
        further = flow_stress(rho, p, heat, plastic_strain + increment, rate, strength)
        increment = increment * excess / fmax(excess + (further - limit), TINY)  # a sum with TINY may be reordered and lose it
        limit = limit + excess - increment * stiffness if stiffness > excess else limit
    return limit, increment


def modulus(state, c2, lam, strong):
    """Shear modulus, Pa; products have none, so that of the unburned mass fraction. `state` as in `yield_at`."""
    rho, p, heat, _ = state
    return shear_modulus(rho, p, heat, rho * c2, strong.law) * unburned(lam, strong.material)


def yielding(equivalent, shear, state, plastic_strain, lam, strong):
    """(flow stress, plastic strain increment) as `yield_at`, the flow stress that of the unburned mass fraction."""
    limit, increment = yield_at(equivalent, shear, state, plastic_strain, strong.law)
    part = unburned(lam, strong.material)
    if part < 1.0:
        limit *= part
        excess = fmax(equivalent - limit, 0.0)
        increment = excess / fmax(3.0 * shear, TINY) if 3.0 * shear > excess else 0.0
    return limit, increment


@only_if(lambda material: material is Burning, otherwise=1.0)
def unburned(lam, material):
    """Mass fraction that has not burned."""
    return 1.0 - lam


@zone_pass("limit flow v plastic_work plastic_strain")
def harden_pass(count, z, dt, numbers, law):
    """Plastic strain and work of the step; stretches of zones in which none flows are skipped."""
    rows_apart()
    first = 0
    while first < count:
        end, most = min(first + STRETCH, count), 0.0
        for j in range(first, end):
            most = fmax(most, z.flow[j])
        if most > 0.0:
            for j in range(first, end):
                z.plastic_work[j] += z.limit[j] * z.flow[j] * z.v[j]
                z.plastic_strain[j] += z.flow[j]
        first = end


@zone_pass("limit flow v heat")
def plastic_heat_pass(count, z, dt, numbers, law):
    """Adds the plastic work of a strain, J/kg."""
    rows_apart()
    for j in range(count):
        z.heat[j] += z.limit[j] * z.flow[j] * z.v[j]
