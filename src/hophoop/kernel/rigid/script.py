"""Motions with known first events (a script): the events are copied, and the phases between them computed."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.panel import FLY, HOLD, no_panel
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.records.layout import SEGMENTS
from hophoop.kernel.records.state import moved
from hophoop.kernel.records.writing import copy_event, has_room, new_log, state_of, write_segment
from hophoop.kernel.rigid.contact_phase import advance_contact, frozen_end
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.limits import limits_of
from hophoop.kernel.rigid.panel_choice import set_anchor
from hophoop.kernel.rigid.phase import Phase, begin_phase, begin_slip_after_roll, continue_phase, opening_of

FLIGHT, SLIP_START = int(Mode.FLIGHT), int(Event.SLIP_START)


@apart
def fill_phase(body, mode, state, until, until_low, log, scratch):
    """Write the segments of a phase that is known to last until a time given as a double-double."""
    if mode == FLIGHT:
        write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, opening_of(body, state)[0], state, until)
        return
    # The final time is one double, and its rounding may be a large part of a slip. So all times are shifted by the low half
    # meanwhile.
    first = log.counts[SEGMENTS]
    early = state.t_low - until_low
    shifted = moved(state, state.t, early, state.x, state.x_low, state.y, state.turns, state.th, state.th_low)
    fill_contact(body, mode, shifted, until, log, scratch)
    for index in range(first, log.counts[SEGMENTS]):
        log.segments[index]["t_low"] += until_low
    if log.counts[SEGMENTS] > first:
        log.segments[first]["t_low"] = state.t_low


@apart
def fill_contact(body, mode, state, until, log, scratch):
    """Write the segments of rolling or slip that is known to last until a time given as a double."""
    limits = limits_of(state, until, math.nan, 0)
    phase = begin_phase(body, mode, state, 0.0, Ending.CONTINUES, scratch)
    while phase.state.t < until and has_room(log):
        written = log.counts[SEGMENTS]
        what, state, level = advance_contact(body, phase, True, limits, log, scratch)
        if what == Ending.TIME_LIMIT and log.counts[SEGMENTS] == written:  # too short for a panel: treated as HOLD
            state = phase.state
            what = Ending.REST
        if what in (Ending.REST, Ending.SINGULAR, Ending.SEARCH_LIMIT):
            sigma = slip_direction(mode)
            rate = frozen_end(body, sigma, state.vt)[0] if sigma != 0 else 0.0
            write_segment(log, mode, no_panel(HOLD, sigma, 0.0), 0.0, rate, state, until)
            return
        phase = continue_phase(phase, state, level, what)


def fill_script(body, script, segments, scratch):
    """Write the segments between the events of a script; return their number, −1 if there is no room.

    Always interpreted: few motions have a script, and within `run` this would add 10 % to the compile time.
    """
    log = new_log(script, segments, scratch)
    for row in range(script.shape[0] - 1):
        end = script[row + 1]["t"], script[row + 1]["t_low"]
        if script[row]["t"] < end[0]:
            fill_phase(body, script[row]["after_mode"], state_of(script[row]), *end, log, scratch)
    return log.counts[SEGMENTS]


@apart
def repeat(body, script, log, scratch):
    """Write the events of a script; return the phase of its last one."""
    last = script.shape[0] - 1
    for row in range(last):
        copy_event(log, script[row])
    mode = script[last]["after_mode"]
    state = state_of(script[last])
    phase = begin_phase(body, mode, state, 0.0, Ending.CONTINUES, scratch)
    if script[last]["t"] > script[last - 1]["t"]:  # inside a phase
        if mode != FLIGHT:
            s, c = sine_cosine(state.th, state.th_low)
            state = set_anchor(body, slip_direction(mode), state, s, c, scratch)
        return Phase(mode, state, False, phase.zeros, phase.opening, phase.level, 0.0, Ending.CONTINUES, phase.status)
    if script[last - 1]["kind"] == SLIP_START:
        return begin_slip_after_roll(body, phase, mode, state, Ending.CONTINUES)
    return phase
