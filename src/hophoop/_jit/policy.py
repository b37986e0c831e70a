"""The decorators of the kernels: interpreted until compiled code is there, or worth its wait.

Compiling the whole kernel takes some fifteen seconds, one motion interpreted some twenty milliseconds, and both give the
same bits. So a kernel that is called from Python runs interpreted at first, with all that it calls, and Numba is not even
imported. When that has taken `PATIENCE_TO_LOAD`, compiled code is loaded if it is on disk. If it is not, a process beside
compiles it from `PATIENCE_TO_COMPILE` on, and the kernel changes over when that is done, in the middle of a call if need be:
a kernel writes nothing but its results, so that it can begin again.

Where a library of compiled kernels is built (`python -m hophoop.kernel.build`), what it has is called from the start, and
Numba is not asked. The environment variable HOPHOOP_KERNELS says otherwise: `compiled` waits for compiled code at the first
call, `interpreted` never asks for it. NUMBA_DISABLE_JIT=1 means `interpreted` as well.
"""

from __future__ import annotations

import contextlib
import math
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from functools import update_wrapper
from time import perf_counter
from types import FunctionType
from typing import Any, TypeVar, cast

import numpy as np

from hophoop._jit import beside, signals, store
from hophoop._jit.kernels import Namespaces, Options, Source, describe
from hophoop._jit.library import library

Function = TypeVar("Function", bound=Callable[..., Any])

# Seconds that a kernel may spend interpreted before compiled code is fetched; loading it takes about as long.
PATIENCE_TO_LOAD = 0.3
# ... and before it is compiled where there is none. The process beside that does it may outlive the program.
PATIENCE_TO_COMPILE = 1.0
# Where no process can be started, compiling holds everything up; it must have been worth that.
PATIENCE_TO_WAIT = 30.0
LOOKS = 0.05  # seconds between two looks for compiled code

MODES = ("auto", "compiled", "interpreted")


def mode() -> str:
    """What the environment asks for: auto, compiled or interpreted.

    Raises
    ------
    ValueError
        If HOPHOOP_KERNELS is something else.
    """
    if os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return "interpreted"
    wanted = os.environ.get("HOPHOOP_KERNELS") or "auto"
    if wanted not in MODES:
        raise ValueError(f"HOPHOOP_KERNELS = {wanted!r} must be one of {', '.join(MODES)}.")
    return wanted


class _Abandoned(BaseException):
    """An interpreted call is given up: there is compiled code now."""


_next_look = math.inf
_current = threading.local()


def _interpreted(kernel: Source, plain: FunctionType) -> Callable[..., Any]:
    if kernel.by_arrays is not None:
        return kernel.by_arrays
    if not kernel.options.nrt:  # small, and called by those that look
        return plain

    def looking(*arguments: Any) -> Any:
        if perf_counter() > _next_look:
            _look()
        return plain(*arguments)

    return cast(Callable[..., Any], update_wrapper(looking, plain))


def _look() -> None:
    global _next_look
    _next_look = perf_counter() + LOOKS
    call = getattr(_current, "call", None)
    if call is not None and call.overdue(perf_counter()):
        raise _Abandoned


_plain = Namespaces(_interpreted)


class _Call:
    """What is known about calls of one kernel with arguments of one kind."""

    def __init__(self, kernel: Kernel, kinds: Any) -> None:
        self.kernel = kernel
        self.kinds = kinds
        self.spent = 0.0  # seconds, interpreted
        self.began = math.inf  # the call that is running
        self.job: beside.Job | None = None
        self.looked = False

    def overdue(self, now: float) -> bool:
        """Whether compiled code is to be used from here on; starts the process that compiles where it is time."""
        spent = self.spent + max(now - self.began, 0.0)
        if spent < PATIENCE_TO_LOAD:
            return False
        if not self.looked or self.job is not None:
            self.looked = True
            if store.is_ready(self.kernel, self.kinds):
                return True
        if spent < PATIENCE_TO_COMPILE:
            return False
        if self.job is None:
            self.job = beside.start([(self.kernel, self.kinds)])
        return self.job.failed and spent >= PATIENCE_TO_WAIT


class Kernel(Source):
    """A function that Numba compiles, and that Python runs until then.

    Called from Python, it does what is quicker; called from another kernel, it is part of that one.
    """

    def __init__(self, function: Callable[..., Any], options: Options) -> None:
        super().__init__(function, options)
        self._target: Callable[..., Any] = self._choose
        self._calls: dict[Any, _Call] = {}
        self._loaded: dict[Any, Callable[..., Any]] = {}

    def __call__(self, *arguments: Any) -> Any:
        return self._target(*arguments)

    @property
    def interpreted(self) -> Callable[..., Any]:
        """The function with all that it calls in plain Python."""
        function: Callable[..., Any] = _plain.of(self)
        return function

    @property
    def dispatcher(self) -> Any:
        """Numba's dispatcher, for other compilers and for measurements."""
        from hophoop._jit import dispatchers

        return dispatchers.inner(self)

    @property
    def built(self) -> Callable[..., Any] | None:
        """What the library that was built ahead makes of the kernel: what is not in it is quick interpreted.

        None where there is no library, and for kernels of other packages.
        """
        found = library()
        if found is None or not self.py_func.__module__.startswith("hophoop."):
            return None
        return found.call(f"{self.py_func.__module__}.{self.py_func.__qualname__}") or self._interpret

    def load(self, kinds: Any) -> Callable[..., Any]:
        """Compiled code for arguments of such kinds, waited for where there is none yet."""
        if kinds not in self._loaded:
            with signals.kept():
                from hophoop._jit import dispatchers

            self._loaded[kinds] = dispatchers.load(self, kinds, self._unknown)
        self._target = self._loaded[kinds]
        return self._target

    def _choose(self, *arguments: Any) -> Any:
        wanted = mode()
        if wanted == "interpreted":
            self._target = self._interpret
            return self._interpret(*arguments)
        built = self.built
        if built is not None:
            self._target = built
            return built(*arguments)
        kinds = tuple(describe(value) for value in arguments)
        if wanted == "compiled" or kinds in self._loaded:
            return self.load(kinds)(*arguments)
        call = self._calls.get(kinds)
        if call is None:
            call = self._calls.setdefault(kinds, _Call(self, kinds))
        return self._try_interpreted(call, arguments)

    def _unknown(self, *arguments: Any) -> Any:
        # compiled code is there, but for arguments of other kinds; Numba asks for what it is to call instead
        kinds = tuple(describe(value) for value in arguments)
        if kinds in self._loaded:
            return type(self._loaded[kinds])._compile_for_args(self._loaded[kinds], *arguments)  # type: ignore[attr-defined]
        return self._choose

    def _interpret(self, *arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return self.interpreted(*arguments)

    def _try_interpreted(self, call: _Call, arguments: tuple[Any, ...]) -> Any:
        global _next_look
        if getattr(_current, "call", None) is not None:
            return self._interpret(*arguments)
        call.began = perf_counter()
        try:
            if call.spent < PATIENCE_TO_LOAD or not call.overdue(call.began):
                _next_look = min(_next_look, call.began + LOOKS)
                _current.call = call
                return self._interpret(*arguments)
        except (_Abandoned, ArithmeticError, ValueError):
            pass  # Python raises where compiled arithmetic gives inf or nan, as the kernels expect
        finally:
            _current.call = None
            call.spent += perf_counter() - call.began
            call.began = math.inf
        return self.load(call.kinds)(*arguments)


def compiled(function: Any, *arguments: Any) -> Callable[..., Any]:
    """A kernel as compiled code for arguments like these, waited for where it must be compiled first."""
    kernel = cast(Kernel, function)
    if mode() == "interpreted" or kernel.built is not None:
        return kernel
    return kernel.load(tuple(describe(value) for value in arguments))


def precompile(wanted: Sequence[tuple[Any, Sequence[Any]]]) -> beside.Job | None:
    """Compile kernels in a process beside, as for a call with such arguments; None where nothing is to be compiled."""
    if mode() == "interpreted":
        return None
    kinds = [(kernel, tuple(describe(value) for value in arguments)) for kernel, arguments in wanted if kernel.built is None]
    missing = [(kernel, kind) for kernel, kind in kinds if not store.is_ready(kernel, kind)]
    return beside.start(missing) if missing else None


@contextlib.contextmanager
def forced(wanted: str) -> Iterator[None]:
    """Run all kernels as HOPHOOP_KERNELS says within; for tests and measurements."""
    before = os.environ.get("HOPHOOP_KERNELS")

    def begin_again() -> None:
        for kernel in KERNELS:
            kernel._target = kernel._choose

    os.environ["HOPHOOP_KERNELS"] = wanted
    begin_again()
    try:
        yield
    finally:
        if before is None:
            del os.environ["HOPHOOP_KERNELS"]
        else:
            os.environ["HOPHOOP_KERNELS"] = before
        begin_again()


KERNELS: list[Kernel] = []


def _kernel(function: Function, **options: bool) -> Function:
    kernel = Kernel(function, Options(**options))
    KERNELS.append(kernel)
    return cast(Function, kernel)


def jit(function: Function) -> Function:
    """Interpreted, then compiled in nopython mode, with IEEE arithmetic and without the interpreter lock."""
    return _kernel(function)


def unit_jit(function: Function) -> Function:
    """`jit` for what several kernels call that is long to compile: compiled once for all of them."""
    return _kernel(function, unit=True)


def lean_jit(function: Function) -> Function:
    """`jit` for functions that make no arrays: without reference counts, which cost a fifth of a motion's time."""
    return _kernel(function, nrt=False)


def apart_jit(function: Function) -> Function:
    """`lean_jit` that is never made a part of its callers: small code stays in the processor's cache.

    A motion runs through all of the kernel, so that its size decides about its speed.
    """
    return _kernel(function, nrt=False, apart=True)


def outer_jit(function: Function) -> Function:
    """`inline_jit` for the outer loops, from which all else is called: to optimise them by themselves takes long."""
    return _kernel(function, nrt=False, forceinline=True, outer=True)


def aside_jit(function: Function) -> Function:
    """`apart_jit` for what is called once a motion and itself calls much of the kernel."""
    return _kernel(function, nrt=False, outer=True, apart=True)


def inline_jit(function: Function) -> Function:
    """`lean_jit` for what is called at each panel: always part of its caller.

    Handing body, panel and scratch on is some sixty words a call, which costs a quarter of a motion's time.
    """
    return _kernel(function, nrt=False, forceinline=True)


def interpreted_as(by_arrays: Callable[..., Any]) -> Callable[[Function], Function]:
    """Above another decorator of a kernel: run `by_arrays` instead where the kernel is interpreted.

    For loops over the nodes of a panel, where NumPy's whole arrays are quicker than Python. The numbers must be the same to
    the last bit, so sums keep their order.
    """

    def attached(kernel: Function) -> Function:
        cast(Kernel, kernel).by_arrays = by_arrays
        return kernel

    return attached


def interpreted(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """A kernel with all that it calls in plain Python: for what Python calls once a motion, which is not worth compiling."""
    return cast(Kernel, kernel).interpreted
