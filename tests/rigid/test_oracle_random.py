"""Random hoops, planes and starts: the program against SciPy's hybrid integration, event by event."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from hophoop.vocabulary.names import LAW_CODES
from oracle_program import STATE, essential, highest_apexes, program_events, simulate
from oracles import hybrid
from oracles.cases import Case


def draw(seed: int) -> Case:
    """A scenario of any mode, law and slope."""
    random = np.random.default_rng(seed)
    eccentricity = float(random.uniform(0.0, 0.95))
    mu = float(random.choice([0.0, random.uniform(0.05, 1.5)], p=[0.1, 0.9]))
    radius = float(random.choice([1.0, random.uniform(0.1, 2.0)]))
    speed = math.sqrt(9.81 * radius)
    values: dict[str, Any] = {
        "radius": radius,
        "mass": float(random.choice([1.0, random.uniform(0.1, 5.0)])),
        "eccentricity": eccentricity,
        "inertia_ratio": float(random.uniform(0.05, 1.0) * (1.0 - eccentricity**2)),
        "slope": float(random.choice([0.0, random.uniform(-0.5, 0.5)])),
        "mu_static": mu * float(random.choice([1.0, random.uniform(1.0, 1.5)])),
        "mu_kinetic": mu,
        "restitution": float(random.choice([0.0, 0.0, 0.3])),
        "impact_law": str(random.choice(sorted(LAW_CODES))),
        "angle": float(random.uniform(-math.pi, math.pi)),
        "vx": float(random.normal() * speed),
        "omega": float(random.normal() * 1.5 * speed / radius),
    }
    kind = random.choice(["roll", "slip", "drop"], p=[0.5, 0.25, 0.25])
    if kind == "roll":
        values["rolling"] = True
    elif kind == "drop":
        values["height"] = float(random.uniform(0.01, 0.6) * radius)
        values["vy"] = float(random.normal() * 0.3 * speed)
    return Case(f"random {seed}", **values, duration=2.5, max_events=12)


def compare(case: Case) -> None:
    """The same events, and the same state between them, to what DOP853 can give."""
    truth, motion = hybrid.solve(case), simulate(case)
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range
    true = essential(highest_apexes(truth.events))
    ours = essential(program_events(motion))
    if truth.status == "event_limit":
        ours = ours[: len(true)]
    assert [event["kind"] for event in ours] == [event["kind"] for event in true], case
    for mine, right in zip(ours, true, strict=True):
        for name in ("t", *STATE):
            assert mine[name] == pytest.approx(right[name], rel=1e-9, abs=1e-9), (case, right["kind"], name)
        if not right["kind"].startswith("painleve"):
            assert mine["to"] == right["to"], (case, right["t"])
    for part in (0.131, 0.377, 0.522, 0.716, 0.943):
        t = part * truth.end
        sample, right = motion.at(t), truth.at(t)
        assert sample.mode == right["mode"]
        for name in STATE:
            assert getattr(sample, name) == pytest.approx(right[name], rel=1e-9, abs=1e-9), (case, t, name)


@pytest.mark.parametrize("block", [0, *(pytest.param(block, marks=pytest.mark.slow) for block in range(1, 33))])
def test_random_motions(block: int) -> None:
    """Fifteen scenarios in every run; hundreds with -m slow."""
    for seed in range(15 * block, 15 * block + 15):
        compare(draw(seed))
