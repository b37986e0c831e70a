"""Numba dispatchers of the kernels, for tests that compile loops of their own."""

from functools import cache

import numba

from hophoop.kernel.build.lowering import copied


@cache
def jitted(kernel):
    """A dispatcher of a kernel, compiled at its first call."""
    return numba.njit(nogil=True, error_model="numpy")(copied(kernel, jitted))
