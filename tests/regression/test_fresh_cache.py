"""Several processes that begin at once with an empty folder of compiled code: each ends, with the same bits."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

DECK = """stop_time = "0.2 us"
[[region]]
name = "flyer"
material = "copper"
from = "-1 mm"
to = "0 mm"
zones = 40
velocity = "300 m/s"
[[region]]
name = "target"
material = "aluminum"
from = "0 mm"
to = "2 mm"
zones = 60
"""


def start(folder: Path, name: str, cache: Path):
    command = [sys.executable, "-c", "from hugoniot.cli.main import main; main()", "run", str(folder / "deck.toml"),
               "--out", str(folder / name), "--no-report", "--quiet"]
    return subprocess.Popen(command, env={**os.environ, "HUGONIOT_CACHE": str(cache)}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def together(folder: Path, count: int) -> None:
    (folder / "deck.toml").write_text(DECK)
    cache = folder / "cache"
    cache.mkdir(mode=0o700)
    processes = [start(folder, f"{k}.run", cache) for k in range(count)]
    told = [process.communicate()[0].decode() for process in processes]
    assert [process.returncode for process in processes] == [0] * count, told
    assert len({hashlib.sha256((folder / f"{k}.run" / "result.h5").read_bytes()).hexdigest() for k in range(count)}) == 1
    assert not list(cache.glob("*/*.tmp.*")) and "once for this machine" not in start(folder, "warm.run", cache).communicate()[0].decode()


@pytest.mark.slow
def test_eight_processes_share_an_empty_cache(tmp_path):
    together(tmp_path, 8)
