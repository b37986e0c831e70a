"""A proof ends with its time, whatever it is at: the clock is asked between all steps, of the guesser and of the checker."""

from __future__ import annotations

import sys

import pytest

import hophoop as hh
from hophoop.prove import proof, prove
from hophoop.prove.checker.check import checked
from hophoop.prove.deadline import Deadline

pytest.importorskip("flint")

WHY = "there was no time for it"
# slip, rolling and a hop; slip with turning points; rolling with resistance up to rest
MOTIONS = {
    "hop": hh.Scenario(duration=2.0),
    "rocking": hh.Scenario(plane=hh.Plane(mu=0.1), start=hh.Start(vx=-1.0, omega=1.5, angle=2.0), duration=3.0),
    "resisted": hh.Scenario(plane=hh.Plane(rolling_resistance=0.05), start=hh.Start.rolling(0.5), duration=3.0),
    "bouncing": hh.Scenario(plane=hh.Plane(restitution=0.5), start=hh.Start(height=0.5, omega=2.0), duration=0.8),
}


class Clock:
    """One more second with each look, or more at some of them."""

    def __init__(self, slow: tuple[int, ...] = (), step: float = 1.0) -> None:
        self.looks, self.now, self.slow, self.step = 0, 0.0, slow, step

    def __call__(self) -> float:
        self.looks += 1
        self.now += self.step if self.looks in self.slow else 1.0
        return self.now


@pytest.mark.parametrize("name", MOTIONS)
def test_it_ends_in_time_wherever_the_time_is_over(name):
    counting = Clock()
    whole = proof._prove(MOTIONS[name], 8, "duration", 4000, Deadline(1e9, counting))
    assert whole.proved
    for seconds in [1, 2, 5, *range(10, counting.looks, max(1, counting.looks // 6))]:
        clock = Clock()
        found = proof._prove(MOTIONS[name], 8, "duration", 4000, Deadline(seconds, clock))
        assert clock.now <= 1 + seconds + max(1, 0.1 * seconds)
        assert (found.verdict, found.why, found.certificate) == ("undecided", WHY, None)
        assert found.events == whole.events[: len(found.events)]
        assert len(found.events) <= len(whole.events)


@pytest.mark.parametrize("name", MOTIONS)
def test_few_steps_come_between_two_looks(name):
    """Calls of functions of this package, of the guesser and of the checker."""
    calls, most = 0, 0

    def clock() -> float:
        nonlocal calls, most
        most, calls = max(most, calls), 0
        return 0.0

    def counting(frame, event, _) -> None:
        nonlocal calls
        calls += event == "call" and "prove" in frame.f_code.co_filename

    deadline = Deadline(1.0, clock)
    before = sys.getprofile()
    sys.setprofile(counting)
    try:
        found = proof._prove(MOTIONS[name], 8, "duration", 4000, deadline)
    finally:
        sys.setprofile(before)
    assert found.proved
    assert most < 2000


def test_no_step_is_begun_that_may_end_too_late():
    """Every hundredth step takes 40 s: after the first such one, nothing goes on within 40 s of the end."""
    clock = Clock(tuple(range(100, 100_000, 100)), 40.0)
    found = proof._prove(MOTIONS["hop"], 8, "duration", 4000, Deadline(200.0, clock))
    assert (found.verdict, found.why) == ("undecided", WHY)
    assert clock.now <= 220.0 + 1


def test_longer_steps_are_expected_with_more_digits():
    clock = Clock()
    deadline = Deadline(100.0, clock)
    deadline.ask()
    deadline.expect(120.0)
    assert deadline.over()
    assert clock.now < 5


def test_a_check_that_takes_too_long_does_not_accept():
    certificate = prove(MOTIONS["hop"], 8).certificate
    verdict = checked(certificate, Deadline(20.0, Clock()))
    assert (verdict.accepted, verdict.why) == (False, WHY)
    assert checked(certificate, Deadline(1e9, Clock())).accepted
