r"""Compatibility relations along characteristics of a reacting flow.

$$\frac{dp}{dt} \pm \rho c\,\frac{du}{dt} = \left[(\rho c^2 - \Gamma p)(v_p - v_r) - \Gamma(e_p - e_r)\right]\rho\dot\lambda
  - (d-1)\frac{\rho c^2 u}{x} \quad\text{on}\quad \frac{dx}{dt} = u \pm c,$$
$$\frac{de}{dt} + p\,\frac{dv}{dt} = 0, \qquad \frac{d\lambda}{dt} = \dot\lambda \quad\text{on}\quad \frac{dx}{dt} = u .$$

The lower sign of rho c belongs to the lower characteristic (S-E4: the source prints a plus for both). c is the frozen sound speed. The
bracket times rho is p_lambda at constant volume and energy for every closure in which both phases have the pressure of the mixture, because
v and e are sums over the phases; where pressures are weighted instead, p_lambda itself is used. The last
term (geometry: d = 1 planar, 2 cylindrical, 3 spherical) is not in the source.

Source: Starkenberg ARL-TR-2161 section 6.
"""

import numpy as np

from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.theory.mixture import MixtureState


def reaction_source(state: MixtureState, rate):
    """Right-hand side due to burning at `rate` = d(burn fraction)/dt in 1/s: Pa/s, array of the state's shape."""
    if "no_equilibrium" in MIXTURE.of(state.par).flags:
        return state.pressure_by_burn_fraction * np.asarray(rate, float)
    rho, gamma = state.density, state.gruneisen
    rho_c2 = state.impedance_squared / rho
    dv = 1.0 / state.product_density - 1.0 / state.reactant_density
    de = state.product_energy - state.reactant_energy
    return ((rho_c2 - gamma * state.pressure) * dv - gamma * de) * rho * np.asarray(rate, float)


def thermicity(state: MixtureState, rate):
    """Reaction source over rho c^2, 1/s: what drives the flow (sigma times the rate in the detonation literature)."""
    return reaction_source(state, rate) * state.density / state.impedance_squared


def geometric_source(state: MixtureState, velocity, position, dimension: int):
    """-(d - 1) rho c^2 u / x, Pa/s."""
    return -(dimension - 1) * state.impedance_squared / state.density * np.asarray(velocity, float) / np.asarray(position, float)


def mismatch(state: MixtureState, sign: int, pressure_rate, velocity_rate, rate, velocity=0.0, position=1.0, dimension: int = 1):
    """Residual of the relation along dx/dt = u + sign c for a flow, Pa/s; zero for a solution.

    pressure_rate, velocity_rate   dp/dt and du/dt along that characteristic, Pa/s and m/s2
    rate                           d(burn fraction)/dt of the material, 1/s
    """
    impedance = np.sqrt(state.impedance_squared)
    flow = np.asarray(pressure_rate, float) + sign * impedance * np.asarray(velocity_rate, float)
    return flow - reaction_source(state, rate) - geometric_source(state, velocity, position, dimension)
