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
    ({"name": "dask", "time_limit": 3.0}, "not ended at a time limit"),
    ({"name": "dask", "scheduler": "tcp://127.0.0.1:1", "workers": 2}, "has its own workers"),
    ({"name": "dask", "workers": 0}, "not a number of workers"),
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
    for workers in (1, 2):
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
