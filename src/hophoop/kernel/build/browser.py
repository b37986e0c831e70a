"""The browser's modules: the entries of `hophoop.lab.wasm` as WebAssembly, linked with the C library of WASI."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from hophoop.kernel.build.link import RUNTIME, optimized, zig
from hophoop.lab.wasm.stamp import FATES, MODULE

TRIPLE = "wasm32-unknown-unknown"
STACK = 1 << 20  # bytes
LINKED = ("-Wl,--no-entry", "-Wl,--export-memory", "-Wl,--strip-all", "-Wl,--gc-sections", f"-Wl,-z,stack-size={STACK}")


class Module(NamedTuple):
    """A module: its file, and the name of its entries in `hophoop.lab.wasm.entries`."""

    file: str
    entries: str


# name in the layout → module
MODULES = {"module": Module(MODULE, "ENTRIES"), "fates_module": Module(FATES, "FATE_ENTRIES")}


def module_code(entries: Mapping[str, tuple[Any, tuple[Any, ...]]]) -> bytes:
    """Return the bitcode of a module.

    Parameters
    ----------
    entries : mapping
        As `hophoop.lab.wasm.entries.ENTRIES`.

    Returns
    -------
    code : bytes
    """
    from hophoop.kernel.build.lowering import exported, joined

    return joined(exported(name, kernel, kinds, simple=False) for name, (kernel, kinds) in entries.items())


def module_of(name: str) -> bytes:
    """Return one of `MODULES`, linked with the C library, without imports."""
    from hophoop.lab.wasm import entries

    chosen = getattr(entries, MODULES[name].entries)
    machine, module = optimized(module_code(chosen), chosen, TRIPLE, features="+simd128", reloc="static")
    exports = [f"-Wl,--export={each}" for each in (*chosen, "malloc", "free")]
    with tempfile.TemporaryDirectory() as folder:
        part, file = Path(folder) / "kernel.o", Path(folder) / MODULE
        part.write_bytes(machine.emit_object(module))
        zig(["-target", "wasm32-wasi", "-mexec-model=reactor", "-O2", str(RUNTIME), str(part), *LINKED, *exports, "-lm"], file)
        return file.read_bytes()
