r"""A detonation followed by a window of zones that moves with its front, started from the exact steady zone.

Whether a detonation is steady, pulsates or dies is settled over hundreds of reaction lengths, and by nothing but the zone itself. A
charge of that length with a piston behind it costs the square of its length, and start and piston send sound after the front for good. Here

* the run begins as the exact zone of `theory.znd`, laid out by mass: $m = \rho_0 D\,t$ behind the front;
* its frame is that of the gas at the end of the zone, which is at rest there, so that a transmitting boundary with the end's pressure lets
  sound out behind (exactly, but for second order of what arrives);
* when the front comes near the end of the window, the zones farthest behind are dropped and as many fresh ones laid ahead.

Source: the steady zone and its instability: Fickett and Wood, Phys. Fluids 9 (1966) 903; Lee and Stewart, J. Fluid Mech. 216 (1990) 103.
"""

from dataclasses import dataclass

import numpy as np
from scipy.signal import find_peaks

from hugoniot.errors import OutOfRange
from hugoniot.materials import burning
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.window import Window
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.znd import Structure, znd

AHEAD, NEAR, STRIDE = 300, 60, 200    # zones ahead of the front at the start; least of them; zones moved from behind to ahead at a time
CYCLES = 32                           # between two readings of the front
FRONT = 0.1                           # of the von Neumann pressure: the level at which the front is found


@dataclass(frozen=True)
class Followed:
    """What the front did: time (s), its position (m, from where it began, in the frame of the gas ahead) and the pressure behind it (Pa).

    front_pressure is that of the crest nearest to the front; `exact` the steady zone the run began with; `peak_pressure` the highest
    pressure that each zone the front has passed and that is still in the window has seen.
    """

    exact: Structure
    zone_size: float
    time: np.ndarray
    position: np.ndarray
    front_pressure: np.ndarray
    peak_pressure: np.ndarray

    def crests(self, after: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """(times, pressures) of the crests of a pulsation from the time `after` on: those that stand out by a third of its range."""
        late = self.time >= after
        time, p = self.time[late], self.front_pressure[late]
        tops = find_peaks(p, prominence=(p.max() - p.min()) / 3.0)[0]
        return time[tops], p[tops]


def follow(material: Material, initial: Initial, duration: float, *, overdrive: float = 1.0, zones: int = 20, window: float = 30.0,
           viscosity: dict[str, float] | None = None) -> Followed:
    """Run the steady zone of a burning material for `duration` (s) and record its front.

    initial     state ahead of the front, at rest
    overdrive   f = (D/D_CJ)^2 of the steady zone
    zones       per half-reaction length, counted at rest
    window      length kept behind the front, in half-reaction lengths
    viscosity   parameters of the `limited` viscosity; linear = 1, the jump of a gas shock itself, unless given
    Raises `OutOfRange` for a burn law without a steady zone, or a window that does not hold the half-reaction length.
    """
    if not (duration > 0.0 and zones >= 1 and window > 2.0):
        raise OutOfRange("following a detonation in a moving window needs a positive duration, at least one zone per half-reaction length "
                         f"and a window longer than 2 half-reaction lengths; got {duration:g} s, zones: {zones:g}, window: {window:g}")
    exact = znd(burning.reactive(material).mixture, initial, material.burn, overdrive=overdrive, points=2000, complete=1.0 - 1e-9)
    size, drift = exact.half_reaction_length / zones, float(exact.particle_velocity[-1])
    behind = round(window * zones * float(exact.states.density[-1]) / initial.density)
    count = behind + AHEAD
    region = Region("charge", material.name, 0.0, count * size, count, velocity=-drift, density=initial.density, energy=initial.energy)
    problem = Problem("followed detonation", "planar", 1e3 * duration, (region,), {material.name: material}, Boundary("transmitting"),
                      Boundary("velocity", Pulse("constant", amplitude=-drift)), output=OutputOptions(report=False),
                      solver=SolverOptions(viscosity=("limited", {"linear": 1.0} if viscosity is None else viscosity)))
    moving = Window(make_solver(problem))
    _lay_out(moving, exact, behind, initial, drift)
    return _march(moving, exact, duration, drift)


def _march(window: Window, exact: Structure, duration: float, drift: float) -> Followed:
    solver, level, rows, front = window.solver, FRONT * float(exact.von_neumann.pressure), [], 0
    while solver.time < duration:
        solver.march(duration, CYCLES)
        state = solver.state()
        p, centre = state.zones["pressure"], 0.5 * (state.position_left + state.position_right)
        front = p.size - 1 - int(np.argmax(p[::-1] > level))
        crest = front
        while crest > 0 and p[crest - 1] > p[crest]:
            crest -= 1
        share = (p[front] - level) / (p[front] - p[front + 1])
        place = centre[front] + share * (centre[front + 1] - centre[front])
        rows.append((solver.time, place + drift * solver.time, p[crest]))
        if front > p.size - NEAR:
            window.move_on(STRIDE)
            front -= STRIDE
    time, place, pressure = np.array(rows).T
    return Followed(exact, window.size, time, place, pressure, solver.peaks()["peak_pressure"][:front - 10])


def _lay_out(window: Window, exact: Structure, behind: int, initial: Initial, drift: float) -> None:
    """The steady zone on the zones left of the face `behind`, by mass; beyond its end the end state."""
    states = exact.states
    mass = initial.density * exact.velocity * exact.time
    since = (behind - np.arange(behind + AHEAD + 1)) * window.mass      # mass between a face and the front
    back = np.interp(since, mass, exact.position) + np.maximum(since - mass[-1], 0.0) / float(states.density[-1])
    burned, depth = since > 0.0, 0.5 * (since[1:] + since[:-1])[:behind]
    fields = {"energy": states.energy, "pressure": states.pressure, "sound_speed": states.sound_speed, "burn_fraction": exact.reaction,
              "reactant_density": states.reactant_density, "reactant_energy": states.reactant_energy,
              "product_density": states.product_density, "product_energy": states.product_energy}
    window.lay_out(np.where(burned, -back, -since / initial.density),
                   np.where(burned, np.interp(since, mass, exact.particle_velocity), 0.0) - drift,
                   {name: np.interp(depth, mass, np.nan_to_num(values)) for name, values in fields.items()}, float(states.pressure[-1]))
