"""The fault harness: kills and refusals at every file operation, flipped bits in every file, mutated decks and tables.

Nothing a fault leaves behind is silently wrong, and what can go on goes on to the same bytes. Each test has a quick part of some faults
and a slow one of thousands.
"""

import errno
import os
import random
import shutil
import signal
import sys

import acoustic_flyer
import numpy as np
import pytest
from test_broken_decks import BROKEN, SOUND

from hugoniot.errors import HugoniotError
from hugoniot.materials import tables_io
from hugoniot.materials.table_hdf5 import write_table
from hugoniot.output.run import load
from hugoniot.output.run_folder import RunFolder
from hugoniot.output.verify import verify
from hugoniot.problem.deck import read_deck_text

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kills and forks are a Unix matter")
SMALL = dict(flyer=10, target=20, cycles=80, checkpoint_every=20)
DOORS = ("open", "write", "pwrite", "replace", "unlink", "fsync", "mkdir", "rmdir", "ftruncate")
slow = pytest.mark.slow


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


def same_bytes(a, b):
    return all((a / name).read_bytes() == (b / name).read_bytes() for name in ("result.h5", "gauges.csv", "deck.toml"))


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
    """Each is found by `verify`; one in the result or the summary stops its reading as well."""
    folder, chance = shutil.copytree(whole, tmp_path / "flipped"), random.Random(count)
    files = sorted(path for path in folder.iterdir())
    for k in range(count):
        path = files[k % len(files)]
        data = path.read_bytes()
        flip(path, chance)
        assert [f.file for f in verify(folder, survey=False) if f.bad] == [path.name], k
        if path.name in ("result.h5", "summary.json"):
            with pytest.raises(HugoniotError):
                load(folder).arrays("gauges")
        path.write_bytes(data)


def test_no_flip_in_a_finished_run_is_silent(whole, tmp_path):
    check_flips_of_a_finished_run(whole, tmp_path, 400)


@slow
def test_none_of_ten_thousand_flips_in_a_finished_run_is_silent(whole, tmp_path):
    check_flips_of_a_finished_run(whole, tmp_path, 10_000)


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


# -- mutated input ----------------------------------------------------------------------------------------------------
SPICE = ["[", "]", "{", "}", "=", '"', "'", ".", "\\", "\n", "\x00", "\x1b", "é", "1e999", "nan", "-inf", "0x" + "f" * 40, "9" * 30, "true", "[[", '"""', "#",
         "m/s", "1 GPa", "free", "region", "material", "law", "zones = 3", "a.b.c"]


def mutated(text, chance):
    """The text with some pieces cut out, doubled, exchanged or spiced."""
    for _ in range(chance.randint(1, 4)):
        a, b = sorted(chance.randrange(len(text) + 1) for _ in range(2))
        b = min(b, a + chance.choice((1, 3, 20, 200)))
        how = chance.randrange(5)
        piece = chance.choice(SPICE)
        text = (text[:a] + text[b:] if how == 0 else text[:b] + text[a:] if how == 1 else text[:a] + piece + text[b:] if how == 2 else
                text[:a] + piece + text[a:] if how == 3 else text[:a] + chr(chance.randrange(1, 0x250)) + text[a + 1:])
        text = text or " "
    return text


def check_decks(count, seed):
    chance, read = random.Random(seed), 0
    decks = [SOUND, *(text for text, _ in BROKEN.values() if len(text) < 5000)]
    for k in range(count):
        text = mutated(decks[0] if k % 2 else chance.choice(decks), chance)
        try:
            read_deck_text(text, "deck.toml")
            read += 1
        except HugoniotError as error:
            shown = str(error)
            assert error.exit_code == 2 and "\x1b" not in shown and "\x00" not in shown and len(shown) < 40_000, text
    assert read > 0


def test_mutated_decks_are_read_or_refused_in_words():
    check_decks(300, 1)


@slow
@pytest.mark.parametrize("seed", range(10))
def test_a_hundred_thousand_mutated_decks_are_read_or_refused_in_words(seed):
    check_decks(10_000, 100 + seed)


def tables(folder):
    rho, t = np.linspace(1.0, 4.0, 4), np.linspace(300.0, 1200.0, 4)
    p, e = rho[:, None] * t * 287.0, np.ones(4)[:, None] * t * 717.5
    rows = "".join(f"{rho[i]},{t[j]},{p[i, j]},{e[i, j]}\n" for i in range(4) for j in range(4))
    words = [4.0, 4.0, *(rho / 1e3), *t, *(p.T / 1e9).ravel(), *(e.T / 1e6).ravel()]
    lines = "".join(" ".join(f"{w:.8E}" for w in words[k:k + 5]) + "\n" for k in range(0, len(words), 5))
    (folder / "t.csv").write_text("density,temperature,pressure,energy\n" + rows)
    (folder / "t.ses").write_text(f" 0 3720 301 {len(words)} r 82803 22704 1\n" + lines)
    write_table(folder / "t.h5", rho, t, p, e)
    return [folder / name for name in ("t.csv", "t.ses", "t.h5")]


def check_tables(tmp_path, count, seed):
    chance, files = random.Random(seed), tables(tmp_path)
    for path in files:
        tables_io.load(path, rho0=2.0)

    def look(path):
        def call():
            try:
                tables_io.load(path, rho0=2.0)
            except HugoniotError as error:
                assert error.exit_code in (2, 3, 4) and "\x1b" not in str(error)
        return call

    for k in range(count):
        path = files[k % 3]
        if path.suffix == ".h5":
            data = bytearray(path.read_bytes())
            for _ in range(chance.randint(1, 4)):
                data[chance.randrange(len(data))] = chance.randrange(256)
            (tmp_path / "x.h5").write_bytes(data[: chance.randrange(len(data))] if chance.random() < 0.1 else data)
            assert in_a_copy_of_this_process(look(tmp_path / "x.h5")) == 0, k
        else:
            changed = tmp_path / f"x{path.suffix}"
            changed.write_text(mutated(path.read_text(), chance), encoding="utf-8")
            look(changed)()


def test_mutated_tables_are_read_or_refused_in_words(tmp_path):
    check_tables(tmp_path, 150, 1)


@slow
@pytest.mark.parametrize("seed", range(4))
def test_ten_thousand_mutated_tables_are_read_or_refused_in_words(tmp_path, seed):
    check_tables(tmp_path, 2500, 100 + seed)
