r"""One-dimensional geometry: planar, cylindrical, spherical.

Volumes are per square metre (planar), per metre and radian (cylindrical) or per steradian (spherical):
$V = (r_2^d - r_1^d)/d$, $A = r^{d-1}$ (Wilkins B.2 item 1). The differences are written factored, so a thin shell far
from the origin loses no digits.
"""

from typing import NamedTuple

import numpy as np

from hugoniot.core.registry import Registry

GEOMETRY = Registry("geometry", contract=("area", "mean_area", "area_per_radius", "volume", "hoops"))


class Planar(NamedTuple):
    dimension: float = 1.0


class Cylindrical(NamedTuple):
    dimension: float = 2.0


class Spherical(NamedTuple):
    dimension: float = 3.0


def area(r, geometry):
    """Area r^(d-1) of a node's surface."""
    return GEOMETRY.of(geometry).functions["area"](r, geometry)


def mean_area(r1, r2, geometry):
    """Volume between two nodes over their distance."""
    return GEOMETRY.of(geometry).functions["mean_area"](r1, r2, geometry)


def area_per_radius(r1, r2, geometry):
    """Mean area of a zone over its mean radius: what the hoop stress pushes on (curved geometries)."""
    return GEOMETRY.of(geometry).functions["area_per_radius"](r1, r2, geometry)


def volume(r1, r2, geometry):
    """Volume (r2^d - r1^d)/d between two nodes."""
    return GEOMETRY.of(geometry).functions["volume"](r1, r2, geometry)


def hoops(geometry):
    """Number d - 1 of hoop directions."""
    return GEOMETRY.of(geometry).functions["hoops"](geometry)


GENERICS = {"area": area, "mean_area": mean_area, "area_per_radius": area_per_radius, "volume": volume, "hoops": hoops}


def planar_area(r, geometry):
    return 1.0


def planar_mean_area(r1, r2, geometry):
    return 1.0


def planar_area_per_radius(r1, r2, geometry):
    return 0.0


def planar_volume(r1, r2, geometry):
    return r2 - r1


def planar_hoops(geometry):
    return 0.0


def cylindrical_area(r, geometry):
    return r


def cylindrical_mean_area(r1, r2, geometry):
    return 0.5 * (r2 + r1)


def cylindrical_area_per_radius(r1, r2, geometry):
    return 1.0


def cylindrical_volume(r1, r2, geometry):
    return 0.5 * (r2 - r1) * (r2 + r1)


def cylindrical_hoops(geometry):
    return 1.0


def spherical_area(r, geometry):
    return r * r


def spherical_mean_area(r1, r2, geometry):
    return (1.0 / 3.0) * (r1 * r1 + r1 * r2 + r2 * r2)


def spherical_area_per_radius(r1, r2, geometry):
    return (2.0 / 3.0) * (r1 * r1 + r1 * r2 + r2 * r2) / (r1 + r2 + 1e-30)


def spherical_volume(r1, r2, geometry):
    return (1.0 / 3.0) * (r2 - r1) * (r1 * r1 + r1 * r2 + r2 * r2)


def spherical_hoops(geometry):
    return 2.0


def _enrol(name, cls, functions):
    GEOMETRY.add(name, cls, functions=dict(zip(GENERICS, functions)), example=cls(), units={"dimension": "1"},
                 meaning={"dimension": "d"}, box={}, references=("Wilkins, appendix B.2 item 1",))


_enrol("planar", Planar, (planar_area, planar_mean_area, planar_area_per_radius, planar_volume, planar_hoops))
_enrol("cylindrical", Cylindrical, (cylindrical_area, cylindrical_mean_area, cylindrical_area_per_radius, cylindrical_volume,
                                    cylindrical_hoops))
_enrol("spherical", Spherical, (spherical_area, spherical_mean_area, spherical_area_per_radius, spherical_volume, spherical_hoops))


def graded_nodes(start: float, end: float, zones: int, ratio: float = 1.0) -> np.ndarray:
    """zones + 1 node positions from start to end, each zone `ratio` times as wide as the one before; ends exact."""
    if ratio == 1.0:
        nodes = start + (end - start) * (np.arange(zones + 1) / zones)
    else:
        widths = ratio ** np.arange(zones)
        nodes = start + (end - start) * np.concatenate(([0.0], np.cumsum(widths) / np.sum(widths)))
    nodes[0], nodes[-1] = start, end
    return nodes
