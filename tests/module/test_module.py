"""The WebAssembly module gives what the library gives: motions, states, theory, regions, maps."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps
from hophoop._jit import dispatchers, kernels, plain, quicker, store
from hophoop.lab.regions import regions
from hophoop.lab.thresholds import thresholds
from hophoop.maps.cells import make_cells
from hophoop.maps.quantities import make_span
from hophoop.module import build
from hophoop.module.entries import DERIVATIVE_ENTRIES, ENTRIES
from hophoop.module.layout import EVENT_COLUMNS, SAMPLE_COLUMNS, layout
from hophoop.module.stamp import HERE, LAYOUT, MODULE, sources, stamped
from hophoop.physics.body import Status
from hophoop.records.scratch import MOST_PANELS

pytest.importorskip("wasmtime")

from module.host import Host
from module.module_tools import cell_of, drawn, references, worst_time

TOLD = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def host() -> Host:
    return Host(HERE / MODULE)


def test_the_module_is_that_of_the_sources() -> None:
    assert TOLD["sources"] == sources(), "run python -m hophoop.module.build"
    assert {name: TOLD[name] for name in layout()} == json.loads(json.dumps(layout()))


def test_the_stamp_holds_all_that_decides_the_bytes() -> None:
    entries = [*ENTRIES.values(), *DERIVATIVE_ENTRIES.values()]
    files = {Path(part.py_func.__code__.co_filename) for kernel, _ in entries for part in store.reachable(kernel)}
    assert len(files) > 50
    compiling = {Path(module.__file__) for module in (dispatchers, kernels, plain, quicker)}
    assert (files | compiling) - set(stamped()) == set()


def test_the_builder_asks_for_what_it_needs_before_it_compiles(monkeypatch, tmp_path) -> None:
    monkeypatch.setitem(sys.modules, "ziglang", None)
    monkeypatch.setattr(build, "module_of", lambda entries: pytest.fail("it compiles"))
    with pytest.raises(ImportError, match=r"pip install 'hophoop\[module\]'"):
        build.build(tmp_path)
    assert not list(tmp_path.iterdir())


def test_it_imports_nothing(host: Host) -> None:
    assert host.imports == []


def compared(host: Host, scenarios: list[hh.Scenario]) -> tuple[int, float]:
    """How many motions were compared, and the worst difference of an event's time over the duration.

    The few motions that make more of a rounding are held to the error that the library states for them.
    """
    count, worst, amplified = 0, 0.0, 0
    for scenario in scenarios:
        motion = hh.simulate(scenario)
        heads, events = host.motion(cell_of(scenario))
        if not math.isnan(heads["doubt_from"]):  # the library asks more digits then, and the page says so
            continue
        count += 1
        assert TOLD["statuses"][int(heads["status"])] == motion.status, scenario.to_query()
        difference = worst_time(events, motion)
        if difference > 1e-12:  # another rounding, as large as the motion makes of it
            most = float(np.max(motion.errors.t)) / scenario.duration
            assert difference <= 10.0 * most, scenario.to_query()
            amplified += 1
            continue
        worst = max(worst, difference)
    assert amplified <= 1 + 0.01 * count
    return count, worst


def test_rolling_resistance_is_the_same(host: Host) -> None:
    scenarios = [
        scenario.replace("plane.rolling_resistance", 0.03) for scenario in drawn(60, 700) if scenario.hoop.inertia_ratio > 0.01
    ]
    count, _ = compared(host, scenarios)
    assert count > 40
    heads, _ = host.motion(cell_of(scenarios[0]))
    assert heads["rolling_resistance"] == pytest.approx(hh.simulate(scenarios[0]).ledger.rolling_resistance, rel=1e-9)


def test_every_reference_scenario_is_the_same(host: Host) -> None:
    scenarios = references()
    assert len(scenarios) > 20
    count, _ = compared(host, scenarios)
    assert count > 0.8 * len(scenarios)


def test_random_motions_are_the_same(host: Host) -> None:
    count, worst = compared(host, drawn(400))
    assert count > 350
    print(f"{count} motions, worst time {worst:.2g}")


@pytest.mark.slow
def test_twenty_thousand_motions_are_the_same(host: Host) -> None:
    count, worst = compared(host, drawn(20_000))
    assert count > 19_000
    print(f"{count} motions, worst time {worst:.2g}")


def test_energies_add_up(host: Host) -> None:
    for scenario in drawn(100, 400):
        heads, _ = host.motion(cell_of(scenario))
        ledger = hh.simulate(scenario).ledger
        if math.isnan(heads["doubt_from"]):
            assert heads["kinetic"] == pytest.approx(ledger.kinetic, rel=1e-9, abs=1e-9 * ledger.range)
            assert abs(heads["residual"]) <= 1e-9 * ledger.range


def test_a_motion_ends_by_its_budget_whatever_is_asked(host: Host) -> None:
    heads, events = host.motion(cell_of(hh.Scenario(duration=1e6)))
    assert heads["status"] == Status.EVENT_LIMIT
    assert heads["panels"] <= MOST_PANELS + 100  # the last step counts itself, and each width that it tries
    assert 1e3 < heads["duration"] < 1e6  # what was computed is told
    assert events[-1, 0] == heads["duration"]


def test_states_are_the_same(host: Host) -> None:
    names = [name for name in SAMPLE_COLUMNS if name not in ("mode", "utilization")]
    checked = 0
    for scenario in drawn(60, 500):
        heads, _ = host.motion(cell_of(scenario))
        motion = hh.simulate(scenario)
        if not math.isnan(heads["doubt_from"]) or worst_time(host.motion(cell_of(scenario))[1], motion) > 1e-13:
            continue
        for left in (False, True):
            times = np.linspace(0.0, motion.duration, 41)
            found = host.samples(int(heads["segments"]), times, left)
            sample = motion.at(times, side="left" if left else "right")
            for name in names:
                mine, theirs = found[:, SAMPLE_COLUMNS.index(name)], getattr(sample, name)
                size = max(np.nanmax(np.abs(theirs)), 1e-3)
                assert np.nanmax(np.abs(mine - theirs)) <= 1e-8 * size, (name, scenario.to_query())
            letters = np.array(list("RSKHM"))[found[:, 0].astype(int)]
            assert (letters == sample.mode).mean() > 0.97
        checked += 1
    assert checked > 40


def test_states_beside_events_are_on_their_side(host: Host) -> None:
    scenario = hh.Scenario()
    heads, events = host.motion(cell_of(scenario))
    times = events[:, 0].copy()
    after = host.samples(int(heads["segments"]), times)
    before = host.samples(int(heads["segments"]), times[1:], left=True)
    assert np.array_equal(after[:-1, 0], events[:-1, EVENT_COLUMNS.index("to_mode")])
    assert np.array_equal(before[:, 0], events[1:, EVENT_COLUMNS.index("from_mode")])


@pytest.mark.parametrize(
    "query",
    ["", "plane.mu=0.5", "plane.mu=0.3&start.speed=0.1", "hoop.load_fraction=0.4&plane.slope=0.2", "plane.slope=-0.3",
     "hoop.load_fraction=1", "plane.gravity=0", "hoop.eccentricity=0.2&hoop.inertia_ratio=0.5", "plane.mu=inf",
     "start.vx=1&start.omega=2", "plane.rolling_resistance=0.01"],
)  # fmt: skip
def test_theory_is_the_same(host: Host, query: str) -> None:
    scenario = hh.Scenario.from_query(query)
    speed = scenario.start.speed
    found = host.thresholds(cell_of(scenario), math.nan if speed is None else speed)
    known = {quantity.key: quantity.value for quantity in hh.theory.summary(scenario)}
    for name, value in found.items():
        if name in known and known[name] is not None:
            assert value == pytest.approx(known[name], rel=1e-13, abs=1e-14), name
        elif name != "massless_loss_by_friction":
            assert math.isnan(value) or known.get(name) is None, name
    assert thresholds(scenario) is not None


@pytest.mark.parametrize(
    "query", ["", "plane.mu=0.4&plane.slope=0.3", "hoop.load_fraction=1", "plane.gravity=0", "plane.mu=inf"]
)
def test_regions_are_the_same(host: Host, query: str) -> None:
    scenario = hh.Scenario.from_query(query)
    window = (-3.0, 7.0, -12.0, 12.0)
    mine = host.regions(cell_of(scenario), window, 90, 60)
    theirs = regions(scenario, window, 90, 60)
    assert (mine[0] != theirs["modes"]).mean() < 1e-3  # cells on a border, to rounding
    assert np.array_equal(mine[1], theirs["paradox"])


def test_maps_are_the_same(host: Host) -> None:
    base = hh.Scenario()
    mu, speed = np.linspace(0.2, 1.2, 21), np.linspace(0.1, 4.0, 25)
    grid = np.meshgrid(mu, speed, indexing="ij")
    cells = make_cells(base, {"plane.mu": grid[0].ravel(), "start.speed": grid[1].ravel()}, mu.size * speed.size)
    span = make_span("first_revolution")
    numbers, words, _ = host.map_cells(cells, span.angle, span.stop, span.timed, 3)
    theirs = maps.sweep(base, {"plane.mu": mu, "start.speed": speed}, ("hop_height", "hop"), "first_revolution")
    height = numbers[:, TOLD["numbers"].index("hop_height")].reshape(grid[0].shape)
    assert np.allclose(height, theirs["hop_height"].values, rtol=1e-9, atol=1e-12, equal_nan=True)
    hop = words[:, TOLD["words"].index("hop")].reshape(grid[0].shape)
    assert np.array_equal(hop, theirs["hop"].values)


def test_it_names_no_machine() -> None:
    content = (HERE / MODULE).read_bytes()
    assert b"site-packages" not in content
    assert b"/home/" not in content
