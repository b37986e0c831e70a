"""LLVM code of kernels, by Numba: the only module that uses Numba's private names.

Numba types and lowers each kernel once. No kernel is optimized on its own, so the code is independent of the machine.
"""

from __future__ import annotations

import contextlib
import dis
import gc
import threading
from collections.abc import Callable, Iterator
from functools import cache
from itertools import pairwise
from types import CellType, CodeType, FunctionType
from typing import Any

import numba
from numba import types
from numba.core.codegen import CPUCodeLibrary, JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder, _LowerResult
from numba.core.compiler_lock import global_compiler_lock
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeLowering, NopythonRewrites
from numba.core.untyped_passes import InlineClosureLikes

from hophoop.kernel.native.marks import mark_of, source_of
from hophoop.kernel.native.sources import is_kernel

ARRAYS = {"empty", "zeros", "ones", "full", "array", "arange", "empty_like", "zeros_like"}  # of NumPy, create an array


# --- names that a kernel calls ---------------------------------------------------------------------------------------


def _names_in(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names_in(constant)


def called(kernel: Callable[..., Any]) -> list[Any]:
    """Return the kernels that a kernel calls directly."""
    function = source_of(kernel)
    values = [function.__globals__.get(name) for name in dict.fromkeys(_names_in(function.__code__))]
    values += [cell.cell_contents for cell in function.__closure__ or ()]
    return [value for value in values if is_kernel(value)]


def _makes_one(code: CodeType) -> bool:
    if "carray" in code.co_names:  # Numba's carray returns an array
        return True
    for one, following in pairwise(dis.get_instructions(code)):
        if one.argval == "np" and following.argval in ARRAYS:
            return True
        # a value assigned to a slice is copied first
        if one.opname == "STORE_SLICE" or (following.opname == "STORE_SUBSCR" and _is_slice(one)):
            return True
    return any(_makes_one(constant) for constant in code.co_consts if isinstance(constant, CodeType))


def _is_slice(step: dis.Instruction) -> bool:
    return step.opname == "BUILD_SLICE" or isinstance(step.argval, slice)


@cache
def makes_arrays(kernel: Callable[..., Any]) -> bool:
    """Return True if a kernel or its callees create arrays; only then are references counted, which costs 20 % of the time."""
    return _makes_one(source_of(kernel).__code__) or any(makes_arrays(each) for each in called(kernel))


class Namespaces:
    """Copies of modules' namespaces in which every kernel is replaced, so that kernels call the replacements.

    Parameters
    ----------
    made : callable
        Function of a kernel and of its copied function that returns the replacement.
    """

    def __init__(self, made: Callable[[Any, FunctionType], Any]) -> None:
        self._make = made
        self._names: dict[int, dict[str, Any]] = {}
        self._made: dict[Any, Any] = {}
        self._lock = threading.RLock()

    def of(self, kernel: Any) -> Any:
        """Return the replacement of a kernel."""
        with self._lock:
            if kernel not in self._made:
                self._made[kernel] = self._make(kernel, self._copied(source_of(kernel)))
                self._fill(source_of(kernel))
            return self._made[kernel]

    def _copied(self, function: FunctionType) -> FunctionType:
        names = self._names.setdefault(id(function.__globals__), dict(function.__globals__))
        cells = tuple(CellType(self._replaced(cell.cell_contents)) for cell in function.__closure__ or ())
        copy = FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells or None)
        copy.__kwdefaults__, copy.__qualname__ = function.__kwdefaults__, function.__qualname__
        copy.__module__, copy.__doc__ = function.__module__, function.__doc__
        return copy

    def _fill(self, function: FunctionType) -> None:
        names = self._names[id(function.__globals__)]
        for name in _names_in(function.__code__):
            if name in function.__globals__:
                names[name] = self._replaced(function.__globals__[name])

    def _replaced(self, value: Any) -> Any:
        return self.of(value) if is_kernel(value) else value


def options_of(kernel: Any) -> dict[str, Any]:
    """Return Numba's options for compiling a kernel, the same for every purpose."""
    options: dict[str, Any] = {"error_model": "numpy", "forceinline": mark_of(kernel) == "inline"}
    if not makes_arrays(kernel):
        options["_nrt"] = False
    return options


# --- unoptimized code ------------------------------------------------------------------------------------------------


class _Part(JITCodeLibrary):  # type: ignore[misc]
    """Code of a kernel, which is only linked into the code of an entry."""

    _linking_libraries: list[Any]
    called: tuple[Any, ...] = ()

    def finalize(self) -> None:
        self._raise_if_finalized()
        self.called = tuple(self._linking_libraries)
        self._finalized = True


class _Whole(JITCodeLibrary):  # type: ignore[misc]
    """Code of an entry, linked with all of its callees and not optimized."""

    _linking_libraries: list[Any]

    def _optimize_functions(self, module: Any) -> None:
        module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        found: dict[Any, None] = {}
        waiting = list(self._linking_libraries)
        while waiting:
            library = waiting.pop(0)
            if library not in found:
                found[library] = None
                waiting += getattr(library, "called", ())
        self._linking_libraries = list(found)
        super().finalize()

    def _optimize_final_module(self) -> None:
        # LLVM drops a library that nothing calls yet: link it once code linked later calls it
        waiting = self._linking_libraries
        while waiting:
            missing = {function.name for function in self._final_module.functions if function.is_declaration}
            waiting = [
                library
                for library in waiting
                if any(not made.is_declaration and made.name in missing for made in library._get_module_for_linking().functions)
            ]
            for library in waiting:
                self._final_module.link_in(library._get_module_for_linking(), preserve=True)

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._finalized = True  # no machine code is generated


class _ApartLower(Lower):  # type: ignore[misc]
    def setup_function(self, fndesc: Any) -> None:
        super().setup_function(fndesc)
        self.function.attributes.add("noinline")


class _Lowering(NativeLowering):  # type: ignore[misc]
    library: type[JITCodeLibrary]

    def run_pass(self, state: Any) -> bool:
        library = state.library = self.library(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        made = state["cr"]

        part: Any = {}.get  # Numba needs a unique builtin as a key; it is never called
        state.targetctx.insert_user_function(part, made.fndesc, [library])
        state["cr"] = _LowerResult(made.fndesc, made.call_helper, cfunc=part, env=made.env)
        return True


def _compiler(library: type[JITCodeLibrary], lower: type[Lower]) -> type[CompilerBase]:
    name = f"Lowering{library.__name__}{lower.__name__}"
    made = type(name, (_Lowering,), {"_name": name, "library": library, "lowering_class": lower})
    lowering = register_pass(mutates_CFG=True, analysis_only=False)(made)

    class Compiler(CompilerBase):  # type: ignore[misc]
        def define_pipelines(self) -> list[Any]:
            pipeline = DefaultPassBuilder.define_nopython_pipeline(self.state)
            pipeline.passes = [
                (lowering if step is NativeLowering else step, text)
                for step, text in pipeline.passes
                # no kernel contains a function or a comprehension
                if step is not InlineClosureLikes
                # these rewrites concern arrays that are created inside, so kernels without reference counts do not need them
                and (step is not NopythonRewrites or self.state.flags.nrt)
            ]
            pipeline.finalize()
            return [pipeline]

    return Compiler


_WHOLE, _PART, _NOINLINE = _compiler(_Whole, Lower), _compiler(_Part, Lower), _compiler(_Part, _ApartLower)


def _jitted(function: FunctionType, compiler: type[CompilerBase], **options: Any) -> Any:
    dispatcher = numba.njit(  # noqa: TID251
        pipeline_class=compiler, no_cpython_wrapper=True, no_cfunc_wrapper=True, **options
    )(function)
    general = dispatcher.get_call_template

    def get_call_template(arguments: Any, keywords: Any) -> Any:
        # Numba would compile a function again for each constant argument, 33 % of the compile time
        return general(
            [types.unliteral(kind) for kind in arguments],
            {name: types.unliteral(kind) for name, kind in keywords.items()},
        )

    dispatcher.get_call_template = get_call_template
    return dispatcher


def _made(kernel: Any, function: FunctionType) -> Any:
    return _jitted(function, _NOINLINE if mark_of(kernel) == "noinline" else _PART, **options_of(kernel))


_parts = Namespaces(_made)


def part_of(kernel: Any) -> Any:
    """Return the dispatcher of a kernel, for entries to call."""
    return _parts.of(kernel)


def result_of(kernel: Any, kinds: tuple[Any, ...]) -> Any:
    """Return Numba's type of a kernel's result for these argument types."""
    part = part_of(kernel)
    part.compile(kinds)
    return part.overloads[kinds].signature.return_type


def code_of(function: FunctionType, kinds: tuple[Any, ...]) -> tuple[str, str]:
    """Return the LLVM code of a function that calls parts, with all of its callees.

    Parameters
    ----------
    function : function
        Function whose globals are parts.
    kinds : tuple of numba type
        Types of its arguments.

    Returns
    -------
    code, name : str
        The code, and the name of the function in it.
    """
    made = _jitted(function, _WHOLE, error_model="numpy")
    made.compile(kinds)
    compiled = made.overloads[kinds]
    with global_compiler_lock:
        compiled.library._ensure_finalized()
    return compiled.library.get_llvm_str(), compiled.fndesc.llvm_func_name


@contextlib.contextmanager
def compiling() -> Iterator[None]:
    """Context in which Numba's own library code is not optimized either; for a build process that ends afterwards."""
    CPUCodeLibrary._optimize_functions = lambda self, module: None
    CPUCodeLibrary._optimize_final_module = lambda self: None
    gc.disable()  # Numba creates millions of permanent objects, and collecting garbage among them takes about 15 % of the time
    try:
        yield
    finally:
        gc.enable()
