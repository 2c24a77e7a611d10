"""What can still be read of a damaged result.h5: looked at in a process of its own, because damage may end the process that meets it."""

import json
import os
import subprocess
import sys

from hugoniot.files import hdf5_texts_end
from hugoniot.output.hdf5 import h5py

PATIENCE = 300.0    # seconds; damage may send HDF5 round in circles


def readable(path) -> dict[str, str]:
    """{column: "" or why it cannot be read} of every column that is still known; empty if the file as a whole cannot be read."""
    command = [sys.executable, "-P", "-c", "from hugoniot.output.salvage import serve; serve()"]
    try:
        place = json.dumps(os.path.abspath(path))
        told = subprocess.run(command, input=place, capture_output=True, text=True, timeout=PATIENCE)
        found = json.loads(told.stdout) if told.returncode == 0 else {}
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return {}
    return found if isinstance(found, dict) else {}


def serve() -> None:
    """Read the path from the standard input and write what `readable` gives to the standard output."""
    sys.stdout.write(json.dumps(_look(json.loads(sys.stdin.read()))))
    sys.stdout.flush()
    os._exit(0)


def _look(path: str) -> dict[str, str]:
    found: dict[str, str] = {}
    try:
        if not hdf5_texts_end(path):
            return found
        with h5py().File(path, "r") as file:
            for group in file:
                try:
                    names = list(file[group])
                except (OSError, RuntimeError, KeyError, AttributeError) as error:
                    found[group] = str(error)[:200]
                    continue
                for name in names:
                    found[f"{group}/{name}"] = _trouble(file, f"{group}/{name}")
    except (OSError, RuntimeError, ValueError):
        return found
    return found


def _trouble(file, name: str) -> str:
    try:
        data = file[name]
        if getattr(data, "chunks", None):
            for chunk in data.iter_chunks():
                data[chunk]
        else:
            data[()]
    except (OSError, RuntimeError, KeyError, ValueError, TypeError, AttributeError) as error:
        return str(error)[:200] or type(error).__name__
    return ""
