"""Rolling and slipping, panel by panel, up to the first event inside a panel."""

from __future__ import annotations

import math

from hophoop._collocation import (
    LEVELS,
    NODES,
    NOT_FOUND,
    ORDER,
    antiderivative,
    coefficients,
    dot,
    first_fall,
    lagrange,
    left_value,
)
from hophoop._jit import lean_jit
from hophoop.physics.body import Mode
from hophoop.physics.contact import (
    inertia_at_height,
    load_height,
    rolling_acceleration,
    slip_motion,
    slip_stiffness,
)
from hophoop.physics.modes import slip_direction
from hophoop.physics.panel import (
    ARRIVE,
    COSINE,
    HOLD,
    LOSS,
    RATE,
    RESOLVED,
    SLIP,
    TIME,
    A,
    B,
    Panel,
    U,
    angle_at,
    arriving_panel,
    chord,
    fill_inside,
    leaving_panel,
    linear_panel,
    place_of,
    rotated,
    turn,
)
from hophoop.physics.roll import roll_margins, solve_roll, u_on_panel
from hophoop.physics.slip import slip_displacement, solve_slip
from hophoop.rigid.state import State, revised, write_segment

ROLL = int(Mode.ROLL)
# What ended a panel.
ON, CONE_AHEAD, CONE_BACK, LIFT, STOP, TURNED, LIMIT, FULL_ANGLE, STILL, STUCK = range(10)

START_LEVEL = 2
GAIN_OF_A_LEVEL = 8.0  # a panel narrower by √2 has a last coefficient smaller by about 2^8
WIDEN = RESOLVED / 200.0
FIRST_EXTENT = 0.4  # rad, of the panel after a start from rest
SMALLEST_EXTENT = 1e-40
STILL_ACCELERATION = 1e-15
# Below this speed a look is taken whether θ̇ hardly matters beside θ̈: panels in θ shrink without end there.
SLOW = 1e-3
CREEP = 1e-8  # rad, over which θ̈ counts as constant
SMALLEST_SQUARE = 1e-290  # a smaller θ̇² is on the way to underflow


@lean_jit
def angular_acceleration(body, sigma, th, u):
    """θ̈ in rolling (sigma = 0) or slip."""
    s = math.sin(th)
    c = math.cos(th)
    if sigma == 0:
        return rolling_acceleration(body, s, c, u)
    return slip_motion(body, s, c, u, sigma)[0]


@lean_jit
def solve(body, panel, work):
    """Fill the panel in its mode."""
    if panel.sigma == 0:
        return solve_roll(body, panel, work)
    return solve_slip(body, panel, work)


@lean_jit
def narrower(level, size):
    """Level to try after a panel whose last coefficients were `size`."""
    if not size < 1.0:
        return level + 3
    return level + max(1, min(4, math.ceil(math.log2(size / RESOLVED) / GAIN_OF_A_LEVEL)))


@lean_jit
def turning_point_ahead(body, panel, totals, scratch):
    """Angle from here to the first zero of θ̇², or 0 where none is near.

    Where a panel loses most of θ̇² but does not reach the zero, wider ones are searched: panels that
    fit before it would shrink towards it for ever.
    """
    for _ in range(4):
        if panel.sigma == 0:
            coefficients(scratch.work[A], scratch.series)
        elif math.isnan(totals.u):
            return 0.0
        else:
            coefficients(scratch.work[U], scratch.series)
        xi = first_fall(scratch.series, 0.0, scratch.stack)
        if xi != NOT_FOUND:
            return panel.extent * 0.5 * (1.0 + xi)
        if panel.level == 0:
            return 0.0
        panel = linear_panel(
            body, panel.sigma, max(panel.level - 2, 0), panel.way, panel.ref, panel.u, panel.vt
        )
        totals = solve(body, panel, scratch.work)
    return 0.0


@lean_jit
def choose_panel(body, sigma, state, level, extent, scratch):
    """A panel from here, as wide as is resolved.

    Returns (panel, totals, level for the next one); totals.tail is above RESOLVED where there is none.
    """
    work = scratch.work
    if state.om == 0.0:
        alpha = angular_acceleration(body, sigma, state.th, 0.0)
        way = 1.0 if alpha > 0.0 else -1.0
        while True:
            panel = leaving_panel(body, sigma, way, state.th, extent, state.vt)
            totals = solve(body, panel, work)
            if totals.tail <= RESOLVED or extent < SMALLEST_EXTENT:
                return panel, totals, START_LEVEL
            extent *= 0.5
    u = state.om * state.om
    way = 1.0 if state.om > 0.0 else -1.0
    while True:
        panel = linear_panel(body, sigma, level, way, state.th, u, state.vt)
        totals = solve(body, panel, work)
        if totals.tail <= RESOLVED:
            return panel, totals, max(level - 1, 0) if totals.tail < WIDEN else level
        size = totals.tail
        if not work[U, ORDER - 1] > 0.8 * u:
            ahead = turning_point_ahead(body, panel, totals, scratch)
            if ahead > 0.0:
                arrival = arriving_panel(body, panel, ahead)
                totals = solve(body, arrival, work)
                if totals.tail <= RESOLVED:
                    return arrival, totals, START_LEVEL
        level = narrower(level, size)
        if level >= LEVELS:
            return panel, totals, level


@lean_jit
def fall_of(row, state_is_fresh, scratch):
    """Where in the panel a margin falls through zero; at its very start if it is negative there already."""
    coefficients(row, scratch.series)
    if not state_is_fresh and left_value(scratch.series) <= 0.0:
        return -1.0
    return first_fall(scratch.series, 0.0, scratch.stack)


@lean_jit
def earliest_event(body, panel, totals, state, fresh, zeros, t_end, origin, span, scratch):
    """(ξ, what) of the first event on the panel; ξ = 1 with ON or TURNED where there is none.

    Simultaneous events: the cone (roll), then lift-off before the end of slip, then the limits.
    """
    work = scratch.work
    xi = NOT_FOUND
    what = ON
    if panel.sigma == 0:
        roll_margins(body, work)
        found = fall_of(work[A], fresh, scratch)
        if found < xi:
            xi = found
            what = CONE_AHEAD  # F > 0
        found = fall_of(work[B], fresh, scratch)
        if found < xi:
            xi = found
            what = CONE_BACK
    else:
        for i in range(ORDER):
            work[A, i] = body.gn - body.eps * work[COSINE, i] * work[U, i]
            value = panel.sigma * work[SLIP, i]
            if fresh:
                for _ in range(zeros):
                    value /= 0.5 * (1.0 + NODES[i])
            work[B, i] = value
        found = fall_of(work[A], fresh, scratch)
        if found < xi:
            xi = found
            what = LIFT
        found = fall_of(work[B], fresh, scratch)
        if found < xi:
            xi = found
            what = STOP
    if not math.isnan(span):
        ahead = span - panel.way * (state.th - origin)
        if ahead <= panel.extent:
            found = -1.0  # an event fell on the angle itself
            if ahead > 0.0:
                found = place_of(panel, panel.extent - ahead if panel.kind == ARRIVE else ahead)
            if found < xi:
                xi = found
                what = FULL_ANGLE
    left = t_end - state.t
    if totals.time >= left:
        antiderivative(work[RATE], work[TIME])
        for i in range(ORDER):
            work[A, i] = left - work[TIME, i]
        coefficients(work[A], scratch.series)
        found = first_fall(scratch.series, 0.0, scratch.stack)
        if left <= 0.0:
            found = -1.0
        elif found == NOT_FOUND:
            found = 1.0
        if found < xi:
            xi = found
            what = LIMIT
    if xi == NOT_FOUND:
        xi = 1.0
        what = TURNED if panel.kind == ARRIVE else ON
    return xi, what


@lean_jit
def state_on_panel(body, panel, totals, state, xi, scratch):
    """The state at ξ of a solved panel that began in `state`."""
    work = scratch.work
    if xi <= -1.0:
        return state
    offset = angle_at(panel, xi)
    inside = xi < 1.0
    sine, versine = chord(panel, xi)
    if inside:
        fill_inside(panel, work)
        lagrange(xi, scratch.weights)
        tau = dot(scratch.weights, work[TIME])
        if panel.sigma == 0:
            u = u_on_panel(body, panel, sine, versine, offset)
            vt = 0.0
            loss = 0.0
        else:
            u = dot(scratch.weights, work[U])
            vt = dot(scratch.weights, work[SLIP])
            loss = dot(scratch.weights, work[LOSS])
    else:
        tau = totals.time
        u = totals.u
        vt = totals.vt
        loss = totals.loss
    om = panel.way * math.sqrt(max(u, 0.0))
    if panel.sigma == 0:
        x = state.x + (offset - angle_at(panel, -1.0))
    else:
        s0 = panel.sine
        c0 = panel.cosine
        ds, dc = rotated(s0, c0, sine, versine)
        if panel.kind == ARRIVE:  # from the start of the panel, not from its reference
            back = turn(s0, c0, angle_at(panel, -1.0))
            s0 += back[0]
            c0 += back[1]
            ds -= back[0]
            dc -= back[1]
        x = state.x + slip_displacement(body, panel.sigma, state.vt, state.om, s0, c0, ds, dc, tau)
    return State(
        state.t + tau,
        x,
        0.0,
        panel.ref + offset,
        vt,
        0.0,
        om,
        state.friction + loss,
        state.impact_n,
        state.impact_t,
    )


@lean_jit
def creeps(body, sigma, state):
    """Whether θ̇ is so small beside θ̈ that the motion starts or turns within `CREEP`, where θ̈ hardly changes."""
    s = math.sin(state.th)
    c = math.cos(state.th)
    u = state.om * state.om
    firm = inertia_at_height(body, load_height(s, c)) if sigma == 0 else slip_stiffness(body, s, c, sigma)
    if not firm > 1e-4 * (1.0 + body.mu_k * abs(sigma)):
        return False
    return u < 2.0 * CREEP * abs(angular_acceleration(body, sigma, state.th, u))


@lean_jit
def creep(body, mode, state, t_end, angle_target, segments, count):
    """Turn by at most `CREEP` under constant θ̈, or up to θ̇ = 0: (what, state, count)."""
    sigma = slip_direction(mode)
    s = math.sin(state.th)
    c = math.cos(state.th)
    om = state.om
    if sigma == 0:
        alpha, normal, rate = rolling_acceleration(body, s, c, om * om), 0.0, 0.0
    else:
        alpha, normal, rate = slip_motion(body, s, c, om * om, sigma)
    if om * alpha < 0.0:
        tau = -om / alpha
        what = TURNED
    else:
        tau = (math.sqrt(om * om + 2.0 * abs(alpha) * CREEP) - abs(om)) / abs(alpha)
        what = ON
    if state.vt * rate < 0.0 and -state.vt / rate <= tau:
        tau = -state.vt / rate
        what = STOP
    turned = om * tau + 0.5 * alpha * tau * tau
    if not math.isnan(angle_target):
        toward = angle_target - state.th
        if toward * turned > 0.0 and abs(toward) <= abs(turned):
            tau = 2.0 * toward / (om + math.copysign(math.sqrt(om * om + 2.0 * alpha * toward), turned))
            what = FULL_ANGLE
    if tau >= t_end - state.t:
        tau = max(t_end - state.t, 0.0)
        what = LIMIT
    turned = om * tau + 0.5 * alpha * tau * tau
    slid = state.vt * tau + 0.5 * rate * tau * tau
    after = State(
        t_end if what == LIMIT else state.t + tau,
        state.x + slid + turned,
        0.0,
        angle_target if what == FULL_ANGLE else state.th + turned,
        0.0 if what == STOP else state.vt + rate * tau,
        0.0,
        0.0 if what == TURNED else om + alpha * tau,
        state.friction + sigma * body.mu_k * normal * slid,
        state.impact_n,
        state.impact_t,
    )
    panel = Panel(sigma, HOLD, 0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, alpha, 0.0)
    return what, after, write_segment(segments, count, mode, panel, 0.0, rate, state, after.t)


@lean_jit
def advance_contact(body, mode, state, fresh, zeros, level, t_end, origin, span, scratch, segments, count):
    """Roll or slip over one panel or up to the first event in it.

    Parameters
    ----------
    fresh : bool
        Whether the phase begins here; margins that are zero at its begin are no events then.
    zeros : int
        How often v_t is zero at the begin of a fresh slip phase.

    Returns
    -------
    what, state, level, count
    """
    sigma = slip_direction(mode)
    if abs(state.om) < SLOW and state.om != 0.0:
        if state.om * state.om < SMALLEST_SQUARE:
            state = revised(state, state.t, state.th, state.vt, 0.0)
        elif not (fresh and zeros > 0 and sigma != 0) and creeps(body, sigma, state):
            target = origin + math.copysign(span, state.om)
            what, state, count = creep(body, mode, state, t_end, target, segments, count)
            return what, state, START_LEVEL, count
    if state.om == 0.0:
        if body.kap == 0.0 and (sigma != 0 or math.cos(state.th) <= -1.0):
            return STILL, state, level, count  # the massless hoop with its load on the plane
        alpha = angular_acceleration(body, sigma, state.th, 0.0)
        if abs(alpha) <= STILL_ACCELERATION * (1.0 + abs(state.th)):
            return STILL, state, level, count
    panel, totals, level = choose_panel(body, sigma, state, level, FIRST_EXTENT, scratch)
    if not totals.tail <= RESOLVED:
        return STUCK, state, level, count
    xi, what = earliest_event(body, panel, totals, state, fresh, zeros, t_end, origin, span, scratch)
    after = state_on_panel(body, panel, totals, state, xi, scratch)
    if what == STOP:
        after = revised(after, after.t, after.th, 0.0, after.om)
    elif what == LIMIT:
        after = revised(after, t_end, after.th, after.vt, after.om)
    elif what == FULL_ANGLE:
        after = revised(after, after.t, origin + panel.way * span, after.vt, after.om)
    if xi > -1.0:
        count = write_segment(segments, count, mode, panel, xi, 0.0, state, after.t)
    return what, after, level, count


@lean_jit
def equilibrium_is_stable(body, th):
    """Whether rest in rolling contact at the angle th has a minimum of the potential energy."""
    return body.eps * (body.gn * math.cos(th) - body.gt * math.sin(th)) < 0.0


@lean_jit
def frozen_end(body, sigma, vt):
    """(v̇_t, time until v_t = 0) of slip without rotation; the time is infinite where it never stops."""
    rate = body.gt - sigma * body.mu_k * body.gn
    if vt * rate < 0.0:
        return rate, -vt / rate
    return rate, math.inf
