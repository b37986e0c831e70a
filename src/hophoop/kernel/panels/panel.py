"""A panel, a piece of rolling or slip: θ at its nodes, and the computations that both modes share.

Time follows from θ by quadrature, dt = dθ/θ̇, which is singular where θ̇ → 0. So a panel that ends (`ARRIVE`) or starts
(`LEAVE`) at a turning point θ_m uses s with θ = θ_m ∓ s², where dt/ds = 2/√(θ̇²/s²) is smooth.

`panels.solve` solves a panel: it fills the rows of its scratch array with values at the nodes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.arithmetic import plus
from hophoop.kernel.numerics.circular import SMALL, sine_and_versine, sine_cosine_change, small_series_remainders
from hophoop.kernel.numerics.collocation import ORDER, antiderivative, integrals, remainders, total
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.numerics.tables import END_SINES, END_VERSINES, NODE_SINES, NODE_VERSINES, NODES, WIDTHS
from hophoop.kernel.physics.closed_forms import rest_curvature

LEVELS = len(WIDTHS)  # widths 0.9 rad · 2^(−k/2)
SINES = np.stack([-NODE_SINES, NODE_SINES])  # backward and forward
HALVES = np.repeat(WIDTHS[:, None] / 2, ORDER, axis=1)


@inline
def width_of(level):
    """Return the width of a panel; levels narrower than the tables have sin φ = φ to rounding."""
    if level < LEVELS:
        return WIDTHS[level]
    return WIDTHS[LEVELS - 1] * power(0.5, 0.5 * (level - (LEVELS - 1)))


LINEAR, ARRIVE, LEAVE, FLY, HOLD, SKIMMING = 0, 1, 2, 3, 4, 5
STRUCK = 1.0  # value of ξ in a segment that ends with the strike of the load

# Rows of the scratch array: values at the nodes of a panel. φ = θ − θ_ref; derivatives and integrals are along ξ.
OFFSET_SINE, OFFSET_VERSINE, STRETCH = 0, 1, 2  # sin φ, 1 − cos φ, abs(dθ/dξ)
SINE, COSINE, U, RATE, TIME = 3, 4, 5, 6, 7  # sin θ, cos θ, θ̇², dt/dξ, time since the start of the panel
# The linear equation for θ̇² in slip, for D′ θ̇² in rolling with resistance: dE = DAMPING E dξ + DRIVE dξ, both signed along θ.
DAMPING, EXPONENT, GROWTH = 8, 9, 10  # ∫ DAMPING dξ from `ref`, and its exponential
DRIVE, SCALED_DRIVE, DRIVEN = 11, 12, 13  # SCALED_DRIVE = DRIVE/GROWTH, and its integral from `ref`
ENERGY, INERTIA = 14, 15  # rolling: D θ̇², and D; with resistance D′ θ̇², and D′
ARM, KAPPA_P_SIGMA, LEVER = 16, 17, 18  # slip: q, κ p_σ, 1 + ε cos θ
NORMAL, SLIP_RATE, SLIP = 19, 20, 21  # N; slip: dv_t/dξ, v_t
POWER, LOSS = 22, 23  # slip: friction power per ξ, and its integral
ROLLING_POWER, ROLLING_LOSS = 24, 25  # the same for the rolling resistance
FORWARD_MARGIN, BACKWARD_MARGIN = 26, 27  # rolling: to the side of the friction cone with F > 0, F < 0; positive inside
LIFT_OFF_MARGIN, SLIP_END_MARGIN = 28, 29  # slip: −f_n, σ v_t
TIME_LEFT = 30
ROWS = 31

RESOLVED = 2e-13  # maximum size of the last 3 Chebyshev coefficients of an accepted panel; the next one is about 1e-15


class Panel(NamedTuple):
    """All numbers needed to compute a panel again, to the last bit."""

    sigma: int  # 0 roll, ±1 slip
    kind: int  # LINEAR, ARRIVE or LEAVE
    level: int  # of a LINEAR panel's width
    direction: float  # ±1, the sign of θ̇
    ref: float  # θ at the start (LINEAR, LEAVE) or at the turning point ahead (ARRIVE), within one revolution
    ref_low: float  # low-order half of `ref`
    sine: float  # sin θ and cos θ at `ref`
    cosine: float
    extent: float  # abs(Δθ) over the panel
    torque: float  # roll: −dV/dθ at `ref`, less ρ g_n with rolling resistance, of the potential V
    curvature: float  # roll: d²V/dθ² at `ref`
    arm: float  # slip: q at `ref`
    kappa_p_sigma: float  # slip: κ p_σ at `ref`
    u: float  # θ̇² at `ref`
    vt: float  # slip velocity at the start


class Totals(NamedTuple):
    """Changes over a whole panel."""

    tail: float  # size of the last Chebyshev coefficients, the panel's error measure
    time: float
    u: float  # θ̇² at the end; for an ARRIVE panel, which ends at rest, at the start
    vt: float
    loss: float
    rolling_loss: float  # energy lost to rolling resistance


@inline
def rows_are_known(work):
    """Return True always; the compiler then knows the stride of the rows and vectorizes over the nodes."""
    return work.shape[1] == ORDER


@noinline
def fill_narrow(direction, half, sines, versines, stretch):
    """Fill the geometry of a panel narrower than the tables, as `fill_geometry` does."""
    for i in range(ORDER):
        offset = half * (1.0 + NODES[i])
        sines[i] = direction * offset
        versines[i] = 0.5 * offset * offset
        stretch[i] = half


@inline
def fill_geometry(panel, work):
    """Fill the rows OFFSET_SINE, OFFSET_VERSINE and STRETCH."""
    sines = work[OFFSET_SINE]
    versines = work[OFFSET_VERSINE]
    stretch = work[STRETCH]
    if panel.kind == LINEAR:
        direction = panel.direction
        if panel.level >= LEVELS:
            fill_narrow(direction, 0.5 * panel.extent, sines, versines, stretch)
            return
        # one loop per row: each compiles to one block copy, which the next reader of the row need not wait for
        table = SINES[1 if direction > 0.0 else 0, panel.level]
        other = NODE_VERSINES[panel.level]
        halves = HALVES[panel.level]
        for i in range(ORDER):
            sines[i] = table[i]
        for i in range(ORDER):
            versines[i] = other[i]
        for i in range(ORDER):
            stretch[i] = halves[i]
        return
    direction = panel.direction
    mirrored = 1.0
    if panel.kind == ARRIVE:
        direction = -direction
        mirrored = -1.0
    for i in range(ORDER):
        stretch[i] = panel.extent * (0.5 * (1.0 + mirrored * NODES[i]))
    if panel.extent > SMALL:
        for i in range(ORDER):
            offset = stretch[i] * (0.5 * (1.0 + mirrored * NODES[i]))
            s, versines[i] = sine_and_versine(offset)
            sines[i] = direction * s
        return
    for i in range(ORDER):
        offset = stretch[i] * (0.5 * (1.0 + mirrored * NODES[i]))
        deficit, _, versine = small_series_remainders(offset)
        sines[i] = direction * (offset - deficit)
        versines[i] = versine


@inline
def angle_at(panel, xi):
    """Return θ − ref at ξ."""
    if panel.kind == LINEAR:
        return panel.direction * panel.extent * 0.5 * (1.0 + xi)
    if panel.kind == ARRIVE:
        part = 0.5 * (1.0 - xi)
        return -panel.direction * panel.extent * part * part
    part = 0.5 * (1.0 + xi)
    return panel.direction * panel.extent * part * part


@inline
def xi_of_offset(panel, offset):
    """Return ξ where abs(θ − ref) = offset."""
    if panel.kind == LINEAR:
        return 2.0 * offset / panel.extent - 1.0
    part = math.sqrt(offset / panel.extent)
    return 1.0 - 2.0 * part if panel.kind == ARRIVE else 2.0 * part - 1.0


@inline
def linear_panel(begin, level):
    """Return a panel of standard width from the start of a panel."""
    return replaced(begin, level=level, extent=width_of(level))


@inline
def leaving_panel(begin, extent):
    """Return a panel from the start of a panel at rest."""
    return replaced(begin, kind=LEAVE, extent=extent, u=0.0)


@inline
def no_panel(kind, sigma, direction):
    """Return a placeholder for a segment without a panel: FLY, HOLD or SKIMMING."""
    return Panel(sigma, kind, 0, direction, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def arriving_panel(body, before, ahead):
    """Return a panel from the start of the linear panel `before` to a turning point at the angle `ahead`.

    The quantities at the turning point are computed as changes from the start. Evaluated directly they would have a rounding
    error that near p_σ = 0 exceeds the panel's width.
    """
    ds, dc = sine_cosine_change(before.sine, before.cosine, before.direction * ahead)
    s = before.sine + ds
    torque = curvature = arm = kappa_p_sigma = 0.0
    if before.sigma == 0:
        torque = before.torque + body.eps * (body.gn * ds + body.gt * dc)
        curvature = before.curvature - rest_curvature(body, ds, dc)
    else:
        turned = body.eps * (ds + before.sigma * body.mu_k * dc)
        arm = before.arm + turned
        kappa_p_sigma = before.kappa_p_sigma + body.eps * (ds * arm + before.sine * turned)
    ref, low = plus(before.ref, before.ref_low, before.direction * ahead)
    return replaced(
        before, kind=ARRIVE, level=0, ref=ref, ref_low=low, sine=s, cosine=before.cosine + dc, extent=ahead,
        torque=torque, curvature=curvature, arm=arm, kappa_p_sigma=kappa_p_sigma, u=0.0,
    )  # fmt: skip


@inline
def sine_versine_of_offset(panel, xi):
    """Return (sin φ, 1 − cos φ) of φ = θ − θ_ref at ξ; a whole LINEAR panel takes them from the table."""
    if panel.kind == LINEAR and xi >= 1.0 and panel.level < LEVELS:
        return panel.direction * END_SINES[panel.level], END_VERSINES[panel.level]
    angle = angle_at(panel, xi)
    return sine_and_versine(angle)


@inline
def fill_inside(panel, work):
    """Fill the rows TIME and LOSS of a solved panel, which are only needed for positions inside it."""
    antiderivative(work[RATE], work[TIME])
    if panel.sigma != 0:
        antiderivative(work[POWER], work[LOSS])


@inline
def direction_from_reference(panel):
    """Return ±1, the direction of θ from `ref` to the far end of a panel."""
    return -panel.direction if panel.kind == ARRIVE else panel.direction


@inline
def away_from_reference(panel, values, out):
    """Integrate values abs(dξ) from `ref` to each node; return the integral from `ref` to the far end."""
    if panel.kind == ARRIVE:
        remainders(values, out)
    else:
        integrals(values, out)
    return total(values)


@inline
def from_reference(panel, values, out):
    """Integrate as `away_from_reference`, with the sign of dθ."""
    whole = away_from_reference(panel, values, out)
    direction = direction_from_reference(panel)
    for i in range(ORDER):
        out[i] *= direction
    return direction * whole


@inline
def fill_rolling_power(body, work):
    """Fill ROLLING_POWER of a solved panel; return the energy lost to rolling resistance on it."""
    for i in range(ORDER):
        work[ROLLING_POWER, i] = body.resist * work[NORMAL, i] * work[STRETCH, i]
    return total(work[ROLLING_POWER])
