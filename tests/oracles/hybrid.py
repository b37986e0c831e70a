"""The hybrid motion of the hoop in double precision: SciPy's DOP853 in the time domain, for any scenario.

The equations are those of :mod:`oracles.mechanics`. Steps are so short that the dense output is as good as they are, and
SciPy finds the events on it. After an event every mode that the velocities allow is tried, and the first whose signs come out
right is taken; a sign that is zero is that of a thousandth of √(R/g) later. Impacts are those of
:mod:`oracles.rational`, in doubles.

It shares no code with hophoop.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from .cases import Case
from .events import STATE, Mode, settle
from .mechanics import (
    DIRECTION,
    FLIGHT,
    ROLL,
    SKID,
    SPIN,
    Vector,
    contact_jacobian,
    free_normal_acceleration,
    mass_matrix,
    normal_response,
    solve_mode,
)
from .rational import collide

EXACT = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}


@dataclass
class Motion:
    """Pieces and events of one motion; the state is (x, y, θ, ẋ, ẏ, θ̇, friction work, rolling work)."""

    case: Case
    pieces: list[tuple[float, Any, str]] = field(default_factory=list)
    events: list[dict[str, Any]] = field(default_factory=list)
    sequence: str = ""
    status: str = "completed"
    end: float = 0.0

    def at(self, t: float) -> dict[str, Any]:
        """State and mode at t (right limit at an event)."""
        start, dense, mode = next(piece for piece in reversed(self.pieces) if piece[0] <= t)
        return {"t": t, "mode": mode, **named(dense(t - start))}


def named(state: Vector) -> dict[str, float]:
    """Names for the numbers of a state."""
    return dict(zip((*STATE, "work", "rolling"), map(float, state), strict=True))


def time_scale(case: Case) -> float:
    """√(R/g), or √(R / 1 m/s²) without gravity."""
    return math.sqrt(case.radius / (case.gravity or 1.0))


def slip_velocity(case: Case, state: Vector) -> float:
    """Velocity of the rim's lowest point along the plane."""
    return float(state[3] - case.radius * state[5])


def rates(case: Case, mode: Mode) -> Callable[[float, Vector], Vector]:
    """Right-hand side in a mode."""

    def right(_: float, state: Vector) -> Vector:
        found = solve_mode(case, mode[0], state[2], state[5], mode[1])
        power = -found[3] * slip_velocity(case, state) if mode[0] in DIRECTION else 0.0
        return np.array([*state[3:6], *found[:3], power, -found[5] * state[5]])

    return right


def advance(case: Case, mode: Mode, state: Vector, tau: float) -> Vector:
    """State a time τ later in one mode."""
    return solve_ivp(rates(case, mode), (0.0, tau), state, **EXACT).y[:, -1]


def choose(case: Case, state: Vector) -> tuple[Mode, str]:
    """Mode that follows from contact at rest off the plane, and a Painlevé event if there is one."""
    vt, omega = slip_velocity(case, state), state[5]
    ways = [0]
    if case.rolling_resistance:
        ways = [0, 1, -1] if omega == 0.0 else [1 if omega > 0.0 else -1]
    contacts = (ROLL, SPIN, SKID)
    if vt != 0.0:
        contact = SKID if vt > 0.0 else SPIN
        contacts = (contact,)
        if normal_response(case, state[2], DIRECTION[contact], ways[0]) <= 0.0:
            if free_normal_acceleration(case, state[2], omega) < 0.0:
                return ("impact", 0), "painleve_inconsistent"
            return ("impact" if case.painleve == "impact" else FLIGHT, 0), "painleve_indeterminate"
    for contact in contacts:
        for way in ways:
            responds = contact == ROLL or normal_response(case, state[2], DIRECTION[contact], way) > 0.0
            if responds and holds(case, (contact, way), state):
                return (contact, way), ""
    return (FLIGHT, 0), ""


def holds(case: Case, mode: Mode, state: Vector) -> bool:
    """Whether the signs come out right in a mode, now and a moment later."""
    contact, way = mode
    tiny = 1e-9 * case.mass * (case.gravity or 1.0)
    later = advance(case, mode, state, 1e-3 * time_scale(case))
    now, then = (solve_mode(case, contact, s[2], s[5], way) for s in (state, later))

    def decided(quantity: Callable[[Vector], float]) -> float:
        return float(quantity(now if abs(quantity(now)) > tiny else then))

    right = decided(lambda f: f[4]) > 0.0
    if contact == ROLL:
        # equality with no motion away from it (μ = 0, F = 0) is allowed
        right &= decided(lambda f: case.mu_static * f[4] - abs(f[3])) >= -1e-12 * tiny
    elif slip_velocity(case, state) == 0.0:
        right &= slip_velocity(case, later) * DIRECTION[contact] > 0.0
    if case.rolling_resistance and state[5] == 0.0:
        most = case.rolling_resistance * case.radius
        right &= later[5] * way > 0.0 if way else abs(now[5]) <= most * now[4]
    return bool(right)


def impact(case: Case, state: Vector) -> tuple[Vector, dict[str, Any]]:
    """State after an impact, what it took and what was lost."""

    def answer(tangential: float, normal: float) -> Vector:
        return np.linalg.solve(mass_matrix(case, state[2]), contact_jacobian(case).T @ [tangential, normal])

    contact = SimpleNamespace(radius=case.radius, mu_static=case.mu_static, mu_kinetic=case.mu_kinetic, answer=answer)
    result = collide(contact, tuple(map(float, state[3:6])), case.restitution, case.impact_law, math.sqrt)
    return np.array([*state[:3], *result.pop("velocity"), *state[6:]]), result


def guards(case: Case, mode: Mode) -> Iterator[tuple[str, Callable[[float, Vector], float]]]:
    """Functions that are positive while the mode lasts; of a turn and an apex, which change no mode, the sign changes."""
    contact, way = mode

    def force(s: Vector) -> Vector:
        return solve_mode(case, contact, s[2], s[5], way)

    def lasts(guard: Callable[[Vector], float]) -> Callable[[float, Vector], float]:
        def test(tau: float, s: Vector) -> float:
            return guard(s) if tau > 0.0 else 1.0  # it is zero where the last event was its own

        test.terminal, test.direction = True, -1.0  # type: ignore[attr-defined]
        return test

    def mark(guard: Callable[[Vector], float], direction: float) -> Callable[[float, Vector], float]:
        def test(_: float, s: Vector) -> float:
            return guard(s)

        test.direction = direction  # type: ignore[attr-defined]
        return test

    if contact == FLIGHT:
        yield "impact", lasts(lambda s: s[1])
        yield "apex", mark(lambda s: s[4], -1.0)
        return
    if way:
        yield "turn", lasts(lambda s: way * s[5])
    elif not case.rolling_resistance:
        yield "turn", mark(lambda s: s[5], 0.0)
    if contact == ROLL:
        yield SPIN, lasts(lambda s: case.mu_static * force(s)[4] - force(s)[3])
        yield SKID, lasts(lambda s: case.mu_static * force(s)[4] + force(s)[3])
    else:
        yield "rest", lasts(lambda s: DIRECTION[contact] * slip_velocity(case, s))
        yield "takeoff", lasts(lambda s: force(s)[4])


def solve(case: Case) -> Motion:
    """Solve a case until its duration or its number of events is reached, or until it rests for good."""
    motion = Motion(case)
    omega = case.vx / case.radius if case.rolling else case.omega
    vx = case.radius * omega if case.rolling else case.vx
    state = np.array([case.x, case.height, case.angle, vx, case.vy, omega, 0.0, 0.0])
    t, mode = 0.0, (FLIGHT, 0)

    def follow(before: str) -> tuple[Mode, Vector]:
        return settle(motion.events, {"t": t, "from": before}, state, partial(choose, case), partial(impact, case))

    if case.height > 0:
        motion.events.append({"t": t, "kind": "start", "from": "start", "to": FLIGHT, **named(state)})
    else:
        mode, state = follow("start")
    motion.sequence = mode[0]
    while t < case.duration and len(motion.events) <= case.max_events:
        if mode == (ROLL, 0) and case.rolling_resistance:
            motion.status = "at_rest"
            break
        names, tests = zip(*guards(case, mode), strict=True)
        run = solve_ivp(
            rates(case, mode), (0.0, case.duration - t), state, events=tests, dense_output=True,
            max_step=0.03 * time_scale(case), **EXACT,
        )  # fmt: skip
        motion.pieces.append((t, run.sol, mode[0]))
        found = [(float(tau), name) for name, times in zip(names, run.t_events, strict=True) for tau in times if tau > 0.0]
        for tau, name in sorted(found):
            state = run.sol(tau)
            if name in ("turn", "apex"):
                state[5 if name == "turn" else 4] = 0.0
                if name == "turn" and mode[0] == ROLL:
                    state[3] = 0.0
                motion.events.append({"t": t + tau, "kind": name, "from": mode[0], "to": mode[0], **named(state)})
        state = run.y[:, -1].copy()
        t += float(run.t[-1])
        if run.status != 1:
            break
        name = max(found)[1]
        if name == "impact":
            state[1] = 0.0
        elif mode[0] != FLIGHT:
            state[1] = state[4] = 0.0
        if name == "turn":
            state[5] = 0.0
        if name == "rest" or mode[0] == ROLL:
            state[3] = case.radius * state[5]
        forced = FLIGHT if name == "takeoff" else ""
        if name in DIRECTION:
            forced = FLIGHT if free_normal_acceleration(case, state[2], state[5]) >= 0 else name
        before = mode[0]
        if name == "turn":
            mode, _ = choose(case, state)
            motion.events[-1] |= {"to": mode[0], "kind": "rest" if mode == (ROLL, 0) else "turn"}
        elif forced:
            motion.events.append(
                {"t": t, "kind": "takeoff" if forced == FLIGHT else "slip_start", "from": before, "to": forced, **named(state)}
            )
            mode = forced, 0 if forced == FLIGHT else mode[1]
        else:
            mode, state = follow(before)
        if name != "turn" or mode[0] != before:
            motion.sequence += mode[0]
    if t < case.duration and motion.status == "completed":
        motion.status = "event_limit"
    motion.end = t
    motion.events.append({"t": t, "kind": "end", "from": mode[0], "to": mode[0], **named(state)})
    return motion
