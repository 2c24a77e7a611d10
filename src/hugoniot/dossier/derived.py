"""What follows from a material's constants: sound speeds, elastic limit, Chapman-Jouguet state, points of its Hugoniots.

Small and scalar on purpose: the library checks itself with it and `material show` answers at once. The tools of `theory` solve the
same problems for any state and any law; they share no code with this file, so one can be tested against the other.
"""

import math
from typing import Any, NamedTuple

from hugoniot.errors import NoSolution
from hugoniot.laws.eos.contract import (
    EOS,
    gruneisen,
    pressure,
    pressure_derivatives,
    reference_state,
    sound_speed_squared,
    temperature_at_rest,
)
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.materials.material import Material
from hugoniot.materials.schema import Row


class Quantity(NamedTuple):
    """A derived number: SI value, unit, and the formula in words."""

    value: float
    unit: str
    meaning: str

    def plain(self) -> "Quantity":
        return self._replace(value=float(self.value))


class ChapmanJouguet(NamedTuple):
    """CJ state: velocity m/s, pressure Pa, particle velocity m/s, density kg/m3, adiabatic exponent."""

    velocity: float
    pressure: float
    particle_velocity: float
    density: float
    exponent: float


def derived_quantities(material: Material, unreacted: Any = None) -> dict[str, Quantity]:
    """Sound speeds, elastic moduli and limit at rest; the CJ state of an explosive's products."""
    return {name: quantity.plain() for name, quantity in _derived(material, unreacted).items()}


def _derived(material: Material, unreacted: Any) -> dict[str, Quantity]:
    found: dict[str, Quantity] = {}
    law = EOS.of(material.eos)
    if "reacted" in law.flags:
        state = chapman_jouguet(material.eos)
        found["cj_velocity"] = Quantity(state.velocity, "m/s", "Chapman-Jouguet detonation velocity from the equation of state")
        found["cj_pressure"] = Quantity(state.pressure, "Pa", "Chapman-Jouguet pressure")
        found["cj_particle_velocity"] = Quantity(state.particle_velocity, "m/s", "particle velocity at the CJ state")
        found["cj_density"] = Quantity(state.density, "kg/m^3", "density at the CJ state")
        found["cj_exponent"] = Quantity(state.exponent, "1", "adiabatic exponent at the CJ state")
        if unreacted is not None:
            rho, e = reference_state(unreacted)
            found["unreacted_sound_speed"] = Quantity(math.sqrt(sound_speed_squared(rho, e, unreacted)), "m/s",
                                                      "bulk sound speed of the unreacted explosive")
        return found
    rho, e = reference_state(material.eos)
    c2 = sound_speed_squared(rho, e, material.eos)
    bulk = rho * c2
    found["bulk_sound_speed"] = Quantity(math.sqrt(c2), "m/s", "sqrt(K/rho) at rest")
    found["bulk_modulus"] = Quantity(bulk, "Pa", "isentropic bulk modulus K at rest")
    found["gruneisen"] = Quantity(gruneisen(rho, e, material.eos), "1", "Grüneisen parameter at rest")
    if material.strength is not None and "fluid" not in STRENGTH.of(material.strength).flags:
        found |= _elastic(material, rho, e, bulk)
    return found


def _elastic(material: Material, rho: float, e: float, bulk: float) -> dict[str, Quantity]:
    warm, p = temperature_at_rest(material.eos), pressure(rho, e, material.eos)
    g = shear_modulus(rho, p, warm, bulk, material.strength)
    y = flow_stress(rho, p, warm, 0.0, 1.0, material.strength)
    found = {"shear_modulus": Quantity(g, "Pa", "shear modulus G at rest"), "yield_stress": Quantity(y, "Pa", "flow stress Y at rest")}
    if g > 0.0:
        longitudinal = math.sqrt((bulk + 4.0 / 3.0 * g) / rho)
        found["longitudinal_sound_speed"] = Quantity(longitudinal, "m/s", "sqrt((K + 4G/3)/rho) at rest")
        found["poisson_ratio"] = Quantity((3.0 * bulk - 2.0 * g) / (2.0 * (3.0 * bulk + g)), "1", "(3K - 2G)/(6K + 2G)")
        limit = 0.5 * y * (bulk / g + 4.0 / 3.0)
        found["hugoniot_elastic_limit"] = Quantity(limit, "Pa", "Y (K/G + 4/3)/2 (Herrmann, WL-TR-64-107)")
        found["hel_particle_velocity"] = Quantity(limit / (rho * longitudinal), "m/s", "HEL/(rho c_L)")
    return found


# -- Chapman-Jouguet ---------------------------------------------------------------------------------------------
def hugoniot_pressure(rho: float, rho0: float, e0: float, par: Any) -> float:
    """Pressure on the Hugoniot from (rho0, e0) at zero pressure, Pa, for a law linear in energy: e = e0 + p (1/rho0 - 1/rho)/2."""
    p_cold, p_e = pressure(rho, 0.0, par), pressure_derivatives(rho, 0.0, par)[1]
    return (p_cold + p_e * e0) / (1.0 - 0.5 * p_e * (1.0 / rho0 - 1.0 / rho))


def chapman_jouguet(par: Any, rho0: float | None = None, e0: float | None = None) -> ChapmanJouguet:
    """Tangency of the Rayleigh line and the products' Hugoniot: rho c = rho0 D, by bisection in density.

    par   products, a law linear in energy; rho0 (kg/m3) and e0 (J/kg) of the explosive default to the law's reference state.
    """
    start = reference_state(par)
    rho0, e0 = start[0] if rho0 is None else rho0, start[1] if e0 is None else e0

    def slope(rho: float) -> float:
        p = hugoniot_pressure(rho, rho0, e0, par)
        e = e0 + 0.5 * p * (1.0 / rho0 - 1.0 / rho)
        return rho * rho * sound_speed_squared(rho, e, par) - p / (1.0 / rho0 - 1.0 / rho)

    low, high = 1.02 * rho0, 1.02 * rho0
    while not slope(high) > 0.0:
        low, high = high, high * 1.02
        if high > 2.5 * rho0:
            raise NoSolution(f"no Chapman-Jouguet state between {1.02 * rho0:.4g} and {2.5 * rho0:.4g} kg/m^3")
    if low == high:
        raise NoSolution(f"the products are stiffer than the Rayleigh line already at {low:.4g} kg/m^3: no Chapman-Jouguet state")
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (low, middle) if slope(middle) > 0.0 else (middle, high)
    p = hugoniot_pressure(high, rho0, e0, par)
    velocity = math.sqrt(p / (1.0 - rho0 / high) / rho0)
    u = p / (rho0 * velocity)
    c2 = sound_speed_squared(high, e0 + 0.5 * p * (1.0 / rho0 - 1.0 / high), par)
    return ChapmanJouguet(float(velocity), float(p), float(u), float(high), float(high * c2 / p))


# -- Us-up rows --------------------------------------------------------------------------------------------------
def shock_velocity(row: Row, up: float) -> float:
    """Us of a row of the table us_up at particle velocity `up`, m/s, in the row's own form."""
    c0, s, form = row["c0"], row["s"], row["form"]
    if form == "linear":
        return c0 + s * up
    if form == "quadratic":
        return c0 + s * up + row["quadratic"] * up * up
    if form == "ulh":
        return c0 + s * up + row["exponential_amplitude"] * up * math.exp(-row["exponential_rate"] * up)
    if form == "steinberg_cubic":
        return _implicit_cubic(c0, s, row["s2"], row["s3"], up)
    raise ValueError(f"row {row.id}: unknown form '{form}'")


def _implicit_cubic(c0: float, s1: float, s2: float, s3: float, up: float) -> float:
    """Us = c0 + s1 up + s2 (up/Us) up + s3 (up/Us)^2 up: the root reached continuously from Us = c0 at up = 0.

    With eta = up/Us it is up = c0 eta/(1 - s1 eta - s2 eta^2 - s3 eta^3); the branch ends where up(eta) has its maximum.
    """
    def particle(eta: float) -> float:
        return c0 * eta / (1.0 - s1 * eta - s2 * eta * eta - s3 * eta ** 3)

    if up <= 0.0:
        return c0
    low, step = 0.0, 1e-3
    while True:
        high = low + step
        if high >= 1.0 or not particle(high) > particle(low) and low > 0.0:
            raise NoSolution(f"no shock of {up:g} m/s on this Hugoniot: its branch ends at a compression of {low:.3f}")
        if particle(high) >= up:
            break
        low = high
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if particle(middle) >= up else (middle, high)
    return up / high


def material_hugoniot(material: Material, up: float) -> float:
    """Us of the principal Hugoniot from a material's equation of state, m/s.

    The jump conditions give p - p0 = up^2/dv and e = e0 + up^2/2 + p0 dv at any density; bisection finds the one on the equation of state.
    """
    par = material.eos
    rho0, e0 = reference_state(par)
    p0 = pressure(rho0, e0, par)

    def excess(rho: float) -> float:
        dv = 1.0 / rho0 - 1.0 / rho
        return (pressure(rho, e0 + 0.5 * up * up + p0 * dv, par) - p0) * dv - up * up

    highest = EOS.of(par).functions["density_limits"](par)[1]
    low, high = rho0, rho0
    while True:
        step = min(high * 1.02, 0.5 * (high + highest))
        if step <= high or step > 12.0 * rho0:
            raise NoSolution(f"no shock of {up:g} m/s: the equation of state ends at {high:.4g} kg/m^3")
        low, high = high, step
        if excess(high) > 0.0:
            break
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if excess(middle) > 0.0 else (middle, high)
    return float(up / (1.0 - rho0 / high))


# -- isentropes of products given by A, B, C or by JWLB ----------------------------------------------------------
def energy_of_tangency(terms: list[tuple[float, float]], c: float, omega: float, rho0: float) -> tuple[float, float, float]:
    """(E0 J/m3, D m/s, p_CJ Pa) of p = sum A_i exp(-R_i V) + C V^-(1+omega) by tangency of the Rayleigh line through V = 1, p = 0."""
    def p(v: float) -> float:
        return sum(a * math.exp(-r * v) for a, r in terms) + c * v ** (-1.0 - omega)

    def excess(v: float) -> float:
        falling = sum(a * r * math.exp(-r * v) for a, r in terms) + c * (1.0 + omega) * v ** (-2.0 - omega)
        return falling - p(v) / (1.0 - v)

    low, high = 0.55, 0.95
    if not excess(low) > 0.0 > excess(high):
        raise NoSolution("no tangency of the isentrope between V = 0.55 and 0.95")
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    energy = sum(a / r * math.exp(-r * high) for a, r in terms) + c / omega * high ** (-omega)
    return energy - 0.5 * p(high) * (1.0 - high), math.sqrt(p(high) / (rho0 * (1.0 - high))), p(high)
