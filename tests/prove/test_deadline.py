"""A proof ends with its time, whatever it is at: the clock is asked between all steps."""

from __future__ import annotations

import pytest

import hophoop as hh

pytest.importorskip("flint")

from hophoop.precise.problem import Problem
from hophoop.prove.solver import LATE, prove_problem

# slip, rolling and a hop; slip with turning points; rolling with resistance up to rest
MOTIONS = {
    "hop": hh.Scenario(duration=2.0),
    "rocking": hh.Scenario(plane=hh.Plane(mu=0.1), start=hh.Start(vx=-1.0, omega=1.5, angle=2.0), duration=3.0),
    "resisted": hh.Scenario(plane=hh.Plane(rolling_resistance=0.05), start=hh.Start.rolling(0.5), duration=3.0),
    "bouncing": hh.Scenario(plane=hh.Plane(restitution=0.5), start=hh.Start(height=0.5, omega=2.0), duration=0.8),
}


def proved(scenario, looks):
    """The proof of a motion whose time is over after so many looks at the clock, and how many there were."""
    count = 0

    def late():
        nonlocal count
        count += 1
        return count > looks

    return prove_problem(scenario, Problem.of(scenario), 8, "duration", 4000, late), count


@pytest.mark.parametrize("name", MOTIONS)
def test_it_ends_in_time_wherever_the_time_is_over(name):
    whole, looks = proved(MOTIONS[name], 10**9)
    assert whole.proved
    assert looks > 5
    for most in (0, 1, 5, *range(10, looks, max(1, looks // 6))):
        found, count = proved(MOTIONS[name], most)
        assert count == most + 1
        assert (found.verdict, found.why) == ("undecided", LATE)
        assert found.events == whole.events[: len(found.events)]
