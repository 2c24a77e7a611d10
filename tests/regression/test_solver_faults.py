"""Runs of every solver, killed at file operations and at random moments: they go on to the same bytes; no flip in their files is silent."""

import os
import random
import shutil
import signal
import sys
import time
from functools import partial

import numpy as np
import pytest
from faults import check_flips_of_a_finished_run, killed_at, operations, same_bytes, spread
from solver_decks import DECKS, MODES

from hugoniot import simulate
from hugoniot.errors import FileTrouble
from hugoniot.output.run import load
from hugoniot.output.verify import verify

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kills and forks are a Unix matter")
FILES = {"deck.toml", "gauges.csv", "report.html", "result.h5", "run.log", "summary.json"}
MORE = {"line": set(), "plane": {"result.vtkhdf"}, "contact": {"result.vtkhdf"}, "algebraic fronts": {"fronts.csv"}, "fronts in cells": {"fronts.csv"}}
slow = pytest.mark.slow
# a mesh without contact writes what one with contact does, and the algebraic fronts what those in cells do
EVERY_WAY = [pytest.param(name, marks=slow) if name in ("plane", "algebraic fronts") else name for name in DECKS]


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """Function from a name of DECKS to (its deck, the finished run of it with its report)."""
    folder, done = tmp_path_factory.mktemp("solved"), {}

    def run(name):
        if name not in done:
            deck = folder / f"{name}.toml"
            deck.write_text(DECKS[name])
            simulate.run(deck, folder / name)
            done[name] = deck, folder / name
        return done[name]

    return run


def go_on(folder) -> bool:
    """Resume; False if there was nothing yet to resume."""
    try:
        simulate.resume(folder, report=False)
    except FileTrouble as error:
        assert "no run to resume" in str(error) and not (folder / "deck.toml").exists()
        return False
    return True


def check_end(whole, folder, what):
    """The run is finished with the bytes of one that nothing disturbed, and nothing else is left."""
    assert same_bytes(whole, folder), what
    assert not (folder / "pieces").exists() and not (folder / "checkpoint").exists() and not any(f.bad for f in verify(folder)), what
    shutil.rmtree(folder)


def check_kills_at_operations(deck, whole, tmp_path, wanted):
    """Runs of a deck, each killed at one of `wanted` file operations (None: at each)."""
    def work(folder):
        simulate.run(deck, folder, report=False)

    total = operations(tmp_path, work)
    for k in range(total) if wanted is None else spread(total, wanted):
        folder = tmp_path / f"operation {k}"
        assert killed_at(folder, k, work), k
        if folder.exists() and go_on(folder):
            check_end(whole, folder, k)
        shutil.rmtree(folder, ignore_errors=True)


def struck(work, delay) -> bool:
    """Whether `work()`, in a fork, was killed `delay` seconds after it began; False if it was done before (None: let it be done)."""
    child = os.fork()
    if child == 0:
        try:
            work()
        finally:
            os._exit(0)
    if delay is not None:
        time.sleep(delay)
        os.kill(child, signal.SIGKILL)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


def check_kills_at_random_moments(deck, whole, tmp_path, wanted):
    """Runs of a deck that are killed `wanted` times in all, some of them again while they are resumed."""
    began = time.perf_counter()
    assert not struck(lambda: simulate.run(deck, tmp_path / "timed", report=False), None)
    takes, chance, hits = time.perf_counter() - began, random.Random(wanted), 0
    shutil.rmtree(tmp_path / "timed")
    for turn in range(20 * wanted):
        folder, kills = tmp_path / f"moment {turn}", 0
        work = partial(simulate.run, deck, folder, report=False)
        while kills < 3 and struck(work, chance.uniform(0.0, takes / (1 + kills))):
            kills += 1
            if not (folder / "deck.toml").exists():     # nothing yet to resume
                break
            work = partial(simulate.resume, folder, report=False)
        hits += kills
        if folder.exists() and go_on(folder):
            check_end(whole, folder, turn)
        shutil.rmtree(folder, ignore_errors=True)
        if hits >= wanted:
            return
    raise AssertionError(f"only {hits} kills met a run")


@pytest.mark.parametrize("mode", MODES)
def test_fronts_meet_before_and_after_their_first_checkpoint(solved, mode):
    """Else the kills of their runs would prove little."""
    name = {"algebraic": "algebraic fronts", "cells": "fronts in cells"}[mode]
    met = load(solved(name)[1]).arrays("events")["cycle"]
    assert np.any(met < MODES[mode][2]) and np.sum(met > MODES[mode][2]) >= 4


@pytest.mark.parametrize("name", EVERY_WAY)
def test_killed_at_some_file_operations_a_run_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_at_operations(*solved(name), tmp_path, 3)


@pytest.mark.parametrize("name", EVERY_WAY)
def test_killed_at_a_random_moment_a_run_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_at_random_moments(*solved(name), tmp_path, 1)


@slow
@pytest.mark.parametrize("name", DECKS)
def test_killed_at_every_file_operation_a_run_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_at_operations(*solved(name), tmp_path, None)


@slow
@pytest.mark.parametrize("name", DECKS)
def test_killed_at_thirty_random_moments_a_run_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_at_random_moments(*solved(name), tmp_path, 30)


@pytest.mark.parametrize("name", DECKS)
def test_no_flip_in_any_file_of_a_run_is_silent(solved, tmp_path, name):
    assert check_flips_of_a_finished_run(solved(name)[1], tmp_path, 24) == FILES | MORE[name]


@slow
@pytest.mark.parametrize("name", DECKS)
def test_none_of_ten_thousand_flips_in_all_files_of_finished_runs_is_silent(solved, tmp_path, name):
    check_flips_of_a_finished_run(solved(name)[1], tmp_path, 2000)
