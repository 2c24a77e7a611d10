"""Workers of a cluster: cases are handed to a `dask.distributed` scheduler, one that runs already or one of this machine.

Only texts (JSON) travel. Every worker process answers one case at a time with one thread, whatever it was started with: Dask limits the
threads of OpenMP and BLAS, not those of Numba. A worker that dies is the scheduler's to replace; what was answered stands in the journal.
With a time limit, a worker has a process of its own for the cases (`campaign.pool`), which can be ended where the worker could not.
"""

import atexit
import json
import os
import threading
from collections.abc import Iterable, Iterator
from typing import Any

from hugoniot.campaign.pool import LocalPool
from hugoniot.campaign.worker import ONE_THREAD
from hugoniot.errors import DeckError, HugoniotError

IN_FLIGHT = 4            # cases handed out for each worker thread: enough that none waits, few enough that memory stays flat
START_SECONDS = 20.0     # for a scheduler to answer
LOST = "the scheduler was lost; finished cases are kept, and the same command continues once it is back"

_one_at_a_time = threading.Lock()
_questions: dict[Any, Any] = {}     # of this process, made once


def answer(hello: str, changes: str, time_limit: float | None = None) -> str:
    """The answer of a worker to a case, as JSON: what `worker.serve` does, for processes that Dask has started."""
    with _one_at_a_time:
        if time_limit is not None:
            return json.dumps(_limited(hello, time_limit, json.loads(changes)))
        for name in ONE_THREAD:
            os.environ.setdefault(name, "1")
        import numba

        if numba.get_num_threads() > 1:
            numba.set_num_threads(1)
        if hello not in _questions:
            from hugoniot.campaign.questions import question_of

            record = json.loads(hello)
            _questions.clear()
            _questions[hello] = question_of(record["question"]), set(record["known"])
        question, known = _questions[hello]
        return json.dumps({**question.answer(json.loads(changes), known), "threads": numba.get_num_threads()})


def _limited(hello: str, time_limit: float, changes: dict) -> dict:
    """The answer of the process that this worker keeps for its cases; `late` where it had to be ended."""
    if (hello, time_limit) not in _questions:
        for pool in [each for each in _questions.values() if isinstance(each, LocalPool)]:
            pool.__exit__()
        _questions.clear()
        record = json.loads(hello)
        pool = _questions[hello, time_limit] = LocalPool(record["question"], 1, record["known"], time_limit)
        atexit.register(pool.__exit__)
    return next(iter(_questions[hello, time_limit].run([(0, changes)])))


class DaskPool:
    """As `pool.LocalPool`, over the workers of a scheduler.

    count       workers of a cluster on this machine, if no scheduler is given
    scheduler   address such as tcp://10.0.0.1:8786
    time_limit  seconds a case may take
    Raises `DeckError` where dask.distributed is missing, `HugoniotError` for a scheduler that does not answer.
    """

    def __init__(self, question: dict, count: int, known: Iterable[str] = (), scheduler: str | None = None,
                 time_limit: float | None = None):
        try:
            import distributed
        except ImportError:
            raise DeckError.single("command line", None, "--engine dask", "dask.distributed is not installed",
                                   "install it with: pip install 'hugoniot[cluster]'") from None
        self.hello = json.dumps({"question": question, "known": sorted(known)})
        self.distributed, self.count, self.scheduler, self.time_limit = distributed, count, scheduler, time_limit
        self.cluster: Any = None
        self.client: Any = None
        self.warm = False

    def __enter__(self):
        client = self.distributed.Client
        try:
            if self.scheduler is None:
                self.cluster = self.distributed.LocalCluster(
                    n_workers=self.count, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0", silence_logs=50,
                    host="127.0.0.1", env=dict.fromkeys(ONE_THREAD, "1"))
                self.client = client(self.cluster)
            else:
                self.client = client(self.scheduler, timeout=START_SECONDS)
        except (OSError, TimeoutError, ValueError) as error:
            self.__exit__()
            raise HugoniotError(f"the scheduler {self.scheduler or 'of this machine'} does not answer: {error}") from None
        return self

    def __exit__(self, *_):
        for each in (self.client, self.cluster):
            if each is not None:
                each.close()

    @property
    def dashboard(self) -> str:
        """Address of the scheduler's own page; "" if it has none."""
        return str(getattr(self.client, "dashboard_link", "") or "")

    def run(self, tasks: Iterable[tuple[int, dict[str, Any]]]) -> Iterator[dict]:
        """The answers to tasks (case, changes), in the order in which they come; the very first is finished before others begin.

        Raises `HugoniotError` if the scheduler is lost.
        """
        source = iter(tasks)
        first = next(source, None)
        if first is None:
            return
        waiting = self.distributed.as_completed([self._submitted(first)])
        for future in waiting:
            yield self._answer(future)
            room = IN_FLIGHT * self._threads()
            for _ in range(max(1, room - waiting.count())):
                task = next(source, None)
                if task is None:
                    break
                waiting.add(self._submitted(task))

    def _threads(self) -> int:
        """Of all workers now, one at least."""
        try:
            return max(1, sum(self.client.nthreads().values())) if self.client is not None else 1
        except (OSError, TimeoutError):
            raise HugoniotError(LOST) from None

    def _submitted(self, task: tuple[int, dict[str, Any]]):
        if self.client is None:
            raise HugoniotError("there is no connection to the cluster: use the pool in a with statement")
        future = self.client.submit(answer, self.hello, json.dumps(task[1]), self.time_limit, pure=False)
        future.case = task[0]       # type: ignore[attr-defined]
        return future

    def _answer(self, future) -> dict:
        case = future.case
        if future.status == "finished":
            found = json.loads(future.result())
            found.pop("threads", None)
            return {**found, "case": case}
        if future.status == "error" and type(future.exception()).__name__ == "KilledWorker":
            return {"case": case, "died": "its worker process died at every attempt"}
        if future.status == "error":
            raise HugoniotError(f"a worker of the cluster failed: {future.exception()}")
        raise HugoniotError(LOST)
