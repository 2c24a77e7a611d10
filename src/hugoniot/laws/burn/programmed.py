r"""The burn fraction follows from a front of prescribed speed, from the compression, or from both.

$$F_1 = \frac{D\,(t - t_b)}{B_s\,\Delta x_0}, \qquad F_2 = \frac{1 - \rho_0/\rho}{1 - \rho_0/\rho_{CJ}}$$

* `programmed`: $F = F_1$; `beta` (CJ-volume burn): $F = F_2$; `programmed_beta`: $F = \max(F_1, F_2)$
* $F$: burn fraction, limited to 0 to 1; it never decreases
* $D$: speed of the front, `detonation_velocity`; $t$: time
* $t_b$: lighting time, at which the front reaches the face of the zone nearer to the detonation point
* $B_s$: `spread_zones`, the number of zones over which the front is spread; $\Delta x_0$: initial width of the zone
* $\rho$: density; $\rho_0$, $\rho_{CJ}$: reference density and density of the CJ state, `rho0`, `rho_cj`

With `programmed_beta` a front that is overdriven by convergence may run ahead of its schedule. The pressure of a burning zone follows from
the mixture law of the material. With the default, `burned_products`, it is $F$ times the pressure of the products.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, fmin
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, no_advance, no_rate
from hugoniot.laws.burn.depletion import with_unit


class Programmed(NamedTuple):
    detonation_velocity: float
    spread_zones: float = 2.5


class Beta(NamedTuple):
    rho0: float
    rho_cj: float


class ProgrammedBeta(NamedTuple):
    detonation_velocity: float
    rho0: float
    rho_cj: float
    spread_zones: float = 2.5


def by_time(time, lighting_time, zone_size, par):
    return fmin(1.0, fmax(0.0, par.detonation_velocity * (time - lighting_time) / (par.spread_zones * zone_size)))


def by_compression(rho, par):
    return fmin(1.0, fmax(0.0, (1.0 - par.rho0 / rho) / (1.0 - par.rho0 / par.rho_cj)))


def programmed(burn_fraction, time, lighting_time, zone_size, rho, par):
    return fmax(burn_fraction, by_time(time, lighting_time, zone_size, par))


def beta(burn_fraction, time, lighting_time, zone_size, rho, par):
    return fmax(burn_fraction, by_compression(rho, par))


def programmed_beta(burn_fraction, time, lighting_time, zone_size, rho, par):
    return fmax(burn_fraction, fmax(by_time(time, lighting_time, zone_size, par), by_compression(rho, par)))


def checked(par):
    """The parameters as they are; OutOfRange for a front that does not run or a CJ state that is not compressed."""
    fields = par._asdict()
    for name in ("detonation_velocity", "spread_zones", "rho0"):
        if name in fields and not fields[name] > 0.0:
            raise OutOfRange(f"{BURN.of(par).name}: {name} must be positive, got {with_unit(par, name)}")
    if "rho_cj" in fields and not par.rho_cj > par.rho0:
        raise OutOfRange(f"{BURN.of(par).name}: rho_cj must exceed rho0, got rho_cj = {par.rho_cj:.6g} and rho0 = {par.rho0:.6g} kg/m^3")
    return par


def build_programmed(detonation_velocity, spread_zones=2.5):
    return checked(Programmed(detonation_velocity, spread_zones))


def build_beta(rho0, rho_cj):
    return checked(Beta(rho0, rho_cj))


def build_programmed_beta(detonation_velocity, rho0, rho_cj, spread_zones=2.5):
    return checked(ProgrammedBeta(detonation_velocity, rho0, rho_cj, spread_zones))


_UNITS = {"detonation_velocity": "m/s", "spread_zones": "1", "rho0": "kg/m^3", "rho_cj": "kg/m^3"}
_MEANING = {"detonation_velocity": "speed of the programmed front", "spread_zones": "number of zones over which the front is spread",
            "rho0": "reference density of the explosive", "rho_cj": "density of the CJ state"}
_SOURCE = ("Herrmann, WL-TR-64-107 (1964), A.27 to A.30",)
_BOX = {"rho": (1000.0, 3000.0)}

for _name, _build, _function, _example, _flags, _line in (
    ("programmed", build_programmed, programmed, Programmed(7991.0), ("programmed",),
     "Programmed burn: a zone burns when a front of prescribed speed reaches it."),
    ("beta", build_beta, beta, Beta(1714.0, 2332.8), ("compression_driven",),
     "CJ-volume burn: a zone burns in proportion to its compression towards the CJ density."),
    ("programmed_beta", build_programmed_beta, programmed_beta, ProgrammedBeta(7991.0, 1714.0, 2332.8),
     ("programmed",
     "compression_driven"), "The larger of programmed and CJ-volume burn, so that a converging front may run ahead of its schedule."),
):
    BURN.add(_name, type(_example), functions={"rate": no_rate, "advance": no_advance, "scheduled": _function}, example=_example,
             units=_UNITS, meaning=_MEANING, box=_BOX, references=_SOURCE, flags=_flags, build=_build,
             defaults={"spread_zones": 2.5} if "programmed" in _flags else {}, line=_line)
