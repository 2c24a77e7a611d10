"""What a run holds in memory does not grow with what it writes."""

import os
import subprocess
import sys

import pytest

DECK = """stop_time = "4 ns"
[[region]]
name = "flyer"
material = "copper"
from = "0 mm"
to = "20 mm"
zones = 20000
velocity = "500 m/s"
[[region]]
name = "target"
material = "copper"
from = "20 mm"
to = "200 mm"
zones = 180000
[output]
snapshots = "{} ns"
report = false
"""


def peak(folder, interval):
    """(peak memory, size of result.h5) of a run in a process of its own, in bytes."""
    (folder / "deck.toml").write_text(DECK.format(interval))
    out = folder / f"{interval}.run"
    process = subprocess.Popen([sys.executable, "-m", "hugoniot.cli.main", "run", str(folder / "deck.toml"), "--out", str(out), "-q"])
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0
    return 1024 * used.ru_maxrss, (out / "result.h5").stat().st_size


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="counts kilobytes as Linux does")
def test_four_times_the_snapshots_need_no_more_memory(tmp_path):
    """Of a million zones less than 3 GB, however many snapshots: here a fifth of the zones in a fifth of that beyond the program's 300 MB."""
    few, small = peak(tmp_path, 0.4)
    many, large = peak(tmp_path, 0.1)
    assert large > 3.0 * small and large > 5e8
    assert many < few + 0.1 * large
    assert many < 3e8 + 0.2 * (3e9 - 3e8)
