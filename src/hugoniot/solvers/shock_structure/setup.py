"""Sets up grid, laws, cells and ends of the viscous flow solver from a problem; what a fixed grid cannot represent is refused."""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract as eos_laws
from hugoniot.laws.transport import contract as transport_laws
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.model import Problem
from hugoniot.solvers.shock_structure import layout as L

NAME = "shock_structure"
FEWEST_CELLS = 8


def eos_of(problem: Problem):
    names = {region.material for region in problem.regions}
    if len(names) != 1:
        raise OutOfRange(f"the solver {NAME} treats one material on a fixed grid, not {len(names)}: use lagrange1d for several")
    if problem.geometry != "planar":
        raise OutOfRange(f"the solver {NAME} is planar; geometry '{problem.geometry}' needs lagrange1d")
    return problem.materials[names.pop()].eos


def transport_of(problem: Problem):
    transport = problem.solver.options.get("transport")
    if transport is None:
        raise OutOfRange(f"the solver {NAME} needs a transport law: give [solver.transport] with viscosity = {{law = ...}}")
    if isinstance(transport, transport_laws.Transport):
        made = transport
    else:
        made = transport_laws.make(transport["viscosity"], transport.get("conduction"), transport.get("bulk_ratio", 0.0),
                                   transport.get("bulk_viscosity", 0.0))
    if transport_laws.needs_temperature(made):
        eos_laws.require_temperature(eos_of(problem))
    return made


def grid_of(problem: Problem):
    """(faces (n+1,) m, region of each cell); cells of equal width."""
    regions = problem.regions
    widths = [(region.end - region.start) / region.zones for region in regions]
    for a, b in zip(regions, regions[1:]):
        if a.end != b.start:
            raise OutOfRange(f"the solver {NAME} needs regions that touch; there is a gap between '{a.name}' and '{b.name}'")
    for region, width in zip(regions, widths):
        if region.ratio != 1.0:
            raise OutOfRange(f"the solver {NAME} needs cells of equal width, but in region '{region.name}' each is {region.ratio:g} times "
                             "as wide as the one before: leave ratio out")
        if abs(width / widths[0] - 1.0) > 1e-9:
            raise OutOfRange(f"the solver {NAME} needs cells of equal width, but those of region '{region.name}' are {width:.6g} m wide "
                             f"and those of '{regions[0].name}' {widths[0]:.6g} m: change zones")
    count = sum(region.zones for region in regions)
    if count < FEWEST_CELLS:
        raise OutOfRange(f"the solver {NAME} needs at least {FEWEST_CELLS} cells; there are {count}")
    return np.linspace(regions[0].start, regions[-1].end, count + 1), np.repeat(np.arange(len(regions)), [r.zones for r in regions])


def conserved(rho, u, e) -> np.ndarray:
    """(density, momentum, total energy) from density, velocity, specific internal energy."""
    return np.array([rho, rho * u, rho * (e + 0.5 * u * u)])


def cells_of_regions(problem: Problem, eos, region_of):
    rows = []
    for region in problem.regions:
        rho, e = initial_state(eos, region.density, region.pressure, region.temperature, region.energy)
        first, last = region.velocity if isinstance(region.velocity, tuple) else (region.velocity, region.velocity)
        u = first + (last - first) * (np.arange(region.zones) + 0.5) / region.zones
        rows.append(conserved(np.full(region.zones, rho), u, np.full(region.zones, e)))
    cells = np.hstack(rows)
    return cells, np.array([cells[:, 0], cells[:, -1]])


def end_kind(boundary, side: str) -> int:
    if boundary.kind not in L.END_KINDS:
        raise OutOfRange(f"boundary.{side} = '{boundary.kind}' is not possible on a fixed grid; the solver {NAME} supports "
                         f"{' and '.join(L.END_KINDS)}")
    return L.END_KINDS[boundary.kind]
