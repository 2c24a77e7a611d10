"""The operations of `core.ops` inside kernels of the CPU, in forms that the vectoriser keeps, and the options of scalar functions.

Importing this module imports numba.
"""

import math

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload

from hugoniot.core import ops

# the options of a scalar function, which becomes part of the kernel that calls it
LAW = dict(fastmath=True, error_model="numpy", forceinline=True, no_cfunc_wrapper=True)
# without the promise that every number is a finite one: for what is looked over afterwards
NAN_LAW = {**LAW, "fastmath": {"contract", "reassoc", "arcp", "nsz"}}
# fused multiply-add only (it rounds once where two roundings stood): exp and log keep their error and gain a factor 1.6
EXACT_LAW = {**LAW, "fastmath": {"contract"}}


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


@overload(ops.vpow, jit_options=LAW)
def _(x, y):
    return ops.vpow
