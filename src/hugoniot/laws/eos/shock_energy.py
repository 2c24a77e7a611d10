r"""The shock equation of state of the KB codes: the pressure of the shock that would have given a zone its energy.

$$p = \rho_0\,U_s\,u_p, \qquad u_p = \sqrt{2e}, \qquad U_s = c_0 + s\,u_p + s_2u_p^2$$

The density does not enter (K-E10): the pressure is right on the principal Hugoniot and nowhere else. There is no tension and no elastic
release, and a zone at e = 0 stays there under its own pressure, because p = 0 does no work: only the artificial viscosity heats it.
It is kept to reproduce those codes' results for unburned explosives; use `mie_gruneisen` for anything else.

With $\partial p/\partial\rho = 0$ the speed of sound is that of $p\,p_e/\rho^2$: 
$c = \tfrac{\rho_0}{\rho}\sqrt{U_s\,(c_0 + 2su_p + 3s_2u_p^2)}$, $c_0$ at rest. With s2 negative the pressure stops rising with the energy
where the last factor vanishes; there the speed of sound is no longer real, and a run stops. The slope
$p_e = \rho_0(c_0/u_p + 2s + 3s_2u_p)$ is infinite at rest, so $u_p$ is at least REST, which leaves 3e-3 Pa in a metal.

Source: KB codes equations 3.1, 3.6 and 3.7.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, vsqrt
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS

REST = 1e-9     # m/s


class ShockEnergy(NamedTuple):
    rho0: float
    c0: float
    s: float
    s2: float = 0.0


def _particle_velocity(e):
    return vsqrt(2.0 * fmax(e, 0.0) + REST * REST)


def pressure(rho, e, par):
    """Energies below that of rest have no pressure."""
    u = _particle_velocity(e)
    return par.rho0 * (par.c0 + u * (par.s + u * par.s2)) * u


def pressure_derivatives(rho, e, par):
    u = _particle_velocity(e)
    return 0.0 * rho, par.rho0 * (par.c0 / u + 2.0 * par.s + 3.0 * par.s2 * u)


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, float("inf")


def build(rho0, c0, s, s2=0.0):
    """Parameters from a deck; OutOfRange unless rho0 and c0 are positive and s is not negative."""
    if not (rho0 > 0.0 and c0 > 0.0 and s >= 0.0):
        raise OutOfRange(f"shock_energy: needs rho0 > 0, c0 > 0 and s >= 0, got {rho0:g}, {c0:g}, {s:g}")
    return ShockEnergy(rho0, c0, s, s2)


EOS.add(
    "shock_energy", ShockEnergy,
    functions=[pressure, pressure_derivatives, reference_state, density_limits],
    example=ShockEnergy(1770.0, 3080.0, 2.01),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "s2": "s/m"},
    meaning={"rho0": "density at rest", "c0": "shock velocity at vanishing particle velocity", "s": "slope dUs/dup at rest",
             "s2": "half its change with up (S2)"},
    defaults={"s2": 0.0},
    box={"rho": (1200.0, 3500.0), "e": (1e2, 1e7)},
    flags=("shocks_only",),
    references=("KB codes, equations 3.1, 3.6, 3.7",),
)
