"""Explosives of a problem: which regions burn, how fast a programmed front runs, and what is wrong with lighting and burn laws."""

import json
from dataclasses import replace

from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import HugoniotError
from hugoniot.laws import burn as _burn  # noqa: F401  (enrols the burn laws)
from hugoniot.laws.burn.contract import BURN, keeps_time
from hugoniot.laws.eos.contract import EOS, reference_state
from hugoniot.materials import burning
from hugoniot.problem.defaults import FOR_PRODUCTS
from hugoniot.problem.model import Problem
from hugoniot.problem.write import toml_key
from hugoniot.theory.chapman_jouguet import cj, overdriven
from hugoniot.theory.hugoniot import Initial
from hugoniot.units import format_si

# Relative difference of a programmed front's speed from the Chapman-Jouguet one, (slower, faster), without a warning. A faster front lacks
# up to 4 % of the pressure; a slower one gains with every zone crossed: at -1e-4, 7 % after 4000 zones, and at -3.6e-4 zones are crushed
# after 1700.
TOLERATED = (-1e-4, 5e-4)
SAME_DENSITY = 1e-3   # between that of a burn law and that of the region it burns; sets and measured densities differ by less
CRUSHED = 2.5      # times the starting density: products behind a front do not reach it (CJ 1.4, reflected at a wall 1.8)
OVERDRIVEN = 1.03     # times the CJ pressure of an explosive to which another drives it: equal ones differ by their rounding
CONVERGING = 1.2      # radii over which a front runs inward
SAME_HEAT = 0.2       # between a chemical energy that is given and the one the laws hold


def burns(problem: Problem, region) -> bool:
    """Whether a region's material has a burn law."""
    return problem.materials[region.material].burn is not None


def front_speed(problem: Problem, region) -> float:
    """Speed of the programmed front in a region, m/s; 0 where nothing is programmed."""
    rate = problem.materials[region.material].burn
    return float(rate.detonation_velocity) if rate is not None and "programmed" in BURN.of(rate).flags else 0.0


def ideal_speed(problem: Problem, region) -> float | None:
    """Chapman-Jouguet speed of a programmed region's products from its own start, m/s; None where nothing is programmed or none exists."""
    point = _own_state(problem.materials[region.material], region) if front_speed(problem, region) > 0.0 else None
    return None if point is None else float(point.detonation_velocity)


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
    for name in dict.fromkeys(region.material for region in problem.regions if burns(problem, region)):
        try:
            burning.reactive(problem.materials[name])
        except HugoniotError as error:
            message, _, hint = str(error).partition("; ")
            found.append((("material", name, "burn"), message, hint))
    bodies = [[problem.regions[k] for k in body] for body in programmed_bodies(problem)]
    for k, point in enumerate(problem.lighting):
        if not any(body[0].start <= point.position <= body[-1].end for body in bodies):
            spans = ", or ".join(" and ".join(f"'{region.name}'" for region in body)
                                 + f", {format_si(body[0].start, 'm')} to {format_si(body[-1].end, 'm')}" for body in bodies)
            found.append((("lighting", k, "at"), f"no explosive with programmed burn at {format_si(point.position, 'm')}",
                          f"move the lighting point into {spans}" if spans else "no material of this problem has a programmed burn law"))
    for body in bodies:
        if not any(body[0].start <= point.position <= body[-1].end for point in problem.lighting):
            names = ", ".join(f"'{region.name}'" for region in body)
            found.append((("lighting",), f"programmed burn of {names} needs a lighting point",
                          "add [[lighting]] with at = \"...\", a position from "
                          f"{format_si(body[0].start, 'm')} to {format_si(body[-1].end, 'm')}, or burn = \"none\" to start with products"))
    return found


def advice(problem: Problem) -> list[str]:
    """What is allowed but seldom meant: fronts products would not drive, burn laws of another density, lighting that comes too late."""
    said = material_advice(problem) + lighting_advice(problem)
    said += [text for body in programmed_bodies(problem) if (text := _converging_advice(problem, body))]
    if problem.solver.kind == "lagrange1d":      # tracked fronts are overdriven as they should be
        said += [text for body in programmed_bodies(problem) for text in _weaker_advice(problem, body)]
    for region in problem.regions:
        if burns(problem, region):
            said += [text for text in region_advice(problem, region) if text not in said]
    return said


def lighting_advice(problem) -> list[str]:
    """Of lighting points that fire after the end of the run, or before its start."""
    said = []
    for k, point in enumerate(problem.lighting):
        if point.time > problem.stop_time:
            said.append(f"lighting point {k + 1} fires at {format_si(point.time, 's')}, after the end of the run (stop_time), "
                        "and has no effect")
        elif point.time < 0.0:
            said.append(f"lighting point {k + 1} fires {format_si(-point.time, 's')} before the run starts: the explosive that its front "
                        "has passed by then starts as products at rest, at the pressure of a constant-volume explosion and without the "
                        "flow behind a detonation; give a time of 0 or later")
    return said


def material_advice(problem) -> list[str]:
    """Of every material without a burn law what it gives in vain."""
    return [f"material '{name}' has no burn law: its {', '.join(idle)} {'is' if len(idle) == 1 else 'are'} not used"
            for name in dict.fromkeys(region.material for region in problem.regions) if (idle := _idle(problem.materials[name]))]


def region_advice(problem, region) -> list[str]:
    """Of a region that burns what its front, its density, its chemical energy and its viscosity have of their own, in sentences."""
    material = problem.materials[region.material]
    sentences = (_front_advice(problem, region), _density_advice(problem, region), _heat_advice(material), _closure_advice(material),
                 _viscosity_advice(problem.solver, material))
    return [text for text in sentences if text]


def _viscosity_advice(solver, material) -> str:
    """That a linear viscosity other than the default one has no effect in an explosive that burns by a schedule alone."""
    given = solver.viscosity
    if given is None or solver.integrator == "wilkins" or not keeps_time(material.burn, burning.has_reactants(material)):
        return ""
    plane = hasattr(given, "explosive_linear")
    if plane:
        key, value, usual = "explosive_linear", given.explosive_linear, type(given).explosive_linear
    else:
        key, value, usual = "linear", given[1].get("linear"), FOR_PRODUCTS[solver.integrator][1]["linear"]
    if value in (None, 0.0, usual):
        return ""
    return (f"[solver.viscosity] {key} = {value:g} has no effect in '{material.name}', which burns by '{BURN.of(material.burn).name}' into "
            "'burned_products': linear viscosity would compress it ahead of the front")


def _idle(material) -> list[str]:
    """What a material without a burn law says of burning in vain. Products at once are an explosive too, and hold the law's own energy."""
    if material.burn is not None:
        return []
    given = ["detonation_energy"] if material.detonation_energy is not None else []
    if "reacted" not in EOS.of(material.eos).flags:
        given += [word for word in ("unreacted", "mixture") if getattr(material, word) is not None]
    return given


def _front_advice(problem: Problem, region) -> str | None:
    """Of a programmed front whose speed is not that of the products from the region's own start.

    A faster one leaves a weak detonation, below the CJ pressure; a slower one is overtaken by the products, which compress the unburned
    zones ahead of it until the run stops.
    """
    material, speed = problem.materials[region.material], front_speed(problem, region)
    point = _own_state(material, region) if speed > 0.0 else None
    if point is None or _tolerated(speed, point):
        return None
    ideal = point.detonation_velocity
    excess = speed / ideal - 1.0
    effect = ("the products overtake it and compress the unburned zones ahead of it until the run stops" if excess < 0.0 else
              f"behind it the pressure is {_lacking(material, point, speed)} below the CJ pressure")
    return (f"material '{region.material}': the programmed front runs at {speed:.5g} m/s, but its products would drive one at "
            f"{ideal:.5g} m/s (Chapman-Jouguet): {effect}; give burn.detonation_velocity = {ideal:.6g}")


def _lacking(material, point, speed: float) -> str:
    """By how much the pressure of the weak detonation at the `speed` of its front (m/s) is below that of the CJ `point`, in words."""
    try:
        weak = overdriven(material.eos, point.initial, branch="weak", shock_velocity=speed)
    except (HugoniotError, ArithmeticError, ValueError):
        return "far"
    part = 1.0 - float(weak.pressure) / float(point.state.pressure)
    return f"about {100.0 * part:.2g} %" if part < 0.5 else "far"


def follows_compression(material) -> bool:
    """Whether what is compressed burns ahead of a schedule."""
    return "compression_driven" in BURN.of(material.burn).flags


def crushing_density(material, regions) -> float:
    """Density, kg/m3, to which nothing may press a material that has no pressure before its programmed front lights it; else NO_LIMIT.

    regions    those (in two dimensions the blocks) of this material
    """
    if material.burn is None or not keeps_time(material.burn, burning.has_reactants(material)):
        return NO_LIMIT
    starts = [_start(material, region) for region in regions]
    return CRUSHED * max((start[0] for start in starts if start is not None), default=NO_LIMIT)


def crushed_unlit(problem, region, densest: float) -> tuple[str, str] | None:
    """(cause, remedy) where zones of a region were crushed, to `densest` kg/m3, before a programmed front had lit them; else None."""
    material = problem.materials[region.material]
    if not front_speed(problem, region) > 0.0 or follows_compression(material):
        return None
    if not densest > CRUSHED * float(region.density or reference_state(material.eos)[0]):
        return None
    point = _own_state(material, region)
    slow = point is not None and material.burn.detonation_velocity < point.detonation_velocity * (1.0 + TOLERATED[0])
    own = (f"give burn.detonation_velocity = {point.detonation_velocity:.6g}, the Chapman-Jouguet velocity of its products at this "
           "density; if the zones are still crushed, " if slow else "")
    return (f"zones were crushed, to {densest:.4g} kg/m3, before the programmed front lit them: what pushes them arrives earlier, such as "
            "a plate, or burned explosive that drives a faster front than the burn law allows (as in converging geometry).",
            f"{own}use a rate law, or allow compression to burn a zone ahead of its schedule:\n{with_compression(material, region)}")


def with_compression(material, region) -> str:
    """The lines of a deck that let compression burn a region ahead of its schedule, with the densities and the speed of its products."""
    point, speed = _own_state(material, region), material.burn.detonation_velocity
    numbers = f", rho0 = {_start(material, region)[0]:.6g}, rho_cj = {point.state.density:.6g}" if point else ", rho0 = ..., rho_cj = ..."
    if point and not _tolerated(speed, point):
        speed = point.detonation_velocity
    burn = f'{{law = "programmed_beta"{numbers}, detonation_velocity = "{speed:.6g} m/s"}}'
    base = f"base = {json.dumps(material.library, ensure_ascii=False)}\n" if material.library else ""
    return f"[material.{toml_key(region.material)}]\n{base}burn = {burn}"


def _tolerated(speed: float, point) -> bool:
    """Whether a programmed front runs nearly at the Chapman-Jouguet velocity."""
    return TOLERATED[0] <= speed / point.detonation_velocity - 1.0 <= TOLERATED[1]


def _weaker_advice(problem: Problem, body: list[int]) -> list[str]:
    """Of fronts that are programmed to pass into a weaker explosive, the texts of `weaker`."""
    said = []
    for a, b in zip(body, body[1:]):
        pair, side = (problem.regions[a], problem.regions[b]), _lit_from(problem, body, a)
        ways = [way for way, against in ((pair, 1), (pair[::-1], -1)) if side != against]
        said += [text for donor, other in ways if (text := weaker(problem, donor, other))]
    return said


def weaker(problem, donor, other) -> str:
    """What happens where the programmed front passes from a region (or block) into a weaker explosive; "" where it is not weaker.

    The products behind overdrive it, and crush what is not lit yet: they release to the particle velocity of the weaker CJ state along the
    tangent of their isentrope, dp = -rho0 D du. With 200 zones/cm Composition B crushes both TNT (CJ 21 GPa) and pentolite (25.5 GPa)
    within 1.5 cm.
    """
    material = problem.materials[other.material]
    one, two = (_own_state(problem.materials[region.material], region) for region in (donor, other))
    if one is None or two is None or follows_compression(material):
        return ""
    rho0, speed = _start(problem.materials[donor.material], donor)[0], one.detonation_velocity
    driven = one.state.pressure + rho0 * speed * (one.state.particle_velocity - two.state.particle_velocity)
    if driven <= OVERDRIVEN * two.state.pressure:
        return ""
    return (f"the programmed front passes from '{donor.name}' (CJ pressure {format_si(one.state.pressure, 'Pa', 3)}) into "
            f"'{other.name}' ({format_si(two.state.pressure, 'Pa', 3)}): the stronger products would drive a faster front "
            "than its schedule, so its zones are compressed before they are lit, the pressures come out too high, and on "
            f"a fine mesh the run stops; let compression burn them:\n{with_compression(material, other)}")


def _lit_from(problem: Problem, body: list[int], k: int) -> int:
    """From which side the front reaches the end of region k: -1 left, 1 right, 0 both at once."""
    place, first = problem.regions[k].end, {-1: NO_LIMIT, 0: NO_LIMIT, 1: NO_LIMIT}
    for point in problem.lighting:
        if problem.regions[body[0]].start <= point.position <= problem.regions[body[-1]].end:
            low, high = sorted((point.position, place))
            way = sum(max(0.0, min(high, r.end) - max(low, r.start)) / front_speed(problem, r) for r in (problem.regions[n] for n in body))
            side = (point.position > place) - (point.position < place)
            first[side] = min(first[side], point.time + way)
    return min((0, -1, 1), key=lambda side: first[side])


def _converging_advice(problem: Problem, body: list[int]) -> str | None:
    """Of a front that is programmed to run inward: it wants to run faster than its schedule, and crushes what that has not lit yet."""
    inner, outer = problem.regions[body[0]].start, problem.regions[body[-1]].end
    lit = [point.position for point in problem.lighting if inner <= point.position <= outer]
    region = next((problem.regions[k] for k in body if not follows_compression(problem.materials[problem.regions[k].material])), None)
    if problem.geometry == "planar" or region is None or not lit or min(lit) <= CONVERGING * inner:
        return None
    return (f"the programmed front of '{region.name}' runs inward from {format_si(min(lit), 'm')} to {format_si(inner, 'm')}: a "
            f"real converging front would outrun this schedule, so unlit zones are crushed; use\n"
            f"{with_compression(problem.materials[region.material], region)}")


def _density_advice(problem: Problem, region) -> str | None:
    """Of a burn law that counts compression from another density than the region starts at: denser, it burns at rest."""
    material = problem.materials[region.material]
    counted = getattr(material.burn, "rho0", None)
    start = _start(material, region)
    if counted is None or start is None or abs(start[0] / counted - 1.0) <= SAME_DENSITY:
        return None
    return (f"region '{region.name}' starts at {start[0]:.6g} kg/m3, and its burn law '{BURN.of(material.burn).name}' measures compression "
            f"from rho0 = {counted:.6g} kg/m3: denser material counts as shocked; give burn.rho0 = {start[0]:.6g} and constants "
            "for that density")


def _heat_advice(material) -> str | None:
    """Of a chemical energy far from the one the laws of the explosive hold."""
    if material.detonation_energy is None or "reacted" not in EOS.of(material.eos).flags:
        return None
    own = burning.heat_of(replace(material, detonation_energy=None))
    if abs(material.detonation_energy / own - 1.0) <= SAME_HEAT:
        return None
    return (f"material '{material.name}': detonation_energy = {format_si(material.detonation_energy, 'J/kg')}, but its equations of state "
            f"give {format_si(own, 'J/kg')}: omit it unless the difference is intended")


def _closure_advice(material) -> str:
    """Of burning by compression in a closure in which weak compressions run faster than the detonation."""
    if not burning.outruns_itself(material):
        return ""
    return (f"material '{material.name}': with mixture = \"{burning.closure(material)}\" the burn law '{BURN.of(material.burn).name}' lets "
            "weak compressions burn a little explosive at once and run ahead of the detonation, the faster the finer the mesh; "
            'use mixture = "weighted_pressures" or "burned_products"')


def _start(material, region) -> tuple[float, float] | None:
    """(rho, e) in which a region starts, e with the chemical energy; None where it has no such state (told elsewhere)."""
    try:
        return burning.start_state(material, region.density, region.pressure, region.temperature, region.energy)
    except HugoniotError:
        return None


def _own_state(material, region):
    """Chapman-Jouguet point of a region's products from the density and energy it starts with; None where they have none."""
    start = _start(material, region)
    if start is None:
        return None
    try:
        return cj(material.eos, Initial(start[0], 0.0, start[1]))
    except (HugoniotError, ArithmeticError, ValueError):
        return None
