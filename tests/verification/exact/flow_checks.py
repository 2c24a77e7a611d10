"""Checks of a gas-dynamic solution that know nothing of how it was found: differential equations, jumps, conserved sums."""

import numpy as np

DIMENSION = {"planar": 1, "cylindrical": 2, "spherical": 3}


def residuals(solution, x, time, step=1e-4, fields=("density", "velocity", "pressure", "energy")):
    """Largest scaled residual of mass, momentum and energy conservation at smooth points x, by fourth-order differences.

    step: difference in time and, relative to the spread of x, in position.
    """
    d = DIMENSION[solution.geometry]
    h, dt = step * (np.max(x) - np.min(x)), step * time
    weights = np.array([1.0, -8.0, 8.0, -1.0]) / 12.0

    def value(points, when):
        return np.array([solution(points, when)[name] for name in fields])

    here = value(x, time)
    by_x = sum(w * value(x + k * h, time) for w, k in zip(weights, (-2, -1, 1, 2))) / h
    by_t = sum(w * value(x, time + k * dt) for w, k in zip(weights, (-2, -1, 1, 2))) / dt
    rho, u, p, _ = here
    divergence = by_x[1] + (d - 1) * u / x if d > 1 else by_x[1]
    mass = by_t[0] + u * by_x[0] + rho * divergence
    momentum = rho * (by_t[1] + u * by_x[1]) + by_x[2]
    energy = rho * (by_t[3] + u * by_x[3]) + p * divergence
    speed, heat = np.max(np.abs(u)) + np.max(np.sqrt(np.abs(p / rho))), np.max(np.abs(here[3]))
    floors = np.max(rho) / abs(time) * np.array([1.0, speed, heat + speed**2])
    terms = ((by_t[0], u * by_x[0], rho * divergence), (rho * by_t[1], rho * u * by_x[1], by_x[2]), (rho * by_t[3], rho * u * by_x[3], p * divergence))
    scales = [max(np.max(np.abs(t)) for t in row) + floor for row, floor in zip(terms, floors)]
    return max(float(np.max(np.abs(r)) / s) for r, s in zip((mass, momentum, energy), scales))


def jump_residual(solution, time, index, release=0.0, stress="pressure", gap=1e-9):
    """Largest scaled violation of the Rankine-Hugoniot relations at jump `index`; `release` is chemical energy per mass set free there."""
    place, later = solution.jumps(time)[index], solution.jumps(time * (1 + 1e-6))[index]
    earlier = solution.jumps(time * (1 - 1e-6))[index]
    speed = (later - earlier) / (2e-6 * time)
    scale = max(abs(place), 1e-3)
    a, b = (solution(np.array([place + side * gap * scale]), time) for side in (-1.0, 1.0))
    flux = [s["density"][0] * (speed - s["velocity"][0]) for s in (a, b)]
    momentum = [f * s["velocity"][0] - s[stress][0] for f, s in zip(flux, (a, b))]
    energy = [f * (s["energy"][0] + extra + 0.5 * s["velocity"][0] ** 2) - s[stress][0] * s["velocity"][0]
              for f, s, extra in zip(flux, (a, b), (0.0, release))]
    sizes = [max(abs(f) for f in flux), max(abs(f * s["velocity"][0]) + abs(s[stress][0]) for f, s in zip(flux, (a, b))),
             max(abs(f) * (abs(s["energy"][0]) + 0.5 * s["velocity"][0] ** 2) + abs(s[stress][0] * s["velocity"][0]) for f, s in zip(flux, (a, b)))]
    floor = 1e-3 * abs(speed) * max(s["density"][0] for s in (a, b))
    return max(abs(pair[0] - pair[1]) / (size + floor * abs(speed) ** k + 1e-300) for k, (pair, size) in enumerate(zip((flux, momentum, energy), sizes)))


def total(solution, time, edges, density_of, points=4000):
    """Integral of density_of(fields, x) r^(d-1) dr between consecutive edges by Gauss quadrature on many panels."""
    d = DIMENSION[solution.geometry]
    nodes, weights = np.polynomial.legendre.leggauss(8)
    result = 0.0
    for a, b in zip(edges[:-1], edges[1:]):
        cuts = np.linspace(a, b, points // 8 + 1)
        middle, half = 0.5 * (cuts[1:] + cuts[:-1]), 0.5 * np.diff(cuts)
        x = (middle[:, None] + half[:, None] * nodes).ravel()
        result += np.sum(np.repeat(half, 8) * np.tile(weights, len(half)) * density_of(solution(x, time), x) * x ** (d - 1))
    return float(result)
