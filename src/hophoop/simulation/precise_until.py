"""Motions in extended precision that end before their duration: double precision says about when, the digits when exactly."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from hophoop._version import __version__
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.rigid.phase import Until
from hophoop.precise.motion import Record
from hophoop.precise.result import PreciseMotion, motion_of
from hophoop.precise.solver import Solution, check, solve
from hophoop.scenario import Scenario, time_unit
from hophoop.simulation.rigid import simulate_rigid

AFTER = 1e-6  # √(R/g): by which a motion is solved beyond the event that ends it
FAR = 0.5  # rad: a passage that is farther from the one in double precision is another one
MOST = 12  # corrections of the time of a passage; each one doubles its digits


def simulate_precisely_until(scenario: Scenario, digits: int, asked: str, until: Until) -> PreciseMotion:
    """Compute a motion to a number of digits, up to its duration or to what ends it before.

    scenario: With rigid contact; digits: From 15 to 1000 [1]; asked: The name of `until`.
    """
    check(scenario, digits)
    events = simulate_rigid(scenario, until).events
    solution = None
    if events["t"][-1] < scenario.duration / time_unit(scenario.hoop, scenario.plane):
        at_event = until.stop or until.landings
        solution = _to_event(scenario, digits, events) if at_event else _to_passage(scenario, digits, until, events[-1])
    ended = solution is not None and solution.status == Status.COMPLETED
    return motion_of(scenario, solution or solve(scenario, digits), digits, __version__, asked if ended else None)


def _to_event(scenario: Scenario, digits: int, events: np.ndarray) -> Solution | None:
    """Return the motion up to just after the event that ends it in double precision; None if there is no such event.

    events: In double precision. The last one before END is the n-th of its kind.
    """
    kind = events["kind"][-2]
    number = np.count_nonzero(events["kind"] == kind)
    for end in (float(events["t"][-1]) + AFTER, None):
        solution = solve(scenario, digits, until=end)
        rows = [row for row, record in enumerate(solution.records) if record.kind == kind]
        if len(rows) >= number:
            return _ended(solution, rows[number - 1])
    return None


def _ended(solution: Solution, row: int) -> Solution:
    """Return a solution that ends just after one of its events."""
    last = solution.records[row]
    state, zero = last.state, solution.body.zero
    end = Record(Event.END, last.after_mode, last.after_mode, state, state.vt, state.vn, state.om, zero, zero, zero)
    right = solution.digits_right[: row + 1]
    records = (*solution.records[: row + 1], end)
    return replace(solution, status=Status.COMPLETED, records=records, digits_right=(*right, right[-1]))


def _to_passage(scenario: Scenario, digits: int, until: Until, rough: Any) -> Solution | None:
    """Return the motion up to where θ passes the angle that ends it, by Newton's method on its time."""
    t: Any = float(rough["t"])
    for _ in range(MOST):
        solution = solve(scenario, digits, until=t)
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
