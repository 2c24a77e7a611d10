#!/usr/bin/env python3
"""Seconds that single answers take, printed beside what was asked of them.

    python benchmarks/answers.py

Commands are timed with the start of their process, in processor time, the best of four; profiles in processor time, warm.
"""

import pathlib
import resource
import subprocess
import sys
import tempfile
import time

COMMAND = [sys.executable, "-m", "hugoniot.cli.main"]
BROKEN = 'stop_time = "1 mmm"\n[[region]]\nname = "a"\nmaterial = "al"\nfrom = 0.0\nto = 1.0\nzones = 10\n'


def started(*words: str) -> float:
    """Processor seconds of a command."""
    spent = []
    for _ in range(4):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*COMMAND, *words], capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(spent)


def nine_profiles() -> float:
    """Processor seconds of the steady structure of argon at three Mach numbers with three transport laws."""
    from hugoniot.laws.eos.ideal_gas import IdealGas
    from hugoniot.laws.transport.contract import TRANSPORT, make
    from hugoniot.theory.structure import steady

    begun = time.process_time()
    for law in ("constant", "power_law", "hard_sphere"):
        example = TRANSPORT.get(law).example
        for mach in (2.0, 5.0, 9.0):
            fluid = make({"law": law, **example._asdict()}, {"law": "prandtl", "prandtl": 2.0 / 3.0})
            steady(IdealGas(5.0 / 3.0, 312.2, 1.6), fluid, mach=mach).thickness()
    return time.process_time() - begun


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "deck.toml"
        deck.write_text(BROKEN)
        rows = [("hugoniot --help", started("--help"), 0.3), ("hugoniot material show copper", started("material", "show", "copper"), 0.5),
                ("hugoniot check of a broken deck", started("check", str(deck)), 1.0),
                ("nine profiles of a shock in argon", nine_profiles(), 5.0)]
    for what, seconds, asked in rows:
        print(f"{what:40s} {seconds:7.3f} s   asked for: {asked:g} s")


if __name__ == "__main__":
    main()
