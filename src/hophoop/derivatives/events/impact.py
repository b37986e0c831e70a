"""The derivative of an impact in one direction: Routh's impulse, differentiated in the branch that it takes.

It follows the pieces of `physics.impact.impact`; names with a leading d are changes (docs/derivatives.md#through-the-events).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.derivatives.layout import EPS, KAP, MU_K, REST, Reason
from hophoop.kernel.native import noinline
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import NEWTON, POISSON, impulse_ratio, slip_rates, stick_rates

NONE, BORDER, PLASTIC, SIDED = int(Reason.NONE), int(Reason.BORDER), int(Reason.PLASTIC), -1
CLOSE = 1e-10  # relative: closer to zero a quantity that decides may have either sign


class Blow(NamedTuple):
    """An impact: restitution, sin θ and cos θ, slip and separation velocity before."""

    rest: float
    s: float
    c: float
    vt: float
    vn: float


class Arms(NamedTuple):
    """Arms of the impulses about G, their changes and that of κ."""

    arm: float
    lever: float
    darm: float
    dlever: float
    dkap: float


class Piece(NamedTuple):
    """Rates by the normal impulse while the slip keeps its state, and their changes."""

    turn: float  # dθ̇/dp
    kt: float  # dv_t/dp
    kn: float  # dv_n/dp
    dr: float
    dturn: float
    dkt: float
    dkn: float


class Velocities(NamedTuple):
    """Slip and separation velocity, and their changes."""

    vt: float
    vn: float
    dvt: float
    dvn: float


class Sums(NamedTuple):
    """The normal impulse and its work so far, and the changes of θ̇, of the impulses and of their works."""

    p_n: float
    work_n: float
    dspin: float
    dp_n: float
    dp_t: float
    dwork_n: float
    dwork_t: float


class Goal(NamedTuple):
    """The end of restitution: v_n, and the impulse or the work that remains; with their changes."""

    target: float
    todo: float
    dtarget: float
    dtodo: float


def arms_of(body, blow, dth, parameter_tangents, k):
    """Arms at the angle of the impact."""
    arm, lever = contact_arms(body, blow.s, blow.c)
    darm = parameter_tangents[EPS, k] * blow.c - body.eps * blow.s * dth
    dlever = parameter_tangents[EPS, k] * blow.s + body.eps * blow.c * dth
    return Arms(arm, lever, darm, dlever, parameter_tangents[KAP, k])


def stick_changes(body, arms):
    """Changes of `stick_rates`."""
    arm, lever, darm, dlever, dkap = arms
    denominator = body.kap + arm * arm
    spin = lever / denominator
    dspin = (dlever - spin * (dkap + 2.0 * arm * darm)) / denominator
    return darm * spin + arm * dspin, dspin, dlever * spin + lever * dspin


def slip_changes(body, arms, r, dr):
    """Changes of `slip_rates`."""
    arm, lever, darm, dlever, dkap = arms
    spin = (lever - arm * r) / body.kap
    dspin = (dlever - darm * r - arm * dr - spin * dkap) / body.kap
    return dspin, dr - darm * spin - arm * dspin, dlever * spin + lever * dspin


def stop_slip(body, arms, at, sums):
    """The (velocities, sums) after infinite friction has stopped the slip by a tangential impulse alone."""
    arm, lever = arms.arm, arms.lever
    denominator = body.kap + arm * arm
    ddenominator = arms.dkap + 2.0 * arm * arms.darm
    turned = arm * at.vt / denominator
    dturned = (arms.darm * at.vt + arm * at.dvt - turned * ddenominator) / denominator
    side = -at.vt * body.kap / denominator
    dside = (-at.dvt * body.kap - at.vt * arms.dkap - side * ddenominator) / denominator
    dwork_t = sums.dwork_t + 0.5 * (at.dvt * side + at.vt * dside)
    after = Velocities(0.0, at.vn + lever * turned, 0.0, at.dvn + (arms.dlever * turned + lever * dturned))
    return after, Sums(sums.p_n, sums.work_n, sums.dspin + dturned, sums.dp_n, sums.dp_t + dside, sums.dwork_n, dwork_t)


def piece_of(body, arms, r, stick, dmu):
    """The rates of a piece of stick or slip, and their changes."""
    if stick:
        _, turn, kn = stick_rates(body, arms.arm, arms.lever)
        dr, dturn, dkn = stick_changes(body, arms)
        return Piece(turn, 0.0, kn, dr, dturn, 0.0, dkn)
    dr = -dmu if r < 0.0 else dmu
    turn, kt, kn = slip_rates(body, arms.arm, arms.lever, r)
    dturn, dkt, dkn = slip_changes(body, arms, r, dr)
    return Piece(turn, kt, kn, dr, dturn, dkt, dkn)


def is_at_static_limit(body, arms):
    """Return True if sticking needs just the static friction."""
    if math.isinf(body.mu_s):
        return False
    steady = stick_rates(body, arms.arm, arms.lever)[0]
    return abs(abs(steady) - body.mu_s) <= CLOSE * (1.0 + body.mu_s) and body.mu_s > 0.0


def impulse_to_end(body, compression, goal, piece, at):
    """(impulse until compression or restitution ends, its change)."""
    kn, dkn = piece.kn, piece.dkn
    if compression or body.law == NEWTON:
        if not kn > 0.0:
            return math.inf, 0.0
        if compression:
            length = -at.vn / kn
            return length, -(at.dvn + length * dkn) / kn
        length = (goal.target - at.vn) / kn
        return length, (goal.dtarget - at.dvn - length * dkn) / kn
    if body.law == POISSON:
        return goal.todo, goal.dtodo
    root = math.sqrt(at.vn * at.vn + 2.0 * kn * goal.todo)
    length = (-at.vn + root) / kn
    return length, (goal.dtodo - length * at.dvn - 0.5 * length * length * dkn) / root


def impulse_to_stop(piece, at):
    """(impulse until the slip stops, its change)."""
    if at.vt != 0.0 and at.vt * piece.kt < 0.0:
        step = -at.vt / piece.kt
        return step, -(at.dvt + step * piece.dkt) / piece.kt
    return math.inf, 0.0


def normal_work(piece, at, step, dstep):
    """(work of the normal impulse over a piece, its change)."""
    work = at.vn * step + 0.5 * piece.kn * step * step
    return work, at.dvn * step + at.vn * dstep + 0.5 * piece.dkn * step * step + piece.kn * step * dstep


def with_piece(sums, piece, r, at, step, dstep):
    """The sums after a piece with the impulse `step`."""
    slid = at.vt * step + 0.5 * piece.kt * step * step
    dslid = at.dvt * step + at.vt * dstep + 0.5 * piece.dkt * step * step + piece.kt * step * dstep
    gain_n, dgain_n = normal_work(piece, at, step, dstep)
    return Sums(
        sums.p_n + step,
        sums.work_n + gain_n,
        sums.dspin + (piece.dturn * step + piece.turn * dstep),
        sums.dp_n + dstep,
        sums.dp_t + (piece.dr * step + r * dstep),
        sums.dwork_n + dgain_n,
        sums.dwork_t + (piece.dr * slid + r * dslid),
    )


def velocities_after(piece, at, step, dstep, stops):
    """Velocities after a piece; slip has stopped or has not been there if it `stops`."""
    vn = at.vn + piece.kn * step
    dvn = at.dvn + (piece.dkn * step + piece.kn * dstep)
    if stops:
        return Velocities(0.0, vn, 0.0, dvn)
    return Velocities(at.vt + piece.kt * step, vn, at.dvt + (piece.dkt * step + piece.kt * dstep), dvn)


def with_falling_gap(piece):
    """The piece of an impact without collision, in which v_n cannot rise until the slip stops."""
    return Piece(piece.turn, piece.kt, min(piece.kn, 0.0), piece.dr, piece.dturn, piece.dkt, piece.dkn)


def goal_of(body, blow, drest, dapproach, sums):
    """The goal of restitution after a compression; `dapproach` is the change of v_n before it."""
    rest = blow.rest
    target = -rest * blow.vn
    dtarget = -drest * blow.vn - rest * dapproach
    if body.law == POISSON:
        return Goal(target, rest * sums.p_n, dtarget, drest * sums.p_n + rest * sums.dp_n)
    dtodo = -rest * (2.0 * drest * sums.work_n + rest * sums.dwork_n)
    return Goal(target, -rest * rest * sums.work_n, dtarget, dtodo)


def goal_after(body, goal, piece, at, step, dstep):
    """The goal of restitution after a piece of it."""
    done, ddone = normal_work(piece, at, step, dstep)
    if body.law == POISSON:
        done, ddone = step, dstep
    return Goal(goal.target, goal.todo - done, goal.dtarget, goal.dtodo - ddone)


def begin_slip(body, arms, at):
    """(velocities, sums, reason) after the impulse that ends the slip dv_t with which v_t = 0 changes.

    The impact stops such a slip at once, or it goes the other way than the slip that the impact starts.
    """
    none = Sums(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    way = 1.0 if at.dvt > 0.0 else -1.0
    r, stick = impulse_ratio(body, arms.arm, arms.lever, at.vt)
    if not (stick or r * way > 0.0):
        return at, none, NONE
    against = -way * body.mu_k
    turn, kt, kn = slip_rates(body, arms.arm, arms.lever, against)
    step = -at.dvt / kt
    sums = Sums(0.0, 0.0, turn * step, step, against * step, at.vn * step, 0.0)
    return Velocities(at.vt, at.vn, 0.0, at.dvn + kn * step), sums, SIDED if way * kt < 0.0 else BORDER


@noinline
def impact_change(body, blow, dth, dvt, dvn, parameter_tangents, k):
    """Changes of what `impact` returns, and why there are none.

    Returns
    -------
    dvt, dvn, dspin, dp_n, dp_t, dloss_n, dloss_t : float
    reason : int
        NONE; SIDED where the change holds for this side only; else a Reason.
    """
    arms = arms_of(body, blow, dth, parameter_tangents, k)
    drest = parameter_tangents[REST, k] if blow.rest == body.rest else 0.0
    at = Velocities(blow.vt, blow.vn, dvt, dvn)
    sums = Sums(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    reason = NONE
    collision = blow.vn < 0.0
    compression = True
    goal = Goal(0.0, math.inf, 0.0, 0.0)
    if at.vt == 0.0 and dvt != 0.0 and not math.isinf(body.mu_k):
        at, sums, reason = begin_slip(body, arms, at)
    for _ in range(8):
        r, stick = impulse_ratio(body, arms.arm, arms.lever, at.vt)
        if math.isinf(r):
            at, sums = stop_slip(body, arms, at, sums)
            if at.vn > 0.0:
                break
            continue
        if at.vt == 0.0 and is_at_static_limit(body, arms):
            reason = BORDER
            break
        piece = piece_of(body, arms, r, stick, parameter_tangents[MU_K, k])
        if not collision and compression and not stick and piece.kn < 1e-9:
            piece = with_falling_gap(piece)
        step, dstep = impulse_to_stop(piece, at)
        length, dlength = impulse_to_end(body, compression, goal, piece, at)
        if length < math.inf and step < math.inf and abs(length - step) <= CLOSE * (length + step):
            reason = BORDER
        stops = not length <= step
        if not stops:
            step = length
            dstep = dlength
        sums = with_piece(sums, piece, r, at, step, dstep)
        if not compression:
            goal = goal_after(body, goal, piece, at, step, dstep)
        at = velocities_after(piece, at, step, dstep, stops or stick)
        if stops:
            continue
        if not compression:
            if body.law == NEWTON:
                at = Velocities(at.vt, at.vn, at.dvt, goal.dtarget)
            break
        at = Velocities(at.vt, 0.0, at.dvt, 0.0)
        if blow.rest == 0.0 or (body.law == NEWTON and not collision):
            if drest != 0.0 and (body.law != NEWTON or collision):
                reason = PLASTIC
            break
        compression = False
        goal = goal_of(body, blow, drest, dvn, sums)
    return at.dvt, at.dvn, sums.dspin, sums.dp_n, sums.dp_t, -sums.dwork_n, -sums.dwork_t, reason


@noinline
def closing_impulse_change(body, blow, dth, dvn, parameter_tangents, k):
    """Changes (dspin, dp_n, dp_t, dloss_n) by the impulse that pulls back a rim launched by infinite friction.

    `blow.vn` is v_n after the impact, and `dvn` its change.
    """
    arms = arms_of(body, blow, dth, parameter_tangents, k)
    vn = blow.vn
    r, turn, lift = stick_rates(body, arms.arm, arms.lever)
    dr, dturn, dlift = stick_changes(body, arms)
    p_n = -vn / lift
    dp_n = -(dvn + p_n * dlift) / lift
    return dturn * p_n + turn * dp_n, dp_n, dr * p_n + r * dp_n, -0.5 * (dvn * p_n + vn * dp_n)
