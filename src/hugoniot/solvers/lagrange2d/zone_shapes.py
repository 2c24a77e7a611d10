"""Corners, areas, volumes and corner shares of the zones of a mesh in its current position, for nodal masses and zone widths."""

import numpy as np

from hugoniot.mesh import triangles
from hugoniot.solvers.lagrange1d.tables import zone_table
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import quads as G

_GAUSS = (np.array([-np.sqrt(0.6), 0.0, np.sqrt(0.6)]), np.array([5.0, 8.0, 5.0]) / 9.0)


def quad_corners(block):
    """Coordinates (2, 4, cells) of the corners of a block's cells."""
    def corners(a):
        return np.stack([a[:-1, :-1], a[1:, :-1], a[1:, 1:], a[:-1, 1:]]).reshape(4, -1)
    return np.stack([corners(block.x), corners(block.y)])


def zone_corners(mesh, block):
    """Coordinates (2, corners, zones) of the corners of a block's zones, and their places (corners, zones) among its own nodes (flat)."""
    i, j = np.indices((block.ni, block.nj))
    place = np.stack([i * (block.nj + 1) + j, (i + 1) * (block.nj + 1) + j, (i + 1) * (block.nj + 1) + j + 1, i * (block.nj + 1) + j + 1])
    place = place.reshape(4, -1)
    if mesh.quads is None:
        return quad_corners(block), place
    lower, upper = triangles.corners_of(mesh.ways[cells_of(mesh, block)])
    place = triangles.by_rows(*(np.take_along_axis(place.T, which, axis=1) for which in (lower, upper)), block).T
    return np.stack([block.x.ravel()[place], block.y.ravel()[place]]), place


def cells_of(mesh, block) -> slice:
    """Cells of a block."""
    first = block.first_zone // block.per_cell
    return slice(first, first + block.ni * block.nj)


def areas(x, y):
    """Areas of zones, corners (4 or 3, n)."""
    if len(x) == 3:
        return 0.5 * ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]))
    return 0.5 * ((x[2] - x[0]) * (y[3] - y[1]) - (y[2] - y[0]) * (x[3] - x[1]))


def inverse_altitudes(x, y):
    """Inverse of the smallest altitude of zones, corners (4 or 3, n): longest edge over area, or twice the area of a triangle."""
    edges = np.hypot(np.roll(x, -1, 0) - x, np.roll(y, -1, 0) - y)
    return edges.max(axis=0) / ((5 - len(x)) * areas(x, y))


def widths(mesh):
    """Widths of zones in which a programmed front burns them: smallest altitudes, of triangles that of their cell."""
    found = []
    for block in mesh.blocks:
        width = 1.0 / inverse_altitudes(*quad_corners(block))
        found.append(width if mesh.quads is None else triangles.by_rows(width, width, block))
    return np.concatenate(found)


def volumes(x, y, kind):
    """Volume of zones, corners (4 or 3, n): area, or the true volume per radian."""
    if kind == G.PLANAR:
        return areas(x, y)
    ahead_x, ahead_y = np.roll(x, -1, axis=0), np.roll(y, -1, axis=0)
    return np.sum((ahead_y - y) * (x * x + x * ahead_x + ahead_x * ahead_x), axis=0) / 6.0


def corner_shares(x, y, kind):
    """Parts (4 or 3, n) of a zone's volume whose mass belongs to its corners.

    Planar and true volume: integrals of the shape functions, times the radius. Area weighted: A_k r_k / sum(A r) with the
    quarters, or thirds of a triangle, A_k.
    """
    if len(x) == 3:
        if kind == G.PLANAR:
            return np.full_like(x, 1.0 / 3.0)
        return x / x.sum(axis=0) if kind == G.AREA_WEIGHTED else 0.25 * (1.0 + x / x.sum(axis=0))
    area = volumes(x, y, G.PLANAR)
    triangle = 0.5 * ((np.roll(x, -1, 0) - x) * (np.roll(y, 1, 0) - y) - (np.roll(y, -1, 0) - y) * (np.roll(x, 1, 0) - x))
    if kind == G.PLANAR:
        return (area + triangle) / (6.0 * area)
    if kind == G.AREA_WEIGHTED:
        weight = (0.125 * area + 0.25 * triangle) * x
        return weight / weight.sum(axis=0)
    share = np.zeros_like(x)
    signs = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    for a, wa in zip(*_GAUSS):
        for b, wb in zip(*_GAUSS):
            shape = 0.25 * (1 + signs[:, 0] * a) * (1 + signs[:, 1] * b)
            # the Jacobian of a quadrilateral is linear: triangle / 2 at the corners
            jacobian = 0.5 * (shape @ triangle.reshape(4, -1)).reshape(area.shape)
            share += wa * wb * shape[:, None] * (shape @ x) * jacobian
    return share / share.sum(axis=0)


def over_nodes(block, values):
    """Values (4, cells) of the corners of a block's cells summed at its nodes, flat."""
    found = np.zeros((block.ni + 1, block.nj + 1))
    for c, (a, b) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
        found[a:a + block.ni, b:b + block.nj] += values[c].reshape(block.ni, block.nj)
    return found.ravel()


def diagonal_table(mesh):
    """Further fields of triangles (`layout.OfTriangles`); None where zones are quadrilaterals."""
    if mesh.quads is None:
        return None
    table = zone_table(len(L.OfTriangles._fields), len(mesh.zone_nodes))
    for block in mesh.blocks:
        way = mesh.ways[cells_of(mesh, block)].astype(float)
        zone = slice(block.first_zone, block.first_zone + block.zones)
        table[0, zone], table[1, zone] = (triangles.by_rows(row, row, block) for row in (way, 1.0 - way))
    return table
