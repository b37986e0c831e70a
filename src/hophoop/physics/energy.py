"""Kinetic and potential energy of the hoop, of numbers or arrays (docs/model.md#the-energy-ledger).

Kernel units: energies over m R²/(time unit)², which is m g R with gravity.
"""

from __future__ import annotations

import numpy as np


def kinetic_energy(body, th, om, vt, vn, th_low=0.0):
    """W_k = ½ (ẋ_G² + ẏ_G² + κ θ̇²), with ẋ_G = v_t + θ̇ (1 + ε cos θ) and ẏ_G = v_n − ε θ̇ sin θ.

    θ is th + th_low: near θ = π the nearly massless hoop turns so fast that the rounding of one number is seen.
    """
    sine = np.sin(th)
    height = 2.0 * np.cos(0.5 * th) ** 2 - sine * th_low  # 1 + cos θ, with all its digits also near θ = π
    sine += np.cos(th) * th_low
    along = vt + om * ((1.0 - body.eps) + body.eps * height)
    up = vn - body.eps * om * sine
    return 0.5 * (along**2 + up**2 + body.kap * om**2)


def potential_energy(body, x, y, th):
    """W_p = g cos β (y + ε (cos θ − 1)) − g sin β (x + ε sin θ): zero at x = y = θ = 0."""
    drop = y - 2.0 * body.eps * np.sin(0.5 * th) ** 2
    return body.gn * drop - body.gt * (x + body.eps * np.sin(th))
