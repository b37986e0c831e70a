"""The computed motion that a proof is guided by. Nothing here has to be right: what it leads to is checked."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from hophoop.kernel.physics.body import EVENT_NAMES, MODE_LETTERS
from hophoop.precise.kernels import Number
from hophoop.precise.problem import Problem
from hophoop.precise.solver import solve_problem
from hophoop.prove._flint import Ball, arb, precision
from hophoop.prove.deadline import Deadline
from hophoop.scenario import Scenario
from hophoop.simulation.simulate import simulate

DURATION, REVOLUTION = "duration", "revolution"
LONGEST = 1e4  # √(R/g), of a revolution
FIRST = 200  # events of a first revolution
FURTHER = 10  # events beyond the limit, for the end of a flight that it cuts
MOST_STEPS = 10_000.0  # of the solution in extended precision, about 10 s
STEPS_A_SECOND = 200.0  # of the time that is left
CLOSING = 1e-12  # bounces are closed when their rest takes less than this part of the time so far
GUARD = 64  # bits


class Mark(NamedTuple):
    """An event of the computed motion, in units of R and √(R/g)."""

    kind: str
    after: str  # letter of the mode
    t: Ball
    angle: Ball
    omega: Ball
    slip: Ball


def by_doubles(scenario: Scenario, until: str, max_events: int) -> list[Mark]:
    """Events of the kernel; for a revolution those of the first one, however slowly it begins."""
    unit = _time_unit(scenario)
    if until == DURATION:
        motion = simulate(scenario.with_values({"contact.max_events": max_events + FURTHER}))
    else:
        motion = simulate(
            scenario.with_values({"duration": LONGEST * unit, "contact.max_events": FIRST}), until="revolutions:1"
        )
    return [
        Mark(event.kind, event.to_mode, arb(event.t / unit), arb(event.angle), arb(event.omega * unit), arb(event.slip))
        for event in motion.events
    ]


def by_digits(
    problem: Problem, rough: Sequence[Mark], digits: int, until: str, max_events: int, deadline: Deadline
) -> list[Mark] | None:
    """Events in extended precision, which needs the end of a revolution from `rough`; None if they take too long."""
    steps = min(MOST_STEPS, STEPS_A_SECOND * max(deadline.end - deadline.clock(), 0.0)) if deadline.limited else MOST_STEPS
    end = None if until == DURATION else 1.01 * float(rough[-1].t)
    try:
        solution = solve_problem(problem, digits, end, max_events + FURTHER, CLOSING, steps)
    except ArithmeticError:
        return None
    with precision(solution.bits + GUARD):
        return [
            Mark(EVENT_NAMES[one.kind], MODE_LETTERS[one.after_mode], *(_ball(getattr(one.state, name)) for name in STATE))
            for one in solution.records
        ]


STATE = ("t", "th", "om", "vt")


def _ball(number: Number) -> Ball:
    """The exact ball of a number of mpmath."""
    sign, man, exponent, _ = number._mpf_
    return (-1 if sign else 1) * arb(int(man)) * arb(2) ** int(exponent)


def _time_unit(scenario: Scenario) -> float:
    """√(R/g) [s]."""
    return math.sqrt(scenario.hoop.radius / (scenario.plane.gravity or 1.0))
