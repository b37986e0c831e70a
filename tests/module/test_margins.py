"""The module's margins are those that the explanation of a motion tells, and follow from its states and laws."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("wasmtime", reason="wasmtime is not installed")

import hophoop as hh
from hophoop.kernel.rigid.sampling import MARGINS
from hophoop.lab.wasm.layout import SAMPLE_COLUMNS
from hophoop.lab.wasm.stamp import HERE, MODULE
from module.host import Host
from module.module_tools import cell_of, drawn


@pytest.fixture(scope="module")
def host() -> Host:
    return Host(Path(HERE / MODULE))


def margins(host: Host, scenario: hh.Scenario, times: np.ndarray, left: bool = False) -> dict[str, np.ndarray]:
    heads, _ = host.motion(cell_of(scenario))
    rows = host.margins(int(heads["segments"]), times, left)
    return {name: rows[:, place] for place, name in enumerate(MARGINS)}


@pytest.mark.parametrize(
    "query", ["", "plane.mu=0.5", "plane.mu_static=0.6&plane.mu_kinetic=0.4&start.speed=2", "plane.slope=0.2&plane.mu=0.4",
              "plane.rolling_resistance=0.02&plane.mu=0.4", "hoop.radius=0.3&hoop.mass=2", "hoop.load_fraction=1"],
)  # fmt: skip
def test_they_are_those_of_the_explanation(host: Host, query: str) -> None:
    scenario = hh.Scenario.from_query(query).replace("duration", 2.0)
    checked = 0
    for phase in hh.phases(scenario):
        if phase.t_end <= phase.t_begin:
            continue
        found = margins(host, scenario, np.array([phase.t_begin]))
        for name in MARGINS:
            theirs = getattr(phase.begin, name)
            mine = float(found[name][0])
            assert mine == theirs or (math.isnan(mine) and math.isnan(theirs)), (name, phase.mode)
        checked += 1
    assert checked > 1


def test_forces_are_those_of_the_states_and_signs_are_those_of_the_modes(host: Host) -> None:
    met = set()
    for scenario in drawn(80, 700):
        heads, _ = host.motion(cell_of(scenario))
        if not math.isnan(heads["doubt"]) or scenario.contact.model != "rigid":
            continue
        times = np.linspace(0.0, heads["duration"], 60)[1:-1]
        states = dict(zip(SAMPLE_COLUMNS, host.samples(int(heads["segments"]), times).T, strict=True))
        found = margins(host, scenario, times)
        letters = np.array(list("RSKHM"))[states["mode"].astype(int)]
        known = np.isfinite(found["normal_force"])
        size = np.nanmax(np.abs(states["normal_force"]), initial=1e-6)
        for name in ("normal_force", "friction_force"):
            assert np.abs(found[name] - states[name])[known].max(initial=0.0) <= 1e-7 * size, (name, scenario.to_query())
        mu_s, mu_k = scenario.plane.mu_static, scenario.plane.mu_kinetic
        for letter, mu in (("R", mu_s), ("S", mu_k), ("K", mu_k)):
            here = known & (letters == letter) & (found["normal_force"] > 1e-6 * size)
            if not here.any():
                continue
            met.add(letter)
            # within the cone, and on its edge in slip, against the slip
            assert np.all(np.abs(found["friction_force"][here]) <= found["friction_limit"][here] * (1 + 1e-9) + 1e-9 * size)
            if math.isfinite(mu):
                assert found["friction_limit"][here] == pytest.approx(mu * found["normal_force"][here])
            if letter != "R":
                sigma = 1.0 if letter == "K" else -1.0
                assert np.all(sigma * found["friction_force"][here] <= 0.0)
                assert np.all(found["p_sigma"][here] > 0.0)
                # N = −f_n m/p_σ, the law of slip, where nothing resists the rolling
                if scenario.plane.rolling_resistance == 0.0:
                    law = -scenario.hoop.mass * found["free_acceleration"][here] / found["p_sigma"][here]
                    assert law == pytest.approx(found["normal_force"][here], rel=1e-6, abs=1e-9 * size)
        air = letters == "H"
        assert np.all(found["height"][air] >= 0.0)
        assert np.all(found["normal_force"][air] == 0.0)
    assert met == {"R", "S", "K"}
