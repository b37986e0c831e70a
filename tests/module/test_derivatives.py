"""The module of derivatives gives what the library gives: rates of all events, reasons, both sides."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from hophoop.derivatives.layout import Reason
from hophoop.derivatives.results.propagation import propagate
from hophoop.lab.wasm.layout import CHANGE_COLUMNS
from hophoop.lab.wasm.stamp import DERIVATIVES, HERE

pytest.importorskip("wasmtime")

from module.host import Host
from module.module_tools import cell_of, drawn, rates_of, references, same

WRT = (
    "plane.mu_kinetic",
    "plane.slope",
    "plane.gravity",
    "plane.restitution",
    "hoop.radius",
    "hoop.mass",
    "start.x",
    "start.angle",
)


@pytest.fixture(scope="module")
def host() -> Host:
    return Host(HERE / DERIVATIVES)


def assert_same(host: Host, scenario: hh.Scenario, paths: tuple[str, ...]) -> None:
    """All rates of all events are those of the library, to the last bit."""
    motion = hh.simulate(scenario)
    for sign in (1.0, -1.0):
        rates, reasons, failed = host.changes(cell_of(scenario), rates_of(scenario, paths), sign)
        theirs = propagate(motion, paths, sign)
        assert reasons.tolist() == theirs.reasons.tolist()
        assert failed.tolist() == theirs.failed.tolist()
        for index in range(len(motion.events)):
            for place, field in enumerate(CHANGE_COLUMNS):
                assert same(rates[index, place], theirs.at_event(index, field).rates), (scenario.to_query(), index, field)


def test_it_imports_nothing(host: Host) -> None:
    assert host.imports == []


def test_rates_of_the_reference_motion_are_the_same(host: Host) -> None:
    paths = ("start.speed", "hoop.load_fraction", "plane.mu", "duration", *WRT)
    assert_same(host, hh.Scenario(duration=2.0), paths)


def test_a_start_in_the_air_and_bounces_are_the_same(host: Host) -> None:
    start = hh.Start(height=0.3, vx=1.0, omega=2.0, angle=0.4)
    for restitution in (0.0, 0.5):
        scenario = hh.Scenario(duration=1.5, start=start, plane=hh.Plane(mu=0.3, restitution=restitution))
        paths = ("plane.mu", "start.height", "start.vx", "start.vy", "start.omega", *WRT)
        assert_same(host, scenario, paths)


def test_rolling_resistance_is_the_same(host: Host) -> None:
    scenario = hh.Scenario(duration=2.0).replace("plane.rolling_resistance", 0.02)
    assert_same(host, scenario, ("plane.rolling_resistance", "plane.mu", "start.speed", *WRT))


def test_reasons_are_told(host: Host) -> None:
    """A landing with e = 0, which any restitution turns into bounces."""
    scenario = hh.Scenario(duration=2.0)
    _, reasons, failed = host.changes(cell_of(scenario), rates_of(scenario, ("plane.restitution", "plane.mu")), 1.0)
    assert reasons.tolist() == [Reason.PLASTIC, Reason.NONE]
    kinds = [event.kind for event in hh.simulate(scenario).events]
    assert [int(each) for each in failed] == [kinds.index("impact"), -1]


def test_rates_of_random_motions_are_the_same(host: Host) -> None:
    count = 0
    for scenario in [*references()[::3], *drawn(50, 4000)]:
        motion = hh.simulate(scenario)
        if math.isfinite(motion.doubt) or len(motion.events) > 40 or not math.isfinite(scenario.plane.mu_static):
            continue
        assert_same(host, scenario, WRT)
        count += 1
    assert count > 20
