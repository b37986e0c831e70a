"""Calls of kernels from Python: compiled if the library has them, else interpreted.

Both give the same bits. The environment variable HOPHOOP_KERNELS can force one: `interpreted` always runs the sources,
`compiled` fails without a library.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator
from functools import cached_property
from importlib import import_module
from typing import Any

import numpy as np

from hophoop._support.errors import InputError
from hophoop.kernel.native.library import library, say_missing, why_missing

MODES = ("auto", "compiled", "interpreted")


def mode() -> str:
    """Return the mode that the environment asks for: auto, compiled or interpreted.

    Raises
    ------
    ValueError
        If HOPHOOP_KERNELS has another value.
    """
    wanted = os.environ.get("HOPHOOP_KERNELS") or "auto"
    if wanted not in MODES:
        raise InputError.of_field("HOPHOOP_KERNELS", wanted, f"one of {', '.join(MODES)}")
    return wanted


class Entry:
    """A kernel that Python can call."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._call: Callable[..., Any] = self._choose

    def __call__(self, *arguments: Any) -> Any:
        return self._call(*arguments)

    def __repr__(self) -> str:
        return f"<kernel {self.name}>"

    def _choose(self, *arguments: Any) -> Any:
        self._call = self._chosen()
        return self._call(*arguments)

    def _chosen(self) -> Callable[..., Any]:
        wanted = mode()
        if wanted == "interpreted":
            return self._interpret
        found = library(quiet=wanted == "compiled")
        why = why_missing()
        if found is not None:
            try:
                return found.call(self.name)
            except OSError as error:
                why = str(error)
        if wanted == "compiled":
            raise InputError(f"HOPHOOP_KERNELS = 'compiled': {why}", field="HOPHOOP_KERNELS", value=wanted)
        say_missing(why)
        return self._interpret

    def _interpret(self, *arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return self.kernel(*arguments)

    @cached_property
    def kernel(self) -> Callable[..., Any]:
        """The kernel's source, imported only if it is interpreted."""
        module, _, function = self.name.rpartition(".")
        found: Callable[..., Any] = getattr(import_module(module), function)
        return found


_entries: dict[Callable[..., Any] | str, Entry] = {}


def compiled(kernel: Callable[..., Any] | str) -> Callable[..., Any]:
    """Return a kernel of `kernel.entries` as compiled code, or interpreted if there is none.

    Parameters
    ----------
    kernel : function or str
        Or its dotted name; its module is then imported only if there is no library.

    Returns
    -------
    call : callable
        A callable with the kernel's arguments.
    """
    found = _entries.get(kernel)
    if found is None:
        name = kernel if isinstance(kernel, str) else f"{kernel.__module__}.{kernel.__qualname__}"
        found = _entries[kernel] = _entries.setdefault(name, Entry(name))
    return found


@contextlib.contextmanager
def forced(wanted: str) -> Iterator[None]:
    """Context in which all kernels run as `wanted` (a value of HOPHOOP_KERNELS); for tests and measurements."""
    before = os.environ.get("HOPHOOP_KERNELS")
    os.environ["HOPHOOP_KERNELS"] = wanted
    _choose_again()
    try:
        yield
    finally:
        if before is None:
            del os.environ["HOPHOOP_KERNELS"]
        else:
            os.environ["HOPHOOP_KERNELS"] = before
        _choose_again()


def _choose_again() -> None:
    for entry in list(_entries.values()):
        entry._call = entry._choose
