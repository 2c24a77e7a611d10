"""Writes docs/theory/shock_structure_numbers.md: every law's shocks, orders of the transient, the source's grid, speed.

    python docs/generate_shock_structure.py            # all, some minutes on one core
    python docs/generate_shock_structure.py matrix     # only this part: matrix, orders, resolutions, spacings, speed

The page is kept in the repository, unlike other generated pages: it is a record. Times are processor time of one core.
"""

import contextlib
import math
import sys
import time
from pathlib import Path

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws import eos as _laws  # noqa: F401  (enrols the equations of state)
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.transport.contract import make
from hugoniot.problem.structure_start import ample_room, resolved, shock_start
from hugoniot.solvers.shock_structure.layout import ROUGH
from hugoniot.solvers.shock_structure.measure import thickness_by_differences
from hugoniot.solvers.shock_structure.solver import ShockStructure
from hugoniot.theory.structure import find_ends, jordan, steady

TARGET = Path(__file__).parent / "theory" / "shock_structure_numbers.md"
MACHS = (1.01, 1.1, 2.0, 5.0, 20.0)
CONDUCTIONS = {"without": None, "with": {"law": "prandtl", "prandtl": 1.0}}
WATER_SPACINGS = (15.5e-9, 7.75e-9, 3.875e-9, 1.9375e-9, 0.96875e-9, 0.484375e-9, 0.2421875e-9)


def table(heads, rows) -> list[str]:
    return ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads), *("| " + " | ".join(row) + " |" for row in rows), ""]


# -- every law ---------------------------------------------------------------------------------------------------------
REASONS = {"no temperature": "no temperature", "its c_p is n": "unstable", "no such shock: ": "beyond limit"}


def shock_of(law, conduction, mach) -> tuple[str, float]:
    """(thickness over 4/3 mu/(rho1 u1), or in a word why there is none; processor time, s)."""
    begun = time.process_time()
    try:
        profile = steady(law.example, make({"law": "constant", "shear_viscosity": 1e-3}, CONDUCTIONS[conduction]), mach=mach)
        shown = f"{profile.thickness() * profile.ends.mass_flux / (4e-3 / 3.0):.4g}"
    except HugoniotError as error:
        shown = next(short for part, short in REASONS.items() if part in str(error))
    return shown, time.process_time() - begun


def matrix() -> list[str]:
    rows, times, found = [], [], 0
    for law in EOS:
        for conduction in CONDUCTIONS:
            row = []
            for mach in MACHS:
                shown, took = shock_of(law, conduction, mach)
                times.append(took)
                found += shown[0].isdigit()
                row.append(shown)
            rows.append([f"`{law.name}`", conduction, *row])
    count = len(rows) * len(MACHS)
    return ["Thickness of the density profile in units of (4/3) μ / (ρ₁u₁), where μ is the constant shear viscosity, ρ₁ the density ahead "
            "of the shock and u₁ the velocity of the shock relative to the material ahead. Each law has the constants of the example on "
            "its own page, and the state ahead is the reference state. *With* heat conduction means a Prandtl number of 1. "
            f"Of {count} cases {found} have a steady wave. "
            "The others have none:", "",
            "* *beyond limit*: the shock is stronger than the fit, the table or the law allows.",
            "* *unstable*: the specific heat at constant pressure is not positive behind the shock, or within the wave where heat "
            "runs ahead of the shock. Heat conduction is then impossible.",
            "* *no temperature*: the law has no temperature, so heat conduction cannot be computed.", "",
            "The rows of `table` at Mach 1.01 show an artefact of a coarse grid. The example tabulates the law of the row "
            "`mie_gruneisen`, with one cell from 2785 to 3200 kg/m³. In so wide a cell $e_v = Tp_T - p$ does not hold, and the shock "
            "lowers the temperature by 15.9 K instead of raising it by 4.5 K. Conduction then makes the wave thinner. The same law "
            "tabulated in steps of 0.28 kg/m³ and 1 K gives 201.6 without and 207.2 with conduction.", "",
            f"CPU time of the slowest case: {max(times):.2f} s; of all {count}: {sum(times):.0f} s.", "",
            *table(("law", "heat conduction", *(f"Mach {m:g}" for m in MACHS)), rows)]


# -- orders ------------------------------------------------------------------------------------------------------------
def titled(case) -> str:
    """Water, or silica with the density of the powder."""
    return "water" if case.name.startswith("water") else f"silica powder, {case.density:g} kg/m³"


def cases():
    """name -> keywords of `resolved`."""
    law, ahead = jordan.argon()
    for mach in jordan.ARGON_MACHS:
        yield f"argon, Mach {mach:g}", dict(material=law, transport=jordan.argon_transport(), upstream=ahead, mach=mach)
    for case in jordan.CONDENSED.values():
        yield (f"{titled(case)}, {case.particle_velocity:g} m/s",
               dict(material=case.eos(), transport=case.transport(), particle_velocity=case.particle_velocity))


def worst_error(keywords, frame, count) -> float:
    """Largest relative error of the thickness, from a step, at nine instants of the last flow of the gas behind through a thickness."""
    problem, profile = resolved(**keywords, cells=count, frame=frame)
    solver = ShockStructure(problem, shock_start(problem))
    flow, found = profile.thickness() / profile.ends.downstream.velocity, 0.0
    for part in (1.0, 0.875, 0.75, 0.625, 0.5, 0.375, 0.25, 0.125, 0.0):
        solver.march(problem.stop_time - part * flow, 10**9)
        found = max(found, abs(solver.thickness()[0] / profile.thickness() - 1.0))
    return found


def orders() -> list[str]:
    rows = []
    for name, keywords in cases():
        for frame in ("standing", "moving"):
            found = [worst_error(keywords, frame, count) for count in (5, 10, 20)]
            rows.append([name, frame, *(f"{100.0 * e:.2g}" for e in found), *(f"{math.log2(a / b):.1f}" for a, b in zip(found, found[1:]))])
    return ["Error of the density thickness relative to the steady wave, for runs started from a step with 5, 10 and 20 cells in the "
            "thickness, and the observed orders of convergence. All runs have the domain and duration recommended for the transient "
            "solver. The error is the largest found at nine instants at the end of the run, while the material behind the "
            "shock moves by one thickness. The velocities of water and silica are particle velocities.", "",
            *table(("case", "frame", "5 cells, %", "10 cells, %", "20 cells, %", "order, 5 to 10", "order, 10 to 20"), rows)]


# -- table 6.2.1.1 by resolution ---------------------------------------------------------------------------------------------
CELLS_OF_300 = (300, 600, 1200, 2400, 4800, 9600, 19200)     # Jordan's numbers of cells in 300 mean free paths
ENOUGH = 12      # cells in a thickness, beyond which finer rows say the same
PRINTED = {("constant", 1.55): "5.47 3.82 3.29 3.04 2.99 2.97 2.97", ("constant", 3.38): "4.18 2.17 1.24 0.82 0.65 0.58 0.56",
           ("constant", 9.0): "NA NA 1.06 0.59 0.33 0.23 0.18", ("power_law", 1.55): "7.50 6.29 5.95 5.83 5.80 5.80 5.79",
           ("power_law", 3.38): "5.17 3.42 2.85 2.62 2.56 2.55 2.55", ("power_law", 9.0): "NA 3.95 3.44 3.25 3.18 3.16 3.15",
           ("maxwell", 1.55): "6.06 4.62 4.17 4.02 3.99 3.98 3.97", ("maxwell", 3.38): "NA 2.82 2.11 1.87 1.78 1.75 1.75",
           ("maxwell", 9.0): "NA NA 2.51 2.26 2.19 2.17 2.16"}


def resolutions() -> list[str]:
    """Table 6.2.1.1 row by row: thickness from a step on the source's spacings, beside what it prints."""
    law, ahead = jordan.argon()
    rows = []
    for block, (viscosity, unit) in jordan.ARGON_BLOCKS.items():
        for mach in jordan.ARGON_MACHS:
            transport = jordan.argon_transport(viscosity)
            profile = steady(law, transport, ahead, mach=mach)
            true, path = profile.thickness(), profile.mean_free_path(unit)
            row: list[str] = []
            prints = PRINTED[block, mach].split()
            for count in CELLS_OF_300:
                cells = true * count / (300.0 * path)
                if row and 0.5 * cells > ENOUGH:
                    row.append("")
                    continue
                room = tuple(max(side, 40.0 / cells) for side in ample_room(profile))
                problem, _ = resolved(law, transport, ahead, mach=mach, cells=cells, room=room)
                solver = ShockStructure(problem, shock_start(problem))
                solver.march(problem.stop_time, 10**9)
                found = thickness_by_differences(solver.h, solver.cells[0], *solver.ends[:, 0]) / path
                row.append(f"{found:.3g}")
            name = block.replace("_", " ").replace("maxwell", "Maxwell")
            rows += [[name, f"{mach:g}", "here", *row, f"{true / path:.4g}"], ["", "", "Jordan", *prints, ""]]
    return ["Density thickness as Jordan computes it (eq. 6.2.5, central differences), for runs started from a step, in the mean free "
            "paths that Jordan uses for each viscosity in table 6.2.1.1. The headings are the numbers of cells in 300 mean free paths; "
            f"*steady* is the thickness of the steady wave. Finer grids are omitted once a thickness spans more than {ENOUGH} cells. "
            "NA is printed in the source.", "",
            *table(("viscosity", "Mach", "", *map(str, CELLS_OF_300), "steady"), rows)]


# -- the source's grid -------------------------------------------------------------------------------------------------------
def on_spacing(case, spacing, first_order=False) -> tuple[float, float]:
    """(thickness by Jordan eq. 6.2.5 on 600 cells of a spacing, steady thickness), m."""
    keywords = dict(material=case.eos(), transport=case.transport(), particle_velocity=case.particle_velocity)
    true = steady(**keywords).thickness()
    many = 300.0 * spacing / true
    problem, profile = resolved(**keywords, cells=true / spacing, room=(many, many), times=max(many, 20.0))
    solver = ShockStructure(problem, shock_start(problem))
    solver.counters[ROUGH] = 10**12 if first_order else 0   # counts down
    solver.march(problem.stop_time, 10**9)
    return thickness_by_differences(solver.h, solver.cells[0], *solver.ends[:, 0]), profile.thickness()


def by_central_differences(case, widths=5.0, alpha=1e-3) -> float:
    """Thickness, m, by Jordan eq. 6.2.5 on its 600 cells from a step, by the scheme of its eqs 2.4.1.7 to 2.4.1.19, without conduction.

    Explicit steps alpha h/c0 of averages at the faces: no dissipation but the fluid's own. Lengths in h, rho in rho0, velocities in c0.
    widths   time in h/c0; the ripples that the scheme makes take the stronger shock apart between 10 and 20
    """
    ends = find_ends(case.eos(), particle_velocity=case.particle_velocity)
    rho0, c0 = case.density, case.sound_speed
    first, last = ([s.density / rho0, ends.mass_flux / (rho0 * c0), s.density / rho0 * (s.energy + 0.5 * s.velocity**2) / c0**2]
                   for s in (ends.upstream, ends.downstream))
    U = np.repeat(np.array([first, last]).T, 300, axis=1)
    mu = 4.0 / 3.0 * case.shear_viscosity / (rho0 * c0 * case.spacing)
    g, s = case.bent, case.slope

    def middle(f):
        return 0.5 * (f[1:] + f[:-1])
    for _ in range(round(widths / alpha)):
        rho, j, E = U
        u, x = j / rho, 1.0 - 1.0 / rho
        p = x * (1.0 - 0.5 * g * x) / (1.0 - s * x) ** 2 + g * (E - 0.5 * j * u)
        tau = mu * np.diff(u)
        F = [middle(j), middle(j) * middle(u) + middle(p) - tau, middle(j) * middle(E + p) / middle(rho) - tau * middle(u)]
        U[:, 1:-1] -= alpha * np.diff(F)
    return thickness_by_differences(case.spacing, U[0], *U[0, [0, -1]])


def spacings() -> list[str]:
    rows, schemes = [], []
    for name in ("water_387", "water_858"):
        case = jordan.CONDENSED[name]
        row, true, label = [], 0.0, f"water, {case.particle_velocity:g} m/s"
        for spacing in WATER_SPACINGS:
            shown, true = on_spacing(case, spacing)
            printed = f" (Jordan's grid: {case.printed[0] * 1e9:.0f})" if spacing == case.spacing else ""
            row.append(f"{shown * 1e9:.4g}" + printed)
        rows.append([label, *row, f"{true * 1e9:.4g}"])
        found = (on_spacing(case, case.spacing)[0], on_spacing(case, case.spacing, True)[0], by_central_differences(case))
        schemes.append([label, *(f"{f * 1e9:.3g} nm, {f / case.spacing:.2g} cells" for f in found),
                        f"{case.printed[0] * 1e9:.0f} nm, {case.printed[0] / case.spacing:.0f} cells"])
    return ["Thickness in nm of shocks in water of two particle velocities by Jordan's eq. 6.2.5, on 600 cells of the width in the "
            "heading. Jordan's result is given in brackets at the cell width that Jordan used:", "",
            *table(("shock", *(f"{s * 1e9:.3g} nm" for s in WATER_SPACINGS), "steady"), rows),
            "The same on cells of Jordan's width by three schemes: this solver; this solver at first order (local Lax-Friedrichs flux); "
            "and the central differences of Jordan's section 2.4.1. The last are shown when sound has crossed five cells; later the "
            "ripples of this scheme steepen the front further:", "",
            *table(("shock", "this solver", "first order", "central differences", "Jordan"), schemes)]


# -- speed -----------------------------------------------------------------------------------------------------------------
@contextlib.contextmanager
def timed(rows, words):
    begun = time.process_time()
    yield
    rows.append([words, f"{time.process_time() - begun:.2f}"])


def speed() -> list[str]:
    law, ahead = jordan.argon()
    rows: list = []
    steady(law, jordan.argon_transport(), ahead, mach=2.0).thickness()
    for mach in (1.01, 9.0):
        with timed(rows, f"steady, argon, Mach {mach:g}"):
            steady(law, jordan.argon_transport(), ahead, mach=mach).thickness()
    with timed(rows, "steady, the nine argon cases of table 6.2.1.1"):
        for viscosity, unit in jordan.ARGON_BLOCKS.values():
            for mach in jordan.ARGON_MACHS:
                profile = steady(law, jordan.argon_transport(viscosity), ahead, mach=mach)
                profile.thickness() / profile.mean_free_path(unit)
    problem, profile = resolved(law, jordan.argon_transport(), ahead, mach=9.0)
    ShockStructure(problem, shock_start(problem)).march(1e-300, 1)   # compile
    solver = ShockStructure(problem, shock_start(problem))
    with timed(rows, ""):
        solver.march(problem.stop_time, 10**9)
    error = abs(solver.thickness()[0] / profile.thickness() - 1.0)
    rows[-1][0] = (f"transient, argon, Mach 9 from a step, 10 cells in the thickness: {len(solver.region_of)} cells, {solver.cycle} steps, "
                   f"{solver.zone_updates / 1e6:.2g} million cell updates; {100 * error:.2g} % from the steady thickness")
    share = 5e7 * 19200 / solver.zone_updates
    return [*table(("calculation", "CPU time, s"), rows),
            f"Jordan took 5e7 steps on 19 200 cells, 9.6e11 cell updates, per case: about "
            f"{1e4 * round(share / 1e4):_.0f} times as many as the run in the last row.".replace("_", " ")]


PARTS = {"Every equation of state of the package": matrix, "Order of the transient": orders, "Argon by resolution": resolutions,
         "Water on Jordan's grid": spacings, "Speed": speed}


def main(wanted) -> None:
    """Write the parts whose function is named in `wanted` (none: all) anew and keep the others."""
    old = dict(part.split("\n", 1) for part in ("\n" + TARGET.read_text()).split("\n### ")[1:]) if TARGET.exists() else {}
    text = []
    for title, part in PARTS.items():
        fresh = not wanted or part.__name__ in wanted or title not in old
        text += [f"### {title}", *(["", *part()] if fresh else old[title].rstrip().split("\n")), ""]
    TARGET.write_text("\n".join(text).rstrip() + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
