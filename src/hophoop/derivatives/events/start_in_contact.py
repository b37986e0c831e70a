"""A start in contact whose rim is lifted a little, or launched up or down: the perturbation after it has settled.

A small velocity v_n is gone after bounces that last a time of its order. Whatever they were, slip and gap are then as without
them, so that the impulses in addition to those of N and F are known: those that stop v_n, along the line of sticking or of
slip. A rim that is lifted by h falls for √(2 h/abs(f_n)). In slip, and in rolling with e = 0, the impulses are then those of
N and F to the order √h, and the difference is of the order h (docs/derivatives.md#a-start-in-contact).
"""

from __future__ import annotations

import math

from hophoop.derivatives.layout import OM, RESISTED, TH, VN, VT, X, Y
from hophoop.derivatives.pieces.flight_and_rest import motion_against, resisted_motion
from hophoop.derivatives.pieces.panels import momentum_change, place_change
from hophoop.kernel.native import apart
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.contact import (
    contact_arms,
    free_acceleration,
    inertia_at_height,
    load_height,
    rolling_acceleration,
    slip_motion,
    slip_stiffness,
    slip_torque_arm,
)
from hophoop.kernel.physics.impact import impact, slip_rates, stick_rates
from hophoop.kernel.physics.painleve import stiffness_slope

SMALL = 2.0**-30  # v_n relative to the slip


@apart
def rebound(body, sigma, s, c, vt, vn):
    """Return v_n after a landing of rolling (sigma = 0) or slip over the small one before; nan if the contact changes."""
    if sigma != 0:
        return impact(body, body.rest, s, c, vt, -SMALL)[1] / SMALL
    after = impact(body, body.rest, s, c, vt, vn)
    return -after[1] / vn if after[0] == 0.0 else math.nan


@apart
def time_of_bounces(body, sigma, s, c, state, throw):
    """Return the duration of bounces that begin with a small v_n = `throw`, over its size; nan if it is unknown."""
    along, away = free_acceleration(body, s, c, state.om * state.om)
    part = rebound(body, sigma, s, c, state.vt if sigma != 0 else -2.0 * along / away, -1.0)
    time = -2.0 / away / (1.0 - part) if part < 1.0 else math.nan
    if throw < 0.0:
        time *= rebound(body, sigma, s, c, state.vt, -1.0)
    return time


@apart
def loses_slip(body, s, c, om):
    """Return True if a small slip of either direction ends at once in a hoop that rolls."""
    if math.isinf(body.mu_k):
        return True
    for sigma in (-1, 1):
        _, normal, along = slip_motion(body, s, c, om * om, sigma, 0.0)
        if not (normal > 0.0 and sigma * along < 0.0 and slip_stiffness(body, s, c, sigma, 0.0) > 0.0):
            return False
    return True


@apart
def stop_throw(body, sigma, state, tangents, k):
    """A little v_n of a start in contact; returns whether there is a derivative."""
    s, c = sine_cosine(state.th, state.th_low)
    arm, lever = contact_arms(body, s, c)
    throw = tangents[VN, k]
    if body.rest >= 1.0 or body.mu_s == 0.0 or (body.resist > 0.0 and state.om == 0.0):
        return False
    sliding = 0.0
    time = time_of_bounces(body, sigma, s, c, state, throw) * abs(throw)
    if math.isnan(time) and (sigma != 0 or body.resist > 0.0 or not loses_slip(body, s, c, state.om)):
        return False
    if sigma == 0:
        _, turn, lift = stick_rates(body, arm, lever)
    else:
        turn, sliding, lift = slip_rates(body, arm, lever, -sigma * body.mu_k)
    if not lift > 0.0:
        return False
    if body.resist > 0.0:  # which does not act in the bounces
        with_couple = resisted_motion(body, sigma, state, 0.0)
        without = motion_against(body, sigma, state, 0.0)
        tangents[OM, k] -= (with_couple[0] - without[0]) * time
        tangents[VT, k] -= (with_couple[1] - without[1]) * time
        tangents[RESISTED, k] -= with_couple[3] * time
    tangents[OM, k] -= turn * throw / lift
    tangents[VT, k] -= sliding * throw / lift
    tangents[VN, k] = 0.0
    return True


@apart
def let_fall(body, sigma, state, tangents, k):
    """A little height of a start in contact; returns whether there is a derivative."""
    s, c = sine_cosine(state.th, state.th_low)
    height = tangents[Y, k]
    om = state.om
    eps = body.eps
    if body.rest >= 1.0 or body.resist > 0.0 or body.mu_s == 0.0 or not height > 0.0:
        return False
    along, away = free_acceleration(body, s, c, om * om)
    if sigma == 0:
        if body.rest > 0.0 or impact(body, 0.0, s, c, -along / away, -1.0)[0] != 0.0:
            return False
        turning = rolling_acceleration(body, s, c, om * om, 0.0)
        inertia = inertia_at_height(body, load_height(s, c))
        tangents[TH, k] += turning / away * height
        tangents[X, k] += (turning - along) / away * height
        tangents[OM, k] -= om * eps * (c * body.gn - s * body.gt - eps * om * om) / (inertia * away) * height
    else:
        q = slip_torque_arm(body, s, c, sigma)
        stiffness = slip_stiffness(body, s, c, sigma, 0.0)
        if not stiffness > 0.0:
            return False
        signed_mu = sigma * body.mu_k
        spin = q / stiffness
        steeper = (eps * (c - signed_mu * s) - spin * stiffness_slope(body, s, c, sigma, q)) / stiffness
        dth = -spin * height
        dom = om * (steeper + 2.0 * eps * c * spin * spin) * height
        tangents[TH, k] += dth
        tangents[OM, k] += dom
        tangents[X, k] += signed_mu * height - place_change(body, sigma, s, c, dth, 0.0, 0.0)
        tangents[VT, k] -= momentum_change(body, sigma, s, c, om, (0.0, dom, dth), (0.0, 0.0))
    tangents[Y, k] = 0.0
    return True
