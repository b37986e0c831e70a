"""Taylor series of rolling, slip and flight, from the equations of docs/model.md.

Each step is a series in s = τ/h with h a power of two. Order by order, the products of series already known give
the next coefficient of θ̈; what the events need (margins to the friction cone, normal force, slip velocity, gap) comes
out on the way.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from operator import mul

from hophoop.precise.problem import Body, Fixed, Number, PreciseState
from hophoop.precise.series import integral, product

# The best order spends about this many bits a coefficient: terms that shrink by e² each.
BITS_A_TERM = 2.9


@dataclass
class Step:
    """One step in contact: series in s = τ/h and how far they are good."""

    exponent: int  # h = 2^exponent
    angle: Sequence[int]  # θ − θ at the start
    omega: Sequence[int]
    slip: Sequence[int]
    normal: Sequence[int]
    friction: Sequence[int]  # F
    reach: int = 0
    room: int = 0


def order_for(bits: int) -> int:
    """Number of terms of a series."""
    return int(bits / BITS_A_TERM) + 4


def _last(a: Sequence[int], b: Sequence[int]) -> int:
    return sum(map(mul, a, reversed(b)))


def _square(a: Sequence[int]) -> int:
    """Last coefficient of a square, each product once."""
    half = len(a) // 2
    twice = sum(map(mul, a[:half], a[: -half - 1 : -1])) << 1 if half else 0
    return twice + a[half] * a[half] if len(a) & 1 else twice


def scaled(values: Sequence[int], exponent: int) -> list[int]:
    """Integers times 2^exponent."""
    if exponent >= 0:
        return [value << exponent for value in values]
    return [value >> -exponent for value in values]


def expand(body: Body, sigma: int, state: PreciseState, exponent: int, order: int) -> Step | None:
    """Rolling (sigma = 0) or slip from a state; None where the coefficients grow beyond any use."""
    body.work.take(body.bits)
    fixed = body.fixed
    ctx = body.ctx
    cosine, sine = ctx.cos_sin(state.th)
    om, s, c = body.integer(state.om), body.integer(sine), body.integer(cosine)
    rho = body.integer(body.resistance(state.th, state.om, sigma))
    if sigma == 0:
        rates = _roll(fixed, rho, om, s, c, exponent, order)
    else:
        rates = _slip(fixed, sigma, rho, om, s, c, exponent, order)
    if rates is None:
        return None
    omega, sines, cosines, normal, friction, divisor = rates
    slip: Sequence[int] = ()
    if sigma != 0:
        slip = _slip_velocity(fixed, sigma, body.integer(state.vt), omega, sines, cosines, exponent)
    step = Step(exponent, integral(scaled(omega[:order], exponent)), omega, slip, normal, friction)
    step.reach, step.room = _reach(fixed.bits, om, divisor, step)
    return step


def _roll(
    fixed: Fixed, rho: int, om: int, s: int, c: int, exponent: int, order: int
) -> tuple[list[int], list[int], list[int], list[int], list[int], int] | None:
    bits, eps, gn, gt = fixed.bits, fixed.eps, fixed.gn, fixed.gt
    one = 1 << bits
    # D − ρ ε sin θ, with D = (1 − ε)² + κ + 2 ε (1 + cos θ)
    inertia: list[int] = []
    omega, sines, cosines = [om], [s], [c]
    turning: list[int] = []  # h θ̇
    alpha: list[int] = []
    squares: list[int] = []
    normal: list[int] = []
    friction: list[int] = []
    constant = one + fixed.kap + (eps * eps >> bits)
    limit = 4 * bits
    for k in range(order):
        turning.append(omega[k] << exponent if exponent >= 0 else omega[k] >> -exponent)
        squares.append(_square(omega) >> bits)
        pull_s = _last(sines, squares) >> bits
        pull_c = _last(cosines, squares) >> bits
        torque = eps * (pull_s + (gn * sines[k] >> bits)) + gt * (eps * cosines[k] >> bits)
        torque += rho * (eps * pull_c >> bits)
        lighter = rho * (eps * sines[k] >> bits) >> bits
        if k == 0:
            inertia.append(constant + (eps * cosines[0] >> (bits - 1)) - lighter)
            torque += (gt << bits) - rho * gn
            if inertia[0] <= 0:
                return None
        else:
            inertia.append((eps * cosines[k] >> (bits - 1)) - lighter)
            torque -= sum(map(mul, inertia[1:], reversed(alpha)))
        alpha.append(torque // inertia[0])
        force_t = alpha[k] + (eps * ((_last(alpha, cosines) >> bits) - pull_s) >> bits)
        force_n = -(eps * ((_last(alpha, sines) >> bits) + pull_c) >> bits)
        if k == 0:
            force_t -= gt
            force_n += gn
        friction.append(force_t)
        normal.append(force_n)
        step = alpha[k] << exponent if exponent >= 0 else alpha[k] >> -exponent
        if step.bit_length() > limit:
            return None
        omega.append(step // (k + 1))
        following = _last(turning, cosines), -_last(turning, sines)
        sines.append((following[0] >> bits) // (k + 1))
        cosines.append((following[1] >> bits) // (k + 1))
    return omega, sines, cosines, normal, friction, inertia[0]


def _slip(
    fixed: Fixed, sigma: int, rho: int, om: int, s: int, c: int, exponent: int, order: int
) -> tuple[list[int], list[int], list[int], list[int], list[int], int] | None:
    bits, eps, gn, kap = fixed.bits, fixed.eps, fixed.gn, fixed.kap
    assert fixed.mu_k is not None
    drag = sigma * fixed.mu_k
    omega, sines, cosines = [om], [s], [c]
    turning: list[int] = []
    squares: list[int] = []
    arms: list[int] = []  # q = ε sin θ + σ μ (1 + ε cos θ) − ρ
    stiffness: list[int] = []  # κ p_σ = κ + ε sin θ q
    loads: list[int] = []  # N/κ
    limit = 4 * bits
    for k in range(order):
        turning.append(omega[k] << exponent if exponent >= 0 else omega[k] >> -exponent)
        squares.append(_square(omega) >> bits)
        load = -(eps * (_last(cosines, squares) >> bits))
        arms.append(eps * (sines[k] + (drag * cosines[k] >> bits)) >> bits)
        if k == 0:
            load += gn << bits
            arms[0] += drag - rho
        stiff = eps * (_last(sines, arms) >> bits) >> bits
        if k == 0:
            stiff += kap
            if stiff <= 0:
                return None
        stiffness.append(stiff)
        load -= sum(map(mul, stiffness[1:], reversed(loads)))
        loads.append(load // stiffness[0])
        alpha = _last(arms, loads) >> bits
        step = alpha << exponent if exponent >= 0 else alpha >> -exponent
        if step.bit_length() > limit:
            return None
        omega.append(step // (k + 1))
        following = _last(turning, cosines), -_last(turning, sines)
        sines.append((following[0] >> bits) // (k + 1))
        cosines.append((following[1] >> bits) // (k + 1))
    normal = [kap * load >> bits for load in loads]
    friction = [-(drag * force >> bits) for force in normal]
    return omega, sines, cosines, normal, friction, stiffness[0]


def _slip_velocity(
    fixed: Fixed, sigma: int, vt: int, omega: Sequence[int], sines: Sequence[int], cosines: Sequence[int], exponent: int
) -> list[int]:
    """v_t from what friction leaves alone: ẋ_G + σ μ ẏ_G grows as gravity makes it."""
    bits, eps = fixed.bits, fixed.eps
    assert fixed.mu_k is not None
    drag = sigma * fixed.mu_k
    # ẋ_G + σ μ ẏ_G = v_t + θ̇ (1 + ε cos θ − σ μ ε sin θ)
    arm = [eps * (c - (drag * s >> bits)) >> bits for s, c in zip(sines, cosines, strict=True)]
    arm[0] += 1 << bits
    slip = [-coefficient for coefficient in product(omega, arm, bits)]
    slip[0] = vt
    gain = fixed.gt - (drag * fixed.gn >> bits)
    slip[1] += gain << exponent if exponent >= 0 else gain >> -exponent
    return slip


def _reach(bits: int, om: int, divisor: int, step: Step) -> tuple[int, int]:
    """(how far in s, up to 1, the last terms stay below rounding; the change of the exponent for which that is 1)."""
    spin = max(om.bit_length() - bits, 0)
    # forces have the rounding of θ̇² over what it is divided by
    force = 2 * spin + max(bits - divisor.bit_length(), 0) + 2
    worst, room = 0.0, 2.0
    for series, slack in ((step.omega, spin), (step.normal, force)):
        size = len(series) - 1
        tail = max((abs(series[k]).bit_length() - slack) / k for k in range(size - 3, size + 1))
        worst = max(worst, tail)
        # the last terms may be rounding alone: those well above it show how fast the terms shrink
        k = size
        while k > 1 and abs(series[k]).bit_length() - slack < bits // 4:
            k -= 1
        if k > 1:
            room = min(room, (bits + slack - abs(series[k]).bit_length()) / k - bits / size)
    return int(2.0 ** (60 - worst)) << (bits - 60), math.floor(room + 0.3)


def work_of_friction(step: Step, fixed: Fixed, until: int) -> int:
    """Energy lost in slip from the start of a step to s = until: −∫ F v_t dt."""
    bits = fixed.bits
    size = min(len(step.friction), len(step.slip))
    power = integral(product(step.friction[:size], step.slip[:size], bits))
    total = 0
    for coefficient in reversed(power):
        total = (total * until >> bits) + coefficient
    total = -total
    return total << step.exponent if step.exponent >= 0 else total >> -step.exponent


def work_of_resistance(step: Step, rho: int, fixed: Fixed, until: int) -> int:
    """Energy lost to rolling resistance from the start of a step to s = until: ∫ ρ N θ̇ dt."""
    bits = fixed.bits
    size = min(len(step.normal), len(step.omega))
    total = 0
    for coefficient in reversed(integral(product(step.normal[:size], step.omega[:size], bits))):
        total = (total * until >> bits) + coefficient
    total = total * rho >> bits
    return total << step.exponent if step.exponent >= 0 else total >> -step.exponent


def travel(step: Step, fixed: Fixed, until: int) -> int:
    """The distance that the rim's lowest point has slid, ∫ v_t dt."""
    bits = fixed.bits
    total = 0
    for coefficient in reversed(integral(step.slip)):
        total = (total * until >> bits) + coefficient
    return total << step.exponent if step.exponent >= 0 else total >> -step.exponent


def gap_series(body: Body, state: PreciseState, opening: Number, exponent: int, order: int, bits: int) -> list[int]:
    """The gap in flight as a series in s = τ/h, with a fixed point of its own; `opening` is f_n at the start."""
    ctx = body.ctx
    with ctx.workprec(bits + 20):
        cosine, sine = ctx.cos_sin(state.th)
        term = -body.eps
        turned = ctx.ldexp(state.om, exponent)
        numbers = [state.y, ctx.ldexp(state.vn, exponent), ctx.ldexp(opening, 2 * exponent) / 2]
        # derivatives of cos: c, −s, −c, s
        cycle = (cosine, -sine, -cosine, sine)
        term = -body.eps * turned * turned / 2
        for k in range(3, order):
            term = term * turned / k
            numbers.append(term * cycle[k % 4])
        return [int(ctx.floor(ctx.ldexp(number, bits))) for number in numbers]
