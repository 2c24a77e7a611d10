"""Explosives of a problem: which regions burn, how fast a programmed front runs, and what is wrong with lighting and burn laws."""

from hugoniot.errors import HugoniotError
from hugoniot.laws import burn as _burn  # noqa: F401  (enrols the burn laws)
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.materials import burning
from hugoniot.materials.derived import chapman_jouguet
from hugoniot.problem.model import Problem
from hugoniot.units import format_si

TOLERATED = 5e-4   # of a programmed front's speed against the Chapman-Jouguet one: 3 % of pressure (p/p_CJ - 1 is about -sqrt(2 dD/D))


def burns(problem: Problem, region) -> bool:
    """Whether a region's material has a burn law."""
    return problem.materials[region.material].burn is not None


def front_speed(problem: Problem, region) -> float:
    """Speed of the programmed front in a region, m/s; 0 where nothing is programmed."""
    rate = problem.materials[region.material].burn
    return float(rate.detonation_velocity) if rate is not None and "programmed" in BURN.of(rate).flags else 0.0


def programmed_bodies(problem: Problem) -> list[list[int]]:
    """Stretches of touching regions with programmed burn, by index: a front runs through all of one."""
    bodies: list[list[int]] = []
    for k, region in enumerate(problem.regions):
        if front_speed(problem, region) <= 0.0:
            continue
        if bodies and bodies[-1][-1] == k - 1 and problem.regions[k - 1].end == region.start:
            bodies[-1].append(k)
        else:
            bodies.append([k])
    return bodies


def defects(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of everything wrong with the explosives of a problem."""
    found: list[tuple[tuple, str, str]] = []
    explosive = [region for region in problem.regions if burns(problem, region)]
    gradual = [region for region in explosive if "instantaneous" not in BURN.of(problem.materials[region.material].burn).flags]
    if gradual and problem.solver.integrator != "compatible":
        law = BURN.of(problem.materials[gradual[0].material].burn).name
        found.append((("solver", "integrator"), f"region '{gradual[0].name}' burns by the law '{law}', which the integrator "
                      f"'{problem.solver.integrator}' cannot: it burns a zone at once, by the law threshold",
                      "take integrator = \"compatible\""))
    for name in dict.fromkeys(region.material for region in explosive):
        try:
            burning.reactive(problem.materials[name])
        except HugoniotError as error:
            message, _, hint = str(error).partition("; ")
            found.append((("material", name, "burn"), message, hint))
    bodies = [[problem.regions[k] for k in body] for body in programmed_bodies(problem)]
    for k, point in enumerate(problem.lighting):
        if not any(body[0].start <= point.position <= body[-1].end for body in bodies):
            spans = ", ".join(f"'{body[0].name}' {format_si(body[0].start, 'm')} to {format_si(body[-1].end, 'm')}" for body in bodies)
            found.append((("lighting", k, "at"), f"no explosive with programmed burn at {format_si(point.position, 'm')}",
                          f"move it inside: {spans}" if spans else "no material of this problem has a programmed burn law"))
    for body in bodies:
        if not any(body[0].start <= point.position <= body[-1].end for point in problem.lighting):
            names = ", ".join(f"'{region.name}'" for region in body)
            found.append((("lighting",), f"programmed burn of {names} needs a lighting point", "add [[lighting]] with at = a place from "
                          f"{format_si(body[0].start, 'm')} to {format_si(body[-1].end, 'm')}, or burn = \"none\" for products at once"))
    return found


def advice(problem: Problem) -> list[str]:
    """What is allowed but seldom meant: a programmed front that is not the one the products would drive.

    A faster one leaves a weak detonation, below the CJ pressure; into a slower one the products run, until its zones are crushed.
    """
    told = []
    for name in dict.fromkeys(region.material for region in problem.regions if front_speed(problem, region) > 0.0):
        material = problem.materials[name]
        ideal = _own_speed(material)
        if ideal is None:
            continue
        excess = material.burn.detonation_velocity / ideal - 1.0
        if abs(excess) > TOLERATED:
            effect = (f"behind it the pressure stays up to {100.0 * (2.0 * excess) ** 0.5:.2g} % low" if excess > 0.0
                      else "its zones are compressed from behind, in the end crushed")
            told.append(f"material '{name}': the programmed front runs at {material.burn.detonation_velocity:.5g} m/s, its products would "
                        f"drive one at {ideal:.5g} m/s (Chapman-Jouguet): {effect}; give burn.detonation_velocity = {ideal:.6g}")
    return told


def _own_speed(material) -> float | None:
    """Chapman-Jouguet velocity of a material's products with its chemical energy, m/s; None for laws not linear in energy."""
    if "linear_in_energy" not in EOS.of(material.eos).flags:
        return None
    try:
        return chapman_jouguet(material.eos, float(reference_state(material.eos)[0]), burning.heat_of(material)).velocity
    except (HugoniotError, ArithmeticError, ValueError):
        return None
