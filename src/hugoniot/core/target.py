"""The CPU as the target of compiled kernels: the options each kind of kernel is compiled with.

A kernel module imports its options from here, and with them the operations of `core.ops` and the folder of compiled code, which numba
asks for when a kernel is defined. Importing this module imports numba, so only kernel modules do.
"""

import llvmlite.binding as llvm
from numba import types
from numba.core.dispatcher import _DispatcherBase

from hugoniot.core import code_files, compile_speed, mathematics  # noqa: F401  (they set numba up)
from hugoniot.core.sources import concerns_package

# A sweep is inlined wherever it is called, and so are the functions on its way up: the whole march is one piece of machine code.
# Otherwise the process that compiles runs another translation of a sweep than the ones that load the march from disk (each
# was optimised in its own surroundings), and with fast-math the two differ in the last bits.
# Kernels own no arrays (_nrt=False): counting the references to every row a sweep takes would cost more than two hundred zones do.
# Nobody calls a kernel as a C function with C's numbers (no_cfunc_wrapper), which would be made of it besides.
SWEEP = dict(_nrt=False, fastmath=True, error_model="numpy", cache=True, nogil=True, forceinline=True, no_cfunc_wrapper=True)
# A law's pass stands alone: it is called by its address, never inlined.
PASS = dict(_nrt=False, fastmath=True, error_model="numpy", cache=True, nogil=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
EXACT_PASS = {**PASS, "fastmath": False}
NAN_PASS = {**PASS, "fastmath": mathematics.NAN_LAW["fastmath"]}
INLINE = dict(_nrt=False, error_model="numpy", forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
GUARD = dict(_nrt=False, fastmath=False, error_model="numpy", cache=True, nogil=True, no_cfunc_wrapper=True)
# what Python never calls itself, which would end the process: taking large tuples of arrays from Python costs more than many a function
BY_ADDRESS = {**GUARD, "no_cpython_wrapper": True}
CURVE = {**GUARD, "_nrt": True}   # of theory, whose searches keep short lists

# A sweep touches some twenty rows of the same tables; the vectoriser proves at run time that they do not overlap and by
# default gives up, silently, when that takes more than 128 instructions.
llvm.set_option("hugoniot", "--vectorize-memory-check-threshold=100000")
# A row that a pass copies beside its other work goes through the same packed loop; by default it becomes a call of the C library that
# reads the row again, which for a piece of a hundred zones costs as much as the pass.
llvm.set_option("hugoniot", "--disable-loop-idiom-memcpy")
llvm.set_option("hugoniot", "--disable-loop-idiom-memset")


def _for_types(real):
    def get_call_template(self, args, kws):
        if concerns_package(self.py_func.__module__):
            args = tuple(types.unliteral(kind) for kind in args)
            kws = {name: types.unliteral(kind) for name, kind in kws.items()}
        return real(self, args, kws)

    return get_call_template


# A kernel that calls another with a constant would have it compiled for that very constant, and once more for the next.
_DispatcherBase.get_call_template = _for_types(_DispatcherBase.get_call_template)
