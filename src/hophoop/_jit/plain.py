"""LLVM's code of a kernel as Numba writes it, for other compilers."""

from __future__ import annotations

from types import FunctionType
from typing import Any

import numba
from numba.core import codegen

from hophoop._jit import dispatchers
from hophoop._jit.kernels import Namespaces, Source


def leave_unoptimised() -> None:
    """From now on, leave Numba's code as it is: the passes for this machine would put its vectors into it.

    Of the whole process, and only of what is compiled afterwards: for programs that build something and end.
    """
    codegen.CPUCodeLibrary._optimize_functions = lambda self, module: None
    codegen.CPUCodeLibrary._optimize_final_module = lambda self: None
    # parts have passes of their own; they are linked still
    dispatchers._PartLibrary._optimize_final_module = dispatchers._Library._optimize_final_module  # type: ignore[method-assign]


def _callee(kernel: Source, function: FunctionType) -> Any:
    # also what is compiled by itself elsewhere: as an entry its code would be kept on disk for this machine, unoptimised
    return dispatchers._dispatcher(kernel, function, entry=False)


_callees = Namespaces(_callee)


def plain(kernel: Source, kinds: tuple[Any, ...]) -> tuple[str, str]:
    """The code of a kernel with all that it calls.

    Parameters
    ----------
    kernel : Source
    kinds : tuple of numba type
        Of its arguments.

    Returns
    -------
    code : str
    name : str
        Of the function in it.
    """
    function = _callees.copied(kernel.py_func)
    _callees.fill(kernel.py_func)
    made = numba.njit(
        error_model="numpy",
        no_cpython_wrapper=True,
        no_cfunc_wrapper=True,
        pipeline_class=dispatchers._ENTRY_COMPILER,
    )(function)
    made.compile(kinds)
    compiled = made.overloads[tuple(kinds)]
    return compiled.library.get_llvm_str(), compiled.fndesc.llvm_func_name
