r"""Compatibility relations along characteristics of a reacting flow.

$$\frac{dp}{dt} \pm \rho c\,\frac{du}{dt} = \left[(\rho c^2 - \Gamma p)(v_p - v_r) - \Gamma(e_p - e_r)\right]\rho\dot\lambda
  - (d-1)\frac{\rho c^2 u}{x} \quad\text{on}\quad \frac{dx}{dt} = u \pm c,$$
$$\frac{de}{dt} + p\,\frac{dv}{dt} = 0, \qquad \frac{d\lambda}{dt} = \dot\lambda \quad\text{on}\quad \frac{dx}{dt} = u$$

* $\lambda$: burn fraction; $v = 1/\rho$: specific volume; $v_r$, $e_r$ and $v_p$, $e_p$: volume and energy of reactants and products
* $c$: sound speed without reaction (frozen); $\Gamma$: Grüneisen parameter of the mixture
* $d$: 1 planar, 2 cylindrical, 3 spherical; $x$: position or radius

The bracket times $\rho$ is the derivative of the pressure with respect to the burn fraction at constant volume and energy, in every
closure in which both phases have the pressure of the mixture; where the pressure is a weighted mean of those of the phases, that
derivative takes the place of the bracket times $\rho$. The term in $d$ is not in the source, and the source prints $+\rho c\,du/dt$ on both
characteristics (S-E4).

Source: Starkenberg, ARL-TR-2161, section 6.
"""

import numpy as np

from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.theory.mixture import MixtureState


def reaction_source(state: MixtureState, rate):
    """The reaction term on the right-hand side, Pa/s.

    state   a `MixtureState`
    rate    d(burn fraction)/dt, 1/s
    """
    if "no_equilibrium" in MIXTURE.of(state.par).flags:
        return state.pressure_by_burn_fraction * np.asarray(rate, float)
    rho, gamma = state.density, state.gruneisen
    rho_c2 = state.impedance_squared / rho
    dv = 1.0 / state.product_density - 1.0 / state.reactant_density
    de = state.product_energy - state.reactant_energy
    return ((rho_c2 - gamma * state.pressure) * dv - gamma * de) * rho * np.asarray(rate, float)


def thermicity(state: MixtureState, rate):
    """The reaction term divided by rho c^2, 1/s (sigma times the rate in the literature on detonations)."""
    return reaction_source(state, rate) * state.density / state.impedance_squared


def geometric_source(state: MixtureState, velocity, position, dimension: int):
    """The geometric term, -(d - 1) rho c^2 u/x, Pa/s.

    velocity    u, m/s
    position    x, m
    dimension   d: 1 planar, 2 cylindrical, 3 spherical
    """
    return -(dimension - 1) * state.impedance_squared / state.density * np.asarray(velocity, float) / np.asarray(position, float)


def mismatch(state: MixtureState, sign: int, pressure_rate, velocity_rate, rate, velocity=0.0, position=1.0, dimension: int = 1):
    """Residual of the relation along dx/dt = u + sign c for a flow, Pa/s; zero for a solution.

    state                          a `MixtureState`
    sign                           +1 or -1
    pressure_rate, velocity_rate   dp/dt (Pa/s) and du/dt (m/s2) along that characteristic
    rate                           d(burn fraction)/dt of the material, 1/s
    velocity, position             u (m/s) and x (m), used in curved geometry
    dimension                      1 planar, 2 cylindrical, 3 spherical
    """
    impedance = np.sqrt(state.impedance_squared)
    flow = np.asarray(pressure_rate, float) + sign * impedance * np.asarray(velocity_rate, float)
    return flow - reaction_source(state, rate) - geometric_source(state, velocity, position, dimension)
