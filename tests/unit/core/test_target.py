"""What kernels are compiled for."""

import numba as nb

from hugoniot.core.target import GUARD


def test_a_kernel_that_is_called_with_constants_is_compiled_for_their_type():
    options = {**GUARD, "cache": False}

    @nb.njit(**options)
    def part(x, k, whole):
        return x**k if whole else x

    @nb.njit(**options)
    def both(x):
        return part(x, 2, True) + part(x, 3, True) + part(x, 3, False)

    assert both(2.0) == 14.0
    assert part.signatures == [(nb.float64, nb.int64, nb.boolean)]
