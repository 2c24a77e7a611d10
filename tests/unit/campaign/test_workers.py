"""Worker processes: one thread each, the same table whatever their number, nothing lost when they or the sweep are killed."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from hugoniot.campaign.ask import Wishes, run_sweep
from hugoniot.campaign.pool import LocalPool
from hugoniot.campaign.questions import Deck
from hugoniot.campaign.sweep import CASES, JOURNAL, TABLE
from hugoniot.errors import HugoniotError

SPEEDS = "region.flyer.velocity = 400..900 m/s : {}"


def bytes_of(folder):
    return [(folder / name).read_bytes() for name in (CASES, TABLE)]


def test_the_table_is_the_same_for_any_number_of_workers_and_deaths(deck, tmp_path, inline):
    wishes = Wishes(vary=[SPEEDS.format(8)], record=["free surface.velocity"])
    run_sweep(deck, wishes, tmp_path / "inline", engine=inline, report=False)
    killed = []

    class Deadly(LocalPool):
        """Kills a worker each time an answer has come, while it works on another case."""

        def run(self, tasks):
            for answer in super().run(tasks):
                busy = [worker for worker in self.workers if worker.case is not None]
                if busy and len(killed) < 2:
                    killed.append(busy[0].case)
                    os.kill(busy[0].process.pid, signal.SIGKILL)
                yield answer

    found = run_sweep(deck, wishes, tmp_path / "two", engine=lambda question, known: Deadly(question, 2, known), report=False)
    assert len(killed) == 2 and not any(found.table.reasons)
    assert bytes_of(tmp_path / "two") == bytes_of(tmp_path / "inline")


def test_a_worker_computes_with_one_thread(monkeypatch):
    monkeypatch.setenv("NUMBA_NUM_THREADS", "2")      # of the user's own; the worker has its own
    from hugoniot.campaign.worker import environment

    found = subprocess.run([sys.executable, "-c", "from hugoniot.campaign.worker import single_threaded; print(single_threaded())"],
                           env=environment(), capture_output=True, text=True)
    assert found.stdout.strip() == "1"
    import numba

    from hugoniot.campaign.worker import single_threaded

    if numba.config.NUMBA_NUM_THREADS > 1:
        with pytest.raises(HugoniotError, match="one thread"):
            single_threaded()


def test_a_case_that_hangs_is_ended_at_its_limit(deck, tmp_path):
    slow = deck.read_text().replace("zones = 16", "zones = 16000")
    pool = LocalPool(Deck(slow, "slow.toml").record(), 1, time_limit=0.3)
    with pool:
        answers = list(pool.run([(0, {"region.target.zones": 16}), (1, {}), (2, {"region.target.zones": 12})]))
    assert ["numbers" in a for a in answers] == [True, False, True]
    assert answers[1] == {"case": 1, "late": 0.3}


def test_the_help_says_what_counts_towards_the_limit(deck, monkeypatch):
    """A function that has to be compiled adds its seconds to the limit of the case; the help and the guide name them."""
    from types import SimpleNamespace

    from typer.main import get_command

    from hugoniot.campaign.pool import COMPILING_SECONDS
    from hugoniot.cli.main import build_app

    pool = LocalPool(Deck(deck.read_text(), "d.toml").record(), 1, time_limit=5.0)
    worker = SimpleNamespace(case=0, deadline=1e12, heard=lambda: [{"compiling": "one"}, {"compiling": "two"}])
    pool.workers, pool.selector = [worker], SimpleNamespace(select=lambda wait: [(SimpleNamespace(data=worker), None)])
    pool._news()
    assert worker.deadline == 1e12 + 2 * COMPILING_SECONDS
    option = next(p for p in get_command(build_app("sweep")).commands["sweep"].params if "--time-limit" in p.opts)
    said = f"has to compile adds {COMPILING_SECONDS:g} s"
    assert said in option.help and said in (Path(__file__).parents[3] / "docs" / "campaigns.md").read_text(encoding="utf-8")


def test_workers_that_cannot_start_are_noticed(monkeypatch, deck):
    monkeypatch.setattr("hugoniot.campaign.pool.COMMAND", "raise SystemExit('no such thing here')")
    with LocalPool(Deck(deck.read_text(), "d.toml").record(), 2) as pool, pytest.raises(HugoniotError, match="no such thing here"):
        list(pool.run([(0, {})]))


def _command(deck, out, cases):
    return [sys.executable, "-m", "hugoniot.cli.main", "sweep", str(deck), "--vary", SPEEDS.format(cases), "--out", str(out), "-q", "-w", "2", "--no-report"]


def _killed_at(deck, out, cases, lines):
    """Start a sweep and kill it when its journal has so many lines; the keys it had then."""
    process = subprocess.Popen(_command(deck, out, cases), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    journal = out / JOURNAL
    while process.poll() is None and (not journal.exists() or journal.read_bytes().count(b"\n") <= lines):
        time.sleep(0.002)
    process.kill()
    process.wait()
    return {json.loads(line[9:])["key"] for line in journal.read_bytes().splitlines()[1:] if line.endswith(b"}")}


def _kill_and_go_on(deck, tmp_path, inline, moments, cases):
    run_sweep(deck, Wishes(vary=[SPEEDS.format(cases)]), tmp_path / "whole", engine=inline, report=False)
    out = tmp_path / "killed"
    for lines in moments:
        before = _killed_at(deck, out, cases, lines)
        assert len(before) >= lines
    inline.worked_out = 0
    run_sweep(deck, Wishes(vary=[SPEEDS.format(cases)]), out, engine=inline, report=False)
    assert inline.worked_out <= cases - len(before)      # what stood in the journal did not run again
    assert bytes_of(out) == bytes_of(tmp_path / "whole")


def test_a_killed_sweep_goes_on(deck, tmp_path, inline):
    _kill_and_go_on(deck, tmp_path, inline, [3], 20)


@pytest.mark.slow
def test_a_sweep_killed_twenty_times_loses_nothing(deck, tmp_path, inline):
    _kill_and_go_on(deck, tmp_path, inline, range(0, 40, 2), 80)


@pytest.mark.slow
def test_four_workers_give_the_table_of_one(deck, tmp_path, inline):
    wishes = Wishes(vary=[SPEEDS.format(12)])
    for workers in (1, 2, 4):
        run_sweep(deck, wishes, tmp_path / str(workers), workers=workers, report=False)
    assert bytes_of(tmp_path / "1") == bytes_of(tmp_path / "2") == bytes_of(tmp_path / "4")
