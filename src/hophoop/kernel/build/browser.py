"""The browser's modules: the entries of `hophoop.lab.wasm` as WebAssembly, linked with the C library of WASI."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from hophoop.kernel.build.link import RUNTIME, anonymous, joined, optimised, zig
from hophoop.lab.wasm.stamp import DERIVATIVES, MODULE, sources

TRIPLE = "wasm32-unknown-unknown"
STACK = 1 << 20  # bytes
LINKED = ("-Wl,--no-entry", "-Wl,--export-memory", "-Wl,--strip-all", "-Wl,--gc-sections", f"-Wl,-z,stack-size={STACK}")


class Module(NamedTuple):
    """A module: its file, its name in the layout, and the source of its entries."""

    file: str
    name: str
    entries: str


# Each is compiled in its own process.
MODULES = {
    "browser-motions": Module(MODULE, "module", "ENTRIES"),
    "browser-derivatives": Module(DERIVATIVES, "derivatives", "DERIVATIVE_ENTRIES"),
}


def wrapper(name: str, mangled: str, kinds: Iterable[Any]) -> str:
    """Return LLVM code of a function with a plain name, pointers and 32-bit counts, that calls Numba's function."""
    given, made, passed = [], [], []
    for place, kind in enumerate(kinds):
        if str(kind) == "int64":
            given.append(f"i32 %a{place}")
            made.append(f"  %c{place} = zext i32 %a{place} to i64\n")
            passed.append(f"i64 %c{place}")
        else:
            plain = "double" if str(kind) == "float64" else "ptr"
            given.append(f"{plain} %a{place}")
            passed.append(f"{plain} %a{place}")
    return (
        f"define i32 @{name}({', '.join(given)}) {{\n  %ret = alloca ptr\n  %exc = alloca ptr\n{''.join(made)}"
        f"  %status = call i32 @{mangled}(ptr %ret, ptr %exc, {', '.join(passed)})\n  ret i32 %status\n}}\n"
    )


def _entry_code(name: str, kernel: Any, kinds: tuple[Any, ...]) -> str:
    from hophoop.kernel.build.numba_code import code_of, part_of

    names = {"kernel": part_of(kernel)}
    arguments = ", ".join(f"a{place}" for place in range(len(kinds)))
    exec(f"def entry({arguments}):\n    kernel({arguments})\n", names)
    text, mangled = code_of(names["entry"], kinds)
    return text + wrapper(name, mangled, kinds)


def module_code(entries: Mapping[str, tuple[Any, tuple[Any, ...]]]) -> str:
    """Return the LLVM code of a module; for a build process that ends afterwards.

    Parameters
    ----------
    entries : mapping
        As `hophoop.lab.wasm.entries.ENTRIES`.

    Returns
    -------
    code : str
    """
    from hophoop.kernel.build.numba_code import compiling

    with compiling():
        return joined(_entry_code(name, *entry) for name, entry in entries.items())


def retargeted(text: str, names: Iterable[str]) -> bytes:
    """Return the object file for WebAssembly."""
    machine, module = optimised(text, names, TRIPLE, features="+simd128", reloc="static")
    made: bytes = machine.emit_object(module)
    return made


def linked(code: bytes, names: Iterable[str]) -> bytes:
    """Link the object file with the C library into a module without imports."""
    exports = [f"-Wl,--export={name}" for name in (*names, "malloc", "free")]
    with tempfile.TemporaryDirectory() as folder:
        part, file = Path(folder) / "kernel.o", Path(folder) / MODULE
        part.write_bytes(code)
        zig(["-target", "wasm32-wasi", "-mexec-model=reactor", "-O2", str(RUNTIME), str(part), *LINKED, *exports, "-lm"], file)
        return file.read_bytes()


def module_of(name: str) -> bytes:
    """One of `MODULES`."""
    from hophoop.lab.wasm import entries

    chosen = getattr(entries, MODULES[name].entries)
    return anonymous(linked(retargeted(module_code(chosen), chosen), chosen))


def description_of(contents: Mapping[str, bytes], versions: dict[str, str]) -> dict[str, Any]:
    """Return the description of the modules in `layout.json`: sources, hashes and signatures."""
    from hophoop.lab.wasm.layout import layout  # it imports most kernels, on which a group of the library need not depend

    tags = {MODULES[name].name: hashlib.sha256(content).hexdigest()[:16] for name, content in contents.items()}
    return {"sources": sources(), **tags, "built_with": versions, **layout()}
