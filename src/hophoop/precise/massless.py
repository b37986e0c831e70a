"""The massless hoop, κ = 0: it rolls while the force can point at the load, then the load falls and the rim skims."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.precise.contact import Stopped
from hophoop.precise.problem import Number, PreciseState
from hophoop.precise.rules import UNDECIDED, can_roll, slip_mode

if TYPE_CHECKING:
    from hophoop.precise.motion import Run


def begin(run: Run) -> None:
    """A start in contact."""
    state = run.state
    if state.vt != 0:
        run.mode = slip_mode(1 if state.vt > 0 else -1)
        run.write(Event.START, None, run.mode)
        run.mode = UNDECIDED
        stop(Status.UNDETERMINED)
    run.write(Event.START, None, Mode.ROLL)
    run.enter(Mode.ROLL)
    if lies(run):
        lie(run)
    if not can_roll(run.body, run.judge, state):
        let_go(run)


def stop(status: Status) -> None:
    """End the motion."""
    raise Stopped(status)


def lies(run: Run) -> bool:
    """Return True if the load is on the plane: θ is the double nearest to π."""
    ctx, th = run.body.ctx, run.origin.th
    turns = ctx.nint((th / ctx.pi - 1) / 2)
    return float(th) == float((2 * turns + 1) * ctx.pi) and run.origin.om == 0


def lie(run: Run) -> None:
    """The load lies on the plane."""
    run.write(Event.REST, Mode.ROLL, Mode.ROLL, stable=True)
    run.state = run.state._replace(t=run.t_end)
    stop(Status.AT_REST)


def let_go(run: Run) -> None:
    """The contact force is lost: the load falls freely and the rim skims the plane.

    Where the load would rise above what the rim allows, the ring's rotation is open.
    """
    body, state = run.body, run.state
    sine = body.ctx.sin(state.th)
    if not (sine * state.om > 0 or (state.om == 0 and sine != 0) or sine == 0):
        run.mode = UNDECIDED
        stop(Status.UNDETERMINED)
    if sine == 0:
        speed = body.ctx.sqrt(body.gn)
        jump = (speed if state.om >= 0 else -speed) - state.om
        run.state = state._replace(vt=state.vt - 2 * jump, om=state.om + jump)
    run.write(Event.SKIM, Mode.ROLL, Mode.SKIM)
    run.enter(Mode.SKIM)


def skim(run: Run) -> None:
    """Skim until the load strikes the plane or time is over."""
    body, state, ctx = run.body, run.state, run.body.ctx
    cosine, sine = ctx.cos_sin(state.th)
    way = 1 if state.om > 0 or (state.om == 0 and sine > 0) else -1
    along = state.vt + state.om * (1 + cosine)  # ẋ of the load
    sink = sine * state.om
    duration = 2 * (1 + cosine) / (sink + ctx.sqrt(sink * sink + 2 * body.gn * (1 + cosine)))
    left = run.t_end - state.t
    if duration > left:
        run.state = skimming(run, left, way, along, sink, sine, cosine)
        stop(Status.COMPLETED)
    turns = ctx.floor(state.th / (2 * ctx.pi))
    x = state.x + sine + along * duration + body.gt * duration * duration / 2
    speed = along + body.gt * duration
    fall = sink + body.gn * duration
    run.state = state._replace(t=state.t + duration, x=x, th=(2 * turns + 1) * ctx.pi, vt=speed, om=way * ctx.inf)
    before = run.state._replace(vn=-fall, om=ctx.nan)
    # a particle with friction that does not rebound
    p_n, p_t = fall, -speed
    if abs(speed) > body.mu_s * p_n:
        p_t = -body.mu_k * p_n if speed > 0 else body.mu_k * p_n
    after = speed + p_t if p_t != -speed else body.zero
    run.state = run.state._replace(
        vt=after,
        om=body.zero,
        impact_n=state.impact_n + fall * fall / 2,
        impact_t=state.impact_t + (speed * speed - after * after) / 2,
    )
    rebounds = body.rest > 0
    mode = Mode.FLIGHT if rebounds else Mode.ROLL if after == 0 else slip_mode(1 if after > 0 else -1)
    run.write(Event.IMPACT, Mode.SKIM, mode, cause=before, p_n=p_n, p_t=p_t, collision=True)
    run.enter(mode)
    if rebounds:
        stop(Status.UNDETERMINED)
    if mode != Mode.ROLL and run.slide():
        run.write(Event.STICK, mode, Mode.ROLL)
        run.enter(Mode.ROLL)
    lie(run)


def skimming(run: Run, tau: Number, way: int, along: Number, sink: Number, sine: Number, cosine: Number) -> PreciseState:
    """The state of the rim after skimming for the time tau, from the height of the load."""
    body, state, ctx = run.body, run.state, run.body.ctx
    height = 1 + cosine - sink * tau - body.gn * tau * tau / 2  # 1 + cos θ
    half = ctx.acos(ctx.sqrt(height / 2))
    turns = ctx.floor(state.th / (2 * ctx.pi))
    if way < 0 and sine == 0:
        turns -= 1
    th = 2 * ctx.pi * turns + (2 * half if way > 0 else 2 * ctx.pi - 2 * half)
    later = ctx.sin(2 * half)
    rate = sink + body.gn * tau
    om = way * rate / later if later != 0 else way * ctx.sqrt(body.gn)
    speed = along + body.gt * tau
    x = state.x + sine + along * tau + body.gt * tau * tau / 2 - ctx.sin(th)
    return state._replace(t=run.t_end, x=x, th=th, vt=speed - om * height, om=om)
