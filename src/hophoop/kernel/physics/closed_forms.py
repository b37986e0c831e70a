"""Motion in closed form: rolling (docs/model.md#rolling-in-closed-form), slip (docs/model.md#slip-as-one-quadrature), flight
(docs/model.md#flight), the massless hoop (docs/model.md#no-mass-in-the-ring), and energies (docs/model.md#the-energy-ledger).
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.arcs import arcsine
from hophoop.kernel.numerics.circular import (
    cosine,
    series_remainders,
    sine,
    sine_and_cosine,
    sine_and_versine,
    sine_cosine_change,
    sine_cosine_change_by,
    versine_of,
)
from hophoop.kernel.physics.contact import inertia_at_height, load_height

# --- rolling: θ̇²(θ)


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
        change += body.gt * series_remainders(angle)[0]
    return 2.0 * change


def _u_after(body, s0, c0, u0, sine, versine, angle):
    """Return θ̇² after a rotation by an angle, from its sine and 1 − cosine, of a hoop that rolls; in g/R."""
    inertia = inertia_at_height(body, load_height(s0, c0))
    energy = inertia * u0 + rolling_energy_change(body, s0, c0, sine, versine, angle)
    return energy / (inertia + 2.0 * body.eps * sine_cosine_change_by(s0, c0, sine, versine)[1])


def rolling_u(body, th0, u0, offset):
    """Return θ̇² at th0 + offset of a hoop that rolls with θ̇² = u0 at th0; negative if it does not get there."""
    s0, c0 = sine_and_cosine(th0)
    s, versine = sine_and_versine(offset)
    return _u_after(body, s0, c0, u0, s, versine, offset)


# --- displacement in slip


@inline
def slip_displacement(body, sigma, vt, om, s, c, ds, dc, tau):
    """Return the change of x over the time tau from a state of slip: only gravity changes ẋ_G + σ μk ẏ_G."""
    signed_mu = sigma * body.mu_k
    arm = (1.0 - body.eps) + body.eps * load_height(s, c)
    speed = vt + om * arm - signed_mu * body.eps * om * s
    steady = body.gt - signed_mu * body.gn
    return speed * tau + 0.5 * steady * tau * tau - signed_mu * body.eps * dc - body.eps * ds


# --- flight: G is a projectile, θ̇ is constant, the gap is a parabola minus a cosine

# rad: beyond this rotation the parabola of G and the cosine are added directly. The sum of their changes from the start, which
# keeps the digits of a short flight, would lose a factor φ² in accuracy.
LARGE_ROTATION = 1_000.0


def flight_rates(body, s, c, om, y, vn, fn, tau):
    """Return the gap after the time tau and its first three derivatives; fn is f_n at the start, 0 after lift-off from slip.

    gap = y + v_n τ + f_n τ²/2 − ε [cos θ (cos φ − 1 + φ²/2) + sin θ (φ − sin φ)] with φ = θ̇ τ; its second derivative is −g_n +
    ε θ̇² cos (θ + φ). Written so that nothing cancels in a short flight.
    """
    phi = om * tau
    high = body.eps * om * om
    if abs(phi) > LARGE_ROTATION:
        ds, dc = sine_cosine_change(s, c, phi)
        rise = vn - body.eps * om * s
        gap = y + (rise - 0.5 * body.gn * tau) * tau - body.eps * dc
        return gap, rise - body.gn * tau + body.eps * om * (s + ds), high * (c + dc) - body.gn, -high * om * (s + ds)
    sine_part, cosine_part, versine = series_remainders(phi)
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
    ds, dc = sine_cosine_change(s, c, phi)
    # G moves on a parabola: ẋ_G = v_t + θ̇ (1 + ε cos θ)
    along = (vt + om * (1.0 + body.eps * c)) * tau + 0.5 * body.gt * tau * tau - body.eps * ds
    return along, vt + body.gt * tau - body.eps * om * dc


# --- the massless hoop, γ = 1
# While it rolls, the formulas of rolling hold with κ = 0. When the contact force is lost, the load falls freely and the rim
# skims the plane, so that θ follows from the height of the load.

TOP_ROUNDING = 1e-8  # revolutions: this close to the top cos θ rounds to 1


def skim_duration(body, fall, sink):
    """Return the time until the load has fallen so far, from its sinking rate, which must not be negative."""
    gained = 2.0 * body.gn * fall  # increase of the squared rate
    if sink * sink > gained:  # at a high rate the difference below would lose all digits
        return 2.0 * fall / (sink + math.sqrt(sink * sink + gained))
    if body.gn == 0.0:
        return math.inf
    return (-sink + math.sqrt(sink * sink + gained)) / body.gn


def revolutions_before(th, direction):
    """Return the revolutions in a direction up to the top from which the load falls, with a tolerance for rounding."""
    return 1.0 * math.floor(direction * (0.5 * th / math.pi) + TOP_ROUNDING)


def skim_state(body, x, th, vt, om, direction, tau):
    """Return (x, θ, v_t, θ̇) after skimming for the time tau; θ̇ is infinite when the load strikes the plane."""
    s, c = sine_and_cosine(th)
    sink = s * om
    speed = vt + om * (1.0 + c)  # of the load, along the plane
    fallen = sink * tau + 0.5 * body.gn * tau * tau
    versine = versine_of(th) + fallen  # 1 − cos θ
    half = arcsine(math.sqrt(min(max(0.5 * versine, 0.0), 1.0)))
    th_end = direction * (2.0 * math.pi * revolutions_before(th, direction) + 2.0 * half)
    s_end = sine(2.0 * half)
    rate = sink + body.gn * tau
    if s_end > 0.0:
        om_end = direction * rate / s_end
    else:
        om_end = direction * math.sqrt(body.gn)
    if versine >= 2.0:
        om_end = direction * math.inf
    along = speed + body.gt * tau
    x_end = x + s + speed * tau + 0.5 * body.gt * tau * tau - sine(th_end)
    return x_end, th_end, along - om_end * (2.0 - versine), om_end


def strike_limit(body, x, th, s, speed, direction, tau):
    """Return (x, θ, v_t) at the strike, after skimming for the time tau; `speed` is the load's velocity along the plane.

    These are the limits of `skim_state`, in which θ̇ is unbounded.
    """
    x_end = x + s + speed * tau + 0.5 * body.gt * tau * tau
    th_end = direction * math.pi * (2.0 * revolutions_before(th, direction) + 1.0)
    return x_end, th_end, speed + body.gt * tau


def strike(body, vx, vy):
    """Return (v_x after, p_n, p_t) of the load that strikes the plane without rebound: a particle with friction."""
    p_n = -vy
    limit = body.mu_s * p_n
    if abs(vx) <= limit:
        return 0.0, p_n, -vx
    p_t = -math.copysign(body.mu_k * p_n, vx)
    return vx + p_t, p_n, p_t


# --- kinetic and potential energy
# Kernel units: energies over m R²/(time unit)², which is m g R with gravity.


def kinetic_energy(body, th, om, vt, vn, th_low):
    """Return W_k = ½ (ẋ_G² + ẏ_G² + κ θ̇²), with ẋ_G = v_t + θ̇ (1 + ε cos θ) and ẏ_G = v_n − ε θ̇ sin θ.

    θ is th + th_low: near θ = π a nearly massless hoop rotates so fast that rounding of θ to one double is visible.
    """
    s, c = sine_and_cosine(th)
    half_cosine = cosine(0.5 * th)
    height = 2.0 * half_cosine * half_cosine - s * th_low  # 1 + cos θ with all digits, also near θ = π
    along = vt + om * ((1.0 - body.eps) + body.eps * height)
    up = vn - body.eps * om * (s + c * th_low)
    return 0.5 * (along * along + up * up + body.kap * (om * om))


def potential_energy(body, x, y, th):
    """Return W_p = g cos β (y + ε (cos θ − 1)) − g sin β (x + ε sin θ), zero at x = y = θ = 0."""
    s, half_sine = sine(th), sine(0.5 * th)
    drop = y - 2.0 * body.eps * half_sine * half_sine
    return body.gn * drop - body.gt * (x + body.eps * s)


def energies_after(body, row):
    """Return (W_k, W_p) just after an event."""
    return (
        kinetic_energy(body, row["theta"], row["omega"], row["slip"], row["vy"], row["theta_low"]),
        potential_energy(body, row["x"], row["height"], row["theta"]),
    )
