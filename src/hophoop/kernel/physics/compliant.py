"""Compliant contact: a unilateral spring with a damper, and regularised friction (docs/model.md#compliant-contact).

Kernel units (R, m, √(R/g)). The rim may sink into the plane (y < 0). While the contact acts, its normal force is

    Kelvin–Voigt       N = −k y − c v_n            until N = 0 (clipped: the plane never pulls)
    Hunt–Crossley      N = −k y (1 − d v_n)        until y = 0 or d v_n = 1

and its friction force is

    tanh, linear       F = −N φ(v_t/v_s), creeping under every load
    bristle            a spring and damper along the plane, F = −(k_t z + c_t ż), whose foot sticks to
                       the plane (ż = v_t) while abs(F) ≤ μs N and else slides with abs(F) = μk N

Rolling resistance is a couple −f N tanh(θ̇/v_s) on the hoop, which creeps under every load.
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import NamedTuple

from hophoop.kernel.numerics.arcs import arccosine
from hophoop.kernel.numerics.exponentials import exponential, hyperbolic_tangent, inverse_hyperbolic_cosine, logarithm_1p


class NormalLaw(IntEnum):
    """Law of the normal force."""

    KELVIN_VOIGT = 0
    HUNT_CROSSLEY = 1


class FrictionLaw(IntEnum):
    """Law of friction."""

    TANH = 0
    LINEAR = 1
    BRISTLE = 2


KELVIN_VOIGT = int(NormalLaw.KELVIN_VOIGT)
TANH, LINEAR, BRISTLE = (int(law) for law in FrictionLaw)


class Compliance(NamedTuple):
    """Dimensionless parameters of the contact."""

    law: int  # NormalLaw
    friction: int  # FrictionLaw
    k: float  # stiffness
    c: float  # damping of Kelvin–Voigt
    d: float  # damping of Hunt–Crossley, per speed
    v_s: float  # slip speed
    mu_s: float
    mu_k: float
    excess: float  # A of the tanh law, see `static_excess`
    k_t: float  # stiffness of the bristle; `c_t` is its damping
    c_t: float


STIFFNESS = 1e6  # in m g / R, if none is given

# In the tanh law friction falls from its static maximum to the kinetic value within this many slip speeds.
STRIBECK = 3.0
# Slip below this many slip speeds counts as roll; there tanh gives 99.93 % of the friction, the linear law all.
TANH_CREEP, LINEAR_CREEP = 4.0, 1.0


def creep_speed(comp):
    """Return the slip speed below which a motion counts as roll in the tanh and linear laws."""
    return (TANH_CREEP if comp.friction == TANH else LINEAR_CREEP) * comp.v_s


def normal_force(comp, y, vn):
    """Return (N, ∂N/∂y, ∂N/∂v_n) while the contact acts."""
    if comp.law == KELVIN_VOIGT:
        return -comp.k * y - comp.c * vn, -comp.k, -comp.c
    closing = 1.0 - comp.d * vn
    return -comp.k * y * closing, -comp.k * closing, comp.k * comp.d * y


def traction(comp, regime, vt):
    """Return (φ, dφ/dv_t) of the tanh and linear laws; `regime` is 0 below the creep speed, else sign(v_t)."""
    if comp.friction == TANH:
        xi = vt / comp.v_s
        hyper = hyperbolic_tangent(xi)
        part = xi / STRIBECK
        decay = comp.excess * exponential(-(part * part))
        level = comp.mu_k + decay
        slope = level * (1.0 - hyper * hyper) - hyper * decay * 2.0 * part / STRIBECK
        return hyper * level, slope / comp.v_s
    if regime == 0:
        return comp.mu_s * vt / comp.v_s, comp.mu_s / comp.v_s
    beyond = regime * vt / comp.v_s - 1.0
    decay = (comp.mu_s - comp.mu_k) * exponential(-beyond * beyond)
    return regime * (comp.mu_k + decay), -2.0 * beyond * decay / comp.v_s


def bristle_rate(comp, regime, normal, z, vt):
    """Return ż of the bristle: v_t while its foot sticks, else relaxation against the sliding friction."""
    if regime == 0:
        return vt
    return (regime * comp.mu_k * normal - comp.k_t * z) / comp.c_t


def friction_force(comp, regime, normal, z, vt):
    """Return (F, ∂F/∂N, ∂F/∂v_t, ∂F/∂z)."""
    if comp.friction == BRISTLE:
        if regime == 0:
            return -(comp.k_t * z + comp.c_t * vt), 0.0, -comp.c_t, -comp.k_t
        return -regime * comp.mu_k * normal, -regime * comp.mu_k, 0.0, 0.0
    phi, slope = traction(comp, regime, vt)
    return -normal * phi, -phi, -normal * slope, 0.0


def resisting_couple(comp, resist, normal, om):
    """Return (C, ∂C/∂N, ∂C/∂θ̇) of the couple C of rolling resistance."""
    hyper = hyperbolic_tangent(om / comp.v_s)
    return -resist * normal * hyper, -resist * hyper, -resist * normal * (1.0 - hyper * hyper) / comp.v_s


def first_regime(comp, normal, z, vt):
    """Return the friction regime at the start of a contact: 0 in stick or creep, else the direction of slip."""
    if comp.friction == BRISTLE:
        bristle_force = comp.k_t * z + comp.c_t * vt
        if abs(bristle_force) <= comp.mu_s * normal:
            return 0
        return 1 if bristle_force > 0.0 else -1
    if abs(vt) <= creep_speed(comp):
        return 0
    return 1 if vt > 0.0 else -1


def spring_energy(comp, y, z):
    """Return the energy in the normal and the tangential spring."""
    depth = min(y, 0.0)
    energy = 0.5 * comp.k * depth * depth
    if comp.friction == BRISTLE:
        energy += 0.5 * comp.k_t * z * z
    return energy


# --- damping for a given restitution -------------------------------------------------------------


BISECTIONS = 200  # maximum; the bisection ends earlier at two neighbouring doubles


def ratio_restitution(ratio):
    """Return the restitution of a mass on a clipped Kelvin–Voigt contact, from its damping over critical damping ζ ≥ 0.

    It is exp(−ζ/√(1 − ζ²) (π − 2 asin ζ)), continued to ζ > 1; the contact ends where N = 0.
    """
    if ratio < 1.0:
        root = math.sqrt((1.0 - ratio) * (1.0 + ratio))
        return exponential(-2.0 * ratio * arccosine(ratio) / root) if root > 0.0 else exponential(-2.0)
    root = math.sqrt((ratio - 1.0) * (ratio + 1.0))
    return exponential(-2.0 * ratio * inverse_hyperbolic_cosine(ratio) / root) if root > 0.0 else exponential(-2.0)


def damping_ratio(restitution):
    """Return the damping over critical damping that gives a restitution from 0 (excluded) to 1."""
    if restitution >= 1.0:
        return 0.0
    low, high = 0.0, 1.0
    while ratio_restitution(high) > restitution:
        low, high = high, 2.0 * high
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if ratio_restitution(middle) > restitution:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def hunt_crossley_excess(restitution, u):
    """Return ln(1 + u) − ln(1 − e u) − (1 + e) u."""
    return logarithm_1p(u) - logarithm_1p(-restitution * u) - (1.0 + restitution) * u


def hunt_crossley_number(restitution):
    """Return d times the approach speed at which a Hunt–Crossley contact has a restitution from 0 (excluded) to 1.

    It is the root u > 0 of ln(1 + u) − ln(1 − e u) = (1 + e) u, exact for every exponent of the spring.
    """
    if restitution >= 1.0:
        return 0.0
    pole = 1.0 / restitution
    high = pole * (1.0 - 1e-15)
    if hunt_crossley_excess(restitution, high) < 0.0:  # the root equals the pole within rounding
        return high
    # the function is negative from 0 to the root and rises through it
    low = 0.5 * pole
    while hunt_crossley_excess(restitution, low) >= 0.0:
        low *= 0.5
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if hunt_crossley_excess(restitution, middle) < 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def static_height(mu_kinetic, excess, xi):
    """Return tanh ξ (μk + A exp(−ξ²/9))."""
    part = xi / STRIBECK
    return hyperbolic_tangent(xi) * (mu_kinetic + excess * exponential(-(part * part)))


def static_peak(mu_kinetic, excess):
    """Return the maximum of `static_height` by golden section; between 0 and 4 STRIBECK it is the only one, or saturates."""
    low, high = 0.0, 4.0 * STRIBECK
    share = 0.5 * (math.sqrt(5.0) - 1.0)
    for _ in range(80):
        left, right = high - share * (high - low), low + share * (high - low)
        if static_height(mu_kinetic, excess, left) < static_height(mu_kinetic, excess, right):
            low = left
        else:
            high = right
    return static_height(mu_kinetic, excess, 0.5 * (low + high))


def static_excess(mu_static, mu_kinetic):
    """Return the factor A ≥ 0 that makes μs ≥ μk the exact maximum of tanh ξ (μk + A exp(−ξ²/9))."""
    if mu_static == mu_kinetic:
        return 0.0
    low, high = 0.0, mu_static - mu_kinetic
    while static_peak(mu_kinetic, high) < mu_static:
        high *= 2.0
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if static_peak(mu_kinetic, middle) < mu_static:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


# --- requirements of a start ---------------------------------------------------------------------


def sinking(k, falls, height, speed):
    """Estimate how deep the rim sinks into the plane after a fall from `height` with a speed (kernel units)."""
    fall = math.sqrt(2.0 * height) if falls else 0.0
    return (speed + fall) / math.sqrt(k) + 1.0 / k
