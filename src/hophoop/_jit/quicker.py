"""What Numba spends much of its time on without need, left out while kernels are compiled; it answers as before.

Shares are those of the processor time that the kernel of a motion takes to compile.
"""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator
from typing import Any

from numba.core import event, ir
from numba.core.cpu import CPUContext
from numba.core.targetconfig import TargetConfig
from numba.core.types.functions import BaseFunction
from numba.core.typing import Context


@contextlib.contextmanager
def compiling() -> Iterator[None]:
    """Within this, Numba compiles without that, and as it did afterwards."""
    with (
        _without_collection(),
        # Numba notes how long each lock is held, once for each function that is being compiled: a thirtieth
        _replaced(event, "install_timer", lambda kind, callback: contextlib.nullcontext()),
        _replaced(event, "start_event", _heard(event.start_event)),
        _replaced(event, "end_event", _heard(event.end_event)),
        _replaced(BaseFunction, "get_call_type", _remembered(BaseFunction.get_call_type)),
        _replaced(CPUContext, "load_additional_registries", _once(CPUContext.load_additional_registries)),
        _replaced(Context, "load_additional_registries", _once(Context.load_additional_registries)),
        _replaced(CPUContext, "get_abi_sizeof", _measured(CPUContext.get_abi_sizeof)),
        _replaced(TargetConfig, "values", _values),
        _replaced(ir.Inst, "_rec_list_vars", _variables),
    ):
        yield


@contextlib.contextmanager
def _without_collection() -> Iterator[None]:
    # Numba makes millions of objects that stay: looking through them for waste takes a sixth
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


@contextlib.contextmanager
def _replaced(owner: Any, name: str, by: Any) -> Iterator[None]:
    was = getattr(owner, name)
    setattr(owner, name, by)
    try:
        yield
    finally:
        setattr(owner, name, was)


def _heard(told: Callable[..., None]) -> Callable[..., None]:
    """Events of Numba that somebody listens to; one begins and ends with each of 50,000 calls of LLVM: a fortieth."""

    def tell(kind: str, *details: Any, **named: Any) -> None:
        if event._registered.get(kind):
            told(kind, *details, **named)

    return tell


def _once(loaded: Callable[[Any], None]) -> Callable[[Any], None]:
    """What other modules declare is looked for once, not with each function; none is imported meanwhile: a fortieth."""
    done = set()

    def load_additional_registries(self: Any) -> None:
        if self not in done:
            done.add(self)
            loaded(self)

    return load_additional_registries


def _remembered(found: Callable[..., Any]) -> Callable[..., Any]:
    """What a builtin gives for arguments of such types: asked 11,000 times, for 340 answers, a tenth."""
    known: dict[Any, Any] = {}

    def get_call_type(self: Any, context: Any, arguments: Any, keywords: Any) -> Any:
        if keywords:
            return found(self, context, arguments, keywords)
        key = (self, context, tuple(arguments))
        if key not in known:
            known[key] = found(self, context, arguments, keywords)
        return known[key]

    return get_call_type


def _measured(size: Callable[[Any, Any], int]) -> Callable[[Any, Any], int]:
    """How many bytes a type takes, for which LLVM reads a whole module each time: asked 1,300 times, a hundredth."""
    known: dict[Any, int] = {}

    def get_abi_sizeof(self: Any, ty: Any) -> int:
        if ty not in known:  # each function has a context of its own, all of this machine
            known[ty] = size(self, ty)
        return known[ty]

    return get_abi_sizeof


def _values(self: Any) -> dict[str, Any]:
    """All options of a compilation, which are compared for every callee, without a call for each of them: a twentieth."""
    return {name: self._values.get(name, option.default) for name, option in self.options.items()}


def _variables(self: Any, value: Any) -> list[Any]:
    """The variables in a part of an instruction, in their order: asked for 200,000 times, of seven parts each, a tenth."""
    found: list[Any] = []
    _gather(value, found)
    return found


def _gather(value: Any, found: list[Any]) -> None:
    if isinstance(value, ir.Inst):
        found.extend(value.list_vars())
        return
    if isinstance(value, dict):
        value = value.values()
    elif isinstance(value, ir.Var):
        found.append(value)
        return
    elif not isinstance(value, list | tuple):
        return
    for item in value:
        if type(item) is ir.Var:
            found.append(item)
        elif type(item) not in _PLAIN:
            _gather(item, found)


_PLAIN = {str, type(None), bool, int, ir.Loc}  # parts of instructions that are no variables, and have none
