r"""Programmed burn: zones burn when a front of prescribed speed has reached them, or when they are compressed to the CJ density.

$$F_1 = \frac{D\,(t - t_b)}{B_s\,\Delta x^0}, \qquad F_2 = \frac{1 - \rho_0/\rho}{1 - \rho_0/\rho_{CJ}}, \qquad
  F = \max(F_1, F_2) \in [0, 1]$$

`programmed` uses F1 (Herrmann A.27, A.28), `beta` uses F2 (the CJ-volume burn), and `programmed_beta` the larger of the two, so that a
front overdriven by convergence may run ahead of its schedule. The burn fraction F never decreases. The lighting time t_b is that of the
zone's face nearer to the detonation point (A.27; `lighting.py`). The pressure is F times that of the products (A.29: `BurnedProducts`).
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, fmin
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, no_advance, no_rate


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
            raise OutOfRange(f"programmed burn: {name} must be positive; got {fields[name]:.6g}")
    if "rho_cj" in fields and not par.rho_cj > par.rho0:
        raise OutOfRange(f"programmed burn: rho_cj must exceed rho0; got {par.rho_cj:.6g} and {par.rho0:.6g} kg/m^3")
    return par


def build_programmed(detonation_velocity, spread_zones=2.5):
    return checked(Programmed(detonation_velocity, spread_zones))


def build_beta(rho0, rho_cj):
    return checked(Beta(rho0, rho_cj))


def build_programmed_beta(detonation_velocity, rho0, rho_cj, spread_zones=2.5):
    return checked(ProgrammedBeta(detonation_velocity, rho0, rho_cj, spread_zones))


_UNITS = {"detonation_velocity": "m/s", "spread_zones": "1", "rho0": "kg/m^3", "rho_cj": "kg/m^3"}
_MEANING = {"detonation_velocity": "speed of the programmed front", "spread_zones": "zones over which a front burns (B_s)",
            "rho0": "density of the unburned explosive", "rho_cj": "density of the Chapman-Jouguet state"}
_SOURCE = ("Herrmann, WL-TR-64-107, A.27 to A.30",)
_BOX = {"rho": (1000.0, 3000.0)}

for _name, _build, _function, _example, _flags, _line in (
    ("programmed", build_programmed, programmed, Programmed(7991.0), ("programmed",),
     "Programmed burn: zones burn when a front of prescribed speed has reached them."),
    ("beta", build_beta, beta, Beta(1714.0, 2332.8), ("compression_driven",),
     "CJ-volume burn: zones burn in proportion to their compression towards the CJ density."),
    ("programmed_beta", build_programmed_beta, programmed_beta, ProgrammedBeta(7991.0, 1714.0, 2332.8),
     ("programmed", "compression_driven"), "The larger of programmed and CJ-volume burn: a converging front may overtake its schedule."),
):
    BURN.add(_name, type(_example), functions={"rate": no_rate, "advance": no_advance, "scheduled": _function}, example=_example,
             units=_UNITS, meaning=_MEANING, box=_BOX, references=_SOURCE, flags=_flags, build=_build,
             defaults={"spread_zones": 2.5} if "programmed" in _flags else {}, line=_line)
