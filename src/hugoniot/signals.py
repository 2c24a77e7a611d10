"""A request to end is answered as Ctrl-C is: with a checkpoint."""

import contextlib
import signal
import threading


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
    signal.signal(wanted, lambda number, frame: signal.raise_signal(signal.SIGINT))
    try:
        yield
    finally:
        signal.signal(wanted, signal.SIG_DFL)
