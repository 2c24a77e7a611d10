"""A finished run, read from its folder: `hugoniot.load(folder)`.

`gauges`, `snapshots`, `budget`, `peaks` and `events` are xarray Datasets with units; `arrays` gives the same as plain arrays
(xarray takes half a second to import; reports and plots do without). Nothing is changed in the folder.
"""

import json
import pathlib
import shlex
from functools import cached_property
from typing import Any

import numpy as np

from hugoniot.diagnostics.interface_gauges import CONTINUOUS, sides
from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import legible
from hugoniot.output.codec import decode, h5py


def load(folder) -> "Run":
    """The run in `folder`. Raises `FileTrouble` if there is none, or it is unfinished or damaged."""
    return Run(folder)


class Run:
    """One run folder. `summary` and `setup` are dictionaries, `deck` is the resolved deck's text."""

    plot: Any   # the pictures of this run: the room `plotting`, a layer above, puts it here

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise FileTrouble(f"{self.folder}: there is no such run folder")
        if not (self.folder / "result.h5").is_file() or not (self.folder / "summary.json").is_file():
            raise FileTrouble(f"{self.folder}: {_what_is_there(self.folder)}")
        self._tables: dict[str, tuple[dict, dict, dict]] = {}

    def __repr__(self):
        return f"<Run '{self.summary['title']}' ({self.summary['status']}) in {self.folder}>"

    @cached_property
    def summary(self) -> dict:
        """summary.json."""
        path = self.folder / "summary.json"
        with legible(path):
            text = path.read_text(encoding="utf-8")
        try:
            return json.loads(text)
        except ValueError as error:
            raise FileTrouble(f"{path}: not the summary of a run ({error})") from error

    @cached_property
    def fronts(self) -> dict[str, np.ndarray]:
        """Columns of fronts.csv, SI: `kind` as texts, the others as numbers; empty for a solver that tracks none."""
        path = self.folder / "fronts.csv"
        if not path.is_file():
            return {}
        with legible(path):
            head, *lines = path.read_text(encoding="utf-8").splitlines()
        names, rows = head.split(","), [line.split(",") for line in lines]
        if any(len(row) != len(names) for row in rows):
            raise FileTrouble(f"{path}: not the fronts of a run")
        columns = dict(zip(names, zip(*rows))) if rows else dict.fromkeys(names, ())
        return {name: np.array(values) if name == "kind" else np.array(values, dtype=float) for name, values in columns.items()}

    @cached_property
    def _setup(self) -> tuple[dict, str]:
        with self._open() as file:
            group = file["setup"]
            return json.loads(group["document"].asstr()[()]), group["deck"].asstr()[()]

    @property
    def setup(self) -> dict:
        """What was asked: regions, boundaries, gauges, materials with every constant and its source, references."""
        return self._setup[0]

    @property
    def deck(self) -> str:
        """The resolved deck, every default written out."""
        return self._setup[1]

    def _open(self):
        path = self.folder / "result.h5"
        try:
            return h5py().File(path, "r")
        except PermissionError as error:
            raise FileTrouble(f"{path}: no permission to read it") from error
        except OSError as error:
            raise FileTrouble(f"{path}: cannot be read as a result ({error})") from error

    def _table(self, group: str) -> tuple[dict, dict, dict]:
        if group not in self._tables:
            values, attributes, dims = {}, {}, {}
            with self._open() as file:
                if group not in (known := [name for name in file if name != "setup"]):
                    raise KeyError(f"no group '{group}' in a run; it has: {', '.join(known)}")
                for name, data in file[group].items():
                    text = h5py().check_string_dtype(data.dtype) is not None
                    values[name] = np.array(data.asstr()[()], dtype=object) if text else data[()]
                    attributes[name] = {k: data.attrs[k] for k in ("units", "long_name") if k in data.attrs}
                    dims[name] = (name,) if data.is_scale else tuple(data.dims[k][0].name.rpartition("/")[2] for k in range(data.ndim))
            self._tables[group] = values, attributes, dims
        return self._tables[group]

    def arrays(self, group: str) -> dict[str, np.ndarray]:
        """Columns of `snapshots`, `gauges`, `budget`, `peaks` or `events` by name, in SI; KeyError for any other group."""
        return self._table(group)[0]

    def unit(self, group: str, name: str) -> str:
        """SI unit of one column of a group, "" if it has none; KeyError names the columns there are."""
        attributes = self._table(group)[1]
        if name not in attributes:
            raise KeyError(f"no column '{name}' in {group}; it has: {', '.join(attributes)}")
        return attributes[name].get("units", "")

    def dataset(self, group: str):
        """One group as an xarray Dataset with `units` and `long_name`."""
        import xarray

        values, attributes, dims = self._table(group)
        axes = {name for name, along in dims.items() if along == (name,)}
        columns = {name: xarray.Variable(dims[name], values[name], attributes[name]) for name in values}
        extra = {name for name in ("region", "centre", "centre_x", "centre_y", "mass") if name in values and "zone" in dims[name]}
        extra |= {"cycle"} & set(values) if group == "snapshots" else set()
        coords = {name: columns.pop(name) for name in sorted(axes | extra)}
        attrs = {"title": self.summary["title"], "solver": self.summary["solver"], "version": self.summary["version"]}
        return xarray.Dataset(columns, coords, attrs)

    @cached_property
    def gauges(self):
        """Gauge records (time, gauge)."""
        return self.dataset("gauges")

    @cached_property
    def snapshots(self):
        """Zone fields (time, zone), with region, centre at t = 0 and mass of each zone."""
        return self.dataset("snapshots")

    @cached_property
    def budget(self):
        """Energy and momentum (time) or (time, region)."""
        return self.dataset("budget")

    @cached_property
    def peaks(self):
        """Extreme values each zone met (zone)."""
        return self.dataset("peaks")

    @cached_property
    def events(self):
        """What happened: time, cycle, kind, text, numbers (JSON)."""
        return self.dataset("events")

    def gauge_names(self) -> list[str]:
        """Names of the gauges, in the order of the deck; free surfaces last."""
        return [str(name) for name in self.arrays("gauges")["gauge"]]

    def gauge(self, field: str, name: str | None = None) -> tuple[np.ndarray, np.ndarray]:
        """(time (n,) s, value (n,) SI) of one field at one gauge; the first gauge if none is named."""
        rows, names = self.arrays("gauges"), self.gauge_names()
        name = names[0] if name is None and names else name
        if name not in names:
            raise KeyError(f"no gauge '{name}'; this run has: {', '.join(names) or 'none'}")
        if field not in rows or rows[field].ndim != 2:
            known = ", ".join(key for key, values in rows.items() if values.ndim == 2)
            raise KeyError(f"no gauge field '{field}'; this run has: {known}")
        values = rows[field][:, names.index(name)]
        if field not in CONTINUOUS and name in set(sides(self.setup["gauges"]).values()):
            raise KeyError(f"{field} differs on the two sides of an interface: ask for '{name} left' or '{name} right'")
        return rows["time"], values


def read_post_mortem(folder) -> dict:
    """The state kept by a run that failed: what the solver handed to `RunFolder.post_mortem`."""
    path = pathlib.Path(folder) / "post_mortem.h5"
    with legible(path):
        return decode(path.read_bytes())


def _what_is_there(folder: pathlib.Path) -> str:
    if (folder / "post_mortem.txt").is_file():
        return "the run failed and left no result; see post_mortem.txt"
    again = f"hugoniot resume {shlex.quote(str(folder))}"
    if (folder / "checkpoint").is_dir() or (folder / "pieces").is_dir():
        return f"the run is unfinished; continue with `{again}`"
    if (folder / "deck.toml").is_file():
        return f"the run is unfinished and has no checkpoint yet; `{again}` starts it again"
    return "this is not a run folder (no result.h5)"
