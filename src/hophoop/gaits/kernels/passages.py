"""Passages of a section, revolution by revolution, without segments."""

from __future__ import annotations

import math

import numpy as np

from hophoop.gaits.kernels.fates import (
    LONGEST_PERIOD,
    MEMORY,
    OPEN,
    ROLLING_TURNS,
    fastest_of,
    fate_at_passage,
    fate_at_start,
    fate_at_turn,
    is_below_top,
)
from hophoop.gaits.kernels.layout import (
    AHEAD,
    BRANCHES,
    COLUMNS,
    DOUBT,
    FEW_EVENTS,
    HIGHEST,
    HOPS,
    INTEGERS,
    LANDING,
    LETTERS,
    MODE,
    Buffers,
)
from hophoop.kernel.model import PASSING, Event, ImpactLaw, Mode, Status, contact_arms, slip_rates
from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.records import EVENT, EVENTS, PANEL_LIMIT, PANELS, SEGMENT, add_letter, count_panel, has_room, new_log
from hophoop.kernel.steps import GOING, ROUNDING, Ending, Limits, begin, can_follow, continue_phase, step
from hophoop.vocabulary.names import FateCode

ROWS = 2 * LONGEST_PERIOD + 2  # of a ring of passages in which any period is seen

# What is remembered of a motion: the present phase's letter and start, and hops; at its end the energy lost and revolutions.
LETTER, SINCE, JUMPS, LOST, TURNED = range(MEMORY, MEMORY + 5)
SIZE = MEMORY + 5
FOREVER = 1e9  # √(R/g): a motion that takes longer from passage to passage is given up
MOST_BETWEEN = 20_000  # panels between two passages
KEPT = 2.0**40  # branches are kept modulo this
FAINT = 1e-3  # m √(gR): impacts with less impulse, as at the end of a sequence of bounces, have no branch


def new_buffers(rows):
    """Return the arrays for so many passages, of which later ones replace the first."""
    return Buffers(
        np.empty((rows, len(COLUMNS))), np.zeros((rows, INTEGERS), np.uint64), np.empty(SIZE), np.empty(FEW_EVENTS, EVENT),
        np.empty(0, SEGMENT),
    )  # fmt: skip


@inline
def cell_of(state):
    """Return the revolution, from bottom to bottom, that the hoop is in or about to enter."""
    ahead = math.copysign(ROUNDING * (1.0 + abs(state.revolutions)), state.om)
    return state.revolutions + math.floor((state.th + PI + ahead) / TWO_PI)


@noinline
def begin_row(buffers, row):
    """Empty the row and the word of the next passage."""
    buffers.numbers[row, :] = 0.0
    buffers.words[row, :] = 0


@noinline
def end_phase(buffers, row):
    """Append the letter of the present phase to the word of the next passage."""
    out = buffers.numbers[row]
    out[LETTERS] = add_letter(buffers.words, row, int(out[LETTERS]), int(buffers.memory[LETTER]))


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
def note_events(body, log, buffers, row, fate):
    """Read the events of a step into the row and the word of the next passage; return the fate that they decide, or OPEN."""
    out, memory = buffers.numbers[row], buffers.memory
    for i in range(log.counts[EVENTS]):
        event = log.events[i]
        kind = event["kind"]
        if kind == Event.TURN and event["after_mode"] != Mode.FLIGHT and fate == OPEN:
            fate = fate_at_turn(body, event, memory)
        if kind == Event.APEX:
            out[HIGHEST] = max(out[HIGHEST], event["height"])
        if kind in PASSING:
            continue
        if event["impulse_normal"] > FAINT and (kind == Event.IMPACT or kind == Event.BOUNCE_LIMIT):
            taken = 5.0 * out[BRANCHES] + branch_of(body, event)
            out[BRANCHES] = taken - KEPT * math.floor(taken / KEPT)
        memory[ROLLING_TURNS] = 0.0
        if event["after_mode"] == Mode.FLIGHT and event["height"] == 0.0 and not event["vy"] < 0.0:
            memory[JUMPS] += 1.0
        if event["t"] > memory[SINCE]:
            end_phase(buffers, row)
        memory[LETTER] = event["after_mode"]
        memory[SINCE] = event["t"]
    log.counts[EVENTS] = 0
    return fate


@noinline
def write_passage(phase, buffers, row, doubt):
    """Write the state into a row, and end its word."""
    state, out, memory = phase.state, buffers.numbers[row], buffers.memory
    if state.t > memory[SINCE]:
        end_phase(buffers, row)
    for column, value in enumerate(state):
        out[column] = value
    out[MODE], out[AHEAD], out[HOPS], out[DOUBT] = phase.mode, state.om > 0.0, memory[JUMPS], doubt
    memory[SINCE] = state.t


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
    scratch.counts[PANEL_LIMIT] = MOST_BETWEEN
    memory = buffers.memory
    log = new_log(buffers.events, buffers.segments, scratch)
    phase = begin(body, start, mode, log)
    log.counts[EVENTS] = 0
    fastest = fastest_of(body, phase.state)
    memory[:] = 0.0
    memory[SINCE], memory[LETTER] = phase.state.t, phase.mode
    fate, period, passages, row = fate_at_start(body, phase.state), 0, 0, 0
    cell = cell_of(phase.state)
    begin_row(buffers, row)
    while phase.status == GOING and has_room(log) and passages < request.most and not (request.stops and fate != OPEN):
        before = phase.mode
        flies = before == Mode.FLIGHT or before == Mode.SKIM
        count_panel(log)
        span = math.nan if flies or request.section == LANDING else PI  # half a revolution to either side of the top
        limits = Limits(FOREVER, 0, 0, span, 0.0, span, 0.0, cell, 0.0, 0.0, False)
        after = step(body, phase, limits, log, scratch)
        if not can_follow(phase.state, after.state, FOREVER):
            break
        phase = after
        fate = note_events(body, log, buffers, row, fate)
        if fate == OPEN and is_below_top(body, phase.state):
            fate = FateCode.ROCKS if body.resist == 0.0 else FateCode.RESTS
        if not ends_at_section(before, phase, request.section):
            cell = cell_of(phase.state) if flies else cell
            continue
        write_passage(phase, buffers, row, log.doubt[0])
        if request.section != LANDING:
            cell = cell_of(phase.state)
            phase = continue_phase(phase, phase.state, phase.level, Ending.CONTINUES, phase.anchor)
        if fate == OPEN:
            fate, period = fate_at_passage(body, buffers, passages, request.section, fastest)
        passages += 1
        if passages < request.most:
            row = passages % len(buffers.numbers)
            begin_row(buffers, row)
        log.counts[PANELS] = 0
    status, state = phase.status, phase.state
    if status == GOING and not (passages >= request.most or (request.stops and fate != OPEN)):
        status = Status.EVENT_LIMIT
    memory[TURNED] = (state.revolutions - start.revolutions) + (state.th - start.th) / TWO_PI
    if fate == OPEN:
        fate = fate_without_passages(body, phase, abs(state.revolutions - start.revolutions))
    memory[LOST] = state.friction + state.impact_n + state.impact_t + state.rolling_loss
    return status, passages, fate, period
