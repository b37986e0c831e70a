"""A phase of panels over a box of parameters: each event is spread over an interval of angles."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from hophoop.prove._flint import Ball, Undecided, arb, sign
from hophoop.prove.enclosures.mean_value_form import over
from hophoop.prove.enclosures.roots import Close, exact
from hophoop.prove.phases.contact import MOST_PIECES, REST, Ended, Found, Limits, PhaseInput, ended, panel_at, search, slide
from hophoop.prove.phases.panels import Panel, TurnPanel
from hophoop.prove.phases.phase_equations import PhaseEquations, Slip, phase_equations
from hophoop.prove.phases.phase_start import move_start
from hophoop.prove.phases.rolling import TURN
from hophoop.prove.phases.trail_recorder import Unrecorded

LEAST = 1 / 16  # of a panel: the least advance before an event is searched for again


def travel_box(run: PhaseInput, sigma: int) -> Iterator[Ended]:
    """Slip, or rolling with resistance, up to the event or the turning point that ends it."""
    state, limits, nothing = run.state, run.limits, Unrecorded()
    model = run.model.after(state.th, state.om, sigma)
    phase: PhaseEquations = phase_equations(model, sigma, state)
    known = [0, run.zeros] if sigma else [0] * len(phase.names)
    way = sign(state.om, "θ̇")
    if way == 0:
        if sign(phase.slope(state.th, arb(0)), "θ̈ of the hoop at rest"):
            raise Undecided("a box whose motions begin to turn is not covered")
        yield slide(phase, limits) if isinstance(phase, Slip) else Ended(REST, state, {})
        return
    centre = exact(state.th)
    phase, u, t = move_start(phase, centre, way, run.energy if sigma else None, run.zeros > 1)
    x, begun = way * (state.th - centre), False
    for _ in range(MOST_PIECES):
        turning = panel_at(phase.plain(), centre, way, over(u), over(t))
        if isinstance(turning, TurnPanel):  # it ends the revolution: how it varies is not wanted any more
            if not begun:
                raise Undecided("a turning point is near the start of a phase")
            x = -(way * (turning.turn - centre)).sqrt()
            found = search(turning, [-1] * len(known), x.lower(), arb(0), limits)
            at_turn = replace(turning.state(arb(0)), om=arb(0))
            yield Ended(TURN, at_turn, {}) if found is None else ended(turning, found, nothing)
            return
        panel = Panel(phase, centre, way, u, t)
        found, clear = _look(panel, known, x.lower(), limits, begun)
        if found is not None:
            yield ended(panel, found, nothing)
            return
        centre, u, t = exact(panel.angle(clear)), panel.square(clear), panel.time(clear)
        known, begun, x = [zeros if zeros > 0 else -1 for zeros in known], True, arb(0)
    raise Undecided(f"a phase takes more than {MOST_PIECES} panels")


def _look(panel: Panel, known: list[int], begin: Ball, limits: Limits, begun: bool) -> tuple[Found | None, Ball]:
    """(the first event on the panel or None, the distance proved free of events)."""
    clear = arb(0)
    for end in (panel.reach, panel.farthest):
        try:
            found = search(panel, known, begin, end, limits, begun)
        except Close as close:
            clear = clear.max(close.at)
            continue
        return found, end
    if not clear > panel.reach * LEAST:
        raise Undecided("an event comes too close to not happening")
    return None, exact(clear)
