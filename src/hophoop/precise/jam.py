"""Slip that runs into p_σ = 0: the last part of it, where N grows without bound and steps in time shrink to nothing.

In slip θ̇² = u obeys du/dθ = 2 q (g cos β − ε cos θ u)/Π with Π = κ p_σ, a linear equation with a regular singular
point where Π = 0. In the angle δ still missing its solution is u = A(δ) + C δᵃ B(δ), with power series A and B and
a = 2 κ cos θ/(sin θ dΠ/dθ) there. For a > 0 and C < 0 the motion ends in the singular point, the dynamic jam, unless
the slip stops before.
"""

from __future__ import annotations

from dataclasses import dataclass

from hophoop.precise.problem import Body, Number, PreciseState

NEAR = 0.02  # rad
EARLY = 40  # natural logarithm of the part of the angle that steps in time still cross
SHRINK = 2  # terms of the series have to shrink by this factor each


@dataclass
class Approach:
    """Slip near the singular angle: u(δ) as two series in z = δ/δ₀."""

    body: Body
    state: PreciseState
    sigma: int
    way: int
    singular: Number  # the angle where p_σ = 0
    extent: Number  # δ₀, the angle missing in `state`
    power: Number  # a
    regular: list[Number]
    factor: list[Number]  # C δ₀ᵃ B

    def square(self, z: Number) -> Number:
        """θ̇² where the part z of the angle is still missing."""
        ctx = self.body.ctx
        if z == 0:
            return self.regular[0]
        return ctx.polyval(self.regular[::-1], z) + z**self.power * ctx.polyval(self.factor[::-1], z)

    def duration(self, z: Number) -> Number:
        """Time from the state until the part z is missing."""
        ctx = self.body.ctx
        return self.extent * ctx.quad(lambda part: 1 / ctx.sqrt(self.square(part)), [z, 1])

    def at(self, z: Number) -> PreciseState:
        """The state where the part z is missing; the friction's work is what the energy lacks."""
        body, before = self.body, self.state
        th = self.singular - self.way * self.extent * z
        om = self.way * body.ctx.sqrt(self.square(z))
        tau = self.duration(z)
        drag = self.sigma * body.mu_k
        cosine, sine = body.ctx.cos_sin(before.th)
        later_cosine, later_sine = body.ctx.cos_sin(th)
        # ẋ_G + σ μ ẏ_G feels gravity alone
        steady = body.gt - drag * body.gn
        kept = before.vt + before.om * (1 + body.eps * cosine - drag * body.eps * sine)
        vt = kept + steady * tau - om * (1 + body.eps * later_cosine - drag * body.eps * later_sine)
        shift = body.eps * (later_sine - sine) + drag * body.eps * (later_cosine - cosine)
        x = before.x + kept * tau + steady * tau * tau / 2 - shift
        after = before._replace(t=before.t + tau, x=x, th=th, vt=vt, om=om)
        resisted = self.resisted(z, before.om * before.om * sine - om * om * later_sine)
        lost = _energy(body, before) - _energy(body, after)
        return after._replace(friction=before.friction + lost - resisted, resisted=before.resisted + resisted)

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


def _energy(body: Body, state: PreciseState) -> Number:
    cosine, sine = body.ctx.cos_sin(state.th)
    along, up = state.vt + state.om * (1 + body.eps * cosine), -body.eps * state.om * sine
    kinetic = (along * along + up * up + body.kap * state.om * state.om) / 2
    return kinetic + body.gn * body.eps * cosine - body.gt * (state.x + body.eps * sine)


def missing_angle(body: Body, state: PreciseState, sigma: int) -> Number:
    """Estimate of the angle still missing to p_σ = 0; negative where it does not come nearer."""
    cosine, sine = body.ctx.cos_sin(state.th)
    stiff, rate = _stiffness(body, sigma, cosine, sine, body.resistance(state.th, state.om, sigma))
    rate *= 1 if state.om > 0 else -1
    return -stiff / rate if rate < 0 else -body.one


def _stiffness(body: Body, sigma: int, cosine: Number, sine: Number, rho: Number) -> tuple[Number, Number]:
    """(Π, dΠ/dθ)."""
    eps, drag = body.eps, sigma * body.mu_k
    torque = eps * sine + drag * (1 + eps * cosine) - rho
    return body.kap + eps * sine * torque, eps * (cosine * torque + sine * eps * (cosine - drag * sine))


def approach(body: Body, state: PreciseState, sigma: int) -> Approach | None:
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
    order = body.bits + 8
    series = _series(body, sigma, way, singular, extent, power, order)
    if series is None:
        return None
    regular, factor = series
    one = body.one
    found = Approach(body, state, sigma, way, singular, extent, power, regular, factor)
    scale = (state.om * state.om - ctx.fsum(regular)) / ctx.fsum(factor)
    if scale >= 0:  # f_n comes to zero before p_σ does
        return None
    found.factor = [scale * number for number in factor]
    return found if found.square(one / 2) > 0 else None


def _series(
    body: Body, sigma: int, way: int, singular: Number, extent: Number, power: Number, order: int
) -> tuple[list[Number], list[Number]] | None:
    """(A, B) in z = δ/extent, up to the term that rounding hides; None where they do not shrink fast enough."""
    ctx, eps, drag, rho = body.ctx, body.eps, sigma * body.mu_k, way * body.resist
    cosine, sine = ctx.cos_sin(singular)
    # sin and cos of θ* − way δ
    cycle = ((sine, -way * cosine, -sine, way * cosine), (cosine, way * sine, -cosine, -way * sine))
    sines: list[Number] = []
    cosines: list[Number] = []
    torques: list[Number] = []
    stiffness: list[Number] = []
    term = body.one
    grow: list[Number] = []  # 2 ε way q cos θ / Π₁
    push: list[Number] = []  # −2 way g q / Π₁
    loads: list[Number] = []  # q cos θ
    regular: list[Number] = []
    factor: list[Number] = []
    small = ctx.ldexp(body.one, -body.bits - 4)
    for k in range(order):
        # Π needs one term more than the others, for it is divided by δ
        while len(sines) < k + 2:
            j = len(sines)
            sines.append(term * cycle[0][j % 4])
            cosines.append(term * cycle[1][j % 4])
            torques.append(eps * sines[j] + drag * (eps * cosines[j] + (1 if j == 0 else 0)) - (rho if j == 0 else 0))
            stiffness.append(eps * ctx.fdot(zip(sines, torques[::-1], strict=True)))
            term = term * extent / (j + 1)
        loads.append(ctx.fdot(zip(cosines[: k + 1], torques[k::-1], strict=True)))
        lead = stiffness[1]
        for series, value in ((grow, 2 * way * eps * loads[k]), (push, -2 * way * body.gn * torques[k])):
            rest = ctx.fdot((stiffness[j + 1], series[k - j]) for j in range(1, k + 1))
            # Π = z (Π₁ extent), and the equation has the factor extent as well
            series.append((value * extent - rest) / lead)
        carried = ctx.fdot((grow[j], regular[k - j]) for j in range(1, k + 1))
        regular.append((push[k] + carried) / (k - power))
        if k == 0:
            factor.append(body.one)
        else:
            factor.append(ctx.fdot((grow[j], factor[k - j]) for j in range(1, k + 1)) / k)
        if k > 4 and max(abs(regular[k] / regular[0]), abs(factor[k]), abs(regular[k - 1] / regular[0])) < small:
            return regular, factor
        if k > 16 and max(abs(regular[k] / regular[0]), abs(factor[k])) > ctx.mpf(SHRINK) ** (4 - k):
            return None
    return None


def ending(found: Approach) -> tuple[bool, PreciseState] | None:
    """(whether it jams, the state at the end): the jam, or where the slip stops only just before it.

    None where it stops so early that steps in time get there too.
    """
    body, ctx = found.body, found.body.ctx
    last = found.at(body.zero)
    if found.sigma * last.vt > 0:
        return True, last
    # the slip falls with a power of the angle: the place is looked for in its logarithm
    high, low = ctx.mpf(-EARLY), ctx.mpf(-2 * EARLY)
    above = found.sigma * found.at(ctx.exp(high)).vt
    if above <= 0:
        return None
    below = found.sigma * found.at(ctx.exp(low)).vt
    while below > 0:
        high, above, low = low, below, 2 * low
        below = found.sigma * found.at(ctx.exp(low)).vt
    # regula falsi after Illinois
    side = 0
    for _ in range(2 * body.bits):
        middle = low - below * (high - low) / (above - below)
        if not low < middle < high:
            break
        value = found.sigma * found.at(ctx.exp(middle)).vt
        if value == 0 or high - low < ctx.ldexp(body.one, -body.bits + 8):
            break
        if value > 0:
            high, above = middle, value
            if side > 0:
                below /= 2
            side = 1
        else:
            low, below = middle, value
            if side < 0:
                above /= 2
            side = -1
    return False, found.at(ctx.exp((low + high) / 2 if not low < middle < high else middle))._replace(vt=body.zero)
