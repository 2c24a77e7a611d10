"""The README's commands and its Python block work as they stand, one after the other, in one folder."""

import re
import shlex
import sys
import textwrap
from pathlib import Path

import pytest
from test_tutorial import run

import hugoniot

README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
NOT_HERE = ("explore", "import", "verify", "resume")     # a server, a file of another program, minutes, nothing to resume


def commands(page: str) -> list[list[str]]:
    """The words of each command of the indented blocks, without the program's name."""
    lines = (part.split("#")[0].strip() for line in page.splitlines() if line.startswith("    ") for part in line.split("&&"))
    found = [shlex.split(line)[1:] for line in lines if re.match(r"(\.venv/bin/)?hugoniot ", line)]
    return [words for words in found if words[0] not in NOT_HERE]


def python_block(page: str) -> str:
    block = page.split("## From Python")[1].split("## ")[0]
    return textwrap.dedent("\n".join(line for line in block.splitlines() if line.startswith("    ") or not line))


@pytest.mark.slow
def test_the_python_block_works_after_the_commands(tmp_path):
    asked = commands(README)
    assert [words[0] for words in asked] == ["init", "run", "run", "compare", "compare", "sweep", "fit", "init", "run", "plot"]
    for words in asked:
        if "visar.csv" in words and not (tmp_path / "visar.csv").exists():
            time, velocity = hugoniot.load(tmp_path / "flyer.run").gauge("velocity", "free surface")
            rows = (f"{1e6 * t - 0.02:.5f}, {u:.2f}" for t, u in zip(time[::4], velocity[::4]))
            (tmp_path / "visar.csv").write_text("time [us], velocity [m/s]\n" + "\n".join(rows) + "\n")
        run([sys.executable, "-m", "hugoniot.cli.main", *words], tmp_path)
    block = python_block(README)
    assert "hugoniot.fit(" in block and "hugoniot.sweep(" in block
    for _ in range(2):      # a cell of a notebook is run again
        run([sys.executable, "-c", block + "\nprint(run.gauges, table, found)\n"], tmp_path)
