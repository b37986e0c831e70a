"""Conserved quantity of a phase, relative to the nearest equilibrium (docs/model.md#near-an-equilibrium).

Rolling conserves D θ̇² + 2 V(θ). In slip the difference of θ̇² from the separatrix, the motion that comes to rest at the
equilibrium, grows by a known factor. A hoop that passes the top at 1e-8 m/s has θ̇² = 1e-16 there, which rounding of the
earlier θ̇² = 10 would hide. So the small number is kept in the state, and each panel computes θ̇² from it:

    roll  D θ̇² = excess + 2 [B (1 − cos ψ) + g_t (ψ − sin ψ)],  ψ = θ − θ_base,  B = ε (g_n cos θ_base − g_t sin θ_base)
    slip  θ̇²   = excess + Σ a_k ψ^k, with the series of the motion that comes to rest at θ_base

The base is the unstable equilibrium if the hoop comes near it, else the stable one.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arcs import exact_arcsine
from hophoop.kernel.numerics.arithmetic import PI, PI_LOW, add, divide, negative, square_root, two_product
from hophoop.kernel.numerics.circular import (
    exact_sine_versine,
    series_remainders,
    sine,
    sine_and_cosine,
    sine_and_versine,
    sine_cosine,
    versine_of,
)
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.physics.closed_forms import rest_curvature
from hophoop.kernel.physics.contact import inertia_at_height, load_height, slip_torque_arm

TERMS = 16
LARGEST_PSI = 0.1  # rad from the unstable equilibrium within which the series of slip is used
CANCELS = 1e-2  # relative to its terms: if the sum is less, as near a turning point, θ̇² of the state has more digits
FREE, ROLLING, SLIPPING = 0, 1, 2


class Anchor(NamedTuple):
    """Conserved quantity of a phase and the equilibrium to which it is relative."""

    kind: int  # FREE: none
    excess: float
    base: float  # θ of the equilibrium, within one revolution
    base_low: float
    bend: float  # B; positive at an unstable equilibrium


NONE = Anchor(FREE, 0.0, 0.0, 0.0, 0.0)


@inline
def has_equilibria(body):
    """Return True if rolling has an unstable and a stable equilibrium in each revolution."""
    return body.eps > 0.0 and body.gn > 0.0 and abs(body.gt) < body.eps


def rolling_unstable_equilibrium(body):
    """Return θ of the unstable equilibrium, ε sin(θ + β) = −sin β, as a double-double; requires `has_equilibria`."""
    if body.gt == 0.0:
        return 0.0, 0.0
    sine = divide(exact_sine_versine((body.slope, 0.0))[0], (body.eps, 0.0))
    return add(negative(exact_arcsine(sine)), (-body.slope, 0.0))


def rolling_stable_equilibrium(body, unstable, direction):
    """Return θ of the stable equilibrium on one side (±1) of the unstable one, π − 2β − θ_unstable, as a double-double."""
    valley = add((direction * PI, direction * PI_LOW), (-2.0 * body.slope, 0.0))
    return add(valley, negative(unstable))


@inline
def offset_from(th, low, base, base_low):
    """Return ψ = θ − θ_base of two double-double angles, accurate to all digits."""
    return (th - base) + (low - base_low)


@inline
def potential_drop(body, bend, psi):
    """Return B (1 − cos ψ) + g_t (ψ − sin ψ), the drop of V from the equilibrium to ψ."""
    if body.gt == 0.0:
        return bend * versine_of(psi)
    bent, _, versine = series_remainders(psi)
    return bend * versine + body.gt * bent


@noinline
def rolling_anchor(body, th, low, s, c, u):
    """Return the anchor of a rolling phase that starts at θ with θ̇² = u."""
    if not has_equilibria(body):
        return NONE
    base, base_low = rolling_unstable_equilibrium(body)
    top, side = sine_and_cosine(base)
    bend = -rest_curvature(body, top, side)
    psi = offset_from(th, low, base, base_low)
    energy = inertia_at_height(body, load_height(s, c)) * u
    excess = energy - 2.0 * potential_drop(body, bend, psi)
    if excess < -2.0 * bend:
        base, base_low = rolling_stable_equilibrium(body, (base, base_low), 1.0 if psi > 0.0 else -1.0)
        bend = -bend
        excess = energy - 2.0 * potential_drop(body, bend, offset_from(th, low, base, base_low))
    return Anchor(ROLLING, excess, base, base_low, bend)


@inline
def rolling_panel_start(body, anchor, th, low, s, c, u):
    """Return (−dV/dθ, d²V/dθ², θ̇²) at the start of a rolling panel; without an anchor θ̇² is unchanged."""
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


def slip_unstable_equilibrium(body, sigma):
    """Return θ of the unstable equilibrium of slip as a double-double; requires σ μ/√(1 + μ²) < ε."""
    signed_mu = sigma * body.mu_k
    if signed_mu == 0.0:
        return 0.0, 0.0
    length = square_root(add(two_product(signed_mu, signed_mu), (1.0, 0.0)))
    sine = divide((signed_mu, 0.0), length)
    return negative(add(exact_arcsine(sine), exact_arcsine(divide(sine, (body.eps, 0.0)))))


@noinline
def separatrix(body, sigma, base, out):
    """Fill `out` with the series in ψ of θ̇² on the separatrix of slip; return the maximum ψ for full accuracy."""
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
    """Return θ̇² at ψ on the separatrix of slip."""
    result = 0.0
    for k in range(TERMS - 1, 1, -1):
        result = result * psi + series[k]
    return result * psi * psi


def frictionless_value(body, th, low):
    """Return θ̇² of the slip without friction that comes to rest at the unstable equilibrium, by conservation of energy."""
    s = sine_cosine(th, low)[0]
    half = sine(0.5 * (th + low))
    return 4.0 * body.eps * body.gn * half * half / (body.kap + body.eps * s * body.eps * s)


@noinline
def slip_anchor(body, sigma, th, low, s, c, u, series):
    """Return the anchor of slip that starts near its unstable equilibrium with θ̇² = u; `series` is scratch."""
    if body.gn == 0.0 or body.eps == 0.0 or math.isinf(body.mu_k):
        return NONE
    signed_mu = sigma * body.mu_k
    if signed_mu == 0.0:
        return Anchor(SLIPPING, u - frictionless_value(body, th, low), 0.0, 0.0, body.eps * c)
    torque = slip_torque_arm(body, s, c, sigma)
    slope = body.eps * (c - signed_mu * s)
    if not (slope > 0.0 and abs(torque) < 2.0 * LARGEST_PSI * slope):
        return NONE
    base, base_low = slip_unstable_equilibrium(body, sigma)
    psi = offset_from(th, low, base, base_low)
    if abs(psi) > separatrix(body, sigma, base, series):
        return NONE
    return Anchor(SLIPPING, u - separatrix_value(series, psi), base, base_low, slope)


@inline
def slip_arm_at(body, sigma, base, psi):
    """Return q at ψ from the equilibrium of slip, with all digits."""
    top, side = sine_and_cosine(base)
    signed_mu = sigma * body.mu_k
    turned, versine = sine_and_versine(psi)
    return body.eps * ((side - signed_mu * top) * turned - (top + signed_mu * side) * versine)


@noinline
def slip_panel_start(body, anchor, sigma, th, low, arm, u, series):
    """Return (q, θ̇²) at the start of a slip panel with all digits, also near the unstable equilibrium."""
    if body.mu_k == 0.0:
        high = frictionless_value(body, th, low)
        found = anchor.excess + high
        return arm, found if found > CANCELS * (abs(anchor.excess) + high) else u
    psi = offset_from(th, low, anchor.base, anchor.base_low)
    if not abs(psi) < LARGEST_PSI:
        return arm, u
    arm = slip_arm_at(body, sigma, anchor.base, psi)
    if u != 0.0 and abs(psi) <= separatrix(body, sigma, anchor.base, series):
        high = separatrix_value(series, psi)
        found = anchor.excess + high
        if found > CANCELS * (abs(anchor.excess) + high):
            u = found
    return arm, u
