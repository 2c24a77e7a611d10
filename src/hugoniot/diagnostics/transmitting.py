"""What a transmitting end may still send back, for `check` and at the end of a run.

Plane waves leave to 1 % of the wave (`solvers.lagrange1d.transmitting`, with its tests). But where an elastic release overtakes the shock
beyond the end, a longer body would send a wave back, which is missing: the end estimates it during the run.

In curved geometry the end knows only sound that spreads from the axis or the origin: strong waves scatter back from the material that they
leave behind, and an elastic body around a sphere is stiff. The parts given here are the largest found against a body without an end.
"""

import numpy as np

from hugoniot.laws.eos.contract import pressure, reference_state, sound_speed_squared
from hugoniot.problem.model import Problem
from hugoniot.problem.plane.model import Problem2D

SMALLEST = 1e-4    # of rho c^2: waves below are sound
FLUID, SOLID = 0.08, 0.11    # largest echo over the wave that reached the end, in fluids and where there is strength
RADIAL = 0.5       # radial part of the normal from which an edge has curved waves
FAITHFUL = 0.01    # part of a plane wave that an end may send back, or fail to, without a warning


def expected(problem: Problem) -> list[str]:
    """Warnings of the transmitting ends of a problem: in curved geometry, and where a planar impact shows that an echo will be missing."""
    from hugoniot.diagnostics.overtaking import echo_over_wave

    found = []
    for side in ("left", "right"):
        if not _transmits(problem, side):
            continue
        if problem.geometry != "planar":
            found.append(_words(problem, side))
        elif (part := echo_over_wave(problem, side)) > FAITHFUL:
            found.append(_missing(f"{side} end", f"up to {part:.0%}"))
    return found


def measured(problem: Problem, peak_stress: np.ndarray, missing: tuple[float, float] = (0.0, 0.0)) -> list[str]:
    """The same for a finished run, in curved geometry only if a wave, not sound, has reached the end.

    peak_stress   largest stress of every zone, Pa, (nzone,)
    missing       stress of the echoes that longer bodies would have sent back from beyond the left and the right end, Pa (planar geometry)
    """
    found = []
    for side, region, zone, echo in (("left", problem.regions[0], 0, missing[0]), ("right", problem.regions[-1], -1, missing[1])):
        if not _transmits(problem, side):
            continue
        law = problem.materials[region.material].eos
        wave = peak_stress[zone] - _ambient(law)
        if not wave > _sound(law):
            continue
        if problem.geometry != "planar":
            found.append(_words(problem, side))
        elif echo > FAITHFUL * wave:
            found.append(_missing(f"{side} end", f"about {echo / wave:.0%}"))
    return found


def measured_at_edges(problem: Problem2D, peak_stress: np.ndarray, missing: dict[str, np.ndarray]) -> list[str]:
    """The same for a finished run in two dimensions, of the edge of each transmitting chain whose echo is the largest part of its wave.

    missing   stress of the echo beyond every edge of the transmitting chains, were waves plane, Pa
    """
    found = []
    for name, echo in missing.items():
        chain = problem.mesh.chains[name]
        material = problem.materials[problem.blocks[chain.block].material]
        wave = peak_stress[chain.zones] - _ambient(material.eos)
        strong = wave > _sound(material.eos)
        facing = float(problem.mesh.outward_normals(chain)[0].mean()) if problem.geometry == "axisymmetric" else 0.0
        if abs(facing) > RADIAL and strong.any():
            solid = material.strength is not None
            found.append(_converging(f"edge '{name}'") if facing < 0.0 else _spreading(f"edge '{name}' around the axis", solid))
        elif (part := np.max(echo[strong] / wave[strong], initial=0.0)) > FAITHFUL:
            found.append(_missing(f"edge '{name}'", f"up to about {part:.0%}"))
    return found


def _ambient(law) -> float:
    """Pressure of the reference state, Pa."""
    return float(pressure(*reference_state(law), law))


def _sound(law) -> float:
    """Stress below which a wave is sound, Pa."""
    rho, e = reference_state(law)
    return float(SMALLEST * rho * sound_speed_squared(rho, e, law))


def _transmits(problem: Problem, side: str) -> bool:
    # in curved geometry the left end of a body that reaches the axis or the origin is that
    outside = side == "right" or problem.geometry == "planar" or problem.regions[0].start > 0.0
    return outside and getattr(problem, side).kind == "transmitting"


def _words(problem: Problem, side: str) -> str:
    if side == "left":
        return _converging("left end")
    return _spreading(f"right end of this {problem.geometry} problem", problem.materials[problem.regions[-1].material].strength is not None)


def _converging(end: str) -> str:
    return (f"the transmitting {end} treats a converging wave as plane: a wave that would run to the axis or "
            "the origin and come back is lost")


def _spreading(end: str, solid: bool) -> str:
    return (f"the transmitting {end} is exact for sound only: up to {SOLID if solid else FLUID:.0%} "
            "of a strong wave comes back; move the end far enough away that its echo reaches no gauge before the run ends")


def _missing(end: str, part: str) -> str:
    return (f"material beyond the transmitting {end} would send back a wave of {part} of the stress that reaches it, "
            "because the elastic release overtakes the shock there; the run lacks this wave: move the end farther away")
