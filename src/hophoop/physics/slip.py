"""Slip: θ̇²(θ) from one linear ODE, the rest by quadrature (physics.md, 'Slip in quadrature')."""

from __future__ import annotations

import math

from hophoop._collocation import ORDER, REMAINDER_T, WEIGHTS, antiderivative, product, resolved
from hophoop._jit import jit
from hophoop.physics.contact import slip_motion, slip_stiffness, slip_torque_arm
from hophoop.physics.panel import (
    ARRIVE,
    COSINE,
    LINEAR,
    LOSS,
    NORMAL,
    RATE,
    RESOLVED,
    SINE,
    SLIP,
    SLIP_RATE,
    STRETCH,
    TIME,
    A,
    B,
    Totals,
    U,
    fill_geometry,
)


@jit
def _from_reference(panel, values, out):
    """∫ values dξ from `ref` to each node, signed along θ; returns the integral from `ref` to the far end."""
    if panel.kind == ARRIVE:
        product(REMAINDER_T, values, out)
        total = 0.0
        for i in range(ORDER):
            out[i] *= -panel.way
            total += WEIGHTS[i] * values[i]
        return -panel.way * total
    total = antiderivative(values, out)
    for i in range(ORDER):
        out[i] *= panel.way
    return panel.way * total


@jit
def solve_slip(body, panel, work):
    """Fill `work` for a slip panel: du/dθ = a u + b by its integrating factor, then t, v_t and the friction work.

    Where the panel reaches beyond a turning point only the row U is meaningful (and the answer is not fine).
    """
    fill_geometry(panel, work)
    sigma = panel.sigma
    for i in range(ORDER):
        s = work[SINE, i]
        c = work[COSINE, i]
        q = slip_torque_arm(body, s, c, sigma)
        stiffness = slip_stiffness(body, s, c, sigma)
        if not stiffness > 0.0:
            return Totals(False, 0.0, math.nan, 0.0, 0.0)
        work[A, i] = -2.0 * q * body.eps * c / stiffness * work[STRETCH, i]
        work[B, i] = 2.0 * q * body.gn / stiffness * work[STRETCH, i]
    if not resolved(work[A], RESOLVED, 0.5):
        return Totals(False, 0.0, math.nan, 0.0, 0.0)
    exponent = _from_reference(panel, work[A], work[TIME])
    for i in range(ORDER):
        growth = math.exp(work[TIME, i])
        work[NORMAL, i] = growth
        work[B, i] /= growth
    driven = _from_reference(panel, work[B], work[TIME])
    for i in range(ORDER):
        work[U, i] = work[NORMAL, i] * (panel.u + work[TIME, i])
    u_far = math.exp(exponent) * (panel.u + driven)
    for i in range(ORDER):
        u = work[U, i]
        if not u > 0.0:
            return Totals(False, 0.0, u_far, 0.0, 0.0)
        _, normal, slip_rate = slip_motion(body, work[SINE, i], work[COSINE, i], u, sigma)
        rate = work[STRETCH, i] / math.sqrt(u)
        work[RATE, i] = rate
        work[NORMAL, i] = normal
        work[SLIP_RATE, i] = slip_rate * rate
    if not (resolved(work[RATE], RESOLVED, 0.0) and resolved(work[NORMAL], RESOLVED, body.gn + panel.u)):
        return Totals(False, 0.0, u_far, 0.0, 0.0)
    if panel.kind == LINEAR and not u_far > 0.0:
        return Totals(False, 0.0, u_far, 0.0, 0.0)
    time = antiderivative(work[RATE], work[TIME])
    vt = panel.vt + antiderivative(work[SLIP_RATE], work[SLIP])
    for i in range(ORDER):
        work[SLIP, i] += panel.vt
        # power of friction; no abs(), so that it stays smooth beyond the end of the slip
        work[A, i] = sigma * body.mu_k * work[NORMAL, i] * work[SLIP, i] * work[RATE, i]
    loss = antiderivative(work[A], work[LOSS])
    return Totals(True, time, 0.0 if panel.kind == ARRIVE else u_far, vt, loss)


@jit
def slip_displacement(body, sigma, vt, om, s, c, ds, dc, tau):
    """Change of x over the time tau from a state of slip: gravity alone changes ẋ_G + σ μk ẏ_G."""
    pull = sigma * body.mu_k
    speed = vt + om * (1.0 + body.eps * c) - pull * body.eps * om * s
    steady = body.gt - pull * body.gn
    return speed * tau + 0.5 * steady * tau * tau - pull * body.eps * dc - body.eps * ds
