r"""Two-state mixture: reactants and products at the density and the temperature of the mixture, as in CTH before 1999.

$$p = (1-\lambda)\,p_r(\rho, T) + \lambda\,p_p(\rho, T), \qquad e = (1-\lambda)\,e_r(\rho, T) + \lambda\,e_p(\rho, T)$$

* $\lambda$: burn fraction, the mass fraction of products
* $\rho$, $e$, $p$, $T$: density, specific internal energy, pressure and temperature of the mixture
* $p_r$, $e_r$, $p_p$, $e_p$: pressure and energy of reactants and products; $e_r$ includes the chemical energy $Q$, `detonation_energy`

Products that form in a solid are thus held at its density, and the weighted pressure is that of neither phase, so it has no physical
meaning (Starkenberg, section 4.4). Use this law only to compare with results of CTH from before 1999. Both equations of state must give a
temperature and a specific heat.

**Numerical solution.** With $z = e_r - e_p$ one equation remains, the equality of the temperatures, which Newton's method solves.
"""

from typing import NamedTuple

from hugoniot.laws.eos.contract import pressure, specific_heat, temperature
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.jwl_unreacted import JWLUnreacted
from hugoniot.laws.mixture.contract import CONVERGED, MIXTURE, NOT_CONVERGED, Mixed, PhaseSlopes, Slopes, volume_slopes

_TRIES = 40
_CLOSE = 1e-13      # of the temperature


class TwoState(NamedTuple):
    reactants: NamedTuple
    products: NamedTuple
    detonation_energy: float


def shared(rho, e, burn_fraction, par):
    """(z = e_r - e_p, status): both phases at one temperature; exact in one step for constant specific heats."""
    lam, z, status = burn_fraction, par.detonation_energy, NOT_CONVERGED
    for _ in range(_TRIES):
        e_r, e_p = e + lam * z - par.detonation_energy, e - (1.0 - lam) * z
        t_r, t_p = temperature(rho, e_r, par.reactants), temperature(rho, e_p, par.products)
        slope = lam / specific_heat(rho, e_r, par.reactants) + (1.0 - lam) / specific_heat(rho, e_p, par.products)
        miss = t_r - t_p
        if abs(miss) <= _CLOSE * (abs(t_r) + abs(t_p)):
            status = CONVERGED
            break
        z = z - miss / slope
    return z, status


def equilibrate(rho, e, burn_fraction, before, par):
    """Both phases found, also the one that carries no mass."""
    z, status = shared(rho, e, burn_fraction, par)
    e_r, e_p = e + burn_fraction * z, e - (1.0 - burn_fraction) * z
    p = (1.0 - burn_fraction) * pressure(rho, e_r - par.detonation_energy, par.reactants) + burn_fraction * pressure(rho, e_p, par.products)
    return Mixed(p, rho, e_r, rho, e_p, status)


def solve(rho, e, burn_fraction, before, par):
    """As `equilibrate`; what has not begun to burn, or has burned, takes its own law alone."""
    if burn_fraction <= 0.0:
        return Mixed(pressure(rho, e - par.detonation_energy, par.reactants), rho, e, rho, e, CONVERGED)
    if burn_fraction >= 1.0:
        return Mixed(pressure(rho, e, par.products), rho, e, rho, e, CONVERGED)
    return equilibrate(rho, e, burn_fraction, before, par)


def heat_slopes(rho, e, par):
    """(p, dp/dv, dp/de, dT/dv, dT/de) of one phase."""
    p, heat = pressure(rho, e, par), specific_heat(rho, e, par)
    p_v, p_e = volume_slopes(rho, e, par)
    return p, p_v, p_e, p / heat - temperature(rho, e, par) * p_e, 1.0 / heat


def shares(burn_fraction, mixed, par):
    """(both phases' slopes, z, dz/dv, dz/de, dz/dlambda)."""
    lam, z = burn_fraction, mixed.e_r - mixed.e_p
    r = heat_slopes(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    s = heat_slopes(mixed.rho_p, mixed.e_p, par.products)
    turn = lam * r[4] + (1.0 - lam) * s[4]
    return r, s, z, (s[3] - r[3]) / turn, (s[4] - r[4]) / turn, z * (s[4] - r[4]) / turn


def slopes(rho, e, burn_fraction, mixed, par):
    """Slopes of the sum of pressures, the phases' energies following their common temperature."""
    lam = burn_fraction
    if lam <= 0.0 or lam >= 1.0:      # the state of `solve` holds one phase
        mixed = equilibrate(rho, e, lam, mixed, par)
    r, s, z, z_v, z_e, z_l = shares(lam, mixed, par)
    by_z = lam * (1.0 - lam) * (r[2] - s[2])
    return Slopes((1.0 - lam) * r[1] + lam * s[1] + by_z * z_v, (1.0 - lam) * r[2] + lam * s[2] + by_z * z_e,
                  s[0] - r[0] + z * ((1.0 - lam) * r[2] + lam * s[2]) + by_z * z_l)


def phase_slopes(burn_fraction, mixed, par):
    lam, left = burn_fraction, 1.0 - burn_fraction
    _, _, z, z_v, z_e, z_l = shares(lam, mixed, par)
    return PhaseSlopes(1.0, lam * z_v, 1.0, -left * z_v, 0.0, 1.0 + lam * z_e, 0.0, 1.0 - left * z_e,
                       0.0, z + lam * z_l, 0.0, z - left * z_l)


def common_temperature(burn_fraction, mixed, par):
    """That of both phases."""
    if burn_fraction < 1.0:
        return temperature(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
    return temperature(mixed.rho_p, mixed.e_p, par.products)


def common_heat(burn_fraction, mixed, par):
    """(1 - lambda) c_vr + lambda c_vp."""
    return ((1.0 - burn_fraction) * specific_heat(mixed.rho_r, mixed.e_r - par.detonation_energy, par.reactants)
            + burn_fraction * specific_heat(mixed.rho_p, mixed.e_p, par.products))


MIXTURE.add(
    "two_state", TwoState,
    functions={"solve": solve, "attempt": solve, "equilibrate": equilibrate, "slopes": slopes, "phase_slopes": phase_slopes,
               "temperature": common_temperature, "specific_heat": common_heat},
    example=TwoState(JWLUnreacted(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1905.0, 1305.5),
                     JWL(1481.05e9, 63.79e9, 6.2, 2.2, 0.5, 1905.0, 6.9e9, 524.9), 3.9e6),
    units={"reactants": "", "products": "", "detonation_energy": "J/kg"},
    meaning={"reactants": "equation of state of the unreacted material", "products": "equation of state of the products",
             "detonation_energy": "chemical energy Q released by burning, not negative"},
    box={"rho": (1900.0, 2600.0), "e": (4e6, 8e6), "burn_fraction": (0.0, 1.0)},
    references=("Starkenberg, ARL-TR-2161, section 4.4", "Kerley (1992), as cited by Starkenberg"),
    flags=("no_equilibrium", "needs_temperature"),
)
