r"""The echo that a transmitting end will miss after a planar impact, from the deck alone; other loads are left to the run.

A flyer with a free rear surface hits more of its own material at the velocity v. The shock has the particle velocity v/2. The release from
the rear surface is elastic up to an amplitude $Y(K/G + 4/3)$, of the longitudinal impedance Z of the shocked state. What it sends back and
when is as in `solvers.lagrange1d.transmitting`.
"""

import math

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos.contract import bulk_modulus, pressure, reference_state, sound_speed, temperature
from hugoniot.laws.strength.contract import STRENGTH, flow_stress, shear_modulus
from hugoniot.problem.model import Problem, Region
from hugoniot.theory.hugoniot import shock

RATE = 1e5     # strain rate behind a shock for laws that need one, 1/s


def echo_over_wave(problem: Problem, side: str) -> float:
    """Largest stress of the echo over that of the wave at the `side` ("left", "right") end, 0 if none returns in the time of the run."""
    impact = _impact(problem, side)
    material = problem.materials[problem.regions[0].material]
    if impact is None or material.strength is None:
        return 0.0
    flyer, target, closing = impact
    law = material.eos
    rho0, e0 = reference_state(law)
    try:
        behind = shock(law, particle_velocity=0.5 * closing, once=True)
    except (OutOfRange, NoSolution):
        return 0.0
    limit, softest, _ = _elastic(material, rho0, e0, 0.0)
    strain = math.log(behind.density / rho0) * 2.0 / 3.0
    amplitude, longitudinal, flow = _elastic(material, behind.density, behind.specific_internal_energy, strain)
    shocked = rho0 * behind.shock_velocity
    slope = 2.0 * shocked - rho0 * sound_speed(rho0, e0, law)
    wave, plastic = behind.pressure + flow * 2.0 / 3.0, behind.pressure + flow * 2.0 / 3.0 - 0.5 * limit
    if not (longitudinal > slope and plastic > 0.0):
        return 0.0
    softest += (longitudinal - softest) * (1.0 - min(amplitude / wave, 1.0))      # where the elastic release ends
    # times between the shock's arrival at the end and that of the first and the last part of the release, slower as the pressure falls
    arrival = rho0 * target / shocked
    first, last = (rho0 * (flyer / shocked + (flyer + target) / impedance) - arrival for impedance in (longitudinal, softest))
    since = max(first, 0.0)
    if last <= 0.0 or arrival + since + 2.0 * since * shocked / (longitudinal - shocked) > problem.stop_time:
        return 0.0
    release = min(amplitude, wave, plastic * (longitudinal + slope) / (2.0 * slope))
    return release * (longitudinal - slope) / (longitudinal + slope) / wave


def _elastic(material, rho: float, e: float, strain: float) -> tuple[float, float, float]:
    """(stress from yield to yield in the other direction, Pa; longitudinal impedance, kg/m2/s; flow stress, Pa)."""
    law, strength = material.eos, material.strength
    p, bulk = pressure(rho, e, law), bulk_modulus(rho, e, law)
    warm = temperature(rho, e, law) if "needs_temperature" in STRENGTH.of(strength).flags else 0.0
    shear, flow = shear_modulus(rho, p, warm, bulk, strength), flow_stress(rho, p, warm, strain, RATE, strength)
    if not shear > 0.0:
        return 0.0, 0.0, 0.0
    return flow * (bulk / shear + 4.0 / 3.0), math.sqrt(rho * (bulk + 4.0 / 3.0 * shear)), flow


def _impact(problem: Problem, side: str) -> tuple[float, float, float] | None:
    """(thickness of the flyer, of what it hits, m; closing velocity, m/s) where a plate of the same material moves towards that end."""
    regions = problem.regions if side == "right" else problem.regions[::-1]
    other = problem.left if side == "right" else problem.right
    if other.kind != "free" or len({region.material for region in regions}) > 1 or not all(_plain(region) for region in regions):
        return None
    if any(a.end != b.start for a, b in zip(problem.regions, problem.regions[1:])):
        return None
    sign = 1.0 if side == "right" else -1.0
    jumps = [k for k, (a, b) in enumerate(zip(regions, regions[1:])) if a.velocity != b.velocity]
    if len(jumps) != 1:
        return None
    count = jumps[0] + 1
    closing = sign * (regions[0].velocity - regions[-1].velocity)
    flyer, target = (sum(region.end - region.start for region in part) for part in (regions[:count], regions[count:]))
    return (flyer, target, closing) if closing > 0.0 else None


def _plain(region: Region) -> bool:
    started = (region.density, region.pressure, region.temperature, region.energy, region.profile)
    return all(value is None for value in started) and not isinstance(region.velocity, tuple)
