"""Guderley's implosion as a run: started from the exact flow with the shock at r = 1, through focussing, to the returning shock.

The outer boundary follows the exact path of its particle, so nothing comes in from outside. Needs the exact solution to set up,
which is why it stands here and not among the standard problems of `problem.standard`.
"""

from functools import lru_cache

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from hugoniot.problem.model import Boundary, Problem, Pulse
from hugoniot.problem.standard.parts import Bar, Measure, StandardProblem, frozen, gas, profiled, simple
from hugoniot.theory.exact import SOLUTIONS

OUTER, START, STOP = 3.0, -1.0, 0.4    # outer radius at the start; the shock is at r = 1 at t = -1 and focusses at t = 0


@lru_cache(maxsize=8)
def exact_flow(geometry: str, gamma: float):
    """The exact solution with unit amplitude and density."""
    return SOLUTIONS["guderley"](geometry=geometry, gamma=gamma)


def outer_path(flow, points: int = 400) -> tuple[np.ndarray, np.ndarray]:
    """(times from the start, velocity) of the particle that starts at the outer radius."""
    times = np.linspace(START, STOP, points)

    def speed(t, r):
        return flow(np.atleast_1d(r), float(t))["velocity"]

    path = solve_ivp(speed, (START, STOP), [OUTER], t_eval=times, rtol=1e-8, atol=1e-10, max_step=0.02)
    velocity = np.array([float(speed(t, r)[0]) for t, r in zip(times, path.y[0])])
    return times - START, velocity


def build(geometry: str, gamma: float, zones: int) -> Problem:
    """The implosion on `zones` equal zones from the centre to the outer radius."""
    flow = exact_flow(geometry, gamma)
    faces = np.linspace(0.0, OUTER, zones + 1)
    at_faces, at_centres = flow(np.maximum(faces, 1e-9), START), flow(0.5 * (faces[1:] + faces[:-1]), START)
    moving = faces > 1.0
    inside = 0.5 * (faces[1:] + faces[:-1]) > 1.0
    times, velocity = outer_path(flow)
    regions = profiled("gas", faces, velocity=np.where(moving, at_faces["velocity"], 0.0),
                       density=np.where(inside, at_centres["density"], 1.0), pressure=np.where(inside, at_centres["pressure"], 0.0))
    drive = Boundary("velocity", Pulse("table", times=tuple(map(float, times)), values=tuple(map(float, velocity))))
    return simple(f"Guderley implosion, {geometry}", STOP - START, regions, {"gas": gas(gamma)}, Boundary("fixed"), drive,
                  geometry=geometry)


def shock_radius(state) -> float:
    """Where the density first reaches half the jump of a strong shock on the way out from the centre (gamma = 1.4: 3.5)."""
    rho, centre = state.zones["density"], state.position_middle
    k = int(np.argmax(rho > 3.5))
    if k == 0:
        return 0.0
    return float(centre[k - 1] + (centre[k] - centre[k - 1]) * (3.5 - rho[k - 1]) / (rho[k] - rho[k - 1]))


def exponent_error(history, flow) -> float:
    """|exponent of R = A (t_f - t)^alpha fitted to R between 0.8 and 0.15 over A, t_f and alpha / exact - 1|."""
    times, radii = np.array([(START + t, r) for t, r in history if 0.15 < r < 0.8 and START + t < 0.0]).T

    def straight(focus):
        fit, misfit, *_ = np.polyfit(np.log(focus - times), np.log(radii), 1, full=True)
        return float(misfit[0]), float(fit[0])

    best = minimize_scalar(lambda focus: straight(focus)[0], bounds=(times[-1] + 1e-4, times[-1] + 0.2), method="bounded",
                           options={"xatol": 1e-9})
    return float(abs(straight(best.x)[1] / flow.numbers["alpha"] - 1.0))


def steepest(state) -> float:
    """Where the pressure falls most steeply outwards: the returning shock that zones show."""
    centre, p = state.position_middle, state.zones["pressure"]
    near = (centre > 0.02) & (centre < 1.2)
    return float(centre[np.argmax(-np.gradient(p, centre) * near)])


def arrival_error(place: float, flow) -> float:
    """Relative error of the time at which the returning shock reached the place where it stands at the end."""
    exact = min(flow.jumps(STOP), key=lambda x: abs(x - place))
    return float(abs((place / exact) ** (1.0 / flow.numbers["alpha"]) - 1.0))


GUDERLEY = StandardProblem(
    "guderley", "Guderley's implosion: exponent of the converging shock, arrival of the returning one",
    lambda zones: build("spherical", 1.4, zones),
    (Measure("exponent", "exponent", "density"), Measure("arrival", "arrival", "pressure")),
    (Bar("exponent", 1200, goal=5e-3), Bar("arrival", 1200, goal=1e-2)), "guderley",
    frozen(geometry="spherical", gamma=1.4), zones=(300, 600, 1200))
