"""Local workers: processes of this machine that answer cases, are ended when a case takes too long, and replaced when they die."""

import collections
import contextlib
import json
import os
import selectors
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from typing import Any

from hugoniot.campaign.worker import COMMAND, environment
from hugoniot.errors import HugoniotError

TRIES = 3                 # workers that may die over one case before it counts as failed
MOST_FALSE_STARTS = 3     # workers in a row that die before they are ready
COMPILING_SECONDS = 120.0     # more time for a case that has to compile a kernel


class _Worker:
    """One process: `case` it works on (None: idle), until when it may (`deadline`), whether it has said that it is ready."""

    def __init__(self, hello: str):
        self.errors = tempfile.TemporaryFile()      # noqa: SIM115  (closed with the worker)
        self.process = subprocess.Popen([sys.executable, "-P", "-c", COMMAND], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=self.errors, env=environment())
        self.case: int | None = None
        self.deadline, self.ready, self.waiting = float("inf"), False, b""
        self.say(hello)

    def say(self, text: str) -> None:
        stream = self.process.stdin
        with contextlib.suppress(OSError):      # one that is gone is noticed by its answer
            if stream is not None:
                stream.write(text.encode())
                stream.flush()

    def heard(self) -> list[dict] | None:
        """The messages that have come; None if the process is gone."""
        stream = self.process.stdout
        data = os.read(stream.fileno(), 1 << 20) if stream is not None else b""
        if not data:
            return None
        *lines, self.waiting = (self.waiting + data).split(b"\n")
        return [json.loads(line) for line in lines]

    def end(self) -> str:
        """Kill the process; the last of what it complained about."""
        self.process.kill()
        for stream in (self.process.stdin, self.process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()
        self.process.wait()
        self.errors.seek(0)
        lines = self.errors.read()[-2000:].decode("utf-8", "replace").strip().splitlines()
        self.errors.close()
        return lines[-1][:300] if lines else ""


class LocalPool:
    """`count` worker processes; as a context, they are gone at its end.

    question   `record` of the question they answer
    known      keys of answers that need not be worked out again
    """

    def __init__(self, question: dict, count: int, known: Iterable[str] = (), time_limit: float | None = None):
        self.hello = json.dumps({"question": question, "known": sorted(known)}) + "\n"
        self.count, self.time_limit = count, time_limit
        self.workers: list[_Worker] = []
        self.selector = selectors.DefaultSelector()
        self.false_starts, self.warm = 0, False

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for worker in list(self.workers):
            self._remove(worker)
        self.selector.close()

    def _start(self) -> _Worker:
        worker = _Worker(self.hello)
        self.workers.append(worker)
        self.selector.register(worker.process.stdout, selectors.EVENT_READ, worker)     # type: ignore[arg-type]
        return worker

    def _remove(self, worker: _Worker) -> str:
        self.workers.remove(worker)
        with contextlib.suppress(KeyError, ValueError):
            self.selector.unregister(worker.process.stdout)     # type: ignore[arg-type]
        return worker.end()

    def run(self, tasks: Iterable[tuple[int, dict[str, Any]]]) -> Iterator[dict]:
        """The answers to tasks (case, changes), in the order in which they come.

        The very first case is finished before others begin, so that kernels are compiled once. Workers stay for the next call. A case
        whose worker died is tried again, one that passes the time limit is not. Raises `HugoniotError` if workers cannot be started.
        """
        todo = _Todo(tasks)
        while todo.any():
            while len(self.workers) < (self.count if self.warm else 1) and (todo.waiting() or not self.workers):
                self._start()
            self._hand_out(todo)
            for worker, messages in self._news():
                answers = self._answers(worker, messages, todo)
                self._hand_out(todo)
                yield from answers

    def _hand_out(self, todo: "_Todo") -> None:
        """Give every idle worker a case."""
        for worker in self.workers:
            if worker.ready and worker.case is None and (self.warm or not todo.asked):
                task = todo.next()
                if task is None:
                    return
                self._ask(worker, task)

    def _answers(self, worker: _Worker, messages: Any, todo: "_Todo") -> list[dict]:
        """What a worker's news (of `_news`) answer."""
        lost = worker.case
        if messages is None:
            return self._died(worker, todo)
        if messages == "late":
            todo.asked.pop(lost)
            return [{"case": lost, "late": self.time_limit}]
        found = [message for message in messages if "case" in message]
        for message in found:
            self.warm = True
            todo.asked.pop(message["case"])
        return found

    def _ask(self, worker: _Worker, task: tuple[int, dict]) -> None:
        worker.case = task[0]
        worker.deadline = time.monotonic() + self.time_limit if self.time_limit else float("inf")
        worker.say(json.dumps({"case": task[0], "changes": task[1]}) + "\n")

    def _news(self) -> list[tuple[_Worker, Any]]:
        """What has happened: (worker, its messages; None if it died; "late" if it was ended at the time limit)."""
        now = time.monotonic()
        nearest = min((worker.deadline for worker in self.workers), default=float("inf"))
        found: list[tuple[_Worker, Any]] = []
        for key, _ in self.selector.select(max(0.0, min(nearest - now, 1.0))):
            worker = key.data
            messages = worker.heard()
            for message in messages or ():
                if "ready" in message:
                    worker.ready, self.false_starts = True, 0
                elif "compiling" in message:
                    worker.deadline += COMPILING_SECONDS if self.time_limit else 0.0
                elif message.get("case") == worker.case:
                    worker.case, worker.deadline = None, float("inf")
            found.append((worker, messages))
        now = time.monotonic()
        heard = [worker for worker, _ in found]
        for worker in [w for w in self.workers if w.case is not None and w.deadline <= now and w not in heard]:
            self._remove(worker)
            found.append((worker, "late"))
        return found

    def _died(self, worker: _Worker, todo: "_Todo") -> list[dict]:
        """Answer or ask again the case whose worker has died; `HugoniotError` if workers never get ready."""
        words = self._remove(worker)
        if not worker.ready:
            self.false_starts += 1
            if self.false_starts >= MOST_FALSE_STARTS:
                raise HugoniotError(f"the worker processes of the sweep failed to start: {words or 'they exited without a message'}")
        if worker.case is None or todo.again(worker.case):
            return []
        return [{"case": worker.case, "died": f"its process died {TRIES} times" + (f": {words}" if words else "")}]


class _Todo:
    """The tasks: those still to come, those being worked on (`asked`), those to try again."""

    def __init__(self, tasks: Iterable[tuple[int, dict]]):
        self.source, self.open = iter(tasks), True
        self.retried: collections.deque = collections.deque()
        self.deaths: collections.Counter = collections.Counter()
        self.asked: dict[int, tuple[int, dict]] = {}

    def waiting(self) -> bool:
        """Whether there may be a task that nobody works on."""
        return self.open or bool(self.retried)

    def any(self) -> bool:
        """Whether anything is left to do or to wait for."""
        return self.waiting() or bool(self.asked)

    def next(self) -> tuple[int, dict] | None:
        """The next task, which is now being worked on; None if there is none."""
        task = self.retried.popleft() if self.retried else next(self.source, None)
        if task is None:
            self.open = False
        else:
            self.asked[task[0]] = task
        return task

    def again(self, case: int) -> bool:
        """Put a case whose worker died back; False if it has killed too many."""
        task = self.asked.pop(case)
        self.deaths[case] += 1
        if self.deaths[case] < TRIES:
            self.retried.append(task)
        return self.deaths[case] < TRIES
