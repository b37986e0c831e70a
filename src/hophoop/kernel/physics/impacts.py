"""Impact (docs/model.md#impact): Routh's incremental impulse with Coulomb friction and three laws of restitution.

The normal impulse p grows from 0. While the slip keeps its state, both velocities are linear in p, so an
impact is at most two straight pieces (slip until it stops, then stick or reversed slip), and every integral
over it is elementary.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import noinline
from hophoop.kernel.physics.body import ImpactLaw
from hophoop.kernel.physics.contact import contact_arms, kappa_p_sigma_slope

NEWTON, POISSON = int(ImpactLaw.NEWTON), int(ImpactLaw.POISSON)


def stick_rates(body, arm, lever):
    """Return (r, dθ̇/dp, dv_n/dp) while the contact sticks; r is the tangential per normal impulse.

    Free of differences of large numbers, which 1/κ would make of W as κ → 0.
    """
    denominator = body.kap + arm * arm
    spin = lever / denominator
    return arm * spin, spin, 1.0 + lever * spin


def slip_rates(body, arm, lever, r):
    """Return (dθ̇/dp, dv_t/dp, dv_n/dp) while the contact slips with the impulses in the ratio r."""
    torque = lever - arm * r
    spin = torque / body.kap
    return spin, r - arm * spin, (body.kap + lever * torque) / body.kap


def stop_impulse(body, s, c, vn):
    """Return (change of θ̇, p_n, p_t, loss) of the impulse that stops a rim which infinite friction has launched with v_n."""
    arm, lever = contact_arms(body, s, c)
    r, turn, lift = stick_rates(body, arm, lever)
    p_n = -vn / lift
    return turn * p_n, p_n, r * p_n, -0.5 * vn * p_n


def impulse_ratio(body, arm, lever, vt):
    """Return (tangential per normal impulse in the present state, True if that state is stick)."""
    if vt > 0.0:
        return -body.mu_k, False
    if vt < 0.0:
        return body.mu_k, False
    stick = stick_rates(body, arm, lever)[0]
    if abs(stick) <= body.mu_s:
        return stick, True
    return (-body.mu_k if stick < 0.0 else body.mu_k), False


@noinline
def impact(body, rest, s, c, vt, vn):
    """Return (v_t, v_n, change of θ̇, p_n, p_t, losses −∫ v_n dP_n and −∫ v_t dP_t) after an impact with restitution `rest`.

    v_n = 0 before, with p_σ ≤ 0, is the impact without collision.
    """
    arm, lever = contact_arms(body, s, c)
    collision = vn < 0.0
    approach = vn
    spin = 0.0
    p_n = 0.0
    p_t = 0.0
    work_n = 0.0
    work_t = 0.0
    # Compression ends at v_n = 0, restitution when its own measure is used up.
    compression = True
    target = 0.0
    todo = math.inf
    for _ in range(8):
        r, stick = impulse_ratio(body, arm, lever, vt)
        if math.isinf(r):  # infinite friction stops the slip with a tangential impulse alone
            turned = arm * vt / (body.kap + arm * arm)
            p_side = -vt * body.kap / (body.kap + arm * arm)
            work_t += 0.5 * vt * p_side
            p_t += p_side
            spin += turned
            vn += lever * turned
            vt = 0.0
            if vn > 0.0:  # the tangential impulse alone lifts the hoop
                break
            continue
        kt = 0.0
        if stick:
            _, turn, kn = stick_rates(body, arm, lever)
        else:
            turn, kt, kn = slip_rates(body, arm, lever, r)
            if not collision and compression and kn < 1e-9:
                kn = min(kn, 0.0)  # not above 0: only the end of the slip lets v_n rise
        # piece: until the slip stops ...
        step = math.inf
        if vt != 0.0 and vt * kt < 0.0:
            step = -vt / kt
        stops = True
        # ... or the phase ends
        if compression:
            length = -vn / kn if kn > 0.0 else math.inf
        elif body.law == NEWTON:
            length = (target - vn) / kn if kn > 0.0 else math.inf
        elif body.law == POISSON:
            length = todo
        else:
            length = (-vn + math.sqrt(vn * vn + 2.0 * kn * todo)) / kn
        if length <= step:
            step = length
            stops = False
        gain_n = vn * step + 0.5 * kn * step * step
        work_n += gain_n
        work_t += r * (vt * step + 0.5 * kt * step * step)
        p_n += step
        p_t += r * step
        spin += turn * step
        if not compression:
            todo -= step if body.law == POISSON else gain_n
        vn += kn * step
        if stops:
            vt = 0.0
            continue
        vt = 0.0 if stick else vt + kt * step
        if not compression:
            if body.law == NEWTON:
                vn = target
            break
        vn = 0.0
        if rest == 0.0 or (body.law == NEWTON and not collision):
            break
        compression = False
        target = -rest * approach
        todo = rest * p_n if body.law == POISSON else -rest * rest * work_n
    return vt, vn, spin, p_n, p_t, -work_n, -work_t


def singular_slip(body, s, c, exact, ahead, vt, om, rho):
    """Return (True if it jams, v_t, θ̇, normal impulse, friction loss) of slip that has reached p_σ = 0 with f_n < 0 and N → ∞.

    It is an impulse at a fixed angle and v_n = 0, with which θ̇ and v_t change linearly. It ends when the slip stops; when θ̇ has
    reversed its sign, so that the motion leaves the angle on the curve θ̇²(θ) of its arrival; or, in a jam, when f_n reaches 0
    first. With rolling resistance it ends at θ̇ = 0, where the couple, and with it p_σ, changes.

    `exact` is True if the slip has reached p_σ = 0, `ahead` [rad] of (s, c), and not only come near it with f_n → 0. `rho` has
    the sign of θ̇.
    """
    sigma = 1.0 if vt > 0.0 else -1.0
    if exact:
        # p_σ = 0 makes q/κ = −1/(ε sin θ); from q only rounding would remain as κ → 0
        arm, lever = contact_arms(body, s + ahead * c, c - ahead * s)
        turn = -1.0 / lever
        rate = arm / lever - sigma * body.mu_k
    else:
        arm, lever = contact_arms(body, s, c)
        turn, rate, _ = slip_rates(body, arm, lever, -sigma * body.mu_k)
        if rho != 0.0:
            turn -= rho / body.kap
            rate += arm * rho / body.kap
    stop = -vt / rate if vt * rate < 0.0 else math.inf
    outward = body.eps * c
    if turn * om > 0.0:
        # θ̇² grows until f_n = 0
        limit = (math.copysign(math.sqrt(body.gn / outward), om) - om) / turn if outward > 0.0 else math.inf
        if limit <= stop:
            limit = max(limit, 0.0)
            after = vt + rate * limit
            loss = sigma * body.mu_k * 0.5 * (vt + after) * limit
            return True, after, om + turn * limit, limit, loss
        length = stop
    else:
        length = min(stop, (-2.0 if rho == 0.0 else -1.0) * om / turn)
    after = 0.0 if length == stop else vt + rate * length
    spin = 0.0 if rho != 0.0 and length < stop and turn * om <= 0.0 else om + turn * length
    return False, after, spin, length, sigma * body.mu_k * 0.5 * (vt + after) * length


def singular_angle(body, s, c, u, sigma, torque, distance):
    """Return (found, exact, ahead): whether κ p_σ is 0 to rounding of the angle, or nearly 0 together with f_n (the jam).

    `torque` and `distance` are q and κ p_σ.
    In the first case, the exact one, `ahead` is the angle to go, about 10⁻¹⁴ rad.
    """
    slope = kappa_p_sigma_slope(body, s, c, sigma, torque)
    if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):
        return True, True, -distance / slope
    opening = abs(body.gn - body.eps * c * u)
    near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)
    return near, False, 0.0
