"""A proof: the events of a motion with enclosures, and the certificate that a checker verifies."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

from hophoop._support import tables
from hophoop._support.files import replacing
from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, precision
from hophoop.prove.candidate import Candidate
from hophoop.prove.checker.check import checked
from hophoop.prove.checker.conventions import CLOSING, MOST_BITS, SCHEMA, Conventions
from hophoop.prove.checker.equations import Refused
from hophoop.prove.checker.verdict import Verdict
from hophoop.prove.deadline import Deadline, Late
from hophoop.prove.guide import DURATION, REVOLUTION, Mark, by_digits, by_doubles
from hophoop.prove.trail import WIDE
from hophoop.results.event_table import change_of
from hophoop.scenario import InputError, Rigid, Scenario
from hophoop.vocabulary.names import plain

LEAST_DIGITS, MOST_DIGITS = 1, 200
BITS_A_DIGIT = 3.3219280948873626
GUARD = 45  # bits
CHECKER_GUARD = 40  # bits that the checker works with beyond those of the proof
TRIES = 5
MOST_ROWS = 12  # events that a proof shows of itself
EVENTS_AT_ONCE = 100  # are written as decimal numbers without a look at the clock
LEAST_GUIDE = 20  # digits of the first guide in extended precision; twice as many with each attempt
NARROW = 1e-12  # half width of brackets then
MASSLESS = "the massless hoop has closed forms of its own, which are not covered"


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


@dataclass(frozen=True)
class ProvedEvent:
    """One event that is proved; the state is the one just after it.

    Attributes
    ----------
    kind : str
        One of the kinds of the file format.
    from_mode, to_mode : str or None
        Letters of the modes before and after.
    t : Enclosure
        Time [s].
    x, height, angle : Enclosure
        Centre along the plane [m], gap [m], θ [rad].
    vx, vy, omega : Enclosure
        Velocity of the centre [m/s], θ̇ [rad/s].
    """

    kind: str
    from_mode: str | None
    to_mode: str
    t: Enclosure
    x: Enclosure
    height: Enclosure
    angle: Enclosure
    vx: Enclosure
    vy: Enclosure
    omega: Enclosure

    def __repr__(self) -> str:
        return f"<{self.kind} at t = {self.t} s, {change_of(self)}: x = {self.x} m, angle = {self.angle} rad>"


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
        Digits of every number, relative to itself or to its unit made of R and g, that its enclosure determines [1].
    events : tuple of ProvedEvent
        The events that are proved; where it is undecided, those before.
    certificate : dict or None
        What `check` verifies; None where the motion is undecided.
    """

    scenario: Scenario
    verdict: str
    why: str
    sequence: str
    status: str
    ending: str
    digits: int
    digits_proved: int
    events: tuple[ProvedEvent, ...]
    certificate: dict[str, Any] | None

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

    def save(self, path: str | Path) -> None:
        """Write the certificate as JSON.

        Parameters
        ----------
        path : str or Path

        Raises
        ------
        ValueError
            If the motion is undecided.
        """
        if self.certificate is None:
            raise InputError(f"There is no certificate to write: {self.why}.")
        with replacing(Path(path)) as file:
            file.write_text(json.dumps(self.certificate, ensure_ascii=False, separators=(",", ":")) + "\n", encoding="utf-8")


def prove(
    scenario: Scenario, digits: int = 15, until: str = DURATION, max_events: int = 4000, seconds: float | None = None
) -> Proof:
    """Prove the sequence of events of a rigid motion, with an enclosure of each.

    The computed motion suggests a certificate; the motion is proved if the checker accepts it, which shares no solver with it.

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
        The motion stays undecided if it is not proved after this time. No proof takes more than a tenth, or 1 s, longer [s].

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
    return _prove(scenario, digits, until, max_events, Deadline(seconds))


def _prove(scenario: Scenario, digits: int, until: str, max_events: int, deadline: Deadline) -> Proof:
    problem = Problem.of(scenario)
    if problem.kap == 0:
        return Proof(scenario, "undecided", MASSLESS, "", "", "", digits, 0, (), None)
    assert isinstance(scenario.contact, Rigid)
    max_events = min(max_events, scenario.contact.max_events)
    bits = int(digits * BITS_A_DIGIT) + GUARD + min(problem.tiny(), 200)
    rough = guide = by_doubles(scenario, until, max_events)
    wide, guide_digits = WIDE, LEAST_GUIDE
    attempts: list[Proof] = []
    for _ in range(TRIES):
        conventions = Conventions(scenario.to_dict(), until, 0, max_events, bits + CHECKER_GUARD)
        walk, why = walked(conventions, guide, wide, bits, deadline)
        found, right = _proof(scenario, walk, why, digits, deadline)
        if found.certificate is not None:
            verdict = checked(found.certificate, deadline)
            if verdict.accepted and right > digits:
                return found
            if not verdict.accepted:
                found = _refused(found, verdict, deadline)
        attempts.append(found)
        if deadline.late or (not found.proved and [len(one.events) for one in attempts[-3:]] == [len(found.events)] * 3):
            break  # twice as many digits, twice, have not helped
        if found.proved:
            more = max(3 * bits // 2, bits + int((digits - right + 4) * BITS_A_DIGIT))
        else:
            more = 2 * bits
            guide = by_digits(problem, rough, guide_digits, until, max_events, deadline) or guide
            wide, guide_digits = NARROW, 2 * guide_digits
        deadline.expect((more / bits) ** 2)
        bits = more
    best = max(attempts, key=lambda one: (one.proved, len(one.events), one.digits_proved))
    return replace(best, why=str(Late())) if deadline.late and not best.proved else best


def walked(
    conventions: Conventions, guide: Sequence[Mark], wide: float, bits: int, deadline: Deadline
) -> tuple[Candidate, str]:
    """The checker's walk along a computed motion, and what it could not show, as a clause; empty if it came to the end."""
    with precision(conventions.bits):
        walk = Candidate(conventions, guide, wide, bits, deadline)
        try:
            walk.follow()
        except Refused as reason:
            return walk, f"it cannot be shown that {reason}"
        except Late as reason:
            return walk, str(reason)
        except (ArithmeticError, ValueError) as error:
            return walk, f"a step cannot be evaluated ({error})"
    return walk, ""


def check_digits(digits: int) -> None:
    """Refuse a number of digits that cannot be asked for."""
    whole = isinstance(digits, int) and not isinstance(digits, bool)
    if not whole or not LEAST_DIGITS <= digits <= MOST_DIGITS:
        raise InputError.of_field("digits", digits, f"a whole number from {LEAST_DIGITS} to {MOST_DIGITS}")


def _refused(proof: Proof, verdict: Verdict, deadline: Deadline) -> Proof:
    refusal = f"the checker does not accept the certificate, for it cannot show that {verdict.why}"
    why = verdict.why if deadline.late else refusal
    return replace(proof, verdict="undecided", why=why, certificate=None, events=proof.events[: verdict.events])


def _digits_of(walk: Candidate) -> int:
    """Digits that every enclosure has."""
    worst = MOST_BITS
    with precision(walk.conventions.bits):
        for one in walk.made:
            for value, unit in walk.equations.in_si(one.state).values():
                if not value.is_exact():
                    worst = min(worst, int(-float((value.rad() / abs(value).mid().max(unit.mid())).log()) / math.log(10)))
    return worst


def decimal_of(exact: Ball, rounding: str, digits: int) -> Decimal:
    """An exact binary number as a decimal one with so many significant digits."""
    man, exponent = (int(part) for part in exact.man_exp())
    context = Context(prec=max(digits, 1), rounding=rounding)
    power = Fraction(2) ** exponent * man
    return context.divide(Decimal(power.numerator), Decimal(power.denominator))


def enclosure(value: Ball, unit: Ball, digits: int) -> Enclosure:
    """Decimal numbers that enclose a ball, as wide as the digits allow."""
    if value.is_zero():
        return Enclosure(Decimal(0), Decimal(0))
    size = abs(value).mid().max(unit.mid())
    tolerance = decimal_of(size, ROUND_CEILING, 1).scaleb(-digits)
    whole = decimal_of(value.mid(), ROUND_HALF_EVEN, digits + 40)
    middle = whole.quantize(Decimal(1).scaleb(tolerance.adjusted() - 1), rounding=ROUND_HALF_EVEN, context=Context(prec=400))
    least = decimal_of((value.rad() * 2).upper() if not value.is_exact() else value.rad(), ROUND_CEILING, 2)
    radius = max(tolerance, least + Decimal(2).scaleb(tolerance.adjusted() - 1))
    return Enclosure(middle, Context(prec=1, rounding=ROUND_CEILING).plus(radius))


def _proof(scenario: Scenario, walk: Candidate, why: str, digits: int, deadline: Deadline) -> tuple[Proof, int]:
    """What a walk has shown, with its certificate if it came to the end; and the digits that every enclosure has."""
    right = _digits_of(walk)
    stated = max(0, min(digits, right - 1))
    events, late = enclosed(walk, stated, deadline)
    why = why or late
    certificate = None if why else certificate_of(walk, scenario.to_dict(), events, stated)
    status, ending = ("", "") if certificate is None else (certificate["status"], certificate["ending"])
    verdict = "undecided" if why else "proved"
    return Proof(scenario, verdict, why, walk.sequence, status, ending, digits, stated, tuple(events), certificate), right


def enclosed(walk: Candidate, digits: int, deadline: Deadline) -> tuple[list[ProvedEvent], str]:
    """The events of a walk with enclosures, and why some are missing."""
    events: list[ProvedEvent] = []
    with precision(walk.conventions.bits):
        for k, one in enumerate(walk.made, 1):
            if k % EVENTS_AT_ONCE == 0 and deadline.used_up():
                deadline.late = True
                return events, str(Late())
            numbers = {name: enclosure(*pair, max(digits, 1)) for name, pair in walk.equations.in_si(one.state).items()}
            events.append(ProvedEvent(one.kind, one.before, one.after, **numbers))
    return events, ""


def certificate_of(walk: Candidate, scenario: dict[str, Any], events: Sequence[ProvedEvent], digits: int) -> dict[str, Any]:
    """The certificate of a walk that came to the end."""
    from hophoop import __version__

    return {
        "schema": SCHEMA,
        "version": __version__,
        "scenario": scenario,
        "until": walk.until,
        "closing": CLOSING,
        "bits": walk.conventions.bits,
        "digits": digits,
        "max_events": walk.conventions.max_events,
        "sequence": walk.sequence,
        "status": walk.claim["status"],
        "ending": walk.claim["ending"],
        "events": [_event_dict(event) for event in events],
        "phases": walk.records,
    }


def _event_dict(event: ProvedEvent) -> dict[str, Any]:
    numbers = {name: [str(one.middle), str(one.radius)] for name, one in vars(event).items() if isinstance(one, Enclosure)}
    return {"kind": event.kind, "from": event.from_mode, "to": event.to_mode, **numbers}
