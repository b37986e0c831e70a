"""Motions in extended precision that end before their duration: double precision says about when, the digits when exactly."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from hophoop._version import __version__
from hophoop.kernel.model import PASSING, Event, Mode, Status
from hophoop.kernel.records import STOP_AT_TURN, Until
from hophoop.precise.motion import Record
from hophoop.precise.problem import Problem
from hophoop.precise.result import PreciseMotion, motion_of
from hophoop.precise.solver import Solution, check, solve, solve_problem
from hophoop.scenario import Scenario, time_unit
from hophoop.simulation.rigid import simulate_rigid

AFTER = 1e-6  # √(R/g): by which a motion is solved beyond the event that ends it
FAR = 0.5  # rad: a passage that is farther from the one in double precision is another one
# Written right after a landing or a turn: what the mode rule makes of it.
AT_ONCE = (
    Event.KANE_GAIN, Event.PAINLEVE_INCONSISTENT, Event.PAINLEVE_INDETERMINATE, Event.IMPACT, Event.STICK, Event.SLIP_START,
    Event.SLIP_REVERSAL, Event.TAKEOFF,
)  # fmt: skip
MOST = 12  # corrections of the time of a passage; each one doubles its digits


def simulate_precisely_until(scenario: Scenario, digits: int, asked: str, until: Until) -> PreciseMotion:
    """Compute a motion to a number of digits, up to its duration or to what ends it before.

    scenario: With rigid contact; digits: From 15 to 1000 [1]; asked: The name of `until`.
    """
    check(scenario, digits)
    end = simulate_rigid(scenario, until).events[-1]
    ends = end["t"] < scenario.duration / time_unit(scenario.hoop, scenario.plane)
    solution = solve_until(Problem.of(scenario), digits, until, float(end["t"]) if ends else None)
    ended = solution is not None and solution.status == Status.COMPLETED
    return motion_of(scenario, solution or solve(scenario, digits), digits, __version__, asked if ended else None)


def solve_until(problem: Problem, digits: int, until: Until, about: float | None) -> Solution | None:
    """Return the motion up to what ends it before its duration; None if that does not happen.

    about: The time of the end in double precision, if there is one.
    """
    if until.stop or until.landings:
        return _to_event(problem, digits, until, about)
    return None if about is None else _to_passage(problem, digits, until, about)


def _to_event(problem: Problem, digits: int, until: Until, about: float | None) -> Solution | None:
    """Return the motion up to just after the event that ends it; None if there is no such event.

    about: Its time in double precision, if there is one. Bounces that accumulate are more in extended precision.
    """
    for end in (None,) if about is None else (about + AFTER, None):
        solution = solve_problem(problem, digits, until=end)
        row = _row_of_end(solution.records, until)
        if row is not None:
            return _ended(solution, row)
    return None


def _row_of_end(records: Sequence[Record], until: Until) -> int | None:
    """Return the last record of the event that ends a motion, with what follows it at once; None if there is no such event."""
    wanted = [row for row, record in enumerate(records) if _counts(record, until)]
    number = max(until.landings, 1)
    if len(wanted) < number:
        return None
    row = wanted[number - 1]
    while records[row + 1].kind in AT_ONCE and records[row + 1].state.t == records[row].state.t:
        row += 1
    return row


def _counts(record: Record, until: Until) -> bool:
    """Return True for a landing, a turn, or a take-off after the start."""
    if until.landings:
        return record.kind == Event.BOUNCE_LIMIT or (record.kind == Event.IMPACT and bool(record.collision))
    if until.stop == STOP_AT_TURN:
        return bool(record.kind == Event.TURN)
    return bool(record.state.t > 0 and record.after_mode == Mode.FLIGHT and record.kind not in (*PASSING, Event.END))


def _ended(solution: Solution, row: int) -> Solution:
    """Return a solution that ends just after one of its events."""
    last = solution.records[row]
    state, zero = last.state, solution.body.zero
    end = Record(Event.END, last.after_mode, last.after_mode, state, state.vt, state.vn, state.om, zero, zero, zero)
    right = solution.digits_right[: row + 1]
    records = (*solution.records[: row + 1], end)
    return replace(solution, status=Status.COMPLETED, records=records, digits_right=(*right, right[-1]))


def _to_passage(problem: Problem, digits: int, until: Until, about: float) -> Solution | None:
    """Return the motion up to where θ passes the angle that ends it, by Newton's method on its time."""
    t: Any = about
    for _ in range(MOST):
        solution = solve_problem(problem, digits, until=t)
        ctx, state = solution.body.ctx, solution.records[-1].state
        start = solution.records[0].state.th
        if math.isnan(until.angle):
            way = 1 if state.th > start else -1
            target = start + way * 2 * ctx.pi * ctx.mpf(until.revolutions)
        else:
            target = ctx.mpf(until.angle)
            turns = ctx.nint((state.th - target) / (2 * ctx.pi))
            target += 2 * ctx.pi * turns
        ahead = target - state.th
        if not abs(ahead) < FAR or state.om == 0:
            return None
        if abs(ahead) < ctx.mpf(10) ** -(digits + 2):
            return solution
        t = ctx.mpf(t) + ahead / state.om
    return solution
