"""Numba dispatchers of the kernels, for users' own compiled loops. Requires Numba (extra `jit`)."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any

from hophoop._support.extras import need

need("numba", "jit")

import numba  # noqa: E402

from hophoop.kernel.build.numba_code import Namespaces, options_of  # noqa: E402


def _made(kernel: Any, function: FunctionType) -> Any:
    return numba.njit(nogil=True, **options_of(kernel))(function)  # noqa: TID251


_dispatchers = Namespaces(_made)


def jitted(kernel: Callable[..., Any]) -> Any:
    """Return a dispatcher of a kernel that a function with `numba.njit` can call.

    Parameters
    ----------
    kernel : function
        For example `hophoop.kernel.rigid.run.run`.

    Returns
    -------
    dispatcher : numba dispatcher
        Compiled at its first call, which takes from seconds to minutes.

    Examples
    --------
    >>> from hophoop.kernel.numerics.circular import sine_and_cosine
    >>> jitted(sine_and_cosine)(0.0)
    (0.0, 1.0)
    """
    return _dispatchers.of(kernel)
