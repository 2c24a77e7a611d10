"""What a burn law must provide: how the burn fraction of a zone grows, by a rate or by a schedule.

    rate(burn_fraction, rho, p, temperature, par)                            1/s; 0 for scheduled and instantaneous laws
    advance(burn_fraction, dt, rho, p, temperature, par)                     burn fraction after dt s at constant rho, p, temperature
    scheduled(burn_fraction, time, lighting_time, zone_size, rho, par)       burn fraction prescribed at `time`, never below `burn_fraction`
    short_advance(burn_fraction, dt, rho, p, temperature, par)               (`advance`, True), or (any number, False) where a packed loop
                                                                             cannot do all of it (only laws that are subcycled)

burn_fraction in [0, 1] is the mass fraction of products; rho kg/m3, p Pa (the mixture's pressure; artificial viscosity added where the
model's authors do so), temperature K (only laws flagged "temperature_driven" receive one, others 0), lighting_time s when the programmed
front reaches the zone's nearer face, zone_size m its width at t = 0. A solver calls `scheduled`, then `advance`, for every law: the
one that does not apply returns the burn fraction unchanged, at no cost in a kernel.

`advance` is exact at constant state where the rate equation has a closed-form solution, and otherwise sub-cycled under error control
("subcycled"). It returns exactly 1 if burning ends in finite time, never leaves [0, 1], and keeps 0 unless the law includes ignition.
The products' equation of state and the mixing are not part of the burn law: see `laws/mixture` and `Reactive`.

Flags: "programmed" (needs lighting times), "pressure_driven", "compression_driven", "temperature_driven", "instantaneous", "subcycled".
"""

from typing import Any, NamedTuple

from hugoniot.core.registry import Registry


def all_advance(burn_fraction, dt, rho, p, temperature, par):
    """`short_advance` of laws whose `advance` has no loop."""
    return advance(burn_fraction, dt, rho, p, temperature, par), True


BURN = Registry("burn", contract=("rate", "advance", "scheduled"), derived={"short_advance": all_advance})


class Reactive(NamedTuple):
    """What `Material.burn` holds: a burn law's and a mixture law's parameters (the mixture holds reactants, products and Q)."""

    rate: Any
    mixture: Any


def keeps_time(par, reactants: bool) -> bool:
    """Whether an explosive burns by a schedule alone: it has no law before it burns (no `reactants`), and no shock ignites it."""
    return not reactants and "compression_driven" not in BURN.of(par).flags


def rate(burn_fraction, rho, p, temperature, par):
    """Rate of burning, 1/s."""
    return BURN.of(par).functions["rate"](burn_fraction, rho, p, temperature, par)


def advance(burn_fraction, dt, rho, p, temperature, par):
    """Burn fraction after dt at constant state."""
    return BURN.of(par).functions["advance"](burn_fraction, dt, rho, p, temperature, par)


def short_advance(burn_fraction, dt, rho, p, temperature, par):
    """(burn fraction after dt at constant state, whether it is that): False where all of `advance` is needed."""
    return BURN.of(par).functions["short_advance"](burn_fraction, dt, rho, p, temperature, par)


def scheduled(burn_fraction, time, lighting_time, zone_size, rho, par):
    """Burn fraction a schedule prescribes, or the given one."""
    return BURN.of(par).functions["scheduled"](burn_fraction, time, lighting_time, zone_size, rho, par)


GENERICS = {"rate": rate, "advance": advance, "short_advance": short_advance, "scheduled": scheduled}


# -- for laws without a rate or without a schedule ---------------------------------------------------------------
def no_rate(burn_fraction, rho, p, temperature, par):
    """Laws that burn by schedule, or at once, have no rate a time step could resolve."""
    return 0.0


def no_advance(burn_fraction, dt, rho, p, temperature, par):
    """Nothing burns between schedules."""
    return burn_fraction


def no_schedule(burn_fraction, time, lighting_time, zone_size, rho, par):
    """Nothing is prescribed."""
    return burn_fraction
