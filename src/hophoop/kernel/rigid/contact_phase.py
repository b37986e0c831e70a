"""Rolling and slip, panel by panel, up to the first event inside a panel."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.arithmetic import TWO_PI, TWO_PI_LOW, add, plus
from hophoop.kernel.numerics.circular import cosine, sine_and_cosine, sine_cosine, sine_cosine_change, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import ORDER, antiderivative, dot, lagrange
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.anchor import rolling_anchor
from hophoop.kernel.panels.panel import (
    ARRIVE,
    HOLD,
    LINEAR,
    LOSS,
    RATE,
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
    later,
    time_left,
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
from hophoop.kernel.rigid.panel_choice import choose_panel, exceeds_time_left, narrow_to_time
from hophoop.kernel.rigid.panel_events import CLOSE, SMALLEST_SQUARE, earliest_event
from hophoop.kernel.rigid.phase import GOING, Ending, at_span, begin_phase, continue_phase, end_motion
from hophoop.kernel.rigid.transitions import is_singular, leave_cone, resolve_mode, resolve_painleve_singularity

STILL_ACCELERATION = 1e-15
GROWTH = 11.5  # ln of CLOSE over the rounding of θ
AT_TOP = 1e-280  # rad: within it of the top a motion would take 600 √(R/g) to become visible


@inline
def normalize_turns(state):
    """Move one revolution from θ into `revolutions`."""
    more = 1.0 if state.th > 0.0 else -1.0
    th, low = add((state.th, state.th_low), (-more * TWO_PI, -more * TWO_PI_LOW))
    return replaced(state, revolutions=state.revolutions + more, th=th, th_low=low)


@inline
def firmness(body, sigma, s, c):
    """Return what divides the torque in θ̈ at rest: D in rolling, κ p_σ in slip."""
    return inertia_at_height(body, load_height(s, c)) if sigma == 0 else kappa_p_sigma(body, s, c, sigma, 0.0)


@inline
def instability(body, sigma, s, c):
    """Return the slope of the torque at rest in rolling (sigma = 0) or slip, positive at an unstable equilibrium."""
    return body.eps * body.gn * (c - sigma * body.mu_k * s) if sigma != 0 else -rest_curvature(body, s, c)


@inline
def has_exact_top(body, sigma):
    """Return True if the unstable equilibrium is exactly the top: in rolling on the level, and in slip without friction."""
    tilt = body.gt if sigma == 0 else body.mu_k
    return tilt == 0.0 and body.eps * body.gn > 0.0 and body.resist == 0.0


@noinline
def is_equilibrium(body, sigma, state):
    """Return True if θ is an equilibrium: exactly at the top, within the rounding of θ elsewhere."""
    s, c = sine_cosine(state.th, state.th_low)
    if has_exact_top(body, sigma) and c > 0.0:
        return abs(s) < AT_TOP
    firm = firmness(body, sigma, s, c)
    rounding = STILL_ACCELERATION * (1.0 + abs(state.th))
    if firm > 0.0:
        rounding *= 1.0 + body.eps * (body.gn + abs(body.gt)) / firm
    return abs(acceleration_in_contact(body, s, c, 0.0, sigma)) <= rounding


@noinline
def doubt_rest(body, sigma, state, until, log):
    """Record a doubt where the rounding of θ at an unstable equilibrium has grown to CLOSE, if the rest lasts until then."""
    s, c = sine_cosine(state.th, state.th_low)
    unstable = instability(body, sigma, s, c)
    if body.resist == 0.0 and not has_exact_top(body, sigma) and unstable > 0.0:
        t = state.t + GROWTH * math.sqrt(firmness(body, sigma, s, c) / unstable)
        if t < until:
            record_doubt(log.doubt, t)


@noinline
def passes_in_doubt(body, sigma, state, s, c):
    """Return True if the hoop slows down so near an unstable equilibrium that rounding decides whether it passes it.

    Its energy and its torque are then zero within rounding. Rolling without resistance keeps its anchor and needs no doubt.
    """
    firm = firmness(body, sigma, s, c)
    unstable = instability(body, sigma, s, c)
    if not firm * state.om * state.om < CLOSE * body.gn or unstable <= 0.0 or (body.resist > 0.0 and state.om == 0.0):
        return False
    alpha = acceleration_in_contact(body, s, c, state.om, sigma)
    return alpha * state.om <= 0.0 and firm * alpha * firm * alpha <= CLOSE * unstable * body.gn


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
    return replaced(
        state, t=t, t_low=t_low, x=x, x_low=x_low, th=th, th_low=th_low, vt=vt, om=om,
        friction=state.friction + loss, rolling_loss=state.rolling_loss + rolling_loss,
    )  # fmt: skip


@inline
def at_panel_start(state):
    """Return (state at the start of the next panel, sin θ, cos θ), with θ̇ = 0 for underflow."""
    if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:
        state = replaced(state, om=0.0)
    s, c = sine_cosine(state.th, state.th_low)
    return state, s, c


@inline
def slip_is_brief(panel, work):
    """Return True if slip ends before the first node of its panel, where v_t and its work would be lost in rounding."""
    return panel.sigma * work[SLIP, 0] < 0.0 < panel.sigma * panel.vt and panel.vt * panel.vt >= SMALLEST_SQUARE


@noinline
def narrow_to_slip(body, anchor, panel, totals, state, scratch):
    """Return (panel, totals) of a panel that brief slip outlasts to the first node at least."""
    work = scratch.work
    while totals.tail <= RESOLVED and slip_is_brief(panel, work):  # each pass at least halves the panel
        left = work[RATE, 0] * (1.0 + NODES[0]) * (panel.vt / (panel.vt - work[SLIP, 0]))
        panel, totals = narrow_to_time(body, anchor, panel, totals, state, left, scratch)
    return panel, totals


@inline
def fit_to_time(body, anchor, panel, totals, state, begins, limits, scratch):
    """Return (panel, totals), with a narrower panel if this one would last much longer than the motion or than slip."""
    left = time_left(state, limits.t_end)
    if totals.tail <= RESOLVED and exceeds_time_left(totals, left):
        panel, totals = narrow_to_time(body, anchor, panel, totals, state, left, scratch)
    if begins and panel.sigma != 0:
        return narrow_to_slip(body, anchor, panel, totals, state, scratch)
    return panel, totals


@inline
def snap_to_event(ending, state, limits, direction):
    """Return the state with the quantity that defines its event exact: v_t = 0, the final time or the final angle."""
    if ending == Ending.SLIP_END:
        return replaced(state, vt=0.0)
    if ending == Ending.TIME_LIMIT:
        return replaced(state, t=limits.t_end, t_low=0.0)
    if ending == Ending.ANGLE_LIMIT:
        return at_span(limits, state, direction)
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

    Returns the phase with the state there. Its ending says what has been reached, CONTINUES if the log is full.
    """
    sigma = slip_direction(phase.mode)
    state, level, begins, anchor = phase.state, phase.level, phase.begins, phase.anchor
    vanishing = vanishing_slip_derivatives(body, phase) if sigma != 0 else 0
    ending = Ending.CONTINUES
    while ending == Ending.CONTINUES and has_room(log):
        count_panel(log)
        state, s, c = at_panel_start(state)
        if begins and sigma == 0:
            anchor = rolling_anchor(body, state, s, c)
        if state.om == 0.0 and remains_at_rest(body, sigma, state):
            return continue_phase(phase, state, level, Ending.REST, anchor)
        if begins and sigma != 0 and is_singular(body, sigma, state.om, s, c):
            return continue_phase(phase, state, level, Ending.SINGULAR, anchor)
        if anchor.bend == 0.0 and not begins and passes_in_doubt(body, sigma, state, s, c):
            record_doubt(log.doubt, state.t)
        panel, totals, level = choose_panel(body, sigma, anchor, state, s, c, level, scratch)
        panel, totals = fit_to_time(body, anchor, panel, totals, state, begins, limits, scratch)
        if not totals.tail <= RESOLVED:
            ending = Ending.SINGULAR if sigma != 0 else Ending.SEARCH_LIMIT
            if begins:  # next to p_σ = 0 rounding decides whether slip moves away from it
                record_doubt(log.doubt, state.t)
            return continue_phase(phase, state, level, ending, anchor)
        xi, ending = earliest_event(body, panel, totals, state, begins, vanishing, limits, scratch)
        if -1.0 < xi < 1.0:
            fill_inside(panel, scratch.work)
        after = snap_to_event(ending, state_on_panel(body, panel, totals, state, xi, scratch), limits, panel.direction)
        if xi > -1.0:
            write_segment(log, phase.mode, panel, xi, state, after.t)
        state = normalize_turns(after) if abs(after.th) > FARTHEST else after
        begins = False
    return continue_phase(phase, state, level, ending, anchor)


def equilibrium_is_stable(body, th):
    """Return True if rest at th is a minimum of the potential energy, or needs less than the full rolling resistance."""
    s, c = sine_and_cosine(th)
    if body.resist > 0.0 and abs(torque_at_rest(body, s, c)) < body.resist * body.gn:
        return True
    return rest_curvature(body, s, c) > 0.0


def slip_rate_without_rotation(body, sigma):
    """Return v̇_t of a hoop in contact that does not rotate; σ = 0: it rests."""
    return body.gt - sigma * body.mu_k * body.gn if sigma != 0 else 0.0


def state_without_rotation(body, sigma, state, t, tau):
    """Return the state at the time t, by tau after `state`, of rest (σ = 0) or slip without rotation."""
    rate = slip_rate_without_rotation(body, sigma)
    slid = state.vt * tau + 0.5 * rate * tau * tau
    loss = sigma * body.mu_k * body.gn * slid if sigma != 0 else 0.0
    x, x_low = plus(state.x, state.x_low, slid)
    vt = state.vt + rate * tau
    return replaced(state, t=t, t_low=0.0, x=x, x_low=x_low, vt=vt, vn=0.0, om=0.0, friction=state.friction + loss)


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
    after = state_without_rotation(body, sigma, state, t_end, tau)
    if ending == Ending.SLIP_END:
        t, t_low = later(state, tau)
        after = replaced(after, t=t, t_low=t_low, vt=0.0)
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
        doubt_rest(body, 0, state, limits.t_end, log)
        state = replaced(state, t=limits.t_end, t_low=0.0, vt=0.0, vn=0.0, om=0.0)
        return end_motion(phase, ROLL, state, Ending.REST, AT_REST)
    begin = state
    ending, state = slide_without_rotation(body, mode, state, limits.t_end, log)
    doubt_rest(body, slip_direction(mode), begin, state.t, log)
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
def turning_point_step(body, phase, limits, log):
    """Return the phase after a turning point with rolling resistance, where the couple and the contact force jump."""
    state = phase.state
    mode = next_mode(body, state.th, state.th_low, 0.0, state.vt)
    if phase.mode == ROLL and mode == ROLL and is_equilibrium(body, 0, state):
        return still_step(body, phase, state, limits, log)
    kind = STICK if phase.mode != ROLL else TAKEOFF if mode == FLIGHT else SLIP_START
    if phase.mode != ROLL and mode > SKIM:
        kind = TURN  # slip goes on until the paradox, which follows at once
    else:
        write_plain_event(log, TURN, phase.mode, phase.mode, state)
    if mode == phase.mode:
        return phase
    if kind == STICK and mode != FLIGHT:
        state = replaced(state, vt=0.0)  # v_t and θ̇ reach zero together
    mode, state = resolve_mode(body, state, event_without_jump(kind, phase.mode, state), log)
    return begin_phase(mode, state, Ending.TURNING_POINT)


@inline
def contact_step(body, phase, limits, log, scratch):
    """Roll or slip up to an event or a turning point, and return the next phase."""
    phase = advance_contact(body, phase, limits, log, scratch)
    ending, state = phase.ending, phase.state
    if ending == Ending.TURNING_POINT and body.resist > 0.0:
        after = turning_point_step(body, phase, limits, log)
        if limits.stop & STOP_AT_TURN and after.status == GOING:
            return end_motion(after, after.mode, after.state, Ending.TURNING_POINT, COMPLETED)
        return after
    if ending == Ending.TURNING_POINT:
        write_plain_event(log, TURN, phase.mode, phase.mode, state)
    if ending in (Ending.TIME_LIMIT, Ending.ANGLE_LIMIT) or (ending == Ending.TURNING_POINT and limits.stop & STOP_AT_TURN):
        return end_motion(phase, phase.mode, state, ending, COMPLETED)
    if ending in (Ending.CONTINUES, Ending.TURNING_POINT):
        return phase
    if ending == Ending.REST:
        return still_step(body, phase, state, limits, log)
    if phase.mode == ROLL:
        return after_rolling(body, phase, ending, state, log)
    return after_slip(body, phase, ending, state, log)
