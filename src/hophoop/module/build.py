"""Builds the WebAssembly modules from the kernels: Numba's plain IR, retargeted, linked with the C library of WASI.

`python -m hophoop.module.build` writes them; that takes two or three minutes, and the packages of the extra `module`.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Iterable, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

from hophoop._extras import need
from hophoop._files import replacing
from hophoop.kernel.build.link import optimised
from hophoop.module.layout import layout
from hophoop.module.stamp import DERIVATIVES, HERE, LAYOUT, MODULE, sources

TRIPLE = "wasm32-unknown-unknown"
STACK = 1 << 20  # bytes
LINKED = ("-Wl,--no-entry", "-Wl,--export-memory", "-Wl,--strip-all", "-Wl,--gc-sections", f"-Wl,-z,stack-size={STACK}")


def plain_code(entries: Mapping[str, tuple[Any, tuple[Any, ...]]]) -> dict[str, tuple[str, str, tuple[Any, ...]]]:
    """LLVM's code of every entry.

    Parameters
    ----------
    entries : mapping
        As `entries.ENTRIES`.

    Returns
    -------
    code : dict
        Name → (code, name of the function in it, Numba types of its arguments).
    """
    from hophoop._jit.plain import leave_unoptimised, plain

    leave_unoptimised()
    return {name: (*plain(kernel, kinds), kinds) for name, (kernel, kinds) in entries.items()}


def wrapper(name: str, mangled: str, kinds: Iterable[Any]) -> str:
    """A function with the plain name, pointers and 32-bit counts, which calls Numba's."""
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


def joined(code: Mapping[str, tuple[str, str, tuple[Any, ...]]]) -> str:
    """All entries in one."""
    import llvmlite.binding as llvm

    whole = None
    for name, (text, mangled, kinds) in code.items():
        part = llvm.parse_assembly(text + wrapper(name, mangled, kinds))
        if whole is None:
            whole = part
        else:
            whole.link_in(part)
    return str(whole)


def retargeted(text: str, names: Iterable[str]) -> bytes:
    """The object file for WebAssembly."""
    machine, module = optimised(text, names, TRIPLE, features="+simd128", reloc="static")
    made: bytes = machine.emit_object(module)
    return made


def linked(code: bytes, names: Iterable[str], target: Path) -> None:
    """The object file with the C library, as a module without imports."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "kernel.o"
        file.write_bytes(code)
        exports = [f"-Wl,--export={name}" for name in (*names, "malloc", "free")]
        subprocess.run(
            [sys.executable, "-m", "ziglang", "cc", "-target", "wasm32-wasi", "-mexec-model=reactor", "-O2",
             str(HERE / "nrt.c"), str(file), "-o", str(target), *LINKED, *exports, "-lm"],
            check=True,
        )  # fmt: skip


def anonymous(content: bytes) -> bytes:
    """The module without the folder of this machine's packages, which Numba writes into places of errors.

    Parameters
    ----------
    content : bytes

    Returns
    -------
    content : bytes
        Of the same length.
    """
    for place in {Path(sysconfig.get_path(name)) for name in ("purelib", "platlib")} | {HERE.parents[1]}:
        own = str(place).encode()
        content = content.replace(own, b"-" * len(own))
    return content


def module_of(entries: Mapping[str, tuple[Any, tuple[Any, ...]]]) -> bytes:
    """A module.

    Parameters
    ----------
    entries : mapping
        As `entries.ENTRIES`.

    Returns
    -------
    content : bytes
    """
    code = plain_code(entries)
    with tempfile.TemporaryDirectory() as fresh:
        file = Path(fresh) / MODULE
        linked(retargeted(joined(code), code), code, file)
        return anonymous(file.read_bytes())


def build(folder: Path = HERE) -> None:
    """Build the modules, and the file that tells how to call them.

    Parameters
    ----------
    folder : Path
        Where to write `MODULE`, `DERIVATIVES` and `LAYOUT`.

    Raises
    ------
    ImportError
        If ziglang is not installed.
    """
    from hophoop.module.entries import DERIVATIVE_ENTRIES, ENTRIES

    need("ziglang", "module")  # asked for before two minutes of compiling, not after
    contents = {"module": module_of(ENTRIES), "derivatives": module_of(DERIVATIVE_ENTRIES)}
    tags = {name: hashlib.sha256(content).hexdigest()[:16] for name, content in contents.items()}
    for name, file in (("module", MODULE), ("derivatives", DERIVATIVES)):
        with replacing(folder / file) as fresh_file:
            fresh_file.write_bytes(contents[name])
    told = {"sources": sources(), **tags, "built_with": tools(), **layout()}
    with replacing(folder / LAYOUT) as fresh_file:
        fresh_file.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")


def tools() -> dict[str, str]:
    """Versions of the packages that make the module: the same ones make the same bytes.

    Returns
    -------
    tools : dict
    """
    return {name: version(name) for name in ("numba", "llvmlite", "ziglang")}


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as cache:  # compiled code that is there already is for this machine
        os.environ["NUMBA_CACHE_DIR"] = cache
        try:
            build()
        except ImportError as error:
            sys.exit(str(error))
