"""The fault harness: kills and refusals at every file operation, refused memory, flipped bits in every file.

Nothing a fault leaves behind is silently wrong, and what can go on goes on to the same bytes. Each test has a quick part of some faults
and a slow one of thousands. Here the recorder is driven by the exact acoustic flyer of tests/unit/output, in test_solver_faults.py by the
solvers. Hostile links and two processes on one folder are in test_run_folder_safety.py, mutated decks and tables in test_fuzzed_input.py.
"""

import errno
import os
import random
import shutil
import sys

import acoustic_flyer
import numpy as np
import pytest
from faults import (
    Doors,
    check_flips_of_a_finished_run,
    flip,
    in_a_copy_of_this_process,
    killed_at,
    operations,
    same_bytes,
    same_contents,
    spread,
)

from hugoniot.errors import HugoniotError
from hugoniot.output.run import load
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.verify import verify

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kills and forks are a Unix matter")
SMALL = dict(flyer=10, target=20, cycles=80, checkpoint_every=20)
slow = pytest.mark.slow
@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("faults") / "whole"
    acoustic_flyer.run(folder, **SMALL)
    return folder


@pytest.fixture(scope="module")
def unfinished(tmp_path_factory):
    """A run that stopped behind its third checkpoint."""
    folder = tmp_path_factory.mktemp("faults") / "unfinished"

    def stop(flyer):
        if flyer.cycle == 65:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        acoustic_flyer.run(folder, after_step=stop, **SMALL)
    return folder


def begin(folder):
    """The run from its start, or over what a fault at its very start has left."""
    acoustic_flyer.run(folder, overwrite=True, **SMALL)


def go_on(folder):
    """What a user does after a fault: resume, of a finished run too; start again where there was nothing yet to resume."""
    try:
        with RunFolder(folder, resume=True) as place:
            if place.finished:
                place.tidy()
                return
            place.checked_deck()
    except HugoniotError as error:
        if "no run to resume" not in str(error):
            raise
        shutil.rmtree(folder, ignore_errors=True)
        begin(folder)
        return
    acoustic_flyer.run(folder, resume=True, **SMALL)


def check_kills(whole, tmp_path, places):
    for k in places:
        folder = tmp_path / f"kill{k}"
        assert killed_at(folder, k, begin), k
        if folder.exists():
            go_on(folder)
            assert same_bytes(whole, folder), k
            assert {path.name for path in folder.iterdir()} == {"deck.toml", "gauges.csv", "result.h5", "run.log", "summary.json"}, k
            assert not any(f.bad for f in verify(folder)), k
            shutil.rmtree(folder)


def test_killed_at_some_file_operations_the_run_ends_in_the_same_bytes(whole, tmp_path):
    check_kills(whole, tmp_path, spread(operations(tmp_path, begin), 8))


@slow
def test_killed_at_every_file_operation_the_run_ends_in_the_same_bytes(whole, tmp_path):
    check_kills(whole, tmp_path, range(operations(tmp_path, begin)))


@slow
def test_killed_twice_the_run_ends_in_the_same_bytes(whole, unfinished, tmp_path):
    """The second kill strikes while the run is being resumed."""
    def resumed(folder):
        shutil.copytree(unfinished, folder)
        acoustic_flyer.run(folder, resume=True, **SMALL)

    check_kills_of_resumes(whole, unfinished, tmp_path, range(operations(tmp_path, resumed)))


def test_killed_while_it_is_resumed_the_run_ends_in_the_same_bytes(whole, unfinished, tmp_path):
    check_kills_of_resumes(whole, unfinished, tmp_path, range(3, 60, 15))


def check_kills_of_resumes(whole, unfinished, tmp_path, places):
    for k in places:
        folder = shutil.copytree(unfinished, tmp_path / f"again{k}")
        killed_at(folder, k, lambda folder: acoustic_flyer.run(folder, resume=True, **SMALL))
        go_on(folder)
        assert same_bytes(whole, folder), k
        shutil.rmtree(folder)


def check_refusals(whole, tmp_path, places, number):
    def refuse(name, real, arguments):
        raise OSError(number, os.strerror(number))

    for k in places:
        folder = tmp_path / f"error{number}_{k}"
        with pytest.MonkeyPatch.context() as patch:
            Doors(patch, k, refuse)
            try:
                begin(folder)
            except HugoniotError as error:
                assert error.exit_code == 4, k
        if folder.exists():
            go_on(folder)
            assert same_bytes(whole, folder), k
            shutil.rmtree(folder)


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO])
def test_refused_at_some_file_operations_the_run_says_so_and_can_be_resumed(whole, tmp_path, number):
    check_refusals(whole, tmp_path, spread(operations(tmp_path, begin), 5), number)


@slow
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO, errno.EACCES, errno.EDQUOT])
def test_refused_at_every_file_operation_the_run_says_so_and_can_be_resumed(whole, tmp_path, number):
    check_refusals(whole, tmp_path, range(operations(tmp_path, begin)), number)


# -- memory that is refused ---------------------------------------------------------------------------------------------
def check_refused_memory(whole, tmp_path, places):
    """One request for memory is refused, the k-th from the start of the run: no crash, nothing lost.

    Where it is refused as h5py lets go of an object, which it then passes over, HDF5 lays out the rest of the file in another way.
    """
    testing = pytest.importorskip("_testcapi", reason="this Python cannot refuse memory")

    def begin_in_want(folder, k):
        testing.set_nomemory(k, k + 1)
        try:
            begin(folder)
        except (MemoryError, HugoniotError, SystemError):
            return
        finally:
            testing.remove_mem_hooks()

    for k in places:
        folder = tmp_path / f"memory{k}"
        status = in_a_copy_of_this_process(lambda: begin_in_want(folder, k))  # noqa: B023
        assert not os.WIFSIGNALED(status), k
        if folder.exists():
            go_on(folder)
            assert same_contents(whole, folder), k
            shutil.rmtree(folder)


def test_refused_memory_at_some_places_the_run_can_be_resumed(whole, tmp_path):
    check_refused_memory(whole, tmp_path, range(1000, 60_000, 12_000))


@slow
def test_refused_memory_at_a_thousand_places_the_run_can_be_resumed(whole, tmp_path):
    check_refused_memory(whole, tmp_path, range(0, 100_000, 100))


# -- flipped bits -----------------------------------------------------------------------------------------------------
def test_no_flip_in_a_finished_run_is_silent(whole, tmp_path):
    check_flips_of_a_finished_run(whole, tmp_path, 200)


def check_flips_of_an_unfinished_run(whole, unfinished, tmp_path, count):
    """The run is refused, or ends in the bytes of one that nothing disturbed. (Its log is not read again, and left out.)"""
    chance, refused = random.Random(count), 0
    names = sorted(str(path.relative_to(unfinished)) for path in unfinished.rglob("*") if path.is_file() and path.name != "run.log")
    for k in range(count):
        folder = shutil.copytree(unfinished, tmp_path / f"flip{k}")
        name = names[k % len(names)]
        flip(folder / name, chance)
        try:
            go_on(folder)
        except HugoniotError as error:
            assert name == "deck.toml" and error.exit_code == 4, (name, error)
            refused += 1
        else:
            assert same_bytes(whole, folder), (k, name)
        shutil.rmtree(folder)
    assert refused == sum(names[k % len(names)] == "deck.toml" for k in range(count))


def test_no_flip_in_an_unfinished_run_changes_its_result(whole, unfinished, tmp_path):
    check_flips_of_an_unfinished_run(whole, unfinished, tmp_path, 14)


@slow
def test_no_flip_of_a_thousand_in_an_unfinished_run_changes_its_result(whole, unfinished, tmp_path):
    check_flips_of_an_unfinished_run(whole, unfinished, tmp_path, 1000)


def check_partial_reading(whole, tmp_path, count):
    """Reading a damaged result on demand ends no process, and gives the numbers that were written or says that it cannot."""
    folder, chance = shutil.copytree(whole, tmp_path / "partial"), random.Random(count)
    data = (folder / "result.h5").read_bytes()
    groups = ("snapshots", "gauges", "budget", "peaks")
    sound = {(group, name): values for group in groups for name, values in load(whole).arrays(group).items() if values.dtype.kind == "f"}

    def look():
        for group, name in sound:
            try:
                found = load(folder, partial=True).arrays(group)[name]
            except (HugoniotError, KeyError):
                continue
            assert np.array_equal(found, sound[group, name]), (group, name)

    for k in range(count):
        flip(folder / "result.h5", chance)
        assert in_a_copy_of_this_process(look) == 0, k
        (folder / "result.h5").write_bytes(data)


def test_a_damaged_result_that_is_read_on_demand_gives_no_other_number(whole, tmp_path):
    check_partial_reading(whole, tmp_path, 10)


@slow
def test_two_thousand_damaged_results_that_are_read_on_demand_give_no_other_number(whole, tmp_path):
    check_partial_reading(whole, tmp_path, 2000)
