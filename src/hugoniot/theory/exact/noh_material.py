r"""Noh's implosion for any equation of state: a uniform inflow stops behind a shock of constant speed.

It tests a solver with a strong shock in a real material. In planar geometry it is the impact of a body on a rigid wall.

Ahead of the shock the particles coast without a pressure gradient, $\rho_1 = \rho_0(1 + Ut/r)^{d-1}$. At the shock, $r = Dt$, this
density is constant, and so are the states on both sides:

$$\rho_2 = \rho_0\left(1 + \frac UD\right)^d, \quad p_2 - p_1 = \rho_1(D + U)U, \quad
  e_2 - e_1 = \tfrac12U^2 + \frac{p_1U}{\rho_1(D + U)}, \quad p_2 = p(\rho_2, e_2)$$

* $\rho_0$, $U$: density at $t = 0$ and speed of the inflow; $D$: speed of the shock
* $p$, $e$: pressure and specific internal energy, with the index 1 ahead of the shock and 2 behind it
* $d$: 1 planar, 2 cylindrical, 3 spherical

The four conditions reduce to one equation for $D$. In planar flow the inflow may have any pressure, so the solution holds for every
material. In cylindrical and spherical flow the converging inflow must stay without pressure, which holds only for equations of state
without pressure at zero energy, such as the ideal gas. Other materials are not supported there.

Source: Noh, J. Comput. Phys. 72 (1987) 78; Ramsey, Boyd and Burnett, Shock Waves 27 (2017) 477 for general laws; derived for this project.
"""

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution
from hugoniot.theory.exact.substance import law_named


def noh_material(material: str = "copper", geometry: str = "planar", speed: float = 1000.0, density: float = 0.0) -> Solution:
    """Noh's implosion of a library material: uniform inflow against a wall, axis or centre, for any equation of state.

    material   name of a library material; in Python also an equation of state
    geometry   planar, cylindrical or spherical (curved: only for materials without pressure at zero energy, such as gases)
    speed      speed of the inflow, towards r = 0
    density    density of the inflow at time 0; 0: the reference density

    Strength is ignored. In planar geometry the inflow has the reference energy of the material, in curved geometry zero energy.

    Fields: density, velocity, pressure, energy. Numbers: plateau_density, plateau_pressure, plateau_energy (behind the shock), shock_speed.
    """
    par, d = law_named(material), DIMENSION[geometry]
    rest, e1 = (float(v) for v in contract.reference_state(par))
    rho0 = density or rest
    if speed <= 0.0 or rho0 <= 0.0:
        raise OutOfRange(f"Noh's problem needs density > 0 and speed > 0, got density = {rho0:g} kg/m3 and speed = {speed:g} m/s")
    if d > 1:
        e1 = 0.0
        if not all(contract.pressure(x * rho0, 0.0, par) == 0.0 for x in (1.0, 2.0, 5.0)):
            raise OutOfRange(f"Noh's {geometry} problem: the converging inflow would have a non-zero pressure with this law "
                             f"({contract.pressure(2.0 * rho0, 0.0, par):.4g} Pa at twice the density); only planar flow is exact for it")
    p1 = float(contract.pressure(rho0, e1, par))
    shock, rho2, p2, e2 = _plateau(par, d, rho0, p1, e1, speed)

    def profile(r, time):
        inside = r < shock * time
        with np.errstate(divide="ignore"):
            ahead = rho0 * (1.0 + speed * time / np.where(inside, np.inf, r)) ** (d - 1)
        return {"density": np.where(inside, rho2, ahead), "velocity": np.where(inside, 0.0, -speed), "energy": np.where(inside, e2, e1),
                "pressure": np.where(inside, p2, p1)}

    numbers = {"plateau_density": rho2, "plateau_pressure": p2, "plateau_energy": e2, "shock_speed": shock}
    return Solution(f"Noh, {geometry}, {material if isinstance(material, str) else 'material'}", geometry, profile,
                    lambda time: (shock * time,), numbers)


def _plateau(par, d: int, rho0: float, p1: float, e1: float, speed: float) -> tuple[float, float, float, float]:
    """(D, rho2, p2, e2) of the slowest shock that satisfies the jumps: the one that a weak inflow turns into sound."""
    def behind(shock):
        rho1 = rho0 * (1.0 + speed / shock) ** (d - 1)
        flux = rho1 * (shock + speed)
        return rho0 * (1.0 + speed / shock) ** d, p1 + flux * speed, e1 + 0.5 * speed**2 + p1 * speed / flux

    def excess(shock):
        rho2, p2, e2 = behind(shock)
        return float(contract.pressure(rho2, e2, par)) - p2

    # Towards a fast shock the material is hardly compressed and the law gives less pressure than the jump asks for.
    high = 1e3 * speed + 1e5
    if not excess(high) < 0.0:
        raise NoSolution("Noh's problem: no shock of up to a thousand times the speed of the inflow stops it")
    with np.errstate(all="ignore"):
        low = high
        while not excess(low) > 0.0:
            low /= 1.05
            if low < 1e-4 * speed:
                raise NoSolution("Noh's problem: no shock stops the inflow: the law does not reach the compression that this needs")
        high = 1.05 * low
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    shock = 0.5 * (low + high)
    rho, p, e = behind(shock)
    return shock, float(rho), float(p), float(e)
