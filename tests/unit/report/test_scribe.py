"""The report is the same whoever writes it, and a run never lacks one because a process could not be had."""

import pathlib
import subprocess
import sys
import time

import pytest

import hugoniot
from hugoniot.errors import FileTrouble
from hugoniot.report import scribe as module
from hugoniot.report.scribe import Scribe

DECK = pathlib.Path(__file__).parents[3] / "examples" / "sod.toml"


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    return hugoniot.run(DECK, tmp_path_factory.mktemp("scribe") / "sod.run").folder


@pytest.fixture
def two_cores(monkeypatch):
    monkeypatch.setattr(module, "_a_second_core", lambda: True)


def rewritten(folder, scribe):
    before = (folder / "report.html").read_bytes()
    (folder / "report.html").unlink()
    with scribe:
        scribe.write(folder)
    return before, (folder / "report.html").read_bytes()


def test_the_waiting_process_writes_the_same_report(finished, two_cores, monkeypatch):
    scribe = Scribe()
    monkeypatch.setattr("hugoniot.report.write_report", lambda folder: pytest.fail("written by the caller"))
    before, after = rewritten(finished, scribe)
    assert before == after and scribe.process is not None


def test_without_a_second_core_the_caller_writes_it(finished, monkeypatch):
    monkeypatch.setattr(module, "_a_second_core", lambda: False)
    scribe = Scribe()
    before, after = rewritten(finished, scribe)
    assert before == after and scribe.process is None


@pytest.mark.parametrize("python", [["false"], [sys.executable, "-c", "print('a greeting')"]], ids=["fails", "says something else"])
def test_where_the_process_fails_the_caller_writes_it(finished, two_cores, monkeypatch, python):
    monkeypatch.setattr(module, "_start", lambda: subprocess.Popen(python, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))
    before, after = rewritten(finished, Scribe())
    assert before == after


@pytest.mark.parametrize("cores", [1, 2])
def test_a_report_that_cannot_be_written_is_told_in_the_log(finished, monkeypatch, cores):
    monkeypatch.setattr(module, "_a_second_core", lambda: cores == 2)
    monkeypatch.setattr(module, "_start", lambda: subprocess.Popen(["false"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))

    def refuse(folder):
        raise FileTrouble("no room for it")

    monkeypatch.setattr("hugoniot.report.write_report", refuse)
    with Scribe() as scribe:
        scribe.write(finished)
    assert (finished / "run.log").read_text().splitlines()[-1].endswith("the report could not be written: no room for it")


def test_the_report_stands_when_the_wait_is_over(finished, two_cores):
    (finished / "report.html").unlink()
    with Scribe() as scribe:
        scribe.write(finished)
        scribe.wait()
        assert (finished / "report.html").is_file()


def test_two_draw_every_picture_once(tmp_path):
    marks = tmp_path / "drawn"

    def task(name):
        def draw():
            time.sleep(0.01)
            with open(marks, "a") as file:
                file.write(f"{name}\n")
            return name.upper()
        return draw

    names = [f"picture {k}" for k in range(12)]
    assert module.by_two({name: task(name) for name in names}) == {name: name.upper() for name in names}
    assert sorted(marks.read_text().splitlines()) == sorted(names)


def test_a_run_that_fails_leaves_no_process_behind(two_cores):
    with pytest.raises(ValueError, match="stopped"), Scribe() as scribe:
        raise ValueError("stopped")
    assert scribe.process.poll() is not None
