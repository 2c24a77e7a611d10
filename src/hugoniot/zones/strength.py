"""Strength of a zone: shear modulus, and the flow stress with the plastic strain that meets it.

The elastic trial and the return to the yield surface belong to the tensor of a dimension (`stress`); what passes between them is the
equivalent stress sqrt(3/2 s:s) of the trial state.

Source: Wilkins B.2 items 5 and 6; Herrmann A.18.
"""

from collections import namedtuple
from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax
from hugoniot.core.passes import bind_flag, law_of, rows_apart, zone_pass
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus

TINY = 1e-300


class ShearRows(NamedTuple):
    """rho (kg/m3), p (Pa), temperature (K), c2 (bulk, m2/s2) -> shear (Pa)."""

    rho: Any
    p: Any
    temperature: Any
    c2: Any
    shear: Any


class YieldRows(NamedTuple):
    """rho, p, temperature, rate (1/s), shear, equivalent (Pa), plastic_strain -> limit (Pa), flow (plastic strain of the step)."""

    rho: Any
    p: Any
    temperature: Any
    rate: Any
    shear: Any
    equivalent: Any
    plastic_strain: Any
    limit: Any
    flow: Any


HardenRows = namedtuple("HardenRows", "limit flow v plastic_work plastic_strain")
UnburnedShearRows = namedtuple("UnburnedShearRows", "lam shear")
UnburnedLimitRows = namedtuple("UnburnedLimitRows", "lam shear equivalent limit flow")
PlasticHeatRows = namedtuple("PlasticHeatRows", "limit flow v heat")


def hardens(strength) -> bool:
    """Whether the flow stress depends on the plastic strain."""
    return "hardens" in STRENGTH.of(strength).flags


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


@zone_pass(ShearRows)
def shear_pass(count, z, dt, numbers, law):
    rows_apart()
    strength = law_of(law, numbers)
    for j in range(count):
        z.shear[j] = shear_modulus(z.rho[j], z.p[j], z.temperature[j], z.rho[j] * z.c2[j], strength)


@zone_pass(YieldRows)
def yield_pass(count, z, dt, numbers, law):
    rows_apart()
    strength = law_of(law, numbers)
    for j in range(count):
        state = (z.rho[j], z.p[j], z.temperature[j], z.rate[j])
        z.limit[j], z.flow[j] = yield_at(z.equivalent[j], z.shear[j], state, z.plastic_strain[j], strength)


@zone_pass(HardenRows)
def harden_pass(count, z, dt, numbers, law):
    """Plastic strain and work of the step."""
    rows_apart()
    for j in range(count):
        z.plastic_work[j] += z.limit[j] * z.flow[j] * z.v[j]
        z.plastic_strain[j] += z.flow[j]


@zone_pass(UnburnedShearRows)
def unburned_shear_pass(count, z, dt, numbers, law):
    """Products have no strength: the modulus is that of the unburned mass fraction."""
    rows_apart()
    for j in range(count):
        z.shear[j] *= 1.0 - z.lam[j]


@zone_pass(UnburnedLimitRows)
def unburned_limit_pass(count, z, dt, numbers, law):
    """The same for the flow stress, with the plastic strain that meets it."""
    rows_apart()
    for j in range(count):
        if z.lam[j] > 0.0:
            limit, stiffness = z.limit[j] * (1.0 - z.lam[j]), 3.0 * z.shear[j]
            excess = fmax(z.equivalent[j] - limit, 0.0)
            z.limit[j] = limit
            z.flow[j] = excess / fmax(stiffness, TINY) if stiffness > excess else 0.0


@zone_pass(PlasticHeatRows)
def plastic_heat_pass(count, z, dt, numbers, law):
    """Adds the plastic work of a strain, J/kg."""
    rows_apart()
    for j in range(count):
        z.heat[j] += z.limit[j] * z.flow[j] * z.v[j]


bind_flag(hardens, STRENGTH, "hardens")
bind(yield_at)
