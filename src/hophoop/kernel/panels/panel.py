"""A panel, a piece of rolling or slip: θ at its nodes, and the computations that both modes share.

Time follows from θ by quadrature, dt = dθ/θ̇, which is singular where θ̇ → 0. So a panel that ends (`ARRIVE`) or starts
(`LEAVE`) at a turning point θ_m uses s with θ = θ_m ∓ s², where dt/ds = 2/√(θ̇²/s²) is smooth.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, antiderivative
from hophoop.kernel.numerics.double_double import plus
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.numerics.tables import END_SINES, END_VERSINES, NODE_SINES, NODE_VERSINES, NODES, WIDTHS
from hophoop.kernel.numerics.trigonometry import SMALL, sine_and_versine, small_turn_deficits, turn
from hophoop.kernel.physics.roll import rest_curvature

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
# Rows of the scratch array of a panel: values at the nodes.
SINE, COSINE, STRETCH, U, RATE, TIME, NORMAL, SLIP_RATE, SLIP, POWER, LOSS, ARM, STIFFNESS, A, B = range(15)
RESIST, RESISTED = 15, 16  # power and work of the rolling resistance
ROWS = 17
RESOLVED = 2e-13  # maximum size of the last 3 Chebyshev coefficients of an accepted panel; the next one is about 1e-15


class Panel(NamedTuple):
    """All numbers needed to compute a panel again, to the last bit."""

    sigma: int  # 0 roll, ±1 slip
    kind: int  # LINEAR, ARRIVE or LEAVE
    level: int  # of a LINEAR panel's width
    way: float  # ±1, the sign of θ̇
    ref: float  # θ at the start (LINEAR, LEAVE) or at the turning point ahead (ARRIVE), within one revolution
    ref_low: float  # low-order half of `ref`
    sine: float  # sin θ and cos θ at `ref`
    cosine: float
    extent: float  # abs(Δθ) over the panel
    arm: float  # slip: q and κ p_σ at `ref`; roll: −dV/dθ, less ρ g_n, and d²V/dθ² of the potential V
    stiffness: float
    u: float  # θ̇² at `ref`
    vt: float  # slip velocity at the start


class Totals(NamedTuple):
    """Changes over a whole panel."""

    tail: float  # size of the last Chebyshev coefficients, the panel's error measure
    time: float
    u: float  # θ̇² at the end; for an ARRIVE panel, which ends at rest, at the start
    vt: float
    loss: float
    growth: float  # slip: growth of a difference of θ̇² between two motions, from `ref` to the far end
    resisted: float  # energy lost to rolling resistance


@inline
def rows_are_known(work):
    """Return True always; the compiler then knows the stride of the rows and vectorizes over the nodes."""
    return work.shape[1] == ORDER


@apart
def fill_narrow(way, half, sines, versines, stretch):
    """Fill the geometry of a panel narrower than the tables, as `fill_geometry` does."""
    for i in range(ORDER):
        offset = half * (1.0 + NODES[i])
        sines[i] = way * offset
        versines[i] = 0.5 * offset * offset
        stretch[i] = half


@inline
def fill_geometry(panel, work):
    """Fill rows A and B with sin φ and 1 − cos φ of φ = θ − θ_ref at the nodes, and STRETCH with abs(dθ/dξ)."""
    sines = work[A]
    versines = work[B]
    stretch = work[STRETCH]
    if panel.kind == LINEAR:
        way = panel.way
        if panel.level >= LEVELS:
            fill_narrow(way, 0.5 * panel.extent, sines, versines, stretch)
            return
        # one loop per row: each compiles to one block copy, which the next reader of the row need not wait for
        table = SINES[1 if way > 0.0 else 0, panel.level]
        other = NODE_VERSINES[panel.level]
        halves = HALVES[panel.level]
        for i in range(ORDER):
            sines[i] = table[i]
        for i in range(ORDER):
            versines[i] = other[i]
        for i in range(ORDER):
            stretch[i] = halves[i]
        return
    way = panel.way
    mirrored = 1.0
    if panel.kind == ARRIVE:
        way = -way
        mirrored = -1.0
    for i in range(ORDER):
        stretch[i] = panel.extent * (0.5 * (1.0 + mirrored * NODES[i]))
    if panel.extent > SMALL:
        for i in range(ORDER):
            offset = stretch[i] * (0.5 * (1.0 + mirrored * NODES[i]))
            s, versines[i] = sine_and_versine(offset)
            sines[i] = way * s
        return
    for i in range(ORDER):
        offset = stretch[i] * (0.5 * (1.0 + mirrored * NODES[i]))
        deficit, _, versine = small_turn_deficits(offset)
        sines[i] = way * (offset - deficit)
        versines[i] = versine


@inline
def angle_at(panel, xi):
    """Return θ − ref at ξ."""
    if panel.kind == LINEAR:
        return panel.way * panel.extent * 0.5 * (1.0 + xi)
    if panel.kind == ARRIVE:
        part = 0.5 * (1.0 - xi)
        return -panel.way * panel.extent * part * part
    part = 0.5 * (1.0 + xi)
    return panel.way * panel.extent * part * part


@inline
def xi_of_offset(panel, offset):
    """Return ξ where abs(θ − ref) = offset."""
    if panel.kind == LINEAR:
        return 2.0 * offset / panel.extent - 1.0
    part = math.sqrt(offset / panel.extent)
    return 1.0 - 2.0 * part if panel.kind == ARRIVE else 2.0 * part - 1.0


class PanelStart(NamedTuple):
    """Start of a panel, to which the functions on the panel are relative."""

    th: float
    th_low: float
    sine: float
    cosine: float
    arm: float
    stiffness: float
    u: float
    vt: float


@inline
def linear_panel(sigma, level, way, begin):
    """Return a panel of standard width."""
    return Panel(
        sigma, LINEAR, level, way, begin.th, begin.th_low, begin.sine, begin.cosine, width_of(level),
        begin.arm, begin.stiffness, begin.u, begin.vt,
    )  # fmt: skip


@inline
def no_panel(kind, sigma, way):
    """Return a placeholder panel for a segment without one: FLY, HOLD or SKIMMING."""
    return Panel(sigma, kind, 0, way, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@inline
def leaving_panel(sigma, way, extent, begin):
    """Return a panel that starts at rest."""
    return Panel(
        sigma, LEAVE, 0, way, begin.th, begin.th_low, begin.sine, begin.cosine, extent,
        begin.arm, begin.stiffness, 0.0, begin.vt,
    )  # fmt: skip


def arriving_panel(body, before, ahead):
    """Return a panel from the start of the linear panel `before` to a turning point at the angle `ahead`.

    The quantities at the turning point are computed as changes from the start. Evaluated directly they would have a rounding
    error that near p_σ = 0 exceeds the panel's width.
    """
    ds, dc = turn(before.sine, before.cosine, before.way * ahead)
    s = before.sine + ds
    if before.sigma == 0:
        arm = before.arm + body.eps * (body.gn * ds + body.gt * dc)
        stiffness = before.stiffness - rest_curvature(body, ds, dc)
    else:
        turned = body.eps * (ds + before.sigma * body.mu_k * dc)
        arm = before.arm + turned
        stiffness = before.stiffness + body.eps * (ds * arm + before.sine * turned)
    ref, low = plus(before.ref, before.ref_low, before.way * ahead)
    return Panel(before.sigma, ARRIVE, 0, before.way, ref, low, s, before.cosine + dc, ahead, arm, stiffness, 0.0, before.vt)


@inline
def sine_versine_of_offset(panel, xi):
    """Return (sin φ, 1 − cos φ) of φ = θ − θ_ref at ξ; a whole LINEAR panel takes them from the table."""
    if panel.kind == LINEAR and xi >= 1.0 and panel.level < LEVELS:
        return panel.way * END_SINES[panel.level], END_VERSINES[panel.level]
    angle = angle_at(panel, xi)
    return sine_and_versine(angle)


@inline
def fill_inside(panel, work):
    """Fill the rows TIME and LOSS of a solved panel, which are only needed for positions inside it."""
    antiderivative(work[RATE], work[TIME])
    if panel.sigma != 0:
        antiderivative(work[POWER], work[LOSS])
