"""Results as another program might have written them: one dataset or attribute changed, and every checksum right."""

import contextlib
import io
import json
import shutil

import h5py
import numpy as np

from hugoniot.cli.main import main
from hugoniot.output.atomic import digest
from hugoniot.output.run import load
from hugoniot.output.seal import sealed_json
from hugoniot.plotting.accessor import PICTURES, PLANE_PICTURES

GROUPS = ("snapshots", "gauges", "budget", "peaks", "events")


def names_of(folder):
    """(groups, datasets, (object, attribute)s) of a result."""
    groups, data, attributes = [], [], []

    def note(name, item):
        (data if isinstance(item, h5py.Dataset) else groups).append(name)
        attributes.extend((name, key) for key in item.attrs)

    with h5py.File(folder / "result.h5") as file:
        attributes += [("/", key) for key in file.attrs]
        file.visititems(note)
    return groups, data, attributes


def _rewrite(file, name, values, tied=True):
    """Other values in the place of a dataset, with its attributes and, where `tied`, its axes."""
    old = file[name]
    kept = {key: old.attrs[key] for key in ("units", "long_name") if key in old.attrs}
    scale = old.is_scale
    axes = [] if scale else [dim[0].name if len(dim) else "" for dim in old.dims]
    del file[name]
    new = file.create_dataset(name, data=values)
    for key, value in kept.items():
        new.attrs[key] = value
    if scale:
        new.make_scale(name.rpartition("/")[2])
    for k, axis in enumerate(axes if tied else ()):
        if axis and k < new.ndim:
            new.dims[k].attach_scale(file[axis])


def _texts(values):
    return np.full(np.shape(values), "x", dtype=h5py.string_dtype())


def _numbers(values):
    return np.zeros(np.shape(values)) if values.dtype.kind in "OS" else values


RETYPED = {"texts": _texts, "complex numbers": lambda v: _numbers(v).astype(complex), "yes and no": lambda v: _numbers(v).astype(bool),
           "records": lambda v: np.zeros(np.shape(v), dtype=[("a", "f8")]), "plain numbers": lambda v: np.zeros(np.shape(v), "f4")}
RESHAPED = {"one row less": lambda v: v[:-1], "one row more": lambda v: np.concatenate([v, v[-1:]]), "turned": lambda v: v.T,
            "one axis more": lambda v: np.stack([v, v], axis=-1), "one axis less": lambda v: v[..., 0], "one value": lambda v: v.ravel()[0],
            "nothing": lambda v: v[:0]}


def forgeries(folder):
    """(what is done, where, function of the open file) for everything in a result."""
    groups, data, attributes = names_of(folder)
    for name in (*groups, *data):
        yield "without", name, lambda f, n=name: f.__delitem__(n)
        yield "linked", name, lambda f, n=name: (f.__delitem__(n), f.__setitem__(n, h5py.SoftLink("/gauges/time")))
        yield "lies elsewhere", name, lambda f, n=name: (f.__delitem__(n), f.__setitem__(n, h5py.ExternalLink("other.h5", n)))
    for name in groups:
        yield "a number", name, lambda f, n=name: (f.__delitem__(n), f.__setitem__(n, 1.0))
    for name in data:
        yield "a group", name, lambda f, n=name: (f.__delitem__(n), f.create_group(n))
        yield "no axes", name, lambda f, n=name: _rewrite(f, n, f[n][()], tied=False)
        for word, change in (RETYPED | RESHAPED).items():
            yield word, name, lambda f, n=name, c=change: _rewrite(f, n, c(np.asarray(f[n][()])))
        yield "never written", name, lambda f, n=name: (s := f[n].shape, f.__delitem__(n), f.create_dataset(n, s, "f8"))
    for place, key in attributes:
        yield f"without attribute {key}", place, lambda f, p=place, k=key: f[p].attrs.__delitem__(k)
        yield f"number as attribute {key}", place, lambda f, p=place, k=key: f[p].attrs.__setitem__(k, [1.5, 2.5])
        yield f"odd attribute {key}", place, lambda f, p=place, k=key: f[p].attrs.__setitem__(k, "\x1b[31m")


def places(value, path=()):
    """The path of everything in tables and lists; of a list its first two elements."""
    pairs = value.items() if isinstance(value, dict) else list(enumerate(value))[:2] if isinstance(value, list) else ()
    for key, inner in pairs:
        yield (*path, key)
        yield from places(inner, (*path, key))


def altered(document):
    """(what is done, where, the document with one entry gone or of another kind) for everything in it."""
    for path in list(places(document)):
        for word, value in (("without", None), ("text", "x"), ("number", 2), ("list", [1.0]), ("table", {"a": 1}), ("nothing", None), ("yes", True)):
            changed = json.loads(json.dumps(document))
            here = changed
            for key in path[:-1]:
                here = here[key]
            if word == "without":
                del here[path[-1]]
            else:
                here[path[-1]] = value
            yield word, path, changed


def other_setup(document):
    """Function of an open result that puts another set-up into it."""
    def change(file):
        del file["setup/document"]
        file["setup/document"] = json.dumps(document)

    return change


def forge(whole, folder, change) -> bool:
    """A copy of a run with its result changed and signed again; False where the change cannot be made."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(whole, folder)
    shutil.copy(folder / "result.h5", folder.parent / "other.h5")
    try:
        with h5py.File(folder / "result.h5", "a") as file:
            change(file)
    except (ValueError, IndexError, TypeError, RuntimeError, KeyError, np.exceptions.AxisError):
        return False
    sign(folder, load(whole).summary)
    return True


def sign(folder, summary, name="result.h5"):
    """Write the summary with the checksum that a file has now, and its own."""
    summary = json.loads(json.dumps(summary))
    summary["sha256"][name] = digest(folder / name).sha256
    (folder / "summary.json").write_text(sealed_json(summary))


def told(*words):
    """(exit code, what a command wrote)."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            main([str(word) for word in words])
            code = 0
        except SystemExit as ended:
            code = ended.code or 0
    return code, err.getvalue()


def commands(whole, folder, plane, every):
    """What reads a run: all of it, or the quick ones."""
    picture = folder.parent / "picture.png"
    yield "info", folder
    if every:
        yield "compare", folder, whole
        yield "info", folder, "--json"
        yield "info", folder, "--events"
        yield "info", folder, "--deck"
        yield "compare", whole, folder
        yield "report", folder
        for kind in PLANE_PICTURES if plane else PICTURES:
            yield "plot", folder, kind, "--out", picture


def read_all(folder, every):
    """Everything that a script may ask of a run; as data sets with their axes too, where `every`."""
    run = load(folder)
    for group in (*GROUPS, *(["mesh"] if "axes" in run.setup else [])):
        for name in (rows := run.arrays(group)):
            rows[name], run.unit(group, name)
        if group != "mesh" and every:
            run.dataset(group).load()
    run.gauge_names(), run.deck, run.fronts
