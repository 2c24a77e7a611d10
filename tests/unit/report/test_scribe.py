"""The report is the same whoever writes it, and a run never lacks one because a process could not be had."""

import pathlib
import subprocess
import sys

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


def test_a_report_that_cannot_be_written_is_the_callers_to_tell(tmp_path, two_cores):
    with Scribe() as scribe, pytest.raises(FileTrouble):
        scribe.write(tmp_path / "no run here")


def test_a_run_that_fails_leaves_no_process_behind(two_cores):
    with pytest.raises(ValueError, match="stopped"), Scribe() as scribe:
        raise ValueError("stopped")
    assert scribe.process.poll() is not None
