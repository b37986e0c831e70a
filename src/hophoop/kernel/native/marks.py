"""Marks that tell the build how to compile a kernel. A kernel is a plain function, which Python can also interpret."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])
Values = TypeVar("Values", bound=Any)

MARK, COMPILED = "__hophoop_mark__", "__hophoop_compiled__"


def inline(function: Function) -> Function:
    """Mark a kernel that the compiler must inline in its callers, because it is called for each panel.

    Passing body, panel and scratch takes about 60 words per call, which would cost 25 % of a motion's time.
    """
    setattr(function, MARK, "alwaysinline")
    return function


def noinline(function: Function) -> Function:
    """Mark a kernel that the compiler must not inline: small code stays in the processor's cache.

    A motion runs through most of the kernel, so code size decides the speed.
    """
    setattr(function, MARK, "noinline")
    return function


def replaced(values: Values, **changes: Any) -> Values:
    """Return a named tuple with other values of some fields; the build compiles a call of it to as many stores."""
    return cast(Values, values._replace(**changes))


def interpreted_as(other: Callable[..., Any]) -> Callable[[Function], Function]:
    """Decorate a kernel (above its mark) so that Python runs `other`; the build compiles the kernel.

    For the bits of doubles, which interpreted Python accesses differently, and for loops over the nodes of a panel, where NumPy
    is faster. Both must agree to the last bit, so sums keep their order.
    """

    def attached(kernel: Function) -> Function:
        own, given = cast(FunctionType, kernel), cast(FunctionType, other)
        made = FunctionType(given.__code__, given.__globals__, own.__name__, given.__defaults__, given.__closure__)
        made.__qualname__, made.__module__, made.__doc__ = own.__qualname__, own.__module__, own.__doc__
        setattr(made, COMPILED, kernel)
        return cast(Function, made)

    return attached


def source_of(kernel: Callable[..., Any]) -> FunctionType:
    """Return the function that the build compiles for a kernel."""
    return cast(FunctionType, getattr(kernel, COMPILED, kernel))


def mark_of(kernel: Callable[..., Any]) -> str:
    """Return LLVM's attribute of a kernel: 'alwaysinline', 'noinline' or ''."""
    return cast(str, getattr(source_of(kernel), MARK, ""))
