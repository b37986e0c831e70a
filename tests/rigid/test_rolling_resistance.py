"""Rolling resistance: motions against an independent integrator, and what must hold for all of them."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from oracle_program import simulate
from oracles import resistance
from oracles.cases import Case, rolling

# (case, f, sequence): each kind of event, to both sides, on the level and on slopes, to the end at rest
CASES = [
    (rolling("slow", 0.5, 1.0, duration=5.0), 0.02, "R"),
    (rolling("hops", 3.1, 1.0, duration=2.6), 0.001, None),
    (rolling("comes to rest", 2.0, 1.0, duration=6.0), 0.3, None),
    (rolling("slips to rest", 3.1, 0.2, duration=6.0), 0.3, None),
    (rolling("slope", 1.0, 0.6, slope=0.1, angle=0.4, duration=3.0), 0.05, None),
    (rolling("back", -2.5, 0.5, slope=0.05, duration=3.0), 0.1, None),
    (Case("skids", vx=3.0, omega=-2.0, angle=1.0, mu_static=0.5, mu_kinetic=0.4, duration=2.0), 0.05, None),
    (Case("spins", vx=0.0, omega=9.0, angle=2.0, mu_static=0.3, mu_kinetic=0.3, duration=2.0), 0.08, None),
    (Case("slides without turning", vx=2.0, angle=0.3, eccentricity=0.5, inertia_ratio=0.6,
          mu_static=0.2, mu_kinetic=0.2, duration=3.0), 0.9, None),
    (Case("lands", height=0.3, vx=1.0, omega=3.0, angle=0.5, eccentricity=0.3, inertia_ratio=0.7,
          mu_static=0.6, mu_kinetic=0.5, duration=2.0), 0.06, None),
    (Case("scaled", radius=0.35, mass=2.2, eccentricity=0.6, inertia_ratio=0.3, vx=1.3, rolling=True, gravity=1.6,
          mu_static=0.4, mu_kinetic=0.3, duration=4.0), 0.04, None),
    (Case("steep, from rest", slope=0.5, angle=-0.9, mu_static=0.4, mu_kinetic=0.3, duration=1.5), 0.02, None),
]  # fmt: skip


def sizes(case: Case) -> dict[str, float]:
    """Natural sizes of the numbers of a motion."""
    second = math.sqrt(case.radius / case.gravity)
    speed = case.radius / second
    return {"t": second, "x": case.radius, "height": case.radius, "angle": 1.0, "vx": speed, "vy": speed,
            "omega": 1.0 / second, "energy": case.mass * speed**2}  # fmt: skip


def program(case: Case, f: float) -> hh.Trajectory:
    scenario = simulate(case).scenario.with_values({"plane.rolling_resistance": f})
    return hh.simulate(scenario)


@pytest.mark.parametrize(("case", "f", "sequence"), CASES, ids=[case.name for case, *_ in CASES])
def test_agrees_with_an_integrator_in_time(case: Case, f: float, sequence: str | None) -> None:
    exact = resistance.solve(case, f)
    motion = program(case, f)
    size = sizes(case)
    ours = [event for event in motion.events if event.kind not in ("start", "apex", "end", "painleve_inconsistent")]
    if exact.status == "at_rest":
        assert motion.status == "at_rest"
    assert len(ours) == len(exact.events)
    assert motion.sequence == exact.sequence == (sequence or exact.sequence)
    for event, true in zip(ours, exact.events, strict=False):
        for name in ("t", "x", "height", "angle", "vx", "vy", "omega"):
            assert getattr(event, name) == pytest.approx(true[name], rel=1e-9, abs=2e-10 * size[name]), (event.kind, name)
        assert event.to_mode == true["to"]
        assert event.rolling_resistance == pytest.approx(true["rolling"], rel=1e-9, abs=1e-10 * size["energy"])
    assert abs(exact.residual) < 1e-9 * size["energy"]
    assert abs(motion.ledger.residual) < 1e-11 * motion.ledger.range
    middle = 0.37 * motion.duration
    if exact.pieces[-1][0] > middle:
        sample = motion.at(middle)
        true_state = exact.at(middle)
        for k, name in enumerate(("x", "height", "angle", "vx", "vy", "omega")):
            assert getattr(sample, name) == pytest.approx(true_state[k], rel=1e-9, abs=2e-10 * size[name]), name
        assert sample.rolling_resistance == pytest.approx(true_state[7], rel=1e-9, abs=1e-10 * size["energy"])


def test_events_of_the_cases_cover_the_kinds() -> None:
    kinds = {event.kind for case, f, _ in CASES for event in program(case, f).events}
    assert kinds >= {"turn", "rest", "slip_start", "stick", "takeoff", "impact", "slip_reversal"}
