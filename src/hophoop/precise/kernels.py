"""The kernel's own functions over other numbers: copies with other constants and globals.

The mode rule, the impacts, the steps from event to event and the energies are the kernel's; the solver of a phase is not.
"""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType, SimpleNamespace
from typing import Any

from hophoop.kernel.native.marks import source_of

Number = Any


class Kernels:
    """Copies of kernels with other numbers for their constants and other values for global names, as all kernels they call.

    Parameters
    ----------
    number : callable
        Function that makes a number of each constant.
    names : dict
        The values in place of the kernel's own.
    """

    def __init__(self, number: Callable[[float], Any], names: dict[str, Any]) -> None:
        self._number, self._names = number, names
        self._copies: dict[FunctionType, Callable[..., Any]] = {}

    def __call__(self, kernel: Callable[..., Any]) -> Callable[..., Any]:
        """Return the copy of a kernel."""
        function = source_of(kernel)
        if function not in self._copies:
            names: dict[str, Any] = {}
            code = function.__code__.replace(co_consts=self._constants(function.__code__.co_consts))
            self._copies[function] = FunctionType(code, names, function.__name__, function.__defaults__)
            for name in code.co_names:
                if name in self._names:
                    names[name] = self._names[name]
                elif name in function.__globals__:
                    value = function.__globals__[name]
                    names[name] = self(value) if isinstance(value, FunctionType) else value
        return self._copies[function]

    def _constants(self, values: tuple[Any, ...]) -> tuple[Any, ...]:
        found = [self._constants(value) if isinstance(value, tuple) else value for value in values]
        return tuple(self._number(value) if isinstance(value, float) else value for value in found)


def numbers_of(ctx: Any) -> dict[str, Any]:
    """Return what kernels read under these names to compute in the precision of a context."""

    def sine_and_cosine(x: Number) -> tuple[Number, Number]:
        c, s = ctx.cos_sin(x)
        return s, c

    def sine_cosine_change(s: Number, c: Number, angle: Number) -> tuple[Number, Number]:
        cosine, sine = ctx.cos_sin(angle)
        return s * cosine + c * sine - s, c * cosine - s * sine - c

    return {
        "math": SimpleNamespace(
            inf=ctx.inf,
            nan=ctx.nan,
            isinf=ctx.isinf,
            isnan=ctx.isnan,
            sqrt=ctx.sqrt,
            copysign=lambda size, sign: abs(size) if sign >= 0 else -abs(size),
        ),
        "sine": ctx.sin,
        "cosine": ctx.cos,
        "sine_and_cosine": sine_and_cosine,
        "sine_cosine": lambda th, low: sine_and_cosine(th),
        "sine_cosine_change": sine_cosine_change,
        "plus": lambda high, low, value: (high + value, low),
    }
