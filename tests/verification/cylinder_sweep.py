r"""What a detonation that runs along a cylinder adds to one burned at once: steady flow through the section, and what a slit camera sees.

In the frame of the front the flow is steady. Per pi, with charge $C = \rho_0 R^2$ and wall $M$ per length, section a of the gas, wall angle
$\theta$, gas velocity w, isentrope of the CJ state, and the gas's radial velocity linear in r as in Gurney's estimate:

$$\rho w a = CD, \qquad h + \tfrac12 w^2 + \tfrac14 D^2\sin^2\theta = h_{CJ} + \tfrac12 (D-u_{CJ})^2, \qquad
  MD^2(1-\cos\theta) = pa + CD(w-D)$$

(mass, Bernoulli, axial momentum of gas and wall). Burned at once: $\tfrac12(M + \tfrac12C)v^2 = C(e_0-e)$ on the isentrope of constant volume.
A wall particle moves with $2D\sin(\theta/2)$; a slit at rest sees $D\tan\theta$ (G. I. Taylor, 1941). Both estimates have one pressure in a section,
so only their ratio is of use, and only after the waves have crossed it a few times.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from hugoniot.laws.eos.contract import pressure
from hugoniot.theory.chapman_jouguet import cj

INNER, OUTER, WALL_DENSITY = 0.0127, 0.0153, 8930.0


def _isentrope(par, density, energy, least):
    path = solve_ivp(lambda x, e: [-float(pressure(np.exp(-x), e[0], par)) * np.exp(x)], (-np.log(density), -np.log(least)), [energy],
                     rtol=1e-10, atol=1e-3, dense_output=True)

    def at(rho):
        e = float(path.sol(-np.log(rho))[0])
        return e, float(pressure(rho, e, par))
    return at


def sweep(par, displacement):
    """(numbers of the steady section where the outer surface has moved by `displacement` m, wall velocity burned at once): a dict and m/s.

    par   products, whose reference energy is that of the explosive at rest (JWL: e0)
    """
    point, rho0 = cj(par), par.rho0
    d, wall = point.detonation_velocity, OUTER**2 - INNER**2
    charge, mass, heat = rho0 * INNER**2, WALL_DENSITY * wall, par.e0 / par.rho0
    outer = (OUTER + displacement) ** 2
    at_once = _isentrope(par, rho0, heat, rho0 / 25.0)
    e, _ = at_once(charge / (outer - wall))
    plain = np.sqrt(2.0 * charge * (heat - e) / (mass + 0.5 * charge))
    start = float(point.state.density)
    behind = _isentrope(par, start, float(point.state.specific_internal_energy), rho0 / 25.0)
    e, p = behind(start)
    total = e + p / start + 0.5 * (d - float(point.state.particle_velocity)) ** 2

    def section(unknown):
        rho, w, angle = unknown[0] * rho0, unknown[1] * d, unknown[2]
        return rho, w, angle, outer - wall / np.cos(angle), *behind(rho)

    def balance(unknown):
        rho, w, angle, a, e, p = section(unknown)
        return [(e + p / rho + 0.5 * w * w + 0.25 * (d * np.sin(angle)) ** 2) / total - 1.0, rho * w * a / (charge * d) - 1.0,
                (p * a + charge * d * (w - d) - mass * d * d * (1.0 - np.cos(angle))) / (charge * d * d)]

    rho, w, angle, a, e, p = section(fsolve(balance, [charge / (outer - wall) / rho0, 1.0, plain / d], xtol=1e-12))
    return {"velocity": 2.0 * d * np.sin(0.5 * angle), "slit": d * np.tan(angle), "radial": d * np.sin(angle), "axial": w - d, "energy": e,
            "pressure": p, "density": rho, "charge": charge, "mass": mass, "heat": heat}, plain
