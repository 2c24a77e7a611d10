r"""One time step of the viscous flow solver.

Third-order Runge-Kutta (Shu and Osher, J. Comput. Phys. 77 (1988) 439) in the form whose total update is one sum of fluxes,

$$U^{(1)} = U^n + \Delta t\,L(U^n),\quad U^{(2)} = U^n + \tfrac14\Delta t\,[L(U^n)+L(U^{(1)})],\quad
  U^{n+1} = U^n + \tfrac16\Delta t\,[L(U^n)+L(U^{(1)})+4L(U^{(2)})],$$

so that mass, momentum and energy telescope to the two ends. The step, with a the largest signal speed and D the largest diffusivity:

1. fill the cells beyond the ends; fluxes of the state; largest signal speed and diffusivity
2. time step: courant / (a/h + D/(0.41 h^2)), cut to hit the event time exactly
3. first stage, its fluxes
4. second stage, its fluxes
5. total flux; the new state is looked at before it is taken
6. update the state; book what passed the ends

A step that meets a state that is none (density or c^2 not positive, not a number) is taken again, half as long and to low order, as are
the next L.ROUGH_STEPS steps; only an unresolved strong jump at the start needs that. If halving does not help, the run stops with the
state before the step in place.
"""

import numba as nb

from hugoniot.core.target import GUARD, INLINE
from hugoniot.solvers.shock_structure import layout as L
from hugoniot.solvers.shock_structure.kernels import account, all_sound, fill_ghosts, flux_sweep, gather, keep_peaks, stage, update

DIFFUSION_LIMIT = 0.41   # of D dt/h^2: below the third-order Runge-Kutta limit 2.51/(272/45) of the sixth-order gradient


@nb.njit(**INLINE)
def fluxes_of_step(U, V, F0, F1, h, rough, shorter, control, counters, kinds, ends, eos, transport, conducting):
    """Items 1 to 5: the step's mean fluxes in F0 and its length (negative: no sound step), and whether it ends at the event time."""
    dt, last = 0.0, False
    for k in range(3):
        W = U if k == 0 else V
        fill_ghosts(W, kinds, ends, eos)
        if not flux_sweep(W, F1, h, rough, control, counters, eos, transport, conducting):
            return -1.0, False
        if k == 0:
            rate = control[L.ADVECTIVE] / h + control[L.DIFFUSIVE] / (DIFFUSION_LIMIT * h * h)
            dt = min(control[L.COURANT] / rate, control[L.DT_LARGEST]) * shorter
            left = control[L.EVENT_TIME] - control[L.TIME]
            last = dt >= left * (1.0 - 1e-12)
            if last:
                dt = left
            elif dt > 0.5 * left:
                dt = 0.5 * left   # two even steps rather than a whole and a sliver
        gather(F0, F1, k)
        stage(U, V, F0, (0.25 if k == 1 else 1.0) * dt / h)
    return (dt, last) if all_sound(V, F1, counters, eos) else (-1.0, False)


@nb.njit(**GUARD)
def march(cycles, U, V, F0, F1, rest, peaks, passed, passed_rest, h, control, counters, kinds, ends, eos, transport, conducting):
    """Take up to `cycles` steps, or until the event time; L.RUNNING or L.BAD_STATE (state of the last sound step kept)."""
    for _ in range(cycles):
        if control[L.TIME] >= control[L.EVENT_TIME]:
            break
        dt, last, shorter = -1.0, False, 1.0
        for _ in range(L.RETRIES + 1):
            dt, last = fluxes_of_step(U, V, F0, F1, h, counters[L.ROUGH] > 0, shorter, control, counters, kinds, ends, eos, transport,
                                      conducting)
            if dt >= 0.0:
                break
            counters[L.ROUGH] = L.ROUGH_STEPS
            shorter *= 0.5
        if dt < 0.0:
            return L.BAD_STATE
        counters[L.ROUGH] -= counters[L.ROUGH] > 0
        update(U, rest, F0, dt / h)
        keep_peaks(peaks, U, F1)
        account(passed, passed_rest, F0, dt)
        control[L.TIME] = control[L.EVENT_TIME] if last else control[L.TIME] + dt
        control[L.DT] = dt
        counters[L.CYCLE] += 1
    return L.RUNNING
