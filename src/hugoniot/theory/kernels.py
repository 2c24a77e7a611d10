"""The scalar searches of this package compiled for arrays: one source, one compiled form per law, kept on disk.

Importing this module imports numba; `theory.hugoniot` and `theory.isentrope` do so only for many states.
"""

import numba as nb

from hugoniot.core.binder import bind, bind_family, bind_module
from hugoniot.core.target import CURVE
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory import expansion, jump

bind_family(EOS, contract.GENERICS)
bind_module(contract)
# these test for NaN and loop: no fast-math, and left to the compiler to inline
_SEARCH = dict(fastmath=False, error_model="numpy", no_cfunc_wrapper=True)
for _function in (jump.line, jump.misfit, jump.beyond_stability, jump.bracket, jump.dip, jump._is_root, jump.polish, jump.anomalous,
                  jump._pressure_by_bracket, jump.pressure_at, jump.shocked, jump.first_guess,
                  expansion.rates, expansion.leap, expansion.across, expansion.astray, expansion.to_edge, expansion.through,
                  expansion.stretch, expansion.advance):
    bind(_function, **_SEARCH)


@nb.njit(**CURVE)
def shock_curve(mode, targets, still, v0, p0, e0, c0, floor, least, most, par, x, p, e, status):
    """`jump.shocked` for each target that is not the upstream state; fills x, p, e and status."""
    for i in range(targets.shape[0]):
        if not still[i]:
            guess = max(jump.first_guess(mode, targets[i], v0, p0, c0), floor)
            status[i], x[i], p[i], e[i] = jump.shocked(mode, targets[i], guess, least, most, v0, p0, e0, par)


@nb.njit(**CURVE)
def isentrope_curve(logs, start, e0, u0, par, e, u):
    """`expansion.advance` from one density (natural logarithm in `logs`) to the next; returns how many were reached."""
    y, e_here, u_here = start, e0, u0
    for i in range(logs.shape[0]):
        status, y, e_here, u_here = expansion.advance(y, e_here, u_here, logs[i], par)
        if status != 0:
            return i
        e[i], u[i] = e_here, u_here
    return logs.shape[0]
