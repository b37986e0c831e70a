"""A phase of panels that a certificate names, slip or rolling with resistance, verified panel by panel."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from hophoop.prove._flint import Ball, Jet, arb
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.intervals import positive, require, root
from hophoop.prove.checker.panels import Panel, TurnPanel, number
from hophoop.prove.checker.phase_equations import Roll, Slip

TURN = "turn"
Limit = tuple[str, Callable[[Any, Ball], Jet]]  # what else ends a phase: its name, and what is left to it on a panel


@dataclass
class Way:
    """The place up to which a certified phase is verified, and what is verified on the way."""

    phase: Slip | Roll
    bits: int
    limit: Limit
    th: Ball
    u: Ball
    t: Ball
    way: int
    known: list[int]
    turns: list[State]


def verify_panels(
    equations: Equations, sigma: int, state: State, zeros: int, record: dict[str, Any], limit: Limit
) -> tuple[str, State, list[State]]:
    """(what ends a certified phase, the state there, the turning points before it)."""
    equations = equations.just_after(state.th, state.om, sigma)
    phase = Slip(equations, sigma, state) if sigma else Roll(equations, 0, state)
    known = [0, zeros] if sigma else [0] * len(phase.names)
    way = direction(equations, sigma, state)
    at = Way(phase, int(record["bits"]), limit, state.th, state.om * state.om, state.t, way, known, [])
    what, panels = record["what"], record["panels"]
    for k, one in enumerate(panels):
        verify = _through_turn if "g" in one else _along
        found = verify(at, one, what if k == len(panels) - 1 else None)
        if found is not None:
            return what, found, at.turns
    raise Refused("the last panel ends the phase")


def _along(at: Way, one: dict[str, Any], what: str | None) -> State | None:
    """A panel between turning points; the state at the event that ends it, if one does."""
    panel = Panel(at.phase, one, at.way, at.bits)
    begin = at.way * (at.th - panel.centre)
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > begin), "panels go on")
    panel.starts(at.th, at.u, at.t, end)
    return _to_end(at, panel, begin, end, one, what)


def _through_turn(at: Way, one: dict[str, Any], what: str | None) -> State | None:
    """A panel about a turning point, or about a start with θ̇ = 0."""
    phase = at.phase
    if at.u.is_zero():
        panel, begin = TurnPanel(phase, one, -at.way, at.bits, at.th), arb(0)
        panel.offset = at.t
    else:
        turn = _turning_angle(at, one["link"])
        panel, begin = TurnPanel(phase, one, at.way, at.bits, turn), -(at.way * (turn - at.th)).sqrt()
        require(bool(begin * begin <= panel.reach), "a panel reaches back to the start")
        panel.offset = at.t - panel.time(begin)
        early = what if what is not None and one["ends"] == "before" else None
        found = _to_end(at, panel, begin, arb(0), one, early)
        if found is not None:
            require(bool(found.om * at.way > 0), "the end of the phase comes before the turning point")
            return found
        after = phase.state(at.t, turn, arb(0))
        if what == TURN:
            return after
        require(not phase.equations.resisted, "the couple is another after a turning point")
        at.turns.append(after)
        begin, at.way = arb(0), -at.way
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > 0) and bool(end * end <= panel.reach), "a panel reaches far enough")
    return _to_end(at, panel, begin, end, one, what)


def _to_end(at: Way, panel: Panel, begin: Ball, end: Ball, one: dict[str, Any], what: str | None) -> State | None:
    """Nothing happens up to the end of a panel, to which it goes on; or the state at the event in its bracket."""
    names = [*at.phase.names, at.limit[0]]

    def functions(x: Ball, terms: int) -> list[Jet]:
        return [*panel.watch(x, terms), at.limit[1](panel, x)[:terms]]

    known = [*at.known, 0]
    if what is None:
        positive(functions, begin, end, "the phase goes on", known)
        at.th, at.u, at.t, at.known = panel.angle(end), panel.square(end), panel.time(end), [0] * len(at.phase.names)
        return None
    low, high = (arb(text) for text in one["bracket"])
    require(bool(low > begin), "an event is ahead")
    positive(functions, begin, low, f"the phase goes on up to its end ({what})", known)
    stop = root(functions, names.index(what), low, high, f"the phase ends ({what})")
    return at.phase.state(panel.time(stop), panel.angle(stop), panel.spin(stop))


def _turning_angle(at: Way, record: dict[str, Any]) -> Ball:
    """θ* as the first root of θ̇²."""
    phase, link = at.phase, Panel(at.phase, record, at.way, at.bits)
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


def direction(equations: Equations, sigma: int, state: State) -> int:
    """The direction in which a hoop turns, or begins to turn."""
    rate = state.om
    if rate.is_zero():
        s, c = state.th.sin_cos()
        rate = equations.contact(s, c, arb(0), sigma).alpha
    require(bool(rate > 0) or bool(rate < 0), "the hoop turns one way")
    return 1 if rate > 0 else -1
