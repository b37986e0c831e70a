"""What can be known about the GPU's kernel without a GPU: it compiles, what it needs, and what its code computes.

    pip install -e '.[gpu]'
    python benchmarks/gpu.py                       # compile, assemble, compare
    python benchmarks/gpu.py --motions 20000 --fuse

Numba turns the kernel into NVVM IR, and NVIDIA's compiler turns that, with NVIDIA's library of mathematical
functions (libdevice), into PTX. The same IR with the same libdevice is compiled for this machine's processor here,
and its motions are compared with those of the kernel that the CPU runs. That shows what other sines and roots, and
minima and maxima that pass over nan, do to them. A GPU also fuses products and sums into one rounding (FMA): `--fuse`
lets LLVM do that as well, though not in the same places. It shows nothing of speed.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import llvmlite.binding as llvm
import numpy as np
from stress import cell_of, draw

import hophoop as hh
from hophoop.kernel.records.layout import CELL, EVENT, SEGMENT, MapRequest, MapResults
from hophoop.maps.grid import kernel
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import run_cells
from hophoop.maps.grid.quantities import make_span

ARCHITECTURE = (8, 0)
ROOM = 3000  # events of one motion
WANTED = kernel.FLIGHT_REQUESTED | kernel.UTILIZATION_REQUESTED


def signature() -> Any:
    """Types of the kernel's arguments."""
    from numba import from_dtype, types

    matrix, whole = types.float64[:, ::1], types.int64
    return types.void(
        matrix, whole[::1], types.NamedTuple((types.float64, whole, types.boolean, whole), MapRequest),
        from_dtype(EVENT)[:, ::1], from_dtype(SEGMENT)[::1],
        types.NamedTuple((matrix, types.int32[:, ::1], types.uint64[:, ::1]), MapResults), types.int8[::1],
    )  # fmt: skip


def compile_kernel() -> dict[str, Any]:
    """Compile to PTX and assemble it: seconds, sizes, and what the assembler says."""
    from numba import cuda

    from hophoop.maps.grid.gpu_kernel import evaluate_thread

    begin = time.perf_counter()
    code, _ = cuda.compile_ptx(evaluate_thread, signature(), cc=ARCHITECTURE)
    found: dict[str, Any] = {"PTX: seconds": time.perf_counter() - begin, "PTX: bytes": len(code)}
    assembler = next(path for folder in sys.path for path in Path(folder).glob("nvidia/cuda_nvcc/bin/ptxas"))
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "kernel.ptx").write_text(code)
        begin = time.perf_counter()
        arch = f"-arch=sm_{ARCHITECTURE[0]}{ARCHITECTURE[1]}"
        done = subprocess.run(
            [str(assembler), "-v", arch, "kernel.ptx", "-o", "kernel.cubin"],
            cwd=folder, check=True, capture_output=True, text=True,
        )  # fmt: skip
        found["machine code: seconds"] = time.perf_counter() - begin
        found["machine code: bytes"] = (Path(folder) / "kernel.cubin").stat().st_size
    said = done.stdout + done.stderr
    for name, pattern in {
        "registers a thread": r"Used (\d+) registers",
        "local memory a thread: bytes": r"(\d+) bytes cumulative stack",
        "constant tables: bytes": r"(\d+) bytes cmem\[3\]",
    }.items():
        found[name] = int(re.findall(pattern, said)[0])
    return found


# The few instructions of an NVIDIA processor that libdevice asks for, in words that every processor knows.
REPLACEMENTS = {
    "floor.d": "floor", "ceil.d": "ceil", "trunc.d": "trunc", "fabs.f64": "fabs", "sqrt.rn.d": "sqrt",
    "fmin.d": "minnum", "fmax.d": "maxnum", "fma.rn.d": "fma",
}  # fmt: skip
BY_HAND = """
@block = global i32 0
define i32 @"host.read.ptx.sreg.tid.x"() { ret i32 0 }
define i32 @"host.read.ptx.sreg.ntid.x"() { ret i32 1 }
define i32 @"host.read.ptx.sreg.ctaid.x"() { %v = load i32, ptr @block
 ret i32 %v }
define i32 @__nvvm_reflect(ptr %p) { ret i32 0 }
declare float @llvm.fabs.f32(float)
declare double @llvm.rint.f64(double)
declare i32 @llvm.fptosi.sat.i32.f64(double)
define float @"host.fabs.f32"(float %x) { %r = call float @llvm.fabs.f32(float %x)
 ret float %r }
define float @"host.fabs.ftz.f32"(float %x) { %r = call float @llvm.fabs.f32(float %x)
 ret float %r }
define double @"host.add.rn.d"(double %x, double %y) { %r = fadd double %x, %y
 ret double %r }
define double @"host.mul.rn.d"(double %x, double %y) { %r = fmul double %x, %y
 ret double %r }
define i32 @"host.d2i.rn"(double %x) { %r = call double @llvm.rint.f64(double %x)
 %i = call i32 @llvm.fptosi.sat.i32.f64(double %r)
 ret i32 %i }
define double @"host.lohi.i2d"(i32 %lo, i32 %hi) { %a = zext i32 %lo to i64
 %b = zext i32 %hi to i64
 %c = shl i64 %b, 32
 %d = or i64 %c, %a
 %e = bitcast i64 %d to double
 ret double %e }
define i32 @"host.d2i.lo"(double %x) { %a = bitcast double %x to i64
 %r = trunc i64 %a to i32
 ret i32 %r }
define i32 @"host.d2i.hi"(double %x) { %a = bitcast double %x to i64
 %b = lshr i64 %a, 32
 %r = trunc i64 %b to i32
 ret i32 %r }
define internal double @coarse(double %x) { %b = bitcast double %x to i64
 %c = and i64 %b, -4294967296
 %d = bitcast i64 %c to double
 ret double %d }
define double @"host.rcp.approx.ftz.d"(double %x) { %r = fdiv double 1.0, %x
 %d = call double @coarse(double %r)
 ret double %d }
define double @host_rsqrt(double %x) { %s = call double @llvm.sqrt.f64(double %x)
 %r = fdiv double 1.0, %s
 %d = call double @coarse(double %r)
 ret double %d }
"""
# Assembly inside libdevice, by what it contains: sums, differences and products of 128 bits, and 1/√x.
ASSEMBLY = (
    ("rsqrt", "host_rsqrt"),
    ("mad.lo.cc.u32   r0", "host_mad"),
    ("sub.cc", "host_sub"),
    ("add.cc.u32      r0", "host_add"),
    ("mul.lo.u32      r0, alo, blo", "host_mul"),
)


def _wide(name: str, arguments: str, lines: list[str]) -> str:
    """A function that gives 128 bits as a pair."""
    low = ["%lo = trunc i128 %r to i64", "%s = lshr i128 %r, 64", "%hi = trunc i128 %s to i64"]
    pair = ["%p = insertvalue { i64, i64 } undef, i64 %lo, 0", "%q = insertvalue { i64, i64 } %p, i64 %hi, 1"]
    body = "\n ".join([*lines, *low, *pair, "ret { i64, i64 } %q"])
    return f"define {{ i64, i64 }} @{name}({arguments}) {{ {body} }}\n"


def host_library() -> str:
    """What stands for an NVIDIA processor's instructions, as LLVM IR."""
    text = BY_HAND
    for name, plain in REPLACEMENTS.items():
        count = {"fma.rn.d": 3, "fmin.d": 2, "fmax.d": 2}.get(name, 1)
        types = ", ".join(["double"] * count)
        values = ", ".join(f"double %x{i}" for i in range(count))
        text += f"declare double @llvm.{plain}.f64({types})\n"
        text += f'define double @"host.{name}"({values}) {{ %r = call double @llvm.{plain}.f64({values})\n ret double %r }}\n'
    wide = {letter: f"%{letter}w = zext i64 %{letter} to i128" for letter in "abcd"}
    text += _wide("host_mul", "i64 %a, i64 %b", [wide["a"], wide["b"], "%r = mul i128 %aw, %bw"])
    text += _wide(
        "host_mad", "i64 %a, i64 %b, i64 %c",
        [wide["a"], wide["b"], wide["c"], "%m = mul i128 %aw, %bw", "%r = add i128 %m, %cw"],
    )  # fmt: skip
    joined = ["%bh = shl i128 %bw, 64", "%u = or i128 %bh, %aw", "%dh = shl i128 %dw, 64", "%v = or i128 %dh, %cw"]
    for what in ("add", "sub"):
        lines = [*wide.values(), *joined, f"%r = {what} i128 %u, %v"]
        text += _wide(f"host_{what}", "i64 %a, i64 %b, i64 %c, i64 %d", lines)
    return text


def _portable(text: str, fuse: bool) -> str:
    text = re.sub(r"^target (triple|datalayout).*$", "", text, flags=re.MULTILINE).replace("llvm.nvvm.", "host.")
    return re.sub(r"= (fadd|fsub|fmul) double", r"= \1 contract double", text) if fuse else text


def _without_assembly(text: str) -> str:
    def replace(found: re.Match[str]) -> str:
        for mark, name in ASSEMBLY:
            if mark in found[2]:
                return f"call {found[1]} @{name}("
        return found[0]  # of functions that the kernel does not call

    text = re.sub(r'call ([^@\n]*?) asm (?:sideeffect )?("[^"]*"), "[^"]*"\(', replace, text)
    declared = "".join(f"declare {{ i64, i64 }} @host_{what}({arguments})\n" for what, arguments in {
        "mul": "i64, i64", "mad": "i64, i64, i64", "add": "i64, i64, i64, i64", "sub": "i64, i64, i64, i64",
    }.items())  # fmt: skip
    return text + "declare double @host_rsqrt(double)\n" + declared


def _flat(array: np.ndarray) -> list[Any]:
    """An array as Numba hands it over."""
    return [None, None, array.size, array.itemsize, array.ctypes.data, *array.shape, *array.strides]


def kernel_on_the_cpu(fuse: bool) -> Callable[..., None]:
    """The kernel's NVVM IR with libdevice, compiled for this processor: a function as `kernel.evaluate`."""
    from numba.cuda import compiler
    from numba.cuda.cudadrv.libs import open_libdevice

    from hophoop.maps.grid.gpu_kernel import evaluate_thread

    made, _ = compiler._compile_pyfunc_with_fixup(
        evaluate_thread, signature(), debug=False, lineinfo=False, device=False, fastmath=False, cc=ARCHITECTURE,
        opt=True, abi="numba", abi_info=None,
    )  # fmt: skip
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    first, *others = made.llvm_strs
    module = llvm.parse_assembly(_portable(first, fuse))
    for text in others:
        module.link_in(llvm.parse_assembly(_portable(text, fuse)))
    library = llvm.parse_bitcode(open_libdevice())
    module.link_in(llvm.parse_assembly(_without_assembly(_portable(str(library), False))))
    module.link_in(llvm.parse_assembly(host_library()))
    for part in [*module.functions, *module.global_variables]:
        if not part.is_declaration and part.name not in (made._entry_name, "block"):
            part.linkage = "internal"
    machine = llvm.Target.from_default_triple().create_target_machine(
        opt=2, jit=True, cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten()
    )
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    builder.getModulePassManager().run(module, builder)
    left = {part.name for part in module.functions if part.is_declaration and not part.name.startswith("llvm.")}
    if left:
        raise RuntimeError(f"nothing stands for {', '.join(sorted(left))}.")
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    pointer, whole = ctypes.c_void_p, ctypes.c_int64
    vector = [pointer, pointer, whole, whole, pointer, whole, whole]
    matrix = [*vector, whole, whole]
    run = ctypes.CFUNCTYPE(
        None, *matrix, *vector, ctypes.c_double, whole, ctypes.c_uint8, whole, *matrix, *vector, *matrix, *matrix,
        *matrix, *vector,
    )(engine.get_function_address(made._entry_name))  # fmt: skip

    def evaluate(
        cells: np.ndarray, angle: float, stop: int, timed: bool, wanted: int,
        numbers: np.ndarray, words: np.ndarray, keys: np.ndarray,
    ) -> None:  # fmt: skip
        cells = np.ascontiguousarray(cells)
        cells[CELL.index("max_events")] = np.minimum(cells[CELL.index("max_events")], ROOM)
        todo, finished = np.zeros(1, np.int64), np.zeros(1, np.int8)
        events, segments = np.empty((1, ROOM + 2), EVENT), np.empty(1, SEGMENT)
        for k in range(cells.shape[1]):
            todo[0] = k
            run(
                *_flat(cells), *_flat(todo), angle, stop, timed, wanted, *_flat(events), *_flat(segments),
                *_flat(numbers), *_flat(words), *_flat(keys), *_flat(finished),
            )  # fmt: skip

    evaluate.engine = engine  # type: ignore[attr-defined]  # the code lives as long as this
    return evaluate


def at_a_border(cell: np.ndarray, span_name: str, size: float = 1e-14) -> bool:
    """Whether the CPU's own class of a cell changes where its numbers change in their last digits."""
    random = np.random.default_rng(1)
    near = np.repeat(cell[:, None], 200, axis=1)
    for name in ("eccentricity", "inertia_ratio", "slope", "mu_static", "height", "vy", "omega", "slip"):
        near[CELL.index(name)] *= 1.0 + size * random.standard_normal(200)
    near[CELL.index("angle")] += size * random.standard_normal(200)
    near[CELL.index("mu_kinetic")] = np.minimum(near[CELL.index("mu_kinetic")], near[CELL.index("mu_static")])
    found = run_cells(near, make_span(span_name), 0, "serial")
    return len(np.unique(np.concatenate([found.sequences, found.words.astype(np.uint64)], axis=1), axis=0)) > 1


def compare(evaluate: Callable[..., None], cells: np.ndarray, span_name: str) -> dict[str, Any]:
    """How the two differ over some cells; differences beside the larger of the number and 1."""
    span = make_span(span_name)
    cells = cells.copy()
    cells[CELL.index("max_events")] = np.minimum(cells[CELL.index("max_events")], ROOM)
    ours = run_cells(cells, span, WANTED, "serial")
    theirs = MapResults(*(np.empty_like(array) for array in ours))
    evaluate(cells, span.angle, span.stop, span.timed, WANTED, *theirs)
    same = (ours.sequences == theirs.sequences).all(1) & (ours.words == theirs.words).all(1)
    a, b = ours.numbers[same], theirs.numbers[same]
    off = np.where((a == b) | (np.isnan(a) & np.isnan(b)), 0.0, np.abs(a - b) / np.maximum(np.abs(a), 1.0))
    off = np.where(np.isnan(off), np.inf, off)
    radius, gravity = cells[CELL.index("radius")], np.maximum(cells[CELL.index("gravity")], 1.0)
    fast = np.abs(cells[CELL.index("omega")]) * np.sqrt(radius / gravity)
    worst = off.max(axis=0)
    return {
        "motions": len(same),
        "of another class": [int(k) for k in np.flatnonzero(~same)],
        "of these not at a border": [int(k) for k in np.flatnonzero(~same) if not at_a_border(cells[:, k], span_name)],
        "share with every number to 1e-10": float(np.mean((off <= 1e-10).all(axis=1))),
        "beyond that": int(np.sum((off > 1e-10).any(axis=1))),
        "fastest start of these, in √(gR)": float(np.max(fast[same][(off > 1e-10).any(axis=1)], initial=0.0)),
        "99.9 % of numbers within": float(np.quantile(off, 0.999)),
        "largest difference": {name: float(value) for name, value in zip(kernel.NUMBERS, worst, strict=True)},
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--motions", type=int, default=100_000, help="first revolutions; a tenth as many of any kind")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--fuse", action="store_true", help="let products and sums be rounded once")
    parser.add_argument("--no-ptx", action="store_true", help="leave out compiling for CUDA")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    from numba.cuda import dispatcher

    # Numba compiles functions of the CPU for the GPU that is there.
    dispatcher.get_current_device = lambda: SimpleNamespace(compute_capability=ARCHITECTURE)
    result: dict[str, Any] = {}
    if not options.no_ptx:
        result["compiling"] = compile_kernel()
    evaluate = kernel_on_the_cpu(options.fuse)
    random = np.random.default_rng(options.seed)
    count = options.motions
    values = {"plane.mu": random.uniform(0, 2, count), "start.speed": random.uniform(0, 5, count)}
    result["first revolutions"] = compare(evaluate, make_cells(hh.Scenario(), values, count), "first_revolution")
    anything = np.array([cell_of(draw(options.seed, index)[1]) for index in range(count // 10)]).T
    result["motions of any kind"] = compare(evaluate, anything, "duration")
    print(json.dumps(result, indent=2))
    if options.json is not None:
        options.json.write_text(json.dumps(result, indent=2))
    return 0


if __name__ == "__main__":
    sys.exit(main())
