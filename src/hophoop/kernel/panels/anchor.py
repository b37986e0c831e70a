"""What a phase conserves, measured from the equilibrium that it passes (docs/model.md#beside-an-equilibrium).

In rolling D θ̇² + 2 V(θ) is conserved, in slip of one direction the difference of θ̇² from the motion that comes to rest
at the equilibrium grows by a factor that is known. A hoop that passes the top at 1e-8 m/s has θ̇² = 1e-16 there, which
is lost in the rounding of the θ̇² = 10 it comes with. So the small number is carried along, and θ̇² is found from it anew
at each panel:

    roll  D θ̇² = excess + 2 [B (1 − cos ψ) + g_t (ψ − sin ψ)],  ψ = θ − θ_base,  B = ε (g_n cos θ_base − g_t sin θ_base)
    slip  θ̇²   = excess + Σ a_k ψ^k, with the series of the motion that comes to rest at θ_base

The hilltop serves as the base where the hoop comes near it, the valley for oscillations beside the valley.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.circular import sine, sine_and_cosine
from hophoop.kernel.numerics.double_angles import arc_sine, sine_versine
from hophoop.kernel.numerics.double_double import (
    PI,
    PI_LOW,
    add,
    divide,
    negative,
    square_root,
    two_product,
)
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.numerics.trigonometry import sine_and_versine, sine_cosine, turn_deficits, versine_of
from hophoop.kernel.physics.contact import inertia_at_height, load_height, slip_torque_arm
from hophoop.kernel.physics.roll import rest_curvature

TERMS = 16
LARGEST_PSI = 0.1  # rad from a hilltop within which the series of slip is used
CANCELS = 1e-2  # of its terms: where θ̇² is less, as beside a turning point, the one that is carried has more digits
FREE, ROLLING, SLIPPING = 0, 1, 2


class Anchor(NamedTuple):
    """The conserved quantity of a phase and what it is measured from."""

    kind: int  # FREE: none
    excess: float
    base: float  # θ of the equilibrium, within the turn
    base_low: float
    bend: float  # B; positive on a hilltop


NONE = Anchor(FREE, 0.0, 0.0, 0.0, 0.0)


def rolling_hilltop(body):
    """θ, in two doubles, of the unstable equilibrium on a slope; needs abs(sin β) < ε."""
    sine = divide(sine_versine((body.slope, 0.0))[0], (body.eps, 0.0))
    return add(negative(arc_sine(sine)), (-body.slope, 0.0))


@inline
def offset_from(th, low, base, base_low):
    """ψ = θ − θ_base of two angles of two doubles, with all its digits."""
    return (th - base) + (low - base_low)


@inline
def potential_drop(body, bend, psi):
    """B (1 − cos ψ) + g_t (ψ − sin ψ): by how much V is lower at ψ than at the equilibrium."""
    if body.gt == 0.0:
        return bend * versine_of(psi)
    bent, _, versine = turn_deficits(psi)
    return bend * versine + body.gt * bent


@apart
def rolling_anchor(body, th, low, s, c, u):
    """The anchor of a rolling phase that begins at θ with θ̇² = u."""
    if body.eps == 0.0 or body.gn == 0.0 or abs(body.gt) >= body.eps:
        return NONE
    base = 0.0
    base_low = 0.0
    if body.gt != 0.0:
        base, base_low = rolling_hilltop(body)
    top, side = sine_and_cosine(base)
    bend = -rest_curvature(body, top, side)
    psi = offset_from(th, low, base, base_low)
    energy = inertia_at_height(body, load_height(s, c)) * u
    excess = energy - 2.0 * potential_drop(body, bend, psi)
    if excess < -2.0 * bend:
        # nearer to the valley, which lies a turn less two arcs from the hilltop: θ_valley = π − 2β − θ_hilltop
        way = 1.0 if psi > 0.0 else -1.0
        valley = add((way * PI, way * PI_LOW), (-2.0 * body.slope, 0.0))
        valley = add(valley, (-base, -base_low))
        base, base_low = valley
        bend = -bend
        excess = energy - 2.0 * potential_drop(body, bend, offset_from(th, low, base, base_low))
    return Anchor(ROLLING, excess, base, base_low, bend)


@inline
def rolling_begin(body, anchor, th, low, s, c, u):
    """(−dV/dθ, d²V/dθ², θ̇²) where a rolling panel begins; the last is as it was without an anchor."""
    torque = body.eps * (body.gn * s + body.gt * c) + body.gt
    bend = -rest_curvature(body, s, c)
    if anchor.kind != ROLLING:
        return torque, bend, u
    psi = 0.0
    if body.gt != 0.0:
        psi = offset_from(th, low, anchor.base, anchor.base_low)
        turned, versine = sine_and_versine(psi)
        torque = anchor.bend * turned + body.gt * versine
    if body.gt == 0.0:  # ψ is θ or θ ± π: 1 − cos ψ without another sine
        height = c if anchor.bend > 0.0 else -c
        versine = s * s / (1.0 + height) if height > 0.0 else 1.0 - height
        lower = 2.0 * anchor.bend * versine
    else:
        lower = 2.0 * potential_drop(body, anchor.bend, psi)
    energy = anchor.excess + lower
    if energy > CANCELS * (abs(anchor.excess) + abs(lower)):
        u = energy / inertia_at_height(body, load_height(s, c))
    return torque, bend, u


def slip_hilltop(body, sigma):
    """θ, in two doubles, where slip has no torque and θ̇ = 0 is unstable; needs σ μ/√(1 + μ²) < ε."""
    signed_mu = sigma * body.mu_k
    if signed_mu == 0.0:
        return 0.0, 0.0
    length = square_root(add(two_product(signed_mu, signed_mu), (1.0, 0.0)))
    sine = divide((signed_mu, 0.0), length)
    return negative(add(arc_sine(sine), arc_sine(divide(sine, (body.eps, 0.0)))))


@apart
def separatrix(body, sigma, base, out):
    """Series in ψ of θ̇² of the slip that comes to rest at its hilltop; returns up to which ψ it is good to rounding."""
    eps = body.eps
    signed_mu = sigma * body.mu_k
    s, c = sine_and_cosine(base)
    s2 = 2.0 * s * c
    c2 = (c - s) * (c + s)
    out[0] = 0.0
    out[1] = 0.0
    for k in range(1, TERMS - 1):
        total = 0.0
        single = 1.0  # 1/j!
        double = 1.0  # 2^j/j!
        sine, cosine, sine2, cosine2 = s, c, s2, c2
        for j in range(1, k + 1):
            single /= j
            double *= 2.0 / j
            sine, cosine = cosine, -sine
            sine2, cosine2 = cosine2, -sine2
            stiffness = 0.5 * eps * eps * double * (signed_mu * sine2 - cosine2) + eps * signed_mu * single * sine
            damping = eps * (eps * double * (sine2 + signed_mu * cosine2) + 2.0 * signed_mu * single * cosine)
            total -= damping * out[k - j] + stiffness * (k - j + 1) * out[k - j + 1]
        total += 2.0 * body.gn * eps * single * (sine + signed_mu * cosine)
        out[k + 1] = total / (body.kap * (k + 1))
    reach = LARGEST_PSI
    for k in range(TERMS - 3, TERMS):
        if out[k] != 0.0:
            reach = min(reach, power(1e-17 * abs(out[2] / out[k]), 1.0 / (k - 2)))
    return reach


def separatrix_value(series, psi):
    """θ̇² of the slip that comes to rest at the hilltop, at ψ from there."""
    result = 0.0
    for k in range(TERMS - 1, 1, -1):
        result = result * psi + series[k]
    return result * psi * psi


def frictionless_value(body, th, low):
    """θ̇² of the slip without friction that comes to rest on the hilltop: its energy is conserved."""
    s = sine_cosine(th, low)[0]
    half = sine(0.5 * (th + low))
    return 4.0 * body.eps * body.gn * half * half / (body.kap + body.eps * s * body.eps * s)


@apart
def slip_anchor(body, sigma, th, low, s, c, u, series):
    """The anchor of slip that begins, with θ̇² = u, beside its hilltop; `series` is scratch."""
    if body.gn == 0.0 or body.eps == 0.0 or math.isinf(body.mu_k):
        return NONE
    signed_mu = sigma * body.mu_k
    if signed_mu == 0.0:
        return Anchor(SLIPPING, u - frictionless_value(body, th, low), 0.0, 0.0, body.eps * c)
    torque = slip_torque_arm(body, s, c, sigma)
    slope = body.eps * (c - signed_mu * s)
    if not (slope > 0.0 and abs(torque) < 2.0 * LARGEST_PSI * slope):
        return NONE
    base, base_low = slip_hilltop(body, sigma)
    psi = offset_from(th, low, base, base_low)
    if abs(psi) > separatrix(body, sigma, base, series):
        return NONE
    return Anchor(SLIPPING, u - separatrix_value(series, psi), base, base_low, slope)


@apart
def slip_begin(body, anchor, sigma, th, low, arm, u, series):
    """(q, θ̇²) where a slip panel begins, from what they are but for rounding: with all digits also beside the hilltop."""
    if body.mu_k == 0.0:
        high = frictionless_value(body, th, low)
        found = anchor.excess + high
        return arm, found if found > CANCELS * (abs(anchor.excess) + high) else u
    psi = offset_from(th, low, anchor.base, anchor.base_low)
    if not abs(psi) < LARGEST_PSI:
        return arm, u
    top, side = sine_and_cosine(anchor.base)
    signed_mu = sigma * body.mu_k
    turned, versine = sine_and_versine(psi)
    arm = body.eps * ((side - signed_mu * top) * turned - (top + signed_mu * side) * versine)
    if u != 0.0 and abs(psi) <= separatrix(body, sigma, anchor.base, series):
        high = separatrix_value(series, psi)
        found = anchor.excess + high
        if found > CANCELS * (abs(anchor.excess) + high):
            u = found
    return arm, u
