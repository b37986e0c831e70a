"""The mode rule of docs/model.md, with every tie decided by the first derivative that is not zero."""

from __future__ import annotations

from typing import NamedTuple

from hophoop.kernel.physics.body import Mode
from hophoop.precise.impact import Contact
from hophoop.precise.phases import expand
from hophoop.precise.problem import Body, Number, PreciseState
from hophoop.precise.series import Judge, Series

# Answers of the rule beyond the modes.
INCONSISTENT, INDETERMINATE, UNDECIDED = 10, 11, 12
TIE_ORDER = 10  # terms of a candidate motion's series


def slip_mode(sigma: int) -> Mode:
    """Skid for sliding ahead (v_t > 0), spin for over-rotating."""
    return Mode.SKID if sigma > 0 else Mode.SPIN


def direction(mode: int) -> int:
    """σ = sign(v_t) of a slip mode, 0 of any other."""
    return {Mode.SKID: 1, Mode.SPIN: -1}.get(Mode(mode), 0)


def sign(body: Body, judge: Judge, value: Number, scale: Number) -> int:
    """Sign of a number relative to its natural size."""
    with body.ctx.workprec(body.bits + 10):
        return judge.sign(body.integer(value), max(body.integer(abs(scale)), 1))


def free_opening(body: Body, th: Number, om: Number) -> Number:
    """f_n: acceleration of the lowest point off the plane without contact force."""
    return -body.gn + body.eps * body.ctx.cos(th) * om * om


def stiffness(body: Body, th: Number, sigma: int, rho: Number) -> Number:
    """κ p_σ = κ + ε sin θ (ε sin θ + σ μ (1 + ε cos θ) − ρ)."""
    cosine, sine = body.ctx.cos_sin(th)
    return body.kap + body.eps * sine * (body.eps * sine + sigma * body.mu_k * (1 + body.eps * cosine) - rho)


def turning_acceleration(body: Body, th: Number, om: Number, sigma: int) -> Number:
    """θ̈ in rolling (sigma = 0) or slip."""
    cosine, sine = body.ctx.cos_sin(th)
    eps, u = body.eps, om * om
    rho = body.resistance(th, om, sigma)
    if sigma == 0:
        torque = eps * sine * (u + body.gn) + body.gt * (1 + eps * cosine) - rho * (body.gn - eps * cosine * u)
        return torque / (1 + body.kap + eps * eps + eps * (2 * cosine - rho * sine))
    arm = eps * sine + sigma * body.mu_k * (1 + eps * cosine) - rho
    return arm * (body.gn - eps * cosine * u) / (body.kap + eps * sine * arm)


def opening_sign(body: Body, judge: Judge, th: Number, om: Number) -> int:
    """Sign of f_n, or of its first derivative in free motion that is not zero; θ̇ stays what it is."""
    cosine, sine = body.ctx.cos_sin(th)
    u = om * om
    centrifugal = body.eps * u
    scale = body.gn + centrifugal
    if scale == 0:
        return 0
    # f_n = −g + ε u cos(θ + θ̇ τ): with τ in units of 1/θ̇ its derivatives are ε u times −sin, −cos, sin, …
    way = 1 if om > 0 else -1
    for value in (centrifugal * cosine - body.gn, -centrifugal * sine * way, -centrifugal * cosine, centrifugal * sine * way):
        found = sign(body, judge, value, scale)
        if found or centrifugal == 0:
            return found
    return 0


def tie_exponent(om: Number) -> int:
    """Step of a candidate's series: its terms do not grow."""
    return -2 - max(int(abs(om)).bit_length(), 0)


def can_roll(body: Body, judge: Judge, state: PreciseState) -> bool:
    """Return True if rolling from here has N > 0 and abs(F) ≤ μs N, now or, in a tie, just after."""
    step = expand(body, 0, state, tie_exponent(state.om), TIE_ORDER)
    if step is None:
        return False
    scale = body.integer(body.gn + abs(body.gt) + state.om * state.om)
    if scale == 0:
        return False
    if judge.leading(step.normal, scale)[1] <= 0:
        return False
    if body.fixed.mu_s is None:
        return True
    return all(judge.leading(margin, scale)[1] >= 0 for margin in cone_margins(body, step.normal, step.friction))


def cone_margins(body: Body, normal: Series, friction: Series) -> list[list[int]]:
    """(μs N − F, μs N + F), over √(1 + μs²) so that neither part outweighs the other; N where μ is infinite."""
    if body.fixed.mu_s is None:
        return [list(normal)]
    bits, ctx = body.bits, body.ctx
    norm = ctx.sqrt(1 + body.mu_s * body.mu_s)
    a, b = body.integer(body.mu_s / norm), body.integer(1 / norm)
    pairs = list(zip(normal, friction, strict=True))
    return [[(a * n - b * f) >> bits for n, f in pairs], [(a * n + b * f) >> bits for n, f in pairs]]


def can_start_slip(body: Body, judge: Judge, state: PreciseState, sigma: int) -> bool:
    """Return True if slip of direction σ can start from v_t = 0: N > 0 and σ v̇_t > 0."""
    rho = body.resistance(state.th, state.om, sigma)
    if sign(body, judge, stiffness(body, state.th, sigma, rho), 1 + body.mu_k) <= 0:
        return False
    step = expand(body, sigma, state, tie_exponent(state.om), TIE_ORDER)
    if step is None:
        return False
    scale = body.integer(body.gn + abs(body.gt) + state.om * state.om)
    if scale == 0 or judge.leading(step.normal, scale)[1] <= 0:
        return False
    return judge.leading(step.slip, scale, 1)[1] == sigma


def next_mode(body: Body, judge: Judge, state: PreciseState) -> int:
    """Mode that follows a state in contact (y = 0, v_n = 0): rules 1, 3 and 4."""
    vt = state.vt
    sigma = 0 if vt == 0 else sign(body, judge, vt, 1 + abs(state.om))
    if sigma == 0:
        if can_roll(body, judge, state):
            return Mode.ROLL
        if body.fixed.mu_k is not None:
            for way in (-1, 1):
                if can_start_slip(body, judge, state, way):
                    return slip_mode(way)
        # μ = ∞: rolling would need to pull and free motion would enter the plane
        return Mode.FLIGHT if opening_sign(body, judge, state.th, state.om) >= 0 else UNDECIDED
    opening = opening_sign(body, judge, state.th, state.om)
    if body.fixed.mu_k is None:  # infinite friction stops any slip at once
        return Mode.FLIGHT if opening >= 0 else INCONSISTENT
    rho = body.resistance(state.th, state.om, sigma)
    p_sigma = sign(body, judge, stiffness(body, state.th, sigma, rho), 1 + body.mu_k)
    if p_sigma > 0:
        return slip_mode(sigma) if opening < 0 else Mode.FLIGHT
    if rho != 0 and stiffness(body, state.th, sigma, body.zero) > 0 and (opening < 0 or body.problem.painleve_impact):
        return UNDECIDED  # an impact, which is without rolling resistance, would change nothing
    if opening < 0:
        return INCONSISTENT
    return INDETERMINATE if p_sigma < 0 else Mode.FLIGHT


class Judged(NamedTuple):
    """Numbers of a working precision, as `impact` decides upon them."""

    body: Body
    judge: Judge

    @property
    def zero(self) -> Number:
        """0."""
        return self.body.zero

    def sign(self, value: Number, what: str) -> int:
        """Return the sign of a number as it is."""
        return int(value > 0) - int(value < 0)

    def judged_sign(self, value: Number, scale: Number, what: str) -> int:
        """Return the sign of a number relative to its natural size."""
        return sign(self.body, self.judge, value, scale)

    def order(self, one: Number, other: Number) -> int:
        """Return the sign of one − other relative to their sum."""
        return sign(self.body, self.judge, one - other, one + other) if one + other else 0

    def is_zero(self, value: Number) -> bool:
        """Return True if a number is exactly 0."""
        return bool(value == 0)

    def sqrt(self, value: Number) -> Number:
        """Return the square root."""
        return self.body.ctx.sqrt(value)

    def endless(self) -> Exception:
        """Return the error of an impact that does not end."""
        return ArithmeticError("an impact does not end.")


def contact_at(body: Body, th: Number) -> Contact:
    """Body and plane as `impact` takes them."""
    cosine, sine = body.ctx.cos_sin(th)
    mu_s = None if body.fixed.mu_s is None else body.mu_s
    mu_k = None if body.fixed.mu_k is None else body.mu_k
    return Contact(1 + body.eps * cosine, body.eps * sine, body.kap, mu_s, mu_k, body.problem.law)
