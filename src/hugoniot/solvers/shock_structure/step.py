r"""One time step of the viscous flow solver.

Third-order Runge-Kutta (Shu and Osher, J. Comput. Phys. 77 (1988) 439) in the form whose total update is one sum of fluxes,

$$U^{(1)} = U^n + \Delta t\,L(U^n),\quad U^{(2)} = U^n + \tfrac14\Delta t\,[L(U^n)+L(U^{(1)})],\quad
  U^{n+1} = U^n + \tfrac16\Delta t\,[L(U^n)+L(U^{(1)})+4L(U^{(2)})],$$

so that changes of mass, momentum and energy depend only on the fluxes at the two ends. The step, with a the largest signal speed and D the
largest diffusivity:

1. fill the cells beyond the ends; fluxes of the state; largest signal speed and diffusivity
2. time step: courant / (a/h + D/(0.41 h^2)), cut to hit the event time exactly
3. first stage, its fluxes
4. second stage, its fluxes
5. total flux; the new state is checked before it is accepted
6. update the state; record what passed the ends

A step that leads to an invalid state (density or c^2 not positive, not a number) is repeated with half the length and at low order, as are
the next L.ROUGH_STEPS steps; only an unresolved strong jump at the start needs this. If halving does not help, the run stops with the
state before the step.
"""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.target import GUARD, INLINE
from hugoniot.solvers.shock_structure import layout as L
from hugoniot.solvers.shock_structure.kernels import account, all_sound, fill_ghosts, flux_sweep, gather, keep_peaks, stage, update

DIFFUSION_LIMIT = 0.41   # of D dt/h^2: below the third-order Runge-Kutta limit 2.51/(272/45) of the sixth-order gradient


class Cells(NamedTuple):
    """The cells of a run and their balances.

    U, V                 conserved averages and those of a stage, (3, cells and ghosts)
    F0, F1               mean flux of the step, flux of a stage, (3, faces)
    rest                 what rounding took from U
    peaks                largest values of every field so far
    passed, passed_rest  what passed the ends, and what rounding took from it
    h                    width of a cell, m
    kinds, ends          kind of each end and the state beyond it
    """

    U: Any
    V: Any
    F0: Any
    F1: Any
    rest: Any
    peaks: Any
    passed: Any
    passed_rest: Any
    h: float
    kinds: Any
    ends: Any


class Flow(NamedTuple):
    """Parameter tuples of the laws, and whether heat is conducted."""

    eos: Any
    transport: Any
    conducting: bool


@nb.njit(**INLINE)
def fluxes_of_step(a, rough, shorter, control, counters, flow):
    """Items 1 to 5: the step's mean fluxes in a.F0 and its length (negative: no sound step), and whether it ends at the event time."""
    dt, last = 0.0, False
    for k in range(3):
        W = a.U if k == 0 else a.V
        fill_ghosts(W, a.kinds, a.ends, flow.eos)
        if not flux_sweep(W, a.F1, a.h, rough, control, counters, flow.eos, flow.transport, flow.conducting):
            return -1.0, False
        if k == 0:
            rate = control[L.ADVECTIVE] / a.h + control[L.DIFFUSIVE] / (DIFFUSION_LIMIT * a.h * a.h)
            dt = min(control[L.COURANT] / rate, control[L.DT_LARGEST]) * shorter
            left = control[L.EVENT_TIME] - control[L.TIME]
            last = dt >= left * (1.0 - 1e-12)
            if last:
                dt = left
            elif dt > 0.5 * left:
                dt = 0.5 * left   # two even steps rather than a whole and a sliver
        gather(a.F0, a.F1, k)
        stage(a.U, a.V, a.F0, (0.25 if k == 1 else 1.0) * dt / a.h)
    return (dt, last) if all_sound(a.V, a.F1, counters, flow.eos) else (-1.0, False)


@nb.njit(**GUARD)
def march(cycles, a, control, counters, flow):
    """Take up to `cycles` steps, or until the event time; L.RUNNING or L.BAD_STATE (state of the last sound step kept)."""
    for _ in range(cycles):
        if control[L.TIME] >= control[L.EVENT_TIME]:
            break
        dt, last, shorter = -1.0, False, 1.0
        for _ in range(L.RETRIES + 1):
            dt, last = fluxes_of_step(a, counters[L.ROUGH] > 0, shorter, control, counters, flow)
            if dt >= 0.0:
                break
            counters[L.ROUGH] = L.ROUGH_STEPS
            shorter *= 0.5
        if dt < 0.0:
            return L.BAD_STATE
        counters[L.ROUGH] -= counters[L.ROUGH] > 0
        update(a.U, a.rest, a.F0, dt / a.h)
        keep_peaks(a.peaks, a.U, a.F1)
        account(a.passed, a.passed_rest, a.F0, dt)
        control[L.TIME] = control[L.EVENT_TIME] if last else control[L.TIME] + dt
        control[L.DT] = dt
        counters[L.CYCLE] += 1
    return L.RUNNING
