"""Time derivatives at an instant: truncated Taylor series along a candidate motion (docs/model.md#which-mode-follows).

They decide ties: if a quantity that selects the next mode is zero, its first nonzero derivative decides. A series is a tuple of
its first 5 coefficients, since kernels for a GPU cannot allocate arrays.
"""

from __future__ import annotations

from hophoop.kernel.native import apart
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.contact import cone_weights
from hophoop.kernel.physics.resistance import resistance_arm

TERMS = 5
ZERO = 1e-11  # relative to the scale of the others; a smaller coefficient counts as zero


def _times(a, b):
    a0, a1, a2, a3, a4 = a
    b0, b1, b2, b3, b4 = b
    return (
        a0 * b0,
        a0 * b1 + a1 * b0,
        a0 * b2 + a1 * b1 + a2 * b0,
        a0 * b3 + a1 * b2 + a2 * b1 + a3 * b0,
        a0 * b4 + a1 * b3 + a2 * b2 + a3 * b1 + a4 * b0,
    )


def _over(a, b):
    b0, b1, b2, b3, b4 = b
    q0 = a[0] / b0
    q1 = (a[1] - q0 * b1) / b0
    q2 = (a[2] - q0 * b2 - q1 * b1) / b0
    q3 = (a[3] - q0 * b3 - q1 * b2 - q2 * b1) / b0
    q4 = (a[4] - q0 * b4 - q1 * b3 - q2 * b2 - q3 * b1) / b0
    return q0, q1, q2, q3, q4


def _sum(x, a, y, b):
    """Return the series x a + y b."""
    return (
        x * a[0] + y * b[0],
        x * a[1] + y * b[1],
        x * a[2] + y * b[2],
        x * a[3] + y * b[3],
        x * a[4] + y * b[4],
    )


def _shifted(value, x, a):
    """Return the series value + x a."""
    return x * a[0] + value, x * a[1], x * a[2], x * a[3], x * a[4]


def _sine_cosine(th, rate):
    # s' = c th' and c' = −s th', coefficient by coefficient
    r0, r1, r2, r3, _ = rate
    s0, c0 = sine_and_cosine(th)
    s1 = r0 * c0
    c1 = -(r0 * s0)
    s2 = r0 * c1 / 2 + r1 * c0 / 2
    c2 = -(r0 * s1 / 2) - r1 * s0 / 2
    s3 = r0 * c2 / 3 + r1 * c1 / 3 + r2 * c0 / 3
    c3 = -(r0 * s2 / 3) - r1 * s1 / 3 - r2 * s0 / 3
    s4 = r0 * c3 / 4 + r1 * c2 / 4 + r2 * c1 / 4 + r3 * c0 / 4
    c4 = -(r0 * s3 / 4) - r1 * s2 / 4 - r2 * s1 / 4 - r3 * s0 / 4
    return (s0, s1, s2, s3, s4), (c0, c1, c2, c3, c4)


@apart
def candidate_series(body, th, om, sigma):
    """Return Taylor coefficients of (N, cone margin at F > 0, at F < 0, v̇_t) in rolling (sigma = 0) or slip."""
    eps = body.eps
    drag = sigma * body.mu_k
    sine, cosine = sine_and_cosine(th)
    rho = resistance_arm(body, sine, cosine, om, sigma)
    a, b = cone_weights(body.mu_s)
    normal = (0.0, 0.0, 0.0, 0.0, 0.0)
    friction = normal
    slip = normal
    rate = (om, 0.0, 0.0, 0.0, 0.0)
    for _ in range(TERMS):  # each pass determines one more coefficient of the angular velocity
        s, c = _sine_cosine(th, rate)
        u = _times(rate, rate)
        arm = _shifted(1.0, eps, c)
        centrifugal = _shifted(0.0, eps, _times(s, u))
        if sigma == 0:
            inertia = _shifted(1.0 + body.kap + eps * eps, 2.0 * eps, c)
            torque = _sum(1.0, _sum(1.0, centrifugal, eps * body.gn, s), body.gt, arm)
            if rho != 0.0:
                inertia = _sum(1.0, inertia, -rho * eps, s)
                torque = _shifted(-rho * body.gn, 1.0, _sum(1.0, torque, rho * eps, _times(c, u)))
            alpha = _over(torque, inertia)
            friction = _shifted(-body.gt, 1.0, _sum(1.0, _times(alpha, arm), -1.0, centrifugal))
            normal = _shifted(body.gn, -eps, _sum(1.0, _times(s, alpha), 1.0, _times(c, u)))
        else:
            q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != 0.0 else _sum(eps, s, drag, arm)
            stiffness = _shifted(body.kap, eps, _times(s, q))
            load = _over(_shifted(body.gn, -eps, _times(c, u)), stiffness)
            alpha = _times(q, load)
            normal = _shifted(0.0, body.kap, load)
            part = _shifted(drag * body.kap, 1.0, _times(arm, q))
            slip = _shifted(body.gt, 1.0, _sum(1.0, centrifugal, -1.0, _times(load, part)))
        rate = om, alpha[0], alpha[1] / 2, alpha[2] / 3, alpha[3] / 4
    return normal, _sum(a, normal, -b, friction), _sum(a, normal, b, friction), slip


def leading_sign(series, scale):
    """Return the sign of the first nonzero coefficient, 0 if all are zero."""
    for value in series:
        if abs(value) > ZERO * scale:
            return 1 if value > 0.0 else -1
    return 0
