"""What a transmitting end may still send back, for `check` and at the end of a run.

Plane waves leave to 1 % of the wave (`solvers.lagrange1d.transmitting`, with its tests). But where an elastic release overtakes the shock
beyond the end, a longer body would send a wave back, which is missing: the end estimates it during the run.

In curved geometry the end knows only sound that spreads from the axis or the origin: strong waves scatter back from the material that they
leave behind, and an elastic body around a sphere is stiff. The parts given here are the largest found against a body without an end.
"""

import numpy as np

from hugoniot.laws.eos.contract import pressure, reference_state, sound_speed_squared
from hugoniot.problem.model import Problem

SMALLEST = 1e-4    # of rho c^2: waves below are sound
FLUID, SOLID = 0.08, 0.11    # largest echo over the wave that reached the end, in fluids and where there is strength
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
            found.append(_missing(side, f"up to {part:.0%}"))
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
        rho, e = reference_state(law)
        wave = peak_stress[zone] - pressure(rho, e, law)
        if not wave > SMALLEST * rho * sound_speed_squared(rho, e, law):
            continue
        if problem.geometry != "planar":
            found.append(_words(problem, side))
        elif echo > FAITHFUL * wave:
            found.append(_missing(side, f"about {echo / wave:.0%}"))
    return found


def _transmits(problem: Problem, side: str) -> bool:
    # in curved geometry the left end of a body that reaches the axis or the origin is that
    outside = side == "right" or problem.geometry == "planar" or problem.regions[0].start > 0.0
    return outside and getattr(problem, side).kind == "transmitting"


def _words(problem: Problem, side: str) -> str:
    if side == "left":
        return ("the transmitting left end treats a converging wave as plane: a wave that would run to the axis or "
                "the origin and come back is lost")
    solid = problem.materials[problem.regions[-1].material].strength is not None
    return (f"the transmitting right end of this {problem.geometry} problem is exact for sound only: up to {SOLID if solid else FLUID:.0%} "
            "of a strong wave comes back; move the end far enough away that its echo reaches no gauge before the run ends")


def _missing(side: str, part: str) -> str:
    return (f"material beyond the transmitting {side} end would send back a wave of {part} of the stress that reaches the end, "
            "because the elastic release overtakes the shock there; the run lacks this wave: move the end farther away")
