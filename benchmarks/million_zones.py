"""Peak memory of a run with a million zones and 100 snapshots, its report included: less than 3 GB is asked.

    python benchmarks/million_zones.py [--plane] [--zones 1000000] [--snapshots 100] [--steps 3] [--folder FOLDER]

A plate of copper hits another or, with --plane, a square of aluminium with strength hits a wall. The run ends after some `--steps` steps
for each snapshot: memory depends on zones and snapshots, not on how far the waves come. Printed: the largest sum of the memory of all its
processes at one time and the peak of each (Linux), the size of the result and the times of running it and of reading one snapshot of it
back.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

DECK = """title = "A million zones"
stop_time = "{stop} s"
[[region]]
name = "flyer"
material = "copper"
from = "0 mm"
to = "{thin} mm"
zones = {few}
velocity = "500 m/s"
[[region]]
name = "target"
material = "copper"
from = "{thin} mm"
to = "{thick} mm"
zones = {many}
[output]
snapshots = "{every} s"
"""
PLANE = """title = "A million zones in the plane"
geometry = "plane"
stop_time = "{stop} s"
[[block]]
name = "b"
material = "al"
x = ["0 mm", "{thick} mm"]
y = ["0 mm", "{thick} mm"]
zones = [{many}, {many}]
velocity = ["0 m/s", "-300 m/s"]
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.3 GPa"
[[boundary]]
on = "b.bottom"
kind = "wall"
[solver]
kind = "lagrange2d"
[output]
snapshots = "{every} s"
"""
STEP_PER_ZONE = 0.48e-10 / 1e-6         # time step of these plates over the width of a zone, s/m
WIDTH = 1e-6                           # of a zone, m
LOOK = 0.2                             # seconds between two looks at the memory


def memory(root: int) -> dict[int, tuple[int, int]]:
    """(memory now, its peak) in bytes of a process and all processes that came from it."""
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            parents[int(stat.parent.name)] = int(stat.read_text().rpartition(")")[2].split()[1])
        except OSError:
            continue
    family, found = {root}, {}
    while more := {child for child, parent in parents.items() if parent in family} - family:
        family |= more
    for one in family:
        try:
            lines = dict(line.split(":", 1) for line in Path(f"/proc/{one}/status").read_text().splitlines())
            found[one] = 1024 * int(lines["VmRSS"].split()[0]), 1024 * int(lines["VmHWM"].split()[0])
        except (OSError, KeyError):     # it has ended
            continue
    return found


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, number in (("zones", 1_000_000), ("snapshots", 100), ("steps", 3)):
        words.add_argument(f"--{name}", type=int, default=number)
    words.add_argument("--folder", type=Path, default=None, help="where to work (default: a temporary folder)")
    words.add_argument("--plane", action="store_true", help="a square mesh in two dimensions")
    asked = words.parse_args()
    with tempfile.TemporaryDirectory(dir=asked.folder) as place:
        few = 0 if asked.plane else asked.zones // 10
        many = round(asked.zones**0.5) if asked.plane else asked.zones - few
        every, length = asked.steps * STEP_PER_ZONE * WIDTH, 1e3 * WIDTH * (few + many)
        deck = Path(place) / "deck.toml"
        deck.write_text((PLANE if asked.plane else DECK).format(stop=every * asked.snapshots, every=every, thin=0.1 * length, thick=length,
                                                                few=few, many=many))
        began, most, peaks = time.perf_counter(), 0, {}
        words_of = [sys.executable, "-m", "hugoniot.cli.main", "run", str(deck), "--out", str(Path(place) / "run"), "-q"]
        process = subprocess.Popen(words_of)
        while process.poll() is None:
            now = memory(process.pid)
            most = max(most, sum(held for held, _ in now.values()))
            peaks |= {one: max(peak, peaks.get(one, 0)) for one, (_, peak) in now.items()}
            time.sleep(LOOK)
        took = time.perf_counter() - began
        if process.returncode:
            sys.exit(f"the run ended with exit code {process.returncode}")
        show(Path(place) / "run", most, sorted(peaks.values(), reverse=True), took)


def show(folder: Path, most: int, peaks: list[int], took: float) -> None:
    """Print what the run needed and left."""
    from hugoniot import load

    began = time.perf_counter()
    run = load(folder)
    count, zones = run.snapshots["pressure"].shape
    run.snapshots["pressure"][-1].values  # noqa: B018
    size = (folder / "result.h5").stat().st_size
    print(f"{zones} zones, {count} snapshots, {run.summary['cycles']} steps: at most {most / 1e9:.2f} GB at one time "
          f"(peaks of its processes: {', '.join(f'{peak / 1e9:.2f}' for peak in peaks)} GB), {took:.0f} s, result.h5 {size / 1e9:.2f} GB, "
          f"opened and one snapshot read in {time.perf_counter() - began:.1f} s")


if __name__ == "__main__":
    main()
