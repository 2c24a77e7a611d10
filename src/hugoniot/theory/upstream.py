"""The state ahead of a shock, and the range of shocks that it allows."""

import math
from dataclasses import dataclass

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory.states import States, density_at, density_range, law_of


@dataclass(frozen=True)
class Initial:
    """The state ahead of a shock.

    density    kg/m3; below the density of the solid for a porous material (its pores are empty, its energy is that of the solid)
    pressure, energy, velocity   Pa, J/kg, m/s
    heat       energy released in the shock, J/kg (a detonation; 0: inert)
    """

    density: float
    pressure: float
    energy: float
    velocity: float = 0.0
    heat: float = 0.0

    @classmethod
    def at_rest(cls, material, density: float | None = None, heat: float = 0.0, velocity: float = 0.0) -> "Initial":
        """The law's reference state; a `density` below the reference density makes it distended material.

        The pressure is the law's at its reference state: zero for a solid, ambient for a gas. A gas has no pores: with a `density`
        it has the reference energy, and the pressure of that state. Raises `OutOfRange` for a solid denser than at rest.
        """
        par = law_of(material)
        rho0, e0 = (float(v) for v in contract.reference_state(par))
        p0 = float(contract.pressure(rho0, e0, par))
        if abs(p0) < 1e-12 * rho0 * abs(contract.sound_speed_squared(rho0, e0, par)):
            p0 = 0.0
        if density is not None and not density > 0.0:
            raise OutOfRange(f"an initial density of {density:.6g} kg/m3 is not a valid state: give a positive density")
        if density is not None and p0 > 0.0 and "gas" in EOS.of(par).flags:
            p0 = float(contract.pressure(float(density), e0, par))
        elif density is not None and density > rho0 * (1.0 + 1e-12):
            raise OutOfRange(f"an initial density of {density:.6g} kg/m3 exceeds the reference density of {rho0:.6g} kg/m3, but pores can "
                             "only lower it: start from the state behind a first shock, or give the law another rho0")
        return cls(rho0 if density is None else float(density), p0, e0, velocity, heat)

    @classmethod
    def of(cls, states: States, index=None) -> "Initial":
        """A computed state as the upstream state of a following shock."""
        s = states if index is None else states[index]
        return cls(float(s.density), float(s.pressure), float(s.specific_internal_energy), float(s.particle_velocity))


def interval(par, ahead: Initial) -> tuple[float, float, float]:
    """(v0, least, most): the specific volume ahead and the range of v0 - v that compression and the law allow."""
    v0 = 1.0 / ahead.density
    low, high = density_range(par)
    if ahead.density >= high:
        raise OutOfRange(f"the initial density {ahead.density:.6g} kg/m3 exceeds the highest that the law allows, {high:.6g} kg/m3")
    # the search never steps on the law's own pole, nor on infinite density
    return v0, max(0.0, v0 - 1.0 / low), min((v0 - 1.0 / high) * (1.0 - 1e-12), v0 * (1.0 - 1e-9))


def sound_speed_ahead(par, ahead: Initial) -> float:
    """The speed of sound ahead, m/s; that of the reference state where the law has none there (distended material)."""
    low, high = density_range(par)
    square = contract.sound_speed_squared(ahead.density, ahead.energy, par) if low <= ahead.density <= high else math.nan
    if not square > 0.0:
        square = contract.sound_speed_squared(*contract.reference_state(par), par)
    return math.sqrt(square) if square > 0.0 else 1.0


def distended(par, ahead: Initial) -> bool:
    """Whether the initial state is distended, not a state of the law: its pores are empty, its pressure and energy those of the solid."""
    low, high = density_range(par)
    if not low < ahead.density < high:
        return True
    rho0, e0 = contract.reference_state(par)
    scale = abs(rho0 * contract.sound_speed_squared(rho0, e0, par)) + abs(ahead.pressure)
    return ahead.heat == 0.0 and contract.pressure(ahead.density, ahead.energy, par) < ahead.pressure - 1e-6 * scale


def crushed(par, ahead: Initial, v0: float) -> float:
    """v0 - v of distended material once its pores are closed, at the pressure and energy ahead: where its Hugoniot starts."""
    return max(0.0, v0 - 1.0 / density_at(par, ahead.pressure, ahead.energy)) if distended(par, ahead) else 0.0


def fastest(par, ahead: Initial) -> float:
    """The particle velocity, m/s, at which the fit of the principal Hugoniot ends (J-E16); inf from other states."""
    rho0, e0 = contract.reference_state(par)
    return contract.particle_velocity_limit(par) if ahead.heat == 0.0 and (ahead.density, ahead.energy) == (rho0, e0) else math.inf
