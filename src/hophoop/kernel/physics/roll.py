"""Rolling: θ̇²(θ) in closed form (docs/model.md#rolling-in-closed-form)."""

from __future__ import annotations

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.trigonometry import rotated, sine_and_versine, turn_deficits
from hophoop.kernel.physics.contact import inertia_at_height, load_height


@inline
def rest_curvature(body, s, c):
    """Return V″(θ) of rolling contact, V = ε (g_n cos θ − g_t sin θ) − g_t θ; negative at an unstable equilibrium."""
    return body.eps * (body.gt * s - body.gn * c)


def rolling_energy_change(body, s0, c0, sine, versine, angle):
    """Return the change of D θ̇² over an angle φ, from sin φ and 1 − cos φ.

    Written with torque and stiffness at the start, so that nothing cancels near an equilibrium on a slope, where the moments of
    hoop and slope balance.
    """
    change = sine * (body.eps * (body.gn * s0 + body.gt * c0) + body.gt)
    change += versine * body.eps * (body.gn * c0 - body.gt * s0)
    if body.gt != 0.0:
        change += body.gt * turn_deficits(angle)[0]
    return 2.0 * change


def _u_after(body, s0, c0, u0, sine, versine, angle):
    inertia = inertia_at_height(body, load_height(s0, c0))
    energy = inertia * u0 + rolling_energy_change(body, s0, c0, sine, versine, angle)
    return energy / (inertia + 2.0 * body.eps * rotated(s0, c0, sine, versine)[1])


def rolling_u(body, th0, u0, offset):
    """Return θ̇² at th0 + offset of a hoop that rolls with θ̇² = u0 at th0; negative if it does not get there."""
    s0, c0 = sine_and_cosine(th0)
    s, versine = sine_and_versine(offset)
    return _u_after(body, s0, c0, u0, s, versine, offset)
