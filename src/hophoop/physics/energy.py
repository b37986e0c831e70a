"""Kinetic and potential energy of the hoop, of numbers or arrays (docs/model.md#the-energy-ledger).

Kernel units: energies over m R²/(time unit)², which is m g R with gravity.
"""

from __future__ import annotations

import numpy as np

from hophoop._jit import jit


def kinetic_energy(body, th, om, vt, vn, th_low=0.0):
    """W_k = ½ (ẋ_G² + ẏ_G² + κ θ̇²), with ẋ_G = v_t + θ̇ (1 + ε cos θ) and ẏ_G = v_n − ε θ̇ sin θ.

    θ is th + th_low: near θ = π the nearly massless hoop turns so fast that the rounding of one number is seen.
    """
    sine = np.sin(th)
    half = np.cos(0.5 * th)
    height = 2.0 * (half * half) - sine * th_low  # 1 + cos θ, with all its digits also near θ = π
    sine += np.cos(th) * th_low
    along = vt + om * ((1.0 - body.eps) + body.eps * height)
    up = vn - body.eps * om * sine
    return 0.5 * (along * along + up * up + body.kap * (om * om))


def potential_energy(body, x, y, th):
    """W_p = g cos β (y + ε (cos θ − 1)) − g sin β (x + ε sin θ): zero at x = y = θ = 0."""
    half = np.sin(0.5 * th)
    drop = y - 2.0 * body.eps * (half * half)
    return body.gn * drop - body.gt * (x + body.eps * np.sin(th))


kinetic, potential = jit(kinetic_energy), jit(potential_energy)  # of numbers, in kernels


@jit
def energies_after(body, row):
    """(W_k, W_p) just after an event."""
    return (
        kinetic(body, row["theta"], row["omega"], row["slip"], row["vy"], row["theta_low"]),
        potential(body, row["x"], row["height"], row["theta"]),
    )
