"""Transitions from an event to the next mode: impacts, the mode rule and the paradoxes."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.physics.body import (
    BOUNCE_LIMIT,
    FLIGHT,
    IMPACT,
    JAM,
    KANE_GAIN,
    PAINLEVE_INCONSISTENT,
    PAINLEVE_INDETERMINATE,
    ROLL,
    SKIM,
    SLIP_REVERSAL,
    SLIP_START,
    STICK,
    TAKEOFF,
)
from hophoop.kernel.physics.contact import (
    cone_weights,
    free_acceleration,
    resistance_arm,
    rolling_forces,
    slip_coefficients,
)
from hophoop.kernel.physics.impacts import impact, singular_angle, singular_slip, stop_impulse
from hophoop.kernel.physics.modes import (
    INDETERMINATE,
    UNDECIDED,
    next_mode,
    slip_direction,
    slip_mode,
)
from hophoop.kernel.records.writing import PendingEvent, event_without_jump, record_doubt, write_event, write_plain_event
from hophoop.kernel.rigid.panel_events import CLOSE, SMALLEST_SQUARE

P_SIGMA_ROUNDING = 4e-15  # of κ p_σ, relative to its terms
GAIN_FLOOR = 1e-14  # relative to the energy of the impact; a smaller gain is rounding


@inline
def collide(body, rest, state, kind, mode, collision):
    """Return (state after, cause) of an impact."""
    s, c = sine_cosine(state.th, state.th_low)
    vt, vn, spin, p_n, p_t, loss_n, loss_t = impact(body, rest, s, c, state.vt, state.vn)
    om = state.om + spin
    gain = -(loss_n + loss_t)
    if gain <= GAIN_FLOOR * (abs(loss_n) + abs(loss_t) + state.vn * state.vn):
        gain = 0.0
    cause = PendingEvent(kind, mode, state.vt, state.vn, state.om, p_n, p_t, gain, collision)
    losses_n = state.impact_n + loss_n
    losses_t = state.impact_t + loss_t
    return replaced(state, vt=vt, vn=vn, om=om, impact_n=losses_n, impact_t=losses_t), cause


@noinline
def end_bounces(body, state):
    """Return (state after, cause) of the impact that ends infinitely many bounces, with e = 0 and v_n = 0 after it."""
    after, cause = collide(body, 0.0, state, BOUNCE_LIMIT, FLIGHT, 1)
    if not after.vn > 0.0:
        return after, cause
    # μ = ∞: the impulse that stops the slip lifts the rim; a second impulse that stops the rim dissipates as little
    s, c = sine_cosine(state.th, state.th_low)
    spin, p_n, p_t, loss = stop_impulse(body, s, c, after.vn)
    still = replaced(after, vt=0.0, vn=0.0, om=after.om + spin, impact_n=after.impact_n + loss)
    p_n += cause.p_n
    p_t += cause.p_t
    return still, PendingEvent(BOUNCE_LIMIT, FLIGHT, state.vt, state.vn, state.om, p_n, p_t, 0.0, 1)


@noinline
def write_cause(log, cause, mode, state):
    """Write the event, and Kane's energy gain after it if there is one."""
    write_event(log, cause, mode, state, 0.0, -1)
    if cause.gain > 0.0:
        write_event(log, event_without_jump(KANE_GAIN, mode, state), mode, state, cause.gain, -1)


@noinline
def is_singular(body, sigma, om, s, c):
    """Return True if p_σ of slip is zero within rounding."""
    arm, stiffness = slip_coefficients(body, s, c, sigma, resistance_arm(body, s, c, om, sigma))
    return abs(stiffness) <= P_SIGMA_ROUNDING * (body.kap + abs(body.eps * s * arm))


@noinline
def mode_is_in_doubt(body, state):
    """Return True if rounding of a state in contact may decide the mode that follows."""
    if body.kap == 0.0 or body.mu_s == 0.0 or math.isinf(body.mu_s):
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    scale = body.gn + abs(body.gt) + u
    if scale == 0.0:
        return False
    opening = abs(free_acceleration(body, s, c, u)[1])
    if state.vt != 0.0:
        sigma = 1 if state.vt > 0.0 else -1
        return is_singular(body, sigma, state.om, s, c) or opening <= CLOSE * (body.gn + body.eps * u)
    friction, normal = rolling_forces(body, s, c, state.om * state.om, resistance_arm(body, s, c, state.om, 0))
    a, b = cone_weights(body.mu_s)
    margin = a * normal - b * abs(friction)
    if abs(margin) <= CLOSE * scale or abs(normal) <= CLOSE * scale:
        return True
    return margin < 0.0 and opening <= CLOSE * scale


@noinline
def undecided(body, state, log):
    """Return (UNDECIDED, state), with the doubt that extended precision may resolve; with infinite friction it does not."""
    if not math.isinf(body.mu_s):
        record_doubt(log.doubt, state.t)
    return UNDECIDED, state


@inline
def resolve_mode(body, state, cause, log):
    """Apply the mode rule after `cause`, writing its event and every paradox met until then.

    Returns (mode, state); the mode is UNDECIDED if the model has no answer.
    """
    for _ in range(8):
        if state.vn > 0.0:
            write_cause(log, cause, FLIGHT, state)
            return FLIGHT, state
        if body.resist > 0.0 and state.om * state.om < SMALLEST_SQUARE:  # as at the phase's start
            state = replaced(state, om=0.0)
        if mode_is_in_doubt(body, state):
            record_doubt(log.doubt, state.t)
        mode = next_mode(body, state.th, state.th_low, state.om, state.vt)
        if cause.kind == STICK and body.mu_s == 0.0 and mode == cause.mode:
            mode = slip_mode(-slip_direction(mode))  # slip that has ended does not continue, even if rounding suggests so
        named = mode
        if mode > SKIM:
            named = ROLL if state.vt == 0.0 else slip_mode(1 if state.vt > 0.0 else -1)
        if cause.kind == STICK and named != ROLL:
            cause = event_without_jump(TAKEOFF if named == FLIGHT else SLIP_REVERSAL, cause.mode, state)
        write_cause(log, cause, named, state)
        if mode <= SKIM:
            return mode, state
        if mode == UNDECIDED:
            break
        if mode == INDETERMINATE:
            after = named if body.painleve_impact else FLIGHT
            write_plain_event(log, PAINLEVE_INDETERMINATE, named, after, state)
            if not body.painleve_impact:
                return FLIGHT, state
        else:
            write_plain_event(log, PAINLEVE_INCONSISTENT, named, named, state)
        state, cause = collide(body, body.rest, state, IMPACT, named, 0)
    return undecided(body, state, log)


@noinline
def resolve_painleve_singularity(body, mode, state, log):
    """Return (True if it jams, mode, state) after slip whose panels have shrunk to nothing.

    This happens where p_σ → 0 with N → ∞. Any other cause is a failure of the program, reported as UNDECIDED.
    """
    s, c = sine_cosine(state.th, state.th_low)
    sigma = slip_direction(mode)
    rho = resistance_arm(body, s, c, state.om, sigma)
    torque, distance = slip_coefficients(body, s, c, sigma, rho)
    found, exact, ahead = singular_angle(body, s, c, state.om * state.om, sigma, torque, distance)
    if not found:
        return False, *undecided(body, state, log)
    if sigma * state.vt <= 0.0:  # v_t is used up: slip has ended, since an impulse would accelerate it
        mode, after = resolve_mode(body, replaced(state, vt=0.0, vn=0.0), event_without_jump(STICK, mode, state), log)
        return False, mode, after
    jams, vt, om, p_n, loss = singular_slip(body, s, c, exact, ahead, state.vt, state.om, rho)
    p_t = -sigma * body.mu_k * p_n
    losses = state.impact_t + loss
    rolling_loss = state.rolling_loss + 0.5 * rho * (state.om + om) * p_n
    after = replaced(state, vt=vt, vn=0.0, om=om, impact_t=losses, rolling_loss=rolling_loss)
    if jams:
        cause = PendingEvent(JAM, mode, state.vt, state.vn, state.om, p_n, p_t, 0.0, -1)
        write_event(log, cause, mode, after, 0.0, -1)
        return True, mode, after
    write_plain_event(log, PAINLEVE_INCONSISTENT, mode, mode, state)
    cause = PendingEvent(IMPACT, mode, state.vt, state.vn, state.om, p_n, p_t, 0.0, 0)
    if vt != 0.0:  # θ̇ has reversed, and the hoop still slips
        write_event(log, cause, mode, after, 0.0, -1)
        return False, mode, after
    mode, after = resolve_mode(body, after, cause, log)
    return False, mode, after


@noinline
def leave_cone(body, state, ahead, log):
    """Return the mode after rolling that needs all available friction (rule 2); `ahead` is True if F > 0.

    Slip starts against the friction force at its limit, unless the rim is free to leave the plane.
    """
    u = state.om * state.om
    s, c = sine_and_cosine(state.th)
    opens = free_acceleration(body, s, c, u)[1]
    if abs(opens) <= CLOSE * (body.gn + u) and not math.isinf(body.mu_s):
        record_doubt(log.doubt, state.t)
    if opens >= 0.0:
        mode = FLIGHT
        write_plain_event(log, TAKEOFF, ROLL, FLIGHT, state)
    elif math.isinf(body.mu_s):
        mode = UNDECIDED  # quasi-jump: N = 0, but free motion would penetrate the plane
    else:
        mode = slip_mode(-1 if ahead else 1)
        write_plain_event(log, SLIP_START, ROLL, mode, state)
    return mode
