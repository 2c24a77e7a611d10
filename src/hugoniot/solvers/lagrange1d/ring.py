"""Periodic ends: what leaves at one end enters at the other.

The two end nodes are one node with the sum of their masses, between the last zone on its left and the first on its
right. Each end records the action of the other half on it, so that work and impulse of the two cancel. The limiter of the viscosity acts
across the junction, and the artificial heat flux passes through it as through any face between zones of one region.
"""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.binder import only_if
from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.field import field_at
from hugoniot.solvers.lagrange1d.layout import H, Z


class RingEnd(NamedTuple):
    """An end of a periodic run: its last zone; mixes is 1 where the zones on both sides of the seam belong together."""

    pulse: Any
    table: Any
    field: Any
    mixes: float
    last: int


def _rings(boundary) -> bool:
    return boundary is RingEnd


@only_if(_rings, otherwise=0.0)
def ring_pull(zones, nodes, control, middle, boundary):
    """Acceleration of the joined end, m/s2, from the stresses in the middle of the step or at its start; 0 in other runs."""
    first, last = nodes[H.mass, 0], nodes[H.mass, int(control[L.LAST_NODE])]
    end = boundary.last
    push = (zones[Z.sigma_half, end] - zones[Z.sigma_half, 0]) if middle else (zones[Z.sigma, end] - zones[Z.sigma, 0])
    return push / (first + last) + field_at(nodes[H.r, 0], boundary.field)


@only_if(_rings, otherwise=0.0)
def seam_flux(zones, nodes, control, dt, boundary):
    """Artificial heat through the seam in a step, J, before the other zones mix (`compatible.heat_flux`)."""
    end, last = boundary.last, int(control[L.LAST_NODE])
    left = nodes[H.u_mean, last - 1] - nodes[H.u_mean, last] if zones[Z.q, end] > 0.0 else 0.0
    right = nodes[H.u_mean, 0] - nodes[H.u_mean, 1] if zones[Z.q, 0] > 0.0 else 0.0
    face = min(zones[Z.rho, end], zones[Z.rho, 0]) * boundary.mixes
    return dt * control[L.HEAT_FLUX] * face * max(left, right) * (zones[Z.e, end] - zones[Z.e, 0])


@only_if(_rings)
def mix_seam(zones, flux, boundary):
    """That heat taken from the last zone and given to the first."""
    end = boundary.last
    zones[Z.e, end] -= flux * zones[Z.inverse_mass, end]
    zones[Z.e, 0] += flux * zones[Z.inverse_mass, 0]


@nb.njit(**BY_ADDRESS)
def ring_ghosts(gradient, segments):
    """Velocity gradients beyond periodic ends: those at the other end."""
    if segments[0, L.SEG_LEFT] == L.PERIODIC:
        last = segments.shape[0] - 1
        end = segments[last, L.SEG_LAST] + 2 * last + 1
        gradient[0], gradient[end] = gradient[end - 1], gradient[1]


def joined_seam(regions) -> float:
    """1 where the first and the last region start alike, so that the seam is no contact."""
    one, two = regions[0], regions[-1]
    same = all(getattr(one, name) == getattr(two, name) for name in ("material", "density", "pressure", "temperature", "energy", "profile"))
    return 1.0 if same else 0.0
