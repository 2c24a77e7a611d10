"""Isentropes of any law through any state: release to a pressure, a density or a velocity, and to vacuum.

Implementation: the integrator and its equations are in `theory.expansion`.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials.initial_state import energy_at_pressure, energy_at_temperature, initial_state
from hugoniot.theory import expansion
from hugoniot.theory.states import States, density_at, density_range, evaluate, law_of, rest_of

COMPILE_ABOVE = 200
AMBIENT = 1e3  # Pa: a law with more than that at rest is a gas


def isentrope(material, start: States | None = None, *, direction: int = 1, **given) -> States:
    """States on the isentrope through a given state.

    material    a `Material`, or the parameters of an equation of state
    start       a single state (default: the reference state, at rest)
    given       exactly one of density (kg/m3), pressure (Pa), particle_velocity (m/s): a number or an array
    direction   direction of the wave that makes the change. +1: towards +x, so that release lowers the particle velocity; -1: towards -x,
                so that release raises it, as at a free surface on the right

    Returns `States` of the shape of the number or array given. Raises `OutOfRange` if the isentrope ends before that value, at a tension
    that the material does not support or at a limit of the law; the message gives the last state reached.
    """
    par = law_of(material)
    start = start or reference(par)
    if len(given) != 1 or next(iter(given)) not in ("density", "pressure", "particle_velocity"):
        raise OutOfRange("give exactly one of density, pressure, particle_velocity for a state on an isentrope, "
                         f"got {', '.join(given) or 'none'}")
    name, value = next(iter(given.items()))
    targets = np.atleast_1d(np.asarray(value, float)).ravel()
    if not np.isfinite(targets).all():
        raise OutOfRange(f"{name} must be finite")
    y0, e0 = math.log(start.density), float(start.specific_internal_energy)
    with np.errstate(all="ignore"):
        if name == "density":
            y, e, u = _by_density(targets, y0, e0, par)
        else:
            wanted = direction * (targets - start.particle_velocity) if name == "particle_velocity" else targets
            y, e, u = _by_search(name, wanted, y0, e0, par)
    rho = np.where(y == y0, start.density, np.exp(y)) if name != "density" else targets
    p = targets if name == "pressure" else evaluate(contract.pressure, rho, e, par)
    fields: tuple[Any, ...] = (rho, p, e, start.particle_velocity + direction * u)
    shape = np.shape(value)
    return States(par, *(f.reshape(shape) if shape else float(f[0]) for f in fields))


def reference(material, velocity: float = 0.0) -> States:
    """The reference state of a material, with a particle velocity in m/s."""
    par = law_of(material)
    rho, e = rest_of(material)
    return States(par, rho, float(contract.pressure(rho, e, par)), e, velocity)


def state(material, velocity: float = 0.0, **given) -> States:
    """A single state of a material.

    material   a `Material`, or the parameters of an equation of state
    velocity   particle velocity, m/s
    given      at most two of density (kg/m3), pressure (Pa), energy (J/kg), temperature (K). With none of them, the reference
               state; with density alone, zero pressure; with one of the others alone, the reference density

    Returns `States` whose fields are numbers. Raises `OutOfRange` for a state that the material cannot have.
    """
    par = law_of(material)
    if stray := set(given) - {"density", "pressure", "energy", "temperature"}:
        raise OutOfRange(f"a state is given by density, pressure, energy or temperature, not by {', '.join(sorted(stray))}")
    if len(given) > 2:
        raise OutOfRange(f"two values fix a state, {len(given)} were given: {', '.join(given)}")
    rho0, e0 = rest_of(material)
    rho = given.get("density", None if len(given) == 2 else rho0)
    if "temperature" in given:
        found = initial_state(par, given.get("density"), given.get("pressure"), given["temperature"], given.get("energy"))
        rho, e = (float(v) for v in found)
        return States(par, rho, float(contract.pressure(rho, e, par)), e, velocity)
    if rho is None:
        rho = density_at(par, given["pressure"], given["energy"])
    low, high = density_range(par)
    if not low <= rho < high:
        raise OutOfRange(f"density {rho:.6g} kg/m3 is outside the law's range, {low:.6g} to {high:.6g} kg/m3")
    if "energy" in given:
        e = float(given["energy"])
    elif "pressure" in given or "density" in given:
        e = float(energy_at_pressure(rho, given.get("pressure", 0.0), par))
    else:
        e = e0
    return States(par, float(rho), float(contract.pressure(rho, e, par)), e, velocity)


def release(material, start: States, to: float = 0.0, *, direction: int = -1, points: int = 1) -> States:
    """States on the release isentrope from a state down to a pressure.

    material    a `Material`, or the parameters of an equation of state; a porous material is released at the compaction it has reached
    start       a single state
    to          final pressure, Pa
    direction   -1: the release runs towards -x, as from a free surface on the right; +1: towards +x
    points      1: the final state alone; more: this number of states, evenly spaced in pressure

    Returns `States`. Raises `OutOfRange` if `to` is above the pressure of `start`, or where the isentrope ends before `to`.
    """
    material = elastic(history(material, start))
    if to > start.pressure:
        raise OutOfRange(f"a release to {to:.6g} Pa must start above it, not at {start.pressure:.6g} Pa")
    if points == 1:
        return isentrope(material, start, pressure=to, direction=direction)
    return isentrope(material, start, pressure=np.linspace(start.pressure, to, points), direction=direction)


def expansion_to(material, start: States, to: float, points: int) -> States:
    """States on the isentrope from a state to the pressure `to`, Pa, behind a wave that runs towards -x.

    Crushed pores are released elastically. The pressures of gases and detonation products are spaced by equal factors, others by equal
    steps.
    """
    flags = EOS.of(law_of(material)).flags
    if to <= start.pressure and "reacted" not in flags:
        release(material, start, to)       # an end out of reach is refused by its own number, not by one on the way
        return release(material, start, to, points=points)
    by_factors = ("reacted" in flags or reference(material).pressure > AMBIENT) and to > 0.0
    span = np.geomspace(start.pressure, to, points) if by_factors else np.linspace(start.pressure, to, points)
    return isentrope(material, start, pressure=span, direction=-1)


def at_temperature(material, density: float, temperature: float) -> tuple[float, float]:
    """Pressure (Pa) and energy (J/kg) at a density (kg/m3) and a temperature (K). OutOfRange where there is no such state."""
    par = law_of(material)
    if not temperature >= 0.0:
        raise OutOfRange(f"a temperature of {temperature:.6g} K is not a valid state")
    e = energy_at_temperature(density, temperature, par)
    return float(contract.pressure(density, e, par)), float(e)


def grid(material, densities, temperatures) -> tuple[np.ndarray, np.ndarray]:
    """Pressure (Pa) and energy (J/kg), each (n, m), at n densities (kg/m3) and m temperatures (K), as for the equation of state `table`."""
    found = np.array([[at_temperature(material, float(rho), float(t)) for t in temperatures] for rho in densities])
    return found[..., 0], found[..., 1]


def history(material, start: States) -> Any:
    """The equation of state after loading to a state: pores crushed by it stay crushed. Unchanged if it has no memory.

    If `start` has a history of crushing already, it is kept.
    """
    par = law_of(material)
    if "remembers" not in EOS.of(par).flags:
        return par
    own = start.par if type(start.par) is type(par) else par
    rho, e = start.density, start.specific_internal_energy
    branch = elastic(own)
    if abs(contract.pressure(rho, e, branch) - start.pressure) <= 1e-10 * rho * abs(contract.sound_speed_squared(rho, e, branch)):
        return own     # nothing is crushed in this state, but for round-off
    return contract.remembered(contract.compacted(0.0, rho, e, start.pressure, own), own)


def elastic(par) -> Any:
    """The branch on which a porous material unloads and reloads; any other equation of state unchanged."""
    return contract.unloading(par) if "remembers" in EOS.of(par).flags else par


def unload(material, start: States, *, direction: int, **given) -> States:
    """The isentrope through a state, as `isentrope`; a material with crushed pores unloads elastically, and stays crushed."""
    kept = history(material, start)
    return replace(isentrope(elastic(kept), start, direction=direction, **given), par=kept)


def escape(material, start: States) -> float:
    r"""Velocity gained by expansion from a state into vacuum, m/s: $\int_0^\rho c\,d\ln\rho$, for what becomes a gas at low density.

    Raises OutOfRange for an equation of state with zero pressure at a finite density (a condensed material).
    """
    par = law_of(material)
    y, e, u = math.log(start.density), float(start.specific_internal_energy), 0.0
    lowest = math.log(density_range(par)[0])
    with np.errstate(all="ignore"):
        for _ in range(600):
            rho = math.exp(y)
            p = contract.pressure(rho, e, par)
            gamma = contract.gruneisen(rho, e, par)
            if p > 0.0 and gamma > 0.0 and abs(p - gamma * rho * e) <= 1e-13 * p:
                return float(2.0 * math.sqrt((gamma + 1.0) * p / rho) / gamma - u)
            if p <= 0.0 or y - 0.5 <= lowest:
                break
            status, y, e, u = expansion.advance(y, e, u, y - 0.5, par)
            if status != expansion.REACHED:
                break
    raise OutOfRange(f"law '{EOS.of(par).name}' does not expand to a gas: its isentrope ends at {math.exp(y):.6g} kg/m3, "
                     f"{p:.6g} Pa; release it to a pressure instead")


def residual(states: States) -> float:
    """Largest residual of de + p dv = 0 between neighbouring states, relative to the energy exchanged.

    The work between two states is computed independently of the integrator, by Gauss-Legendre quadrature on the isentrope.
    """
    worst = 0.0
    for i in range(len(states) - 1):
        a, b = states[i], states[i + 1]
        gain = b.specific_internal_energy - a.specific_internal_energy
        ends = _edges(a, math.log(b.density))
        noise = 1e-15 * (abs(a.specific_internal_energy) + a.sound_speed**2 * abs(ends[-1][0] - ends[0][0]))
        work = sum(_work(a.par, *start, end[0], 1e-13 * abs(gain) + noise) for start, end in zip(ends, ends[1:]))
        worst = max(worst, abs(gain - work) / max(abs(work), abs(gain), 1e-300))
    return worst


# -- inside ------------------------------------------------------------------------------------------------------
def _by_density(targets, y0, e0, par):
    low, high = density_range(par)
    if (targets <= low).any() or (targets >= high).any():
        beyond = targets[(targets <= low) | (targets >= high)][0]
        raise OutOfRange(f"a density of {beyond:.6g} kg/m3 is outside the range of law '{EOS.of(par).name}', "
                         f"{low if low > 1e-200 else 0.0:.6g} to {high:.6g} kg/m3")
    order = np.argsort(targets)
    logs = np.log(targets)
    e, u = np.empty_like(targets), np.empty_like(targets)
    # outwards from the start on either side, each state from its neighbour
    for side in (order[logs[order] >= y0], order[logs[order] < y0][::-1]):
        if side.size > COMPILE_ABOVE:
            from hugoniot.theory import kernels

            found_e, found_u = np.empty(side.size), np.empty(side.size)
            reached = kernels.isentrope_curve(logs[side], y0, e0, 0.0, par, found_e, found_u)
            if reached < side.size:
                last = (logs[side[reached - 1]], found_e[reached - 1]) if reached else (y0, e0)
                status, y, e_here, _ = expansion.advance(*map(float, last), 0.0, float(logs[side[reached]]), par)
                _end(status, y, e_here, par)
            e[side], u[side] = found_e, found_u
            continue
        y, e_here, u_here = y0, e0, 0.0
        for i in side:
            status, y, e_here, u_here = expansion.advance(y, e_here, u_here, float(logs[i]), par)
            if status != expansion.REACHED:
                _end(status, y, e_here, par)
            e[i], u[i] = e_here, u_here
    return logs, e, u


def _by_search(name, targets, y0, e0, par):
    low, high = density_range(par)
    lowest, highest = math.log(low), math.log(high) if math.isfinite(high) else 700.0
    find = expansion.to_pressure if name == "pressure" else expansion.to_velocity
    y, e, u = np.empty_like(targets), np.empty_like(targets), np.empty_like(targets)
    first = contract.pressure(math.exp(y0), e0, par) if name == "pressure" else 0.0
    order = np.argsort(targets)
    for side in (order[targets[order] >= first], order[targets[order] < first][::-1]):
        here = (y0, e0, 0.0)
        for i in side:
            status, *here = find(*here, float(targets[i]), lowest, highest, par)
            if status != expansion.REACHED:
                unit = "Pa" if name == "pressure" else "m/s"
                _end(status, here[0], here[1], par, f"{name.replace('_', ' ')} {targets[i]:.6g} {unit} is not reached: ")
            y[i], e[i], u[i] = here
    return y, e, u


def _end(status, y, e, par, what=""):
    rho = math.exp(y)
    p = contract.pressure(rho, e, par)
    square = contract.sound_speed_squared(rho, e, par)
    torn = status != expansion.OUTSIDE and (p < 0.0 or not square > 0.0)
    why = ("the law is not defined beyond" if not torn else "the law supports no greater tension" if p < 0.0 else
           "the law is unstable beyond")
    raise OutOfRange(f"{what}the isentrope of law '{EOS.of(par).name}' ends at {rho:.6g} kg/m3, {p:.6g} Pa, {e:.6g} J/kg: {why}")


def _edges(start, end):
    """(ln(rho), e) from a state to ln(rho) = `end` on its isentrope, where a smooth piece of the law ends and at most 0.3 apart."""
    par, y, e = start.par, math.log(start.density), float(start.specific_internal_energy)
    kink = math.log(contract.reference_state(par)[0])  # where a law may change its branch
    found = [(y, e)]
    while y != end:
        goal = min(max(end, y - 0.3), y + 0.3)
        _, y, e, _ = expansion.stretch(y, e, 0.0, kink if min(y, goal) < kink < max(y, goal) else goal, par)
        found.append((y, e))
    return found


def _work(par, y1, e1, y2, tolerance):
    """Integral of p/rho d ln(rho) from (y1, e1) to y2, its error below the tolerance or in an interval of 1e-9."""
    whole, middle = _quadrature(par, y1, e1, y2)
    half = 0.5 * (y1 + y2)
    parts = _quadrature(par, y1, e1, half)[0], _quadrature(par, half, middle, y2)[0]
    if abs(sum(parts) - whole) <= tolerance or abs(y2 - y1) < 1e-9:
        return sum(parts)
    return _work(par, y1, e1, half, tolerance) + _work(par, half, middle, y2, tolerance)


def _quadrature(par, y1, e1, y2):
    """(the integral by 12 nodes, the energy half way)."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    here = States(par, math.exp(y1), float(contract.pressure(math.exp(y1), e1, par)), e1, 0.0)
    way = isentrope(par, here, density=np.exp(0.5 * (y1 + y2) + 0.5 * (y2 - y1) * np.append(nodes, 0.0)))
    return 0.5 * (y2 - y1) * float(np.sum(weights * (way.pressure / way.density)[:-1])), float(way.specific_internal_energy[-1])
