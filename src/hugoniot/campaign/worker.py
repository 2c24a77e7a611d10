"""A process that answers the cases of a sweep one after the other: lines of JSON in, lines of JSON out.

It loads compiled code once, computes with one thread, and ends as soon as whoever started it is gone.
"""

import gc
import json
import os
import queue
import signal
import sys
import threading

from hugoniot.errors import HugoniotError

ONE_THREAD = ("NUMBA_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
# keep the memory of a case for the next one: else the records of each come as new pages from the system (glibc)
KEPT_MEMORY = {"MALLOC_MMAP_THRESHOLD_": str(2**28), "MALLOC_TRIM_THRESHOLD_": str(2**29)}
COMMAND = "from hugoniot.campaign.worker import serve; serve()"


def single_threaded() -> int:
    """How many threads numba may use here; `HugoniotError` if more than one, for then workers would fight for the cores."""
    import numba

    threads = numba.config.NUMBA_NUM_THREADS    # type: ignore[attr-defined]
    if threads != 1:
        raise HugoniotError(f"a worker of a sweep computes with one thread, but NUMBA_NUM_THREADS is {threads}: set it to 1")
    return threads


def environment() -> dict[str, str]:
    """The variables a worker starts with."""
    return KEPT_MEMORY | os.environ | dict.fromkeys(ONE_THREAD, "1")


def serve() -> None:
    """Answer the questions that come on the standard input until it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)     # Ctrl-C is answered by whoever started the workers
    out = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1)
    os.dup2(2, 1)       # nothing else may write between the answers

    def say(message: dict) -> None:
        try:
            out.write(json.dumps(message) + "\n")
            out.flush()
        except OSError:
            os._exit(0)

    asked: queue.SimpleQueue = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(asked,), daemon=True).start()
    hello = json.loads(asked.get())
    from hugoniot.campaign.questions import question_of
    from hugoniot.core.compile_watch import when_compiling, without_linear_algebra

    without_linear_algebra()
    question, known = question_of(hello["question"]), set(hello.get("known", ()))
    with when_compiling(lambda news: say({"compiling": news.kernel})):
        question.warm()
        gc.freeze()     # what is loaded stays: nobody need look whether it is still in use
        say({"ready": os.getpid(), "threads": single_threaded()})
        while True:
            task = json.loads(asked.get())
            say({"case": task["case"], **question.answer(task["changes"], known)})


def _listen(asked: queue.SimpleQueue) -> None:
    """Pass lines on; at the end of the input end the process, whatever it is doing."""
    for line in sys.stdin:
        asked.put(line)
    os._exit(0)
