"""Compatibility relations with reaction (Starkenberg ARL-TR-2161 section 6, S-E4) along characteristics of exact flows."""

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.eos.jwl import JWL
from hugoniot.theory import characteristics
from hugoniot.theory import mixture as tool

RHO0 = 1895.0
PRODUCTS = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, RHO0, 6.9e9, 1.0e6 / RHO0)
UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, RHO0, 0.0, 2.487e6 / RHO0)
SPEED = 8000.0     # an overdriven wave in this pair (CJ speed about 7.7 km/s)
H = 1e-3


def rest_energy():
    return -eos.pressure(RHO0, 0.0, UNREACTED) / eos.pressure_derivatives(RHO0, 0.0, UNREACTED)[1]


def reaction_zone(par, burn_fractions):
    """(v, u, p, state) behind a steady shock of SPEED: mass, momentum and energy with p(v, e, lambda), solved by Newton in v."""
    v0, e0 = 1.0 / RHO0, rest_energy() + par.detonation_energy

    def rayleigh(v):
        return (RHO0 * SPEED) ** 2 * (v0 - v)

    def newton(v, pressure_and_slope):
        for _ in range(50):
            p, p_v, p_e = pressure_and_slope(v, e0 + 0.5 * rayleigh(v) * (v0 - v))
            energy_slope = -(RHO0 * SPEED) ** 2 * (v0 - v)
            step = (rayleigh(v) - p) / (-((RHO0 * SPEED) ** 2) - p_v - p_e * energy_slope)
            v = v - step
            if abs(step) < 1e-15 * v:
                break
        return v

    def bare(v, e):
        p_rho, p_e = eos.pressure_derivatives(1.0 / v, e - par.detonation_energy, UNREACTED)
        return eos.pressure(1.0 / v, e - par.detonation_energy, UNREACTED), -p_rho / v**2, p_e

    v_spike = newton(0.6 * v0, bare)
    reference = (1.0 / v_spike, e0 + 0.5 * rayleigh(v_spike) * (v0 - v_spike))
    volumes, v = [], v_spike
    for lam in burn_fractions:
        def mixed(v, e, lam=lam):
            s = tool.solve(1.0 / v, e, lam, par, reference)
            return float(s.pressure), float(s.pressure_by_volume), float(s.pressure_by_energy)
        v = newton(v, mixed)
        volumes.append(v)
    v = np.array(volumes)
    p, u = rayleigh(v), RHO0 * SPEED * (v0 - v)
    return u, p, tool.solve(1.0 / v, e0 + 0.5 * p * (v0 - v), burn_fractions, par, reference)


@pytest.mark.parametrize("kind", ("thermal_isolation", "thermal_equilibrium"))
@pytest.mark.parametrize("centre", (0.2, 0.5, 0.8))
def test_steady_reaction_zone_obeys_both_relations(kind, centre):
    """Along u +- c in a steady wave dx/dt = u - D in the wave frame, d/dt = (u +- c - D) d/dx, and d(lambda)/dx = rate/(u - D)."""
    par = tool.mixture(kind, UNREACTED, PRODUCTS, 3.6e6)
    lam = centre + H * np.arange(-3, 4)
    u, p, state = reaction_zone(par, lam)
    assert np.allclose(state.pressure, p, rtol=1e-10)
    stencil = np.array([-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]) / (60.0 * H)
    rate = 2.5e6
    at_centre = tool.MixtureState(par, *(getattr(state, name)[3] for name in list(state.__dataclass_fields__)[1:]))
    lam_by_x = rate / (u[3] - SPEED)
    p_x, u_x = stencil @ p * lam_by_x, stencil @ u * lam_by_x
    source = float(characteristics.reaction_source(at_centre, rate))
    for sign in (1, -1):
        speed = u[3] + sign * float(at_centre.sound_speed) - SPEED
        miss = characteristics.mismatch(at_centre, sign, speed * p_x, speed * u_x, rate)
        assert abs(miss) < 1e-7 * abs(source)
    # the printed sign on the lower characteristic (S-E4) misses by the size of the terms themselves
    speed = u[3] - float(at_centre.sound_speed) - SPEED
    impedance = np.sqrt(float(at_centre.impedance_squared))
    assert abs(speed * p_x + impedance * speed * u_x - source) > 0.1 * abs(source)


def test_source_is_the_slope_of_pressure_by_burn_fraction():
    par = tool.mixture("thermal_isolation", UNREACTED, PRODUCTS, 3.6e6)
    _, _, state = reaction_zone(par, np.array([0.1, 0.4, 0.9]))
    assert np.allclose(characteristics.reaction_source(state, 1.0), state.pressure_by_burn_fraction, rtol=1e-9)
    sigma = state.pressure_by_burn_fraction / (state.density * state.sound_speed**2)
    assert np.allclose(characteristics.thermicity(state, 3.0), 3.0 * sigma, rtol=1e-9)


def test_simple_wave_of_a_frozen_mixture_and_spherical_uniform_expansion():
    """Without burning: du = -dv i on a centred wave; and u = x/t, rho ~ t^-3 in a sphere of uniform pressure (the geometric term)."""
    par = tool.mixture("thermal_isolation", UNREACTED, PRODUCTS, 3.6e6)
    _, _, zone = reaction_zone(par, np.array([0.5]))
    start = tool.MixtureState(par, *(getattr(zone, name)[0] for name in list(zone.__dataclass_fields__)[1:]))
    v0 = 1.0 / float(start.density)
    path = tool.adiabat(start, v0 * (1.0 + 1e-3 * np.arange(0, 7)))
    stencil = np.array([-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]) / (60.0 * 1e-3 * v0)
    middle = tool.MixtureState(par, *(getattr(path, name)[3] for name in list(path.__dataclass_fields__)[1:]))
    impedance = np.sqrt(float(middle.impedance_squared))
    # right-going simple wave: u + integral(i dv) is constant in it, so along the crossing characteristic u - c, dp = +rho c du
    p_rate, u_rate = stencil @ path.pressure, -impedance
    assert abs(characteristics.mismatch(middle, -1, p_rate, u_rate, 0.0)) < 1e-7 * abs(p_rate)
    # homologous sphere: dp/dt = -i^2 dv/dt with dv/dt = 3 v/t; du/dt along u +- c is +-c/t because u = x/t
    t, x = 1e-6, 0.01
    c, v = float(middle.sound_speed), 1.0 / float(middle.density)
    p_rate = -float(middle.impedance_squared) * 3.0 * v / t
    for sign in (1, -1):
        miss = characteristics.mismatch(middle, sign, p_rate, sign * c / t, 0.0, velocity=x / t, position=x, dimension=3)
        assert abs(miss) < 1e-12 * abs(p_rate)
