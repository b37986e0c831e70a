"""The kernels' code for other processors: nothing fused, nothing of the C library; and as a program it gives the kept bits."""

import re
from collections import Counter

import pytest

from bits_kernels import NATIVE, code_of, program, run_program, why_no_program
from bits_tools import differing, kept_scenarios
from hophoop.lab.wasm.entries import ENTRIES, FATE_ENTRIES

# What is left to call: Numba's runtime (nrt.c), memory, and functions whose result is exact.
RUNTIME = re.compile(r"NRT_\w+|Py\w+|numba_\w+")
MEMORY = {"memset", "memcpy", "memmove", "bzero"}
EXACT = {"floor", "ceil", "trunc", "rint", "fmod", "ldexp", "sqrt"}
INTRINSIC = re.compile(
    r"llvm\.(?:floor|ceil|trunc|rint|sqrt|fabs|copysign|is\.fpclass|memset|memcpy|memmove|lifetime|abs|ctlz|cttz|"
    r"[us]m(?:in|ax)|[us]\w+\.with\.overflow)\b"
)
LOOSE = re.compile(r"= f\w+ (?:fast|contract|reassoc|arcp|afn)\b")

FUSED = re.compile(r"^\s+(v?fn?m(?:add|sub|la|ls)\w*(?:\.\w+)*)", re.MULTILINE)
CALLED = re.compile(r"^\s+(?:bl|b|callq?|jmpq?|tail|jal)\s+\*?([A-Za-z_.$][\w.$@]*)", re.MULTILINE)


def fused(assembly):
    """Instructions that multiply and add at once."""
    return Counter(FUSED.findall(assembly))


def called(assembly):
    """Functions that are not in the code itself."""
    own = set(re.findall(r"^([A-Za-z_.$][\w.$]*):", assembly, re.MULTILINE))
    names = {name.partition("@")[0] for name in CALLED.findall(assembly)}
    return {name.lstrip("_") for name in names - own if not name.startswith((".", "L"))}


def strange(names):
    """Those of them that are neither Numba's, nor memory, nor exact."""
    return {name for name in names if not (RUNTIME.fullmatch(name) or name in MEMORY | EXACT)}


# Numba's own functions, what they call that is inexact, and what stands for it here: the digits of an integer are counted for
# messages; and of a power with an integer exponent that call is for exponents beyond 65,536, the others are products.
NEVER = (("11integer_str", "llvm.log10.f64", "llvm.floor.f64"), ("int_power", "llvm.pow.f64", "llvm.copysign.f64"))


def without_what_never_runs(text):
    """LLVM's code with exact functions in Numba's own branches that no motion gets to."""
    parts = re.split(r"(?m)^(?=define )", text)
    for place, part in enumerate(parts):
        for owner, name, instead in NEVER:
            if "numba7cpython" in (head := part.partition("\n")[0]) and owner in head:
                parts[place] = parts[place].replace(f"call double @{name}(", f"call double @{instead}(")
    whole = "".join(parts)
    for _, name, _ in NEVER:
        if f"call double @{name}(" not in whole:
            whole = re.sub(rf"(?m)^declare [^@]*@{re.escape(name)}\(.*$", "", whole)
    return whole


def assert_exact(text):
    """LLVM's code asks for nothing inexact."""
    text = without_what_never_runs(text)
    assert not LOOSE.findall(text)
    names = set(re.findall(r"^declare [^@]*@([\w.]+)", text, re.MULTILINE))
    assert len(names) > 5
    assert not strange({name for name in names if not INTRINSIC.match(name)})


@pytest.mark.long
def test_the_code_of_fates_asks_for_nothing_inexact():
    assert_exact(code_of(tuple(FATE_ENTRIES), "FATE_ENTRIES"))


@pytest.mark.long
@pytest.mark.timeout(900)
def test_another_processor_gives_the_kept_bits(tmp_path):
    """The code asks for nothing inexact; ARM64's fuses no product with a sum either, and gives the bits."""
    code = code_of(tuple(ENTRIES))
    assert_exact(code)
    missing = why_no_program("aarch64")
    if missing:
        pytest.skip(missing)
    made = program("aarch64", tmp_path, code)
    assembly = made.with_suffix(".s").read_text(encoding="utf-8")
    assert all(re.search(rf"^_?{name}:", assembly, re.MULTILINE) for name in NATIVE)
    assert len(re.findall(r"^\s+fmul", assembly, re.MULTILINE)) > 1000  # it is understood
    assert not fused(assembly)
    assert strange(called(assembly)) <= {"log10", "pow"}  # in what never runs
    assert differing(run_program(made, kept_scenarios(every=8), "aarch64")) == []
