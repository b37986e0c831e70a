"""Proofs: the working precision rises until every comparison is certain and every event has its digits."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

from hophoop._support import tables
from hophoop._support.files import replacing
from hophoop.precise import result
from hophoop.precise.problem import Problem
from hophoop.prove.contact import SMALL
from hophoop.prove.formulas import STATUS_NAMES, Ending, Status
from hophoop.prove.motion import Run
from hophoop.prove.numbers import BITS_A_DIGIT, Number, Unclear, arb, rational, raw, setting
from hophoop.results.event_table import change_of
from hophoop.results.records import EventRecord
from hophoop.scenario import InputError, Rigid, Scenario
from hophoop.vocabulary.names import plain, sequence_of

LEAST_DIGITS, MOST_DIGITS = 1, 200
GUARD, LOST = 45, 4.0  # bits, and those that a time of √(R/g) takes from the digits
LONGEST = 20.0  # √(R/g), for which bits are given at first
TRIES, SAME = 5, 3
CLOSING_GUARD = 4  # digits: bounces are closed when their rest is so far below the digits asked for, and below 10⁻¹⁰
SPARE = 4  # digits beyond those that were missing
MOST_ROWS = 12  # events that a proof shows of itself
DURATION, REVOLUTION = "duration", "revolution"
LATE = "there was no time for it"
MASSLESS = "the massless hoop has closed forms of its own, which are not covered"
ENDINGS = {
    Ending.TIME_LIMIT: "duration", Ending.ANGLE_LIMIT: "revolutions", Ending.TURNING_POINT: "reversal",
    Ending.LIFT_OFF: "takeoff", Ending.REST: "rest",
}  # fmt: skip


@dataclass(frozen=True)
class Enclosure:
    """A number that is proved to lie within `radius` of `middle`; both are exact decimal numbers."""

    middle: Decimal
    radius: Decimal

    def holds(self, value: float | Decimal | Fraction) -> bool:
        """Return True if a number lies in it.

        Parameters
        ----------
        value : float, Decimal or Fraction
            In the unit of the enclosure [SI units].

        Returns
        -------
        inside : bool
        """
        return abs(Fraction(value) - Fraction(self.middle)) <= Fraction(self.radius)

    def distance(self, value: float) -> float:
        """Return the distance of a number from it, 0 inside.

        Parameters
        ----------
        value : float
            In the unit of the enclosure [SI units].

        Returns
        -------
        distance : float
            In the same unit [SI units].
        """
        return max(0.0, float(abs(Fraction(value) - Fraction(self.middle)) - Fraction(self.radius)))

    def __str__(self) -> str:
        return f"{self.middle} ± {self.radius:.0e}" if self.radius else f"{self.middle}"

    def __repr__(self) -> str:
        return f"<{self}>"


def enclosure(value: Any, digits: int) -> Enclosure:
    """Decimal numbers that enclose a ball of python-flint."""
    if value.is_zero():
        return Enclosure(Decimal(0), Decimal(0))
    middle, _, radius = value.str(digits + 1).strip("[]").partition("+/-")
    rounded_up = Context(prec=1, rounding=ROUND_CEILING)
    return Enclosure(Decimal(middle.strip() or "0"), rounded_up.plus(Decimal(radius.strip() or "0")))


@dataclass(frozen=True)
class Proof:
    """The proved events of a motion; made by `prove`.

    Attributes
    ----------
    scenario : Scenario
        Its doubles are taken as the exact numbers that they are.
    verdict : str
        'proved', or 'undecided' where something could not be shown.
    why : str
        What could not be shown, as a clause; empty where all is.
    sequence : str
        One letter per phase, as far as it is proved.
    status, ending : str
        How the motion ended, where it is proved.
    digits : int
        Digits asked for [1].
    digits_proved : int
        Digits of every number, relative to itself or to its unit made of R, g and m, that its enclosure determines [1].
    events : tuple of EventRecord
        The events that are proved, each number an `Enclosure`; where it is undecided, those before.
    until : str
        'duration' or 'revolution'.
    """

    scenario: Scenario
    verdict: str
    why: str
    sequence: str
    status: str
    ending: str
    digits: int
    digits_proved: int
    events: tuple[EventRecord[Any], ...]
    until: str = DURATION

    def __repr__(self) -> str:
        head = f"Proof of {self.sequence}: {self.verdict}, {len(self.events)} events, {self.digits_proved} digits"
        return tables.report(head, self._rows(), self._notes())

    def _repr_html_(self) -> str:
        titles = ("event", "mode", "t (s)", "θ (rad)", "x (m)")
        head = f"{self.sequence}: {self.verdict}, {self.digits_proved} digits"
        return tables.html(self._rows(), titles, (0, 1), before=[head], after=self._notes())

    def _rows(self) -> list[list[str]]:
        shown = self.events[:MOST_ROWS]
        return [[plain(event.kind), change_of(event), *map(str, (event.t, event.angle, event.x))] for event in shown]

    def _notes(self) -> list[str]:
        more = len(self.events) - MOST_ROWS
        return [f"… and {more} more"] * (more > 0) + [f"Undecided: {self.why}."] * (not self.proved)

    @property
    def proved(self) -> bool:
        """True if the whole motion is proved."""
        return self.verdict == "proved"

    def to_dict(self) -> dict[str, Any]:
        """Return the proof for JSON.

        Returns
        -------
        result : dict
            Each number as [middle, radius], texts of exact decimal numbers in SI units and radians.
        """
        from hophoop import __version__

        own = {name: getattr(self, name) for name in ("until", "verdict", "why", "sequence", "status", "ending")}
        return {
            "schema": "hophoop-proof/2", "version": __version__, "scenario": self.scenario.to_dict(), **own,
            "digits": self.digits_proved, "events": [_event_dict(event) for event in self.events],
        }  # fmt: skip

    def save(self, path: str | Path) -> None:
        """Write the proof as JSON.

        Parameters
        ----------
        path : str or Path
        """
        with replacing(Path(path)) as file:
            file.write_text(json.dumps(self.to_dict(), ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def _event_dict(record: Any) -> dict[str, Any]:
    """Return the numbers of an event, and of the velocities before it, for JSON."""
    return {
        name: _event_dict(one)
        if name == "before"
        else [str(one.middle), str(one.radius)]
        if isinstance(one, Enclosure)
        else one
        for name, one in vars(record).items()
    }


class Units(result.Units):
    """SI values of R, m and √(R/g) as balls, and enclosures of so many digits; `right` counts those that all have."""

    right = math.inf

    def decimal(self, value: Number, unit: Any) -> Any:
        """The enclosure of a number in SI units."""
        ball = arb(raw(value))
        if not ball.is_exact():
            size = abs(ball).mid().max(1)
            self.right = min(self.right, int(-float((ball.rad() / size).log()) / math.log(10)))
        return enclosure(ball * raw(unit), self.digits)


def prove(
    scenario: Scenario, digits: int = 15, until: str = DURATION, max_events: int = 4000, seconds: float | None = None
) -> Proof:
    """Prove the sequence of events of a rigid motion, with an enclosure of each.

    Every number is a ball, and every decision of the motion is certain; where one is not, the working precision rises.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact; its doubles are taken as the exact numbers that they are.
    digits : int, default 15
        Digits of every number that the enclosures are to determine, from 1 to 200 [1].
    until : str, default 'duration'
        'duration' of the scenario, or 'revolution': the first of a whole turn, a turning point and a take-off.
    max_events : int, default 4000
        More events are not looked at, nor more than the scenario's own limit [1].
    seconds : float, optional
        The motion stays undecided if it is not proved after this time [s].

    Returns
    -------
    proof : Proof

    Raises
    ------
    ValueError
        If digits, until or seconds is out of its range, or the contact is compliant.
    ImportError
        If python-flint is not installed.
    """
    check_digits(digits)
    if until not in (DURATION, REVOLUTION):
        raise InputError.of_field("until", until, f"{DURATION} or {REVOLUTION}")
    if not isinstance(scenario.contact, Rigid):
        raise InputError("A proof needs rigid contact; this scenario has a compliant one.")
    if seconds is not None and not seconds > 0:
        raise InputError.of_field("seconds", seconds, "above 0")
    end = math.inf if seconds is None else time.monotonic() + seconds
    return prove_problem(scenario, Problem.of(scenario), digits, until, max_events, lambda: time.monotonic() > end)


class Late(Unclear):
    """The time is over."""


def prove_problem(
    scenario: Scenario, problem: Problem, digits: int, until: str, max_events: int, late: Callable[[], bool], least: int = 0
) -> Proof:
    """`prove` of exact numbers, which need not be the scenario's doubles, while there is time; with so many bits at least."""
    if problem.kap == 0:
        return Proof(scenario, "undecided", MASSLESS, "", "", "", digits, 0, (), until)

    def look_at_clock() -> None:
        if late():
            raise Late(LATE)

    lasts = float(problem.duration) * math.sqrt(float((problem.gravity or 1) / problem.radius))
    bits = max(int(digits * BITS_A_DIGIT + GUARD + LOST * min(lasts, LONGEST)) + problem.tiny(), least)
    closing, best = max(digits, 10) + CLOSING_GUARD, None
    reasons: list[tuple[str, int]] = []
    for _ in range(TRIES):
        with setting(bits):
            why = ""
            short = rational(Fraction(1, 10**closing))
            run = Run(problem, short, until == REVOLUTION, min(max_events, problem.max_events), look_at_clock)
            try:
                run.run()
            except Late as reason:
                why = str(reason)
            except Unclear as reason:
                why = f"it cannot be shown that {reason}"
            except (ZeroDivisionError, ValueError):  # of a division of balls
                why = "it cannot be shown that no divisor is zero"
            found = _proof(scenario, run, why, digits, until)
        # of equal ones the last
        best = found if best is None else max(found, best, key=lambda one: (one.proved, len(one.events), one.digits_proved))
        if why == LATE:
            return best if best.proved else replace(best, why=LATE)
        if found.proved and found.digits_proved >= digits:
            return found
        reasons.append((why, len(found.events)))
        if why and reasons.count(reasons[-1]) == SAME and SMALL not in why:
            break  # twice as many bits, twice, have not helped
        missing = digits - found.digits_proved + SPARE
        closing += missing if found.proved else 0
        bits += int(missing * BITS_A_DIGIT) if found.proved else bits
    assert best is not None
    return best


def check_digits(digits: int) -> None:
    """Refuse a number of digits that cannot be asked for."""
    whole = isinstance(digits, int) and not isinstance(digits, bool)
    if not whole or not LEAST_DIGITS <= digits <= MOST_DIGITS:
        raise InputError.of_field("digits", digits, f"a whole number from {LEAST_DIGITS} to {MOST_DIGITS}")


def _proof(scenario: Scenario, run: Run, why: str, digits: int, until: str) -> Proof:
    """What a run has shown."""
    units, records = Units(run.body, digits), run.records
    events = tuple(result.event_of(record, digits, units) for record in records)
    status = "" if why else str(STATUS_NAMES[run.status])
    ending = status if run.status == Status.EVENT_LIMIT or why else ENDINGS.get(run.ending, status)
    times = [raw(record.state.t).mid() for record in records]
    sequence = sequence_of([r.kind for r in records], [r.after_mode for r in records], times, ending == "takeoff")
    verdict = "undecided" if why else "proved"
    return Proof(scenario, verdict, why, sequence, status, ending, digits, int(max(0, min(digits, units.right))), events, until)
