"""A phase of rolling that a certificate names: margins on intervals, times as integrals with FLINT's own bounds."""

from __future__ import annotations

from functools import partial
from typing import Any

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, arb, coefficients, order, pi, series, symmetric
from hophoop.prove.checker.equations import Equations, State
from hophoop.prove.checker.intervals import positive, require, root
from hophoop.prove.checker.panel_phases import direction
from hophoop.prove.deadline import Deadline

NAMES = ("ahead", "back", "turn")


class Rolling:
    """Rolling from a state in a direction."""

    def __init__(self, equations: Equations, state: State, way: int) -> None:
        self.equations, self.begin, self.way = equations, state, way
        s, c = state.th.sin_cos()
        self.from_turn = bool(state.om.is_zero())
        self.energy = equations.height(state.th, s, c) + equations.inertia(c) * state.om * state.om / 2
        self.names = NAMES if equations.mu_s is not None else ("open", "turn")

    def square(self, th: Ball) -> Ball:
        """θ̇²."""
        s, c = th.sin_cos()
        return 2 * (self.energy - self.equations.height(th, s, c)) / self.equations.inertia(c)

    def margins(self, th: Ball, terms: int) -> list[Jet]:
        """What must stay positive, as series in the distance along θ."""
        equations = self.equations
        with order(terms):
            z = series([th, self.way])
            s, c = z.sin_cos()
            excess = self.energy - equations.height(z, s, c)
            contact = equations.contact(s, c, 2 * excess / equations.inertia(c), 0)
            return [coefficients(series([0]) + one, terms) for one in (*equations.margins(contact), excess)]

    def along(self, origin: Ball) -> Any:
        """The margins as functions of the way from an angle."""
        return lambda x, terms: self.margins(origin + self.way * x, terms)

    def clear(self, begin: Ball, end: Ball, fresh: bool) -> None:
        """Refuse unless nothing happens from one angle to another."""
        origin = begin.mid()
        zeros = [0] * (len(self.names) - 1) + [1 if fresh and self.from_turn else 0]
        positive(self.along(origin), self.way * (begin - origin), self.way * (end - origin), "rolling goes on", zeros)

    def event(self, what: str, bracket: list[Ball]) -> Ball:
        """The angle of the first event, inside its bracket."""
        first, last = bracket if self.way > 0 else bracket[::-1]
        require(bool(self.way * (first - self.begin.th) > 0), "an event is ahead")
        self.clear(self.begin.th, first, True)
        origin = first.mid()
        x = root(self.along(origin), self.names.index(what), arb(0), self.way * (last - origin), f"rolling ends ({what})")
        return origin + self.way * x

    def duration(self, a: Ball, b: Ball, from_turn: bool, to_turn: bool) -> Ball:
        """Time between two angles; at a turning point θ = turn ± w² takes the singularity away."""
        if from_turn and to_turn:
            middle = ((a + b) / 2).mid()
            return self.duration(a, middle, True, False) + self.duration(middle, b, False, True)
        deadline = self.equations.deadline
        if from_turn or to_turn:
            turn, other, way = (a, b, self.way) if from_turn else (b, a, -self.way)
            slowness = partial(self._slowness_at_turn, turn, way)
            return integral(slowness, arb(0), (way * (other - turn)).sqrt(), deadline)
        return self.way * integral(self._slowness, a, b, deadline)

    def _slowness(self, z: Ball, analytic: bool) -> Ball:
        equations = self.equations
        excess = self.energy - equations.height(z, z.sin(), z.cos())
        return (equations.inertia(z.cos()) / (2 * excess)).sqrt(analytic=analytic)

    def _slowness_at_turn(self, turn: Ball, way: int, w: Ball, analytic: bool) -> Ball:
        equations = self.equations
        half = way * w * w / 2
        middle = turn + half
        fall = way * (equations.eps * half.sinc() * (equations.gn * middle.sin() + equations.gt * middle.cos()) + equations.gt)
        return (2 * equations.inertia((turn + 2 * half).cos()) / fall).sqrt(analytic=analytic)

    def state(self, t: Ball, th: Ball, turns: bool) -> State:
        """The state at an angle."""
        zero = arb(0)
        om = zero if turns else self.way * self.square(th).sqrt()
        return State(t, self.begin.x + th - self.begin.th, zero, th, zero, zero, om)

    def angle_at(self, t: Ball, bracket: list[Ball]) -> Ball:
        """The angle at a time, which the bracket encloses."""
        first, last = bracket if self.way > 0 else bracket[::-1]
        require(bool(self.way * (first - self.begin.th) > 0), "the end of the time is ahead")
        missing = t - self.duration(self.begin.th, first, self.from_turn, False)
        require(bool(missing > 0), "the angle at the end of the time is in its bracket")
        speed = self.square(first.union(last)).sqrt()
        require(bool(self.way * (last - first) > speed * missing), "the angle at the end of the time is in its bracket")
        found = first + self.way * speed * missing
        while True:  # once more from there, until it does not get narrower: the digits double each time
            middle = found.mid()
            missing = t - self.duration(self.begin.th, middle, self.from_turn, False)
            around = found + symmetric(found.rad())
            narrower = found.intersection(middle + self.way * self.square(around).sqrt() * missing)
            if not 2 * narrower.rad() < found.rad():
                return narrower
            found = narrower


def roll(equations: Equations, state: State, record: dict[str, Any], until: str, origin: Ball) -> State:
    """The state at the end of a certified piece of rolling."""
    way, what = int(record["way"]), record["what"]
    require(way == direction(equations, 0, state), "rolling goes in its direction")
    rolling = Rolling(equations, state, way)
    timed = until == "duration"
    if what == "span":
        th = origin + 2 * way * pi()
        rolling.clear(state.th, th, True)
        return rolling.state(state.t + rolling.duration(state.th, th, rolling.from_turn, False), th, False)
    bracket = [arb(text) for text in record["angle"]]
    if what == "limit":
        turns = int(record.get("turns", 0))
        if turns:  # on the level what does not happen in a whole turn happens in none
            require(bool(equations.gt.is_zero()), "turns repeat on the level alone")
            whole = state.th + 2 * way * pi()
            rolling.clear(state.th, whole, True)
            shift = 2 * way * pi() * turns
            spent = rolling.duration(state.th, whole, False, False) * turns
            th = rolling.angle_at(equations.t_end - state.t - spent, [one - shift for one in bracket]) + shift
        else:
            last = bracket[1] if way > 0 else bracket[0]
            rolling.clear(state.th, last, True)
            th = rolling.angle_at(equations.t_end - state.t, bracket)
        return rolling.state(equations.t_end, th, False)
    th = rolling.event(what, bracket)
    if until == "revolution":
        require(bool(way * (th - origin) < 2 * pi()), "an event comes before the whole turn")
    t = state.t + rolling.duration(state.th, th, rolling.from_turn, what == "turn")
    require(not timed or bool(t < equations.t_end), "an event comes before the end of the time")
    return rolling.state(t, th, what == "turn")


def integral(function: Any, a: Ball, b: Ball, deadline: Deadline) -> Ball:
    """A definite integral, enclosed by FLINT."""

    def watched(z: Ball, analytic: bool) -> Ball:
        """Zero when the time is over, which ends the integral: no exception gets through it."""
        return _flint.acb(0) if deadline.over() else function(z, analytic)

    value = _flint.acb.integral(watched, _flint.acb(a), _flint.acb(b))
    deadline.ask()
    require(bool(value.is_finite()), "a time has an enclosure")
    return value.real
