"""The massless hoop, γ = 1 (docs/model.md#no-mass-in-the-ring).

While it rolls, the formulas of `roll` hold with κ = 0. When the contact force is lost, the load falls freely and the rim skims
the plane, so that θ follows from the height of the load.
"""

from __future__ import annotations

import math

from hophoop.kernel.numerics.arcs import arcsine
from hophoop.kernel.numerics.circular import sine, sine_and_cosine
from hophoop.kernel.numerics.trigonometry import versine_of

TOP_ROUNDING = 1e-8  # revolutions: this close to the top cos θ rounds to 1


def skim_duration(body, c, sink):
    """Return the time until the load strikes the plane, from cos θ and its sinking rate, which must not be negative."""
    gained = 2.0 * body.gn * (1.0 + c)  # increase of the squared rate
    if sink * sink > gained:  # at a high rate the difference below would lose all digits
        return 2.0 * (1.0 + c) / (sink + math.sqrt(sink * sink + gained))
    if body.gn == 0.0:
        return math.inf
    return (-sink + math.sqrt(sink * sink + gained)) / body.gn


def turns_before(th, way):
    """Return the revolutions in the direction `way` up to the top from which the load falls, with a tolerance for rounding."""
    return 1.0 * math.floor(way * (0.5 * th / math.pi) + TOP_ROUNDING)


def skim_state(body, x, th, vt, om, way, tau):
    """Return (x, θ, v_t, θ̇) after skimming for the time tau; θ̇ is infinite when the load strikes the plane."""
    s, c = sine_and_cosine(th)
    sink = s * om
    speed = vt + om * (1.0 + c)  # of the load, along the plane
    fallen = sink * tau + 0.5 * body.gn * tau * tau
    versine = versine_of(th) + fallen  # 1 − cos θ
    half = arcsine(math.sqrt(min(max(0.5 * versine, 0.0), 1.0)))
    th_end = way * (2.0 * math.pi * turns_before(th, way) + 2.0 * half)
    s_end = sine(2.0 * half)
    rate = sink + body.gn * tau
    if s_end > 0.0:
        om_end = way * rate / s_end
    else:
        om_end = way * math.sqrt(body.gn)
    if versine >= 2.0:
        om_end = way * math.inf
    along = speed + body.gt * tau
    x_end = x + s + speed * tau + 0.5 * body.gt * tau * tau - sine(th_end)
    return x_end, th_end, along - om_end * (2.0 - versine), om_end


def strike_limit(body, x, th, s, speed, way, tau):
    """Return (x, θ, v_t) at the strike, after skimming for the time tau; `speed` is the load's velocity along the plane.

    These are the limits of `skim_state`, in which θ̇ is unbounded.
    """
    x_end = x + s + speed * tau + 0.5 * body.gt * tau * tau
    th_end = way * math.pi * (2.0 * turns_before(th, way) + 1.0)
    return x_end, th_end, speed + body.gt * tau


def strike(body, vx, vy):
    """Return (v_x after, p_n, p_t) of the load that strikes the plane without rebound: a particle with friction."""
    p_n = -vy
    limit = body.mu_s * p_n
    if abs(vx) <= limit:
        return 0.0, p_n, -vx
    p_t = -math.copysign(body.mu_k * p_n, vx)
    return vx + p_t, p_n, p_t
