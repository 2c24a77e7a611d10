"""result.h5: everything a run recorded, self-describing, in SI, the same bytes for the same physics.

Groups: `snapshots` (time, zone), `gauges` (time, gauge), `budget` (time[, region]), `peaks` (zone), `events` (event) and `setup`; of two
dimensions `snapshots` have fields (time, node) too, and `mesh` says which nodes a zone has, counter-clockwise (zone, corner).
Every dataset carries `units` and `long_name`; every axis is an HDF5 dimension scale, so netCDF readers open it as well:
`xarray.open_dataset("result.h5", group="gauges")`. Nothing in it depends on the clock, on the machine or on how often the run
was interrupted.
"""

import json

import numpy as np

from hugoniot.output.codec import h5py, image_bytes, new_image
from hugoniot.output.columns import describe

FORMAT = "hugoniot-result-1"


class _Writer:
    """Writes columns into one group and ties them to the group's axes."""

    def __init__(self, group, geometry: str, given: dict):
        self.group, self.geometry, self.given, self.axes = group, geometry, given, {}

    def _dataset(self, name, values):
        values = np.asarray(values)
        if values.dtype.kind in "UO":
            data = self.group.create_dataset(name, data=values.astype(object), dtype=h5py().string_dtype())
        else:
            data = self.group.create_dataset(name, data=values)
        unit, long_name = describe(name, self.geometry, self.given)
        if unit and values.dtype.kind == "f":
            data.attrs["units"] = unit
        data.attrs["long_name"] = long_name
        return data

    def axis(self, name, values):
        data = self._dataset(name, values)
        data.make_scale(name)
        self.axes[name] = data

    def column(self, name, values, *axes):
        data = self._dataset(name, values)
        for k, axis in enumerate(axes):
            data.dims[k].attach_scale(self.axes[axis])


def _write_tables(file, tables: dict, peaks: dict, setup: dict):
    geometry, given = setup["document"]["geometry"], setup["units"]
    zones = {"region": setup["region"], **setup["centres"], "mass": setup["mass"]}
    zone_count, mesh = len(setup["region"]), setup["mesh"]
    nodal = set(mesh.get("node_fields", ()))

    def writer(name):
        return _Writer(file.create_group(name), geometry if name == "budget" else "", given)

    w = writer("snapshots")
    rows = dict(tables["snapshots"])
    w.axis("time", rows.pop("time", np.empty(0)))
    w.axis("zone", np.arange(zone_count))
    w.column("cycle", rows.pop("cycle", np.empty(0, dtype=np.int64)), "time")
    for name, values in zones.items():
        w.column(name, values, "zone")
    if mesh:
        w.axis("node", np.arange(mesh["node_count"]))
    for name, values in rows.items():
        w.column(name, values, "time", "node" if name in nodal else "zone")

    w = writer("gauges")
    rows = dict(tables["gauges"])
    w.axis("time", rows.pop("time", np.empty(0)))
    w.axis("gauge", np.array(setup["gauges"], dtype=object))
    for name, values in rows.items():
        w.column(name, values, "time", "gauge")

    w = writer("budget")
    rows = dict(tables["budget"])
    w.axis("time", rows.pop("time", np.empty(0)))
    w.axis("region", np.array([r["name"] for r in setup["document"]["regions"]], dtype=object))
    for name, values in rows.items():
        w.column(name, values, *(("time",) if values.ndim == 1 else ("time", "region")))

    if mesh:
        w = writer("mesh")
        w.axis("zone", np.arange(zone_count))
        w.axis("corner", np.arange(4))
        w.column("zone_nodes", mesh["zone_nodes"], "zone", "corner")
        w.column("block_of", mesh["block_of"], "zone")

    w = writer("peaks")
    w.axis("zone", np.arange(zone_count))
    for name, values in {**zones, **peaks}.items():
        w.column(name, values, "zone")


def _write_events(file, events: list[dict]):
    w = _Writer(file.create_group("events"), "", {})
    w.axis("event", np.arange(len(events)))
    w.column("time", np.array([e["time"] for e in events], dtype=float), "event")
    w.column("cycle", np.array([e["cycle"] for e in events], dtype=np.int64), "event")
    for name in ("kind", "text"):
        w.column(name, np.array([e[name] for e in events], dtype=object), "event")
    w.column("numbers", np.array([json.dumps(e["numbers"], sort_keys=True) for e in events], dtype=object), "event")


def result_bytes(tables: dict, events: list[dict], peaks: dict, setup: dict) -> bytes:
    """The bytes of result.h5.

    tables   {table: {column: array}} with `time` (and `cycle`) among the columns, as `Series.collect` gives them
    setup    {"document": setup record, "region", "mass": (nzone,), "centres": {column: (nzone,)}, "mesh": {} or {"zone_nodes",
             "block_of", "node_count", "node_fields"}, "gauges": names, "units": {}, "deck": text, ...}
    """
    with new_image() as file:
        document = setup["document"]
        for name, value in (("format", FORMAT), ("title", document["title"]), ("solver", document["solver"]["kind"]),
                            ("version", document["version"]), ("deck_sha256", setup["deck_sha256"])):
            file.attrs[name] = value
        _write_tables(file, tables, peaks, setup)
        _write_events(file, events)
        group = file.create_group("setup")
        group["document"] = json.dumps(document, sort_keys=True)
        group["deck"] = setup["deck"]
        return image_bytes(file)


def gauges_text(rows: dict, gauges: list[str], given: dict) -> str:
    """gauges.csv: the time and every field of every gauge, one column each, headed `<gauge> <field> [unit]`; ten digits."""
    rows = dict(rows)
    time = rows.pop("time", np.empty(0))
    heads, columns = ["time [s]"], [time]
    for k, gauge in enumerate(gauges):
        for name, values in rows.items():
            if len(values) and np.isnan(values[:, k]).all():
                continue     # what has no value there
            unit = describe(name, "", given)[0]
            heads.append(f"{gauge} {name} [{unit or '1'}]".replace(",", ";"))
            columns.append(values[:, k])
    line = ",".join(["%.10g"] * len(columns))
    body = "\n".join(line % tuple(row) for row in np.stack(columns, axis=1).tolist())
    return ",".join(heads) + "\n" + (body + "\n" if body else "")
