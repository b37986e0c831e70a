"""The start of a phase over a box of parameters, moved from its angle θ*, which varies, to an exact angle nearby."""

from __future__ import annotations

from dataclasses import replace

from hophoop.prove._flint import Ball, arb, symmetric
from hophoop.prove.enclosures.mean_value_form import Varied, at_centre, derivatives, over
from hophoop.prove.phases.phase_equations import PhaseEquations, phase_equations, square_at


def move_start(
    phase: PhaseEquations, centre: Ball, way: int, energy: Ball | None, smoothly: bool
) -> tuple[PhaseEquations, Ball, Ball]:
    """Return (phase, θ̇², t) at an exact angle inside those where the phase begins.

    Parameters
    ----------
    phase : PhaseEquations
        Of the phase from where it begins.
    centre : Ball
        The exact angle.
    way : int
    energy : Ball or None
        Of the rolling that was before, if it was.
    smoothly : bool
        Whether slip begins with v̇_t = 0, as after rolling for μs = μk.
    """
    if energy is None:
        return phase, *_along(phase, centre, way)
    return _from_rolling(phase, centre, way, energy, smoothly)


def _along(phase: PhaseEquations, centre: Ball, way: int) -> tuple[Ball, Ball]:
    """(θ̇², t) there, along the phase itself.

    With the start (θ*, u*, t*) and C = exp(∫ A): ∂u/∂p = C (∂u*/∂p − 2 θ̈ ∂θ*/∂p) + ∫ C (∂A/∂p u + ∂B/∂p) dθ.
    """
    begin, count = phase.begin, phase.model.varying
    first = begin.om * begin.om
    plain, central = phase.plain(), phase.central()
    u, box = square_at(plain, over(begin.th), over(first), centre)
    middle, near = square_at(central, at_centre(begin.th), at_centre(first), centre)
    spread = centre - over(begin.th)
    s, c = over(begin.th).union(centre).sin_cos()
    grow, push = phase.model.rates(s, c, phase.sigma)
    carried = (over(grow) * symmetric(spread)).exp()
    slope, start = plain.slope(over(begin.th), over(first)), over(first).rsqrt()
    u_by, t_by = [], []
    rates = (derivatives(one, count) for one in (first, begin.th, begin.t, grow, push))
    for square, th, t, a, b in zip(*rates, strict=True):
        change = carried * (square - slope * th) + symmetric(spread) * carried * (a * box + b)
        u_by.append(change)
        t_by.append(t - way * th * start - symmetric(spread) * box.rsqrt() / box / 2 * change)
    times = [
        pick(begin.t) + way * (centre - pick(begin.th)) * squares.rsqrt() for pick, squares in ((at_centre, near), (over, box))
    ]
    return Varied(middle, u, tuple(u_by)), Varied(times[0], times[1], tuple(t_by))


def _from_rolling(
    phase: PhaseEquations, centre: Ball, way: int, energy: Ball, smoothly: bool
) -> tuple[PhaseEquations, Ball, Ball]:
    """The same next to rolling, which is known at a fixed angle: there nothing depends on θ* to first order.

    With u_r of rolling D = u − u_r obeys D′ = A D + R with R = 2 (θ̈ in slip − θ̈ in rolling), both at u_r, and D = 0 at θ*.
    Where slip begins with v̇_t = 0 both forces are the same, so that R = 0 at θ* and ∂θ*/∂p drops out. The same is true of v_t.
    """
    model, sigma, begin = phase.model, phase.sigma, phase.begin
    count = model.varying
    spread, spread_at = centre - over(begin.th), centre - at_centre(begin.th)
    shift = derivatives(0 if smoothly else begin.th, count)
    segment = over(begin.th).union(centre)
    s, c = segment.sin_cos()
    u = 2 * (energy - model.height(segment, s, c)) / model.inertia(c)
    missing = 2 * (model.slipping(s, c, u, sigma).alpha - model.rolling(s, c, u).alpha)
    grow = model.rates(s, c, sigma)[0]
    carried = (over(grow) * symmetric(spread)).exp()
    by = tuple(
        carried * (symmetric(spread) * (rate + symmetric(spread) * more * over(missing)) - over(missing) * th)
        for rate, more, th in zip(derivatives(missing, count), derivatives(grow, count), shift, strict=True)
    )
    extra = Varied(carried * at_centre(missing) * symmetric(spread_at), carried * over(missing) * symmetric(spread), by)
    square = u + extra  # on all of the way between θ* and the exact angle
    slid = model.slipping(s, c, square, sigma).slip * square.rsqrt() * way
    by = tuple(symmetric(spread) * rate - over(slid) * th for rate, th in zip(derivatives(slid, count), shift, strict=True))
    vt = begin.vt + Varied(at_centre(slid) * spread_at, over(slid) * spread, by)
    s, c = centre.sin_cos()
    there = 2 * (energy - model.height(centre, s, c)) / model.inertia(c) + extra
    # the time is counted from this angle, and x is a ball: nothing in a box asks for more
    x = over(begin.x) + (1 + way * over(vt) * over(square).rsqrt()).union(arb(1)) * symmetric(spread)
    moved = replace(begin, t=over(begin.t), x=x, th=centre, vt=vt, om=way * there.sqrt())
    return phase_equations(model, sigma, moved), there, moved.t
