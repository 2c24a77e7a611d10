"""Every command, file and program of the tutorial works as it stands on the page, in its order, and gives the numbers shown."""

import os
import re
import shlex
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
from pace import PATIENCE

PAGE = Path(__file__).parents[2] / "docs" / "tutorial.md"
NUMBER = re.compile(r"-?\d+\.\d+")


def blocks():
    """(kind, text) of the page's code in order: "python" or "plain", indentation removed."""
    found, here, fenced = [], [], False
    for line in [*PAGE.read_text(encoding="utf-8").splitlines(), "end"]:
        if line.startswith("```"):
            if fenced:
                found.append(("python", "\n".join(here)))
            fenced, here = not fenced, []
        elif fenced or line.startswith("    ") or (here and not line):
            here.append(line)
        elif here:
            found.append(("plain", textwrap.dedent("\n".join(here)).strip()))
            here = []
    return found


def run(arguments, folder):
    environment = {**os.environ, "COLUMNS": "200", "TERM": "dumb", "MPLBACKEND": "Agg"}
    done = subprocess.run(arguments, cwd=folder, env=environment, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, f"{arguments}: {done.stderr[-2000:]}"
    return done.stdout


def test_the_page_is_understood():
    kinds = [kind for kind, _ in blocks()]
    assert kinds.count("python") == 3 and kinds.count("plain") >= 12
    assert sum(text.count("hugoniot ") for kind, text in blocks() if kind == "plain") >= 15


def test_the_readme_shows_the_same_gauges():
    def table(page):
        lines = iter(page.read_text(encoding="utf-8").splitlines())
        return [next(line for line in lines if line.startswith("    gauge  ")), *(next(lines) for _ in range(4))]

    assert table(PAGE.parents[1] / "README.md") == table(PAGE)


@pytest.mark.slow
def test_the_first_hour(tmp_path):
    printed, shown = "", ""
    for kind, text in blocks():
        if kind == "python":
            printed += run([sys.executable, "-c", text], tmp_path)
        elif text.startswith("hugoniot "):
            for line in text.splitlines():
                command = [sys.executable, "-m", "hugoniot.cli.main", *shlex.split(line)[1:]]
                printed += run(command, tmp_path)
        elif text.startswith("time [us]"):
            (tmp_path / "visar.csv").write_text(text + "\n")
        elif text.startswith("title ="):
            (tmp_path / "other.toml").write_text(text + "\n")
        elif text.startswith("[[gauge]]"):
            with (tmp_path / "flyer.toml").open("a") as deck:
                deck.write("\n" + text + "\n")
        elif "gauge              arrival" in text or text.startswith("time        cycle"):
            shown += text
    wall = set(NUMBER.findall(re.search(r"updates in [\d.]+ s", shown)[0]))
    assert set(NUMBER.findall(shown)) - wall <= set(NUMBER.findall(printed))
    said = NUMBER.findall(re.search("The match gives.*", PAGE.read_text(encoding="utf-8"))[0])
    assert len(said) == 4
    for number in said:
        assert number in printed, number
    found = [float(text) for text in NUMBER.findall(printed)]
    commented = [number for kind, text in blocks() if kind == "python" for comment in re.findall("#.*", text)
                 for number in NUMBER.findall(comment)]
    assert len(commented) == 6
    for number in commented:       # as printed, rounded to the digits shown
        assert any(f"{value:.{len(number.partition('.')[2])}f}" == number for value in found), number
