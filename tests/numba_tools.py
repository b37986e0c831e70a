"""Numba dispatchers of the kernels, for tests that compile loops of their own."""

import numba

from hophoop.kernel.build.numba_code import Namespaces, options_of


def _made(kernel, function):
    return numba.njit(nogil=True, **options_of(kernel))(function)  # noqa: TID251


_dispatchers = Namespaces(_made)


def jitted(kernel):
    """A dispatcher of a kernel, compiled at its first call."""
    return _dispatchers.of(kernel)
