"""Sign of κ p_σ near zero, in extended precision: it decides whether slip has a solution (docs/model.md#painlevés-paradox)."""

from __future__ import annotations

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.double_angles import sine_versine
from hophoop.kernel.numerics.double_double import add, multiply, negative, two_product
from hophoop.kernel.physics.contact import slip_torque_arm

NEARLY = 1e-8  # below this κ p_σ has lost half its digits


@inline
def exact_inertia(body):
    """Return κ as a double-double."""
    if body.ideal:
        return add((1.0, 0.0), negative(two_product(body.eps, body.eps)))
    return body.kap, 0.0


@apart
def exact_slip_stiffness(body, th, th_low, sigma, rho):
    """Return (q, κ p_σ) with all digits, treating θ and the parameters as exact numbers."""
    sine, versine = sine_versine((th, th_low))
    lever = multiply((body.eps, 0.0), sine)
    arm = add(add((1.0, 0.0), (body.eps, 0.0)), negative(multiply((body.eps, 0.0), versine)))
    q = add(add(lever, multiply((sigma * body.mu_k, 0.0), arm)), (-rho, 0.0))
    stiffness = add(exact_inertia(body), multiply(lever, q))
    return q[0], stiffness[0]


def stiffness_slope(body, s, c, sigma, q):
    """Return dκp_σ/dθ."""
    return body.eps * c * q + body.eps * s * body.eps * (c - sigma * body.mu_k * s)


@inline
def slip_coefficients(body, th, th_low, s, c, sigma, rho):
    """Return (q, κ p_σ) in slip of direction σ with the rolling resistance ρ, accurate also if κ p_σ is nearly zero."""
    arm = slip_torque_arm(body, s, c, sigma) - rho
    stiffness = body.kap + body.eps * s * arm
    if abs(stiffness) < NEARLY:
        return exact_slip_stiffness(body, th, th_low, sigma, rho)
    return arm, stiffness
