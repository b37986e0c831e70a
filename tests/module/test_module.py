"""The WebAssembly module: what it is made of, that it imports nothing, how its motions end, and regions of the phase plane."""

import hashlib
import json
import math
import re
import sys
from collections import Counter
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
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import Cell, Contact
from hophoop.kernel.records.layout import MOST_PANELS
from hophoop.kernel.records.refusals import Refusal, refusal
from hophoop.lab.wasm.entries import ENTRIES, FATE_ENTRIES
from hophoop.lab.wasm.layout import layout
from hophoop.lab.wasm.stamp import FATES, HERE, LAYOUT, MODULE, sources, stamped
from hophoop.scenario.scenario import contact_of
from hophoop.vocabulary.names import MODE_WORDS, mode_words

pytest.importorskip("wasmtime")

from module.host import Host
from module.module_tools import cell_of

TOLD = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def host():
    return Host(HERE / MODULE)


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


def test_a_motion_ends_by_its_budget_whatever_is_asked(host):
    heads, events = host.motion(cell_of(hh.Scenario(duration=1e6)))
    assert heads["status"] == Status.EVENT_LIMIT
    assert heads["panels"] <= MOST_PANELS + 100  # the last step counts itself, and each width that it tries
    assert 1e3 < heads["duration"] < 1e6  # what was computed is told
    assert events[-1, 0] == heads["duration"]


def test_it_refuses_what_the_library_refuses(host):
    draw = np.random.default_rng(6)
    usual, spring = np.array(cell_of(hh.Scenario())), np.array(contact_of(hh.Compliant()))
    ends = {
        Cell.ECCENTRICITY: [0.3, 1.0, 1.5], Cell.INERTIA_RATIO: [0.0, 1e-13, 1e-12, 1e7],
        Cell.MASS: [1e-13, 1e12], Cell.IDEAL: [0.0, 1.0],
        Cell.MU_STATIC: [0.0, 1.0, math.inf], Cell.SLOPE: [0.1, 1.57, 1.5704, 2.0], Cell.ROLLING_RESISTANCE: [1e-9, 0.5, 1.0],
        Cell.GRAVITY: [0.0, 1e-6], Cell.HEIGHT: [0.0, 1e6], Cell.VY: [1e6], Cell.OMEGA: [1e9], Cell.SLIP: [-1e6],
        Cell.RADIUS: [1e-6, 1e6],
    }  # fmt: skip
    found = Counter()
    for _ in range(1500):
        cell, contact = usual.copy(), spring.copy()
        if draw.random() < 0.3:
            cell[Cell.ECCENTRICITY], cell[Cell.INERTIA_RATIO] = 1.0, 0.0
        for column in draw.choice(list(ends), 2):
            cell[column] = draw.choice(ends[int(column)])
        rows = [Contact.STIFFNESS, Contact.TANGENTIAL_STIFFNESS, Contact.SLIP_SPEED]
        contact[rows] = draw.choice([math.nan, 1e-9, 10.0, 1e5, 1e18], 3)
        given = tuple(contact.tolist()) if draw.random() < 0.6 else ()
        code, number = refusal(cell.tolist(), given)
        np.testing.assert_equal(host.refused(cell, given), (code, number))
        found[code] += 1
    assert len(found) == len(Refusal)


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
def test_regions(host, query):
    scenario = hh.Scenario.from_query(query)
    window = (-3.0, 7.0, -12.0, 12.0)
    codes, paradox = host.regions(cell_of(scenario), window, 90, 60)
    angles = -3.0 + (np.arange(90) + 0.5) * (10.0 / 90)
    rates = (-12.0 + (np.arange(60) + 0.5) * (24.0 / 60))[:, None]
    hoop, plane = scenario.hoop, scenario.plane
    words = mode_words(hh.theory.mode_of(angles, rates, hoop, plane), rates)
    places = {word: code for code, word in enumerate(MODE_WORDS)}
    assert codes.ravel().tolist() == [places.get(word, len(MODE_WORDS)) for word in words.ravel()]
    sides = np.zeros((2, 90))
    if not hoop.massless and math.isfinite(plane.mu_kinetic):
        couple, turning = plane.rolling_resistance, np.array([[-1.0], [1.0]])
        sides[:] = hh.theory.painleve_region(angles, plane.mu_kinetic, hoop, rolling_resistance=couple, omega=turning)
    assert np.array_equal(paradox, sides.ravel())


def test_it_names_no_machine():
    content = (HERE / MODULE).read_bytes()
    assert b"site-packages" not in content
    assert b"/home/" not in content
