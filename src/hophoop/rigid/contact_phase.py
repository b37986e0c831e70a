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
    extremes,
    first_fall,
    lagrange,
    left_value,
    width_of,
)
from hophoop._jit import inline_jit, lean_jit
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
    LEAVE,
    LINEAR,
    LOSS,
    RATE,
    RESOLVED,
    SLIP,
    TIME,
    A,
    B,
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
from hophoop.physics.roll import roll_margins, rolling_u, solve_roll, u_on_panel
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
MOST_MOVES = 8  # of a turning point
START_ROUNDING = 1e-15  # of θ̇² at the start of a panel that arrives at one
STILL_ACCELERATION = 1e-15
# Below this speed panels may be narrower than the tables go: a hoop that starts or turns at the speed θ̇ has a
# scale of θ̇²/θ̈.
SLOW = 1e-3
LONG = 64.0  # times the time left, or the unit of time: longer panels than this are cut
NARROWEST = 2000
MARGIN_ROUNDING = 4e-16  # of the margin to the friction cone, beside the forces
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
def is_still(body, sigma, th):
    """Whether θ̈ of a hoop that does not turn is what the rounding of θ at an equilibrium can make."""
    s = math.sin(th)
    c = math.cos(th)
    firm = inertia_at_height(body, load_height(s, c)) if sigma == 0 else slip_stiffness(body, s, c, sigma)
    rounding = STILL_ACCELERATION * (1.0 + abs(th))
    if firm > 0.0:
        rounding *= 1.0 + body.eps * (body.gn + abs(body.gt)) / firm
    return abs(angular_acceleration(body, sigma, th, 0.0)) <= rounding


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
    more = int(math.ceil(math.log2(size / RESOLVED) / GAIN_OF_A_LEVEL))
    return level + max(1, min(4, more))


@lean_jit
def turns_within(body, panel, reach):
    """Whether rolling on from the panel's start has θ̇² < 0 at one of a few angles up to `reach`."""
    while reach >= 0.5 * panel.extent:
        if rolling_u(body, panel.ref, panel.u, panel.way * reach) < 0.0:
            return True
        reach *= 0.5
    return False


@lean_jit
def turning_point_ahead(body, panel, totals, scratch):
    """Angle from here to the first zero of θ̇², or 0 where none is near.

    Where a panel loses most of θ̇² but does not reach the zero, wider ones are searched: panels that
    fit before it would shrink towards it for ever.
    """
    if panel.sigma == 0 and not turns_within(body, panel, 8.0 * panel.extent):
        return 0.0
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
            body, panel.sigma, max(panel.level - 2, 0), panel.way, panel.ref, panel.sine, panel.cosine, panel.u, panel.vt
        )
        totals = solve(body, panel, scratch.work)
    return 0.0


@lean_jit
def solve_arrival(body, before, ahead, work):
    """A panel up to the turning point about `ahead` from the start of a linear one; returns (panel, totals).

    `ahead` is as good as a panel that is not resolved. The turning point is moved to where this one, which goes back
    from there, finds θ̇² at the start as it is.
    """
    power = 1.0  # of `ahead` in θ̇² at the start
    panel = arriving_panel(body, before, ahead)
    totals = solve(body, panel, work)
    for _ in range(MOST_MOVES):
        if not (totals.tail <= RESOLVED and totals.u > 0.0) or abs(totals.u - before.u) <= START_ROUNDING * before.u:
            break
        moved = ahead * math.pow(before.u / totals.u, 1.0 / power)
        panel = arriving_panel(body, before, moved)
        u = totals.u
        totals = solve(body, panel, work)
        if totals.u > 0.0 and abs(totals.u - u) > 1e-9 * u:
            power = min(max(math.log(totals.u / u) / math.log(moved / ahead), 0.25), 4.0)
        ahead = moved
    return panel, totals


@inline_jit
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
    s = math.sin(state.th)
    c = math.cos(state.th)
    finest = LEVELS
    if u < SLOW * SLOW:
        finest += int(math.ceil(2.0 * math.log2(SLOW * SLOW / u)))
    while True:
        panel = linear_panel(body, sigma, level, way, state.th, s, c, u, state.vt)
        totals = solve(body, panel, work)
        if totals.tail <= RESOLVED:
            return panel, totals, max(level - 1, 0) if totals.tail < WIDEN else level
        size = totals.tail
        if not work[U, ORDER - 1] > 0.8 * u:
            ahead = turning_point_ahead(body, panel, totals, scratch)
            if ahead > 0.0 and ahead < panel.extent / 16.0:
                # a place known to the rounding of a panel this wide is not known well enough
                level = min(level + int(math.floor(2.0 * math.log2(panel.extent / ahead))) - 3, finest)
                continue
            if ahead > 0.0:
                arrival, totals = solve_arrival(body, panel, ahead, work)
                if totals.tail <= RESOLVED:
                    return arrival, totals, START_LEVEL
        level = narrower(level, size)
        if level >= finest:
            return panel, totals, level


@lean_jit
def fall_of(row, state_is_fresh, floor, scratch):
    """Where in the panel a margin falls through zero; at its very start if it is negative there already.

    A margin that stays above −`floor` counts as the zero that it would be without rounding.
    """
    lowest, highest = extremes(row)
    # between its nodes and at the ends a function that the panel resolves goes beyond their range by a part of it
    if lowest > highest - lowest:
        return NOT_FOUND
    coefficients(row, scratch.series)
    if not state_is_fresh and left_value(scratch.series) <= 0.0:
        if floor == 0.0:
            return -1.0
        for i in range(ORDER):
            if row[i] < -floor:
                return -1.0
        return NOT_FOUND
    return first_fall(scratch.series, floor, scratch.stack)


@inline_jit
def earliest_event(body, panel, totals, state, fresh, zeros, t_end, origin, span, scratch):
    """(ξ, what) of the first event on the panel; ξ = 1 with ON or TURNED where there is none.

    Simultaneous events: the cone (roll), then lift-off before the end of slip, then the limits.
    """
    work = scratch.work
    xi = NOT_FOUND
    what = ON
    if panel.sigma == 0:
        roll_margins(body, work)
        rounding = MARGIN_ROUNDING * (body.gn + abs(body.gt) + panel.u)
        found = fall_of(work[A], fresh, rounding, scratch)
        if found < xi:
            xi = found
            what = CONE_AHEAD  # F > 0
        found = fall_of(work[B], fresh, rounding, scratch)
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
        found = fall_of(work[A], fresh, 0.0, scratch)
        if found < xi:
            xi = found
            what = LIFT
        found = fall_of(work[B], fresh, 0.0, scratch)
        if fresh and zeros == 0 and work[B, 0] < 0.0 and found > NODES[0]:
            found = -1.0  # slip that ends before it can be told from none on the panel
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
def u_between(panel, xi, weights, values):
    """θ̇² at ξ of a slip panel; beside a turning point by θ̇²/s², so that also a small θ̇ has its digits."""
    if panel.kind == LINEAR:
        return dot(weights, values)
    end = 1.0 if panel.kind == ARRIVE else -1.0
    result = 0.0
    for i in range(ORDER):
        result += weights[i] * (values[i] / ((end - NODES[i]) * (end - NODES[i])))
    return result * ((end - xi) * (end - xi))


@inline_jit
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
            u = u_between(panel, xi, scratch.weights, work[U])
            vt = dot(scratch.weights, work[SLIP])
            loss = dot(scratch.weights, work[LOSS])
    else:
        tau = totals.time
        u = 0.0 if panel.kind == ARRIVE else totals.u
        vt = totals.vt
        loss = totals.loss
    tau = max(tau, 0.0)
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


@inline_jit
def shortened(body, panel, totals, state, left, scratch):
    """The panel, or a narrower one where it would last so long beside the time left that its end would be lost in it."""
    if not (totals.time > LONG * max(left, 1.0) and left > 0.0):
        return panel, totals
    if panel.kind == LEAVE:
        extent = panel.extent * (4.0 * left / totals.time) ** 2
        short = leaving_panel(body, panel.sigma, panel.way, panel.ref, extent, panel.vt)
    else:
        wide = width_of(0) / (4.0 * left * abs(state.om))
        level = min(max(int(math.floor(2.0 * math.log2(wide))), 0), NARROWEST)
        short = linear_panel(
            body, panel.sigma, level, panel.way, state.th, math.sin(state.th), math.cos(state.th),
            state.om * state.om, state.vt,
        )  # fmt: skip
    return short, solve(body, short, scratch.work)


@inline_jit
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
    if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:
        state = revised(state, state.t, state.th, state.vt, 0.0)
    if state.om == 0.0:
        if body.kap == 0.0 and (sigma != 0 or math.cos(state.th) <= -1.0):
            return STILL, state, level, count  # the massless hoop with its load on the plane
        if is_still(body, sigma, state.th):
            return STILL, state, level, count
    panel, totals, level = choose_panel(body, sigma, state, level, FIRST_EXTENT, scratch)
    if not totals.tail <= RESOLVED:
        return STUCK, state, level, count
    panel, totals = shortened(body, panel, totals, state, t_end - state.t, scratch)
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
