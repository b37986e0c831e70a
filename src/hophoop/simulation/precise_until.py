"""Motions in extended precision that end before their duration: double precision says about when, the digits when exactly."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from hophoop._version import __version__
from hophoop.kernel.physics.body import Event, Status
from hophoop.precise.motion import Record
from hophoop.precise.result import PreciseMotion, motion_of
from hophoop.precise.solver import Solution, check, solve
from hophoop.scenario import Scenario, time_unit
from hophoop.simulation.rigid import simulate_rigid
from hophoop.simulation.until import Until, is_met

AFTER = 1e-6  # √(R/g): by which a motion is solved beyond the event that ends it
FAR = 0.5  # rad: a passage that is farther from the one in double precision is another one
MOST = 12  # corrections of the time of a passage; each one doubles its digits


def simulate_precisely_until(scenario: Scenario, digits: int, asked: str, until: Until) -> PreciseMotion:
    """Compute a motion to a number of digits, up to its duration or to what ends it before.

    scenario: With rigid contact; digits: From 15 to 1000 [1]; asked: The name of `until`.
    """
    check(scenario, digits)
    rough = simulate_rigid(scenario, until).events[-1]
    if rough["t"] >= scenario.duration / time_unit(scenario.hoop, scenario.plane):
        return motion_of(scenario, solve(scenario, digits), digits, __version__)
    at_event = until.word not in ("revolutions", "angle")
    solution = _to_event(scenario, digits, until, rough) if at_event else _to_passage(scenario, digits, until, rough)
    if solution is None:
        return motion_of(scenario, solve(scenario, digits), digits, __version__)
    return motion_of(scenario, solution, digits, __version__, asked if solution.status == Status.COMPLETED else None)


def _to_event(scenario: Scenario, digits: int, until: Until, rough: Any) -> Solution | None:
    """Return the motion up to just after the event that ends it; None if there is no such event."""
    last = scenario.duration / time_unit(scenario.hoop, scenario.plane)
    ahead = AFTER
    while True:
        whole = rough["t"] + ahead >= last
        solution = solve(scenario, digits, until=None if whole else float(rough["t"]) + ahead)
        left = until.number
        for row, record in enumerate(solution.records):
            state = record.state
            left -= is_met(until, record.kind, record.after_mode, state.y, state.vn, record.collision)
            if left <= 0.0:
                return _ended(solution, row)
        if whole:
            return None
        ahead = max(16.0 * ahead, 1e-2)


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
        way = 1 if state.th > start else -1
        if until.word == "revolutions":
            target = start + way * 2 * ctx.pi * ctx.mpf(until.number)
        else:
            target = ctx.mpf(until.number)
            turns = ctx.nint((state.th - target) / (2 * ctx.pi))
            target += 2 * ctx.pi * turns
        ahead = target - state.th
        if not abs(ahead) < FAR or state.om == 0:
            return None
        if abs(ahead) < ctx.mpf(10) ** -(digits + 2):
            return solution
        t = ctx.mpf(t) + ahead / state.om
    return solution
