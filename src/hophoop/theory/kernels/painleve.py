"""Painlevé's paradox, case by case."""

from __future__ import annotations

import math

from hophoop.kernel.model import contact_arms, kappa_p_sigma, resistance_arm
from hophoop.kernel.numerics.arcs import arccosine
from hophoop.kernel.numerics.circular import sine_and_cosine

BOTH = 2


def threshold(body, th, sigma):
    """μ at which p_σ = 0 without rolling resistance, inf if there is none: p_σ is linear in μ."""
    s, c = sine_and_cosine(th)
    arm, lever = contact_arms(body, s, c)
    smooth = body.kap + lever * lever
    rough = body.kap + lever * (lever + sigma * arm)
    return smooth / (smooth - rough) if rough < smooth else math.inf


def thresholds(body, angles, out):
    for k in range(angles.shape[0]):
        out[k] = min(threshold(body, angles[k], 1), threshold(body, angles[k], -1))


def region(body, angle, rate):
    """σ of the slip with p_σ ≤ 0, 0 if there is none, BOTH if both directions have it."""
    s, c = sine_and_cosine(angle)
    spin = kappa_p_sigma(body, s, c, -1, resistance_arm(body, s, c, rate, -1)) <= 0.0
    skid = kappa_p_sigma(body, s, c, 1, resistance_arm(body, s, c, rate, 1)) <= 0.0
    return (BOTH if spin else 1) if skid else (-1 if spin else 0)


def regions(body, angles, rates, out):
    for k in range(angles.shape[0]):
        out[k] = region(body, angles[k], rates[k])


def worst_angle(eps, kap):
    """θ in [0, π/2] where the threshold is smallest: dμ/dθ = 0 is a cubic in cos θ."""
    low = 0.0
    high = 1.0
    while True:
        c = 0.5 * (low + high)
        if c in (low, high):
            break
        cubic = ((eps * eps * c + eps * (2.0 * kap + eps * eps)) * c + kap - eps * eps) * c
        if cubic < eps * (kap + eps * eps):
            low = c
        else:
            high = c
    return arccosine(low)


def minimum(body):
    """(the smallest threshold, θ in [0, π/2] where it is)."""
    angle = worst_angle(body.eps, body.kap)
    return threshold(body, angle, -1), angle


def border(body, mu, high_side):
    """θ in (0, π) where the threshold is μ, on either side of its minimum; nan where μ is below it."""
    worst = worst_angle(body.eps, body.kap)
    if not threshold(body, worst, -1) <= mu:
        return math.nan
    inside = worst
    outside = math.pi if high_side else 0.0
    while True:
        middle = 0.5 * (inside + outside)
        if middle in (inside, outside):
            return inside
        if threshold(body, middle, -1) <= mu:
            inside = middle
        else:
            outside = middle
