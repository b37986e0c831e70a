"""A phase of panels over a box of parameters, in which each event is smeared over an interval of angles."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from hophoop.prove._flint import Ball, Undecided, arb, sign
from hophoop.prove.carriers import Carrier, Slip, carrier_of
from hophoop.prove.entering import entered
from hophoop.prove.panels import Panel, TurnPanel
from hophoop.prove.phases import MOST_PIECES, REST, Ended, Found, Limits, Phase, ended, panel, search, slide
from hophoop.prove.rolling import TURN
from hophoop.prove.search import Close, exact
from hophoop.prove.varied import over
from hophoop.prove.witness import Unrecorded

LEAST = 1 / 16  # of a panel, that is gone before an event is looked for again from nearer by


def travel_box(run: Phase, sigma: int) -> Iterator[Ended]:
    """Slip, or rolling with resistance, up to the event or the turning point that ends it."""
    state, limits, nothing = run.state, run.limits, Unrecorded()
    model = run.model.after(state.th, state.om, sigma)
    carrier: Carrier = carrier_of(model, sigma, state)
    known = [0, run.zeros] if sigma else [0] * len(carrier.names)
    way = sign(state.om, "θ̇")
    if way == 0:
        if sign(carrier.slope(state.th, arb(0)), "θ̈ of the hoop at rest"):
            raise Undecided("a box whose motions begin to turn is not covered")
        yield slide(carrier, limits) if isinstance(carrier, Slip) else Ended(REST, state, {})
        return
    centre = exact(state.th)
    carrier, u, t = entered(carrier, centre, way, run.energy if sigma else None, run.zeros > 1)
    x, begun = way * (state.th - centre), False
    for _ in range(MOST_PIECES):
        turning = panel(carrier.plain(), centre, way, over(u), over(t))
        if isinstance(turning, TurnPanel):  # it ends the revolution: how it varies is not wanted any more
            if not begun:
                raise Undecided("a turning point is near the begin of a phase")
            x = -(way * (turning.turn - centre)).sqrt()
            found = search(turning, [-1] * len(known), x.lower(), arb(0), limits)
            at_turn = replace(turning.state(arb(0)), om=arb(0))
            yield Ended(TURN, at_turn, {}) if found is None else ended(turning, found, nothing)
            return
        piece = Panel(carrier, centre, way, u, t)
        found, clear = _look(piece, known, x.lower(), limits, begun)
        if found is not None:
            yield ended(piece, found, nothing)
            return
        centre, u, t = exact(piece.angle(clear)), piece.square(clear), piece.time(clear)
        known, begun, x = [zeros if zeros > 0 else -1 for zeros in known], True, arb(0)
    raise Undecided(f"a phase takes more than {MOST_PIECES} panels")


def _look(piece: Panel, known: list[int], begin: Ball, limits: Limits, begun: bool) -> tuple[Found | None, Ball]:
    """(the first event on a panel, or how far there is none): an event that may be further on is looked for from nearer by."""
    clear = arb(0)
    for end in (piece.reach, piece.farthest):
        try:
            found = search(piece, known, begin, end, limits, begun)
        except Close as close:
            clear = clear.max(close.at)
            continue
        return found, end
    if not clear > piece.reach * LEAST:
        raise Undecided("an event comes too close to not happening")
    return None, exact(clear)
