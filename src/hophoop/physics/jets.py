"""Time derivatives at an instant: truncated Taylor series along a candidate motion.

Only ties need them: where a quantity that decides on the next mode is zero, its first derivative that is
not zero decides.
"""

from __future__ import annotations

import math

import numpy as np

from hophoop._jit import jit
from hophoop.physics.contact import cone_weights

DEGREE = 6
ZERO = 1e-11  # a coefficient this small beside the others' scale counts as zero


@jit
def _times(a, b):
    out = np.zeros(DEGREE + 1)
    for i in range(DEGREE + 1):
        for j in range(i + 1):
            out[i] += a[j] * b[i - j]
    return out


@jit
def _over(a, b):
    out = np.zeros(DEGREE + 1)
    for i in range(DEGREE + 1):
        value = a[i]
        for j in range(i):
            value -= out[j] * b[i - j]
        out[i] = value / b[0]
    return out


@jit
def _sine_cosine(th):
    s = np.zeros(DEGREE + 1)
    c = np.zeros(DEGREE + 1)
    s[0] = math.sin(th[0])
    c[0] = math.cos(th[0])
    for i in range(1, DEGREE + 1):
        for j in range(1, i + 1):
            s[i] += j * th[j] * c[i - j] / i
            c[i] -= j * th[j] * s[i - j] / i
    return s, c


@jit
def candidate_series(body, th, om, sigma):
    """Taylor coefficients of (N, cone margin at F > 0, at F < 0, v̇_t) in rolling (sigma = 0) or slip."""
    eps = body.eps
    angle = np.zeros(DEGREE + 1)
    angle[0] = th
    angle[1] = om
    a, b = cone_weights(body.mu_s)
    normal = np.zeros(DEGREE + 1)
    friction = np.zeros(DEGREE + 1)
    slip = np.zeros(DEGREE + 1)
    for _ in range(DEGREE + 1):  # each pass makes one more coefficient of the angle right
        s, c = _sine_cosine(angle)
        rate = np.zeros(DEGREE + 1)
        for i in range(DEGREE):
            rate[i] = (i + 1) * angle[i + 1]
        u = _times(rate, rate)
        arm = eps * c
        arm[0] += 1.0
        pull = eps * _times(s, u)
        if sigma == 0:
            inertia = 2.0 * eps * c
            inertia[0] += 1.0 + body.kap + eps * eps
            torque = pull + eps * body.gn * s + body.gt * arm
            alpha = _over(torque, inertia)
            friction = _times(alpha, arm) - pull
            friction[0] -= body.gt
            normal = -eps * (_times(s, alpha) + _times(c, u))
            normal[0] += body.gn
        else:
            q = eps * s + sigma * body.mu_k * arm
            stiffness = eps * _times(s, q)
            stiffness[0] += body.kap
            load = -eps * _times(c, u)
            load[0] += body.gn
            load = _over(load, stiffness)
            alpha = _times(q, load)
            normal = body.kap * load
            part = _times(arm, q)
            part[0] += sigma * body.mu_k * body.kap
            slip = pull - _times(load, part)
            slip[0] += body.gt
        for i in range(DEGREE - 1):
            angle[i + 2] = alpha[i] / ((i + 1) * (i + 2))
    return normal, a * normal - b * friction, a * normal + b * friction, slip


@jit
def leading_sign(series, scale):
    """Sign of the first coefficient that is not zero, 0 if all are."""
    for i in range(DEGREE - 1):
        if abs(series[i]) > ZERO * scale:
            return 1 if series[i] > 0.0 else -1
    return 0
