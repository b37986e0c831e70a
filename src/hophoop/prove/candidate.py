"""Candidates of certificates: the checker's own walk, with records of the phases that a computed motion suggests.

The walk gives all numbers and shows every inequality; only what it would read from a certificate is made up here. A bracket in
the wrong place, or a polynomial that is none of the equations', is refused by it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from hophoop.prove._flint import arb, pi
from hophoop.prove.checker.check import Stopped, Walk
from hophoop.prove.checker.conventions import Conventions
from hophoop.prove.checker.equations import Refused, State
from hophoop.prove.checker.flight import gap, without_apex
from hophoop.prove.checker.panel_phases import direction
from hophoop.prove.checker.rule import SIGMA
from hophoop.prove.deadline import Deadline
from hophoop.prove.guide import DURATION, REVOLUTION, Mark
from hophoop.prove.trail import Trail, around

SAMPLES = 48  # of the gap, per radian of a flight
NEWTON, HALVINGS = 8, 60
LATE = 0.999999  # of the time: an end of rolling after it is the end of the time
PASSING = ("apex", "kane_gain")  # no ends of a phase
ENDS_OF_SLIP = {"turn": "turn", "rest": "turn", "end": "limit", "stick": "stop", "slip_reversal": "stop"}


class Made(NamedTuple):
    """An event of the walk, with the state just after it."""

    kind: str
    before: str | None
    after: str
    state: State


class Candidate(Walk):
    """The walk of the checker along a computed motion; `made` and `records` become a certificate.

    Parameters
    ----------
    conventions : Conventions
        Of the certificate to be.
    guide : sequence of Mark
    wide : float
        Half width of a bracket, where nothing else is near.
    bits : int
        Of the polynomials.
    deadline : Deadline
    """

    def __init__(self, conventions: Conventions, guide: Sequence[Mark], wide: float, bits: int, deadline: Deadline) -> None:
        claim: dict[str, Any] = {"events": [], "phases": [], "status": "", "ending": ""}
        super().__init__(claim, conventions, deadline)
        self.guide, self.wide, self.bits = guide, wide, bits
        self.place = 0  # in the guide, just after the present event
        self.made: list[Made] = []
        self.records: list[dict[str, Any]] = []

    def follow(self) -> None:
        """Walk to the end, or to the limit of events."""
        try:
            self.walk()
        except Stopped:
            self.claim |= {"status": "event_limit", "ending": "event_limit"}

    # --- what the walk claims and reads --------------------------------------------------------

    def event(self, kind: str, before: str | None, after: str) -> None:
        """Note an event, and go on to the one after it in the guide."""
        if self.seen == self.conventions.max_events:
            raise Stopped
        self.made.append(Made(kind, before, after, self.state))
        self.note(kind, after)
        same = (k + 1 for k in range(self.place, len(self.guide)) if self.guide[k].kind == kind)
        self.place = next(same, self.place)

    def end(self, status: str, ending: str, mode: str | None = None) -> None:
        """The last event."""
        self.claim |= {"status": status, "ending": ending}
        super().end(status, ending, mode)

    def record(self, mode: str) -> dict[str, Any]:
        """Make up the record of the present phase."""
        if self.seen == self.conventions.max_events:
            raise Stopped
        ahead = [one for one in self.guide[self.place :] if one.kind not in PASSING]
        if not ahead:
            raise Refused("the motion goes on as it is computed")
        if mode == "H":
            found = self._flight(ahead[0])
        elif mode in SIGMA and self._held(SIGMA[mode]):
            found = {"mode": mode, "what": "limit" if ahead[0].kind == "end" else "stop", "slides": True}
        elif mode == "R" and not self.equations.resisted:
            found = self._rolling(ahead[0])
        else:
            found = self._panels(ahead)
        self.records.append(found)
        return found

    # --- flight --------------------------------------------------------------------------------

    def _flight(self, ahead: Mark) -> dict[str, Any]:
        tau = float(ahead.t - self.guide[self.place - 1].t)
        landing = self._landing(tau) if ahead.kind in ("impact", "bounce_limit") else None
        without = without_apex(self.equations, self.state, arb(tau), self.zeros)
        return {"mode": "H", "to": landing, "apex": None if without else self._apex(tau)}

    def _landing(self, tau: float) -> list[str]:
        """A bracket of the landing: by Newton's method, for a short flight is lost in the rounding of times."""
        x = arb(tau)
        for _ in range(NEWTON):
            value, slope = (one.mid() for one in gap(self.equations, self.state, x, 2))
            x = (x - value / slope).mid() if slope < 0 else x
        if not 0.5 * tau < float(x) < 2.0 * tau:
            x = arb(tau)
        return around(x, min(self.wide, 1e-3 * float(x)))

    def _apex(self, tau: float) -> list[str] | None:
        """A bracket of the highest top of the gap, found in doubles."""

        def rate(x: float) -> float:
            return float(gap(self.equations, self.state, arb(x), 2)[1].mid())

        count = 8 + int(SAMPLES * abs(float(self.state.om)) * tau)
        places = [tau * k / count for k in range(count + 1)]
        rates = [rate(x) for x in places]
        tops = []
        for k in range(count):
            begins = k == 0 and rates[0] == 0.0 > rates[1] and rate(0.01 * places[1]) > 0.0
            if rates[k] > 0.0 >= rates[k + 1] or begins:
                low, high = places[k], places[k + 1]
                for _ in range(HALVINGS):
                    middle = 0.5 * (low + high)
                    low, high = (middle, high) if rate(middle) > 0.0 else (low, middle)
                tops.append((float(gap(self.equations, self.state, arb(low), 1)[0].mid()), low))
        if not tops:
            return None
        top = max(tops)[1]
        return around(arb(top), min(self.wide, 0.25 * top, 0.25 * (tau - top)))

    # --- contact -------------------------------------------------------------------------------

    def _way(self, sigma: int) -> int:
        """Direction in which the hoop turns, or begins to turn."""
        state = self.state
        return direction(self.equations.just_after(state.th, state.om, sigma), sigma, state)

    def _spans(self, way: int, ahead: Mark) -> bool:
        """Return True if the whole turn that is asked for comes before an event."""
        if self.until == DURATION:
            return False
        return ahead.kind == "end" or bool(way * (ahead.angle - self.origin) > 2 * pi())

    def _rolling(self, ahead: Mark) -> dict[str, Any]:
        way, length = self._way(0), abs(float(ahead.angle - self.state.th))
        what = "span" if self._spans(way, ahead) else self._end_of_rolling(ahead)
        level = what == "limit" and self.equations.gt.is_zero()
        turns = max(int(length / (2.0 * math.pi)) - 1, 0) if level else 0
        wide = min(max(self.wide, 1e-13 * abs(float(ahead.angle))), 0.25 * length)
        return {"mode": "R", "way": way, "what": what, "angle": around(ahead.angle, wide), "turns": turns}

    def _end_of_rolling(self, ahead: Mark) -> str:
        """The name that the checker gives the end of a phase of rolling."""
        if ahead.kind in ("turn", "rest"):
            return "turn"
        if ahead.kind == "end" and (self.equations.mu_s is not None or ahead.t > LATE * self.equations.t_end):
            return "limit"
        if self.equations.mu_s is None:
            return "open"
        if ahead.kind == "slip_start":
            return "ahead" if ahead.after == "S" else "back"
        s, c = ahead.angle.sin_cos()
        return "ahead" if self.equations.contact(s, c, ahead.omega * ahead.omega, 0).friction > 0 else "back"

    def _panels(self, ahead: Sequence[Mark]) -> dict[str, Any]:
        """Slip, or rolling with resistance, with its turning points."""
        sigma = SIGMA.get(self.mode, 0)
        equations = self.equations.just_after(self.state.th, self.state.om, sigma)
        trail = Trail(equations, sigma, self.state, self._way(sigma), self.bits, self.wide)
        single = equations.resisted or self.until == REVOLUTION  # the record ends with a turning point
        for one in ahead:
            if self._spans(trail.way, one):
                trail.to(self.origin + trail.way * 2 * pi())
                return trail.record(self.mode, "span")
            what = self._end_of_rolling(one) if sigma == 0 else _end_of_slip(one)
            if what != "turn":
                trail.to(one.angle)
                return trail.record(self.mode, what)
            trail.turn(one.angle, single)
            if single:
                return trail.record(self.mode, what)
        raise Refused("the motion goes on as it is computed")


def _end_of_slip(ahead: Mark) -> str:
    """The name that the checker gives the end of a phase of slip."""
    if ahead.kind == "takeoff":
        return "lift" if ahead.slip != 0 else "stop"
    if ahead.kind not in ENDS_OF_SLIP:
        raise Refused("slip stays away from p_σ = 0")
    return ENDS_OF_SLIP[ahead.kind]
