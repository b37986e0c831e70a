"""The module of derivatives gives what the library gives: rates of all events, reasons, both sides."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
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


def test_rates_of_random_motions_are_the_same() -> None:
    host, count = Host(HERE / DERIVATIVES), 0
    for scenario in [hh.Scenario(duration=2.0), *references()[::3], *drawn(50, 4000)]:
        motion = hh.simulate(scenario)
        if math.isfinite(motion.doubt) or len(motion.events) > 40 or not math.isfinite(scenario.plane.mu_static):
            continue
        for sign in (1.0, -1.0):
            rates, reasons, failed = host.changes(cell_of(scenario), rates_of(scenario, WRT), sign)
            theirs = propagate(motion, WRT, sign)
            assert reasons.tolist() == theirs.reasons.tolist()
            assert failed.tolist() == theirs.failed.tolist()
            for index in range(len(motion.events)):
                for place, field in enumerate(CHANGE_COLUMNS):
                    expected = theirs.at_event(index, field).rates
                    assert same(rates[index, place], expected), (scenario.to_query(), index, field)
        count += 1
    assert count > 20
