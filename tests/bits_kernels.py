"""The kernels' own code outside of Python: as LLVM's text, as assembly, as a program for another processor, as the module."""

import base64
import json
import math
import shutil
import subprocess
import sys
import tempfile
from contextlib import closing
from pathlib import Path

import numpy as np

import hophoop as hh
from bits_tools import FOLDER, SAMPLES, bits_of_heads
from checkout import text_of
from hophoop.kernel.build.link import optimized
from hophoop.kernel.compliant.event_loop import MAX_STEPS
from hophoop.kernel.compliant.records import WIDTH
from hophoop.kernel.physics.body import Status
from hophoop.kernel.physics.compliant import FrictionLaw, NormalLaw
from hophoop.kernel.records.cells import CELL, CONTACT
from hophoop.kernel.records.layout import EVENT, SEGMENT
from hophoop.lab.wasm.layout import EVENT_COLUMNS, HEADS, SAMPLE_COLUMNS
from hophoop.lab.wasm.stamp import HERE
from lab_page_tools import serving
from module.module_tools import answered, cell_of, given_of

# Processor → how LLVM and zig call it.
PROCESSORS = {
    "aarch64": ("aarch64-unknown-linux-musl", "aarch64-linux-musl"),
    "riscv64": ("riscv64-unknown-linux-musl", "riscv64-linux-musl"),
}
# What LLVM takes for a plain machine of its kind that zig's C library is made for.
FEATURES = {"riscv64": "+m,+a,+f,+d,+c"}
NATIVE = ("motion", "samples", "compliant_motion", "compliant_samples")


# --- LLVM's code -----------------------------------------------------------------------------------------------------


def code_of(names, table="ENTRIES"):
    """LLVM's code of entries, made in a process of its own: it leaves Numba unoptimised."""
    script = (
        "import llvmlite.binding as llvm; from hophoop.kernel.build.processes import begin; "
        "begin(); from hophoop.kernel.build.browser import module_code; from hophoop.lab.wasm import entries; "
        f"chosen = {{name: entries.{table}[name] for name in {tuple(names)!r}}}; "
        "print(llvm.parse_bitcode(module_code(chosen)))"
    )
    return subprocess.run([sys.executable, "-c", script], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout


# --- a program -------------------------------------------------------------------------------------------------------


def why_no_program(processor):
    """What is missing to build and run a program for it, or nothing."""
    try:
        import ziglang  # noqa: F401
    except ImportError:
        return "ziglang is not installed (the extra `build`)"
    if shutil.which(f"qemu-{processor}") is None:
        return f"qemu-{processor} is not installed (Debian: apt-get install qemu-user)"
    return ""


def program(processor, folder, code=""):
    """The kernel's entries as a static program for a processor, with its assembly next to it; `code`: LLVM's that has them."""
    import llvmlite.binding as llvm

    triple, target = PROCESSORS[processor]
    code = llvm.parse_assembly(code or code_of(NATIVE)).as_bitcode()
    machine, code = optimized(code, NATIVE, triple, features=FEATURES.get(processor, ""))
    assembly, made = folder / f"kernel-{processor}.s", folder / f"kernel-{processor}"
    assembly.write_text(machine.emit_assembly(code), encoding="utf-8")
    subprocess.run(
        [sys.executable, "-m", "ziglang", "cc", "-target", target, "-O2", "-ffp-contract=off", "-static",
         str(FOLDER / "native.c"), str(HERE / "nrt.c"), str(assembly), "-o", str(made), "-lm"],
        check=True,
    )  # fmt: skip
    return made


def ask(kept):
    """What the program reads."""
    return np.array([np.concatenate(([each.kind == "compliant"], *numbers(each.scenario))) for each in kept])


def numbers(scenario):
    """The cell and the contact of a scenario, as the module's entries take them."""
    contact = scenario.contact
    if isinstance(contact, hh.Rigid):
        return cell_of(scenario), np.zeros(len(CONTACT))
    chosen = [
        list(NormalLaw).index(NormalLaw[contact.law.upper().replace("-", "_")]),
        list(FrictionLaw).index(FrictionLaw[contact.friction.upper()]),
        *(getattr(contact, name) for name in CONTACT[2:]),
    ]
    cell = cell_of(scenario.replace("contact", hh.Rigid(max_events=contact.max_events)))
    return cell, np.array([math.nan if each is None else float(each) for each in chosen])


def run_program(made, kept, processor=""):
    """The bits of motions that the program computes; emulated where a processor is named."""
    with tempfile.TemporaryDirectory() as fresh:
        asked, answered = Path(fresh) / "asked", Path(fresh) / "answered"
        ask(kept).astype("<f8").tofile(asked)
        sizes = (
            len(CELL), len(CONTACT), EVENT.itemsize, SEGMENT.itemsize, 8 * WIDTH, len(HEADS), len(EVENT_COLUMNS),
            len(SAMPLE_COLUMNS), SAMPLES, int(Status.BUFFER), MAX_STEPS, CELL.index("max_events"),
        )  # fmt: skip
        emulator = [f"qemu-{processor}"] if processor else []
        subprocess.run([*emulator, str(made), str(asked), str(answered), *map(str, sizes)], check=True)
        content = answered.read_bytes()
    return parted(content, kept)


def parted(content, kept):
    """Bits out of bytes: for each motion its heads, the records of its events and, where it lasts, the rows of its samples."""
    found, place = {}, 0

    def taken(kind, count):
        nonlocal place
        part = np.frombuffer(content, kind, count, place)
        place += part.nbytes
        return part

    for each in kept:
        heads = dict(zip(HEADS, taken("<f8", len(HEADS)).tolist(), strict=True))
        events = taken(EVENT, int(heads["events"]))
        rows = SAMPLES if heads["duration"] > 0.0 else 0
        samples = taken("<f8", rows * len(SAMPLE_COLUMNS)).reshape(rows, len(SAMPLE_COLUMNS))
        found[each.index] = bits_of_heads(heads, events, samples)
    assert place == len(content)
    return found


# --- the module, by the page's kernel ------------------------------------------------------------------------------------

IN_PAGE = """
async (given) => {
  const { HoopModule } = await import("./kernel.js");
  const response = await fetch("./hophoop.wasm");
  const module = new HoopModule(await WebAssembly.compile(await response.arrayBuffer()));
  const asked = JSON.parse(given, (_, value) => (value === "inf" ? Infinity : value));
  %s
  return bits(module, asked);
}
"""


def given_bits(kept):
    """What is asked of `bits` in module/bits.mjs."""
    return {"asked": [given_of(each.scenario) for each in kept], "count": SAMPLES, "eventBytes": EVENT.itemsize}


def run_node(kept):
    """The bits of motions that the module computes in Node."""
    return parted(base64.b64decode(answered([["bits", given_bits(kept)]])[0]), kept)


def run_page(browser, kept):
    """The bits of motions that the module computes in a browser of playwright's."""
    program = IN_PAGE % text_of("tests/module/bits.mjs").replace("export ", "")
    with closing(browser.new_page()) as page, serving() as address:
        page.goto(f"{address}static/licences.txt")  # a page that does nothing
        content = page.evaluate(program, json.dumps(given_bits(kept)))
    return parted(base64.b64decode(content), kept)
