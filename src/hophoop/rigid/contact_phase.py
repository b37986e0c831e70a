"""Rolling and slipping, panel by panel, up to the first event inside a panel."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop._jit import inline_jit, lean_jit
from hophoop.numerics.collocation import NODES, ORDER, antiderivative, coefficients, dot, extremes, lagrange, left_value
from hophoop.numerics.double_double import TWO_PI, TWO_PI_LOW, add, plus
from hophoop.numerics.roots import NOT_FOUND, first_fall
from hophoop.numerics.trigonometry import rotated, sine_cosine, turn, versine_of
from hophoop.panels.anchor import (
    NONE,
    ROLLING,
    SLIPPING,
    Anchor,
    offset_from,
    rolling_anchor,
    rolling_begin,
    slip_anchor,
    slip_begin,
)
from hophoop.panels.panel import (
    ARRIVE,
    COSINE,
    LEAVE,
    LEVELS,
    LINEAR,
    LOSS,
    RATE,
    RESOLVED,
    SLIP,
    TIME,
    A,
    B,
    Begin,
    U,
    angle_at,
    arriving_panel,
    chord,
    fill_inside,
    leaving_panel,
    linear_panel,
    place_of,
    width_of,
)
from hophoop.panels.roll import roll_margins, solve_roll, u_on_panel
from hophoop.panels.slip import solve_slip
from hophoop.physics.body import Mode
from hophoop.physics.contact import (
    inertia_at_height,
    load_height,
    rolling_acceleration,
    slip_motion,
    slip_stiffness,
    slip_torque_arm,
)
from hophoop.physics.modes import slip_direction
from hophoop.physics.slip import slip_displacement
from hophoop.records.state import State, at_time, later, moved, time_left, with_anchor, with_velocities
from hophoop.records.writing import write_segment
from hophoop.rigid.doubts import CLOSE, NEARBY, has_graze, note_doubt

ROLL = int(Mode.ROLL)
# What ended a panel.
ON, CONE_AHEAD, CONE_BACK, LIFT, STOP, TURNED, LIMIT, FULL_ANGLE, STILL, STUCK = range(10)

START_LEVEL = 2
GAIN_OF_A_LEVEL = 8.0  # a panel narrower by √2 has a last coefficient smaller by about 2^8
WIDEN = RESOLVED / 200.0
FIRST_EXTENT = 0.4  # rad, of the panel after a start from rest
SMALLEST_EXTENT = 1e-300
MOST_MOVES = 8  # of a turning point
START_ROUNDING = 1e-15  # of θ̇² at the start of a panel that arrives at one
STILL_ACCELERATION = 1e-15
# Below this speed panels may be narrower than the tables go: a hoop that starts or turns at the speed θ̇ has a
# scale of θ̇²/θ̈.
SLOW = 1e-3
LONG = 64.0  # times the time left, or the unit of time: longer panels than this are cut
NARROWEST = 2000
MARGIN_ROUNDING = 4e-16  # of the margin to the friction cone, beside the forces
GRAZE_ROUNDING = 1e-14  # of v_t in slip without friction, beside the speeds
SMALLEST_SQUARE = 1e-290  # a smaller θ̇² is on the way to underflow
# θ stays within this of the turn it is counted in, so that it has all its digits beside the hilltops of both sides.
FARTHEST = TWO_PI - 0.5


class Limits(NamedTuple):
    """Where a motion ends at the latest: a time, and an angle to either side of the start (nan: none)."""

    t_end: float
    span: float
    span_turns: float  # the span as whole turns and the rest
    span_rest: float
    turns: float  # the angle of the start
    th: float
    th_low: float


@lean_jit
def limits_of(start, t_end, span):
    """Limits of a motion; a span that is a double beside whole turns means these turns."""
    turns = 0.0
    rest = 0.0
    if not math.isnan(span):
        turns = 1.0 * math.floor(span / TWO_PI + 0.5)
        rest = span - turns * TWO_PI
        if abs(rest) <= 4e-16 * span:
            rest = 0.0
    return Limits(t_end, span, turns, rest, start.turns, start.th, start.th_low)


@lean_jit
def angle_left(limits, state, way):
    """Angle to go in the direction `way` until the motion has turned by its span."""
    turns = limits.span_turns - way * (state.turns - limits.turns)
    rest = limits.span_rest - way * ((state.th - limits.th) + (state.th_low - limits.th_low))
    return turns * TWO_PI + (rest + turns * TWO_PI_LOW)


@lean_jit
def at_span(limits, state, way):
    """The state at exactly the angle where the span ends."""
    th, low = plus(limits.th, limits.th_low, way * limits.span_rest)
    turns = limits.turns + way * limits.span_turns
    return moved(state, state.t, state.t_low, state.x, state.x_low, state.y, turns, th, low)


@lean_jit
def counted(body, state):
    """The state with θ counted in the next turn, for one that is too far from the present one."""
    way = 1.0 if state.th > 0.0 else -1.0
    th, low = add((state.th, state.th_low), (-way * TWO_PI, -way * TWO_PI_LOW))
    after = moved(state, state.t, state.t_low, state.x, state.x_low, state.y, state.turns + way, th, low)
    anchor = state.anchor
    if anchor.kind == SLIPPING and body.mu_k == 0.0:
        return after  # without friction the motion that comes to rest at one hilltop does so at each
    if anchor.kind == ROLLING and anchor.bend > 0.0:  # the hilltop of the next turn, which is lower on a slope
        excess = anchor.excess + 2.0 * way * TWO_PI * body.gt
        return with_anchor(after, Anchor(ROLLING, excess, anchor.base, anchor.base_low, anchor.bend))
    base, base_low = add((anchor.base, anchor.base_low), (-way * TWO_PI, -way * TWO_PI_LOW))
    return with_anchor(after, Anchor(anchor.kind, anchor.excess, base, base_low, anchor.bend))


@lean_jit
def anchored(body, sigma, state, scratch):
    """The state at the begin of a phase, with the anchor of the phase."""
    u = state.om * state.om
    if sigma == 0:
        return with_anchor(state, rolling_anchor(body, state.th, state.th_low, u))
    if body.mu_k == 0.0 and state.anchor.kind == SLIPPING:
        return state  # without friction the direction of slip changes nothing
    s, c = sine_cosine(state.th, state.th_low)
    return with_anchor(state, slip_anchor(body, sigma, state.th, state.th_low, s, c, u, scratch.values[0]))


@inline_jit
def begin_of(body, sigma, state, scratch):
    """Where the next panel begins."""
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    if sigma == 0:
        arm, stiffness, u = rolling_begin(body, state.anchor, state.th, state.th_low, s, c, u)
    else:
        arm = slip_torque_arm(body, s, c, sigma)
        if state.anchor.kind == SLIPPING:
            arm, u = slip_begin(body, state.anchor, sigma, state.th, state.th_low, arm, u, scratch.values[0])
        stiffness = body.kap + body.eps * s * arm
    return Begin(state.th, state.th_low, s, c, arm, stiffness, u, state.vt)


@lean_jit
def angular_acceleration(body, sigma, th, u):
    """θ̈ in rolling (sigma = 0) or slip."""
    s = math.sin(th)
    c = math.cos(th)
    if sigma == 0:
        return rolling_acceleration(body, s, c, u)
    return slip_motion(body, s, c, u, sigma)[0]


@lean_jit
def is_still(body, sigma, state):
    """Whether a hoop that does not turn stays: on a hilltop exactly, in a valley within the rounding of θ."""
    anchor = state.anchor
    if anchor.kind != 0 and anchor.bend > 0.0:
        psi = offset_from(state.th, state.th_low, anchor.base, anchor.base_low)
        # beside the top of the level by less than 1e-280 rad it takes 600 √(R/g) to be seen
        return abs(psi) < (1e-280 if anchor.base == 0.0 else 1e-30)
    th = state.th
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
        versine = versine_of(reach)
        if u_on_panel(body, panel, panel.way * math.sin(reach), versine, panel.way * reach) < 0.0:
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
        begin = Begin(panel.ref, panel.ref_low, panel.sine, panel.cosine, panel.arm, panel.stiffness, panel.u, panel.vt)
        panel = linear_panel(panel.sigma, max(panel.level - 2, 0), panel.way, begin)
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
    begin = begin_of(body, sigma, state, scratch)
    if state.om == 0.0:
        way = 1.0 if begin.arm > 0.0 else -1.0
        while True:
            panel = leaving_panel(sigma, way, extent, begin)
            totals = solve(body, panel, work)
            if totals.tail <= RESOLVED or extent < SMALLEST_EXTENT:
                return panel, totals, START_LEVEL
            extent *= 0.5
    u = begin.u
    way = 1.0 if state.om > 0.0 else -1.0
    finest = LEVELS
    if u < SLOW * SLOW:
        finest += int(math.ceil(2.0 * math.log2(SLOW * SLOW / u)))
    while True:
        panel = linear_panel(sigma, level, way, begin)
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

    Returns
    -------
    xi : float
    near : bool
        Whether the margin may touch zero between the nodes: a parabola that does has a node beside it as near as that.
    """
    lowest, highest = extremes(row)
    # between its nodes and at the ends a function that the panel resolves goes beyond their range by a part of it
    if lowest > highest - lowest:
        return NOT_FOUND, False
    near = abs(lowest) < NEARBY * (highest - lowest)
    coefficients(row, scratch.series)
    if not state_is_fresh and left_value(scratch.series) <= 0.0:
        if floor == 0.0:
            return -1.0, near
        for i in range(ORDER):
            if row[i] < -floor:
                return -1.0, near
        return NOT_FOUND, near
    return first_fall(scratch.series, floor, scratch.stack), near


@inline_jit
def earliest_event(body, panel, totals, state, fresh, blind, zeros, limits, scratch):
    """(ξ, what) of the first event on the panel; ξ = 1 with ON or TURNED where there is none.

    Simultaneous events: the cone (roll), then lift-off before the end of slip, then the limits.
    """
    work = scratch.work
    xi = NOT_FOUND
    what = ON
    doubtful = False
    if blind:
        pass
    elif panel.sigma == 0:
        roll_margins(body, work)
        rounding = MARGIN_ROUNDING * (body.gn + abs(body.gt) + panel.u)
        found, near_ahead = fall_of(work[A], fresh, rounding, scratch)
        if found < xi:
            xi = found
            what = CONE_AHEAD  # F > 0
        found, near_back = fall_of(work[B], fresh, rounding, scratch)
        if found < xi:
            xi = found
            what = CONE_BACK
        doubtful = (near_ahead or near_back) and 0.0 < body.mu_s < math.inf
    else:
        for i in range(ORDER):
            work[A, i] = body.gn - body.eps * work[COSINE, i] * work[U, i]
            value = panel.sigma * work[SLIP, i]
            if fresh:
                for _ in range(zeros):
                    value /= 0.5 * (1.0 + NODES[i])
            work[B, i] = value
        speed = abs(panel.vt) + abs(state.om)
        found, near_lift = fall_of(work[A], fresh, 0.0, scratch)
        if found < xi:
            xi = found
            what = LIFT
        # without friction v_t comes back to zero at each hilltop, if it was zero at one, and touches it only
        rounding = GRAZE_ROUNDING * speed if body.mu_k == 0.0 else 0.0
        found, near_stop = fall_of(work[B], fresh, rounding, scratch)
        doubtful = body.mu_k > 0.0 and (near_lift or (near_stop and not fresh))
        if fresh and zeros == 0 and work[B, 0] < 0.0 and found > NODES[0]:
            found = -1.0  # slip that ends before it can be told from none on the panel
        elif fresh and zeros > 0 and body.mu_k == 0.0 and found == NOT_FOUND and extremes(work[B])[1] < 0.0:
            found = -1.0  # the other direction: without friction the rounding of θ may decide where slip begins
        if found != NOT_FOUND and xi != NOT_FOUND and abs(found - xi) < CLOSE and body.mu_k > 0.0:
            note_doubt(scratch, state.t, state.t + totals.time)
        if found < xi:
            xi = found
            what = STOP
    if doubtful and has_graze(body, panel, state, scratch):
        note_doubt(scratch, state.t, state.t + totals.time)
    if not math.isnan(limits.span):
        ahead = angle_left(limits, state, panel.way)
        if ahead <= panel.extent:
            found = -1.0  # an event fell on the angle itself
            if ahead > 0.0:
                found = place_of(panel, panel.extent - ahead if panel.kind == ARRIVE else ahead)
            if found < xi:
                xi = found
                what = FULL_ANGLE
    left = time_left(state, limits.t_end)
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
        along = offset - angle_at(panel, -1.0)
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
        along = slip_displacement(body, panel.sigma, state.vt, state.om, s0, c0, ds, dc, tau)
    t, t_low = later(state, tau)
    x, x_low = plus(state.x, state.x_low, along)
    th, th_low = plus(panel.ref, panel.ref_low, offset)
    return State(
        t, t_low, x, x_low, 0.0, state.turns, th, th_low, vt, 0.0, om,
        state.friction + loss, state.impact_n, state.impact_t, state.anchor,
    )  # fmt: skip


@lean_jit
def carried(body, panel, totals, xi, after):
    """The state after a slip panel, with what its anchor has become."""
    anchor = after.anchor
    if body.mu_k == 0.0:  # θ̇² − θ̇² of another motion goes as 1/(κ p)
        s, _ = sine_cosine(after.th, after.th_low)
        sine = panel.sine
        if panel.kind == ARRIVE:
            sine += turn(panel.sine, panel.cosine, angle_at(panel, -1.0))[0]
        before = body.eps * sine
        now = body.eps * s
        growth = (body.kap + before * before) / (body.kap + now * now)
    elif xi < 1.0:
        return with_anchor(after, NONE)
    else:
        growth = 1.0 / totals.growth if panel.kind == ARRIVE else totals.growth
    return with_anchor(after, Anchor(SLIPPING, anchor.excess * growth, anchor.base, anchor.base_low, anchor.bend))


@inline_jit
def shortened(body, panel, totals, state, left, scratch):
    """The panel, or a narrower one where it would last so long beside the time left that its end would be lost in it."""
    if not (totals.time > LONG * max(left, 1.0) and left > 0.0):
        return panel, totals
    begin = begin_of(body, panel.sigma, state, scratch)
    if panel.kind == LEAVE:
        part = 4.0 * left / totals.time
        extent = panel.extent * part * part
        short = leaving_panel(panel.sigma, panel.way, extent, begin)
    else:
        wide = width_of(0) / (4.0 * left * abs(state.om))
        level = min(max(int(math.floor(2.0 * math.log2(wide))), 0), NARROWEST)
        short = linear_panel(panel.sigma, level, panel.way, begin)
    return short, solve(body, short, scratch.work)


@inline_jit
def advance_contact(body, mode, state, fresh, blind, zeros, level, limits, scratch, segments, count):
    """Roll or slip over one panel or up to the first event in it.

    Parameters
    ----------
    fresh : bool
        Whether the phase begins here; margins that are zero at its begin are no events then.
    blind : bool
        Whether the phase is known to last until the end of time, so that no event is looked for.
    zeros : int
        How often v_t is zero at the begin of a fresh slip phase.

    Returns
    -------
    what, state, level, count
    """
    sigma = slip_direction(mode)
    if state.om != 0.0 and state.om * state.om < SMALLEST_SQUARE:
        state = with_velocities(state, state.vt, state.vn, 0.0)
    if fresh:
        state = anchored(body, sigma, state, scratch)
    if state.om == 0.0:
        if body.kap == 0.0 and (sigma != 0 or math.cos(state.th) <= -1.0):
            return STILL, state, level, count  # the massless hoop with its load on the plane
        if is_still(body, sigma, state):
            return STILL, state, level, count
    panel, totals, level = choose_panel(body, sigma, state, level, FIRST_EXTENT, scratch)
    if not totals.tail <= RESOLVED:
        return STUCK, state, level, count
    panel, totals = shortened(body, panel, totals, state, time_left(state, limits.t_end), scratch)
    if not totals.tail <= RESOLVED:
        return STUCK, state, level, count
    xi, what = earliest_event(body, panel, totals, state, fresh, blind, zeros, limits, scratch)
    after = state_on_panel(body, panel, totals, state, xi, scratch)
    if what == STOP:
        after = with_velocities(after, 0.0, after.vn, after.om)
    elif what == LIMIT:
        after = at_time(after, limits.t_end)
    elif what == FULL_ANGLE:
        after = at_span(limits, after, panel.way)
    if xi > -1.0:
        count = write_segment(segments, count, mode, panel, xi, 0.0, state, after.t)
        if after.anchor.kind == SLIPPING:
            after = carried(body, panel, totals, xi, after)
    if abs(after.th) > FARTHEST:
        after = counted(body, after)
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
