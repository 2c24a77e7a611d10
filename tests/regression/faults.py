"""What the fault harness strikes with: doors to the file system that kill or refuse, forks that are killed, flipped bits."""

import os
import random
import resource
import shutil
import signal

import h5py
import numpy as np
import pytest

from hugoniot.errors import HugoniotError
from hugoniot.output.run import load
from hugoniot.output.verify import verify

DOORS = ("open", "write", "pwrite", "replace", "unlink", "fsync", "mkdir", "rmdir", "ftruncate")


def spread(count, wanted):
    """At most `wanted` numbers below `count`, evenly, the first and the last among them."""
    return sorted({round(k * (count - 1) / (wanted - 1)) for k in range(wanted)})


def same_bytes(a, b):
    """Whether two runs have the same files with the same bytes, but for what holds times of day."""
    names = [path.name for path in a.iterdir() if path.name not in ("run.log", "summary.json", "report.html")]
    return all((b / name).is_file() and (a / name).read_bytes() == (b / name).read_bytes() for name in names)


def same_contents(a, b):
    """`same_bytes`, but for where in result.h5 its parts lie: every group, number, storage and attribute in it is the same."""
    with h5py.File(a / "result.h5") as one, h5py.File(b / "result.h5") as other:
        parts: tuple[dict, dict] = {}, {}
        for file, found in zip((one, other), parts):
            for name in ("/", *_names(file)):
                item = file[name]
                stored = isinstance(item, h5py.Dataset) and (_plain(item[()]), item.dtype, item.shape, item.chunks, item.fletcher32)
                found[name] = stored, {key: str(value) for key, value in item.attrs.items()}
    names = [path.name for path in a.iterdir() if path.name not in ("run.log", "summary.json", "report.html", "result.h5")]
    return parts[0] == parts[1] and all((b / name).is_file() and (a / name).read_bytes() == (b / name).read_bytes() for name in names)


def _plain(values):
    """Something that compares NaN with NaN as the same."""
    return values.tobytes() if getattr(values, "dtype", np.dtype(object)).kind != "O" else np.asarray(values).tolist()


def _names(file):
    names: list[str] = []
    file.visit(names.append)
    return names


def flip(path, chance):
    """Flip one bit of a file."""
    data = bytearray(path.read_bytes())
    data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    path.write_bytes(data)


class Doors:
    """Stands in the doors to the file system and lets something happen at the operation number `at`, counted from 0."""

    def __init__(self, monkeypatch, at, happen):
        self.at, self.count, self.happen = at, 0, happen
        for name in DOORS:
            monkeypatch.setattr(os, name, self._door(name, getattr(os, name)))

    def _door(self, name, real):
        def call(*arguments, **more):
            here, self.count = self.count, self.count + 1
            if here == self.at:
                self.happen(name, real, arguments)
            return real(*arguments, **more)

        return call


def kill(name, real, arguments):
    """Kill -9, of a write in its middle."""
    if name == "write":
        real(arguments[0], bytes(arguments[1])[: len(arguments[1]) // 2])
    os.kill(os.getpid(), signal.SIGKILL)


def operations(tmp_path, work) -> int:
    """File operations of `work(folder)`."""
    with pytest.MonkeyPatch.context() as patch:
        doors = Doors(patch, -1, None)
        work(tmp_path / "counted")
    shutil.rmtree(tmp_path / "counted")
    return doors.count


def in_a_copy_of_this_process(work):
    """Exit status of `work()` in a fork; 0 if it came to its end."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            resource.setrlimit(resource.RLIMIT_CPU, (600, 600))     # only for what never ends
            work()
            status = 0
        finally:
            os._exit(status)
    return os.waitpid(child, 0)[1]


def killed_at(folder, k, work) -> bool:
    """Whether `work(folder)` was killed at its file operation k."""
    def doomed():
        with pytest.MonkeyPatch.context() as patch:
            Doors(patch, k, kill)
            work(folder)

    return os.WIFSIGNALED(in_a_copy_of_this_process(doomed))


def check_flips_of_a_finished_run(whole, tmp_path, count):
    """Each is found by `verify`; one in a file that is read again stops its reading as well."""
    folder, chance = shutil.copytree(whole, tmp_path / "flipped"), random.Random(count)
    readings = {"result.h5": lambda: load(folder).arrays("gauges"), "summary.json": lambda: load(folder).summary,
                "fronts.csv": lambda: load(folder).fronts}
    files = sorted(path for path in folder.iterdir())
    for k in range(count):
        path = files[k % len(files)]
        data = path.read_bytes()
        flip(path, chance)
        assert [f.file for f in verify(folder, survey=False) if f.bad] == [path.name], k
        if path.name in readings:
            with pytest.raises(HugoniotError):
                readings[path.name]()
        path.write_bytes(data)
    return {path.name for path in files}
