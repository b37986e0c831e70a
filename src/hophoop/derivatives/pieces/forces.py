"""How the contact force of rolling changes with the state and the parameters."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import OM, STILL, TH
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.native import noinline
from hophoop.kernel.physics.contact import rolling_acceleration, rolling_forces

d_rolling_forces = tangent_of(rolling_forces, "body", "s", "c", "u", "rho")


@noinline
def forces_by_angle(body, s, c, om, rho):
    """Return (dF/dθ, dN/dθ) along rolling."""
    alpha = rolling_acceleration(body, s, c, om * om, rho)
    return d_rolling_forces(body, s, c, om * om, rho, STILL, c, -s, 2.0 * alpha, 0.0)[1]


@noinline
def change_of_forces(body, s, c, om, rho, d_body, tangents, k):
    """Return the changes of F and N in a direction."""
    dth = tangents[TH, k]
    drho = math.copysign(1.0, rho if rho != 0.0 else om) * d_body.resist
    return d_rolling_forces(body, s, c, om * om, rho, d_body, c * dth, -s * dth, 2.0 * om * tangents[OM, k], drho)[1]
