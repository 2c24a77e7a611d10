r"""A shell of incompressible, rigid-perfectly plastic material that flies inwards and stops when its kinetic energy is spent.

It tests the plastic work that a solver computes in convergent flow: the radius at which the shell stops.

The shell lies between the radii $a(t)$ and $b(t)$, in cylindrical geometry ($d = 2$, plane strain) or spherical geometry ($d = 3$), and
flows as $u = -C(t)/r^{d-1}$. Its kinetic energy $T$ and the power $\dot W$ of plastic work are

$$d=2:\; T = \pi\rho\,C^2\ln\frac ba,\quad \dot W = \frac{4\pi}{\sqrt3}\,Y\,C\ln\frac ba; \qquad
  d=3:\; T = 2\pi\rho\,C^2\left(\frac1a-\frac1b\right),\quad \dot W = 8\pi\,Y\,C\ln\frac ba$$

with the density $\rho$, the yield stress $Y$ and $C\,dt = -a^{d-1}da$. The work $W$ down to a radius is an integral over $a$; then $C(a)$
follows from $T = T_0 - W$ with the initial kinetic energy $T_0$, the stopping radius from $T = 0$ and the motion from $t = -\int
a^{d-1}da/C$.

Source: Verney, Evaluation of the plastic limit of metals under explosive shells (1968); Howell & Ball, J. Comput. Phys. 175 (2002)
128; integrals derived for this project.
"""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact.solution import Solution


def _measure(a, volume, d):
    """(outer radius, integral of u^2 r^(d-1) dr for C = 1) at inner radius a; `volume` = b^d - a^d."""
    b = (a**d + volume) ** (1.0 / d)
    return b, np.log(b / a) if d == 2 else 1.0 / a - 1.0 / b


def _resistance(a, volume, density, yield_stress, d):
    """Plastic work per unit of a^(d-1) da over half the density and the surface factor: the same unit as C^2 times the measure."""
    b = (a**d + volume) ** (1.0 / d)
    factor = 4.0 / np.sqrt(3.0) if d == 2 else 4.0
    return factor * yield_stress / density * np.log(b / a) * a ** (d - 1)


def shell_stopping(geometry: str = "spherical", density: float = 1845.0, yield_stress: float = 330e6, inner: float = 0.08,
                   outer: float = 0.10, speed: float = 675.036) -> Solution:
    """Rigid-plastic shell that flies inwards and stops.

    geometry       cylindrical or spherical
    density        density of the shell
    yield_stress   yield stress in uniaxial stress
    inner          inner radius at time 0
    outer          outer radius at time 0
    speed          inward speed of the inner surface at time 0

    Fields: density, velocity; not a number (NaN) outside the shell. Numbers: stop_radius and stop_outer_radius (of the stopped shell, m),
    stop_time (s), kinetic_energy (at time 0, J per metre of the cylinder or J of the sphere). A shell that reaches the axis or
    the centre has no solution.
    """
    if geometry not in ("cylindrical", "spherical") or not 0.0 < inner < outer or min(density, yield_stress, speed) <= 0.0:
        raise OutOfRange("a stopping shell is cylindrical or spherical, with 0 < inner < outer and positive density, yield stress, speed")
    d = 2 if geometry == "cylindrical" else 3
    volume = outer**d - inner**d
    start = (speed * inner ** (d - 1)) ** 2 * _measure(inner, volume, d)[1]

    def work(a):
        return quad(_resistance, a, inner, args=(volume, density, yield_stress, d), epsabs=0.0, epsrel=1e-13)[0]

    floor = 1e-6 * inner
    if work(floor) < start:
        raise NoSolution(f"the shell reaches r = {floor:.2g} m before its kinetic energy is spent; lower the speed of {speed:g} m/s")
    stop = brentq(lambda a: work(a) - start, floor, inner, xtol=1e-15, rtol=1e-14)

    def strength(a):
        return np.sqrt(max(start - work(a), 0.0) / _measure(a, volume, d)[1])

    def elapsed(a):
        # a = stop + y^2 takes the square-root singularity out of 1/C at the end of the motion
        return quad(lambda y: 2.0 * y * (stop + y * y) ** (d - 1) / strength(stop + y * y),
                    np.sqrt(a - stop), np.sqrt(inner - stop), epsabs=0.0, epsrel=1e-9, limit=200)[0]

    stop_time = elapsed(stop * (1.0 + 1e-14))

    def radius(time):
        return inner if time <= 0.0 else stop if time >= stop_time else brentq(lambda a: elapsed(a) - time, stop * (1 + 1e-13), inner)

    def profile(r, time):
        a = radius(time)
        b = _measure(a, volume, d)[0]
        inside = (r >= a * (1 - 1e-12)) & (r <= b * (1 + 1e-12))
        c = strength(a) if time < stop_time else 0.0
        with np.errstate(divide="ignore"):
            return {"density": np.where(inside, density, np.nan), "velocity": np.where(inside, -c / r ** (d - 1), np.nan)}

    numbers = {"stop_radius": stop, "stop_outer_radius": float(_measure(stop, volume, d)[0]), "stop_time": stop_time,
               "kinetic_energy": (np.pi if d == 2 else 2.0 * np.pi) * density * float(start)}
    return Solution(f"stopping shell, {geometry}", geometry, profile,
                    lambda time: (radius(time), float(_measure(radius(time), volume, d)[0])), numbers)


def howell_ball() -> Solution:
    """Cylindrical beryllium shell that stops at an inner radius of 5 cm (Howell & Ball).

    It is shell_stopping in cylindrical geometry with a speed of 417.1 m/s; the other values are the defaults.
    """
    return shell_stopping("cylindrical", speed=417.1)


def verney() -> Solution:
    """Spherical beryllium shell that stops at an inner radius of 3 cm (Verney).

    It is shell_stopping with the default values.
    """
    return shell_stopping("spherical", speed=675.036)
