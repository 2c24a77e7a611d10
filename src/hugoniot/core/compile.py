"""Binds the plain scalar laws to compiled sweeps: importing this module imports numba, so only kernel modules do.

* Inside a kernel a call such as `pressure(rho, e, par)` is resolved by the class of `par`, at compile time, to that law's
  own function and inlined. One kernel source therefore serves every law, each specialisation is compiled once and kept on
  disk, and no closure or function pointer stands in the way of the vectoriser (`kernels/README.md`, items 3, 6, 7).
* The cache folder is named after a hash of the package's sources: an edit anywhere in the package can never meet stale
  machine code (numba itself only watches the file that holds the kernel).
"""

import hashlib
import math
import os
import pathlib
import re
import sys
import types as pytypes
from collections.abc import Callable

import llvmlite.binding as llvm
import numba as nb
import numpy as np
from llvmlite import ir
from numba import types
from numba.core import caching, event
from numba.extending import intrinsic, overload

from hugoniot.core import ops
from hugoniot.core.registry import Registry

LAW = dict(fastmath=True, error_model="numpy", forceinline=True)
# fused multiply-add only (it rounds once where two roundings stood): exp and log keep their error and gain a factor 1.6
EXACT_LAW = dict(fastmath={"contract"}, error_model="numpy", forceinline=True)
# A sweep is inlined wherever it is called, and so are the functions on its way up: the whole march is one piece of machine code.
# Otherwise the process that compiles runs another translation of a sweep than the ones that load the march from disk (each
# was optimised in its own surroundings), and with fast-math the two differ in the last bits.
# Kernels own no arrays (_nrt=False): counting the references to every row a sweep takes would cost more than two hundred zones do.
SWEEP = dict(_nrt=False, fastmath=True, error_model="numpy", cache=True, nogil=True, forceinline=True)
# A law's pass stands alone: it is called by its address, never inlined.
PASS = dict(_nrt=False, fastmath=True, error_model="numpy", cache=True, nogil=True)
EXACT_PASS = {**PASS, "fastmath": False}
INLINE = dict(_nrt=False, error_model="numpy", forceinline=True)
GUARD = dict(_nrt=False, fastmath=False, error_model="numpy", cache=True, nogil=True)
CURVE = {**GUARD, "_nrt": True}   # of theory, whose searches keep short lists

# A sweep touches some twenty rows of the same tables; the vectoriser proves at run time that they do not overlap and by
# default gives up, silently, when that takes more than 128 instructions.
llvm.set_option("hugoniot", "--vectorize-memory-check-threshold=100000")


def source_hash() -> str:
    """SHA-256 of every Python source of the package, shortened: the name of the compiled code's folder."""
    root = pathlib.Path(__file__).resolve().parents[1]
    digest = hashlib.sha256(f"{sys.version_info[:2]} {nb.__version__}".encode())
    for room in ("core", "laws", "mesh", "theory", "solvers"):
        for path in sorted((root / room).rglob("*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def cache_root() -> pathlib.Path:
    """Folder of the compiled code: HUGONIOT_CACHE, else the user's cache folder."""
    if named := os.environ.get("HUGONIOT_CACHE"):
        return pathlib.Path(named)
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return pathlib.Path(home) / "hugoniot"


def _use_cache_folder():
    if os.environ.get("NUMBA_CACHE_DIR"):
        return pathlib.Path(os.environ["NUMBA_CACHE_DIR"])
    folder = cache_root() / source_hash()
    nb.core.config.CACHE_DIR = str(folder)
    return folder


CACHE_FOLDER = _use_cache_folder()
_whole_index = caching.IndexDataCacheFile._load_index


def _known_index(self):
    """Index of a kernel's compiled code; empty where it names a law that this process does not have, such as one of a test or a script.

    The index is read whole: one class that cannot be imported would keep every run from its own compiled code.
    """
    try:
        return _whole_index(self)
    except (ImportError, AttributeError):
        return {}


caching.IndexDataCacheFile._load_index = _known_index


class _Teller(event.Listener):
    def __init__(self, tell: Callable[[], None]):
        self.tell, self.told = tell, False

    def on_start(self, event):
        if not self.told:
            self.told = True
            self.tell()

    def on_end(self, event):
        """Nothing to tell."""


def when_compiling(tell: Callable[[], None]):
    """A context in which `tell` is called, once, when a kernel has to be compiled because it is not in the folder of compiled code."""
    return event.install_listener("numba:compile", _Teller(tell))


def without_linear_algebra() -> None:
    """Keep numba from reading scipy's, which takes a tenth of a second and which no kernel of ours asks for.

    For processes that are the program's own: a user's kernels may want it.
    """
    from numba.np import linalg

    def refused():
        raise ImportError("hugoniot's own processes do without linear algebra in kernels")

    linalg.ensure_blas = refused


# -- operations that keep a sweep vectorised ---------------------------------------------------------------------
def _select(operator):
    @intrinsic
    def select(typingctx, a, b):
        def codegen(context, builder, signature, args):
            chosen = builder.fcmp_ordered(operator, args[0], args[1], flags=("fast",))
            return builder.select(chosen, args[0], args[1], flags=("fast",))
        return types.float64(types.float64, types.float64), codegen
    return select


_select_min, _select_max = _select("<"), _select(">")


@overload(ops.fmin, jit_options=LAW)
def _(a, b):
    return lambda a, b: _select_min(np.float64(a), np.float64(b))


@overload(ops.fmax, jit_options=LAW)
def _(a, b):
    return lambda a, b: _select_max(np.float64(a), np.float64(b))


@overload(ops.vsqrt, jit_options=LAW)
def _(x):
    return lambda x: math.sqrt(x)


@intrinsic
def _times_reciprocal(typingctx, x, y):
    def codegen(context, builder, signature, args):
        # without fast-math flags, with which the two would be made one division again
        return builder.fmul(args[0], builder.fdiv(ir.Constant(ir.DoubleType(), 1.0), args[1]))
    return types.float64(types.float64, types.float64), codegen


@overload(ops.late_over, jit_options=LAW)
def _(x, y):
    return lambda x, y: _times_reciprocal(np.float64(x), np.float64(y))


@overload(ops.vexp, jit_options=EXACT_LAW)
def _(x):
    def vexp(x):
        x = ops.fmin(ops.fmax(x, -708.0), 709.0)
        k = math.floor(x * 1.4426950408889634 + 0.5)
        r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10
        # Taylor polynomial of degree 13 in Horner form on |r| < log(2)/2: remainder below 1e-17
        y = 1.0 + r * (1.0 + r * (1 / 2 + r * (1 / 6 + r * (1 / 24 + r * (1 / 120 + r * (1 / 720 + r * (
            1 / 5040 + r * (1 / 40320 + r * (1 / 362880 + r * (1 / 3628800 + r * (1 / 39916800 + r * (
                1 / 479001600 + r * (1 / 6227020800)))))))))))))
        return y * np.int64((np.int64(k) + 1023) << 52).view(np.float64)
    return vexp


@overload(ops.vlog, jit_options=EXACT_LAW)
def _(x):
    def vlog(x):
        bits = np.float64(x).view(np.int64)
        mantissa = np.int64((bits & 0x000FFFFFFFFFFFFF) | 0x3FF0000000000000).view(np.float64)
        exponent = np.float64((bits >> 52) - 1023)
        large = mantissa > 1.4142135623730951
        mantissa = 0.5 * mantissa if large else mantissa
        exponent = exponent + 1.0 if large else exponent
        f = mantissa - 1.0
        s = f / (2.0 + f)
        z = s * s
        tail = z * (2 / 3 + z * (2 / 5 + z * (2 / 7 + z * (2 / 9 + z * (2 / 11 + z * (2 / 13 + z * (2 / 15 + z * (
            2 / 17 + z * (2 / 19 + z * (2 / 21 + z * (2 / 23)))))))))))
        # log(1+f) = f - s (f - tail): no cancellation near x = 1
        return exponent * 6.93147180369123816490e-01 + (f - s * (f - tail) + exponent * 1.90821492927058770002e-10)
    return vlog


# -- laws --------------------------------------------------------------------------------------------------------
_bound: set = set()


def bind(function, **options):
    """Let kernels call a plain scalar function, inlined, through its undecorated name."""
    if function in _bound:
        return function
    _bound.add(function)
    overload(function, jit_options=options or LAW, strict=False)(lambda *args: function)
    return function


bind(ops.vpow)


def bind_module(module):
    """Bind every plain function of a module, and the modules it imports functions from that declare `KERNEL_HELPERS = True`."""
    helpers = set()
    for value in list(vars(module).values()):
        if not isinstance(value, pytypes.FunctionType):
            continue
        if value.__module__ == module.__name__:
            bind(value)
        elif getattr(sys.modules[value.__module__], "KERNEL_HELPERS", False):
            helpers.add(value.__module__)
    for name in helpers:
        bind_module(sys.modules[name])


def bind_dispatch(generic, family: Registry, name: str, position: int = -1):
    """Resolve `generic(...)` inside kernels by the class of the parameter tuple at `position` among its arguments.

    `generic` is the plain function of the same meaning that dispatches in Python; `name` is the contract name.
    """
    if generic in _bound:
        return
    _bound.add(generic)

    def resolve(*args):
        cls = getattr(args[position], "instance_class", None)
        law = family.of_class(cls) if cls is not None else None
        return None if law is None else law.functions.get(name)

    overload(generic, jit_options=LAW, strict=False)(resolve)


def bind_choice(generic, choose):
    """Resolve `generic(...)` inside kernels by the function `choose` returns for the argument classes (None where not a tuple).

    For what depends on facts about several laws at once, such as a flag of one and a function of another.
    """
    if generic in _bound:
        return
    _bound.add(generic)

    def resolve(*args):
        return choose(*(getattr(arg, "instance_class", None) for arg in args))

    overload(generic, jit_options=LAW, strict=False)(resolve)


def bind_family(family: Registry, generics: dict):
    """Bind all law files of a family and its generic functions (contract name -> plain dispatching function)."""
    for name, generic in generics.items():
        bind_dispatch(generic, family, name)
    for law in family:
        bind_module(law.module)


# -- parameters from a table -------------------------------------------------------------------------------------
@intrinsic
def parameters(typingctx, proto, row):
    """A parameter tuple of the class of `proto` with its float fields read in order from the 1-D array `row`.

    Fields that are not floats (tables) are taken from `proto` itself. Lets one compiled sweep serve any number of
    materials of one law: their numbers live in an array, only the law's class is part of the compiled type.
    """
    def codegen(context, builder, signature, args):
        array = context.make_array(signature.args[1])(context, builder, args[1])
        column = 0

        def fill(kind, value):
            nonlocal column
            parts = []
            for i, field in enumerate(kind.types):
                inner = builder.extract_value(value, i)
                if field == types.float64:
                    pointer = builder.gep(array.data, [context.get_constant(types.intp, column)])
                    parts.append(builder.load(pointer))
                    column += 1
                else:
                    parts.append(fill(field, inner) if isinstance(field, types.BaseTuple) else inner)
            return context.make_tuple(builder, kind, parts)

        return fill(signature.return_type, args[0])

    return proto(proto, row), codegen


@intrinsic
def rows_apart(typingctx):
    """Promise that the float arrays a function takes as arguments do not overlap; said once, at the top of a sweep over rows of a table.

    Without the promise the vectoriser compares every pair of rows each time the sweep is entered, most of a microsecond for
    twenty-five rows, and must store what it has only read.
    """
    def codegen(context, builder, signature, args):
        for argument in builder.function.args[2:]:   # after the return value and the exception
            if isinstance(argument.type, ir.PointerType) and argument.type.pointee == ir.DoubleType():
                argument.add_attribute("noalias")
        return context.get_dummy_value()

    return types.void(), codegen


def float_row(par) -> list[float]:
    """The float fields of a parameter tuple in order, nested laws included: one row of the table that `parameters` reads."""
    row: list[float] = []
    for value in par:
        if isinstance(value, tuple):
            row += float_row(value)
        elif isinstance(value, (int, float)):
            row.append(float(value))
    return row


def packed(dispatcher, signature=None) -> dict[str, int]:
    """How many packed (AVX-512 or AVX2) divisions, square roots and fused products a kernel's machine code holds."""
    text = dispatcher.inspect_asm(signature or dispatcher.signatures[0])
    return {op: len(re.findall(rf"\sv{op}\w*pd[^\n]*[yz]mm", text)) for op in ("div", "sqrt", "fmadd", "fnmadd")}
