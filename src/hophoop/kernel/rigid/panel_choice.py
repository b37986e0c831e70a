"""Choice of the next panel of rolling or slip: the widest one that is resolved, up to a turning point if one is near."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import sine, sine_cosine
from hophoop.kernel.numerics.collocation import NOT_FOUND, ORDER, coefficients, first_downcrossing
from hophoop.kernel.numerics.exponentials import binary_logarithm
from hophoop.kernel.panels.anchor import rolling_panel_start
from hophoop.kernel.panels.panel import (
    ENERGY,
    LEAVE,
    LEVELS,
    LINEAR,
    RESOLVED,
    Panel,
    U,
    arriving_panel,
    leaving_panel,
    linear_panel,
    width_of,
)
from hophoop.kernel.panels.solve import solve_resisted, solve_roll, solve_slip, u_on_panel
from hophoop.kernel.physics.contact import (
    clamp,
    inertia_at_height,
    load_height,
    resistance_arm,
    slip_coefficients,
)
from hophoop.kernel.records.layout import PANELS
from hophoop.kernel.rigid.phase import START_LEVEL

GAIN_OF_A_LEVEL = 8.0  # one level (a factor of √2 in width) makes the last coefficient smaller by about 2^8
WIDEN = RESOLVED / 200.0
FIRST_EXTENT = 0.4  # rad, width of the panel after a start from rest
SMALLEST_EXTENT = 1e-300
ARRIVED = 1e-11  # relative: θ̇² integrated back from a turning point to the start; otherwise its place is not known well enough
# Below this speed panels may be narrower than the tables: θ̇² changes over the angle θ̇²/θ̈.
SLOW = 1e-3
LONG = 64.0  # panels are cut if they last longer than this times the time left (or the unit of time)
NARROWEST = 2000


@inline
def panel_start(body, sigma, anchor, state, s, c):
    """Return the start of the next panel, a panel without extent; s and c are sin θ and cos θ."""
    u = state.om * state.om
    torque = curvature = arm = kappa_p_sigma = 0.0
    if sigma == 0:
        torque, curvature, u = rolling_panel_start(body, anchor, state, s, c)
        if body.resist > 0.0:
            reach = body.resist * body.gn
            torque -= math.copysign(reach, state.om) if state.om != 0.0 else clamp(torque, reach)
    else:
        arm, kappa_p_sigma = slip_coefficients(body, s, c, sigma, resistance_arm(body, s, c, state.om, sigma))
    turning = state.om if state.om != 0.0 else torque if sigma == 0 else arm
    direction = 1.0 if turning > 0.0 else -1.0
    return Panel(
        sigma, LINEAR, 0, direction, state.th, state.th_low, s, c, 0.0, torque, curvature, arm, kappa_p_sigma, u, state.vt
    )


@inline
def solve(body, panel, work):
    """Solve the panel by the equations of its mode; fill `work` and return the Totals."""
    if panel.sigma == 0:
        if body.resist > 0.0:
            return solve_resisted(body, panel, work)
        return solve_roll(body, panel, work)
    return solve_slip(body, panel, work)


@noinline
def solve_noinline(body, panel, work):
    """Call `solve` without inlining it, where it is rarely needed: copies of it would dominate the compile time."""
    return solve(body, panel, work)


@inline
def narrower_level(level, size):
    """Return the level to try after a panel whose last coefficients were `size`."""
    if not size < 1.0:
        return level + 3
    more = math.ceil(binary_logarithm(size / RESOLVED) / GAIN_OF_A_LEVEL)
    return level + max(1, min(4, more))


@noinline
def slow_levels(body, sigma, begin):
    """Return (widest, finest) level for a panel that starts with θ̇² below `SLOW`².

    θ̇² changes by its own size over the angle θ̇²/θ̈, so a wider panel is not resolved. On a much wider one θ̇² at the start,
    and with it the turning point, is lost in rounding.
    """
    finest = LEVELS + math.ceil(2.0 * binary_logarithm(SLOW * SLOW / begin.u))
    if sigma == 0:
        torque = abs(begin.torque)
        inertia = inertia_at_height(body, load_height(begin.sine, begin.cosine))
    else:
        torque = abs(begin.arm) * body.gn
        inertia = begin.kappa_p_sigma
    if not 0.0 < begin.u * inertia < width_of(0) * torque:
        return 0, finest
    # a sum of logarithms, since the quotient may overflow
    ratio = binary_logarithm(width_of(0) * torque) - binary_logarithm(inertia) - binary_logarithm(begin.u)
    return math.floor(2.0 * ratio), finest


@noinline
def has_turning_point_within(body, panel, reach):
    """Return True if rolling has θ̇² < 0 at one of a few angles up to `reach` from the panel's start."""
    end = sine(reach)
    while reach >= 0.5 * panel.extent:
        half = sine(0.5 * reach)  # gives 1 − cos as in `versine_of`, and is the sine of the next angle
        if u_on_panel(body, panel, panel.direction * end, 2.0 * half * half, panel.direction * reach) < 0.0:
            return True
        reach *= 0.5
        end = half
    return False


@noinline
def turning_point_ahead(body, panel, totals, scratch):
    """Return the angle from the panel's start to the first zero of θ̇², or 0 if none is near.

    If a panel loses most of θ̇² without reaching the zero, wider panels are searched: panels that end before the turning point
    would shrink towards it forever.
    """
    if panel.sigma == 0 and body.resist == 0.0 and not has_turning_point_within(body, panel, 8.0 * panel.extent):
        return 0.0
    for _ in range(4):
        if math.isnan(totals.u):
            return 0.0
        coefficients(scratch.work[ENERGY if panel.sigma == 0 else U], scratch.series)
        xi = first_downcrossing(scratch.series, 0.0, scratch.stack)
        if xi != NOT_FOUND:
            return panel.extent * 0.5 * (1.0 + xi)
        if panel.level == 0:
            return 0.0
        panel = linear_panel(panel, max(panel.level - 2, 0))
        totals = solve_noinline(body, panel, scratch.work)
    return 0.0


@inline
def choose_panel(body, sigma, anchor, state, s, c, level, scratch):
    """Return the widest resolved panel from this state; s and c are sin θ and cos θ.

    Returns (panel, totals, level for the next panel); totals.tail exceeds RESOLVED if no panel is resolved.
    """
    work = scratch.work
    begin = panel_start(body, sigma, anchor, state, s, c)
    if state.om == 0.0:
        extent = FIRST_EXTENT
        while True:  # at most about 1000 times: the extent is halved from below 1 rad
            scratch.counts[PANELS] += 1
            panel = leaving_panel(begin, extent)
            totals = solve_noinline(body, panel, work)
            if totals.tail <= RESOLVED or extent < SMALLEST_EXTENT:
                return panel, totals, START_LEVEL
            extent *= 0.5
    u = begin.u
    finest = LEVELS
    if u < SLOW * SLOW:
        widest, finest = slow_levels(body, sigma, begin)
        level = max(level, min(widest, finest))
    while True:  # at most `finest` times: each pass takes a finer level
        scratch.counts[PANELS] += 1
        panel = linear_panel(begin, level)
        totals = solve(body, panel, work)
        if totals.tail <= RESOLVED:
            return panel, totals, max(level - 1, 0) if totals.tail < WIDEN else level
        size = totals.tail
        if not work[U, ORDER - 1] > 0.8 * u:
            ahead = turning_point_ahead(body, panel, totals, scratch)
            if ahead > 0.0 and ahead < panel.extent / 16.0 and level < finest:
                # the turning point is only known to the rounding of a panel this wide, so try a narrower one first
                level = min(level + math.floor(2.0 * binary_logarithm(panel.extent / ahead)) - 3, finest)
                continue
            if ahead > 0.0:
                arrival = arriving_panel(body, panel, ahead)
                totals = solve_noinline(body, arrival, work)
                if totals.tail <= RESOLVED and abs(totals.u - u) <= ARRIVED * u:
                    return arrival, totals, START_LEVEL
        level = narrower_level(level, size)
        if level >= finest:
            return panel, totals, level


@inline
def exceeds_time_left(totals, left):
    """Return True if the panel lasts so much longer than the time left that the end of the motion is lost in it."""
    return totals.time > LONG * max(left, 1.0) and left > 0.0


@noinline
def narrow_to_time(body, anchor, panel, totals, state, left, scratch):
    """Return (panel, totals) of a panel narrow enough for the time left; see `exceeds_time_left`."""
    s, c = sine_cosine(state.th, state.th_low)
    begin = panel_start(body, panel.sigma, anchor, state, s, c)
    if panel.kind == LEAVE:
        part = 4.0 * left / totals.time
        short = leaving_panel(begin, panel.extent * part * part)
    else:
        wide = width_of(0) / (4.0 * left * abs(state.om))
        short = linear_panel(begin, min(max(math.floor(2.0 * binary_logarithm(wide)), 0), NARROWEST))
    return short, solve_noinline(body, short, scratch.work)
