"""The derivative of an impact in one direction: Routh's impulse, differentiated in the branch that it takes.

It follows `physics.impact` line by line; names with a leading d are what changes.
"""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EPS, KAP, MU_K, REST, Reason
from hophoop.kernel.native import apart
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import NEWTON, POISSON, impulse_ratio, slip_rates, stick_rates

NONE, BORDER, PLASTIC, SIDED = int(Reason.NONE), int(Reason.BORDER), int(Reason.PLASTIC), -1
CLOSE = 1e-10  # beside its natural size: nearer to zero a quantity that decides may have either sign


def stick_changes(body, arm, lever, darm, dlever, dkap):
    """Changes of `stick_rates`."""
    firm = body.kap + arm * arm
    spin = lever / firm
    dspin = (dlever - spin * (dkap + 2.0 * arm * darm)) / firm
    return darm * spin + arm * dspin, dspin, dlever * spin + lever * dspin


def slip_changes(body, arm, lever, r, darm, dlever, dkap, dr):
    """Changes of `slip_rates`."""
    spin = (lever - arm * r) / body.kap
    dspin = (dlever - darm * r - arm * dr - spin * dkap) / body.kap
    return dspin, dr - darm * spin - arm * dspin, dlever * spin + lever * dspin


@apart
def impact_change(body, rest, s, c, vt, vn, dth, dvt, dvn, changes, k):
    """Changes of what `impact` returns, and why there are none.

    Returns
    -------
    dvt, dvn, dspin, dp_n, dp_t, dloss_n, dloss_t : float
    reason : int
        NONE; SIDED where the change holds for this side only; else a Reason.
    """
    arm, lever = contact_arms(body, s, c)
    dkap = changes[KAP, k]
    darm = changes[EPS, k] * c - body.eps * s * dth
    dlever = changes[EPS, k] * s + body.eps * c * dth
    drest = changes[REST, k] if rest == body.rest else 0.0
    reason = NONE
    collision = vn < 0.0
    approach = vn
    dapproach = dvn
    p_n = work_n = 0.0
    dspin = dp_n = dp_t = dwork_n = dwork_t = 0.0
    compression = True
    target = 0.0
    dtarget = 0.0
    todo = math.inf
    dtodo = 0.0
    if vt == 0.0 and dvt != 0.0 and not math.isinf(body.mu_k):
        # a slip that the impact stops at once, or that goes the other way than the one that it starts
        way = 1.0 if dvt > 0.0 else -1.0
        r, stick = impulse_ratio(body, arm, lever, vt)
        if stick or r * way > 0.0:
            against = -way * body.mu_k
            turn, kt, kn = slip_rates(body, arm, lever, against)
            reason = SIDED if way * kt < 0.0 else BORDER
            step = -dvt / kt
            dspin += turn * step
            dp_n += step
            dp_t += against * step
            dwork_n += vn * step
            dvn += kn * step
            dvt = 0.0
    for _ in range(8):
        r, stick = impulse_ratio(body, arm, lever, vt)
        if math.isinf(r):
            firm = body.kap + arm * arm
            dfirm = dkap + 2.0 * arm * darm
            turned = arm * vt / firm
            dturned = (darm * vt + arm * dvt - turned * dfirm) / firm
            p_side = -vt * body.kap / firm
            dp_side = (-dvt * body.kap - vt * dkap - p_side * dfirm) / firm
            dwork_t += 0.5 * (dvt * p_side + vt * dp_side)
            dp_t += dp_side
            dspin += dturned
            vn += lever * turned
            dvn += dlever * turned + lever * dturned
            vt = 0.0
            dvt = 0.0
            if vn > 0.0:
                break
            continue
        kt = 0.0
        dkt = 0.0
        if stick:
            _, turn, kn = stick_rates(body, arm, lever)
            dr, dturn, dkn = stick_changes(body, arm, lever, darm, dlever, dkap)
        else:
            dr = -changes[MU_K, k] if r < 0.0 else changes[MU_K, k]
            turn, kt, kn = slip_rates(body, arm, lever, r)
            dturn, dkt, dkn = slip_changes(body, arm, lever, r, darm, dlever, dkap, dr)
        if vt == 0.0 and not math.isinf(body.mu_s):
            steady = stick_rates(body, arm, lever)[0]
            if abs(abs(steady) - body.mu_s) <= CLOSE * (1.0 + body.mu_s) and body.mu_s > 0.0:
                return dvt, dvn, dspin, dp_n, dp_t, -dwork_n, -dwork_t, BORDER
        if not collision and compression and not stick and kn < 1e-9:
            kn = min(kn, 0.0)
        step = math.inf
        dstep = 0.0
        if vt != 0.0 and vt * kt < 0.0:
            step = -vt / kt
            dstep = -(dvt + step * dkt) / kt
        stops = True
        dlength = 0.0
        if compression:
            length = -vn / kn if kn > 0.0 else math.inf
            if kn > 0.0:
                dlength = -(dvn + length * dkn) / kn
        elif body.law == NEWTON:
            length = (target - vn) / kn if kn > 0.0 else math.inf
            if kn > 0.0:
                dlength = (dtarget - dvn - length * dkn) / kn
        elif body.law == POISSON:
            length = todo
            dlength = dtodo
        else:
            root = math.sqrt(vn * vn + 2.0 * kn * todo)
            length = (-vn + root) / kn
            dlength = (dtodo - length * dvn - 0.5 * length * length * dkn) / root
        if length < math.inf and step < math.inf and abs(length - step) <= CLOSE * (length + step):
            reason = BORDER
        if length <= step:
            step = length
            dstep = dlength
            stops = False
        gain_n = vn * step + 0.5 * kn * step * step
        dgain_n = dvn * step + vn * dstep + 0.5 * dkn * step * step + kn * step * dstep
        slid = vt * step + 0.5 * kt * step * step
        dslid = dvt * step + vt * dstep + 0.5 * dkt * step * step + kt * step * dstep
        work_n += gain_n
        dwork_n += dgain_n
        dwork_t += dr * slid + r * dslid
        p_n += step
        dp_n += dstep
        dp_t += dr * step + r * dstep
        dspin += dturn * step + turn * dstep
        if not compression:
            todo -= step if body.law == POISSON else gain_n
            dtodo -= dstep if body.law == POISSON else dgain_n
        vn += kn * step
        dvn += dkn * step + kn * dstep
        if stops:
            vt = 0.0
            dvt = 0.0
            continue
        if stick:
            vt = 0.0
            dvt = 0.0
        else:
            vt += kt * step
            dvt += dkt * step + kt * dstep
        if not compression:
            if body.law == NEWTON:
                vn = target
                dvn = dtarget
            break
        vn = 0.0
        dvn = 0.0
        if rest == 0.0 or (body.law == NEWTON and not collision):
            if drest != 0.0 and (body.law != NEWTON or collision):
                reason = PLASTIC
            break
        compression = False
        target = -rest * approach
        dtarget = -drest * approach - rest * dapproach
        if body.law == POISSON:
            todo = rest * p_n
            dtodo = drest * p_n + rest * dp_n
        else:
            todo = -rest * rest * work_n
            dtodo = -rest * (2.0 * drest * work_n + rest * dwork_n)
    return dvt, dvn, dspin, dp_n, dp_t, -dwork_n, -dwork_t, reason


@apart
def pulled_back(body, s, c, vn, dth, dvn, changes, k):
    """Changes (dspin, dp_n, dp_t, dloss_n) by the impulse that pulls back a rim thrown up by infinite friction.

    `vn` is v_n after the impact, and `dvn` its change.
    """
    arm, lever = contact_arms(body, s, c)
    darm = changes[EPS, k] * c - body.eps * s * dth
    dlever = changes[EPS, k] * s + body.eps * c * dth
    r, turn, lift = stick_rates(body, arm, lever)
    dr, dturn, dlift = stick_changes(body, arm, lever, darm, dlever, changes[KAP, k])
    p_n = -vn / lift
    dp_n = -(dvn + p_n * dlift) / lift
    return dturn * p_n + turn * dp_n, dp_n, dr * p_n + r * dp_n, -0.5 * (dvn * p_n + vn * dp_n)
