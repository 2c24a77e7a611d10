"""Runs in a process of their own that are killed and resumed, and the comparison of what is left with an undisturbed run."""

import json
import os
import signal
import subprocess
import sys
import time

from pace import PATIENCE

FILES = ("result.h5", "gauges.csv", "deck.toml")
TIMINGS = {"wall_seconds", "kernel_seconds", "compile_seconds", "sha256", "run_log_bytes", "sha256_of_this_text"}     # the log has times of day


def same_bytes(one, other):
    for name in FILES:
        assert (one / name).read_bytes() == (other / name).read_bytes(), name
    a, b = (json.loads((folder / "summary.json").read_text()) for folder in (one, other))
    for key in set(a) | set(b):
        if key not in TIMINGS and "warning" not in key and "resum" not in key:
            assert a[key] == b[key], key


def start(path, folder, how="run"):
    words = ["run", str(path), "--out", str(folder)] if how == "run" else ["resume", str(folder)]
    environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
    return subprocess.Popen([sys.executable, "-m", "hugoniot.cli.main", *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            env=environment)


def wait_for_checkpoint(process, folder, seconds=PATIENCE):
    """True when a checkpoint stands in the folder, False when the run was done before."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if list((folder / "checkpoint").glob("[0-9]*.json")):
            return True
        if process.poll() is not None:
            return False
        time.sleep(0.002)
    raise AssertionError("no checkpoint came")


def finish(path, folder, kills, chance, longest):
    """Run and resume with a kill -9 at random moments until the run is done; how many kills hit."""
    hits, how = 0, "run"
    for _ in range(kills):
        process = start(path, folder, how)
        if wait_for_checkpoint(process, folder):
            time.sleep(chance.uniform(0.0, longest))
        process.send_signal(signal.SIGKILL)
        code = process.wait(timeout=PATIENCE)
        hits += code == -signal.SIGKILL
        how = "resume"
        if (folder / "summary.json").is_file():
            break
    if not (folder / "summary.json").is_file():
        process = start(path, folder, "resume")
        assert process.wait(timeout=PATIENCE) == 0, process.stdout.read()[-2000:]
    return hits
