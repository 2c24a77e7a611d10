"""Explosives of a two-dimensional problem: what is wrong with their laws and lighting, and what is seldom meant."""

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.materials import burning
from hugoniot.problem.explosives import burns, front_speed, lighting_advice, material_advice, region_advice, weaker
from hugoniot.problem.plane.lighting import bodies, holds, unlit, zone_lighting_times
from hugoniot.problem.plane.model import Problem2D

HEAD_ON = 0.5      # of the time in which a front goes straight across a joint: one that runs along it is hardly later on the other side


def defects(problem: Problem2D) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of everything wrong with the explosives of a problem."""
    found: list[tuple[tuple, str, str]] = []
    for name in dict.fromkeys(block.material for block in problem.blocks if burns(problem, block)):
        try:
            burning.reactive(problem.materials[name])
        except HugoniotError as error:
            message, _, hint = str(error).partition("; ")
            found.append((("material", name, "burn"), message, hint))
    return found or _lighting_defects(problem)


def _lighting_defects(problem: Problem2D) -> list[tuple[tuple, str, str]]:
    lit = bodies(problem)
    names = " or ".join(f"'{problem.blocks[k].name}'" for body in lit for k in body.blocks)
    found = []
    for k, point in enumerate(problem.lighting):
        what = "the lighting point" if point.to is None else "this end of the line"
        for key, place in (("at", point.at), ("to", point.to)):
            if place is not None and not any(holds(problem.mesh, body, np.array(place)) for body in lit):
                found.append((("lighting", k, key), f"no explosive with programmed burn at ({place[0]:g}, {place[1]:g}) m",
                              f"move {what} into {names}" if names else "no material of this problem has a programmed burn law"))
    for body in unlit(problem, lit) if not found else ():
        names = ", ".join(f"'{problem.blocks[k].name}'" for k in body.blocks)
        hint = "add [[lighting]] there, or let it touch a lit explosive"
        found.append((("lighting",), f"no detonation front reaches {names}", hint))
    return found


def advice(problem: Problem2D) -> list[str]:
    """What is allowed but seldom meant, as `problem.explosives.advice`."""
    said = material_advice(problem) + lighting_advice(problem)
    for block in problem.blocks:
        if burns(problem, block):
            said += [text for text in region_advice(problem, block) if text not in said]
    return said + _weaker_advice(problem)


def _weaker_advice(problem: Problem2D) -> list[str]:
    """Of joints that a programmed front crosses into a weaker explosive, the texts of `problem.explosives.weaker`."""
    said, mesh, times = [], problem.mesh, None
    for joint in mesh.joints.values():
        a, b = (problem.blocks[k] for k in joint.blocks)
        if a.material == b.material or not all(front_speed(problem, block) > 0.0 for block in (a, b)):
            continue
        texts = weaker(problem, a, b), weaker(problem, b, a)
        if any(texts):
            times = zone_lighting_times(problem) if times is None else times
            centres = mesh.nodes[:, mesh.zone_nodes[joint.zones]].mean(axis=-1)
            apart = np.hypot(*(centres[:, :, 1] - centres[:, :, 0]))
            later = np.median((times[joint.zones[:, 1]] - times[joint.zones[:, 0]]) / apart)
            crossed = (later * front_speed(problem, a) > HEAD_ON, -later * front_speed(problem, b) > HEAD_ON)
            said += [text for text, way in zip(texts, crossed) if text and way]
    return said
