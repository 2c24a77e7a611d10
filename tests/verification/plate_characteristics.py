"""The end-on plate of B22 by characteristics with the reflected shock fitted: a third route, without zones, viscosity or a burn.

Ahead of the shock the Taylor wave of a slab lit at its free end is known, c^2 = 9 D m/(16 rho0 t) at the mass m from that end. Between the
shock and the plate, in the mass coordinate m, dp +- rho c du = 0 on dm/dt = +- rho c, entropy stays with its mass, and the plate obeys
M du/dt = p. Points fixed in share of that region; feet by cubic interpolation, coefficients by the trapezoid rule, all second order.

What the reflected wave conserves is a choice, and it is all that tells three answers apart:

    "shock"        mass, momentum and energy: gamma = 3 products, whose entropy rises
    "barotropic"   mass and momentum, with p = K rho^3 on both sides: products without a temperature
    "unbroken"     mass and u + c, with p = K rho^3: neither momentum nor energy. The closed formula of B22
"""

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

GONE = 1e-3      # share of the charge ahead of the shock below which it is taken to have left: nothing enters there any more


def _jump(kind, p2, p1, v1, u1):
    """(v, u, mass flux) behind a shock that runs to the left, from the pressure behind it and the state ahead."""
    if kind == "shock":
        v2 = v1 * (p2 + 2.0 * p1) / (2.0 * p2 + p1)
    else:
        v2 = v1 * np.cbrt(p1 / p2)
    if kind == "unbroken":
        c1, c2 = np.sqrt(3.0 * p1 * v1), np.sqrt(3.0 * p2 * v2)
        return v2, u1 + c1 - c2, c2 / v1
    return v2, u1 - np.sqrt((p2 - p1) * (v1 - v2)), np.sqrt((p2 - p1) / (v1 - v2))


class _Plate:
    """The region between the reflected shock and the plate, on `points` shares of its mass; lengths of one charge, SI."""

    def __init__(self, ratio, kind, points, speed, density, length):
        self.kind, self.speed, self.density = kind, speed, density
        self.charge, self.arrival = density * length, length / speed
        self.plate = ratio * self.charge
        first = self.ahead(self.charge, self.arrival)
        start = brentq(lambda p: _jump(kind, p, *first)[1], 1.01 * first[0], 5.0 * first[0], xtol=1.0)
        v, _, self.flux = _jump(kind, start, *first)
        since = 1e-5 * self.arrival
        self.time, self.place = self.arrival + since, self.charge - self.flux * since
        self.xi = np.linspace(0.0, 1.0, points + 1)
        self.p, self.u = np.full(points + 1, start), self.xi * start * since / self.plate
        self.passed, self.entropy = [self.place, self.charge], [start * v**3] * 2

    def ahead(self, m, t):
        """(p, v, u) of the Taylor wave at mass m from the lit end; p = K rho^3 through the CJ state."""
        c = np.sqrt(9.0 * self.speed * m / (16.0 * self.density * t))
        rho = 16.0 * self.density * c / (9.0 * self.speed)
        return rho * c * c / 3.0, 1.0 / rho, c - 0.5 * self.speed

    def impedance(self, p, m):
        return np.sqrt(3.0) * p ** (2.0 / 3.0) / np.interp(m, self.passed, self.entropy) ** (1.0 / 6.0)

    def step(self, stop):
        z, height = self.impedance(self.p, self.place + (self.charge - self.place) * self.xi), self.charge - self.place
        dt = min(0.5 * height / self.xi.size / z.max(), 0.02 * (self.time - self.arrival), stop - self.time)
        if self.flux > 0.0:
            dt = min(dt, 0.05 * self.place / self.flux)
        field = CubicSpline(self.xi, np.array([self.p, self.u, z]).T)
        p, u, z, flux, v = self.p, self.u, z, self.flux, 0.0
        for _ in range(4):
            place = self.place - 0.5 * dt * (self.flux + flux)
            m = place + (self.charge - place) * self.xi
            right = left = np.array([p, u, z]).T
            for _ in range(3):      # feet of the two characteristics that meet in each point
                right, left = (field(np.clip((m - sign * 0.5 * dt * (foot[:, 2] + z) - self.place) / height, 0.0, 1.0))
                               for sign, foot in ((1.0, right), (-1.0, left)))
            a, b = 0.5 * (right[:, 2] + z), 0.5 * (left[:, 2] + z)
            u = (right[:, 0] - left[:, 0] + a * right[:, 1] + b * left[:, 1]) / (a + b)
            p = right[:, 0] - a * (u - right[:, 1])
            g = 0.5 * dt / self.plate       # the plate: a characteristic from the inside and Newton's law
            u[-1] = (self.u[-1] + g * (self.p[-1] + right[-1, 0] + a[-1] * right[-1, 1])) / (1.0 + g * a[-1])
            p[-1] = right[-1, 0] - a[-1] * (u[-1] - right[-1, 1])
            if self.flux > 0.0:
                p[0], v, u[0], flux = self._overtaken(left[0], b[0], self.ahead(place, self.time + dt))
            z = self.impedance(p, m)
        if self.flux > 0.0:
            self.passed.insert(0, place)
            self.entropy.insert(0, p[0] * v**3)
        self.p, self.u, self.place, self.time = p, u, place, self.time + dt
        self.flux = flux if place > GONE * self.charge else 0.0

    def _overtaken(self, foot, z, ahead):
        """(p, v, u, mass flux) behind the shock: the characteristic that overtakes it, and its jump."""
        p = brentq(lambda p: p - foot[0] - z * (_jump(self.kind, p, *ahead)[1] - foot[1]), ahead[0] * (1.0 + 1e-9),
                   2.0 * max(self.p.max(), ahead[0]), xtol=1e-6 * ahead[0])
        return p, *_jump(self.kind, p, *ahead)


def plate_velocity(ratio, stop, kind, points=20, speed=8000.0, density=1600.0, length=0.1):
    """Velocity (m/s) at time `stop` of a plate with M/C = ratio; `kind` of reflected wave as above."""
    region = _Plate(ratio, kind, points, speed, density, length)
    while region.time < stop:
        region.step(stop)
    return float(region.u[-1])
