"""How the tests compile: every kernel once for all workers, and outside of them.

A process that compiles keeps some megabytes for every kernel, which numba never gives back, and two workers that begin with an empty
folder of compiled code would compile the same kernels at once. Here a kernel that is not kept yet is compiled by a fork of the worker,
which writes it to the folder, while whoever wants the same kernel waits; then it is read from there, which costs next to nothing. The fork
stays for the next kernels, which share their functions with those before; after `MOST` of them another takes its place.
"""

import contextlib
import gc
import hashlib
import itertools
import os
import pickle
import signal
import tempfile
import threading
import weakref
from multiprocessing import Pipe

try:
    import fcntl
except ImportError:     # no Unix
    fcntl = None

OWN = 8         # kernels that a process compiles itself, so that its forks need not begin with what all kernels have in common
MOST = 80       # kernels that one fork compiles
KNOWN, UNKNOWN = b"known", b"unknown"
_numbers = itertools.count()
_numbered: weakref.WeakValueDictionary = weakref.WeakValueDictionary()      # whatever compiles kernels, by a number that forks know it by
_own = 0
_fork: "Fork | None" = None
_here = False


class Fork:
    """A copy of this process that compiles what it is asked for and keeps nothing of this process open."""

    def __init__(self):
        self.pipe, theirs = Pipe()
        self.left, self.owner = MOST, os.getpid()
        self.process = os.fork()
        if self.process == 0:
            try:
                _serve(theirs.fileno())
            finally:
                os._exit(0)
        theirs.close()

    def compiles(self, number: int, signature: tuple, path) -> bool:
        """Whether it knows what has this number, and so has compiled its kernel into the file, unless that cannot be compiled."""
        self.left -= 1
        with contextlib.suppress(OSError, EOFError, pickle.PicklingError, TypeError):
            self.pipe.send_bytes(pickle.dumps((number, signature, path)))
            return self.pipe.recv_bytes() == KNOWN
        return False

    def end(self):
        self.pipe.close()
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(self.process, signal.SIGKILL)
            os.waitpid(self.process, 0)


def here() -> None:
    """Let this process, itself a fork, compile what it needs."""
    global _here
    _here = True


def _serve(pipe: int) -> None:
    """Compile what arrives, until nobody is at the other end."""
    from multiprocessing.connection import Connection

    here()
    gc.freeze()         # a collection would touch, and so copy, all memory
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    null = os.open(os.devnull, os.O_RDWR)
    for standard in range(3):       # whatever is wrong is said by the process that compiles it again
        os.dup2(null, standard)
    os.closerange(3, pipe)          # among them the locks of run folders and of kernels, and the other end
    os.closerange(pipe + 1, 4096)
    worker = Connection(pipe)
    while True:
        asked, answer = worker.recv_bytes(), UNKNOWN
        with contextlib.suppress(Exception):
            number, signature, path = pickle.loads(asked)
            compiler = _numbered[number]
            if _path(compiler, signature) == path:      # what it depends on is as it is there
                answer = KNOWN
                compiler.compile.real(compiler, *signature)
        worker.send_bytes(answer)


@contextlib.contextmanager
def _alone(path):
    """Whoever wants the kernel of this file too waits until the block ends."""
    folder = os.path.join(tempfile.gettempdir(), f"hugoniot-compiling-{os.getuid()}")
    os.makedirs(folder, mode=0o700, exist_ok=True)
    with open(os.path.join(folder, hashlib.sha256(os.fsencode(path)).hexdigest()[:40]), "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _path(compiler, signature: tuple):
    """File that the kernel belongs in; None if it belongs in none."""
    from hugoniot.core import code_files

    function, target = (compiler.py_func, compiler.targetctx) if hasattr(compiler, "py_func") else \
        (compiler._pyfunc, compiler._targetdescr.target_context)
    cache = compiler._cache
    if not isinstance(getattr(cache, "_cache_file", None), code_files.CodeFile):
        return None
    return code_files.path_of(function, cache._index_key(signature[0] if signature else compiler._sig, target.codegen()))


def _elsewhere(number: int, signature: tuple, path) -> None:
    """Have a kernel compiled by the fork; by another one where what it is made from is younger than the first.

    A process with threads, besides the one that hears from pytest-xdist, is not forked: it compiles what a fork it has does not.
    """
    global _fork
    if (_fork is not None and _fork.left and _fork.compiles(number, signature, path)) or threading.active_count() > 2:
        return
    if _fork is not None:
        _fork.end()
    _fork = Fork()
    _fork.compiles(number, signature, path)


def _compiled_once(real):
    from numba.core.compiler_lock import global_compiler_lock
    from numba.core.targetconfig import ConfigStack

    def compile(self, *signature):
        global _own
        with global_compiler_lock:      # taken first by everybody, so that no two threads wait for each other
            if _fork is not None and _fork.owner != os.getpid() and not _here:      # a fork of a test's own
                return real(self, *signature)
            if signature and tuple(signature[0] if isinstance(signature[0], tuple) else signature[0].args) in self.overloads:
                return real(self, *signature)
            path = _path(self, signature)
            if path is None or path.exists():
                return real(self, *signature)
            with _alone(path):
                # a kernel within one that this process compiles stays here: a fork made now would believe itself within that one for ever
                if not path.exists() and not _here and ConfigStack.top_or_none() is None:
                    _own += 1
                    if _own > OWN:
                        _elsewhere(self._number, signature, path)
                return real(self, *signature)

    compile.real = real
    return compile


def _number_all(kind) -> None:
    """Give whatever compiles kernels a number, in the order in which it is made."""
    begin = kind.__init__

    def __init__(self, *args, **options):
        begin(self, *args, **options)
        self._number = next(_numbers)
        _numbered[self._number] = self

    kind.__init__ = __init__


def begin() -> None:
    """Let this process compile in this way from now on; where there are no forks, as always."""
    if fcntl is None:
        return
    from numba.core.ccallback import CFunc
    from numba.core.dispatcher import Dispatcher

    for kind in Dispatcher, CFunc:
        _number_all(kind)
        kind.compile = _compiled_once(kind.compile)


def end() -> None:
    """Let the fork go."""
    global _fork
    if _fork is not None and _fork.owner == os.getpid():
        _fork.end()
        _fork = None
