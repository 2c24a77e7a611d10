"""Surfaces of the zones that are in the mesh: their faces that no other zone has, and how these follow one another."""

import numpy as np


def _keys(mesh):
    """A number for every face of every zone (faces of a zone, zones) that is the same for the two zones that have it."""
    corners = mesh.zone_nodes.T
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=0)]), axis=0)
    return ends[0] * np.int64(mesh.nodes.shape[1]) + ends[1]


def surface_faces(mesh, live, closed, shut_nodes):
    """(zone, face) of the faces that only one zone of those that are `live` has, sorted by place, and the face that follows each.

    closed      (n, 2) nodes of faces that represent the outside, which nothing meets
    shut_nodes  nodes whose faces nothing meets
    The face that follows is -1 where the surface ends. Where zones touch at a corner only, each surface goes on along its own zone.
    """
    keys, count = _keys(mesh), mesh.nodes.shape[1]
    alive = np.flatnonzero(live)
    known, times = np.unique(keys[:, alive], return_counts=True)
    alone = np.zeros(keys.shape, dtype=bool)
    alone[:, alive] = times[np.searchsorted(known, keys[:, alive])] == 1
    start, end = mesh.zone_nodes.T, np.roll(mesh.zone_nodes.T, -1, axis=0)
    outer = np.zeros(count, dtype=bool)
    outer[start[alone]] = outer[end[alone]] = True
    owners = {}
    for zone in alive[outer[mesh.zone_nodes[alive]].any(axis=1)].tolist():
        for k in np.flatnonzero(~alone[:, zone]).tolist():
            owners.setdefault(int(keys[k, zone]), []).append((zone, k))
    low, high = np.sort(closed, axis=1).T
    met = alone & ~np.isin(keys, low * np.int64(count) + high) & ~np.isin(start, shut_nodes) & ~np.isin(end, shut_nodes)
    faces = sorted(((int(zone), int(k)) for k, zone in np.argwhere(met)), key=lambda face: _place(mesh, *face))
    number = {face: n for n, face in enumerate(faces)}
    return faces, [_following(zone, k, alone, keys, owners, number) for zone, k in faces]


def _place(mesh, zone, k):
    """What faces are sorted by: their middle at t = 0, then their direction; the order of the blocks plays no part."""
    (ax, ay), (bx, by) = mesh.nodes[:, mesh.zone_nodes[zone, k]], mesh.nodes[:, mesh.zone_nodes[zone, (k + 1) % mesh.zone_nodes.shape[1]]]
    return ax + bx, ay + by, bx - ax, by - ay


def _following(zone, k, alone, keys, owners, number):
    """The face after the end of a face: around that node through the zones that hang together there."""
    while True:
        k = (k + 1) % len(keys)
        if alone[k, zone]:
            return number.get((zone, k), -1)
        zone, k = next(face for face in owners[int(keys[k, zone])] if face != (zone, k))
