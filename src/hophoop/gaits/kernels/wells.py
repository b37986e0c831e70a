"""Wells of energy: where a hoop on a slope rocks for ever.

Rolling, x = θ (units of R and m), so that the potential energy is a function of θ alone, with one well per revolution:

    V = g_n ε (cos θ − 1) − g_t (θ + ε sin θ).

Let E be the kinetic energy plus V, in any contact. Rolling and rolling resistance never add to it, and slip changes it by

    dE/dt = −μk N abs(v_t) + g_t v_t,

which is negative in slip uphill, and in slip downhill if μk N > abs(g_t). So a hoop that is in contact in a well, below both
tops, stays there for ever if everywhere in the well, at all kinetic energies up to E − V,

* f_n < 0, so that no contact opens;
* μk N > abs(g_t) in slip downhill, with N = −f_n/p_σ.

Painlevé's paradox stays away: slip begins at the edge of the friction cone, where N p_σ = −f_n > 0. If p_σ fell to 0, not
faster than linearly since θ̇ is bounded, the impulse of N = −f_n/p_σ would be infinite, and it stops the slip before. With
rolling resistance p_σ > 0 is required, too.

In slip f_n depends on θ and θ̇² alone, and θ̇² ≤ 2 (E − V)/(κ + ε² sin² θ), because the kinetic energy is at least that of θ̇
with the centre of gravity moving across the plane. `stays_in_well` bounds all these from the safe side on pieces of the well.
So 'True' is a proof, up to rounding (10⁻¹⁴ against a margin of 10⁻⁹). 'False' proves nothing: slip may not occur where it would
gain energy, and all slips of a swing together may lose it although one gains.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.theory.kernels.arcs import first_maximum

PIECES, PARTS = 96, 16  # of a well, and of a piece on which the bounds are too wide
MARGIN = 1e-9  # relative, for rounding


@noinline
def rolling_potential(body, s, c, th):
    """Return V from θ, its sine and its cosine."""
    return body.eps * body.gn * (c - 1.0) - body.gt * (th + body.eps * s)


@noinline
def stays_in_well(body, th, slip, om):
    """Return True if a hoop in contact never leaves its well of energy nor the plane; False proves nothing."""
    top = first_maximum(body)
    if not (body.kap > 0.0 and 0.0 < body.mu_k < math.inf and not math.isnan(top)):
        return False
    th -= TWO_PI * math.floor((th - top) / TWO_PI)
    s, c = sine_cosine(th, 0.0)
    along, up = slip + om * (1.0 + body.eps * c), body.eps * om * s
    energy = 0.5 * (along * along + up * up + body.kap * om * om) + rolling_potential(body, s, c, th)
    s, c = sine_cosine(top, 0.0)
    lower = rolling_potential(body, s, c, top) - max(TWO_PI * body.gt, 0.0)
    if not energy < lower - MARGIN:
        return False
    half = PI / PIECES
    for k in range(PIECES):
        th = top + (2 * k + 1) * half
        if is_held(body, th, half, energy):
            continue
        for part in range(PARTS):
            if not is_held(body, th + half * ((2 * part + 1) / PARTS - 1.0), half / PARTS, energy):
                return False
    return True


@noinline
def is_held(body, th, half, energy):
    """Return True if no state within `half` of θ, with at most this E, leaves the plane, jams or gains E in slip."""
    s, c = sine_cosine(th, 0.0)  # which change by at most `half`
    steepest = body.eps * body.gn + abs(body.gt) * (1.0 + body.eps)  # of V
    free = energy - rolling_potential(body, s, c, th) + half * steepest
    if free < 0.0:
        return True
    cosine = min(c + half, 1.0)
    lever, farthest = body.eps * max(abs(s) - half, 0.0), body.eps * (abs(s) + half)
    load = body.gn - body.eps * max(cosine, 0.0) * 2.0 * free / (body.kap + lever * lever)  # −f_n, the least
    stiffness = body.kap + lever * lever - farthest * (body.mu_k * (1.0 + body.eps * cosine) + body.resist)  # κ p_σ, the least
    if not load > MARGIN or (body.resist > 0.0 and not stiffness > MARGIN):
        return False
    ahead = body.eps * ((s if body.gt > 0.0 else -s) + half)  # σ ε sin θ in slip downhill, the most
    arm = 1.0 + body.eps * (cosine if ahead > 0.0 else c - half)
    most = body.kap + farthest * (farthest + body.resist) + body.mu_k * ahead * arm
    return body.mu_k * body.kap * load > (1.0 + MARGIN) * abs(body.gt) * most
