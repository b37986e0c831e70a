"""From LLVM code to a library: optimized as a whole for a kind of processor, and linked by zig, for any system."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
from collections.abc import Iterable, Sequence
from importlib.metadata import PackageNotFoundError
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from hophoop.kernel.build.kept import keep, kept

HERE = Path(__file__).parent
# detection of the processor's level; the runtime that Numba's code needs
LEVEL, RUNTIME = HERE / "level.c", HERE.parents[1] / "lab" / "wasm" / "nrt.c"


class Target(NamedTuple):
    """A kind of machine.

    Attributes
    ----------
    machine : tuple of str
        `sys.platform` and `platform.machine()` there, in small letters.
    triple : str
        As LLVM calls it.
    zig : str
        As zig calls it, with the oldest C library.
    levels : dict
        Kinds of processors: suffix of the library's file → LLVM's name.
    suffix : str
        Suffix of the library's file.
    """

    machine: tuple[str, str]
    triple: str
    zig: str
    levels: dict[str, str]
    suffix: str


_X86 = {"v2": "x86-64-v2", "v3": "x86-64-v3"}
TARGETS = {
    "linux-x86_64": Target(("linux", "x86_64"), "x86_64-unknown-linux-gnu", "x86_64-linux-gnu.2.28", _X86, ".so"),
    "linux-aarch64": Target(
        ("linux", "aarch64"), "aarch64-unknown-linux-gnu", "aarch64-linux-gnu.2.28", {"v1": "generic"}, ".so"
    ),
    "musllinux-x86_64": Target(("linux", "x86_64"), "x86_64-unknown-linux-musl", "x86_64-linux-musl", _X86, ".so"),
    "musllinux-aarch64": Target(
        ("linux", "aarch64"), "aarch64-unknown-linux-musl", "aarch64-linux-musl", {"v1": "generic"}, ".so"
    ),
    "macos-arm64": Target(("darwin", "arm64"), "arm64-apple-macosx11.0.0", "aarch64-macos.11.0", {"v1": "apple-m1"}, ".dylib"),
    "macos-x86_64": Target(("darwin", "x86_64"), "x86_64-apple-macosx10.15.0", "x86_64-macos.11.0", _X86, ".dylib"),
    "windows-amd64": Target(("win32", "amd64"), "x86_64-pc-windows-gnu", "x86_64-windows-gnu", _X86, ".dll"),
}


def own_target() -> str:
    """Return the name of this machine's target.

    Raises
    ------
    KeyError
        If there is none.
    """
    import platform

    own = sys.platform, platform.machine().lower()
    musl = "musl" in (platform.libc_ver()[0] or "musl") if sys.platform == "linux" else False
    for name, target in TARGETS.items():
        if target.machine == own and name.startswith("musl") == musl:
            return name
    raise KeyError(f"There is no library for {' '.join(own)}.")


def optimized(
    code: bytes, names: Iterable[str], triple: str, cpu: str = "", features: str = "", reloc: str = "pic"
) -> tuple[Any, Any]:
    """Return the code optimized for a machine, by default for the oldest processor of its kind.

    Parameters
    ----------
    code : bytes
        LLVM's bitcode.
    names : iterable of str
        Functions that remain visible.
    triple, cpu, features : str
        LLVM triple of the machine.
    reloc : str, default 'pic'
        LLVM's relocation model.

    Returns
    -------
    machine : llvmlite.binding.TargetMachine
    module : llvmlite.binding.ModuleRef
        For `machine.emit_object` or `machine.emit_assembly`.
    """
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(triple).create_target_machine(
        cpu=cpu, features=features, opt=3, reloc=reloc, codemodel="default"
    )
    module = llvm.parse_bitcode(code)
    module.triple, module.data_layout = triple, str(machine.target_data)
    module.verify()
    visible = set(names)
    for function in module.functions:
        if not function.is_declaration:
            function.linkage = "external" if function.name in visible else "internal"
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    options.loop_vectorization = options.slp_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return machine, module


def object_of(code: bytes, names: Sequence[str], target: str, level: str) -> bytes:
    """Return the object file of functions for a kind of processor."""
    from hophoop.kernel.native.sources import TOOLS, hash_of  # not by pip's hook, which reads `TARGETS` without NumPy

    name = f"{target}-{level}.{hashlib.sha256(code + hash_of({}, TOOLS).encode()).hexdigest()[:32]}.o"
    content = kept(name)
    if content is None:
        machine, module = optimized(code, names, TARGETS[target].triple, TARGETS[target].levels[level])
        content = bytes(machine.emit_object(module))
        keep(name, content)
    return content


def zig_command() -> list[str]:
    """Return the command that starts zig: from the package ziglang, else a program on the path, as conda installs it.

    Raises
    ------
    PackageNotFoundError
        If there is neither.
    """
    if find_spec("ziglang") is not None:
        return [sys.executable, "-m", "ziglang"]
    program = shutil.which("zig")
    if program is None:
        raise PackageNotFoundError("ziglang")
    return [program]


def zig_version() -> str:
    """Return the version of zig.

    Raises
    ------
    PackageNotFoundError
        If there is no zig.
    RuntimeError
        If the program does not run.
    """
    command = [*zig_command(), "version"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)} failed: {done.stderr.strip()[-2000:]}")
    return done.stdout.strip()


def zig(arguments: Iterable[str], file: Path) -> None:
    """Compile and link with zig's C compiler into a file.

    Raises
    ------
    RuntimeError
        If zig fails; the message contains its output.
    """
    command = [*zig_command(), "cc", *arguments, "-o", str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"zig could not link {file.name}: {done.stderr.strip()[-2000:]}")


def linked(code: bytes, target: Target, file: Path) -> bytes:
    """Link an object file into a library, and return its content."""
    part = file.with_suffix(".o")
    part.write_bytes(code)
    options = ["-target", target.zig, "-shared", "-O2", "-g0", str(LEVEL), str(RUNTIME), str(part)]
    if target.suffix != ".dylib":
        options += ["-Wl,-s"]
    if target.suffix == ".so":
        options += ["-lm", "-Wl,--gc-sections", f"-Wl,-soname,{file.name}"]
    zig(options, file)
    return file.read_bytes()
