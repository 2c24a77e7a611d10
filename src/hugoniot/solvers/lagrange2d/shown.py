"""Fields of zones that the march does not need: they are not stored in every step but computed when a state is requested.

Where the march itself needs them (transmitting edges) they are stored like all others.
"""

from typing import Any, NamedTuple

import numpy as np

from hugoniot.core.pass_lists import Operation
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.commands import SHOW, Plan, carry_out_alone
from hugoniot.solvers.lagrange2d.layout import Stress, Tensor
from hugoniot.solvers.lagrange2d.tensor import principal
from hugoniot.solvers.lagrange2d.zone_passes import ShapeOf, shape


class Shown:
    """A solver with the table `_zones`, of which these fields are found when it is asked for and a march has made them `stale`."""

    stale = False
    plan: Plan
    counters: np.ndarray
    _zones: np.ndarray

    @property
    def zones(self) -> np.ndarray:
        """The table of zones, (fields, nzone)."""
        if self.stale:
            carry_out_alone(self.plan, (SHOW,))
            self.stale = False
        return self._zones[:, :self.counters[L.ZONES]]


class LargestStressOf(NamedTuple):
    """Pressure and deviators of the state -> the principal stress of largest size."""

    p: Any
    s: Tensor
    sigma: Any


class TraceOf(NamedTuple):
    """Mean viscous stress -> its trace."""

    q: Stress
    trace: Any


@zone_pass(LargestStressOf)
def largest_stress(count, z, dt, numbers, law):
    """The principal stress of largest size of the state that stands."""
    rows_apart()
    for j in range(count):
        z.sigma[j] = principal(z.p[j], z.s.xx[j], z.s.yy[j], z.s.xy[j])


@zone_pass(TraceOf)
def trace(count, z, dt, numbers, law):
    """Trace of the viscous stress."""
    rows_apart()
    for j in range(count):
        z.trace[j] = z.q.xx[j] + z.q.yy[j] + z.q.hoop[j]


def left_out(at, laws):
    """Rows of a material (`plane_rows.PlaneRows`) in which a step does not keep these fields; burning zones need their density."""
    return at._replace(z=at.z._replace(sigma=at.w.sigma, rho=at.z.rho if laws.burns else at.w.rho))


def operations(at, geometry, numbers) -> list[Operation]:
    """The list of passes that finds them; numbers: those of the material."""
    z = at.z
    return [Operation(shape, geometry, ShapeOf(at.now, z.inverse_mass, at.w.v, z.rho, at.w.inverse_length), numbers, at.whole),
            Operation(largest_stress, None, LargestStressOf(z.p, at.s, z.sigma), numbers, at.whole),
            Operation(trace, None, TraceOf(at.q, z.q), numbers, at.whole)]
