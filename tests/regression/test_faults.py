"""The fault harness: kills and refusals at every file operation, refused memory, flipped bits in every file.

Nothing a fault leaves behind is silently wrong, and what can go on goes on to the same bytes. Each test has a quick part of some faults
and a slow one of thousands. Hostile links and two processes on one folder are in test_run_folder_safety.py, mutated decks and tables in
test_fuzzed_input.py.
"""

import errno
import os
import random
import resource
import shutil
import signal
import sys

import acoustic_flyer
import numpy as np
import pytest
from test_plane_kill import DECK as PLATES
from test_resume import DECK as FLYER

from hugoniot import simulate
from hugoniot.errors import FileTrouble, HugoniotError
from hugoniot.output.run import load
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.verify import verify
from hugoniot.problem.deck import read_deck

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kills and forks are a Unix matter")
SMALL = dict(flyer=10, target=20, cycles=80, checkpoint_every=20)
DOORS = ("open", "write", "pwrite", "replace", "unlink", "fsync", "mkdir", "rmdir", "ftruncate")
slow = pytest.mark.slow
FRONTS = """title = "plate on plate"
stop_time = "1 us"
[[region]]
name = "flyer"
material = "al"
from = "0 mm"
to = "2 mm"
zones = 10
velocity = "700 m/s"
[[region]]
name = "target"
material = "al"
from = "2.1 mm"
to = "6 mm"
zones = 20
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[[gauge]]
name = "middle"
at = "3 mm"
[solver]
kind = "fronts"
[output]
snapshots = "0.2 us"
checkpoint_cycles = 3
"""
DECKS = {"line": FLYER.format(flyer=20, target=40, integrator="compatible", every=40).replace("report = false\n", ""),
         "plane": PLATES.replace("report = false\n", "").replace("1.2 us", "0.6 us"), "fronts": FRONTS}


@pytest.fixture(scope="module", autouse=True)
def _without_waiting_for_the_disk():
    """A kill of the program, other than a power cut, takes nothing that the system has been given: flushing would only cost time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "fsync", lambda handle: None)
        yield


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


def same_bytes(a, b):
    """Whether two runs have the same files with the same bytes, but for what holds times of day."""
    names = [path.name for path in a.iterdir() if path.name not in ("run.log", "summary.json", "report.html")]
    return all((b / name).is_file() and (a / name).read_bytes() == (b / name).read_bytes() for name in names)


def flip(path, chance):
    data = bytearray(path.read_bytes())
    data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    path.write_bytes(data)


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


class Doors:
    """Stands in the doors to the file system and lets something happen at the operation number `at`, counted from 0."""

    def __init__(self, monkeypatch, at, happen):
        self.at, self.count, self.happen = at, 0, happen
        for name in DOORS:
            monkeypatch.setattr(os, name, self._door(name, getattr(os, name)))

    def _door(self, name, real):
        def call(*arguments, **more):
            here, self.count = self.count, self.count + 1
            if here == self.at:
                self.happen(name, real, arguments)
            return real(*arguments, **more)

        return call


def kill(name, real, arguments):
    """Kill -9, of a write in its middle."""
    if name == "write":
        real(arguments[0], bytes(arguments[1])[: len(arguments[1]) // 2])
    os.kill(os.getpid(), signal.SIGKILL)


def operations(tmp_path, work=begin):
    with pytest.MonkeyPatch.context() as patch:
        doors = Doors(patch, -1, None)
        work(tmp_path / "counted")
    shutil.rmtree(tmp_path / "counted")
    return doors.count


def in_a_copy_of_this_process(work):
    """Exit status of `work()` in a fork; 0 if it came to its end."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            resource.setrlimit(resource.RLIMIT_CPU, (600, 600))     # only for what never ends
            work()
            status = 0
        finally:
            os._exit(status)
    return os.waitpid(child, 0)[1]


def killed_at(folder, k, work=begin):
    def doomed():
        with pytest.MonkeyPatch.context() as patch:
            Doors(patch, k, kill)
            work(folder)

    return os.WIFSIGNALED(in_a_copy_of_this_process(doomed))


def check_kills(whole, tmp_path, places):
    for k in places:
        folder = tmp_path / f"kill{k}"
        assert killed_at(folder, k), k
        if folder.exists():
            go_on(folder)
            assert same_bytes(whole, folder), k
            assert {path.name for path in folder.iterdir()} == {"deck.toml", "gauges.csv", "result.h5", "run.log", "summary.json"}, k
            assert not any(f.bad for f in verify(folder)), k
            shutil.rmtree(folder)


def spread(count, wanted):
    return sorted({round(k * (count - 1) / (wanted - 1)) for k in range(wanted)})


def test_killed_at_some_file_operations_the_run_ends_in_the_same_bytes(whole, tmp_path):
    check_kills(whole, tmp_path, spread(operations(tmp_path), 8))


@slow
def test_killed_at_every_file_operation_the_run_ends_in_the_same_bytes(whole, tmp_path):
    check_kills(whole, tmp_path, range(operations(tmp_path)))


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
    check_refusals(whole, tmp_path, spread(operations(tmp_path), 5), number)


@slow
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO, errno.EACCES, errno.EDQUOT])
def test_refused_at_every_file_operation_the_run_says_so_and_can_be_resumed(whole, tmp_path, number):
    check_refusals(whole, tmp_path, range(operations(tmp_path)), number)


# -- runs of the solvers ----------------------------------------------------------------------------------------------
def check_kills_of_solvers(deck, whole, tmp_path, places, whenever):
    """Runs of a deck, each killed at a file operation (`places` of all, None: at each) or in a random step (`whenever` of them)."""
    def work(folder):
        simulate.run(deck, folder, report=False)

    def in_step(folder, call):
        """Kill where the solver is asked to march for the `call`-th time, in pieces of three cycles at the most."""
        kind = type(simulate.make_solver(read_deck(deck).problem))
        march, calls = kind.march, iter(range(call, -1, -1))

        def marched(self, until, cycles):
            if next(calls) == 0:
                os.kill(os.getpid(), signal.SIGKILL)
            return march(self, until, min(cycles, 3))

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(kind, "march", marched)
            work(folder)

    def killed_in_step(folder, call):
        return os.WIFSIGNALED(in_a_copy_of_this_process(lambda: in_step(folder, call)))

    total = operations(tmp_path, work)
    chance, most = random.Random(total), load(whole).summary["cycles"] // 3
    steps = [chance.randrange(most) for _ in range(whenever)]
    kills = [(killed_at, k, work) for k in (range(total) if places is None else spread(total, places))] + [(killed_in_step, k) for k in steps]
    for struck, k, *more in kills:
        folder = tmp_path / f"{struck.__name__}{k}"
        assert struck(folder, k, *more), k
        if folder.exists():
            try:
                simulate.resume(folder, report=False)
            except FileTrouble as error:
                assert "no run to resume" in str(error) and not (folder / "deck.toml").exists()
                shutil.rmtree(folder)
                continue
            assert same_bytes(whole, folder), k
            assert not (folder / "pieces").exists() and not (folder / "checkpoint").exists() and not any(f.bad for f in verify(folder)), k
            shutil.rmtree(folder)


@pytest.mark.parametrize("name", DECKS)
def test_a_killed_run_of_a_solver_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_of_solvers(*solved(name), tmp_path, 3, 1)


@slow
@pytest.mark.parametrize("name", DECKS)
def test_killed_at_every_file_operation_and_in_many_steps_a_run_of_a_solver_ends_in_the_same_bytes(solved, tmp_path, name):
    check_kills_of_solvers(*solved(name), tmp_path, None, 40)


# -- memory that is refused ---------------------------------------------------------------------------------------------
def check_refused_memory(whole, tmp_path, places):
    """One request for memory is refused, the k-th from the start of the run: no crash, nothing lost."""
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
            assert same_bytes(whole, folder), k
            shutil.rmtree(folder)


def test_refused_memory_at_some_places_the_run_can_be_resumed(whole, tmp_path):
    check_refused_memory(whole, tmp_path, range(1000, 60_000, 12_000))


@slow
def test_refused_memory_at_a_thousand_places_the_run_can_be_resumed(whole, tmp_path):
    check_refused_memory(whole, tmp_path, range(0, 100_000, 100))


# -- flipped bits -----------------------------------------------------------------------------------------------------
def check_flips_of_a_finished_run(whole, tmp_path, count):
    """Each is found by `verify`; one in a file that is read again stops its reading as well."""
    folder, chance = shutil.copytree(whole, tmp_path / "flipped"), random.Random(count)
    readings = {"result.h5": lambda: load(folder).arrays("gauges"), "summary.json": lambda: load(folder).summary,
                "fronts.csv": lambda: load(folder).fronts}
    files = sorted(path for path in folder.iterdir())
    for k in range(count):
        path = files[k % len(files)]
        data = path.read_bytes()
        flip(path, chance)
        assert [f.file for f in verify(folder, survey=False) if f.bad] == [path.name], k
        if path.name in readings:
            with pytest.raises(HugoniotError):
                readings[path.name]()
        path.write_bytes(data)
    return {path.name for path in files}


def test_no_flip_in_a_finished_run_is_silent(whole, tmp_path):
    check_flips_of_a_finished_run(whole, tmp_path, 200)


@pytest.mark.parametrize("name, more", [("line", {"report.html"}), ("plane", {"report.html", "result.vtkhdf"}), ("fronts", {"report.html", "fronts.csv"})])
def test_no_flip_in_any_file_of_a_solvers_run_is_silent(solved, tmp_path, name, more):
    files = check_flips_of_a_finished_run(solved(name)[1], tmp_path, 24)
    assert files == {"deck.toml", "gauges.csv", "result.h5", "run.log", "summary.json"} | more


@slow
@pytest.mark.parametrize("name", DECKS)
def test_none_of_ten_thousand_flips_in_all_files_of_finished_runs_is_silent(solved, tmp_path, name):
    check_flips_of_a_finished_run(solved(name)[1], tmp_path, 3334)


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
