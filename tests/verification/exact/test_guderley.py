"""Guderley's converging shock: printed exponents (B7), known compressions, jumps, equations of motion, conservation."""

import numpy as np
import pytest
from flow_checks import jump_residual, residuals, total

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.guderley import exponent

PRINTED = [("spherical", 1.4, 0.7171745015), ("spherical", 5.0 / 3.0, 0.6883768229), ("spherical", 3.0, 0.6364105940),
           ("cylindrical", 1.4, 0.8353231920), ("cylindrical", 5.0 / 3.0, 0.8156249014), ("cylindrical", 3.0, 0.7756666195)]


@pytest.mark.parametrize("geometry,gamma,alpha", PRINTED)
def test_printed_exponents(geometry, gamma, alpha):
    assert exponent(geometry, gamma) == pytest.approx(alpha, abs=1e-10)


@pytest.mark.parametrize("gamma,focus,reflected", [(1.4, 20.1, 145.0), (5.0 / 3.0, 9.55, 32.3)])
def test_compressions_known_from_the_literature(gamma, focus, reflected):
    numbers = SOLUTIONS["guderley"]("spherical", gamma).numbers
    assert numbers["focus_density"] == pytest.approx(focus, rel=2.5e-3)
    assert numbers["reflected_density"] == pytest.approx(reflected, rel=1.5e-3)


@pytest.mark.parametrize("geometry,gamma", [("spherical", 1.4), ("cylindrical", 5.0 / 3.0), ("spherical", 3.0)])
def test_flow_obeys_the_equations_before_and_after_focussing(geometry, gamma):
    solution = SOLUTIONS["guderley"](geometry, gamma, 1.3, 0.9)
    for time in (-0.7, 0.4):
        assert jump_residual(solution, time, 0) < 1e-6
        shock = solution.jumps(time)[0]
        # fine steps near the shock; the outer stretch of the incoming flow holds the crossing of the sonic characteristic
        assert residuals(solution, np.linspace(1.02 * shock, 1.5 * shock, 60), time, 1e-3) < 3e-7
    assert residuals(solution, np.linspace(0.2 * shock, 0.97 * shock, 60), 0.4, 5e-4) < 3e-7


@pytest.mark.parametrize("geometry,gamma", [("spherical", 1.4), ("cylindrical", 1.4), ("spherical", 5.0 / 3.0)])
def test_mass_and_energy_inside_a_particle_path_are_conserved(geometry, gamma):
    """A ball bounded by a material surface: its mass is constant, its energy changes by the work on the surface."""
    solution = SOLUTIONS["guderley"](geometry, gamma)
    d = 3 if geometry == "spherical" else 2
    times = np.linspace(-0.2, 0.5, 561)
    radius, held, work = [1.2], [], [0.0]
    for a, b in zip(times[:-1], times[1:]):
        def speed(r, t):
            return float(solution(np.array([r]), t)["velocity"][0])
        k1 = speed(radius[-1], a)
        k2 = speed(radius[-1] + 0.5 * (b - a) * k1, 0.5 * (a + b))
        k3 = speed(radius[-1] + 0.5 * (b - a) * k2, 0.5 * (a + b))
        k4 = speed(radius[-1] + (b - a) * k3, b)
        new = radius[-1] + (b - a) / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4)
        middle = radius[-1] + 0.5 * (b - a) * k2
        rates = []
        for r, t in ((radius[-1], a), (middle, 0.5 * (a + b)), (new, b)):
            f = solution(np.array([r]), t)
            rates.append(-float(f["pressure"][0] * f["velocity"][0]) * r ** (d - 1))
        work.append(work[-1] + (b - a) / 6.0 * (rates[0] + 4 * rates[1] + rates[2]))
        radius.append(new)
    for time in (-0.2, -0.01, 0.05, 0.5):
        i = int(round((time + 0.2) / 0.7 * 560))
        when, outer = times[i], radius[i]
        shock = solution.jumps(when)[0]
        edges = np.concatenate((shock * np.array([0.0, 0.01, 0.1, 0.5, 1.0]), np.geomspace(shock, outer, 8)[1:]))
        contents = [lambda f, x: f["density"], lambda f, x: f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2)]
        mass, energy = (total(solution, when, edges, c, 1600) for c in contents)
        held.append((mass, energy - work[i]))
    for mass, energy in held[1:]:
        assert mass == pytest.approx(held[0][0], rel=1e-6)
        assert energy == pytest.approx(held[0][1], rel=1e-5)


def test_centre_after_reflection_has_uniform_pressure():
    solution = SOLUTIONS["guderley"]()
    shock = solution.jumps(1.0)[0]
    p = solution(shock * np.array([0.0, 1e-6, 1e-3, 1e-2]), 1.0)["pressure"]
    assert p == pytest.approx(p[2], rel=1e-4)
    with pytest.raises(OutOfRange, match="cylindrical or spherical"):
        exponent("planar", 1.4)
