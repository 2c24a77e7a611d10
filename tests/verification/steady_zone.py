"""Plane detonations of an ideal gas with a one-step Arrhenius rate, put into the cells of tracked fronts as the steady zone or a normal mode.

Distances y are those behind the front, in half-reaction lengths.
"""

import math
from types import MappingProxyType

import numpy as np
from scipy.integrate import cumulative_simpson, solve_ivp
from scipy.interpolate import CubicSpline

from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.solvers.fronts.cells.mesh import Front, Mesh
from hugoniot.solvers.fronts.cells.solver import Cells

CELLS = SolverOptions("fronts", options=MappingProxyType({"mode": "cells", "burn_step": 0.0}))      # a mesh as fine as it is given
LAST = 30.0      # of s = -ln(1 - lambda): beyond it everything has burned
FAR = 18.0       # of s: beyond it a mode is taken as it is there


class SteadyZone:
    """y, time since the shock, and what stands there: density, velocity in the laboratory, pressure, burn fraction."""

    def __init__(self, wave, points=40001):
        self.wave, self.s = wave, np.linspace(0.0, LAST, points)
        self.burned = -np.expm1(-self.s)
        g, d2 = wave.gamma, wave.velocity**2
        v = (g * (1.0 + d2) - np.sqrt((d2 - g) ** 2 - 2.0 * (g * g - 1.0) * self.burned * wave.heat * d2)) / ((g + 1.0) * d2)
        self.density, self.velocity, self.pressure = 1.0 / v, wave.velocity * (1.0 - v), 1.0 + d2 * (1.0 - v)
        pace = wave.rate_constant * np.exp(-wave.activation * self.density / self.pressure)
        self.time, self.y = (np.concatenate([[0.0], cumulative_simpson(f, x=self.s)]) for f in (1.0 / pace, wave.velocity * v / pace))

    def integrals(self, added=None):
        """Functions of y: contents of mass, momentum, energy and burned mass between the front and y; `added` to the four fields."""
        rho, u, p, burned = (f + a for f, a in zip((self.density, self.velocity, self.pressure, self.burned),
                                                   (0.0,) * 4 if added is None else added))
        wave, last = self.wave, self.y[-1]
        e = p / ((wave.gamma - 1.0) * rho) + (1.0 - burned) * wave.heat
        per_length = [CubicSpline(self.y, q) for q in (rho, rho * u, rho * (e + 0.5 * u * u), rho * burned)]
        whole = [q.antiderivative() for q in per_length]
        return [lambda y, q=q, w=w: w(np.minimum(y, last)) + np.maximum(y - last, 0.0) * q(last) for q, w in zip(per_length, whole)]

    def mode(self, mode):
        """Complex fields of a normal mode, per velocity of the front."""
        start = np.append(self.wave._shock_slopes, 0.0).astype(complex)
        found = solve_ivp(self.wave._slope, (0.0, FAR), start, args=(complex(mode.growth, mode.frequency),), method="DOP853", rtol=1e-10,
                          atol=1e-12, dense_output=True)
        return found.sol(np.minimum(self.s, FAR))[:4]


def material_of(wave):
    gas = IdealGas(wave.gamma, 1.0 / (wave.gamma - 1.0), 1.0)
    return Material("gas", gas, burn=Arrhenius(wave.rate_constant, wave.activation), unreacted=gas, mixture="weighted_pressures",
                    detonation_energy=wave.heat)


def steady_solver(zone, per_half_length, behind, stop, added=None):
    """A solver whose cells hold the steady zone from the start: the front at 0, a piston that moves with the burned gas at -behind."""
    wave = zone.wave
    ahead = 1.01 * wave.velocity * stop + 1.0
    last = wave.velocity + wave.state(1.0)[1]
    counts = round(per_half_length * behind), round(per_half_length * ahead)
    region = Region("gas", "gas", -behind, ahead, sum(counts), density=1.0, pressure=1.0)
    solver = Cells(Problem("steady", "planar", stop, (region,), {"gas": material_of(wave)}, Boundary("velocity", Pulse("constant", last)),
                           Boundary("fixed"), solver=CELLS))
    x = np.concatenate([np.linspace(-behind, 0.0, counts[0] + 1), np.linspace(0.0, ahead, counts[1] + 1)[1:]])
    q, h, rest = np.zeros((sum(counts), 6)), np.diff(x), 1.0 / (wave.gamma - 1.0) + wave.heat
    q[:, 0], q[:, 2] = h, h * rest
    for k, content in enumerate(zone.integrals(added)):
        q[:counts[0], k] = -np.diff(content(-x[:counts[0] + 1]))
    q[:, 4], q[:, 5] = q[:, 0], q[:, 0] * rest
    marked = np.isin(np.arange(len(x)), (0, counts[0], len(x) - 1))
    ends = [front for front in solver.mesh.fronts if front.kind == "end"]
    solver.mesh = Mesh(x, q, np.zeros(len(q), dtype=int), marked, [ends[0], Front("shock", wave.velocity, 1, 0.9), ends[1]], 1)
    solver.mesh.fronts[0].speed = last
    solver.start_totals, solver.start_size = solver.mesh.q.sum(axis=0), solver._size()
    return solver


def zone_errors(zone, per_half_length, stop=1.0, depth=8.0):
    """Errors after a time: of the front's place over its way; mean ones of density, velocity and burn fraction over their largest."""
    solver = steady_solver(zone, per_half_length, 15.0, stop)
    solver.march(stop, 10**9)
    mesh = solver.mesh
    at = int(mesh.faces()[1])
    front = float(mesh.x[at])
    y = np.maximum(front - mesh.x[:at + 1], 0.0)
    inside = y[1:] < depth
    h, found = mesh.width[:at], mesh.q[:at]
    exact = np.stack([-np.diff(content(y)) for content in zone.integrals()], axis=1)
    pairs = [(found[:, 0] / h, exact[:, 0] / h), *((found[:, k] / found[:, 0], exact[:, k] / exact[:, 0]) for k in (1, 3))]
    mean = [float((np.abs(a - b) * h)[inside].sum() / h[inside].sum() / b[inside].max()) for a, b in pairs]
    return np.array([abs(front / (zone.wave.velocity * stop) - 1.0), *mean])


def grown(zone, mode, per_half_length, behind, stop, amplitude=3e-4):
    """(growth, frequency) of a mode put on the steady zone, from how the front runs ahead of the steady one.

    Half the difference of two runs with the mode of either sign: what is of even order, and the zone's own error, cancel.
    """
    fields = zone.mode(mode) * amplitude * zone.wave.velocity
    paths = []
    for sign in (1.0, -1.0):
        solver, path = steady_solver(zone, per_half_length, behind, stop, sign * fields.real), [(0.0, 0.0)]
        while solver.time < stop:
            solver.march(min(stop, solver.time + 0.05), 10**9)
            path.append((solver.time, float(solver.mesh.x[solver.mesh.faces()[1]])))
        paths.append(np.array(path))
    t, ahead = paths[0][:, 0], 0.5 * (paths[0][:, 1] - paths[1][:, 1])
    return fitted(t, ahead, mode)


def fitted(t, ahead, mode):
    """Growth and frequency of c1 e^(at) cos(wt) + c2 e^(at) sin(wt) + c3, by least squares."""
    from scipy.optimize import least_squares

    weight = np.exp(-mode.growth * t)[:, None]

    def misfit(rates):
        wave = np.exp(complex(*rates) * t)
        basis = np.stack([wave.real, wave.imag, np.ones_like(t)], axis=1) * weight
        wanted = ahead * weight[:, 0]
        return (basis @ np.linalg.lstsq(basis, wanted, rcond=None)[0] - wanted) / np.abs(ahead).max()

    return least_squares(misfit, (mode.growth, mode.frequency), xtol=1e-12, ftol=1e-12, gtol=1e-12, diff_step=1e-6).x


# -- long runs: a window of cells that goes with the front ----------------------------------------------------------------
def windowed(old, wave, per_half_length, behind, ahead, stop):
    """A solver that goes on with the cells of another from `behind` its lead shock on, fresh ones up to `ahead` of it; its clock at 0.

    A piston with the velocity of the gas there takes the place of what is left out.
    """
    mesh, rest = old.mesh, 1.0 / (wave.gamma - 1.0) + wave.heat
    faces = mesh.faces()
    front = float(mesh.x[faces[mesh.fronts.index(lead_shock(old))]])
    first, last = max(int(np.searchsorted(mesh.x, front - behind)) - 1, 0), float(mesh.x[-1])
    more = max(round((front + ahead - last) * per_half_length), 0)
    new = np.zeros((more, 6))
    new[:, [0, 4]], new[:, [2, 5]] = 1.0 / per_half_length, rest / per_half_length
    x, q = np.concatenate([mesh.x[first:], last + np.arange(1, more + 1) / per_half_length]), np.concatenate([mesh.q[first:], new])
    marked = np.concatenate([mesh.marked[first:-1], np.zeros(more, bool), [True]])
    marked[0], speed, length = True, float(q[0, 1] / q[0, 0]), float(x[-1] - x[0])
    region = Region("gas", "gas", float(x[0]), float(x[-1]), round(per_half_length * length), density=1.0, pressure=1.0)
    solver = Cells(Problem("window", "planar", stop, (region,), {"gas": material_of(wave)}, Boundary("velocity", Pulse("constant", speed)),
                           Boundary("fixed"), solver=CELLS))
    ends = [one for one in solver.mesh.fronts if one.kind == "end"]
    kept = [one for one, face in zip(mesh.fronts, faces) if first < face < len(mesh.x) - 1]
    for one in kept:
        one.since = 0.0
    solver.mesh = Mesh(x, q, np.zeros(len(q), dtype=int), marked, [ends[0], *kept, ends[1]], 1)
    solver.mesh.fronts[0].speed = speed
    solver.start_totals, solver.start_size = solver.mesh.q.sum(axis=0), solver._size()
    return solver


def lead_shock(solver):
    """The foremost of the tracked shocks that run to the right."""
    return [one for one in solver.mesh.fronts if one.kind == "shock" and one.direction > 0][-1]


def crests(wave, per_half_length, stop, behind=60.0, piece=4.0, guess=0.08 + 0.5j, keeps_all=False):
    """(n, 2) times and front velocities of the crests of a wave that starts with its normal mode, 0.02 of its velocity.

    keeps_all   the window grows with the front, from `behind` at the start on: nothing is cut off
    """
    fields = SteadyZone(wave).mode(wave.mode(guess)).real * 0.02 * wave.velocity
    solver, begun, rows = steady_solver(SteadyZone(wave), per_half_length, behind, piece, fields), 0.0, []
    while begun < stop:
        while solver.time < piece:
            solver.march(min(piece, solver.time + 0.02), 10**9)
            rows.append((begun + solver.time, lead_shock(solver).speed))
        begun += piece
        solver = windowed(solver, wave, per_half_length, math.inf if keeps_all else behind, 1.6 * wave.velocity * piece + 1.0, piece)
    found = []
    for before, here, after in zip(rows, rows[1:], rows[2:]):
        if before[1] < here[1] >= after[1] and here[1] > wave.velocity:
            if found and here[0] - found[-1][0] < 4.0:      # two tops of one crest
                found[-1] = max(found[-1], here, key=lambda row: row[1])
            else:
                found.append(here)
    return np.array(found)
