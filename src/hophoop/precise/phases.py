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

from hophoop.kernel.model import resistance_arm
from hophoop.kernel.records import State
from hophoop.precise.kernels import Number
from hophoop.precise.problem import Body, Fixed
from hophoop.precise.series import integral, product, value

# The best order spends about this many bits a coefficient: terms that shrink by e² each.
BITS_A_TERM = 2.9


@dataclass
class Step:
    """One step in contact: series in s = τ/h and how far they are good."""

    exponent: int  # h = 2^exponent
    angle: Sequence[int]  # θ − θ at the start
    omega: Sequence[int]
    slip: Sequence[int]  # v_t in slip, empty in rolling
    normal: Sequence[int]  # N
    friction: Sequence[int]  # F in rolling, empty in slip
    reach: int
    room: int


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


def expand(body: Body, sigma: int, state: State, exponent: int, order: int) -> Step | None:
    """Rolling (sigma = 0) or slip from a state; None where the coefficients grow beyond any use."""
    body.work.take(body.bits)
    fixed, bits = body.fixed, body.bits
    cosine, sine = body.ctx.cos_sin(state.th)
    rho = body.integer(body.kernels(resistance_arm)(body, sine, cosine, state.om, sigma))
    forces = Rolling(fixed, rho) if sigma == 0 else Slipping(fixed, sigma, rho)
    omega, sines, cosines = [body.integer(state.om)], [body.integer(sine)], [body.integer(cosine)]
    turning: list[int] = []  # h θ̇
    squares: list[int] = []  # θ̇²
    up, down = max(exponent, 0), max(-exponent, 0)
    for k in range(order):
        turning.append(omega[k] << up >> down)
        squares.append(_square(omega) >> bits)
        forces.extend(k, sines, cosines, squares)
        if forces.divisor <= 0:
            return None
        step = forces.alpha[k] << up >> down
        if step.bit_length() > 4 * bits:
            return None
        omega.append(step // (k + 1))
        back = turning[::-1]
        sine, cosine = sum(map(mul, cosines, back)), -sum(map(mul, sines, back))
        sines.append((sine >> bits) // (k + 1))
        cosines.append((cosine >> bits) // (k + 1))
    slip = _slip_velocity(fixed, sigma, body.integer(state.vt), omega, sines, cosines, exponent) if sigma != 0 else ()
    friction = forces.friction if isinstance(forces, Rolling) else ()
    reach, room = _reach(bits, omega, forces)
    return Step(exponent, integral(turning), omega, slip, forces.normal, friction, reach, room)


class Rolling:
    """Series of θ̈, N and F in rolling, each one term longer by `extend`.

    These are the equations of `kernel.physics.contact` once more: over series of integers, each coefficient from those before.
    """

    def __init__(self, fixed: Fixed, rho: int) -> None:
        self.numbers = fixed.bits, fixed.eps, fixed.gn, fixed.gt, rho
        self.divisor = (1 << fixed.bits) + fixed.kap + (fixed.eps * fixed.eps >> fixed.bits)  # D − ρ ε sin θ at the start
        self.inertia: list[int] = []  # D − ρ ε sin θ with D = 1 + κ + ε² + 2 ε cos θ, from its second term on
        self.alpha: list[int] = []
        self.normal: list[int] = []
        self.friction: list[int] = []

    def extend(self, k: int, sines: Sequence[int], cosines: Sequence[int], squares: Sequence[int]) -> None:
        """Append the term k, from those of sin θ, cos θ and θ̇²."""
        bits, eps, gn, gt, rho = self.numbers
        alpha = self.alpha
        pull_s = _last(sines, squares) >> bits
        pull_c = _last(cosines, squares) >> bits
        torque = eps * (pull_s + (gn * sines[k] >> bits)) + gt * (eps * cosines[k] >> bits)
        inertia = eps * cosines[k] >> (bits - 1)
        if rho:
            torque += rho * (eps * pull_c >> bits)
            inertia -= rho * (eps * sines[k] >> bits) >> bits
        if k == 0:
            torque += (gt << bits) - rho * gn
            self.divisor += inertia
        else:
            self.inertia.append(inertia)
            torque -= _last(self.inertia, alpha)
        alpha.append(torque // self.divisor)
        force_t = alpha[k] + (eps * ((_last(alpha, cosines) >> bits) - pull_s) >> bits)
        force_n = -(eps * ((_last(alpha, sines) >> bits) + pull_c) >> bits)
        self.friction.append(force_t - gt if k == 0 else force_t)
        self.normal.append(force_n + gn if k == 0 else force_n)


class Slipping:
    """Series of θ̈ and N in slip of direction σ, as those of `Rolling`."""

    def __init__(self, fixed: Fixed, sigma: int, rho: int) -> None:
        self.numbers = fixed.bits, fixed.eps, fixed.kap, fixed.gn, sigma * fixed.mu_k, rho
        self.divisor = fixed.kap  # κ p_σ at the start
        self.arms: list[int] = []  # q = ε sin θ + σ μ (1 + ε cos θ) − ρ
        self.stiffness: list[int] = []  # κ p_σ = κ + ε sin θ q, from its second term on
        self.loads: list[int] = []  # N/κ
        self.alpha: list[int] = []
        self.normal: list[int] = []

    def extend(self, k: int, sines: Sequence[int], cosines: Sequence[int], squares: Sequence[int]) -> None:
        """Append the term k, from those of sin θ, cos θ and θ̇²."""
        bits, eps, kap, gn, drag, rho = self.numbers
        arms, loads = self.arms, self.loads
        load = -(eps * (_last(cosines, squares) >> bits))
        arms.append(eps * (sines[k] + (drag * cosines[k] >> bits)) >> bits)
        if k == 0:
            load += gn << bits
            arms[0] += drag - rho
        stiffness = eps * (_last(sines, arms) >> bits) >> bits
        if k == 0:
            self.divisor += stiffness
        else:
            self.stiffness.append(stiffness)
            load -= _last(self.stiffness, loads)
        loads.append(load // self.divisor if self.divisor > 0 else 0)
        self.alpha.append(_last(arms, loads) >> bits)
        self.normal.append(kap * loads[k] >> bits)


def _slip_velocity(
    fixed: Fixed, sigma: int, vt: int, omega: Sequence[int], sines: Sequence[int], cosines: Sequence[int], exponent: int
) -> list[int]:
    """v_t from what friction leaves alone: ẋ_G + σ μ ẏ_G grows as gravity makes it."""
    bits, eps = fixed.bits, fixed.eps
    drag = sigma * fixed.mu_k
    # ẋ_G + σ μ ẏ_G = v_t + θ̇ (1 + ε cos θ − σ μ ε sin θ)
    arm = [eps * (c - (drag * s >> bits)) >> bits for s, c in zip(sines, cosines, strict=True)]
    arm[0] += 1 << bits
    slip = [-coefficient for coefficient in product(omega, arm, bits)]
    slip[0] = vt
    gain = fixed.gt - (drag * fixed.gn >> bits)
    slip[1] += gain << exponent if exponent >= 0 else gain >> -exponent
    return slip


def _reach(bits: int, omega: Sequence[int], forces: Rolling | Slipping) -> tuple[int, int]:
    """(how far in s, up to 1, the last terms stay below rounding; the change of the exponent for which that is 1)."""
    spin = max(omega[0].bit_length() - bits, 0)
    # forces have the rounding of θ̇² over what it is divided by
    force = 2 * spin + max(bits - forces.divisor.bit_length(), 0) + 2
    worst, room = 0.0, 2.0
    for series, slack in ((omega, spin), (forces.normal, force)):
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


def work(step: Step, rate: Sequence[int], bits: int, until: int) -> int:
    """∫ N times a rate over time, from the start of a step to s = until; friction takes μ, resistance ρ times as much."""
    return integral_to(step, product(step.normal, rate, bits), bits, until)


def integral_to(step: Step, series: Sequence[int], bits: int, until: int) -> int:
    """The integral of a series over time, from the start of a step to s = until."""
    found = value(integral(series), until, bits)
    return found << step.exponent if step.exponent >= 0 else found >> -step.exponent


def gap_series(body: Body, state: State, opening: Number, exponent: int, order: int, bits: int) -> list[int]:
    """The gap in flight as a series in s = τ/h, with a fixed point of its own; `opening` is f_n at the start."""
    ctx = body.ctx
    with ctx.workprec(bits + 20):
        cosine, sine = ctx.cos_sin(state.th)
        turned = ctx.ldexp(state.om, exponent)
        numbers = [state.y, ctx.ldexp(state.vn, exponent), ctx.ldexp(opening, 2 * exponent) / 2]
        # derivatives of cos: c, −s, −c, s
        cycle = (cosine, -sine, -cosine, sine)
        term = -body.eps * turned * turned / 2
        for k in range(3, order):
            term = term * turned / k
            numbers.append(term * cycle[k % 4])
        return [int(ctx.floor(ctx.ldexp(number, bits))) for number in numbers]
