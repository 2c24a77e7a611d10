"""What follows from a material's constants: sound speeds, elastic limit, Chapman-Jouguet state, points of its Hugoniots."""

import math
from functools import cache
from typing import Any, NamedTuple

from hugoniot.errors import HugoniotError, NoSolution
from hugoniot.laws.eos.contract import (
    EOS,
    gruneisen,
    has_temperature,
    pressure,
    reference_state,
    sound_speed_squared,
    temperature,
    temperature_at_rest,
)
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.materials import schema
from hugoniot.materials.marks import Closure, misfits
from hugoniot.materials.material import Material
from hugoniot.materials.schema import Row
from hugoniot.theory.chapman_jouguet import cj, on_isentrope
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.upstream import Initial


class Quantity(NamedTuple):
    """A derived number: SI value, unit, and the formula in words."""

    value: float
    unit: str
    meaning: str

    def plain(self) -> "Quantity":
        return self._replace(value=float(self.value))


def derived_quantities(material: Material, unreacted: Any = None) -> dict[str, Quantity]:
    """Sound speeds, elastic moduli and limit at rest; the CJ state of an explosive's products."""
    return {name: quantity.plain() for name, quantity in _derived(material, unreacted).items()}


def _derived(material: Material, unreacted: Any) -> dict[str, Quantity]:
    found: dict[str, Quantity] = {}
    law = EOS.of(material.eos)
    if "reacted" in law.flags:
        point = cj(material.eos)
        state = point.state
        found["cj_velocity"] = Quantity(point.detonation_velocity, "m/s", "from the equation of state of the products")
        found["cj_pressure"] = Quantity(state.pressure, "Pa", "from the equation of state of the products")
        found["cj_particle_velocity"] = Quantity(state.particle_velocity, "m/s", "relative to the unreacted explosive")
        found["cj_density"] = Quantity(state.density, "kg/m^3", "of the products")
        found["cj_exponent"] = Quantity(point.adiabatic_exponent, "1", "rho c^2/p of the products")
        if unreacted is not None:
            rho, e = reference_state(unreacted)
            found["unreacted_sound_speed"] = Quantity(math.sqrt(sound_speed_squared(rho, e, unreacted)), "m/s",
                                                      "at the reference density of the unreacted explosive")
        return found
    rho, e = reference_state(material.eos)
    c2 = sound_speed_squared(rho, e, material.eos)
    bulk = rho * c2
    found["bulk_sound_speed"] = Quantity(math.sqrt(c2), "m/s", "from the equation of state")
    found["bulk_modulus"] = Quantity(bulk, "Pa", "rho c^2, c the bulk sound speed")
    found["gruneisen"] = Quantity(gruneisen(rho, e, material.eos), "1", "from the equation of state")
    if material.strength is not None and "fluid" not in STRENGTH.of(material.strength).flags:
        found |= _elastic(material, rho, e, bulk)
    return found


def _elastic(material: Material, rho: float, e: float, bulk: float) -> dict[str, Quantity]:
    warm, p = temperature_at_rest(material.eos), pressure(rho, e, material.eos)
    g = shear_modulus(rho, p, warm, bulk, material.strength)
    y = flow_stress(rho, p, warm, 0.0, 1.0, material.strength)
    found = {"shear_modulus": Quantity(g, "Pa", "from the strength law"),
             "yield_stress": Quantity(y, "Pa", f"from the strength law{_first_yield(material.strength)}")}
    if g > 0.0:
        longitudinal = math.sqrt((bulk + 4.0 / 3.0 * g) / rho)
        found["longitudinal_sound_speed"] = Quantity(longitudinal, "m/s", "sqrt((K + 4G/3)/rho)")
        found["poisson_ratio"] = Quantity((3.0 * bulk - 2.0 * g) / (2.0 * (3.0 * bulk + g)), "1", "(3K - 2G)/(6K + 2G)")
        limit = 0.5 * y * (bulk / g + 4.0 / 3.0)
        found["hugoniot_elastic_limit"] = Quantity(limit, "Pa", "Y (K/G + 4/3)/2 (Herrmann, WL-TR-64-107)")
        found["hel_particle_velocity"] = Quantity(limit / (rho * longitudinal), "m/s", "HEL/(rho c_L), c_L the longitudinal sound speed")
    return found


def _first_yield(strength: Any) -> str:
    """At which plastic strain and strain rate the yield stress is given, as far as the law depends on them."""
    flags = STRENGTH.of(strength).flags
    strain = "zero plastic strain" if "hardens" in flags else ""
    if getattr(strength, "initial_strain", 0.0) > 0.0:
        strain = "zero plastic strain beyond the initial strain"
    rate = "a strain rate of 1 per second" if "needs_rate" in flags else ""
    at = " and ".join(t for t in (strain, rate) if t)
    return f", at {at}" if at else ""


def wave_speeds(material: Material, rho: float, e: float) -> dict[str, float]:
    """Speeds of waves into the state (rho kg/m3, e J/kg), m/s, as far as the laws give them.

    bulk_sound_speed, longitudinal_sound_speed (of a solid with strength), and hugoniot_slope: the secant (Us - c)/up of the Hugoniot from
    that state, up to a particle velocity of a tenth of c
    """
    c = math.sqrt(sound_speed_squared(rho, e, material.eos))
    found = {"bulk_sound_speed": c}
    p = float(pressure(rho, e, material.eos))
    if material.strength is not None and "fluid" not in STRENGTH.of(material.strength).flags:
        warm = float(temperature(rho, e, material.eos)) if has_temperature(material.eos) else temperature_at_rest(material.eos)
        shear = shear_modulus(rho, p, warm, rho * c * c, material.strength)
        if shear > 0.0:
            found["longitudinal_sound_speed"] = math.sqrt(c * c + 4.0 / 3.0 * shear / rho)
    try:
        behind = shock(material.eos, Initial(rho, p, e), particle_velocity=0.1 * c, once=True)
    except HugoniotError:
        return found
    return found | {"hugoniot_slope": (float(behind.shock_velocity) - c) / (0.1 * c)}


# -- Chapman-Jouguet states of rows ------------------------------------------------------------------------------
@cache
def closure(identity: str) -> Closure | None:
    """CJ closure of a products row of the table jwl, computed; None where the row gives no energy to close with."""
    row = schema.row(identity)
    if "c" in row:
        found = on_isentrope(isentrope_of(row), row["rho0"])
        return misfits(row, found.detonation_velocity, found.pressure)
    if "e0" not in row:
        return None
    point = cj(JWL(row["a"], row["b"], row["r1"], row["r2"], row["omega"], row["rho0"], row["e0"]))
    return misfits(row, point.detonation_velocity, point.state.pressure)


def isentrope_of(row: Row) -> JWLIsentrope:
    """The principal isentrope of a row of the table jwl with C, or of the table jwlb."""
    pairs = (("a", "r1"), ("b", "r2")) if row.table == "jwl" else tuple((f"a{i}", f"r{i}") for i in range(1, 5))
    return JWLIsentrope(tuple((row[a], row[r]) for a, r in pairs), row["c"], row["omega"])


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
            raise NoSolution(f"no shock with particle velocity {up:g} m/s: the fitted Hugoniot ends at particle velocity "
                             f"{particle(low):.6g} m/s (up/Us = {low:.3f})")
        if particle(high) >= up:
            break
        low = high
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if particle(middle) >= up else (middle, high)
    return up / high


def material_hugoniot(material: Material, up: float) -> float:
    """Us of the principal Hugoniot from a material's equation of state, m/s."""
    return float(shock(material, particle_velocity=up).shock_velocity)
