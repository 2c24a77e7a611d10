"""A request to end is answered as Ctrl-C is: with a checkpoint."""

import contextlib
import signal
import threading


def interrupt(number, frame):
    """What SIGTERM does while `end_like_interrupt` is on, also where Ctrl-C is ignored, as in what a script starts in the background."""
    raise KeyboardInterrupt


@contextlib.contextmanager
def end_like_interrupt():
    """While the block runs, SIGTERM (a batch system's, a shutdown's) does what SIGINT does.

    Only in the main thread, and only where nobody else has taken the signal.
    """
    wanted = getattr(signal, "SIGTERM", None)
    ours = wanted is not None and threading.current_thread() is threading.main_thread() and signal.getsignal(wanted) is signal.SIG_DFL
    if not ours:
        yield
        return
    signal.signal(wanted, interrupt)
    try:
        yield
    finally:
        signal.signal(wanted, signal.SIG_DFL)
