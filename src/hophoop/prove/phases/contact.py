"""Phases of contact: rolling and slip up to their next event, panel by panel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Protocol

from hophoop.prove._flint import (
    Ball,
    Jet,
    Undecided,
    arb,
    bits,
    coefficients,
    order,
    pi,
    polynomial,
    precision,
    sign,
    symmetric,
)
from hophoop.prove.enclosures.mean_value_form import located, ranges
from hophoop.prove.enclosures.roots import Root, exact, first_root
from hophoop.prove.phases.panels import LARGEST, SHARE, SMALLEST, Panel, TurnPanel, terms_for
from hophoop.prove.phases.phase_equations import STOP, PhaseEquations, Slip, begin_at, disc, phase_equations, square_at
from hophoop.prove.phases.rolling import TURN, Rolling, still
from hophoop.prove.phases.trail_recorder import Trail, Unrecorded, bracket
from hophoop.prove.physics.equations import Model, State

LIMIT, SPAN, REST = "limit", "span", "rest"
MOST_PIECES = 20_000


@dataclass(frozen=True)
class Ended:
    """The end of a phase or a turning point in it: what it is, the state there, and the phase's record in the certificate."""

    what: str
    state: State
    witness: dict[str, Any]
    energy: Ball | None = None


@dataclass(frozen=True)
class Limits:
    """The latest end of a motion: a time, and a revolution from an angle; None if it does not matter.

    Without `timed` the time that rolling takes is left out, where nothing depends on it.
    """

    t_end: Ball | None
    origin: Ball | None
    timed: bool = True

    def left(self, th: Ball, way: int) -> Ball | None:
        """Angle to go."""
        return None if self.origin is None else 2 * pi() - way * (th - self.origin)


@dataclass(frozen=True)
class Found:
    """The first event on a panel, its root, and the place as it varies over a box."""

    what: str
    root: Root
    x: Ball


class PhaseInput(Protocol):
    """The run's attributes that a phase reads."""

    model: Model
    state: State
    zeros: int
    limits: Limits
    energy: Ball | None  # of the rolling that was before slip, or that comes after it


# --- rolling -------------------------------------------------------------------------------------


def roll(run: PhaseInput) -> Iterator[Ended]:
    """Rolling up to the event that ends it; turning points are given on the way."""
    model, state, limits, energy = run.model, run.state, run.limits, run.energy
    while True:
        at_turn = bool(state.om.is_zero())
        way = still(model, state) if at_turn else sign(state.om, "θ̇")
        if way == 0:
            yield Ended(REST, state, {})
            return
        rolling = Rolling(model, state, way, at_turn, energy)
        what, state, around, turns = _roll_on(rolling, limits)
        witness = {"mode": "R", "way": way, "what": what, "angle": around, "turns": turns}
        energy = rolling.energy
        yield Ended(what, state, witness, energy)
        if what != TURN:
            return


def _roll_on(rolling: Rolling, limits: Limits) -> tuple[str, State, list[str] | None, int]:
    """(what comes next, the state there, a bracket of its angle, whole turns before it that are not looked at)."""
    model, begin, way = rolling.model, rolling.begin, rolling.way
    turn = 2 * pi()
    base, t, fresh = begin.th, begin.t, True
    known = len(rolling.names) - 1
    turns = 0
    while True:
        zeros = [0] * known + [1 if fresh and rolling.at_turn else 0]
        rolled = rolling.first(turn.upper(), zeros, base, limits.left(exact(base), way))
        ends = rolled.what == TURN
        if limits.timed:
            after = t + rolling.duration(base, rolled.th, fresh and rolling.at_turn, ends)
            if limits.t_end is not None and not after < limits.t_end:
                if not after > limits.t_end:
                    raise Undecided("an event and the end of the time come together")
                th = _angle_at(rolling, base, rolled.th, limits.t_end - t, fresh and rolling.at_turn)
                return LIMIT, _rolled(rolling, limits.t_end, th), bracket(th), turns
            t = after
        if rolled.what is not None:
            state = _rolled(rolling, t, rolled.th)
            around = None if rolled.bracket is None or not limits.timed else bracket(rolled.th, *rolled.bracket)
            return rolled.what, replace(state, om=arb(0)) if ends else state, around, turns
        base, fresh = rolled.th, False
        if model.level and limits.t_end is not None:  # what does not happen in a whole turn happens in none
            period = rolling.duration(base, base + way * turn)
            count = int(((limits.t_end - t) / period).lower().floor().unique_fmpz() or 0)
            if count > 1:
                turns += count
                base, t = base + way * turn * count, t + period * count


def _rolled(rolling: Rolling, t: Ball, th: Ball) -> State:
    begin, zero = rolling.begin, arb(0)
    om = rolling.way * rolling.square(th).sqrt()
    return State(t, begin.x + th - begin.th, zero, th, zero, zero, om)


def _angle_at(rolling: Rolling, base: Ball, last: Ball, wanted: Ball, at_turn: bool) -> Ball:
    """The angle that rolling reaches in a time: found roughly, then enclosed by the mean value theorem."""
    way = rolling.way
    with precision(64):
        low, high = way * exact(base), way * exact(last)
        x = exact((low + high) / 2)
        for _ in range(60):
            missing = wanted - rolling.duration(base, way * x, at_turn)
            if abs(missing).mid() < 1e-14:
                break
            low, high = (x, high) if missing.mid() > 0 else (low, x)
            x = exact(x + rolling.square(way * x).sqrt() * missing)
            if not (x > low and x < high):
                x = exact((low + high) / 2)
    for _ in range(4):
        missing = wanted - rolling.duration(base, way * x, at_turn)
        speed = rolling.square(way * x).sqrt()
        around = symmetric(2 * speed * missing + arb(2) ** -bits())
        shift = rolling.square(way * x + around).sqrt() * missing
        if not around.contains(shift):
            raise Undecided("the angle at the end of the time has no enclosure")
        found = way * x + way * shift
        if missing.contains(0) or shift.rad() * 4 > abs(shift).mid():
            return found
        x = exact(way * found)
    return found


# --- panels --------------------------------------------------------------------------------------


def travel(run: PhaseInput, sigma: int) -> Iterator[Ended]:
    """Slip, or rolling with resistance, up to the event that ends it; turning points are given on the way."""
    limits = run.limits
    model = run.model.after(run.state.th, run.state.om, sigma)
    phase: PhaseEquations = phase_equations(model, sigma, run.state)
    zeros = [0, run.zeros] if sigma else [0] * len(phase.names)
    way = sign(run.state.om, "θ̇") or sign(phase.slope(run.state.th, arb(0)), "θ̈ of the hoop at rest")
    if way == 0:
        yield slide(phase, limits) if isinstance(phase, Slip) else Ended(REST, run.state, {})
        return
    panel, x = _first_panel(run, phase, way)
    phase = panel.phase
    trail = Trail(phase, run.state.th) if limits.timed else Unrecorded()
    turned = bool(run.state.om.is_zero())  # the turning point of the panel is behind
    for _ in range(MOST_PIECES):
        if isinstance(panel, TurnPanel):
            if not turned:
                found = search(panel, zeros, x.lower(), arb(0), limits)
                trail.turn(panel)
                if found is not None:
                    yield ended(panel, found, trail)
                    return
                last_turn = limits.origin is not None or phase.ends_at_turn
                record = trail.record(TURN, None) if last_turn else {}
                yield Ended(TURN, replace(panel.state(arb(0)), om=arb(0)), record)
                if last_turn:
                    return
                zeros, way = [-1, -1], -way
            else:
                trail.turn(panel)
            found = search(panel, zeros, arb(0), exact(panel.reach.sqrt().lower() * 15 / 16), limits)
        else:
            found = search(panel, zeros, x.lower(), panel.reach, limits)
            trail.panel(panel)
        if found is not None:
            yield ended(panel, found, trail)
            return
        centre, u, t = _end_of(panel, way, trail)
        zeros, turned = [-1, -1], False
        panel = panel_at(phase, centre, way, u, t)
        x = -(way * (panel.turn - centre)).sqrt() if isinstance(panel, TurnPanel) else arb(0)
    raise Undecided(f"a phase takes more than {MOST_PIECES} panels")


def _first_panel(run: PhaseInput, phase: PhaseEquations, way: int) -> tuple[Panel | TurnPanel, Ball]:
    """(the panel that a phase begins on, its variable there)."""
    state = run.state
    panel: Panel | TurnPanel
    if state.om.is_zero():
        panel = TurnPanel(phase, state.th, -way)
        panel.t = state.t
        return panel, arb(0)
    centre = exact(state.th)
    u, _ = square_at(phase, state.th, state.om * state.om, centre, run.energy)
    begin = begin_at(phase, centre, u, way)
    panel = panel_at(phase_equations(phase.model, phase.sigma, begin), centre, way, u, begin.t)
    x = -(way * (panel.turn - state.th)).sqrt() if isinstance(panel, TurnPanel) else way * (state.th - centre)
    return panel, x


def _end_of(panel: Panel | TurnPanel, way: int, trail: Trail | Unrecorded) -> tuple[Ball, Ball, Ball]:
    """(exact angle, θ̇², t) where the next panel begins."""
    if isinstance(panel, TurnPanel):
        last = arb(float(panel.reach.sqrt().lower() * 7 / 8))
        trail.leave(last)
        centre = exact(panel.angle(last))
        w = (way * (centre - panel.turn)).sqrt()
        return centre, w * w * panel.over(w), panel.time(w)
    centre = exact(panel.angle(panel.reach))
    x = way * (centre - panel.centre)
    return centre, panel.square(x), panel.time(x)


def panel_at(phase: PhaseEquations, centre: Ball, way: int, u: Ball, t: Ball) -> Panel | TurnPanel:
    """The panel that begins at an exact angle: one about a turning point where that is near."""
    slope = way * phase.slope(centre, u)
    if slope < 0 and u / -slope < LARGEST / SHARE:
        found = turn_ahead(phase, centre, way, u)
        if found is not None:
            found.t = t - (found.time(-(way * (found.turn - centre)).sqrt()) - found.t)
            return found
    return Panel(phase, centre, way, u, t)


def turn_ahead(phase: PhaseEquations, centre: Ball, way: int, u: Ball) -> TurnPanel | None:
    """A panel about the turning point ahead, None where it does not reach back to the centre."""
    radius = arb(LARGEST)
    while (found := disc(phase, centre, radius)) is None or not found.grow * radius < 1:
        radius = radius / 2
        if radius < SMALLEST:
            raise Undecided("slip comes too close to p_σ = 0")
    terms = terms_for(bits())
    ratio = arb(1) / SHARE
    most = (abs(u).abs_upper() + radius * found.push) * (found.grow * radius).exp()
    rest = symmetric(most * ratio**terms / (1 - ratio))
    with order(terms):
        squares = coefficients(phase.square(centre, u, way, terms), terms)

    def evaluate(x: Ball, wanted: int) -> list[Jet]:
        value = polynomial(squares, x) + rest
        return [[value, way * phase.slope(centre + way * x, value)][:wanted]]

    try:
        root = first_root(evaluate, [0], arb(0), exact(radius / SHARE))
        if root is None:
            return None
        panel = TurnPanel(phase, centre + way * root.x, way)
    except Undecided:  # not yet: from nearer by it may
        return None
    return panel if root.x < panel.reach else None


def search(
    panel: Panel | TurnPanel, zeros: list[int], begin: Ball, end: Ball, limits: Limits, begun: bool = False
) -> Found | None:
    """(what, where) of the first event on a panel."""
    names, known = panel.phase.names, list(zeros)
    if limits.t_end is not None:
        names, known = [*names, LIMIT], [*known, 0]
    if limits.origin is not None:
        names, known = [*names, SPAN], [*known, 0]

    def evaluate(x: Ball, terms: int) -> list[Jet]:
        panel.phase.model.deadline.ask()
        found = panel.watch(x, terms)
        if limits.t_end is not None:
            found.append([limits.t_end - panel.time(x), -panel.slowness(x)][:terms])
        if limits.origin is not None:
            way = panel.way_at(x)
            left = limits.left(panel.angle(x), way)
            left_jet = [left, -way * panel.angle_rate(x)]
            found.append(left_jet[:terms] + [arb(0)] * (terms - 2))  # more than two are asked for in panels alone
        return found

    def values(x: Ball, terms: int) -> list[Jet]:
        return ranges(evaluate(x, terms))

    if not begin < end:
        return None
    wide = panel.phase.model.varying > 0
    root = first_root(values, known, exact(begin), exact(end), exact((end - begin) / 2), wide, begun)
    return None if root is None else Found(names[root.index], root, located(evaluate, root))


def ended(panel: Panel | TurnPanel, found: Found, trail: Trail | Unrecorded) -> Ended:
    what, x = found.what, found.x
    energy = None
    if what == STOP and isinstance(panel, Panel) and not panel.phase.ends_at_turn:
        energy = panel.energy(x)
    return Ended(what, panel.state(x, what == STOP), trail.record(what, found.root), energy)


def slide(phase: Slip, limits: Limits) -> Ended:
    """Slip at a constant angle."""
    begin, steady, still = phase.begin, phase.steady, phase.begin.vt.is_zero()
    way = sign(steady, "v̇_t") * phase.sigma
    ends = way < 0 and not still  # slip that begins gets faster
    if limits.t_end is None:
        if not ends:
            raise Undecided("slip goes on without rotation and without end")
        tau, stops = abs(begin.vt) / abs(steady), True
    else:
        left = limits.t_end - begin.t
        stops = ends and _before(abs(begin.vt) / abs(steady), left)
        tau = abs(begin.vt) / abs(steady) if stops else left
    x = begin.x + begin.vt * tau + steady * tau * tau / 2
    vt = arb(0) if stops else begin.vt + steady * tau
    state = replace(begin, t=begin.t + tau if stops or limits.t_end is None else limits.t_end, x=x, vt=vt)
    what = STOP if stops else LIMIT
    return Ended(what, state, {"mode": "RKS"[phase.sigma], "what": what, "slides": True})


def _before(a: Ball, b: Ball) -> bool:
    if a < b:
        return True
    if a > b:
        return False
    raise Undecided("an event and the end of the time come together")
