"""Displacement in slip (docs/model.md#slip-as-one-quadrature)."""

from __future__ import annotations

from hophoop.kernel.native import inline
from hophoop.kernel.physics.contact import load_height


@inline
def slip_displacement(body, sigma, vt, om, s, c, ds, dc, tau):
    """Return the change of x over the time tau from a state of slip: only gravity changes ẋ_G + σ μk ẏ_G."""
    signed_mu = sigma * body.mu_k
    arm = (1.0 - body.eps) + body.eps * load_height(s, c)
    speed = vt + om * arm - signed_mu * body.eps * om * s
    steady = body.gt - signed_mu * body.gn
    return speed * tau + 0.5 * steady * tau * tau - signed_mu * body.eps * dc - body.eps * ds
