"""result.vtkhdf of a two-dimensional run: a temporal UnstructuredGrid of quadrilaterals or triangles that ParaView and pyvista open.

Layout: VTKHDF 2.2, type UnstructuredGrid, group Steps (VTK file formats, section "VTKHDF"). The cells are written once and every step
points at them; positions and fields are written step after step. Points have three coordinates, (x, y, 0) in the plane and (r, z, 0) in
axisymmetric geometry (rotate about the second axis to see the body). Point data: velocity (three components); cell data: every zone
field, the number of the block, and the zone's number. Units are SI and stand in the attribute `units` of each field.
"""

import numpy as np

from hugoniot.output.atomic import Written
from hugoniot.output.columns import describe
from hugoniot.output.hdf5 import h5py, sound_layout, write_hdf5

_TYPES = {3: 5, 4: 9}      # VTK_TRIANGLE, VTK_QUAD
_NODAL = ("position_x", "position_y", "velocity_x", "velocity_y")
_OF_SURFACES = ("contact_pressure", "gap", "sliding_distance")
ROWS = 1 << 17              # of a column that are turned over at a time, about


def write_vtkhdf(path, snapshots, zone_nodes: np.ndarray, block_of: np.ndarray) -> Written:
    """Write the file, whole or not at all; its length and SHA-256. Columns go from one file to the other in blocks of some records.

    snapshots    `Table` of time (nt,), node fields (nt, nnode), zone fields (nt, nzone); position_x and position_y needed
    zone_nodes   (nzone, 4) or, of triangles, (nzone, 3), counter-clockwise
    block_of     (nzone,) number of the block
    """
    def fill(file, check):
        _fill(file, check, snapshots, zone_nodes, block_of)

    return write_hdf5(path, fill, snapshots.bytes * 3 // 2 + zone_nodes.nbytes)


def _fill(file, check, snapshots, zone_nodes, block_of) -> None:
    times = np.concatenate(list(snapshots.column("time", snapshots.length)))
    nodes = snapshots.shapes["position_x"][0]
    root = file.create_group("VTKHDF", track_order=True)
    root.attrs["Version"] = np.array([2, 2], dtype=np.int64)
    kind = b"UnstructuredGrid"
    root.attrs.create("Type", kind, dtype=h5py().string_dtype("ascii", len(kind)))
    _write_cells(root, zone_nodes, nodes)
    _write_column(root, "Points", snapshots, ("position_x", "position_y"), "m", check)
    steps = root.create_group("Steps")
    steps.attrs["NSteps"] = np.int64(len(times))
    steps["Values"] = times
    zero, count = np.zeros(len(times), dtype=np.int64), np.arange(len(times), dtype=np.int64)
    steps["PartOffsets"], steps["NumberOfParts"] = zero, zero + 1
    steps["PointOffsets"] = count * nodes
    for name in ("CellOffsets", "ConnectivityIdOffsets"):
        steps[name] = zero[:, None]
    _write_fields(root, steps, snapshots, block_of, count, check)


def _write_cells(root, zone_nodes: np.ndarray, node_count: int) -> None:
    zones, corners = zone_nodes.shape
    root["NumberOfPoints"], root["NumberOfCells"] = np.array([node_count]), np.array([zones])
    root["NumberOfConnectivityIds"] = np.array([corners * zones])
    root["Connectivity"] = np.asarray(zone_nodes, dtype=np.int64).ravel()
    root["Offsets"] = np.arange(0, corners * zones + 1, corners, dtype=np.int64)
    root["Types"] = np.full(zones, _TYPES[corners], dtype=np.uint8)


def _write_fields(root, steps, snapshots, block_of, count, check) -> None:
    points, cells = root.create_group("PointData"), root.create_group("CellData")
    point_offsets, cell_offsets = steps.create_group("PointDataOffsets"), steps.create_group("CellDataOffsets")
    if "velocity_x" in snapshots.names:
        _write_column(points, "velocity", snapshots, ("velocity_x", "velocity_y"), "m/s", check)
        point_offsets["velocity"] = count * snapshots.shapes["velocity_x"][0]
    for name in snapshots.names:
        if name in ("time", "cycle", *_NODAL):
            continue
        group, offsets = (points, point_offsets) if name in _OF_SURFACES else (cells, cell_offsets)
        _write_column(group, name, snapshots, (name,), describe(name)[0], check)
        offsets[name] = count * snapshots.shapes[name][0]
    for name, numbers in (("block", block_of), ("zone", np.arange(len(block_of)))):     # the same in every step
        cells[name] = np.asarray(numbers, dtype=np.int64)
        cell_offsets[name] = 0 * count


def _write_column(group, name: str, snapshots, columns: tuple[str, ...], unit: str, check) -> None:
    """A field step after step, (nt * n,), or of the two coordinates of a vector (nt * n, 3) with zeros for the third."""
    count = snapshots.shapes[columns[0]][0]
    kind, more = snapshots.kinds[columns[0]], (3,) if len(columns) == 2 else ()
    shape = (snapshots.length * count, *more)
    data = group.create_dataset(name, shape, kind, **sound_layout(shape, kind.itemsize))
    if unit and unit != "1":
        data.attrs["units"] = unit
    place, rows = 0, max(1, ROWS // max(1, count))
    for blocks in zip(*(snapshots.column(column, rows) for column in columns)):
        check()
        parts = [block.ravel() for block in blocks]
        data[place:place + len(parts[0])] = np.stack([*parts, np.zeros_like(parts[0])], axis=-1) if more else parts[0]
        place += len(parts[0])
