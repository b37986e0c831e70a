"""The record of a phase in a certificate: brackets of the events, and polynomials for θ̇² and t in slip.

None of it has to be trusted: the checker puts it into the equations. So it is made with midpoints of balls, in wider
panels than those of the proof.
"""

from __future__ import annotations

import math
from typing import Any

from hophoop.prove._flint import Ball, arb, bits, coefficients, order, polynomial, precision
from hophoop.prove.enclosures.roots import Root
from hophoop.prove.phases.panels import Panel, TurnPanel
from hophoop.prove.phases.phase_equations import PhaseEquations

WIDE = 1e-8  # half width of a bracket, where nothing else is near
BITS_A_TERM = 1.5
WIDEST = 0.5  # rad
GUARD = 6


def text(x: Ball) -> str:
    """A number of a bracket, where the last digits do not matter."""
    return str(x.mid().str(max(20, bits() * 3 // 10), radius=False))


def bracket(x: Ball, low: Ball | None = None, high: Ball | None = None) -> list[str]:
    """Ends of a bracket about a root, not beyond where it is known to be the only one; the lower one first."""
    wide = arb(WIDE).max(x.rad() * 16)
    ends = [(x - wide).mid(), (x + wide).mid()]
    if low is not None and high is not None:
        low, high = low.min(high), low.max(high)
        ends = [ends[0].max(low.mid()), ends[1].min(high.mid())]
    return [text(end) for end in ends]


def digits36(number: int) -> str:
    """An integer to base 36."""
    sign, number = ("-", -number) if number < 0 else ("", number)
    found = ""
    while number:
        number, digit = divmod(number, 36)
        found = "0123456789abcdefghijklmnopqrstuvwxyz"[digit] + found
    return sign + (found or "0")


def packed(values: list[Ball], reach: float, precise: int) -> str:
    """A polynomial in x/reach, to 2^−precise each."""
    numbers = []
    with precision(2 * precise + 300):  # so that the middle is rounded to an integer and to no other number
        scale, step = arb(2) ** precise, arb(reach)
        for k, value in enumerate(values):
            whole = ((value.mid() * scale * step**k).mid() + arb(0.5)).floor()
            numbers.append(int(whole.unique_fmpz()))
    while len(numbers) > 1 and numbers[-1] == 0:
        numbers.pop()
    return " ".join(map(digits36, numbers))


def extent(values: list[Ball], precise: int) -> float:
    """The distance up to which the last terms of a series stay below 2^−precise."""
    found = WIDEST
    size = len(values) - 1
    for k in range(size - 3, size + 1):
        value = abs(values[k].mid())
        if value > 0:
            log = float(value.log()) / math.log(2)
            found = min(found, 2.0 ** (-(precise + log) / k))
    return found


class Unrecorded:
    """No record, where no certificate is wanted."""

    def panel(self, panel: Panel) -> None:
        """A panel in the angle."""

    def turn(self, panel: TurnPanel) -> None:
        """A panel about a turning point."""

    def leave(self, w: Ball) -> None:
        """The turning point is left."""

    def record(self, what: str, root: Root | None) -> dict[str, Any]:
        """The record of the phase."""
        return {}


class Trail:
    """The panels of a phase as they are proved, made into the record of a certificate."""

    def __init__(self, phase: PhaseEquations, th: Ball) -> None:
        self.phase, self.precise = phase, bits()
        self.at = float(th.mid())  # where the record has come to
        self.panels: list[dict[str, Any]] = []
        self.proved: list[Panel] = []
        self.about: TurnPanel | None = None

    def panel(self, panel: Panel) -> None:
        """A panel in the angle."""
        self.about = None
        self.proved.append(panel)

    def turn(self, panel: TurnPanel) -> None:
        """A panel about a turning point: the way to it is recorded first."""
        way, at_begin = panel.way, not self.proved and not self.panels
        self._record_way()
        reach = float(panel.reach.lower())
        one: dict[str, Any] = {
            "reach": reach,
            "g": packed(panel.g_terms, reach, self.precise),
            "h": packed(panel.t_terms, reach, self.precise),
        }
        distance = way * (panel.turn - arb(self.at))
        if not (at_begin and self.phase.begin.om.is_zero()):
            one["link"] = self._link(way, distance, self._begin_square())
        self.panels.append(one)
        self.about, self.proved = panel, []

    def leave(self, w: Ball) -> None:
        """The turning point is left at w."""
        assert self.about is not None
        self.panels[-1]["to"] = float(w)
        self.at = float(self.about.angle(w).mid())

    def record(self, what: str, root: Root | None) -> dict[str, Any]:
        """The record of the phase."""
        mode = "RKS"[self.phase.sigma]
        found = {"mode": mode, "what": what, "bits": self.precise, "panels": self.panels}
        if root is None:
            self.panels[-1]["ends"] = "turn"
            return found
        if self.about is not None:
            self.panels[-1]["ends"] = "before" if root.x < 0 else "after"
            self.panels[-1]["bracket"] = bracket(root.x, root.low, root.high)
            return found
        last = self.proved[-1]
        centre, way = last.centre, last.way
        self._record_way(float(last.angle(root.x).mid()))
        shift = way * (centre - arb(self.panels[-1]["centre"]))
        self.panels[-1]["bracket"] = bracket(root.x + shift, root.low + shift, root.high + shift)
        self.panels[-1].pop("to", None)
        return found

    def _record_way(self, end: float | None = None) -> None:
        """Record panels over the proved ones, up to an angle or to the end of the last one."""
        if not self.proved:
            return
        way = self.proved[0].way
        last = self.proved[-1]
        goal = float(last.angle(last.reach).mid()) if end is None else end
        past = 4 * WIDE if end is not None else 0.0
        while way * (goal - self.at) > 0 or not self.panels or past:
            one = self._best(way, self.at)
            begin = way * (self.at - one["centre"])
            to = way * (goal - one["centre"])
            if to + past <= one["reach"]:
                one["to"] = to
                self.panels.append(one)
                self.at = goal
                return
            one["to"] = one["reach"] - past
            if not one["to"] > begin:
                one["to"] = (one["reach"] + begin) / 2
            self.panels.append(one)
            self.at = one["centre"] + way * one["to"]

    def _best(self, way: int, at: float) -> dict[str, Any]:
        """The widest panel that reaches back to an angle."""
        first = self._series(way, at)
        last = self.proved[-1]
        farthest = way * (float(last.angle(last.reach).mid()) - at)
        for share in (0.9, 0.6):
            ahead = min(share * first["reach"], farthest)
            if ahead <= 0:
                break
            other = self._series(way, at + way * ahead)
            if other["reach"] >= abs(other["centre"] - at) * (1 + 1e-9):
                return other
        return first

    def _square(self, th: float) -> Ball:
        """θ̇² at an angle that the proved panels cover."""
        found = self.proved[-1]
        for panel in self.proved:
            if not panel.way * (arb(th) - panel.centre) > panel.reach:
                found = panel
                break
        return found.square((found.way * (arb(th) - found.centre)).mid()).mid()

    def _series(self, way: int, centre: float) -> dict[str, Any]:
        """Polynomials about an angle, as far as they go."""
        precise, ask = self.precise, self.phase.model.deadline.ask
        with precision(precise + 40):
            u, t = self._terms(way, centre, self._square(centre))
            ask()
            reach = min(extent(u, precise + GUARD), extent(t, precise + GUARD))
            found = {"centre": centre, "reach": reach, "u": packed(u, reach, precise)}
            ask()
            return found | {"t": packed(t, reach, precise)}

    def _terms(self, way: int, centre: float, square: Ball) -> tuple[list[Ball], list[Ball]]:
        terms = int(self.precise / BITS_A_TERM) + 8
        with order(terms):
            found = self.phase.square(arb(centre), square, way, terms)
            middles = [value.mid() for value in coefficients(found, terms)]
            times = coefficients(found.rsqrt().integral(), terms) if square > 0 else middles
        return middles, [value.mid() for value in times]

    def _begin_square(self) -> Ball:
        """θ̇² where the record has come to."""
        if self.proved:
            return self._square(self.at)
        if self.about is not None:
            w = arb(self.panels[-1]["to"])
            return (w * w * self.about.over(w)).mid()
        begin = self.phase.begin
        with order(8):  # the record goes on from a double next to the angle of the start
            near = coefficients(self.phase.square(begin.th.mid(), (begin.om * begin.om).mid(), 1, 8), 8)
        return polynomial(near, arb(self.at) - begin.th.mid()).mid()

    def _link(self, way: int, distance: Ball, square: Ball) -> dict[str, Any]:
        """θ̇² alone, from where the record has come to until it vanishes."""
        with precision(self.precise + 40):
            u, _ = self._terms(way, self.at, square)
            reach = float(distance.mid()) * 1.0625
            return {
                "centre": self.at,
                "reach": reach,
                "u": packed(u, reach, self.precise),
                "bracket": bracket(distance, distance - distance / 32, distance + distance / 32),
            }
