"""The mode rule and Routh's impact, verified for the mode that a certificate claims.

They repeat `kernel.physics.modes` and `kernel.physics.impact` on purpose, derived once more in contact space: the checker
shares nothing with what made the certificate.
"""

from __future__ import annotations

from typing import Any

from hophoop.prove._flint import Ball, Jet, arb
from hophoop.prove.checker.conventions import GAIN_FLOOR
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.intervals import require

ORDER = 6
SIGMA = {"S": -1, "K": 1}


def sign(value: Ball, what: str) -> int:
    """Sign of a number, 0 where it is exactly zero; anything else is refused."""
    if value > 0 or value < 0:
        return 1 if value > 0 else -1
    require(bool(value.is_zero()), f"the sign of {what} is certain")
    return 0


def leading(jet: Jet, what: str) -> int:
    """Sign of the first coefficient that is not exactly zero."""
    return next((found for value in jet if (found := sign(value, what))), 0)


def opening(equations: Equations, state: State) -> int:
    """Sign of f_n, ties by free motion."""
    s, c = state.th.sin_cos()
    size, om = equations.eps * state.om * state.om, state.om
    return leading([size * c - equations.gn, -size * om * s, -size * om * om * c, size * om * om * om * s], "f_n")


def rolls(equations: Equations, state: State) -> bool:
    """Return True if rolling is admissible."""
    s, c = state.th.sin_cos()
    after = equations.just_after(state.th, state.om, 0)
    contact = after.contact(s, c, state.om * state.om, 0)
    margins = [contact.normal, *equations.margins(contact)]
    if all(bool(value > 0) for value in margins):
        return True
    if any(bool(value < 0) for value in margins):
        return False
    series = equations.in_time(state.th, state.om, 0, ORDER)
    if leading(series["normal"], "N in rolling") <= 0:
        return False
    if equations.mu_s is None:
        return True
    if equations.mu_s.is_zero() and not any(not value.is_zero() for value in series["friction"]):
        level = equations.gt.is_zero() and (
            equations.eps.is_zero() or after.held or (state.om.is_zero() and state.th.is_zero())
        )
        require(bool(level), "rolling without friction needs none")
    pairs = list(zip(series["normal"], series["friction"], strict=True))
    return all(leading([equations.mu_s * n + way * f for n, f in pairs], "a margin") >= 0 for way in (1, -1))


def slips(equations: Equations, state: State, sigma: int) -> bool:
    """Return True if slip can start from v_t = 0 in a direction."""
    s, c = state.th.sin_cos()
    contact = equations.just_after(state.th, state.om, sigma).contact(s, c, state.om * state.om, sigma)
    if sign(contact.divisor, "p_σ") <= 0:
        return False
    if contact.normal < 0 or sigma * contact.slip < 0:
        return False
    if contact.normal > 0 and sigma * contact.slip > 0:
        return True
    series = equations.in_time(state.th, state.om, sigma, ORDER)
    return leading(series["normal"], "N in slip") > 0 and sigma * leading(series["slip"], "v̇_t") > 0


def slip_zeros(equations: Equations, state: State, sigma: int) -> int:
    """The number of derivatives of v_t that vanish where slip begins, its value included."""
    if not state.vt.is_zero():
        return 0
    series = equations.in_time(state.th, state.om, sigma, ORDER)["slip"]
    return 1 + next((k for k, value in enumerate(series) if not value.is_zero()), 0)


def next_mode(equations: Equations, state: State) -> str:
    """R, S, K or H; 'inconsistent', 'indeterminate', 'undetermined'."""
    sigma = sign(state.vt, "v_t")
    if sigma == 0:
        if rolls(equations, state):
            return "R"
        if equations.mu_k is not None:
            ways = [letter for letter, way in SIGMA.items() if slips(equations, state, way)]
            require(len(ways) < 2, "slip can start in one direction only")
            if ways:
                return ways[0]
        return "H" if opening(equations, state) >= 0 else "undetermined"
    free = opening(equations, state)
    if equations.mu_k is None:
        return "H" if free >= 0 else "inconsistent"
    s, c = state.th.sin_cos()
    p_sigma = sign(equations.just_after(state.th, state.om, sigma).contact(s, c, arb(0), sigma).divisor, "p_σ")
    if p_sigma > 0:
        return ("K" if sigma > 0 else "S") if free < 0 else "H"
    if equations.resisted and (free < 0 or equations.strike):
        without_couple = sign(equations.contact(s, c, arb(0), sigma).divisor, "p_σ")
        if without_couple > 0:
            return "undetermined"  # an impact, which is without rolling resistance, would change nothing
    if free < 0:
        return "inconsistent"
    return "indeterminate" if p_sigma < 0 else "H"


def collide(equations: Equations, state: State, rest: Ball) -> tuple[State, bool]:
    """(state after an impact, whether energy is created): Routh's impulse in contact space."""
    s, c = state.th.sin_cos()
    w_tt, w_nn, w_tn = (value / equations.kap for value in equations.delassus(s, c))
    vt, vn, total_n, total_t = state.vt, state.vn, arb(0), arb(0)
    work_n = work_t = arb(0)
    goal: Any = None  # of restitution
    done = False
    for _ in range(8):
        way = sign(vt, "v_t in an impact")
        hold = -w_tn / w_tt
        sticks = way == 0 and (equations.mu_s is None or sign(equations.mu_s - abs(hold), "the friction of an impact") >= 0)
        if not sticks and equations.mu_k is None:
            side = -vt / w_tt
            work_t, total_t, vn, vt = work_t + vt * side / 2, total_t + side, vn + w_tn * side, arb(0)
            if sign(vn, "v_n after the slip") > 0:
                done = True
                break
            continue
        if sticks:
            ratio = hold
        else:
            ratio = -way * equations.mu_k if way else sign(hold, "the friction of an impact") * equations.mu_k
        along, up = w_tn + w_tt * ratio, w_nn + w_tn * ratio
        if sticks:
            along = arb(0)
        stop = -vt / along if way and sign(along, "dv_t/dp") == -way else None
        end = _end(equations, vn, up, goal)
        stops = stop is not None and (end is None or _before(stop, end))
        length = stop if stops else end
        if length is None:
            raise Refused("an impact ends")
        rise = length * (vn + up * length / 2)
        work_n, work_t = work_n + rise, work_t + ratio * length * (vt + along * length / 2)
        total_n, total_t = total_n + length, total_t + ratio * length
        vn, vt = vn + up * length, arb(0) if stops or sticks else vt + along * length
        if goal is not None:
            goal -= {"poisson": length, "stronge": rise}.get(equations.law, arb(0))
        if stops:
            continue
        if goal is not None:
            vn = goal if equations.law == "newton" else vn
            done = True
            break
        vn = arb(0)
        if rest.is_zero() or (equations.law == "newton" and state.vn.is_zero()):
            done = True
            break
        goal = {"newton": -rest * state.vn, "poisson": rest * total_n}.get(equations.law, -rest * rest * work_n)
    require(done, "an impact ends")
    lever, arm = equations.eps * s, 1 + equations.eps * c
    om = state.om + (lever * total_n - arm * total_t) / equations.kap
    excess = work_n + work_t - arb(GAIN_FLOOR) * (abs(work_n) + abs(work_t) + state.vn * state.vn)
    gains = sign(excess, "the energy that an impact creates") > 0
    return State(state.t, state.x, arb(0), state.th, vt, vn, om), gains


def _end(equations: Equations, vn: Ball, up: Ball, goal: Any) -> Ball | None:
    """Normal impulse to the end of compression, or of restitution by its law; None where there is none."""
    rises = sign(up, "dv_n/dp") > 0
    if goal is None:
        return -vn / up if rises else None
    if equations.law == "newton":
        return (goal - vn) / up if rises else None
    if equations.law == "poisson":
        return goal
    return 2 * goal / (vn + (vn * vn + 2 * up * goal).sqrt())


def _before(a: Ball, b: Ball) -> bool:
    require(bool(a < b) or bool(b < a), "the order of what happens in an impact is certain")
    return bool(a < b)
