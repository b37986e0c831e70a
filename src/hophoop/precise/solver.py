"""Solve at two working precisions, count the digits that agree, and raise the precision until they are enough."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from hophoop.kernel.model import Status
from hophoop.precise.contact import Stiff
from hophoop.precise.kernels import Number
from hophoop.precise.motion import Record, Run
from hophoop.precise.problem import Body, Problem
from hophoop.precise.series import MorePrecision, Work, work_of_step
from hophoop.scenario import InputError, Scenario

LEAST_DIGITS, MOST_DIGITS = 15, 1000
BITS_A_DIGIT = 3.3219280948873626
GUARD = 12  # digits beyond those asked for
SURE = 0.9  # of the work that steps took, what as many take again for certain
SECOND = 11  # bits that the second solution has more than the first: other roundings, other orders, other steps
CLOSING_GUARD = 3  # digits: bounces are closed when their rest is this far below the digits asked for
MOST_TRIES = 8


@dataclass(frozen=True)
class Solution:
    """A motion in many digits, in units of R, m and √(R/g).

    Attributes
    ----------
    body : Body
        Body and plane at the working precision, with the context `body.ctx` of all numbers.
    status : Status
    records : tuple of Record
        All events.
    digits_right : tuple of int
        Per event, how many digits of time and state two working precisions have in common; see `agreement`.
    bits : int
        Working precision of the records.
    """

    body: Body
    status: Status
    records: tuple[Record, ...]
    digits_right: tuple[int, ...]
    bits: int

    def digits(self) -> int:
        """Return the number of digits that every event has.

        Returns
        -------
        digits : int
            The least of `digits_right` [1].
        """
        return min(self.digits_right, default=0)


def solve(
    scenario: Scenario,
    digits: int = 30,
    until: Any = None,
    max_events: int | None = None,
    closing: float | None = None,
    most_steps: float | None = None,
) -> Solution:
    """Compute a rigid motion to a number of digits.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact; its doubles are taken as the exact numbers that they are.
    digits : int, default 30
        From 15 to 1000 [1].
    until : float or mpf, optional
        End of time in units of √(R/g), by default the scenario's duration [1].
    max_events : int, optional
        Stop after so many events, by default the scenario's limit [1].
    closing : float, optional
        A sequence of bounces is closed when its rest takes less than this part of the time so far; by default
        10^(−digits − 3) [1].
    most_steps : float, optional
        Steps of contact and flight that all computations may take together, at all their precisions: one with more than 106
        bits counts for as many as take its time [1].

    Returns
    -------
    solution : Solution
        `digits_right` shows if the digits are not reached.

    Raises
    ------
    ValueError
        If digits is not a whole number in its range, the contact is compliant or the hoop massless.
    ArithmeticError
        If it needs more steps than are allowed.
    """
    check(scenario, digits)
    return solve_problem(Problem.of(scenario), digits, until, max_events, closing, most_steps)


def solve_problem(
    problem: Problem,
    digits: int = 30,
    until: Any = None,
    max_events: int | None = None,
    closing: float | None = None,
    most_steps: float | None = None,
) -> Solution:
    """Compute the motion of exact numbers, which need not be doubles; see `solve`."""
    closing_at = f"1e-{digits + CLOSING_GUARD}" if closing is None else closing
    base = int((digits + GUARD) * BITS_A_DIGIT) + problem.tiny()
    best: Solution | None = None
    work = Work(math.inf if most_steps is None else most_steps)
    for _ in range(MOST_TRIES):
        runs = _pair(problem, base, closing_at, until, max_events, work)
        if runs is None:  # what happens differs between the two: neither can be trusted
            base *= 2
            continue
        rough, fine = runs
        right = tuple(agreement(rough.body, a, b) for a, b in zip(rough.records, fine.records, strict=True))
        found = Solution(fine.body, fine.status, tuple(fine.records), right, fine.body.bits)
        if best is None or found.digits() > best.digits():
            best = found
        if found.digits() >= digits or base > 12 * digits * BITS_A_DIGIT + 2000:
            break
        base += int((digits - found.digits() + GUARD // 2) * BITS_A_DIGIT)
    if best is None:
        raise ArithmeticError("two working precisions never gave the same events.")
    return best


def check(scenario: Scenario, digits: int) -> None:
    """Refuse a scenario or digits that cannot be solved."""
    whole = isinstance(digits, int) and not isinstance(digits, bool)
    if not whole or not LEAST_DIGITS <= digits <= MOST_DIGITS:
        raise InputError.of_field("digits", digits, f"a whole number from {LEAST_DIGITS} to {MOST_DIGITS}")
    if scenario.contact.model != "rigid":
        raise InputError(
            f"digits = {digits!r} needs rigid contact: a compliant contact is solved in double precision only.",
            field="digits",
            value=digits,
        )
    if scenario.hoop.massless:
        raise InputError(
            f"digits = {digits!r} needs a rim with mass: the massless hoop (hoop.inertia_ratio = 0) has closed forms and is "
            "solved in double precision only.",
            field="digits",
            value=digits,
        )


def _levels(base: int) -> Iterator[tuple[int, bool]]:
    """Working precisions while a quantity that decides is indistinguishable from 0; at the last one it counts as 0."""
    yield base, False
    yield base * 3 // 2, False
    yield base * 3, True


def _pair(problem: Problem, base: int, closing: Any, until: Any, max_events: int | None, work: Work) -> tuple[Run, Run] | None:
    """The motion at two working precisions; None where the events are not the same."""
    steps = 0.0  # up to the undecided quantity of the level before; all of them are made again
    for bits, last in _levels(base):
        rough, fine = (Run(problem, b, last, closing, until, max_events, work) for b in (bits, bits + SECOND))
        price, other = work_of_step(bits), work_of_step(bits + SECOND)
        work.need(SURE * steps * (price + other))
        begin = work.left
        try:
            with work.kept_back(SURE / (1.0 + SURE)):  # for the second one, which takes as much
                rough.run()
            price += other
            fine.run()
        except (MorePrecision, Stiff):
            if last:
                return None
            steps = (begin - work.left) / price
            continue
        return (rough, fine) if _signature(rough) == _signature(fine) else None
    return None


def _signature(run: Run) -> list[Any]:
    return [run.status, *((r.kind, r.before_mode, r.after_mode, r.collision, r.stable) for r in run.records)]


def numbers(record: Record) -> list[Number]:
    """The compared numbers of an event: time and state."""
    state = record.state
    return [state.t, state.x, state.y, state.th, state.vt, state.vn, state.om, record.p_n, record.p_t]


def agreement(body: Body, rough: Record, fine: Record) -> int:
    """The digits in which two solutions agree in every number, relative to the number itself or 1, whichever is larger."""
    ctx = body.ctx
    worst = body.zero
    for a, b in zip(numbers(rough), numbers(fine), strict=True):
        if ctx.isfinite(a) and ctx.isfinite(b):
            worst = max(worst, abs(a - b) / max(abs(b), 1))
    most = int(body.bits / BITS_A_DIGIT)
    if worst == 0:
        return most
    return max(0, min(most, int(-ctx.log10(worst))))
