"""Setting up burning regions: the solver's laws for them, lighting times, the state before burning, and messages.

Burning zones have further rows in the zone table behind the inert ones (`layout`): burn fraction, time since lighting, size at
t = 0, the two phases of the previous step, and how the reactants' reference state was found. Runs without an explosive have no such rows.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.lighting import lighting_times
from hugoniot.laws.eos.contract import pressure, reference_state, sound_speed_squared
from hugoniot.laws.mixture.reference_state import FROZEN, MEANING, ROLLING
from hugoniot.laws.strength.contract import shear_modulus
from hugoniot.materials import burning
from hugoniot.problem.explosives import burns, defects, front_speed, programmed_bodies
from hugoniot.problem.model import Problem
from hugoniot.problem.write import toml_key
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import B, Z
from hugoniot.units import format_si
from hugoniot.zones.burn import STEP_SHARE

ZONES_NEEDED = 10.0  # in a reaction length, below which a rate is not resolved
PULLED = 0.01        # tension, in units of rho0 c0^2, beyond which an explosive that nothing parts is told of


def check(problem: Problem) -> None:
    """Refuse combinations that burning does not support, and burn laws that lack data; OutOfRange says what to change."""
    for _, message, hint in defects(problem):
        raise OutOfRange(f"{message}; {hint}" if hint else message)


def constants(problem: Problem, region) -> dict[str, float]:
    """What the zones of a burning region know besides their laws, as fields of `zones.constants.Constants`."""
    return {"per_rate": (problem.solver.courant or 0.0) / STEP_SHARE, "front": front_speed(problem, region),
            "freezes": float(problem.materials[region.material].reference_state == FROZEN)}


def start_region(material, region):
    """(rho, e with the chemical energy, p, longitudinal sound speed) of an unburned region."""
    rho, e = burning.start_state(material, region.density, region.pressure, region.temperature, region.energy)
    if not burning.has_reactants(material):
        return rho, e, 0.0, 0.0
    thermal = e - burning.heat_of(material)
    c2 = sound_speed_squared(rho, thermal, material.unreacted)
    if not c2 >= 0.0:
        raise OutOfRange(f"the unreacted explosive of region '{region.name}' has an imaginary sound speed at {rho:g} kg/m3")
    p = float(pressure(rho, thermal, material.unreacted))
    if material.strength is not None:
        c2 += 4.0 / 3.0 * shear_modulus(rho, p, 298.15, rho * c2, material.strength) / rho
    return rho, e, p, float(np.sqrt(c2))


def prepare(problem: Problem, zones, charge, places, ranges) -> None:
    """Fill the rows of burning zones: unburned, with the clock of their lighting. `places` are node positions by region."""
    for region, place, (a, b) in zip(problem.regions, places, ranges):
        if burns(problem, region):
            charge[B.rho_r, a:b], charge[B.e_r, a:b] = zones[Z.rho, a:b], zones[Z.e, a:b]
            charge[B.size, a:b] = np.diff(place)
            charge[B.resolution, a:b] = 1e300
    for body in programmed_bodies(problem):
        _light(problem, charge, places, ranges, body)


def _light(problem: Problem, charge, places, ranges, body: list[int]) -> None:
    """Lighting times of one body: distances count as times, since each explosive has its own front speed."""
    first, last = problem.regions[body[0]], problem.regions[body[-1]]
    points = [p for p in problem.lighting if first.start <= p.position <= last.end]
    ends = [first.start] + [problem.regions[k].end for k in body]
    clock = np.concatenate(([0.0], np.cumsum([(e - s) / front_speed(problem, problem.regions[k])
                                              for s, e, k in zip(ends[:-1], ends[1:], body)])))
    faces = np.interp(np.concatenate([places[body[0]], *(places[k][1:] for k in body[1:])]), ends, clock)
    times = lighting_times(faces, [(float(np.interp(p.position, ends, clock)), p.time) for p in points], 1.0)
    charge[B.since, ranges[body[0]][0]:ranges[body[-1]][1]] = -times


def isolated(problem: Problem) -> list[bool]:
    """Which regions hold an explosive whose reactants keep an isentrope, and so have a reference state."""
    return [burns(problem, region) and burning.keeps_isentrope(problem.materials[region.material]) for region in problem.regions]


def state_fields(problem: Problem, charge) -> dict[str, np.ndarray]:
    """Zone fields of a burning run only: burn_fraction and, where reactants are isolated, the code of their reference state."""
    rows = {"burn_fraction": B.lam} | ({"reference_state": B.reference} if any(isolated(problem)) else {})
    return {name: charge[row].copy() for name, row in rows.items()}


def gauge_columns(problem: Problem, block) -> dict[str, np.ndarray]:
    """Further columns of gauge records `block` (n, ngauge, columns): burn fraction, reference state and, for temperatures, what zones hold.

    `share` (n, ngauge) is that of the second of the two zones a gauge lies between, `phases` (n, ngauge, 2, 5) are those of both.
    """
    phases = block[:, :, L.GAUGE_PHASES:].reshape(*block.shape[:2], 2, len(L.PHASE_ROWS))
    codes = {"reference_state": block[:, :, L.GAUGE_REFERENCE]} if any(isolated(problem)) else {}
    return codes | {"burn_fraction": block[:, :, L.GAUGE_BURN], "share": block[:, :, L.GAUGE_SHARE], "phases": phases}


def released_heat(problem: Problem, mass, burned, ranges) -> float:
    """Chemical energy released so far, J in the problem's geometry, from the masses and burn fractions of the zones."""
    return float(sum(burning.heat_of(problem.materials[region.material]) * np.sum(mass[a:b] * burned[a:b])
                     for region, (a, b) in zip(problem.regions, ranges) if burns(problem, region)))


def unresolved(problem: Problem, resolution, ranges) -> list[str]:
    """A sentence for every region whose rate was faster than its zones resolve; resolution (nzone,): zones in a reaction length."""
    told = []
    for region, (a, b) in zip(problem.regions, ranges):
        if not burns(problem, region):
            continue
        held = resolution[a:b]
        held = held[held < 1e299]
        if held.size and np.median(held) < ZONES_NEEDED:
            told.append(f"region '{region.name}' burned within {np.median(held):.3g} zones (median over its zones), so its reaction zone "
                        f"is not resolved; {ZONES_NEEDED:g} zones are needed: make them {ZONES_NEEDED / np.median(held):.2f} times smaller")
    return told


def doubts(problem: Problem, resolution, peak_tension, ranges) -> list[str]:
    """What limits the validity of the results: rates that were not resolved, explosives in tension beyond their strength.

    Rows (nzone,) of any solver: zones in a reaction length, peak tension (Pa, positive); ranges: first and last zone of the regions.
    """
    return unresolved(problem, resolution, ranges) + pulled(problem, peak_tension, ranges)


def pulled(problem: Problem, peak_tension, ranges) -> list[str]:
    """A sentence for every region whose unburned explosive was in tension and has no fracture law that would separate it."""
    told = []
    for region, (a, b) in zip(problem.regions, ranges):
        material = problem.materials[region.material]
        if not burns(problem, region) or not burning.has_reactants(material) or material.fracture is not None:
            continue
        rho, e = reference_state(material.unreacted)
        tension, table = float(np.max(peak_tension[a:b])), f"[material.{toml_key(region.material)}.unreacted"
        if tension > PULLED * rho * sound_speed_squared(rho, e, material.unreacted):
            told.append(f"region '{region.name}': its unburned explosive held a tension of up to {format_si(tension, 'Pa')} without "
                        f"separating: give the material a fracture law, or limit the tension: {table}] "
                        "law = \"tension_cutoff\", tension = \"0 Pa\", and its own law with all constants "
                        f"under {table}.base]")
    return told


def references(problem: Problem, codes, ranges) -> list[str]:
    """A sentence for every region whose reactants are isolated: in how many zones their reference state was found, and how."""
    told = []
    for region, alone, (a, b) in zip(problem.regions, isolated(problem), ranges):
        if alone:
            kind = problem.materials[region.material].reference_state or ROLLING
            counts = ", ".join(f"{np.count_nonzero(codes[a:b] == code)} {words}" for code, words in MEANING.items())
            told.append(f"reference state of the reactants of region '{region.name}' ({kind}), by zones: {counts}")
    return told
