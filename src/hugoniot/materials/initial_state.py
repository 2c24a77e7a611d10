"""The (density, energy) at which a region starts, from whatever two of density, pressure, temperature and energy are given."""

import math

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import (
    EOS,
    density_limits,
    gives,
    has_temperature,
    pressure,
    pressure_derivatives,
    reference_state,
    temperature,
)
from hugoniot.units import format_si

_STEPS = 200
ENDLESS = 1e12   # J/kg/K: with it the temperature is that of the cold isentrope, and a little less for less energy
COLD = 1e-12     # of a pressure that does not depend on the energy: what counts as the same


def _bracketed(function, low, high, what):
    """Root of a function that changes sign between low and high, by bisection safeguarded secant steps, to round-off."""
    f_low, f_high = function(low), function(high)
    if f_low == 0.0:
        return low
    if not (math.isfinite(f_low) and math.isfinite(f_high)) or f_low * f_high > 0.0:
        raise OutOfRange(f"no state with {what}: the equation of state does not reach it")
    for _ in range(_STEPS):
        guess = high - f_high * (high - low) / (f_high - f_low)
        inside = min(low, high) + 0.01 * abs(high - low) < guess < max(low, high) - 0.01 * abs(high - low)
        x = guess if inside else 0.5 * (low + high)
        f = function(x)
        if f * f_low <= 0.0:
            high, f_high = x, f
        else:
            low, f_low = x, f
        if f == 0.0 or abs(high - low) <= 1e-16 * max(abs(low), abs(high)):
            break
    return high if abs(f_high) <= abs(f_low) else low


def energy_at_pressure(rho, p, eos):
    """e with pressure(rho, e) = p: the law's own inverse, else Newton (one step for laws linear in the energy), else in a bracket.

    A law that searches for its pressure (pores) answers with an error of its own; where steps no longer shrink, that is reached.
    """
    law = EOS.of(eos)
    rest = reference_state(eos)[1]
    if "linear_in_energy" in law.flags and pressure_derivatives(rho, rest, eos)[1] == 0.0:
        cold = pressure(rho, rest, eos)
        if abs(p - cold) <= COLD * (abs(p) + abs(cold)):
            return rest      # the pressure of that density, whatever the energy
        raise OutOfRange(f"'{law.name}' gives a pressure that does not depend on the energy: density and pressure do not determine the "
                         "energy; give the density and the energy")
    if "energy" in law.functions:
        return law.functions["energy"](rho, p, eos)
    e, last = rest, math.inf
    for _ in range(60):
        miss, slope = p - pressure(rho, e, eos), pressure_derivatives(rho, e, eos)[1]
        if miss == 0.0:
            return e
        if not slope > 0.0:
            break
        change = abs(miss / slope)
        e += miss / slope
        if change <= 1e-15 * (abs(e) + change) or (change >= 0.5 * last and change <= 1e-11 * (abs(e) + abs(p) / rho)):
            return e
        last = change
    return _energy_between(rho, p, eos)


def _energy_between(rho, p, eos):
    """The same in an interval about the reference energy, doubled until the pressure is enclosed."""
    centre = reference_state(eos)[1]
    width = max(abs(centre), abs(p) / rho, 1e3)
    while width < 1e13:
        low, high = centre - width, centre + width
        if pressure(rho, low, eos) <= p <= pressure(rho, high, eos):
            return _bracketed(lambda e: pressure(rho, e, eos) - p, low, high, f"{p:g} Pa at {rho:g} kg/m3")
        width *= 2.0
    raise OutOfRange(f"no energy gives {p:g} Pa at {rho:g} kg/m3 in the law '{EOS.of(eos).name}'")


def energy_at_temperature(rho, t, eos):
    """e with temperature(rho, e) = t."""
    law = EOS.of(eos)
    if "temperature" not in law.functions:
        raise OutOfRange(f"the equation of state '{law.name}' has no temperature; give density, pressure or energy instead")
    e = reference_state(eos)[1]
    now = temperature(rho, e, eos)
    if not math.isfinite(now):
        raise OutOfRange(f"the equation of state '{law.name}' needs a specific_heat before a temperature can be set")
    last = math.inf
    for _ in range(60):
        step = 1e-6 * (abs(e) + 1e3)
        slope = (temperature(rho, e + step, eos) - now) / step
        if slope == 0.0:
            break
        change = (t - now) / slope
        e += change
        now = temperature(rho, e, eos)
        # near 0 K the round-off of the energy is more than any part of t: there the steps no longer shrink
        if abs(now - t) <= 1e-13 * abs(t) or (abs(change) >= 0.5 * last and abs(change) <= 1e-12 * (abs(e) + 1e3)):
            return e
        last = abs(change)
    raise OutOfRange(f"no energy gives {t:g} K at {rho:g} kg/m3 in the law '{law.name}'")


def _tried(function, rho) -> float:
    """The function at a trial density, not a number where the law has no such state: the search passes it by."""
    try:
        return function(rho)
    except OutOfRange:
        return math.nan


def _trials(rho0, gas: bool):
    """Densities at which a search looks, outward from the one at rest; a gas has states at any density, thin ones first."""
    for factor in (1.0 + 0.02 * k for k in range(1, 400)):
        yield from (rho0 * factor, rho0 / factor)
    if gas:
        yield from (rho0 / 9.0 / 1.5**k for k in range(60))
        yield from (rho0 * 9.0 * 1.5**k for k in range(60))


def _density(function, eos, what):
    """Density at which `function(rho)` vanishes, searched outward from the reference density."""
    rho0 = reference_state(eos)[0]
    low, high = density_limits(eos)
    start, value = rho0, function(rho0)
    if value == 0.0:
        return rho0
    for rho in _trials(rho0, "gas" in EOS.of(eos).flags):
        if low < rho < high and math.isfinite(found := _tried(function, rho)) and found * value <= 0.0:
            return _bracketed(function, start, rho, what)
    raise OutOfRange(f"no state with {what}: the equation of state does not reach it")


def initial_state(eos, density=None, pressure_=None, temperature_=None, energy=None) -> tuple[float, float]:
    """(rho, e) from at most two given quantities (SI); none: the law's reference state. OutOfRange where no material can be in it.

    One alone goes with the reference density, and a density alone with zero pressure (with the reference temperature for a gas).
    """
    rho, e = _state(eos, density, pressure_, temperature_, energy)
    alone = density is not None and pressure_ is None and energy is None
    refuse_below_zero(rho, e, eos, "; give the density and a temperature, from which the pressure follows" if alone else "")
    return rho, e


def refuse_below_zero(rho, e, eos, remedy: str = "") -> None:
    """OutOfRange for a state whose temperature would be negative; of products without a known specific heat, whatever it were."""
    known = has_temperature(eos)
    if not known:
        if not ("reacted" in EOS.of(eos).flags and gives(eos, "temperature") and "specific_heat" in eos._fields):
            return
        eos = eos._replace(specific_heat=ENDLESS)
    warm = float(temperature(rho, e, eos))
    if warm < 0.0:
        where = f"at {warm:.4g} K, below absolute zero" if known else "below absolute zero, whatever its specific heat"
        raise OutOfRange(f"{rho:.6g} kg/m3 and {format_si(float(pressure(rho, e, eos)), 'Pa', 4)} would be a state {where}{remedy}")


def _state(eos, density, pressure_, temperature_, energy) -> tuple[float, float]:
    """The same, whatever its temperature."""
    rho0, e0 = reference_state(eos)
    given = sum(x is not None for x in (density, pressure_, temperature_, energy))
    if given > 2:
        raise OutOfRange("more than two of density, pressure, temperature and energy are given; give at most two")
    for name, value, unit in (("density", density, "kg/m3"), ("temperature", temperature_, "K")):
        if value is not None and not 0.0 < value < math.inf:
            raise OutOfRange(f"a {name} of {value:g} {unit} is not a valid state: give a positive value")
    if given == 0:
        return rho0, e0
    if density is None and given == 1:
        density = rho0
    if density is not None:
        if energy is not None:
            return density, energy
        if pressure_ is not None:
            return density, energy_at_pressure(density, pressure_, eos)
        if temperature_ is not None:
            return density, energy_at_temperature(density, temperature_, eos)
        return density, (e0 if "gas" in EOS.of(eos).flags else energy_at_pressure(density, 0.0, eos))
    if energy is not None and pressure_ is not None:
        return _density(lambda r: pressure(r, energy, eos) - pressure_, eos, f"{pressure_:g} Pa and {energy:g} J/kg"), energy
    if energy is not None:
        if "temperature" not in EOS.of(eos).functions:
            raise OutOfRange(f"the equation of state '{EOS.of(eos).name}' has no temperature; give density or pressure instead")
        return _density(lambda r: temperature(r, energy, eos) - temperature_, eos, f"{temperature_:g} K and {energy:g} J/kg"), energy
    rho = _density(lambda r: pressure(r, energy_at_temperature(r, temperature_, eos), eos) - pressure_, eos,
                   f"{pressure_:g} Pa and {temperature_:g} K")
    return rho, energy_at_temperature(rho, temperature_, eos)
