"""The hybrid motion of the hoop to as many digits as wanted, by Taylor series in mpmath.

Every piece between events is a chain of power series (:mod:`oracles.series`); events are roots of the series
of the event functions. Functions that vanish at the start of a piece (slip velocity after rolling ends, gap
after lift-off) have their leading zero coefficients divided out before roots are looked for, which also
decides each tie of the mode rule: the first non-zero coefficient of the candidate motion is the first
non-zero time derivative.

It shares no code with hophoop.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from mpmath import mp, mpf

from .cases import Case
from .events import STATE, Mode, settle
from .mechanics import DIRECTION, FLIGHT, ROLL, SKID, SPIN
from .rational import collide
from .series import Parameters, Piece, Series, derivative, expand, leading, value


@dataclass
class Solution:
    """Pieces and events of one motion."""

    case: Case
    parameters: Parameters
    pieces: list[Piece] = field(default_factory=list)
    events: list[dict[str, Any]] = field(default_factory=list)
    sequence: str = ""
    status: str = "completed"
    end: mpf = field(default_factory=mpf)
    losses_normal: mpf = field(default_factory=mpf)
    losses_tangential: mpf = field(default_factory=mpf)

    def at(self, t: mpf) -> dict[str, Any]:
        """State, mode and forces at time t (right limit at an event)."""
        if not 0 <= t <= self.end:
            raise ValueError(f"t = {t} is outside the motion, 0 to {self.end}")
        for piece in reversed(self.pieces):
            if piece.start <= t:
                break
        tau = t - piece.start
        sample = dict(zip(STATE, piece.state(tau), strict=True))
        return {
            "t": t,
            "mode": piece.mode,
            **sample,
            "friction": value(piece.friction, tau),
            "normal": value(piece.normal, tau),
            "work": value(piece.work, tau),
        }


def slip_velocity(p: Parameters, state: tuple[mpf, ...]) -> mpf:
    """Velocity of the rim's lowest point; exactly zero where the state was set to roll."""
    return state[3] - p.radius * state[5]


def choose(p: Parameters, state: tuple[mpf, ...], order: int = 12) -> tuple[Mode, str]:
    """Mode that follows from contact at rest off the plane, and the Painlevé event if there is one."""
    unit, weight, speed = p.time_scale, p.force_scale, p.speed_scale

    def sign(series: Series, scale: mpf) -> int:
        return int(mp.sign(leading(series, scale, unit)[1]))

    vt = slip_velocity(p, state)
    if vt == 0:
        piece = expand(p, ROLL, mpf(0), state, mpf(0), order)
        functions = event_functions(p, piece)
        if sign(piece.normal, weight) > 0 and all(sign(*functions[name][:2]) >= 0 for name in ("slip+", "slip-")):
            return (ROLL, 0), ""
    elif normal_response(p, state[2], SKID if vt > 0 else SPIN) <= 0:
        if p.free_normal_acceleration(state[2], state[5]) < 0:
            return ("impact", 0), "painleve_inconsistent"
        return ("impact" if p.case.painleve == "impact" else FLIGHT, 0), "painleve_indeterminate"
    for mode in (SKID, SPIN):
        if vt * DIRECTION[mode] >= 0 and normal_response(p, state[2], mode) > 0:
            piece = expand(p, mode, mpf(0), state, mpf(0), order)
            slip = [u - p.radius * w for u, w in zip(piece.vx, piece.omega, strict=True)]
            if sign(piece.normal, weight) > 0 and (vt != 0 or sign(slip, speed) == DIRECTION[mode]):
                return (mode, 0), ""
    return (FLIGHT, 0), ""


def normal_response(p: Parameters, angle: mpf, mode: str) -> mpf:
    """Acceleration off the plane per unit normal force, with the friction of slip in `mode`."""
    return p.response(angle, -DIRECTION[mode] * p.mu_kinetic, mpf(1))[1]


def impact(p: Parameters, state: tuple[mpf, ...]) -> tuple[tuple[mpf, ...], dict[str, Any]]:
    """State after an impact, what it took and what was lost: straight pieces of the velocity over the normal impulse."""
    restitution = mpf(0) if -state[4] < p.case.rest_below else p.restitution
    contact = SimpleNamespace(
        radius=p.radius, mu_static=p.mu_static, mu_kinetic=p.mu_kinetic, answer=partial(p.response, state[2])
    )  # fmt: skip
    result = collide(contact, state[3:], restitution, p.case.impact_law, mp.sqrt)
    return (*state[:3], *result.pop("velocity")), result


def event_functions(p: Parameters, piece: Piece) -> dict[str, tuple[Series, mpf, bool]]:
    """Event name → (series, its scale, whether only a fall through zero counts)."""
    n, f = piece.normal, piece.friction
    if piece.mode == FLIGHT:
        return {"impact": (piece.y, p.radius, True), "apex": (piece.vy, p.speed_scale, True)}
    turn = {"turn": (piece.omega, p.speed_scale / p.radius, False)}
    if piece.mode == ROLL:
        upper = [p.mu_static * a - b for a, b in zip(n, f, strict=True)]
        lower = [p.mu_static * a + b for a, b in zip(n, f, strict=True)]
        return {"slip+": (upper, p.force_scale, True), "slip-": (lower, p.force_scale, True), **turn}
    slip = [u - p.radius * w for u, w in zip(piece.vx, piece.omega, strict=True)]
    ahead = [DIRECTION[piece.mode] * u for u in slip]
    return {"rest": (ahead, p.speed_scale, True), "takeoff": (n, p.force_scale, True), **turn}


def roots(series: Series, scale: mpf, unit: mpf, span: mpf, fresh: bool, samples: int = 96) -> list[tuple[mpf, int]]:
    """Roots in (0, span] and the sign of the slope there; leading zeros are divided out when `fresh`."""
    if fresh:
        zeros, _ = leading(series, scale, unit)
        if zeros < 0:
            return []
        series = series[zeros:]
    slope = derivative(series)
    grid = np.linspace(0.0, 1.0, samples + 1)
    scaled = np.array([float(c * span**k) for k, c in enumerate(series)])
    values = np.polynomial.polynomial.polyval(grid, scaled)
    scaled_slope = scaled[1:] * np.arange(1, len(scaled))
    slopes = np.polynomial.polynomial.polyval(grid, scaled_slope)
    brackets = []
    for i in range(samples):
        left, right = span * mpf(grid[i]), span * mpf(grid[i + 1])
        if values[i] * values[i + 1] < 0:
            brackets.append((left, right))
        elif slopes[i] * slopes[i + 1] < 0 and values[i] * slopes[i] < 0:
            # an extremum that points at zero: does it reach it?
            extremum = refine(slope, left, right)
            if value(series, extremum) * values[i] < 0:
                brackets += [(left, extremum), (extremum, right)]
    found = []
    for left, right in brackets:
        root = refine(series, left, right)
        found.append((root, int(mp.sign(value(slope, root)))))
    return found


def refine(series: Series, left: mpf, right: mpf) -> mpf:
    """Root of a series in a bracket: bisection to start, then Newton's method kept inside the bracket."""
    slope = derivative(series)
    sign = mp.sign(value(series, left))
    root = (left + right) / 2
    for _ in range(300):
        here = value(series, root)
        if mp.sign(here) == sign:
            left = root
        else:
            right = root
        step = -here / value(slope, root)
        if abs(step) < abs(root) * mpf(10) ** (-mp.dps + 2):
            return root + step
        root = root + step if left < root + step < right else (left + right) / 2
    return root


def initial_state(p: Parameters) -> tuple[mpf, ...]:
    """State of the case at t = 0; a rolling start has the slip velocity zero to the last digit."""
    case = p.case
    omega = mpf(case.vx) / p.radius if case.rolling else mpf(case.omega)
    vx = p.radius * omega if case.rolling else mpf(case.vx)
    return mpf(case.x), mpf(case.height), mpf(case.angle), vx, mpf(case.vy), omega


def solve(case: Case, digits: int = 40, order: int | None = None) -> Solution:
    """Solve a case to about `digits` − 8 digits, until its duration or its number of events is reached."""
    with mp.workdps(digits + 10):
        p = Parameters(case)
        return _solve(case, p, order or digits)


def _solve(case: Case, p: Parameters, order: int) -> Solution:
    solution = Solution(case, p)
    t, work, state, mode = mpf(0), mpf(0), initial_state(p), "start"
    duration = mpf(case.duration)

    def note(kind: str, to: str) -> None:
        solution.events.append({"t": t, "kind": kind, "from": mode, "to": to, **dict(zip(STATE, state, strict=True))})

    def strike(before: tuple[mpf, ...]) -> tuple[tuple[mpf, ...], dict[str, Any]]:
        after, more = impact(p, before)
        solution.losses_normal += more["loss_normal"]
        solution.losses_tangential += more["loss_tangential"]
        return after, more

    def follow() -> tuple[str, tuple[mpf, ...]]:
        (following, _), after = settle(solution.events, {"t": t, "from": mode}, state, partial(choose, p), strike)
        return following, after

    if state[1] > 0:
        note("start", FLIGHT)
        mode = FLIGHT
    else:
        mode, state = follow()
    solution.sequence = mode
    fresh = True
    while t < duration:
        piece = expand(p, mode, t, state, work, order)
        solution.pieces.append(piece)
        span = min(piece.span, duration - t)
        if span < p.time_scale * mpf(10) ** (-mp.dps // 3):
            if span == duration - t:
                break
            solution.status = "jammed"
            break
        candidates = []
        for name, (series, scale, falling) in event_functions(p, piece).items():
            for root, slope in roots(series, scale, p.time_scale, span, fresh):
                if not falling or slope < 0:
                    candidates.append((root, name))
        if not candidates:
            t, state, work = t + span, piece.state(span), value(piece.work, span)
            fresh = False
            continue
        tau, name = min(candidates)
        t, work, fresh = t + tau, value(piece.work, tau), True
        x, y, angle, vx, vy, omega = piece.state(tau)
        if mode != FLIGHT or name == "impact":
            y = mpf(0)
        if mode != FLIGHT or name == "apex":
            vy = mpf(0)
        if name == "turn":
            omega = mpf(0)
        if mode == ROLL or name == "rest":
            vx = p.radius * omega
        state = (x, y, angle, vx, vy, omega)
        if name in ("turn", "apex"):
            note(name, mode)
        elif name in ("rest", "impact"):
            mode, state = follow()
            solution.sequence += mode
        else:  # the edge of the friction cone: F > 0 at "slip+" drives the slip backwards
            to = SPIN if name == "slip+" else SKID
            if name == "takeoff" or p.free_normal_acceleration(angle, omega) >= 0:
                to = FLIGHT
            note("takeoff" if to == FLIGHT else "slip_start", to)
            mode = to
            solution.sequence += mode
        if len(solution.events) > case.max_events:
            solution.status = "event_limit"
            break
    solution.end = t
    last = solution.at(t) if solution.status == "completed" else dict(zip(STATE, state, strict=True)) | {"work": work}
    solution.events.append({"mode": mode, **last, "t": t, "kind": "end", "from": mode, "to": mode})
    return solution


def energy(solution: Solution, state: dict[str, Any]) -> tuple[mpf, mpf]:
    """Kinetic and potential energy of a state."""
    p = solution.parameters
    velocity = mp.matrix([state["vx"], state["vy"], state["omega"]])
    kinetic = (velocity.T * p.mass_matrix(state["angle"]) * velocity)[0] / 2
    along = state["x"] + p.arm * mp.sin(state["angle"])
    off = state["height"] + p.arm * (mp.cos(state["angle"]) - 1)
    return kinetic, p.mass * p.gravity * (off * p.down - along * p.along)


def ledger(solution: Solution) -> dict[str, mpf]:
    """Energy balance at the end of the motion, with its residual."""
    start, end = solution.events[0], solution.events[-1]
    if "before" in start:  # an impact at t = 0: the account starts before it
        start = {**start, **start["before"]}
    before, after = energy(solution, start), energy(solution, end)
    lost = end["work"] + solution.losses_normal + solution.losses_tangential
    return {
        "kinetic": after[0],
        "potential": after[1],
        "friction": end["work"],
        "impact_normal": solution.losses_normal,
        "impact_tangential": solution.losses_tangential,
        "residual": sum(after) + lost - sum(before),
    }
