"""result.h5: everything a run recorded, self-describing, in SI, the same bytes for the same physics.

Groups: `snapshots` (time, zone), `gauges` (time, gauge), `budget` (time[, region]), `peaks` (zone), `events` (event) and `setup`; of two
dimensions `snapshots` have fields (time, node) too, and `mesh` says which nodes a zone has, counter-clockwise (zone, corner).
Every dataset carries `units` and `long_name`; every axis is an HDF5 dimension scale, so netCDF readers open it as well:
`xarray.open_dataset("result.h5", group="gauges")`. Every chunk of numbers has a checksum (Fletcher32), which HDF5 looks at whenever it
is read. Nothing in it depends on the clock, on the machine or on how often the run was interrupted. Long columns are written chunk by
chunk and are never in memory as a whole.
"""

import json

import numpy as np

from hugoniot.output.atomic import Written, write_parts
from hugoniot.output.columns import describe
from hugoniot.output.hdf5 import h5py, sound_layout, write_hdf5
from hugoniot.output.result_layout import ORDER

FORMAT = "hugoniot-result-1"
CSV_ROWS = 4096


class _Writer:
    """Writes columns into one group and ties them to the group's axes."""

    def __init__(self, group, geometry: str, given: dict, check):
        self.group, self.geometry, self.given, self.check, self.axes = group, geometry, given, check, {}

    def _described(self, data, name, kind):
        unit, long_name = describe(name, self.geometry, self.given)
        if unit and kind == "f":
            data.attrs["units"] = unit
        data.attrs["long_name"] = long_name
        return data

    def _whole(self, name, values):
        self.check()
        values = np.asarray(values)
        if values.dtype.kind in "UO":
            data = self.group.create_dataset(name, data=values.astype(object), dtype=h5py().string_dtype())
        else:
            data = self.group.create_dataset(name, data=values, **sound_layout(values.shape, values.itemsize))
        return self._described(data, name, values.dtype.kind)

    def _in_blocks(self, name, table):
        shape, kind = (table.length, *table.shapes[name]), table.kinds[name]
        layout = sound_layout(shape, kind.itemsize)
        data = self.group.create_dataset(name, shape, kind, **layout)
        row = 0
        for block in table.column(name, layout["chunks"][0] if layout else 1):
            self.check()
            data[row:row + len(block)] = block
            row += len(block)
        return self._described(data, name, kind.kind)

    def axis(self, name, values):
        data = self._whole(name, values)
        data.make_scale(name)
        self.axes[name] = data

    def column(self, name, values, *axes):
        self._attach(self._whole(name, values), axes)

    def _attach(self, data, axes):
        for k, axis in enumerate(axes):
            data.dims[k].attach_scale(self.axes[axis])

    def time_axis(self, table):
        if table.names:
            data = self._in_blocks("time", table)
            data.make_scale("time")
            self.axes["time"] = data
        else:
            self.axis("time", np.empty(0))

    def rows(self, table, axis, nodal=()):
        """Every column of the table along time and, where its rows are no plain numbers, along the axis, or `node` for names in `nodal`."""
        self.group.attrs[ORDER] = " ".join(table.names)
        for name in table.names:
            if name != "time":
                other = "node" if name in nodal else axis
                self._attach(self._in_blocks(name, table), ("time", other) if table.shapes[name] else ("time",))


def _write_tables(file, tables: dict, peaks: dict, setup: dict, check):
    geometry, given = setup["document"]["geometry"], setup["units"]
    zones = {"region": setup["region"], **setup["centres"], "mass": setup["mass"]}
    zone_count, mesh = len(setup["region"]), setup["mesh"]
    nodal = set(mesh.get("node_fields", ()))

    def writer(name):
        return _Writer(file.create_group(name), geometry if name == "budget" else "", given, check)

    w = writer("snapshots")
    w.time_axis(tables["snapshots"])
    w.axis("zone", np.arange(zone_count))
    if not tables["snapshots"].names:
        w.column("cycle", np.empty(0, dtype=np.int64), "time")
    for name, values in zones.items():
        w.column(name, values, "zone")
    if mesh:
        w.axis("node", np.arange(mesh["node_count"]))
    w.rows(tables["snapshots"], "zone", nodal=nodal)

    w = writer("gauges")
    w.time_axis(tables["gauges"])
    w.axis("gauge", np.array(setup["gauges"], dtype=object))
    w.rows(tables["gauges"], "gauge")

    w = writer("budget")
    w.time_axis(tables["budget"])
    w.axis("region", np.array([r["name"] for r in setup["document"]["regions"]], dtype=object))
    w.rows(tables["budget"], "region")

    if mesh:
        w = writer("mesh")
        w.axis("zone", np.arange(zone_count))
        w.axis("corner", np.arange(mesh["zone_nodes"].shape[1]))
        w.column("zone_nodes", mesh["zone_nodes"], "zone", "corner")
        w.column("block_of", mesh["block_of"], "zone")

    w = writer("peaks")
    w.group.attrs[ORDER] = " ".join([*zones, *peaks])
    w.axis("zone", np.arange(zone_count))
    for name, values in {**zones, **peaks}.items():
        w.column(name, values, "zone")


def _write_events(file, events: list[dict], check):
    w = _Writer(file.create_group("events"), "", {}, check)
    w.axis("event", np.arange(len(events)))
    w.column("time", np.array([e["time"] for e in events], dtype=float), "event")
    w.column("cycle", np.array([e["cycle"] for e in events], dtype=np.int64), "event")
    for name in ("kind", "text"):
        w.column(name, np.array([e[name] for e in events], dtype=object), "event")
    w.column("numbers", np.array([json.dumps(e["numbers"], sort_keys=True) for e in events], dtype=object), "event")


def write_result(path, tables: dict, events: list[dict], peaks: dict, setup: dict) -> Written:
    """Write result.h5, whole or not at all; its length and SHA-256.

    tables   {table: Table} with `time` (and `cycle`) among the columns, as `Series.collect` gives them
    setup    {"document": setup record, "region", "mass": (nzone,), "centres": {column: (nzone,)}, "mesh": {} or {"zone_nodes",
             "block_of", "node_count", "node_fields"}, "gauges": names, "units": {}, "deck": text, ...}
    """
    document = setup["document"]

    def fill(file, check):
        for name, value in (("format", FORMAT), ("title", document["title"]), ("solver", document["solver"]["kind"]),
                            ("version", document["version"]), ("deck_sha256", setup["deck_sha256"])):
            file.attrs[name] = value
        _write_tables(file, tables, peaks, setup, check)
        _write_events(file, events, check)
        group = file.create_group("setup")
        group["document"] = json.dumps(document, sort_keys=True)
        group["deck"] = setup["deck"]

    return write_hdf5(path, fill, sum(table.bytes for table in tables.values()) + sum(values.nbytes for values in peaks.values()))


def _head(text: str) -> str:
    """A column's head as one line of one cell."""
    return "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text).replace(",", ";")


def _has_values(table, name: str, gauge: int) -> bool:
    """Whether anything was recorded; a gauge on an interface has, for one, no density of its own."""
    return table.length == 0 or any(not np.isnan(block[:, gauge]).all() for block in table.column(name, CSV_ROWS))


def _gauge_lines(table, gauges: list[str], given: dict):
    names = [name for name in table.names if name != "time"]
    kept = [(k, name) for k in range(len(gauges)) for name in names if _has_values(table, name, k)]
    heads = ["time [s]"] + [_head(f"{gauges[k]} {name} [{describe(name, '', given)[0] or '1'}]") for k, name in kept]
    yield (",".join(heads) + "\n").encode()
    if not table.names:
        return
    line = ",".join(["%.10g"] * len(heads)) + "\n"
    for time, *fields in zip(*(table.column(name, CSV_ROWS) for name in ("time", *names))):
        found = dict(zip(names, fields))
        block = np.stack([time] + [found[name][:, k] for k, name in kept], axis=1)
        yield "".join(line % tuple(row) for row in block.tolist()).encode()


def write_gauges(path, table, gauges: list[str], given: dict) -> Written:
    """Write gauges.csv: the time and every field of every gauge, one column each, headed `<gauge> <field> [unit]`; ten digits."""
    return write_parts(path, _gauge_lines(table, gauges, given), durable=False)
