r"""Plates driven by explosives: the exact end-on plate of a gamma = 3 explosive, and Gurney's formulas.

**End-on plate.** A slab of length L is lit at its free end x = 0; the plate of mass per area M rests at x = L, and the charge has the mass
per area C = rho0 L. For gamma = 3 both characteristics are straight: behind the front $u + c = x/t$, $p = \tfrac{16}{27}\rho_0 c^3/D$. At
the plate, with y = x/t, $c = y - \dot x = -t\dot y$, and $M\ddot x = p$ becomes $d(ct)/dt = -\kappa (ct)^3/t^2$, $\kappa = 16\rho_0/(27 D
M)$:

$$ct = \left(a - 2\kappa/t\right)^{-1/2},\quad a = L^{-2} + 2\kappa D/L; \qquad
  \frac xt = D - \frac1\kappa\left[\sqrt{a - 2\kappa/t} - \frac1L\right]$$
$$\frac{v_\infty}{D} = 1 - \frac{27M}{16C}\left(\sqrt{1 + \frac{32C}{27M}} - 1\right)$$

The assumption that $u + c$ is unchanged across the reflected shock violates conservation of momentum and energy. With both conserved the
plate is 0.5 % faster at M/C = 0.1 and 1.0 % faster at M/C = 5; with products $p = K\rho^3$ it is 0.25 and 1.3 % slower
(`docs/theory/detonation.md`).

**Gurney.** With a linear velocity profile and a uniform energy release E, $v/\sqrt{2E} = (\mu + k)^{-1/2}$, mu = M/C, with k = 1/3
(symmetric sandwich, where M counts both plates), 1/2 (cylinder), 3/5 (sphere). In an asymmetric sandwich a tamper of mass N, nu = N/C,
moves at A v in the opposite direction; the momentum balance gives A and the energy balance v:

$$A = \frac{1 + 2\mu}{1 + 2\nu}, \qquad \frac{v}{\sqrt{2E}} = \left[\mu + \nu A^2 + \frac{1 + A^3}{3(1 + A)}\right]^{-1/2}$$

The open sandwich has no tamper.

Source: Aziz, Hurwitz & Sternberg, Phys. Fluids 4 (1961) 380; Gurney, BRL Report 405 (1943); both re-derived.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def terminal_velocity(mass_ratio: float, detonation_velocity: float) -> float:
    """Final speed of an end-on plate, m/s; mass_ratio = M/C."""
    k = 27.0 * mass_ratio / 16.0
    return detonation_velocity * (1.0 - k * (np.sqrt(1.0 + 2.0 / k) - 1.0))


def plate_push(mass_ratio: float = 1.0, detonation_velocity: float = 8000.0, density: float = 1600.0, length: float = 0.1) -> Solution:
    """End-on plate: M/C = mass_ratio, driven by a slab of gamma = 3 explosive lit at its free end x = 0; vacuum on both sides.

    Positions are ignored except for their shape: the fields `position` and `velocity` are those of the plate at the given time; `pressure`
    is that on the plate. `numbers`: terminal_velocity, arrival_time. Before arrival the plate rests at `length`.
    """
    if min(mass_ratio, detonation_velocity, density, length) <= 0.0:
        raise OutOfRange("the driven plate needs positive mass ratio, detonation velocity, density and length")
    d, mass = detonation_velocity, mass_ratio * density * length
    kappa = 16.0 * density / (27.0 * d * mass)
    a = 1.0 / length**2 + 2.0 * kappa * d / length

    def state(time):
        if time <= length / d:
            return length, 0.0, 0.0
        root = np.sqrt(a - 2.0 * kappa / time)
        ratio = d - (root - 1.0 / length) / kappa
        sound = 1.0 / (root * time)
        return ratio * time, ratio - sound, 16.0 / 27.0 * density * sound**3 / d

    def profile(x, time):
        return {name: np.full_like(x, value) for name, value in zip(("position", "velocity", "pressure"), state(time))}

    numbers = {"terminal_velocity": float(terminal_velocity(mass_ratio, d)), "arrival_time": length / d}
    return Solution("end-on plate", "planar", profile, lambda time: (float(state(time)[0]),), numbers)


GURNEY_CONSTANT = {"symmetric": 1.0 / 3.0, "cylinder": 0.5, "sphere": 0.6}


def gurney(configuration: str, mass_ratio: float, gurney_velocity: float) -> float:
    """Gurney's metal velocity, m/s.

    configuration "open" (sandwich with one plate), "symmetric", "cylinder" or "sphere"; mass_ratio = M/C, where M counts both
    plates of the symmetric sandwich; gurney_velocity = sqrt(2E), m/s.
    """
    if configuration == "open":
        return asymmetric_sandwich(mass_ratio, 0.0, gurney_velocity)[0]
    if mass_ratio <= 0.0:
        raise OutOfRange(f"mass_ratio = {mass_ratio:g} must be positive")
    if configuration not in GURNEY_CONSTANT:
        raise OutOfRange(f"configuration = {configuration!r} must be one of open, {', '.join(GURNEY_CONSTANT)}")
    return gurney_velocity / float(np.sqrt(mass_ratio + GURNEY_CONSTANT[configuration]))


def asymmetric_sandwich(mass_ratio: float, tamper_ratio: float, gurney_velocity: float) -> tuple[float, float]:
    """Gurney's velocities of a plate and of the tamper on the other side of the explosive, both positive outwards, m/s.

    mass_ratio = M/C of the plate, tamper_ratio = N/C of the tamper, 0 for none (then the second velocity is that of the gas there);
    gurney_velocity = sqrt(2E), m/s.
    """
    if mass_ratio <= 0.0:
        raise OutOfRange(f"mass_ratio = {mass_ratio:g} must be positive")
    if tamper_ratio < 0.0:
        raise OutOfRange(f"tamper_ratio = {tamper_ratio:g} must not be negative")
    ratio = (1.0 + 2.0 * mass_ratio) / (1.0 + 2.0 * tamper_ratio)
    energy = mass_ratio + tamper_ratio * ratio**2 + (1.0 + ratio**3) / (3.0 * (1.0 + ratio))
    plate = gurney_velocity / float(np.sqrt(energy))
    return plate, ratio * plate
