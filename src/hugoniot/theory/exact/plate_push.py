r"""Plates driven by explosives: the closed-form motion of a plate at the end of a slab of gamma = 3 explosive, and Gurney's formulas.

The closed-form motion tests, to about 1 %, a solver with a detonation that accelerates metal; Gurney's formulas estimate the velocity of
driven metal.

**End-on plate.** A slab of explosive of length $L$ is lit at its free end $x = 0$; a rigid plate of mass $M$ per area lies at $x = L$.
The charge has the mass $C = \rho_0 L$ per area. For gamma = 3 the characteristics are straight, and behind the front $u + c = x/t$ and $p
= \tfrac{16}{27}\rho_0 c^3/D$ with the detonation velocity $D$. The motion $x(t)$ of the plate then follows from $M\ddot x = p$:

$$ct = \left(a - 2\kappa/t\right)^{-1/2},\quad \frac xt = D - \frac1\kappa\left[\sqrt{a - 2\kappa/t} - \frac1L\right], \qquad
  \kappa = \frac{16\rho_0}{27 DM}, \quad a = \frac{1}{L^2} + \frac{2\kappa D}{L}$$
$$\frac{v_\infty}{D} = 1 - \frac{27M}{16C}\left(\sqrt{1 + \frac{32C}{27M}} - 1\right)$$

where $c$ is the sound speed of the products at the plate and $v_\infty$ the final velocity. The solution takes $u + c$ as unchanged
across the shock reflected from the plate, which violates the conservation of momentum and energy there. If the shock conserves mass,
momentum and energy, the plate is at late times 0.5 % faster than here at M/C = 0.1 and 1.0 % faster at M/C = 5. If it conserves only mass
and momentum, and the products keep $p = K\rho^3$ with the same $K$ behind it (no rise of the entropy), the plate is 0.25 % slower than
here at M/C = 0.1 and 1.3 % slower at M/C = 5.

**Gurney's formulas** assume a velocity of the products linear in the position and a uniform energy release $E$ per mass of explosive. The
velocity $v$ of the metal is

$$\frac{v}{\sqrt{2E}} = (\mu + k)^{-1/2}, \qquad \mu = \frac MC$$

with the ratio $\mu$ of the masses of metal and explosive, and $k$ = 1/3 for a symmetric sandwich (where $M$ counts both plates), 1/2 for
a cylinder and 3/5 for a sphere. In an asymmetric sandwich the tamper on the other side of the explosive, of mass $N$ with $\nu = N/C$,
moves at $A v$ in the opposite direction:

$$A = \frac{1 + 2\mu}{1 + 2\nu}, \qquad \frac{v}{\sqrt{2E}} = \left[\mu + \nu A^2 + \frac{1 + A^3}{3(1 + A)}\right]^{-1/2}$$

The open sandwich has no tamper, $\nu = 0$.

Source: Aziz, Hurwitz & Sternberg, Phys. Fluids 4 (1961) 380; Gurney, BRL Report 405 (1943); both derived for this project.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def terminal_velocity(mass_ratio: float, detonation_velocity: float) -> float:
    """Final velocity of an end-on plate, m/s.

    mass_ratio            M/C, mass of the plate divided by that of the explosive
    detonation_velocity   detonation velocity of the explosive, m/s
    """
    k = 27.0 * mass_ratio / 16.0
    return detonation_velocity * (1.0 - k * (np.sqrt(1.0 + 2.0 / k) - 1.0))


def plate_push(mass_ratio: float = 1.0, detonation_velocity: float = 8000.0, density: float = 1600.0, length: float = 0.1) -> Solution:
    """Plate driven end-on by a slab of gamma = 3 explosive that is lit at its free end x = 0, with vacuum on both sides.

    mass_ratio            M/C, mass of the plate divided by that of the explosive
    detonation_velocity   detonation velocity D of the explosive
    density               initial density of the explosive
    length                length L of the slab, initial position of the plate

    The result is the motion of the plate as a function of time. In Python the positions given are ignored, except for the shape of their
    array.

    Fields: position (m) and velocity of the plate, pressure on it. Numbers: terminal_velocity, arrival_time (of the front at the plate).
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
    """Metal velocity by Gurney's formulas, m/s.

    configuration     open (sandwich with one plate), symmetric (sandwich), cylinder or sphere
    mass_ratio        M/C, mass of the metal (of both plates of the symmetric sandwich) divided by that of the explosive
    gurney_velocity   sqrt(2E) of the explosive, m/s
    """
    if configuration == "open":
        return asymmetric_sandwich(mass_ratio, 0.0, gurney_velocity)[0]
    if mass_ratio <= 0.0:
        raise OutOfRange(f"mass_ratio = {mass_ratio:g} must be positive")
    if configuration not in GURNEY_CONSTANT:
        raise OutOfRange(f"configuration = {configuration!r} must be one of open, {', '.join(GURNEY_CONSTANT)}")
    return gurney_velocity / float(np.sqrt(mass_ratio + GURNEY_CONSTANT[configuration]))


def asymmetric_sandwich(mass_ratio: float, tamper_ratio: float, gurney_velocity: float) -> tuple[float, float]:
    """Velocities of a plate and of the tamper on the other side of the explosive by Gurney's formulas, both positive outwards, m/s.

    mass_ratio        M/C, mass of the plate divided by that of the explosive
    tamper_ratio      N/C, mass of the tamper divided by that of the explosive; 0: no tamper, and the second velocity is that
                      of the gas
    gurney_velocity   sqrt(2E) of the explosive, m/s
    """
    if mass_ratio <= 0.0:
        raise OutOfRange(f"mass_ratio = {mass_ratio:g} must be positive")
    if tamper_ratio < 0.0:
        raise OutOfRange(f"tamper_ratio = {tamper_ratio:g} must not be negative")
    ratio = (1.0 + 2.0 * mass_ratio) / (1.0 + 2.0 * tamper_ratio)
    energy = mass_ratio + tamper_ratio * ratio**2 + (1.0 + ratio**3) / (3.0 * (1.0 + ratio))
    plate = gurney_velocity / float(np.sqrt(energy))
    return plate, ratio * plate
