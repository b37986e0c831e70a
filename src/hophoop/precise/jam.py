"""Slip that runs into p_σ = 0: the last part of it, where N grows without bound and steps in time shrink to nothing.

In slip θ̇² = u obeys du/dθ = 2 q (g cos β − ε cos θ u)/Π with Π = κ p_σ, a linear equation with a regular singular
point where Π = 0. In the angle δ still missing its solution is u = A(δ) + C δᵃ B(δ), with power series A and B and
a = 2 κ cos θ/(sin θ dΠ/dθ) there. For a > 0 and C < 0 the motion ends in the singular point, the dynamic jam, unless
the slip stops before.
"""

from __future__ import annotations

from dataclasses import dataclass

from hophoop.kernel.model import (
    kappa_p_sigma_slope,
    kinetic_energy,
    potential_energy,
    resistance_arm,
    slip_displacement,
    slip_torque_arm,
)
from hophoop.kernel.records import State
from hophoop.precise.kernels import Number
from hophoop.precise.problem import Body

NEAR = 0.02  # rad
EARLY = 40  # natural logarithm of the part of the angle that steps in time still cross
SHRINK = 2  # terms of the series have to shrink by this factor each

Series = list[Number]


@dataclass
class Approach:
    """Slip near the singular angle: u(δ) as two series in z = δ/δ₀."""

    body: Body
    state: State
    sigma: int
    way: int
    singular: Number  # the angle where p_σ = 0
    extent: Number  # δ₀, the angle missing in `state`
    power: Number  # a
    regular: Series
    factor: Series  # C δ₀ᵃ B

    def square(self, z: Number) -> Number:
        """θ̇² where the part z of the angle is still missing."""
        if z == 0:
            return self.regular[0]
        return _value(self.regular, z) + z**self.power * _value(self.factor, z)

    def duration(self, z: Number) -> Number:
        """Time from the state until the part z is missing."""
        ctx = self.body.ctx
        return self.extent * ctx.quad(lambda part: 1 / ctx.sqrt(self.square(part)), [z, 1])

    def at(self, z: Number) -> State:
        """The state where the part z is missing; the friction's work is what the energy lacks."""
        body, before, kernels = self.body, self.state, self.body.kernels
        th = self.singular - self.way * self.extent * z
        om = self.way * body.ctx.sqrt(self.square(z))
        tau = self.duration(z)
        c, s = body.ctx.cos_sin(before.th)
        dc, ds = (after - start for after, start in zip(body.ctx.cos_sin(th), (c, s), strict=True))
        along = kernels(slip_displacement)(body, self.sigma, before.vt, before.om, s, c, ds, dc, tau)
        # ẋ_G + σ μ ẏ_G feels gravity alone
        drag = self.sigma * body.mu_k
        arm = 1 + body.eps * (c - drag * s)
        vt = before.vt + before.om * arm + (body.gt - drag * body.gn) * tau - om * (arm + body.eps * (dc - drag * ds))
        after = before._replace(t=before.t + tau, x=before.x + along, th=th, vt=vt, om=om)
        resisted = self.resisted(z, before.om * before.om * s - om * om * (s + ds))
        lost = _energy(body, before) - _energy(body, after)
        return after._replace(friction=before.friction + lost - resisted, rolling_loss=before.rolling_loss + resisted)

    def resisted(self, z: Number, less: Number) -> Number:
        """Energy lost to rolling resistance until the part z is missing; `less` is by how much θ̇² sin θ has become less.

        N dt = g cosβ dt + d ẏ_G with ẏ_G = −ε θ̇ sin θ, so that ∫N dθ = g cosβ Δθ − ε (Δ(θ̇² sin θ) + ∫θ̇² cos θ dθ)/2.
        """
        body, ctx = self.body, self.body.ctx
        if body.resist == 0:
            return body.zero
        turned = self.way * self.extent
        pull = turned * ctx.quad(lambda part: self.square(part) * ctx.cos(self.singular - turned * part), [z, 1])
        pressed = body.gn * turned * (1 - z) - body.eps * (pull - less) / 2
        return self.way * body.resist * pressed


def _energy(body: Body, state: State) -> Number:
    kinetic = body.kernels(kinetic_energy)(body, state.th, state.om, state.vt, state.vn, state.th_low)
    return kinetic + body.kernels(potential_energy)(body, state.x, state.y, state.th)


def missing_angle(body: Body, state: State, sigma: int) -> Number:
    """Estimate of the angle still missing to p_σ = 0; negative where it does not come nearer."""
    cosine, sine = body.ctx.cos_sin(state.th)
    rho = body.kernels(resistance_arm)(body, sine, cosine, state.om, sigma)
    stiff, rate = _stiffness(body, sigma, cosine, sine, rho)
    rate *= 1 if state.om > 0 else -1
    return -stiff / rate if rate < 0 else -body.one


def _stiffness(body: Body, sigma: int, cosine: Number, sine: Number, rho: Number) -> tuple[Number, Number]:
    """(Π, dΠ/dθ)."""
    torque = body.kernels(slip_torque_arm)(body, sine, cosine, sigma) - rho
    return body.kap + body.eps * sine * torque, body.kernels(kappa_p_sigma_slope)(body, sine, cosine, sigma, torque)


def approach(body: Body, state: State, sigma: int) -> Approach | None:
    """Slip near p_σ = 0 as a series about the singular angle; None where that does not hold, or not yet."""
    ctx = body.ctx
    way = 1 if state.om > 0 else -1
    rho = way * body.resist
    singular = state.th + way * missing_angle(body, state, sigma)
    for _ in range(body.bits):
        cosine, sine = ctx.cos_sin(singular)
        stiff, rate = _stiffness(body, sigma, cosine, sine, rho)
        if rate == 0:
            return None
        step = stiff / rate
        singular -= step
        if abs(step) < ctx.ldexp(body.one, -body.bits // 2 - 8):
            break
    extent = way * (singular - state.th)
    cosine, sine = ctx.cos_sin(singular)
    rate = _stiffness(body, sigma, cosine, sine, rho)[1]
    if not (0 < extent < 2 * NEAR and way * rate < 0 and cosine > 0):
        return None
    power = 2 * body.kap * cosine / (sine * rate)
    if power <= 0:
        return None
    series = _series(body, sigma, way, singular, extent, power)
    if series is None:
        return None
    regular, factor = series
    scale = (state.om * state.om - ctx.fsum(regular)) / ctx.fsum(factor)
    if scale >= 0:  # f_n comes to zero before p_σ does
        return None
    found = Approach(body, state, sigma, way, singular, extent, power, regular, [scale * number for number in factor])
    return found if found.square(body.one / 2) > 0 else None


def _value(series: Series, z: Number) -> Number:
    """A power series at z, by Horner's rule."""
    total: Number = 0
    for coefficient in reversed(series):
        total = total * z + coefficient
    return total


def _series(body: Body, sigma: int, way: int, singular: Number, extent: Number, power: Number) -> tuple[Series, Series] | None:
    """(A, B) in z = δ/extent, up to the term that rounding hides; None where they do not shrink fast enough.

    With θ = θ* − way δ the coefficient of z^k in Π du/dz = 2 way extent (ε q cos θ u − g q) gives the next one of u.
    """
    ctx, eps, drag = body.ctx, body.eps, sigma * body.mu_k
    (c, s), (c2, s2) = ctx.cos_sin(singular), ctx.cos_sin(2 * singular)
    constant, turned, pull = drag - way * body.resist, -way * extent, 2 * way * extent
    stiffness: Series = []  # Π
    loads: Series = []  # 2 way extent ε q cos θ
    regular: Series = []
    factor: Series = []
    rates: tuple[Series, Series] = ([], [])  # k times their coefficients, and k + power times

    def known(series: Series, rate: Series) -> Number:
        """The terms of a coefficient that the earlier ones determine."""
        driven = ctx.fdot(zip(loads[1:], series[::-1], strict=True))
        return driven - ctx.fdot(zip(stiffness[2:], rate[::-1], strict=True))

    for k in range(body.bits + 8):
        q = eps * (s + drag * c) + (constant if k == 0 else 0)
        loads.append(pull * eps * (constant * c + eps * (s2 + drag * c2 + (drag if k == 0 else 0)) / 2))
        if k == 0:
            stiffness.append(body.zero)
        # the coefficients of sin θ, cos θ, sin 2θ and cos 2θ for z^(k + 1), of which Π needs one more than the others
        s, c, s2, c2 = (turned / (k + 1) * one for one in (c, -s, 2 * c2, -2 * s2))
        stiffness.append(eps * (constant * s + eps * (drag * s2 - c2) / 2))
        regular.append((known(regular, rates[0]) - pull * body.gn * q) / (stiffness[1] * (k - power)))
        factor.append(known(factor, rates[1]) / (stiffness[1] * k) if k > 0 else body.one)
        rates[0].append(k * regular[k])
        rates[1].append((k + power) * factor[k])
        largest = max(abs(regular[k] / regular[0]), abs(factor[k]))
        if k > 4 and max(largest, abs(regular[k - 1] / regular[0])) < ctx.ldexp(1, -body.bits - 4):
            return regular, factor
        if k > 16 and largest > ctx.mpf(SHRINK) ** (4 - k):
            return None
    return None


def ending(found: Approach) -> tuple[bool, State] | None:
    """(whether it jams, the state at the end): the jam, or where the slip stops only just before it.

    None where it stops so early that steps in time get there too.
    """
    body, ctx = found.body, found.body.ctx
    last = found.at(body.zero)
    if found.sigma * last.vt > 0:
        return True, last

    # the slip falls with a power of the angle: the place is looked for in its logarithm
    def slip(logarithm: Number) -> Number:
        return found.sigma * found.at(ctx.exp(logarithm)).vt

    high, low = ctx.mpf(-EARLY), ctx.mpf(-2 * EARLY)
    if slip(high) <= 0:
        return None
    while slip(low) > 0:
        high, low = low, 2 * low
    place = ctx.findroot(slip, (low, high), solver="illinois", tol=ctx.ldexp(1, 16 - body.bits), maxsteps=300, verify=False)
    return False, found.at(ctx.exp(place))._replace(vt=body.zero)
