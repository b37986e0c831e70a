"""LLVM code of the library's entries: functions of one address, at which their arguments are stored (`kernel.native.calls`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numba
from numba import types
from numba.extending import intrinsic

from hophoop.kernel.build.link import joined
from hophoop.kernel.build.numba_code import code_of, compiling, part_of, result_of
from hophoop.kernel.entries import Array, class_of, fields_of, is_tuple, kernel_named


def numba_type(kind: Any) -> Any:
    """Return Numba's type of an argument type."""
    if isinstance(kind, Array):
        return types.Array(numba.from_dtype(kind.dtype), kind.dimensions, "C")
    if is_tuple(kind):
        return types.BaseTuple.from_types([numba_type(each) for _, each in fields_of(kind)], class_of(kind))
    return {float: types.float64, int: types.int64, bool: types.boolean}[kind]


def _pointer_to(item: Any) -> Any:
    pointer = types.CPointer(item)

    @intrinsic  # type: ignore[untyped-decorator]
    def made(typing_context: Any, address: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(pointer))

        return pointer(types.int64), generate

    return made


class _Writer:
    """Writer of the source of an entry, which reads its arguments from memory and writes its results after them."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"carray": numba.carray}
        self.place = 0

    def read(self, kind: Any) -> str:
        """Return the expression of an argument."""
        if isinstance(kind, Array):
            item = numba.from_dtype(kind.dtype)
            name = f"pointer{len(self.names)}"
            self.names[name] = _pointer_to(item)
            at = self.place
            self.place += 1 + kind.dimensions
            shape = "".join(f"wholes[{at + 1 + i}], " for i in range(kind.dimensions))
            return f"carray({name}(wholes[{at}]), ({shape}))"
        if is_tuple(kind):
            name = f"class{len(self.names)}"
            self.names[name] = class_of(kind)
            return f"{name}({', '.join(self.read(each) for _, each in fields_of(kind))})"
        self.place += 1
        return {float: "reals[{}]", int: "wholes[{}]", bool: "(wholes[{}] & 255) != 0"}[kind].format(self.place - 1)

    def write(self, kind: Any, value: str, lines: list[str]) -> Any:
        """Append lines that write a result of Numba's type `kind`; return the description of its type."""
        if isinstance(kind, types.BaseTuple):
            items = [self.write(each, f"{value}[{i}]", lines) for i, each in enumerate(kind.types)]
            made = getattr(kind, "instance_class", None)
            return {"class": None if made is None else f"{made.__module__}:{made.__qualname__}", "items": items}
        self.place += 1
        if isinstance(kind, types.Float):
            lines.append(f"    reals[{self.place - 1}] = {value}\n")
            return "d"
        if isinstance(kind, types.Boolean):
            lines.append(f"    wholes[{self.place - 1}] = 1 if {value} else 0\n")
            return "?7x"
        if isinstance(kind, types.Integer):
            lines.append(f"    wholes[{self.place - 1}] = {value}\n")
            return "q"
        raise TypeError(f"An entry cannot give a {kind}.")


def entry_code(name: str, kinds: tuple[Any, ...], symbol: str) -> tuple[str, Any]:
    """Return the LLVM code of an entry, and the description of its result.

    Parameters
    ----------
    name : str
        Dotted name of the kernel.
    kinds : tuple
        Types of its arguments.
    symbol : str
        Name of the function in the library.

    Returns
    -------
    code : str
    result : str, dict or None
        As `calls.caller` takes it.
    """
    kernel, of_numba = kernel_named(name), tuple(numba_type(kind) for kind in kinds)
    writer = _Writer()
    writer.names["kernel"] = part_of(kernel)
    arguments = ", ".join(writer.read(kind) for kind in kinds)
    lines: list[str] = []
    result = result_of(kernel, of_numba)
    told = None if isinstance(result, types.NoneType) else writer.write(result, "result", lines)
    source = f"def {symbol}(reals, wholes):\n    result = kernel({arguments})\n{''.join(lines)}"
    exec(source, writer.names)
    text, mangled = code_of(writer.names[symbol], (types.CPointer(types.float64), types.CPointer(types.int64)))
    return text + _wrapper(symbol, mangled), told


def _wrapper(symbol: str, mangled: str) -> str:
    return (
        f"\ndefine i32 @{symbol}(ptr %memory) {{\n  %ret = alloca ptr\n  %exc = alloca ptr\n"
        f"  %status = call i32 @{mangled}(ptr %ret, ptr %exc, ptr %memory, ptr %memory)\n  ret i32 %status\n}}\n"
    )


def takes(kind: Any) -> Any:
    """Return the description of an argument type for `kernel.native.calls`."""
    if isinstance(kind, Array):
        return {"array": [kind.dtype.str if kind.dtype.names is None else kind.dtype.descr, kind.dimensions]}
    if is_tuple(kind):
        return {"tuple": [takes(each) for _, each in fields_of(kind)]}
    return kind.__name__


def group_code(entries: Mapping[str, tuple[Any, ...]]) -> tuple[str, dict[str, Any]]:
    """Return the LLVM code of a group of entries and their descriptions; for a build process that ends afterwards."""
    parts, told = [], {}
    for name, kinds in entries.items():
        symbol = "hophoop_" + name.removeprefix("hophoop.").replace(".", "_")
        with compiling():
            text, result = entry_code(name, kinds, symbol)
        told[name] = {"symbol": symbol, "takes": [takes(kind) for kind in kinds], "gives": result}
        parts.append(text)
    return joined(parts), told
