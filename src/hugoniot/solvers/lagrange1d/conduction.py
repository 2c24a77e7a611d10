r"""Heat conduction along a body, implicit, so that it never limits the time step.

With the heat capacity $C = m c_v$ and conductance $G = A/(\Delta r_l/2k_l + \Delta r_r/2k_r)$ of the face between two zones, one step of

$$C_j\,\dot T_j = G_{j-1/2}(T_{j-1} - T_j) + G_{j+1/2}(T_{j+1} - T_j)$$

is taken by the trapezoidal rule over $\gamma\Delta t$, $\gamma = 2 - \sqrt2$, and the second-order backward difference over the rest
(TR-BDF2: second order, with damping of stiff components). Energies change by the fluxes of the three stages, so that heat is conserved to
round-off. If a temperature would leave the range that its body had, the step is taken by the backward Euler rule, for which this is
impossible. Conductivity and specific heat are those at the start of the step, so the scheme is of first order in time where they vary. Ends
and gaps are insulated.

Source: Bank et al., IEEE Trans. Electron Devices 32 (1985) 1992, section III; Hosea and Shampine, Appl. Numer. Math. 20 (1996) 21;
the energy equation with conduction: Herrmann 2.16 and 3.4.
"""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.mesh.line import area
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.zones.transport import TransportRows

T = TransportRows(*range(len(TransportRows._fields)))
CONDUCTANCE, UPPER, RIGHT, NEW, FLUX = range(5)     # rows of the scratch
GAMMA = 2.0 - 2.0**0.5
IMPLICIT, EARLY = 0.5 * GAMMA, 0.25 * 2.0**0.5      # weights of the last stage, and of the first two
WITHIN = 1e-9                                       # of the range of temperatures: round-off


class Conduction(NamedTuple):
    """rows (TransportRows; zones) and scratch (5, zones); no columns where nothing conducts."""

    rows: Any
    scratch: Any


@nb.njit(**BY_ADDRESS)
def solve(a, flow, first, last, share_dt, mass):
    """(C + share_dt L) NEW = RIGHT over zones first..last-1, L the conduction."""
    G, upper, right, new = a[CONDUCTANCE], a[UPPER], a[RIGHT], a[NEW]
    for j in range(first, last):
        left, here = share_dt * G[j - 1] if j > first else 0.0, share_dt * G[j] if j < last - 1 else 0.0
        heat = mass[j] * flow[T.isochoric, j] if flow[T.conductivity, j] > 0.0 else mass[j]
        below = upper[j - 1] if j > first else 0.0
        before = right[j - 1] if j > first else 0.0
        pivot = heat + left * (1.0 - below) + here
        upper[j] = here / pivot
        right[j] = (heat * right[j] + left * before) / pivot
    new[last - 1] = right[last - 1]
    for j in range(last - 2, first - 1, -1):
        new[j] = right[j] + upper[j] * new[j + 1]


@nb.njit(**BY_ADDRESS)
def add_flux(a, temperature, first, last, weight):
    """Add weight times the flux through the right face of every zone."""
    for j in range(first, last - 1):
        a[FLUX, j] += weight * a[CONDUCTANCE, j] * (temperature[j] - temperature[j + 1])


@nb.njit(**BY_ADDRESS)
def within(new, old, conductivity, first, last):
    """Whether no temperature leaves the range of the old ones."""
    low, high, inside = 1e300, -1e300, True
    for j in range(first, last):
        if conductivity[j] > 0.0:
            low, high = min(low, old[j]), max(high, old[j])
    slack = WITHIN * (high - low)
    for j in range(first, last):
        inside = inside and (conductivity[j] <= 0.0 or low - slack <= new[j] <= high + slack)
    return inside


@nb.njit(**BY_ADDRESS)
def conduct(zones, nodes, segments, dt, conduction, geometry):
    """One step of conduction in every body: energies change, temperatures at its start stand in the rows."""
    flow, a = conduction.rows, conduction.scratch
    old, k, mass = flow[T.temperature], flow[T.conductivity], zones[Z.mass]
    for s in range(segments.shape[0]):
        first, last = segments[s, L.SEG_FIRST], segments[s, L.SEG_LAST]
        for j in range(first, last):
            a[FLUX, j] = a[CONDUCTANCE, j] = 0.0
            if j < last - 1 and k[j] > 0.0 and k[j + 1] > 0.0:
                r0, r1, r2 = nodes[H.r, j + s], nodes[H.r, j + s + 1], nodes[H.r, j + s + 2]
                a[CONDUCTANCE, j] = 2.0 * area(r1, geometry) / ((r1 - r0) / k[j] + (r2 - r1) / k[j + 1])
        add_flux(a, old, first, last, 1.0)
        for j in range(first, last):
            heat = mass[j] * flow[T.isochoric, j] if k[j] > 0.0 else mass[j]
            into = (a[FLUX, j - 1] if j > first else 0.0) - a[FLUX, j]
            a[RIGHT, j] = old[j] + IMPLICIT * dt * into / heat
        solve(a, flow, first, last, IMPLICIT * dt, mass)
        for j in range(first, last):
            a[FLUX, j] *= EARLY
        add_flux(a, a[NEW], first, last, EARLY)
        for j in range(first, last):
            a[RIGHT, j] = (a[NEW, j] - (1.0 - GAMMA) ** 2 * old[j]) / (GAMMA * (2.0 - GAMMA))
        solve(a, flow, first, last, IMPLICIT * dt, mass)
        add_flux(a, a[NEW], first, last, IMPLICIT)
        if not within(a[NEW], old, k, first, last):
            for j in range(first, last):
                a[FLUX, j], a[RIGHT, j] = 0.0, old[j]
            solve(a, flow, first, last, dt, mass)
            add_flux(a, a[NEW], first, last, 1.0)
        for j in range(first, last):
            into = (a[FLUX, j - 1] if j > first else 0.0) - a[FLUX, j]
            zones[Z.e, j] += dt * into * zones[Z.inverse_mass, j]
