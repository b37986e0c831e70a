"""The derivative of an impact in one direction: that of `physics.impacts.impact`, in the branch that it takes.

What is written by hand is what happens between two branches (docs/derivatives.md#through-the-events).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.derivatives.layout import STILL, Reason
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import NEWTON, contact_arms, impact, impulse_ratio, slip_rates, stick_rates, stop_impulse
from hophoop.kernel.native import noinline

NONE, BORDER, PLASTIC, SIDED = int(Reason.NONE), int(Reason.BORDER), int(Reason.PLASTIC), -1
CLOSE = 1e-10  # relative: closer to zero a quantity that decides may have either sign
JUMP = 1e-10  # relative: changes on both sides of a border that differ by less are equal
LEAST = 1e-200  # a slip that is no more than the change of none

d_impact = tangent_of(impact, "body", "rest", "s", "c", "vt", "vn")
d_stop_impulse = tangent_of(stop_impulse, "body", "s", "c", "vn")


class Blow(NamedTuple):
    """An impact: restitution, sin θ and cos θ, slip and separation velocity before."""

    rest: float
    s: float
    c: float
    vt: float
    vn: float


@noinline
def tangent_from(body, blow, vt, d_body, d_blow):
    """Return (what `impact` returns with the slip vt before, its tangent)."""
    rest, s, c, _, vn = blow
    return d_impact(body, rest, s, c, vt, vn, d_body, d_blow.rest, d_blow.s, d_blow.c, d_blow.vt, d_blow.vn)


def distance(one, other):
    """Return the largest difference of two tangents of an impact."""
    gap = 0.0
    for i in range(7):
        gap = max(gap, abs(one[i] - other[i]))
    return gap


@noinline
def is_between_courses(body, blow):
    """Return True if the least change of an impact may change its course, and its derivatives jump there."""
    arm, lever = contact_arms(body, blow.s, blow.c)
    after = impact(body, blow.rest, blow.s, blow.c, blow.vt, blow.vn)[0]
    if 0.0 < body.mu_s < math.inf and after * blow.vt <= 0.0:  # the slip stops: does friction just hold the stick?
        need = abs(stick_rates(body, arm, lever)[0])
        if abs(need - body.mu_s) <= CLOSE * (1.0 + body.mu_s):
            return True
    by_slip = Blow(0.0, 0.0, 0.0, 1.0, 0.0)
    step = 2.0 * CLOSE * blow.vt
    far_below = tangent_from(body, blow, blow.vt - 3.0 * step, STILL, by_slip)[1]
    below = tangent_from(body, blow, blow.vt - step, STILL, by_slip)[1]
    above = tangent_from(body, blow, blow.vt + step, STILL, by_slip)[1]
    far_above = tangent_from(body, blow, blow.vt + 3.0 * step, STILL, by_slip)[1]
    smooth = distance(far_below, below) + distance(above, far_above)
    size = 1.0 + distance(below, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    return distance(below, above) > 3.0 * smooth + JUMP * size


@noinline
def impact_change(body, blow, d_body, d_blow):
    """Return (the changes of what `impact` returns, why there are none).

    The reason is NONE; SIDED where the changes hold for this side only; else a Reason.
    """
    collision = blow.vn < 0.0
    vt = blow.vt
    reason = NONE
    if math.isinf(body.mu_k) and (d_blow.s != 0.0 or d_blow.vn != 0.0):  # does stopping the slip alone lift the hoop?
        arm, lever = contact_arms(body, blow.s, blow.c)
        if vt != 0.0 and abs(blow.vn + lever * arm * vt / (body.kap + arm * arm)) <= CLOSE * abs(vt):
            reason = BORDER
    if vt == 0.0 and d_blow.vt != 0.0 and not math.isinf(body.mu_k):
        reason = SIDED
        arm, lever = contact_arms(body, blow.s, blow.c)
        way = math.copysign(1.0, d_blow.vt)
        r, stick = impulse_ratio(body, arm, lever, vt)
        if stick or r * way > 0.0:  # a slip that the impact stops at once, or against which it starts another one
            vt = way * LEAST
            if way * slip_rates(body, arm, lever, -way * body.mu_k)[1] >= 0.0:
                reason = BORDER
    found, change = tangent_from(body, blow, vt, d_body, d_blow)
    compressed = found[3] > 0.0 and (body.law != NEWTON or collision)
    if blow.rest == 0.0 and d_blow.rest != 0.0 and compressed:
        reason = PLASTIC
    return change, reason
