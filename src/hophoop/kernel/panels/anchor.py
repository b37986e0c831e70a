"""Conserved energy of rolling, relative to the nearest equilibrium (docs/model.md#near-an-equilibrium).

Rolling without resistance conserves D θ̇² + 2 V(θ). A hoop that passes the top at 1e-8 m/s has θ̇² = 1e-16 there, which rounding
of the earlier θ̇² = 10 would hide. So the small number is kept over the phase, and each panel computes θ̇² from it:

    D θ̇² = excess + 2 [B (1 − cos ψ) + g_t (ψ − sin ψ)],  ψ = θ − θ_base,  B = ε (g_n cos θ_base − g_t sin θ_base)

The base is the unstable equilibrium if the hoop comes near it, else the stable one.
"""

from __future__ import annotations

from typing import NamedTuple

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arcs import arcsine
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI, TWO_PI_LOW
from hophoop.kernel.numerics.circular import series_remainders, sine_and_cosine, sine_and_versine
from hophoop.kernel.physics.closed_forms import rest_curvature
from hophoop.kernel.physics.contact import inertia_at_height, load_height

CANCELS = 1e-2  # relative to its terms: if the sum is less, as near a turning point, θ̇² of the state has more digits


class Anchor(NamedTuple):
    """Conserved energy of a phase of rolling and the equilibrium to which it is relative."""

    excess: float
    base: float  # θ of the equilibrium, in the revolution `revolutions`
    revolutions: float
    bend: float  # B; positive at an unstable equilibrium, 0 without an anchor


NONE = Anchor(0.0, 0.0, 0.0, 0.0)


@inline
def has_equilibria(body):
    """Return True if rolling has an unstable and a stable equilibrium in each revolution."""
    return body.eps > 0.0 and body.gn > 0.0 and abs(body.gt) < body.eps


def rolling_unstable_equilibrium(body):
    """Return θ of the unstable equilibrium, ε sin(θ + β) = −sin β; requires `has_equilibria`."""
    return -arcsine(body.gt / body.eps) - body.slope if body.gt != 0.0 else 0.0


def rolling_stable_equilibrium(body, unstable, direction):
    """Return θ of the stable equilibrium on one side (±1) of the unstable one, π − 2β − θ_unstable."""
    return direction * PI - 2.0 * body.slope - unstable


@inline
def potential_drop(body, anchor, state, s, c):
    """Return B (1 − cos ψ) + g_t (ψ − sin ψ), the drop of V from the equilibrium to θ."""
    if body.gt == 0.0:  # ψ is θ or θ ± π: 1 − cos ψ without another sine
        height = c if anchor.bend > 0.0 else -c
        return anchor.bend * (s * s / (1.0 + height) if height > 0.0 else 1.0 - height)
    bent, _, versine = series_remainders(offset_from(anchor, state))
    return anchor.bend * versine + body.gt * bent


@inline
def offset_from(anchor, state):
    """Return ψ = θ − θ_base."""
    revolutions = state.revolutions - anchor.revolutions
    return (state.th - anchor.base) + revolutions * TWO_PI + (state.th_low + revolutions * TWO_PI_LOW)


@noinline
def rolling_anchor(body, state, s, c):
    """Return the anchor of a phase of rolling that starts in `state`; s and c are sin θ and cos θ.

    With rolling resistance nothing is conserved.
    """
    if body.resist > 0.0 or not has_equilibria(body):
        return NONE
    energy = inertia_at_height(body, load_height(s, c)) * (state.om * state.om)
    base = rolling_unstable_equilibrium(body)
    top, side = sine_and_cosine(base)
    bend = -rest_curvature(body, top, side)
    anchor = Anchor(0.0, base, state.revolutions, bend)
    excess = energy - 2.0 * potential_drop(body, anchor, state, s, c)
    if excess < -2.0 * bend:
        base = rolling_stable_equilibrium(body, base, 1.0 if offset_from(anchor, state) > 0.0 else -1.0)
        anchor = Anchor(0.0, base, state.revolutions, -bend)
        excess = energy - 2.0 * potential_drop(body, anchor, state, s, c)
    return Anchor(excess, anchor.base, anchor.revolutions, anchor.bend)


@inline
def rolling_panel_start(body, anchor, state, s, c):
    """Return (−dV/dθ, d²V/dθ², θ̇²) at the start of a rolling panel; without an anchor θ̇² is that of the state."""
    torque = body.eps * (body.gn * s + body.gt * c) + body.gt
    curvature = -rest_curvature(body, s, c)
    u = state.om * state.om
    if anchor.bend == 0.0:
        return torque, curvature, u
    if body.gt != 0.0:
        turned, versine = sine_and_versine(offset_from(anchor, state))
        torque = anchor.bend * turned + body.gt * versine
    lower = 2.0 * potential_drop(body, anchor, state, s, c)
    energy = anchor.excess + lower
    if energy > CANCELS * (abs(anchor.excess) + abs(lower)):
        u = energy / inertia_at_height(body, load_height(s, c))
    return torque, curvature, u
