"""Functions of a zone that the passes use, for each kind of zone: quadrilaterals (`quads`) or triangles (`triangles`).

A pass names the corners of its zones by one row of its rows, `layout.Sides` or `layout.Vertices` (with velocities) or
`layout.SidesNow` or `layout.VerticesNow` (positions only). The compiler chooses among the functions here by this class, so that the same
source of the passes serves both kinds of zone. In Python the same classes are used.
"""

from hugoniot.core.binder import bind, bind_choice
from hugoniot.core.ops import fmax, vsqrt
from hugoniot.solvers.lagrange2d import forces, quads, triangles
from hugoniot.solvers.lagrange2d.layout import VertexForces, Vertices, VerticesNow
from hugoniot.solvers.lagrange2d.quads import AreaWeighted, Planar, quad
from hugoniot.solvers.lagrange2d.triangles import Triangle, triangle


def cell(corners, j):
    """`Quad` or `Triangle`: zone j."""
    return _by_corners(type(corners))(corners, j)


def volume(of, geometry):
    """Area, or true volume per radian."""
    return _volume(type(of), type(geometry))(of, geometry)


def coefficients(of, near, geometry):
    """Coefficients of a zone; near: the radius used for the axis."""
    return _coefficients(type(of), None, type(geometry))(of, near, geometry)


def strains(of, corners, j, near, geometry):
    """`quads.Strains` of zone j, which is `of`."""
    return _strains(type(of), None, None, None, type(geometry))(of, corners, j, near, geometry)


def power(f, corners, j):
    """Power of the forces on the corners of zone j, W."""
    return _power(type(f))(f, corners, j)


def longest_side(of):
    """Length (m) which over the area of a zone is the inverse of its smallest altitude: the longest edge, half that of a triangle."""
    return _longest_side(type(of))(of)


def stress_forces(f, j, b, p, xx, yy, xy, qxx, qyy, qxy, qhoop):
    """Forces of the stress of zone j with the coefficients b: pressure, deviators and mean viscous stress (compression positive)."""
    return _stress_forces(type(f))(f, j, b, p, xx, yy, xy, qxx, qyy, qxy, qhoop)


# -- quadrilaterals -----------------------------------------------------------------------------------------------------------
def quad_of(corners, j):
    return quad(corners.low, corners.high, j)


def quad_volume(q, geometry):
    return quads.volume(q, geometry)


def quad_coefficients(q, near, geometry):
    return quads.coefficients(q, near, geometry)


def quad_strains(q, corners, j, near, geometry):
    return quads.strains(q, corners.low, corners.high, j, near, geometry)


def quad_power(f, corners, j):
    low, high = corners.low, corners.high
    work = f.f0x[j] * low.u[j] + f.f0y[j] * low.v[j] + f.f1x[j] * high.u[j] + f.f1y[j] * high.v[j]
    work += f.f2x[j] * high.u[j + 1] + f.f2y[j] * high.v[j + 1] + f.f3x[j] * low.u[j + 1] + f.f3y[j] * low.v[j + 1]
    return work


def quad_longest_side(at):
    a, b = (at.x1 - at.x0) * (at.x1 - at.x0) + (at.y1 - at.y0) * (at.y1 - at.y0), at.x2 - at.x1
    b, c = b * b + (at.y2 - at.y1) * (at.y2 - at.y1), at.x3 - at.x2
    c, d = c * c + (at.y3 - at.y2) * (at.y3 - at.y2), at.x0 - at.x3
    d = d * d + (at.y0 - at.y3) * (at.y0 - at.y3)
    return vsqrt(fmax(fmax(a, b), fmax(c, d)))


# -- triangles ----------------------------------------------------------------------------------------------------------------
def triangle_power(f, corners, j):
    a, b, c = corners.a, corners.b, corners.c
    work = f.f0x[j] * a.u[j] + f.f0y[j] * a.v[j] + f.f1x[j] * b.u[j] + f.f1y[j] * b.v[j]
    return work + f.f2x[j] * c.u[j] + f.f2y[j] * c.v[j]


def triangle_longest_side(t):
    """Half the longest side; the sides are twice the derivatives of the area."""
    a, b, c = t.ax * t.ax + t.ay * t.ay, t.bx * t.bx + t.by * t.by, t.cx * t.cx + t.cy * t.cy
    return vsqrt(fmax(a, fmax(b, c)))


def _by_corners(*classes):
    return triangle if classes[0] in (Vertices, VerticesNow) else quad_of


def _volume(*classes):
    if classes[0] is Triangle:
        return triangles.plane_area if classes[-1] is Planar else triangles.ring_volume
    return quad_volume


def _coefficients(*classes):
    if classes[0] is Triangle:
        by_kind = {Planar: triangles.plane_weights, AreaWeighted: triangles.area_weights}
        return by_kind.get(classes[-1], triangles.ring_weights)
    return quad_coefficients


def _strains(*classes):
    if classes[0] is Triangle:
        return triangles.plane_rates if classes[-1] is Planar else triangles.ring_rates
    return quad_strains


def _power(*classes):
    return triangle_power if classes[0] is VertexForces else quad_power


def _longest_side(*classes):
    return triangle_longest_side if classes[0] is Triangle else quad_longest_side


def _stress_forces(*classes):
    return forces.triangle_forces if classes[0] is VertexForces else forces.stress_forces


for _generic, _choose in ((cell, _by_corners), (volume, _volume), (coefficients, _coefficients), (strains, _strains), (power, _power),
                          (longest_side, _longest_side), (stress_forces, _stress_forces)):
    bind_choice(_generic, _choose)
for _function in (triangle, triangles.plane_area, triangles.ring_volume, triangles.plane_weights, triangles.ring_weights,
                  triangles.area_weights, triangles.plane_rates, triangles.ring_rates, triangles._rates, quad_of, quad_volume,
                  quad_coefficients, quad_strains, quad_power, quad_longest_side, triangle_power, triangle_longest_side):
    bind(_function)
