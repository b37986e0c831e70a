"""Rolling and slip, panel by panel, up to the first event inside a panel."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import TWO_PI, TWO_PI_LOW, add, plus
from hophoop.kernel.numerics.circular import cosine, sine_and_cosine, sine_cosine, sine_cosine_change, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import ORDER, antiderivative, dot, lagrange
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.anchor import (
    NONE,
    ROLLING,
    SLIPPING,
    Anchor,
    offset_from,
)
from hophoop.kernel.panels.panel import (
    ARRIVE,
    HOLD,
    LINEAR,
    LOSS,
    RESOLVED,
    ROLLING_LOSS,
    ROLLING_POWER,
    SLIP,
    TIME,
    U,
    angle_at,
    fill_inside,
    no_panel,
    sine_versine_of_offset,
)
from hophoop.kernel.panels.solve import u_on_panel
from hophoop.kernel.physics.body import (
    AT_REST,
    COMPLETED,
    FLIGHT,
    JAMMED,
    REST,
    ROLL,
    SKIM,
    SLIP_START,
    STICK,
    TAKEOFF,
    TURN,
    UNDETERMINED,
)
from hophoop.kernel.physics.closed_forms import rest_curvature, slip_displacement
from hophoop.kernel.physics.contact import (
    acceleration_in_contact,
    inertia_at_height,
    kappa_p_sigma,
    load_height,
    torque_at_rest,
)
from hophoop.kernel.physics.modes import next_mode, slip_direction
from hophoop.kernel.records.layout import STOP_AT_TURN
from hophoop.kernel.records.state import (
    FARTHEST,
    State,
    at_time,
    later,
    moved,
    time_left,
    with_anchor,
    with_losses,
    with_velocities,
)
from hophoop.kernel.records.writing import (
    count_panel,
    event_without_jump,
    has_room,
    record_doubt,
    write_event,
    write_plain_event,
    write_segment,
)
from hophoop.kernel.rigid.flight_phase import begin_skim
from hophoop.kernel.rigid.panel_choice import choose_panel, exceeds_time_left, narrow_to_time, set_anchor
from hophoop.kernel.rigid.panel_events import SMALLEST_SQUARE, earliest_event
from hophoop.kernel.rigid.phase import GOING, Ending, at_span, begin_phase, continue_phase, end_motion
from hophoop.kernel.rigid.transitions import leave_cone, resolve_mode, resolve_painleve_singularity

STILL_ACCELERATION = 1e-15
LOST = 1e-9  # relative error of θ̇² near the unstable equilibrium above which v_t has lost digits too
FINEST_PREDICTED = 24  # finest level for which the next one is predicted: beyond, near p_σ = 0, truncation errors are rounding


@noinline
def with_turns(body, state, more):
    """Count `more` revolutions in `revolutions` instead of in θ."""
    th, low = add((state.th, state.th_low), (-more * TWO_PI, -more * TWO_PI_LOW))
    after = moved(state, state.t, state.t_low, state.x, state.x_low, state.y, state.revolutions + more, th, low)
    anchor = state.anchor
    if anchor.kind == SLIPPING and body.mu_k == 0.0:
        return after  # without friction the anchor is the same in every revolution
    if anchor.kind == ROLLING and anchor.bend > 0.0:  # of the next revolution, which is lower on a slope
        excess = anchor.excess + 2.0 * more * TWO_PI * body.gt
        return with_anchor(after, Anchor(ROLLING, excess, anchor.base, anchor.base_low, anchor.bend))
    base, base_low = add((anchor.base, anchor.base_low), (-more * TWO_PI, -more * TWO_PI_LOW))
    return with_anchor(after, Anchor(anchor.kind, anchor.excess, base, base_low, anchor.bend))


@inline
def normalize_turns(body, state):
    """Move one revolution from θ into `revolutions`."""
    return with_turns(body, state, 1.0 if state.th > 0.0 else -1.0)


@noinline
def is_equilibrium(body, sigma, state):
    """Return True if θ is an equilibrium: exactly at an unstable one, within the rounding of θ at a stable one."""
    anchor = state.anchor
    if anchor.kind != 0 and anchor.bend > 0.0:
        psi = offset_from(state.th, state.th_low, anchor.base, anchor.base_low)
        # within 1e-280 rad of the top, on the level, a motion would take 600 √(R/g) to become visible
        return abs(psi) < (1e-280 if anchor.base == 0.0 else 1e-30)
    th = state.th
    s, c = sine_and_cosine(th)
    firm = inertia_at_height(body, load_height(s, c)) if sigma == 0 else kappa_p_sigma(body, s, c, sigma, 0.0)
    rounding = STILL_ACCELERATION * (1.0 + abs(th))
    if firm > 0.0:
        rounding *= 1.0 + body.eps * (body.gn + abs(body.gt)) / firm
    return abs(acceleration_in_contact(body, s, c, 0.0, sigma)) <= rounding


@inline
def remains_at_rest(body, sigma, state):
    """Return True if a hoop with θ̇ = 0 stays at rest."""
    if body.kap == 0.0 and (sigma != 0 or cosine(state.th) <= -1.0):
        return True  # the massless hoop with its load on the plane
    return is_equilibrium(body, sigma, state)


@inline
def square_rate_inside(panel, xi, weights, values):
    """Interpolate θ̇² at ξ; near a turning point θ̇²/s² is interpolated, so that a small θ̇ keeps its digits."""
    if panel.kind == LINEAR:
        return dot(weights, values)
    end = 1.0 if panel.kind == ARRIVE else -1.0
    result = 0.0
    for i in range(ORDER):
        result += weights[i] * (values[i] / ((end - NODES[i]) * (end - NODES[i])))
    return result * ((end - xi) * (end - xi))


@noinline
def rolling_loss_inside(work, weights):
    """Return the energy lost to rolling resistance up to a position inside a solved panel, given by its weights."""
    antiderivative(work[ROLLING_POWER], work[ROLLING_LOSS])
    return dot(weights, work[ROLLING_LOSS])


@inline
def state_on_panel(body, panel, totals, state, xi, scratch):
    """Return the state at ξ of a solved panel that starts in `state`; ξ inside the panel requires `fill_inside` first."""
    work = scratch.work
    if xi <= -1.0:
        return state
    offset = angle_at(panel, xi)
    inside = xi < 1.0
    sine, versine = sine_versine_of_offset(panel, xi)
    if inside:
        lagrange(xi, scratch.weights)
        tau = dot(scratch.weights, work[TIME])
        if panel.sigma == 0:
            vt = 0.0
            loss = 0.0
            if body.resist > 0.0:
                u = square_rate_inside(panel, xi, scratch.weights, work[U])
            else:
                u = u_on_panel(body, panel, sine, versine, offset)
        else:
            u = square_rate_inside(panel, xi, scratch.weights, work[U])
            vt = dot(scratch.weights, work[SLIP])
            loss = dot(scratch.weights, work[LOSS])
        rolling_loss = rolling_loss_inside(work, scratch.weights) if body.resist > 0.0 else 0.0
    else:
        tau = totals.time
        u = 0.0 if panel.kind == ARRIVE else totals.u
        vt = totals.vt
        loss = totals.loss
        rolling_loss = totals.rolling_loss
    tau = max(tau, 0.0)
    om = panel.direction * math.sqrt(max(u, 0.0))
    if panel.sigma == 0:
        along = offset - angle_at(panel, -1.0)
    else:
        s0 = panel.sine
        c0 = panel.cosine
        ds, dc = sine_cosine_change_by(s0, c0, sine, versine)
        if panel.kind == ARRIVE:  # from the start of the panel, not from its reference
            back = sine_cosine_change(s0, c0, angle_at(panel, -1.0))
            s0 += back[0]
            c0 += back[1]
            ds -= back[0]
            dc -= back[1]
        along = slip_displacement(body, panel.sigma, state.vt, state.om, s0, c0, ds, dc, tau)
    t, t_low = later(state, tau)
    x, x_low = plus(state.x, state.x_low, along)
    th, th_low = plus(panel.ref, panel.ref_low, offset)
    return State(
        t, t_low, x, x_low, 0.0, state.revolutions, th, th_low, vt, 0.0, om,
        state.friction + loss, state.impact_n, state.impact_t, state.rolling_loss + rolling_loss, state.anchor,
    )  # fmt: skip


@inline
def propagate_anchor(body, panel, totals, xi, after):
    """Return the state after a slip panel with its anchor propagated over the panel."""
    anchor = after.anchor
    if body.mu_k == 0.0:  # the difference of θ̇² between two motions is proportional to 1/(κ p)
        s, _ = sine_cosine(after.th, after.th_low)
        sine = panel.sine
        if panel.kind == ARRIVE:
            sine += sine_cosine_change(panel.sine, panel.cosine, angle_at(panel, -1.0))[0]
        before = body.eps * sine
        now = body.eps * s
        growth = (body.kap + before * before) / (body.kap + now * now)
    elif xi < 1.0:
        return with_anchor(after, NONE)
    else:
        growth = 1.0 / totals.growth if panel.kind == ARRIVE else totals.growth
    return with_anchor(after, Anchor(SLIPPING, anchor.excess * growth, anchor.base, anchor.base_low, anchor.bend))


@noinline
def recover_slip_velocity(body, state, u):
    """Return the state of slip with θ̇² = u, if rounding has lost digits of θ̇ near the unstable equilibrium.

    v_t follows from the velocity of the centre of gravity along the plane, which has lost no digits: only friction changes it.
    """
    s, c = sine_cosine(state.th, state.th_low)
    om = math.copysign(math.sqrt(u), state.om)
    height = load_height(s, c)
    return with_velocities(state, state.vt + (state.om - om) * ((1.0 - body.eps) + body.eps * height), state.vn, om)


@inline
def at_panel_start(body, sigma, state, begins, scratch):
    """Return (state at the start of the next panel, sin θ, cos θ), with θ̇ = 0 for underflow, and the anchor of a new phase."""
    if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:
        state = with_velocities(state, state.vt, state.vn, 0.0)
    s, c = sine_cosine(state.th, state.th_low)
    if begins:
        state = set_anchor(body, sigma, state, s, c, scratch)
    return state, s, c


@inline
def has_lost_digits(sigma, panel, state):
    """Return True if θ̇² of slip from the anchor differs from the state's θ̇², which has lost digits to rounding."""
    return sigma != 0 and panel.kind == LINEAR and abs(panel.u - state.om * state.om) > LOST * panel.u


@inline
def predicted_level(level, error, before):
    """Return the level of the next panel: one finer if the truncation error grows too fast to stay resolved."""
    return level + 1 if level < FINEST_PREDICTED and error > before and error * (error / before) > RESOLVED else level


@inline
def fit_to_time(body, panel, totals, state, limits, scratch):
    """Return (panel, totals), with a narrower panel if this one would last much longer than the motion."""
    left = time_left(state, limits.t_end)
    if totals.tail <= RESOLVED and exceeds_time_left(totals, left):
        return narrow_to_time(body, panel, totals, state, left, scratch)
    return panel, totals


@inline
def snap_to_event(body, ending, state, limits, direction):
    """Return the state with the quantity that defines its event exact: v_t = 0, the final time or the final angle."""
    if ending == Ending.SLIP_END:
        return with_velocities(state, 0.0, state.vn, state.om)
    if ending == Ending.TIME_LIMIT:
        return at_time(state, limits.t_end)
    if ending == Ending.ANGLE_LIMIT:
        after = at_span(limits, state, direction)
        if after.revolutions != state.revolutions:  # a motion that goes on from there needs its anchor
            after = with_anchor(after, with_turns(body, state, after.revolutions - state.revolutions).anchor)
        return after
    return state


@inline
def vanishing_slip_derivatives(body, phase):
    """Return the number of time derivatives of v_t that vanish at the start of slip, v_t included."""
    if phase.ending in (Ending.CONE_FORWARD, Ending.CONE_BACKWARD):
        return 2 if body.mu_s == body.mu_k else 1  # at the friction cone v̇_t is zero too if friction does not jump there
    return 1 if phase.state.vt == 0.0 else 0


@inline
def advance_contact(body, phase, limits, log, scratch):
    """Roll or slip, panel by panel, up to an event or a turning point.

    Returns (ending, state, level of the next panel); the ending is CONTINUES if the log is full.
    """
    sigma = slip_direction(phase.mode)
    state, level, begins = phase.state, phase.level, phase.begins
    vanishing = vanishing_slip_derivatives(body, phase) if sigma != 0 else 0
    ending = Ending.CONTINUES
    unresolved = Ending.SINGULAR if sigma != 0 else Ending.SEARCH_LIMIT
    before = math.inf  # truncation error of the last panel
    while ending == Ending.CONTINUES and has_room(log):
        count_panel(log)
        state, s, c = at_panel_start(body, sigma, state, begins, scratch)
        if state.om == 0.0 and remains_at_rest(body, sigma, state):
            return Ending.REST, state, level
        panel, totals, level = choose_panel(body, sigma, state, s, c, level, scratch)
        if has_lost_digits(sigma, panel, state):
            state = recover_slip_velocity(body, state, panel.u)
            continue
        level = predicted_level(level, totals.tail, before)
        before = totals.tail
        panel, totals = fit_to_time(body, panel, totals, state, limits, scratch)
        if not totals.tail <= RESOLVED:
            return unresolved, state, level
        xi, ending = earliest_event(body, panel, totals, state, begins, vanishing, limits, scratch)
        if -1.0 < xi < 1.0:
            fill_inside(panel, scratch.work)
        after = snap_to_event(body, ending, state_on_panel(body, panel, totals, state, xi, scratch), limits, panel.direction)
        if xi > -1.0:
            write_segment(log, phase.mode, panel, xi, state, after.t)
            if after.anchor.kind == SLIPPING:
                after = propagate_anchor(body, panel, totals, xi, after)
        state = normalize_turns(body, after) if abs(after.th) > FARTHEST else after
        begins = False
    return ending, state, level


def equilibrium_is_stable(body, th):
    """Return True if rest at th is a minimum of the potential energy, or needs less than the full rolling resistance."""
    s, c = sine_and_cosine(th)
    if body.resist > 0.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:
        return True
    return rest_curvature(body, s, c) > 0.0


def slip_rate_without_rotation(body, sigma):
    """Return v̇_t of a hoop in contact that does not rotate; σ = 0: it rests."""
    return body.gt - sigma * body.mu_k * body.gn if sigma != 0 else 0.0


def slide_without_rotation(body, mode, state, t_end, log):
    """Slip without rotation until v_t = 0 or the final time; return (ending, state)."""
    sigma = slip_direction(mode)
    rate = slip_rate_without_rotation(body, sigma)
    until = -state.vt / rate if state.vt * rate < 0.0 else math.inf
    ending = Ending.SLIP_END
    tau = until
    left = time_left(state, t_end)
    if not until <= left:
        ending = Ending.TIME_LIMIT
        tau = left
    slid = state.vt * tau + 0.5 * rate * tau * tau
    vt = 0.0 if ending == Ending.SLIP_END else state.vt + rate * tau
    t, t_low = later(state, tau)
    if ending != Ending.SLIP_END:
        t, t_low = t_end, 0.0
    x, x_low = plus(state.x, state.x_low, slid)
    friction = state.friction + sigma * body.mu_k * body.gn * slid
    after = with_velocities(moved(state, t, t_low, x, x_low, 0.0, state.revolutions, state.th, state.th_low), vt, 0.0, 0.0)
    after = with_losses(after, friction, state.impact_n, state.impact_t, state.rolling_loss)
    write_segment(log, mode, no_panel(HOLD, sigma, 0.0), 0.0, state, after.t)
    return ending, after


@noinline
def still_step(body, phase, state, limits, log):
    """Rest, or slip without rotation until it ends; return the next phase."""
    mode = phase.mode
    if mode == ROLL:
        stable = 1 if equilibrium_is_stable(body, state.th) else 0
        write_event(log, event_without_jump(REST, ROLL, state), ROLL, state, 0.0, stable)
        write_segment(log, ROLL, no_panel(HOLD, 0, 0.0), 0.0, state, limits.t_end)
        return end_motion(phase, ROLL, at_time(with_velocities(state, 0.0, 0.0, 0.0), limits.t_end), Ending.REST, AT_REST)
    ending, state = slide_without_rotation(body, mode, state, limits.t_end, log)
    if ending == Ending.TIME_LIMIT:
        return end_motion(phase, mode, state, Ending.TIME_LIMIT, COMPLETED)
    if body.kap == 0.0:
        mode = ROLL
        write_plain_event(log, STICK, phase.mode, ROLL, state)
    else:
        mode, state = resolve_mode(body, state, event_without_jump(STICK, phase.mode, state), log)
    return begin_phase(mode, state, Ending.SLIP_END)


@inline
def after_rolling(body, phase, ending, state, log):
    """Return the phase after rolling that has reached the friction cone or could not be resolved further."""
    if ending == Ending.SEARCH_LIMIT:
        record_doubt(log.doubt, state.t)
        return end_motion(phase, ROLL, state, ending, UNDETERMINED)
    if body.kap == 0.0:
        mode, state = begin_skim(body, state, log)
    else:
        mode = leave_cone(body, state, ending == Ending.CONE_FORWARD, log)
    return begin_phase(mode, state, ending)


@inline
def after_slip(body, phase, ending, state, log):
    """Return the phase after slip that has lifted off, ended, or reached p_σ = 0."""
    if ending == Ending.LIFT_OFF:
        mode = FLIGHT
        write_plain_event(log, TAKEOFF, phase.mode, FLIGHT, state)
    elif ending == Ending.SLIP_END:
        mode, state = resolve_mode(body, state, event_without_jump(STICK, phase.mode, state), log)
    else:
        jams, mode, state = resolve_painleve_singularity(body, phase.mode, state, log)
        if jams:
            return end_motion(phase, mode, state, Ending.SINGULAR, JAMMED)
    return begin_phase(mode, state, ending)


@noinline
def turning_point_step(body, phase, state, level, limits, log):
    """Return the phase after a turning point with rolling resistance, where the couple and the contact force jump."""
    mode = next_mode(body, state.th, state.th_low, 0.0, state.vt)
    if phase.mode == ROLL and mode == ROLL and is_equilibrium(body, 0, state):
        return still_step(body, phase, state, limits, log)
    kind = STICK if phase.mode != ROLL else TAKEOFF if mode == FLIGHT else SLIP_START
    if phase.mode != ROLL and mode > SKIM:
        kind = TURN  # slip goes on until the paradox, which follows at once
    else:
        write_plain_event(log, TURN, phase.mode, phase.mode, state)
    if mode == phase.mode:
        return continue_phase(phase, state, level, Ending.TURNING_POINT)
    if kind == STICK and mode != FLIGHT:
        state = with_velocities(state, 0.0, state.vn, state.om)  # v_t and θ̇ reach zero together
    mode, state = resolve_mode(body, state, event_without_jump(kind, phase.mode, state), log)
    return begin_phase(mode, state, Ending.TURNING_POINT)


@inline
def contact_step(body, phase, limits, log, scratch):
    """Roll or slip up to an event or a turning point, and return the next phase."""
    ending, state, level = advance_contact(body, phase, limits, log, scratch)
    if ending == Ending.TURNING_POINT and body.resist > 0.0:
        after = turning_point_step(body, phase, state, level, limits, log)
        if limits.stop & STOP_AT_TURN and after.status == GOING:
            return end_motion(after, after.mode, after.state, Ending.TURNING_POINT, COMPLETED)
        return after
    if ending == Ending.TURNING_POINT:
        write_plain_event(log, TURN, phase.mode, phase.mode, state)
    if ending in (Ending.TIME_LIMIT, Ending.ANGLE_LIMIT) or (ending == Ending.TURNING_POINT and limits.stop & STOP_AT_TURN):
        return end_motion(phase, phase.mode, state, ending, COMPLETED)
    if ending in (Ending.CONTINUES, Ending.TURNING_POINT):
        return continue_phase(phase, state, level, ending)
    if ending == Ending.REST:
        return still_step(body, phase, state, limits, log)
    if phase.mode == ROLL:
        return after_rolling(body, phase, ending, state, log)
    return after_slip(body, phase, ending, state, log)
