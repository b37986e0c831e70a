"""Compute the kept scenarios in many surroundings and count the motions with other bits: `python benchmarks/bits.py`.

Each surrounding is a process of its own: other BLAS kernels, a C library and a NumPy without the newer instructions,
the library for older processors, interpreted kernels, WebAssembly in Node and in Chromium, and the kernels' code as a
program for ARM64 and RISC-V under qemu. Missing programs (ziglang, qemu,
Node, Chromium) are named. The exit status is 1 where any motion differs.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HERE / "tests"))

GIVEN, OLDER = "as given", "all of these"
OLD_GLIBC = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable"}
# x86-64 of 2009, without AVX and FMA; other processors have one library
OLD_LEVEL = {"HOPHOOP_LEVEL": "v2"} if platform.machine().lower() in ("x86_64", "amd64") else {}
PYTHON, INTERPRETED, NODE, CHROMIUM = "compiled", "interpreted", "node", "chromium"


class Surrounding(NamedTuple):
    """How motions are computed, and with which environment."""

    name: str
    how: str = PYTHON
    environment: dict[str, str | None] = {}  # noqa: RUF012, never changed
    every: int = 1


def surroundings() -> list[Surrounding]:
    """All of them, the one that others are compared with first."""
    numpy_off = {"NPY_DISABLE_CPU_FEATURES": " ".join(optional_features())}
    blas: dict[str, str | None] = {"OPENBLAS_L2_SIZE": None}
    return [
        Surrounding(GIVEN),
        Surrounding("BLAS: by itself", environment={**blas, "OPENBLAS_CORETYPE": None}),
        Surrounding("BLAS: Haswell", environment={**blas, "OPENBLAS_CORETYPE": "Haswell"}),
        Surrounding("BLAS: Nehalem", environment={**blas, "OPENBLAS_CORETYPE": "Nehalem"}),
        Surrounding("C library without AVX2 and FMA", environment={**OLD_GLIBC}),
        Surrounding("library for x86-64-v2", environment={**OLD_LEVEL}),
        Surrounding("NumPy without optional instructions", environment={**numpy_off}),
        Surrounding(OLDER, environment={**blas, "OPENBLAS_CORETYPE": "Nehalem", **OLD_GLIBC, **OLD_LEVEL, **numpy_off}),
        Surrounding("interpreted", INTERPRETED, every=10),
        Surrounding("WebAssembly in Node", NODE),
        Surrounding("WebAssembly in Chromium", CHROMIUM),
        Surrounding("ARM64, under qemu", "aarch64"),
        Surrounding("RISC-V, under qemu", "riscv64"),
    ]


def optional_features() -> list[str]:
    """What this NumPy knows and this processor has beyond the least that NumPy asks for."""
    try:
        from numpy._core import _multiarray_umath as core
    except ImportError:  # before NumPy 2
        from numpy.core import _multiarray_umath as core
    return [name for name in core.__cpu_dispatch__ if core.__cpu_features__.get(name)]


def with_changes(changes: Mapping[str, str | None]) -> dict[str, str]:
    """The environment of this process with changes; None takes a name away."""
    kept = {name: value for name, value in os.environ.items() if name not in changes}
    return kept | {name: value for name, value in changes.items() if value is not None}


# --- one surrounding, in a process of its own ------------------------------------------------------------------------


def compute(how: str, every: int, out: Path) -> None:
    """Compute motions in one way and write their bits."""
    import bits_tools

    kept = bits_tools.kept_scenarios(every)
    if how in (PYTHON, INTERPRETED):
        import hophoop as hh
        from hophoop.kernel.native import forced

        with forced(how):
            found = {each.index: bits_tools.bits_of(hh.simulate(each.scenario)) for each in kept}
    else:
        found = by_module(how, kept)
    np.savez(out, **{f"{index}-{name}": table for index, bits in found.items() for name, table in bits._asdict().items()})


def by_module(how: str, kept: Sequence[object]) -> dict[int, object]:
    """By the kernel's own code, outside of Python; a sentence where something is missing."""
    import shutil

    import bits_kernels

    if how == NODE:
        return bits_kernels.run_node(kept) if shutil.which(NODE) else sys.exit("Node is not installed")
    if how == CHROMIUM:
        from browser_tools import FLAGS, NAMES

        try:
            from playwright import sync_api
        except ImportError:
            sys.exit("playwright is not installed")
        chromium = next((found for name in NAMES if (found := shutil.which(name))), None)
        if chromium is None:
            sys.exit("Chromium is not installed")
        with sync_api.sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
            return bits_kernels.run_page(browser, kept)
    missing = bits_kernels.why_no_program(how)
    if missing:
        sys.exit(missing)
    with tempfile.TemporaryDirectory() as folder:
        return bits_kernels.run_program(bits_kernels.program(how, Path(folder)), kept, how)


def started(surrounding: Surrounding, source: Path, out: Path, every: int) -> str:
    """Run it, and return what is missing for it, or nothing."""
    own = with_changes(surrounding.environment)
    own |= {"PYTHONPATH": str(source / "src"), "HOPHOOP_KERNELS": "compiled"}
    command = [sys.executable, __file__, "--child", surrounding.how, str(max(every, surrounding.every)), str(out)]
    done = subprocess.run(command, env=own, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return ""
    said = done.stderr.strip().splitlines() or ["it ended without a word"]
    if done.returncode == 1 and "Traceback" not in done.stderr:
        return said[-1]
    raise RuntimeError(f"{surrounding.name}: {done.stderr[-3000:]}")


# --- comparing -------------------------------------------------------------------------------------------------------


class Difference(NamedTuple):
    """How far the motions of two surroundings are apart."""

    motions: int
    events: int  # motions with other events
    anything: int  # motions with another number anywhere
    other: int  # motions with other kinds of events, or another number of them
    largest: float  # difference of an event's time, over the duration
    worst: int  # the motion that has it, or −1


def difference(first: Path, second: Path) -> Difference:
    """Compare the bits in two files, of the motions that both have."""
    one, other = np.load(first), np.load(second)
    indices = sorted({int(name.partition("-")[0]) for name in other.files})
    counts = {"events": 0, "anything": 0, "other": 0}
    largest, worst = 0.0, -1
    for index in indices:
        tables = [(one[f"{index}-{name}"], other[f"{index}-{name}"]) for name in ("events", "samples", "ledger")]
        differ = [a.shape != b.shape or a.tobytes() != b.tobytes() for a, b in tables]
        counts["anything"] += any(differ)
        if not differ[0]:
            continue
        counts["events"] += 1
        a, b = tables[0]
        if a.shape != b.shape or (a[:, 1] != b[:, 1]).any():  # the column of kinds
            counts["other"] += 1
        else:
            far = float(np.max(np.abs(a[:, 0] - b[:, 0]))) / max(float(a[-1, 0]), 1e-300)
            if far > largest:
                largest, worst = far, index
    return Difference(len(indices), largest=largest, worst=worst, **counts)


def cells(found: Difference | str) -> str:
    """A row's last columns."""
    if isinstance(found, str):
        return f"{found} | "
    said = f"{found.largest:.1e}" if found.largest else "0"
    if found.other:
        said += f"; {found.other} with other events"
    return f"{found.anything} | {said}"


def run(source: Path, chosen: Sequence[Surrounding], folder: Path, every: int) -> dict[str, Difference | str]:
    """All surroundings of one source tree."""
    found: dict[str, Difference | str] = {}
    reference = folder / "0.npz"
    for place, each in enumerate(chosen):
        begin = time.perf_counter()
        out = folder / f"{place}.npz"
        missing = started(each, source, out, every)
        found[each.name] = missing or difference(reference, out)
        told = found[each.name]
        said = (
            told
            if isinstance(told, str)
            else f"{told.motions} motions, {told.events} with other events, {told.anything} differ"
        )
        if not isinstance(told, str) and told.largest > 0.0:
            said += f", by up to {told.largest:.1e} (motion {told.worst})"
        print(f"{place + 1} of {len(chosen)}  {each.name}: {said} ({time.perf_counter() - begin:.0f} s)", flush=True)
    return found


def table(found: Mapping[str, Difference | str]) -> str:
    """All surroundings but the first in Markdown."""
    lines = ["| surroundings | motions | other bits | largest Δt/duration |", "| --- | --- | --- | --- |"]
    for name, told in found.items():
        if name != GIVEN:
            lines.append(f"| {name} | {'' if isinstance(told, str) else f'{told.motions:,}'} | {cells(told)} |")
    return "\n".join(lines) + "\n"


def main() -> int:
    """Compute, compare, write the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=Path, default=HERE, help="checkout whose src is computed with; this one by default")
    parser.add_argument("--every", type=int, default=1, help="only every so many of the kept scenarios")
    parser.add_argument(
        "--only", nargs="+", default=[], metavar="WORD", help="only surroundings whose name has one of these words"
    )
    parser.add_argument("--markdown", type=Path, help="write the table to this file, such as docs/tables/bits.md")
    parser.add_argument(
        "--run", nargs=argparse.REMAINDER, metavar="COMMAND", help="run a command in all older surroundings at once"
    )
    options = parser.parse_args()
    if options.run:
        older = next(each for each in surroundings() if each.name == OLDER)
        return subprocess.run(options.run, env=with_changes(older.environment), check=False).returncode
    chosen = [
        each
        for each in surroundings()
        if each.name == GIVEN or not options.only or any(word in each.name for word in options.only)
    ]
    with tempfile.TemporaryDirectory() as name:
        results = run(options.source.resolve(), chosen, Path(name), options.every)
    text = table(results)
    print(text)
    if options.markdown is not None:
        options.markdown.write_text(text, encoding="utf-8")
    return int(any(not isinstance(each, str) and each.anything > 0 for each in results.values()))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        compute(sys.argv[2], int(sys.argv[3]), Path(sys.argv[4]))
        sys.exit(0)
    sys.exit(main())
