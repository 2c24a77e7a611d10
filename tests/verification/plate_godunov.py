"""A second, independent scheme for the end-on plate of B22: a Lagrangian Godunov method of second order, gamma = 3, without viscosity.

It starts from the exact Taylor wave at the moment the detonation reaches the plate, so that nothing of the solver under test takes part:
no burn, no staggered mesh, no artificial viscosity. Fluxes from impedances rho (c + 2 |u* - u|), which are exact for strong shocks of
gamma = 3; limited linear profiles; Hancock's half step.
"""

import numpy as np

GAMMA = 3.0
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(5)


def _taylor_wave(cells, speed, density, length):
    """(mass, volume per mass, velocity, total energy) of equal masses between the escape front and the detonation at the plate."""
    time = length / speed
    edge = speed * (-0.5 + 1.5 * np.sqrt(np.linspace(0.0, 1.0, cells + 1)))
    y = 0.5 * (edge[1:] + edge[:-1])[:, None] + 0.5 * np.diff(edge)[:, None] * POINTS
    u, c = 0.5 * (y - 0.5 * speed), 0.5 * (y + 0.5 * speed)
    share = c * WEIGHTS / np.sum(c * WEIGHTS, axis=1, keepdims=True)
    mass = density * length / cells
    return mass, np.diff(edge) * time / mass, np.sum(share * u, axis=1), np.sum(share * (0.5 * u * u + c * c / 6.0), axis=1)


def _slope(x):
    """Monotonized central differences of cell values over a cell; half the one-sided ones at the two ends."""
    d = np.diff(x)
    a, b = d[:-1], d[1:]
    inner = np.where(a * b > 0.0, np.sign(a) * np.minimum(0.5 * np.abs(a + b), 2.0 * np.minimum(np.abs(a), np.abs(b))), 0.0)
    return np.concatenate(([0.0], inner, [0.5 * d[-1]]))


def _impedances(left, right, u):
    return (rho * (c + 2.0 * np.abs(u - velocity)) for _, velocity, rho, c in (left, right))


def plate_velocity(ratio, stop, cells, speed=8000.0, density=1600.0, length=0.1):
    """Velocity (m/s) at time `stop` of a plate with M/C = ratio."""
    mass, v, u, e = _taylor_wave(cells, speed, density, length)
    time, plate, heavy = length / speed, 0.0, ratio * density * length
    while time < stop:
        p = np.maximum((GAMMA - 1.0) * (e - 0.5 * u * u), 1e-12 * e) / v
        c = np.sqrt(GAMMA * p * v)
        dt = min(0.4 * float(np.min((mass * v / c)[1:])), stop - time)
        h, du, dp, dr = 0.5 * dt / mass, _slope(u), _slope(p), _slope(1.0 / v)
        mid_p, mid_u, mid_r = p - h * (c / v) ** 2 * du, u - h * dp, 1.0 / v - h * du / v**2

        def edge(side, mid_p=mid_p, mid_u=mid_u, mid_r=mid_r, dp=dp, du=du, dr=dr, p=p, v=v):
            p_, r_ = np.maximum(mid_p + side * dp, 1e-3 * p), np.maximum(mid_r + side * dr, 1e-3 / v)
            return np.array([p_, mid_u + side * du, r_, np.sqrt(GAMMA * p_ / r_)])
        ahead, behind = edge(0.5), edge(-0.5)
        left, right = ahead[:, :-1], behind[:, 1:]
        star = 0.5 * (left[1] + right[1])
        for _ in range(4):
            zl, zr = _impedances(left, right, star)
            star = (zl * left[1] + zr * right[1] + left[0] - right[0]) / (zl + zr)
        push = left[0] - zl * (star - left[1])
        p_, u_, r_, c_ = ahead[:, -1]
        now = plate
        for _ in range(30):     # the plate's mean velocity and the pressure on it
            mean = 0.5 * (plate + now)
            on_plate = p_ + r_ * (c_ + 2.0 * abs(u_ - mean)) * (u_ - mean) if u_ > mean else p_ * max(1.0 - (mean - u_) / c_, 0.0) ** 3
            now = plate + dt * on_plate / heavy
        pressure = np.concatenate(([0.0], push, [on_plate]))
        face = np.concatenate(([u[0] - c[0]], star, [0.5 * (plate + now)]))
        v, u, e = v + dt / mass * np.diff(face), u - dt / mass * np.diff(pressure), e - dt / mass * np.diff(pressure * face)
        plate, time = now, time + dt
    return plate
