"""Go through a certificate event by event.

On purpose the checker has words and rules of its own, such as which events do not end a phase: it shares no table with
what it checks.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import InvalidOperation
from itertools import pairwise
from typing import Any

from hophoop.prove._flint import Ball, Jet, arb, pi, precision
from hophoop.prove.checker.conventions import CLOSING, Conventions
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.flight import flown, gap, no_top, skims, without_apex
from hophoop.prove.checker.intervals import positive, require, root
from hophoop.prove.checker.panel_phases import verify_panels
from hophoop.prove.checker.panels import TurnPanel
from hophoop.prove.checker.rolling import roll
from hophoop.prove.checker.rule import SIGMA, collide, next_mode, opening, sign, slip_zeros
from hophoop.prove.checker.verdict import Verdict
from hophoop.prove.deadline import Deadline, Late


def check(certificate: dict[str, Any]) -> Verdict:
    """Verify a certificate by interval evaluation, independently of what made it.

    Parameters
    ----------
    certificate : dict
        As `hophoop prove --out` writes it.

    Returns
    -------
    verdict : Verdict

    Raises
    ------
    ImportError
        If python-flint is not installed.
    """
    return checked(certificate, Deadline())


def checked(certificate: dict[str, Any], deadline: Deadline) -> Verdict:
    """`check` within a time; what is not verified by then is not accepted."""
    walk: Walk | None = None
    try:
        conventions = Conventions.of(certificate)
        with precision(conventions.bits):
            walk = Walk(certificate, conventions, deadline)
            walk.run()
    except (Refused, Late) as reason:
        return Verdict(False, str(reason), walk.seen if walk else 0)
    except (ArithmeticError, ValueError, KeyError, TypeError, IndexError, AttributeError, InvalidOperation) as error:
        return Verdict(False, f"the certificate cannot be read or evaluated ({error!r})", walk.seen if walk else 0)
    return Verdict(True, "", walk.seen, conventions.lines())


class Stopped(Exception):
    """All events that are claimed are verified."""


class Walk:
    """A certificate, as far as it is verified.

    Parameters
    ----------
    certificate : dict
    conventions : Conventions
        Of the certificate.
    deadline : Deadline
    """

    def __init__(self, certificate: dict[str, Any], conventions: Conventions, deadline: Deadline) -> None:
        self.events: list[dict[str, Any]] = certificate["events"]
        self.phases: list[dict[str, Any]] = list(certificate["phases"])
        self.claim, self.conventions, self.until = certificate, conventions, conventions.until
        self.equations = Equations(conventions.scenario, deadline)
        require(bool(self.equations.kap > 0), "the ring has mass")
        self.state = self.equations.start
        self.origin = self.state.th
        self.mode, self.zeros = "H", 0
        self.bounce = arb(0)
        self.seen = 0
        self.letters: list[tuple[str, Ball]] = []
        self.last = ("H", arb(0))  # the mode after the last event, and its time
        self.over = ""

    # --- events --------------------------------------------------------------------------------

    def event(self, kind: str, before: str | None, after: str) -> None:
        """The next event is this one, and its numbers enclose the present state."""
        if self.seen == len(self.events) and self.claim["status"] == "event_limit":
            raise Stopped  # more than these events is not claimed
        require(self.seen < len(self.events), "no event is left out")
        one = self.events[self.seen]
        said = (one["kind"], one["from"], one["to"])
        require(
            said == (kind, before, after),
            f"event {self.seen} is {kind} {before} → {after}, not {said[0]} {said[1]} → {said[2]}",
        )
        for name, (value, unit) in self.equations.in_si(self.state).items():
            known = self.conventions.encloses(one[name], value, unit)
            require(known, f"{name} of event {self.seen} ({kind}) is where it is said to be")
        self.note(kind, after)

    def note(self, kind: str, after: str) -> None:
        """Count an event that is verified."""
        self.last = after, self.state.t
        if kind not in ("apex", "turn", "kane_gain", "rest"):
            self.letters.append(self.last)
        self.seen += 1

    def settle(self, kind: str, before: str | None, gains: bool = False) -> None:
        """The mode rule after an event."""
        for _ in range(8):
            rises = sign(self.state.vn, "v_n") > 0
            mode = "H" if rises else next_mode(self.equations, self.state)
            require(not (kind == "stick" and mode == before), "slip that stops does not go on")
            named = mode
            if len(mode) > 1:
                way = sign(self.state.vt, "v_t")
                named = "R" if way == 0 else "K" if way > 0 else "S"
            if kind == "stick" and named != "R":
                kind = "takeoff" if named == "H" else "slip_reversal"
            self.event(kind, before, named)
            if gains:
                self.event("kane_gain", named, named)
            if mode == "undetermined":
                self.end("undetermined", "undetermined", named)
                return
            if len(mode) == 1:
                self.enter(mode)
                return
            if mode == "indeterminate":
                self.event("painleve_indeterminate", named, named if self.equations.strike else "H")
                if not self.equations.strike:
                    self.enter("H")
                    return
            else:
                self.event("painleve_inconsistent", named, named)
            kind, before = "impact", named
            self.state, gains = collide(self.equations, self.state, self.equations.rest)
        raise Refused("impacts without collision come to an end")

    def enter(self, mode: str) -> None:
        """Begin a phase."""
        self.mode, state = mode, self.state
        if mode == "H":
            if not state.vn.is_zero():
                self.zeros = 1
            else:
                f_n = self.equations.eps * state.th.cos() * state.om * state.om - self.equations.gn
                self.zeros = 2 if sign(f_n, "f_n") > 0 else 3
        elif mode in SIGMA:
            self.zeros = slip_zeros(self.equations, state, SIGMA[mode])

    def end(self, status: str, ending: str, mode: str | None = None) -> None:
        """The last event."""
        last = mode or self.mode
        self.event("end", last, last)
        self.over = status
        require(self.claim["status"] == status and self.claim["ending"] == ending, "status and ending are as said")

    # --- phases --------------------------------------------------------------------------------

    def run(self) -> None:
        """From the start to the end, or to the limit of events."""
        try:
            self.walk()
            require(bool(self.over), "the motion comes to its end")
        except Stopped:
            require(self.claim["ending"] == "event_limit", "the ending is as said")
        require(self.seen == len(self.events) and not self.phases, "nothing follows the end")
        require(self.claim["sequence"] == self.sequence, "the sequence is that of the events")

    @property
    def sequence(self) -> str:
        """One letter per phase, as far as it is verified."""
        pairs = pairwise([*self.letters, self.last])  # the last event counts, whatever its kind
        found = "".join(a[0] for a, b in pairs if a[1] < b[1]) + ("H" if self.claim["ending"] == "takeoff" else "")
        return found or "".join(letter for letter, _ in self.letters[-1:])

    def walk(self) -> None:
        """From the start, phase after phase."""
        state = self.state
        if state.y.is_zero() and state.vn.is_zero():
            self.settle("start", None)
        else:
            self.event("start", "H", "H")
            if state.y.is_zero() and state.vn < 0:
                self.land()
            else:
                require(bool(state.y > 0) or bool(state.vn > 0), "the rim starts above the plane")
                self.zeros = 1 if state.y.is_zero() else 0
        while not self.over:
            {"R": self.rolling, "S": self.slipping, "K": self.slipping, "H": self.flying}[self.mode]()

    def record(self, mode: str) -> dict[str, Any]:
        """The certificate's record of the present phase."""
        if not self.phases and self.seen == len(self.events) and self.claim["status"] == "event_limit":
            raise Stopped
        require(bool(self.phases) and self.phases[0]["mode"] == mode, "every phase has its record")
        return self.phases.pop(0)

    def rolling(self) -> None:
        """Rolling, up to an event or a turning point."""
        if self._held(0):
            self.event("rest", "R", "R")
            self.state = replace(self.state, t=self.equations.t_end)
            self.end("at_rest", "rest")
            return
        if self.equations.resisted:
            self.panels(0)
            return
        one = self.record("R")
        self.state = roll(self.equations, self.state, one, self.until, self.origin)
        self.after(one["what"])

    def _held(self, sigma: int) -> bool:
        """Return True if a hoop with θ̇ = 0 stays so."""
        state = self.state
        if not state.om.is_zero():
            return False
        s, c = state.th.sin_cos()
        after = self.equations.just_after(state.th, state.om, sigma)
        return bool(after.contact(s, c, arb(0), sigma).alpha.is_zero())

    def slipping(self) -> None:
        """A slip phase with its turning points, or one without rotation."""
        if self._held(SIGMA[self.mode]):
            self.slide()
        else:
            self.panels(SIGMA[self.mode])

    def slide(self) -> None:
        """Slip at a constant angle: only gravity and friction along the plane."""
        one, sigma, state = self.record(self.mode), SIGMA[self.mode], self.state
        require(one.get("slides") is True, "slip without rotation is said to be so")
        pull = self.equations.gt - sigma * self.equations.mu_k * self.equations.gn
        tau = self.equations.t_end - state.t
        if one["what"] == "stop":
            require(bool(sigma * state.vt > 0) and bool(sigma * pull < 0), "slip without rotation stops")
            stop = -state.vt / pull
            require(self.until == "revolution" or bool(stop < tau), "slip stops before the end of the time")
            tau = stop
        else:
            require(one["what"] == "limit" and self.until == "duration", "slip goes on up to the end of the time")
            steady = bool(sigma * pull > 0) or bool(pull.is_zero())
            require(steady or bool(-state.vt / pull > tau), "slip does not stop before the end of the time")
        way = tau * (state.vt + pull * tau / 2)
        moved = replace(state, t=state.t + tau, x=state.x + way, vt=state.vt + pull * tau)
        self._leave(one["what"], moved)

    def panels(self, sigma: int) -> None:
        """A phase that is certified by panels, with its turning points."""
        one, t_end = self.record(self.mode), self.equations.t_end
        limit = ("limit", lambda panel, x: panel.limits(x, t_end)) if self.until == "duration" else ("span", self._turn_left)
        what, state, turns = verify_panels(self.equations, sigma, self.state, self.zeros, one, limit)
        for turn in turns:
            self.state = turn
            self.after("turn")
            if self.over:
                return
        self._leave(what, state)

    def _leave(self, what: str, state: State) -> None:
        self.state = replace(state, vt=arb(0)) if what == "stop" else state
        if what == "limit":
            self.state = replace(self.state, t=self.equations.t_end)
        self.after(what)

    def _turn_left(self, panel: Any, x: Ball) -> Jet:
        slope = 2 * x if isinstance(panel, TurnPanel) else arb(-1)
        return [2 * pi() - panel.way * (panel.angle(x) - self.origin), slope]

    def after(self, what: str) -> None:
        """Go through the end of a phase of contact, or a turning point in it."""
        was = self.mode
        if what == "turn":
            self.turn(was)
        elif what in ("limit", "span"):
            require((what == "limit") == (self.until == "duration"), "the motion ends where it is followed to")
            self.end("completed", "duration" if what == "limit" else "revolutions")
        elif what == "lift":
            self.event("takeoff", was, "H")
            self.mode, self.zeros = "H", 3
        elif what == "stop":
            self.settle("stick", was)
        elif opening(self.equations, self.state) >= 0:
            self.event("takeoff", "R", "H")
            self.enter("H")
        elif what == "open":
            self.end("undetermined", "undetermined", "R")
        else:
            require(what in ("ahead", "back"), "the end of a phase is a known one")
            self.mode = "S" if what == "ahead" else "K"
            self.event("slip_start", "R", self.mode)
            self.zeros = 2 if self.equations.equal_friction else 1

    def turn(self, was: str) -> None:
        """θ̇ = 0; with rolling resistance the couple jumps there, and the mode rule is asked again."""
        mode = was
        if self.equations.resisted:
            mode = next_mode(self.equations, self.state)
            if mode == was == "R" and self._held(0):
                return  # rest is what comes next
        paradox = was != "R" and len(mode) > 1
        if not paradox or self.until == "revolution":
            self.event("turn", was, was)
        if self.until == "revolution":
            self.end("completed", "reversal")
        elif mode != was:
            rolled = "takeoff" if mode == "H" else "slip_start"
            self.settle("turn" if paradox else rolled if was == "R" else "stick", was)
        else:
            self.zeros = 0

    # --- flight --------------------------------------------------------------------------------

    def flying(self) -> None:
        """A flight, its apex and its landing."""
        if self.until == "revolution":
            self.end("completed", "takeoff")
            return
        one, longest = self.record("H"), self.equations.t_end - self.state.t

        def functions(tau: Ball, terms: int) -> list[Jet]:
            return [gap(self.equations, self.state, tau, terms)]

        if one["to"] is None and skims(self.equations, self.state):
            tau, lands = longest, False  # a graze with ẏ = 0 is no event
        elif one["to"] is None:
            positive(functions, arb(0), longest, "nothing lands before the end of the time", [self.zeros])
            tau, lands = longest, False
        else:
            low, high = (arb(text) for text in one["to"])
            require(bool(low > 0), "the landing is ahead")
            positive(functions, arb(0), low, "the gap is positive in flight", [self.zeros])
            tau, lands = root(functions, 0, low, high, "the rim lands"), True
            require(bool(tau < longest), "the landing comes before the end of the time")
        landed = flown(self.equations, self.state, tau)
        if one["apex"] is not None:
            low, high = (arb(text) for text in one["apex"])

            def rates(x: Ball, terms: int) -> list[Jet]:
                jet = gap(self.equations, self.state, x, terms + 1)
                return [[(k + 1) * jet[k + 1] for k in range(terms)]]

            top = root(rates, 0, low, high, "the rim is highest")
            require(bool(top > 0) and bool(top < tau), "the apex is in the flight")
            height = gap(self.equations, self.state, top, 1)[0]
            no_top(self.equations, self.state, arb(0), low, self.zeros, height)
            no_top(self.equations, self.state, high, tau, 0, height)
            begin, self.state = self.state, replace(flown(self.equations, self.state, top), vn=arb(0))
            self.event("apex", "H", "H")
            self.state = begin
        elif not without_apex(self.equations, self.state, tau, self.zeros):
            no_top(self.equations, self.state, arb(0), tau, self.zeros, None)
        self.state = landed
        if not lands:
            self.end("completed", "duration")
            return
        self.state = replace(landed, y=arb(0))
        self.land()

    def land(self) -> None:
        """An impact, or the one that closes endless bounces by the rule of the model."""
        before = self.state
        self.state, gains = collide(self.equations, before, self.equations.rest)
        kind = "impact"
        if self._last(before):
            kind, gains = "bounce_limit", False
            self.state, _ = collide(self.equations, before, arb(0))
            require(bool(self.state.vn.is_zero()), "the last bounce ends on the plane")
        self.bounce = self.state.vn
        self.settle(kind, "H", gains)

    def _last(self, before: State) -> bool:
        state, last = self.state, self.bounce
        fall = self.equations.gn - self.equations.eps * state.th.cos() * state.om * state.om
        if sign(state.vn, "v_n") <= 0 or sign(fall, "f_n") <= 0 or not last > 0:
            return False
        require(bool(state.vn < last) or bool(last <= state.vn), "whether bounces shrink is certain")
        if not state.vn < last:
            return False
        left = 2 * state.vn / (fall * (1 - state.vn / last))
        most = arb(CLOSING) * before.t.max(arb(1))
        require(bool(left < most) or bool(most <= left), "whether bounces are closed is certain")
        return bool(left < most)
