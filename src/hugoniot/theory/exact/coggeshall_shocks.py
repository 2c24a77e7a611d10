r"""Coggeshall's adiabatic flows in which cold gas flows through a shock.

They test a solver with an infinitely strong shock in a moving or non-uniform flow. The density of the ideal gas, with the ratio of specific
heats $\gamma$, rises by a factor of $(\gamma+1)/(\gamma-1)$ across the shock; $d$ = 1, 2, 3 in planar, cylindrical and spherical geometry.
The numbers of the problems are Coggeshall's.

**Problem 20** is Noh's implosion in a frame that expands at the rate $a$, for $\gamma = 1 + 2/d$. With $h = 1 + at$, the speed $U$ of the
inflow, its density $\rho_0$ at $t = 0$ and the shock at $r_s = \tfrac12(\gamma-1)Ut$,

$$r > r_s:\; \rho = \rho_0h^{-d}\left(1 + \frac{Ut}{r}\right)^{d-1},\; u = \frac{ar - U}{h},\; p = 0; \qquad
  r < r_s:\; \rho = \rho_0h^{-d}\left(\frac{\gamma+1}{\gamma-1}\right)^{d},\; u = \frac{ar}{h},\; e = \frac{U^2}{2h^2}$$

Only for this gamma does the transformation to $(r/h, t/h)$ leave the equations of the gas unchanged; $r_s/h$ is Noh's shock at the time
$t/h$.

**Problem 21**: gas flows inwards with a time of collapse $\tau$ and stops behind an outgoing shock. With $T = 1 - t/\tau$ and the shock at
$R = R_0T^{-(\gamma-1)/2}$

$$r > R:\; \rho = \rho_0\left(\frac{r}{R_0}\right)^bT^{-b-d},\; u = -\frac{r}{\tau T},\; p = 0,\; b = -2 - \frac{2d}{\gamma+1}; \qquad
  r < R:\; \rho = \frac{\gamma+1}{\gamma-1}\rho_0\left(\frac{r}{R_0}\right)^{-2(\gamma+1)/(\gamma-1)},\; u = 0,\;
  p = \frac{\gamma+1}{2}\rho_0\frac{R_0^2}{\tau^2}$$

where $R_0$ is the radius of the shock and $\rho_0$ the density just ahead of it at $t = 0$. The gas behind the shock is at rest under a
uniform and constant pressure. The mass around the centre is infinite unless $2(\gamma+1)/(\gamma-1) < d$. Coggeshall has $d = 3$, $\gamma
= 5$, $b = -3$, and $u = r/t$ with an ingoing shock. For $t > 0$ that is the present flow reversed in time, in which the entropy would
decrease across the shock.

Source: Coggeshall, Phys. Fluids A 3 (1991) 757, problems 20 and 21; the positions of the shocks, and problem 21 for any gamma, follow from
the jump conditions.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution


def coggeshall_noh(geometry: str = "spherical", rate: float = 0.3, speed: float = 1.0, density: float = 1.0) -> Solution:
    """Noh's implosion in an expanding or contracting frame (Coggeshall): gamma = 1 + 2/d (planar 3, cylindrical 2, spherical 5/3).

    geometry   planar, cylindrical or spherical
    rate       rate a of the frame's expansion at time 0, negative for contraction
    speed      speed U of the inflow, towards r = 0
    density    density of the inflow at time 0

    Fields: density, velocity, pressure, energy. Numbers: gamma, shock_speed. Valid while 1 + a t > 0.
    """
    if min(speed, density) <= 0.0:
        raise OutOfRange(f"Coggeshall's implosion needs positive speed and density, got speed = {speed:g} m/s and density = {density:g} "
                         "kg/m3")
    d = DIMENSION[geometry]
    gamma = 1.0 + 2.0 / d
    shock = 0.5 * (gamma - 1.0) * speed

    def profile(r, time):
        h, inside = 1.0 + rate * time, r < shock * time
        ahead = (1.0 + speed * time / np.where(inside, np.inf, r)) ** (d - 1)
        rho = density * h**-d * np.where(inside, ((gamma + 1.0) / (gamma - 1.0)) ** d, ahead)
        e = np.where(inside, 0.5 * (speed / h) ** 2, 0.0)
        return {"density": rho, "velocity": (rate * r - np.where(inside, 0.0, speed)) / h, "pressure": (gamma - 1.0) * rho * e, "energy": e}

    last = np.inf if rate >= 0.0 else (1.0 - 1e-12) / -rate
    return Solution(f"Coggeshall, Noh in a moving frame, {geometry}", geometry, profile, lambda time: (shock * time,),
                    {"gamma": gamma, "shock_speed": shock}, (1e-300, last))


def coggeshall_stopping(geometry: str = "spherical", gamma: float = 5.0, radius: float = 0.1, density: float = 1.0,
                        collapse_time: float = 1.0) -> Solution:
    """Cold gas that flows inwards and stops behind an outgoing shock (Coggeshall), with densities that are powers of the radius.

    geometry        planar, cylindrical or spherical
    gamma           ratio of specific heats, above 1
    radius          radius of the shock at time 0
    density         density just ahead of the shock at time 0
    collapse_time   time at which the inflow would reach r = 0

    Fields: density, velocity, pressure, energy, at r > 0. Numbers: slope (exponent b of the density ahead), pressure (behind the shock).
    Valid for times below collapse_time.
    """
    if gamma <= 1.0 or min(radius, density, collapse_time) <= 0.0:
        raise OutOfRange("Coggeshall's stopping gas needs gamma > 1 and a positive radius, density and collapse_time")
    d, jump = DIMENSION[geometry], (gamma + 1.0) / (gamma - 1.0)
    slope = -2.0 - 2.0 * d / (gamma + 1.0)
    pressure = 0.5 * (gamma + 1.0) * density * (radius / collapse_time) ** 2

    def place(time):
        return radius * (1.0 - time / collapse_time) ** (-0.5 * (gamma - 1.0))

    def profile(r, time):
        left, inside = 1.0 - time / collapse_time, r < place(time)
        with np.errstate(divide="ignore"):
            rho = density * np.where(inside, jump * (r / radius) ** (-2.0 * jump), (r / radius) ** slope * left ** (-slope - d))
        p = np.where(inside, pressure, 0.0)
        return {"density": rho, "velocity": np.where(inside, 0.0, -r / (collapse_time * left)), "pressure": p,
                "energy": p / ((gamma - 1.0) * rho)}

    return Solution(f"Coggeshall, stopping gas, {geometry}", geometry, profile, lambda time: (float(place(time)),),
                    {"slope": slope, "pressure": pressure}, (0.0, collapse_time * (1.0 - 1e-12)),
                    lambda time: (0.3 * float(place(time)), 3.0 * float(place(time))))
