"""A run that is killed, interrupted or paused goes on to the bits of one that was not."""

import os
import random
import signal
import sys
import threading
from types import SimpleNamespace

import lagrange_builders as build
import numpy as np
import pytest
from killed_runs import finish, same_bytes, start, wait_for_checkpoint
from pace import PATIENCE
from solver_decks import DECKS, flyer_deck

from hugoniot import simulate
from hugoniot.core import machine
from hugoniot.errors import FileTrouble
from hugoniot.output import origin
from hugoniot.output.run_folder import RunFolder
from hugoniot.simulate import make_solver
from hugoniot.solvers.run import Schedule, march_to_end, snapshot_times


def deck(folder, flyer=100, target=200, integrator="compatible", every=37):
    path = folder / f"flyer_{flyer}_{integrator}_{every}.toml"
    path.write_text(flyer_deck(flyer, target, integrator, every))
    return path


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    return tmp_path_factory.mktemp("resume")


@pytest.fixture(scope="module")
def whole(place):
    """Function from a deck to the folder of its run that nothing disturbed."""
    done = {}

    def run(path):
        if path not in done:
            done[path] = place / f"{path.stem}.whole"
            simulate.run(path, done[path])
        return done[path]

    return run


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")
def test_killed_three_times_the_flyer_ends_in_the_same_bytes(place, whole):
    path = deck(place)
    reference = whole(path)
    hits = finish(path, place / "killed.run", 3, random.Random(4), 0.4)
    assert hits >= 2
    same_bytes(reference, place / "killed.run")


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")
@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_fifty_kills_at_random_moments(place, whole, integrator):
    path = deck(place, flyer=150, target=300, integrator=integrator, every=11)
    reference, chance, hits, round_ = whole(path), random.Random(9), 0, 0
    while hits < 50:
        folder = place / f"fifty_{integrator}_{round_}.run"
        hits += finish(path, folder, 10, chance, 1.0)
        same_bytes(reference, folder)
        round_ += 1


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
@pytest.mark.parametrize("after", [1, 5, 9])
def test_every_checkpoint_continues_bitwise(integrator, after):
    """March to a checkpoint, restore it in a fresh solver, go on: every array, counter and total is the same."""
    problem = build.flyer((40, 80), stop=2.2e-6, gap=2e-5, integrator=integrator)
    watcher = build.Watcher()
    first, _ = build.run(problem, watcher, checkpoint_cycles=61)
    payload = watcher.payloads[min(after, len(watcher.payloads) - 1)]
    assert first.voids_opened >= 1 and first.voids_closed >= 1
    second = make_solver(problem)
    second.restore(payload["solver"])
    schedule = Schedule(problem.stop_time, snapshot_times(problem.stop_time, None, 10))
    march_to_end(second, schedule, (), payload["next_snapshot"])
    a, b = first.payload(), second.payload()
    for name, values in a.items():
        if name == "counters":
            continue
        assert np.array_equal(values, b[name]), name
    assert first.errors() == second.errors() and first.cycle == second.cycle


class Interrupt:
    """An observer that sends the process a SIGINT at a chosen moment of the loop."""

    def __init__(self, hook, cycle):
        self.hook, self.cycle, self.done = hook, cycle, False

    def __getattr__(self, name):
        if name != self.hook:
            raise AttributeError(name)

        def call(*args):
            if not self.done and self.solver.cycle >= self.cycle:
                self.done = True
                signal.raise_signal(signal.SIGINT)

        return call


@pytest.mark.parametrize("hook", ["gauges", "event", "snapshot", "progress", "checkpoint"])
def test_interrupted_anywhere_in_the_loop_nothing_is_lost_or_seen_twice(hook):
    """Ctrl-C between any two lines: what observers saw before and after, put together, is the undisturbed run."""
    problem = build.flyer((40, 80), stop=2.2e-6, gap=2e-5)
    whole = build.Watcher(keep_snapshots=True)
    reference, _ = build.run(problem, whole, checkpoint_cycles=61)
    parts = build.Watcher(keep_snapshots=True)
    breaker = Interrupt(hook, 200)
    breaker.solver = solver = make_solver(problem)
    schedule = Schedule(problem.stop_time, snapshot_times(problem.stop_time, None, 10), checkpoint_cycles=61)
    with pytest.raises(KeyboardInterrupt):
        march_to_end(solver, schedule, (breaker, parts))
    assert breaker.done and solver.time < problem.stop_time
    payload = parts.payloads[-1]
    resumed = make_solver(problem)
    resumed.restore(payload["solver"])
    march_to_end(resumed, schedule, (parts,), payload["next_snapshot"])
    assert [s.time for s in parts.states] == [s.time for s in whole.states]
    assert [(e.kind, e.cycle) for e in parts.events] == [(e.kind, e.cycle) for e in whole.events]
    assert np.array_equal(np.concatenate(parts.times), np.concatenate(whole.times))
    assert np.array_equal(resumed.zones, reference.zones) and resumed.cycle == reference.cycle


def struck_while_marching(solver, bursts):
    """Let `solver` be sent an interrupt during its burst number `bursts`, from another thread, which the burst waits for.

    A timer beside the run could strike before the loop has begun or after it has ended, and then it is the test that is interrupted.
    """
    march, left = solver.march, [bursts]

    def struck(*arguments):
        left[0] -= 1
        if left[0] != 0:
            return march(*arguments)
        sender = threading.Timer(0.002, os.kill, (os.getpid(), signal.SIGINT))
        sender.start()
        try:
            return march(*arguments)
        finally:
            sender.join()

    solver.march = struck


def test_an_interrupt_while_the_solver_marches_waits_for_the_burst():
    """The signal comes from outside, in the middle of compiled code: no event and no snapshot of that burst is lost."""
    problem = build.flyer((600, 1200), stop=2.2e-6, gap=2e-5)
    reference, whole = build.run(problem, build.Watcher(keep_snapshots=True))
    parts = build.Watcher(keep_snapshots=True)
    solver = make_solver(problem)
    schedule = Schedule(problem.stop_time, snapshot_times(problem.stop_time, None, 10))
    next_snapshot, interrupted = 0, 0
    for attempt in range(40):
        struck_while_marching(solver, 2 + attempt)
        try:
            march_to_end(solver, schedule, (parts,), next_snapshot)
            break
        except KeyboardInterrupt:
            interrupted += 1
            payload = parts.payloads[-1]
            solver, next_snapshot = make_solver(problem), payload["next_snapshot"]
            solver.restore(payload["solver"])
    assert interrupted >= 3
    assert [s.time for s in parts.states] == [s.time for s in whole.states]
    assert [(e.kind, e.cycle) for e in parts.events] == [(e.kind, e.cycle) for e in whole.events]
    assert np.array_equal(solver.zones, reference.zones) and solver.cycle == reference.cycle


@pytest.mark.skipif(sys.platform == "win32", reason="signals are a Unix matter")
@pytest.mark.parametrize("asked, background", [(signal.SIGINT, False), pytest.param(signal.SIGTERM, False, marks=pytest.mark.slow), (signal.SIGTERM, True)])
def test_a_request_to_end_leaves_a_checkpoint_and_exit_code_130(place, whole, asked, background):
    """In the background of a script too, where the shell lets a command ignore SIGINT."""
    path = deck(place)
    folder = place / f"interrupted_{asked}_{background}.run"
    usual = signal.signal(signal.SIGINT, signal.SIG_IGN) if background else None     # which the process inherits
    try:
        process = start(path, folder)
    finally:
        if background:
            signal.signal(signal.SIGINT, usual)
    assert wait_for_checkpoint(process, folder)
    process.send_signal(asked)
    output = process.communicate(timeout=PATIENCE)[0].decode()
    assert process.returncode == 130, output
    assert "hugoniot resume" in output and "Traceback" not in output
    assert list((folder / "checkpoint").glob("[0-9]*.json")) and not (folder / "summary.json").exists()
    with RunFolder(folder, resume=True) as place:
        assert place.latest_checkpoint() is not None
    simulate.resume(folder)
    same_bytes(whole(path), folder)


def stopped_after_its_first_checkpoint(path, folder):
    """The folder of a run that was interrupted."""
    def stop(report):
        if list((folder / "checkpoint").glob("[0-9]*.json")):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simulate.run(path, folder, progress=SimpleNamespace(update=stop))
    return folder


def test_a_checkpoint_of_another_program_is_refused_and_not_touched(place, monkeypatch):
    folder = stopped_after_its_first_checkpoint(deck(place), place / "older.run")
    with monkeypatch.context() as other:
        other.setattr(origin, "program", lambda: {"version": "0.0.9", "sources": "other"})
        with pytest.raises(FileTrouble, match=r"another version of hugoniot .*start again in a new folder: hugoniot run .*deck\.toml"):
            simulate.resume(folder)
    assert simulate.resume(folder).summary["status"] == "done"


@pytest.mark.parametrize("name", ["line", "plane"])
def test_a_checkpoint_of_another_machine_is_continued_with_a_warning(name, place, monkeypatch):
    path = place / f"{name} elsewhere.toml"
    path.write_text(DECKS[name])
    folder = stopped_after_its_first_checkpoint(path, place / f"{name} elsewhere.run")
    with monkeypatch.context() as other:
        here = machine.machine()
        other.setattr(machine, "machine", lambda: {**here, "cpu": "another"})
        events = simulate.resume(folder).events
    assert any(kind == "warning" and "a different machine" in text and here["cpu"] in text for kind, text in zip(events["kind"].values, events["text"].values))
