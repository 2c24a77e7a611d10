"""Where a transient run of a shock starts: from the exact jump as a step, or from the cell averages of the steady profile.

`resolved` lays out the whole problem for a shock: cells, domain and time counted in its own thickness.
"""

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from types import MappingProxyType

import numpy as np

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import EOS, pressure
from hugoniot.laws.transport import contract as transport_laws
from hugoniot.materials.initial_state import initial_state
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Region, SolverOptions
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.states import law_of
from hugoniot.theory.structure.profile import Profile, steady

EDGE = 1e-3           # part of the jump that the profile may still lack at the ends of a domain
WIDTH = 12.0          # thicknesses on each side of a shock, and that its slowest wave runs
FAR, MARGIN = 1e-8, 3.0
MEASURES = ("mach", "shock_velocity", "particle_velocity", "pressure")
_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(4)


def ample_room(profile: Profile) -> tuple[float, float]:
    """Thicknesses ahead of the shock and behind it that the ends of a domain do not disturb.

    As far as the profile is within FAR of its ends and MARGIN more, at least WIDTH: the foot of a strong shock is many thicknesses long.
    """
    length = profile.thickness()
    ahead, behind = profile.extent(FAR)
    return max(WIDTH, MARGIN - ahead / length), max(WIDTH, MARGIN + behind / length)


def settling_times(profile: Profile) -> float:
    """How often the gas behind must flow through a thickness until the waves of a start from a step are gone.

    The slowest of them, entropy at u2, sound at c2 - u2 behind and at u1 - c1 ahead of the shock, then has run WIDTH thicknesses.
    """
    one, two = profile.ends.upstream, profile.ends.downstream
    slowest = min(two.velocity, two.sound_speed - two.velocity, one.velocity - one.sound_speed)
    return WIDTH * two.velocity / slowest


def resolved(material, transport, upstream=None, *, cells: int = 10, room=None, times: float | None = None, frame: str = "standing",
             start: str = "step", **strength) -> tuple[Problem, Profile]:
    """(problem of the solver `shock_structure`, its steady profile) with `cells` in the density thickness of the shock.

    material, transport, upstream, strength   as in `steady`
    room     thicknesses ahead of the shock and behind it (default: `ample_room`); in the moving frame the path is added ahead
    times    how often the gas behind flows through a thickness until the run stops (default: `settling_times`)
    """
    eos = law_of(material)
    profile = steady(eos, transport, upstream, **strength)
    room, times = room or ample_room(profile), times or settling_times(profile)
    one, length = profile.ends.upstream, profile.thickness()
    size = length / cells
    stop = times * length / profile.ends.downstream.velocity
    before, after = math.ceil(room[0] * cells), math.ceil(room[1] * cells)
    if frame == "moving":
        before += math.ceil(one.velocity * stop / size)
    region = Region("fluid", "fluid", -before * size, after * size, before + after, density=one.density, energy=one.energy)
    options = {"transport": transport, "shock": {**strength, "at": 0.0, "start": start, "frame": frame}}
    end = Boundary("transmitting")
    solver = SolverOptions("shock_structure", options=MappingProxyType(options))
    title = f"{EOS.of(eos).name}, Mach {profile.ends.mach:.4g}"
    return Problem(title, "planar", stop, (region,), {"fluid": Material("fluid", eos)}, end, end, solver=solver), profile


def setting(problem: Problem):
    """(equation of state, transport tuple, `Initial` ahead) of a shock-structure problem; ahead is the first region's state."""
    transport, region = problem.solver.options["transport"], problem.regions[0]
    eos = problem.materials[region.material].eos
    rho, e = initial_state(eos, region.density, region.pressure, region.temperature, region.energy)
    if not isinstance(transport, transport_laws.Transport):
        transport = transport_laws.make(transport["viscosity"], transport.get("conduction"), transport.get("bulk_ratio", 0.0),
                                        transport.get("bulk_viscosity", 0.0))
    return eos, transport, Initial(rho, float(pressure(rho, e, eos)), e)


def profile_of(problem: Problem) -> Profile:
    """The steady profile of the shock that `solver.options["shock"]` asks for."""
    shock = problem.solver.options["shock"]
    eos, transport, ahead = setting(problem)
    return steady(eos, transport, ahead, **{name: shock[name] for name in MEASURES if shock.get(name) is not None})


def shock_start(problem: Problem):
    """(cells (3, n), ends (2, 3)) of conserved quantities for the solver, or None where the problem names no shock.

    options["shock"]: mach or one of shock_velocity, particle_velocity, pressure; at (m): where the shock stands at t = 0;
    start "step" | "steady"; frame "standing" | "moving" (the gas ahead, on the left, keeps its region's velocity and the shock runs left).
    Raises `DeckError` where the domain cannot hold the profile, saying what is needed.
    """
    shock = problem.solver.options.get("shock")
    if not shock:
        return None
    profile = profile_of(problem)
    one, two = profile.ends.upstream, profile.ends.downstream
    velocity = problem.regions[0].velocity
    boost = 0.0
    if shock.get("frame", "standing") == "moving":
        boost = (velocity if isinstance(velocity, (int, float)) else velocity[0]) - one.velocity
    left, right = problem.regions[0].start, problem.regions[-1].end
    at = shock.get("at", 0.5 * (left + right))
    _require_room(problem, profile, left, right, at, boost)
    count = sum(region.zones for region in problem.regions)
    faces = np.linspace(left, right, count + 1)
    ends = np.array([_conserved(s.density, s.velocity + boost, s.energy) for s in (one, two)])
    if shock.get("start", "step") == "step":
        part = np.clip((at - faces[:-1]) / np.diff(faces), 0.0, 1.0)   # of each cell that lies ahead
        return ends[0][:, None] * part + ends[1][:, None] * (1.0 - part), ends
    centres, half = 0.5 * (faces[1:] + faces[:-1]), 0.5 * (faces[1] - faces[0])
    cells = np.zeros((3, count))
    for point, weight in zip(_POINTS, _WEIGHTS):
        s = profile.at(centres + half * point - at)
        cells += 0.5 * weight * _conserved(s["density"], s["velocity"] + boost, s["energy"])
    return cells, ends


def _conserved(rho, u, e):
    return np.array([rho, rho * u, rho * (e + 0.5 * u * u)])


def _require_room(problem, profile: Profile, left, right, at, boost):
    """The profile, and in the moving frame its path, must lie inside the domain."""
    ahead, behind = profile.extent(EDGE)
    path = boost * problem.stop_time   # the shock stands in its own frame
    first, last = at + ahead + min(path, 0.0), at + behind + max(path, 0.0)
    if left <= first and last <= right:
        return
    one, other = problem.regions[0], problem.regions[-1]
    run = f", and it runs {abs(path):.4g} m until stop_time" if path else ""
    moves = [f"region '{one.name}' begin at {_outward(first, ROUND_FLOOR):g} m or less"] if first < left else []
    moves += [f"region '{other.name}' end at {_outward(last, ROUND_CEILING):g} m or more"] if last > right else []
    kept = f", and give [solver.shock] at = \"{at:.6g} m\"" if abs(at - 0.5 * (left + right)) < 1e-9 * (right - left) else ""
    raise DeckError.single("deck", None, f"region.{(one if first < left else other).name}",
                           f"the domain from {left:.4g} m to {right:.4g} m does not hold the shock: at {at:.4g} m it needs "
                           f"{-ahead:.4g} m ahead of it (at smaller x) and {behind:.4g} m behind{run}", f"let {' and '.join(moves)}{kept}")


def _outward(place: float, rounding: str) -> float:
    """The place to four figures, rounded so that a domain that reaches to it is long enough."""
    return float(Context(prec=4, rounding=rounding).create_decimal_from_float(float(place)))
