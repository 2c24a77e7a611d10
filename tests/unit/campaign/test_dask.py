"""The workers of a Dask cluster give the table of local ones, with one thread each, also where one of them is killed."""

import json
import os
import signal
import subprocess
import sys

import pytest

from hugoniot.campaign.ask import Wishes, engine_of, run_sweep
from hugoniot.campaign.sweep import CASES, TABLE
from hugoniot.errors import DeckError, HugoniotError


@pytest.mark.parametrize("asked, words", [
    ({"name": "ray"}, "unknown engine"),
    ({"name": "local", "scheduler": "tcp://127.0.0.1:1"}, "add --engine dask"),
    ({"name": "dask", "time_limit": 0.0}, "not a time"),
    ({"name": "dask", "scheduler": "tcp://127.0.0.1:1", "workers": 2}, "has its own workers"),
    ({"name": "dask", "workers": 0}, "not a valid number of workers"),
])
def test_engines_that_are_refused(asked, words):
    with pytest.raises(DeckError, match=words):
        engine_of(**asked)


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(DeckError, match="pip install 'hugoniot.cluster.'"):
        engine_of("dask")({}, ())


def test_a_case_is_answered_with_one_thread(deck):
    """In a process of its own, as Dask starts it: the number of threads is a setting of the whole process."""
    from hugoniot.campaign.questions import Deck

    hello = json.dumps({"question": Deck(deck.read_text(), deck.name).record(), "known": []})
    code = "import sys; from hugoniot.campaign import dask_pool; print(dask_pool.answer(*sys.argv[1:]))"
    told = subprocess.run([sys.executable, "-c", code, hello, json.dumps({"region.flyer.velocity": "650 m/s"})], capture_output=True, text=True)
    found = json.loads(told.stdout)
    assert found["threads"] == 1 and found["numbers"]["free surface.peak_velocity"] == pytest.approx(650.0, rel=0.1)


@pytest.mark.slow
def test_a_cluster_gives_the_table_of_one_process(deck, tmp_path, inline):
    distributed = pytest.importorskip("distributed")
    wishes = Wishes(vary=["region.flyer.velocity = 400..900 m/s : 12"])
    run_sweep(deck, wishes, tmp_path / "inline", engine=inline, report=False)
    wanted = [(tmp_path / "inline" / name).read_bytes() for name in (CASES, TABLE)]
    for workers in (1, 2, 4):
        out = tmp_path / str(workers)
        run_sweep(deck, wishes, out, engine=engine_of("dask", workers=workers), report=False)
        assert [(out / name).read_bytes() for name in (CASES, TABLE)] == wanted
    with distributed.LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None, host="127.0.0.1") as cluster:
        killed = []

        def kill_one(progress):
            if not killed and progress.done == 3:
                killed.append(next(iter(cluster.workers.values())).pid)
                os.kill(killed[0], signal.SIGKILL)

        out = tmp_path / "killed"
        run_sweep(deck, wishes, out, engine=engine_of("dask", cluster.scheduler_address), show=kill_one, report=False)
        assert killed and [(out / name).read_bytes() for name in (CASES, TABLE)] == wanted
        address = cluster.scheduler_address
    with pytest.raises(HugoniotError, match="does not answer"):
        run_sweep(deck, wishes, tmp_path / "lost", engine=engine_of("dask", address), report=False)


def test_a_case_that_hangs_is_ended_inside_a_worker(deck):
    """What a worker of a cluster calls: the process it keeps for its cases is ended at the limit, and the next case has another."""
    from hugoniot.campaign import dask_pool
    from hugoniot.campaign.questions import Deck

    slow = deck.read_text().replace("zones = 16", "zones = 16000")
    hello = json.dumps({"question": Deck(slow, deck.name).record(), "known": []})
    try:
        answers = [json.loads(dask_pool.answer(hello, json.dumps(changes), 0.5)) for changes in
                   ({"region.target.zones": 16}, {}, {"region.target.zones": 12})]
    finally:
        for pool in dask_pool._questions.values():
            pool.__exit__()
        dask_pool._questions.clear()
    assert ["numbers" in a for a in answers] == [True, False, True] and answers[1]["late"] == 0.5


def _started(module, *arguments):
    return subprocess.Popen([sys.executable, "-m", f"distributed.cli.{module}", *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                            env=os.environ | {"DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "10s"})


@pytest.mark.slow
def test_a_sweep_goes_on_when_its_scheduler_is_back(deck, tmp_path, inline):
    pytest.importorskip("distributed")
    import socket

    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    wishes = Wishes(vary=["region.flyer.velocity = 400..900 m/s : 40"])
    run_sweep(deck, wishes, tmp_path / "inline", engine=inline, report=False)
    wanted, out = [(tmp_path / "inline" / name).read_bytes() for name in (CASES, TABLE)], tmp_path / "s"

    def cluster():
        scheduler = _started("dask_scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
        return scheduler, [_started("dask_worker", address, "--nthreads", "1", "--no-dashboard", "--death-timeout", "20") for _ in range(2)]

    began = cluster()

    def kill_it(progress):
        if progress.done == 5:
            began[0].kill()

    try:
        with pytest.raises(HugoniotError, match="the scheduler was lost"):
            run_sweep(deck, wishes, out, engine=engine_of("dask", address), show=kill_it, report=False)
    finally:
        for process in (began[0], *began[1]):
            process.kill()
            process.wait()
    again = cluster()
    try:
        found = run_sweep(deck, wishes, out, engine=engine_of("dask", address), report=False)
    finally:
        for process in (again[0], *again[1]):
            process.kill()
            process.wait()
    assert found.progress.known >= 5 and [(out / name).read_bytes() for name in (CASES, TABLE)] == wanted
