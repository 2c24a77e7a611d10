"""Why a run had to stop: the zone, what is wrong with it, and what may help."""

import numpy as np

from hugoniot.errors import UnphysicalState
from hugoniot.problem.explosives import crushed_unlit
from hugoniot.solvers.lagrange1d.layout import B
from hugoniot.solvers.lagrange1d.post_mortem import no_mixture
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.zone_shapes import areas
from hugoniot.zones.soundness import first_unsound

NO_NUMBER = ("the state or the velocity of a zone is not a number any more",
             "use a smaller courant from the start; post_mortem.h5 in the run folder holds the fields of the zones around it")


def diagnose(solver, code) -> UnphysicalState:
    """The error that ends a march with `code`."""
    z = solver.zones
    x, y = solver._corners(N.x), solver._corners(N.y)
    area = areas(x, y)
    if (broken := _first_broken(solver)) is not None:
        zone, (cause, remedy) = broken, NO_NUMBER
    elif code == L.BAD_STATE:
        zone = max(int(first_unsound(z[Z.rho], z[Z.c], z[Z.sigma])), 0)
        cause, remedy = _ill_burned(solver, zone) or _unsound({"rho": z[Z.rho, zone], "c": z[Z.c, zone], "e": z[Z.e, zone]})
    else:
        triangles = np.min([(np.roll(x, -k, 0)[1] - np.roll(x, -k, 0)[0]) * (np.roll(y, -k, 0)[-1] - np.roll(y, -k, 0)[0])
                            - (np.roll(y, -k, 0)[1] - np.roll(y, -k, 0)[0]) * (np.roll(x, -k, 0)[-1] - np.roll(x, -k, 0)[0])
                            for k in range(len(x))], axis=0)
        flat = triangles / np.maximum(np.abs(area), 1e-300)
        zone = int(np.argmin(flat if solver.erosion.live is None else np.where(solver.erosion.live, flat, np.inf)))
        cause = "the mesh is tangled: a zone would invert (negative volume) at any time step" if code == L.TANGLED else (
            "the time step has collapsed: a zone is nearly flat")
        remedy = ("stop earlier, use a finer or differently shaped mesh there, or raise the hourglass coefficients" if solver.cycle else
                  "check the initial velocities and the mesh there")
    block = solver.problem.mesh.blocks[solver.region_of[zone]]
    i, j = block.place(zone)
    values = {name: float(z[row, zone]) for name, row in zip(Z._fields, range(len(Z))) if not name.startswith("f")}
    values |= {"i": i, "j": j, "x": float(x[:, zone].mean()), "y": float(y[:, zone].mean()), "area": float(area[zone])}
    place = values["x"], values["y"]
    start = "" if np.isfinite(place).all() else "initially "
    if start:
        place = block.x[i:i + 2, j:j + 2].mean(), block.y[i:i + 2, j:j + 2].mean()
    where = f" (zone i = {i}, j = {j}, {start}at ({place[0]:.6g}, {place[1]:.6g}) m)"
    return UnphysicalState(cause.removesuffix(".") + where, remedy, zone, block.name, None,
                           solver.time, solver.cycle, values)


def _first_broken(solver) -> int | None:
    """The first zone whose state is no number or, if there is none, the first with a node whose motion is none; a density is that of the
    nodes as they stand, so it is asked after what no other zone can have spoilt."""
    for rows in ((Z.e, Z.p, Z.c), (Z.rho, Z.sigma)):
        bad = ~np.isfinite(solver.zones[list(rows)]).all(axis=0)
        if bad.any():
            return int(np.argmax(bad))
    bad = ~np.isfinite([solver._corners(row) for row in (N.x, N.y, N.u, N.v)]).all(axis=(0, 1))
    return int(np.argmax(bad)) if bad.any() else None


def _ill_burned(solver, zone) -> tuple[str, str] | None:
    """(cause, remedy) of a bad state that comes of burning, or None."""
    if not solver.burning:
        return None
    if solver.charge[B.status, zone] != 0.0:
        return no_mixture(float(solver.charge[B.lam, zone]))
    return crushed_unlit(solver.problem, solver.problem.blocks[solver.region_of[zone]], float(solver.zones[Z.rho, zone]))


def _unsound(values) -> tuple[str, str]:
    if values["rho"] <= 0.0:
        return "a zone has a negative density", "use a smaller courant, or a law that is defined in tension"
    return (f"the sound speed of a zone is imaginary, at {values['rho']:.6g} kg/m3 and {values['e']:.6g} J/kg",
            "give the material a fracture law or a tension cut-off (its law is not defined in such a state), or use a smaller courant")
