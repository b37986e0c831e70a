"""Impact (docs/model.md#impact) for numbers of any kind: arbitrary precision here, balls in `hophoop.prove`.

Over the normal impulse p both velocities are straight lines while the slip keeps its state. An impact has three pieces at
most: slip until it stops, stick or reversed slip, and the end of compression in any of them.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from hophoop.kernel.physics.body import ImpactLaw

Number = Any
MOST_PIECES = 8


class Numbers(Protocol):
    """The decisions that depend on the kind of numbers."""

    @property
    def zero(self) -> Number:
        """0."""

    def sign(self, value: Number, what: str) -> int:
        """Return the sign of a number as it is."""

    def judged_sign(self, value: Number, scale: Number, what: str) -> int:
        """Return the sign of a number that is 0 if it is small relative to `scale`."""

    def order(self, one: Number, other: Number) -> int:
        """Return the sign of one − other for two impulses."""

    def is_zero(self, value: Number) -> bool:
        """Return True if a number is exactly 0."""

    def sqrt(self, value: Number) -> Number:
        """Return the square root."""

    def endless(self) -> Exception:
        """Return the error of an impact that does not end."""


class Contact(NamedTuple):
    """Body and plane at the angle of the impact; a coefficient of friction is None if it is infinite."""

    tangential_arm: Number  # 1 + ε cos θ
    normal_arm: Number  # ε sin θ
    kap: Number
    mu_s: Number
    mu_k: Number
    law: int


class Blow(NamedTuple):
    """Velocities after the impact, the change of θ̇, the impulses, and the works ∫ v dP."""

    vt: Number
    vn: Number
    spin: Number
    p_n: Number
    p_t: Number
    work_n: Number
    work_t: Number


class Restitution(NamedTuple):
    """The end of restitution: v_n there, and the impulse or the work that remains."""

    target: Number
    todo: Number


def impact(contact: Contact, numbers: Numbers, rest: Number, vt: Number, vn: Number) -> Blow:
    """Follow Routh's impact; with vn = 0 it is the impact without collision.

    Parameters
    ----------
    contact : Contact
    numbers : Numbers
    rest : number
        Restitution e.
    vt, vn : number
        Slip and separation velocity before.

    Returns
    -------
    blow : Blow
    """
    arm, lever, zero = contact.tangential_arm, contact.normal_arm, numbers.zero
    denominator = contact.kap + arm * arm
    hold = arm * lever / denominator  # tangential over normal impulse that keeps v_t
    collision, approach = not numbers.is_zero(vn), vn
    spin = p_n = p_t = work_n = work_t = zero
    goal = None  # of restitution; None in compression
    for _ in range(MOST_PIECES):
        slip = numbers.sign(vt, "v_t in an impact")
        stick = slip == 0 and _sticks(contact, numbers, hold)
        if contact.mu_k is None and not stick:  # infinite friction stops the slip with a tangential impulse alone
            turned, side = arm * vt / denominator, -vt * contact.kap / denominator
            work_t, p_t, spin, vn = work_t + vt * side / 2, p_t + side, spin + turned, vn + lever * turned
            vt = zero
            if numbers.judged_sign(vn, abs(vn) + abs(approach) + 1, "v_n after the slip was stopped") > 0:
                break
            continue
        if stick:
            ratio, turn, rate_t = hold, lever / denominator, zero
        else:
            ratio = (-slip if slip else numbers.sign(hold, "the friction that an impact needs")) * contact.mu_k
            turn = (lever - arm * ratio) / contact.kap
            rate_t = ratio - arm * turn
        rate_n = 1 + lever * turn
        to_end = _to_end(contact, numbers, vn, rate_n, goal)
        to_stop = -vt / rate_t if slip and numbers.sign(rate_t, "dv_t/dp in an impact") * slip < 0 else None
        after = _order(numbers, to_end, to_stop)  # above 0 if the slip stops first
        length = to_stop if after > 0 else to_end
        gain_n = length * (vn + rate_n * length / 2)
        work_n, work_t = work_n + gain_n, work_t + ratio * length * (vt + rate_t * length / 2)
        p_n, p_t, spin = p_n + length, p_t + ratio * length, spin + turn * length
        if goal is not None:
            goal = Restitution(goal.target, goal.todo - (length if contact.law == ImpactLaw.POISSON else gain_n))
        vn = vn + rate_n * length
        vt = zero if stick or after >= 0 else vt + rate_t * length
        if after > 0:
            continue
        if goal is not None:
            vn = goal.target if contact.law == ImpactLaw.NEWTON else vn
            break
        vn = zero
        if numbers.is_zero(rest) or (contact.law == ImpactLaw.NEWTON and not collision):
            break
        goal = Restitution(-rest * approach, rest * p_n if contact.law == ImpactLaw.POISSON else -rest * rest * work_n)
    return Blow(vt, vn, spin, p_n, p_t, work_n, work_t)


def _sticks(contact: Contact, numbers: Numbers, hold: Number) -> bool:
    """Return True if static friction keeps v_t = 0."""
    if contact.mu_s is None:
        return True
    return numbers.judged_sign(contact.mu_s - abs(hold), 1 + contact.mu_s, "the friction that an impact needs") >= 0


def _to_end(contact: Contact, numbers: Numbers, vn: Number, rate_n: Number, goal: Restitution | None) -> Number | None:
    """Return the impulse until compression or restitution ends, None if this piece does not end it."""
    rises = numbers.sign(rate_n, "dv_n/dp in an impact") > 0
    if goal is None:
        return -vn / rate_n if rises else None
    if contact.law == ImpactLaw.NEWTON:
        return (goal.target - vn) / rate_n if rises else None
    if contact.law == ImpactLaw.POISSON or numbers.is_zero(goal.todo):
        return goal.todo
    return 2 * goal.todo / (vn + numbers.sqrt(vn * vn + 2 * rate_n * goal.todo))


def _order(numbers: Numbers, to_end: Number | None, to_stop: Number | None) -> int:
    """Return the sign of to_end − to_stop, where None is infinite."""
    if to_end is None:
        if to_stop is None:
            raise numbers.endless()
        return 1
    return -1 if to_stop is None else numbers.order(to_end, to_stop)
