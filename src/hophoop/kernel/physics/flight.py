"""Flight: G is a projectile and θ̇ constant; the gap is a parabola plus a cosine, written without cancellation."""

from __future__ import annotations

from hophoop.kernel.numerics.trigonometry import turn, turn_deficits

# rad: over more the parabola of G and the turning are added up as they are. Their sum from the start, which keeps the digits
# of a short flight, would lose φ² of them.
MANY_TURNS = 1_000.0


def flight_rates(body, s, c, om, y, vn, fn, tau):
    """The gap after the time tau and its first three derivatives; fn is the initial f_n, exactly 0 after a lift-off from slip.

    gap = y + v_n τ + f_n τ²/2 − ε [cos θ (cos φ − 1 + φ²/2) + sin θ (φ − sin φ)], φ = θ̇ τ; its second derivative is
    −g_n + ε θ̇² cos (θ + φ).
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
    """(gap, its rate) after the time tau of a flight, as `flight_rates` gives them."""
    gap, rate, _, _ = flight_rates(body, s, c, om, y, vn, fn, tau)
    return gap, rate


def flight_displacement(body, vt, om, s, c, tau):
    """(change of x, v_t) after the time tau."""
    phi = om * tau
    ds, dc = turn(s, c, phi)
    # G moves on a parabola: ẋ_G = v_t + θ̇ (1 + ε cos θ)
    along = (vt + om * (1.0 + body.eps * c)) * tau + 0.5 * body.gt * tau * tau - body.eps * ds
    return along, vt + body.gt * tau - body.eps * om * dc
