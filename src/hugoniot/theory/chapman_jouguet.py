r"""Chapman-Jouguet state of any law, by tangency of the Rayleigh line; detonation Hugoniot and overdriven states.

In the CJ state the products leave the front at their own sound speed $c$. With the specific volume $v = 1/\rho$, the index 0 for the state
ahead and $x = v_0 - v$, this is the point of the detonation Hugoniot at which

$$F(x) = \rho^2 c^2\,x - (p - p_0) = 0, \qquad D = v_0\sqrt{(p - p_0)/x}$$

Here the Rayleigh line is tangent to the detonation Hugoniot, and the detonation velocity $D$ has its minimum. The condition holds for any
equation of state; no gamma-law formula is used. The energy of the state ahead includes the chemical energy (JWL), or the chemical energy
is given with this state as `heat`.

Implementation: F is negative near constant volume and changes sign once; a scan brackets the sign change, which is then refined.

Source: KB codes manual, section 4, with K-E4 corrected; Starkenberg, ARL-TR-2161, A-5.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope
from hugoniot.theory import jump
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.states import States, law_of, rest_of
from hugoniot.theory.upstream import Initial, interval

NO_CHARGE = 1e-3     # of the stiffness: less pressure at constant volume is round-off of an energy at rest


@dataclass(frozen=True)
class Detonation:
    """The CJ point.

    state      the CJ state; its shock_velocity is the detonation velocity
    initial    the state ahead
    tangency   relative residual of the condition F = 0
    """

    state: States
    initial: Initial
    tangency: float

    @property
    def detonation_velocity(self) -> float:
        """Detonation velocity relative to the explosive ahead, m/s."""
        return self.state.shock_velocity - self.initial.velocity

    @property
    def adiabatic_exponent(self) -> float:
        """gamma = rho c^2 / p of the products at the CJ point."""
        return self.state.adiabatic_exponent

    def table(self) -> dict:
        """The state under the field's words, with detonation_velocity and adiabatic_exponent."""
        return {**self.state.table(), "detonation_velocity": self.detonation_velocity, "adiabatic_exponent": self.adiabatic_exponent}


def explosive(material, density: float | None = None, heat: float = 0.0) -> Initial:
    """The state ahead of a detonation, an `Initial`: unreacted explosive at zero pressure, with the reference density and energy that the
    equation of state of the products gives, or with the `detonation_energy` of a `Material` that states one.

    density   density of the charge, kg/m3; default: the reference density
    heat      chemical energy, J/kg, added to the reference energy; needed for equations of state that do not contain it, such as a gas
    """
    par = law_of(material)
    rho0, e0 = rest_of(material)
    gas_at_rest = "reacted" not in EOS.of(par).flags and getattr(material, "detonation_energy", None) is None
    p0 = float(contract.pressure(rho0, e0, par)) if gas_at_rest else 0.0
    if density is not None and not density > 0.0:
        raise OutOfRange(f"an explosive of {density:.6g} kg/m3 is not a valid state: give a positive density")
    return Initial(density or rho0, p0, e0, heat=heat)


def cj(material, initial: Initial | None = None) -> Detonation:
    """The Chapman-Jouguet state of detonation products.

    material   the products
    initial    state ahead, with its heat; default: `explosive(material)`

    Raises OutOfRange if no energy is released, NoSolution if the condition F = 0 is not met to a relative residual of 1e-10.
    """
    par = law_of(material)
    ahead = initial or explosive(material)
    v0, least, most = interval(par, ahead)
    _refuse_unreacted(par, ahead)
    with np.errstate(all="ignore"):
        x = _tangency(par, ahead, v0, max(least, 1e-4 * v0), most)
        _, p, _ = _slack(x, par, ahead, v0)
    e = ahead.energy + ahead.heat + 0.5 * (p + ahead.pressure) * x
    rho = 1.0 / (v0 - x)
    u, d = math.sqrt((p - ahead.pressure) * x), v0 * math.sqrt((p - ahead.pressure) / x)
    state = States(par, rho, p, e, ahead.velocity + u, ahead.velocity + d)
    tangency = abs(rho * rho * contract.sound_speed_squared(rho, e, par) * x / (p - ahead.pressure) - 1.0)
    if not tangency < 1e-10:
        raise NoSolution(f"the Rayleigh line is tangent only to within {tangency:.2g} (law '{EOS.of(par).name}'): "
                         "the law is not smooth near its CJ point")
    return Detonation(state, ahead, tangency)


def _refuse_unreacted(par, ahead: Initial) -> None:
    """Raise `OutOfRange` where a law of products holds no pressure at the explosive's own density and energy: then it is the explosive's.

    Sets of unreacted explosives have the form of products (JWL) and about zero pressure at rest; the tangency would answer with an
    acoustic wave.
    """
    if ahead.heat != 0.0 or "reacted" not in EOS.of(par).flags:
        return
    held = float(contract.pressure(ahead.density, ahead.energy, par)) - ahead.pressure
    stiffness = ahead.density * float(contract.sound_speed_squared(ahead.density, ahead.energy, par))
    if abs(held) < NO_CHARGE * stiffness:
        raise OutOfRange(f"law '{EOS.of(par).name}' is that of an unreacted explosive: at its density and energy the pressure is only "
                         f"{held:.3g} Pa, so no energy is released; use the explosive's products")


def overdriven(material, initial: Initial | None = None, *, branch: str = "strong", **given) -> States:
    """States on the detonation Hugoniot.

    initial   state ahead, as in `cj`
    branch    if the front velocity is given, which of the two states: strong (overdriven) or weak (supersonic products)
    given     one of pressure (Pa), particle_velocity (m/s), density (kg/m3), shock_velocity (m/s, of the front): a number or an array
    """
    par = law_of(material)
    ahead = initial or explosive(material)
    if "shock_velocity" not in given:
        return shock(par, ahead, **given)
    point = cj(par, ahead)
    speed = np.asarray(given["shock_velocity"], float) - ahead.velocity
    if (speed < point.detonation_velocity * (1.0 - 1e-12)).any():
        raise OutOfRange(f"a front of {speed.min():.6g} m/s is slower than the Chapman-Jouguet velocity "
                         f"{point.detonation_velocity:.6g} m/s: no steady detonation")
    x_cj = 1.0 / ahead.density - 1.0 / point.state.density
    v0, least, most = interval(par, ahead)
    found = []
    for target in np.atleast_1d(speed).ravel() * ahead.density:
        if target <= point.detonation_velocity * ahead.density * (1.0 + 1e-12):
            found.append(x_cj)
            continue
        e0 = ahead.energy + ahead.heat
        low, high = x_cj, x_cj
        if branch == "strong":
            status, low, high = jump.bracket(jump.BY_SHOCK_VELOCITY, target, x_cj, least, most, v0, ahead.pressure, e0, par)
            status, x = jump.polish(jump.BY_SHOCK_VELOCITY, target, low, high, v0, ahead.pressure, e0, par)
        else:
            x = _weak(target, x_cj, v0, ahead.pressure, e0, par)
        found.append(x)
    x = np.reshape(found, np.shape(speed)) if np.ndim(speed) else found[0]
    return shock(par, ahead, density=1.0 / (v0 - x))


def detonation_hugoniot(material, initial: Initial | None = None, *, points: int = 101, up_to: float | None = None,
                        once: bool = False) -> States:
    """The Hugoniot with complete reaction: weak detonations from near constant volume, the CJ point, and overdriven detonations.

    points   number of states, evenly spaced in particle velocity
    up_to    highest particle velocity, m/s; default: 1.4 times that of the CJ point
    once     True skips the compilation, as in `hugoniot.theory.hugoniot.shock`
    """
    par = law_of(material)
    ahead = initial or explosive(material)
    if up_to is None:
        up_to = 1.4 * (cj(par, ahead).state.particle_velocity - ahead.velocity)
    return shock(par, ahead, once=once, particle_velocity=ahead.velocity + np.linspace(0.05 * up_to, up_to, points))


class Tangency(NamedTuple):
    """The CJ point of an isentrope: energy (E0, J per m3 of explosive), detonation_velocity (m/s), pressure (Pa), relative volume."""

    energy: float
    detonation_velocity: float
    pressure: float
    volume: float


def on_isentrope(isentrope: JWLIsentrope, rho0: float) -> Tangency:
    """The CJ point on a JWL isentrope of the products, and the chemical energy E0 that follows from it.

    isentrope   parameters of the isentrope
    rho0        reference density of the explosive, kg/m3

    At this point the isentrope is tangent to the Rayleigh line through the relative volume V = 1 and zero pressure, -dp/dV = p/(1 - V).
    Raises NoSolution if there is no such point.
    """
    from scipy.optimize import brentq

    def excess(v: float) -> float:
        return isentrope.steepness(v) - isentrope.pressure(v) / (1.0 - v)

    low, high = 0.55, 0.95
    if not excess(low) > 0.0 > excess(high):
        raise NoSolution("no CJ state: the isentrope is nowhere tangent to a Rayleigh line between V = v/v0 = 0.55 and 0.95")
    v = brentq(excess, low, high, xtol=1e-15, rtol=1e-14)
    p = float(isentrope.pressure(v))
    return Tangency(float(isentrope.energy(v)) - 0.5 * p * (1.0 - v), math.sqrt(p / (rho0 * (1.0 - v))), p, v)


def _weak(flux, x_cj, v0, p0, e0, par):
    """x on the weak branch, between constant volume and the CJ point: the misfit falls through zero there."""
    low, high = 1e-12 * v0, x_cj
    for _ in range(200):
        x = 0.5 * (low + high)
        g, _ = jump.misfit(jump.BY_SHOCK_VELOCITY, flux, x, v0, p0, e0, par)
        low, high = (x, high) if g > 0.0 else (low, x)
        if high - low < 1e-16 * v0:
            break
    return 0.5 * (low + high)


def _slack(x, par, ahead: Initial, v0):
    """(F, p, ok) on the detonation Hugoniot at x."""
    rho = 1.0 / (v0 - x)
    e0 = ahead.energy + ahead.heat
    status, p = jump.pressure_at(x, rho, ahead.pressure, e0, contract.pressure(rho, e0 + ahead.pressure * x, par), par)
    e = e0 + 0.5 * (p + ahead.pressure) * x
    return rho * rho * contract.sound_speed_squared(rho, e, par) * x - (p - ahead.pressure), p, status == jump.FOUND and p > ahead.pressure


def _tangency(par, ahead, v0, least, most):
    """x of the CJ point: scan for the change of sign, then secants kept in the bracket (Illinois)."""
    low, f_low, high, f_high = None, 0.0, None, 0.0
    for x in least + (most - least) * np.linspace(0.0, 1.0, 121)[1:-1] ** 1.5:
        f, _, ok = _slack(float(x), par, ahead, v0)
        if not (ok and math.isfinite(f)):
            if low is None:
                continue
            break
        if f < 0.0:
            low, f_low = float(x), f
        elif low is not None:
            high, f_high = float(x), f
            break
    if low is None or high is None:
        raise OutOfRange(f"law '{EOS.of(par).name}' has no Chapman-Jouguet point for an initial density of {ahead.density:.6g} kg/m3: "
                         f"with an upstream energy of {ahead.energy:.6g} J/kg and a heat of {ahead.heat:.6g} J/kg no energy is released; "
                         "give the products of an explosive, or the heat of reaction (--heat)")
    side = 0
    for _ in range(200):
        x = (low * f_high - high * f_low) / (f_high - f_low)
        if not low < x < high:
            x = 0.5 * (low + high)
        f, _, _ = _slack(x, par, ahead, v0)
        if f == 0.0 or high - low <= 4e-16 * high:
            break
        if f < 0.0:
            low, f_low, f_high, side = x, f, (0.5 * f_high if side < 0 else f_high), -1
        else:
            high, f_high, f_low, side = x, f, (0.5 * f_low if side > 0 else f_low), 1
    return x
