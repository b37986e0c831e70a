"""Kinetic and potential energy of the hoop (docs/model.md#the-energy-ledger).

Kernel units: energies over m R²/(time unit)², which is m g R with gravity.
"""

from __future__ import annotations

from typing import Any

from hophoop.kernel.native import inline
from hophoop.kernel.numerics import elementwise
from hophoop.kernel.numerics.circular import cosine, sine, sine_and_cosine


@inline
def _kinetic(body, s, c, half_cosine, om, vt, vn, th_low):
    """Return W_k = ½ (ẋ_G² + ẏ_G² + κ θ̇²), with ẋ_G = v_t + θ̇ (1 + ε cos θ) and ẏ_G = v_n − ε θ̇ sin θ."""
    height = 2.0 * half_cosine * half_cosine - s * th_low  # 1 + cos θ with all digits, also near θ = π
    along = vt + om * ((1.0 - body.eps) + body.eps * height)
    up = vn - body.eps * om * (s + c * th_low)
    return 0.5 * (along * along + up * up + body.kap * (om * om))


@inline
def _potential(body, x, y, s, half_sine):
    """Return W_p = g cos β (y + ε (cos θ − 1)) − g sin β (x + ε sin θ), zero at x = y = θ = 0."""
    drop = y - 2.0 * body.eps * half_sine * half_sine
    return body.gn * drop - body.gt * (x + body.eps * s)


def kinetic_energy(body, th, om, vt, vn, th_low):
    """Return the kinetic energy of a state.

    θ is th + th_low: near θ = π a nearly massless hoop rotates so fast that rounding of θ to one double is visible.
    """
    s, c = sine_and_cosine(th)
    return _kinetic(body, s, c, cosine(0.5 * th), om, vt, vn, th_low)


def potential_energy(body, x, y, th):
    """Return the potential energy of a state."""
    return _potential(body, x, y, sine(th), sine(0.5 * th))


def energies_after(body, row):
    """Return (W_k, W_p) just after an event."""
    return (
        kinetic_energy(body, row["theta"], row["omega"], row["slip"], row["vy"], row["theta_low"]),
        potential_energy(body, row["x"], row["height"], row["theta"]),
    )


def kinetic_energies(body: Any, th: Any, om: Any, vt: Any, vn: Any, th_low: Any = 0.0) -> Any:
    """Return kinetic energies of states given as arrays, with the bits of `kinetic_energy`."""
    s, c = elementwise.sine_and_cosine(th)
    return _kinetic(body, s, c, elementwise.cosine(0.5 * th), om, vt, vn, th_low)


def potential_energies(body: Any, x: Any, y: Any, th: Any) -> Any:
    """Return potential energies of states given as arrays, with the bits of `potential_energy`."""
    return _potential(body, x, y, elementwise.sine(th), elementwise.sine(0.5 * th))
