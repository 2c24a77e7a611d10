r"""Blake's problem: a pressure applied suddenly to the wall of a spherical cavity in an unbounded elastic solid.

It tests the elastic response and the geometry terms of a solver in spherical flow, where the exact stress is known behind a moving front.

With the longitudinal sound speed $c = \sqrt{(K + \tfrac43G)/\rho}$ and the shear wave speed $c_s = \sqrt{G/\rho}$, the outgoing waves have
the potential $f(\tau)/r$, where $\tau = t - (r-a)/c$ is the time since the front passed:

$$u = -\frac{f}{r^2} - \frac{f'}{cr},\quad v = -\frac{f'}{r^2} - \frac{f''}{cr},\quad \nabla\cdot u = \frac{f''}{c^2r},\quad
  \sigma_r = \frac{\rho f''}{r} + \frac{4G f'}{cr^2} + \frac{4G f}{r^3}$$

* $P$: pressure on the wall, `pressure`; $a$: radius of the cavity, `radius`
* $\rho$, $K$, $G$: density, bulk modulus and shear modulus of the solid
* $u$, $v$: displacement and velocity at the radius $r$ and the time $t$; $\sigma_r$: radial stress, positive in tension

The condition at the wall, $\sigma_r(a) = -P$, is the equation of a damped oscillator, $f'' + 2\alpha f' + \omega_0^2 f = -Pa/\rho$ with
$\alpha = 2c_s^2/(ca)$ and $\omega_0 = 2c_s/a$. Its solution from rest is, with $\omega^2 = \omega_0^2 - \alpha^2$,

$$f = -\frac{Pa^3}{4G}\left[1 - e^{-\alpha\tau}\left(\cos\omega\tau + \frac\alpha\omega\sin\omega\tau\right)\right]$$

At the front the compressive stress is $Pa/r$. Far behind it the solid is at rest with the displacement $Pa^3/(4Gr^2)$ and its initial
density.

Source: Blake, J. Acoust. Soc. Am. 24 (1952) 211; Sharpe, Geophysics 7 (1942) 144; derived for this project.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def blake(pressure: float = 1e6, radius: float = 0.1, density: float = 3000.0, bulk_modulus: float = 125e9 / 3.0,
          shear_modulus: float = 25e9) -> Solution:
    """Blake's spherical cavity: a pressure applied suddenly to the wall of a cavity in an elastic solid.

    pressure        pressure on the wall
    radius          radius of the cavity
    density         density of the solid
    bulk_modulus    bulk modulus of the solid
    shear_modulus   shear modulus of the solid

    Strains are small: positions are radii in the undeformed solid, from the cavity outwards.

    Fields: displacement (m), velocity, pressure, density, and stress (radial) and hoop_stress, both positive in compression.
    Numbers: sound_speed (longitudinal), shear_speed, decay_time (1/alpha), period (2 pi/omega), final_displacement and
    largest_displacement (both of the wall).
    """
    if min(pressure, radius, density, bulk_modulus, shear_modulus) <= 0.0:
        raise OutOfRange("Blake's cavity needs positive pressure, radius, density and moduli")
    a, g = radius, shear_modulus
    c = np.sqrt((bulk_modulus + 4.0 / 3.0 * g) / density)
    shear = np.sqrt(g / density)
    decay, natural = 2.0 * shear**2 / (c * a), 2.0 * shear / a
    omega = np.sqrt(natural**2 - decay**2)  # always real: c exceeds the shear speed

    def potential(tau):
        """(f, f', f'') at the retarded time."""
        swing, cosine, sine = np.exp(-decay * tau), np.cos(omega * tau), np.sin(omega * tau)
        f = -pressure * a**3 / (4.0 * g) * (1.0 - swing * (cosine + decay / omega * sine))
        return f, -pressure * a / density * swing * sine / omega, -pressure * a / density * swing * (cosine - decay / omega * sine)

    def profile(r, time):
        if (r < a * (1.0 - 1e-12)).any():
            raise OutOfRange(f"a position lies inside the cavity, whose radius is {a:g} m")
        tau = time - (r - a) / c
        behind = tau >= 0.0
        f, f1, f2 = (np.where(behind, values, 0.0) for values in potential(np.where(behind, tau, 0.0)))
        dilatation = f2 / (c * c * r)
        displacement = -f / r**2 - f1 / (c * r)
        radial = density * f2 / r + 4.0 * g * f1 / (c * r * r) + 4.0 * g * f / r**3
        hoop = (bulk_modulus - 2.0 / 3.0 * g) * dilatation + 2.0 * g * displacement / r
        return {"displacement": displacement, "velocity": -f1 / r**2 - f2 / (c * r), "pressure": -bulk_modulus * dilatation,
                "stress": -radial, "hoop_stress": -hoop, "density": density * (1.0 - dilatation)}

    final = pressure * a / (4.0 * g)
    numbers = {"sound_speed": float(c), "shear_speed": float(shear), "decay_time": float(1.0 / decay), "period": float(2.0 * np.pi / omega),
               "final_displacement": float(final), "largest_displacement": _largest(potential, a, c, np.pi / omega)}
    return Solution("Blake, spherical cavity", "spherical", profile, lambda time: (a + c * time,), numbers,
                    domain=lambda time: (a, a + 1.1 * c * time))


def _largest(potential, a: float, c: float, half: float) -> float:
    """Largest displacement of the wall: where its velocity -f'/a^2 - f''/(ca) first vanishes, by bisection within half a period."""
    def velocity(tau):
        _, f1, f2 = potential(tau)
        return -f1 / a**2 - f2 / (c * a)

    low, high = 0.0, 2.0 * half
    while velocity(low + 0.02 * half) > 0.0 and low < high:
        low += 0.02 * half
    high = low + 0.02 * half
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if velocity(middle) > 0.0 else (low, middle)
    f, f1, _ = potential(low)
    return float(-f / a**2 - f1 / (c * a))
