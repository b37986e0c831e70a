"""What the build is told about a kernel. A kernel is a plain function: Python runs it as it stands."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])

MARK, COMPILED = "__hophoop_mark__", "__hophoop_compiled__"


def inline(function: Function) -> Function:
    """Mark a kernel that becomes part of its callers: what is called at each panel.

    Handing body, panel and scratch on is some sixty words a call, which costs a quarter of a motion's time.
    """
    setattr(function, MARK, "inline")
    return function


def apart(function: Function) -> Function:
    """Mark a kernel that never becomes part of its callers: small code stays in the processor's cache.

    A motion runs through all of the kernel, so that its size decides about its speed.
    """
    setattr(function, MARK, "apart")
    return function


def interpreted_as(other: Callable[..., Any]) -> Callable[[Function], Function]:
    """Above a kernel and its mark: Python runs `other`, the build takes the kernel.

    For the bits of doubles, which Python reaches by other ways, and for loops over the nodes of a panel, where NumPy's whole
    arrays are quicker. The numbers must be the same to the last bit, so sums keep their order.
    """

    def attached(kernel: Function) -> Function:
        own, given = cast(FunctionType, kernel), cast(FunctionType, other)
        made = FunctionType(given.__code__, given.__globals__, own.__name__, given.__defaults__, given.__closure__)
        made.__qualname__, made.__module__, made.__doc__ = own.__qualname__, own.__module__, own.__doc__
        setattr(made, COMPILED, kernel)
        return cast(Function, made)

    return attached


def source_of(kernel: Callable[..., Any]) -> FunctionType:
    """The function that the build compiles for a kernel."""
    return cast(FunctionType, getattr(kernel, COMPILED, kernel))


def mark_of(kernel: Callable[..., Any]) -> str:
    """'inline', 'apart' or nothing."""
    return cast(str, getattr(source_of(kernel), MARK, ""))
