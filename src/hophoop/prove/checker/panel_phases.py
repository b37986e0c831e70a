"""A phase of panels that a certificate names, slip or rolling with resistance, verified panel by panel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hophoop.prove._flint import Ball, Jet, arb
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.intervals import positive, require, root
from hophoop.prove.checker.panels import Panel, TurnPanel, number
from hophoop.prove.checker.phase_equations import Roll, Slip

LIMIT, SPAN, TURN = "limit", "span", "turn"


@dataclass
class Way:
    """The place up to which a certified slip phase is verified."""

    th: Ball
    u: Ball
    t: Ball
    way: int
    known: list[int]
    turns: list[State]


def verify_panels(
    equations: Equations, sigma: int, state: State, zeros: int, record: dict[str, Any], limits: dict[str, Any]
) -> tuple[str, State, list[State]]:
    """(what ends a certified phase, the state there, the turning points before it)."""
    equations = equations.just_after(state.th, state.om, sigma)
    phase = Slip(equations, sigma, state) if sigma else Roll(equations, 0, state)
    bits, what = int(record["bits"]), record["what"]
    known = [0, zeros] if sigma else [0] * len(phase.names)
    at = Way(state.th, state.om * state.om, state.t, _direction(equations, sigma, state), known, [])
    panels = record["panels"]
    for k, one in enumerate(panels):
        ends = what if k == len(panels) - 1 else None
        verify = _through_turn if "g" in one else _along
        found = verify(phase, at, one, bits, limits, ends)
        if found is not None:
            return what, found, at.turns
    raise Refused("the last panel ends the phase")


def _along(
    phase: Slip | Roll, at: Way, one: dict[str, Any], bits: int, limits: dict[str, Any], what: str | None
) -> State | None:
    """A panel between turning points; the state at the event that ends it, if one does."""
    panel = Panel(phase, one, at.way, bits)
    begin = at.way * (at.th - panel.centre)
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > begin), "panels go on")
    panel.starts(at.th, at.u, at.t, end)
    stop = _stretch(panel, at.known, begin, end, limits, what, one)
    if stop is not None:
        return phase.state(panel.time(stop), panel.angle(stop), panel.spin(stop))
    at.th, at.u, at.t, at.known = panel.angle(end), panel.square(end), panel.time(end), [0] * len(phase.names)
    return None


def _through_turn(
    phase: Slip | Roll, at: Way, one: dict[str, Any], bits: int, limits: dict[str, Any], what: str | None
) -> State | None:
    """A panel about a turning point, or about a start with θ̇ = 0."""
    if at.u.is_zero():
        panel, begin = TurnPanel(phase, one, -at.way, bits, at.th), arb(0)
        panel.offset = at.t
    else:
        turn = _turning_angle(phase, at, one["link"], bits)
        panel, begin = TurnPanel(phase, one, at.way, bits, turn), -(at.way * (turn - at.th)).sqrt()
        require(bool(begin * begin <= panel.reach), "a panel reaches back to the start")
        panel.offset = at.t - panel.time(begin)
        early = what if what is not None and one["ends"] == "before" else None
        stop = _stretch(panel, at.known, begin, arb(0), limits, early, one)
        if stop is not None:
            require(bool(stop < 0), "the end of the phase comes before the turning point")
            return phase.state(panel.time(stop), panel.angle(stop), panel.spin(stop))
        after = phase.state(panel.time(arb(0)), turn, arb(0))
        if what == TURN:
            return after
        require(not phase.equations.resisted, "the couple is another after a turning point")
        at.turns.append(after)
        at.known, begin, at.way = [0] * len(phase.names), arb(0), -at.way
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > 0) and bool(end * end <= panel.reach), "a panel reaches far enough")
    stop = _stretch(panel, at.known, begin, end, limits, what, one)
    if stop is not None:
        return phase.state(panel.time(stop), panel.angle(stop), panel.spin(stop))
    at.th, at.u, at.t, at.known = panel.angle(end), panel.square(end), panel.time(end), [0] * len(phase.names)
    return None


def _turning_angle(phase: Slip | Roll, at: Way, record: dict[str, Any], bits: int) -> Ball:
    """θ* as the first root of θ̇²."""
    link = Panel(phase, record, at.way, bits)
    low, high = (arb(text) for text in record["bracket"])
    begin = at.way * (at.th - link.centre)
    require(bool(low > begin), "a turning point is ahead")
    link.starts(at.th, at.u, at.t, high)

    def square(x: Ball, terms: int) -> list[Jet]:
        s, c = link.angle(x).sin_cos()
        value = link.square(x)
        slope = 2 * link.way * phase.equations.contact(s, c, value, phase.sigma).alpha
        return [[value, slope][:terms]]

    positive(square, begin, low, "θ̇ stays away from zero before a turning point")
    return link.angle(root(square, 0, low, high, "θ̇ = 0"))


def _direction(equations: Equations, sigma: int, state: State) -> int:
    rate = state.om
    if rate.is_zero():
        s, c = state.th.sin_cos()
        rate = equations.contact(s, c, arb(0), sigma).alpha
    require(bool(rate > 0) or bool(rate < 0), "the hoop turns one way")
    return 1 if rate > 0 else -1


def _stretch(
    panel: Panel, zeros: list[int], begin: Ball, end: Ball, limits: dict[str, Any], what: str | None, one: dict[str, Any]
) -> Ball | None:
    """Nothing happens on the stretch; or the event in its bracket, before which nothing does."""
    names = list(panel.phase.names)
    if "t_end" in limits:
        names.append(LIMIT)
    if "turn_end" in limits:
        names.append(SPAN)

    def functions(x: Ball, terms: int) -> list[Jet]:
        found = panel.watch(x, terms)
        if "t_end" in limits:
            found.append(panel.limits(x, limits["t_end"])[:terms])
        if "turn_end" in limits:
            found.append(limits["turn_end"](panel, x)[:terms])
        return found

    known = zeros + [0] * (len(names) - len(zeros))
    if what is None:
        positive(functions, begin, end, "the phase goes on", known)
        return None
    low, high = (arb(text) for text in one["bracket"])
    require(bool(low > begin), "an event is ahead")
    positive(functions, begin, low, f"the phase goes on up to its end ({what})", known)
    return root(functions, names.index(what), low, high, f"the phase ends ({what})")
