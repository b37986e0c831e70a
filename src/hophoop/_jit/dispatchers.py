"""Sources as Numba's dispatchers: cached, IEEE arithmetic, no fastmath; and what the process that compiles does."""

from __future__ import annotations

import contextlib
import enum
import gc
import importlib
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FunctionType
from typing import Any

import numba
import numpy as np
from numba import types
from numba.core import config, event
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder, _LowerResult
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeLowering, NopythonRewrites
from numba.core.untyped_passes import InlineClosureLikes

from hophoop._jit import beside, quicker, signals, store
from hophoop._jit.disk import DiskCache
from hophoop._jit.kernels import Namespaces, Source


class _Library(JITCodeLibrary):  # type: ignore[misc]
    """Code that is linked with all that it calls, also where a part of it has left something out."""

    _linking_libraries: list[Any]
    left_out: tuple[Any, ...] = ()  # what is called from here and is to be linked later

    def _optimize_functions(self, module: Any) -> None:
        # what is done to the linked module does the same and more
        module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        called = self._called()
        self.left_out = tuple(library for library in called if self._leaves_out(library))
        self._linking_libraries = [library for library in called if library not in self.left_out]
        super().finalize()

    def _optimize_final_module(self) -> None:
        self._link_again()
        super()._optimize_final_module()

    def _link_again(self) -> None:
        """LLVM drops what is not called yet when it is linked; link it when something linked later calls it."""
        waiting = self._linking_libraries
        while waiting:
            missing = {function.name for function in self._final_module.functions if function.is_declaration}
            needed = [
                library
                for library in waiting
                if any(not made.is_declaration and made.name in missing for made in library._get_module_for_linking().functions)
            ]
            for library in needed:
                self._final_module.link_in(library._get_module_for_linking(), preserve=True)
            waiting = needed

    def _leaves_out(self, library: Any) -> bool:
        return False

    def _called(self) -> list[Any]:
        found: dict[Any, None] = {}
        waiting = list(self._linking_libraries)
        while waiting:
            library = waiting.pop(0)
            if library not in found:
                found[library] = None
                # what is called from what is left out comes with that, later
                if not self._leaves_out(library):
                    waiting += getattr(library, "left_out", ())
        return list(found)


class _PartLibrary(_Library):
    """Code that is only ever linked into that of a caller: of it alone no machine code is made.

    What it calls and never inlines is left out: it would be optimised again as a part of each of its callers.
    """

    def _leaves_out(self, library: Any) -> bool:
        return isinstance(library, _ApartLibrary | _OuterApartLibrary)

    def _optimize_final_module(self) -> None:
        self._link_again()
        # Numba has cheaper passes first, for what counts references. The whole is optimised with both: here they gain nothing
        made = self._codegen._module_pass_manager()
        passes, *builder = made if isinstance(made, tuple) else (made,)  # alone before Numba 0.61
        passes.run(self._final_module, *builder)

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._finalized = True


class _ApartLibrary(_PartLibrary):
    """Code of what is never inlined."""


class _OuterLibrary(_Library):
    """Code of the outer loops, which is not optimised before it is a part of the whole."""

    def finalize(self) -> None:
        self._raise_if_finalized()
        self.left_out = tuple(self._linking_libraries)
        self._finalized = True


class _OuterApartLibrary(_OuterLibrary):
    """Code of outer loops that is never inlined."""


class _ApartLower(Lower):  # type: ignore[misc]
    """Lowering of code that is never inlined."""

    def setup_function(self, fndesc: Any) -> None:
        super().setup_function(fndesc)
        self.function.attributes.add("noinline")


class _PartLowering(NativeLowering):  # type: ignore[misc]
    library: type[_Library]

    def run_pass(self, state: Any) -> bool:
        library = state.library = self.library(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        made = state["cr"]

        part: Any = {}.get  # Numba wants a builtin for a key, one for each; nobody calls it
        state.targetctx.insert_user_function(part, made.fndesc, [library])
        state["cr"] = _LowerResult(made.fndesc, made.call_helper, cfunc=part, env=made.env)
        return True


class _EntryLowering(NativeLowering):  # type: ignore[misc]
    library: type[_Library]

    def run_pass(self, state: Any) -> bool:
        state.library = self.library(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


def _compiler(kind: type[NativeLowering], library: type[_Library], lower: type[Lower]) -> type[CompilerBase]:
    """Numba's compiler, with another lowering: making machine code of each part took a sixth of the time."""
    name = f"{kind.__name__}{library.__name__}{lower.__name__}"
    made = type(name, (kind,), {"_name": name, "library": library, "lowering_class": lower})
    lowering = register_pass(mutates_CFG=True, analysis_only=False)(made)

    class Compiler(CompilerBase):  # type: ignore[misc]
        def define_pipelines(self) -> list[Any]:
            pipeline = DefaultPassBuilder.define_nopython_pipeline(self.state)
            pipeline.passes = [
                (lowering if step is NativeLowering else step, text)
                for step, text in pipeline.passes
                # no kernel has a function or a comprehension within
                if step is not InlineClosureLikes
                # those are of arrays made within: most kernels make none, and have no reference counts
                and (step is not NopythonRewrites or self.state.flags.nrt)
            ]
            pipeline.finalize()
            return [pipeline]

    return Compiler


_ENTRY_COMPILER = _compiler(_EntryLowering, _Library, Lower)
# by (outer, apart)
_PART_COMPILERS = {
    (False, False): _compiler(_PartLowering, _PartLibrary, Lower),
    (False, True): _compiler(_PartLowering, _ApartLibrary, _ApartLower),
    (True, False): _compiler(_PartLowering, _OuterLibrary, Lower),
    (True, True): _compiler(_PartLowering, _OuterApartLibrary, _ApartLower),
}


def _dispatcher(kernel: Source, function: FunctionType, entry: bool) -> Any:
    options: dict[str, Any] = {"error_model": "numpy", "nogil": True}
    if not kernel.options.nrt:
        options["_nrt"] = False
    # also where it is False: what is first called by a part that is inlined would inherit it, everywhere
    options["forceinline"] = kernel.options.forceinline
    options["pipeline_class"] = _ENTRY_COMPILER if entry else _PART_COMPILERS[kernel.options.outer, kernel.options.apart]
    if not entry:
        # Python calls it through no one but an entry: what would translate its arguments is half of all code
        options |= {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    before = config.CACHE_DIR
    # Read by Numba at decoration only, so other packages keep their own setting.
    config.CACHE_DIR = str(store.folder_of(kernel)) if entry else before
    try:
        dispatcher = numba.njit(**options)(function)
        if entry:
            dispatcher._cache = DiskCache(function)
    finally:
        config.CACHE_DIR = before
    general = dispatcher.get_call_template

    def get_call_template(arguments: Any, keywords: Any) -> Any:
        # Numba would compile a function anew for each constant that it is called with: a third of the time to compile
        return general(
            [types.unliteral(kind) for kind in arguments],
            {name: types.unliteral(kind) for name, kind in keywords.items()},
        )

    dispatcher.get_call_template = get_call_template
    return dispatcher


def _callee(kernel: Source, function: FunctionType) -> Any:
    return entry(kernel) if kernel.options.unit else _dispatcher(kernel, function, entry=False)


_callees = Namespaces(_callee)
_entries: dict[Source, Any] = {}


def inner(kernel: Source) -> Any:
    """The dispatcher that other kernels call."""
    return _callees.of(kernel)


def entry(kernel: Source) -> Any:
    """The dispatcher that Python calls, with its code on disk."""
    if kernel not in _entries:
        _entries[kernel] = _dispatcher(kernel, _callees.copied(kernel.py_func), entry=True)
        _callees.fill(kernel.py_func)
    return _entries[kernel]


def numba_type(kind: Any) -> Any:
    """Numba's type of what `_jit.describe` describes."""
    if kind[0] == "array":
        _, dtype, dimensions, layout, writeable = kind
        return types.Array(numba.from_dtype(np.dtype(dtype)), dimensions, layout, readonly=not writeable)
    if kind[0] == "tuple":
        _, made, items = kind
        return types.BaseTuple.from_types([numba_type(item) for item in items], None if made is tuple else made)
    if issubclass(kind[1], enum.Enum):
        return numba.typeof(next(iter(kind[1])))
    return numba.typeof(kind[1]())


def compile_for(kernel: Source, kinds: Any) -> None:
    """Load compiled code for such arguments from disk, or compile it and put it there."""
    dispatcher = entry(kernel)
    there = store.is_ready(kernel, kinds)
    # one process at a time compiles it; the next loads what that one has made
    with (
        contextlib.nullcontext() if there else _alone(store.folder_of(kernel)),
        quicker.compiling(),
        signals.kept(),
    ):
        dispatcher.compile(tuple(numba_type(kind) for kind in kinds))
        if dispatcher._cache.complete:
            store.note_ready(kernel, kinds)


def load(kernel: Source, kinds: Any, unknown: Callable[..., Any]) -> Callable[..., Any]:
    """The dispatcher of a kernel with compiled code for such arguments, waited for where there is none yet.

    `unknown` takes calls with arguments of other kinds.
    """
    if not store.is_ready(kernel, kinds):
        with beside.Waiting(sys.stderr) as waiting:
            # where no process can be started, or none can import the kernel, it is compiled here
            beside.start([(kernel, kinds)]).wait(waiting.report)
    dispatcher = entry(kernel)
    compile_for(kernel, kinds)
    dispatcher._compile_for_args = unknown
    result: Callable[..., Any] = dispatcher
    return result


class _Progress(event.Listener):  # type: ignore[misc]
    def __init__(self, path: str) -> None:
        self._path = Path(path)
        self._count = 0

    def on_start(self, event: Any) -> None:
        pass

    def on_end(self, event: Any) -> None:
        self._count += 1
        with contextlib.suppress(OSError):
            self._path.write_text(str(self._count))


def main() -> None:
    """Compile what standard input asks for; runs in a process of its own."""
    wanted, progress = pickle.load(sys.stdin.buffer)
    if hasattr(os, "nice"):
        os.nice(5)
    gc.disable()  # Numba makes millions of objects: to look through them at the end takes a twenty-fifth of the time
    try:
        with event.install_listener("numba:compile", _Progress(progress)):
            for module, name, kinds in wanted:
                kernel = getattr(importlib.import_module(module), name)
                compile_for(kernel, kinds)
    finally:
        with contextlib.suppress(OSError):
            Path(progress).unlink()


@contextlib.contextmanager
def _alone(folder: Path) -> Iterator[None]:
    with contextlib.ExitStack() as stack:
        # where there is no such lock (Windows), or no room for its file, both compile, and write whole files
        with contextlib.suppress(ImportError, OSError):
            import fcntl

            folder.mkdir(parents=True, exist_ok=True)
            fcntl.flock(stack.enter_context(open(folder / "lock", "a+b")), fcntl.LOCK_EX)
        yield
