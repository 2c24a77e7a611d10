"""What an equation of state must provide, and everything that follows from it, derived once for all laws.

A law gives, for one point (rho in kg/m3, e in J/kg) and its parameter tuple:

    pressure(rho, e, par)                 p, Pa
    pressure_derivatives(rho, e, par)     (dp/drho at constant e, dp/de at constant rho)

and, where its theory has them in closed form,

    temperature(rho, e, par)              T, K
    entropy(rho, e, par)                  s, J/(kg K), up to a constant
    energy(rho, p, par)                   e, J/kg (inverse of pressure at constant rho)
    reference_state(par)                  (rho, e) of the reference state: zero (or ambient) pressure
    density_limits(par)                   (lowest, highest) density at which the law is defined
    particle_velocity_limit(par)          largest particle velocity for which the law's Hugoniot fit is valid, m/s
    energy_limits(rho, par)               (lowest, highest) energy at a density at which the law is defined (tables)
    pressure_and_derivatives(rho, e, par) (p, dp/drho, dp/de) at once, for laws that search; all others have it from the first two
    reference_curve(rho, par), hugoniot_curve(eta, par)   for laws built on a curve; reference_curves derives the rest
    reference_isentrope(rho, par)         (e_S, ln phi): one isentrope, and the growth phi of energies beside it, of laws that are linear in
                                          the energy: all isentropes are e_S + constant phi, with d ln phi / d ln rho = Gamma
    smooth_piece(rho, e, way, par)        (parameters, lowest, highest density) of the smooth law that equals this one in the piece entered
                                          by an isentrope through (rho, e) as the density rises (way 1) or falls (-1), and continues
                                          it beyond; lowest = highest where the isentrope leaves the law there
    piece_coordinate(rho, e, piece)       (g, dg/drho at e, dg/de at rho): in the piece between those densities while 0 <= g <= 1

The last two are needed only for laws whose slopes jump in many places (tables); all others are one piece.

A law with a memory (pores that stay crushed) has one history variable, the compaction, which rises from 0 to 1 (all pores closed) and never
falls. It is flagged "remembers" and has four more functions; without them it describes the first loading:

    remembered(compaction, par)           parameters, of the same class, of the law after that history
    unloading(par)                        parameters of its elastic branch: the same history, and no further compaction
    compacted(compaction, rho, e, p, par) the compaction after the state (rho, e, p) has been reached
    elastic_limit(par)                    pressure, Pa, up to which a remembered law is elastic; NO_LIMIT once all pores are closed

Kernels do not check states; `check_state` does, for interactive callers.

The functions below dispatch on the class of `par`, in Python and, through `core.binder`, inside kernels.
"""

import math

from hugoniot.core.ops import NO_LIMIT, vsqrt
from hugoniot.core.registry import Registry
from hugoniot.errors import OutOfRange

LEAST_STIFFNESS = 20.0     # of what is no gas, rho c^2 / p in the reference state


def both_apart(rho, e, par):
    """(p, dp/drho at e, dp/de at rho) from the two functions every law gives."""
    p_rho, p_e = pressure_derivatives(rho, e, par)
    return pressure(rho, e, par), p_rho, p_e


def forgets(compaction, par):
    """Laws without memory are after any history what they were."""
    return par


def always_elastic(par):
    """Laws without memory unload as they load."""
    return par


def nothing_compacts(compaction, rho, e, p, par):
    """Laws without memory have nothing to count."""
    return compaction


def never_crushed(par):
    """Laws without memory are elastic at any pressure."""
    return NO_LIMIT


def one_piece(rho, e, way, par):
    """Laws that do not say where their slopes leap are one piece."""
    return par, 1e-300, NO_LIMIT


def never_left(rho, e, piece):
    """The one piece of a law is never left."""
    return 0.5, 0.0, 0.0


EOS = Registry(
    "eos",
    contract=("pressure", "pressure_derivatives", "reference_state", "density_limits"),
    optional=("temperature", "entropy", "energy", "specific_heat", "particle_velocity_limit", "energy_limits",
              "reference_isentrope", "reference_curve", "hugoniot_curve"),
    derived={"pressure_and_derivatives": both_apart, "remembered": forgets, "unloading": always_elastic, "compacted": nothing_compacts,
             "elastic_limit": never_crushed, "smooth_piece": one_piece, "piece_coordinate": never_left},
)


def pressure(rho, e, par):
    """Pressure, Pa."""
    return EOS.of(par).functions["pressure"](rho, e, par)


def pressure_derivatives(rho, e, par):
    """(dp/drho at constant e, Pa m3/kg; dp/de at constant rho, Pa kg/J)."""
    return EOS.of(par).functions["pressure_derivatives"](rho, e, par)


def pressure_and_derivatives(rho, e, par):
    """(p, dp/drho at constant e, dp/de at constant rho): one search where a law has to search for its pressure."""
    return EOS.of(par).functions["pressure_and_derivatives"](rho, e, par)


def temperature(rho, e, par):
    """Temperature, K, for laws that have one."""
    return EOS.of(par).functions["temperature"](rho, e, par)


def entropy(rho, e, par):
    """Specific entropy, J/(kg K), up to a constant, for laws that have one."""
    return EOS.of(par).functions["entropy"](rho, e, par)


def energy(rho, p, par):
    """Specific internal energy at density and pressure, J/kg, for laws with a closed inverse."""
    return EOS.of(par).functions["energy"](rho, p, par)


def specific_heat(rho, e, par):
    """Specific heat at constant volume, J/(kg K), for laws with a temperature."""
    return EOS.of(par).functions["specific_heat"](rho, e, par)


def reference_state(par):
    """(rho, e) of the reference state."""
    return EOS.of(par).functions["reference_state"](par)


def density_limits(par):
    """(lowest, highest) density at which the law is defined, kg/m3."""
    return EOS.of(par).functions["density_limits"](par)


def reference_isentrope(rho, par):
    """(e_S, J/kg; ln phi) of laws whose isentropes are known in closed form."""
    return EOS.of(par).functions["reference_isentrope"](rho, par)


def reference_curve(rho, par):
    """(P, E, dP/deta, dE/deta) of a law's reference curve, P = p/rho0 (reference_curves)."""
    return EOS.of(par).functions["reference_curve"](rho, par)


def hugoniot_curve(eta, par):
    """(P, dP/deta) of a law's Hugoniot in compression, P = p/rho0 (reference_curves)."""
    return EOS.of(par).functions["hugoniot_curve"](eta, par)


# -- laws made of many smooth pieces ------------------------------------------------------------------------------
def smooth_piece(rho, e, way, par):
    """(parameters, lowest density, highest density) of the smooth piece an isentrope through (rho, e) enters."""
    return EOS.of(par).functions["smooth_piece"](rho, e, way, par)


def piece_coordinate(rho, e, piece):
    """(g, dg/drho at e, dg/de at rho), 0 <= g <= 1 inside the piece."""
    return EOS.of(piece).functions["piece_coordinate"](rho, e, piece)


# -- laws with a memory ------------------------------------------------------------------------------------------
def remembered(compaction, par):
    """Parameters of the law after a history of that compaction; the same ones for laws without memory."""
    return EOS.of(par).functions["remembered"](compaction, par)


def unloading(par):
    """Parameters of the elastic branch of a remembered law, on which nothing is compacted further."""
    return EOS.of(par).functions["unloading"](par)


def compacted(compaction, rho, e, p, par):
    """The compaction (0 to 1, never falling) after the state (rho, e, p); `par` are the parameters of the first loading."""
    return EOS.of(par).functions["compacted"](compaction, rho, e, p, par)


def elastic_limit(par):
    """Pressure up to which a remembered law is elastic, Pa: beyond it pores go on closing; NO_LIMIT where none are left."""
    return EOS.of(par).functions["elastic_limit"](par)


GENERICS = {
    "pressure": pressure, "pressure_derivatives": pressure_derivatives, "pressure_and_derivatives": pressure_and_derivatives,
    "temperature": temperature,
    "entropy": entropy, "energy": energy, "specific_heat": specific_heat, "reference_state": reference_state,
    "reference_isentrope": reference_isentrope, "reference_curve": reference_curve, "hugoniot_curve": hugoniot_curve,
    "remembered": remembered, "unloading": unloading, "compacted": compacted, "elastic_limit": elastic_limit,
    "smooth_piece": smooth_piece, "piece_coordinate": piece_coordinate,
}


# -- derived once for all laws -----------------------------------------------------------------------------------
def sound_speed_squared(rho, e, par):
    """c^2 = dp/drho|_e + p dp/de|_rho / rho^2, m2/s2 (negative where the state is unstable)."""
    p, p_rho, p_e = pressure_and_derivatives(rho, e, par)
    return p_rho + p * p_e / (rho * rho)


def sound_speed(rho, e, par):
    """Bulk (hydrodynamic) sound speed, m/s."""
    return vsqrt(sound_speed_squared(rho, e, par))


def gruneisen(rho, e, par):
    """Grüneisen parameter Gamma = (dp/de at constant rho) / rho."""
    return pressure_derivatives(rho, e, par)[1] / rho


def bulk_modulus(rho, e, par):
    """Isentropic bulk modulus K_S = rho c^2, Pa."""
    return rho * sound_speed_squared(rho, e, par)


def adiabatic_exponent(rho, e, par):
    """gamma = -(d ln p / d ln v) along the isentrope = rho c^2 / p."""
    return bulk_modulus(rho, e, par) / pressure(rho, e, par)


# -- at the surface: clear answers for what a law cannot do ----------------------------------------------------------
def particle_velocity_limit(par) -> float:
    """Largest particle velocity of a shock into the reference state for which the law is valid, m/s; inf where there is none (J-E16)."""
    function = EOS.of(par).functions.get("particle_velocity_limit")
    return function(par) if function else math.inf


def check_state(rho, e, par, c2_floor: float = 0.0) -> None:
    """Raise `OutOfRange`, stating the limit, unless the law answers (rho, e) with finite pressure and c^2 > c2_floor (m2/s2)."""
    name = EOS.of(par).name
    low, high = density_limits(par)
    if not (math.isfinite(rho) and math.isfinite(e)):
        raise OutOfRange(f"{name}: density and energy must be finite numbers")
    if not low < rho < high:
        if rho >= high:
            raise OutOfRange(f"{name}: density {rho:.6g} kg/m3 is at or beyond the law's compression limit, {high:.6g} kg/m3; "
                             "stay below it or choose a law that reaches further")
        raise OutOfRange(f"{name}: the density must be above {low:.6g} kg/m3, got {rho:.6g} kg/m3")
    if "energy_limits" in EOS.of(par).functions:
        cold, hot = EOS.of(par).functions["energy_limits"](rho, par)
        if not cold <= e <= hot:
            raise OutOfRange(f"{name}: energy {e:.6g} J/kg is outside {cold:.6g} to {hot:.6g} J/kg, the range of the law at "
                             f"{rho:.6g} kg/m3")
    p, c2 = pressure(rho, e, par), sound_speed_squared(rho, e, par)
    if not (math.isfinite(p) and math.isfinite(c2)):
        raise OutOfRange(f"{name}: no finite pressure at rho = {rho:.6g} kg/m3, e = {e:.6g} J/kg")
    if not c2 > c2_floor:
        raise OutOfRange(f"{name}: the state rho = {rho:.6g} kg/m3, e = {e:.6g} J/kg is unstable (c^2 = {c2:.4g} m2/s2, p = {p:.4g} Pa)"
                         + _stability_edge(rho, e, par, c2_floor))


def _stability_edge(rho, e, par, c2_floor) -> str:
    """Where the law becomes stable at this energy, between an unstable density and the reference density, as the end of a message."""
    unstable, stable = rho, reference_state(par)[0]
    if not sound_speed_squared(stable, e, par) > c2_floor:
        return f"; at this energy its reference density {stable:.6g} kg/m3 is unstable too"
    for _ in range(60):
        middle = 0.5 * (unstable + stable)
        if sound_speed_squared(middle, e, par) > c2_floor:
            stable = middle
        else:
            unstable = middle
    side = "above" if rho < stable else "below"
    return f"; at this energy the law is stable only {side} {stable:.6g} kg/m3, where p = {pressure(stable, e, par):.4g} Pa"


def gives(par, name: str) -> bool:
    """Whether the law, and every law inside it, has the named function of the contract."""
    return name in EOS.of(par).functions and all(gives(inner, name) for inner in par if EOS.knows(inner))


def flagged(par, flag: str) -> bool:
    """Whether the law, or a law inside it, is registered with a flag."""
    return flag in EOS.of(par).flags or any(flagged(inner, flag) for inner in par if EOS.knows(inner))


def is_condensed(par) -> bool:
    """Whether a material is condensed: rho c^2 far above its reference pressure, which in a gas is rho c^2 / gamma; false with pores."""
    if flagged(par, "remembers") or not gives(par, "reference_state"):
        return False
    rho, e = reference_state(par)
    return rho * sound_speed_squared(rho, e, par) > LEAST_STIFFNESS * abs(pressure(rho, e, par))


def temperature_at_rest(par) -> float:
    """Temperature of the reference state, K: nan where the specific heat is not known, 298.15 where the law has no temperature."""
    return float(temperature(*reference_state(par), par)) if gives(par, "temperature") else 298.15


def has_temperature(par) -> bool:
    """Whether the law gives a temperature with these parameters (its theory has one and the specific heat is known, and is not 0)."""
    if not gives(par, "temperature") or _lacks_specific_heat(par):
        return False
    rho, e = reference_state(par)
    return math.isfinite(temperature(rho, e, par))


def _lacks_specific_heat(par) -> bool:
    """Whether a specific heat is not given, or given as 0, in the law or in one inside it."""
    return not getattr(par, "specific_heat", 1.0) > 0.0 or any(_lacks_specific_heat(inner) for inner in par if EOS.knows(inner))


def require_temperature(par) -> None:
    """Raise `OutOfRange` where the law has no temperature, saying what is missing."""
    law = EOS.of(par)
    if not gives(par, "temperature"):
        raise OutOfRange(f"{law.name}: this equation of state has no temperature; choose one that has, for instance mie_gruneisen")
    if not has_temperature(par):
        if _lacks_specific_heat(par):
            raise OutOfRange(f"{law.name}: a temperature needs the specific heat (specific_heat, J/kg/K), which is not given, or is 0")
        raise OutOfRange(f"{law.name}: a temperature needs the temperature of the reference state (reference_temperature, K), which is not "
                         "given")
