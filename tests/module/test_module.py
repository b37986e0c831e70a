"""The WebAssembly module: what it is made of, that it imports nothing, how its motions end, and regions of the phase plane."""

import hashlib
import json
import math
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from types import FunctionType

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives import transform
from hophoop.kernel.build import __main__ as builder
from hophoop.kernel.build import browser, link, lowering
from hophoop.kernel.native import marks
from hophoop.kernel.native.sources import called, is_kernel
from hophoop.kernel.records.layout import MOST_PANELS
from hophoop.lab.wasm.entries import ENTRIES, FATE_ENTRIES
from hophoop.lab.wasm.layout import HEADS, layout
from hophoop.lab.wasm.stamp import FATES, HERE, LAYOUT, MODULE, sources, stamped
from hophoop.vocabulary.names import MODE_WORDS, mode_words
from module.module_tools import answered, given_of, needs_node

TOLD = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))


def test_the_module_is_that_of_the_sources():
    assert TOLD["sources"] == sources(), "run python -m hophoop.kernel.build browser"
    assert {name: TOLD[name] for name in layout()} == json.loads(json.dumps(layout()))


def source_file(kernel):
    """The file of a kernel; of a generated tangent that of the kernel it belongs to."""
    name = marks.source_of(kernel).__code__.co_filename
    tangent = re.match(r"<tangent of ([\w.]+)\.\w+ by", name)
    return Path(sys.modules[tangent[1]].__file__ if tangent else name)


def test_the_stamp_holds_all_that_decides_the_bytes_and_entries_call_kernels_alone():
    """What is called and is no kernel cannot be compiled, nor is it in the stamp."""
    found, waiting = set(), [kernel for kernel, _ in [*ENTRIES.values(), *FATE_ENTRIES.values()]]
    while waiting:
        kernel = waiting.pop()
        if kernel not in found:
            found.add(kernel)
            waiting += called(kernel)
    files = {source_file(kernel) for kernel in found}
    assert len(files) > 50
    compiling = {Path(module.__file__) for module in (browser, link, lowering, marks, transform)} | {link.RUNTIME}
    assert (files | compiling) - set(stamped()) == set()
    plain = set()
    for function in map(marks.source_of, found):
        values = [function.__globals__.get(name) for name in function.__code__.co_names]
        plain |= {value for value in values if isinstance(value, FunctionType) and value.__module__.startswith("hophoop")}
    plain.discard(marks.replaced)  # which the build compiles to stores
    assert {function.__qualname__ for function in plain if not is_kernel(function)} == set()


def test_the_modules_come_to_the_folder_that_is_named(monkeypatch, tmp_path):
    @contextmanager
    def workers():
        with ThreadPoolExecutor(1) as pool:
            yield pool

    monkeypatch.setattr(builder, "workers", workers)
    monkeypatch.setattr(builder, "module_of", str.encode)
    out = tmp_path / "out"
    assert builder.main(["browser", "--out", str(out)]) == 0
    told = json.loads((out / LAYOUT).read_text(encoding="utf-8"))
    assert told["sources"] == sources()
    assert told.keys() == TOLD.keys()
    for file, name in ((MODULE, "module"), (FATES, "fates_module")):
        assert hashlib.sha256((out / file).read_bytes()).hexdigest()[:16] == told[name]
    assert {file.name for file in out.iterdir()} == {MODULE, FATES, LAYOUT}


@pytest.mark.long
@needs_node
def test_a_motion_ends_by_its_budget_whatever_is_asked():
    long = given_of(hh.Scenario(duration=1e6))
    computed, motion = answered([["compute", long], ["motion", long]])
    assert motion["status"] == "event_limit"
    panels = computed["head"][HEADS.index("panels")]
    assert panels <= MOST_PANELS + 100  # the last step counts itself, and each width that it tries
    assert 1e3 < motion["duration"] < 1e6  # what was computed is told
    assert motion["events"][-1]["t"] == motion["duration"]


@pytest.mark.parametrize(
    "query",
    [
        "",
        "plane.mu=0.4&plane.slope=0.3&hoop.radius=0.3",
        "plane.mu=0.9&plane.rolling_resistance=0.1",
        "hoop.load_fraction=1",
        "plane.gravity=0",
        "plane.mu=inf",
    ],
)
@needs_node
def test_regions(query):
    scenario = hh.Scenario.from_query(query)
    (found,) = answered([["regions", given_of(scenario), (-3.0, 7.0, -12.0, 12.0), 90, 60]])
    angles = -3.0 + (np.arange(90) + 0.5) * (10.0 / 90)
    rates = (-12.0 + (np.arange(60) + 0.5) * (24.0 / 60))[:, None]
    hoop, plane = scenario.hoop, scenario.plane
    words = mode_words(hh.theory.mode_of(angles, rates, hoop, plane), rates)
    places = {word: code for code, word in enumerate(MODE_WORDS)}
    assert found["modes"] == [places.get(word, len(MODE_WORDS)) for word in words.ravel()]
    sides = np.zeros((2, 90))
    if not hoop.massless and math.isfinite(plane.mu_kinetic):
        couple, turning = plane.rolling_resistance, np.array([[-1.0], [1.0]])
        sides[:] = hh.theory.painleve_region(angles, plane.mu_kinetic, hoop, rolling_resistance=couple, omega=turning)
    assert found["paradox"] == sides.ravel().tolist()


def test_it_names_no_machine():
    content = (HERE / MODULE).read_bytes()
    assert b"site-packages" not in content
    assert b"/home/" not in content
