#!/usr/bin/env python3
"""Prints the measured numbers of docs/theory/lagrange2d.md and the two-dimensional ones of docs/verification.md that need other options.

    python benchmarks/plane_numbers.py            # all, some ten minutes on one core
    python benchmarks/plane_numbers.py kinds      # parts: kinds fluxes triangles filters bars

What the defaults give is in the tables of `hugoniot verify`.
"""

import dataclasses
import math
import sys

from hugoniot.campaign.plane import PLANE, run_plane
from hugoniot.campaign.verify import verify_problem
from hugoniot.errors import HugoniotError
from hugoniot.problem.plane.model import Viscosity2D
from hugoniot.solvers.lagrange2d.assemble import N, Z


def show(name: str, zones: int, words: str, **options) -> None:
    """All measures of a problem with these options."""
    try:
        found = ", ".join(f"{j.measure} {j.value:.4g}" for j in verify_problem(name, [zones], **options).judged)
    except HugoniotError as error:
        found = str(error)[:100]
    print(f"| {name}, {zones} | {words} | {found} |", flush=True)


def kinds() -> None:
    """The three viscosities, and the default without the heat flux."""
    for name, zones in (("noh_square", 50), ("noh_ring", 75), ("sedov_square", 45), ("saltzman_skewed", 100)):
        for words, viscosity in (("tensor", Viscosity2D()), ("without heat flux", Viscosity2D(heat_flux=0.0)),
                                 ("edge", Viscosity2D(kind="edge")), ("herrmann", Viscosity2D(kind="herrmann", limited=False))):
            show(name, zones, words, viscosity=viscosity)


def fluxes() -> None:
    """Without the heat flux, and with twice of it."""
    for name, zones in (("noh_square", 100), ("noh_sphere", 50), ("noh_sphere", 100), ("noh_ring", 150), ("sedov_sphere", 45)):
        show(name, zones, "without heat flux", viscosity=Viscosity2D(heat_flux=0.0))
    for name, zones in (("noh_ring", 75), ("sedov_square", 45)):
        show(name, zones, "twice the heat flux", viscosity=Viscosity2D(heat_flux=1.5))


def triangles() -> None:
    """The directions of the diagonals; a copper bar whose triangles share their pressure or not."""
    for diagonal in ("one_way", "alternating", "crossed"):
        show("noh_triangles", 50, diagonal, diagonal=diagonal)
        show("sedov_triangles", 45, diagonal, diagonal=diagonal)
        for shared in (True, False):
            show("taylor_triangles", 5, f"{diagonal}, pressure shared: {shared}", diagonal=diagonal, average_pressure=shared)


def filters() -> None:
    """Gresho's vortex without viscosity, without subzonal pressures, without both; Sedov and Saltzman without subzonal pressures."""
    none = Viscosity2D(linear=0.0, quadratic=0.0)
    show("gresho", 40, "without viscosity", viscosity=none)
    show("gresho", 40, "without subzonal pressures", subzonal_pressure=0.0)
    show("gresho", 40, "without both", viscosity=none, subzonal_pressure=0.0)
    show("sedov_square", 45, "without subzonal pressures", subzonal_pressure=0.0)
    for words, more in (("default", {}), ("without subzonal pressures", {"subzonal_pressure": 0.0})):
        print(f"| saltzman_skewed, 100 | {words} | steps {run_plane(PLANE['saltzman_skewed'], 100, **more).cycle} |", flush=True)


def measured(name: str, zones: int) -> dict[str, float]:
    """Length and radius of the foot, m, and largest plastic strain of a Taylor bar."""
    solver = run_plane(PLANE[name], zones)
    return {"length": solver.nodes[N.y].max(), "foot": solver.nodes[N.x].max(), "plastic_strain": solver.zones[Z.plastic_strain].max()}


def bars() -> None:
    """Taylor bars on three meshes: Richardson's order, limit and error of the finest; the steel bar by its shear coefficient."""
    for name in ("taylor_copper", "taylor_steel"):
        found = [measured(name, zones) for zones in (5, 10, 20)]
        for key in found[0]:
            coarse, middle, fine = (float(values[key]) for values in found)
            ratio = (coarse - middle) / (middle - fine)
            limit = fine + (fine - middle) / (ratio - 1.0)
            print(f"| {name}, {key} | {coarse:.5g}, {middle:.5g}, {fine:.5g} | order {math.log2(abs(ratio)):.2f}, limit {limit:.5g}, "
                  f"error {100 * abs(fine / limit - 1.0):.2f} % |", flush=True)
    for shear in (0.06, 0.3):
        show("taylor_steel", 5, f"solid_shear = {shear}", viscosity=dataclasses.replace(Viscosity2D(), solid_shear=shear))


PARTS = (kinds, fluxes, triangles, filters, bars)

if __name__ == "__main__":
    for part in PARTS:
        if len(sys.argv) < 2 or part.__name__ in sys.argv[1:]:
            print(f"\n{part.__name__}: {part.__doc__}", flush=True)
            part()
