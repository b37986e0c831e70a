"""Passages of a section, revolution by revolution, without segments."""

from __future__ import annotations

import math

import numpy as np

from hophoop.gaits.kernels.fates import (
    CONTACT_TURNS,
    LONGEST_PERIOD,
    MEMORY,
    OPEN,
    ROLLING_TURNS,
    angle_between,
    fastest_of,
    fate_at_passage,
    fate_at_start,
    fate_at_turn,
    is_below_top,
)
from hophoop.gaits.kernels.layout import (
    BRANCHES,
    COLUMNS,
    DOUBT,
    FEW_EVENTS,
    FRICTION,
    HEIGHT,
    HIGHEST,
    HOPS,
    IMPACT_NORMAL,
    IMPACT_TANGENTIAL,
    INTEGERS,
    LANDING,
    LETTERS,
    MODE,
    OMEGA,
    ROLLING_RESISTANCE,
    SLIP,
    T_LOW,
    THETA,
    THETA_LOW,
    TURNS,
    VY,
    X_LOW,
    Buffers,
    T,
    X,
)
from hophoop.kernel.model import PASSING, Event, ImpactLaw, Mode, Status, contact_arms, slip_rates
from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.records import EVENT, EVENTS, PANEL_LIMIT, PANELS, SEGMENT, add_letter, count_panel, has_room, new_log
from hophoop.kernel.steps import GOING, ROUNDING, Ending, Limits, angle_left, begin, can_follow, continue_phase, step
from hophoop.vocabulary.names import FateCode

ROWS = 2 * LONGEST_PERIOD + 2  # of a ring of passages in which any period is seen

# What is remembered since the last passage: the present phase's letter and start, letters, hops, the highest gap and the
# branches of the impacts; and of the motion's end, the energy lost and the revolutions.
LETTER, SINCE, COUNT, JUMPS, GAP, TAKEN, LOST, TURNED = range(MEMORY, MEMORY + 8)
SIZE = MEMORY + 8
KEPT = 2.0**40  # branches are kept modulo this
FAINT = 1e-3  # m √(gR): impacts with less impulse, as at the end of a sequence of bounces, have no branch


def new_buffers(rows):
    """Return the arrays for so many passages, of which later ones replace the first."""
    return Buffers(
        np.empty((rows, len(COLUMNS))), np.zeros((rows, INTEGERS), np.uint64), np.empty(SIZE), np.empty(FEW_EVENTS, EVENT),
        np.empty(0, SEGMENT),
    )  # fmt: skip


@inline
def limits_in_cell(t_end, cell, bounded):
    """Return limits half a revolution to either side of a load at the top, if the rim is bounded to them."""
    return Limits(t_end, 0, 0, PI if bounded else math.nan, 0.0, PI if bounded else 0.0, 0.0, cell, 0.0, 0.0, False)


@noinline
def cell_of(state):
    """Return the revolution, from bottom to bottom, that the hoop is in or about to enter."""
    cell = state.revolutions + math.floor((state.th + PI) / TWO_PI)
    limits = limits_in_cell(0.0, cell, True)
    rounding = ROUNDING * (1.0 + abs(state.revolutions))
    if state.om > 0.0 and angle_left(limits, state, 1.0) <= rounding:
        return cell + 1.0
    if state.om < 0.0 and angle_left(limits, state, -1.0) <= rounding:
        return cell - 1.0
    return cell


@noinline
def end_phase(words, row, memory):
    """Append the letter of the present phase to the word of a passage."""
    memory[COUNT] = add_letter(words, row, int(memory[COUNT]), int(memory[LETTER]))


@noinline
def branch_of(body, event):
    """Return the branch of an impact: 0 if the slip goes on, 1 if it stops, 2 if it reverses; 2 more if it does in compression.

    The map has a corner where it changes, also between motions with the same phases.
    """
    before, after = event["before_slip"], event["slip"]
    if before == 0.0 or before * after > 0.0:
        return 0.0
    branch = 1.0 if after == 0.0 else 2.0
    bounces = event["kind"] == Event.IMPACT and event["collision"] == 1 and body.rest > 0.0 and body.law != ImpactLaw.NEWTON
    if not bounces or body.kap == 0.0 or math.isinf(body.mu_k):
        return branch
    s, c = sine_cosine(event["theta"], event["theta_low"])
    arm, lever = contact_arms(body, s, c)
    _, slip, lift = slip_rates(body, arm, lever, -body.mu_k if before > 0.0 else body.mu_k)
    return branch + 2.0 if before * lift / slip > event["before_vy"] else branch


@noinline
def note_events(body, log, words, row, memory):
    """Read the events of a step into word and hops of the passage to come; return the fate that they decide, or OPEN."""
    fate = OPEN
    for i in range(log.counts[EVENTS]):
        event = log.events[i]
        kind = event["kind"]
        if kind == Event.TURN and event["after_mode"] != Mode.FLIGHT:
            found = fate_at_turn(body, event, memory)
            if fate == OPEN:
                fate = found
        if kind == Event.APEX:
            memory[GAP] = max(memory[GAP], event["height"])
        if kind in PASSING:
            continue
        if event["impulse_normal"] > FAINT and (kind == Event.IMPACT or kind == Event.BOUNCE_LIMIT):
            taken = 5.0 * memory[TAKEN] + branch_of(body, event)
            memory[TAKEN] = taken - KEPT * math.floor(taken / KEPT)
        memory[ROLLING_TURNS] = 0.0
        if event["after_mode"] == Mode.FLIGHT and event["height"] == 0.0 and not event["vy"] < 0.0:
            memory[JUMPS] += 1.0
        if event["t"] > memory[SINCE]:
            end_phase(words, row, memory)
        memory[LETTER] = event["after_mode"]
        memory[SINCE] = event["t"]
    log.counts[EVENTS] = 0
    return fate


@noinline
def write_passage(phase, numbers, words, row, memory, doubt):
    """Write a row, and start the word of the next passage."""
    state = phase.state
    if state.t > memory[SINCE]:
        end_phase(words, row, memory)
    out = numbers[row]
    out[T], out[T_LOW] = state.t, state.t_low
    out[X], out[X_LOW] = state.x, state.x_low
    out[HEIGHT] = state.y
    out[TURNS], out[THETA], out[THETA_LOW] = state.revolutions, state.th, state.th_low
    out[SLIP], out[VY], out[OMEGA] = state.vt, state.vn, state.om
    out[FRICTION] = state.friction
    out[IMPACT_NORMAL], out[IMPACT_TANGENTIAL] = state.impact_n, state.impact_t
    out[ROLLING_RESISTANCE] = state.rolling_loss
    out[MODE] = phase.mode
    out[HOPS] = memory[JUMPS]
    out[LETTERS] = memory[COUNT]
    out[DOUBT] = doubt
    out[HIGHEST] = memory[GAP]
    out[BRANCHES] = memory[TAKEN]
    memory[COUNT], memory[JUMPS], memory[GAP], memory[TAKEN], memory[SINCE] = 0.0, 0.0, 0.0, 0.0, state.t


def clear_word(words, row):
    """Empty a row of words."""
    for i in range(INTEGERS):
        words[row, i] = 0


@inline
def ends_at_section(before, phase, section):
    """Return True if a step has reached the section."""
    if section == LANDING:
        return before == Mode.FLIGHT and phase.ending == Ending.LANDING and phase.status == GOING
    return phase.status == Status.COMPLETED and phase.ending == Ending.ANGLE_LIMIT


@noinline
def fate_without_passages(body, phase, revolutions):
    """Return the fate of a motion that passes its section no more."""
    status = phase.status
    if status == Status.AT_REST:
        return FateCode.RESTS
    if status == Status.JAMMED:
        return FateCode.JAM
    if status == Status.UNDETERMINED:
        return FateCode.UNDETERMINED
    if abs(body.gt) > body.mu_s * body.gn:  # friction cannot hold it: it gets faster and faster
        return FateCode.RUNS_AWAY if revolutions > 2.0 else FateCode.SLIDES_AWAY
    return FateCode.UNDECIDED


def lands_no_more(section, status, fate):
    """Return True if a motion that is judged at landings has gone on without any: what becomes of it is seen at the bottom."""
    open_end = status in (Status.EVENT_LIMIT, Status.COMPLETED)
    return section == LANDING and open_end and fate in (FateCode.UNDECIDED, FateCode.SLIDES_AWAY, FateCode.RUNS_AWAY)


def follow_passages(body, start, mode, request, buffers, scratch):
    """Compute the passages of a section; return (status, passages, fate's code, period of a gait or 0).

    The status is GOING if the motion goes on. `mode` is that of the start, or BY_RULE.
    """
    limit = scratch.counts[PANEL_LIMIT]
    scratch.counts[PANEL_LIMIT] = request.panels
    numbers, words, memory = buffers.numbers, buffers.words, buffers.memory
    log = new_log(buffers.events, buffers.segments, scratch)
    phase = begin(body, start, mode, log)
    log.counts[EVENTS] = 0
    fastest = fastest_of(body, phase.state)
    memory[ROLLING_TURNS], memory[CONTACT_TURNS] = 0.0, 0.0
    memory[COUNT], memory[JUMPS], memory[GAP], memory[TAKEN] = 0.0, 0.0, 0.0, 0.0
    memory[SINCE], memory[LETTER] = phase.state.t, phase.mode
    fate, period = fate_at_start(body, phase.state), 0
    cell, passages, row = cell_of(phase.state), 0, 0
    clear_word(words, 0)
    while phase.status == GOING and has_room(log) and passages < request.most and not (request.stops and fate != OPEN):
        before = phase.mode
        count_panel(log)
        in_contact = before != Mode.FLIGHT and before != Mode.SKIM
        limits = limits_in_cell(request.t_end, cell, request.section != LANDING and in_contact)
        after = step(body, phase, limits, log, scratch)
        if not can_follow(phase.state, after.state, request.t_end):
            break
        phase = after
        found = note_events(body, log, words, row, memory)
        if fate == OPEN and found == OPEN and is_below_top(body, phase.state):
            found = FateCode.ROCKS if body.resist == 0.0 else FateCode.RESTS
        if fate == OPEN:
            fate = found
        if not ends_at_section(before, phase, request.section):
            if before in (Mode.FLIGHT, Mode.SKIM):
                cell = cell_of(phase.state)
            continue
        write_passage(phase, numbers, words, row, memory, log.doubt[0])
        if request.section != LANDING:
            cell += 1.0 if phase.state.om > 0.0 else -1.0
            phase = continue_phase(phase, phase.state, phase.level, Ending.CONTINUES, phase.anchor)
        if fate == OPEN:
            fate, period = fate_at_passage(body, numbers, words, passages, request.section, fastest)
        passages += 1
        if passages < request.most:
            row = passages % numbers.shape[0]
            clear_word(words, row)
        log.counts[PANELS] = 0
    status = phase.status
    if status == GOING and not (passages >= request.most or (request.stops and fate != OPEN)):
        status = Status.EVENT_LIMIT
    if fate == OPEN:
        fate = fate_without_passages(body, phase, abs(phase.state.revolutions - start.revolutions))
    scratch.counts[PANEL_LIMIT] = limit
    state = phase.state
    memory[LOST] = state.friction + state.impact_n + state.impact_t + state.rolling_loss
    memory[TURNED] = (state.revolutions - start.revolutions) + (state.th - start.th) / TWO_PI
    return status, passages, fate, period


def hops_in(numbers, passages, period):
    """Return the hops in the last passages of a gait."""
    hops = 0.0
    for k in range(period):
        hops += numbers[(passages - 1 - k) % numbers.shape[0], HOPS]
    return int(hops)


def turns_in(numbers, passages, period):
    """Return the whole revolutions in the last passages of a gait, in either direction."""
    length = numbers.shape[0]
    turned = angle_between(numbers[(passages - 1 - period) % length], numbers[(passages - 1) % length])
    return math.floor(abs(turned) / TWO_PI + 0.5)
