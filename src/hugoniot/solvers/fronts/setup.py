"""From a problem to its first fronts: what the solver takes, and the Riemann problems at t = 0."""

import math
import re
from dataclasses import dataclass

import numpy as np

from hugoniot.errors import HugoniotError, OutOfRange, UnphysicalState
from hugoniot.laws.eos.contract import compacted, pressure
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.fronts import defects, with_defaults
from hugoniot.problem.model import Boundary, Problem
from hugoniot.problem.profiles import values_at
from hugoniot.solvers.fronts.line import Front, Piece
from hugoniot.solvers.fronts.meeting import Bench, outgoing

STATE_FIELDS = ("density", "pressure", "temperature", "energy")
COURANT = 0.5         # of the cells mode, where none is given


@dataclass
class Drive:
    """Values of an end over time: (time from which, value), the first at t = 0."""

    steps: list[tuple[float, float]]


def unsolved(error: Exception, where: str, region: str = "", place: float | None = None, time: float = 0.0,
             cycle: int = 0) -> UnphysicalState:
    """What a run says where a Riemann problem has no answer. where: "where fronts meet", or the like."""
    if isinstance(error, UnphysicalState):
        return error
    why = str(error).rstrip(".") if isinstance(error, HugoniotError) else f"no wave of finite speed and strength leaves ({error})"
    advised = re.fullmatch(r"(.*)(?: \(|: |; )((?:use|give|light|start)\b.*?)\)?", why)       # by whoever knows the cause
    why, remedy = advised.groups() if advised else (why, "stay inside the range of the equations of state, or choose ones that reach "
                                                         "further")
    return UnphysicalState(f"{where}, {why}.", remedy, None, region, place, time, cycle)


def options_of(problem: Problem) -> dict:
    """The solver's own options with every default filled in."""
    return with_defaults(problem.solver.options)


def refuse_what_is_not_solved(problem: Problem) -> None:
    """Raise `OutOfRange` for the first thing that the mode asked for cannot do (problem.fronts.defects)."""
    for _, message in defects(problem):
        raise OutOfRange(message)


def matter_of(material) -> Matter:
    """Equation of state and strength of a material, as the Riemann problems take them."""
    if material.strength is None or STRENGTH.of(material.strength).name == "none":
        return Matter(material.eos)
    strength = material.strength
    if strength.yield_stress <= 0.0 or strength.shear_modulus <= 0.0:
        return Matter(material.eos)
    return Matter(material.eos, strength.shear_modulus, strength.yield_stress)


def drive_of(end: Boundary) -> Drive:
    """The steps of an end's velocity or pressure."""
    pulse = end.pulse
    if pulse is None:
        return Drive([(0.0, 0.0)])
    over = pulse.start + pulse.duration if pulse.shape == "square" else math.inf
    if over <= 0.0:
        return Drive([(0.0, 0.0)])
    steps = [(0.0, 0.0)] if pulse.start > 0.0 else []
    steps.append((max(pulse.start, 0.0), pulse.amplitude))
    return Drive(steps if over == math.inf else [*steps, (over, 0.0)])


def grips_of(problem: Problem) -> list[float]:
    """Stress (Pa) that holds each region to the next one."""
    grip = {"bonded": math.inf, "separable": 0.0}
    held = {i.left: i.strength if i.kind == "bond" else grip[i.kind] for i in problem.interfaces}
    return [held.get(r.name, 0.0) for r in problem.regions]


def bench_of(problem: Problem, drives: dict[int, Drive]) -> Bench:
    """Materials, grips and ends of the run's meetings."""
    options = options_of(problem)
    matters = [matter_of(problem.materials[r.material]) for r in problem.regions]
    bench = Bench(matters, grips_of(problem), float(options["weakest"]), float(options["fan_step"]))
    for side, end in ((-1, problem.left), (1, problem.right)):
        value = drives[side].steps[0][1]
        (bench.pressures if end.kind == "pressure" else bench.walls)[side] = value
    return bench


_OUTSIDE = {"free": "vacuum", "fixed": "wall", "velocity": "wall", "pressure": "pressure", "transmitting": "open"}


def first_pieces(problem: Problem) -> tuple[list[Piece], list[float]]:
    """(pieces from outside to outside, positions of the lines between them) before any wave has left."""
    pieces, places = [Piece(_OUTSIDE[problem.left.kind])], []
    for k, region in enumerate(problem.regions):
        if k and region.start > problem.regions[k - 1].end:
            places.append(problem.regions[k - 1].end)
            pieces.append(Piece("vacuum"))
        eos = problem.materials[region.material].eos
        rho, e = initial_state(eos, region.density, region.pressure, region.temperature, region.energy)
        u = region.velocity[0] if isinstance(region.velocity, tuple) else region.velocity
        p = region.pressure if region.pressure is not None else pressure(rho, e, eos)
        places.append(region.start)
        pieces.append(Piece("state", k, State(float(rho), float(u), float(e), float(p), 0.0, float(compacted(0.0, rho, e, p, eos)))))
    places.append(problem.regions[-1].end)
    pieces.append(Piece(_OUTSIDE[problem.right.kind]))
    for piece, inner, side in ((pieces[0], pieces[1], -1), (pieces[-1], pieces[-2], 1)):
        if piece.kind == "open":
            piece.state = inner.edge(side)
    return pieces, places


def first_line(problem: Problem, bench: Bench) -> tuple[list[Piece], list[Front]]:
    """Pieces and fronts at t = 0+: every line between regions has sent out its waves."""
    before, places = first_pieces(problem)
    pieces, fronts = [before[0]], []
    for j, x in enumerate(places):
        if j:
            pieces.append(before[j])
        some, between, _ = outgoing(before[j], before[j + 1], x, 0.0, bench)
        fronts += some
        pieces += between
    return [*pieces, before[-1]], fronts


def start_states(region, material, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(density, energy) of a region at t = 0 at some places, from its state or its profile."""
    varying = {} if region.profile is None else {name: values_at(region.profile, name, places) for name, _ in region.profile.fields
                                                 if name != "velocity"}
    found = []
    for k in range(len(places) if varying else 1):
        given = [float(varying[name][k]) if name in varying else getattr(region, name) for name in STATE_FIELDS]
        found.append(initial_state(material.eos, *given) if material.burn is None else burning.start_state(material, *given))
    rho, e = np.array(found, dtype=float).T
    return np.broadcast_to(rho, len(places)), np.broadcast_to(e, len(places))


def zone_faces(problem: Problem) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(left, right) faces of every zone at t = 0 and the region it belongs to."""
    left, right, owner = [], [], []
    for k, region in enumerate(problem.regions):
        q, n = region.ratio, region.zones
        widths = np.full(n, 1.0) if q == 1.0 else q ** np.arange(n)
        faces = region.start + (region.end - region.start) * np.concatenate([[0.0], np.cumsum(widths) / widths.sum()])
        faces[-1] = region.end
        left.append(faces[:-1])
        right.append(faces[1:])
        owner += [k] * n
    return np.concatenate(left), np.concatenate(right), np.array(owner)
