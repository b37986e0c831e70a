"""LLVM code of the library's entries: functions of one address, at which their arguments are stored (`kernel.native.calls`)."""

from __future__ import annotations

from typing import Any

import numba
from numba import types

from hophoop.kernel.build.lowering import exported, part_of
from hophoop.kernel.entries import ENTRIES, Array, class_of, description, is_tuple, kernel_named, kinds_of

MEMORY = types.CPointer(types.float64), types.CPointer(types.int64), types.CPointer(types.voidptr)


def numba_type(kind: Any) -> Any:
    """Return Numba's type of an argument type."""
    if isinstance(kind, Array):
        return types.Array(numba.from_dtype(kind.dtype), kind.dimensions, "C")
    if is_tuple(kind):
        return types.BaseTuple.from_types([numba_type(each) for each in kinds_of(kind)], class_of(kind))
    return {float: types.float64, int: types.int64, bool: types.boolean}[kind]


class _Writer:
    """Writer of the source of an entry, which reads its arguments from memory and writes its results after them."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"carray": numba.carray}
        self.place = 0

    def read(self, kind: Any) -> str:
        """Return the expression of an argument."""
        at = self.place
        if isinstance(kind, Array):
            self.place += 1 + kind.dimensions
            self.names[f"dtype{at}"] = kind.dtype
            shape = "".join(f"wholes[{at + 1 + i}], " for i in range(kind.dimensions))
            return f"carray(places[{at}], ({shape}), dtype{at})"
        if is_tuple(kind):
            items = ", ".join(self.read(each) for each in kinds_of(kind))
            self.names[f"class{at}_{self.place}"] = class_of(kind)
            return f"class{at}_{self.place}({items})"
        self.place += 1
        return {float: "reals[{}]", int: "wholes[{}]", bool: "wholes[{}] != 0"}[kind].format(at)

    def write(self, kind: Any, value: str, lines: list[str]) -> Any:
        """Append lines that write a result of Numba's type `kind`; return the description of its type."""
        if isinstance(kind, types.BaseTuple):
            items = [self.write(each, f"{value}[{i}]", lines) for i, each in enumerate(kind.types)]
            made = getattr(kind, "instance_class", None)
            return {"class": made and f"{made.__module__}.{made.__qualname__}", "items": items}
        at = self.place
        self.place += 1
        if isinstance(kind, types.Float):
            lines.append(f"    reals[{at}] = {value}\n")
            return "float"
        lines.append(f"    wholes[{at}] = {value}\n")
        return "bool" if isinstance(kind, types.Boolean) else "int"


def entry(name: str) -> tuple[dict[str, Any], bytes]:
    """Compile an entry; return its description and its bitcode."""
    kernel, kinds = kernel_named(name), ENTRIES[name]
    symbol = "hophoop_" + name.removeprefix("hophoop.").replace(".", "_")
    result = part_of(kernel, tuple(numba_type(kind) for kind in kinds)).result
    writer = _Writer()
    writer.names |= {"__name__": "hophoop.entries", "kernel": kernel}
    arguments = ", ".join(writer.read(kind) for kind in kinds)
    lines: list[str] = []
    gives = None if isinstance(result, types.NoneType) else writer.write(result, "result", lines)
    exec(f"def {symbol}(reals, wholes, places):\n    result = kernel({arguments})\n{''.join(lines)}", writer.names)
    told = {"symbol": symbol, "takes": [description(kind) for kind in kinds], "gives": gives}
    return told, exported(symbol, writer.names[symbol], MEMORY, simple=True)
