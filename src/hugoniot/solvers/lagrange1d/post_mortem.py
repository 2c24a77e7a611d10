"""Why a run cannot go on: the cause of a bad state and a remedy, found from the state at the end."""

import numpy as np

from hugoniot.errors import UnphysicalState
from hugoniot.laws.eos.contract import EOS, density_limits, pressure, reference_state
from hugoniot.materials import burning
from hugoniot.problem.explosives import crushed_unlit
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import B, H, Z
from hugoniot.units import format_si
from hugoniot.zones.soundness import first_unsound

NEAR = 8              # zones around a bad one in which its cause is looked for
DENSE = 1e9           # times the density of rest: compressed to nothing


def unphysical(solver, code: int) -> UnphysicalState:
    """The error with which a march ends, by the code it came back with: cause, remedy, the zone and its fields."""
    problem, zones = solver.problem, solver.zones
    culprit = max(first_unsound(zones[Z.rho], zones[Z.c], zones[Z.sigma]), 0)
    left, right = solver.faces(H.r)
    if code == L.STEP_COLLAPSED:
        culprit, _ = solver.limiting()
    crushed = crushed_zone(problem, zones, solver.region_of, culprit)
    culprit = crushed[0] if crushed else culprit
    values = {name: float(zones[row, culprit]) for name, row in solver.zone_fields.items()}
    if solver.burning:
        rows = {"burn_fraction": B.lam, "mixture_status": B.status}
        values |= {name: float(solver.charge[row, culprit]) for name, row in rows.items()}
    burned = ill_burned(problem, zones, solver.charge, solver.region_of, culprit) if solver.burning else None
    region = problem.regions[solver.region_of[culprit]]
    breaks = problem.materials[region.material].fracture is not None
    cause, remedy = crushed[1:] if crushed else burned or diagnose(code, values, float(left[culprit]), float(right[culprit]), breaks)
    return UnphysicalState(cause, remedy, culprit, region.name, _place(left, right, culprit), solver.time, solver.cycle, values)


def _place(left, right, culprit: int) -> float:
    """Where a zone is, m; one that is nowhere is reported where its nearest sound neighbour is."""
    with np.errstate(invalid="ignore"):
        centres = 0.5 * (left + right)
    near = np.flatnonzero(np.isfinite(centres))
    return float(centres[near[np.argmin(np.abs(near - culprit))]]) if near.size else float("nan")


def crushed_zone(problem, zones, region_of, culprit: int) -> tuple[int, str, str] | None:
    """(zone, cause, remedy) where a zone beside the bad one was pressed harder than its law can support at any density, or None.

    Laws with a compression limit stiffen without bound before it. Others, such as a truncated cold curve or the Hugoniot of a powder with
    a slope below 1, have a finite pressure at no volume at all: pressed harder, a zone collapses (Jordan section 5.1; J-E16).
    """
    near = range(max(0, culprit - NEAR), min(zones.shape[1], culprit + NEAR + 1))
    pressed = max(float(zones[Z.peak_stress, j]) for j in near)
    energy = max((float(zones[Z.e, j]) for j in near if np.isfinite(zones[Z.e, j])), default=0.0)
    for j in sorted(near, key=lambda j: abs(j - culprit)):
        region = problem.regions[region_of[j]]
        material = problem.materials[region.material]
        if material.burn is not None or np.isfinite(density_limits(material.eos)[1]):
            continue
        supported = float(pressure(DENSE * float(reference_state(material.eos)[0]), energy, material.eos))
        if 0.0 < supported < pressed:
            cause = (f"the zone collapsed: its equation of state cannot support more than {format_si(supported, 'Pa')}, however dense the "
                     f"material becomes, and the stress there reached {format_si(pressed, 'Pa')}.")
            return (j, cause, "use an equation of state that stiffens without bound: for a powder, grain_contact around this law, or "
                    "p_alpha or snow_plough over the law of its solid; otherwise the exact cold curve (mie_gruneisen_cold) instead of "
                    "a series; or a slower impact.")
    return None


def ill_burned(problem, zones, charge, region_of, culprit: int) -> tuple[str, str] | None:
    """(cause, remedy) of a bad state that comes of burning, or None."""
    near = slice(max(0, culprit - NEAR), culprit + NEAR + 1)
    densest = float(np.max(zones[Z.peak_density, near]))
    region = problem.regions[region_of[culprit]]
    return crushed_unlit(problem, region, densest) or torn_reactants(problem, zones, charge, region_of, culprit)


def torn_reactants(problem, zones, charge, region_of, culprit: int) -> tuple[str, str] | None:
    """(cause, remedy) where a burning zone's unreacted explosive is stretched beyond what its law can carry, or None.

    The laws of ignition-and-growth sets are fitted to compression: expanded and hot, their negative term makes sound imaginary.
    """
    material = problem.materials[problem.regions[region_of[culprit]].material]
    if material.burn is None or not burning.has_reactants(material) or zones[Z.c, culprit] > 0.0:
        return None
    if not charge[B.lam, culprit] < 1.0:
        return None
    rho = float(charge[B.rho_r, culprit])
    if not 0.0 < rho < float(reference_state(material.unreacted)[0]):
        return None
    law = EOS.of(material.unreacted).name
    burned = charge[B.lam, culprit]
    return (f"the explosive that has not burned (burn fraction {burned:.3g}) is stretched to {rho:.4g} kg/m3, where the mixture has no "
            f"sound speed: its law, {law}, is fitted to compression.",
            "stop the run before the release arrives, cover the free surface with an inert tamper, or give the material an unreacted law "
            "that expands ([material.NAME.unreacted] law = \"mie_gruneisen\"; after a weak shock tension_cutoff over its own law will do).")


def no_mixture(burn_fraction: float) -> tuple[str, str]:
    """(cause, remedy) where the search for the state of a mixture failed."""
    return ("reactants and products have no common pressure there: the search for the state of the mixture failed at a burn fraction of "
            f"{burn_fraction:.6g}.", "lower [solver] courant, use finer zones, or choose another mixture law for the material.")


def diagnose(code, values, left, right, breaks: bool) -> tuple[str, str]:
    """(cause, remedy) of a bad state; `breaks` says whether the material there has a fracture law."""
    if code == L.STEP_COLLAPSED:
        return ("the time step collapsed below 1e-12 of the stop time.",
                "use coarser zones there, or zones whose widths vary less, or stop the run earlier.")
    if values.get("mixture_status", 0.0) != 0.0:
        return no_mixture(values["burn_fraction"])
    if np.isnan(left + right):
        return ("a field of the zone is not a number any more: its state left the range of a law, or a boundary gave it no valid value.",
                "check the initial state, the boundaries and the impact conditions against the laws' limits, or lower [solver] courant.")
    if 0.0 < values.get("burn_fraction", 0.0) < 1.0:
        return (f"a burning zone (burn fraction {values['burn_fraction']:.3g}) has no valid state: if its burn is programmed, the "
                "explosive behind it may drive a faster front than the burn law allows, as in converging geometry.",
                "with a programmed burn, use the law programmed_beta, in which compression can burn a zone ahead of its schedule, or a "
                "rate law; with any other burn law, use finer zones or lower [solver] courant.")
    if not right > left:
        return ("the zone is inverted (negative volume).",
                "lower [solver] courant, or increase the artificial viscosity.")
    if not values["density"] > 0.0:
        return ("the density is negative or zero.", "lower [solver] courant.")
    if values["pressure"] < 0.0:
        return ("the sound speed became imaginary in tension: the material is stretched beyond the range of its equation of state.",
                "lower the limits of the fracture law ([material.NAME.fracture]), or use an equation of state valid in expansion." if breaks
                else "add a fracture law to the material ([material.NAME.fracture]).")
    return ("the sound speed is imaginary or not finite: the state left the range of its equation of state.",
            "check the impact conditions against the law's compression limit, lower [solver] courant, or use another equation of state.")
