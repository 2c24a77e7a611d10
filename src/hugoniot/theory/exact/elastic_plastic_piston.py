r"""A piston driven at constant speed into an elastic-perfectly plastic solid: the exact elastic precursor and plastic shock.

It tests how a solver treats strength: the Hugoniot elastic limit, the two-wave structure, and the single shock of a slow or a very fast
piston.

The pressure has the Mie-Grüneisen form, with the Hugoniot $U_s = c_0 + s u_p$ as reference curve. With $\epsilon = 1-\rho_0/\rho$,

$$p = p_H\left(1 - \tfrac12\tilde\Gamma\,\epsilon\right) + \rho\Gamma e, \qquad p_H = \frac{\rho_0 c_0^2\epsilon}{(1 - s\epsilon)^2}, \qquad
  \tilde\Gamma = \frac{\rho\Gamma}{\rho_0}$$

* $\rho_0$, $c_0$, $s$: `solid.rho0`, `solid.c0`, `solid.s`
* $\Gamma$: Grüneisen parameter, either $\Gamma_0\rho_0/\rho$ (`solid.rho_gamma_constant` true) or the constant $\Gamma_0$, `solid.gamma0`
* $Y$, $G$: yield stress and shear modulus, `solid.yield_stress`, `solid.shear_modulus`

In uniaxial strain the solid yields at the density

$$\rho_Y = \rho_0 e^{Y/2G}\ (\text{hypoelastic}), \qquad \rho_Y = \rho_0/(1 - Y/2G)\ (\text{hyperelastic, infinitesimal strain})$$

Both waves are shocks. Across each, with the longitudinal stress $\sigma$ (which is $p + \tfrac23 Y$ once the solid yields), the velocity
$U$ of the shock and the index a for the state ahead,

$$(u-u_a)^2 = (\sigma-\sigma_a)\left(\tfrac1{\rho_a}-\tfrac1\rho\right), \qquad
  e-e_a = \tfrac12(\sigma+\sigma_a)\left(\tfrac1{\rho_a}-\tfrac1\rho\right), \qquad
  U = u_a + \frac{\sigma-\sigma_a}{\rho_a(u-u_a)}$$

A piston slower than the particle velocity of the elastic limit drives one elastic shock. A piston so fast that the plastic shock would
outrun the precursor drives a single shock.

Source: Udaykumar, Tran, Belk & Vanden, J. Comput. Phys. 186 (2003) 136, and ExactPack's ep_piston for the two yield densities;
the relations are conservation of mass, momentum and energy.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact.solution import Solution


class Solid(NamedTuple):
    """Constants of the solid, SI, as described under `elastic_plastic_piston`."""

    rho0: float
    c0: float
    s: float
    gamma0: float
    shear_modulus: float
    yield_stress: float
    rho_gamma_constant: bool = True


class State(NamedTuple):
    density: float
    velocity: float
    pressure: float
    energy: float
    stress: float
    wave_speed: float


def pressure(rho: float, e: float, solid: Solid) -> float:
    """Mie-Grüneisen pressure on the linear us-up Hugoniot, Pa."""
    strain = 1.0 - solid.rho0 / rho
    rho_gamma = solid.gamma0 * (solid.rho0 if solid.rho_gamma_constant else rho)
    hugoniot = solid.rho0 * solid.c0**2 * strain / (1.0 - solid.s * strain) ** 2
    return hugoniot * (1.0 - 0.5 * rho_gamma / solid.rho0 * strain) + rho_gamma * e


def yield_density(solid: Solid, strain: str = "hypo") -> float:
    """Density at the elastic limit: strain "hypo" (logarithmic) or "hyper" (infinitesimal)."""
    ratio = solid.yield_stress / (2.0 * solid.shear_modulus)
    if strain not in ("hypo", "hyper"):
        raise OutOfRange(f"strain = {strain!r} is neither 'hypo' nor 'hyper'")
    return solid.rho0 * float(np.exp(ratio)) if strain == "hypo" else solid.rho0 / (1.0 - ratio)


def deviator(rho: float, solid: Solid, strain: str) -> float:
    """-s1 on loading from rest, Pa: 4/3 G times the strain, at most 2/3 Y."""
    elastic = np.log(rho / solid.rho0) if strain == "hypo" else 1.0 - solid.rho0 / rho
    return min(4.0 / 3.0 * solid.shear_modulus * float(elastic), 2.0 / 3.0 * solid.yield_stress)


def shock_to(rho: float, ahead: State, solid: Solid, strain: str) -> State:
    """The shock from `ahead` to density rho: p is linear in e and e linear in p, so the energy equation is solved in closed form."""
    volume = 0.5 * (1.0 / ahead.density - 1.0 / rho)
    s = deviator(rho, solid, strain)
    cold = pressure(rho, 0.0, solid)
    rho_gamma = pressure(rho, 1.0, solid) - cold
    p = (cold + rho_gamma * (ahead.energy + volume * (s + ahead.stress))) / (1.0 - rho_gamma * volume)
    stress = p + s
    if not (1.0 - rho_gamma * volume > 0.0 and stress > ahead.stress and solid.s * (1.0 - solid.rho0 / rho) < 1.0):
        return State(rho, float("nan"), p, float("nan"), stress, float("nan"))  # beyond the end of the Hugoniot
    jump = float(np.sqrt((stress - ahead.stress) * 2.0 * volume))
    return State(rho, ahead.velocity + jump, p, ahead.energy + volume * (stress + ahead.stress), stress,
                 ahead.velocity + (stress - ahead.stress) / (ahead.density * jump))


def shock_at(velocity: float, ahead: State, solid: Solid, strain: str) -> State:
    """The shock from `ahead` to a particle velocity."""
    low = high = ahead.density * (1.0 + 1e-13)
    growth = 1e-4
    while (reached := shock_to(high, ahead, solid, strain).velocity) < velocity:
        low, high, growth = high, high * (1.0 + growth), 1.4 * growth
        while not np.isfinite(shock_to(high, ahead, solid, strain).velocity) and growth > 1e-12:
            growth *= 0.5
            high = low * (1.0 + growth)
        if growth <= 1e-12:
            raise NoSolution(f"no shock reaches a particle velocity of {velocity:g} m/s: the Hugoniot ends at {reached:g} m/s and "
                             f"{low:g} kg/m3")
    rho = brentq(lambda r: shock_to(r, ahead, solid, strain).velocity - velocity, low, high, xtol=1e-13 * solid.rho0, rtol=1e-15)
    return shock_to(rho, ahead, solid, strain)


def waves(solid: Solid, piston: float, strain: str = "hypo") -> list[State]:
    """States behind the waves, precursor first: one (elastic or overdriven) or two."""
    rest = State(solid.rho0, 0.0, 0.0, 0.0, 0.0, 0.0)
    if solid.yield_stress <= 0.0:
        return [shock_at(piston, rest, solid, strain)]
    limit = shock_to(yield_density(solid, strain), rest, solid, strain)
    if piston <= limit.velocity:
        return [shock_at(piston, rest, solid, strain)]
    plastic = shock_at(piston, limit, solid, strain)
    return [limit, plastic] if plastic.wave_speed < limit.wave_speed else [shock_at(piston, rest, solid, strain)]


def elastic_plastic_piston(solid: Solid, piston: float, strain: str = "hypo") -> Solution:
    """Piston at constant speed into an elastic-plastic solid at rest in x > 0: precursor and plastic shock.

    solid                      the constants below, or on the command line a library material with a linear Us-up law and a strength law
    solid.rho0                 reference density
    solid.c0                   bulk sound speed, constant of the linear Us-up relation
    solid.s                    slope of the linear Us-up relation
    solid.gamma0               Grüneisen parameter at the reference density
    solid.shear_modulus        shear modulus
    solid.yield_stress         yield stress in uniaxial stress
    solid.rho_gamma_constant   true: density times Grüneisen parameter is constant; false: the Grüneisen parameter is constant
    piston                     speed of the piston, into the solid
    strain                     hypo (logarithmic strain) or hyper (infinitesimal strain)

    Fields: density, velocity, pressure, energy, stress (longitudinal, positive in compression), deviator_radial (pressure - stress); not a
    number (NaN) where the piston has passed. Numbers: wave_count (1 or 2), and density, velocity, pressure, energy, stress and wave_speed
    behind each wave, with the prefixes elastic_ and plastic_ (equal if there is one wave).
    """
    if piston <= 0.0:
        raise OutOfRange(f"piston = {piston:g} m/s must be positive (into the solid)")
    found = waves(solid, piston, strain)
    rest = State(solid.rho0, 0.0, 0.0, 0.0, 0.0, 0.0)

    def profile(x, time):
        fields = {}
        for name in ("density", "velocity", "pressure", "energy", "stress"):
            value = np.full_like(x, getattr(rest, name))
            for state in found:
                value = np.where(x < state.wave_speed * time, getattr(state, name), value)
            fields[name] = np.where(x >= piston * time, value, np.nan)
        fields["deviator_radial"] = fields["pressure"] - fields["stress"]
        return fields

    numbers = {"wave_count": float(len(found))}
    for label, state in (("elastic", found[0]), ("plastic", found[-1])):
        numbers |= {f"{label}_{name}": value for name, value in state._asdict().items()}
    return Solution("elastic-plastic piston", "planar", profile, lambda time: tuple(s.wave_speed * time for s in found), numbers)


ALUMINIUM = Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 0.3e9)
COPPER = Solid(8930.0, 3940.0, 1.49, 2.0, 45e9, 0.09e9)
EXACTPACK = Solid(2790.0, 5330.0, 1.34, 2.0, 28.6e9, 0.26e9)


def aluminium_piston() -> Solution:
    """Aluminium driven by a piston at 400 m/s: precursor and plastic shock.

    Hypoelastic, with rho0 = 2785 kg/m3, c0 = 5328 m/s, s = 1.338, gamma0 = 2, a shear modulus of 27.6 GPa and a yield stress of 0.3 GPa;
    density times Grüneisen parameter is constant.
    """
    return elastic_plastic_piston(ALUMINIUM, 400.0)


def copper_piston() -> Solution:
    """Copper driven by a piston at 20 m/s: precursor and plastic shock.

    Hypoelastic, with rho0 = 8930 kg/m3, c0 = 3940 m/s, s = 1.49, gamma0 = 2, a shear modulus of 45 GPa and a yield stress of 0.09 GPa;
    density times Grüneisen parameter is constant.
    """
    return elastic_plastic_piston(COPPER, 20.0)


def udaykumar_piston() -> Solution:
    """Aluminium driven by a piston at 100 m/s, with the constants of ExactPack's ep_piston.

    Hypoelastic, with rho0 = 2790 kg/m3, c0 = 5330 m/s, s = 1.34, gamma0 = 2, a shear modulus of 28.6 GPa and a yield stress of 0.26 GPa;
    density times Grüneisen parameter is constant.
    """
    return elastic_plastic_piston(EXACTPACK, 100.0)
