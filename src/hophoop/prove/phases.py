"""Phases of contact: rolling and slip up to their next event, piece by piece."""

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
from hophoop.prove.carriers import STOP, Carrier, Slip, begin_at, carrier_of, disc, square_at
from hophoop.prove.model import Model, State
from hophoop.prove.panels import LARGEST, SHARE, SMALLEST, Panel, TurnPanel, terms_for
from hophoop.prove.rolling import TURN, Rolling, still
from hophoop.prove.search import Root, exact, first_root
from hophoop.prove.varied import located, ranges
from hophoop.prove.witness import Trail, Unrecorded, bracket

LIMIT, SPAN, REST = "limit", "span", "rest"
MOST_PIECES = 20_000


@dataclass(frozen=True)
class Ended:
    """What ends a phase, or a turning point in it, the state there, and what a certificate keeps of the way to it."""

    what: str
    state: State
    witness: dict[str, Any]
    energy: Ball | None = None


@dataclass(frozen=True)
class Limits:
    """Where a motion ends at the latest: a time (None: no matter), and a whole turn from an angle (None: no matter).

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
    """The first event on a piece, its root, and the place as it varies over a box."""

    what: str
    root: Root
    x: Ball


class Phase(Protocol):
    """What a phase needs of the run."""

    model: Model
    state: State
    zeros: int
    limits: Limits
    energy: Ball | None  # of the rolling that was before slip, or that comes after it


# --- rolling -------------------------------------------------------------------------------------


def roll(run: Phase) -> Iterator[Ended]:
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
        rolled = rolling.first(turn.upper(), zeros, base, limits.left(base, way))
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


def travel(run: Phase, sigma: int) -> Iterator[Ended]:
    """Slip, or rolling with resistance, up to the event that ends it; turning points are given on the way."""
    state, limits = run.state, run.limits
    model = run.model.after(state.th, state.om, sigma)
    carrier = carrier_of(model, sigma, state)
    zeros = [0, run.zeros] if sigma else [0] * len(carrier.names)
    way = sign(state.om, "θ̇")
    if way == 0:
        way = sign(carrier.slope(state.th, arb(0)), "θ̈ of the hoop at rest")
        if way == 0:
            yield slide(carrier, limits) if isinstance(carrier, Slip) else Ended(REST, state, {})
            return
        piece: Any = TurnPanel(carrier, state.th, -way)
        piece.t = state.t
        x, begun = arb(0), True
    else:
        centre = exact(state.th)
        u, _ = square_at(carrier, state.th, state.om * state.om, centre, run.energy)
        begin = begin_at(carrier, centre, u, way)
        carrier = carrier_of(model, sigma, begin)
        piece = panel(carrier, centre, way, u, begin.t)
        turning = isinstance(piece, TurnPanel)
        x = -(way * (piece.turn - state.th)).sqrt() if turning else way * (state.th - centre)
        begun = False
    trail = Trail(carrier, state.th) if limits.timed else Unrecorded()
    for _ in range(MOST_PIECES):
        if isinstance(piece, TurnPanel):
            if not begun:
                root = search(piece, zeros, x.lower(), arb(0), limits)
                trail.turn(piece)
                if root is not None:
                    yield ended(piece, root, trail)
                    return
                last_turn = limits.origin is not None or carrier.ends_at_turn
                found = trail.record(TURN, None) if last_turn else {}
                yield Ended(TURN, replace(piece.state(arb(0)), om=arb(0)), found)
                if last_turn:
                    return
                zeros, x, way = [-1, -1], arb(0), -way
            else:
                trail.turn(piece)
            root = search(piece, zeros, arb(0), exact(piece.reach.sqrt().lower() * 15 / 16), limits)
            last = arb(float(piece.reach.sqrt().lower() * 7 / 8))
            if root is not None:
                yield ended(piece, root, trail)
                return
            trail.leave(last)
            centre = exact(piece.angle(last))
            w = (way * (centre - piece.turn)).sqrt()
            u, t = w * w * piece.over(w), piece.time(w)
        else:
            root = search(piece, zeros, x.lower(), piece.reach, limits)
            trail.panel(piece)
            if root is not None:
                yield ended(piece, root, trail)
                return
            centre = exact(piece.angle(piece.reach))
            x = way * (centre - piece.centre)
            u, t = piece.square(x), piece.time(x)
        zeros, begun, x = [-1, -1], False, arb(0)
        piece = panel(carrier, centre, way, u, t)
        if isinstance(piece, TurnPanel):
            x = -(way * (piece.turn - centre)).sqrt()
    raise Undecided(f"a phase takes more than {MOST_PIECES} panels")


def panel(carrier: Carrier, centre: Ball, way: int, u: Ball, t: Ball) -> Panel | TurnPanel:
    """The panel that begins at an exact angle: one about a turning point where that is near."""
    slope = way * carrier.slope(centre, u)
    if slope < 0 and u / -slope < LARGEST / SHARE:
        found = turn_ahead(carrier, centre, way, u)
        if found is not None:
            found.t = t - (found.time(-(way * (found.turn - centre)).sqrt()) - found.t)
            return found
    return Panel(carrier, centre, way, u, t)


def turn_ahead(carrier: Carrier, centre: Ball, way: int, u: Ball) -> TurnPanel | None:
    """A panel about the turning point ahead, None where it does not reach back to the centre."""
    radius = arb(LARGEST)
    while (found := disc(carrier, centre, radius)) is None or not found.grow * radius < 1:
        radius = radius / 2
        if radius < SMALLEST:
            raise Undecided("slip comes too close to p_σ = 0")
    terms = terms_for(bits())
    ratio = arb(1) / SHARE
    most = (abs(u).abs_upper() + radius * found.push) * (found.grow * radius).exp()
    rest = symmetric(most * ratio**terms / (1 - ratio))
    with order(terms):
        squares = coefficients(carrier.square(centre, u, way, terms), terms)

    def evaluate(x: Ball, wanted: int) -> list[Jet]:
        value = polynomial(squares, x) + rest
        return [[value, way * carrier.slope(centre + way * x, value)][:wanted]]

    try:
        root = first_root(evaluate, [0], arb(0), exact(radius / SHARE))
        if root is None:
            return None
        panel = TurnPanel(carrier, centre + way * root.x, way)
    except Undecided:  # not yet: from nearer by it may
        return None
    return panel if root.x < panel.reach else None


def search(
    piece: Panel | TurnPanel, zeros: list[int], begin: Ball, end: Ball, limits: Limits, begun: bool = False
) -> Found | None:
    """(what, where) of the first event on a piece."""
    names, known = piece.carrier.names, list(zeros)
    if limits.t_end is not None:
        names, known = [*names, LIMIT], [*known, 0]
    if limits.origin is not None:
        names, known = [*names, SPAN], [*known, 0]

    def evaluate(x: Ball, terms: int) -> list[Jet]:
        piece.carrier.model.deadline.ask()
        found = piece.watch(x, terms)
        if limits.t_end is not None:
            found.append([limits.t_end - piece.time(x), -piece.slowness(x)][:terms])
        if limits.origin is not None:
            way = piece.way_at(x)
            left = limits.left(piece.angle(x), way)
            left_jet = [left, -way * piece.angle_rate(x)]
            found.append(left_jet[:terms] + [arb(0)] * (terms - 2))  # more than two are asked for in panels alone
        return found

    def values(x: Ball, terms: int) -> list[Jet]:
        return ranges(evaluate(x, terms))

    if not begin < end:
        return None
    wide = piece.carrier.model.varying > 0
    root = first_root(values, known, exact(begin), exact(end), exact((end - begin) / 2), wide, begun)
    return None if root is None else Found(names[root.index], root, located(evaluate, root))


def ended(piece: Panel | TurnPanel, found: Found, trail: Trail | Unrecorded) -> Ended:
    what, x = found.what, found.x
    energy = None
    if what == STOP and isinstance(piece, Panel) and not piece.carrier.ends_at_turn:
        energy = piece.energy(x)
    return Ended(what, piece.state(x, what == STOP), trail.record(what, found.root), energy)


def slide(carrier: Slip, limits: Limits) -> Ended:
    """Slip at a constant angle."""
    begin, steady, still = carrier.begin, carrier.steady, carrier.begin.vt.is_zero()
    way = sign(steady, "v̇_t") * carrier.sigma
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
    return Ended(what, state, {"mode": "RKS"[carrier.sigma], "what": what, "slides": True})


def _before(a: Ball, b: Ball) -> bool:
    if a < b:
        return True
    if a > b:
        return False
    raise Undecided("an event and the end of the time come together")
