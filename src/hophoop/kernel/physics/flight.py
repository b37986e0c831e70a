"""Flight: G is a projectile, θ̇ is constant, and the gap is a parabola minus a cosine (docs/model.md#flight)."""

from __future__ import annotations

from hophoop.kernel.numerics.trigonometry import turn, turn_deficits

# rad: beyond this rotation the parabola of G and the cosine are added directly. The sum of their changes from the start, which
# keeps the digits of a short flight, would lose a factor φ² in accuracy.
MANY_TURNS = 1_000.0


def flight_rates(body, s, c, om, y, vn, fn, tau):
    """Return the gap after the time tau and its first three derivatives; fn is f_n at the start, 0 after lift-off from slip.

    gap = y + v_n τ + f_n τ²/2 − ε [cos θ (cos φ − 1 + φ²/2) + sin θ (φ − sin φ)] with φ = θ̇ τ; its second derivative is −g_n +
    ε θ̇² cos (θ + φ). Written so that nothing cancels in a short flight.
    """
    phi = om * tau
    high = body.eps * om * om
    if abs(phi) > MANY_TURNS:
        ds, dc = turn(s, c, phi)
        rise = vn - body.eps * om * s
        gap = y + (rise - 0.5 * body.gn * tau) * tau - body.eps * dc
        return gap, rise - body.gn * tau + body.eps * om * (s + ds), high * (c + dc) - body.gn, -high * om * (s + ds)
    sine_part, cosine_part, versine = turn_deficits(phi)
    gap = y + vn * tau + 0.5 * fn * tau * tau - body.eps * (c * cosine_part + s * sine_part)
    rate = vn + fn * tau - body.eps * om * (c * sine_part + s * versine)
    sine = phi - sine_part
    return gap, rate, high * (c - (s * sine + c * versine)) - body.gn, -high * om * (s + (c * sine - s * versine))


def flight_gap(body, s, c, om, y, vn, fn, tau):
    """Return (gap, its rate) after the time tau of a flight; see `flight_rates`."""
    gap, rate, _, _ = flight_rates(body, s, c, om, y, vn, fn, tau)
    return gap, rate


def flight_displacement(body, vt, om, s, c, tau):
    """Return (change of x, v_t) after the time tau."""
    phi = om * tau
    ds, dc = turn(s, c, phi)
    # G moves on a parabola: ẋ_G = v_t + θ̇ (1 + ε cos θ)
    along = (vt + om * (1.0 + body.eps * c)) * tau + 0.5 * body.gt * tau * tau - body.eps * ds
    return along, vt + body.gt * tau - body.eps * om * dc
