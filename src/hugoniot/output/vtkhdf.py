"""result.vtkhdf of a two-dimensional run: a temporal UnstructuredGrid of quadrilaterals or triangles that ParaView and pyvista open.

Layout: VTKHDF 2.2, type UnstructuredGrid, group Steps (VTK file formats, section "VTKHDF"). The cells are written once and every step
points at them; positions and fields are written step after step. Points have three coordinates, (x, y, 0) in the plane and (r, z, 0) in
axisymmetric geometry (rotate about the second axis to see the body). Point data: velocity (three components); cell data: every zone
field, the number of the block, and the zone's number. Units are SI and stand in the attribute `units` of each field.
"""

import numpy as np

from hugoniot.output.columns import describe
from hugoniot.output.hdf5 import h5py, image_bytes, new_image

_TYPES = {3: 5, 4: 9}      # VTK_TRIANGLE, VTK_QUAD
_NODAL = ("position_x", "position_y", "velocity_x", "velocity_y")
_OF_SURFACES = ("contact_pressure", "gap", "sliding_distance")


def vtkhdf_bytes(snapshots: dict[str, np.ndarray], zone_nodes: np.ndarray, block_of: np.ndarray) -> bytes:
    """The bytes of the file.

    snapshots    time (nt,), node fields (nt, nnode), zone fields (nt, nzone); position_x and position_y needed
    zone_nodes   (nzone, 4) or, of triangles, (nzone, 3), counter-clockwise
    block_of     (nzone,) number of the block
    """
    times = np.asarray(snapshots["time"], dtype=float)
    x, y = snapshots["position_x"], snapshots["position_y"]
    with new_image("vtkhdf") as file:
        root = file.create_group("VTKHDF", track_order=True)
        root.attrs["Version"] = np.array([2, 2], dtype=np.int64)
        kind = b"UnstructuredGrid"
        root.attrs.create("Type", kind, dtype=h5py().string_dtype("ascii", len(kind)))
        _write_cells(root, zone_nodes, x.shape[1])
        _dataset(root, "Points", np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3), "m")
        steps = root.create_group("Steps")
        steps.attrs["NSteps"] = np.int64(len(times))
        steps["Values"] = times
        zero, count = np.zeros(len(times), dtype=np.int64), np.arange(len(times), dtype=np.int64)
        steps["PartOffsets"], steps["NumberOfParts"] = zero, zero + 1
        steps["PointOffsets"] = count * x.shape[1]
        for name in ("CellOffsets", "ConnectivityIdOffsets"):
            steps[name] = zero[:, None]
        _write_fields(root, steps, snapshots, block_of, count, zero)
        return image_bytes(file)


def _write_cells(root, zone_nodes: np.ndarray, node_count: int) -> None:
    zones, corners = zone_nodes.shape
    root["NumberOfPoints"], root["NumberOfCells"] = np.array([node_count]), np.array([zones])
    root["NumberOfConnectivityIds"] = np.array([corners * zones])
    root["Connectivity"] = np.asarray(zone_nodes, dtype=np.int64).ravel()
    root["Offsets"] = np.arange(0, corners * zones + 1, corners, dtype=np.int64)
    root["Types"] = np.full(zones, _TYPES[corners], dtype=np.uint8)


def _write_fields(root, steps, snapshots, block_of, count, zero) -> None:
    points, cells = root.create_group("PointData"), root.create_group("CellData")
    point_offsets, cell_offsets = steps.create_group("PointDataOffsets"), steps.create_group("CellDataOffsets")
    if "velocity_x" in snapshots:
        u, v = snapshots["velocity_x"], snapshots["velocity_y"]
        _dataset(points, "velocity", np.stack([u, v, np.zeros_like(u)], axis=-1).reshape(-1, 3), "m/s")
        point_offsets["velocity"] = count * u.shape[1]
    for name, values in snapshots.items():
        if name in ("time", "cycle", *_NODAL):
            continue
        if name in _OF_SURFACES:
            _dataset(points, name, values.ravel(), describe(name)[0])
            point_offsets[name] = count * values.shape[1]
            continue
        _dataset(cells, name, values.ravel(), describe(name)[0])
        cell_offsets[name] = count * values.shape[1]
    for name, numbers in (("block", block_of), ("zone", np.arange(len(block_of)))):     # the same in every step
        cells[name] = np.asarray(numbers, dtype=np.int64)
        cell_offsets[name] = zero


def _dataset(group, name: str, values: np.ndarray, unit: str) -> None:
    group[name] = values
    if unit and unit != "1":
        group[name].attrs["units"] = unit
