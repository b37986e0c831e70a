"""Impacts and the mode rule of docs/model.md: every inequality shown, ties by the first derivative that is not zero.

A quantity is in a tie only where it is zero exactly: an enclosure that merely contains zero decides nothing.
"""

from __future__ import annotations

from typing import NamedTuple

from hophoop.kernel.physics.body import ImpactLaw, Mode
from hophoop.prove._flint import Ball, Jet, Undecided, arb, sign
from hophoop.prove.model import Model, State, Still

TIE_ORDER = 6
INCONSISTENT, INDETERMINATE, UNDETERMINED = 10, 11, 12


def slip_mode(sigma: int) -> int:
    """Skid for sliding ahead (v_t > 0), spin for over-rotating."""
    return int(Mode.SKID if sigma > 0 else Mode.SPIN)


def leading(jet: Jet, what: str) -> int:
    """Sign of the first coefficient that is not exactly zero."""
    for value in jet:
        found = sign(value, what)
        if found:
            return found
    return 0


def free_opening(model: Model, th: Ball, om: Ball) -> Ball:
    """f_n."""
    return model.eps * th.cos() * om * om - model.gn


def opening_sign(model: Model, state: State) -> int:
    """Sign of f_n, or of its first derivative in free motion that is not zero."""
    s, c = state.th.sin_cos()
    turned = model.eps * state.om * state.om
    om = state.om
    jet = [turned * c - model.gn, -turned * s * om, -turned * c * om * om, turned * s * om * om * om]
    return leading(jet, "f_n")


def can_roll(model: Model, state: State) -> bool:
    """Whether rolling from here has N > 0 and abs(F) ≤ μs N, now or, in a tie, just after."""
    model = model.after(state.th, state.om, 0)
    s, c = state.th.sin_cos()
    forces = model.rolling(s, c, state.om * state.om)
    normal = sign(forces.normal, "N in rolling") if not _tied(forces.normal) else 0
    if normal < 0:
        return False
    if normal > 0 and model.mu_s is None:
        return True
    if model.mu_s is not None and normal > 0:
        below, above = model.mu_s * forces.normal - forces.friction, model.mu_s * forces.normal + forces.friction
        if below > 0 and above > 0:
            return True
        if below < 0 or above < 0:
            return False
        if not (_tied(below) or _tied(above)):
            raise Undecided("whether the friction suffices to roll is not certain")
    normals, frictions, _, _ = model.candidate(state.th, state.om, 0, TIE_ORDER)
    if leading(normals, "N in rolling") <= 0:
        return False
    if model.mu_s is None:
        return True
    margins = [[model.mu_s * n + way * f for n, f in zip(normals, frictions, strict=True)] for way in (1, -1)]
    signs = [leading(margin, "the margin of friction in rolling") for margin in margins]
    if 0 in signs and model.mu_s.is_zero() and not _identically_free(model, state):
        raise Undecided("rolling without friction is in a tie of high order")
    return min(signs) >= 0


def _tied(value: Ball) -> bool:
    return bool(value.is_zero())


def _identically_free(model: Model, state: State) -> bool:
    """Whether rolling needs no friction at all: without gravity along the plane, at rest in equilibrium or balanced."""
    balanced = model.eps.is_zero() or isinstance(model, Still) or (state.om.is_zero() and state.th.is_zero())
    return bool(model.gt.is_zero() and balanced)


def can_start_slip(model: Model, state: State, sigma: int) -> bool:
    """Whether slip of direction σ can start from v_t = 0: N > 0 and σ v̇_t > 0."""
    model = model.after(state.th, state.om, sigma)
    s, c = state.th.sin_cos()
    if sign(model.stiffness(s, c, sigma), "p_σ") <= 0:
        return False
    forces = model.slipping(s, c, state.om * state.om, sigma)
    load, slip = forces.load, sigma * forces.slip
    if load < 0 or slip < 0:
        return False
    if load > 0 and slip > 0:
        return True
    if not ((_tied(load) or load > 0) and (_tied(slip) or slip > 0)):
        raise Undecided("whether slip can start is not certain")
    normals, _, slips, _ = model.candidate(state.th, state.om, sigma, TIE_ORDER)
    return leading(normals, "N in slip") > 0 and sigma * leading(slips, "v̇_t") > 0


def next_mode(model: Model, state: State) -> int:
    """Mode that follows a state in contact (y = 0, v_n = 0): rules 1, 3 and 4."""
    sigma = sign(state.vt, "v_t")
    if sigma == 0:
        if can_roll(model, state):
            return int(Mode.ROLL)
        if model.mu_k is not None:
            for way in (-1, 1):
                if can_start_slip(model, state, way):
                    return slip_mode(way)
        return int(Mode.FLIGHT) if opening_sign(model, state) >= 0 else UNDETERMINED
    opening = opening_sign(model, state)
    if model.mu_k is None:
        return int(Mode.FLIGHT) if opening >= 0 else INCONSISTENT
    s, c = state.th.sin_cos()
    firm = sign(model.after(state.th, state.om, sigma).stiffness(s, c, sigma), "p_σ")
    if firm > 0:
        return slip_mode(sigma) if opening < 0 else int(Mode.FLIGHT)
    if model.resisted and sign(model.stiffness(s, c, sigma), "p_σ") > 0 and (opening < 0 or model.problem.strike):
        return UNDETERMINED  # an impact, which is without rolling resistance, would change nothing
    if opening < 0:
        return INCONSISTENT
    return INDETERMINATE if firm < 0 else int(Mode.FLIGHT)


class Blow(NamedTuple):
    """What an impact does: velocities after it, the change of θ̇, impulses, and the energy that it adds."""

    vt: Ball
    vn: Ball
    spin: Ball
    p_n: Ball
    p_t: Ball
    gain: Ball
    size: Ball


def impact(model: Model, rest: Ball, state: State) -> Blow:
    """Routh's impact, every branch taken by a sign that is certain."""
    s, c = state.th.sin_cos()
    arm, lever = 1 + model.eps * c, model.eps * s
    firm = model.kap + arm * arm
    hold = arm * lever / firm
    law = model.problem.law
    vt, vn = state.vt, state.vn
    collision, approach = not vn.is_zero(), vn
    spin = p_n = p_t = work_n = work_t = arb(0)
    compression = True
    todo = target = arb(0)
    for _ in range(8):
        sigma = sign(vt, "v_t in an impact")
        stick = sigma == 0 and (model.mu_s is None or sign(model.mu_s - abs(hold), "the friction that an impact needs") >= 0)
        if model.mu_k is None and not stick:  # infinite friction stops the slip with a tangential impulse alone
            turned, side = arm * vt / firm, -vt * model.kap / firm
            work_t, p_t, spin, vn = work_t + vt * side / 2, p_t + side, spin + turned, vn + lever * turned
            vt = arb(0)
            if sign(vn, "v_n after the slip was stopped") > 0:
                break
            continue
        if stick:
            ratio, turn, rate_t = hold, lever / firm, arb(0)
        else:
            way = sigma if sigma else sign(hold, "the friction that an impact needs")
            ratio = -way * model.mu_k if sigma else way * model.mu_k
            turn = (lever - arm * ratio) / model.kap
            rate_t = ratio - arm * turn
        rate_n = 1 + lever * turn
        rises = sign(rate_n, "dv_n/dp in an impact") > 0
        to_stop = -vt / rate_t if sigma and sign(rate_t, "dv_t/dp in an impact") * sigma < 0 else None
        if compression:
            to_end = -vn / rate_n if rises else None
        elif law == ImpactLaw.NEWTON:
            to_end = (target - vn) / rate_n if rises else None
        elif law == ImpactLaw.POISSON:
            to_end = todo
        else:
            to_end = 2 * todo / (vn + (vn * vn + 2 * rate_n * todo).sqrt())
        stops = _stops_first(to_stop, to_end)
        length = to_stop if stops else to_end
        gain_n = length * (vn + rate_n * length / 2)
        work_n, work_t = work_n + gain_n, work_t + ratio * length * (vt + rate_t * length / 2)
        p_n, p_t, spin = p_n + length, p_t + ratio * length, spin + turn * length
        if not compression:
            todo = todo - (length if law == ImpactLaw.POISSON else gain_n)
        vn = vn + rate_n * length
        if stops:
            vt = arb(0)
            continue
        vt = arb(0) if stick else vt + rate_t * length
        if not compression:
            vn = target if law == ImpactLaw.NEWTON else vn
            break
        vn = arb(0)
        if rest.is_zero() or (law == ImpactLaw.NEWTON and not collision):
            break
        compression = False
        target = -rest * approach
        todo = rest * p_n if law == ImpactLaw.POISSON else -rest * rest * work_n
    return Blow(vt, vn, spin, p_n, p_t, work_n + work_t, abs(work_n) + abs(work_t) + state.vn * state.vn)


def _stops_first(to_stop: Ball | None, to_end: Ball | None) -> bool:
    if to_end is None:
        if to_stop is None:
            raise Undecided("an impact does not end")
        return True
    if to_stop is None or to_end < to_stop:
        return False
    if to_stop < to_end:
        return True
    raise Undecided("slip stops in an impact as a part of it ends, as far as can be told")
